/* scenarios/flying-laptop: counts per second follow from the satellite's spectrum, the telescope
 * and the detector, and the materials have the slopes of the paper's Table 1. */
#include <string.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "base/core/interpolation.h"
#include "environment/airmass.h"
#include "model/build/build.h"
#include "model/products/reflectivity_pass.h"
#include "tests/scenarios/support.h"
#include "tests/support/with_context.h"

#define SCENARIO           UMBRA_SOURCE_DIR "/scenarios/flying-laptop"
#define QUANTUM_EFFICIENCY UMBRA_SOURCE_DIR "/optics/instrument/sensors/zyla-5.5.csv"

/* Raxus Prime, Table 1, printed to three digits; below 0.8 %: rounding of Rq and tau
 * (docs/physics/roughness-and-lobes.md). */
static void slopes(void **state)
{
  (void)state;
  static const struct {
    const char *name;
    double alpha;
  } table[] = {{"mli_kapton_ito", 0.0295},
               {"cfrp", 0.326},
               {"cell_triple_junction", 0.265},
               {"aluminium_bare", 0.513},
               {"copper", 0.513}};
  const char *const overrides[] = {"time.step_s=240", "optics.samples=1",
                                   "thermal.start=isothermal"};
  struct support_run run;
  support_compute(SCENARIO, overrides, 3, &run);
  size_t n = sizeof table / sizeof table[0];
  assert_int_equal(um_geometry_material_count(run.model->geometry), n);
  for (size_t i = 0; i < n; i++) {
    size_t m = 0;
    while (strcmp(um_geometry_material_name(run.model->geometry, m), table[i].name) != 0) m++;
    double alpha = um_materials_roughness(run.model->material[m], NULL);
    support_close(table[i].name, alpha / table[i].alpha, 1.0, 0.008);
  }
  support_release(&run);
}

/* Over the 5 nm about a wavelength, by points 0.1 nm apart. */
static double mean_air(const struct um_environment_clear_sky *sky, double wavelength,
                       double airmass)
{
  double sum = 0.0;
  for (int i = 0; i < 50; i++) {
    double at = wavelength + 0.1e-9 * (i - 24.5);
    sum += um_environment_clear_sky_transmission(sky, at - 1e-12, at + 1e-12, airmass);
  }
  return sum / 50.0;
}

/* Counts by hand: E lambda/(h c) over 5 nm bins of the run's own spectrum, 0.43 m with 48.5 % of
 * its diameter hidden, 0.7, the detector's table at the middle of each bin, 0.45 electrons a count,
 * what the air leaves in the mean of 50 points of each bin. The table is smooth over bins but where
 * it bends or steps: 2e-4. Both telescopes count the same photons, so that their ratio is that of
 * the areas. */
static void counts(void **state)
{
  (void)state;
  const char *const overrides[] = {"time.step_s=30", "time.start_utc=2019-07-23T20:45:10Z",
                                   "optics.samples=4", "thermal.facet_size_m=0.5",
                                   "time.exposure_s=0"};
  struct support_run run;
  struct um_core_csv *qe;
  double nm[32], electrons[32];
  support_compute(SCENARIO, overrides, 5, &run);
  assert_int_equal(um_core_csv_read(run.context, QUANTUM_EFFICIENCY, &qe), UM_OK);
  size_t rows = um_core_csv_rows(qe);
  for (size_t i = 0; i < rows; i++) {
    assert_int_equal(um_core_csv_number(run.context, qe, i, 0, &nm[i]), UM_OK);
    assert_int_equal(um_core_csv_number(run.context, qe, i, 1, &electrons[i]), UM_OK);
  }
  um_core_csv_destroy(&qe);
  const struct um_model_result *r = run.result;
  double large = 0.25 * UM_PI * 0.43 * 0.43 * (1.0 - 0.485 * 0.485);
  double small = 0.25 * UM_PI * 0.20 * 0.20 * (1.0 - 0.3 * 0.3), brightest = 0.0;
  for (size_t k = 0; k < r->nobs; k++) {
    double range = run.tables->sample[k].range, rate = 0.0;
    double airmass = um_environment_airmass_toward(run.tables->look[k].elevation);
    for (size_t b = 0; b < r->nbin && r->bin_band[b] == 0; b++) {
      double intensity = 0.0;
      for (int m = 0; m < UM_MECHANISM_COUNT; m++)
        intensity += r->spectral[(k * r->nbin + b) * UM_MECHANISM_COUNT + (size_t)m];
      assert_close(r->bin_width[b], 5e-9, 1e-15);
      rate += intensity / (range * range) * r->bin_width[b] * r->wavelength[b] /
              (UM_PLANCK * UM_LIGHT_SPEED) *
              um_core_interpolate(nm, electrons, rows, r->wavelength[b] * 1e9) *
              mean_air(&run.model->environment.sky, r->wavelength[b], airmass);
    }
    rate *= large * 0.7 / 0.45;
    assert_close(r->count_rate[2 * k] / rate, 1.0, 2e-4);
    assert_close(r->count_rate[2 * k + 1] / r->count_rate[2 * k], small / large, 1e-12);
    brightest = fmax(brightest, r->count_rate[2 * k]);
  }
  print_message("brightest: %.3g counts/s\n", brightest);
  assert_true(brightest > 1e6 && brightest < 1e8); /* seen by the eye at a small telescope */
  support_release(&run);
}

/* The pass begins near the deck's normal, where the blanket's lobe of 1.7 deg is narrower than any
 * grid: looked up on a refined map it is the direct simulation within 10 % rms of its mean, and
 * without refinement not within its whole. Few rays: shadows are as coarse on both sides. */
static void pass_on_its_map(void **state)
{
  (void)state;
  static const char *const overrides[] = {"time.step_s=10", "optics.samples=2",
                                          "bands.clear.bins=4", "bands.lwir.bins=1",
                                          "thermal.facet_size_m=1"};
  static const double degrees[] = {0.0, 40.0, 80.0, 120.0, 160.0};
  struct um_model_options options = {.overrides = overrides, .noverride = 5};
  struct um_model *model = NULL;
  double phase[5], rms[2];
  assert_int_equal(um_model_create(context, SCENARIO, &options, &model), UM_OK);
  for (size_t i = 0; i < 5; i++) phase[i] = degrees[i] * UM_DEG;
  for (int refined = 0; refined < 2; refined++) {
    struct um_model_map_grid grid = {15.0 * UM_DEG, phase, 5, 3, refined ? 0.1 : 0.0};
    struct um_model_map *map = NULL;
    struct um_model_map_pass *pass = NULL;
    assert_int_equal(um_model_map_create(context, model, &grid, &map), UM_OK);
    assert_int_equal(um_model_map_pass_create(context, model, map, &pass), UM_OK);
    struct um_model_map_difference d = um_model_map_difference(pass, 0);
    rms[refined] = d.rms / d.mean;
    print_message("%zu nodes: %.3g W/sr in the mean of %zu instants, rms %.3g\n", map->nnode,
                  d.mean, d.count, rms[refined]);
    um_model_map_pass_destroy(context, &pass);
    um_model_map_destroy(context, &map);
  }
  assert_true(rms[0] > 1.0);
  assert_true(rms[1] <= 0.1);
  um_model_destroy(context, &model);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(slopes), cmocka_unit_test(counts),
      cmocka_unit_test_setup_teardown(pass_on_its_map, context_set_up, context_tear_down)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
