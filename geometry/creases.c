/* Tilted patches: a facet cut by the squares of its plane. */
#include "geometry/creases.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "geometry/geometry_impl.h"

#define CORNERS     8    /* of a triangle cut by a square: 3 + 4 at most */
#define SAME_NORMAL 1e-4 /* planes are one where normals differ by less [1] */
#define SAME_PLANE  1e-3 /* and distances by less [m] */
#define SMALLEST    1e-9 /* of a facet, below which a piece is dropped [1] */

/* A convex polygon in the plane, in units of the patch. */
struct piece {
  double x[CORNERS], y[CORNERS];
  int n;
};

static double area_of(const struct piece *p)
{
  double twice = 0.0;
  for (int i = 1; i + 1 < p->n; i++)
    twice += (p->x[i] - p->x[0]) * (p->y[i + 1] - p->y[0]) -
             (p->x[i + 1] - p->x[0]) * (p->y[i] - p->y[0]);
  return 0.5 * fabs(twice);
}

/* What of it has sign (u - at) >= 0, u its x or its y (Sutherland & Hodgman 1974). */
static struct piece cut(const struct piece *p, bool by_y, double at, double sign)
{
  struct piece out = {.n = 0};
  const double *u = by_y ? p->y : p->x;
  for (int i = 0; i < p->n; i++) {
    int j = i + 1 < p->n ? i + 1 : 0;
    double a = sign * (u[i] - at), b = sign * (u[j] - at);
    if (a >= 0.0 && out.n < CORNERS) {
      out.x[out.n] = p->x[i];
      out.y[out.n++] = p->y[i];
    }
    if ((a >= 0.0) == (b >= 0.0) || out.n >= CORNERS) continue;
    double t = a / (a - b);
    out.x[out.n] = p->x[i] + t * (p->x[j] - p->x[i]);
    out.y[out.n++] = p->y[i] + t * (p->y[j] - p->y[i]);
  }
  return out;
}

static struct piece strip(const struct piece *p, bool by_y, double at)
{
  struct piece above = cut(p, by_y, at, 1.0);
  return cut(&above, by_y, at + 1.0, -1.0);
}

static void range_of(const double *u, int n, double *low, double *high)
{
  *low = *high = u[0];
  for (int i = 1; i < n; i++) {
    *low = fmin(*low, u[i]);
    *high = fmax(*high, u[i]);
  }
}

/* A facet in its own plane. */
struct plane {
  struct piece triangle;
  double area;  /* [patch^2] */
  uint64_t key; /* of seed, part and plane */
};

static uint64_t whole(double value) { return (uint64_t)(int64_t)llround(value); }

static struct plane plane_of(const struct um_geometry *geometry, size_t surface,
                             const struct um_geometry_creasing *creasing)
{
  const struct um_geometry_surface *s = &geometry->mesh.surface[surface];
  struct um_vec3 n = um_vec3_scale(geometry->normal[s->facet], s->back ? -1.0 : 1.0), grain, across;
  um_geometry_part_grain(geometry, surface, &grain, &across);
  struct plane plane = {.triangle = {.n = 3}};
  for (int k = 0; k < 3; k++) {
    struct um_vec3 p = geometry->vertex[geometry->mesh.corner[s->facet][k]];
    plane.triangle.x[k] = um_vec3_dot(p, grain) / creasing->patch;
    plane.triangle.y[k] = um_vec3_dot(p, across) / creasing->patch;
  }
  plane.area = area_of(&plane.triangle);
  double distance = um_vec3_dot(geometry->vertex[geometry->mesh.corner[s->facet][0]], n);
  const double numbers[] = {n.x / SAME_NORMAL, n.y / SAME_NORMAL, n.z / SAME_NORMAL,
                            distance / SAME_PLANE};
  plane.key = um_core_hash(creasing->seed, s->part);
  for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++)
    plane.key = um_core_hash(plane.key, whole(numbers[i]));
  return plane;
}

/* Two normal numbers of a square (Box & Muller 1958). */
static void normal_numbers(uint64_t key, double out[2])
{
  double u = 1.0 - um_core_hash_uniform(um_core_hash(key, 1)), /* above 0 */
      v = um_core_hash_uniform(um_core_hash(key, 2)), r = sqrt(-2.0 * log(u));
  out[0] = r * cos(2.0 * UM_PI * v);
  out[1] = r * sin(2.0 * UM_PI * v);
}

/* Cut the facet of a surface by its squares; count them, and keep them where `out` is not NULL. */
static size_t cut_facet(const struct plane *plane, double slope, struct um_geometry_creases *out,
                        size_t from)
{
  double low_y, high_y, sum = 0.0;
  size_t n = 0;
  range_of(plane->triangle.y, 3, &low_y, &high_y);
  for (double j = floor(low_y); j < high_y; j += 1.0) {
    struct piece row = strip(&plane->triangle, true, j);
    if (row.n < 3) continue;
    double low_x, high_x;
    range_of(row.x, row.n, &low_x, &high_x);
    for (double i = floor(low_x); i < high_x; i += 1.0) {
      struct piece square = strip(&row, false, i);
      double share = square.n < 3 ? 0.0 : area_of(&square) / plane->area, g[2];
      if (!(share > SMALLEST)) continue;
      if (out != NULL) {
        normal_numbers(um_core_hash(um_core_hash(plane->key, whole(i)), whole(j)), g);
        out->along[from + n] = (float)(slope * g[0]);
        out->across[from + n] = (float)(slope * g[1]);
        out->share[from + n] = (float)share;
      }
      sum += share;
      n++;
    }
  }
  for (size_t k = 0; out != NULL && k < n; k++)
    out->share[from + k] = (float)((double)out->share[from + k] / sum);
  return n;
}

static enum um_status count_all(struct um_context *context, const struct um_geometry *geometry,
                                const struct um_geometry_creasing *creasing, const bool *wanted,
                                struct um_geometry_creases *out)
{
  double all = 0.0;
  for (size_t s = 0; s < out->nsurface; s++) {
    const struct um_geometry_surface *surface = &geometry->mesh.surface[s];
    const struct um_geometry_creasing *c = &creasing[surface->group];
    out->first[s + 1] = out->first[s];
    if (!wanted[s] || !(c->tilt_square > 0.0) || !(c->patch > 0.0)) continue;
    all += geometry->mesh.area[surface->facet] / (c->patch * c->patch);
    if (!(all <= UM_GEOMETRY_PATCHES_MOST))
      return um_core_fail(
          context, UM_ERR_INPUT,
          "part '%s': patches of %g m are more than %g; accepted: larger patches, or "
          "patch_m 0 for those too small to tell apart",
          geometry->part[surface->part].name, c->patch, UM_GEOMETRY_PATCHES_MOST);
    struct plane plane = plane_of(geometry, s, c);
    out->first[s + 1] += cut_facet(&plane, 0.0, NULL, 0);
    UM_TRY(um_core_stop_check(context, "creases were cut"));
  }
  return UM_OK;
}

enum um_status um_geometry_creases_create(struct um_context *context,
                                          const struct um_geometry *geometry,
                                          const struct um_geometry_creasing *creasing,
                                          const bool *wanted, struct um_geometry_creases **out)
{
  enum um_status status;
  struct um_geometry_creases *c = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *c, &c));
  c->nsurface = geometry->mesh.nsurface;
  UM_CHECK(um_core_allocate(context, c->nsurface + 1, sizeof *c->first, &c->first));
  UM_CHECK(count_all(context, geometry, creasing, wanted, c));
  size_t n = c->first[c->nsurface];
  UM_CHECK(um_core_allocate(context, n, sizeof *c->along, &c->along));
  UM_CHECK(um_core_allocate(context, n, sizeof *c->across, &c->across));
  UM_CHECK(um_core_allocate(context, n, sizeof *c->share, &c->share));
  for (size_t s = 0; s < c->nsurface; s++) {
    if (c->first[s + 1] == c->first[s]) continue;
    const struct um_geometry_creasing *of = &creasing[geometry->mesh.surface[s].group];
    struct plane plane = plane_of(geometry, s, of);
    cut_facet(&plane, sqrt(um_geometry_slope_variance(of)), c, c->first[s]);
    UM_CHECK(um_core_stop_check(context, "creases were cut"));
  }
  *out = c;
  c = NULL;
done:
  um_geometry_creases_destroy(context, &c);
  return status;
}

void um_geometry_creases_destroy(struct um_context *context, struct um_geometry_creases **creases)
{
  if (creases == NULL || *creases == NULL) return;
  UM_FREE(context, (*creases)->first, (*creases)->along, (*creases)->across, (*creases)->share,
          *creases);
  *creases = NULL;
}
