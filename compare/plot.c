/* A picture per channel by gnuplot, from residuals.csv. The script is kept beside it. */
#include "compare/plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/figures.h"
#include "orbit/time.h"
#include "plot/plot.h"

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

static double largest_of(const struct um_compare_comparison *c, size_t i)
{
  const struct um_compare_channel_comparison *channel = &c->channel[i];
  double largest = 0.0;
  for (size_t k = 0; k < channel->count; k++) {
    size_t row = channel->row[k];
    double model = isnan(c->model[row]) ? 0.0 : fabs(c->model[row]);
    largest = fmax(largest, fmax(fabs(c->run.plan->measurements->row[row].value), model));
  }
  return largest;
}

static void values(struct um_plot *plot, const struct um_compare_comparison *c, size_t i,
                   struct rows rows)
{
  const struct um_compare_channel *of = &c->run.plan->measurements->channel[c->channel[i].channel];
  bool few = c->channel[i].count <= FEW;
  char name[200], unit[80], words[120];
  um_compare_channel_words(of, name, sizeof name);
  double power = um_plot_power(um_compare_is_magnitude(of->quantity) ? 1.0 : largest_of(c, i),
                               um_compare_quantity_unit(of->quantity), unit);
  snprintf(words, sizeof words, "[%s]", unit);
  um_plot_ylabel(plot, name, words);
  um_plot_add(plot,
              "y(i) = column(i) / %g\ns(i) = strcol(i) eq '' ? 0 : column(i) / %g\n"
              "plot 'residuals.csv' every ::%zu::%zu using (x(1)):(y(4)-s(6)):(0):(2*s(6)) with "
              "vectors nohead linewidth 0.9 linecolor rgb '#8a8a8a' notitle, '' every ::%zu::%zu "
              "using (x(1)):(y(4)) with points pointtype 7 pointsize %g linecolor rgb '#444444' "
              "title 'measured', '' every ::%zu::%zu using (x(1)):(y(5)) with ",
              power, power, rows.first, rows.last, rows.first, rows.last, few ? 0.4 : 0.25,
              rows.first, rows.last);
  if (c->run.model->points)
    um_plot_add(plot, "points pointtype 6 pointsize 0.6 ");
  else
    um_plot_add(plot, "lines linewidth 2 ");
  um_plot_add(plot, "linecolor rgb '#b3261e' title 'model'\n");
}

static void residuals(struct um_plot *plot, const struct um_compare_comparison *c, size_t i,
                      struct rows rows)
{
  const struct um_compare_channel *of = &c->run.plan->measurements->channel[c->channel[i].channel];
  bool weighted = !isnan(c->channel[i].all.chi2);
  char unit[80], words[120];
  double largest = 0.0;
  for (size_t k = 0; k < c->channel[i].count; k++) {
    double residual = c->residual[c->channel[i].row[k]];
    if (isfinite(residual)) largest = fmax(largest, fabs(residual));
  }
  double power =
      um_plot_power(weighted ? 1.0 : largest, um_compare_residual_unit(of->quantity), unit);
  snprintf(words, sizeof words, "[%s]", unit);
  um_plot_ylabel(plot, weighted ? "" : "measured − model",
                 weighted ? "(measured − model) / σ" : words);
  um_plot_add(plot, "plot 0 with lines linecolor rgb '#888888' notitle, ");
  if (weighted)
    um_plot_add(plot, "1 with lines dashtype (3,4) linecolor rgb '#888888' notitle, -1 with lines "
                      "dashtype (3,4) linecolor rgb '#888888' notitle, ");
  um_plot_add(plot,
              "'residuals.csv' every ::%zu::%zu using (x(1)):(column(%d) / %g) with points "
              "pointtype 7 pointsize %g linecolor rgb '#1f4e9c' notitle\n",
              rows.first, rows.last, weighted ? 8 : 7, power,
              c->channel[i].count <= FEW ? 0.5 : 0.25);
}

static enum um_status picture(struct um_context *context, struct um_plot *plot,
                              const struct um_compare_comparison *c, size_t i, struct rows rows)
{
  const struct um_model_precomputed *t = c->run.precomputed;
  const struct um_compare_channel_comparison *channel = &c->channel[i];
  const struct um_compare_channel *of = &c->run.plan->measurements->channel[channel->channel];
  char start[32], *name = NULL, text[300];
  um_orbit_time_format(t->t_obs[0], start);
  struct um_plot_time time = um_plot_time(t->t_obs[0], t->t_obs[t->nobs - 1], start);
  UM_TRY(um_compare_channel_file(context, of, &name));
  um_plot_picture(plot, name, WIDTH, TOP + VALUES + GAP + RESIDUAL + BELOW);
  um_core_free(context, name);
  um_compare_channel_words(of, text, sizeof text);
  size_t n = strlen(text);
  if (!isnan(channel->all.chi2_reduced))
    snprintf(text + n, sizeof text - n, ": %zu observations, reduced χ² %.3g", channel->all.count,
             channel->all.chi2_reduced);
  um_plot_title(plot, c->run.model->scenario->name, text);
  um_plot_time_axis(plot, &time);
  um_plot_shade(plot, &time, t->nobs, t->t_obs, t->sunlit);
  um_plot_xnumbers(plot, false);
  um_plot_panel(plot, LEFT, TOP, RIGHT, TOP + VALUES);
  um_plot_add(plot, um_compare_is_magnitude(of->quantity) ? "set yrange [*:*] reverse\n"
                                                          : "set yrange [*:*] noreverse\n");
  values(plot, c, i, rows);
  um_plot_panel(plot, LEFT, TOP + VALUES + GAP, RIGHT, TOP + VALUES + GAP + RESIDUAL);
  um_plot_add(plot, "set yrange [*:*] noreverse\n");
  um_plot_xnumbers(plot, true);
  um_plot_time_label(plot, &time);
  residuals(plot, c, i, rows);
  return UM_OK;
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
