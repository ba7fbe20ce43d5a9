/* A pose with its ray-tracing scene. Private to the rooms of optics/. */
#ifndef UMBRA_OPTICS_POSED_SCENE_GROUP_H
#define UMBRA_OPTICS_POSED_SCENE_GROUP_H

#include "optics/radiance/optics.h"

struct um_optics_exchange; /* paths_impl.h */

struct um_optics_posed_scene {
  double *angle; /* [njoint] [rad] */
  struct um_geometry_pose *pose;
  struct um_geometry_visibility *visibility;
  struct um_optics_exchange *exchange; /* NULL unless inter-reflection is wanted */
};

#endif
