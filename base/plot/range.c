/* An axis that few values cannot stretch, and curves that stop where nothing was computed. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/order.h"
#include "base/plot/plot_impl.h"

#define FEW    60   /* values below which .. */
#define SPARED 3    /* .. so many at an end, .. */
#define PART   5    /* .. if they are at most one in so many, do not set the axis, .. */
#define MANY   20   /* .. and one in so many above */
#define MARGIN 0.06 /* beside the first and the last value, of the axis */
#define GAP    8.0  /* median steps that are a gap */

/* How many of n values at either end do not set the axis if they would stretch it. */
static size_t spared_of(size_t n)
{
  if (n >= FEW) return n / MANY;
  return n / PART < SPARED ? n / PART : SPARED;
}

/* Finite values of value[n] in order into v. */
static size_t sort_finite(const double *value, size_t n, double *v)
{
  size_t count = 0;
  for (size_t i = 0; i < n; i++)
    if (isfinite(value[i])) v[count++] = value[i];
  qsort(v, count, sizeof *v, um_core_order_double);
  return count;
}

/* What of a sorted set the axis must hold; low <= high, or none. */
static void must_hold(const double *v, size_t n, enum um_plot_shown shown, double *low,
                      double *high)
{
  size_t spared = shown == UM_PLOT_MOST ? spared_of(n) : n / 4;
  if (n == 0 || shown == UM_PLOT_NEAR) return;
  *low = fmin(*low, v[spared]);
  *high = fmax(*high, v[n - 1 - spared]);
}

/* v: of all sets one after the other, each of them sorted and count[i] long. */
static void range_of(const struct um_plot_values *set, size_t nset, const double *v,
                     const size_t *count, double anchor, double stretch, struct um_plot_range *out)
{
  double low = isnan(anchor) ? INFINITY : anchor, high = isnan(anchor) ? -INFINITY : anchor;
  const double *of = v;
  for (size_t i = 0; i < nset; of += count[i++]) must_hold(of, count[i], set[i].shown, &low, &high);
  if (!(low <= high)) return;
  double room = high > low ? stretch * (high - low) : INFINITY;
  double first = low - room, last = high + room; /* what may be on the axis */
  out->low = low;
  out->high = high;
  of = v;
  for (size_t i = 0; i < nset; of += count[i++])
    for (size_t k = 0; k < count[i]; k++) {
      double value = of[k];
      bool below = value<first, above = value> last;
      out->cut = out->cut || below || above;
      if (!below && !above) {
        out->low = fmin(out->low, value);
        out->high = fmax(out->high, value);
      }
      if (set[i].shown != UM_PLOT_MOST) continue;
      out->below += below;
      out->above += above;
      out->lowest = fmin(out->lowest, value);
      out->highest = fmax(out->highest, value);
    }
  double margin = MARGIN * (out->high - out->low);
  if (!(margin > 0.0)) margin = fmax(1e-3 * fabs(out->high), 1e-30);
  out->low -= margin;
  out->high += margin;
}

enum um_status um_plot_range(struct um_context *context, const struct um_plot_values *set,
                             size_t nset, double anchor, double stretch, struct um_plot_range *out)
{
  double *v = NULL;
  size_t *count = NULL, n = 0;
  enum um_status status;
  *out = (struct um_plot_range){.low = 0.0, .high = 1.0, .lowest = NAN, .highest = NAN};
  for (size_t i = 0; i < nset; i++) n += set[i].n;
  UM_CHECK(um_core_allocate(context, n, sizeof *v, &v));
  UM_CHECK(um_core_allocate(context, nset, sizeof *count, &count));
  n = 0;
  for (size_t i = 0; i < nset; n += count[i++])
    count[i] = sort_finite(set[i].value, set[i].n, v + n);
  range_of(set, nset, v, count, anchor, stretch, out);
done:
  UM_FREE(context, v, count);
  return status;
}

void um_plot_ordinate(struct um_plot *plot, const struct um_plot_range *range, double unit,
                      bool reverse)
{
  char words[120] = "";
  size_t n = 0;
  if (range->below > 0)
    n = (size_t)snprintf(words, sizeof words, "%zu beyond the axis, to %.4g", range->below,
                         range->lowest / unit);
  if (range->above > 0)
    snprintf(words + n, sizeof words - n, "%s%zu beyond the axis, to %.4g", n > 0 ? "; " : "",
             range->above, range->highest / unit);
  um_plot_add(plot, "set yrange [%.9g:%.9g]\n", (reverse ? range->high : range->low) / unit,
              (reverse ? range->low : range->high) / unit);
  um_plot_add(plot, "edge(v) = v < %.9g ? %.9g : v > %.9g ? %.9g : NaN\n", range->low / unit,
              range->low / unit, range->high / unit, range->high / unit);
  if (words[0] != '\0')
    um_plot_add(plot, "set label 905 %s at graph 0,1 left offset 0.3,0.55 font ',9'\n", words);
  else
    um_plot_add(plot, "unset label 905\n");
}

enum um_status um_plot_gap(struct um_context *context, size_t n, const double *t, double *out)
{
  double *step = NULL;
  *out = INFINITY;
  if (n < 3) return UM_OK;
  UM_TRY(um_core_allocate(context, n - 1, sizeof *step, &step));
  for (size_t i = 0; i + 1 < n; i++) step[i] = t[i + 1] - t[i];
  qsort(step, n - 1, sizeof *step, um_core_order_double);
  *out = GAP * step[(n - 1) / 2];
  um_core_free(context, step);
  return UM_OK;
}

void um_plot_curve(struct um_plot *plot, const struct um_plot_time *time, size_t number, size_t n,
                   const double *t, const double *value, double gap)
{
  bool begun = false; /* a row stands, and no empty line since */
  size_t last = 0;
  um_plot_add(plot, "$curve%zu << EOD\n", number);
  for (size_t i = 0; i < n; i++) {
    if (begun && (!isfinite(value[i]) || t[i] - t[last] > gap)) {
      um_plot_add(plot, "\n");
      begun = false;
    }
    if (!isfinite(value[i])) continue;
    um_plot_add(plot, "%.9f,%.9g\n", um_plot_time_at(time, t[i]), value[i]);
    begun = true;
    last = i;
  }
  um_plot_add(plot, "EOD\n");
}
