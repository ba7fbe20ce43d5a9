/* Sun and Moon by ERFA: heliocentric and barycentric Earth (VSOP2000 fit, eraEpv00), Moon (Meeus,
 * eraMoon98). TDB is taken as TT (2 ms: 60 m of the Earth's path).
 *
 * Apparent place of the Sun from a point r, v near the Earth:
 *   natural direction  p = s(t - tau) - (e + r),  tau = |p| / c,  all barycentric
 *   apparent direction by eraAb with the barycentric velocity of the observer.
 * Reference: Urban & Seidelmann 2013, Explanatory Supplement, chapter 7; SOFA eraAb. */
#include "orbit/sun.h"

#include <erfa.h>

#include "base/core/constants.h"
#include "orbit/time.h"

static const double AU_PER_DAY = UM_AU / 86400.0; /* [m/s] */

static struct um_vec3 vector(const double p[3], double unit)
{
  return um_vec3(unit * p[0], unit * p[1], unit * p[2]);
}

struct um_vec3 um_orbit_sun_position(struct um_orbit_ephemeris *ephemeris, double t_tai)
{
  struct um_orbit_earth_motion earth;
  um_orbit_ephemeris_earth(ephemeris, t_tai, &earth);
  return vector(earth.r, -UM_AU);
}

struct um_vec3 um_orbit_moon_position(double t_tai)
{
  double tt[2], moon[2][3];
  um_orbit_time_tt(t_tai, tt);
  eraMoon98(tt[0], tt[1], moon);
  return vector(moon[0], UM_AU);
}

void um_orbit_sun_apparent(struct um_orbit_ephemeris *ephemeris, double t_tai,
                           struct um_vec3 r_gcrs, struct um_vec3 v_gcrs, struct um_vec3 *direction,
                           double *distance)
{
  struct um_orbit_earth_motion earth;
  um_orbit_ephemeris_earth(ephemeris, t_tai, &earth);

  /* Sun from the observer now, and the Sun's own barycentric velocity (some 13 m/s) */
  struct um_vec3 now = um_vec3_sub(vector(earth.r, -UM_AU), r_gcrs);
  struct um_vec3 earth_velocity = vector(earth.v_b, AU_PER_DAY);
  struct um_vec3 sun_velocity = um_vec3_sub(earth_velocity, vector(earth.v, AU_PER_DAY));

  /* p = s(t) - v_sun tau - o(t); one pass leaves tau right to (13 m/s / c) tau = 2e-5 s */
  double tau = um_vec3_norm(now) / UM_LIGHT_SPEED; /* [s] */
  struct um_vec3 natural = um_vec3_axpy(now, -tau, sun_velocity);
  *distance = um_vec3_norm(natural);

  struct um_vec3 p = um_vec3_unit(natural);
  struct um_vec3 beta = um_vec3_scale(um_vec3_add(earth_velocity, v_gcrs), 1.0 / UM_LIGHT_SPEED);
  double pnat[3] = {p.x, p.y, p.z}, v[3] = {beta.x, beta.y, beta.z}, apparent[3];
  eraAb(pnat, v, *distance / UM_AU, sqrt(1.0 - um_vec3_dot(beta, beta)), apparent);
  *direction = um_vec3_unit(vector(apparent, 1.0));
}
