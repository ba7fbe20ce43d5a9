/* Is the stated standard error the scatter that there is?
 *
 *        wing (turned, moved)
 *      ----/----
 *        +-----+   a box whose faces the wing hides and shades in part, seen and lit from
 *        | bus |   directions drawn at random; no configuration is like another, so that the
 *        +-----+   errors of two configurations are independent draws
 *
 * Truth is the same with 4096 points a facet, whose own variance is a fifth of that with 256 and
 * less of others. The stated error is that of evenly spread points where a straight edge cuts a
 * facet (geometry/scatter.c): squares of errors and of stated errors, each summed over all
 * surfaces, have the ratio 1, surfaces counted whose points are all seen, or none, although a
 * shadow slips between them. Some 200 surfaces are partly hidden and states of a facet differ by
 * their edges: the ratio is good to about 20 %. */
#include <math.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "tests/optics/fixture.h"

enum { CASES = 120 };

static void configure(struct fixture *f, uint64_t c)
{
  fixture_pair(f, c, 2.0, 1);
  f->samples[0].sun = fixture_direction(c, 30);
  f->samples[0].to_observer =
      um_vec3_unit(um_vec3_axpy(f->samples[0].sun, 0.9, fixture_direction(c, 40)));
}

static const int numbers[] = {1, 2, 4, 16, 64, 256};
enum { NUMBERS = 6, TRUTH = 4096 };

/* Sums of squares over the surfaces: of errors, and of what was stated; of those with all points
 * alike, errors alone. */
struct pooled {
  size_t partial;
  double error, stated, silent;
};

static void pool(const struct um_optics_view *v, const struct um_optics_view *truth, bool lit,
                 struct pooled *out)
{
  const float *f = lit ? v->sun.share : v->seen, *t = lit ? truth->sun.share : truth->seen;
  const float *e = lit ? v->sun.error : v->seen_error;
  for (size_t i = 0; i < v->nsurface; i++) {
    double error = (double)f[i] - (double)t[i];
    out->error += error * error;
    out->stated += (double)e[i] * (double)e[i];
    if (f[i] == 0.0F || f[i] == 1.0F) out->silent += error * error;
    if (t[i] > 0.0F && t[i] < 1.0F) out->partial++;
  }
}

static void test_stated(void **state)
{
  (void)state;
  struct pooled all[NUMBERS][2] = {{{0}}};
  for (uint64_t c = 0; c < CASES; c++) {
    struct fixture f;
    configure(&f, c);
    struct um_optics_view *truth, *view;
    FIXTURE_OK(&f, um_optics_view_trace(f.context, f.geometry, f.samples, 1, TRUTH, 0, &truth));
    for (size_t i = 0; i < NUMBERS; i++) {
      FIXTURE_OK(&f,
                 um_optics_view_trace(f.context, f.geometry, f.samples, 1, numbers[i], 0, &view));
      for (int lit = 0; lit < 2; lit++) pool(view, truth, lit == 1, &all[i][lit]);
      um_optics_view_destroy(f.context, &view);
    }
    um_optics_view_destroy(f.context, &truth);
    fixture_destroy(&f);
  }
  for (size_t i = 0; i < NUMBERS; i++)
    for (int lit = 0; lit < 2; lit++) {
      const struct pooled *p = &all[i][lit];
      double ratio = p->error / p->stated;
      print_message("%3d points, %s: %zu surfaces partly so, squares of errors over stated %.3f, "
                    "of surfaces that state none %.3f\n",
                    numbers[i], lit ? "lit " : "seen", p->partial, ratio, p->silent / p->stated);
      assert_true(p->partial > 200);
      if (numbers[i] == 1)
        assert_true(ratio <= 1.0); /* no estimate, a bound */
      else
        assert_true(fabs(ratio - 1.0) <= 0.4); /* two standard deviations */
    }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_stated)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
