/* TEME, PEF, ITRF, GCRS, and frames of the equinox.
 *
 *   TEME -> PEF    R3(GMST82(UT1)), no equation of the equinoxes
 *   PEF  -> ITRF   R1(-yp) R2(-xp)
 *   GCRS -> ITRF   IAU 2006/2000A with polar motion (the steps of eraC2t06a)
 *   v_PEF = R3 v_TEME - omega x r_PEF,  omega = 7.29211514670698e-5 (1 - LOD / 86400 s) rad/s
 *   GCRS -> EME2000 -> MOD -> TOD   bias; precession IAU 1976; nutation IAU 1980
 * References: Vallado, Crawford, Hujsak & Kelso 2006, AIAA 2006-6753, appendix C; IERS TN36. */
#include "orbit/frames.h"

#include <ctype.h>
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

/* TIRS -> ITRF. */
static void polar_motion(const struct instant *now, double pole[3][3])
{
  eraPom00(now->xp, now->yp, eraSp00(now->tt[0], now->tt[1]), pole);
}

static struct um_mat3 gcrs_to_itrf(const struct instant *now)
{
  double celestial[3][3], pole[3][3], m[3][3];
  struct um_orbit_cip cip;
  um_orbit_ephemeris_cip(now->ephemeris, now->t_tai, &cip);
  eraC2ixys(cip.x, cip.y, cip.s, celestial);
  polar_motion(now, pole);
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

/* --- frames of others ------------------------------------------------------------------------- */

static const struct um_orbit_earth_orientation still = {0}; /* UT1 is UTC, the pole at zero */

/* A name; `dated`: a number or a year may follow it. */
static const struct name {
  const char *name;
  bool dated;
  enum um_orbit_frame frame;
} names[] = {{"GCRF", true, UM_ORBIT_FRAME_GCRF},        {"ICRF", true, UM_ORBIT_FRAME_GCRF},
             {"EME2000", false, UM_ORBIT_FRAME_EME2000}, {"J2000", false, UM_ORBIT_FRAME_EME2000},
             {"MOD", false, UM_ORBIT_FRAME_MOD},         {"MOD_EARTH", false, UM_ORBIT_FRAME_MOD},
             {"TOD", false, UM_ORBIT_FRAME_TOD},         {"TOD_EARTH", false, UM_ORBIT_FRAME_TOD},
             {"TEME", false, UM_ORBIT_FRAME_TEME},       {"TEMEOFDATE", false, UM_ORBIT_FRAME_TEME},
             {"ITRF", true, UM_ORBIT_FRAME_ITRF}};

static bool is_named(const char *text, const struct name *n)
{
  size_t length = strlen(n->name);
  if (strncmp(text, n->name, length) != 0) return false;
  text += length;
  if (n->dated && *text == '-' && text[1] != '\0') text++;
  while (n->dated && isdigit((unsigned char)*text)) text++;
  return *text == '\0';
}

bool um_orbit_frame_find(const char *name, enum um_orbit_frame *frame)
{
  for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
    if (!is_named(name, &names[k])) continue;
    *frame = names[k].frame;
    return true;
  }
  return false;
}

static struct um_mat3 gcrs_to_eme2000(void)
{
  double bias[3][3], precession[3][3], both[3][3];
  eraBp06(2451545.0, 0.0, bias, precession, both);
  return matrix(bias);
}

static struct um_mat3 eme2000_to_date(bool nutates, double t_tai)
{
  double tt[2], m[3][3];
  um_orbit_time_tt(t_tai, tt);
  if (nutates)
    eraPnm80(tt[0], tt[1], m);
  else
    eraPmat76(tt[0], tt[1], m);
  return matrix(m);
}

enum um_status um_orbit_frame_from_gcrs(struct um_context *context,
                                        const struct um_orbit_earth_orientation *orientation,
                                        enum um_orbit_frame frame, double t_tai,
                                        struct um_mat3 *out)
{
  if (orientation == NULL) orientation = &still;
  switch (frame) {
  case UM_ORBIT_FRAME_ITRF:
    return um_orbit_frames_gcrs_to_itrf(context, orientation, t_tai, out);
  case UM_ORBIT_FRAME_TEME:
    UM_TRY(um_orbit_frames_teme_to_gcrs(context, orientation, t_tai, out));
    *out = um_mat3_transpose(*out);
    return UM_OK;
  case UM_ORBIT_FRAME_MOD:
  case UM_ORBIT_FRAME_TOD:
    *out = um_mat3_multiply(eme2000_to_date(frame == UM_ORBIT_FRAME_TOD, t_tai), gcrs_to_eme2000());
    return UM_OK;
  case UM_ORBIT_FRAME_EME2000:
    *out = gcrs_to_eme2000();
    return UM_OK;
  case UM_ORBIT_FRAME_GCRF:
    break;
  }
  *out = um_mat3_from_axes(um_vec3(1, 0, 0), um_vec3(0, 1, 0), um_vec3(0, 0, 1));
  return UM_OK;
}

/* omega in ITRF [rad/s]: along the axis of TIRS, from which the pole is turned. */
static enum um_status earth_rate(struct um_context *context,
                                 const struct um_orbit_earth_orientation *orientation, double t_tai,
                                 struct um_vec3 *out)
{
  struct instant now;
  double pole[3][3];
  UM_TRY(instant_at(context, orientation, t_tai, &now));
  polar_motion(&now, pole);
  *out = um_mat3_apply(matrix(pole), um_vec3(0.0, 0.0, UM_EARTH_ROTATION));
  return UM_OK;
}

enum um_status um_orbit_frame_to_gcrs(struct um_context *context,
                                      const struct um_orbit_earth_orientation *orientation,
                                      enum um_orbit_frame frame, double t_tai, struct um_vec3 *r,
                                      struct um_vec3 *v)
{
  struct um_mat3 m;
  if (frame == UM_ORBIT_FRAME_GCRF) return UM_OK;
  if (orientation == NULL) orientation = &still;
  UM_TRY(um_orbit_frame_from_gcrs(context, orientation, frame, t_tai, &m));
  if (frame == UM_ORBIT_FRAME_ITRF) {
    struct um_vec3 omega;
    UM_TRY(earth_rate(context, orientation, t_tai, &omega));
    *v = um_vec3_add(*v, um_vec3_cross(omega, *r)); /* v + omega x r */
  }
  m = um_mat3_transpose(m);
  *r = um_mat3_apply(m, *r);
  *v = um_mat3_apply(m, *v);
  return UM_OK;
}
