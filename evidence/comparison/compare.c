/* Metrics, residuals and correlations of every channel. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "evidence/comparison/compare.h"
#include "evidence/comparison/correlation_impl.h"
#include "evidence/comparison/intervals_impl.h"
#include "evidence/comparison/series.h"

static enum um_status find_residuals(struct um_context *context, struct um_compare_comparison *c)
{
  const struct um_compare_measurements *m = c->run.plan->measurements;
  double *model_sigma = NULL;
  enum um_status status;
  UM_CHECK(um_core_allocate(context, m->count, sizeof *c->model, &c->model));
  UM_CHECK(um_core_allocate(context, m->count, sizeof *c->residual, &c->residual));
  UM_CHECK(um_core_allocate(context, m->count, sizeof *model_sigma, &model_sigma));
  um_compare_predict_error(c->run.plan, c->run.result, model_sigma);
  UM_CHECK(um_compare_predict(context, c->run.plan, c->run.tables, c->run.result, c->model));
  for (size_t i = 0; i < m->count; i++)
    c->residual[i] = um_compare_residual_make(m, i, c->model[i], model_sigma[i]);
done:
  um_core_free(context, model_sigma);
  return status;
}

/* Residuals of one channel in order of time, and the labels of its observations. */
struct gathered {
  struct um_compare_residual *residual; /* [count] */
  size_t *light, *motion;               /* [count] */
};

static enum um_status gather(struct um_context *context, const struct um_compare_comparison *c,
                             const struct um_compare_channel_comparison *channel,
                             struct gathered *g)
{
  UM_TRY(um_core_allocate(context, channel->count, sizeof *g->residual, &g->residual));
  UM_TRY(um_core_allocate(context, 2 * channel->count, sizeof *g->light, &g->light));
  g->motion = g->light + channel->count;
  for (size_t i = 0; i < channel->count; i++) {
    size_t row = channel->row[i], k = c->run.plan->observation[row];
    g->residual[i] = c->residual[row];
    g->light[i] = (size_t)c->light[k];
    g->motion[i] = UM_COMPARE_LABEL_NONE;
    if (c->motion[k] != UM_SEGMENT_COUNT) g->motion[i] = (size_t)(c->motion[k] - UM_SEGMENT_RISING);
  }
  return UM_OK;
}

static enum um_status channel_metrics(struct um_context *context,
                                      const struct um_compare_comparison *c, double fitted,
                                      struct um_compare_channel_comparison *channel)
{
  struct gathered g = {0};
  enum um_compare_quantity quantity = c->run.plan->measurements->channel[channel->channel].quantity;
  enum um_status status;
  UM_CHECK(gather(context, c, channel, &g));
  UM_CHECK(um_compare_metrics_compute(context, quantity, channel->count, g.residual, g.light,
                                      UM_SEGMENT_RISING, fitted, channel->segment, &channel->all));
  /* the parameters' share of rising and setting is that of all observations, as for light */
  UM_CHECK(um_compare_metrics_compute(context, quantity, channel->count, g.residual, g.motion,
                                      UM_SEGMENT_COUNT - UM_SEGMENT_RISING, fitted,
                                      channel->segment + UM_SEGMENT_RISING, NULL));
done:
  if (status != UM_OK)
    um_core_message_prefix(context, "%s: %s '%s'", c->run.plan->measurements->path,
                           um_compare_quantity_name(quantity),
                           c->run.plan->measurements->channel[channel->channel].label);
  UM_FREE(context, g.residual, g.light);
  return status;
}

/* --- correlations ---------------------------------------------------------------------------- */

static int by_p(const void *a, const void *b)
{
  const struct um_compare_correlation *x = a, *y = b;
  bool known_x = !isnan(x->p), known_y = !isnan(y->p);
  if (known_x != known_y) return known_x ? -1 : 1;
  if (known_x && x->p != y->p) return x->p < y->p ? -1 : 1;
  if (known_x && fabs(x->value) != fabs(y->value)) return fabs(x->value) > fabs(y->value) ? -1 : 1;
  return strcmp(x->name, y->name);
}

/* One coordinate; x of observation k. NULL: the model's own value. */
static enum um_status correlate(struct um_context *context, const struct um_compare_comparison *c,
                                const struct um_compare_channel_comparison *channel,
                                const struct um_compare_coordinate *coordinate, double *pairs,
                                struct um_compare_correlation *out)
{
  double *x = pairs, *y = pairs + channel->count;
  size_t n = 0;
  for (size_t i = 0; i < channel->count; i++) {
    size_t row = channel->row[i], k = c->run.plan->observation[row];
    x[n] = coordinate == NULL ? c->model[row] : coordinate->value[k];
    y[n] = um_compare_residual_normalised(&c->residual[row]);
    if (!isnan(x[n])) n++;
  }
  out->name = coordinate == NULL ? "model" : coordinate->name;
  out->count = n;
  return coordinate != NULL && coordinate->circular
             ? um_compare_circular(context, n, x, y, &out->value, &out->p)
             : um_compare_spearman(context, n, x, y, &out->value, &out->p);
}

static enum um_status channel_correlations(struct um_context *context,
                                           const struct um_compare_comparison *c,
                                           struct um_compare_channel_comparison *channel)
{
  const struct um_compare_coordinates *coordinates = c->coordinates;
  double *pairs = NULL;
  enum um_status status;
  UM_TRY(um_core_allocate(context, coordinates->count + 1, sizeof *channel->correlation,
                          &channel->correlation));
  UM_TRY(um_core_allocate(context, 2 * channel->count, sizeof *pairs, &pairs));
  for (size_t j = 0; j <= coordinates->count; j++)
    UM_CHECK(correlate(context, c, channel,
                       j < coordinates->count ? &coordinates->coordinate[j] : NULL, pairs,
                       &channel->correlation[channel->ncorrelation++]));
  qsort(channel->correlation, channel->ncorrelation, sizeof *channel->correlation, by_p);
  status = UM_OK;
done:
  um_core_free(context, pairs);
  return status;
}

/* --- channels -------------------------------------------------------------------------------- */

static enum um_status make_channel(struct um_context *context,
                                   const struct um_compare_comparison *c, size_t which,
                                   double fitted, struct um_compare_channel_comparison *channel)
{
  const struct um_compare_measurements *m = c->run.plan->measurements;
  struct um_compare_series *series = NULL;
  UM_TRY(um_compare_series_create(context, m, which, SIZE_MAX, &series));
  channel->channel = which;
  channel->count = series->count;
  channel->left_out = m->channel[which].count - series->count;
  channel->row = series->row;
  series->row = NULL; /* taken over */
  um_compare_series_destroy(context, &series);
  UM_TRY(channel_metrics(context, c, fitted, channel));
  UM_TRY(um_compare_intervals_find(context, c, channel));
  return channel_correlations(context, c, channel);
}

static enum um_status make_channels(struct um_context *context, struct um_compare_comparison *c,
                                    double fitted)
{
  const struct um_compare_measurements *m = c->run.plan->measurements;
  size_t weighted = 0; /* observations in use that have a sigma */
  UM_TRY(um_core_allocate(context, m->nchannel, sizeof *c->channel, &c->channel));
  for (size_t i = 0; i < m->count; i++)
    if (c->run.plan->observation[i] != UM_COMPARE_NOWHERE && !isnan(m->row[i].sigma)) weighted++;
  for (size_t i = 0; i < m->nchannel; i++) {
    if (c->run.plan->source[i] == UM_COMPARE_NOWHERE) continue;
    size_t own = 0;
    for (size_t r = 0; r < m->count; r++)
      if (m->row[r].channel == i && m->row[r].flag == 0 && !isnan(m->row[r].sigma)) own++;
    double share = weighted == 0 ? 0.0 : fitted * (double)own / (double)weighted;
    UM_TRY(make_channel(context, c, i, share, &c->channel[c->nchannel++]));
  }
  c->chi2 = c->dof = c->chi2_reduced = c->model_share = NAN;
  if (weighted == 0) return UM_OK;
  c->chi2 = c->model_share = 0.0;
  for (size_t i = 0; i < c->nchannel; i++)
    if (!isnan(c->channel[i].all.chi2)) c->chi2 += c->channel[i].all.chi2;
  for (size_t i = 0; i < m->count; i++)
    if (c->run.plan->observation[i] != UM_COMPARE_NOWHERE && !isnan(c->residual[i].sigma))
      c->model_share +=
          um_compare_residual_share(c->residual[i].sigma, c->residual[i].model_sigma) /
          (double)weighted;
  c->dof = (double)weighted - fitted;
  if (c->dof > 0.0) c->chi2_reduced = c->chi2 / c->dof;
  return UM_OK;
}

enum um_status um_compare_create(struct um_context *context, const struct um_compare_run *run,
                                 double fitted, struct um_compare_comparison **out)
{
  struct um_compare_comparison *c = NULL;
  enum um_status status;
  size_t nobs = run->tables->nobs;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *c, &c));
  c->run = *run;
  c->samples = run->tables->sampling.samples;
  c->samples_before = run->model->scenario->optics->samples;
  UM_CHECK(find_residuals(context, c));
  UM_CHECK(um_core_allocate(context, nobs, sizeof *c->light, &c->light));
  UM_CHECK(um_core_allocate(context, nobs, sizeof *c->motion, &c->motion));
  UM_CHECK(um_compare_segments_find(context, run->model, run->tables, c->light, c->motion));
  UM_CHECK(um_compare_coordinates_create(context, run->model, run->tables, &c->coordinates));
  UM_CHECK(make_channels(context, c, fitted));
  *out = c;
  c = NULL;
done:
  um_compare_destroy(context, &c);
  return status;
}
