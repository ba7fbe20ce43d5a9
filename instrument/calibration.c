/* Factor and extinction from stars of known magnitude. */
#include "instrument/calibration.h"

#include <math.h>

static const double POGSON = 1.08573620475812959; /* 2.5/ln 10 */

#define SPREAD 1e-3 /* of airmass, below which they are all the same */

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

enum um_status um_instrument_calibrate(struct um_context *context,
                                       const struct um_instrument_star *star, size_t n,
                                       double extinction, struct um_instrument_calibration *out,
                                       size_t *at)
{
  double w = 0.0, wx = 0.0, wxx = 0.0, wy = 0.0, wxy = 0.0;
  *out = (struct um_instrument_calibration){0};
  UM_TRY(check(context, star, n, extinction, at));
  bool known = !isnan(extinction);
  for (size_t i = 0; i < n; i++) {
    double y = -2.5 * log10(star[i].measured / star[i].predicted), x = star[i].airmass;
    double sigma = POGSON * star[i].sigma / star[i].measured, weight = 1.0 / (sigma * sigma);
    w += weight;
    wx += weight * x;
    wxx += weight * x * x;
    wy += weight * y;
    wxy += weight * x * y;
  }
  double determinant = w * wxx - wx * wx;
  double k = known ? extinction : (w * wxy - wx * wy) / determinant;
  double a = (wy - k * wx) / w; /* of both fits */
  double a_sigma = known ? 1.0 / sqrt(w) : sqrt(wxx / determinant);
  out->kappa = pow(10.0, -0.4 * a);
  out->kappa_sigma = out->kappa * a_sigma / POGSON;
  out->extinction = k;
  out->extinction_sigma = known ? 0.0 : sqrt(w / determinant);
  out->correlation = known ? 0.0 : -wx / sqrt(w * wxx);
  for (size_t i = 0; i < n; i++) {
    double y = -2.5 * log10(star[i].measured / star[i].predicted);
    double sigma = POGSON * star[i].sigma / star[i].measured;
    out->chi2 += pow((y - a - k * star[i].airmass) / sigma, 2);
  }
  out->dof = n - (known ? 1 : 2);
  return UM_OK;
}

double um_instrument_calibration_factor(const struct um_instrument_calibration *c, double airmass,
                                        double *relative)
{
  double a = POGSON * c->kappa_sigma / c->kappa, k = airmass * c->extinction_sigma; /* [mag] */
  *relative = sqrt(fmax(a * a + 2.0 * c->correlation * a * k + k * k, 0.0)) / POGSON;
  return c->kappa * pow(10.0, -0.4 * c->extinction * airmass);
}
