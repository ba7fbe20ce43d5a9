/* Sensors on top of a preset: what the scenario states counts, the rest is the preset's. Nothing is
 * computed but what building a model does. */
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "base/core/listing.h"
#include "base/core/planck.h"
#include "model/build/bands.h"
#include "model/build/build.h"
#include "model/build/sensor_preset.h"
#include "optics/instrument/photometry.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

#define BINS 100

static const char *const head =
    "schema: 1\n"
    "name: sensors\n"
    "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:00:00Z, step_s: 1}\n"
    "orbit: {fixed: {position_gcrs_km: [7000, 0, 0]}}\n"
    "attitude: [{fixed: {q_gcrs: [1, 0, 0, 0]}}]\n"
    "parts:\n"
    "  - {name: box, box: {size_m: [1, 1, 1]}, outside: grey_panel, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
    "thermal: {start: isothermal, orbits_before: 0}\n"
    "bands: {vis: {from_um: 0.45, to_um: 1.15}, lwir: {from_um: 8, to_um: 12, bins: 100}}\n"
    "sensors:\n";

static enum um_status build(const char *sensors, struct um_model **out)
{
  char text[4096], path[UM_TEST_PATH];
  snprintf(text, sizeof text, "%s%s", head, sensors);
  um_test_file_create(path, text, strlen(text));
  um_core_message_clear(context);
  enum um_status status = um_model_create(context, path, NULL, out);
  unlink(path);
  return status;
}

#define SPELT                                                                                      \
  "  spelt: {band: vis, aperture_m: 0.43, obstruction: 0.485, throughput: 0.7, gain_e: 0.45,\n"    \
  "          quantum_efficiency_file: " UMBRA_SOURCE_DIR                                           \
  "/optics/instrument/sensors/zyla-5.5.csv,\n"                                                     \
  "          pixel_arcsec: 0.456, fwhm_arcsec: 2.5, annulus_pixels: 400, read_noise_e: 1.4,\n"     \
  "          dark_e_s: 0.1, sky_mag_arcsec2: 19, saturation_e: 30000, exposure_s: 0.2}\n"

static void test_preset_is_its_keys(void **state)
{
  (void)state;
  struct um_model *m;
  if (build(SPELT "  preset: {band: vis, preset: ufo, exposure_s: 0.2}\n"
                  "  own: {band: vis, preset: ufo, exposure_s: 2, fwhm_arcsec: 4,\n"
                  "        quantum_efficiency: 0.5}\n",
            &m) != UM_OK)
    fail_msg("%s", um_core_message(context));
  const struct um_model_sensor *spelt = &m->sensor[0], *preset = &m->sensor[1],
                               *own = &m->sensor[2];
  assert_int_equal(m->nsensor, 3);
  /* no NAN but the noise-equivalent irradiance, which the scenario may give beside a preset */
  struct um_instrument_sensor a = spelt->optics, b = preset->optics;
  assert_true(isnan(a.noise_equivalent_irradiance) && isnan(b.noise_equivalent_irradiance));
  a.noise_equivalent_irradiance = b.noise_equivalent_irradiance = 0.0;
  assert_memory_equal(&a, &b, sizeof a);
  assert_true(preset->exposure == 0.2 && own->exposure == 2.0);
  int bins = m->band[0].bins;
  assert_memory_equal(spelt->efficiency, preset->efficiency, (size_t)bins * sizeof(double));
  assert_true(own->optics.fwhm == 4.0 && own->optics.aperture == 0.43);
  for (int i = 0; i < bins; i++) assert_true(fabs(own->efficiency[i] - 0.35) < 1e-15);
  um_model_destroy(context, &m);
}

/* docs/physics/noise.md: half a metre, pixels of 2 arcsec, efficiency 0.7, optics 0.6, 3.00e9
 * electrons per second and pixel of mirrors at 283 K that emit 0.15 and a sky of 0.15 at 270 K. */
static void test_cooled_background(void **state)
{
  (void)state;
  struct um_model *m;
  double edge = 4e-6 / BINS, wavelength[BINS], width[BINS], radiance[BINS];
  if (build("  cooled: {band: lwir, preset: lwir_cooled}\n", &m) != UM_OK)
    fail_msg("%s", um_core_message(context));
  const struct um_instrument_sensor *s = &m->sensor[0].optics;
  for (int i = 0; i < BINS; i++) {
    double from = 8e-6 + i * edge;
    wavelength[i] = from + 0.5 * edge;
    width[i] = edge;
    radiance[i] = (s->emissivity * um_core_planck_band(from, from + edge, s->temperature) +
                   0.15 * um_core_planck_band(from, from + edge, 270.0)) /
                  edge;
  }
  struct um_instrument_bins bins = {BINS, wavelength, width, m->sensor[0].efficiency};
  double rate = um_instrument_sky_rate(s, &bins, radiance);
  print_message("%.4g electrons per second and pixel\n", rate);
  assert_true(fabs(rate / 3.00e9 - 1.0) < 0.01);
  um_model_destroy(context, &m);
}

static void refused(const char *sensors, const char *says)
{
  struct um_model *m = NULL;
  assert_int_equal(build(sensors, &m), UM_ERR_INPUT);
  if (strstr(um_core_message(context), says) == NULL) fail_msg("%s", um_core_message(context));
}

static void test_refused(void **state)
{
  (void)state;
  refused("  a: {band: vis, preset: ufoo}\n",
          ":12: sensors.a.preset: no sensor 'ufoo'; did you mean 'ufo'?; accepted: ");
  refused("  a: {band: vis, preset: ../sensors/ufo}\n", "no sensor '../sensors/ufo'");
  refused("  a: {band: vis}\n", ":12: sensors.a.aperture_m: is missing; accepted: it, or preset");
  refused("  a: {preset: ufo}\n", "band");
  refused("  a: {band: lwir, preset: ufo, exposure_s: 1}\n", "counts nothing of band 'lwir'");
}

/* Each one that comes along can be read, and says what is assumed. */
static void test_all(void **state)
{
  (void)state;
  char **names;
  size_t count;
  assert_int_equal(um_model_sensor_presets(context, &names, &count), UM_OK);
  assert_true(count >= 4);
  for (size_t i = 0; i < count; i++) {
    char *path;
    struct um_document *document;
    struct um_scenario_preset *preset;
    assert_int_equal(um_model_sensor_preset_path(context, names[i], &path), UM_OK);
    if (um_model_sensor_preset_read(context, path, &document, &preset) != UM_OK)
      fail_msg("%s", um_core_message(context));
    assert_true(preset->sensor->aperture_m > 0.0 && strlen(preset->assumed) > 10);
    um_document_destroy(&document);
    um_core_free(context, path);
  }
  um_core_listing_free(context, names, count);
}

/* Whose magnitudes are relative to Vega: by their filters' catalogues, or as the scenario states.
 */
static void test_systems(void **state)
{
  (void)state;
  static const struct {
    const char *override;
    bool vega;
  } band[] = {{"bands.v={filter: johnson_v}", true},
              {"bands.i={filter: cousins_i}", true},
              {"bands.g={filter: gaia_g}", true},
              {"bands.sdss={filter: sdss_g}", false},
              {"bands.lsst={filter: lsst_r}", false},
              {"bands.edges={from_um: 0.5, to_um: 0.6}", false},
              {"bands.stated={from_um: 0.5, to_um: 0.6, vega_magnitude: 0}", true},
              /* where Vega is not known there is nothing to be relative to */
              {"bands.far={from_um: 45, to_um: 50, vega_magnitude: 0}", false}};
  const char *override[8];
  struct um_model *m;
  char text[4096], path[UM_TEST_PATH];
  const struct um_model_options options = {.overrides = override, .noverride = 8};
  for (size_t i = 0; i < 8; i++) override[i] = band[i].override;
  snprintf(text, sizeof text, "%s  one: {band: vis, aperture_m: 1}\n", head);
  um_test_file_create(path, text, strlen(text));
  enum um_status status = um_model_create(context, path, &options, &m);
  unlink(path);
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
  assert_int_equal(m->nband, 10);
  assert_false(um_model_band_is_vega(m, 0) || um_model_band_is_vega(m, 1));
  for (size_t i = 0; i < 8; i++)
    if (um_model_band_is_vega(m, 2 + i) != band[i].vega) fail_msg("%s", band[i].override);
  um_model_destroy(context, &m);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_preset_is_its_keys),
      cmocka_unit_test(test_cooled_background),
      cmocka_unit_test(test_refused),
      cmocka_unit_test(test_all),
      cmocka_unit_test(test_systems),
  };
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
