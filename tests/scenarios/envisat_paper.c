/* scenarios/envisat-paper: four orbits from one temperature do not converge what MLI wraps.
 *
 * Linearised at 300 K the interior (5.4e6 J/K) loses heat through the radiators, 60 W/K in series
 * with 12.6 m2 * 0.83 * 4 sigma T^3 = 64 W/K, through the MLI, 97 m2 * 0.02 * 4 sigma T^3 = 12 W/K,
 * and through contacts, 1.6 W/K: 44.6 W/K together, a time constant of 1.21e5 s or 20.1 orbits of
 * 6012 s. Of the way to the periodic state exp(-4/20.1) = 0.82 is left after four orbits. Between
 * 290 K and the periodic 390 K T^3 grows by more than half, radiators and skin lag behind: 0.05
 * allowed.
 *
 * That is one node. The scenario has the solid: its surface is colder than its middle, so that it
 * gives away less of the heat by which 6.5 kW would warm 5.4e6 J/K in four orbits, 28.9 K. */
#include "tests/scenarios/support.h"

#include <string.h>

#include "thermal/network/tetgen_impl.h"

#define SCENARIO     UMBRA_SOURCE_DIR "/scenarios/envisat-paper"
#define CONDUCTIVITY "parts.bus.interior.conductivity_W_m_K="
#define NODE         CONDUCTIVITY "0"

static double interior(const char *start, const char *conductivity, double *drift)
{
  const char *const overrides[] = {start,
                                   "thermal.facet_size_m=3",
                                   "thermal.step_s=10",
                                   "time.step_s=60",
                                   "optics.samples=1",
                                   "thermal.accuracy_K=0.1",
                                   conductivity};
  struct support_run run;
  support_compute(SCENARIO, overrides, sizeof overrides / sizeof overrides[0], &run);
  double temperature = support_temperature(&run, "bus.interior")[0];
  for (size_t p = 0; p < run.result->nplace; p++)
    if (strcmp(run.result->place[p].name, "bus.interior") == 0) *drift = run.result->place[p].drift;
  support_close("energy audit", run.result->audit_error, 0.0, 1e-6);
  support_release(&run);
  return temperature;
}

static double after_four, drift; /* of the node [K], [K/orbit] */

static void interior_is_not_converged(void **state)
{
  (void)state;
  double rest = NAN;
  after_four = interior("thermal.start=isothermal", NODE, &drift);
  double periodic = interior("thermal.start=periodic", NODE, &rest);
  print_message("after four orbits %.2f K and %+.2f K/orbit; periodic %.2f K and %+.4f K/orbit\n",
                after_four, drift, periodic, rest);
  support_close("left of the way", (periodic - after_four) / (periodic - 290.0), 0.82, 0.05);
  /* the last of the four orbits: 1 - exp(-1/20.1) of what was left before it */
  support_close("drift [K/orbit]", drift, (periodic - after_four) * expm1(1.0 / 20.1), 1.0);
  support_close("periodic drift [K/orbit]", rest, 0.0, 0.02);
}

/* Between the node, which is at its mean everywhere, and no loss at all; at 1e5 W/m/K, where it has
 * no gradient either, it is the node to 0.05 K: blankets and contacts meet it here and there. */
static void solid_keeps_more(void **state)
{
  (void)state;
  if (!um_thermal_tetgen_present()) skip(); /* UMBRA_TETGEN=OFF */
  double unused, node = after_four;
  double solid = interior("thermal.start=isothermal", "name=solid", &unused);
  double metal = interior("thermal.start=isothermal", CONDUCTIVITY "1e5", &unused);
  print_message("node %.3f K, solid %.3f K, metal %.3f K\n", node, solid, metal);
  assert_true(solid > node + 0.5 && solid < 290.0 + 6500.0 * 4.0 * 6012.0 / 5.4e6);
  support_close("metal", metal, node, 0.05);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(interior_is_not_converged),
                                     cmocka_unit_test(solid_keeps_more)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
