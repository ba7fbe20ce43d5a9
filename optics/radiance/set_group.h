/* A pose with its ray-tracing scene. Private to optics/. */
#ifndef UMBRA_OPTICS_SET_IMPL_H
#define UMBRA_OPTICS_SET_IMPL_H

#include "optics/optics.h"

struct um_optics_exchange; /* paths_impl.h */

struct um_optics_set {
  double *angle; /* [njoint] [rad] */
  struct um_geometry_pose *pose;
  struct um_geometry_visibility *visibility;
  struct um_optics_exchange *exchange; /* NULL unless inter-reflection is wanted */
};

#endif
