/* TEME, PEF, ITRF and GCRS by ERFA (IAU 2006/2000A; TEME by GMST82, no equation of the equinoxes).
 */
#ifndef UMBRA_ORBIT_FRAMES_H
#define UMBRA_ORBIT_FRAMES_H

#include "base/core/context.h"
#include "base/core/vec.h"
#include "orbit/finals.h"

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
