/* SGP4/SDP4: from a TLE to position and velocity in TEME.
 *
 *   mean elements at epoch -> secular gravity and drag -> [deep space: resonance, Sun, Moon]
 *   -> long-period terms by J3 -> Kepler's equation -> short-period terms by J2 -> r, v
 * WGS-72, operation mode 'i'. References: STR3 sections 6 and 7; V06. */
#include "orbit/sgp4.h"

#include <erfa.h>

#include "orbit/sgp4_impl.h"

#define DEEP_SPACE_PERIOD 225.0     /* [min] */
#define JD_1950           2433281.5 /* [d] */

enum sgp4_error {
  SGP4_GOOD = 0,
  SGP4_MEAN_ECCENTRICITY = 1,
  SGP4_MEAN_MOTION = 2,
  SGP4_PERTURBED_ECCENTRICITY = 3,
  SGP4_SEMI_LATUS_RECTUM = 4,
  SGP4_DECAYED = 6
};

static const char *error_text(int error)
{
  switch (error) {
  case SGP4_MEAN_ECCENTRICITY:
    return "mean eccentricity outside 0 to 1";
  case SGP4_MEAN_MOTION:
    return "mean motion is not positive";
  case SGP4_PERTURBED_ECCENTRICITY:
    return "perturbed eccentricity outside 0 to 1";
  case SGP4_SEMI_LATUS_RECTUM:
    return "semi-latus rectum is negative";
  case SGP4_DECAYED:
    return "the satellite has decayed";
  default:
    return "unknown";
  }
}

enum um_status um_orbit_sgp4_create(struct um_context *context, const struct um_orbit_tle *tle,
                                    struct um_orbit_sgp4 **out)
{
  struct um_orbit_sgp4 *sgp4;
  *out = NULL;
  if (!(tle->mean_motion > 0.0 && tle->eccentricity >= 0.0 && tle->eccentricity < 1.0))
    return um_core_fail(context, UM_ERR_INPUT,
                        "TLE: mean motion %g rad/min and eccentricity %g; a positive mean motion "
                        "and an eccentricity of 0 to 1 are accepted",
                        tle->mean_motion, tle->eccentricity);
  UM_TRY(um_core_allocate(context, 1, sizeof *sgp4, &sgp4));
  sgp4->context = context;
  sgp4->epoch = (struct um_sgp4_elements){.n = tle->mean_motion,
                                          .e = tle->eccentricity,
                                          .i = tle->inclination,
                                          .raan = tle->raan,
                                          .argp = tle->argument_of_perigee,
                                          .m = tle->mean_anomaly};
  um_orbit_sgp4_secular_prepare(&sgp4->epoch, tle->bstar, &sgp4->secular);
  sgp4->epoch.n = sgp4->secular.n0;
  sgp4->deep = 2.0 * UM_PI / sgp4->epoch.n >= DEEP_SPACE_PERIOD;
  if (sgp4->deep) {
    struct um_sdp4_deep *deep = &sgp4->deep_space;
    sgp4->secular.truncated = true;
    /* The theory takes UTC for UT1. The date is summed to one double, as in V06: its last bit (40
     * us of the Moon's motion) shows as 4e-6 km in satellite 23333. */
    deep->gmst0 = eraGmst82(tle->epoch_jd[0], tle->epoch_jd[1]);
    um_orbit_sdp4_lunisolar_prepare(&sgp4->epoch, tle->epoch_jd[0] + tle->epoch_jd[1] - JD_1950,
                                    deep);
    um_orbit_sdp4_resonance_prepare(&sgp4->epoch, &sgp4->secular, deep);
  }
  *out = sgp4;
  return UM_OK;
}

void um_orbit_sgp4_destroy(struct um_orbit_sgp4 **sgp4)
{
  if (!sgp4 || !*sgp4) return;
  um_core_free((*sgp4)->context, *sgp4);
  *sgp4 = NULL;
}

double um_orbit_sgp4_nodal_period(const struct um_orbit_sgp4 *sgp4)
{
  return 60.0 * 2.0 * UM_PI / (sgp4->secular.m_dot + sgp4->secular.argp_dot);
}

static double wrap(double angle) { return fmod(angle, 2.0 * UM_PI); }

/* Mean elements at t [min] with drag and deep-space terms; *axis receives a [er]. */
static enum sgp4_error mean_elements(const struct um_orbit_sgp4 *sgp4, double t,
                                     struct um_sgp4_elements *mean, double *axis)
{
  struct um_sgp4_drag drag;
  um_orbit_sgp4_secular_at(&sgp4->epoch, &sgp4->secular, t, mean, &drag);
  if (sgp4->deep) {
    const struct um_sdp4_deep *deep = &sgp4->deep_space;
    mean->e += deep->e_dot * t;
    mean->i += deep->i_dot * t;
    mean->argp += deep->argp_dot * t;
    mean->raan += deep->raan_dot * t;
    mean->m += deep->m_dot * t;
    um_orbit_sdp4_resonance_at(deep, &sgp4->epoch, sgp4->secular.argp_dot, t, mean);
  }
  if (!(mean->n > 0.0)) return SGP4_MEAN_MOTION;
  *axis = pow(um_sgp4_ke() / mean->n, 2.0 / 3.0) * drag.axis * drag.axis;
  mean->n = um_sgp4_ke() / pow(*axis, 1.5);
  mean->e -= drag.e;
  if (!(mean->e < 1.0 && mean->e >= -0.001)) return SGP4_MEAN_ECCENTRICITY;
  mean->e = fmax(mean->e, 1.0e-6);

  mean->m += sgp4->secular.n0 * drag.longitude;
  double longitude = wrap(mean->m + mean->argp + mean->raan);
  mean->raan = wrap(mean->raan);
  mean->argp = wrap(mean->argp);
  mean->m = wrap(longitude - mean->argp - mean->raan);
  if (!sgp4->deep) return SGP4_GOOD;

  um_orbit_sdp4_lunisolar_periodics(&sgp4->deep_space, t, mean);
  if (mean->i < 0.0) {
    mean->i = -mean->i;
    mean->raan += UM_PI;
    mean->argp -= UM_PI;
  }
  if (!(mean->e >= 0.0 && mean->e <= 1.0)) return SGP4_PERTURBED_ECCENTRICITY;
  return SGP4_GOOD;
}

/* The ellipse after the long-period terms, in equinoctial form. */
struct orbit_ellipse {
  double axn, ayn;     /* e cos omega, e sin omega + long-period */
  double u;            /* M + omega, long-period included [rad] */
  double sin_e, cos_e; /* of E + omega, Kepler's equation solved */
};

/* Long-period terms by J3 (STR3: a_xN, a_yN, L_L). */
static struct orbit_ellipse long_period(const struct um_sgp4_elements *mean, double axis)
{
  struct orbit_ellipse o;
  double sin_i = sin(mean->i), cos_i = cos(mean->i);
  double j3 = SGP4_J3 / SGP4_J2;
  /* the term in 1 / (1 + cos i) is bounded at i = 180 deg */
  double one_plus = fabs(cos_i + 1.0) > 1.5e-12 ? 1.0 + cos_i : 1.5e-12;
  double l_cof = -0.25 * j3 * sin_i * (3.0 + 5.0 * cos_i) / one_plus;
  double inverse_p = 1.0 / (axis * (1.0 - mean->e * mean->e));
  o.axn = mean->e * cos(mean->argp);
  o.ayn = mean->e * sin(mean->argp) + inverse_p * (-0.5 * j3 * sin_i);
  double longitude = mean->m + mean->argp + mean->raan + inverse_p * l_cof * o.axn;
  o.u = wrap(longitude - mean->raan);
  return o;
}

/* U = F - a_xN sin F + a_yN cos F by Newton, steps bounded by 0.95 rad, to 1e-12 rad. The theory
 * stops after ten steps, which its verification set (satellite 23333) relies on. */
static void kepler_solve(struct orbit_ellipse *o)
{
  double f = o->u, step = 1.0;
  for (int k = 0; k < 10 && fabs(step) >= 1.0e-12; k++) {
    o->sin_e = sin(f);
    o->cos_e = cos(f);
    step = (o->u - o->ayn * o->cos_e + o->axn * o->sin_e - f) /
           (1.0 - o->cos_e * o->axn - o->sin_e * o->ayn);
    if (fabs(step) >= 0.95) step = step > 0.0 ? 0.95 : -0.95;
    f += step;
  }
}

/* Short-period terms by J2 and the state (STR3, last block of section 6). */
static enum sgp4_error short_period(const struct um_sgp4_elements *mean, double axis,
                                    const struct orbit_ellipse *o, struct um_vec3 *r,
                                    struct um_vec3 *v)
{
  double e_cos = o->axn * o->cos_e + o->ayn * o->sin_e;
  double e_sin = o->axn * o->sin_e - o->ayn * o->cos_e;
  double e2 = o->axn * o->axn + o->ayn * o->ayn;
  double p = axis * (1.0 - e2); /* [er] */
  if (!(p >= 0.0)) return SGP4_SEMI_LATUS_RECTUM;
  double radius = axis * (1.0 - e_cos); /* [er] */
  double r_dot = sqrt(axis) * e_sin / radius, r_u_dot = sqrt(p) / radius;
  double beta = sqrt(1.0 - e2), shared = e_sin / (1.0 + beta);
  double sin_u = axis / radius * (o->sin_e - o->ayn - o->axn * shared);
  double cos_u = axis / radius * (o->cos_e - o->axn + o->ayn * shared);
  double sin_2u = (cos_u + cos_u) * sin_u, cos_2u = 1.0 - 2.0 * sin_u * sin_u;

  double sin_i = sin(mean->i), cos_i = cos(mean->i), theta2 = cos_i * cos_i;
  double con41 = 3.0 * theta2 - 1.0, x1mth2 = 1.0 - theta2, x7thm1 = 7.0 * theta2 - 1.0;
  double k1 = 0.5 * SGP4_J2 / p, k2 = k1 / p; /* [1/er], [1/er^2] */
  double rk = radius * (1.0 - 1.5 * k2 * beta * con41) + 0.5 * k1 * x1mth2 * cos_2u;
  double uk = atan2(sin_u, cos_u) - 0.25 * k2 * x7thm1 * sin_2u;
  double node = mean->raan + 1.5 * k2 * cos_i * sin_2u;
  double ik = mean->i + 1.5 * k2 * cos_i * sin_i * cos_2u;
  double rk_dot = r_dot - mean->n * k1 * x1mth2 * sin_2u / um_sgp4_ke();
  double ruk_dot = r_u_dot + mean->n * k1 * (x1mth2 * cos_2u + 1.5 * con41) / um_sgp4_ke();

  /* U = M sin u + N cos u, V = M cos u - N sin u */
  double sin_n = sin(node), cos_n = cos(node), sin_ik = sin(ik), cos_ik = cos(ik);
  double su = sin(uk), cu = cos(uk);
  struct um_vec3 m = um_vec3(-sin_n * cos_ik, cos_n * cos_ik, sin_ik);
  struct um_vec3 n = um_vec3(cos_n, sin_n, 0.0);
  struct um_vec3 out = um_vec3_axpy(um_vec3_scale(m, su), cu, n);
  struct um_vec3 ahead = um_vec3_axpy(um_vec3_scale(m, cu), -su, n);
  double metre = 1000.0 * SGP4_RADIUS, metre_per_second = metre * um_sgp4_ke() / 60.0;
  *r = um_vec3_scale(out, rk * metre);
  *v = um_vec3_scale(um_vec3_axpy(um_vec3_scale(out, rk_dot), ruk_dot, ahead), metre_per_second);
  return rk < 1.0 ? SGP4_DECAYED : SGP4_GOOD;
}

enum um_status um_orbit_sgp4_state(struct um_context *context, const struct um_orbit_sgp4 *sgp4,
                                   double minutes, struct um_vec3 *r_teme, struct um_vec3 *v_teme,
                                   int *error)
{
  struct um_sgp4_elements mean;
  double axis = 0.0;
  enum sgp4_error code = mean_elements(sgp4, minutes, &mean, &axis);
  if (code == SGP4_GOOD) {
    struct orbit_ellipse ellipse = long_period(&mean, axis);
    kepler_solve(&ellipse);
    code = short_period(&mean, axis, &ellipse, r_teme, v_teme);
  }
  if (error) *error = (int)code;
  if (code == SGP4_GOOD) return UM_OK;
  return um_core_fail(context, UM_ERR_NUMERIC,
                      "SGP4 error %d (%s) at %.3f min from the epoch of the elements", (int)code,
                      error_text((int)code), minutes);
}
