/* One orbit seen from several stations: what a row is of, and what its station sees.
 *
 * The other station north of Graz has its pass later: what it measures is held against
 * a scenario whose observer it is. */
#include "tests/evidence/model_test.h"

#include "evidence/comparison/comparison.h"
#include "evidence/comparison/predict.h"
#include "evidence/measurements/listed.h"

#define NORTH    "latitude_deg: 54, longitude_deg: 15, height_m: 2000"
#define STATIONS "observer.stations=[{name: North, " NORTH "}]"

static const char *const stations[] = {STATIONS, "optics.interreflection_samples=0"};

static struct um_model *model_at(const char *const *set, size_t n)
{
  const struct um_model_options options = {.overrides = set, .noverride = n};
  return model_of(&options);
}

/* The same light as the observer's own scenario, at times that both stations share and at others;
 * temperatures are those of one history. */
static void seen_from_each(void **state)
{
  (void)state;
  static const char *const alone[] = {"observer={station: {name: North, " NORTH "}}",
                                      "optics.interreflection_samples=0"};
  static const char *const rows = DAY "13:00Z,band_irradiance,vis,1,1,North,n\n" DAY
                                      "14:10Z,band_irradiance,lwir,1,1,North,n\n" DAY
                                      "15:20Z,band_irradiance,vis,1,1,North,n\n";
  char text[1024];
  struct um_model *both = model_at(stations, 2), *north = model_at(alone, 2);
  snprintf(text, sizeof text,
           "time_utc,quantity,of,value,sigma,station,track\n" DAY
           "13:00Z,band_irradiance,vis,1,1,Graz,g\n" DAY
           "14:10Z,temperature,panel.front,280,1,,g\n" DAY "15:20Z,band_irradiance,vis,1,1,,g\n%s",
           rows);
  put("m.csv", text);
  struct pair two = pair_of(both, "m.csv", 0.0);
  snprintf(text, sizeof text, "time_utc,quantity,of,value,sigma,station,track\n%s", rows);
  put("n.csv", text);
  struct pair one = pair_of(north, "n.csv", 0.0);
  assert_int_equal(two.plan->ntime, 6);
  for (size_t i = 0; i < 3; i++) {
    size_t k = two.plan->observation[3 + i], graz = two.plan->observation[i];
    size_t own = one.plan->observation[i];
    assert_int_equal(um_model_tables_station(two.tables, k), 1);
    assert_int_equal(um_model_tables_station(two.tables, graz), 0);
    assert_true(two.tables->look[k].range == one.tables->look[own].range);
    assert_true(fabs(two.tables->look[graz].range - two.tables->look[k].range) > 1.0);
    double a = two.comparison->model[3 + i], b = one.comparison->model[i];
    print_message("row %zu: %.9g W/m2, %.9g alone\n", i, a, b);
    assert_true(a > 0.0);
    if (!(fabs(a / b - 1.0) < 1e-4)) fail_msg("row %zu: %g, alone %g", i, a, b);
  }
  for (size_t i = 1; i < two.tables->nobs; i++)
    assert_true(two.tables->sample[i].t_tai >= two.tables->sample[i - 1].t_tai);
  pair_end(&one);
  remove("n.csv");
  pair_end(&two);
  um_model_destroy(context, &north);
  um_model_destroy(context, &both);
}

/* The satellite sets for one while it still rises for the other. */
static void rising_and_setting(void **state)
{
  (void)state;
  struct um_model *model = model_at(stations, 1);
  enum um_compare_segment motion[2];
  put("m.csv",
      "time_utc,quantity,of,value,sigma,station,track\n" DAY
      "15:00Z,band_irradiance,vis,1,1,Graz,g\n" DAY "15:00Z,band_irradiance,vis,1,1,North,n\n");
  struct pair p = pair_of(model, "m.csv", 0.0);
  for (size_t i = 0; i < 2; i++) motion[i] = p.comparison->motion[p.plan->observation[i]];
  assert_int_equal(motion[0], UM_SEGMENT_SETTING);
  assert_int_equal(motion[1], UM_SEGMENT_RISING);
  pair_end(&p);
  um_model_destroy(context, &model);
}

/* A set has a station; a row that names one goes before it. */
static void station_of_a_set(void **state)
{
  (void)state;
  static const char *const with_sets[] = {
      STATIONS, "measurements={sets: [{name: a, file: a.csv}, {name: b, file: b.csv, station: "
                "North}]}"};
  struct um_compare_measurements *m;
  struct um_compare_plan *plan;
  put("a.csv", HEAD DAY "13:00Z,band_irradiance,vis,1,1\n");
  put("b.csv", "time_utc,quantity,of,value,sigma,station\n" DAY
               "14:00Z,band_irradiance,vis,1,1,\n" DAY "14:10Z,band_irradiance,vis,1,1,Graz\n");
  struct um_model *model = model_at(with_sets, 2);
  assert_ok(um_compare_measurements_listed(context, model->scenario, &m));
  assert_ok(um_compare_plan_create(context, model, m, &plan));
  static const size_t expected[] = {0, 1, 0};
  for (size_t i = 0; i < 3; i++) assert_int_equal(plan->station[plan->observation[i]], expected[i]);
  um_compare_plan_destroy(context, &plan);
  um_compare_measurements_destroy(context, &m);
  um_model_destroy(context, &model);
  remove("a.csv");
  remove("b.csv");
}

static void refused_rows(const char *station, const char *message)
{
  struct um_compare_measurements *m;
  struct um_compare_plan *plan;
  struct um_model *model = model_at(stations, 1);
  char text[256];
  snprintf(text, sizeof text,
           "time_utc,quantity,of,value,sigma,station\n" DAY "13:00Z,band_irradiance,vis,1,1,%s\n",
           station);
  put("m.csv", text);
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  assert_refused(um_compare_plan_create(context, model, m, &plan), UM_ERR_INPUT, message);
  assert_null(plan);
  um_compare_measurements_destroy(context, &m);
  um_model_destroy(context, &model);
}

static void refused_scenario(const char *const *set, size_t n, const char *message)
{
  struct um_model *model;
  const struct um_model_options options = {.overrides = set, .noverride = n};
  assert_refused(um_model_create(context, SCENARIO, &options, &model), UM_ERR_INPUT, message);
  assert_null(model);
}

static void refusals(void **state)
{
  (void)state;
  static const char *const nameless[] = {"observer.stations=[{" NORTH "}]"};
  static const char *const taken[] = {"observer.stations=[{name: Graz, " NORTH "}]"};
  static const char *const twice[] = {"observer.stations=[{name: N, " NORTH "}, {name: N, " NORTH
                                      "}]"};
  static const char *const direction[] = {
      "observer={direction: {unit_gcrs: [0, 0, 1], range_km: 500}, stations: [{name: N, " NORTH
      "}]}"};
  static const char *const of_set[] = {
      STATIONS, "measurements={sets: [{name: b, file: b.csv, station: Nrth}]}"};
  struct um_compare_measurements *m;
  refused_rows("Nrth", "m.csv:2: column 'station': the scenario has no station 'Nrth'; did you "
                       "mean 'North'?; accepted: Graz, North, empty for the observer's "
                       "(observer.station, observer.stations)");
  refused_scenario(nameless, 1,
                   "--set: observer.stations.0: has no name; accepted: the one that measurements "
                   "use");
  refused_scenario(taken, 1,
                   "--set: observer.stations.Graz.name: 'Graz' is taken; accepted: names used "
                   "once");
  refused_scenario(twice, 1,
                   "--set: observer.stations.N.name: 'N' is taken; accepted: names used once");
  refused_scenario(direction, 1,
                   "--set: observer.stations: stands beside an observer that is no station; "
                   "accepted: with observer.station");
  put("b.csv", HEAD DAY "14:00Z,band_irradiance,vis,1,1\n");
  struct um_model *model = model_at(of_set, 2);
  assert_refused(um_compare_measurements_listed(context, model->scenario, &m), UM_ERR_INPUT,
                 "--set:0: measurements.sets.b.station: the scenario has no station 'Nrth'; did "
                 "you mean 'North'?; accepted: Graz, North, empty for the observer's "
                 "(observer.station, observer.stations)");
  um_model_destroy(context, &model);
  remove("b.csv");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(seen_from_each), cmocka_unit_test(rising_and_setting),
      cmocka_unit_test(station_of_a_set), cmocka_unit_test(refusals)};
  return cmocka_run_group_tests(tests, model_set_up, model_tear_down);
}
