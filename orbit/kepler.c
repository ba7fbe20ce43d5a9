/* Two-body motion: Kepler's equation, and the state on an ellipse.
 *
 *   M = M0 + n (t - t0),  M = E - e sin E
 *   r = a (cos E - e) P + b sin E Q,  v = dE/dt (-a sin E P + b cos E Q),  dE/dt = n / (1 - e cos
 * E) Reference: Vallado 2013, Fundamentals of Astrodynamics, chapters 2 and 5; Montenbruck & Gill
 * 2000, chapter 2. */
#include "base/core/constants.h"
#include "orbit/trajectory_impl.h"

enum { KEPLER_ITERATIONS = 100 };

static enum um_status not_converged(struct um_context *context, double mean_anomaly, double e)
{
  return um_core_fail(context, UM_ERR_NUMERIC,
                      "Kepler's equation did not converge: mean anomaly %.17g rad, eccentricity %g",
                      mean_anomaly, e);
}

/* Newton inside the bracket [M - e, M + e], bisection whenever a step would leave it. */
enum um_status um_orbit_kepler_solve(struct um_context *context, double mean_anomaly, double e,
                                     double *eccentric_anomaly)
{
  double turns = nearbyint(mean_anomaly / (2.0 * UM_PI)) * 2.0 * UM_PI;
  double m = mean_anomaly - turns; /* [-pi, pi] */
  double low = m - e, high = m + e, x = m + 0.85 * e * (m < 0.0 ? -1.0 : 1.0);
  for (int k = 0; k < KEPLER_ITERATIONS; k++) {
    double f = x - e * sin(x) - m;
    if (f > 0.0)
      high = x;
    else
      low = x;
    double newton = x - f / (1.0 - e * cos(x));
    /* a step, or a residual, of the size of the rounding */
    if (fabs(newton - x) <= 4e-16 * (1.0 + fabs(x)) || fabs(f) <= 4e-16 * fabs(x)) {
      *eccentric_anomaly = newton + turns;
      return UM_OK;
    }
    x = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (!(x > low && x < high)) { /* the bracket is down to neighbouring numbers */
      *eccentric_anomaly = x + turns;
      return isfinite(x) ? UM_OK : not_converged(context, mean_anomaly, e);
    }
  }
  return not_converged(context, mean_anomaly, e);
}

enum um_status um_orbit_conic_state(struct um_context *context, const struct um_orbit_conic *conic,
                                    double t_tai, struct um_vec3 *r, struct um_vec3 *v)
{
  double e = conic->e, anomaly;
  double m = conic->m0 + conic->rate * (t_tai - conic->epoch);
  UM_TRY(um_orbit_kepler_solve(context, m, e, &anomaly));
  double c = cos(anomaly), s = sin(anomaly), b = conic->a * sqrt((1.0 - e) * (1.0 + e));
  double anomaly_rate = conic->rate / (1.0 - e * c);
  *r = um_vec3_axpy(um_vec3_scale(conic->p, conic->a * (c - e)), b * s, conic->q);
  *v = um_vec3_axpy(um_vec3_scale(conic->p, -anomaly_rate * conic->a * s), anomaly_rate * b * c,
                    conic->q);
  return UM_OK;
}
