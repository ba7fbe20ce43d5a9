/* Roughness from heights: waves in closed form, a surface of Gaussian autocorrelation, refusals. */
#include "check.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "materials/profile.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

static enum um_status read_text(const char *text, struct um_materials_heights *out)
{
  char path[UM_TEST_PATH];
  um_test_file_create(path, text, strlen(text));
  um_core_message_clear(context);
  enum um_status status = um_materials_heights_read(context, path, out);
  unlink(path);
  return status;
}

/* h = a cos(k x) on a slope: Rq = a/sqrt(2), C(s) = cos(k s), which is 0.2 at acos(0.2)/k. 100
 * periods of 64 steps, symmetric about the middle, so that the line taken off is the slope alone.
 * 2e-3: linear between steps 3e-4, and of 100 periods a part of one is cut by the shift. */
static void a_wave(void **state)
{
  enum { N = 6401 };
  static char text[N * 40];
  struct um_materials_heights h;
  struct um_materials_slope r;
  char *at = text + sprintf(text, "x_um,height_um\n");
  double k = 2.0 * UM_PI / 32.0; /* [1/um], steps of 0.5 um */
  (void)state;
  for (int i = 0; i < N; i++)
    at += sprintf(at, "%.1f,%.9f\n", 0.5 * i, 0.3 * cos(k * 0.5 * (i - N / 2)) + 0.01 * i + 5.0);
  assert_int_equal(read_text(text, &h), UM_OK);
  assert_int_equal(um_materials_heights_roughness(context, &h, &r), UM_OK);
  check_near("Rq", r.rq / (0.3e-6 / sqrt(2.0)), 1.0, 1e-3);
  check_near("tau", r.tau / (acos(0.2) / k * 1e-6), 1.0, 2e-3);
  check_near("alpha", r.alpha, sqrt(2.0) * r.rq / r.tau, 1e-15);
  /* docs/physics/roughness-and-lobes.md */
  check_near("alpha, Gaussian", r.alpha_gaussian / r.alpha, 1.794, 5e-4);
  um_materials_heights_free(context, &h);
}

/* cos(k x) cos(k y/2) falls first along x: along (1, 1) cos(t) cos(t/2) = 0.2 further out, and so
 * along (2, 1). The other way round along y. Rq = a/2. */
static void crossed_waves(void **state)
{
  enum { N = 257 };
  static char text[N * N * 32];
  (void)state;
  for (int turn = 0; turn < 2; turn++) {
    struct um_materials_heights h;
    struct um_materials_slope r;
    double k = 2.0 * UM_PI / 16.0;
    char *at = text + sprintf(text, "x_um,y_um,height_um\n");
    for (int j = 0; j < N; j++)
      for (int i = 0; i < N; i++) {
        double x = k * (turn == 0 ? i : j), y = 0.5 * k * (turn == 0 ? j : i);
        at += sprintf(at, "%d,%d,%.7f\n", i, j, 2.0 * cos(x) * cos(y));
      }
    assert_int_equal(read_text(text, &h), UM_OK);
    assert_int_equal(um_materials_heights_roughness(context, &h, &r), UM_OK);
    check_near("Rq", r.rq / 1e-6, 1.0, 1e-2);
    check_near("tau", r.tau / (acos(0.2) / k * 1e-6), 1.0, 1e-2);
    um_materials_heights_free(context, &h);
  }
}

/* 600 waves of random direction with k of variance 2/T^2 per axis make C = exp(-(s/T)^2): the root
 * of the mean square slope, which is known of the waves that were drawn, is Beckmann's alpha. A map
 * of 64 T by 64 T holds 2600 areas pi T^2/2: C to 2 %, hence tau, where C falls by 0.51/T, to 3 %;
 * the smallest of 8 directions is some 4 % low. */
static void a_gaussian_surface(void **state)
{
  enum { N = 384, WAVES = 600 };
  struct um_materials_heights h = {.nx = N, .ny = N, .dx = 1e-6, .dy = 1e-6};
  struct um_materials_slope r;
  double t = 6.0, slope2 = 0.0, a = 0.1e-6;
  (void)state;
  h.height = calloc(N * N, sizeof *h.height);
  assert_non_null(h.height);
  for (uint64_t w = 0; w < WAVES; w++) {
    double u[2];
    um_core_sample_2d(3, w, u);
    double size = sqrt(-2.0 * log(1.0 - u[0])) * sqrt(2.0) / t, phi = 2.0 * UM_PI * u[1];
    double kx = size * cos(phi), ky = size * sin(phi);
    double phase = 2.0 * UM_PI * um_core_hash_uniform(um_core_hash(9, w));
    slope2 += 0.5 * a * a * size * size * 1e12;
    for (int j = 0; j < N; j++)
      for (int i = 0; i < N; i++) h.height[j * N + i] += a * cos(kx * i + ky * j + phase);
  }
  assert_int_equal(um_materials_heights_roughness(context, &h, &r), UM_OK);
  print_message("root mean square slope %.4f, alpha of its autocorrelation %.4f, as Table 1 %.4f\n",
                sqrt(slope2), r.alpha_gaussian, r.alpha);
  check_near("alpha", r.alpha_gaussian / sqrt(slope2), 1.0, 0.08);
  free(h.height);
}

static void refused(const char *text, const char *line, const char *word)
{
  struct um_materials_heights h;
  assert_int_equal(read_text(text, &h), UM_ERR_INPUT);
  assert_null(h.height);
  if (strstr(um_core_message(context), line) == NULL ||
      strstr(um_core_message(context), word) == NULL)
    fail_msg("'%s' lacks '%s' or '%s'", um_core_message(context), line, word);
}

#define FIFTEEN "0,1\n1,2\n2,1\n3,2\n4,1\n5,2\n6,1\n7,2\n8,1\n9,2\n10,1\n11,2\n12,1\n13,2\n14,1\n"

static void what_is_refused(void **state)
{
  struct um_materials_heights h;
  struct um_materials_slope r;
  (void)state;
  refused("x_um,height_um\n0,1\n1,2\n", "", "16 or more");
  refused("x_um,z\n" FIFTEEN "15,1\n", "", "height_um");
  refused("x_um,height_um\n" FIFTEEN "16,1\n", ":17:", "without a gap");
  refused("x_um,height_um\n" FIFTEEN "15,nan\n", ":17:", "height_um");
  refused("x_um,height_um\n1,1\n" FIFTEEN, ":3:", "ascending");
  refused(
      "x_um,y_um,height_um\n0,0,1\n1,0,1\n2,0,1\n3,0,1\n0,1,1\n1,1,1\n2,1,1\n3,1,1\n0,2,1\n1,2,1"
      "\n2,2,1\n3,2,1\n0,3,1\n1,3,1\n2,3,1\n3,3,1\n0,4,1\n",
      ":18:", "as many");
  assert_int_equal(
      read_text("x_um,height_um\n0,0\n1,0\n2,0\n3,0\n4,0\n5,0\n6,0\n7,0\n8,0\n9,0\n10,0\n"
                "11,0\n12,0\n13,0\n14,0\n15,0\n",
                &h),
      UM_OK);
  assert_int_equal(um_materials_heights_roughness(context, &h, &r), UM_ERR_INPUT);
  um_materials_heights_free(context, &h);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(a_wave, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(crossed_waves, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(a_gaussian_surface, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(what_is_refused, context_set_up, context_tear_down),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
