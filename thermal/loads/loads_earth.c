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

/* One number of each surface, or of each of four directions. */
typedef double lanes __attribute__((vector_size(LANES * sizeof(double)), aligned(sizeof(double))));

static void along_set(struct um_thermal_cap *cap, int which, size_t i, struct um_vec3 d)
{
  cap->along[which][0][i] = d.x;
  cap->along[which][1][i] = d.y;
  cap->along[which][2][i] = d.z;
}

void um_irradiation_cap_spread(struct um_thermal_cap *cap, const uint16_t *cell)
{
  for (size_t i = 0; i < cap->n; i++) {
    struct um_vec3 across, along, d = cap->point[i].direction;
    along_set(cap, 0, i, d);
    if (cell == NULL) continue;
    um_core_vec3_frame(d, &across, &along);
    double a = 0.25 * sqrt(cap->point[i].solid_angle);
    for (int j = 0; j < 4; j++) {
      struct um_vec3 part = um_vec3_unit(
          um_vec3_axpy(um_vec3_axpy(d, j & 1 ? a : -a, across), j & 2 ? a : -a, along));
      along_set(cap, 1 + j, i, part);
      cap->cell[i][j] = cell[um_geometry_cube_cell(UM_IRRADIATION_CUBE_SIDE, part)];
    }
  }
}

/* Cosines to a normal of all directions of the cap, and of the four of each. */
struct cosines {
  double of[1 + 4][UM_EARTH_CAP_POINTS];
};

UM_WIDE_VECTORS static void cosines_of(const struct um_thermal_cap *cap, struct um_vec3 normal,
                                       bool four, struct cosines *out)
{
  for (int j = 0; j < (four ? 5 : 1); j++)
    for (size_t i = 0; i < cap->n; i++)
      out->of[j][i] = normal.x * cap->along[j][0][i] + normal.y * cap->along[j][1][i] +
                      normal.z * cap->along[j][2][i];
}

/* Which directions are before the normal, and which of their four. */
static void before(const struct um_thermal_cap *cap, const struct cosines *cosines, bool four,
                   struct um_thermal_half *out)
{
  static const double share[1 + 4] = {0.0, 1.0 / 255.0, 1.0 / 510.0, 1.0 / 765.0, 1.0 / 1020.0};
  size_t n = 0;
  for (size_t i = 0; i < cap->n; i++) {
    size_t ncell = 0;
    if (!(cosines->of[0][i] > 0.0)) continue;
    for (int j = 0; four && j < 4; j++) {
      out->cell[n][ncell] = cap->cell[i][j];
      ncell += cosines->of[1 + j][i] > 0.0;
    }
    out->point[n] = (uint16_t)i;
    out->cosine[n] = cosines->of[0][i];
    out->open[n] = cap->point[i].solid_angle;
    out->reflected[n] = cap->point[i].albedo_radiance;
    out->emitted[n] = cap->point[i].planet_radiance;
    out->ncell[n] = (uint8_t)ncell;
    out->unit[n++] = four ? share[ncell] : 1.0;
  }
  out->n = n;
  for (; n % 4 != 0; n++) out->cosine[n] = out->open[n] = out->reflected[n] = out->emitted[n] = 0.0;
}

/* Values from cosines, solid angles and radiances, and their sums, in four parts. */
UM_WIDE_VECTORS static void weigh(struct um_thermal_half *half)
{
  lanes planet = {0.0}, albedo = {0.0}, longwave = {0.0};
  for (size_t k = 0; k < half->n; k += LANES) {
    lanes open = *(const lanes *)&half->cosine[k] * *(const lanes *)&half->open[k];
    *(lanes *)&half->open[k] = open;
    planet += open;
    albedo += *(lanes *)&half->reflected[k] *= open;
    longwave += *(lanes *)&half->emitted[k] *= open;
  }
  half->planet = planet[0] + planet[1] + planet[2] + planet[3];
  half->albedo = albedo[0] + albedo[1] + albedo[2] + albedo[3];
  half->longwave = longwave[0] + longwave[1] + longwave[2] + longwave[3];
}

void um_irradiation_cap_halve(const struct um_thermal_cap *cap, struct um_vec3 normal, bool four,
                              bool by_angle, struct um_thermal_half *out)
{
  struct cosines cosines;
  out->by_angle = false;
  out->varies = cap->varies;
  cosines_of(cap, normal, four, &cosines);
  before(cap, &cosines, four, out);
  weigh(out);
  if (by_angle) um_irradiation_half_by_angle(out);
}

/* Sums of the four bytes of words, two by two: 16 bits hold 4 times 255. */
#define BYTES INT32_C(0x00ff00ff)

/* One word: surfaces of one block. */
static void look_at_word(const uint32_t *freedom, const struct um_thermal_half *half,
                         struct um_thermal_block *out)
{
  for (size_t k = 0; k < half->n; k++) {
    uint32_t even = 0, odd = 0;
    for (size_t j = 0; j < half->ncell[k]; j++) {
      const uint32_t *at = freedom + half->cell[k][j];
      __builtin_prefetch(at + UM_GEOMETRY_OPEN_CELLS);
      uint32_t four = *at;
      even += four & BYTES;
      odd += four >> 8 & BYTES;
    }
    const uint32_t sum[LANES] = {even & 0xffff, odd & 0xffff, even >> 16, odd >> 16};
    for (size_t l = 0; l < LANES; l++) out->of[k][l] = sum[l];
  }
}

typedef int32_t words
    __attribute__((vector_size(LANES * sizeof(int32_t)), aligned(sizeof(int32_t))));
_Static_assert(UM_IRRADIATION_BLOCKS == 4 && LANES == 4, "a byte of a word is of a block");

/* Words side by side: byte i of each is of block i. of: first word of a cell, [CELLS][n]. */
UM_WIDE_VECTORS static void look_at_words(const uint32_t *freedom, size_t n,
                                          const struct um_thermal_half *half,
                                          struct um_thermal_free *out)
{
  for (size_t k = 0; k < half->n; k++) {
    words even = {0}, odd = {0};
    for (size_t j = 0; j < half->ncell[k]; j++) {
      words four = *(const words *)(freedom + half->cell[k][j] * n);
      even += four & BYTES;
      odd += four >> 8 & BYTES;
    }
    *(lanes *)out->block[0].of[k] = __builtin_convertvector(even & 0xffff, lanes);
    *(lanes *)out->block[1].of[k] = __builtin_convertvector(odd & 0xffff, lanes);
    *(lanes *)out->block[2].of[k] = __builtin_convertvector(even >> 16, lanes);
    *(lanes *)out->block[3].of[k] = __builtin_convertvector(odd >> 16, lanes);
  }
}

void um_irradiation_look_at_sky(const struct um_irradiation_sky *sky, size_t class, size_t first,
                                const struct um_thermal_half *half, struct um_thermal_free *out)
{
  const uint32_t *freedom = sky->freedom + sky->word[class] * UM_GEOMETRY_OPEN_CELLS;
  size_t n = sky->word[class + 1] - sky->word[class];
  if (n > 1)
    look_at_words(freedom + first / UM_IRRADIATION_BLOCKS, n, half, out);
  else
    look_at_word(freedom, half, &out->block[0]);
}

void um_irradiation_look_by_rays(const struct um_geometry_mesh *mesh,
                                 const struct um_thermal_scene *scene, size_t surface,
                                 const struct um_thermal_cap *cap,
                                 const struct um_thermal_half *half, size_t lane,
                                 struct um_thermal_block *out)
{
  struct um_geometry_ray ray[CAP_RAYS * UM_EARTH_CAP_POINTS];
  uint8_t occluded[CAP_RAYS * UM_EARTH_CAP_POINTS];
  uint32_t facet = mesh->surface[surface].facet;
  const uint32_t *v = mesh->corner[facet];
  size_t n = 0;
  for (size_t k = 0; k < half->n; k++) {
    size_t i = half->point[k];
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

/* Sums over the directions of the half of what is free, times a value, and by angle. */
struct sums {
  lanes sum, moment[UM_ANGULAR_MOMENTS];
};

/* value: [n of the half]. */
UM_WIDE_VECTORS static void add_up(const struct um_thermal_half *half,
                                   const struct um_thermal_block *free_of, const double *value,
                                   bool by_angle, struct sums *out)
{
  lanes sum = {0.0}, m0 = {0.0}, m1 = {0.0}, m2 = {0.0}, m3 = {0.0}, m4 = {0.0};
  for (size_t k = 0; k < half->n; k++) {
    lanes part = *(const lanes *)free_of->of[k] * (half->unit[k] * value[k]);
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
                               const struct um_thermal_block *free_of,
                               struct um_thermal_shares out[LANES])
{
  struct sums open, reflected = {{0.0}, {{0.0}}}, emitted = reflected;
  add_up(half, free_of, half->open, half->by_angle && !half->varies, &open);
  if (half->albedo > 0.0) add_up(half, free_of, half->reflected, half->by_angle, &reflected);
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
