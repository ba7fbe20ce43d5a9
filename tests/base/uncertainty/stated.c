/* Statements from residuals against what they are made for: normal ones, and surrogates. */
#include "base/uncertainty/stated.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "base/uncertainty/surrogate.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

static double uniform(uint64_t key, size_t i) { return um_core_hash_uniform(um_core_hash(key, i)); }

static double normal(uint64_t key, size_t i)
{
  return sqrt(-2.0 * log(1.0 - uniform(key, 2 * i))) * cos(2.0 * UM_PI * uniform(key, 2 * i + 1));
}

/* Tables of Student's t and of chi-square. */
static void test_factors(void **state)
{
  (void)state;
  assert_close(um_uncertainty_stated_factor(10, 0.01), 3.169273, 1e-6);
  assert_close(um_uncertainty_stated_factor(20, 0.05), 2.085963, 1e-6);
  assert_close(um_uncertainty_rms_factor(10, 0.05), sqrt(10.0 / 3.940299), 1e-6);
}

/* Of normal residuals as many are beyond as it says, whatever their number; and of the root of
 * their mean square. */
static void test_normal(void **state)
{
  (void)state;
  const size_t number[] = {5, 10, 60};
  const size_t trials = 40000;
  for (size_t c = 0; c < 3; c++) {
    size_t n = number[c], beyond = 0, more = 0;
    double bound = um_uncertainty_stated_factor(n, 0.01), wide = um_uncertainty_rms_factor(n, 0.05);
    for (size_t i = 0; i < trials; i++) {
      double sum = 0.0;
      for (size_t k = 0; k < n; k++) sum += pow(normal(c + 1, i * (n + 1) + k), 2.0);
      double rms = sqrt(sum / (double)n);
      beyond += fabs(normal(c + 1, i * (n + 1) + n)) > bound * rms;
      more += wide * rms < 1.0;
    }
    assert_close((double)beyond / (double)trials, 0.01, 0.002);
    assert_close((double)more / (double)trials, 0.05, 0.005);
  }
}

/* --- curves of functions that polynomials follow well, badly, or not at all ------------------- */

enum { D = 3, NVALUE = 40, FRESH = 400 };

struct family {
  uint64_t key;
  int kind; /* 0 smooth, 1 a bend, 2 a step, 3 a narrow peak */
};

static void curve(const struct family *f, const double *x, double *v)
{
  double a = 0.5 + uniform(f->key, 0), b = uniform(f->key, 1), c = 1.0 + 3.0 * uniform(f->key, 2);
  double along = a * x[0] + b * x[1] + 0.3 * x[2], edge = along - 0.3 - 0.4 * uniform(f->key, 3);
  for (size_t k = 0; k < NVALUE; k++) {
    double t = (double)k / NVALUE;
    v[k] = 3.0 + exp(along) * (1.0 + 0.3 * t) + sin(c * x[1] + 2.0 * t) / (1.2 + x[2]);
    if (f->kind == 1) v[k] += 0.5 * t * fabs(edge);
    if (f->kind == 2) v[k] += edge > 0.2 * t ? 0.2 : 0.0;
    if (f->kind == 3) v[k] += exp(-pow((edge - t + 0.5) / 0.1, 2.0));
  }
}

static enum um_status evaluate(struct um_context *with, void *user, const double *place, size_t n,
                               double *value)
{
  (void)with;
  for (size_t i = 0; i < n; i++) curve(user, place + i * D, value + i * NVALUE);
  return UM_OK;
}

/* Share of the values at fresh points that are off by more than is stated. */
static double beyond(struct family *f, double asked, double *stated)
{
  static double place[FRESH][D], value[FRESH][NVALUE];
  struct um_uncertainty_group group = {
      .name = "curve", .count = NVALUE, .relative = asked, .floor = 0.01};
  struct um_uncertainty_surrogate_request r = {
      .d = D, .nvalue = NVALUE, .ngroup = 1, .group = &group, .evaluate = evaluate, .user = f};
  struct um_uncertainty_surrogate *s = NULL;
  assert_int_equal(um_uncertainty_surrogate_create(context, &r, &s), UM_OK);
  *stated = um_uncertainty_surrogate_errors(s)[0].stated * asked;
  for (size_t i = 0; i < (size_t)FRESH * D; i++) place[i / D][i % D] = uniform(f->key + 1000, i);
  assert_int_equal(um_uncertainty_surrogate_at(context, s, place[0], FRESH, value[0]), UM_OK);
  size_t count = 0;
  for (size_t i = 0; i < FRESH; i++) {
    double v[NVALUE];
    curve(f, place[i], v);
    for (size_t k = 0; k < NVALUE; k++) count += fabs(value[i][k] - v[k]) > *stated * fabs(v[k]);
  }
  um_uncertainty_surrogate_destroy(context, &s);
  return (double)count / (FRESH * NVALUE);
}

/* What is stated holds at 99 of 100 values: of nearly each function, and on the whole. */
static void test_surrogates(void **state)
{
  (void)state;
  enum { FUNCTIONS = 40 };
  int bad = 0;
  for (int kind = 0; kind < 4; kind++) {
    double mean = 0.0, worst = 0.0, stated, largest = 0.0;
    size_t off = 0;
    for (size_t i = 0; i < FUNCTIONS; i++) {
      struct family f = {100 * (uint64_t)kind + i, kind};
      double share = beyond(&f, 1e-3, &stated);
      mean += share / FUNCTIONS;
      worst = fmax(worst, share);
      largest = fmax(largest, stated);
      off += share > 0.01;
    }
    print_message("kind %d: beyond what is stated %.5f, at most %.4f, above 1 %% in %zu of %d; "
                  "stated at most %.2e\n",
                  kind, mean, worst, off, FUNCTIONS, largest);
    bad += mean > 0.01 || off > 2;
  }
  assert_int_equal(bad, 0);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_factors), cmocka_unit_test(test_normal),
                                     cmocka_unit_test(test_surrogates)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
