/* What share of the visible Earth a surface sees past the satellite itself:
 *
 *   share = sum(w L cos free) / sum(w L cos)   over the directions of the cap, w [sr], L [W/m^2/sr]
 *
 * free comes from the sky of a rigid body, or from rays where joints move. */
#include "base/core/sampling.h"
#include "base/core/wide.h"
#include "geometry/cube.h"
#include "thermal/loads/loads_impl.h"

#define CAP_RAYS 2 /* per direction of the cap where joints move */
#define LANES    UM_IRRADIATION_LANES

void um_irradiation_cap_spread(struct um_thermal_cap *cap)
{
  for (size_t i = 0; i < cap->n; i++) {
    struct um_vec3 across, along, d = cap->point[i].direction;
    um_core_vec3_frame(d, &across, &along);
    double a = 0.25 * sqrt(cap->point[i].solid_angle);
    for (int j = 0; j < 4; j++) {
      cap->four[i][j] = um_vec3_unit(
          um_vec3_axpy(um_vec3_axpy(d, j & 1 ? a : -a, across), j & 2 ? a : -a, along));
      cap->cell[i][j] = um_geometry_cube_cell(UM_IRRADIATION_CUBE_SIDE, cap->four[i][j]);
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
    out->cosine[k] = cosine;
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
  if (by_angle) um_irradiation_half_by_angle(out);
}

/* Sums of the four bytes of words, two by two: 16 bits hold 4 times 255. */
#define BYTES UINT32_C(0x00ff00ff)

/* freedom: of one group, [UM_IRRADIATION_CUBE_CELLS]. */
UM_WIDE_VECTORS static void look(const uint32_t *freedom, const struct um_thermal_half *half,
                                 struct um_thermal_free *out)
{
  for (size_t k = 0; k < half->n; k++) {
    uint32_t even = 0, odd = 0;
    for (size_t j = 0; j < half->ncell[k]; j++) {
      const uint32_t *at = freedom + half->cell[k][j];
      __builtin_prefetch(at + UM_IRRADIATION_CUBE_CELLS);
      uint32_t four = *at;
      even += four & BYTES;
      odd += four >> 8 & BYTES;
    }
    const uint32_t sum[LANES] = {even & 0xffff, odd & 0xffff, even >> 16, odd >> 16};
    double all = 255.0 * (double)half->ncell[k];
    for (size_t l = 0; l < LANES; l++) out->of[k][l] = all > 0.0 ? sum[l] / all : 0.0;
  }
}

void um_irradiation_look_at_sky(const struct um_irradiation_sky *sky, size_t group,
                                const struct um_thermal_half *half, struct um_thermal_free *out)
{
  look(sky->freedom + group * UM_IRRADIATION_CUBE_CELLS, half, out);
}

void um_irradiation_look_by_rays(const struct um_geometry_mesh *mesh,
                                 const struct um_thermal_scene *scene, size_t surface,
                                 struct um_vec3 normal, const struct um_thermal_cap *cap,
                                 size_t lane, struct um_thermal_free *out)
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
  for (size_t k = 0; k < n / CAP_RAYS; k++)
    for (size_t j = 0; j < CAP_RAYS; j++)
      out->of[k][lane] += (1.0 - occluded[k * CAP_RAYS + j]) / CAP_RAYS;
}

/* One number of each surface. */
typedef double lanes __attribute__((vector_size(LANES * sizeof(double)), aligned(sizeof(double))));

/* Sums over the directions of the half of what is free, times a value, and by angle. */
struct sums {
  lanes sum, moment[UM_ANGULAR_MOMENTS];
};

/* value: [n of the half]; NULL: 1. */
UM_WIDE_VECTORS static void add_up(const struct um_thermal_half *half,
                                   const struct um_thermal_free *free_of, const double *value,
                                   bool by_angle, struct sums *out)
{
  lanes sum = {0.0}, m0 = {0.0}, m1 = {0.0}, m2 = {0.0}, m3 = {0.0}, m4 = {0.0};
  for (size_t k = 0; k < half->n; k++) {
    lanes part = *(const lanes *)free_of->of[k] * half->weight[k];
    if (value != NULL) part *= value[k];
    sum += part;
    if (!by_angle) continue;
    m0 += part * half->polynomial[0][k];
    m1 += part * half->polynomial[1][k];
    m2 += part * half->polynomial[2][k];
    m3 += part * half->polynomial[3][k];
    m4 += part * half->polynomial[4][k];
  }
  *out = (struct sums){sum, {m0, m1, m2, m3, m4}};
}

/* Where the Earth emits uniformly, what is emitted has the share of the solid angle. */
void um_irradiation_cap_shares(const struct um_thermal_half *half,
                               const struct um_thermal_free *free_of,
                               struct um_thermal_shares out[LANES])
{
  struct sums open, reflected = {{0.0}, {{0.0}}}, emitted = reflected;
  add_up(half, free_of, NULL, half->by_angle && !half->varies, &open);
  if (half->albedo > 0.0) add_up(half, free_of, half->radiance, half->by_angle, &reflected);
  if (half->varies) add_up(half, free_of, half->emitted, half->by_angle, &emitted);
  for (size_t l = 0; l < LANES; l++) {
    struct um_thermal_shares *o = &out[l];
    double albedo[UM_ANGULAR_MOMENTS], planet[UM_ANGULAR_MOMENTS];
    o->view_factor = half->planet > 0.0 ? open.sum[l] / half->planet : 1.0;
    o->albedo = half->albedo > 0.0 ? reflected.sum[l] / half->albedo : o->view_factor;
    o->planet =
        half->varies && half->longwave > 0.0 ? emitted.sum[l] / half->longwave : o->view_factor;
    if (!half->by_angle) continue;
    for (size_t m = 0; m < UM_ANGULAR_MOMENTS; m++) {
      albedo[m] = reflected.moment[m][l];
      planet[m] = half->varies ? emitted.moment[m][l] : open.moment[m][l];
    }
    um_irradiation_shares_by_angle(half, albedo, planet, o);
  }
}
