/* Effects on Sun, Earth and shadow. The steady satellite radiates what it absorbs and 20 W. */
#include <stdlib.h>

#include "base/core/planck.h"
#include "heat_help.h"
#include "model/build/timeline.h"

static void check_balance(const struct heat_run *run)
{
  struct heat_budget all = heat_budget(run, NULL, false);
  heat_close("balance", all.emitted, all.absorbed + 20.0, 1e-6);
}

/* Loads and earthshine double; direct sunlight stays bit for bit. Without albedo nothing is left of
 * either. Loads are floats. */
static void albedo_level_scales_load_and_earthshine(void **state)
{
  (void)state;
  struct heat_run a = heat_compute(NONE, NONE, NONE);
  struct heat_run b = heat_compute(NONE, LIST("albedo_level,factor=2"), NONE);
  struct heat_run none = heat_compute(NONE, LIST("albedo_level,factor=0"), NONE);
  struct heat_run off = heat_compute(NONE, NONE, LIST("albedo", "earthshine"));
  struct heat_budget before = heat_budget(&a, NULL, false), after = heat_budget(&b, NULL, false);
  assert_true(before.albedo > 100.0);
  heat_close("albedo", after.albedo, 2.0 * before.albedo, 1e-7);
  assert_true(after.sun == before.sun && after.planet == before.planet);
  check_balance(&b);
  heat_close("earthshine", heat_intensity(&b, "vis", UM_MECHANISM_EARTH, NULL),
             2.0 * heat_intensity(&a, "vis", UM_MECHANISM_EARTH, NULL), 1e-12);
  assert_true(heat_intensity(&b, "vis", UM_MECHANISM_SUN, NULL) ==
              heat_intensity(&a, "vis", UM_MECHANISM_SUN, NULL));
  assert_true(heat_intensity(&none, "vis", UM_MECHANISM_EARTH, NULL) <=
              1e-20 * heat_intensity(&a, "vis", UM_MECHANISM_EARTH, NULL));
  heat_close("no albedo", heat_temperature(&none, "panel.back", 0),
             heat_temperature(&off, "panel.back", 0), 1e-12);
  heat_release(&a);
  heat_release(&b);
  heat_release(&none);
  heat_release(&off);
}

/* The load alone: what the satellite reflects of the Earth stays, to the float in which the free
 * share of a covered sky is kept. */
static void earth_ir_level_scales_the_load(void **state)
{
  (void)state;
  struct heat_run a = heat_compute(NONE, NONE, NONE);
  struct heat_run b = heat_compute(NONE, LIST("earth_ir_level,factor=0.8"), NONE);
  struct heat_budget before = heat_budget(&a, NULL, false), after = heat_budget(&b, NULL, false);
  heat_close("Earth IR", after.planet, 0.8 * before.planet, 1e-7);
  assert_true(after.albedo == before.albedo && after.sun == before.sun);
  check_balance(&b);
  assert_true(heat_same_reflected(&a, &b, "vis"));
  heat_close("reflected", heat_intensity(&b, "lwir", UM_MECHANISM_EARTH, NULL),
             heat_intensity(&a, "lwir", UM_MECHANISM_EARTH, NULL), 1e-7);
  heat_release(&a);
  heat_release(&b);
}

/* Grey materials reflect the band radiance of the Earth: ratio B(250 K)/B(270 K), 8-12 um. */
static void earth_brightness_scales_reflection(void **state)
{
  (void)state;
  struct heat_run a = heat_compute(NONE, NONE, LIST("earthshine"));
  struct heat_run b = heat_compute(NONE, LIST("earth_brightness,shift_K=-20"), LIST("earthshine"));
  double before = heat_intensity(&a, "lwir", UM_MECHANISM_EARTH, NULL);
  assert_true(before > 0.0);
  heat_close("reflected", heat_intensity(&b, "lwir", UM_MECHANISM_EARTH, NULL),
             before * um_core_planck_band(8e-6, 12e-6, 250.0) /
                 um_core_planck_band(8e-6, 12e-6, 270.0),
             1e-9);
  assert_true(heat_same_temperatures(&a, &b));
  assert_true(heat_intensity(&a, "lwir", UM_MECHANISM_EMITTED, NULL) ==
              heat_intensity(&b, "lwir", UM_MECHANISM_EMITTED, NULL));
  heat_release(&a);
  heat_release(&b);
}

/* All that comes from the Sun, by whatever way; earthshine by a load, a float. */
static void solar_irradiance_scales_all_sunlight(void **state)
{
  (void)state;
  struct heat_run a = heat_compute(NONE, NONE, NONE);
  struct heat_run b = heat_compute(NONE, LIST("solar_irradiance,factor=1.1"), NONE);
  struct heat_budget before = heat_budget(&a, NULL, false), after = heat_budget(&b, NULL, false);
  for (int m = UM_MECHANISM_SUN; m <= UM_MECHANISM_EARTH; m++)
    heat_close("visible", heat_intensity(&b, "vis", m, NULL),
               1.1 * heat_intensity(&a, "vis", m, NULL), m == UM_MECHANISM_SUN ? 1e-12 : 1e-7);
  heat_close("sunlight", after.sun, 1.1 * before.sun, 1e-12);
  heat_close("albedo", after.albedo, 1.1 * before.albedo, 1e-7);
  assert_true(after.planet == before.planet);
  check_balance(&b);
  heat_release(&a);
  heat_release(&b);
}

/* Times of half light [s] from the start over one orbit and a half: entry, exit, entry. */
static void edges(const char *const *with, double t[3])
{
  static const char *const circling[] = {"orbit={circular: {altitude_km: 600, beta_deg: 0}}",
                                         "environment.shadow=sphere", "environment.disc=point",
                                         "thermal.start=isothermal", NULL};
  struct heat_run run = heat_compute(circling, with, NONE);
  double from = run.tables->t_obs[0];
  struct um_environment_event *event = NULL;
  size_t count = 0, n = 0;
  assert_int_equal(um_model_events(run.context, run.model, from, from + 1.6 * run.tables->period,
                                   &event, &count),
                   UM_OK);
  for (size_t i = 0; i < count; i++) {
    if (event[i].kind != UM_EVENT_HALF_ENTRY && event[i].kind != UM_EVENT_HALF_EXIT) continue;
    if (n == 0 && event[i].kind == UM_EVENT_HALF_EXIT) continue;
    if (n < 3) t[n++] = event[i].t_tai - from;
  }
  assert_int_equal(n, 3);
  um_core_free(run.context, event);
  heat_release(&run);
}

/* Seen from the geocentre the edge of a sphere stands at asin(R/r) from the axis of the shadow; the
 * satellite turns at a uniform rate. Edges are found to 1 ms; that the Sun is 1 au away, not
 * infinitely far, turns both edges alike, by 5e-5 rad times the step of 0.0035 rad. */
static void shadow_radius_moves_both_edges(void **state)
{
  (void)state;
  double before[3], after[3];
  edges(NONE, before);
  edges(LIST("shadow_radius,shift_km=10"), after);
  double rate = 2.0 * UM_PI / (before[2] - before[0]);
  double r = UM_EARTH_RADIUS + 600e3;
  double earlier = (asin((UM_EARTH_RADIUS + 10e3) / r) - asin(UM_EARTH_RADIUS / r)) / rate;
  assert_true(earlier > 3.0);
  print_message("  entry %.4f s, exit %+.4f s, expected -+%.4f s\n", after[0] - before[0],
                after[1] - before[1], earlier);
  assert_true(fabs(before[0] - after[0] - earlier) <= 2.5e-3);
  assert_true(fabs(after[1] - before[1] - earlier) <= 2.5e-3);
}

static int setup(void **state)
{
  (void)state;
  return heat_setup("effects_heat_environment.yaml");
}
static int teardown(void **state)
{
  (void)state;
  return heat_teardown();
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(albedo_level_scales_load_and_earthshine),
      cmocka_unit_test(earth_ir_level_scales_the_load),
      cmocka_unit_test(earth_brightness_scales_reflection),
      cmocka_unit_test(solar_irradiance_scales_all_sunlight),
      cmocka_unit_test(shadow_radius_moves_both_edges),
  };
  return cmocka_run_group_tests(tests, setup, teardown);
}
