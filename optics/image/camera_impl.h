/* The orthographic camera of pictures: where it stands and the rays of its pixels. */
#ifndef UMBRA_OPTICS_CAMERA_IMPL_H
#define UMBRA_OPTICS_CAMERA_IMPL_H

#include "geometry/visibility.h"

#define UM_OPTICS_CAMERA_LINES 16384 /* at most */

struct um_optics_camera {
  struct um_vec3 right, up, toward; /* unit, body frame; toward the observer */
  struct um_vec3 corner;            /* upper left corner of the picture, before the body [m] */
  int width, height;
  double pixel_size; /* [m] */
};

/* The whole body with a margin, `width` pixels across, up_gcrs pointing up; q: GCRS to body;
 * toward: to the observer, body frame. UM_ERR_INPUT: up along the line of sight, a body without
 * extent, too many lines. */
enum um_status um_optics_camera_create(struct um_context *context, int width,
                                       struct um_vec3 up_gcrs, const struct um_geometry_mesh *mesh,
                                       const struct um_geometry_pose *pose, struct um_quat q,
                                       struct um_vec3 toward, struct um_optics_camera *camera);
/* Ray through the point (x, y) of the picture [pixels], y downward. */
struct um_geometry_ray um_optics_camera_ray(const struct um_optics_camera *camera, double x,
                                            double y);

#endif
