/* Points of a study against measurements. */
#include "study/measured.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/core/interpolation.h"
#include "base/uncertainty/statistics.h"
#include "evidence/comparison/metrics.h"
#include "evidence/measurements/measurements.h"

#define SIGMAS 2.0 /* that the study's largest error is taken to be */

/* Rows of a channel that are used, between which instants of the study they lie. */
struct channel {
  size_t quantity; /* of the result */
  enum um_compare_quantity of;
  size_t n, *before;                    /* [n] the instant at or before; the next follows it */
  double *part;                         /* [n] of the way to the next */
  struct um_compare_residual *residual; /* [n] of the point at hand */
  double error; /* sigma of the study: relative of light, else in its unit */
};

static const char *prefix(enum um_compare_quantity quantity)
{
  switch (quantity) {
  case UM_QUANTITY_BAND_IRRADIANCE:
    return "irradiance";
  case UM_QUANTITY_MAGNITUDE_AB:
    return "magnitude";
  case UM_QUANTITY_TEMPERATURE:
    return "temperature";
  default:
    return NULL;
  }
}

static enum um_status find(struct um_context *context, const struct um_study_result *r,
                           const struct um_compare_measurements *m, size_t c, size_t *out)
{
  const struct um_study_quantity *q;
  const struct um_compare_channel *channel = &m->channel[c];
  const char *kind = prefix(channel->quantity);
  char name[300];
  snprintf(name, sizeof name, "%s:%s", kind != NULL ? kind : "", channel->of);
  q = kind == NULL ? NULL : um_study_result_quantity(r, name);
  *out = q == NULL ? 0 : (size_t)(q - r->quantity);
  if (q != NULL && q->count == r->ntime) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s: %s of '%s' is measured, and the study has no such curve; name it in "
                      "outputs (band_irradiance, magnitude_ab and temperature can be compared)",
                      m->path, um_compare_quantity_name(channel->quantity), channel->of);
}

/* Place of a time among the study's; false: outside, or nothing is seen there. */
static bool between(const struct um_study_result *r, const struct um_study_quantity *q, double t,
                    size_t *before, double *part)
{
  if (r->ntime < 2 || !(t >= r->time[0] && t <= r->time[r->ntime - 1])) return false;
  size_t k = um_core_interval_find(r->time, r->ntime, t);
  *before = k;
  *part = (t - r->time[k]) / (r->time[k + 1] - r->time[k]);
  return !isnan(r->nominal[q->first + k]) && !isnan(r->nominal[q->first + k + 1]);
}

static void release(struct um_context *context, struct channel *c)
{
  UM_FREE(context, c->before, c->part, c->residual);
}

static enum um_status gather(struct um_context *context, const struct um_study_result *r,
                             const struct um_compare_measurements *m, size_t number,
                             struct channel *c)
{
  size_t n = m->channel[number].count;
  UM_TRY(find(context, r, m, number, &c->quantity));
  c->of = m->channel[number].quantity;
  double error = r->error[c->quantity];
  c->error = isfinite(error) ? error / SIGMAS : 0.0;
  UM_TRY(um_core_allocate(context, n, sizeof *c->before, &c->before));
  UM_TRY(um_core_allocate(context, n, sizeof *c->part, &c->part));
  UM_TRY(um_core_allocate(context, n, sizeof *c->residual, &c->residual));
  for (size_t i = 0; i < m->count; i++) {
    const struct um_compare_measurement *row = &m->row[i];
    if (row->channel != number || row->flag != 0 || isnan(row->sigma)) continue;
    if (!between(r, &r->quantity[c->quantity], row->t_tai, &c->before[c->n], &c->part[c->n]))
      continue;
    c->residual[c->n++] = um_compare_residual_make(m, i, NAN, 0.0);
  }
  return UM_OK;
}

/* A curve [ntime] at the channel's rows, between its instants linearly in flux. false: a value that
 * is none. */
static bool predict(struct channel *c, const double *curve, bool light)
{
  bool relative = light && !um_compare_is_magnitude(c->of);
  for (size_t i = 0; i < c->n; i++) {
    struct um_compare_linear a = um_compare_linear(c->of, curve[c->before[i]], c->error);
    struct um_compare_linear b = um_compare_linear(c->of, curve[c->before[i] + 1], c->error);
    struct um_compare_residual *r = &c->residual[i];
    r->model = a.value + c->part[i] * (b.value - a.value);
    r->model_sigma =
        relative ? c->error * fabs(r->model) : a.sigma + c->part[i] * (b.sigma - a.sigma);
    if (!isfinite(r->model)) return false;
  }
  return true;
}

static enum um_status describe(struct um_context *context, struct um_study_quantity *q,
                               const char *metric, const struct um_study_quantity *of,
                               const char *unit)
{
  UM_TRY(um_core_asprintf(context, &q->name, "%s:%s", metric, of->name));
  UM_TRY(um_core_strdup(context, unit, &q->unit));
  return um_core_strdup(context, of->of, &q->of);
}

/* Room for two metrics of each channel behind the values of every point. */
static enum um_status widen(struct um_context *context, struct um_study_result *r, size_t more)
{
  size_t old = r->nvalue, wide = old + more;
  double *value = NULL;
  UM_TRY(um_core_reallocate(context, wide, sizeof *r->nominal, &r->nominal));
  UM_TRY(um_core_reallocate(context, r->nquantity + more, sizeof *r->quantity, &r->quantity));
  UM_TRY(um_core_reallocate(context, r->nquantity + more, sizeof *r->error, &r->error));
  UM_TRY(um_core_allocate(context, r->npoint, wide * sizeof *value, &value));
  for (size_t k = old; k < wide; k++) r->nominal[k] = NAN;
  for (size_t p = 0; p < r->npoint; p++) {
    memcpy(value + p * wide, r->value + p * old, old * sizeof *value);
    for (size_t k = old; k < wide; k++) value[p * wide + k] = NAN;
  }
  um_core_free(context, r->value);
  r->value = value;
  r->nvalue = wide;
  return UM_OK;
}

/* chi2 and metrics of one set of curves [nvalue]; metrics behind them are filled in. */
static enum um_status hold(struct um_context *context, const struct um_study_result *r,
                           struct channel *c, size_t n, double *value, double *chi2)
{
  size_t first = r->nvalue - 2 * n;
  *chi2 = 0.0;
  for (size_t i = 0; i < n; i++) {
    struct um_compare_metrics metrics;
    if (c[i].n == 0) continue;
    const struct um_study_quantity *q = &r->quantity[c[i].quantity];
    if (!predict(&c[i], value + q->first, q->light)) {
      *chi2 = NAN;
      return UM_OK;
    }
    UM_TRY(um_compare_metrics_compute(context, c[i].of, c[i].n, c[i].residual, NULL, 0, 0.0, NULL,
                                      &metrics));
    value[first + 2 * i] = metrics.rms;
    value[first + 2 * i + 1] = metrics.chi2_reduced;
    *chi2 += metrics.chi2;
  }
  return UM_OK;
}

static enum um_status weigh(struct um_context *context, const struct um_study_result *r,
                            struct um_study_measured *m)
{
  enum um_status status;
  double *log_likelihood = NULL;
  UM_CHECK(um_core_allocate(context, r->npoint, sizeof *log_likelihood, &log_likelihood));
  m->best = SIZE_MAX;
  for (size_t p = 0; p < r->npoint; p++) {
    log_likelihood[p] = -0.5 * m->chi2[p];
    if (isnan(m->chi2[p])) continue;
    if (m->best == SIZE_MAX || m->chi2[p] < m->chi2[m->best]) m->best = p;
  }
  UM_CHECK(um_uncertainty_weights(context, r->npoint, log_likelihood, m->weight, &m->effective));
done:
  um_core_free(context, log_likelihood);
  return status;
}

/* The metrics of the channels as quantities of the result. */
static enum um_status add_quantities(struct um_context *context, struct um_study_result *r,
                                     const struct channel *c, size_t n)
{
  size_t first = r->nvalue;
  UM_TRY(widen(context, r, 2 * n));
  for (size_t i = 0; i < 2 * n; i++) {
    struct um_study_quantity *q = &r->quantity[r->nquantity];
    const struct um_study_quantity *of = &r->quantity[c[i / 2].quantity];
    bool flux = i % 2 == 0 && !um_compare_is_magnitude(c[i / 2].of);
    *q = (struct um_study_quantity){.first = first + i, .count = 1};
    r->error[r->nquantity++] = NAN;
    UM_TRY(describe(context, q, i % 2 == 0 ? "rms" : "chi2_reduced", of, flux ? of->unit : "1"));
  }
  return UM_OK;
}

static enum um_status check(struct um_context *context, const struct um_study_result *r,
                            const struct um_compare_measurements *m)
{
  if (r->design == UM_STUDY_ONE_AT_A_TIME || r->design == UM_STUDY_MORRIS)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: points one at a time or of Morris's design are no sample of the "
                        "parameters, and measurements cannot weigh them; take sobol or "
                        "latin_hypercube",
                        m->path);
  if (!m->independent || r->ntime > 1) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "%s: observations that stand alone", m->path);
}

static enum um_status fill(struct um_context *context, struct um_study_result *r,
                           const struct um_compare_measurements *m, struct channel *c,
                           struct um_study_measured *out)
{
  double unused;
  UM_TRY(check(context, r, m));
  for (size_t i = 0; i < m->nchannel; i++) {
    UM_TRY(gather(context, r, m, i, &c[i]));
    out->used += c[i].n;
  }
  out->left_out = m->count - out->used;
  if (out->used == 0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: no row has a sigma and lies where the study sees something", m->path);
  UM_TRY(um_core_allocate(context, r->npoint, sizeof *out->chi2, &out->chi2));
  UM_TRY(um_core_allocate(context, r->npoint, sizeof *out->weight, &out->weight));
  UM_TRY(add_quantities(context, r, c, m->nchannel));
  UM_TRY(hold(context, r, c, m->nchannel, r->nominal, &unused));
  for (size_t p = 0; p < r->npoint; p++) {
    out->chi2[p] = NAN;
    if (r->reason[p] == NULL)
      UM_TRY(hold(context, r, c, m->nchannel, r->value + p * r->nvalue, &out->chi2[p]));
  }
  return weigh(context, r, out);
}

enum um_status um_study_measured_create(struct um_context *context, struct um_study_result *result,
                                        const char *path, struct um_study_measured **out)
{
  enum um_status status;
  struct um_compare_measurements *m = NULL;
  struct um_study_measured *measured = NULL;
  struct channel *channel = NULL;
  size_t n = 0;
  *out = NULL;
  UM_CHECK(um_compare_measurements_read(context, path, &m));
  UM_CHECK(um_core_allocate(context, 1, sizeof *measured, &measured));
  UM_CHECK(um_core_allocate(context, m->nchannel, sizeof *channel, &channel));
  n = m->nchannel;
  UM_CHECK(fill(context, result, m, channel, measured));
  *out = measured;
  measured = NULL;
done:
  for (size_t i = 0; i < n; i++) release(context, &channel[i]);
  um_core_free(context, channel);
  um_study_measured_destroy(context, &measured);
  um_compare_measurements_destroy(context, &m);
  return status;
}

void um_study_measured_destroy(struct um_context *context, struct um_study_measured **measured)
{
  if (measured == NULL || *measured == NULL) return;
  UM_FREE(context, (*measured)->chi2, (*measured)->weight, *measured);
  *measured = NULL;
}
