/* With v = F^-1 r of a channel of n rows, q = U'v along the eigenvectors of K = U L U', b the ratio
 * and s the scale,
 *
 *   -2 ln likelihood = (|v|^2 - |q|^2 + sum q_k^2 / (1 + b^2 l_k)) / s^2
 *                      + n ln s^2 + sum ln(1 + b^2 l_k) + ln det F^2   (+ constant),
 *
 * of which s has its largest likelihood in closed form and b is searched. A row is foretold by all
 * others of its channel (Rasmussen & Williams 2006, Gaussian Processes, eq. 5.12):
 *
 *   z_j = (C^-1 v)_j / sqrt((C^-1)_jj). */
#include "base/inference/noise.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "base/inference/policy.h"

typedef struct um_inference_correlation_part part;

/* --- one channel of one kind ------------------------------------------------------------------ */

struct channel {
  const part *part;
  const double *v;     /* [nrow] */
  const double *q;     /* [rank] */
  double square, rest; /* |v|^2, |v|^2 - |q|^2 */
  double usual;        /* rms of a discrepancy; INFINITY: any */
};

/* -2 ln likelihood at b, with the best scale of `least` or more, and what the size of the
 * discrepancy that is expected, sum (b^2 l_k / (1 + b^2 l_k) q_k)^2 / n, costs. */
static double likelihood(const struct channel *c, double least, double b, double *scale)
{
  double n = (double)c->part->nrow, quadratic = c->rest, determinant = 0.0, size = 0.0;
  for (size_t k = 0; k < c->part->rank; k++) {
    double more = b * b * c->part->value[k];
    quadratic += c->q[k] * c->q[k] / (1.0 + more);
    size += pow(more / (1.0 + more) * c->q[k], 2) / n;
    determinant += log1p(more);
  }
  *scale = fmax(least, sqrt(quadratic / n));
  return quadratic / (*scale * *scale) + 2.0 * n * log(*scale) + determinant +
         size / (c->usual * c->usual);
}

/* The best ratio: a grid in its logarithm, then thirds of the interval about its best. */
static double best_ratio(const struct channel *c, double least, double *value, double *scale)
{
  enum { STEPS = 40, THIRDS = 20 };
  double low = log(UM_INFERENCE_RATIO_LEAST), high = log(UM_INFERENCE_RATIO_MOST);
  double step = (high - low) / STEPS, best = low, s;
  *value = INFINITY;
  for (int i = 0; i <= STEPS; i++) {
    double now = likelihood(c, least, exp(low + i * step), &s);
    if (!(now < *value)) continue;
    *value = now;
    best = low + i * step;
  }
  double from = fmax(low, best - step), to = fmin(high, best + step);
  for (int i = 0; i < THIRDS; i++) {
    double a = from + (to - from) / 3.0, b = to - (to - from) / 3.0;
    if (likelihood(c, least, exp(a), &s) < likelihood(c, least, exp(b), &s))
      to = b;
    else
      from = a;
  }
  *value = likelihood(c, least, exp(0.5 * (from + to)), scale);
  return exp(0.5 * (from + to));
}

/* --- a noise --------------------------------------------------------------------------------- */

static enum um_status begin(struct um_context *context,
                            const struct um_inference_noise_family *family,
                            const struct um_inference_noise *from, struct um_inference_noise *out)
{
  size_t n = family->nobservation;
  *out = (struct um_inference_noise){.family = family};
  UM_TRY(um_core_allocate(context, family->nchannel, sizeof *out->channel, &out->channel));
  UM_TRY(um_core_allocate(context, n, sizeof *out->factor, &out->factor));
  UM_TRY(um_core_allocate(context, n, sizeof *out->work, &out->work));
  for (size_t c = 0; c < family->nchannel; c++) out->channel[c].scale = 1.0;
  for (size_t j = 0; j < n; j++) out->factor[j] = from == NULL ? 1.0 : from->factor[j];
  out->noutlier = from == NULL ? 0 : from->noutlier;
  return UM_OK;
}

void um_inference_noise_release(struct um_context *context, struct um_inference_noise *noise)
{
  UM_FREE(context, noise->channel, noise->factor, noise->work);
  *noise = (struct um_inference_noise){0};
}

static const part *part_of(const struct um_inference_noise_family *family, size_t kind, size_t c)
{
  return &family->kind[kind]->part[c];
}

/* Rows of a channel of v [nobservation] over their factors: out [nrow]. */
static void gather(const struct um_inference_noise *noise, const part *p, const double *v,
                   double *out)
{
  for (size_t i = 0; i < p->nrow; i++) out[i] = v[p->row[i]] / noise->factor[p->row[i]];
}

/* -2 ln likelihood of white noise with the best scale of `least` or more. */
static double white_likelihood(const struct channel *c, double least, double *scale)
{
  double n = (double)c->part->nrow;
  *scale = fmax(least, sqrt(c->square / n));
  return c->square / (*scale * *scale) + 2.0 * n * log(*scale);
}

/* The best of no, any one kind of discrepancy, for a channel; returns what it is worth. A
 * discrepancy beside less noise than is stated must be worth more than less noise alone. */
static double estimate_channel(struct um_inference_noise *noise, size_t c, const double *residual,
                               double *v, double *q)
{
  const struct um_inference_noise_family *f = noise->family;
  struct um_inference_noise_channel *out = &noise->channel[c];
  double cost = log((double)f->nobservation), least = 0.0, white = 0.0;
  *out = (struct um_inference_noise_channel){.scale = 1.0};
  for (size_t k = 0; k < f->nkind; k++) {
    const part *p = part_of(f, k, c);
    if (p->nrow == 0) return 0.0;
    gather(noise, p, residual, v);
    struct channel channel = {
        .part = p, .v = v, .q = q, .usual = f->usual == NULL ? INFINITY : f->usual[c]};
    channel.square = channel.rest = um_inference_dot(p->nrow, v, v);
    for (size_t i = 0; i < p->rank; i++) {
      q[i] = um_inference_dot(p->nrow, p->basis + i * p->nrow, v);
      channel.rest -= q[i] * q[i];
    }
    channel.rest = fmax(0.0, channel.rest);
    double value, scale;
    if (k == 0) {
      white = cost + white_likelihood(&channel, UM_INFERENCE_SCALE_LEAST, &scale);
      value = cost + white_likelihood(&channel, 1.0, &scale);
      least = fmin(value, channel.square);
      out->scale = value < channel.square ? scale : 1.0;
    }
    static const double scales[] = {1.0, UM_INFERENCE_SCALE_LEAST};
    for (size_t i = 0; i < sizeof scales / sizeof *scales; i++) {
      double ratio = best_ratio(&channel, scales[i], &value, &scale);
      value += scale != 1.0 ? 2.0 * cost : cost;
      if (!(value < least) || (scale < 1.0 && !(value < white))) continue;
      least = value;
      *out = (struct um_inference_noise_channel){scale, ratio, k};
    }
  }
  return least;
}

static void estimate_all(struct um_inference_noise *noise, const double *residual, double *v,
                         double *q)
{
  noise->worth = 0.0;
  for (size_t c = 0; c < noise->family->nchannel; c++)
    noise->worth += estimate_channel(noise, c, residual, v, q);
  for (size_t j = 0; j < noise->family->nobservation; j++)
    if (noise->factor[j] > 1.0)
      noise->worth += 2.0 * log(noise->factor[j]) - 2.0 * log(UM_INFERENCE_OUTLIERS);
}

/* --- outliers -------------------------------------------------------------------------------- */

static int ascending(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Residual with each channel's rows cut at a few of its own scatters, the scatter by the median of
 * |r| (Rousseeuw & Croux 1993, JASA 88:1273). out, v: [nobservation] */
static void winsorise(const struct um_inference_noise_family *f, const double *residual, double *v,
                      double *out)
{
  memcpy(out, residual, f->nobservation * sizeof *out);
  for (size_t c = 0; c < f->nchannel; c++) {
    const part *p = part_of(f, 0, c);
    if (p->nrow == 0) continue;
    for (size_t i = 0; i < p->nrow; i++) v[i] = fabs(residual[p->row[i]]);
    qsort(v, p->nrow, sizeof *v, ascending);
    double most = UM_INFERENCE_WINSOR * fmax(1.0, 1.4826 * v[p->nrow / 2]);
    for (size_t i = 0; i < p->nrow; i++)
      out[p->row[i]] = fmax(-most, fmin(most, residual[p->row[i]]));
  }
}

/* z [nrow] of the rows of a channel, each foretold by the others. */
static void foretell(const struct um_inference_noise *noise, size_t c, const double *residual,
                     double *z)
{
  const struct um_inference_noise_channel *of = &noise->channel[c];
  const part *p = part_of(noise->family, of->kind, c);
  double b2 = of->ratio * of->ratio;
  gather(noise, p, residual, z);
  double *own = noise->work; /* (C^-1)_jj */
  for (size_t i = 0; i < p->nrow; i++) own[i] = 1.0;
  if (b2 > 0.0) {
    for (size_t k = 0; k < p->rank; k++)
      for (size_t i = 0; i < p->nrow; i++)
        own[i] -= p->basis[k * p->nrow + i] * p->basis[k * p->nrow + i] * b2 * p->value[k] /
                  (1.0 + b2 * p->value[k]);
    for (size_t k = 0; k < p->rank; k++) {
      const double *u = p->basis + k * p->nrow;
      double q = um_inference_dot(p->nrow, u, z),
             share = b2 * p->value[k] / (1.0 + b2 * p->value[k]);
      for (size_t i = 0; i < p->nrow; i++) z[i] -= share * q * u[i];
    }
  }
  for (size_t i = 0; i < p->nrow; i++) z[i] /= fmax(1.0, of->scale) * sqrt(fmax(1e-12, own[i]));
}

/* Whether row i of a channel stands out, alone or with one neighbour: three to one side are no
 * spikes but something that the model misses. */
static bool is_alone(const double *z, size_t n, size_t i)
{
  double side = z[i] > 0.0 ? 1.0 : -1.0;
  size_t run = 1;
  if (!(side * z[i] > UM_INFERENCE_OUTLIER)) return false;
  for (size_t j = i; j > 0 && side * z[j - 1] > UM_INFERENCE_OUTLIER; j--) run++;
  for (size_t j = i + 1; j < n && side * z[j] > UM_INFERENCE_OUTLIER; j++) run++;
  return run <= 2;
}

/* Rows that stand out are set aside, with those that were before. */
static void set_aside(struct um_inference_noise *noise, const double *residual, double *z)
{
  noise->noutlier = 0;
  for (size_t c = 0; c < noise->family->nchannel; c++) {
    const part *p = part_of(noise->family, 0, c);
    size_t n = 0;
    if (p->nrow == 0) continue;
    foretell(noise, c, residual, z);
    for (size_t i = 0; i < p->nrow; i++) {
      double *factor = &noise->factor[p->row[i]];
      if (is_alone(z, p->nrow, i)) *factor = fmax(*factor, fabs(z[i]));
      n += *factor > 1.0;
    }
    if ((double)n > UM_INFERENCE_OUTLIERS_MOST * (double)p->nrow)
      for (size_t i = 0; i < p->nrow; i++) noise->factor[p->row[i]] = 1.0;
    else
      noise->noutlier += n;
  }
}

static enum um_status look_for_outliers(struct um_context *context,
                                        struct um_inference_noise *noise, const double *residual,
                                        double *v, double *q)
{
  enum um_status status;
  size_t n = noise->family->nobservation;
  struct um_inference_noise trial = {0};
  double *cut = NULL;
  UM_CHECK(begin(context, noise->family, NULL, &trial));
  UM_CHECK(um_core_allocate(context, n, sizeof *cut, &cut));
  winsorise(noise->family, residual, v, cut);
  estimate_all(&trial, cut, v, q);
  for (size_t before = 0, look = 0; look < UM_INFERENCE_LOOKS; look++) {
    set_aside(&trial, residual, v);
    if (trial.noutlier == before) break;
    before = trial.noutlier;
    estimate_all(&trial, residual, v, q);
  }
  if (trial.noutlier > 0 && trial.worth < noise->worth) {
    struct um_inference_noise other = *noise;
    *noise = trial;
    trial = other;
  }
done:
  um_core_free(context, cut);
  um_inference_noise_release(context, &trial);
  return status;
}

enum um_status um_inference_noise_estimate(struct um_context *context,
                                           const struct um_inference_noise_family *family,
                                           const double *residual,
                                           const struct um_inference_noise *from,
                                           struct um_inference_noise *out)
{
  enum um_status status;
  double *v = NULL, *q = NULL;
  UM_CHECK(begin(context, family, from, out));
  UM_CHECK(um_core_allocate(context, family->nobservation, sizeof *v, &v));
  UM_CHECK(um_core_allocate(context, family->nobservation, sizeof *q, &q));
  estimate_all(out, residual, v, q);
  if (from == NULL) UM_CHECK(look_for_outliers(context, out, residual, v, q));
done:
  UM_FREE(context, v, q);
  if (status != UM_OK) um_inference_noise_release(context, out);
  return status;
}

/* --- roots ----------------------------------------------------------------------------------- */

bool um_inference_noise_is_white(const struct um_inference_noise *noise)
{
  for (size_t c = 0; c < noise->family->nchannel; c++)
    if (noise->channel[c].scale > 1.0 || noise->channel[c].ratio > 0.0) return false;
  return noise->noutlier == 0;
}

/* v <- U diag(g(b^2 l)) U'v + what is left of v, in a channel; g - 1 by `power` of 1 + b^2 l. */
static void along(const struct um_inference_noise *noise, size_t c, double power, double *v)
{
  const struct um_inference_noise_channel *of = &noise->channel[c];
  const part *p = part_of(noise->family, of->kind, c);
  double *before = noise->work;
  if (!(of->ratio > 0.0)) return;
  for (size_t i = 0; i < p->nrow; i++) before[i] = v[p->row[i]];
  for (size_t k = 0; k < p->rank; k++) {
    const double *u = p->basis + k * p->nrow;
    double q = um_inference_dot(p->nrow, u, before);
    double g = pow(1.0 + of->ratio * of->ratio * p->value[k], power) - 1.0;
    for (size_t i = 0; i < p->nrow; i++) v[p->row[i]] += g * q * u[i];
  }
}

void um_inference_noise_whiten(struct um_inference_noise *noise, double *v)
{
  if (noise == NULL) return;
  const struct um_inference_noise_family *f = noise->family;
  for (size_t j = 0; j < f->nobservation; j++)
    v[j] /= noise->factor[j] * noise->channel[f->channel[j]].scale;
  for (size_t c = 0; c < f->nchannel; c++) along(noise, c, -0.5, v);
}

void um_inference_noise_colour(struct um_inference_noise *noise, double *v)
{
  if (noise == NULL) return;
  const struct um_inference_noise_family *f = noise->family;
  for (size_t c = 0; c < f->nchannel; c++) along(noise, c, 0.5, v);
  for (size_t j = 0; j < f->nobservation; j++)
    v[j] *= noise->factor[j] * noise->channel[f->channel[j]].scale;
}

void um_inference_noise_discrepancy(struct um_inference_noise *noise, const double *residual,
                                    double *out)
{
  const struct um_inference_noise_family *f = noise->family;
  for (size_t j = 0; j < f->nobservation; j++) out[j] = residual[j] / noise->factor[j];
  for (size_t c = 0; c < f->nchannel; c++) along(noise, c, -1.0, out);
  for (size_t j = 0; j < f->nobservation; j++) out[j] = residual[j] / noise->factor[j] - out[j];
}
