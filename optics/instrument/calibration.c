/* Factor and extinction from stars of known magnitude. */
#include "optics/instrument/calibration.h"

#include <math.h>

#include "base/core/constants.h"

#define SPREAD          1e-3  /* of airmass, below which they are all the same */
#define EXTINCTION_MOST 10.0  /* [mag per airmass] */
#define HUGE_FACTOR     1e100 /* of counts, beyond which nothing is computed */

static enum um_status check(struct um_context *context, const struct um_instrument_star *star,
                            size_t n, double extinction, size_t *at)
{
  double least = INFINITY, most = 0.0;
  size_t wanted = isnan(extinction) ? 2 : 1;
  for (*at = 0; *at < n; (*at)++) {
    const struct um_instrument_star *s = &star[*at];
    if (!(s->measured > 0.0 && s->sigma > 0.0 && s->predicted > 0.0 && s->airmass > 0.0) ||
        !isfinite(s->measured + s->sigma + s->predicted + s->airmass))
      return um_core_fail(context, UM_ERR_INPUT,
                          "%g +- %g counts per second of %g at airmass %g; accepted: all above 0",
                          s->measured, s->sigma, s->predicted, s->airmass);
    least = fmin(least, s->airmass);
    most = fmax(most, s->airmass);
  }
  if (n < wanted)
    return um_core_fail(context, UM_ERR_INPUT, "%zu stars; accepted: %zu or more", n, wanted);
  if (isnan(extinction) && !(most - least > SPREAD))
    return um_core_fail(context, UM_ERR_INPUT,
                        "all stars stand at airmass %g: the extinction is not determined; "
                        "accepted: stars at several airmasses, or a known extinction",
                        least);
  return UM_OK;
}

/* A star's -2.5 log10(measured/predicted) and its weight, one over its variance. */
static double magnitude(const struct um_instrument_star *star, double *weight)
{
  double sigma = UM_POGSON * star->sigma / star->measured;
  *weight = 1.0 / (sigma * sigma);
  return -2.5 * (log10(star->measured) - log10(star->predicted));
}

/* Counts beyond all measure give numbers that are none. */
static enum um_status check_fit(struct um_context *context,
                                const struct um_instrument_calibration *fit)
{
  if (!(fit->kappa > 1.0 / HUGE_FACTOR && fit->kappa + fit->kappa_sigma < HUGE_FACTOR &&
        fit->extinction_sigma < HUGE_FACTOR && isfinite(fit->extinction + fit->chi2)))
    return um_core_fail(context, UM_ERR_INPUT,
                        "counts so far from what is predicted that they give no factor; accepted: "
                        "counts as of this telescope, with their own sigma");
  if (fabs(fit->extinction) <= EXTINCTION_MOST) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "the stars give an extinction of %g +- %g mag per airmass; accepted: -%g to "
                      "%g, stars at airmasses further apart, or a known extinction",
                      fit->extinction, fit->extinction_sigma, EXTINCTION_MOST, EXTINCTION_MOST);
}

enum um_status um_instrument_calibrate(struct um_context *context,
                                       const struct um_instrument_star *star, size_t n,
                                       double extinction, struct um_instrument_calibration *out,
                                       size_t *at)
{
  double w = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, weight;
  *out = (struct um_instrument_calibration){0};
  UM_TRY(check(context, star, n, extinction, at));
  bool known = !isnan(extinction);
  for (size_t i = 0; i < n; i++) { /* means */
    double value = magnitude(&star[i], &weight);
    w += weight;
    x += weight / w * (star[i].airmass - x);
    y += weight / w * (value - y);
  }
  for (size_t i = 0; i < n; i++) { /* about them: no difference of large sums */
    double value = magnitude(&star[i], &weight), beside = star[i].airmass - x;
    xx += weight * beside * beside;
    xy += weight * beside * (value - y);
  }
  double k = known ? extinction : xy / xx;
  double a = y - k * x; /* of both fits */
  double a_sigma = known ? 1.0 / sqrt(w) : sqrt(1.0 / w + x * x / xx);
  out->kappa = pow(10.0, -0.4 * a);
  out->kappa_sigma = out->kappa * a_sigma / UM_POGSON;
  out->extinction = k;
  out->extinction_sigma = known ? 0.0 : sqrt(1.0 / xx);
  out->correlation = known ? 0.0 : -x / sqrt(x * x + xx / w);
  for (size_t i = 0; i < n; i++) {
    double apart = magnitude(&star[i], &weight) - a - k * star[i].airmass;
    out->chi2 += weight * apart * apart;
  }
  out->dof = n - (known ? 1 : 2);
  return check_fit(context, out);
}

double um_instrument_calibration_factor(const struct um_instrument_calibration *c, double airmass,
                                        double *relative)
{
  double a = UM_POGSON * c->kappa_sigma / c->kappa, k = airmass * c->extinction_sigma; /* [mag] */
  *relative = sqrt(fmax(a * a + 2.0 * c->correlation * a * k + k * k, 0.0)) / UM_POGSON;
  return c->kappa * pow(10.0, -0.4 * c->extinction * airmass);
}
