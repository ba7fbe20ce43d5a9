/* What share of the visible Earth a surface sees past the satellite itself:
 *
 *   share = sum(w L cos free) / sum(w L cos)   over the directions of the cap, w [sr], L [W/m^2/sr]
 *
 * free comes from the sky of a rigid body, or from rays where joints move. */
#include "core/sampling.h"
#include "thermal/loads_impl.h"

#define CAP_RAYS 2 /* per direction of the cap where joints move */

void um_thermal_cap_spread(struct um_thermal_cap *cap)
{
  for (size_t i = 0; i < cap->n; i++) {
    struct um_vec3 across, along, d = cap->point[i].direction;
    um_core_vec3_frame(d, &across, &along);
    double a = 0.25 * sqrt(cap->point[i].solid_angle);
    for (int j = 0; j < 4; j++)
      cap->four[i][j] = um_vec3_unit(
          um_vec3_axpy(um_vec3_axpy(d, j & 1 ? a : -a, across), j & 2 ? a : -a, along));
  }
}

/* How free the directions of the cap are from a surface, by the sky of a rigid body. */
static void look_at_sky(const struct um_thermal_scene *scene, size_t surface, struct um_vec3 normal,
                        const struct um_thermal_cap *cap, double *free_of)
{
  for (size_t i = 0; i < cap->n; i++) {
    double sum = 0.0, n = 0.0;
    for (int j = 0; j < 4; j++) {
      if (!(um_vec3_dot(cap->four[i][j], normal) > 0.0)) continue;
      sum += um_geometry_sky_free(scene->sky, surface, cap->four[i][j]);
      n += 1.0;
    }
    free_of[i] = n > 0.0 ? sum / n : 0.0;
  }
}

/* The same by rays, each from a point of the facet of its own. */
static void look_by_rays(const struct um_geometry_mesh *mesh, const struct um_thermal_scene *scene,
                         size_t surface, struct um_vec3 normal, const struct um_thermal_cap *cap,
                         double *free_of)
{
  struct um_geometry_ray ray[CAP_RAYS * UM_EARTH_CAP_POINTS];
  uint8_t occluded[CAP_RAYS * UM_EARTH_CAP_POINTS];
  uint32_t facet = mesh->surface[surface].facet;
  const uint32_t *v = mesh->corner[facet];
  size_t n = 0;
  for (size_t i = 0; i < cap->n; i++) {
    if (!(um_vec3_dot(normal, cap->point[i].direction) > 0.0)) continue;
    for (size_t j = 0; j < CAP_RAYS; j++, n++) {
      double u[2], weight[3];
      um_core_sample_2d(facet, i * CAP_RAYS + j, u);
      um_core_sample_triangle(u, weight);
      struct um_vec3 origin = um_vec3(0, 0, 0);
      for (int c = 0; c < 3; c++)
        origin = um_vec3_axpy(origin, weight[c], scene->pose->vertex[v[c]]);
      ray[n] = (struct um_geometry_ray){origin, cap->point[i].direction, INFINITY, facet};
    }
  }
  um_geometry_visibility_occluded(scene->visibility, ray, n, occluded);
  n = 0;
  for (size_t i = 0; i < cap->n; i++) {
    free_of[i] = 0.0;
    if (!(um_vec3_dot(normal, cap->point[i].direction) > 0.0)) continue;
    for (size_t j = 0; j < CAP_RAYS; j++) free_of[i] += (1.0 - occluded[n++]) / CAP_RAYS;
  }
}

/* Free shares of the cap before a surface, for the reflected and for the emitted part. */
void um_thermal_cap_shares(const struct um_geometry_mesh *mesh,
                           const struct um_thermal_scene *scene, size_t surface,
                           struct um_vec3 normal, const struct um_thermal_cap *cap, double *albedo,
                           double *planet)
{
  double all[2] = {0.0, 0.0}, open[2] = {0.0, 0.0}, free_of[UM_EARTH_CAP_POINTS] = {0.0};
  if (scene->sky != NULL)
    look_at_sky(scene, surface, normal, cap, free_of);
  else
    look_by_rays(mesh, scene, surface, normal, cap, free_of);
  for (size_t i = 0; i < cap->n; i++) {
    double cosine = um_vec3_dot(normal, cap->point[i].direction);
    if (!(cosine > 0.0)) continue;
    double w = cosine * cap->point[i].solid_angle;
    all[0] += w * cap->point[i].albedo_radiance;
    open[0] += free_of[i] * w * cap->point[i].albedo_radiance;
    all[1] += w;
    open[1] += free_of[i] * w;
  }
  *planet = all[1] > 0.0 ? open[1] / all[1] : 1.0;
  *albedo = all[0] > 0.0 ? open[0] / all[0] : *planet;
}
