/* TEME, PEF, ITRF and GCRS.
 *
 *   TEME -> PEF    R3(GMST82(UT1)), no equation of the equinoxes
 *   PEF  -> ITRF   R1(-yp) R2(-xp)
 *   GCRS -> ITRF   IAU 2006/2000A with polar motion (the steps of eraC2t06a)
 *   v_PEF = R3 v_TEME - omega x r_PEF,  omega = 7.29211514670698e-5 (1 - LOD / 86400 s) rad/s
 * References: Vallado, Crawford, Hujsak & Kelso 2006, AIAA 2006-6753, appendix C; IERS TN36. */
#include "orbit/frames.h"

#include <erfa.h>
#include <string.h>

#include "base/core/constants.h"
#include "orbit/time.h"

/* Earth orientation and the two Julian dates that belong to one instant. */
struct instant {
  double t_tai;                         /* [s] */
  double tt[2], ut1[2];                 /* [d] */
  double xp, yp;                        /* [rad] */
  struct um_orbit_ephemeris *ephemeris; /* NULL: the series */
};

static enum um_status instant_at(struct um_context *context,
                                 const struct um_orbit_earth_orientation *orientation, double t_tai,
                                 struct instant *now)
{
  double ut1_utc;
  UM_TRY(um_orbit_earth_orientation_at(context, orientation, t_tai, &ut1_utc, &now->xp, &now->yp));
  now->t_tai = t_tai;
  now->ephemeris = orientation->ephemeris;
  um_orbit_time_tt(t_tai, now->tt);
  um_orbit_time_ut1(t_tai, ut1_utc, now->ut1);
  return UM_OK;
}

static struct um_mat3 matrix(double m[3][3])
{
  struct um_mat3 out;
  memcpy(out.m, m, sizeof out.m);
  return out;
}

static struct um_mat3 gcrs_to_itrf(const struct instant *now)
{
  double celestial[3][3], pole[3][3], m[3][3];
  struct um_orbit_cip cip;
  um_orbit_ephemeris_cip(now->ephemeris, now->t_tai, &cip);
  eraC2ixys(cip.x, cip.y, cip.s, celestial);
  eraPom00(now->xp, now->yp, eraSp00(now->tt[0], now->tt[1]), pole);
  eraC2tcio(celestial, eraEra00(now->ut1[0], now->ut1[1]), pole, m);
  return matrix(m);
}

static struct um_mat3 teme_to_pef(const struct instant *now)
{
  double m[3][3];
  eraIr(m);
  eraRz(eraGmst82(now->ut1[0], now->ut1[1]), m);
  return matrix(m);
}

static struct um_mat3 pef_to_itrf(const struct instant *now)
{
  double m[3][3];
  eraPom00(now->xp, now->yp, 0.0, m);
  return matrix(m);
}

enum um_status um_orbit_frames_gcrs_to_itrf(struct um_context *context,
                                            const struct um_orbit_earth_orientation *orientation,
                                            double t_tai, struct um_mat3 *out)
{
  struct instant now;
  UM_TRY(instant_at(context, orientation, t_tai, &now));
  *out = gcrs_to_itrf(&now);
  return UM_OK;
}

enum um_status um_orbit_frames_teme_to_gcrs(struct um_context *context,
                                            const struct um_orbit_earth_orientation *orientation,
                                            double t_tai, struct um_mat3 *out)
{
  struct instant now;
  UM_TRY(instant_at(context, orientation, t_tai, &now));
  struct um_mat3 itrf = um_mat3_multiply(pef_to_itrf(&now), teme_to_pef(&now));
  *out = um_mat3_multiply(um_mat3_transpose(gcrs_to_itrf(&now)), itrf);
  return UM_OK;
}

enum um_status um_orbit_frames_teme_to_itrf(struct um_context *context,
                                            const struct um_orbit_earth_orientation *orientation,
                                            double t_tai, double lod, struct um_vec3 r_teme,
                                            struct um_vec3 v_teme, struct um_vec3 *r_itrf,
                                            struct um_vec3 *v_itrf)
{
  struct instant now;
  UM_TRY(instant_at(context, orientation, t_tai, &now));
  struct um_mat3 spin = teme_to_pef(&now), pole = pef_to_itrf(&now);
  struct um_vec3 omega = um_vec3(0.0, 0.0, UM_EARTH_ROTATION * (1.0 - lod / 86400.0)); /* [rad/s] */

  struct um_vec3 r_pef = um_mat3_apply(spin, r_teme);
  /* v_PEF = R3 v_TEME - omega x r_PEF */
  struct um_vec3 v_pef = um_vec3_sub(um_mat3_apply(spin, v_teme), um_vec3_cross(omega, r_pef));
  *r_itrf = um_mat3_apply(pole, r_pef);
  *v_itrf = um_mat3_apply(pole, v_pef);
  return UM_OK;
}
