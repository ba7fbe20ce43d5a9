/* Grey bodies behind the light of several bands: a scan over temperatures, at each of which the
 * areas are linear, then nonlinear least squares. */
#include "optics/instrument/grey_body.h"

#include <math.h>
#include <stdbool.h>

#include "base/core/planck.h"
#include "base/inference/fit.h"

#define COLDEST 40.0   /* [K] */
#define HOTTEST 1500.0 /* [K] */
#define STEPS   120    /* of the scan of one, in the logarithm */
#define COARSE  48     /* of two */
#define LEAST   0.05   /* of the area, that a component begins with */
#define RATIO   1.5    /* ln of the hotter temperature by the colder one, at most */
#define LOGIT   2.0    /* prior width: a share of 2 to 98 % */

#define TOUCH 1e-6 /* of a bin's width: edges nearer than this are one */

/* int T f d lambda over a band; bins that touch and let through the same are one. f: of an interval
 * of wavelengths [m] and a temperature. */
static double over_band(const struct um_instrument_bins *band, double temperature,
                        double (*f)(double from, double to, double temperature))
{
  double sum = 0.0;
  for (size_t i = 0, end; i < band->n; i = end) {
    double passed = band->transmission != NULL ? band->transmission[i] : 1.0;
    double from = band->wavelength[i] - 0.5 * band->width[i];
    double to = band->wavelength[i] + 0.5 * band->width[i];
    for (end = i + 1; end < band->n; end++) {
      double next = band->wavelength[end] - 0.5 * band->width[end];
      if (!(fabs(next - to) < TOUCH * band->width[i])) break;
      if (band->transmission != NULL && band->transmission[end] != passed) break;
      to = band->wavelength[end] + 0.5 * band->width[end];
    }
    if (passed != 0.0) sum += passed * f(from, to, temperature);
  }
  return sum;
}

/* int T B_lambda(T) d lambda over a band [W/m^2/sr] */
static double radiance(const struct um_instrument_bins *band, double temperature)
{
  return over_band(band, temperature, um_core_planck_band);
}

double um_instrument_grey_body_intensity(const struct um_instrument_grey_body *body,
                                         const struct um_instrument_bins *band)
{
  double sum = 0.0;
  for (size_t j = 0; j < body->n; j++) sum += body->area[j] * radiance(band, body->temperature[j]);
  return sum;
}

double um_instrument_grey_body_effective(const struct um_instrument_grey_body *body)
{
  double sum = 0.0, area = 0.0;
  for (size_t j = 0; j < body->n; j++) {
    sum += body->area[j] * body->temperature[j];
    area += body->area[j];
  }
  return sum / area;
}

/* With x = (ln T, ln A), J_b = I_b (d ln L_b/d ln T, 1) and weights 1/sigma^2,
 *   dx = (J^T W J)^-1 J^T W dI,  to first order in dI. */
void um_instrument_grey_body_error(const struct um_instrument_grey_body *body,
                                   const struct um_instrument_bins *band, const double *sigma,
                                   const double *error, size_t nband, double *temperature,
                                   double *area)
{
  double m00 = 0.0, m01 = 0.0, m11 = 0.0, t2 = 0.0, a2 = 0.0;
  double t = body->temperature[0], a = body->area[0];
  for (int pass = 0; pass < 2; pass++)
    for (size_t b = 0; b < nband; b++) {
      double j0 = a * t * over_band(&band[b], t, um_core_planck_band_slope) / sigma[b];
      double j1 = a * radiance(&band[b], t) / sigma[b], e = error[b] / sigma[b];
      double determinant = m00 * m11 - m01 * m01;
      if (pass == 0) {
        m00 += j0 * j0;
        m01 += j0 * j1;
        m11 += j1 * j1;
        continue;
      }
      t2 += pow((m11 * j0 - m01 * j1) / determinant * e, 2);
      a2 += pow((m00 * j1 - m01 * j0) / determinant * e, 2);
    }
  *temperature = t * sqrt(t2);
  *area = a * sqrt(a2);
}

bool um_instrument_grey_body_prefers_two(const struct um_instrument_grey_body *one,
                                         const struct um_instrument_grey_body *two)
{
  return one->n > 0 && two->n > 0 && two->bic < one->bic;
}

struct problem {
  const struct um_instrument_bins *band;
  const double *intensity, *sigma;
  size_t nband, n;
};

/* From the parameters of the fit: ln T and ln A of one; of two the logarithms of effective
 * temperature and whole area, d = ln(T_hot / T_cold) and the logit of the colder one's share f of
 * the area, T_eff = f T_cold + (1 - f) T_hot. */
static void body_of(const double *x, struct um_instrument_grey_body *body)
{
  double all = exp(x[1]);
  body->temperature[0] = exp(x[0]);
  body->area[0] = all;
  if (body->n == 1) return;
  double share = 1.0 / (1.0 + exp(-x[3])), ratio = exp(x[2]);
  body->temperature[0] /= share + (1.0 - share) * ratio;
  body->temperature[1] = body->temperature[0] * ratio;
  body->area[0] = share * all;
  body->area[1] = (1.0 - share) * all;
}

static enum um_status evaluate(struct um_context *context, void *user, const double *x,
                               double *value)
{
  const struct problem *p = user;
  struct um_instrument_grey_body body = {.n = p->n};
  (void)context;
  body_of(x, &body);
  for (size_t b = 0; b < p->nband; b++)
    value[b] = um_instrument_grey_body_intensity(&body, &p->band[b]);
  return UM_OK;
}

static double at_step(size_t i, size_t steps)
{
  return COLDEST * pow(HOTTEST / COLDEST, (double)i / (double)(steps - 1));
}

/* Areas of least squares at two temperatures, neither below 0, and chi-square; l[j][nband]. */
static double solve(const struct problem *p, const double *l0, const double *l1, double area[2])
{
  double m00 = 0.0, m01 = 0.0, m11 = 0.0, r0 = 0.0, r1 = 0.0, chi2 = 0.0;
  for (size_t b = 0; b < p->nband; b++) {
    double w = 1.0 / (p->sigma[b] * p->sigma[b]);
    m00 += w * l0[b] * l0[b];
    r0 += w * l0[b] * p->intensity[b];
    if (l1 == NULL) continue;
    m01 += w * l0[b] * l1[b];
    m11 += w * l1[b] * l1[b];
    r1 += w * l1[b] * p->intensity[b];
  }
  double determinant = m00 * m11 - m01 * m01;
  area[0] = fmax(r0 / m00, 0.0);
  area[1] = 0.0;
  if (l1 != NULL && determinant > 1e-12 * m00 * m11) {
    double a = (r0 * m11 - r1 * m01) / determinant, c = (r1 * m00 - r0 * m01) / determinant;
    if (a > 0.0 && c > 0.0) {
      area[0] = a;
      area[1] = c;
    } else if (a <= 0.0) { /* the other alone */
      area[0] = 0.0;
      area[1] = fmax(r1 / m11, 0.0);
    }
  }
  for (size_t b = 0; b < p->nband; b++) {
    double model = area[0] * l0[b] + (l1 != NULL ? area[1] * l1[b] : 0.0);
    chi2 += pow((p->intensity[b] - model) / p->sigma[b], 2);
  }
  return chi2;
}

/* Where the fit begins: the best of all temperatures of a grid. */
static enum um_status scan(struct um_context *context, const struct problem *p, double *x)
{
  size_t steps = p->n == 1 ? STEPS : COARSE, n = p->nband;
  double *table = NULL, lowest = INFINITY;
  UM_TRY(um_core_allocate(context, steps * n, sizeof *table, &table));
  for (size_t i = 0; i < steps; i++)
    for (size_t b = 0; b < n; b++) table[i * n + b] = radiance(&p->band[b], at_step(i, steps));
  for (size_t i = 0; i < steps; i++)
    for (size_t k = p->n == 1 ? i : i + 1; k < (p->n == 1 ? i + 1 : steps); k++) {
      double area[2], ratio = log(at_step(k, steps) / at_step(i, steps));
      if (ratio > RATIO) break; /* the fit would not begin there */
      double chi2 = solve(p, table + i * n, p->n == 1 ? NULL : table + k * n, area);
      if (!(chi2 < lowest) || !(area[0] + area[1] > 0.0)) continue;
      lowest = chi2;
      double all = area[0] + area[1], cold = at_step(i, steps), hot = at_step(k, steps);
      double share = fmin(fmax(area[0] / all, LEAST), 1.0 - LEAST);
      x[0] = log(share * cold + (1.0 - share) * hot);
      x[1] = log(all);
      x[2] = ratio;
      x[3] = log(share / (1.0 - share));
    }
  um_core_free(context, table);
  return UM_OK;
}

static enum um_status check(struct um_context *context, const struct problem *p)
{
  double most = 0.0;
  size_t least = 2 * p->n + 1;
  if (p->nband < least)
    return um_core_fail(context, UM_ERR_INPUT, "%zu thermal bands; accepted: %zu or more for %s",
                        p->nband, least, p->n == 1 ? "a temperature" : "two");
  for (size_t b = 0; b < p->nband; b++) {
    if (!(p->sigma[b] > 0.0) || !isfinite(p->sigma[b]) || !isfinite(p->intensity[b]))
      return um_core_fail(context, UM_ERR_INPUT,
                          "light %g with sigma %g; accepted: numbers, sigma above 0",
                          p->intensity[b], p->sigma[b]);
    most = fmax(most, p->intensity[b]);
  }
  if (most > 0.0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "no light in any band; accepted: some in one");
}

/* Variance of what moves by `move`[parameter] per unit of each parameter. */
static double variance(const struct um_inference_fit *fit, const double *move)
{
  double sum = 0.0;
  for (size_t i = 0; i < fit->nparameter; i++)
    for (size_t k = 0; k < fit->nparameter; k++)
      sum += move[i] * move[k] * fit->covariance[i * fit->nparameter + k];
  return sum;
}

/* Values, and sigmas by differences of what the parameters give. */
static void take(const struct um_inference_fit *fit, struct um_instrument_grey_body *out)
{
  struct um_instrument_grey_body moved = {.n = out->n};
  double t[2][4], a[2][4], x[4];
  body_of(fit->x, out);
  for (size_t k = 0; k < fit->nparameter; k++) {
    for (size_t i = 0; i < fit->nparameter; i++) x[i] = fit->x[i] + (i == k ? 1e-6 : 0.0);
    body_of(x, &moved);
    for (size_t j = 0; j < out->n; j++) {
      t[j][k] = (moved.temperature[j] - out->temperature[j]) / 1e-6;
      a[j][k] = (moved.area[j] - out->area[j]) / 1e-6;
    }
  }
  bool known = true; /* NaN at a bound, INFINITY where nothing tells */
  for (size_t k = 0; k < fit->nparameter; k++) known = known && isfinite(fit->sigma[k]);
  for (size_t j = 0; j < out->n; j++) {
    out->temperature_sigma[j] = known ? sqrt(variance(fit, t[j])) : INFINITY;
    out->area_sigma[j] = known ? sqrt(variance(fit, a[j])) : INFINITY;
  }
  out->chi2 = fit->chi2;
  out->bic = fit->bic;
}

enum um_status um_instrument_grey_body_fit(struct um_context *context,
                                           const struct um_instrument_bins *band,
                                           const double *intensity, const double *sigma,
                                           size_t nband, size_t n,
                                           struct um_instrument_grey_body *out)
{
  struct problem problem = {band, intensity, sigma, nband, n};
  struct um_inference_fit_parameter parameter[4];
  struct um_inference_fit *fit = NULL;
  double x[4] = {0.0, 0.0, 0.0, 0.0};
  *out = (struct um_instrument_grey_body){.n = n};
  UM_TRY(check(context, &problem));
  UM_TRY(scan(context, &problem, x));
  parameter[0] =
      (struct um_inference_fit_parameter){x[0], log(COLDEST), log(HOTTEST), 0.0, INFINITY, 1e-4};
  parameter[1] =
      (struct um_inference_fit_parameter){x[1], x[1] - 40.0, x[1] + 40.0, 0.0, INFINITY, 1e-3};
  parameter[2] = (struct um_inference_fit_parameter){x[2], 0.0, RATIO, 0.0, INFINITY, 1e-3};
  parameter[3] = (struct um_inference_fit_parameter){x[3], -6.0, 6.0, 0.0, LOGIT, 1e-2};
  struct um_inference_fit_problem fitted = {.nobservation = nband,
                                            .nparameter = 2 * n,
                                            .measured = intensity,
                                            .sigma = sigma,
                                            .parameter = parameter,
                                            .evaluate = evaluate,
                                            .user = &problem,
                                            .iterations_max = 100,
                                            .tolerance = 1e-8};
  UM_TRY(um_inference_fit_create(context, &fitted, &fit));
  take(fit, out);
  um_inference_fit_destroy(context, &fit);
  return UM_OK;
}

enum um_status um_instrument_grey_body_try(struct um_context *context,
                                           const struct um_instrument_bins *band,
                                           const double *intensity, const double *sigma,
                                           size_t nband, size_t n,
                                           struct um_instrument_grey_body *out)
{
  *out = (struct um_instrument_grey_body){0};
  if (nband < 2 * n + 1) return UM_OK;
  enum um_status status =
      um_instrument_grey_body_fit(context, band, intensity, sigma, nband, n, out);
  if (status != UM_ERR_INPUT && status != UM_ERR_NUMERIC) return status;
  um_core_message_clear(context);
  *out = (struct um_instrument_grey_body){0};
  return UM_OK;
}
