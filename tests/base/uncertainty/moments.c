/* Moments and Sobol' indices of surrogates in closed form; values nowhere; time and threads. */
#include <string.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "base/uncertainty/surrogate.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

struct function {
  size_t d, nvalue;
  void (*at)(const double *x, size_t nvalue, double *value);
};

static enum um_status evaluate(struct um_context *with, void *user, const double *place, size_t n,
                               double *value)
{
  (void)with;
  struct function *f = user;
  for (size_t i = 0; i < n; i++) f->at(place + i * f->d, f->nvalue, value + i * f->nvalue);
  return UM_OK;
}

static struct um_uncertainty_surrogate *make(struct function *f, double relative)
{
  struct um_uncertainty_surrogate *s = NULL;
  struct um_uncertainty_group group = {
      .name = "light", .count = f->nvalue, .relative = relative, .floor = 1.0};
  struct um_uncertainty_surrogate_request r = {.d = f->d,
                                               .nvalue = f->nvalue,
                                               .ngroup = 1,
                                               .group = &group,
                                               .evaluate = evaluate,
                                               .user = f,
                                               .evaluations_max = 400};
  if (um_uncertainty_surrogate_create(context, &r, &s) != UM_OK)
    fail_msg("%s", um_core_message(context));
  return s;
}

/* 2 x + y; x y; constant; never */
static void simple(const double *x, size_t nvalue, double *v)
{
  (void)nvalue;
  v[0] = 2.0 * x[0] + x[1];
  v[1] = x[0] * x[1];
  v[2] = 4.0;
  v[3] = NAN;
}

/* Uniform on [0, 1]: variances 4/12 and 1/12; of the product V = 1/9 - 1/16 = 7/144, V_i = 1/48. */
static void test_uniform(void **state)
{
  (void)state;
  struct function f = {.d = 2, .nvalue = 4, .at = simple};
  struct um_uncertainty_surrogate *s = make(&f, 1e-6);
  const struct um_uncertainty_distribution law[2] = {
      {.kind = UM_UNCERTAINTY_UNIFORM, .from = 0.0, .to = 1.0},
      {.kind = UM_UNCERTAINTY_UNIFORM, .from = -5.0, .to = 5.0}};
  double mean[4], variance[4], first[2][4], total[2][4];
  assert_int_equal(
      um_uncertainty_surrogate_moments(context, s, law, mean, variance, *first, *total), UM_OK);
  assert_close(mean[0], 1.5, 1e-14);
  assert_close(variance[0], 5.0 / 12.0, 1e-14);
  assert_close(first[0][0], 0.8, 1e-14);
  assert_close(total[0][0], 0.8, 1e-14);
  assert_close(first[1][0], 0.2, 1e-14);
  assert_close(mean[1], 0.25, 1e-14);
  assert_close(variance[1], 7.0 / 144.0, 1e-14);
  assert_close(first[0][1], 3.0 / 7.0, 1e-13);
  assert_close(total[1][1], 4.0 / 7.0, 1e-13);
  assert_close(mean[2], 4.0, 1e-14);
  assert_close(variance[2], 0.0, 0.0);
  assert_true(isnan(first[0][2]) && isnan(total[1][2]));
  assert_true(isnan(mean[3]) && isnan(variance[3]) && isnan(first[1][3]));
  double at[2] = {0.25, 0.75}, v[4];
  assert_int_equal(um_uncertainty_surrogate_at(context, s, at, 1, v), UM_OK);
  assert_close(v[0], 1.25, 1e-14);
  assert_true(isnan(v[3]));
  at[0] = 1.0001;
  assert_int_equal(um_uncertainty_surrogate_at(context, s, at, 1, v), UM_ERR_INPUT);
  um_core_message_clear(context);
  um_uncertainty_surrogate_destroy(context, &s);
}

/* The same of other distributions, whose moments have closed forms: normal of mean m and width w in
 * units of the axis (m = 1/2, w = 1/8, cut at 4 of them: its variance falls by 2 z phi(z) = 1.07e-3
 * of itself), and a list of 0, 0, 1. */
static void test_other(void **state)
{
  (void)state;
  struct function f = {.d = 2, .nvalue = 4, .at = simple};
  struct um_uncertainty_surrogate *s = make(&f, 1e-6);
  const double values[3] = {10.0, 10.0, 20.0};
  const struct um_uncertainty_distribution law[2] = {
      {.kind = UM_UNCERTAINTY_NORMAL, .from = -INFINITY, .to = INFINITY, .mean = 3.0, .sigma = 0.1},
      {.kind = UM_UNCERTAINTY_LIST, .value = values, .nvalue = 3}};
  double mean[4], variance[4], first[2][4], vx = 1.0 / 64.0 * (1.0 - 1.0706e-3), vy = 2.0 / 9.0;
  assert_int_equal(um_uncertainty_surrogate_moments(context, s, law, mean, variance, *first, NULL),
                   UM_OK);
  assert_close(mean[0], 1.0 + 1.0 / 3.0, 1e-12);
  assert_close(variance[0], 4.0 * vx + vy, 2e-7); /* the quadrature's 256 nodes */
  assert_close(first[0][0], 4.0 * vx / (4.0 * vx + vy), 1e-6);
  /* V(x y) = (vx + 1/4)(vy + 1/9) - 1/36 */
  assert_close(variance[1], (vx + 0.25) * (vy + 1.0 / 9.0) - 1.0 / 36.0, 2e-7);
  um_uncertainty_surrogate_destroy(context, &s);
}

#define ISHIGAMI_A 7.0
#define ISHIGAMI_B 0.1
static void ishigami(const double *x, size_t nvalue, double *v)
{
  (void)nvalue;
  double a = UM_PI * (2.0 * x[0] - 1.0), b = UM_PI * (2.0 * x[1] - 1.0),
         c = UM_PI * (2.0 * x[2] - 1.0);
  v[0] = sin(a) + ISHIGAMI_A * pow(sin(b), 2.0) + ISHIGAMI_B * pow(c, 4.0) * sin(a);
}

/* Ishigami & Homma 1990: V = a^2/8 + b pi^4/5 + b^2 pi^8/18 + 1/2. */
static void test_ishigami(void **state)
{
  (void)state;
  struct function f = {.d = 3, .nvalue = 1, .at = ishigami};
  struct um_uncertainty_surrogate *s = make(&f, 1e-3);
  struct um_uncertainty_distribution law[3];
  for (size_t k = 0; k < 3; k++)
    law[k] = (struct um_uncertainty_distribution){
        .kind = UM_UNCERTAINTY_UNIFORM, .from = -UM_PI, .to = UM_PI};
  double mean, v, first[3], total[3], p4 = pow(UM_PI, 4.0), p8 = p4 * p4;
  double v1 = 0.5 * pow(1.0 + ISHIGAMI_B * p4 / 5.0, 2.0), v2 = ISHIGAMI_A * ISHIGAMI_A / 8.0,
         v13 = ISHIGAMI_B * ISHIGAMI_B * p8 * (1.0 / 18.0 - 1.0 / 50.0), all = v1 + v2 + v13;
  assert_int_equal(um_uncertainty_surrogate_moments(context, s, law, &mean, &v, first, total),
                   UM_OK);
  print_message("Ishigami: %zu points\n", um_uncertainty_surrogate_evaluations(s));
  assert_close(mean, ISHIGAMI_A / 2.0, 1e-3);
  assert_close(v, all, 1e-3 * all);
  const double expected[2][3] = {{v1 / all, v2 / all, 0.0},
                                 {(v1 + v13) / all, v2 / all, v13 / all}};
  for (size_t k = 0; k < 3; k++) {
    assert_close(first[k], expected[0][k], 1e-3);
    assert_close(total[k], expected[1][k], 1e-3);
  }
  um_uncertainty_surrogate_destroy(context, &s);
}

/* A curve of many values, each another smooth function. */
static void curve(const double *x, size_t nvalue, double *v)
{
  for (size_t k = 0; k < nvalue; k++) {
    double t = (double)k / (double)nvalue;
    v[k] = exp(-t * x[0]) + t * x[1] * x[1] + 0.1 * sin(t + x[2]) * x[0];
  }
}

/* The same bytes of a curve for 1 and 3 threads, memory as stated. */
static void test_curve(void **state)
{
  (void)state;
  enum { N = 100, NVALUE = 20000 };
  struct function f = {.d = 3, .nvalue = NVALUE, .at = curve};
  struct um_uncertainty_surrogate *s = make(&f, 1e-5);
  double *one, *three, place[3 * N];
  assert_int_equal(um_core_allocate(context, N, NVALUE * sizeof *one, &one), UM_OK);
  assert_int_equal(um_core_allocate(context, N, NVALUE * sizeof *one, &three), UM_OK);
  for (size_t i = 0; i < N * 3; i++) place[i] = um_core_hash_uniform(um_core_hash(9, i));
  um_core_context_set_threads(context, 1);
  assert_int_equal(um_uncertainty_surrogate_at(context, s, place, N, one), UM_OK);
  um_core_context_set_threads(context, 3);
  assert_int_equal(um_uncertainty_surrogate_at(context, s, place, N, three), UM_OK);
  assert_memory_equal(one, three, N * NVALUE * sizeof *one);
  assert_int_equal(um_uncertainty_surrogate_moments(
                       context, s,
                       (const struct um_uncertainty_distribution[3]){
                           {.kind = UM_UNCERTAINTY_UNIFORM, .from = 0.0, .to = 1.0},
                           {.kind = UM_UNCERTAINTY_UNIFORM, .from = 0.0, .to = 1.0},
                           {.kind = UM_UNCERTAINTY_UNIFORM, .from = 0.0, .to = 1.0}},
                       one, NULL, NULL, NULL),
                   UM_OK);
  um_core_free(context, one);
  um_core_free(context, three);
  um_uncertainty_surrogate_destroy(context, &s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_uniform), cmocka_unit_test(test_other),
                                     cmocka_unit_test(test_ishigami), cmocka_unit_test(test_curve)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
