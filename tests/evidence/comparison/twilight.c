/* The sky behind a satellite as a camera has it: zeniths at twilight as measured, moonlight as
 * published, and what of it is left in a measurement that does not subtract it. */
#include "model/run/counts.h"
#include "model/run/sky_light.h"
#include "orbit/sun.h"
#include "tests/evidence/compared.h"

#define HEAD "time_utc,quantity,of,value,sigma,satellite_height_km,azimuth_deg,elevation_deg\n"

static const char *const scenario_text =
    "schema: 1\n"
    "name: twilight\n"
    "time: {start_utc: 2022-03-17T00:00:00Z, stop_utc: 2022-03-21T00:00:00Z, step_s: 3600}\n"
    "orbit: {points: {}}\n"
    "attitude: [{yaw_steering: {axis_body: [0, 0, 1], clock_body: [1, 0, 0]}}]\n"
    "observer:\n"
    "  station: {name: Zero, latitude_deg: 0, longitude_deg: 0, height_m: 2635}\n"
    "  air: {profile: us_standard, ozone_DU: 260, aerosol: 0.03}\n"
    "parts:\n"
    "  - {name: plate, plate: {size_m: [2, 1]}, front: grey_white, back: black,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}, lumped: true}\n"
    "thermal: {start: isothermal, start_temperature_K: 250}\n"
    "bands:\n"
    "  V: {filter: johnson_v}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 10}\n"
    "sensors:\n"
    "  cam: {band: V, aperture_m: 0.43, obstruction: 0.485, throughput: 0.7, "
    "quantum_efficiency: 0.6, exposure_s: 2, pixel_arcsec: 2, fwhm_arcsec: 2.5, "
    "read_noise_e: 1.4, dark_e_s: 0}\n";

static int set_up(void **state)
{
  if (compare_set_up(state) != 0) return -1;
  put(SCENARIO, scenario_text);
  return 0;
}

static int tear_down(void **state)
{
  remove(SCENARIO);
  return compare_tear_down(state);
}

/* What a camera has at a time and direction. */
struct seen {
  double magnitude; /* of the background, AB per square arcsecond */
  double snr, limit, rate, irradiance, background;
  double radiance; /* of 0.50 to 0.58 um [W/m^2/sr/m] */
  /* of the Moon [rad]; extinction in the zenith [mag] */
  double phase, moon_elevation, separation, extinction;
};

static void place_moon(const struct um_model *model, const struct compared *p, struct seen *s)
{
  const struct um_orbit_look *l = &p->tables->look[0];
  const struct um_environment_sample *sample = &p->tables->sample[0];
  struct um_vec3 station = um_vec3_axpy(l->r_gcrs, l->range, l->to_observer);
  struct um_vec3 moon = um_vec3_sub(um_orbit_moon_position(sample->t_tai), station);
  struct um_vec3 sun = um_vec3_scale(sample->sun, sample->sun_distance);
  s->phase = um_vec3_angle(um_vec3_sub(sun, moon), um_vec3_scale(moon, -1.0));
  s->moon_elevation = 0.5 * UM_PI - um_vec3_angle(moon, station);
  s->separation = um_vec3_angle(moon, um_vec3_scale(l->to_observer, -1.0));
  s->extinction = -2.5 * log10(um_environment_clear_sky_transmission(&model->environment.sky,
                                                                     0.545e-6, 0.555e-6, 1.0));
}

static struct seen look(const char *time, double azimuth, double elevation, const char *set)
{
  const char *const sets[] = {set, NULL};
  char rows[512];
  struct um_model *model;
  struct um_model_options options = {.overrides = sets, .noverride = set != NULL};
  struct seen s;
  snprintf(rows, sizeof rows, HEAD "%s,count_rate,cam,1,1,800,%g,%g\n", time, azimuth, elevation);
  assert_ok(um_model_create(context, SCENARIO, &options, &model));
  struct compared p = compare(model, rows);
  const struct um_instrument_sensor *cam = &model->sensor[0].optics;
  struct um_instrument_exposure e = um_model_expose(model, p.tables, p.result, 0, 0);
  struct um_instrument_bins bins = um_model_bins(p.result, 0, model->sensor[0].efficiency);
  s.background = um_model_pixel_background(model, p.tables, p.result, 0, 0);
  double zero = um_instrument_count_rate_ab0(cam, &bins) * cam->gain;
  s.magnitude = -2.5 * log10(s.background / (2.0 * 4.0 * zero));
  s.snr = e.snr;
  s.limit = e.limit_ab;
  s.rate = p.result->count_rate[0];
  s.irradiance = p.result->irradiance[0];
  struct um_model_sky sky;
  um_model_sky(model, p.tables, 0, 0.4e-6, 0.75e-6, &sky);
  s.radiance = um_model_sky_radiance(&sky, 0.50e-6, 0.58e-6);
  place_moon(model, &p, &s);
  compared_end(&p);
  um_model_destroy(context, &model);
  return s;
}

/* Patat et al. 2006 (tests/reference/twilight-paranal.csv), V, through the filter and the detector:
 * depressions of 5.0, 8.0 and 11.0 deg over the equator at an equinox, 4 minutes a degree. */
static void test_zenith(void **state)
{
  static const struct {
    const char *time;
    double depression;
  } row[] = {
      {"2022-03-20T18:27:16Z", 5.0}, {"2022-03-20T18:39:15Z", 8.0}, {"2022-03-20T18:51:15Z", 11.0}};
  (void)state;
  double limit = -INFINITY;
  for (size_t i = 0; i < 3; i++) {
    struct seen s = look(row[i].time, 10.0, 89.9, NULL);
    double x = row[i].depression - 5.0;
    double measured = 11.84 + 1.518 * x - 0.057 * x * x;
    print_message("%4.1f deg: V %.2f, Paranal %.2f; SNR %.3g, limit %.2f\n", row[i].depression,
                  s.magnitude, measured, s.snr, s.limit);
    assert_close(s.magnitude, measured, 0.35);
    assert_true(s.limit > limit + 1.0);
    limit = s.limit;
    if (i > 0) continue;
    /* the light itself does not know of the sky */
    struct seen bare = look(row[i].time, 10.0, 89.9, "effects=[{effect: atmosphere, off: true}]");
    assert_close(bare.background, 0.0, 0.0);
    assert_true(bare.rate > s.rate && bare.rate < 1.25 * s.rate);
    assert_true(bare.snr > s.snr);
  }
}

/* Without subtraction: E' = E + Omega L, in counts what the pixels of that area have. */
static void test_left(void **state)
{
  (void)state;
  const char *const time = "2022-03-20T18:35:00Z";
  struct seen a = look(time, 10.0, 60.0, NULL);
  struct seen b = look(time, 10.0, 60.0, "effects=[{effect: twilight, area_arcsec2: 40}]");
  struct seen c =
      look(time, 10.0, 60.0, "effects=[{effect: twilight, target: V, area_arcsec2: 20}]");
  double added = b.rate - a.rate, pixels = 10.0;
  assert_close(added / (a.background / 2.0 * pixels), 1.0, 0.03); /* colour within the filter */
  assert_close((c.rate - a.rate) / added, 0.5, 1e-9);
  assert_close((c.irradiance - a.irradiance) / (b.irradiance - a.irradiance), 0.5, 1e-9);
  assert_close(b.background, a.background, 0.0);
  double solid = 40.0 * UM_DEG * UM_DEG / 3600.0 / 3600.0;
  double mean = (b.irradiance - a.irradiance) / solid / 85e-9; /* equivalent width of V */
  assert_close(mean / a.radiance, 1.0, 0.15);
}

/* Krisciunas & Schaefer 1991, PASP 103:1033, eqs. 3, 15 and 20: the moonlit sky by phase and
 * separation [deg], zenith distances and extinction; 23 % off what was measured. */
static double published(const struct seen *s, double elevation)
{
  double rho = s->separation / UM_DEG, g = s->phase / UM_DEG, k = s->extinction;
  double lunar = pow(10.0, -0.4 * (3.84 + 0.026 * g + 4e-9 * pow(g, 4.0)));
  double f = pow(10.0, 5.36) * (1.06 + cos(s->separation) * cos(s->separation)) +
             pow(10.0, 6.15 - rho / 40.0);
  double to_moon = cos(s->moon_elevation), to_sky = cos(elevation);
  double nanolambert = f * lunar * pow(10.0, -0.4 * k / sqrt(1.0 - 0.96 * to_moon * to_moon)) *
                       (1.0 - pow(10.0, -0.4 * k / sqrt(1.0 - 0.96 * to_sky * to_sky)));
  return (20.7233 - log(nanolambert / 34.08)) / 0.92104;
}

static void test_moonlit(void **state)
{
  static const struct {
    const char *time;
    double azimuth, elevation;
  } row[] = {{"2022-03-18T22:00:00Z", 270.0, 50.0},
             {"2022-03-18T21:00:00Z", 300.0, 60.0},
             {"2022-03-17T22:30:00Z", 200.0, 70.0},
             {"2022-03-20T23:00:00Z", 290.0, 40.0}};
  (void)state;
  for (size_t i = 0; i < 4; i++) {
    struct seen s = look(row[i].time, row[i].azimuth, row[i].elevation, NULL);
    double expected = published(&s, row[i].elevation * UM_DEG);
    print_message("phase %.0f deg, %.0f deg up, %.0f deg away: V %.2f, published %.2f\n",
                  s.phase / UM_DEG, s.moon_elevation / UM_DEG, s.separation / UM_DEG, s.magnitude,
                  expected);
    assert_close(s.magnitude, expected, 0.6);
    if (i > 0) continue;
    struct seen dark = look(row[i].time, row[i].azimuth, row[i].elevation,
                            "effects=[{effect: moonlight, off: true}]");
    assert_true(dark.background < 1e-3 * s.background);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_zenith, set_up, tear_down),
      cmocka_unit_test_setup_teardown(test_left, set_up, tear_down),
      cmocka_unit_test_setup_teardown(test_moonlit, set_up, tear_down),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
