/* Measurements as reflectivity. What the whole model says of four quantities, read back as if it
 * had been measured, is the reflectivity that the renderer gives for the directions of each
 * instant: grey bodies in sunlight alone, above air, on a pass that begins in the umbra. */
#include "evidence/inversion/on_map.h"

#include "tests/evidence/model_test.h"

#define BINS "bands.vis.bins=6"
#define SENSORS                                                                                    \
  "sensors={eye: {band: vis, aperture_m: 0.4, throughput: 0.6, quantum_efficiency: 0.5, gain_e: "  \
  "1}}"

static struct um_model *grey_model(void)
{
  const char *const without[] = {"earthshine", "reflected_earth_ir"};
  const char *const set[] = {BINS, "observer.air={profile: us_standard}", SENSORS};
  struct um_model_options options = {
      .overrides = set, .noverride = 3, .without = without, .nwithout = 2};
  struct um_model *model = NULL;
  assert_ok(um_model_create(context, SCENARIO, &options, &model));
  return model;
}

static const char *const quantity[][2] = {{"radiant_intensity", "vis"},
                                          {"band_irradiance", "vis"},
                                          {"magnitude_ab", "vis"},
                                          {"magnitude_vega", "vis"},
                                          {"count_rate", "eye"}};
static const char *const times[] = {"18:09:00", "18:10:10", "18:12:00", "18:14:30", "18:16:00"};

/* Rows of every quantity at every time; value[5 times][5 quantities], NULL: ones. */
static void put_rows(const double *value)
{
  char text[4096];
  size_t n = (size_t)snprintf(text, sizeof text, HEAD);
  for (size_t t = 0; t < 5; t++)
    for (size_t q = 0; q < 5; q++)
      n += (size_t)snprintf(text + n, sizeof text - n, "2016-09-06T%s.000Z,%s,%s,%.17g,%s\n",
                            times[t], quantity[q][0], quantity[q][1],
                            value != NULL ? value[5 * t + q] : 1.0, q == 0 ? "0.5" : "");
  n += (size_t)snprintf(text + n, sizeof text - n,
                        "2016-09-06T18:17:00.000Z,temperature,bus.+x,%s\n", "280,1");
  put("m.csv", text);
}

/* Colours of sunlight in 6 bins weigh nothing: the bodies are grey, and so are both sides of every
 * ratio. Lines of sight are floats: 1e-6. */
static void model_read_back(void **state)
{
  (void)state;
  struct um_model *model = grey_model();
  struct um_compare_measurements *m = NULL;
  struct um_compare_plan *plan = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  struct um_compare_on_map *on_map = NULL;
  struct um_model_map *map = NULL;
  struct um_model_map_pass *pass = NULL;
  double value[26], phase = 0.0;
  put_rows(NULL);
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  assert_ok(um_compare_plan_create(context, model, m, &plan));
  assert_ok(um_compare_plan_trace(context, model, plan, &tables));
  assert_ok(um_model_run(context, model, tables, &result));
  assert_ok(um_compare_predict(context, plan, tables, result, value));
  for (size_t i = 0; i < 5; i++) value[i] = 1.0; /* dark */
  um_compare_plan_destroy(context, &plan);
  um_compare_measurements_destroy(context, &m);
  put_rows(value);
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  assert_ok(um_compare_on_map_create(context, model, m, &on_map));
  assert_int_equal(on_map->count, 20);
  assert_int_equal(on_map->dark, 5);
  struct um_model_map_grid grid = {0.5 * UM_PI, &phase, 1, 1, 0.0};
  assert_ok(um_model_map_create(context, model, &grid, &map));
  assert_ok(um_model_map_pass_of(context, model, map, on_map->sample, on_map->plan->time,
                                 on_map->plan->ntime, &pass));
  for (size_t i = 0; i < on_map->count; i++) {
    const struct um_compare_map_row *row = &on_map->row[i];
    double direct = pass->direct[row->observation * pass->nband];
    assert_int_equal(row->band, 0);
    assert_true(direct > 0.0);
    assert_close(row->value / direct, 1.0, 1e-6);
    if (i % 5 == 0)
      assert_close(row->sigma, 0.5 / row->light, 1e-15);
    else
      assert_true(isnan(row->sigma));
  }
  um_model_map_pass_destroy(context, &pass);
  um_model_map_destroy(context, &map);
  um_compare_on_map_destroy(context, &on_map);
  um_compare_measurements_destroy(context, &m);
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
}

static void nothing_in_sunlight(void **state)
{
  (void)state;
  struct um_model *model = grey_model();
  struct um_compare_measurements *m = NULL;
  struct um_compare_on_map *on_map = NULL;
  put("m.csv", HEAD DAY "09:00.000Z,radiant_intensity,vis,0,1\n");
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  assert_int_equal(um_compare_on_map_create(context, model, m, &on_map), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(context), "m.csv: no row of light in sunlight, 1 in the "
                                                   "shadow; accepted: one or more"));
  assert_null(on_map);
  um_compare_measurements_destroy(context, &m);
  um_model_destroy(context, &model);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(model_read_back, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(nothing_in_sunlight, model_set_up, model_tear_down)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
