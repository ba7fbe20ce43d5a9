/* What share of the visible Earth a surface sees past the satellite itself:
 *
 *   share = sum(w L cos free) / sum(w L cos)   over the directions of the cap, w [sr], L [W/m^2/sr]
 *
 * free comes from the sky of a rigid body, or from rays where joints move. */
#include "core/sampling.h"
#include "geometry/cube.h"
#include "irradiation/loads_impl.h"

#define CAP_RAYS 2 /* per direction of the cap where joints move */

enum um_status um_irradiation_scene_tabulate(struct um_context *context,
                                             const struct um_geometry_mesh *mesh, int nsample,
                                             struct um_thermal_scene *scene)
{
  struct um_geometry_sky *sky = NULL;
  struct um_vec3 *direction = NULL;
  size_t covered = 0;
  for (size_t s = 0; s < mesh->nsurface; s++)
    covered += !um_geometry_visibility_is_open(scene->visibility, s);
  if (covered == 0) return UM_OK;
  enum um_status status;
  UM_CHECK(um_geometry_sky_create(context, scene->visibility, nsample, &sky));
  UM_CHECK(um_core_allocate(context, UM_THERMAL_CUBE_CELLS, sizeof *direction, &direction));
  UM_CHECK(um_core_allocate(context, mesh->nsurface, sizeof *scene->row, &scene->row));
  UM_CHECK(um_core_allocate(context, covered, UM_THERMAL_CUBE_CELLS, &scene->freedom));
  for (size_t cell = 0; cell < UM_THERMAL_CUBE_CELLS; cell++)
    direction[cell] = um_geometry_cube_direction(UM_THERMAL_CUBE_SIDE, cell, 0.5, 0.5);
  covered = 0;
  for (size_t s = 0; s < mesh->nsurface; s++)
    scene->row[s] = um_geometry_visibility_is_open(scene->visibility, s)
                        ? SIZE_MAX
                        : UM_THERMAL_CUBE_CELLS * covered++;
  long nsurface = (long)mesh->nsurface;
#pragma omp parallel for schedule(static) num_threads(um_core_context_threads(context))
  for (long s = 0; s < nsurface; s++)
    for (size_t cell = 0; cell < UM_THERMAL_CUBE_CELLS && scene->row[s] != SIZE_MAX; cell++) {
      double f = um_geometry_sky_free(sky, (size_t)s, direction[cell]);
      scene->freedom[scene->row[s] + cell] = (uint8_t)lround(255.0 * f);
    }
done:
  um_core_free(context, direction);
  um_geometry_sky_destroy(&sky);
  return status;
}

void um_irradiation_cap_spread(struct um_thermal_cap *cap)
{
  for (size_t i = 0; i < cap->n; i++) {
    struct um_vec3 across, along, d = cap->point[i].direction;
    um_core_vec3_frame(d, &across, &along);
    double a = 0.25 * sqrt(cap->point[i].solid_angle);
    for (int j = 0; j < 4; j++) {
      cap->four[i][j] = um_vec3_unit(
          um_vec3_axpy(um_vec3_axpy(d, j & 1 ? a : -a, across), j & 2 ? a : -a, along));
      cap->cell[i][j] = um_geometry_cube_cell(UM_THERMAL_CUBE_SIDE, cap->four[i][j]);
    }
  }
}

void um_irradiation_cap_halve(const struct um_thermal_cap *cap, struct um_vec3 normal, bool four,
                              bool by_angle, struct um_thermal_half *out)
{
  out->n = 0;
  out->by_angle = false;
  out->albedo = out->planet = out->longwave = 0.0;
  out->varies = cap->varies;
  for (size_t i = 0; i < cap->n; i++) {
    double cosine = um_vec3_dot(normal, cap->point[i].direction);
    if (!(cosine > 0.0)) continue;
    size_t k = out->n++;
    out->weight[k] = cosine * cap->point[i].solid_angle;
    out->radiance[k] = cap->point[i].albedo_radiance;
    out->albedo += out->weight[k] * out->radiance[k];
    out->planet += out->weight[k];
    out->emitted[k] = cap->point[i].planet_radiance;
    out->longwave += out->weight[k] * out->emitted[k];
    out->ncell[k] = 0;
    for (int j = 0; four && j < 4; j++)
      if (um_vec3_dot(cap->four[i][j], normal) > 0.0)
        out->cell[k][out->ncell[k]++] = (uint16_t)cap->cell[i][j];
  }
  if (by_angle) um_irradiation_half_by_angle(cap, normal, out);
}

/* How free the directions of the half are from a surface, by the sky of a rigid body. */
static void look_at_sky(const struct um_thermal_scene *scene, size_t surface,
                        const struct um_thermal_half *half, double *free_of)
{
  const uint8_t *freedom = scene->freedom + scene->row[surface];
  for (size_t k = 0; k < half->n; k++) {
    int sum = 0;
    for (size_t j = 0; j < half->ncell[k]; j++) sum += freedom[half->cell[k][j]];
    free_of[k] = half->ncell[k] > 0 ? sum / (255.0 * (double)half->ncell[k]) : 0.0;
  }
}

/* The same by rays, each from a point of the facet of its own. The directions are those of the
 * half, in its order. */
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
  if (n == 0) return;
  um_geometry_visibility_occluded(scene->visibility, ray, n, occluded);
  for (size_t k = 0; k < n / CAP_RAYS; k++) {
    free_of[k] = 0.0;
    for (size_t j = 0; j < CAP_RAYS; j++)
      free_of[k] += (1.0 - occluded[k * CAP_RAYS + j]) / CAP_RAYS;
  }
}

/* Free shares of the cap before a surface. Where all of it emits alike, what is emitted has the
 * share of the solid angle. */
void um_irradiation_cap_shares(const struct um_geometry_mesh *mesh,
                               const struct um_thermal_scene *scene, size_t surface,
                               struct um_vec3 normal, const struct um_thermal_cap *cap,
                               const struct um_thermal_half *half, struct um_thermal_shares *out)
{
  double open[3] = {0.0, 0.0, 0.0}, free_of[UM_EARTH_CAP_POINTS];
  if (scene->row != NULL)
    look_at_sky(scene, surface, half, free_of);
  else
    look_by_rays(mesh, scene, surface, normal, cap, free_of);
  for (size_t k = 0; k < half->n; k++) {
    open[0] += free_of[k] * half->weight[k] * half->radiance[k];
    open[1] += free_of[k] * half->weight[k];
    open[2] += free_of[k] * half->weight[k] * half->emitted[k];
  }
  out->view_factor = half->planet > 0.0 ? open[1] / half->planet : 1.0;
  out->albedo = half->albedo > 0.0 ? open[0] / half->albedo : out->view_factor;
  out->planet = half->varies && half->longwave > 0.0 ? open[2] / half->longwave : out->view_factor;
  if (half->by_angle) um_irradiation_shares_by_angle(half, free_of, out);
}
