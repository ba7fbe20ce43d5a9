/* Characteristic temperature and infrared cross-section of a run, and as quantities that are
 * measured: a grey plate has its own temperature and emissivity times area seen; what the bands of
 * a real pass say, in the shadow and in sunlight, is what `umbra retrieve` makes of the same light;
 * noise is as stated; where something is left out it shows. */
#include "tests/evidence/model_test.h"

#include "base/core/planck.h"
#include "evidence/comparison/compare.h"
#include "evidence/inversion/retrieve.h"
#include "evidence/inversion/synth.h"
#include "evidence/measurements/measurements.h"
#include "evidence/measurements/write.h"
#include "model/products/run_response.h"
#include "output/lightcurve_impl.h"

#define THERMAL                                                                                    \
  "bands:\n"                                                                                       \
  "  vis: {from_um: 0.38, to_um: 0.78, bins: 4}\n"                                                 \
  "  a: {from_um: 8, to_um: 9, bins: 4}\n"                                                         \
  "  b: {from_um: 10, to_um: 11.5, bins: 4}\n"                                                     \
  "  c: {from_um: 12, to_um: 14, bins: 4}\n"

/* 2 m^2 of white paint seen at 0.8 of its face, without what it reflects of the Earth. */
static const char plate[] =
    "schema: 1\n"
    "name: plate\n"
    "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:00:20Z, step_s: 10}\n"
    "orbit: {fixed: {position_gcrs_km: [7000, 0, 0]}}\n"
    "attitude: [{fixed: {q_gcrs: [1, 0, 0, 0]}}]\n"
    "observer: {direction: {unit_gcrs: [0, 0.6, 0.8], range_km: 1000}}\n"
    "parts:\n"
    "  - {name: plate, plate: {size_m: [2, 1]}, front: grey_white, back: grey_white, lumped: "
    "true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 1e9}}\n"
    "thermal: {start: isothermal, start_temperature_K: 253.7, orbits_before: 0}\n"
    "effects: [{effect: reflected_earth_ir, off: true}, {effect: earthshine, off: true}]\n" THERMAL;
#define EMITTANCE 0.88
/* Another one beside it. */
#define SECOND                                                                                     \
  "parts.+={name: other, plate: {size_m: [2, 1]}, pose: {position_m: [0, 5, 0]}, front: "          \
  "grey_white, back: grey_white, lumped: true, shell: {areal_heat_capacity_J_m2_K: 1e9}}"

/* The pass of model_test.h, from the umbra into sunlight, in other bands. */
static struct um_model *pass_in(const char *bands, const struct um_model_options *options)
{
  char text[4096];
  const char *at = strstr(scenario_text, "bands:\n");
  snprintf(text, sizeof text, "%.*s%s", (int)(at - scenario_text), scenario_text, bands);
  put(SCENARIO, text);
  return model_of(options);
}

/* The Sun adds little to these bands. */
static void test_grey_plate(void **state)
{
  (void)state;
  put(SCENARIO, plate);
  struct um_model *model = model_of(NULL);
  put("m.csv", HEAD "2020-03-20T12:00:10Z,characteristic_temperature,thermal,250,1\n"
                    "2020-03-20T12:00:10Z,infrared_cross_section,thermal,1,0.1\n");
  struct pair p = pair_of(model, "m.csv", 0.0);
  print_message("%.6f K, %.8f m2\n", p.comparison->model[0], p.comparison->model[1]);
  assert_close(p.comparison->model[0], 253.7, 1e-3);
  assert_close(p.comparison->model[1] / (EMITTANCE * 2.0 * 0.8), 1.0, 2e-5);
  assert_close(p.comparison->residual[0].measured - p.comparison->residual[0].model, 250.0 - 253.7,
               1e-3);
  assert_string_equal(um_compare_residual_unit(UM_QUANTITY_INFRARED_CROSS_SECTION), "m^2");
  pair_end(&p);
  um_model_destroy(context, &model);
}

/* Two such plates, the light of one of them made 60 K warmer, in five bands known to 0.2 %: two
 * grey bodies explain more than one, and are these, drawn by the weak prior on equal shares by a
 * fraction of what 0.2 % leaves open; at 5 % one is as good. */
static void test_two_plates(void **state)
{
  (void)state;
  static const char two[] =
      "bands:\n"
      "  a: {from_um: 4, to_um: 5, bins: 4}\n"
      "  b: {from_um: 8, to_um: 9, bins: 4}\n"
      "  c: {from_um: 10, to_um: 11.5, bins: 4}\n"
      "  d: {from_um: 12, to_um: 14, bins: 4}\n"
      "  e: {from_um: 17, to_um: 24, bins: 4}\n"
      "measurements: {noise: [{quantity: radiant_intensity, relative: %g}]}\n";
  const double error[] = {0.002, 0.05};
  for (int i = 0; i < 2; i++) {
    char text[4096], bands[1024], *at;
    snprintf(text, sizeof text, "%s", plate);
    at = strstr(text, "bands:\n");
    snprintf(bands, sizeof bands, two, error[i]);
    snprintf(at, sizeof text - (size_t)(at - text), "%s", bands);
    put(SCENARIO, text);
    struct world w = {.model = model_of(&(struct um_model_options){
                          .overrides = (const char *const[]){SECOND}, .noverride = 1})};
    struct um_model_thermal_solution *heat;
    assert_ok(um_model_precompute(context, w.model, &w.tables));
    assert_ok(um_model_thermal_solution_create(context, w.model, w.tables, NULL, 1.0, &heat));
    const struct um_geometry_mesh *mesh = um_geometry_mesh(w.model->geometry);
    double *warmer;
    assert_ok(um_core_allocate(context, mesh->nsurface, sizeof *warmer, &warmer));
    for (size_t s = 0; s < mesh->nsurface; s++) warmer[s] = mesh->surface[s].part == 1 ? 60.0 : 0.0;
    assert_ok(um_model_run_warmer(context, w.model, w.tables, heat, warmer, &w.result));
    const struct um_model_grey_body *g = &w.result->grey_body[0];
    const struct um_instrument_grey_body *b = &g->two;
    bool prefers = um_instrument_grey_body_prefers_two(&g->one, b);
    print_message(
        "%g %%: one %.1f K, chi2 %.3g; two %.2f +- %.2f and %.2f +- %.2f K, %.3f and %.3f "
        "m2%s\n",
        100.0 * error[i], g->one.temperature[0], g->one.chi2, b->temperature[0],
        b->temperature_sigma[0], b->temperature[1], b->temperature_sigma[1], b->area[0], b->area[1],
        prefers ? ", preferred" : "");
    assert_int_equal(prefers, i == 0);
    if (i == 0) {
      assert_close(b->temperature[0], 253.7, b->temperature_sigma[0]);
      assert_close(b->temperature[1], 313.7, b->temperature_sigma[1]);
      assert_close(b->area[0] / (EMITTANCE * 1.6), 1.0, 0.1);
      assert_close(b->area[1] / (EMITTANCE * 1.6), 1.0, 0.1);
    }
    um_core_free(context, warmer);
    um_model_thermal_solution_destroy(context, &heat);
    world_end(&w);
  }
}

/* Light without noise, retrieved with errors of 1 % of each band, is what the run concludes with
 * that weight; in shadow and in sunlight. The scatter of the bands by the run's own error is far
 * smaller than 1 %, so that the weights agree. What the Earth sends and bare metal reflects is left
 * out, and so is light between surfaces, whose error is not small. */
static void test_pass(void **state)
{
  (void)state;
  const char *off[] = {"reflected_earth_ir", "earthshine", "inter_reflection"};
  struct um_model_options heat_alone = {.without = off, .nwithout = 3};
  struct um_model *model = pass_in(THERMAL, &heat_alone);
  struct world w = {.model = model};
  struct um_compare_measurements *m;
  struct um_compare_retrieved *found;
  double lowest[2] = {INFINITY, INFINITY}, highest[2] = {0.0, 0.0};
  assert_ok(um_model_precompute(context, w.model, &w.tables));
  assert_ok(um_model_run(context, w.model, w.tables, &w.result));
  struct um_compare_synth o = {.relative = 1e-9, .seed = 1};
  assert_ok(um_compare_synth_create(context, model, w.tables, w.result, &o, "m.csv", &m));
  for (size_t i = 0; i < m->count; i++) m->row[i].sigma = 0.01 * m->row[i].value;
  assert_ok(um_compare_retrieve(context, model, m, &found));
  assert_int_equal(found->count, w.tables->nobs);
  for (size_t k = 0; k < found->count; k++) {
    const struct um_model_grey_body *g = &w.result->grey_body[k];
    const struct um_instrument_grey_body *one = &found->row[k].one;
    int lit = w.tables->sunlit[k] > 0.5;
    assert_int_equal(g->one.n, 1);
    assert_int_equal(g->two.n, 0);
    assert_close(one->temperature[0], g->one.temperature[0], 0.02);
    assert_close(one->area[0] / g->one.area[0], 1.0, 1e-3);
    assert_true(g->temperature_error >= 0.0 && g->area_error >= 0.0);
    lowest[lit] = fmin(lowest[lit], g->one.temperature[0]);
    highest[lit] = fmax(highest[lit], g->one.temperature[0]);
    /* what is emitted alone: between the coldest and the warmest surface there is; in sunlight bare
     * metal reflects as much as it emits */
    if (w.tables->sunlit[k] > 0.0) continue;
    double low = INFINITY, high = 0.0;
    for (size_t s = 0; s < w.result->nsurface; s++) {
      low = fmin(low, w.result->surface_temperature[k * w.result->nsurface + s]);
      high = fmax(high, w.result->surface_temperature[k * w.result->nsurface + s]);
    }
    assert_true(g->one.temperature[0] > low && g->one.temperature[0] < high);
  }
  print_message("umbra %.1f to %.1f K, sunlight %.1f to %.1f K\n", lowest[0], highest[0], lowest[1],
                highest[1]);
  assert_true(lowest[0] < lowest[1] && highest[0] < highest[1]);
  um_compare_retrieved_destroy(context, &found);
  um_compare_measurements_destroy(context, &m);
  world_end(&w);
}

/* Weights are the errors that the scenario states of the bands: of a body of two temperatures a
 * band that is known badly says little, and the temperature is that of the others. */
static void test_stated_error(void **state)
{
  (void)state;
  static const char other[] = "bands:\n"
                              "  a: {from_um: 4, to_um: 5, bins: 4}\n"
                              "  b: {from_um: 10, to_um: 11.5, bins: 4}\n"
                              "  c: {from_um: 12, to_um: 14, bins: 4}\n";
  static const char *const stated[] = {
      "", "measurements: {noise: [{quantity: radiant_intensity, of: a, relative: 10}]}\n",
      ("measurements: {noise: [{quantity: band_irradiance, relative: 0.01}, "
       "{quantity: band_irradiance, of: a, floor: 1e3}]}\n")};
  double value[3], two_bands;
  for (int i = 0; i < 3; i++) {
    char bands[1024];
    snprintf(bands, sizeof bands, "%s%s", other, stated[i]);
    struct world w = {.model = pass_in(bands, NULL)};
    assert_ok(um_model_precompute(context, w.model, &w.tables));
    assert_ok(um_model_run(context, w.model, w.tables, &w.result));
    size_t k = w.result->nobs - 1;
    value[i] = w.result->grey_body[k].one.temperature[0];
    /* ratio of b and c alone, by bisection */
    double low = 100.0, high = 500.0, *l = &w.result->measured_intensity[k * 3];
    while (high - low > 1e-6) {
      double t = 0.5 * (low + high);
      double ratio = um_core_planck_band(10e-6, 11.5e-6, t) / um_core_planck_band(12e-6, 14e-6, t);
      if (ratio < l[1] / l[2])
        low = t;
      else
        high = t;
    }
    two_bands = low;
    world_end(&w);
  }
  print_message("all alike %.2f K, without a %.2f and %.2f K, from b and c %.2f K\n", value[0],
                value[1], value[2], two_bands);
  assert_true(fabs(value[0] - two_bands) > 1.0);
  assert_close(value[1], two_bands, 0.05);
  assert_close(value[2], two_bands, 0.05);
}

/* chi-square of either quantity over 20 seeds: n rows each, within 4 sigma. Then the satellite has
 * lost the Earth's heat: the temperature shows it. */
static void test_compared(void **state)
{
  (void)state;
  struct um_model *model = pass_in(THERMAL, NULL);
  struct world w = {.model = model};
  struct um_compare_measurements *m;
  double chi2[2] = {0.0, 0.0}, dof[2] = {0.0, 0.0};
  assert_ok(um_model_precompute(context, model, &w.tables));
  assert_ok(um_model_run(context, model, w.tables, &w.result));
  for (uint64_t seed = 1; seed <= 20; seed++) {
    struct um_compare_synth o = {.relative = 0.01, .floor = 1e-3, .grey_body = true, .seed = seed};
    assert_ok(um_compare_synth_create(context, model, w.tables, w.result, &o, "m.csv", &m));
    if (seed == 1) assert_ok(um_compare_measurements_write(context, m, "m.csv"));
    for (size_t i = 0; i < m->count; i++) {
      enum um_compare_quantity q = m->channel[m->row[i].channel].quantity;
      if (!um_compare_is_grey_body(q)) continue;
      size_t k = i / m->nchannel;
      const struct um_instrument_grey_body *one = &w.result->grey_body[k].one;
      int area = q == UM_QUANTITY_INFRARED_CROSS_SECTION;
      double z = (m->row[i].value - (area ? one->area[0] : one->temperature[0])) / m->row[i].sigma;
      assert_string_equal(m->channel[m->row[i].channel].of, "thermal");
      chi2[area] += z * z;
      dof[area] += 1.0;
    }
    um_compare_measurements_destroy(context, &m);
  }
  for (int i = 0; i < 2; i++) {
    print_message("chi2 %.1f of %.0f\n", chi2[i], dof[i]);
    assert_true(fabs(chi2[i] - dof[i]) <= 4.0 * sqrt(2.0 * dof[i]));
  }
  struct pair p = pair_of(model, "m.csv", 0.0);
  for (size_t c = 0; c < p.comparison->nchannel; c++) {
    const struct um_compare_metrics *all = &p.comparison->channel[c].all;
    assert_true(fabs(all->chi2 - all->dof) <= 4.0 * sqrt(2.0 * all->dof));
  }
  pair_end(&p);
  world_end(&w);
  const char *off = "earth_ir";
  struct um_model_options without = {.without = &off, .nwithout = 1};
  model = model_of(&without);
  p = pair_of(model, "m.csv", 0.0);
  for (size_t c = 0; c < p.comparison->nchannel; c++) {
    const struct um_compare_metrics *all = &p.comparison->channel[c].all;
    if (p.measurements->channel[c].quantity != UM_QUANTITY_CHARACTERISTIC_TEMPERATURE) continue;
    print_message("without the Earth's heat: bias %.2f K, chi2 %.0f of %.0f\n", all->bias,
                  all->chi2, all->dof);
    assert_true(all->bias > 1.0 && all->chi2 > 3.0 * all->dof);
  }
  pair_end(&p);
  um_model_destroy(context, &model);
}

/* A floor of irradiance is one of intensity by the square of the range. */
static void test_floor(void **state)
{
  (void)state;
  static const char bands[] = "bands:\n"
                              "  a: {from_um: 4, to_um: 5, bins: 4}\n"
                              "  b: {from_um: 10, to_um: 11.5, bins: 4}\n"
                              "  c: {from_um: 12, to_um: 14, bins: 4}\n"
                              "measurements: {noise: [{quantity: %s, floor: %.17g}]}\n";
  double value[2], range = 1.0;
  for (int i = 0; i < 2; i++) {
    char text[1024];
    snprintf(text, sizeof text, bands, i == 0 ? "radiant_intensity" : "band_irradiance",
             0.5 / (range * range));
    struct world w = {.model = pass_in(text, NULL)};
    assert_ok(um_model_precompute(context, w.model, &w.tables));
    assert_ok(um_model_run(context, w.model, w.tables, &w.result));
    size_t k = w.result->nobs - 1;
    value[i] = w.result->grey_body[k].one.temperature[0];
    range = w.tables->sample[k * w.tables->nsub].range;
    world_end(&w);
  }
  print_message("%.6f and %.6f K\n", value[0], value[1]);
  assert_close(value[0], value[1], 1e-6);
  assert_true(fabs(value[0] - 257.50) > 1.0); /* that of equal shares, above */
}

/* What stands in which column. */
static void test_columns(void **state)
{
  (void)state;
  struct um_model_grey_body g = {
      .one = {.n = 1, .temperature = {1.0}, .area = {3.0}, .chi2 = 5.0, .bic = 1.0},
      .two = {.n = 2, .temperature = {6.0, 8.0}, .area = {7.0, 9.0}, .bic = 0.5},
      .temperature_error = 2.0,
      .area_error = 4.0};
  double value[UM_LIGHTCURVE_GREY];
  um_output_grey_values(&g, value);
  for (int i = 0; i < UM_LIGHTCURVE_GREY; i++) assert_true(value[i] == i + 1.0);
  g.two.bic = 1.5; /* one is as good */
  um_output_grey_values(&g, value);
  for (int i = 0; i < UM_LIGHTCURVE_GREY; i++)
    assert_true(i < UM_LIGHTCURVE_GREY_ONE ? value[i] == i + 1.0 : value[i] != value[i]);
}

static void refused_rows(struct um_model *model, const char *rows, const char *message)
{
  struct um_compare_measurements *m;
  struct um_compare_plan *plan;
  put("m.csv", rows);
  enum um_status status = um_compare_measurements_read(context, "m.csv", &m);
  if (status == UM_OK) {
    status = um_compare_plan_create(context, model, m, &plan);
    um_compare_measurements_destroy(context, &m);
  }
  assert_int_equal(status, UM_ERR_INPUT);
  assert_string_equal(um_core_message(context), message);
  um_core_message_clear(context);
}

static void test_refused(void **state)
{
  (void)state;
  struct um_model *model = pass_in(THERMAL, NULL);
  refused_rows(model, HEAD DAY "12:00Z,characteristic_temperature,b,280,1\n",
               "m.csv:2: column 'of': 'b'; accepted: thermal, all bands of 3 to 40 um together");
  refused_rows(model, HEAD DAY "12:00Z,characteristic_temperature,thermal,-3,1\n",
               "m.csv:2: column 'value': characteristic_temperature -3 K; accepted: above 0");
  um_model_destroy(context, &model);
  put(SCENARIO, scenario_text);
  model = model_of(NULL);
  refused_rows(model, HEAD DAY "12:00Z,infrared_cross_section,thermal,3,1\n",
               "m.csv:2: column 'of': infrared_cross_section wants light in three bands of 3 to 40 "
               "um, the scenario has 1; accepted: a scenario with three or more");
  struct um_compare_synth o = {.relative = 0.01, .grey_body = true};
  assert_refused(um_compare_synth_check(context, model, &o), UM_ERR_INPUT,
                 "scenario.yaml: --grey-body wants an observer and light in three bands of 3 to 40 "
                 "um or more, the scenario has 1 such bands");
  um_core_message_clear(context);
  um_model_destroy(context, &model);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_grey_plate, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_two_plates, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_pass, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_stated_error, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_compared, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_floor, model_set_up, model_tear_down),
      cmocka_unit_test(test_columns),
      cmocka_unit_test_setup_teardown(test_refused, model_set_up, model_tear_down),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
