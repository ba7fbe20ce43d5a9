/* Shapes of STEP-TAS. Private to geometry/step_tas*.c. */
#ifndef UMBRA_GEOMETRY_STEP_TAS_SHAPE_IMPL_H
#define UMBRA_GEOMETRY_STEP_TAS_SHAPE_IMPL_H

#include "geometry/step_tas_impl.h"

enum um_geometry_tas_kind {
  UM_TAS_RECTANGLE,
  UM_TAS_TRIANGLE,
  UM_TAS_QUADRILATERAL,
  UM_TAS_DISC, /* and what follows: round */
  UM_TAS_CYLINDER,
  UM_TAS_CONE,
  UM_TAS_SPHERE,
  UM_TAS_PARABOLOID,
  UM_TAS_KINDS
};

struct um_geometry_tas_shape {
  enum um_geometry_tas_kind kind;
  struct um_vec3 point[4];                /* corners; or the origin */
  struct um_vec3 x, y, axis;              /* unit vectors of round ones */
  double height, length[3], start, sweep; /* [m, m, rad, rad] */
};

/* What item `shape` is, that of a surface. UM_ERR_INPUT: none that is read, or one that cannot be.
 */
enum um_status um_geometry_tas_read_surface(const struct um_geometry_tas *t,
                                            um_geometry_tas_item shape,
                                            struct um_geometry_tas_shape *out);
/* The same of a round solid: MGM_SOLID_CYLINDER, _CONE or _SPHERE; *is false: it is none. */
enum um_status um_geometry_tas_read_solid(const struct um_geometry_tas *t,
                                          um_geometry_tas_item solid,
                                          struct um_geometry_tas_shape *out, bool *is);

#endif
