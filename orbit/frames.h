/* TEME, PEF, ITRF and GCRS by ERFA (IAU 2006/2000A; TEME by GMST82, no equation of the equinoxes),
 * and frames of the equinox by its older theories, as others write them. */
#ifndef UMBRA_ORBIT_FRAMES_H
#define UMBRA_ORBIT_FRAMES_H

#include "base/core/context.h"
#include "base/core/vec.h"
#include "orbit/finals.h"

/* Frames that ephemerides and attitudes of others are written in. */
enum um_orbit_frame {
  UM_ORBIT_FRAME_GCRF,
  UM_ORBIT_FRAME_EME2000, /* turned by the bias of its frame */
  UM_ORBIT_FRAME_MOD,     /* mean equator and equinox of the date: from EME2000 by IAU 1976 */
  UM_ORBIT_FRAME_TOD,     /* true ones: with nutation of IAU 1980, without observed corrections */
  UM_ORBIT_FRAME_TEME,
  UM_ORBIT_FRAME_ITRF /* of any year: they agree within some centimetres */
};
#define UM_ORBIT_FRAMES "GCRF, ICRF, EME2000, ITRF, TEME, TOD, MOD"
/* The frame that messages of CCSDS name; false: none of these. GCRF, ICRF and ITRF may have a
 * number or a year, "ITRF2014", "ITRF-93". */
bool um_orbit_frame_find(const char *name, enum um_orbit_frame *frame);
/* Passive rotation GCRS -> a frame. orientation: NULL: UT1 is UTC and the pole at zero.
 * UM_ERR_INPUT outside of a finals table. */
enum um_status um_orbit_frame_from_gcrs(struct um_context *context,
                                        const struct um_orbit_earth_orientation *orientation,
                                        enum um_orbit_frame frame, double t_tai,
                                        struct um_mat3 *out);
/* Place [m] and velocity [m/s], relative to the frame, to GCRS in place. The day is taken as 86400
 * s (10 um/s of a low orbit); the slow turn of the equinox has no part in velocities (0.1 mm/s).
 * Errors as above. */
enum um_status um_orbit_frame_to_gcrs(struct um_context *context,
                                      const struct um_orbit_earth_orientation *orientation,
                                      enum um_orbit_frame frame, double t_tai, struct um_vec3 *r,
                                      struct um_vec3 *v);

/* Passive rotation GCRS -> ITRF at a time; UM_ERR_INPUT as above. Its third row is the Earth's
 * pole in GCRS. */
enum um_status um_orbit_frames_gcrs_to_itrf(struct um_context *context,
                                            const struct um_orbit_earth_orientation *orientation,
                                            double t_tai, struct um_mat3 *out);
/* TEME -> GCRS (positions rotate alone; velocity is rotated as a vector, as the attitude frames
 * want it). */
enum um_status um_orbit_frames_teme_to_gcrs(struct um_context *context,
                                            const struct um_orbit_earth_orientation *orientation,
                                            double t_tai, struct um_mat3 *out);
/* TEME -> ITRF position [m] and velocity [m/s] with the Earth's rotation (lod [s]). */
enum um_status um_orbit_frames_teme_to_itrf(struct um_context *context,
                                            const struct um_orbit_earth_orientation *orientation,
                                            double t_tai, double lod, struct um_vec3 r_teme,
                                            struct um_vec3 v_teme, struct um_vec3 *r_itrf,
                                            struct um_vec3 *v_itrf);

#endif
