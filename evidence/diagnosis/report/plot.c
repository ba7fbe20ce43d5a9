/* Pictures of a diagnosis by gnuplot: per channel data with the model before and after and the
 * residuals of both. The script is kept beside them. */
#include "evidence/diagnosis/report/plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "evidence/comparison/figures.h"
#include "evidence/comparison/shade.h"
#include "evidence/diagnosis/report/channels.h"
#include "evidence/diagnosis/report/report_impl.h"

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

/* What the panels of a channel show. */
struct shown {
  const struct um_diagnosis *d;
  size_t channel, number; /* number: of its picture, from 0 */
  bool curve, magnitude, few;
  size_t first, last, count; /* rows of fit.csv, counted from its header, which is 0 */
  struct um_plot_range values, residuals[2]; /* before, after; the latter in sigma */
};

/* The axes, and both models as curves with gaps: $curve2N and $curve2N+1 of picture N. row [count].
 */
static enum um_status prepare(struct um_context *context, struct shown *s, const size_t *row,
                              const struct um_plot_time *time, struct um_plot *plot)
{
  const struct um_sensitivity_observations *o = &s->d->forward->observations;
  enum um_compare_quantity quantity = um_diagnosis_report_channel(s->d, s->channel)->quantity;
  bool light = !s->magnitude && quantity != UM_QUANTITY_TEMPERATURE;
  size_t n = s->count;
  double *all = NULL, gap;
  enum um_status status;
  UM_CHECK(um_core_allocate(context, 4 * n, sizeof *all, &all));
  double *t = all + 3 * n;
  const struct um_plot_values of[] = {
      {all, n, UM_PLOT_MOST}, {all + n, n, UM_PLOT_MIDDLE}, {all + 2 * n, n, UM_PLOT_MIDDLE}};
  for (size_t i = 0; i < n; i++) t[i] = o->t[row[i]];
  UM_CHECK(um_plot_gap(context, n, t, &gap));
  for (int k = 0; k < 2; k++) {
    const double *value = k == 0 ? s->d->value_before : s->d->value_after;
    for (size_t i = 0; i < n; i++)
      all[i] = (o->measured[row[i]] - value[row[i]]) / o->sigma[row[i]];
    UM_CHECK(um_plot_range(context, of, 1, 0.0, UM_PLOT_STRETCH, &s->residuals[k]));
  }
  for (size_t i = 0; i < n; i++) {
    all[i] = um_diagnosis_report_in_unit(quantity, o->measured[row[i]]);
    all[n + i] = um_diagnosis_report_in_unit(quantity, s->d->value_before[row[i]]);
    all[2 * n + i] = um_diagnosis_report_in_unit(quantity, s->d->value_after[row[i]]);
  }
  for (size_t k = 0; k < 2 && s->curve; k++)
    um_plot_curve(plot, time, 2 * s->number + k, n, t, all + (k + 1) * n, gap);
  UM_CHECK(um_plot_range(context, of, 3, NAN, light ? UM_PLOT_STRETCH_LIGHT : UM_PLOT_STRETCH,
                         &s->values));
done:
  um_core_free(context, all);
  return status;
}

static enum um_status put_title(struct um_context *context, const struct um_diagnosis *d, size_t c,
                                struct um_plot *plot)
{
  const struct um_compare_channel *channel = um_diagnosis_report_channel(d, c);
  struct um_compare_metrics before, after;
  char title[400], words[200], verdict[400], unit[80];
  UM_TRY(um_diagnosis_report_channel_metrics(context, d, c, d->value_before, d->dof, &before));
  UM_TRY(um_diagnosis_report_channel_metrics(context, d, c, d->value_after, d->dof_after, &after));
  um_compare_channel_words(channel, words, sizeof words);
  um_plot_unit(um_compare_residual_unit(channel->quantity), unit);
  snprintf(title, sizeof title, "%.100s: %.60s: rms %.3g → %.3g %s, reduced χ² %.3g → %.3g",
           d->forward->model->scenario->name, words, before.rms, after.rms, unit,
           before.chi2_reduced, after.chi2_reduced);
  um_diagnosis_report_plot_verdict(d, verdict, sizeof verdict);
  um_plot_title(plot, title, verdict);
  return UM_OK;
}

static void put_points(struct um_plot *plot, const struct shown *s)
{
  bool few = s->few;
  um_plot_add(
      plot,
      "'fit.csv' every ::%zu::%zu using (x(1)):(y(4)-s(5)):(0):(2*s(5)) with vectors "
      "nohead linewidth %g linecolor rgb %s notitle, '' every ::%zu::%zu using "
      "(x(1)):(y(4)) with points pointtype 7 pointsize %g linecolor rgb %s title 'measured'",
      s->first, s->last, few ? 0.9 : 0.5, few ? "#777777" : "#b0b0b0", s->first, s->last,
      few ? 0.4 : 0.25, few ? "#333333" : "#9a9a9a");
}

/* A model, as a curve with gaps, or as points. */
static void put_model(struct um_plot *plot, const struct shown *s, bool before, double unit)
{
  if (s->curve)
    um_plot_add(
        plot, "$curve%zu using 1:($2/%g) with linespoints linewidth 2 pointtype 7 pointsize 0.15 ",
        2 * s->number + (before ? 0 : 1), unit);
  else
    um_plot_add(plot, "'fit.csv' every ::%zu::%zu using (x(1)):(y(%d)) with points pointtype %d ",
                s->first, s->last, before ? 6 : 7, before ? 6 : 2);
  if (s->curve && before) um_plot_add(plot, "dashtype (6,4) ");
  um_plot_add(plot, "linecolor rgb %s title %s", before ? "#d9480f" : "#1f4e9c",
              before ? "before" : "after");
}

/* Where the draws of a posterior have the model, 5 to 95 %. */
static void put_band(struct um_plot *plot, const struct shown *s, double unit)
{
  um_plot_add(plot,
              "'posterior_curves.csv' every ::%zu::%zu using (x(1)):(column(4)/%g):(column(6)/%g) "
              "with filledcurves fillcolor rgb '#b8cbe8' title 'after, 5 to 95 %%', ",
              s->first, s->last, unit, unit);
}

/* At its end what lies beyond the axis: measured, before, after. */
static void put_cut(struct um_plot *plot, const struct shown *s)
{
  static const struct {
    int column;
    const char *colour;
  } of[] = {{4, "#333333"}, {6, "#d9480f"}, {7, "#1f4e9c"}};
  for (size_t i = 0; i < 3 && s->values.cut; i++)
    um_plot_add(plot,
                ", 'fit.csv' every ::%zu::%zu using (x(1)):(edge(y(%d))) with points pointtype 12 "
                "linecolor rgb %s notitle",
                s->first, s->last, of[i].column, of[i].colour);
  um_plot_add(plot, "\n");
}

static void put_values(const struct shown *s, struct um_plot *plot)
{
  const struct um_compare_channel *channel = um_diagnosis_report_channel(s->d, s->channel);
  char name[200], unit[80], words[120];
  um_compare_channel_words(channel, name, sizeof name);
  double largest = fmax(fabs(s->values.low), fabs(s->values.high));
  double power = um_plot_power(s->magnitude ? 1.0 : largest,
                               um_compare_quantity_unit(channel->quantity), unit);
  snprintf(words, sizeof words, "[%s]", unit);
  um_plot_ylabel(plot, name, words);
  um_plot_add(plot, "y(i) = column(i) / %g\ns(i) = strcol(i) eq '' ? 0 : column(i) / %g\n", power,
              power);
  um_plot_ordinate(plot, &s->values, power, s->magnitude);
  um_plot_add(plot, "plot ");
  if (s->d->posterior != NULL && s->curve) put_band(plot, s, power);
  if (!s->few) put_points(plot, s);
  if (!s->few) um_plot_add(plot, ", ");
  put_model(plot, s, true, power);
  um_plot_add(plot, ", ");
  put_model(plot, s, false, power);
  if (s->few) um_plot_add(plot, ", ");
  if (s->few) put_points(plot, s);
  put_cut(plot, s);
}

/* Residuals of either model on a scale of its own. */
static void put_residuals(const struct shown *s, bool before, struct um_plot *plot)
{
  struct um_plot_range range = s->residuals[before ? 0 : 1];
  range.high = fmax(1.1, fmax(range.high, -range.low));
  range.low = -range.high;
  um_plot_ylabel(plot, before ? "before" : "after", "residual / σ");
  um_plot_ordinate(plot, &range, 1.0, false);
  const char *colour = before ? "#d9480f" : "#1f4e9c";
  int column = before ? 8 : 9;
  um_plot_add(plot,
              "set ytics %.6g\n"
              "plot 0 with lines linecolor rgb '#888888' notitle, 1 with lines dashtype (3,4) "
              "linecolor rgb '#888888' notitle, -1 with lines dashtype (3,4) linecolor rgb "
              "'#888888' notitle, 'fit.csv' every ::%zu::%zu using (x(1)):%d with points pointtype "
              "7 pointsize %g linecolor rgb %s notitle",
              um_plot_spacing(2.0 * range.high), s->first, s->last, column, s->few ? 0.5 : 0.25,
              colour);
  if (range.cut)
    um_plot_add(plot,
                ", '' every ::%zu::%zu using (x(1)):(edge(column(%d))) with points pointtype 12 "
                "linecolor rgb %s notitle",
                s->first, s->last, column, colour);
  um_plot_add(plot, "\n");
}

static enum um_status put_panels(struct um_context *context, struct shown *s,
                                 const struct um_plot_time *time, struct um_plot *plot)
{
  char *name;
  int below = TOP + VALUES + BETWEEN, last = below + RESIDUAL + BETWEEN;
  UM_TRY(um_compare_channel_file(context, um_diagnosis_report_channel(s->d, s->channel), &name));
  um_plot_picture(plot, name, WIDTH, last + RESIDUAL + BELOW);
  um_core_free(context, name);
  UM_TRY(put_title(context, s->d, s->channel, plot));
  um_plot_time_axis(plot, time);
  UM_TRY(um_compare_plot_shade(context, s->d->forward->model, time, plot));
  um_plot_xnumbers(plot, false);
  um_plot_panel(plot, LEFT, TOP, RIGHT, TOP + VALUES);
  put_values(s, plot);
  um_plot_panel(plot, LEFT, below, RIGHT, below + RESIDUAL);
  put_residuals(s, true, plot);
  um_plot_panel(plot, LEFT, last, RIGHT, last + RESIDUAL);
  um_plot_xnumbers(plot, true);
  um_plot_time_label(plot, time);
  put_residuals(s, false, plot);
  return UM_OK;
}

/* Data and both models above, the residuals of either below. first: row of fit.csv; *count: rows.
 */
static enum um_status put_channel(struct um_context *context, const struct um_diagnosis *d,
                                  size_t c, const struct um_plot_time *time, size_t first,
                                  size_t *count, struct um_plot *plot)
{
  size_t *row;
  UM_TRY(um_diagnosis_report_channel_rows(context, d, c, &row, count));
  struct shown s = {.d = d, .channel = c, .number = c, .count = *count};
  s.first = first;
  s.last = first + *count - 1;
  s.few = *count <= FEW;
  s.curve = !d->forward->model->points && *count > 2;
  s.magnitude = um_compare_is_magnitude(um_diagnosis_report_channel(d, c)->quantity);
  enum um_status status = *count > 0 ? prepare(context, &s, row, time, plot) : UM_OK;
  um_core_free(context, row);
  if (status != UM_OK || *count == 0) return status;
  return put_panels(context, &s, time, plot);
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
  if (d->posterior != NULL) UM_TRY(um_diagnosis_report_plot_posterior(context, d, plot));
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
