/* What a run says of heat and of its own sampling error, against closed forms: the small satellite
 * of tests/effects/heat_help.h, which stands still before a frozen Sun, so that all instants of an
 * exposure are the same. */
#include "tests/effects/heat_help.h"

#define EXPOSED "time.exposure_s=10", "time.exposure_samples=4"

static const struct um_thermal_heat *heat_of(const struct heat_run *run, const char *place)
{
  const struct um_model_result *r = run->result;
  for (size_t p = 0; p < r->nplace; p++)
    if (strcmp(r->place[p].name, place) == 0) return &r->heat[p];
  fail_msg("no place is called '%s'", place);
  return NULL;
}

/* The front of the panel takes (alpha - eta) S A cos: alpha 0.90 of grey_panel, A 2 m^2, S 1361
 * W/m^2 at 1 au; what leaves as electricity is no heat. Loads are floats: 1e-6. */
static void sunlight_less_what_is_extracted(void **state)
{
  (void)state;
  static const char *const set[] = {"parts.panel.electrical_extraction=0",
                                    "parts.panel.electrical_extraction=0.18"};
  for (int i = 0; i < 2; i++) {
    struct heat_run run = heat_compute(LIST(EXPOSED, set[i]), NONE, NONE);
    const struct um_environment_sample *sample = run.tables->sample;
    double cosine = um_quat_apply(sample->q, sample->sun).x;
    double expected = (0.90 - (i == 0 ? 0.0 : 0.18)) * 1361.0 * 2.0 * cosine;
    print_message("extraction %g: %.6g W of sunlight, expected %.6g\n", i == 0 ? 0.0 : 0.18,
                  heat_of(&run, "panel.front")->solar, expected);
    assert_true(cosine > 0.9);
    heat_close("sunlight on the front", heat_of(&run, "panel.front")->solar, expected, 2e-6);
    heat_close("sunlight on the panel", heat_of(&run, "panel")->solar, expected, 2e-6);
    assert_true(heat_of(&run, "panel.back")->solar == 0.0);
    heat_release(&run);
  }
}

/* Through the blanket of a wall of 1 m^2 go e* sigma (T_skin^4 - T_wall^4), e* = 0.02; what the
 * wall takes the skin loses. */
static void blanket_exchanges_what_it_lets_through(void **state)
{
  (void)state;
  static const char *const face[] = {"bus.+x", "bus.-x", "bus.+y", "bus.-z"};
  struct heat_run run = heat_compute(LIST(EXPOSED), NONE, NONE);
  for (size_t i = 0; i < sizeof face / sizeof *face; i++) {
    char wall[32];
    snprintf(wall, sizeof wall, "%s.wall", face[i]);
    double skin4 = pow(heat_temperature(&run, face[i], 0), 4.0);
    double wall4 = pow(heat_temperature(&run, wall, 0), 4.0);
    double expected = 0.02 * UM_STEFAN_BOLTZMANN * (skin4 - wall4);
    print_message("%s: %.6g W, expected %.6g\n", wall, heat_of(&run, wall)->exchanged, expected);
    assert_true(fabs(expected) > 0.1);
    heat_close(wall, heat_of(&run, wall)->exchanged, expected, 1e-6);
    heat_close(face[i], heat_of(&run, face[i])->exchanged, -expected, 1e-6);
  }
  heat_release(&run);
}

/* In a steady state every column is there: they add up to what is stored, which is nothing. Columns
 * and state are computed apart, each with what is extracted. */
static void columns_add_up(void **state)
{
  (void)state;
  struct heat_run run = heat_compute(LIST(EXPOSED, "parts.panel.electrical_extraction=0.18"),
                                     LIST("mutual_radiation", "solar_multiple_reflection"), NONE);
  for (size_t p = 0; p < run.model->body->nplace; p++) {
    const struct um_thermal_heat *h = &run.result->heat[p];
    const double part[] = {h->solar,     h->albedo,   h->planet,   h->internal,
                           h->conducted, h->radiated, h->exchanged};
    double sum = 0.0, gross = 0.0;
    for (size_t i = 0; i < sizeof part / sizeof *part; i++) {
      sum += part[i];
      gross += fabs(part[i]);
    }
    if (!(fabs(h->stored - sum) <= 1e-12 * gross) || !(fabs(sum) <= 1e-3 * gross))
      fail_msg("%s: stored %g W, sum %g W of %g W", run.result->place[p].name, h->stored, sum,
               gross);
  }
  /* 0.85 sigma A (T^4 - T_space^4) leave the front, before which nothing stands */
  double front4 = pow(heat_temperature(&run, "panel.front", 0), 4.0);
  heat_close("radiated by the front", heat_of(&run, "panel.front")->radiated,
             -0.85 * 2.0 * UM_STEFAN_BOLTZMANN * (front4 - pow(UM_SPACE_TEMPERATURE, 4.0)), 1e-6);
  heat_close("internal", heat_of(&run, "bus.interior")->internal, 20.0, 1e-12);
  heat_release(&run);
}

/* Instants of an exposure share their sample points: where nothing moves, the error of their mean
 * is that of one. The bus stands half out of the panel's shade, so that there is an error. Paths
 * between surfaces are new ones at each instant. */
static void error_of_an_exposure_is_that_of_an_instant(void **state)
{
  (void)state;
#define HALF_SHADED "parts.bus.pose.position_m=[-2, 0.37, 0]", "optics.interreflection_samples=0"
  struct heat_run one = heat_compute(LIST(HALF_SHADED), NONE, NONE);
  struct heat_run mean = heat_compute(LIST(EXPOSED, HALF_SHADED), NONE, NONE);
  assert_true(one.result->standard_error[0] > 0.0);
  print_message("standard error %.4g of %.4g W/sr\n", one.result->standard_error[0],
                um_model_result_intensity(one.result, 0, 0, -1));
  for (size_t b = 0; b < one.result->nband; b++) {
    heat_close("standard error", mean.result->standard_error[b], one.result->standard_error[b],
               1e-6);
    heat_close("intensity", um_model_result_intensity(mean.result, 0, b, -1),
               um_model_result_intensity(one.result, 0, b, -1), 1e-6);
    heat_close("irradiance", mean.result->irradiance[b], one.result->irradiance[b], 1e-6);
    heat_close("irradiance at 1000 km", one.result->irradiance[b],
               um_model_result_intensity(one.result, 0, b, -1) / 1e12, 1e-9);
  }
  heat_release(&one);
  heat_release(&mean);
}

static int setup(void **state)
{
  (void)state;
  return heat_setup("model_run.yaml");
}
static int teardown(void **state)
{
  (void)state;
  return heat_teardown();
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(sunlight_less_what_is_extracted),
      cmocka_unit_test(blanket_exchanges_what_it_lets_through),
      cmocka_unit_test(columns_add_up),
      cmocka_unit_test(error_of_an_exposure_is_that_of_an_instant),
  };
  return cmocka_run_group_tests(tests, setup, teardown);
}
