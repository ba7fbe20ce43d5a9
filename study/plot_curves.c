/* Curves as bands of quantiles, and below each the shares of its variance over time. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "orbit/time.h"
#include "study/plot_impl.h"

/* Pixels. */
#define WIDTH   1000
#define LEFT    104
#define RIGHT   980
#define TOP     92
#define CURVE   210
#define SHARES  110
#define GAP     24 /* of a curve and its shares .. */
#define LEGEND  10 /* .. of the first, which have a legend, and .. */
#define ROW     19 /* .. each row of it */
#define WIDE    70 /* characters of names that go into two rows */
#define BETWEEN 34
#define BELOW   58

#define AT_A_TIME 4 /* quantities of a picture */

static size_t row_of(const struct um_study_result *r, size_t q)
{
  size_t row = 1; /* the header is 0 */
  for (size_t i = 0; i < q; i++)
    if (um_study_is_curve(r, &r->quantity[i])) row += r->quantity[i].count;
  return row;
}

static double largest_of(const struct um_study_result *r, const struct um_study_statistics *l,
                         size_t q)
{
  double largest = 0.0;
  for (size_t k = 0; k < r->quantity[q].count; k++)
    largest = fmax(largest, fabs(l->quantile[4 * r->nvalue + r->quantity[q].first + k]));
  return largest;
}

static void curve(struct um_plot *plot, const struct um_study_result *r,
                  const struct um_study_statistics *l, size_t q, bool legend)
{
  const struct um_study_quantity *of = &r->quantity[q];
  bool magnitude = strcmp(of->unit, "mag") == 0;
  char words[100];
  double power = um_study_axis_unit(of, largest_of(r, l, q), words);
  size_t first = row_of(r, q), last = first + of->count - 1;
  um_plot_ylabel(plot, of->name, words);
  um_plot_add(plot, legend ? "set key\n" : "unset key\n");
  um_plot_add(plot, magnitude ? "set yrange [*:*] reverse\n" : "set yrange [*:*] noreverse\n");
  um_plot_add(
      plot,
      "set ytics autofreq\ny(i) = strcol(i) eq '' ? NaN : column(i) / %g\n"
      "plot 'curves.csv' every ::%zu::%zu using (x(1)):(y(7)):(y(11)) with filledcurves "
      "fillcolor rgb '#cfe0f0' title '5 to 95 %%', '' every ::%zu::%zu using "
      "(x(1)):(y(8)):(y(10)) with filledcurves fillcolor rgb '#8db8dc' title '25 to 75 %%', "
      "'' every ::%zu::%zu using (x(1)):(y(9)) with lines linewidth 2 linecolor rgb "
      "'#0072b2' title 'median'",
      power, first, last, first, last, first, last);
  if (r->nominal != NULL)
    um_plot_add(plot,
                ", '' every ::%zu::%zu using (x(1)):(y(4)) with lines linewidth 1.6 dashtype (8,5) "
                "linecolor rgb '#d55e00' title 'as the scenario stands'",
                first, last);
  um_plot_add(plot, "\n");
}

/* Rows of the shares' legend: two, or one for each name where they are long. */
static int legend_rows(const struct um_study_result *r)
{
  size_t length = 0;
  for (size_t i = 0; i < r->nparameter; i++) length += strlen(r->parameter_name[i]) + 4;
  return length < WIDE ? 2 : (int)r->nparameter + 1;
}

/* Does anything vary a curve at any time? */
static bool varies(const struct um_study_statistics *l, const struct um_study_quantity *of)
{
  double quiet = um_study_quiet(l, of);
  for (size_t k = of->first; k < of->first + of->count; k++)
    if (l->deviation[k] > quiet) return true;
  return false;
}

/* Shares, one parameter on the other; what is left belongs to several at once. */
static void shares(struct um_plot *plot, const struct um_study_result *r,
                   const struct um_study_statistics *l, size_t q, bool legend)
{
  const struct um_study_quantity *of = &r->quantity[q];
  size_t first = row_of(r, q), last = first + of->count - 1;
  bool sobol = l->indices == UM_STUDY_INDICES_SURROGATE || l->indices == UM_STUDY_INDICES_SAMPLED;
  um_plot_ylabel(plot, "", "share of variance");
  if (legend)
    um_plot_add(plot, "set key vertical maxrows %d\n", legend_rows(r));
  else
    um_plot_add(plot, "unset key\n");
  const char *note = !varies(l, of) ? "nothing varies it" : of->withheld ? "withheld" : NULL;
  if (note != NULL)
    um_plot_add(plot, "set label 1 %s at graph 0.5, graph 0.5 center textcolor rgb '#666666'\n",
                note);
  /* up to column i of the parameters' first indices, none where nothing varies or none is said */
  um_plot_add(plot,
              "set yrange [0:1] noreverse\nset ytics 0.5\n"
              "moves(i) = strcol(3) eq '' ? NaN : strcol(4) ne '' && column(3) > %g ? 1 : 0\n"
              "f(i) = strcol(i) eq '' ? 0 : column(i) < 0 ? 0 : column(i)\n"
              "upto(n) = moves(0) == 0 ? 0 : moves(0) * (sum [j=1:n] f(4 * j))\n"
              "plot ",
              um_study_quiet(l, of));
  for (size_t i = 0; i < r->nparameter; i++)
    um_plot_add(plot,
                "'indices.csv' every ::%zu::%zu using (x(1)):(upto(%zu)):(upto(%zu)) with "
                "filledcurves fillcolor rgb %s title %s noenhanced, ",
                first, last, i, i + 1, um_study_colour(i), r->parameter_name[i]);
  if (sobol)
    um_plot_add(plot,
                "'indices.csv' every ::%zu::%zu using (x(1)):(upto(%zu)):(moves(0)) with "
                "filledcurves fillcolor rgb '#bbbbbb' title 'several at once'",
                first, last, r->nparameter);
  else
    um_plot_add(plot, "NaN notitle");
  um_plot_add(plot, "\nunset label 1\n");
}

static void picture(struct um_plot *plot, const struct um_study_result *r,
                    const struct um_study_statistics *l, const char *name, const size_t *q,
                    size_t n)
{
  char start[32], below[200];
  bool indices = l->first != NULL;
  int each = CURVE + (indices ? GAP + SHARES : 0), top = TOP;
  int legend = indices ? LEGEND + ROW * legend_rows(r) - GAP : 0, more = legend; /* of the first */
  um_orbit_time_format(r->time[0], start);
  struct um_plot_time time = um_plot_time(r->time[0], r->time[r->ntime - 1], start);
  um_plot_picture(plot, name, WIDTH, TOP + (int)n * each + legend + ((int)n - 1) * BETWEEN + BELOW);
  snprintf(below, sizeof below, "%zu points; %s", l->ndone, um_study_indices_words(l->indices));
  um_plot_title(plot, r->name, below);
  um_plot_time_axis(plot, &time);
  if (r->sunlit != NULL) um_plot_shade(plot, &time, r->ntime, r->time, r->sunlit);
  for (size_t i = 0; i < n; i++, top += each + BETWEEN, more = 0) {
    if (i == 1) top += legend;
    um_plot_xnumbers(plot, false);
    um_plot_panel(plot, LEFT, top, RIGHT, top + CURVE);
    if (!indices && i + 1 == n) {
      um_plot_xnumbers(plot, true);
      um_plot_time_label(plot, &time);
    }
    curve(plot, r, l, q[i], i == 0);
    if (!indices) continue;
    um_plot_panel(plot, LEFT, top + CURVE + GAP + more, RIGHT, top + each + more);
    um_plot_xnumbers(plot, i + 1 == n);
    if (i + 1 == n) um_plot_time_label(plot, &time);
    shares(plot, r, l, q[i], i == 0);
  }
}

void um_study_plot_curves(struct um_plot *plot, const struct um_study_result *result,
                          const struct um_study_statistics *statistics)
{
  static const char *const name[3] = {"bands", "temperatures", "curves"};
  for (size_t kind = 0; kind < 3; kind++) {
    size_t q[AT_A_TIME], n = 0, pictures = 0;
    for (size_t i = 0; i <= result->nquantity; i++) {
      bool end = i == result->nquantity;
      if (!end) {
        const struct um_study_quantity *of = &result->quantity[i];
        size_t is = of->light ? 0 : strcmp(of->unit, "K") == 0 ? 1 : 2;
        if (is == kind && um_study_is_curve(result, of)) q[n++] = i;
      }
      if (n == 0 || (n < AT_A_TIME && !end)) continue;
      char file[40];
      snprintf(file, sizeof file, "%s", name[kind]);
      if (pictures > 0) snprintf(file, sizeof file, "%s_%zu", name[kind], pictures + 1);
      picture(plot, result, statistics, file, q, n);
      pictures++;
      n = 0;
    }
  }
}
