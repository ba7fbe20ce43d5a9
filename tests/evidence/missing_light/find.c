/* Light that no catalogue has: of known kind, coordinate and size, put into the values of a small
 * world by geometry that is worked out here in the sky's axes, with noise. Drawn:
 *
 *   cloud   all light dimmed below an elevation, in both bands
 *   paint   the light of one material grows with the phase angle, in one band
 *   lamp    light of the satellite's own toward its x axis, in one band */
#include "evidence/missing_light/light.h"

#include "evidence/missing_light/policy.h"
#include "tests/base/inference/observations_test.h"
#include "tests/evidence/sensitivity/forward_test.h"
#include "tests/support/allocator.h"

#define STEP 4.0 /* between observations [s] */
#define ROWS 110
#define N    (2 * ROWS)

enum hidden { NOTHING, CLOUD, PAINT, LAMP };

#define EDGE   0.35 /* elevation [rad] */
#define TAKEN  0.15
#define SLOPE  0.4 /* of the paint, per radian */
#define LAMP_I 6.0 /* [W/sr] */

/* Rows of both bands; value NULL: any. */
static void put_rows(const double *value, const double *sigma)
{
  FILE *file = fopen("m.csv", "w");
  assert_non_null(file);
  fputs("time_utc,quantity,of,value,sigma\n", file);
  for (int k = 0; k < ROWS; k++) {
    int s = 11 * 60 + (int)(k * STEP); /* in sunlight */
    for (int b = 0; b < 2; b++)
      fprintf(file, DAY "%02d:%02dZ,band_irradiance,%s,%.17g,%.17g\n", s / 60, s % 60,
              b == 0 ? "vis" : "lwir", value == NULL ? 1.0 : value[2 * k + b],
              sigma == NULL ? 1.0 : sigma[2 * k + b]);
  }
  assert_int_equal(fclose(file), 0);
}

/* What is hidden does to a row, over the irradiance of the model. */
static double hide(enum hidden hidden, const struct um_sensitivity_forward_run *run, size_t k,
                   size_t band, double value)
{
  const struct um_model_tables *t = run->variant.tables;
  const struct um_environment_sample *s = &t->sample[k * t->nsub + t->nsub / 2];
  double elevation = t->look[k * t->nsub + t->nsub / 2].elevation;
  if (hidden == CLOUD) return elevation < EDGE ? (1.0 - TAKEN) * value : value;
  if (hidden == PAINT && band == 0) { /* the bus is of one material, the panel of others */
    const struct um_model_result *r = run->result;
    double all = um_model_result_intensity(r, k, band, -1), of = 0.0;
    for (size_t m = 0; m < r->nmaterial; m++)
      for (size_t i = 0; i < UM_MECHANISM_COUNT; i++)
        if (strcmp(um_geometry_material_name(run->variant.model->geometry, (uint32_t)m),
                   "grey_white") == 0)
          of += r->intensity[((k * r->nband + band) * r->nmaterial + m) * UM_MECHANISM_COUNT + i];
    return value * (1.0 + SLOPE * (acos(um_vec3_dot(s->sun, s->to_observer)) - 1.0) * of / all);
  }
  if (hidden == LAMP && band == 0) { /* the body's x axis in the sky: back by the conjugate */
    struct um_vec3 x = um_quat_apply(um_quat_conjugate(s->q), um_vec3(1.0, 0.0, 0.0));
    double c = fmax(0.0, um_vec3_dot(x, s->to_observer));
    return value + LAMP_I * c * c / (s->range * s->range);
  }
  return value;
}

/* What is found in measurements with that hidden and noise of 1 %; level: its scale is free. */
static struct um_missing_light look(enum hidden hidden, uint64_t seed, bool level,
                                    struct um_sensitivity_forward **kept,
                                    struct um_compare_measurements **m)
{
  double value[N], truth[N], sigma[N], column[N];
  struct um_sensitivity_forward_run run;
  struct um_missing_light light;
  put_world("");
  put_rows(NULL, NULL);
  *m = measured();
  *kept = forward_of(NULL, *m);
  assert_int_equal((*kept)->observations.count, N);
  assert_ok(um_sensitivity_forward_evaluate(context, *kept, NULL, 0, value));
  assert_ok(um_sensitivity_forward_run(context, *kept, NULL, 0, NULL, &run));
  for (size_t j = 0; j < N; j++) {
    sigma[j] = 0.01 * value[j];
    truth[j] = hide(hidden, &run, j / 2, j % 2, value[j]) + sigma[j] * rows_normal(seed, j);
    column[j] = value[j] / sigma[j];
  }
  um_sensitivity_forward_run_release(context, &run);
  um_sensitivity_forward_destroy(context, kept);
  um_compare_measurements_destroy(context, m);
  put_rows(truth, sigma);
  *m = measured();
  *kept = forward_of(NULL, *m);
  assert_ok(um_missing_light_find(context, *kept, NULL, 0, value, column, level ? 1 : 0, &light));
  return light;
}

static void done(struct um_sensitivity_forward **forward, struct um_compare_measurements **m)
{
  um_sensitivity_forward_destroy(context, forward);
  um_compare_measurements_destroy(context, m);
}

static void say(const struct um_missing_light *l)
{
  char text[UM_MISSING_LIGHT_TEXT];
  um_missing_light_text(l, text);
  print_message("  %s; chi-square %.4g to %.4g, worth %.4g, %zu others\n", text, l->chi2_before,
                l->chi2_after, l->worth, l->nalternative);
}

/* Twenty sets of noise: nothing is found, and nothing is worth what the number of trials costs. */
static void test_noise(void **state)
{
  (void)state;
  for (uint64_t seed = 1; seed <= 20; seed++) {
    struct um_sensitivity_forward *f;
    struct um_compare_measurements *m;
    struct um_missing_light l = look(NOTHING, seed, false, &f, &m);
    assert_true(l.any && !l.found);
    assert_true(l.worth < UM_MISSING_LIGHT_EVIDENCE);
    assert_true(l.chi2_after <= l.chi2_before);
    done(&f, &m);
  }
}

/* A cloud: what it takes within three sigmas, its edge to a step of the rows, both bands alike; the
 * level free makes no other. */
static void test_cloud(void **state)
{
  (void)state;
  for (int level = 0; level < 2; level++) {
    struct um_sensitivity_forward *f;
    struct um_compare_measurements *m;
    struct um_missing_light l = look(CLOUD, 7, level == 1, &f, &m);
    say(&l);
    assert_true(l.any && l.found && l.grey && l.material == NULL);
    assert_int_equal(l.kind, UM_LIGHT_FACTOR);
    assert_true(l.coordinate == UM_COORDINATE_ELEVATION || l.coordinate == UM_COORDINATE_AIRMASS);
    assert_int_equal(l.curve.kind, UM_CURVE_EDGE);
    assert_int_equal(l.nband, 2);
    double taken = fabs(l.value[0]);
    if (level == 0) { /* of a hundredth or more at each of 10 to 220 rows */
      assert_close(taken, TAKEN, 3.0 * l.sigma[0] + 1e-3);
      assert_true(l.sigma[0] > 0.01 / sqrt(220.0) && l.sigma[0] < 0.01 / sqrt(10.0));
    }
    if (l.coordinate == UM_COORDINATE_ELEVATION) assert_close(l.curve.a * UM_DEG, EDGE, 0.05);
    done(&f, &m);
  }
}

/* Paint: the material, the coordinate and the band; along the phase angle the curve is the truth
 * within 0.02 or three sigmas, everywhere that it was seen. */
static void test_paint(void **state)
{
  (void)state;
  struct um_sensitivity_forward *f;
  struct um_compare_measurements *m;
  struct um_missing_light l = look(PAINT, 8, false, &f, &m);
  say(&l);
  assert_true(l.any && l.found && !l.grey);
  assert_int_equal(l.kind, UM_LIGHT_FACTOR);
  assert_non_null(l.material);
  assert_string_equal(l.material, "grey_white");
  assert_int_equal(l.nband, 1);
  assert_string_equal(l.band[0], "vis");
  assert_int_equal(l.coordinate, UM_COORDINATE_PHASE);
  for (int i = 0; i <= 10; i++) {
    double u = l.from + i / 10.0 * (l.to - l.from), truth = SLOPE * (u * UM_DEG - 1.0);
    assert_close(um_effect_curve_at(&l.curve, l.value, u), truth, 0.02 + 3.0 * l.sigma[0]);
  }
  done(&f, &m);
}

/* A lamp is light of the satellite, in the visible; where it looks at the observer it has its
 * intensity within a tenth and three sigmas. */
static void test_lamp(void **state)
{
  (void)state;
  struct um_sensitivity_forward *f;
  struct um_compare_measurements *m;
  struct um_missing_light l = look(LAMP, 9, false, &f, &m);
  say(&l);
  assert_true(l.any && l.found);
  assert_int_equal(l.kind, UM_LIGHT_INTENSITY);
  assert_int_equal(l.nband, 1);
  assert_string_equal(l.band[0], "vis");
  assert_int_equal(l.coordinate, UM_COORDINATE_OBSERVER_X);
  double c = cos(l.from * UM_DEG);
  assert_close(um_effect_curve_at(&l.curve, l.value, l.from), LAMP_I * c * c,
               0.1 * LAMP_I + 3.0 * l.sigma[0]);
  done(&f, &m);
}

/* Temperatures alone have no light. */
static void test_no_light(void **state)
{
  (void)state;
  double value[ROWS];
  struct um_missing_light l;
  put_world("");
  FILE *file = fopen("m.csv", "w");
  assert_non_null(file);
  fputs("time_utc,quantity,of,value,sigma\n", file);
  for (int k = 0; k < 20; k++)
    fprintf(file, DAY "11:%02dZ,temperature,bus.interior,300,0.5\n", 2 * k);
  assert_int_equal(fclose(file), 0);
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(NULL, m);
  assert_ok(um_sensitivity_forward_evaluate(context, f, NULL, 0, value));
  assert_ok(um_missing_light_find(context, f, NULL, 0, value, NULL, 0, &l));
  assert_false(l.any || l.found);
  assert_true(l.chi2_before == l.chi2_after && l.chi2_before > 0.0);
  done(&f, &m);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_noise), cmocka_unit_test(test_cloud),    cmocka_unit_test(test_paint),
      cmocka_unit_test(test_lamp),  cmocka_unit_test(test_no_light),
  };
  return cmocka_run_group_tests(tests, model_set_up, model_tear_down);
}
