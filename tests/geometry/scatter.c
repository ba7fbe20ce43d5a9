/* What evenly spread points find of a triangle that a straight edge cuts, against what is stated.
 *
 *   /|     lines of random direction and distance that cross the triangle; the fraction on one
 *  /-+--   side of a line is known in closed form, and from the points by a half plane's shadow:
 * /__|     here counted directly, each draw with a seed of its own
 *
 * Mean squares of errors, over f (1 - f), of LINES lines are good to 1/sqrt(LINES) times the
 * kurtosis: some 5 %, and the table between its entries to as much. */
#include <math.h>
#include <stdlib.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "geometry/scatter.h"
#include "geometry/visibility.h"
#include "tests/geometry/support.h"

enum { LINES = 600 };

static double uniform(uint64_t a, uint64_t b) { return um_core_hash_uniform(um_core_hash(a, b)); }

/* A roof far wider than the floor whose edge runs over the floor's facet along a line at random: of
 * the floor's two facets (right triangles of sides 1) some are cut. height tiny against its width.
 */
static void test_scatter(void **state)
{
  (void)state;
  static const int numbers[] = {4, 16, 40, 64, 256};
  enum { N = 5 };
  double error[N] = {0}, stated[N] = {0};
  size_t cut = 0;
  for (uint64_t line = 0; line < LINES; line++) {
    double angle = 2.0 * UM_PI * uniform(line, 1), offset = 1.4 * (uniform(line, 2) - 0.5);
    struct um_geometry_part_spec parts[] = {
        support_plate("floor", 1, 1, um_vec3(0, 0, 0)),
        support_plate("roof", 40, 40,
                      um_vec3((20.0 + offset) * cos(angle), (20.0 + offset) * sin(angle), 0.5))};
    parts[1].rotation = um_quat_from_axis(um_vec3(0, 0, 1), angle);
    struct support s = support_create(parts, 2);
    double seen[8], lit[8], e[8], truth[8];
    struct um_vec3 up = um_vec3(0, 0, 1);
    um_geometry_visibility_toward_both(s.visibility, up, up, 0.0, 16384, 77, truth, lit, NULL,
                                       NULL);
    for (size_t k = 0; k < N; k++) {
      um_geometry_visibility_toward_both(s.visibility, up, up, 0.0, numbers[k], line, seen, lit, e,
                                         NULL);
      for (size_t i = 0; i < s.mesh->nsurface; i++) {
        if (s.mesh->surface[i].part != 0 || s.mesh->surface[i].back) continue;
        error[k] += (seen[i] - truth[i]) * (seen[i] - truth[i]);
        stated[k] += e[i] * e[i];
        cut += k == 0 && truth[i] > 0.0 && truth[i] < 1.0;
      }
    }
    support_destroy(&s);
  }
  assert_true(cut > LINES / 2);
  for (size_t k = 0; k < N; k++) {
    print_message("%3d points: squares of errors over stated %.3f of %zu\n", numbers[k],
                  error[k] / stated[k], cut);
    assert_true(fabs(error[k] / stated[k] - 1.0) <= 0.15);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_scatter)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
