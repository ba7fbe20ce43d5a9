/* What is computed with geometry tables and heat used again is what a run of its own gives.
 */
#include "evidence/sensitivity/candidates.h"
#include "evidence/sensitivity/forward_impl.h"
#include "evidence/sensitivity/moves_impl.h"
#include "evidence/sensitivity/policy.h"
#include "model/scenario/scenario_read.h"
#include "tests/evidence/sensitivity/forward_test.h"

/* One effect of every kind of hook, away from its null value. */
static const struct {
  const char *effect, *target;
  double value;
} kinds[] = {{"albedo_level", NULL, 1.2},              /* environment, loads */
             {"earthshine_level", NULL, 1.5},          /* environment, behind the geometry tables */
             {"shadow_radius", NULL, 20.0},            /* environment, events */
             {"solar_absorptance", "grey_white", 0.1}, /* material, heat and light */
             {"roughness", "grey_panel", 1.3},         /* material, light alone */
             {"area", "panel", 1.2},                   /* geometry */
             {"internal_power", "bus", 10.0},          /* part */
             {"heat_capacity", "bus", 1.5},            /* group */
             {"contact_conductance", "panel", 3.0},
             {"time_tag", NULL, 2.0},
             {"exposure", NULL, 16.0},
             {"along_track", NULL, 3.0},
             {"spin_period", NULL, 0.02}, /* law */
             {"attitude_offset", NULL, 4.0},
             {"zero_point", "vis", 0.9}, /* observation */
             {"albedo", NULL, 0.0}};     /* a switch that is off */
#define KINDS  (sizeof kinds / sizeof kinds[0])
#define SCALED 0 /* of kinds: its loads are made of the scenario's, off by the last of 24 bits */

static const struct um_model_instants own_window = {.count = 0};
static const char *const without_albedo[] = {"albedo"};

static double largest_difference(const struct um_sensitivity_forward *f, const double *a,
                                 const double *b)
{
  double largest = 0.0;
  for (size_t j = 0; j < f->observations.count; j++)
    largest = fmax(largest, fabs(a[j] - b[j]) / f->observations.sigma[j]);
  return largest;
}

/* As a fresh one: to the bit, or, of scaled loads, to a millionth of sigma. */
static bool as_fresh(const struct um_sensitivity_forward *f, const double *value,
                     const double *expected, bool scaled)
{
  if (scaled) return largest_difference(f, value, expected) < 1e-6;
  return memcmp(value, expected, 48 * sizeof *value) == 0;
}

/* From an isothermal start there is nothing to search for, and reuse must not change a bit; in any
 * order. Every effect changes some observation (else the test would test nothing). */
static void test_same_bits(void **state)
{
  (void)state;
  static const char *const isothermal[] = {"thermal.start=isothermal", "thermal.orbits_before=0.1",
                                           "optics.interreflection_samples=512"};
  const struct um_model_options options = {
      .overrides = isothermal, .noverride = 3, .without = without_albedo, .nwithout = 1};
  put_world("");
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(&options, m);
  assert_int_equal(f->observations.count, 48);
  assert_int_equal(f->paths, f->paths_before); /* few paths are corrected, not the same */
  double base[48], expected[48], value[48], again[48];
  assert_ok(um_sensitivity_forward_evaluate(context, f, NULL, 0, base));
  assert_ok(fresh_values(&options, f, NULL, 0, expected));
  assert_memory_equal(base, expected, sizeof base);
  for (size_t k = 0; k < KINDS; k++) {
    struct um_model_addition a[2] = {addition_of(kinds[k].effect, kinds[k].target, kinds[k].value),
                                     addition_of("emittance", "grey_panel", 0.9)};
    assert_ok(um_sensitivity_forward_evaluate(context, f, a, 1, value));
    assert_ok(fresh_values(&options, f, a, 1, expected));
    if (!as_fresh(f, value, expected, k == SCALED))
      fail_msg("%s: differs by %g sigma", kinds[k].effect, largest_difference(f, value, expected));
    if (memcmp(value, base, sizeof value) == 0) fail_msg("%s: changes nothing", kinds[k].effect);
    if (k % 4 != 0) continue;
    /* with another effect on the same geometry tables, and back */
    assert_ok(um_sensitivity_forward_evaluate(context, f, a, 2, again));
    assert_ok(fresh_values(&options, f, a, 2, expected));
    if (!as_fresh(f, again, expected, k == SCALED)) fail_msg("%s and emittance", kinds[k].effect);
    assert_ok(um_sensitivity_forward_evaluate(context, f, a, 1, again));
    assert_memory_equal(again, value, sizeof value);
  }
  assert_ok(um_sensitivity_forward_evaluate(context, f, NULL, 0, again));
  assert_memory_equal(again, base, sizeof base);
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

/* A periodic state is found again within the tolerance of the search, 0.01 K of every node, from
 * either side: 0.02 K, which is 0.04 sigma of the temperatures (0.5 K) and, as dE/E = 4 to 5 dT/T
 * at 280 K, 0.04 sigma of the LWIR observations (1 %). A factor of 3 on the tolerances adds what
 * they may leave in an orbit, 3 times thermal.accuracy_K at most, to both sides. */
static void test_periodic(void **state)
{
  (void)state;
  static const size_t some[] = {3, 9}; /* of kinds: one that warms, one of other geometry tables */
  const struct um_model_options options = {.without = without_albedo, .nwithout = 1};
  put_world("");
  struct um_compare_measurements *m = measured();
  for (int loose = 0; loose < 2; loose++) {
    struct um_variant_tolerance tolerance = UM_VARIANT_TIGHT;
    struct um_sensitivity_forward *f;
    if (loose) tolerance.factor = 3.0;
    assert_ok(um_sensitivity_forward_create(context, SCENARIO, &options, m, tolerance, &f));
    double expected[48], value[48];
    for (size_t i = 0; i < sizeof some / sizeof some[0]; i++) {
      size_t k = some[i];
      struct um_model_addition a = addition_of(kinds[k].effect, kinds[k].target, kinds[k].value);
      assert_ok(um_sensitivity_forward_evaluate(context, f, &a, 1, value));
      assert_ok(fresh_values(&options, f, &a, 1, expected));
      double d = largest_difference(f, value, expected);
      if (!(d <= (loose ? 0.2 : 0.04))) fail_msg("%s: differs by %g sigma", kinds[k].effect, d);
    }
    um_sensitivity_forward_destroy(context, &f);
  }
  um_compare_measurements_destroy(context, &m);
}

/* A run that is kept says what the evaluation says; of the scenario's own window it has all steps.
 */
static void test_run(void **state)
{
  (void)state;
  put_world("");
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(NULL, m);
  struct um_model_addition a = addition_of("internal_power", "bus", 10.0);
  struct um_sensitivity_forward_run run;
  double value[48], rows[60];
  assert_ok(um_sensitivity_forward_evaluate(context, f, &a, 1, value));
  assert_ok(um_sensitivity_forward_run(context, f, &a, 1, NULL, &run));
  assert_ok(um_compare_predict(context, f->plan, run.variant.tables, run.result, rows));
  for (size_t j = 0; j < f->observations.count; j++)
    if (m->channel[f->observations.channel[j]].quantity == UM_QUANTITY_TEMPERATURE)
      assert_true(rows[f->observations.row[j]] == value[j]);
  um_sensitivity_forward_run_release(context, &run);
  assert_ok(um_sensitivity_forward_run(context, f, &a, 1, &own_window, &run));
  assert_int_equal(run.variant.tables->nobs, 181); /* 12 minutes, every 4 s */
  um_sensitivity_forward_run_release(context, &run);
  um_sensitivity_forward_run_release(context, &run);
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

/* fresh_values with as many paths between surfaces. */
static void fresh(const struct um_model_options *options, const struct um_sensitivity_forward *f,
                  int paths, const struct um_model_addition *addition, size_t n, double *value)
{
  struct um_sensitivity_forward other = *f;
  other.paths = paths;
  assert_ok(fresh_values(options, &other, addition, n, value));
}

static void assert_fresh(const struct um_model_options *options,
                         const struct um_sensitivity_forward *f, int paths,
                         const struct um_model_addition *addition, size_t n, const double *value)
{
  double expected[24];
  fresh(options, f, paths, addition, n, expected);
  assert_memory_equal(value, expected, sizeof expected);
}

/* A run that is kept is made with all paths. */
static void assert_run(struct um_sensitivity_forward *f, const struct um_model_addition *a,
                       const double *value)
{
  struct um_sensitivity_forward_run run;
  double rows[24], own[24];
  assert_ok(um_sensitivity_forward_run(context, f, a, 1, NULL, &run));
  assert_ok(um_compare_predict(context, f->plan, run.variant.tables, run.result, rows));
  um_compare_modelled(f->measurements, f->observations.count, f->observations.row, rows, own);
  assert_memory_equal(own, value, sizeof own);
  um_sensitivity_forward_run_release(context, &run);
}

/* Of the zero point the signature is the light itself, corrected. */
static void assert_signature(struct um_sensitivity_forward *f, const double *light)
{
  static const char *const only[] = {"zero_point:vis"};
  const struct um_sensitivity_candidates_options options = {.only = only, .nonly = 1};
  struct um_sensitivity_candidates *all;
  assert_ok(um_sensitivity_candidates_create(context, f, NULL, 0, &options, &all));
  assert_int_equal(all->count, 1);
  const double *column = all->candidate[0].signature;
  for (size_t j = 0; j < f->observations.count; j++)
    if (f->observations.channel[j] == f->observations.channel[1])
      assert_close(column[j] / light[j], column[1] / light[1], 1e-6 * fabs(column[1] / light[1]));
  um_sensitivity_candidates_destroy(context, &all);
}

/* Between the coldest and the warmest that the model says of a place's temperature [K]. */
static double halfway(const struct um_sensitivity_forward *f, const char *place)
{
  double low = INFINITY, high = 0.0;
  for (size_t j = 0; j < f->observations.count; j++) {
    const struct um_compare_channel *c = &f->measurements->channel[f->observations.channel[j]];
    if (c->quantity != UM_QUANTITY_TEMPERATURE || strcmp(c->of, place) != 0) continue;
    low = fmin(low, f->cache->base[j]);
    high = fmax(high, f->cache->base[j]);
  }
  assert_true(low < high);
  return 0.5 * (low + high);
}

/* Heaters that come are found together, without a run: each as if it came alone, by what a faint
 * one of half a watt does in a run of its own. */
static void test_heaters(void **state)
{
  (void)state;
  static const char *const tight[] = {"thermal.accuracy_K=0.0005"};
  static const char *const place[] = {"panel", "bus.interior"};
  static const char *const seen[] = {"panel.front", "bus.interior"};
  const struct um_model_options options = {.overrides = tight, .noverride = 1};
  struct um_sensitivity_move move[2];
  put_world("");
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(&options, m);
  for (int k = 0; k < 2; k++)
    move[k] = (struct um_sensitivity_move){.effect = um_effects_find("heater"),
                                           .target = place[k],
                                           .at = {0.0, halfway(f, seen[k]), 2.0},
                                           .step = 10.0};
  assert_ok(um_sensitivity_moves_find(context, f, move, 2, 1e-4));
  assert_int_equal(f->cache->moves->count, 2);
  for (int k = 0; k < 2; k++) {
    double value[48], run[48], largest = 0.0, worst = 0.0;
    struct um_model_addition a = addition_of("heater", place[k], 0.5);
    memcpy(a.value + 1, move[k].at + 1, 2 * sizeof *a.value);
    assert_ok(um_sensitivity_forward_evaluate_move(context, f, &move[k], value));
    assert_true(f->cache->moved_heat);
    assert_ok(um_sensitivity_forward_evaluate(context, f, &a, 1, run));
    for (size_t j = 0; j < f->observations.count; j++) {
      if (m->channel[f->observations.channel[j]].quantity != UM_QUANTITY_TEMPERATURE) continue;
      double base = f->cache->base[j], truth = (run[j] - base) / 0.5;
      largest = fmax(largest, fabs(truth));
      worst = fmax(worst, fabs((value[j] - base) / move[k].step - truth));
    }
    print_message("a heater of %s: %.3f K a watt, off by %.2f of it\n", place[k], largest,
                  worst / largest);
    assert_true(largest > 0.01 && worst < 0.05 * largest);
  }
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

/* What shares a run does not depend on the memory that a worker has: steps of a run, and with them
 * bits, hang on who is in it. */
static void test_shared_run(void **state)
{
  (void)state;
  static const char *const level[] = {"albedo_level", "earth_ir_level"};
  struct um_sensitivity_move move[2];
  put_world("");
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(NULL, m);
  for (int k = 0; k < 2; k++)
    move[k] = (struct um_sensitivity_move){
        .effect = um_effects_find(level[k]), .at = {1.0}, .step = 0.05};
  um_variant_evaluator_bound(f->evaluator, 1);
  assert_ok(um_sensitivity_moves_find(context, f, move, 2, 1e-3));
  assert_int_equal(f->heat_sensitivities, 2);
  assert_int_equal(f->heat_batches, 1);
  for (int k = 0; k < 2; k++) { /* and their light finds the geometry of their heat */
    const struct um_model_addition a = {.effect = move[k].effect, .value = {1.0 + 0.05}};
    const struct um_model_changes changes = {.addition = &a, .naddition = 1};
    struct um_variant v;
    assert_ok(um_variant_open(context, f->evaluator, &changes, NULL, &v));
    assert_false(v.fresh_geometry);
    um_variant_close(context, &v);
  }
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

/* Who moves the loads, and how many of those a run has: small ones as many as it likes. */
static void test_loads(void **state)
{
  (void)state;
  const struct um_sensitivity_move level = {
      .effect = um_effects_find("albedo_level"), .at = {1.0}, .step = 0.05};
  const struct um_sensitivity_move power = {
      .effect = um_effects_find("internal_power"), .target = "bus", .step = 1.0};
  bool loads;
  put_world("");
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(NULL, m);
  assert_ok(um_sensitivity_moves_loads(context, f, &level, &loads));
  assert_true(loads);
  assert_ok(um_sensitivity_moves_loads(context, f, &power, &loads));
  assert_false(loads);
  assert_int_equal(um_sensitivity_moves_open(f, 8), 8);
  assert_int_equal(um_sensitivity_moves_open(f, SIZE_MAX),
                   1 + UM_SENSITIVITY_OPEN /
                           (1 + um_model_tables_bytes(f->base.tables, f->base.tables)));
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

/* A change in two parts: held, temperatures are the scenario's; of heat alone, those of the whole.
 */
static void test_parts(void **state)
{
  (void)state;
  static const char *const isothermal[] = {"thermal.start=isothermal", "thermal.orbits_before=0.1"};
  const struct um_model_options options = {.overrides = isothermal, .noverride = 2};
  struct um_model_addition a = addition_of("solar_absorptance", "grey_white", 0.1);
  double base[48], whole[48], held[48], heat[48];
  size_t warmer = 0, brighter = 0;
  bool apart;
  put_world("");
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(&options, m);
  assert_ok(um_sensitivity_forward_evaluate(context, f, NULL, 0, base));
  assert_ok(um_sensitivity_forward_evaluate(context, f, &a, 1, whole));
  assert_ok(
      um_sensitivity_forward_evaluate_part(context, f, &a, UM_SENSITIVITY_HELD, &apart, held));
  assert_true(apart);
  assert_ok(
      um_sensitivity_forward_evaluate_part(context, f, &a, UM_SENSITIVITY_HEAT, &apart, heat));
  assert_true(apart);
  for (size_t j = 0; j < 48; j++) {
    const struct um_compare_channel *c = &m->channel[f->observations.channel[j]];
    if (c->quantity == UM_QUANTITY_TEMPERATURE) {
      assert_true(held[j] == base[j]);
      assert_true(heat[j] == whole[j]);
      warmer += whole[j] > base[j]; /* where it is grey_white */
    } else if (strcmp(c->of, "vis") == 0) {
      assert_true(heat[j] == base[j]); /* nothing glows in it */
    } else {
      assert_true(heat[j] >= base[j] * (1.0 - 1e-5)); /* where it is not seen, noise of heat */
      brighter += heat[j] > base[j];
    }
  }
  assert_true(warmer > 0 && brighter > 0);
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

/* Light by few paths is that of a scenario with as many, and goes again. */
static void test_few_paths(void **state)
{
  (void)state;
  static const char *const set[] = {"thermal.start=isothermal", "thermal.orbits_before=0.1",
                                    "optics.interreflection_samples=1"};
  const struct um_model_options options = {.overrides = set, .noverride = 3};
  struct um_model_addition a = addition_of("diffuse_level", "grey_metal", 1.2);
  struct um_model_addition turned = addition_of("attitude_offset", NULL, 0.0);
  double many[24], few[24], value[24], few_moved[24], many_moved[24], corrected[24],
      off[2] = {0.0, 0.0};
  turned.value[2] = 5.0;
  put_world("");
  FILE *file = fopen("m.csv", "w");
  assert_non_null(file);
  fputs(HEAD, file);
  for (int k = 0; k < 12; k++)
    fprintf(file,
            DAY "%02d:%02dZ,band_irradiance,lwir,3e-12,3e-15\n" DAY
                "%02d:%02dZ,magnitude_ab,vis,9,0.001\n",
            9 + k / 2, 30 * (k % 2), 9 + k / 2, 30 * (k % 2));
  assert_int_equal(fclose(file), 0);
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(&options, m);
  assert_int_equal(f->observations.count, 24);
  assert_int_equal(f->paths_before, 1);
  assert_true(f->paths > 1);
  assert_ok(um_sensitivity_forward_evaluate(context, f, NULL, 0, many));
  assert_fresh(&options, f, f->paths, NULL, 0, many);
  fresh(&options, f, 1, NULL, 0, few);
  assert_memory_not_equal(few, many, sizeof few);
  fresh(&options, f, 1, &a, 1, few_moved);
  fresh(&options, f, f->paths, &a, 1, many_moved);
  assert_ok(um_sensitivity_forward_evaluate(context, f, &a, 1, value));
  memcpy(corrected, few_moved, sizeof corrected);
  um_sensitivity_forward_correct(few, many, 24, corrected);
  assert_memory_equal(value, corrected, sizeof value);
  for (size_t j = 0; j < 24; j++) {
    off[0] = fmax(off[0], fabs(few_moved[j] / many_moved[j] - 1.0));
    off[1] = fmax(off[1], fabs(value[j] / many_moved[j] - 1.0));
  }
  print_message("off by up to %.1e, corrected %.1e\n", off[0], off[1]);
  assert_true(off[1] < 0.2 * off[0]);
  /* what is promised to be a derivative has all paths, and another geometry in values */
  assert_ok(um_sensitivity_forward_paths(context, f, UM_SENSITIVITY_DERIVATIVES));
  assert_ok(um_sensitivity_forward_evaluate(context, f, &a, 1, value));
  assert_memory_equal(value, many_moved, sizeof value);
  assert_ok(um_sensitivity_forward_paths(context, f, UM_SENSITIVITY_VALUES));
  assert_ok(um_sensitivity_forward_evaluate(context, f, &turned, 1, value));
  assert_fresh(&options, f, f->paths, &turned, 1, value);
  assert_signature(f, many);
  assert_ok(um_sensitivity_forward_evaluate(context, f, &turned, 1, few));
  assert_memory_equal(few, value, sizeof few); /* all of them again */
  struct um_sensitivity_forward_run run;
  assert_ok(um_sensitivity_forward_run(context, f, &a, 1, &own_window, &run));
  assert_int_equal(run.variant.tables->sampling.paths, 1); /* the window wants no more */
  assert_int_equal(run.variant.tables->sampling.samples, f->samples);
  um_sensitivity_forward_run_release(context, &run);
  assert_run(f, &a, many_moved);
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

/* By numbers: a share of what is nearly right, an amount of what is faint, also where few paths
 * find nothing; the scenario itself to the bit. */
static void test_correction(void **state)
{
  (void)state;
  const double few[] = {1.0, 1.0, 0.0, 0.3}, base[] = {1.05, 2.0, 0.5, 0.1};
  const double moved[] = {1.4, 1.4, 0.4, 0.7}, expected[] = {1.47, 2.4, 0.9, 0.5};
  double value[4], same[4];
  memcpy(value, moved, sizeof value);
  memcpy(same, few, sizeof same);
  um_sensitivity_forward_correct(few, base, 4, value);
  um_sensitivity_forward_correct(few, base, 4, same);
  for (size_t j = 0; j < 4; j++) {
    assert_close(value[j], expected[j], 1e-15);
    assert_true(same[j] == base[j]);
  }
}

static void overwrite(const char *name, const char *text)
{
  FILE *file = fopen(name, "w");
  assert_non_null(file);
  fputs(text, file);
  fclose(file);
}

/* What is edited on the disk meanwhile does not reach a variant: neither the scenario nor a file
 * that it names. A use whose target is gone is refused by the effect and by nothing else. */
static void test_edited_meanwhile(void **state)
{
  (void)state;
  overwrite("power.csv", "time_utc,power_W\n2016-01-01T00:00:00Z,40\n2017-01-01T00:00:00Z,40\n");
  put_world("");
  struct um_model_options with_file = {
      .overrides = (const char *const[]){"parts.bus.interior.power_file=power.csv"},
      .noverride = 1};
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(&with_file, m);
  struct um_model_addition a = addition_of("zero_point", "vis", 0.5),
                           b = addition_of("internal_power", "bus", 10.0);
  double before[2][48], after[2][48];
  assert_ok(um_sensitivity_forward_evaluate(context, f, &a, 1, before[0]));
  assert_ok(um_sensitivity_forward_evaluate(context, f, &b, 1, before[1]));
  overwrite(SCENARIO, "this is no scenario\n");
  overwrite("power.csv", "neither is this a table\n");
  assert_ok(um_sensitivity_forward_evaluate(context, f, &a, 1, after[0]));
  assert_ok(um_sensitivity_forward_evaluate(context, f, &b, 1, after[1]));
  assert_memory_equal(after, before, sizeof before);
  um_sensitivity_forward_destroy(context, &f);
  /* nothing is held any more */
  struct um_model *model = NULL;
  assert_int_not_equal(um_model_create(context, SCENARIO, &with_file, &model), UM_OK);
  um_compare_measurements_destroy(context, &m);
  remove("power.csv");
}

/* Observations in linear flux: F = 10^(-0.4 9), sigma = 0.4 ln 10 F 0.02. */
static void test_rows(void **state)
{
  (void)state;
  put_world("effects:\n  - {effect: zero_point, target: vis, factor: 0.8}\n");
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(NULL, m);
  assert_int_equal(f->observations.row[1], 1);
  assert_int_equal(f->observations.row[4], 5); /* the flagged observation is left out */
  assert_true(fabs(f->observations.measured[1] / 2.5118864315095801e-4 - 1.0) < 1e-14);
  assert_true(
      fabs(f->observations.stated_sigma[1] / (0.4 * log(10.0) * 2.5118864315095801e-4 * 0.02) -
           1.0) < 1e-14);
  assert_true(f->observations.measured[0] == 3e-12 && f->observations.stated_sigma[0] == 3e-14 &&
              f->observations.t[0] == m->row[0].t_tai);
  assert_true(f->evaluations == 1 && f->seconds_first > 0.0 && f->seconds == f->seconds_first);
  /* values as the scenario has them; an addition takes the place of its own use */
  double now[UM_EFFECT_PARAMETERS_MAX], base[48], value[48];
  um_sensitivity_forward_null(f, um_effects_find("zero_point"), "vis", now);
  assert_true(now[0] == 0.8);
  um_sensitivity_forward_null(f, um_effects_find("zero_point"), "lwir", now);
  assert_true(now[0] == 1.0);
  struct um_model_addition a = addition_of("zero_point", "vis", 0.4);
  assert_ok(um_sensitivity_forward_evaluate(context, f, NULL, 0, base));
  assert_ok(um_sensitivity_forward_evaluate(context, f, &a, 1, value));
  assert_true(fabs(value[1] / base[1] - 0.5) < 1e-12);
  assert_true(value[0] == base[0]);
  a = addition_of("mli_emittance", "panel", 2.0);
  assert_refused(um_sensitivity_forward_evaluate(context, f, &a, 1, value), UM_ERR_REFUSED,
                 "effect 'mli_emittance': the part 'panel' has no MLI");
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

/* sigma^2 = (relative x model)^2 + floor^2 where an observation has none; the entry of a band goes
 * first. */
static void test_noise(void **state)
{
  (void)state;
  static const char *const rows =
      HEAD DAY "12:00Z,band_irradiance,lwir,3e-12,\n" DAY "12:00Z,band_irradiance,vis,3e-12,\n" DAY
               "12:00Z,temperature,bus.interior,280,\n";
  struct um_sensitivity_forward *f;
  put_world("");
  put("m.csv", rows);
  struct um_compare_measurements *m = measured();
  assert_refused(um_sensitivity_forward_create(context, SCENARIO, NULL, m, UM_VARIANT_TIGHT, &f),
                 UM_ERR_INPUT,
                 "m.csv:2: column 'sigma': empty; accepted: a number above 0, or a scenario with "
                 "measurements.noise for band_irradiance 'lwir'");
  assert_null(f);
  put_world("measurements:\n  noise:\n    - {quantity: band_irradiance, relative: 0.03, floor: "
            "1e-14}\n    - {quantity: band_irradiance, of: vis, relative: 0.05}\n    - {quantity: "
            "temperature, floor: 0.5}\n");
  put("m.csv", rows);
  f = forward_of(NULL, m);
  double value[3];
  assert_ok(um_sensitivity_forward_evaluate(context, f, NULL, 0, value));
  assert_true(fabs(f->observations.stated_sigma[0] / hypot(0.03 * value[0], 1e-14) - 1.0) < 1e-14);
  assert_true(fabs(f->observations.stated_sigma[1] / (0.05 * value[1]) - 1.0) < 1e-14);
  assert_true(f->observations.sigma[2] == 0.5);
  um_sensitivity_forward_destroy(context, &f);
  put_world("measurements:\n  noise:\n    - {quantity: temperature, of: bus.interior}\n");
  put("m.csv", rows);
  assert_refused(um_sensitivity_forward_create(context, SCENARIO, NULL, m, UM_VARIANT_TIGHT, &f),
                 UM_ERR_INPUT,
                 "scenario.yaml:35: measurements.noise.0: noise of temperature 'bus.interior': "
                 "relative 0, floor 0 K; accepted: both 0 or more, not both 0");
  put_world("measurements:\n  noise:\n    - {quantity: temperature, floor: 1}\n    - {quantity: "
            "temperature, floor: 2}\n");
  put("m.csv", rows);
  assert_refused(um_sensitivity_forward_create(context, SCENARIO, NULL, m, UM_VARIANT_TIGHT, &f),
                 UM_ERR_INPUT,
                 "scenario.yaml:36: measurements.noise.1: the same rows are on line 35; accepted: "
                 "each once");
  um_compare_measurements_destroy(context, &m);
}

/* Entries of the schema stand for the quantities in their order. */
static void test_quantities(void **state)
{
  (void)state;
  for (int q = 0; q < UM_QUANTITY_COUNT; q++) {
    char more[160];
    snprintf(more, sizeof more, "measurements:\n  noise:\n    - {quantity: %s, floor: 1}\n",
             um_compare_quantity_name((enum um_compare_quantity)q));
    put_world(more);
    struct um_document *document;
    const struct um_scenario *scenario;
    assert_ok(
        um_model_scenario_read(context, SCENARIO, NULL, NULL, 0, NULL, 0, &document, &scenario));
    const struct um_scenario_noise *noise = scenario->measurements->noise.items;
    assert_int_equal(noise[0].quantity, q);
    um_document_destroy(&document);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_same_bits, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_periodic, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_run, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_heaters, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_shared_run, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_loads, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_parts, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_few_paths, model_set_up, model_tear_down),
      cmocka_unit_test(test_correction),
      cmocka_unit_test_setup_teardown(test_edited_meanwhile, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_rows, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_noise, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_quantities, model_set_up, model_tear_down),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
