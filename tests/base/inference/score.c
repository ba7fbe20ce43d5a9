/* Score test and expected chi-square difference on observations whose answers are known: closed
 * forms, and the distribution of p under noise alone. Noise is keyed, so that every run sees the
 * same draws; a uniform p is accepted below the 1e-4 tail of chi-square over bins. */
#include "base/inference/score.h"

#include "tests/base/inference/observations_test.h"
#include "tests/support/memory_sweep.h"
#include "tests/support/with_context.h"

#define ROWS 40

static const double ANY[2][8] = {
    {-INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY},
    {INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY}};

static struct um_inference_direction direction_of(size_t ncolumn, const double *column)
{
  return (struct um_inference_direction){ncolumn, column, ANY[0], ANY[1], ANY[1], 0};
}

static double at(size_t i) { return (double)i / (double)(ROWS - 1); }

/* Four smooth nuisances: an offset with width 2, a free slope, the same slope again, an insensitive
 * one. */
static double nuisance_column[4][ROWS];
static const double nuisance_width[4] = {2.0, INFINITY, INFINITY, 1.0};
static const struct um_inference_nuisance nuisance = {4, nuisance_column[0], nuisance_width};
static double bend[2][ROWS];

static int set_up(void **state)
{
  for (size_t i = 0; i < ROWS; i++) {
    nuisance_column[0][i] = 1.0;
    nuisance_column[1][i] = at(i);
    nuisance_column[2][i] = -3.0 * at(i);
    nuisance_column[3][i] = 0.0;
    bend[0][i] = 2.0 * at(i) * at(i);
    bend[1][i] = exp(-20.0 * (at(i) - 0.3) * (at(i) - 0.3));
  }
  return context_set_up(state);
}

/* Chi-square of 20 bins of p over `draws`; the nuisances are what their priors say. */
static double bins_chi2(struct um_context *c, const struct um_inference_nuisance *n,
                        const struct um_inference_direction *d, uint64_t key)
{
  enum { DRAWS = 8000, BINS = 20 };
  double count[BINS] = {0}, chi2 = 0.0, r[ROWS];
  for (uint64_t k = 0; k < DRAWS; k++) {
    struct um_inference_score s;
    for (size_t i = 0; i < ROWS; i++) {
      r[i] = rows_normal(um_core_hash(key, k), i);
      if (n == NULL) continue;
      r[i] += nuisance_width[0] * rows_normal(um_core_hash(key, k), ROWS) * nuisance_column[0][i];
      r[i] += 50.0 * nuisance_column[1][i];
    }
    assert_int_equal(um_inference_score_test(c, ROWS, r, n, 1, d, &s), UM_OK);
    assert_true(s.p >= 0.0 && s.p <= 1.0);
    assert_true(s.p == s.p_corrected || fabs(s.p / s.p_corrected - 1.0) < 1e-9);
    count[(size_t)fmin(s.p * BINS, BINS - 1)] += 1.0;
  }
  for (size_t b = 0; b < BINS; b++) {
    double expected = (double)DRAWS / BINS;
    chi2 += (count[b] - expected) * (count[b] - expected) / expected;
  }
  return chi2;
}

/* P(chi2_19 > 50.8) = 1e-4. */
static void test_p_is_uniform(void **state)
{
  struct um_context *c = *state;
  static const double zero = 0.0;
  struct um_inference_direction one = direction_of(1, bend[0]), two = direction_of(2, bend[0]);
  struct um_inference_direction up = one, down = one;
  up.minimum_step = &zero;
  down.maximum_step = &zero;
  assert_true(bins_chi2(c, NULL, &one, 1) < 50.8);
  assert_true(bins_chi2(c, NULL, &two, 2) < 50.8);
  assert_true(bins_chi2(c, &nuisance, &one, 3) < 50.8);
  assert_true(bins_chi2(c, &nuisance, &two, 4) < 50.8);
  assert_true(bins_chi2(c, &nuisance, &up, 5) < 50.8);
  assert_true(bins_chi2(c, &nuisance, &down, 6) < 50.8);
}

/* Share of 20000 draws of noise in which any of 60 directions is accused at 1 %. */
static double accused(struct um_context *c, const double *column, uint64_t key)
{
  enum { N = 60, DRAWS = 20000 };
  struct um_inference_direction d[N];
  struct um_inference_score s[N];
  double r[2 * ROWS], hits = 0.0;
  for (size_t i = 0; i < N; i++) d[i] = direction_of(1, column + i * 2 * ROWS);
  for (uint64_t k = 0; k < DRAWS; k++) {
    bool hit = false;
    for (size_t i = 0; i < 2 * ROWS; i++) r[i] = rows_normal(um_core_hash(key, k), i);
    assert_int_equal(um_inference_score_test(c, 2 * ROWS, r, NULL, N, d, s), UM_OK);
    for (size_t i = 0; i < N; i++) hit |= s[i].p_corrected < 0.01;
    hits += hit;
  }
  return hits / DRAWS;
}

/* Orthogonal directions: 1 % exactly, +-4 standard errors of 20000 draws, 0.0028 (two-sided 6e-5).
 * Directions that resemble each other: not more. */
static void test_family_wise_rate(void **state)
{
  struct um_context *c = *state;
  static double smooth[60][2 * ROWS], apart[60][2 * ROWS];
  for (size_t k = 0; k < 60; k++)
    for (size_t i = 0; i < 2 * ROWS; i++) {
      double x = (double)i / (2.0 * ROWS) - (double)k / 60.0;
      smooth[k][i] = exp(-50.0 * x * x) + 0.5;
      apart[k][i] = i == k;
    }
  assert_close(accused(c, apart[0], 7), 0.01, 0.0028);
  assert_true(accused(c, smooth[0], 8) < 0.0128);
}

/* A straight line y = a + b x, a free: b = Sxy / Sxx about the mean, sigma 1 / sqrt(Sxx), statistic
 * (b / sigma)^2. Tolerance: rounding of 40 observations. */
static void test_closed_form(void **state)
{
  struct um_context *c = *state;
  static const double free_width = INFINITY;
  const struct um_inference_nuisance offset = {1, nuisance_column[0], &free_width};
  struct um_inference_direction d = direction_of(1, nuisance_column[1]);
  struct um_inference_score s;
  double r[ROWS], sxx = 0.0, sxy = 0.0, length = 0.0;
  for (size_t i = 0; i < ROWS; i++) {
    r[i] = 3.0 + 7.0 * at(i) + rows_normal(9, i);
    sxx += (at(i) - 0.5) * (at(i) - 0.5);
    sxy += (at(i) - 0.5) * r[i];
    length += at(i) * at(i);
  }
  assert_int_equal(um_inference_score_test(c, ROWS, r, &offset, 1, &d, &s), UM_OK);
  assert_close(s.estimate[0], sxy / sxx, 1e-12);
  assert_close(s.sigma[0], 1.0 / sqrt(sxx), 1e-13);
  assert_close(s.statistic, sxy * sxy / sxx, 1e-10);
  assert_close(s.kept, sqrt(sxx / length), 1e-13);
  assert_close(s.dof, 1.0, 0.0);
  assert_false(s.absorbed);
}

/* Two columns with nuisances: the fall of chi-square and the estimate are those of the normal
 * equations of both together with the priors' widths. The insensitive nuisance has no equation. */
static void test_priors_of_nuisances(void **state)
{
  struct um_context *c = *state;
  struct um_inference_direction d = direction_of(2, bend[0]);
  struct um_inference_score s;
  double r[ROWS], column[4][ROWS], x[4], variance[4];
  const double width[4] = {2.0, INFINITY, INFINITY, INFINITY}, mean[4] = {0};
  for (size_t i = 0; i < ROWS; i++) {
    r[i] = 3.0 + bend[0][i] + 2.0 * bend[1][i] + rows_normal(10, i);
    column[0][i] = nuisance_column[0][i];
    column[1][i] = nuisance_column[1][i];
    column[2][i] = bend[0][i];
    column[3][i] = bend[1][i];
  }
  double without = rows_normal_equations(ROWS, 2, column[0], r, width, mean, x, NULL);
  double with = rows_normal_equations(ROWS, 4, column[0], r, width, mean, x, variance);
  assert_int_equal(um_inference_score_test(c, ROWS, r, &nuisance, 1, &d, &s), UM_OK);
  assert_close(s.statistic, without - with, 1e-9);
  for (size_t j = 0; j < 2; j++) {
    assert_close(s.estimate[j], x[2 + j], 1e-10);
    assert_close(s.sigma[j], sqrt(variance[2 + j]), 1e-11);
  }
}

/* A nuisance turned by 5e-4 rad from the direction leaves that share of it; one of 5e-3 leaves
 * enough. A direction the observations do not see, one prior width being 1e-7 sigma, is absorbed
 * too. */
static void test_absorbed(void **state)
{
  struct um_context *c = *state;
  static double turned[2][ROWS], faint[ROWS];
  static const double free_width = INFINITY, small = 1e-6;
  const double angle[2] = {5e-4, 5e-3};
  double r[ROWS];
  for (size_t i = 0; i < ROWS; i++) {
    r[i] = rows_normal(11, i);
    double first = i == 0, second = i == 1;
    for (size_t k = 0; k < 2; k++)
      turned[k][i] = 100.0 * (cos(angle[k]) * first + sin(angle[k]) * second);
    faint[i] = i == 3 ? 0.1 : 0.0;
  }
  double unit[ROWS] = {1.0};
  const struct um_inference_nuisance n = {1, unit, &free_width};
  struct um_inference_direction d[3] = {direction_of(1, turned[0]), direction_of(1, turned[1]),
                                        direction_of(1, faint)};
  struct um_inference_score s[3];
  d[2].prior_sigma = &small;
  assert_int_equal(um_inference_score_test(c, ROWS, r, &n, 3, d, s), UM_OK);
  assert_true(s[0].absorbed && !s[1].absorbed && s[2].absorbed);
  assert_close(s[0].kept, sin(angle[0]), 1e-12);
  assert_close(s[1].kept, sin(angle[1]), 1e-12);
  assert_true(isnan(s[0].estimate[0]) && isnan(s[0].sigma[0]));
  assert_close(s[0].p_corrected, 1.0, 0.0);
  assert_close(s[1].p_corrected, s[1].p, 1e-12); /* the others are no test */
  assert_close(s[1].statistic, r[1] * r[1], 1e-9);
}

/* Holm and Sidak by hand: of four directions the first two are one line, so there are three tests;
 * with one side allowed to one of the two there are four, and with the two sides of one line that
 * are the same side, three again. */
static void test_collinear_is_one_test(void **state)
{
  struct um_context *c = *state;
  static const double zero = 0.0;
  double r[ROWS], column[4][ROWS] = {{0}};
  for (size_t i = 0; i < ROWS; i++) r[i] = 0.0;
  r[0] = 3.0, r[1] = 2.0, r[2] = 1.0;
  column[0][0] = 5.0, column[1][0] = -2.0, column[2][1] = 1.0, column[3][2] = 1.0;
  struct um_inference_direction d[4];
  struct um_inference_score s[4];
  for (size_t k = 0; k < 4; k++) d[k] = direction_of(1, column[k]);
  assert_int_equal(um_inference_score_test(c, ROWS, r, NULL, 4, d, s), UM_OK);
  const double p[3] = {erfc(3.0 / sqrt(2.0)), erfc(2.0 / sqrt(2.0)), erfc(1.0 / sqrt(2.0))};
  double second = 1.0 - pow(1.0 - p[1], 2.0);
  for (size_t k = 0; k < 2; k++) {
    assert_close(s[k].p, p[0], 1e-14);
    assert_close(s[k].p_corrected, 1.0 - pow(1.0 - p[0], 3.0), 1e-13);
  }
  assert_close(s[2].p_corrected, second, 1e-13);
  assert_close(s[3].p_corrected, p[2], 1e-13);
  d[0].minimum_step = &zero;
  assert_int_equal(um_inference_score_test(c, ROWS, r, NULL, 4, d, s), UM_OK);
  assert_close(s[0].p, 0.5 * p[0], 1e-14);
  assert_close(s[0].p_corrected, 1.0 - pow(1.0 - 0.5 * p[0], 4.0), 1e-13);
  assert_close(s[1].p_corrected, 1.0 - pow(1.0 - p[0], 3.0), 1e-13);
  d[1].maximum_step = &zero; /* its column points the other way */
  assert_int_equal(um_inference_score_test(c, ROWS, r, NULL, 4, d, s), UM_OK);
  assert_close(s[0].p_corrected, 1.0 - pow(1.0 - 0.5 * p[0], 3.0), 1e-13);
  assert_close(s[1].p_corrected, s[0].p_corrected, 0.0);
  d[1].minimum_step = &zero; /* known to the last digit: no side is left, hence no side is asked */
  d[1].maximum_step = ANY[1];
  assert_int_equal(um_inference_score_test(c, ROWS, r, NULL, 4, d, s), UM_OK);
  assert_close(s[1].p, 1.0 - 0.5 * p[0], 1e-14); /* against the side */
  assert_close(s[1].statistic, 0.0, 0.0);
  assert_close(s[1].estimate[0], -1.5, 1e-14);
}

/* A column twice in a direction: one degree of freedom, neither parameter known, p as of one. */
static void test_collinear_columns(void **state)
{
  struct um_context *c = *state;
  double r[ROWS], twice[2][ROWS];
  for (size_t i = 0; i < ROWS; i++) {
    r[i] = rows_normal(12, i) + bend[1][i];
    twice[0][i] = bend[1][i];
    twice[1][i] = 4.0 * bend[1][i];
  }
  struct um_inference_direction d[2] = {direction_of(2, twice[0]), direction_of(1, bend[1])};
  struct um_inference_score s[2];
  assert_int_equal(um_inference_score_test(c, ROWS, r, NULL, 2, d, s), UM_OK);
  assert_close(s[0].dof, 1.0, 0.0);
  assert_close(s[0].statistic, s[1].statistic, 1e-10);
  assert_true(isnan(s[0].sigma[0]) && isnan(s[0].sigma[1]) && isfinite(s[1].sigma[0]));
}

/* Statistics whose p is no double any more are told apart still. */
static void test_underflow(void **state)
{
  struct um_context *c = *state;
  double r[ROWS] = {1e4, 2e2, 5e3}, column[3][ROWS] = {{0}};
  struct um_inference_direction d[3];
  struct um_inference_score s[3];
  for (size_t k = 0; k < 3; k++) {
    column[k][k] = 1.0;
    d[k] = direction_of(1, column[k]);
  }
  assert_int_equal(um_inference_score_test(c, ROWS, r, NULL, 3, d, s), UM_OK);
  for (size_t k = 0; k < 3; k++) {
    assert_close(s[k].statistic / (r[k] * r[k]), 1.0, 1e-14);
    assert_close(s[k].p, 0.0, 0.0);
    assert_close(s[k].p_corrected, 0.0, 0.0);
  }
}

/* The minimum over alternative and nuisances together by their normal equations. */
static void test_separation(void **state)
{
  struct um_context *c = *state;
  const double rival_width[2] = {0.5, INFINITY}, mean[4] = {0};
  const double width[4] = {2.0, INFINITY, 0.5, INFINITY};
  struct um_inference_direction d[3] = {direction_of(2, bend[0]), direction_of(1, bend[0]),
                                        direction_of(1, nuisance_column[2])};
  double signal[ROWS], column[4][ROWS], x[4], out[3];
  d[0].prior_sigma = rival_width;
  for (size_t i = 0; i < ROWS; i++) {
    signal[i] = 30.0 * sin(5.0 * at(i)) + 10.0 * bend[1][i];
    column[0][i] = nuisance_column[0][i];
    column[1][i] = nuisance_column[1][i];
    column[2][i] = bend[0][i];
    column[3][i] = bend[1][i];
  }
  assert_int_equal(um_inference_chi2_difference(c, ROWS, signal, &nuisance, 3, d, out), UM_OK);
  double expected = rows_normal_equations(ROWS, 4, column[0], signal, width, mean, x, NULL);
  assert_close(out[0] / expected, 1.0, 1e-10);
  const double any[3] = {2.0, INFINITY, INFINITY};
  expected = rows_normal_equations(ROWS, 3, column[0], signal, any, mean, x, NULL);
  assert_close(out[1] / expected, 1.0, 1e-10);
  /* one that is absorbed leaves what the nuisances leave */
  expected = rows_normal_equations(ROWS, 2, column[0], signal, any, mean, x, NULL);
  assert_close(out[2] / expected, 1.0, 1e-10);
  for (size_t i = 0; i < ROWS; i++) signal[i] = bend[1][i] + 7.0 * at(i);
  assert_int_equal(um_inference_chi2_difference(c, ROWS, signal, &nuisance, 1, d, out), UM_OK);
  assert_close(out[0], 0.0, 1e-20); /* it is the signal, with a nuisance */
}

static void test_refused(void **state)
{
  struct um_context *c = *state;
  const double column[3][2] = {{1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}}, r[2] = {1.0, 2.0};
  const double width[2] = {INFINITY, INFINITY};
  const struct um_inference_nuisance two = {2, column[0], width}, one = {1, column[0], width};
  struct um_inference_direction d = direction_of(1, column[2]);
  struct um_inference_score s;
  assert_int_equal(um_inference_score_test(c, 2, r, &two, 1, &d, &s), UM_ERR_INPUT);
  assert_string_equal(um_core_message(c), "2 nuisance parameters without prior and 2 measurements: "
                                          "at least one measurement more is needed");
  um_core_message_clear(c);
  assert_int_equal(um_inference_score_test(c, 2, r, &one, 1, &d, &s), UM_OK);
  assert_close(s.statistic, 4.0, 1e-14);
}

/* The least p of m orthogonal directions, each tried both ways, is below p in 1 - (1 - p)^m of the
 * draws; m times the same direction is one. Of 20000 draws within 4 of their standard errors. */
static void test_search(void **state)
{
  enum { DRAWS = 20000, MANY = 5 };
  struct um_context *c = *state;
  double column[MANY][ROWS] = {{0.0}}, p;
  struct um_inference_direction direction[MANY];
  for (size_t i = 0; i < MANY; i++) {
    column[i][3 * i + 1] = 2.0 + (double)i;
    direction[i] = direction_of(1, column[i]);
  }
  const double each = 0.01;
  for (size_t m = 1; m <= MANY; m += MANY - 1) {
    double expected = 1.0 - pow(1.0 - each, (double)m);
    assert_int_equal(um_inference_search_p(c, ROWS, NULL, m, direction, each, DRAWS, 7, &p), UM_OK);
    assert_close(p, expected, 4.0 * sqrt(expected * (1.0 - expected) / DRAWS));
  }
  for (size_t i = 0; i < MANY; i++) direction[i] = direction_of(1, column[0]);
  assert_int_equal(um_inference_search_p(c, ROWS, NULL, MANY, direction, each, DRAWS, 7, &p),
                   UM_OK);
  assert_close(p, each, 4.0 * sqrt(each * (1.0 - each) / DRAWS));
  assert_int_equal(um_inference_search_p(c, ROWS, &nuisance, MANY, direction, 0.0, 99, 7, &p),
                   UM_OK);
  assert_close(p, 0.01, 1e-12); /* as little as that many draws show */
}

static enum um_status everything(struct um_context *c)
{
  const double r[3] = {1.0, 2.0, 3.0};
  struct um_inference_direction d[2] = {direction_of(1, bend[0]), direction_of(2, bend[0])};
  struct um_inference_score s[2];
  const double width[1] = {2.0};
  const struct um_inference_nuisance n = {1, nuisance_column[0], width};
  const size_t channel[3] = {0};
  struct um_inference_whiteness w;
  double out[2];
  UM_TRY(um_inference_score_test(c, 3, r, &n, 2, d, s));
  UM_TRY(um_inference_chi2_difference(c, 3, r, &n, 2, d, out));
  return um_inference_whiteness_test(c, 3, r, channel, 1, 0.0, &w);
}

static void test_memory(void **state)
{
  (void)state;
  memory_sweep(everything, 40);
}

/* The best of many directions: p of one is made that of the largest of so many. */
static void test_best_of_many(void **state)
{
  struct um_context *c = *state;
  struct um_inference_score one, best;
  double r[ROWS];
  struct um_inference_direction d = direction_of(2, bend[0]);
  for (size_t i = 0; i < ROWS; i++) r[i] = 0.8 * bend[1][i] + 0.1 * bend[0][i];
  assert_int_equal(um_inference_score_test(c, ROWS, r, &nuisance, 1, &d, &one), UM_OK);
  d.trials = 20;
  assert_int_equal(um_inference_score_test(c, ROWS, r, &nuisance, 1, &d, &best), UM_OK);
  assert_true(one.p > 0.01 && one.p < 0.9);
  assert_true(fabs(best.p - (1.0 - pow(1.0 - one.p, 20.0))) < 1e-12);
  assert_true(best.statistic == one.statistic);
  assert_true(best.p_corrected == best.p);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_search),
                                     cmocka_unit_test(test_closed_form),
                                     cmocka_unit_test(test_priors_of_nuisances),
                                     cmocka_unit_test(test_absorbed),
                                     cmocka_unit_test(test_collinear_is_one_test),
                                     cmocka_unit_test(test_collinear_columns),
                                     cmocka_unit_test(test_underflow),
                                     cmocka_unit_test(test_separation),
                                     cmocka_unit_test(test_best_of_many),
                                     cmocka_unit_test(test_refused),
                                     cmocka_unit_test(test_memory),
                                     cmocka_unit_test(test_p_is_uniform),
                                     cmocka_unit_test(test_family_wise_rate)};
  return cmocka_run_group_tests(tests, set_up, context_tear_down);
}
