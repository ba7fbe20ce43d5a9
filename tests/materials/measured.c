/* Measured tables over the hemisphere: what is refused, with its line; tables made of lobes in
 * closed form give them back between their nodes, the better the finer they are; what is found not
 * reciprocal or above one is reported; a record of one absorbs and emits what it does not reflect.
 */
#include "check.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/core/sampling.h"
#include "tests/materials/table.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

static struct um_materials_lobe lobe_of(const char *kind, double alpha)
{
  return (struct um_materials_lobe){
      .kind = um_materials_lobe_kind_find(kind), .alpha = alpha, .alpha_across = alpha};
}

/* --- files ----------------------------------------------------------------------------------- */

#define HEAD "incidence_deg,scattering_deg,azimuth_deg,brdf_1_sr\n"

/* A whole file: f(i, o, phi) of four polar angles to `reach` and azimuths in steps. */
struct written {
  double reach, turn, last; /* [deg] */
  double from;              /* the last incidence, 0: as reach [deg] */
  size_t skip, twice;       /* row left out, row written two times; 0: none */
  size_t row;               /* whose text is `text` */
  const char *text;
};

static enum um_status read_written(const struct written *w, struct um_materials_measured_grid *grid)
{
  char path[UM_TEST_PATH], *text = malloc(1 << 20), *at = text;
  size_t n = 0;
  at += sprintf(at, HEAD);
  for (int i = 0; i < 4; i++)
    for (int o = 0; o < 4; o++)
      for (double phi = 0.0; phi <= w->last; phi += w->turn) {
        n++;
        if (n == w->skip) continue;
        for (int k = 0; k < (n == w->twice ? 2 : 1); k++)
          at += n == w->row
                    ? sprintf(at, "%s\n", w->text)
                    : sprintf(at, "%g,%g,%g,%g\n", i / 3.0 * (w->from > 0.0 ? w->from : w->reach),
                              o / 3.0 * w->reach, phi, 0.2 + 0.01 * i + 0.001 * o + 1e-5 * phi);
      }
  um_test_file_create(path, text, (size_t)(at - text));
  um_core_message_clear(context);
  enum um_status status = um_materials_measured_read(context, path, grid);
  unlink(path);
  free(text);
  return status;
}

static void refused(struct written w, const char *line, const char *word)
{
  struct um_materials_measured_grid grid;
  if (w.reach == 0.0) w.reach = 81.0;
  if (w.turn == 0.0) w.turn = 45.0;
  if (w.last == 0.0) w.last = 180.0;
  assert_int_equal(read_written(&w, &grid), UM_ERR_INPUT);
  assert_null(grid.f);
  if (strstr(um_core_message(context), line) == NULL ||
      strstr(um_core_message(context), word) == NULL)
    fail_msg("'%s' lacks '%s' or '%s'", um_core_message(context), line, word);
}

/* Line = row + 1; five azimuths a pair. */
static void what_is_refused(void **state)
{
  (void)state;
  refused((struct written){.row = 7, .text = "0,27,45,-0.1"}, ":8: ", "1e-12 to 1e+09 [1/sr]");
  refused((struct written){.row = 7, .text = "0,27,45,0"}, ":8: ", "limit of detection");
  refused((struct written){.row = 7, .text = "0,27,45,nan"}, ":8: ", "brdf_1_sr");
  refused((struct written){.row = 7, .text = "0,27,45,1e99"}, ":8: ", "1e+09");
  refused((struct written){.row = 7, .text = "0,27,,1"}, ":8: ", "azimuth_deg");
  refused((struct written){.row = 7, .text = "0,27,361,1"}, ":8: ", "0 to 360 [deg]");
  refused((struct written){.row = 7, .text = "0,91,45,1"}, ":8: ", "0 to 90 [deg]");
  refused((struct written){.row = 7, .text = "0,27,50,1"}, ":8: ", "50 where 45 is expected");
  refused((struct written){.row = 1, .text = "0,0,1,1"}, ":2: ", "begins at 1");
  refused((struct written){.skip = 37}, ":38: ", "90 where 45 is expected");
  refused((struct written){.skip = 80}, ":80: ", "ends within the incidence of 81 deg");
  refused((struct written){.twice = 37}, ":39: ", "45 where 90 is expected");
  refused((struct written){.row = 3, .text = "0,0,40,1"}, ":4: ", "40 follows 45");
  refused((struct written){.reach = 60.0}, "scattering_deg", "measured to 75 deg or more");
  refused((struct written){.last = 135.0}, "azimuth_deg", "from 0 to 180");
  refused((struct written){.last = 270.0}, "azimuth_deg", "on the other side");
  refused((struct written){.turn = 180.0}, "", "2 azimuths");
  refused((struct written){.from = 54.0}, ":81: ", "4 incidences to 54");
  refused((struct written){.from = 63.0}, ":22: ", "21 is no angle of reflection");
  struct um_materials_measured_grid grid;
  assert_int_equal(um_materials_measured_read(context, "/nowhere", &grid), UM_ERR_IO);
}

/* Both sides count, each half: values to 180 deg are the mean with those at 360 - phi, which are
 * larger by 1e-5 (360 - 2 phi) where the file is linear in phi. */
static void both_sides(void **state)
{
  struct um_materials_measured_grid one, two;
  (void)state;
  assert_int_equal(
      read_written(&(struct written){.reach = 81.0, .turn = 45.0, .last = 180.0}, &one), UM_OK);
  assert_int_equal(
      read_written(&(struct written){.reach = 81.0, .turn = 45.0, .last = 315.0}, &two), UM_OK);
  assert_int_equal(one.npolar, 4);
  assert_int_equal(one.nazimuth, 5);
  assert_int_equal(two.nazimuth, 5);
  check_near("pi", two.azimuth[4], UM_PI, 0.0);
  assert_true(one.sides == 0.0 && two.sides > 0.0);
  for (size_t k = 0; k < 5; k++) {
    double turn = k == 0 ? 0.0 : 1e-5 * (180.0 - 45.0 * (double)k);
    check_near("mean of both sides", two.f[35 + k] - one.f[35 + k], turn, 1e-12);
  }
  um_materials_measured_grid_free(context, &one);
  um_materials_measured_grid_free(context, &two);
}

/* --- values ---------------------------------------------------------------------------------- */

struct errors {
  double rms, largest, peak; /* of ln f; peak: rms near the mirror direction */
};

/* Against the closed form off the nodes, to 80 deg: all over, and within one alpha of the mirror
 * direction. */
static struct errors compare(const struct test_brdf *b, double step, double turn)
{
  enum { N = 4000 };
  struct um_materials_measured_grid grid = test_grid(b, step, 85.0, turn);
  struct um_materials_measured *m;
  struct errors e = {0.0, 0.0, 0.0};
  assert_int_equal(um_materials_measured_create(context, &grid, false, &m), UM_OK);
  for (uint64_t n = 0; n < 2 * N; n++) {
    double u[2], v[2], most = 80.0 * UM_DEG;
    um_core_sample_2d(1, n, u);
    um_core_sample_2d(2, n, v);
    double i = u[0] * most, o = u[1] * most, phi = v[0] * UM_PI;
    if (n % 2 == 1) {
      o = fmin(fmax(0.0, i + 2.0 * (u[1] - 0.5) * b->lobe.alpha), most);
      phi = v[0] * b->lobe.alpha;
    }
    struct um_materials_pair pair = test_pair(i, o, phi);
    double f = um_materials_measured_evaluate(m, pair.cos_i, pair.cos_o, pair.cos_d);
    double d = log(f / test_brdf_at(b, i, o, phi));
    if (n % 2 == 1)
      e.peak += d * d / N;
    else
      e.rms += d * d / N;
    e.largest = fmax(e.largest, fabs(d));
  }
  for (double zenith = 0.0; zenith <= 70.0; zenith += 10.0) {
    double c = cos(zenith * UM_DEG);
    /* what lies beyond 85 deg is that of 85 deg: 1e-3 of a lobe that rises toward grazing */
    check_near("albedo of a table", um_materials_measured_albedo(m, c),
               b->diffuse + b->rest * um_materials_lobe_albedo(&b->lobe, c), 2e-3);
  }
  um_materials_measured_destroy(context, &m);
  test_grid_free(&grid);
  e.rms = sqrt(e.rms);
  e.peak = sqrt(e.peak);
  return e;
}

/* Steps of a third of alpha or less hold the peak to 1.5 % and all else to 0.5 % rms; halving
 * them, of the third order near a smooth peak, gains a factor of 6 and more. Ashikhmin & Shirley
 * have a kink where cos_i = cos_o: second order there and 3 % at most. */
static void between_the_nodes(void **state)
{
  static const struct {
    const char *kind;
    double alpha, gain;
    struct errors bound; /* of steps of 5 deg; all but one of +- 0.1 share/pi below */
  } lobes[] = {
      {"ggx", 0.3, 6.0, {5e-4, 0.02, 4e-3}},
      {"ggx", 0.2, 6.0, {1e-3, 0.1, 0.015}},
      {"beckmann", 0.3, 6.0, {1e-3, 0.05, 4e-3}},
      {"ashikhmin_shirley", 0.3, 2.5, {2e-3, 0.06, 8e-3}},
      {"phong", 0.3, 2.0, {2e-3, 0.06, 8e-3}},
  };
  (void)state;
  for (size_t k = 0; k < sizeof lobes / sizeof lobes[0]; k++) {
    const struct test_brdf b = {lobe_of(lobes[k].kind, lobes[k].alpha), 0.1, 0.5};
    struct errors coarse = compare(&b, 5.0, 5.0), fine = compare(&b, 2.5, 2.5);
    print_message("%-18s alpha %.1f: rms %.2e, near the mirror direction %.2e, most %.2e; half the "
                  "steps %.2e, %.2e, %.2e\n",
                  lobes[k].kind, lobes[k].alpha, coarse.rms, coarse.peak, coarse.largest, fine.rms,
                  fine.peak, fine.largest);
    assert_true(coarse.rms <= lobes[k].bound.rms && coarse.peak <= lobes[k].bound.peak);
    assert_true(coarse.largest <= lobes[k].bound.largest);
    assert_true(fine.peak * lobes[k].gain <= coarse.peak);
  }
}

/* On a node the value is what was measured, where that was reciprocal; beyond the last angle that
 * of the last; the azimuth of a direction along the normal does not matter; what is continued
 * through the normal has no kink: both one-sided slopes across it agree. */
static void on_the_nodes(void **state)
{
  const struct test_brdf b = {lobe_of("ggx", 0.35), 0.05, 0.7};
  struct um_materials_measured_grid grid = test_grid(&b, 5.0, 85.0, 10.0);
  struct um_materials_measured *m;
  (void)state;
  assert_int_equal(um_materials_measured_create(context, &grid, false, &m), UM_OK);
  for (size_t a = 0; a < grid.npolar; a += 2)
    for (size_t c = 1; c < grid.npolar; c += 3)
      for (size_t k = 0; k < grid.nazimuth; k += 2) {
        struct um_materials_pair p = test_pair(grid.polar[a], grid.polar[c], grid.azimuth[k]);
        double f = grid.f[(a * grid.npolar + c) * grid.nazimuth + k];
        check_near("on a node", um_materials_measured_evaluate(m, p.cos_i, p.cos_o, p.cos_d) / f,
                   1.0, 1e-6); /* acos near 0 and pi */
      }
  double wide = 85.0 * UM_DEG, i = 40.0 * UM_DEG, step = 1e-4;
  struct um_materials_pair last = test_pair(i, wide, 1.0), beyond = test_pair(i, 1.02 * wide, 1.0);
  check_near("beyond the last",
             um_materials_measured_evaluate(m, beyond.cos_i, beyond.cos_o, beyond.cos_d) /
                 um_materials_measured_evaluate(m, last.cos_i, last.cos_o, last.cos_d),
             1.0, 1e-9);
  double f[3]; /* in the plane of incidence across the normal */
  for (int k = -1; k <= 1; k++) {
    struct um_materials_pair p = test_pair(i, fabs(k * step), k < 0 ? UM_PI : 0.0);
    f[k + 1] = um_materials_measured_evaluate(m, p.cos_i, p.cos_o, p.cos_d);
  }
  check_near("slope across the normal", (f[2] - f[1]) / (f[1] - f[0]), 1.0, 0.01);
  um_materials_measured_destroy(context, &m);
  test_grid_free(&grid);
}

/* Incidences every 15 deg to 75 among reflections every 2.5 deg to 85: to 75 deg within 1 % rms of
 * the closed form between all nodes, as reciprocity gives what lies on either and the rest goes
 * with the mirror direction. Each incidence from its neighbours 30 deg apart is worse, which is
 * what left_out says. Read from a file the grid is the same. */
static void incidences_between(void **state)
{
  static const struct {
    const char *kind;
    double alpha, bound;
  } lobes[] = {{"ggx", 0.3, 4e-3},
               {"beckmann", 0.2, 8e-3},
               {"beckmann", 0.5, 0.01},
               {"ashikhmin_shirley", 0.3, 8e-3},
               {"phong", 0.5, 0.01}};
  (void)state;
  for (size_t k = 0; k < sizeof lobes / sizeof lobes[0]; k++) {
    const struct test_brdf b = {lobe_of(lobes[k].kind, lobes[k].alpha), 0.1, 0.5};
    struct um_materials_measured_grid grid = test_grid(&b, 2.5, 85.0, 5.0), read;
    struct um_materials_measured *m;
    double squares = 0.0;
    test_grid_thin(&grid, 6, 75.0);
    if (k == 0) {
      char path[UM_TEST_PATH];
      um_test_file_create(path, "", 0);
      test_grid_write(&grid, path);
      assert_int_equal(um_materials_measured_read(context, path, &read), UM_OK);
      unlink(path);
      assert_int_equal(read.npolar, grid.npolar);
      for (size_t n = 0; n < grid.npolar * grid.npolar * grid.nazimuth; n++)
        check_near("as written", read.f[n], grid.f[n], 1e-15);
      for (size_t a = 0; a < grid.npolar; a++) assert_true(read.known[a] == grid.known[a]);
      um_materials_measured_grid_free(context, &read);
    }
    assert_int_equal(um_materials_measured_create(context, &grid, false, &m), UM_OK);
    for (uint64_t n = 0; n < 4000; n++) {
      double u[2], v[2], most = 75.0 * UM_DEG;
      um_core_sample_2d(1, n, u);
      um_core_sample_2d(2, n, v);
      struct um_materials_pair p = test_pair(u[0] * most, u[1] * most, v[0] * UM_PI);
      double f = um_materials_measured_evaluate(m, p.cos_i, p.cos_o, p.cos_d);
      squares += pow(log(f / test_brdf_at(&b, u[0] * most, u[1] * most, v[0] * UM_PI)), 2.0) / 4000;
    }
    struct um_materials_measured_found found = um_materials_measured_found(m);
    print_message("%s, alpha %g: rms %.2e, left out %.2e\n", lobes[k].kind, lobes[k].alpha,
                  sqrt(squares), found.left_out);
    assert_int_equal(found.incidences, 6);
    check_near("asymmetry", found.asymmetry, 0.0, 1e-12);
    assert_true(sqrt(squares) <= lobes[k].bound);
    assert_true(found.left_out > sqrt(squares) && found.left_out < 0.1);
    um_materials_measured_destroy(context, &m);
    test_grid_free(&grid);
  }
}

/* --- what is found --------------------------------------------------------------------------- */

/* f(i, o) e^a for i < o and e^-a the other way: |ln of both| = 2 a everywhere, the mean cosh(a) f;
 * one pair that is further off is named. */
static void not_reciprocal(void **state)
{
  const double a = 0.1;
  const struct test_brdf b = {lobe_of("ggx", 0.4), 0.2, 0.3};
  struct um_materials_measured_grid grid = test_grid(&b, 5.0, 85.0, 15.0);
  struct um_materials_measured *m;
  size_t n = grid.npolar, na = grid.nazimuth;
  (void)state;
  for (size_t k = 0; k < n * n * na; k++) {
    size_t i = k / na / n, o = k / na % n;
    grid.f[k] *= i < o ? exp(a) : i > o ? exp(-a) : 1.0;
  }
  assert_int_equal(um_materials_measured_create(context, &grid, false, &m), UM_OK);
  struct um_materials_measured_found found = um_materials_measured_found(m);
  check_near("asymmetry", found.asymmetry, 2.0 * a, 1e-12);
  check_near("largest", found.largest, 2.0 * a, 1e-12);
  struct um_materials_pair p = test_pair(grid.polar[4], grid.polar[9], grid.azimuth[6]);
  check_near("mean of both ways",
             um_materials_measured_evaluate(m, p.cos_i, p.cos_o, p.cos_d) /
                 test_brdf_at(&b, grid.polar[4], grid.polar[9], grid.azimuth[6]),
             cosh(a), 1e-7);
  um_materials_measured_destroy(context, &m);
  grid.f[(3 * n + 7) * na + 2] *= 2.0;
  assert_int_equal(um_materials_measured_create(context, &grid, false, &m), UM_OK);
  found = um_materials_measured_found(m);
  check_near("largest", found.largest, 2.0 * a + log(2.0), 1e-12);
  check_near("incidence", found.largest_at[0], 15.0 * UM_DEG, 1e-12);
  check_near("reflection", found.largest_at[1], 35.0 * UM_DEG, 1e-12);
  check_near("azimuth", found.largest_at[2], 30.0 * UM_DEG, 1e-12);
  um_materials_measured_destroy(context, &m);
  test_grid_free(&grid);
}

/* Lambert's 1.1/pi: 1.1 of what arrives, renormalised 1/pi. And f = (0.5 + c sin^2 i sin^2 o)/pi,
 * of which E(o) = 0.5 + c sin^2 o/2: with c 2.4 it is 1.7 at grazing and above 1 from 40.2 deg on.
 * Renormalised it is 1 at most, still reciprocal, and the same toward the normal. */
static void above_one(void **state)
{
  const struct test_brdf even = {{0}, 1.1, 0.0};
  struct um_materials_measured_grid grid = test_grid(&even, 5.0, 85.0, 15.0);
  struct um_materials_measured *m, *kept;
  struct um_materials_measured_found found;
  (void)state;
  assert_int_equal(um_materials_measured_create(context, &grid, false, &m), UM_OK);
  found = um_materials_measured_found(m);
  check_near("albedo", found.albedo, 1.1, 1e-6);
  assert_false(found.renormalised);
  check_near("kept", um_materials_measured_evaluate(m, 0.5, 0.5, 0.9), 1.1 / UM_PI, 1e-12);
  um_materials_measured_destroy(context, &m);
  assert_int_equal(um_materials_measured_create(context, &grid, true, &m), UM_OK);
  found = um_materials_measured_found(m);
  check_near("albedo as found", found.albedo, 1.1, 1e-6);
  assert_true(found.renormalised && um_materials_measured_albedo_most(m) <= 1.0 + 1e-12);
  check_near("brought to 1", um_materials_measured_evaluate(m, 0.5, 0.5, 0.9), 1.0 / UM_PI, 1e-6);
  um_materials_measured_destroy(context, &m);
  for (size_t k = 0; k < grid.npolar * grid.npolar * grid.nazimuth; k++) {
    double i = sin(grid.polar[k / grid.nazimuth / grid.npolar]),
           o = sin(grid.polar[k / grid.nazimuth % grid.npolar]);
    grid.f[k] = (0.5 + 2.4 * i * i * o * o) / UM_PI;
  }
  assert_int_equal(um_materials_measured_create(context, &grid, false, &kept), UM_OK);
  assert_int_equal(um_materials_measured_create(context, &grid, true, &m), UM_OK);
  for (double z = 0.0; z <= 80.0; z += 10.0) {
    double s = sin(z * UM_DEG);
    check_near("albedo", um_materials_measured_albedo(kept, cos(z * UM_DEG)), 0.5 + 1.2 * s * s,
               2e-3); /* constant from 85 deg on */
    assert_true(um_materials_measured_albedo(m, cos(z * UM_DEG)) <= 1.0 + 1e-6);
  }
  struct um_materials_pair p = test_pair(0.2, 0.4, 1.0);
  /* what is left above 1 between the nodes, some 1e-5, is spread over all */
  check_near("untouched", um_materials_measured_evaluate(m, p.cos_i, p.cos_o, p.cos_d),
             um_materials_measured_evaluate(kept, p.cos_i, p.cos_o, p.cos_d), 5e-6);
  p = test_pair(0.2, 1.3, 1.0);
  check_near("reciprocal", um_materials_measured_evaluate(m, p.cos_i, p.cos_o, p.cos_d),
             um_materials_measured_evaluate(m, p.cos_o, p.cos_i, p.cos_d), 1e-12);
  um_materials_measured_destroy(context, &m);
  um_materials_measured_destroy(context, &kept);
  test_grid_free(&grid);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(what_is_refused, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(both_sides, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(between_the_nodes, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(on_the_nodes, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(incidences_between, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(not_reciprocal, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(above_one, context_set_up, context_tear_down),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
