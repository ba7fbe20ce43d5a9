/* A picture per channel by gnuplot, from residuals.csv. The script is kept beside it. */
#include "evidence/comparison/plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/plot/plot.h"
#include "evidence/comparison/figures.h"
#include "evidence/comparison/predict.h"
#include "evidence/comparison/shade.h"
#include "orbit/time.h"

/* Pixels. */
#define WIDTH    1000
#define LEFT     100
#define RIGHT    980
#define TOP      100
#define VALUES   340
#define RESIDUAL 190
#define GAP      22
#define BELOW    58

#define FEW 300 /* observations up to which they are drawn large */

/* Rows of residuals.csv, counted from its header, which is 0. */
struct rows {
  size_t first, last;
};

/* What the panels of a channel show. */
struct shown {
  const struct um_compare_comparison *c;
  const struct um_compare_channel_comparison *channel;
  const struct um_compare_channel *of;
  struct rows rows;
  size_t number;      /* of the curve */
  bool few, weighted; /* residuals are in sigma */
  double *curve;      /* [nobs] model at every observation of the run, of any channel */
  struct um_plot_range values, residuals;
  double unit;     /* of values */
  char words[120]; /* "[mag]" */
};

static bool is_linear_light(enum um_compare_quantity quantity)
{
  return !um_compare_is_magnitude(quantity) && quantity != UM_QUANTITY_TEMPERATURE &&
         !um_compare_is_grey_body(quantity);
}

/* Axes: of what is measured and of the model, and of residuals. */
static enum um_status ranges(struct um_context *context, struct shown *s)
{
  const struct um_compare_comparison *c = s->c;
  size_t n = s->channel->count;
  bool light = is_linear_light(s->of->quantity);
  double *all = NULL;
  enum um_status status;
  UM_CHECK(um_core_allocate(context, 3 * n, sizeof *all, &all));
  const struct um_plot_values of[] = {{all, n, UM_PLOT_MOST},
                                      {all + n, n, UM_PLOT_MIDDLE},
                                      {s->curve, c->run.tables->nobs, UM_PLOT_NEAR}};
  const struct um_plot_values residual = {all + 2 * n, n, UM_PLOT_MOST};
  for (size_t k = 0; k < n; k++) {
    size_t row = s->channel->row[k];
    const struct um_compare_residual *r = &c->residual[row];
    all[k] = c->run.plan->measurements->row[row].value;
    all[n + k] = c->model[row];
    all[2 * n + k] = !s->weighted      ? r->measured - r->model
                     : isnan(r->sigma) ? (double)NAN
                                       : um_compare_residual_normalised(r);
  }
  UM_CHECK(um_plot_range(context, &residual, 1, 0.0, UM_PLOT_STRETCH, &s->residuals));
  UM_CHECK(um_plot_range(context, of, 3, NAN, light ? UM_PLOT_STRETCH_LIGHT : UM_PLOT_STRETCH,
                         &s->values));
done:
  um_core_free(context, all);
  return status;
}

static enum um_status shown_of(struct um_context *context, const struct um_compare_comparison *c,
                               size_t i, struct rows rows, struct shown *out)
{
  const struct um_compare_run *run = &c->run;
  struct shown s = {.c = c, .channel = &c->channel[i], .rows = rows, .number = i};
  char unit[80];
  s.of = &run->plan->measurements->channel[s.channel->channel];
  s.few = s.channel->count <= FEW;
  s.weighted = !isnan(s.channel->all.chi2);
  UM_TRY(um_core_allocate(context, run->tables->nobs, sizeof *s.curve, &s.curve));
  for (size_t k = 0; k < run->tables->nobs; k++)
    s.curve[k] = um_compare_predict_at(run->plan, run->tables, run->result, s.channel->channel, k);
  enum um_status status = ranges(context, &s);
  double largest = fmax(fabs(s.values.low), fabs(s.values.high));
  s.unit = um_plot_power(um_compare_is_magnitude(s.of->quantity) ? 1.0 : largest,
                         um_compare_quantity_unit(s.of->quantity), unit);
  snprintf(s.words, sizeof s.words, "[%s]", unit);
  if (status != UM_OK) um_core_free(context, s.curve);
  *out = s;
  return status;
}

static enum um_status values(struct um_context *context, struct um_plot *plot,
                             const struct um_plot_time *time, const struct shown *s)
{
  const struct um_model_tables *t = s->c->run.tables;
  bool points = s->c->run.model->points;
  size_t first = s->rows.first, last = s->rows.last;
  char name[200];
  double gap;
  UM_TRY(um_plot_gap(context, t->nobs, t->t_obs, &gap));
  um_compare_channel_words(s->of, name, sizeof name);
  um_plot_ylabel(plot, name, s->words);
  um_plot_ordinate(plot, &s->values, s->unit, um_compare_is_magnitude(s->of->quantity));
  if (!points) um_plot_curve(plot, time, s->number, t->nobs, t->t_obs, s->curve, gap);
  um_plot_add(plot,
              "y(i) = column(i) / %g\ns(i) = strcol(i) eq '' ? 0 : column(i) / %g\n"
              "plot 'residuals.csv' every ::%zu::%zu using (x(1)):(y(4)-s(6)):(0):(2*s(6)) with "
              "vectors nohead linewidth 0.9 linecolor rgb '#8a8a8a' notitle, '' every ::%zu::%zu "
              "using (x(1)):(y(4)) with points pointtype 7 pointsize %g linecolor rgb '#444444' "
              "title 'measured', ",
              s->unit, s->unit, first, last, first, last, s->few ? 0.4 : 0.25);
  if (points)
    um_plot_add(plot,
                "'' every ::%zu::%zu using (x(1)):(y(5)) with points pointtype 6 pointsize 0.6 "
                "linecolor rgb '#b3261e' title 'model'",
                first, last);
  else
    um_plot_add(plot,
                "$curve%zu using 1:($2/%g) with linespoints linewidth 2 pointtype 7 pointsize 0.15 "
                "linecolor rgb '#b3261e' title 'model'",
                s->number, s->unit);
  if (s->values.cut)
    um_plot_add(plot,
                ", 'residuals.csv' every ::%zu::%zu using (x(1)):(edge(y(4))) with points "
                "pointtype 12 linecolor rgb '#444444' notitle, '' every ::%zu::%zu using "
                "(x(1)):(edge(y(5))) with points pointtype 12 linecolor rgb '#b3261e' notitle",
                first, last, first, last);
  um_plot_add(plot, "\n");
  return UM_OK;
}

static void residuals(struct um_plot *plot, const struct shown *s)
{
  size_t first = s->rows.first, last = s->rows.last;
  char unit[80], words[120];
  double power = um_plot_power(s->weighted ? 1.0 : fmax(-s->residuals.low, s->residuals.high),
                               um_compare_residual_unit(s->of->quantity), unit);
  snprintf(words, sizeof words, "[%s]", unit);
  um_plot_ylabel(plot, s->weighted ? "" : "measured − model",
                 s->weighted ? "(measured − model) / σ" : words);
  um_plot_ordinate(plot, &s->residuals, power, false);
  um_plot_add(plot, "plot 0 with lines linecolor rgb '#888888' notitle, ");
  if (s->weighted)
    um_plot_add(plot, "1 with lines dashtype (3,4) linecolor rgb '#888888' notitle, -1 with lines "
                      "dashtype (3,4) linecolor rgb '#888888' notitle, ");
  int column = s->weighted ? 8 : 7;
  um_plot_add(plot,
              "'residuals.csv' every ::%zu::%zu using (x(1)):(column(%d) / %g) with points "
              "pointtype 7 pointsize %g linecolor rgb '#1f4e9c' notitle",
              first, last, column, power, s->few ? 0.5 : 0.25);
  if (s->residuals.cut)
    um_plot_add(plot,
                ", '' every ::%zu::%zu using (x(1)):(edge(column(%d) / %g)) with points pointtype "
                "12 linecolor rgb '#1f4e9c' notitle",
                first, last, column, power);
  um_plot_add(plot, "\n");
}

static void title(struct um_plot *plot, const struct shown *s)
{
  char text[300];
  um_compare_channel_words(s->of, text, sizeof text);
  size_t n = strlen(text);
  if (!isnan(s->channel->all.chi2_reduced))
    snprintf(text + n, sizeof text - n, ": %zu observations, reduced χ² %.3g",
             s->channel->all.count, s->channel->all.chi2_reduced);
  um_plot_title(plot, s->c->run.model->scenario->name, text);
}

static enum um_status picture(struct um_context *context, struct um_plot *plot,
                              const struct um_compare_comparison *c, size_t i, struct rows rows)
{
  const struct um_model_tables *t = c->run.tables;
  struct shown s;
  enum um_status status;
  char start[32], *name = NULL;
  um_orbit_time_format(t->t_obs[0], start);
  struct um_plot_time time = um_plot_time(t->t_obs[0], t->t_obs[t->nobs - 1], start);
  UM_TRY(shown_of(context, c, i, rows, &s));
  UM_CHECK(um_compare_channel_file(context, s.of, &name));
  um_plot_picture(plot, name, WIDTH, TOP + VALUES + GAP + RESIDUAL + BELOW);
  title(plot, &s);
  um_plot_time_axis(plot, &time);
  UM_CHECK(um_compare_plot_shade(context, c->run.model, &time, plot));
  um_plot_xnumbers(plot, false);
  um_plot_panel(plot, LEFT, TOP, RIGHT, TOP + VALUES);
  UM_CHECK(values(context, plot, &time, &s));
  um_plot_panel(plot, LEFT, TOP + VALUES + GAP, RIGHT, TOP + VALUES + GAP + RESIDUAL);
  um_plot_xnumbers(plot, true);
  um_plot_time_label(plot, &time);
  residuals(plot, &s);
done:
  UM_FREE(context, name, s.curve);
  return status;
}

enum um_status um_compare_plot(struct um_context *context,
                               const struct um_compare_comparison *comparison, const char *folder)
{
  enum um_status status = UM_OK;
  struct um_plot *plot = NULL;
  UM_TRY(um_plot_create(context, folder, "plots.gp", &plot));
  struct rows rows = {1, 0};
  for (size_t i = 0; i < comparison->nchannel; i++) {
    rows.last = rows.first + comparison->channel[i].count - 1;
    if (comparison->channel[i].count > 0) UM_CHECK(picture(context, plot, comparison, i, rows));
    rows.first = rows.last + 1;
  }
  status = um_plot_draw(context, &plot);
done:
  um_plot_destroy(context, &plot);
  return status;
}
