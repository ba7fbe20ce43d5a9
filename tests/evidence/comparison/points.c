/* Observations that stand alone: every row says where the satellite is.
 *
 *                 Sun, h below the horizon
 *   plate ----n   /        a Lambert plate straight above a station on the equator, normal to nadir
 *     |         /          I = E_sun rho/pi A cos_i cos_o,  cos_o = 1,  cos_i = sin(h)
 *     | range              E = I / range^2
 *   station                m = -2.5 log10(E_lambda lambda^2 / (c 3631 Jy))
 */
#include "environment/environment.h"
#include "orbit/time.h"
#include "tests/evidence/compared.h"

#define HEAD "time_utc,quantity,of,value,sigma,satellite_height_km,azimuth_deg,elevation_deg"
#define TIME "2022-03-20T19:10:00Z"
#define UP   TIME ",magnitude_ab,v,6,0.1,550,10,90"

static const char *const scenario_text =
    "schema: 1\n"    /* 1 */
    "name: points\n" /* 2 */
    "time: {start_utc: 2022-03-20T00:00:00Z, stop_utc: 2022-03-21T00:00:00Z, step_s: 3600}\n" /* 3
                                                                                               */
    "orbit:\n"                                                                     /* 4 */
    "  points: {}\n"                                                               /* 5 */
    "attitude:\n"                                                                  /* 6 */
    "  - yaw_steering: {axis_body: [0, 0, 1], clock_body: [1, 0, 0]}\n"            /* 7 */
    "observer:\n"                                                                  /* 8 */
    "  station: {name: Zero, latitude_deg: 0, longitude_deg: 0, height_m: 100}\n"  /* 9 */
    "parts:\n"                                                                     /* 10 */
    "  - {name: plate, plate: {size_m: [2, 1]}, front: grey_white, back: black,\n" /* 11 */
    "     shell: {areal_heat_capacity_J_m2_K: 3000}, lumped: true}\n"              /* 12 */
    "thermal: {start: isothermal, start_temperature_K: 250}\n"                     /* 13 */
    "bands:\n"                                                                     /* 14 */
    "  v: {from_um: 0.549, to_um: 0.551, bins: 1}\n"                               /* 15 */
    "  r: {from_um: 0.62, to_um: 0.63, bins: 1}\n"                                 /* 16 */
    "effects:\n"                                                                   /* 17 */
    "  - {effect: earthshine, off: true}\n";                                       /* 18 */

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

/* Sine of the Sun's elevation at the intersection of equator and prime meridian, and its distance
 * [au], by the low-precision formulas of the Astronomical Almanac (0.01 deg) and GMST. d: days of
 * UTC since 2000-01-01T12:00. */
static double sun_sine(double d, double *distance)
{
  double g = (357.529 + 0.98560028 * d) * UM_DEG, q = 280.459 + 0.98564736 * d;
  double l = (q + 1.915 * sin(g) + 0.020 * sin(2.0 * g)) * UM_DEG;
  double e = (23.439 - 0.00000036 * d) * UM_DEG;
  double theta = (280.46061837 + 360.98564736629 * d) * UM_DEG;
  *distance = 1.00014 - 0.01671 * cos(g) - 0.00014 * cos(2.0 * g);
  /* the station stands at (cos theta, sin theta, 0) */
  return cos(theta) * cos(l) + sin(theta) * cos(e) * sin(l);
}

/* 0.01 deg of 16.7 deg is 6e-4 of cos_i, 0.65 mmag. */
static void flat_plate(void **state)
{
  (void)state;
  struct um_model *model = model_with(NULL);
  struct compared p = compare(model, HEAD "\n" UP "\n");
  double au, days = 8114.0 + (19.0 + 10.0 / 60.0 - 12.0) / 24.0; /* 2022-03-20 is day 8114 */
  double cos_i = -sun_sine(days, &au), range = 550e3 - 100.0;
  double e_lambda = um_environment_solar_band(&model->environment, 0.549e-6, 0.551e-6) / 0.002e-6;
  double at_aperture = e_lambda / (au * au) * 0.8 / UM_PI * 2.0 * cos_i / (range * range);
  double lambda = 0.55e-6;
  double expected = -2.5 * log10(at_aperture * lambda * lambda / (UM_LIGHT_SPEED * 3631e-26));
  print_message("plate above the equator: %.4f mag, by hand %.4f mag\n", p.comparison->model[0],
                expected);
  assert_true(p.tables->sunlit[0] == 1.0);
  if (!(fabs(p.comparison->model[0] - expected) <= 1e-3))
    fail_msg("%.6f mag, expected %.6f", p.comparison->model[0], expected);
  assert_true(fabs(p.tables->look[0].range - range) < 1e-4);
  assert_true(fabs(p.tables->look[0].elevation - 0.5 * UM_PI) < 1e-7);
  assert_true(p.tables->sample[0].t_tai < p.tables->t_obs[0]); /* light time */
  assert_true(p.result->place[0].mean[0] == 250.0);
  compared_end(&p);
  um_model_destroy(context, &model);
}

/* Rows of one time, station and place are one observation, whatever they measure; another place or
 * station at that time is another one. Nothing is known of rising and setting. */
static void rows(void **state)
{
  (void)state;
  struct um_model *model =
      model_with("observer.stations=[{name: North, latitude_deg: 10, longitude_deg: 0}]");
  struct compared p =
      compare(model, HEAD ",station,track\n" /* 1 */
                          "2022-03-20T19:00:00Z,magnitude_ab,v,6,0.1,550,200,50,Zero,a\n" UP
                          ",,a\n"                                      /* 2, 3 */
              TIME ",band_irradiance,r,1e-12,1e-13,550,10,90,Zero,a\n" /* 4 */
              TIME ",magnitude_ab,v,6,0.1,550,200,60,Zero,b\n"         /* 5 */
              TIME ",magnitude_ab,v,6,0.1,550,200,60,North,c\n"        /* 6 */
              TIME ",magnitude_ab,v,6,0.1,340,200,60,North,d\n" /* 7 */);
  assert_int_equal(p.plan->ntime, 5);
  assert_int_equal(p.plan->observation[0], 0);
  assert_int_equal(p.plan->observation[1], p.plan->observation[2]);
  for (size_t i = 3; i < 6; i++)
    for (size_t k = 1; k < i; k++) assert_true(p.plan->observation[i] != p.plan->observation[k]);
  for (size_t i = 0; i < 6; i++) {
    const struct um_compare_measurement *row = &p.measurements->row[i];
    const struct um_orbit_look *look = &p.tables->look[p.plan->observation[i]];
    assert_true(p.plan->time[p.plan->observation[i]] == row->t_tai);
    assert_true(fabs(look->elevation - row->elevation) < 1e-7);
    if (row->elevation < 1.5) assert_true(fabs(look->azimuth - row->azimuth) < 1e-9);
  }
  for (size_t k = 0; k < 5; k++) {
    assert_int_equal(p.comparison->light[k], UM_SEGMENT_SUNLIT);
    assert_int_equal(p.comparison->motion[k], UM_SEGMENT_COUNT);
    assert_true(p.result->surface_temperature[k * p.result->nsurface] == 250.0);
  }
  /* one place: its two bands are of one intensity; the same direction elsewhere sees another Sun */
  assert_true(p.comparison->model[3] != p.comparison->model[4]);
  assert_true(p.comparison->model[4] != p.comparison->model[5]);
  compared_end(&p);
  um_model_destroy(context, &model);
}

/* The order of rows in the file does not matter, nor do others beside a row: same bytes. */
static void rows_stand_alone(void **state)
{
  (void)state;
  struct um_model *model = model_with(NULL);
  struct compared one = compare(model, HEAD "\n" TIME ",magnitude_ab,v,6,0.1,550,200,60\n");
  struct compared many = compare(
      model, HEAD ",track\n" TIME ",magnitude_ab,v,6,0.1,550,230,40,a\n" TIME
                  ",magnitude_ab,v,6,0.1,550,200,60,b\n2022-03-20T18:59:00Z,magnitude_ab,v,6,0.1,"
                  "1150,100,30,c\n2022-03-20T23:00:00Z,magnitude_ab,v,6,0.1,550,100,30,d\n");
  assert_true(one.comparison->model[0] == many.comparison->model[1]);
  /* deep night, in the umbra: no light but the plate's own heat, which is none at 0.55 um */
  assert_true(many.comparison->model[3] > 60.0);
  assert_int_equal(many.comparison->light[many.plan->observation[3]], UM_SEGMENT_UMBRA);
  compared_end(&many);
  compared_end(&one);
  um_model_destroy(context, &model);
}

static void refused_rows(const struct um_model *model, const char *text, const char *message)
{
  struct um_compare_measurements *m;
  struct um_compare_plan *plan;
  put("m.csv", text);
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  assert_refused(um_compare_plan_create(context, model, m, &plan), UM_ERR_INPUT, message);
  assert_null(plan);
  um_compare_measurements_destroy(context, &m);
}

static void row_refusals(void **state)
{
  (void)state;
  struct um_model *model = model_with(NULL);
  struct um_model_tables *tables;
  refused_rows(model, "time_utc,quantity,of,value,sigma\n" TIME ",magnitude_ab,v,6,0.1\n",
               "m.csv: header: columns satellite_height_km, azimuth_deg and elevation_deg are "
               "missing; accepted: all three, because the scenario's orbit is 'points'");
  refused_rows(model, HEAD ",station\n" UP ",Zro\n",
               "m.csv:2: column 'station': the scenario has no station 'Zro'; did you mean "
               "'Zero'?; accepted: Zero, empty "
               "for the observer's (observer.station, observer.stations)");
  refused_rows(
      model, HEAD "\n" TIME ",temperature,plate,280,1,550,0,60\n",
      "m.csv:2: column 'quantity': temperature wants heat that is followed along an orbit, "
      "orbit.points has none; accepted: band_irradiance, radiant_intensity, magnitude_ab, "
      "magnitude_vega, count_rate, characteristic_temperature, infrared_cross_section");
  refused_rows(model, HEAD "\n" TIME ",magnitude_ab,v,6,0.1,0.05,0,60\n",
               "m.csv:2: satellite height 0.05 km; accepted: above the station at 0.1 km");
  refused_rows(model, HEAD "\n2022-03-22T00:00:00Z,magnitude_ab,v,6,0.1,550,0,60\n",
               "m.csv:2: column 'time_utc': 2022-03-22T00:00:00.000Z is outside the scenario; "
               "accepted: 2022-03-20T00:00:00.000Z to 2022-03-21T00:00:00.000Z (time.start_utc, "
               "time.stop_utc)");
  assert_refused(um_model_precompute(context, model, &tables), UM_ERR_INPUT,
                 "scenario.yaml:5: orbit.points: has no times and places of its own; accepted: "
                 "measurements with satellite_height_km, azimuth_deg and elevation_deg (umbra "
                 "compare, diagnose, fit)");
  assert_null(tables);
  um_model_destroy(context, &model);
}

static void refused_scenario(const char *override, const char *message)
{
  struct um_model *model;
  struct um_model_options options = {.overrides = &override, .noverride = 1};
  um_core_message_clear(context);
  assert_int_equal(um_model_create(context, SCENARIO, &options, &model), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context), message);
  assert_null(model);
}

#define LAWS "fixed, sun, target, yaw_steering, table, magnetic, spin with axis_gcrs or q_gcrs"

static void scenario_refusals(void **state)
{
  (void)state;
  refused_scenario(
      "thermal.start=periodic",
      "--set: thermal.start: periodic wants an orbit, orbit.points has none; accepted: "
      "isothermal (temperatures stay at start_temperature_K)");
  refused_scenario("attitude=[{lvlh: {}}]",
                   "--set: attitude.0.lvlh: wants a velocity, which orbit.points does not know; "
                   "accepted: " LAWS);
  refused_scenario(
      "attitude=[{spin: {axis_lvlh: [0, 1, 0], axis_body: [0, 1, 0], period_s: 100}}]",
      "--set: attitude.0.spin.axis_lvlh: wants a velocity, which orbit.points does not know; "
      "accepted: " LAWS);
  refused_scenario("observer={direction: {unit_gcrs: [0, 0, 1], range_km: 500}}",
                   "scenario.yaml:5: orbit.points: wants the station that azimuths and elevations "
                   "are of; accepted: observer.station");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(flat_plate), cmocka_unit_test(rows), cmocka_unit_test(rows_stand_alone),
      cmocka_unit_test(row_refusals), cmocka_unit_test(scenario_refusals)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
