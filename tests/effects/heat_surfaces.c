/* Effects on the surfaces of materials: what they absorb, reflect and emit. */
#include "core/planck.h"
#include "heat_help.h"

/* The panel's back is white paint, Lambert with rho_d = 1 - alpha = 0.8, lit by the Earth alone and
 * seen from below: alpha + 0.1 leaves 0.7/0.8 of the light. Other materials keep theirs. */
static void absorptance_darkens_the_visible(void **state)
{
  (void)state;
  const char *const *below = LIST("observer.direction.unit_gcrs=[-0.8, 0.6, 0]");
  struct heat_run a = heat_compute(below, NONE, NONE);
  struct heat_run b =
      heat_compute(below, LIST("solar_absorptance:grey_white,absorptance_shift=0.1"), NONE);
  double before = heat_intensity(&a, "vis", UM_MECHANISM_EARTH, "grey_white");
  assert_true(before > 0.0);
  heat_close("earthshine", heat_intensity(&b, "vis", UM_MECHANISM_EARTH, "grey_white"),
             0.875 * before, 1e-12);
  assert_true(heat_intensity(&b, "vis", UM_MECHANISM_EARTH, "grey_mli") ==
              heat_intensity(&a, "vis", UM_MECHANISM_EARTH, "grey_mli"));
  heat_release(&a);
  heat_release(&b);
}

/* The diffuse part of the panel's front, 0.06, falls by the shift; its lobe stays: sunlight is
 * linear in the shift until 0.06 is spent. */
static void absorptance_leaves_the_lobe(void **state)
{
  (void)state;
  struct heat_run run[3] = {
      heat_compute(NONE, NONE, NONE),
      heat_compute(NONE, LIST("solar_absorptance:grey_panel,absorptance_shift=0.02"), NONE),
      heat_compute(NONE, LIST("solar_absorptance:grey_panel,absorptance_shift=0.06"), NONE)};
  double sun[3];
  for (size_t i = 0; i < 3; i++)
    sun[i] = heat_intensity(&run[i], "vis", UM_MECHANISM_SUN, "grey_panel");
  heat_close("a third", sun[0] - sun[1], (sun[0] - sun[2]) / 3.0, 1e-9);
  assert_true(sun[2] > 0.0 && sun[0] > sun[2]);
  for (size_t i = 0; i < 3; i++) heat_release(&run[i]);
}

/* More of sunlight and albedo is absorbed, by the shift times what falls in; it is radiated. */
static void absorptance_heats(void **state)
{
  (void)state;
  struct heat_run a = heat_compute(NONE, NONE, NONE);
  struct heat_run b =
      heat_compute(NONE, LIST("solar_absorptance:grey_panel,absorptance_shift=0.05"), NONE);
  struct heat_budget front = heat_budget(&a, "panel", false);
  heat_close("absorptance", heat_budget(&b, "panel", false).absorptance, 0.95, 1e-15);
  heat_close("emission", heat_budget(&b, NULL, false).emitted,
             heat_budget(&a, NULL, false).emitted + 0.05 * (front.sun + front.albedo), 1e-6);
  assert_true(heat_temperature(&b, "panel.front", 0) > heat_temperature(&a, "panel.front", 0));
  heat_release(&a);
  heat_release(&b);
}

/* The front faces away from the Earth: what it absorbs stays, and so does what is radiated in all;
 * it is hotter, and its band radiance changes by 0.9 B(T')/B(T). The renderer interpolates B to
 * 1e-6. The visible stays bit for bit. */
static void emittance_scales_emission(void **state)
{
  (void)state;
  struct heat_run a = heat_compute(NONE, NONE, NONE);
  struct heat_run b = heat_compute(NONE, LIST("emittance:grey_panel,emittance_factor=0.9"), NONE);
  double cool = heat_temperature(&a, "panel.front", 0),
         hot = heat_temperature(&b, "panel.front", 0);
  heat_close("emittance", heat_budget(&b, "panel", false).emittance, 0.9 * 0.85, 1e-15);
  heat_close("emission", heat_budget(&b, NULL, false).emitted, heat_budget(&a, NULL, false).emitted,
             1e-6);
  assert_true(hot > cool);
  heat_close("band radiance", heat_intensity(&b, "lwir", UM_MECHANISM_EMITTED, "grey_panel"),
             heat_intensity(&a, "lwir", UM_MECHANISM_EMITTED, "grey_panel") * 0.9 *
                 um_core_planck_band(8e-6, 12e-6, hot) / um_core_planck_band(8e-6, 12e-6, cool),
             1e-6);
  assert_true(heat_same_reflected(&a, &b, "vis"));
  heat_release(&a);
  heat_release(&b);
}

static int setup(void **state)
{
  (void)state;
  return heat_setup("effects_heat_surfaces.yaml");
}
static int teardown(void **state)
{
  (void)state;
  return heat_teardown();
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(absorptance_darkens_the_visible),
      cmocka_unit_test(absorptance_leaves_the_lobe),
      cmocka_unit_test(absorptance_heats),
      cmocka_unit_test(emittance_scales_emission),
  };
  return cmocka_run_group_tests(tests, setup, teardown);
}
