/* Pictures of a diagnosis by gnuplot: per channel data with the model before and after and the
 * residuals of both. The script is kept beside them. */
#include "diagnosis/report/plot.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/figures.h"
#include "core/order.h"
#include "diagnosis/report/channels.h"
#include "diagnosis/report/plot_frame_impl.h"
#include "diagnosis/report/plot_ranking_impl.h"
#include "orbit/time.h"

#define GAP 8.0 /* median steps over which a curve is not drawn */
#define FEW 300 /* observations up to which they are drawn over the curves */

/* Pixels. */
#define WIDTH    UM_DIAGNOSIS_PLOT_WIDTH
#define LEFT     UM_DIAGNOSIS_PLOT_LEFT
#define RIGHT    UM_DIAGNOSIS_PLOT_RIGHT
#define TOP      100
#define VALUES   330
#define RESIDUAL 140
#define BETWEEN  22
#define BELOW    58

/* ---- channels ---- */

/* Step between observations beyond which a curve has a gap [s]. */
static enum um_status gap_of(struct um_context *context, const struct um_diagnosis *d, size_t c,
                             double *out, size_t *count)
{
  size_t *row;
  double *step = NULL;
  UM_TRY(um_diagnosis_report_channel_rows(context, d, c, &row, count));
  enum um_status status = um_core_allocate(context, *count, sizeof *step, &step);
  *out = INFINITY;
  if (status == UM_OK && *count > 2) {
    size_t n = *count - 1;
    for (size_t i = 0; i < n; i++)
      step[i] = d->forward->observations.t[row[i + 1]] - d->forward->observations.t[row[i]];
    qsort(step, n, sizeof *step, um_core_order_double);
    *out = GAP * step[n / 2];
  }
  um_core_free(context, step);
  um_core_free(context, row);
  return status;
}

/* "with panel_extraction of array, albedo" */
static void added(const struct um_diagnosis *d, char *out, size_t size)
{
  size_t n = 0;
  if (d->naddition == 0) snprintf(out, size, "nothing added");
  for (size_t i = 0; i < d->naddition && n < size; i++) {
    const struct um_model_addition *a = &d->addition[i];
    n += (size_t)snprintf(out + n, size - n, "%s%s%s%s", i == 0 ? "with " : ", ", a->effect->name,
                          a->target == NULL ? "" : " of ", a->target == NULL ? "" : a->target);
  }
}

static enum um_status put_title(struct um_context *context, const struct um_diagnosis *d, size_t c,
                                struct um_plot *plot)
{
  const struct um_compare_channel *channel = um_diagnosis_report_channel(d, c);
  struct um_compare_metrics before, after;
  char title[400], words[200], with[200], unit[80], below[400];
  UM_TRY(um_diagnosis_report_channel_metrics(context, d, c, d->value_before, d->dof, &before));
  UM_TRY(um_diagnosis_report_channel_metrics(context, d, c, d->value_after, d->dof_after, &after));
  um_compare_channel_words(channel, words, sizeof words);
  snprintf(title, sizeof title, "%.150s: %s", d->forward->model->scenario->name, words);
  added(d, with, sizeof with);
  um_plot_unit(um_compare_residual_unit(channel->quantity), unit);
  snprintf(below, sizeof below, "%.80s: rms %.3g → %.3g %s, reduced χ² %.3g → %.3g", with,
           before.rms, after.rms, unit, before.chi2_reduced, after.chi2_reduced);
  um_plot_title(plot, title, below);
  return UM_OK;
}

/* Largest residual in sigma, at least 1, rounded up to a number that halves well. */
static double largest_residual(const struct um_diagnosis *d, size_t c, const double *value)
{
  const struct um_sensitivity_forward *f = d->forward;
  double largest = 1.0;
  for (size_t i = 0; i < f->observations.count; i++)
    if (f->observations.channel[i] == c)
      largest =
          fmax(largest, fabs(f->observations.measured[i] - value[i]) / f->observations.sigma[i]);
  double power = pow(10.0, floor(log10(largest))), lead = largest / power;
  static const double round[] = {1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0};
  size_t i = 0;
  while (i < 6 && lead > round[i]) i++;
  return power * round[i];
}

static double largest_value(const struct um_diagnosis *d, size_t c)
{
  const struct um_sensitivity_forward *f = d->forward;
  double largest = 0.0;
  for (size_t i = 0; i < f->observations.count; i++)
    if (f->observations.channel[i] == c)
      largest = fmax(largest, fmax(fabs(f->observations.measured[i]),
                                   fmax(fabs(d->value_before[i]), fabs(d->value_after[i]))));
  return largest;
}

/* Observations of a channel in fit.csv, counted from its header, which is 0, and their number. */
struct rows {
  size_t first, last, count;
};

static void put_points(struct um_plot *plot, struct rows rows, bool few)
{
  um_plot_add(
      plot,
      "'fit.csv' every ::%zu::%zu using (x(1)):(y(4)-s(5)):(0):(2*s(5)) with vectors "
      "nohead linewidth %g linecolor rgb %s notitle, '' every ::%zu::%zu using "
      "(x(1)):(y(4)) with points pointtype 7 pointsize %g linecolor rgb %s title 'measured'",
      rows.first, rows.last, few ? 0.9 : 0.5, few ? "#777777" : "#b0b0b0", rows.first, rows.last,
      few ? 0.4 : 0.25, few ? "#333333" : "#9a9a9a");
}

/* Column `column` of fit.csv, a model, as a curve with gaps, or as points. */
static void put_model(struct um_plot *plot, struct rows rows, int column, bool curve)
{
  bool before = column == 6;
  if (curve)
    um_plot_add(
        plot,
        "last = 1e30, 'fit.csv' every ::%zu::%zu using (x(1)):(L(%d)) with lines linewidth 2 ",
        rows.first, rows.last, column);
  else
    um_plot_add(plot, "'fit.csv' every ::%zu::%zu using (x(1)):(y(%d)) with points pointtype %d ",
                rows.first, rows.last, column, before ? 6 : 2);
  if (curve && before) um_plot_add(plot, "dashtype (6,4) ");
  um_plot_add(plot, "linecolor rgb %s title %s", before ? "#d9480f" : "#1f4e9c",
              before ? "before" : "after");
}

static void put_values(const struct um_diagnosis *d, size_t c, struct rows rows,
                       struct um_plot *plot)
{
  const struct um_compare_channel *channel = um_diagnosis_report_channel(d, c);
  bool few = rows.count <= FEW, curve = !d->forward->model->points && rows.count > 2;
  bool magnitude = um_compare_is_magnitude(channel->quantity);
  char name[200], unit[80], words[120];
  um_compare_channel_words(channel, name, sizeof name);
  double power = um_plot_power(magnitude ? 1.0 : largest_value(d, c),
                               um_compare_quantity_unit(channel->quantity), unit);
  snprintf(words, sizeof words, "[%s]", unit);
  um_plot_ylabel(plot, name, words);
  um_plot_add(plot, "y(i) = column(i) / %g\ns(i) = strcol(i) eq '' ? 0 : column(i) / %g\n", power,
              power);
  um_plot_add(plot, magnitude ? "set yrange [*:*] reverse\n" : "set yrange [*:*] noreverse\n");
  um_plot_add(plot, "plot ");
  if (!few) put_points(plot, rows, few);
  if (!few) um_plot_add(plot, ", ");
  put_model(plot, rows, 6, curve);
  um_plot_add(plot, ", ");
  put_model(plot, rows, 7, curve);
  if (few) um_plot_add(plot, ", ");
  if (few) put_points(plot, rows, few);
  um_plot_add(plot, "\n");
}

/* Residuals of either model on a scale of its own. */
static void put_residuals(const struct um_diagnosis *d, size_t c, bool before, struct rows rows,
                          struct um_plot *plot)
{
  double range = largest_residual(d, c, before ? d->value_before : d->value_after);
  um_plot_ylabel(plot, before ? "before" : "after", "residual / σ");
  um_plot_add(plot,
              "set yrange [%.6g:%.6g] noreverse\nset ytics %.6g\n"
              "plot 0 with lines linecolor rgb '#888888' notitle, 1 with lines dashtype (3,4) "
              "linecolor rgb '#888888' notitle, -1 with lines dashtype (3,4) linecolor rgb "
              "'#888888' notitle, 'fit.csv' every ::%zu::%zu using (x(1)):%d with points pointtype "
              "7 pointsize %g linecolor rgb %s notitle\n",
              -1.1 * range, 1.1 * range, 0.5 * range, rows.first, rows.last, before ? 8 : 9,
              rows.count <= FEW ? 0.5 : 0.25, before ? "#d9480f" : "#1f4e9c");
}

/* Data and both models above, the residuals of either below. */
static enum um_status put_channel(struct um_context *context, const struct um_diagnosis *d,
                                  size_t c, const struct um_plot_time *time, size_t first,
                                  size_t *count, struct um_plot *plot)
{
  char *name;
  double gap;
  UM_TRY(gap_of(context, d, c, &gap, count));
  if (*count == 0) return UM_OK;
  struct rows rows = {first, first + *count - 1, *count};
  int below = TOP + VALUES + BETWEEN, last = below + RESIDUAL + BETWEEN;
  UM_TRY(um_compare_channel_file(context, um_diagnosis_report_channel(d, c), &name));
  um_plot_picture(plot, name, WIDTH, last + RESIDUAL + BELOW);
  um_core_free(context, name);
  UM_TRY(put_title(context, d, c, plot));
  um_plot_time_axis(plot, time);
  UM_TRY(um_diagnosis_report_plot_shade(context, d, time, plot));
  um_plot_add(plot,
              "gap = %.9g\nL(i) = (v = x(1), step = v - last, last = v, step > gap ? NaN : y(i))\n",
              isfinite(gap) ? gap / time->unit : 1e30);
  um_plot_xnumbers(plot, false);
  um_plot_panel(plot, LEFT, TOP, RIGHT, TOP + VALUES);
  put_values(d, c, rows, plot);
  um_plot_panel(plot, LEFT, below, RIGHT, below + RESIDUAL);
  put_residuals(d, c, true, rows, plot);
  um_plot_panel(plot, LEFT, last, RIGHT, last + RESIDUAL);
  um_plot_xnumbers(plot, true);
  um_plot_time_label(plot, time);
  put_residuals(d, c, false, rows, plot);
  return UM_OK;
}

static enum um_status put_script(struct um_context *context, const struct um_diagnosis *d,
                                 struct um_plot *plot)
{
  const struct um_sensitivity_forward *forward = d->forward;
  double first = INFINITY, last = -INFINITY;
  for (size_t i = 0; i < forward->observations.count; i++) {
    first = fmin(first, forward->observations.t[i]);
    last = fmax(last, forward->observations.t[i]);
  }
  struct um_plot_time time = um_diagnosis_report_plot_time(first, last);
  for (size_t c = 0, row = 1, count; c < forward->measurements->nchannel; c++, row += count)
    UM_TRY(put_channel(context, d, c, &time, row, &count, plot));
  if (d->nranking > 0) UM_TRY(um_diagnosis_report_plot_ranking(context, d, plot));
  if (d->unexplained != NULL && d->unexplained->nheat > 0 && d->unexplained->heat[0].nbin > 0)
    UM_TRY(um_diagnosis_report_plot_heat(context, d, plot));
  return UM_OK;
}

enum um_status um_diagnosis_report_plot(struct um_context *context,
                                        const struct um_diagnosis *diagnosis, const char *folder)
{
  struct um_plot *plot;
  UM_TRY(um_plot_create(context, folder, "plots.gp", &plot));
  enum um_status status = put_script(context, diagnosis, plot);
  if (status == UM_OK) status = um_plot_draw(context, &plot);
  um_plot_destroy(context, &plot);
  return status;
}
