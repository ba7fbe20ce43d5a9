/* The orthographic camera of pictures. */
#include "optics/image/camera_impl.h"

#include <math.h>

#define MARGIN 0.03 /* of the body's larger extent, on each side */

enum um_status um_optics_camera_create(struct um_context *context, int width,
                                       struct um_vec3 up_gcrs, const struct um_geometry_mesh *mesh,
                                       const struct um_geometry_pose *pose, struct um_quat q,
                                       struct um_vec3 toward, struct um_optics_camera *camera)
{
  struct um_vec3 up = um_quat_apply(q, up_gcrs);
  up = um_vec3_axpy(up, -um_vec3_dot(up, toward), toward);
  if (!(um_vec3_norm(up) > 1e-6 * um_vec3_norm(up_gcrs)))
    return um_core_fail(context, UM_ERR_INPUT,
                        "image: the upward direction lies along the line of sight");
  camera->toward = toward;
  camera->up = um_vec3_unit(up);
  camera->right = um_vec3_cross(camera->up, toward);
  double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
  for (size_t i = 0; i < mesh->nvertex; i++) {
    struct um_vec3 v = pose->vertex[i];
    double at[3] = {um_vec3_dot(v, camera->right), um_vec3_dot(v, camera->up),
                    um_vec3_dot(v, toward)};
    for (int k = 0; k < 3; k++) {
      low[k] = fmin(low[k], at[k]);
      high[k] = fmax(high[k], at[k]);
    }
  }
  double size_x = high[0] - low[0], size_y = high[1] - low[1];
  double margin = MARGIN * fmax(size_x, size_y);
  if (!(margin > 0.0)) return um_core_fail(context, UM_ERR_INPUT, "image: the body has no extent");
  camera->width = width;
  camera->pixel_size = (size_x + 2.0 * margin) / width;
  double rows = ceil((size_y + 2.0 * margin) / camera->pixel_size);
  if (!(rows <= UM_OPTICS_CAMERA_LINES))
    return um_core_fail(context, UM_ERR_INPUT, "image: %g rows for width %d; accepted: up to %d",
                        rows, width, UM_OPTICS_CAMERA_LINES);
  camera->height = (int)rows;
  /* centred; in front of everything by the body's own extent */
  double left = 0.5 * (low[0] + high[0]) - 0.5 * camera->width * camera->pixel_size;
  double top = 0.5 * (low[1] + high[1]) + 0.5 * camera->height * camera->pixel_size;
  camera->corner = um_vec3_scale(camera->right, left);
  camera->corner = um_vec3_axpy(camera->corner, top, camera->up);
  camera->corner = um_vec3_axpy(camera->corner, high[2] + 10.0 * margin, toward);
  return UM_OK;
}

struct um_geometry_ray um_optics_camera_ray(const struct um_optics_camera *camera, double x,
                                            double y)
{
  struct um_vec3 p = um_vec3_axpy(camera->corner, x * camera->pixel_size, camera->right);
  p = um_vec3_axpy(p, -y * camera->pixel_size, camera->up);
  return (struct um_geometry_ray){p, um_vec3_scale(camera->toward, -1.0), INFINITY,
                                  UM_GEOMETRY_NONE};
}
