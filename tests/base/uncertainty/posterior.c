/* Draws from a posterior: moments against closed forms, bounds, a proposal that is wrong, and
 * simulation-based calibration (Talts et al. 2018, arXiv 1804.06788): where truths are drawn from
 * the prior, and measurements from the model, the rank of the truth among the draws is uniform. */
#include "base/uncertainty/posterior.h"

#include <string.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "base/inference/distributions.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

#define OK(call)                                                                                   \
  do {                                                                                             \
    if ((call) != UM_OK) fail_msg("%s: %s", #call, um_core_message(context));                      \
  } while (0)

static const double nowhere[] = {-INFINITY, -INFINITY, -INFINITY};
static const double everywhere[] = {INFINITY, INFINITY, INFINITY};

static double uniform(uint64_t key, uint64_t i)
{
  return um_core_hash_uniform(um_core_hash(key, i));
}

static double normal(uint64_t key, uint64_t i)
{
  return sqrt(-2.0 * log(1.0 - uniform(key, 2 * i))) * cos(2.0 * UM_PI * uniform(key, 2 * i + 1));
}

/* ---- closed forms ---- */

/* Precision of two normal numbers: variances 1 and 4, correlation 0.8. */
static const double two[4] = {1.0 / 0.36, -0.4 / 0.36, -0.4 / 0.36, 0.25 / 0.36};

static enum um_status gauss(struct um_context *c, void *user, size_t n, const double *x,
                            double *out)
{
  (void)c;
  const double *p = user;
  for (size_t i = 0; i < n; i++) {
    double a = x[2 * i] - 3.0, b = x[2 * i + 1] + 1.0;
    out[i] = -0.5 * (p[0] * a * a + 2.0 * p[1] * a * b + p[3] * b * b);
  }
  return UM_OK;
}

static struct um_uncertainty_posterior *draws(size_t n, const double *centre,
                                              const double *precision, const double *least)
{
  struct um_uncertainty_posterior *out;
  const struct um_uncertainty_posterior_problem problem = {.nparameter = 2,
                                                           .ndraw = n,
                                                           .centre = centre,
                                                           .precision = precision,
                                                           .least = least,
                                                           .most = everywhere,
                                                           .density = gauss,
                                                           .user = (void *)two,
                                                           .seed = 5};
  OK(um_uncertainty_posterior_create(context, &problem, &out));
  return out;
}

/* Its mean, covariance and what draws are worth; also from a proposal that is twice as narrow,
 * knows no correlation and stands a sigma aside. Errors of a mean are sigma / sqrt(effective). */
static void test_normal(void **state)
{
  static const double centre[] = {3.0, -1.0}, aside[] = {4.0, 1.0}, narrow[] = {4.0, 0, 0, 1.0};
  (void)state;
  for (int k = 0; k < 2; k++) {
    struct um_uncertainty_posterior *p =
        draws(4000, k == 0 ? centre : aside, k == 0 ? two : narrow, nowhere);
    double mean[2], s[4], error = 1.0 / sqrt(p->effective);
    um_uncertainty_covariance(p->n, 2, p->x, p->weight, mean, s);
    print_message("%.4f %.4f, %.4f %.4f %.4f, worth %.0f, tail %.2f\n", mean[0], mean[1], s[0],
                  s[1], s[3], p->effective, p->tail);
    assert_true(p->n == 4000 && um_uncertainty_posterior_is_sound(p));
    assert_true(p->effective > (k == 0 ? 3000.0 : 2000.0) && p->tail < 0.5);
    assert_close(mean[0], 3.0, 4.0 * error);
    assert_close(mean[1], -1.0, 8.0 * error);
    assert_close(s[0], 1.0, 6.0 * error);
    assert_close(s[1], 1.6, 12.0 * error);
    assert_close(s[3], 4.0, 24.0 * error);
    um_uncertainty_posterior_destroy(context, &p);
  }
}

/* Cut at its mean: the half-normal's mean sqrt(2 / pi), and 0.8 of it for the other, over 2. */
static void test_bound(void **state)
{
  static const double centre[] = {3.0, -1.0}, least[] = {3.0, -INFINITY};
  double mean[2], s[4];
  (void)state;
  struct um_uncertainty_posterior *p = draws(4000, centre, two, least);
  um_uncertainty_covariance(p->n, 2, p->x, p->weight, mean, s);
  double half = sqrt(2.0 / UM_PI), error = 1.0 / sqrt(p->effective);
  for (size_t i = 0; i < p->n; i++) assert_true(p->x[2 * i] >= 3.0);
  assert_close(mean[0], 3.0 + half, 4.0 * error);
  assert_close(mean[1], -1.0 + 0.8 * 2.0 * half, 8.0 * error);
  um_uncertainty_posterior_destroy(context, &p);
}

/* A density that is nothing, a precision that is none: said, not drawn. */
static enum um_status nothing(struct um_context *c, void *user, size_t n, const double *x,
                              double *out)
{
  (void)c, (void)user, (void)x;
  for (size_t i = 0; i < n; i++) out[i] = NAN;
  return UM_OK;
}

static void test_refusals(void **state)
{
  static const double centre[] = {0.0, 0.0}, flat[] = {1.0, 1.0, 1.0, 1.0}, far[] = {1e9, 1e9};
  struct um_uncertainty_posterior *p;
  struct um_uncertainty_posterior_problem problem = {.nparameter = 2,
                                                     .ndraw = 100,
                                                     .centre = centre,
                                                     .precision = two,
                                                     .least = nowhere,
                                                     .most = everywhere,
                                                     .density = nothing};
  (void)state;
  assert_int_equal(um_uncertainty_posterior_create(context, &problem, &p), UM_ERR_NUMERIC);
  problem.precision = flat;
  assert_int_equal(um_uncertainty_posterior_create(context, &problem, &p), UM_ERR_NUMERIC);
  problem.precision = two;
  problem.least = far;
  assert_int_equal(um_uncertainty_posterior_create(context, &problem, &p), UM_ERR_NUMERIC);
  assert_null(p);
}

/* The tail of weights u^-k is Pareto of shape k; of uniform ones -1. The prior takes 10 in 300. */
static void test_tail(void **state)
{
  enum { N = 10000 };
  static const double shape[] = {0.3, 0.9, -1.0};
  static double w[N];
  (void)state;
  for (int s = 0; s < 3; s++) {
    double k;
    for (size_t i = 0; i < N; i++) {
      double u = 1.0 - uniform(71 + (uint64_t)s, i);
      w[i] = shape[s] < 0.0 ? u : pow(u, -shape[s]);
    }
    OK(um_uncertainty_tail(context, N, w, &k));
    print_message("%.3f of %.1f\n", k, shape[s]);
    assert_close(k, (shape[s] * 300.0 + 5.0) / 310.0, 3.0 * (1.0 + shape[s]) / sqrt(300.0) + 0.1);
  }
}

/* ---- calibration ---- */

/* y = exp(a - b t) + c at ROWS times, a and c normal, b normal and above a third: non-linear, and
 * at its bound in every twelfth set. */
enum { ROWS = 12, D = 3 };
#define NOISE 0.2
static const double prior_mean[D] = {0.5, 1.0, 0.0}, prior_sigma[D] = {0.5, 0.5, 0.3};
static const double least[D] = {-INFINITY, 1.0 / 3.0, -INFINITY};

struct set {
  double y[ROWS];
  double narrow; /* 1; above: the error that is planted, sigmas too small by so much */
};

static double model(const double *x, size_t i)
{
  return exp(x[0] - x[1] * 0.25 * (double)i) + x[2];
}

static double chi2_of(const struct set *set, const double *x)
{
  double sum = 0.0;
  for (size_t i = 0; i < ROWS; i++) sum += pow((set->y[i] - model(x, i)) / NOISE, 2.0);
  for (size_t k = 0; k < D; k++) sum += pow((x[k] - prior_mean[k]) / prior_sigma[k], 2.0);
  return sum * set->narrow * set->narrow;
}

static enum um_status density(struct um_context *c, void *user, size_t n, const double *x,
                              double *out)
{
  (void)c;
  for (size_t i = 0; i < n; i++) out[i] = -0.5 * chi2_of(user, x + i * D);
  return UM_OK;
}

/* Curvature at x by the model's slopes, and one Gauss-Newton step by it, solved by sweeps. */
static void curvature(const struct set *set, double *x, double p[D * D])
{
  double gradient[D] = {0};
  memset(p, 0, D * D * sizeof *p);
  for (size_t i = 0; i < ROWS; i++) {
    double t = 0.25 * (double)i, e = exp(x[0] - x[1] * t), r = set->y[i] - model(x, i);
    const double slope[D] = {e, -t * e, 1.0};
    for (size_t k = 0; k < D; k++) {
      gradient[k] += slope[k] * r / (NOISE * NOISE);
      for (size_t l = 0; l < D; l++) p[k * D + l] += slope[k] * slope[l] / (NOISE * NOISE);
    }
  }
  for (size_t k = 0; k < D; k++) {
    p[k * D + k] += 1.0 / (prior_sigma[k] * prior_sigma[k]);
    gradient[k] -= (x[k] - prior_mean[k]) / (prior_sigma[k] * prior_sigma[k]);
  }
  double step[D] = {0};
  for (int sweep = 0; sweep < 60; sweep++)
    for (size_t k = 0; k < D; k++) {
      double sum = gradient[k];
      for (size_t l = 0; l < D; l++) sum -= l == k ? 0.0 : p[k * D + l] * step[l];
      step[k] = sum / p[k * D + k];
    }
  for (size_t k = 0; k < D; k++) x[k] = fmax(least[k], x[k] + step[k]);
}

/* p of ranks that are uniform, the least of the parameters', of `sets` sets. */
static double calibration(double narrow, size_t sets)
{
  enum { BINS = 10 };
  double counts[D][BINS] = {{0}}, least_p = 1.0;
  for (size_t s = 0; s < sets; s++) {
    struct set set = {.narrow = narrow};
    struct um_uncertainty_posterior *p;
    double truth[D], x[D], precision[D * D];
    uint64_t key = um_core_hash(900, s);
    for (size_t k = 0, i = 0; k < D; k++) /* of the prior within its bounds */
      do truth[k] = prior_mean[k] + prior_sigma[k] * normal(key, i++);
      while (truth[k] < least[k]);
    for (size_t i = 0; i < ROWS; i++) set.y[i] = model(truth, i) + NOISE * normal(key, 1000 + i);
    memcpy(x, prior_mean, sizeof x);
    for (int i = 0; i < 12; i++) curvature(&set, x, precision);
    const struct um_uncertainty_posterior_problem problem = {.nparameter = D,
                                                             .ndraw = 1000,
                                                             .centre = x,
                                                             .precision = precision,
                                                             .least = least,
                                                             .most = everywhere,
                                                             .density = density,
                                                             .user = &set,
                                                             .seed = s};
    OK(um_uncertainty_posterior_create(context, &problem, &p));
    for (size_t k = 0; k < D; k++) {
      double rank = 0.0;
      for (size_t i = 0; i < p->n; i++) rank += p->x[i * D + k] < truth[k] ? p->weight[i] : 0.0;
      counts[k][(size_t)fmin(BINS - 1, rank * BINS)] += 1.0;
    }
    um_uncertainty_posterior_destroy(context, &p);
  }
  for (size_t k = 0; k < D; k++) {
    double chi2 = 0.0, expected = (double)sets / BINS;
    for (size_t b = 0; b < BINS; b++) chi2 += pow(counts[k][b] - expected, 2.0) / expected;
    least_p = fmin(least_p, um_inference_chi2_q(chi2, BINS - 1));
  }
  return least_p;
}

/* Ranks are uniform: chance refuses them in 3 of 1000 draws of this test. Of a posterior that is
 * too narrow by 1.3 they are not: a tenth at either end should hold a sixth. */
static void test_calibration(void **state)
{
  (void)state;
  double right = calibration(1.0, 1000), narrow = calibration(1.3, 1000);
  print_message("p %.3g; too narrow by 1.3: %.2g\n", right, narrow);
  assert_true(right > 1e-3);
  assert_true(narrow < 1e-6);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_normal), cmocka_unit_test(test_bound),
                                     cmocka_unit_test(test_refusals), cmocka_unit_test(test_tail),
                                     cmocka_unit_test(test_calibration)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
