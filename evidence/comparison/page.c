/* report.html of a comparison: how far off the model is, where, and what its residual goes with. */
#include "evidence/comparison/page.h"

#include <math.h>
#include <string.h>

#include "evidence/comparison/channel_page.h"
#include "evidence/comparison/figures.h"
#include "evidence/comparison/shade.h"
#include "evidence/measurements/time_text.h"
#include "orbit/time.h"

#define STRONG 1e-2 /* p of a correlation that is shown */

struct work {
  struct um_page_writer *p;
  struct um_page *page; /* the writer's */
  const struct um_compare_comparison *c;
  struct um_compare_page_channel *channel; /* [nchannel] */
};

static const struct um_compare_channel *channel_of(const struct work *w, size_t i)
{
  return &w->c->run.plan->measurements->channel[w->c->channel[i].channel];
}

static enum um_status read_channel(struct work *w, size_t i)
{
  const struct um_compare_channel_comparison *channel = &w->c->channel[i];
  const struct um_compare_measurements *m = w->c->run.plan->measurements;
  size_t n = channel->count;
  bool weighted = !isnan(channel->all.chi2);
  double *time, *value, *sigma, *model, *residual;
  UM_TRY(UM_PAGE_ROOM(w->p, n, &time));
  UM_TRY(UM_PAGE_ROOM(w->p, n, &value));
  UM_TRY(UM_PAGE_ROOM(w->p, n, &sigma));
  UM_TRY(UM_PAGE_ROOM(w->p, n, &model));
  UM_TRY(UM_PAGE_ROOM(w->p, n, &residual));
  for (size_t k = 0; k < n; k++) {
    size_t row = channel->row[k];
    const struct um_compare_residual *r = &w->c->residual[row];
    time[k] = um_orbit_time_unix(m->row[row].t_tai);
    value[k] = m->row[row].value;
    sigma[k] = m->row[row].sigma;
    model[k] = w->c->model[row];
    residual[k] = !weighted         ? r->measured - r->model
                  : isnan(r->sigma) ? (double)NAN
                                    : um_compare_residual_normalised(r);
  }
  w->channel[i] = (struct um_compare_page_channel){.channel = channel_of(w, i),
                                                   .count = n,
                                                   .time = time,
                                                   .value = value,
                                                   .sigma = sigma,
                                                   .weighted = weighted,
                                                   .model = {{"model", "model", model, residual}},
                                                   .nmodel = 1};
  return UM_OK;
}

static enum um_status table_metrics(struct work *w)
{
  static const struct um_page_figure figure = {.id = "metrics", .title = "How far off"};
  enum { OBSERVATIONS, BIAS, RMS, SHARE, CHI2, WHITE, COLUMNS };
  size_t n = w->c->nchannel;
  const char **name, **unit;
  double *value[COLUMNS];
  UM_TRY(UM_PAGE_ROOM(w->p, n, &name));
  UM_TRY(UM_PAGE_ROOM(w->p, n, &unit));
  for (int i = 0; i < COLUMNS; i++) UM_TRY(UM_PAGE_ROOM(w->p, n, &value[i]));
  for (size_t i = 0; i < n; i++) {
    const struct um_compare_metrics *m = &w->c->channel[i].all;
    bool magnitude = um_compare_is_magnitude(channel_of(w, i)->quantity);
    char *words;
    UM_TRY(UM_PAGE_ROOM(w->p, 200, &words));
    um_compare_channel_words(channel_of(w, i), words, 200);
    name[i] = words;
    unit[i] = magnitude ? "mag" : um_compare_residual_unit(channel_of(w, i)->quantity);
    value[OBSERVATIONS][i] = (double)m->count;
    value[BIAS][i] = magnitude ? m->bias_mag : m->bias;
    value[RMS][i] = magnitude ? m->rms_mag : m->rms;
    value[SHARE][i] = 100.0 * m->rms_over_mean;
    value[CHI2][i] = m->chi2_reduced;
    value[WHITE][i] = m->durbin_watson;
  }
  const struct um_page_column columns[] = {
      {.name = "channel", .text = name},
      {.name = "observations", .value = value[OBSERVATIONS]},
      {.name = "mean of measured \xe2\x88\x92 model", .value = value[BIAS]},
      {.name = "root mean square", .value = value[RMS]},
      {.name = "unit", .text = unit},
      {.name = "root mean square of the mean", .unit = "%", .value = value[SHARE]},
      {.name = "chi-square per degree of freedom", .value = value[CHI2]},
      {.name = "Durbin-Watson (2: white)", .value = value[WHITE]}};
  um_page_table(w->page, &figure, columns, sizeof columns / sizeof columns[0], n);
  return UM_OK;
}

static enum um_status how_far(struct work *w)
{
  const struct um_compare_comparison *c = w->c;
  bool good = c->chi2_reduced < 1.5;
  um_page_section(w->page, "fit", "How far off is the model?",
                  isnan(c->chi2_reduced) ? UM_PAGE_PLAIN
                  : good                 ? UM_PAGE_GOOD
                                         : UM_PAGE_WARNING);
  um_compare_page_put_chi2(w->page, "All channels", c->chi2, c->dof);
  for (size_t i = 0; i < c->nchannel; i++)
    UM_TRY(um_compare_page_put_channel(w->p, &w->channel[i], i));
  return table_metrics(w);
}

/* The largest share of an interval, and of what unit it is. */
static const struct um_compare_share *largest(const struct um_compare_share *share, size_t n)
{
  const struct um_compare_share *most = NULL;
  for (size_t i = 0; i < n; i++)
    if (most == NULL || fabs(share[i].value) > fabs(most->value)) most = &share[i];
  return most;
}

static enum um_status where(struct work *w)
{
  static const struct um_page_figure figure = {.id = "worst", .title = "Worst intervals"};
  size_t n = 0, most = w->c->nchannel * UM_COMPARE_WORST;
  enum { CHANNEL, FROM, TO, MECHANISM, MATERIAL, TEXTS };
  const char **text[TEXTS];
  double *bias, *chi2;
  for (int i = 0; i < TEXTS; i++) UM_TRY(UM_PAGE_ROOM(w->p, most, &text[i]));
  UM_TRY(UM_PAGE_ROOM(w->p, most, &bias));
  UM_TRY(UM_PAGE_ROOM(w->p, most, &chi2));
  for (size_t i = 0; i < w->c->nchannel; i++)
    for (size_t k = 0; k < w->c->channel[i].nworst; k++) {
      const struct um_compare_interval *worst = &w->c->channel[i].worst[k];
      const struct um_compare_share *by = largest(worst->mechanism, worst->nmechanism);
      const struct um_compare_share *of = largest(worst->material, worst->nmaterial);
      char *words, *times;
      UM_TRY(UM_PAGE_ROOM(w->p, 200, &words));
      UM_TRY(UM_PAGE_ROOM(w->p, 80, &times));
      um_compare_channel_words(channel_of(w, i), words, 200);
      um_compare_time_text(worst->from, times);
      um_compare_time_text(worst->to, times + 40);
      text[CHANNEL][n] = words;
      text[FROM][n] = times;
      text[TO][n] = times + 40;
      text[MECHANISM][n] = by != NULL ? by->name : "";
      text[MATERIAL][n] = of != NULL ? of->name : "";
      bias[n] = worst->bias;
      chi2[n++] = worst->chi2;
    }
  const struct um_page_column columns[] = {
      {.name = "channel", .text = text[CHANNEL]},
      {.name = "from", .unit = "UTC", .text = text[FROM]},
      {.name = "to", .unit = "UTC", .text = text[TO]},
      {.name = "mean of measured \xe2\x88\x92 model, linear", .value = bias},
      {.name = "chi-square", .value = chi2},
      {.name = "most of the model is", .text = text[MECHANISM]},
      {.name = "from", .text = text[MATERIAL]}};
  if (n == 0) return UM_OK;
  um_page_section(w->page, "where", "When does it fail most?", UM_PAGE_PLAIN);
  um_page_table(w->page, &figure, columns, sizeof columns / sizeof columns[0], n);
  return UM_OK;
}

/* Is it shown: what a reader asks first, and what the residual of some channel goes with? */
static bool is_shown(const struct um_compare_comparison *c,
                     const struct um_compare_coordinate *coordinate)
{
  static const char *const asked[] = {"phase_angle_deg", "airmass", "spin_phase"};
  for (size_t i = 0; i < sizeof asked / sizeof asked[0]; i++)
    if (strcmp(coordinate->name, asked[i]) == 0) return true;
  for (size_t i = 0; i < c->nchannel; i++)
    for (size_t k = 0; k < c->channel[i].ncorrelation; k++)
      if (c->channel[i].correlation[k].p < STRONG &&
          strcmp(c->channel[i].correlation[k].name, coordinate->name) == 0)
        return true;
  return false;
}

static bool varies(const double *value, size_t n)
{
  double least = INFINITY, most = -INFINITY;
  for (size_t k = 0; k < n; k++) {
    if (!isfinite(value[k])) continue;
    least = fmin(least, value[k]);
    most = fmax(most, value[k]);
  }
  return most > least;
}

/* Residuals of all channels against one coordinate. */
static enum um_status against(struct work *w, const struct um_compare_coordinate *coordinate)
{
  const struct um_compare_comparison *c = w->c;
  struct um_page_series *series;
  struct um_page_panel *panel;
  const char *id;
  UM_TRY(UM_PAGE_ROOM(w->p, c->nchannel, &series));
  UM_TRY(UM_PAGE_ROOM(w->p, c->nchannel, &panel));
  UM_TRY(um_page_words(w->p, &id, "against-%s", coordinate->name));
  for (size_t i = 0; i < c->nchannel; i++) {
    const struct um_compare_page_channel *channel = &w->channel[i];
    double *x;
    char *words;
    UM_TRY(UM_PAGE_ROOM(w->p, channel->count, &x));
    UM_TRY(UM_PAGE_ROOM(w->p, 200, &words));
    for (size_t k = 0; k < channel->count; k++)
      x[k] = coordinate->value[c->run.plan->observation[c->channel[i].row[k]]];
    um_compare_channel_words(channel->channel, words, 200);
    series[i] = (struct um_page_series){.name = "measured \xe2\x88\x92 model",
                                        .role = "model",
                                        .mark = UM_PAGE_POINTS,
                                        .value = channel->model[0].residual,
                                        .x = x,
                                        .count = channel->count};
    panel[i] = (struct um_page_panel){
        .name = words,
        .unit = channel->weighted ? "sigma" : um_compare_residual_unit(channel->channel->quantity),
        .zero = true,
        .series = &series[i],
        .nseries = 1};
  }
  const struct um_page_axis x = {coordinate->name, "1", UM_PAGE_LINEAR, coordinate->value,
                                 c->coordinates->nobs};
  const struct um_page_figure figure = {.id = id, .title = coordinate->name};
  um_page_axes(w->page, &figure, &x, NULL, 0, panel, c->nchannel);
  return UM_OK;
}

static enum um_status goes_with(struct work *w)
{
  const struct um_compare_coordinates *all = w->c->coordinates;
  um_page_section(w->page, "against", "What does the residual go with?", UM_PAGE_PLAIN);
  um_page_text(w->page, "A residual that follows a coordinate says where the model is wrong.");
  for (size_t i = 0; i < all->count; i++)
    if (is_shown(w->c, &all->coordinate[i]) && varies(all->coordinate[i].value, all->nobs))
      UM_TRY(against(w, &all->coordinate[i]));
  return UM_OK;
}

static enum um_status fill(struct um_page_writer *p, const void *of)
{
  const struct um_compare_comparison *c = of;
  struct work whole = {.p = p, .page = p->page, .c = c}, *w = &whole;
  const struct um_model_tables *tables = c->run.tables;
  double first = INFINITY, last = -INFINITY;
  size_t count = 0;
  for (size_t k = 0; k < tables->nobs; k++) {
    first = fmin(first, tables->t_obs[k]);
    last = fmax(last, tables->t_obs[k]);
  }
  UM_TRY(um_compare_page_shade(p, c->run.model, first, last));
  UM_TRY(UM_PAGE_ROOM(w->p, c->nchannel, &w->channel));
  for (size_t i = 0; i < c->nchannel; i++) {
    UM_TRY(read_channel(w, i));
    count += c->channel[i].count;
  }
  if (isnan(c->chi2_reduced))
    um_page_lead(w->page, "The model beside %zu observations, which have no stated errors.", count);
  else
    um_page_lead(
        w->page,
        "The model leaves %.4g times the chi-square of noise alone, over %zu observations.",
        c->chi2_reduced, count);
  um_page_fact(w->page, "scenario", "%s", c->run.model->scenario->name);
  um_page_fact(w->page, "measurements", "%s", c->run.plan->measurements->path);
  UM_TRY(how_far(w));
  UM_TRY(where(w));
  return goes_with(w);
}

enum um_status um_compare_write_page(struct um_context *context,
                                     const struct um_compare_comparison *comparison,
                                     const char *command, struct um_core_folder *folder)
{
  const struct um_page_head head = {.command = command,
                                    .kind = "comparison",
                                    .title = comparison->run.model->scenario->name,
                                    .about = " beside measurements"};
  return um_page_report(context, &head, fill, comparison, folder);
}
