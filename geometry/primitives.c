/* Box, plate and sphere. Flat sides are regular grids of right triangles whose longest edge, the
 * diagonal of a cell, is at most the facet size; cells of neighbouring sides match.
 *
 * Sphere: each face of an icosahedron in f^2 triangles, pushed out to the sphere (geodesic class I,
 * Kenner 1976), f >= 4; then scaled by sqrt(4 pi r^2 / A), A being the area of its facets, so that
 * emitting and absorbing area are exact. Its projected area is too small by O(h^2). */
#include "geometry/patch_impl.h"

#include "base/core/constants.h"
#include "geometry/geometry_impl.h"
#include "geometry/steps_impl.h"

/* Grid of nu x nv cells from `corner` along u and v (full sides); front toward u x v. */
static enum um_status add_grid(struct um_geometry_patch *patch, const char *name,
                               struct um_vec3 corner, struct um_vec3 u, struct um_vec3 v, size_t nu,
                               size_t nv)
{
  uint32_t group, first = (uint32_t)patch->nvertex;
  UM_TRY(um_geometry_patch_group(patch, name, &group));
  for (size_t j = 0; j <= nv; j++)
    for (size_t i = 0; i <= nu; i++) {
      /* the last row and column hit the far sides exactly, so that sides weld */
      double s = i == nu ? 1.0 : (double)i / (double)nu, t = j == nv ? 1.0 : (double)j / (double)nv;
      UM_TRY(um_geometry_patch_vertex(patch, um_vec3_axpy(um_vec3_axpy(corner, s, u), t, v), NULL));
    }
  uint32_t row = (uint32_t)nu + 1;
  for (uint32_t j = 0; j < nv; j++)
    for (uint32_t i = 0; i < nu; i++) {
      uint32_t a = first + j * row + i, b = a + 1, c = b + row, d = a + row;
      UM_TRY(um_geometry_patch_facet(patch, a, b, c, group, 0));
      UM_TRY(um_geometry_patch_facet(patch, a, c, d, group, 0));
    }
  return UM_OK;
}

static enum um_status build_box(const struct um_geometry_part_spec *spec,
                                struct um_geometry_patch *patch)
{
  const double *size = spec->size, step = spec->facet_size / sqrt(2.0);
  double count[3];
  for (int k = 0; k < 3; k++) count[k] = um_geometry_step_count(size[k], step, 1.0);
  UM_TRY(um_geometry_count_check(
      spec, patch->context,
      4.0 * (count[0] * count[1] + count[1] * count[2] + count[2] * count[0])));
  size_t nx = (size_t)count[0], ny = (size_t)count[1], nz = (size_t)count[2];
  double x = 0.5 * size[0], y = 0.5 * size[1], z = 0.5 * size[2];
  struct um_vec3 ex = um_vec3(2 * x, 0, 0), ey = um_vec3(0, 2 * y, 0), ez = um_vec3(0, 0, 2 * z);
  UM_TRY(add_grid(patch, "+x", um_vec3(x, -y, -z), ey, ez, ny, nz));
  UM_TRY(add_grid(patch, "-x", um_vec3(-x, -y, -z), ez, ey, nz, ny));
  UM_TRY(add_grid(patch, "+y", um_vec3(-x, y, -z), ez, ex, nz, nx));
  UM_TRY(add_grid(patch, "-y", um_vec3(-x, -y, -z), ex, ez, nx, nz));
  UM_TRY(add_grid(patch, "+z", um_vec3(-x, -y, z), ex, ey, nx, ny));
  return add_grid(patch, "-z", um_vec3(-x, -y, -z), ey, ex, ny, nx);
}

static enum um_status build_plate(const struct um_geometry_part_spec *spec,
                                  struct um_geometry_patch *patch)
{
  double x = spec->size[0], y = spec->size[1], step = spec->facet_size / sqrt(2.0);
  double nx = um_geometry_step_count(x, step, 1.0), ny = um_geometry_step_count(y, step, 1.0);
  UM_TRY(um_geometry_count_check(spec, patch->context, 2.0 * nx * ny));
  return add_grid(patch, "plate", um_vec3(-0.5 * x, -0.5 * y, 0), um_vec3(x, 0, 0),
                  um_vec3(0, y, 0), (size_t)nx, (size_t)ny);
}

/* Vertices (0, +-1, +-g) and cyclic, g the golden ratio, on the unit sphere. */
static void icosahedron_vertices(struct um_vec3 vertex[12])
{
  const double g = 0.5 * (1.0 + sqrt(5.0));
  int n = 0;
  for (int axis = 0; axis < 3; axis++)
    for (int s = -1; s <= 1; s += 2)
      for (int t = -1; t <= 1; t += 2) {
        double p[3] = {0, 0, 0};
        p[(axis + 1) % 3] = s;
        p[(axis + 2) % 3] = t * g;
        vertex[n++] = um_vec3_unit(um_vec3(p[0], p[1], p[2]));
      }
}

/* The 20 faces are the triples of vertices at the edge's distance 4 / sqrt(10 + 2 sqrt(5));
 * counter-clockwise from outside. */
static void icosahedron_faces(const struct um_vec3 vertex[12], struct um_vec3 face[20][3])
{
  const double edge = 4.0 / sqrt(10.0 + 2.0 * sqrt(5.0));
  int n = 0;
  for (int i = 0; i < 12; i++)
    for (int j = i + 1; j < 12; j++)
      for (int k = j + 1; k < 12; k++) {
        struct um_vec3 ij = um_vec3_sub(vertex[j], vertex[i]),
                       ik = um_vec3_sub(vertex[k], vertex[i]);
        struct um_vec3 jk = um_vec3_sub(vertex[k], vertex[j]);
        double far = fmax(um_vec3_norm(ij), fmax(um_vec3_norm(ik), um_vec3_norm(jk)));
        if (far > 1.01 * edge || n == 20) continue;
        bool outward = um_vec3_dot(um_vec3_cross(ij, ik), vertex[i]) > 0.0;
        face[n][0] = vertex[i];
        face[n][1] = outward ? vertex[j] : vertex[k];
        face[n++][2] = outward ? vertex[k] : vertex[j];
      }
}

/* Longest edge of the unit icosphere of frequency f: it lies in the middle of a face. */
static double longest_edge(const struct um_vec3 face[3], size_t f)
{
  struct um_vec3 a = face[0], b = face[1], c = face[2];
  double longest = 0.0;
  for (size_t j = 0; j < f; j++)
    for (size_t i = 0; i + j < f; i++) {
      double u = (double)i / (double)f, v = (double)j / (double)f, d = 1.0 / (double)f;
      struct um_vec3 ab = um_vec3_sub(b, a), ac = um_vec3_sub(c, a);
      struct um_vec3 p = um_vec3_unit(um_vec3_axpy(um_vec3_axpy(a, u, ab), v, ac));
      struct um_vec3 q = um_vec3_unit(um_vec3_axpy(um_vec3_axpy(a, u + d, ab), v, ac));
      longest = fmax(longest, um_vec3_norm(um_vec3_sub(q, p)));
    }
  return longest;
}

/* A face in f^2 triangles on the unit sphere. */
static enum um_status add_face(struct um_geometry_patch *patch, const struct um_vec3 corner[3],
                               uint32_t f, uint32_t group)
{
  uint32_t row = (uint32_t)patch->nvertex;
  for (uint32_t j = 0; j <= f; j++)
    for (uint32_t i = 0; i + j <= f; i++) {
      struct um_vec3 p = um_vec3_scale(corner[0], (double)(f - i - j));
      p = um_vec3_axpy(um_vec3_axpy(p, (double)i, corner[1]), (double)j, corner[2]);
      UM_TRY(um_geometry_patch_vertex(patch, um_vec3_unit(p), NULL));
    }
  for (uint32_t j = 0; j < f; j++) {
    uint32_t next = row + f - j + 1;
    for (uint32_t i = 0; i + j < f; i++) {
      UM_TRY(um_geometry_patch_facet(patch, row + i, row + i + 1, next + i, group, 0));
      if (i + j + 1 < f)
        UM_TRY(um_geometry_patch_facet(patch, row + i + 1, next + i + 1, next + i, group, 0));
    }
    row = next;
  }
  return UM_OK;
}

static enum um_status build_sphere(const struct um_geometry_part_spec *spec,
                                   struct um_geometry_patch *patch)
{
  struct um_vec3 vertex[12], face[20][3];
  icosahedron_vertices(vertex);
  icosahedron_faces(vertex, face);
  size_t f = 4;
  if (spec->facet_size > 0.0) {
    /* edges of a face are about 1.23 r / f long */
    double ratio = spec->radius / spec->facet_size;
    UM_TRY(um_geometry_count_check(spec, patch->context, 20.0 * ratio * ratio));
    /* 1 % below, because the scaling to the exact area makes edges longer by at most 1 % */
    while (longest_edge(face[0], f) * spec->radius > 0.99 * spec->facet_size) f += 1 + f / 16;
  }
  UM_TRY(um_geometry_count_check(spec, patch->context, 20.0 * (double)(f * f)));
  uint32_t group;
  UM_TRY(um_geometry_patch_group(patch, "sphere", &group));
  for (int k = 0; k < 20; k++) UM_TRY(add_face(patch, face[k], (uint32_t)f, group));
  double area = 0.0;
  for (size_t i = 0; i < patch->nfacet; i++)
    area += 0.5 * um_vec3_norm(um_geometry_cross_of(patch->vertex, patch->corner[i]));
  double scale = spec->radius * sqrt(4.0 * UM_PI / area);
  for (size_t i = 0; i < patch->nvertex; i++)
    patch->vertex[i] = um_vec3_scale(patch->vertex[i], scale);
  return UM_OK;
}

enum um_status um_geometry_primitive_build(const struct um_geometry_part_spec *spec,
                                           struct um_geometry_patch *patch)
{
  switch (spec->shape) {
  case UM_SHAPE_BOX:
    return build_box(spec, patch);
  case UM_SHAPE_PLATE:
    return build_plate(spec, patch);
  case UM_SHAPE_SPHERE:
    return build_sphere(spec, patch);
  default:
    return um_geometry_round_build(spec, patch);
  }
}
