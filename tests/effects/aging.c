/* Surfaces that age during a run: what they absorb, reflect and emit at an instant is that of
 * surfaces which have always been as they are then; at the null value not a bit moves; the audit
 * closes. OBJECTS is the folder of an effect on the emittance. */
#include <math.h>
#include <stdio.h>

#include "base/core/constants.h"
#include "tests/effects/case.h"
#include "tests/support/cmocka_all.h"

#define STEP  60.0 /* of case_plate's three observations [s] */
#define RATE  50.0 /* [1/d]: 0.035 a step */
#define DAY   86400.0
#define FRONT "grey_panel"
#define FADE  2e-3 /* [1/s]: 12 % a step */

static double shift(size_t k) { return RATE * STEP * (double)k / DAY; }

static struct case_run static_shift(size_t k)
{
  char with[96];
  snprintf(with, sizeof with, "solar_absorptance:" FRONT ",shift=%.17g", shift(k));
  return case_with(case_plate, with);
}

static void light_is_that_of_the_instant(void **state)
{
  (void)state;
  struct case_run aged = case_with(case_plate, "contamination:" FRONT ",absorptance_per_day=50");
  for (size_t k = 0; k < aged.result->nobs; k++) {
    struct case_run still = static_shift(k);
    for (int m = UM_MECHANISM_SUN; m <= UM_MECHANISM_EARTH; m++)
      case_near("vis", case_intensity(&aged, k, "vis", FRONT, m),
                case_intensity(&still, k, "vis", FRONT, m), 1e-12);
    case_release(&still);
  }
  assert_true(case_intensity(&aged, 0, "vis", FRONT, UM_MECHANISM_SUN) >
              1.05 * case_intensity(&aged, 2, "vis", FRONT, UM_MECHANISM_SUN));
  case_release(&aged);
}

/* Index of a place among the histories of a result. */
static size_t place(const struct case_run *run, const char *name)
{
  for (size_t p = 0; p < run->result->nplace; p++)
    if (strcmp(run->result->place[p].name, name) == 0) return p;
  fail_msg("no place %s", name);
  return 0;
}

static struct um_thermal_heat heat(const struct case_run *run, size_t k)
{
  return run->result->heat[k * run->result->nplace + place(run, "plate")];
}

static void heat_is_that_of_the_instant(void **state)
{
  (void)state;
  struct case_run aged = case_with(case_plate, "contamination:" FRONT ",absorptance_per_day=50");
  double warmed[3];
  for (size_t k = 0; k < aged.result->nobs; k++) {
    struct case_run still = static_shift(k);
    case_near("sun", heat(&aged, k).solar, heat(&still, k).solar, 1e-10);
    case_near("albedo", heat(&aged, k).albedo, heat(&still, k).albedo, 1e-10);
    size_t p = place(&aged, "plate.front");
    warmed[k] = aged.result->place[p].mean[k] - still.result->place[p].mean[k];
    case_release(&still);
  }
  /* it has absorbed the lesser shifts of before */
  assert_true(warmed[0] == 0.0 && warmed[1] < 0.0 && warmed[2] < warmed[1]);
  assert_true(aged.result->audit_error < 1e-6);
  case_release(&aged);
}

/* Heat gained over the run is the integral of a line: under constant sunlight the panel that ages
 * by r t absorbs E A r t^2/2 more than one that does not. */
static void gain_is_the_integral(void **state)
{
  (void)state;
  struct case_run plain = case_with(case_plate, NULL);
  struct case_run aged = case_with(case_plate, "contamination:" FRONT ",absorptance_per_day=50");
  double t = STEP * (double)(plain.result->nobs - 1), absorptance = 0.0;
  const struct um_thermal_network *network = plain.model->body->network;
  for (size_t s = 0; s < um_thermal_network_surfaces(network); s++)
    absorptance = /* the front's, the darker side */
        fmax(absorptance, um_thermal_network_surface(network, (uint32_t)s)->absorptance);
  double per_absorptance = heat(&plain, 0).solar / absorptance;
  case_near("gain", aged.result->audit.solar - plain.result->audit.solar,
            per_absorptance * RATE / DAY * t * t / 2.0, 1e-5);
  case_release(&plain);
  case_release(&aged);
}

static void null_moves_no_bit(void **state)
{
  (void)state;
  struct case_run plain = case_with(case_satellite, NULL);
  struct case_run null = case_with(case_satellite, "contamination:" FRONT ",absorptance_per_day=0");
  assert_true(case_same(&plain, &null));
  case_release(&plain);
  case_release(&null);
}

/* Emission to space: eps(t) sigma A (T^4 - T_space^4) at the temperatures that were found, and the
 * light in LWIR falls by the same factor. */
static void emission_fades(void **state)
{
  (void)state;
  char scenario[4096], with[96];
  snprintf(scenario, sizeof scenario, "effect_files: [%s/aging.so]\n%s", OBJECTS, case_plate);
  snprintf(with, sizeof with, "fading:" FRONT ",loss_per_s=%g", FADE);
  struct case_run run = case_with(scenario, with);
  struct case_run plain = case_with(scenario, "fading:" FRONT ",loss_per_s=0");
  double front = 0.0, back = 0.0;
  const struct um_thermal_network *network = run.model->body->network;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(run.model->geometry);
  for (size_t s = 0; s < mesh->nsurface; s++) {
    const char *material =
        um_geometry_material_name(run.model->geometry, mesh->surface[s].material);
    double emission = um_thermal_surface_emission(um_thermal_network_surface(network, (uint32_t)s));
    *(strcmp(material, FRONT) == 0 ? &front : &back) += emission;
  }
  for (size_t k = 0; k < run.result->nobs; k++) {
    double t[2], expected = 0.0;
    const char *const side[2] = {"plate.front", "plate.back"};
    for (int i = 0; i < 2; i++) t[i] = run.result->place[place(&run, side[i])].mean[k];
    double faded = 1.0 - FADE * STEP * (double)k;
    expected += faded * front * (pow(t[0], 4) - pow(UM_SPACE_TEMPERATURE, 4));
    expected += back * (pow(t[1], 4) - pow(UM_SPACE_TEMPERATURE, 4));
    case_near("radiated", heat(&run, k).radiated, -UM_STEFAN_BOLTZMANN * expected, 1e-9);
  }
  size_t p = place(&run, "plate.front");
  assert_true(run.result->place[p].mean[2] > plain.result->place[p].mean[2]);
  assert_true(run.result->audit_error < 1e-6);
  case_release(&run);
  case_release(&plain);
}

/* More than everything cannot be absorbed. */
static void too_much_is_held_at_one(void **state)
{
  (void)state;
  struct case_run aged = case_with(case_plate, "contamination:" FRONT ",absorptance_per_day=-50");
  assert_true(aged.result->audit_error < 1e-6);
  case_release(&aged);
  char scenario[4096];
  snprintf(scenario, sizeof scenario, "effect_files: [%s/aging.so]\n%s", OBJECTS, case_plate);
  struct case_run dark = case_with(scenario, "fading:" FRONT ",loss_per_s=0.5");
  size_t p = place(&dark, "plate.front");
  assert_true(dark.result->place[p].mean[2] > 0.0); /* emits nothing, never less */
  case_release(&dark);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(light_is_that_of_the_instant),
      cmocka_unit_test(heat_is_that_of_the_instant),
      cmocka_unit_test(gain_is_the_integral),
      cmocka_unit_test(null_moves_no_bit),
      cmocka_unit_test(emission_fades),
      cmocka_unit_test(too_much_is_held_at_one),
  };
  return cmocka_run_group_tests(tests, case_begin, case_end);
}
