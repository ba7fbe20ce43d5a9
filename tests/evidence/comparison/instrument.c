/* Magnitudes through filters, relative to Vega, and counts of a sensor beside measurements.
 *
 * A Lambert plate straight above a station, in sunlight alone, has the Sun's own spectrum. So its
 * magnitude in any filter is the Sun's, dimmed by one number k for all of them, and its counts are
 * those of the dimmed Sun. k is taken from a narrow band, the rest is predicted. */
#include "environment/clear_sky.h"
#include "environment/environment.h"
#include "model/run/counts.h"
#include "optics/instrument/filter.h"
#include "optics/instrument/photometry.h"
#include "tests/evidence/compared.h"

#define BINS 40
#define TIME "2022-03-20T19:10:00Z"
#define TAIL ",550,10,90\n"
#define HEAD "time_utc,quantity,of,value,sigma,satellite_height_km,azimuth_deg,elevation_deg\n"

static const char *const scenario_text =
    "schema: 1\n"
    "name: points\n"
    "time: {start_utc: 2022-03-20T00:00:00Z, stop_utc: 2022-03-21T00:00:00Z, step_s: 3600}\n"
    "orbit: {points: {}}\n"
    "attitude: [{yaw_steering: {axis_body: [0, 0, 1], clock_body: [1, 0, 0]}}]\n"
    "observer:\n"
    "  station: {name: Zero, latitude_deg: 0, longitude_deg: 0, height_m: 100}\n"
    "parts:\n"
    "  - {name: plate, plate: {size_m: [2, 1]}, front: grey_white, back: black,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}, lumped: true}\n"
    "thermal: {start: isothermal, start_temperature_K: 250}\n"
    "bands:\n"
    "  line: {from_um: 0.549, to_um: 0.551, bins: 1}\n"
    "  V: {filter: johnson_v, vega_magnitude: 0.03}\n"
    "  own: {filter_file: own.csv, bins: 20}\n"
    "sensors:\n"
    "  ufo: {band: V, aperture_m: 0.43, obstruction: 0.485, throughput: 0.7, "
    "quantum_efficiency_file: qe.csv, gain_e: 0.45}\n"
    "effects:\n"
    "  - {effect: earthshine, off: true}\n";

static int set_up(void **state)
{
  if (compare_set_up(state) != 0) return -1;
  put(SCENARIO, scenario_text);
  put("own.csv", "wavelength_um,transmission\n0.6,0\n0.62,0.5\n0.68,0.5\n0.7,0\n");
  put("qe.csv", "wavelength_nm,transmission\n400,0.4\n600,0.6\n900,0.3\n");
  return 0;
}

static int tear_down(void **state)
{
  remove(SCENARIO);
  remove("own.csv");
  remove("qe.csv");
  return compare_tear_down(state);
}

struct light {
  double wavelength[BINS], width[BINS], transmission[BINS], sun[BINS];
  struct um_instrument_bins bins;
};

/* The Sun at 1 au in the bins of a filter. */
static void light_of(struct light *l, const struct um_environment *environment,
                     const struct um_instrument_filter *f, int n)
{
  double a = f->wavelength[0], b = f->wavelength[f->n - 1];
  for (int i = 0; i < n; i++) {
    double from = a + (b - a) * i / n, to = a + (b - a) * (i + 1) / n;
    l->wavelength[i] = 0.5 * (from + to);
    l->width[i] = to - from;
    l->transmission[i] = um_instrument_filter_mean(f, from, to);
    l->sun[i] = um_environment_solar_band(environment, from, to) / (to - from);
  }
  l->bins = (struct um_instrument_bins){(size_t)n, l->wavelength, l->width, l->transmission};
}

static const char rows[] = HEAD TIME
    ",band_irradiance,line,1e-12,1e-13" TAIL TIME ",band_irradiance,V,1e-12,1e-13" TAIL TIME
    ",magnitude_ab,V,6,0.1" TAIL TIME ",magnitude_vega,V,6,0.1" TAIL TIME
    ",magnitude_vega,own,6,0.1" TAIL TIME ",count_rate,ufo,1e5,1e3" TAIL;

static void test_one_spectrum(void **state)
{
  (void)state;
  struct um_model *model = model_with(NULL);
  struct compared p = compare(model, rows);
  const double *got = p.comparison->model;
  struct um_instrument_filter *v, *own, *qe;
  struct light in_v, in_own, counted;
  assert_ok(um_instrument_filter_find(context, "johnson_v", &v));
  assert_ok(um_instrument_filter_read(context, "own.csv", &own));
  assert_ok(um_instrument_filter_read(context, "qe.csv", &qe));
  light_of(&in_v, &model->environment, v, BINS);
  light_of(&in_own, &model->environment, own, 20);
  double k = got[0] / um_environment_solar_band(&model->environment, 0.549e-6, 0.551e-6);
  assert_close(got[1] / (k * um_instrument_irradiance(&in_v.bins, in_v.sun)), 1.0, 1e-9);
  double dimmed = -2.5 * log10(k), ab = um_instrument_magnitude_ab(&in_v.bins, in_v.sun);
  assert_close(got[2], ab + dimmed, 1e-9);
  assert_close(got[3], got[2] - um_instrument_vega_ab(&in_v.bins) + 0.03, 1e-9);
  assert_close(got[4],
               um_instrument_magnitude_ab(&in_own.bins, in_own.sun) -
                   um_instrument_vega_ab(&in_own.bins) + dimmed,
               1e-9);
  /* photons bin by bin, electrons by the curve's mean over the bin, counts by the gain */
  counted = in_v;
  double rate = 0.0;
  for (int i = 0; i < BINS; i++) {
    double l = counted.wavelength[i], w = counted.width[i];
    rate += k * counted.sun[i] * w * counted.transmission[i] * 0.7 *
            um_instrument_filter_mean(qe, l - 0.5 * w, l + 0.5 * w) * l /
            (UM_PLANCK * UM_LIGHT_SPEED);
  }
  rate *= 0.25 * UM_PI * 0.43 * 0.43 * (1.0 - 0.485 * 0.485) / 0.45;
  print_message("%.4g counts/s of a plate of %.3f mag in V\n", got[5], got[3]);
  assert_close(got[5] / rate, 1.0, 1e-9);
  um_instrument_filter_destroy(context, &v);
  um_instrument_filter_destroy(context, &own);
  um_instrument_filter_destroy(context, &qe);
  compared_end(&p);
  um_model_destroy(context, &model);
}

/* What the atmosphere takes of irradiance it takes of counts, and not of magnitudes; a sampling
 * error is relative to the same light in all of them. */
static void test_effects(void **state)
{
  (void)state;
  struct um_model *bare = model_with(NULL);
  struct um_model *dim =
      model_with("effects=[{effect: earthshine, off: true}, {effect: extinction, target: V, "
                 "k_mag: 0.3}]");
  struct compared a = compare(bare, rows), b = compare(dim, rows);
  const double *x = a.comparison->model, *y = b.comparison->model;
  double airmass = 0.99971; /* Kasten & Young 1989 in the zenith */
  assert_close(y[1] / x[1], pow(10.0, -0.4 * 0.3 * airmass), 1e-6);
  assert_close((y[5] / x[5]) / (y[1] / x[1]), 1.0, 1e-12);
  assert_close(y[3], x[3], 0.0);
  compared_end(&a);
  compared_end(&b);
  um_model_destroy(context, &bare);
  um_model_destroy(context, &dim);
}

/* Clear air: what it takes of a narrow band it takes of irradiance; counts through the filter lose
 * the mean of it over what they count, to the curvature of the air within a bin; magnitudes lose
 * nothing. */
static void test_air(void **state)
{
  (void)state;
  struct um_model *bare = model_with(NULL);
  struct um_model *air =
      model_with("observer={station: {name: Zero, latitude_deg: 0, longitude_deg: 0, height_m: "
                 "100}, air: {profile: mid_latitude_summer, aerosol: 0.2}}");
  struct compared a = compare(bare, rows), b = compare(air, rows);
  const double *x = a.comparison->model, *y = b.comparison->model;
  struct um_environment_clear_sky sky =
      um_environment_clear_sky_of(UM_SKY_MID_LATITUDE_SUMMER, 100.0);
  sky.aerosol = 0.2;
  double airmass = 0.99971;
  assert_close(y[0] / x[0],
               um_environment_clear_sky_transmission(&sky, 0.549e-6, 0.551e-6, airmass), 1e-6);
  assert_true(y[0] / x[0] > 0.70 && y[0] / x[0] < 0.80);
  assert_close(y[2], x[2], 0.0);
  assert_close(y[4], x[4], 0.0);
  assert_close((y[5] / x[5]) / (y[1] / x[1]), 1.0, 0.02);
  assert_true(y[5] / x[5] != y[1] / x[1]); /* the detector weighs the colours its own way */
  assert_close(b.result->irradiance_error[1] * x[1], a.result->irradiance_error[1] * y[1], 1e-30);
  compared_end(&a);
  compared_end(&b);
  um_model_destroy(context, &bare);
  um_model_destroy(context, &air);
}

/* A thermal imager's background: 0.5 m, 2 arcsec pixels, quantum efficiency 0.7, throughput 0.6,
 * optics of emissivity 0.3 at 280 K, by the photon radiance of 8-12 um at 280 K
 * (docs/physics/thermal-emission.md, 1.371287e21 1/s/m^2/sr); air adds its own glow. */
static void test_glow(void **state)
{
  (void)state;
  const char *const sets[] = {"bands={lwir: {from_um: 8, to_um: 12, bins: 40}}",
                              "sensors={imager: {band: lwir, aperture_m: 0.5, throughput: 0.6, "
                              "quantum_efficiency: 0.7, exposure_s: 0.01, pixel_arcsec: 2, "
                              "optics_emissivity: 0.3, optics_temperature_K: 280}}",
                              "observer.air={profile: us_standard}"};
  double per_pixel[2];
  for (size_t n = 2; n <= 3; n++) {
    struct um_model *model;
    struct um_model_options options = {.overrides = sets, .noverride = n};
    assert_ok(um_model_create(context, SCENARIO, &options, &model));
    struct compared p = compare(model, HEAD TIME ",count_rate,imager,1,1" TAIL);
    struct um_instrument_exposure e = um_model_expose(model, p.tables, p.result, 0, 0);
    per_pixel[n - 2] = e.background / 0.01 / UM_PI; /* a radius of 2 arcsec is one pixel */
    assert_true(e.snr > 0.0);
    compared_end(&p);
    um_model_destroy(context, &model);
  }
  double arcsec = UM_DEG / 3600.0;
  double solid = 0.25 * UM_PI * 0.25 * 4.0 * arcsec * arcsec;
  assert_close(per_pixel[0] / (solid * 0.7 * 0.6 * 0.3 * 1.371287e21), 1.0, 1e-3);
  print_message("optics %.3g e/s a pixel, with air %.3g\n", per_pixel[0], per_pixel[1]);
  assert_true(per_pixel[1] > 1.2 * per_pixel[0] && per_pixel[1] < 3.0 * per_pixel[0]);
}

/* An error of the model in flux: relative to Vega it is that of AB times the flux between zeros. */
static void test_errors(void **state)
{
  (void)state;
  struct um_model *model = model_with(NULL);
  struct compared p = compare(model, rows);
  double sigma[6];
  p.result->magnitude_error[1] = 3.0;
  p.result->count_rate_error[0] = 7.0;
  um_compare_predict_error(p.plan, p.result, sigma);
  assert_close(sigma[2], 3.0, 0.0);
  assert_close(sigma[3] / (3.0 * pow(10.0, 0.4 * model->vega_ab[1])), 1.0, 1e-14);
  assert_close(sigma[5], 7.0, 0.0);
  compared_end(&p);
  um_model_destroy(context, &model);
}

static void refused_scenario(const char *override, const char *part)
{
  struct um_model *model;
  struct um_model_options options = {.overrides = &override, .noverride = 1};
  um_core_message_clear(context);
  enum um_status status = um_model_create(context, SCENARIO, &options, &model);
  if (status == UM_OK || strstr(um_core_message(context), part) == NULL)
    fail_msg("%s: %d %s", override, status, um_core_message(context));
}

static void test_refused(void **state)
{
  (void)state;
  refused_scenario("bands.V={bins: 3}", "bands.V: no edges and no filter; accepted: from_um with "
                                        "to_um, or filter, or filter_file");
  refused_scenario("bands.V={filter: johnson_v, from_um: 0.5}",
                   "bands.V: its edges are given twice; accepted");
  refused_scenario("bands.V={filter: johnson_v, filter_file: own.csv}",
                   "bands.V: its edges are given twice; accepted");
  refused_scenario("bands.V={from_um: 0.5}",
                   "bands.V: one edge is missing; accepted: to_um as well");
  refused_scenario("bands.V={filter: jonson_v}",
                   "bands.V.filter: no filter 'jonson_v'; did you mean 'johnson_v'?");
  refused_scenario("bands.V={filter_file: nowhere.csv}", "bands.V.filter_file: ");
  refused_scenario(
      "sensors.ufo.band=W",
      "sensors.ufo.band: the scenario has no band 'W'; did you mean 'V'?; accepted: line, V, own");
  refused_scenario("sensors.ufo.quantum_efficiency=0.5",
                   "sensors.ufo.quantum_efficiency: is given beside quantum_efficiency_file");
  refused_scenario("sensors.ufo.pixel_arcsec=0.5",
                   "sensors.ufo.pixel_arcsec: noise is that of an exposure, whose length");
  refused_scenario("observer={direction: {unit_gcrs: [1, 0, 0], range_km: 1000}, air: {}}",
                   "observer.air: there is no air before an observer in space");
#define STATION "observer={station: {name: Zero, latitude_deg: 0, longitude_deg: 0}, air: {"
  refused_scenario(STATION "file: nowhere.csv}}", "observer.air.file: ");
  struct um_model *none;
  const char *const far[] = {STATION "profile: us_standard}}",
                             "bands={swir: {from_um: 1.5, to_um: 1.7}}", "sensors={}"};
  struct um_model_options options = {.overrides = far, .noverride = 3};
  um_core_message_clear(context);
  assert_int_not_equal(um_model_create(context, SCENARIO, &options, &none), UM_OK);
  assert_non_null(strstr(um_core_message(context),
                         "band 'swir', 1.5 to 1.7 um, is beyond the air that is known; accepted: "
                         "bands within 0.3 to 1.16 um or 7.02 to 14.28 um, or a file"));
  refused_scenario("sensors={q/e: {band: V, aperture_m: 1}}", "'q/e' cannot name a sensor");
  put("qe.csv", "wavelength_nm,transmission\n900,0.4\n1000,0.6\n");
  refused_scenario("name=far", "quantum_efficiency_file: counts nothing of band 'V'; accepted: a "
                               "curve that reaches into 0.47182 to 0.74278 um");
  put("qe.csv", "wavelength_nm,transmission\n400,0.4\n600,0.6\n900,0.3\n");
  struct um_compare_measurements *m;
  struct um_compare_plan *plan;
  struct um_model *model = model_with(NULL);
  put("m.csv", HEAD TIME ",count_rate,uf,1,1" TAIL);
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  assert_refused(um_compare_plan_create(context, model, m, &plan), UM_ERR_INPUT,
                 "m.csv:2: column 'of': the scenario has no sensor 'uf'; did you mean 'ufo'?; "
                 "accepted: ufo");
  um_compare_measurements_destroy(context, &m);
  um_model_destroy(context, &model);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_one_spectrum, set_up, tear_down),
      cmocka_unit_test_setup_teardown(test_effects, set_up, tear_down),
      cmocka_unit_test_setup_teardown(test_air, set_up, tear_down),
      cmocka_unit_test_setup_teardown(test_glow, set_up, tear_down),
      cmocka_unit_test_setup_teardown(test_errors, set_up, tear_down),
      cmocka_unit_test_setup_teardown(test_refused, set_up, tear_down),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
