/* Noise beside the model: its roots and likelihood against dense matrices, what is estimated of
 * drawn noise, outliers, and a fit by generalised least squares. Draws are keyed. */
#include <string.h>

#include "base/inference/fit.h"
#include "base/inference/noise.h"
#include "base/inference/policy.h"

#include "tests/base/inference/observations_test.h"
#include "tests/support/memory_sweep.h"
#include "tests/support/with_context.h"

#define ROWS   120
#define LENGTH 6.0 /* rows over which a discrepancy is alike */

static size_t channel[ROWS];
static struct um_inference_correlation *smooth;
static struct um_inference_noise_family family;
static double root[ROWS][ROWS]; /* lower, of K in each channel */

/* Rows by turns of two channels. */
static double kernel(size_t i, size_t j)
{
  double away = sqrt(3.0) * fabs((double)i - (double)j) / LENGTH;
  return i % 2 != j % 2 ? 0.0 : 0.5 * ((1.0 + away) * exp(-away) + 1.0);
}

/* a [ROWS][ROWS] <- its Cholesky factor; returns ln det. */
static double cholesky(double a[ROWS][ROWS])
{
  double determinant = 0.0;
  for (size_t i = 0; i < ROWS; i++) {
    for (size_t j = 0; j <= i; j++) {
      double sum = a[i][j];
      for (size_t k = 0; k < j; k++) sum -= a[i][k] * a[j][k];
      a[i][j] = i == j ? sqrt(fmax(sum, 1e-14)) : sum / a[j][j];
    }
    determinant += 2.0 * log(a[i][i]);
  }
  return determinant;
}

/* r'C^-1 r + ln det C of C = scale^2 (I + ratio^2 K). */
static double dense(const double *r, double scale, double ratio)
{
  static double c[ROWS][ROWS];
  double quadratic = 0.0, y[ROWS];
  for (size_t i = 0; i < ROWS; i++)
    for (size_t j = 0; j < ROWS; j++)
      c[i][j] = scale * scale * ((double)(i == j) + ratio * ratio * kernel(i, j));
  double determinant = cholesky(c);
  for (size_t i = 0; i < ROWS; i++) {
    y[i] = r[i];
    for (size_t k = 0; k < i; k++) y[i] -= c[i][k] * y[k];
    y[i] /= c[i][i];
    quadratic += y[i] * y[i];
  }
  return quadratic + determinant;
}

static int set_up(void **state)
{
  double z[ROWS];
  if (context_set_up(state) != 0) return -1;
  for (size_t i = 0; i < ROWS; i++) {
    channel[i] = i % 2;
    z[i] = (double)i / LENGTH;
    for (size_t j = 0; j < ROWS; j++) root[i][j] = kernel(i, j) + 1e-10 * (double)(i == j);
  }
  cholesky(root);
  if (um_inference_correlation_create(context, "rows", ROWS, channel, 2, 1, z, &smooth) != UM_OK)
    return -1;
  family = (struct um_inference_noise_family){
      .nobservation = ROWS, .nchannel = 2, .channel = channel, .nkind = 1, .kind = &smooth};
  return 0;
}

static int tear_down(void **state)
{
  um_inference_correlation_destroy(context, &smooth);
  return context_tear_down(state);
}

/* scale (e + ratio times a draw of the kernel) */
static void draw(uint64_t key, double scale, double ratio, double *r)
{
  for (size_t i = 0; i < ROWS; i++) {
    r[i] = scale * rows_normal(key, i);
    for (size_t k = 0; k <= i; k++)
      r[i] += scale * ratio * root[i][k] * rows_normal(um_core_hash(key, 1), k);
  }
}

static struct um_inference_noise estimate(const double *r)
{
  struct um_inference_noise noise;
  assert_int_equal(um_inference_noise_estimate(context, &family, r, NULL, &noise), UM_OK);
  return noise;
}

/* Both channels with ratio 2 and scale 1.5: |C^-1/2 r|^2 and the estimated worth against dense
 * matrices; the kernel's smallest eigenvalues, 1e-4 of its trace, are left out. */
static void test_root_and_worth(void **state)
{
  double r[ROWS], v[ROWS], square = 0.0;
  draw(um_core_hash(41, 0), 1.5, 2.0, r);
  struct um_inference_noise noise = estimate(r);
  (void)state;
  double scale = 1.5, ratio = 2.0;
  noise.channel[0] = noise.channel[1] = (struct um_inference_noise_channel){scale, ratio, 0};
  memcpy(v, r, sizeof v);
  um_inference_noise_whiten(&noise, v);
  for (size_t i = 0; i < ROWS; i++) square += v[i] * v[i];
  um_inference_noise_colour(&noise, v);
  for (size_t i = 0; i < ROWS; i++) assert_close(v[i], r[i], 1e-10);
  double zero[ROWS] = {0.0};
  assert_close(square, dense(r, scale, ratio) - dense(zero, scale, ratio), 1e-2 * square);
  um_inference_noise_release(context, &noise);
}

/* The estimated maximum is one of the dense likelihood of each channel; each number costs ln n. */
static void test_likelihood(void **state)
{
  double r[ROWS], numbers = 0.0;
  (void)state;
  draw(um_core_hash(42, 0), 1.0, 3.0, r);
  struct um_inference_noise noise = estimate(r);
  double sum = 0.0, zero[ROWS] = {0.0};
  for (size_t c = 0; c < 2; c++) { /* the other channel's rows at 0 leave half of ln det */
    double own[ROWS] = {0.0}, scale = noise.channel[c].scale, ratio = noise.channel[c].ratio;
    for (size_t i = 0; i < ROWS; i++)
      if (channel[i] == c) own[i] = r[i];
    double here = dense(own, scale, ratio), base = 0.5 * dense(zero, scale, ratio);
    for (double f = 0.8; f < 1.3; f += 0.4)
      assert_true(here - base <
                  dense(own, scale, ratio * f) - 0.5 * dense(zero, scale, ratio * f) + 1e-3);
    sum += here - base;
    numbers += ratio > 0.0 ? 1.0 : 0.0;
    numbers += scale != 1.0 ? 1.0 : 0.0;
  }
  assert_close(noise.worth, sum + numbers * log(ROWS), 0.05);
  um_inference_noise_release(context, &noise);
}

/* White noise stays white: at ln 120 = 4.8 a number, two channels, chance takes up one in 30. Of
 * noise that scatters 1.5 times what is said the scale is found within its error sqrt(1 / 2n) each,
 * of a discrepancy of ratio 3 the ratio within the scatter of its level and ten lengths, 25 %. */
static void test_estimates(void **state)
{
  enum { DRAWS = 200 };
  double r[ROWS], scale = 0.0, ratio = 0.0;
  size_t white = 0;
  (void)state;
  for (uint64_t k = 0; k < DRAWS; k++) {
    draw(um_core_hash(43, k), 1.0, 0.0, r);
    struct um_inference_noise noise = estimate(r);
    white += um_inference_noise_is_white(&noise);
    um_inference_noise_release(context, &noise);
    draw(um_core_hash(44, k), 1.5, 0.0, r);
    noise = estimate(r);
    scale += noise.channel[0].scale / DRAWS;
    um_inference_noise_release(context, &noise);
    draw(um_core_hash(45, k), 1.0, 3.0, r);
    noise = estimate(r);
    ratio += log(noise.channel[0].ratio / 3.0) / DRAWS;
    um_inference_noise_release(context, &noise);
  }
  print_message("white %zu of %d, scale %.3f, ratio exp(%.3f)\n", white, DRAWS, scale, ratio);
  assert_true((double)white >= 0.93 * DRAWS);
  assert_close(scale, 1.5, 0.045);
  assert_close(ratio, 0.0, 0.15);
}

/* Whose sigma is mostly the model's: noise of 0.3 sigma and a discrepancy of 0.9, both found within
 * their scatter of 9 % and 25 %, and of noise of 0.3 sigma alone nothing but by chance. */
static void test_less_than_stated(void **state)
{
  enum { DRAWS = 100 };
  double r[ROWS], scale = 0.0, ratio = 0.0;
  size_t white = 0;
  (void)state;
  for (uint64_t k = 0; k < DRAWS; k++) {
    draw(um_core_hash(50, k), 0.3, 3.0, r);
    struct um_inference_noise noise = estimate(r);
    scale += log(noise.channel[0].scale / 0.3) / DRAWS;
    ratio += log(fmax(noise.channel[0].ratio, 0.02) / 3.0) / DRAWS;
    um_inference_noise_release(context, &noise);
    draw(um_core_hash(51, k), 0.3, 0.0, r);
    noise = estimate(r);
    white += um_inference_noise_is_white(&noise);
    um_inference_noise_release(context, &noise);
  }
  print_message("white %zu of %d, scale 0.3 exp(%.3f), ratio 3 exp(%.3f)\n", white, DRAWS, scale,
                ratio);
  assert_true((double)white >= 0.93 * DRAWS);
  assert_close(scale, 0.0, 0.06);
  assert_close(ratio, 0.0, 0.2);
}

/* A level of 10 sigma where discrepancies are usually 2: it costs (10 / 2)^2 more than where any is
 * as good, less what a smaller one in its place saves; one of 1 sigma hardly anything. */
static void test_usual(void **state)
{
  static const double usual[2] = {2.0, 2.0};
  struct um_inference_noise_family any = family;
  double worth[2][2];
  (void)state;
  for (size_t large = 0; large < 2; large++)
    for (size_t i = 0; i < 2; i++) {
      double r[ROWS];
      draw(um_core_hash(52, 0), 1.0, 0.0, r);
      for (size_t k = 0; k < ROWS; k += 2) r[k] += large != 0 ? 10.0 : 1.0;
      family.usual = i == 0 ? NULL : usual;
      struct um_inference_noise noise = estimate(r);
      worth[large][i] = noise.worth;
      um_inference_noise_release(context, &noise);
    }
  family = any;
  print_message("costs %.2f, %.2f\n", worth[0][1] - worth[0][0], worth[1][1] - worth[1][0]);
  assert_close(worth[0][1] - worth[0][0], 0.25, 0.15);
  assert_close(worth[1][1] - worth[1][0], 25.0, 2.5);
}

/* Four spikes of 8 to 14 sigma are set aside on white noise; on a discrepancy, which a spike's
 * neighbours foretell less well, two in three. Three neighbours that are off alike, as in a glint
 * that the model misses, are not. */
static void test_outliers(void **state)
{
  static const size_t spike[4] = {11, 40, 77, 102};
  size_t found = 0;
  (void)state;
  for (uint64_t k = 0; k < 40; k++) {
    double r[ROWS];
    draw(um_core_hash(46, k), 1.0, k % 2 == 0 ? 0.0 : 3.0, r);
    for (size_t s = 0; s < 4; s++)
      r[spike[s]] += (s % 2 == 0 ? 1.0 : -1.0) * (8.0 + 2.0 * (double)s);
    struct um_inference_noise noise = estimate(r);
    size_t here = 0;
    for (size_t s = 0; s < 4; s++) here += noise.factor[spike[s]] > 1.0;
    assert_int_equal(here, noise.noutlier); /* and no other */
    if (k % 2 == 0)
      assert_int_equal(here, 4);
    else
      found += here;
    um_inference_noise_release(context, &noise);
  }
  print_message("%zu of 80 on a discrepancy\n", found);
  assert_true(found >= 53);
  double r[ROWS];
  draw(um_core_hash(47, 0), 1.0, 0.0, r);
  for (size_t i = 50; i < 56; i += 2) r[i] += 9.0;
  struct um_inference_noise noise = estimate(r);
  assert_int_equal(noise.noutlier, 0);
  um_inference_noise_release(context, &noise);
}

/* A slope beside a discrepancy: a fit with its noise scatters as its sigma says, one without by
 * several times that. */
struct line {
  double x[ROWS];
};

static enum um_status evaluate(struct um_context *c, void *user, const double *x, double *value)
{
  const struct line *line = user;
  (void)c;
  for (size_t i = 0; i < ROWS; i++) value[i] = x[0] * line->x[i];
  return UM_OK;
}

static double pull_of(uint64_t key, bool with, double *sigma_of)
{
  struct line line;
  double r[ROWS], sigma[ROWS];
  draw(key, 1.0, 3.0, r);
  for (size_t i = 0; i < ROWS; i++) {
    line.x[i] = (double)i / ROWS - 0.5;
    sigma[i] = 0.5;
    r[i] = 0.5 * r[i] + 2.0 * line.x[i];
  }
  struct um_inference_noise noise = {0};
  assert_int_equal(um_inference_noise_estimate(context, &family, r, NULL, &noise), UM_OK);
  noise.channel[0] = noise.channel[1] = (struct um_inference_noise_channel){1.0, 3.0, 0};
  const struct um_inference_fit_parameter p = {
      .minimum = -INFINITY, .maximum = INFINITY, .prior_sigma = INFINITY, .step = 0.1};
  struct um_inference_fit_problem problem = {.nobservation = ROWS,
                                             .nparameter = 1,
                                             .measured = r,
                                             .sigma = sigma,
                                             .parameter = &p,
                                             .evaluate = evaluate,
                                             .user = &line,
                                             .noise = with ? &noise : NULL};
  struct um_inference_fit *fit = NULL;
  assert_int_equal(um_inference_fit_create(context, &problem, &fit), UM_OK);
  double pull = (fit->x[0] - 2.0) / fit->sigma[0];
  for (size_t i = 0; i < ROWS; i++) /* residual and Jacobian are over sigma alone */
    assert_close(fit->residual[i], (r[i] - fit->value[i]) / 0.5, 1e-9);
  *sigma_of = fit->sigma[0];
  um_inference_fit_destroy(context, &fit);
  um_inference_noise_release(context, &noise);
  return pull;
}

static void test_fit(void **state)
{
  enum { DRAWS = 300 };
  double with = 0.0, without = 0.0, sigma;
  (void)state;
  for (uint64_t k = 0; k < DRAWS; k++) {
    with += pow(pull_of(um_core_hash(48, k), true, &sigma), 2.0) / DRAWS;
    without += pow(pull_of(um_core_hash(48, k), false, &sigma), 2.0) / DRAWS;
  }
  print_message("rms pull %.3f with the noise, %.2f without\n", sqrt(with), sqrt(without));
  assert_close(sqrt(with), 1.0, 4.0 / sqrt(2.0 * DRAWS));
  assert_true(without > 4.0);
}

static double swept[ROWS];

static enum um_status everything(struct um_context *c)
{
  struct um_inference_noise noise;
  struct um_inference_correlation *k = NULL;
  double z[ROWS];
  for (size_t i = 0; i < ROWS; i++) z[i] = (double)i / LENGTH;
  enum um_status status = um_inference_correlation_create(c, "", ROWS, channel, 2, 1, z, &k);
  if (status == UM_OK) {
    struct um_inference_noise_family f = {
        .nobservation = ROWS, .nchannel = 2, .channel = channel, .nkind = 1, .kind = &k};
    status = um_inference_noise_estimate(c, &f, swept, NULL, &noise);
    if (status == UM_OK) um_inference_noise_release(c, &noise);
  }
  um_inference_correlation_destroy(c, &k);
  return status;
}

static void test_memory(void **state)
{
  (void)state;
  draw(um_core_hash(49, 0), 1.0, 1.0, swept);
  swept[30] += 12.0;
  memory_sweep(everything, 20);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_root_and_worth),
                                     cmocka_unit_test(test_likelihood),
                                     cmocka_unit_test(test_estimates),
                                     cmocka_unit_test(test_less_than_stated),
                                     cmocka_unit_test(test_usual),
                                     cmocka_unit_test(test_outliers),
                                     cmocka_unit_test(test_fit),
                                     cmocka_unit_test(test_memory)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
