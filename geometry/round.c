/* Disc, cylinder, cone and paraboloid: n >= 24 straight segments around.
 *
 * A polygon inside the circle has too little area. The radius is scaled so that what matters is
 * exact: r' = r sqrt(2 pi / (n sin(2 pi / n))) makes the area of a disc pi r^2; for a cylinder and
 * a cone the lateral area is made that of the round body. With k the scale, s = sin(pi/n), c =
 * cos(pi/n), R + r and R - r sum and difference of the end radii, the n plane trapezoids have area
 * n k s (R + r) sqrt(h^2 + k^2 (R - r)^2 c^2), the round frustum pi (R + r) sqrt(h^2 + (R-r)^2).
 * The caps then exceed pi r^2 by less than 0.6 % (n = 24), O(n^-2). The dish z = r^2 / (4 f) is
 * left inscribed: its area is too small by O(n^-2). */
#include "geometry/patch_impl.h"

#include "base/core/constants.h"
#include "geometry/steps_impl.h"

#define LEAST_SEGMENTS   24.0
#define LEAST_DISH_RINGS 6.0

/* Segments around a circle of this radius so that chords are at most `step`. */
static double segment_count(double radius, double step)
{
  if (step <= 0.0) return LEAST_SEGMENTS;
  return fmax(LEAST_SEGMENTS, ceil(2.0 * UM_PI * 1.01 * radius / step));
}

/* n vertices on a circle, the first at azimuth 0. */
static enum um_status add_ring(struct um_geometry_patch *patch, uint32_t n, double radius, double z)
{
  for (uint32_t i = 0; i < n; i++) {
    double angle = 2.0 * UM_PI * (double)i / (double)n;
    UM_TRY(um_geometry_patch_vertex(patch, um_vec3(radius * cos(angle), radius * sin(angle), z),
                                    NULL));
  }
  return UM_OK;
}

/* Triangles between an inner ring of na and an outer ring of nb vertices (both starting at azimuth
 * 0), front toward +z when seen with the inner ring inside; `flip` turns them. */
static enum um_status stitch(struct um_geometry_patch *patch, uint32_t a, uint32_t na, uint32_t b,
                             uint32_t nb, uint32_t group, bool flip)
{
  uint32_t i = 0, j = 0;
  while (i < na || j < nb) {
    uint32_t ai = a + i % na, bj = b + j % nb, third;
    /* step along the ring whose next vertex comes first; at a tie, alternately by ring */
    if (j < nb && (i == na || (uint64_t)(2 * j + 1) * na <= (uint64_t)(2 * i + 1) * nb)) {
      third = b + (j + 1) % nb;
      j++;
    } else {
      third = a + (i + 1) % na;
      i++;
    }
    UM_TRY(flip ? um_geometry_patch_facet(patch, ai, third, bj, group, 0)
                : um_geometry_patch_facet(patch, ai, bj, third, group, 0));
  }
  return UM_OK;
}

/* A cap of `rings` rings, outermost with n segments; z(r) = r^2 / (4 f), or z0 where f is infinite.
 */
static enum um_status add_cap(struct um_geometry_patch *patch, const char *name, double radius,
                              double z0, double focal_length, uint32_t n, uint32_t rings, bool flip)
{
  uint32_t group, inner, ninner = 0;
  UM_TRY(um_geometry_patch_group(patch, name, &group));
  UM_TRY(um_geometry_patch_vertex(patch, um_vec3(0, 0, z0), &inner));
  for (uint32_t k = 1; k <= rings; k++) {
    double r = k == rings ? radius : radius * (double)k / (double)rings;
    uint32_t count = k == rings ? n : (uint32_t)fmax(6.0, round((double)n * k / (double)rings));
    uint32_t ring = (uint32_t)patch->nvertex;
    UM_TRY(add_ring(patch, count, r, z0 + r * r / (4.0 * focal_length)));
    for (uint32_t i = 0; k == 1 && i < count; i++) {
      uint32_t u = ring + i, v = ring + (i + 1) % count;
      UM_TRY(um_geometry_patch_facet(patch, inner, flip ? v : u, flip ? u : v, group, 0));
    }
    if (k > 1) UM_TRY(stitch(patch, inner, ninner, ring, count, group, flip));
    inner = ring;
    ninner = count;
  }
  return UM_OK;
}

static enum um_status build_disc(const struct um_geometry_part_spec *spec,
                                 struct um_geometry_patch *patch)
{
  double step = spec->facet_size / sqrt(2.0), n = segment_count(spec->radius, step);
  double rings = um_geometry_step_count(1.01 * spec->radius, step, 1.0);
  UM_TRY(um_geometry_count_check(spec, patch->context, n * rings));
  double scale = sqrt(2.0 * UM_PI / (n * sin(2.0 * UM_PI / n)));
  return add_cap(patch, "disc", scale * spec->radius, 0.0, INFINITY, (uint32_t)n, (uint32_t)rings,
                 false);
}

static enum um_status build_paraboloid(const struct um_geometry_part_spec *spec,
                                       struct um_geometry_patch *patch)
{
  double step = spec->facet_size / sqrt(2.0), n = segment_count(spec->radius, step);
  double slope = spec->radius / (2.0 * spec->focal_length);
  double rings =
      um_geometry_step_count(spec->radius * sqrt(1.0 + slope * slope), step, LEAST_DISH_RINGS);
  UM_TRY(um_geometry_count_check(spec, patch->context, n * rings));
  return add_cap(patch, "dish", spec->radius, 0.0, spec->focal_length, (uint32_t)n, (uint32_t)rings,
                 false);
}

/* Scale k of both end radii that makes the lateral area exact; a = k^2 solves
 * n^2 s^2 a (h^2 + a (R - r)^2 c^2) = pi^2 (h^2 + (R - r)^2). */
static double lateral_scale(double difference, double h, double n)
{
  double s = n * sin(UM_PI / n), c = cos(UM_PI / n), d2 = difference * difference;
  double quadratic = s * s * d2 * c * c, linear = s * s * h * h;
  double constant = UM_PI * UM_PI * (h * h + d2);
  return sqrt(2.0 * constant / (linear + sqrt(linear * linear + 4.0 * quadratic * constant)));
}

/* Rows of the side between the bottom and top radius; a top radius of 0 is one apex vertex. */
static enum um_status add_side(struct um_geometry_patch *patch, double bottom, double top, double h,
                               uint32_t n, uint32_t rows)
{
  uint32_t group, below = 0;
  UM_TRY(um_geometry_patch_group(patch, "side", &group));
  for (uint32_t j = 0; j <= rows; j++) {
    double t = (double)j / (double)rows, r = j == rows ? top : bottom + t * (top - bottom);
    double z = j == rows ? 0.5 * h : h * (t - 0.5);
    uint32_t ring = (uint32_t)patch->nvertex;
    UM_TRY(add_ring(patch, r > 0.0 ? n : 1, r, z));
    for (uint32_t i = 0; j > 0 && i < n; i++) {
      uint32_t a = below + i, b = below + (i + 1) % n, d = ring + i, c = ring + (i + 1) % n;
      if (r > 0.0) {
        UM_TRY(um_geometry_patch_facet(patch, a, b, c, group, 0));
        UM_TRY(um_geometry_patch_facet(patch, a, c, d, group, 0));
      } else {
        UM_TRY(um_geometry_patch_facet(patch, a, b, ring, group, 0));
      }
    }
    below = ring;
  }
  return UM_OK;
}

static enum um_status build_frustum(const struct um_geometry_part_spec *spec, double bottom,
                                    double top, struct um_geometry_patch *patch)
{
  double step = spec->facet_size / sqrt(2.0), h = spec->height;
  double n = segment_count(fmax(bottom, top), step);
  double slant = sqrt(h * h + (bottom - top) * (bottom - top));
  double rows = um_geometry_step_count(1.01 * slant, step, 1.0);
  double k = lateral_scale(bottom - top, h, n);
  double rings_bottom = um_geometry_step_count(1.01 * bottom, step, 1.0);
  double rings_top = um_geometry_step_count(1.01 * top, step, 1.0);
  UM_TRY(um_geometry_count_check(spec, patch->context,
                                 2.0 * n * rows + n * (rings_bottom + rings_top)));
  UM_TRY(add_side(patch, k * bottom, k * top, h, (uint32_t)n, (uint32_t)rows));
  if (top > 0.0)
    UM_TRY(
        add_cap(patch, "top", k * top, 0.5 * h, INFINITY, (uint32_t)n, (uint32_t)rings_top, false));
  return add_cap(patch, "bottom", k * bottom, -0.5 * h, INFINITY, (uint32_t)n,
                 (uint32_t)rings_bottom, true);
}

enum um_status um_geometry_round_build(const struct um_geometry_part_spec *spec,
                                       struct um_geometry_patch *patch)
{
  switch (spec->shape) {
  case UM_SHAPE_DISC:
    return build_disc(spec, patch);
  case UM_SHAPE_CYLINDER:
    return build_frustum(spec, spec->radius, spec->radius, patch);
  case UM_SHAPE_CONE:
    return build_frustum(spec, spec->radius, spec->radius_top, patch);
  default:
    return build_paraboloid(spec, patch);
  }
}
