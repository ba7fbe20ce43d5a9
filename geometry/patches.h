/* Surfaces gathered into patches: the unit in which surfaces of a satellite see and heat each
 * other. A patch has surfaces of one part, group and side, and so of one material. */
#ifndef UMBRA_GEOMETRY_PATCHES_H
#define UMBRA_GEOMETRY_PATCHES_H

#include "geometry/geometry.h"

/* More than this are refused: their exchange may be a full matrix. */
#define UM_GEOMETRY_PATCHES_MAX 8192

struct um_geometry_patches {
  size_t nsurface, npatch;
  uint32_t *patch;   /* [nsurface] UM_GEOMETRY_NONE: nothing of the satellite stands before it */
  uint32_t *surface; /* [nmember] surfaces by patch */
  size_t *begin;     /* [npatch + 1] first of a patch in `surface` */
  double *area;      /* [npatch] [m^2] */
};

/* Patches of one side of a group follow each other. seen: [nsurface], share of a surface's view
 * that other surfaces of the satellite may take; negative where nothing stands before it. As many
 * patches as there are surfaces with something before them, or `limit` where those are more: groups
 * are then halved across their longest edge, in the pose, first where edge times area times share
 * seen is largest. A side of a group is one patch at least, so that there may be more than `limit`.
 * UM_ERR_INPUT above UM_GEOMETRY_PATCHES_MAX. The caller destroys. */
enum um_status um_geometry_patches_create(struct um_context *context,
                                          const struct um_geometry_mesh *mesh,
                                          const struct um_geometry_pose *pose, const double *seen,
                                          size_t limit, struct um_geometry_patches **out);
void um_geometry_patches_destroy(struct um_context *context, struct um_geometry_patches **patches);

#endif
