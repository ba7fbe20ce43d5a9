/* Triangles of a simple, nearly plane polygon: a fan when it is convex, else ear clipping
 * (Meisters 1975) that takes the ear with the largest smallest sine first, so that corners on one
 * line do not make degenerate triangles. */
#include "geometry/polygon_impl.h"

#include <string.h>

#include "base/core/constants.h"
#include "geometry/patch_impl.h"

/* Ear clipping costs n^3; longer concave faces are refused. */
#define MAX_CONCAVE_CORNERS 1024

/* Twice the vector area (Newell). */
static struct um_vec3 newell(const struct um_vec3 *p, size_t n)
{
  struct um_vec3 sum = um_vec3(0, 0, 0);
  for (size_t i = 1; i + 1 < n; i++)
    sum = um_vec3_add(sum, um_vec3_cross(um_vec3_sub(p[i], p[0]), um_vec3_sub(p[i + 1], p[0])));
  return sum;
}

/* Twice the area as seen along the unit normal; its ratio to the longest edge squared in *shape. */
static double seen_area(struct um_vec3 a, struct um_vec3 b, struct um_vec3 c, struct um_vec3 normal,
                        double *shape)
{
  struct um_vec3 ab = um_vec3_sub(b, a), ac = um_vec3_sub(c, a), bc = um_vec3_sub(c, b);
  double area = um_vec3_dot(um_vec3_cross(ab, ac), normal);
  double longest = fmax(um_vec3_dot(ab, ab), fmax(um_vec3_dot(ac, ac), um_vec3_dot(bc, bc)));
  *shape = area / longest;
  return area;
}

/* Convex without corners on one line as seen from p[0]: every fan triangle and every corner turns
 * left. A polygon that winds twice is found by its area: fan triangles would overlap. */
static bool fan_works(const struct um_vec3 *p, size_t n, struct um_vec3 normal)
{
  double shape;
  struct um_vec3 first = um_vec3_sub(p[1], p[0]);
  for (size_t i = 1; i + 1 < n; i++) {
    seen_area(p[0], p[i], p[i + 1], normal, &shape);
    if (!(shape > 1e3 * UM_GEOMETRY_DEGENERATE)) return false;
    /* the fan must not turn by more than half a circle */
    struct um_vec3 spoke = um_vec3_sub(p[i + 1], p[0]);
    if (!(um_vec3_dot(um_vec3_cross(first, spoke), normal) > 0.0)) return false;
  }
  for (size_t i = 0; i < n; i++) {
    seen_area(p[i], p[(i + 1) % n], p[(i + 2) % n], normal, &shape);
    if (!(shape >= -UM_GEOMETRY_DEGENERATE)) return false;
  }
  return true;
}

/* The outer angles of a simple polygon sum to 2 pi (Hopf); to 0 or 4 pi when it crosses itself. */
static bool turns_once(const struct um_vec3 *p, size_t n, struct um_vec3 normal)
{
  double sum = 0.0;
  for (size_t i = 0; i < n; i++) {
    struct um_vec3 in = um_vec3_sub(p[(i + 1) % n], p[i]);
    struct um_vec3 out = um_vec3_sub(p[(i + 2) % n], p[(i + 1) % n]);
    sum += atan2(um_vec3_dot(um_vec3_cross(in, out), normal), um_vec3_dot(in, out));
  }
  return fabs(sum - 2.0 * UM_PI) < 1.0; /* 1 rad: the polygon need not be quite plane */
}

/* True when q lies inside or, to rounding, on the border of the triangle, seen along the normal. */
static bool inside(struct um_vec3 q, struct um_vec3 a, struct um_vec3 b, struct um_vec3 c,
                   struct um_vec3 normal)
{
  double s[3];
  seen_area(a, b, q, normal, &s[0]);
  seen_area(b, c, q, normal, &s[1]);
  seen_area(c, a, q, normal, &s[2]);
  return fmin(fmin(s[0], s[1]), s[2]) >= -UM_GEOMETRY_DEGENERATE;
}

static bool same_point(struct um_vec3 a, struct um_vec3 b)
{
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* Shape measure of the ear at `at` of the remaining ring, or -1 when it is none. */
static double ear_quality(const struct um_vec3 *p, const uint32_t *ring, size_t n, size_t at,
                          struct um_vec3 normal)
{
  struct um_vec3 a = p[ring[(at + n - 1) % n]], b = p[ring[at]], c = p[ring[(at + 1) % n]];
  double shape;
  seen_area(a, b, c, normal, &shape);
  if (!(shape > 1e3 * UM_GEOMETRY_DEGENERATE)) return -1.0;
  for (size_t k = 2; k + 1 < n; k++) {
    struct um_vec3 q = p[ring[(at + k) % n]];
    /* a corner that returns to the same place (a keyhole) does not block */
    if (same_point(q, a) || same_point(q, b) || same_point(q, c)) continue;
    if (inside(q, a, b, c, normal)) return -1.0;
  }
  return shape;
}

bool um_geometry_polygon_triangulate(const struct um_vec3 *p, size_t n, uint32_t *work,
                                     uint32_t (*triangle)[3])
{
  if (n < 3) return false;
  struct um_vec3 area = newell(p, n);
  double norm = um_vec3_norm(area);
  if (!(norm > 0.0)) return false;
  struct um_vec3 normal = um_vec3_scale(area, 1.0 / norm);
  size_t ntriangle = 0;
  if (n == 3 || fan_works(p, n, normal)) {
    for (uint32_t i = 1; i + 1 < n; i++)
      memcpy(triangle[ntriangle++], (uint32_t[3]){0, i, i + 1}, sizeof *triangle);
    return true;
  }
  if (n > MAX_CONCAVE_CORNERS || !turns_once(p, n, normal)) return false;
  for (uint32_t i = 0; i < n; i++) work[i] = i;
  for (size_t left = n; left >= 3; left--) {
    size_t best = 0;
    double quality = -1.0;
    for (size_t i = 0; i < left; i++) {
      double q = ear_quality(p, work, left, i, normal);
      if (q > quality) {
        quality = q;
        best = i;
      }
    }
    if (!(quality > 0.0)) return false;
    uint32_t a = work[(best + left - 1) % left], b = work[best], c = work[(best + 1) % left];
    memcpy(triangle[ntriangle++], (uint32_t[3]){a, b, c}, sizeof *triangle);
    memmove(work + best, work + best + 1, (left - best - 1) * sizeof *work);
  }
  return true;
}
