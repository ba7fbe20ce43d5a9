/* Distributions: quantiles against closed forms and GSL's cut tails, there and back, refusals. */
#include "base/uncertainty/distribution.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <string.h>

#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

static const double values[3] = {3.0, 1.0, 2.0};
static const struct um_uncertainty_distribution laws[] = {
    {.kind = UM_UNCERTAINTY_UNIFORM, .from = -2.0, .to = 6.0},
    {.kind = UM_UNCERTAINTY_LOG_UNIFORM, .from = 0.01, .to = 100.0},
    {.kind = UM_UNCERTAINTY_TRIANGULAR, .from = 1.0, .to = 5.0, .mode = 2.0},
    {.kind = UM_UNCERTAINTY_NORMAL, .from = -INFINITY, .to = INFINITY, .mean = 10.0, .sigma = 2.0},
    {.kind = UM_UNCERTAINTY_NORMAL, .from = 14.0, .to = 20.0, .mean = 10.0, .sigma = 2.0},
    {.kind = UM_UNCERTAINTY_NORMAL, .from = 3.0, .to = INFINITY, .mean = 10.0, .sigma = 2.0},
    {.kind = UM_UNCERTAINTY_LOG_NORMAL,
     .from = -INFINITY,
     .to = INFINITY,
     .median = 5.0,
     .sigma = 0.3},
    {.kind = UM_UNCERTAINTY_LOG_NORMAL, .from = 4.0, .to = 7.0, .median = 5.0, .sigma = 0.3},
};
enum { NLAW = sizeof laws / sizeof *laws };

/* The share of a normal distribution between two places of it, from the nearer tail. */
static double between(double a, double b)
{
  return a > 0.0 ? gsl_cdf_ugaussian_Q(a) - gsl_cdf_ugaussian_Q(b)
                 : gsl_cdf_ugaussian_P(b) - gsl_cdf_ugaussian_P(a);
}

/* The share below x, by each law's own distribution function. */
static double share(const struct um_uncertainty_distribution *l, double x)
{
  double least, largest;
  bool logarithm = l->kind == UM_UNCERTAINTY_LOG_NORMAL;
  um_uncertainty_distribution_ends(l, &least, &largest);
  if (l->kind == UM_UNCERTAINTY_UNIFORM) return (x - least) / (largest - least);
  if (l->kind == UM_UNCERTAINTY_LOG_UNIFORM) return log(x / least) / log(largest / least);
  if (l->kind == UM_UNCERTAINTY_TRIANGULAR && x < l->mode)
    return (x - least) * (x - least) / (largest - least) / (l->mode - least);
  if (l->kind == UM_UNCERTAINTY_TRIANGULAR)
    return 1.0 - (largest - x) * (largest - x) / (largest - least) / (largest - l->mode);
  double z[3] = {least, x, largest};
  for (int k = 0; k < 3; k++)
    z[k] = (logarithm ? log(z[k] / l->median) : z[k] - l->mean) / l->sigma;
  return between(z[0], z[1]) / between(z[0], z[2]);
}

/* Value and back, place and back, rising, ends exactly. */
static void test_there_and_back(void **state)
{
  (void)state;
  for (size_t l = 0; l < NLAW; l++) {
    double least, largest, last = -INFINITY;
    assert_int_equal(um_uncertainty_distribution_check(context, "x", &laws[l]), UM_OK);
    um_uncertainty_distribution_ends(&laws[l], &least, &largest);
    assert_close(um_uncertainty_distribution_value(&laws[l], 0.0), least, 0.0);
    assert_close(um_uncertainty_distribution_value(&laws[l], 1.0), largest, 0.0);
    assert_close(um_uncertainty_distribution_at_place(&laws[l], 0.0), least, 0.0);
    assert_close(um_uncertainty_distribution_at_place(&laws[l], 1.0), largest, 0.0);
    for (double u = 0.005; u < 1.0; u += 0.01) {
      double x = um_uncertainty_distribution_value(&laws[l], u);
      double place = um_uncertainty_distribution_place(&laws[l], x);
      assert_true(x > last && x >= least && x <= largest);
      last = x;
      assert_close(share(&laws[l], x), u, 1e-11);
      assert_true(place > 0.0 && place < 1.0);
      assert_close(um_uncertainty_distribution_at_place(&laws[l], place), x, 1e-13 * fabs(x));
    }
  }
}

static void test_closed_forms(void **state)
{
  (void)state;
  assert_close(um_uncertainty_distribution_value(&laws[0], 0.25), 0.0, 1e-15);
  assert_close(um_uncertainty_distribution_value(&laws[1], 0.25), 0.1, 1e-15);
  /* left of the mode F = (x - 1)^2 / 4, right of it 1 - (5 - x)^2 / 12 */
  assert_close(um_uncertainty_distribution_value(&laws[2], 0.25 * 0.25), 1.5, 1e-15);
  assert_close(um_uncertainty_distribution_value(&laws[2], 1.0 - 4.0 / 12.0), 3.0, 1e-15);
  /* 97.5 % of the normal distribution, of any table; the cut at 4 sigma moves it by 6e-5 / 2 shares
   */
  assert_close(um_uncertainty_distribution_value(&laws[3], 0.975), 10.0 + 2.0 * 1.959963985, 3e-3);
  assert_close(um_uncertainty_distribution_value(&laws[3], 0.5), 10.0, 1e-12);
  assert_close(um_uncertainty_distribution_value(&laws[6], 0.5), 5.0, 1e-12);
  /* beyond 2 sigma: Q(z) = (Q(2) + Q(5)) / 2 at the middle */
  double z = (um_uncertainty_distribution_value(&laws[4], 0.5) - 10.0) / 2.0;
  assert_close(gsl_cdf_ugaussian_Q(z), 0.5 * (gsl_cdf_ugaussian_Q(2.0) + gsl_cdf_ugaussian_Q(5.0)),
               1e-14);
  struct um_uncertainty_distribution far = laws[4]; /* 20 to 21 sigma: Q alone still has digits */
  far.from = 50.0;
  far.to = 52.0;
  assert_close(um_uncertainty_distribution_value(&far, 0.5), 50.0687, 1e-3); /* ln 2 / 20 sigma */
}

static void test_list(void **state)
{
  (void)state;
  struct um_uncertainty_distribution list = {
      .kind = UM_UNCERTAINTY_LIST, .value = values, .nvalue = 3};
  assert_int_equal(um_uncertainty_distribution_check(context, "x", &list), UM_OK);
  for (size_t i = 0; i < 3; i++) {
    double u = ((double)i + 0.5) / 3.0;
    assert_close(um_uncertainty_distribution_value(&list, u), values[i], 0.0);
    assert_close(um_uncertainty_distribution_place(&list, values[i]), (values[i] - 1.0) / 2.0, 0.0);
  }
  assert_close(um_uncertainty_distribution_value(&list, 1.0), 2.0, 0.0);
  assert_close(um_uncertainty_distribution_value(&list, 0.0), 3.0, 0.0);
}

static void refused(struct um_context *c, struct um_uncertainty_distribution law, const char *word)
{
  assert_int_equal(um_uncertainty_distribution_check(c, "cells", &law), UM_ERR_INPUT);
  if (strncmp(um_core_message(c), "cells: ", 7) != 0 || strstr(um_core_message(c), word) == NULL)
    fail_msg("'%s' does not say '%s'", um_core_message(c), word);
  um_core_message_clear(c);
}

static void test_refusals(void **state)
{
  (void)state;
  struct um_context *c = context;
  struct um_uncertainty_distribution law = laws[0];
  law.to = law.from;
  refused(c, law, "is empty");
  law.to = NAN;
  refused(c, law, "not finite");
  law = laws[1];
  law.from = 0.0;
  refused(c, law, "above 0");
  law = laws[2];
  law.mode = 6.0;
  refused(c, law, "outside its range");
  law = laws[3];
  law.sigma = 0.0;
  refused(c, law, "sigma 0");
  law = laws[3];
  law.from = 20.0; /* beyond the cut at 18 */
  refused(c, law, "is empty");
  law = laws[6];
  law.median = -1.0;
  refused(c, law, "median -1");
  const double same[2] = {4.0, 4.0};
  law =
      (struct um_uncertainty_distribution){.kind = UM_UNCERTAINTY_LIST, .value = same, .nvalue = 2};
  refused(c, law, "nothing varies");
  law.nvalue = 0;
  refused(c, law, "without values");
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_there_and_back),
                                     cmocka_unit_test(test_closed_forms),
                                     cmocka_unit_test(test_list), cmocka_unit_test(test_refusals)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
