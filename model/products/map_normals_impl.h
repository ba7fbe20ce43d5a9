/* Normals of a body, at which its glints stand on a map. Private to model/products/. */
#ifndef UMBRA_MODEL_MAP_NORMALS_IMPL_H
#define UMBRA_MODEL_MAP_NORMALS_IMPL_H

#include "model/build/model.h"

#define UM_MODEL_MAP_POLE 1e-6 /* from a pole, where a longitude means nothing [rad] */

struct um_model_map_normal {
  double latitude, longitude; /* [rad] */
  struct um_vec3 unit;
  double area; /* of all that has it [m^2] */
};
struct um_model_map_normals {
  struct um_model_map_normal *normal; /* [n] the caller frees */
  size_t n;
};
/* Of a body without moving joints, those of a tenth of a degree together, the 4096 first; none
 * where joints move. Errors of um_geometry_pose_create. */
enum um_status um_model_map_normals_find(struct um_context *context, const struct um_model *model,
                                         struct um_model_map_normals *out);

#endif
