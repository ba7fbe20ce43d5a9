/* SGP4/SDP4, WGS-72 (Hoots & Roehrich 1980, Spacetrack Report 3; Vallado, Crawford, Hujsak &
 * Kelso 2006, AIAA 2006-6753). Improved mode 'i'. Own implementation from the equations. */
#ifndef UMBRA_ORBIT_SGP4_H
#define UMBRA_ORBIT_SGP4_H

#include "base/core/context.h"
#include "base/core/vec.h"
#include "orbit/tle.h"

/* Error codes of AIAA 2006-6753: 0 none, 1 mean eccentricity, 2 mean motion, 3 perturbed
 * eccentricity, 4 semi-latus rectum, 6 decayed. */
struct um_orbit_sgp4;

enum um_status um_orbit_sgp4_create(struct um_context *context, const struct um_orbit_tle *tle,
                                    struct um_orbit_sgp4 **out);
void um_orbit_sgp4_destroy(struct um_orbit_sgp4 **sgp4);
/* State at `minutes` since epoch: r_teme [m], v_teme [m/s]. UM_ERR_NUMERIC with the code's meaning;
 * *error (may be NULL) receives the code. Stateless: the result does not depend on earlier calls,
 * and threads may share an object. All 33 satellites of AIAA 2006-6753 to 2e-7 km
 * (tests/orbit/sgp4.c). */
enum um_status um_orbit_sgp4_state(struct um_context *context, const struct um_orbit_sgp4 *sgp4,
                                   double minutes, struct um_vec3 *r_teme, struct um_vec3 *v_teme,
                                   int *error);

#endif
