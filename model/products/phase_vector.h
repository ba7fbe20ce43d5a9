/* The phase vector: the bisector of the directions to Sun and observer, in body axes. */
#ifndef UMBRA_MODEL_PHASE_VECTOR_H
#define UMBRA_MODEL_PHASE_VECTOR_H

#include "base/core/vec.h"

/* Where Sun and observer stand, as a map of a body has it. With p the phase vector, gamma the phase
 * angle and t a unit vector across p,
 *   p = (s + o)/|s + o|,   s = p cos(gamma/2) + t sin(gamma/2),   o = p cos(gamma/2) - t
 * sin(gamma/2) The plane angle says where t, the side of the Sun, points about p: 0 to the north of
 * the map (body z), 90 deg to its east (growing longitude). At gamma 0 it means nothing and is 0.
 */
struct um_model_phase_vector {
  double latitude, longitude; /* asin p_z, atan2(p_y, p_x) [rad] */
  double phase_angle;         /* 0 to pi [rad] */
  double plane;               /* 0 to 2 pi [rad] */
};

/* Of unit directions in body axes. NaN but for the phase angle where Sun and observer are opposite.
 * Checks: tests/model/products/phase_vector.c. */
struct um_model_phase_vector um_model_phase_vector(struct um_vec3 sun, struct um_vec3 observer);
/* The way back: unit directions in body axes. */
void um_model_phase_directions(const struct um_model_phase_vector *at, struct um_vec3 *sun,
                               struct um_vec3 *observer);

#endif
