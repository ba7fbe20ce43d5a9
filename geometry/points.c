/* Sample points of facets and of the Sun's disc.
 *
 * Sample k of a facet is element a + k of one sequence, a < 1024 being hashed from the facet: any
 * run of such a sequence is evenly spread, and most of it can be tabulated. Points of facets follow
 * R2 (steps 1/g, 1/g^2 with g^3 = g + 1), those of the disc a Kronecker sequence with the steps
 * sqrt 2 and sqrt 3 modulo 1. The four steps are independent over the rationals, so that pairs of
 * both fill the four-dimensional cube evenly (Weyl 1916); two R2 sequences, equal but for a shift,
 * would fill no more than a plane of it. */
#include "geometry/visibility_data_impl.h"

#include "base/core/sampling.h"

/* Keys of the hashes. */
#define KEY_POINT UINT64_C(0x706f696e74)
#define KEY_DISC  UINT64_C(0x64697363)

void um_geometry_points_second(uint64_t index, double out[2])
{
  /* sqrt 2 and sqrt 3 modulo 1 as 64-bit fractions: the product wraps exactly */
  const uint64_t step_x = UINT64_C(0x6a09e667f3bcc908), step_y = UINT64_C(0xbb67ae8584caa73b);
  out[0] = um_core_hash_uniform((index + 1) * step_x);
  out[1] = um_core_hash_uniform((index + 1) * step_y);
}

static void facet_weight(uint64_t index, double weight[2])
{
  double u[2], w[3];
  um_core_sample_2d(KEY_POINT, index, u);
  um_core_sample_triangle(u, w);
  weight[0] = w[1];
  weight[1] = w[2];
}

static void disc_point(uint64_t index, double xy[2])
{
  double u[2];
  um_geometry_points_second(index, u);
  um_core_sample_disc(u, xy);
}

void um_geometry_points_fill(struct um_geometry_visibility *visibility)
{
  for (uint64_t i = 0; i < 2 * UM_GEOMETRY_POINTS; i++) {
    facet_weight(i, visibility->weight[i]);
    disc_point(i, visibility->disc[i]);
  }
}

static uint64_t first_of(uint64_t seed, uint32_t facet)
{
  return um_core_hash(KEY_POINT + seed, facet) % UM_GEOMETRY_POINTS;
}

const double (*um_geometry_points_weights(const struct um_geometry_visibility *visibility,
                                          uint64_t seed, uint32_t facet))[2]
{
  return &visibility->weight[first_of(seed, facet)];
}

struct um_vec3 um_geometry_points_facet(const struct um_geometry_visibility *visibility,
                                        uint64_t seed, uint32_t facet, uint64_t sample)
{
  uint64_t index = first_of(seed, facet) + sample;
  double far[2];
  const double *w = far;
  if (index < 2 * UM_GEOMETRY_POINTS)
    w = visibility->weight[index];
  else
    facet_weight(index, far);
  const uint32_t *c = visibility->mesh->corner[facet];
  const struct um_vec3 *vertex = visibility->pose->vertex;
  struct um_vec3 a = vertex[c[0]];
  /* from corner a, so that points of a facet lie in its plane to the last place */
  struct um_vec3 p = um_vec3_axpy(a, w[0], um_vec3_sub(vertex[c[1]], a));
  return um_vec3_axpy(p, w[1], um_vec3_sub(vertex[c[2]], a));
}

void um_geometry_points_disc(const struct um_geometry_visibility *visibility, uint64_t seed,
                             uint32_t facet, uint64_t sample, double xy[2])
{
  uint64_t index = um_core_hash(KEY_DISC + seed, facet) % UM_GEOMETRY_POINTS + sample;
  if (index >= 2 * UM_GEOMETRY_POINTS) {
    disc_point(index, xy);
    return;
  }
  xy[0] = visibility->disc[index][0];
  xy[1] = visibility->disc[index][1];
}
