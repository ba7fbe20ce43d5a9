/* Temperatures of a scenario by forward sensitivities against central differences of runs of their
 * own, over effects that act on every kind of number of the heat network and of its loads: the
 * small satellite of hidden-effect in its pass into the shadow, from the periodic state.
 *
 * Asked: 1e-3 of the largest answer. Differences: periodic states to 1e-5 K, runs with tolerances
 * of 1e-9 and 1e-7 K, both sides moved by a hundredth of a prior width or so: 1e-4 of curvature,
 * and what 1e-5 K of a periodic state are over the width, added. */
#include <math.h>
#include <string.h>

#include "effects/effects.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/products/light_sensitivity.h"
#include "model/run/run_light.h"
#include "model/run/thermal_solution_group.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/whole.h"
#include "tests/support/with_context.h"

#define SCENARIO UMBRA_SOURCE_DIR "/scenarios/hidden-effect/dusk"
#define ASKED    1e-3
#define MATRIX_FACTOR                                                                              \
  0.1                 /* on the scenario's tolerances, as a matrix of derivatives has it [1]       \
                       */
#define PERIODIC 1e-5 /* [K] */

struct moved {
  const char *effect, *target;
  size_t parameter;
  double at, width; /* moved to at + width and at - width; sensitivities by `small` of it */
  double small;     /* 1 where loads move, which are kept to 24 bits */
};
static const struct moved moves[] = {
    {"emittance", "white", 0, NAN, 0.01, 1e-3},
    {"solar_absorptance", "mli", 0, NAN, 0.01, 1e-3},
    {"internal_power", "bus", 0, NAN, 1.0, 1e-3},
    {"contact_conductance", "array", 0, NAN, 0.02, 1e-3},
    {"mli_emittance", "bus", 0, NAN, 0.01, 1e-3},
    {"heat_capacity", "array", 0, NAN, 0.01, 1e-3},
    {"interior_capacity", "bus", 0, NAN, 30.0, 1e-3},
    {"panel_extraction", "array", 0, 0.1, 0.01, 1e-3},
    {"earth_ir_level", NULL, 0, NAN, 0.02, 1.0},
    {"solar_irradiance", NULL, 0, NAN, 0.01, 1.0},
};
enum { MOVES = sizeof moves / sizeof moves[0] };
/* What mirrors reflect moves with what they absorb. */
static const struct moved mirror_moves[] = {
    {"emittance", "fep_silver", 0, NAN, 0.01, 1e-3},
    {"solar_absorptance", "fep_silver", 0, NAN, 0.01, 1e-3},
    {"solar_absorptance", "cfrp", 0, NAN, 0.01, 1e-3},
    {"solar_irradiance", NULL, 0, NAN, 0.01, 1.0},
    {"specific_heat_law", "array", 0, NAN, 1e-3, 1e-3},
};

struct world {
  struct um_model *model;
  struct um_model_tables *tables;
  bool borrowed; /* of the base: loads that do not move */
};

static double value_of(const struct moved *m, const struct um_effect *effect)
{
  return isnan(m->at) ? effect->parameters[m->parameter].null_value : m->at;
}

/* The model with a parameter moved by `by` from where it stands. */
static struct world variant(const struct world *base, const struct moved *m, double by)
{
  struct world w = {0};
  struct um_model_addition a = {.effect = um_effects_find(m->effect), .target = m->target};
  assert_non_null(a.effect);
  for (size_t p = 0; p < a.effect->nparameter; p++) a.value[p] = a.effect->parameters[p].null_value;
  a.value[m->parameter] = value_of(m, a.effect) + by;
  const struct um_model_changes changes = {.addition = &a, .naddition = 1};
  assert_int_equal(um_model_variant_create(context, base->model, &changes, &w.model), UM_OK);
  w.borrowed = (um_effects_reach(a.effect) & (UM_REACH_GEOMETRY | UM_REACH_LIGHT)) == 0;
  w.tables = base->tables;
  if (!w.borrowed) assert_int_equal(um_model_precompute(context, w.model, &w.tables), UM_OK);
  return w;
}

/* The scenario with the options, and its heat with this factor on its tolerances. */
static struct um_model_thermal_solution *world_solved(const struct um_model_options *options,
                                                      double factor, struct world *out)
{
  struct um_model_thermal_solution *heat;
  assert_int_equal(um_model_create(context, SCENARIO, options, &out->model), UM_OK);
  assert_int_equal(um_model_precompute(context, out->model, &out->tables), UM_OK);
  assert_int_equal(
      um_model_thermal_solution_create(context, out->model, out->tables, NULL, factor, &heat),
      UM_OK);
  return heat;
}

static void world_release(struct world *w)
{
  if (!w->borrowed) um_model_tables_destroy(context, &w->tables);
  um_model_destroy(context, &w->model);
}

/* Temperatures of all nodes at the times of `like`, from the periodic state, which is looked for
 * from `guess`. */
static struct um_thermal_history *
solved(const struct world *w, const struct um_model_thermal_solution *like, const double *guess)
{
  struct um_model_solver_options solver;
  struct um_thermal_history *h;
  struct um_thermal_network *network = w->model->body->network;
  size_t n = um_thermal_network_nodes(network);
  double start[512], drift;
  assert_true(n <= 512);
  assert_int_equal(um_model_solver_options_make(context, w->model, w->tables, NULL, &solver),
                   UM_OK);
  solver.options.relative_tolerance = 1e-9;
  solver.options.absolute_tolerance = 1e-7;
  assert_int_equal(um_thermal_solve_periodic(context, network, w->tables->loads, &solver.options,
                                             guess, w->tables->t_start, w->tables->period, PERIODIC,
                                             start, &drift),
                   UM_OK);
  assert_int_equal(um_thermal_solve(context, network, w->tables->loads, &solver.options, start,
                                    w->tables->t_start, like->run.history->t,
                                    like->run.history->ntime, &h),
                   UM_OK);
  um_model_solver_options_clear(context, &solver);
  return h;
}

/* Temperatures of the two sides against what the sensitivity says of the step. */
static void compare(const struct world *scenario, const struct moved *m,
                    const struct um_model_thermal_solution *heat,
                    const struct um_model_thermal_solution *moved)
{
  struct um_thermal_history *h[2];
  double largest = 0.0, worst = 0.0, guess[512];
  assert_true(heat->run.history->nnode <= 512);
  for (int side = 0; side < 2; side++) {
    struct world w = variant(scenario, m, side == 0 ? m->width : -m->width);
    const double *t = heat->run.history->temperature, *to = moved->run.history->temperature;
    for (size_t i = 0; i < heat->run.history->nnode; i++)
      guess[i] = side == 0 ? to[i] : 2.0 * t[i] - to[i]; /* an orbit after the start, or there */
    h[side] = solved(&w, heat, guess);
    world_release(&w);
  }
  for (size_t i = 0; i < h[0]->ntime * h[0]->nnode; i++) {
    double central = 0.5 * (h[0]->temperature[i] - h[1]->temperature[i]);
    double own = moved->run.history->temperature[i] - heat->run.history->temperature[i];
    largest = fmax(largest, fabs(central));
    worst = fmax(worst, fabs(own - central));
  }
  print_message("%-20s at most %9.4f K a step, off by %.1e of it\n", m->effect, largest,
                worst / largest);
  assert_true(largest > 0.01);
  if (!(worst <= ASKED * largest + PERIODIC))
    fail_msg("%s: off by %g K of %g K", m->effect, worst, largest);
  for (int side = 0; side < 2; side++) um_thermal_history_destroy(context, &h[side]);
}

/* All moves in one run; a part of the sweep compares every second one. */
static void differences(const struct um_model_options *options, const struct moved *moves_of,
                        size_t nmove)
{
  struct world base = {0}, small[MOVES];
  struct um_model_thermal_move move[MOVES];
  struct um_model_thermal_solution *heat, *moved;
  struct um_model_thermal_sensitivity *s;
  bool applicable;
  assert_true(nmove <= MOVES);
  heat = world_solved(options, MATRIX_FACTOR, &base);
  for (size_t k = 0; k < nmove; k++) {
    double step = moves_of[k].small * moves_of[k].width;
    small[k] = variant(&base, &moves_of[k], step);
    move[k] = (struct um_model_thermal_move){
        .model = small[k].model, .tables = small[k].tables, .step = step};
    assert_int_equal(um_model_thermal_sensitivity_is_applicable(context, heat, small[k].model,
                                                                small[k].tables, &applicable),
                     UM_OK);
    if (!applicable) fail_msg("%s is not applicable", moves_of[k].effect);
  }
  assert_int_equal(um_model_thermal_sensitivity_create(context, heat, move, nmove, 0.0, &s), UM_OK);
  for (size_t k = 0; k < nmove; k++) {
    assert_int_equal(um_model_thermal_solution_move(context, heat, s, k, moves_of[k].width,
                                                    small[k].model, small[k].tables, &moved),
                     UM_OK);
    if (um_test_whole() || k % 2 == 0) compare(&base, &moves_of[k], heat, moved);
    um_model_thermal_solution_destroy(context, &moved);
    world_release(&small[k]);
  }
  um_model_thermal_sensitivity_destroy(context, &s);
  um_model_thermal_solution_destroy(context, &heat);
  world_release(&base);
}

static void test_differences(void **state)
{
  (void)state;
  static const char *const overrides[] = {"time.step_s=60", "time.exposure_s=0",
                                          "parts.bus.interior.capacity_J_K=3000"};
  static const char *const with[] = {"panel_extraction:array,efficiency=0.1"};
  const struct um_model_options options = {
      .overrides = overrides, .noverride = 3, .with = with, .nwith = 1};
  differences(&options, moves, MOVES);
}

/* The same where surfaces mirror heat and sunlight to each other. */
static void test_mirrors(void **state)
{
  (void)state;
  static const char *const overrides[] = {"time.step_s=60",
                                          "time.exposure_s=0",
                                          "parts.bus.interior.capacity_J_K=3000",
                                          "parts.bus.outside=fep_silver",
                                          "parts.array.pose.position_m=[0, 1.4, 0]",
                                          "effects.+={effect: emittance_temperature, off: true}"};
  const struct um_model_options options = {.overrides = overrides, .noverride = 6};
  differences(&options, mirror_moves, sizeof mirror_moves / sizeof mirror_moves[0]);
}

/* A bin's light of all mechanisms at an instant. */
static double light_of(const struct um_optics_lightcurve *light, size_t i)
{
  double sum = 0.0;
  for (size_t m = 0; m < UM_MECHANISM_COUNT; m++)
    sum += light->spectral[i * UM_MECHANISM_COUNT + m];
  return sum;
}

/* Light by temperatures alone, straight and by way of mirrors and walls, against light that is
 * computed at temperatures on both sides. Paths are the same: they do not depend on temperatures.
 */
static void test_light(void **state)
{
  (void)state;
  static const char *const overrides[] = {
      "time.step_s=60", "time.exposure_s=0", "parts.bus.outside=fep_silver",
      "parts.array.pose.position_m=[0, 1.4, 0]", "optics.interreflection_samples=16"};
  const struct um_model_options options = {.overrides = overrides, .noverride = 5};
  const struct moved power = {"internal_power", "bus", 0, NAN, 10.0, 1e-3};
  struct world base = {0};
  struct um_model_thermal_solution *heat, *moved[2];
  struct um_model_thermal_sensitivity *s;
  struct um_model_light_sensitivity *by_heat;
  struct um_optics_lightcurve *light, *side[2], *linear;
  heat = world_solved(&options, 3.0, &base);
  struct world w = variant(&base, &power, 1e-2);
  const struct um_model_thermal_move move = {.model = w.model, .tables = w.tables, .step = 1e-2};
  assert_int_equal(um_model_thermal_sensitivity_create(context, heat, &move, 1, 0.0, &s), UM_OK);
  assert_int_equal(um_model_light_sensitivity_create(context, s, &by_heat), UM_OK);
  assert_int_equal(um_model_run_light(context, base.model, base.tables, heat, &light), UM_OK);
  assert_int_equal(um_model_light_move(context, light, by_heat, 0, 1.0, &linear), UM_OK);
  for (int k = 0; k < 2; k++) {
    assert_int_equal(um_model_thermal_solution_move(context, heat, s, 0,
                                                    k == 0 ? power.width : -power.width, base.model,
                                                    base.tables, &moved[k]),
                     UM_OK);
    assert_int_equal(um_model_run_light(context, base.model, base.tables, moved[k], &side[k]),
                     UM_OK);
  }
  double worst = 0.0, largest = 0.0, by_others = 0.0;
  for (size_t i = 0; i < light->ntime * light->nbin; i++) {
    double central = (light_of(side[0], i) - light_of(side[1], i)) / (2.0 * power.width);
    size_t between = i * UM_MECHANISM_COUNT + UM_MECHANISM_INTERREFLECTED;
    largest = fmax(largest, fabs(central));
    worst = fmax(worst, fabs(light_of(linear, i) - light_of(light, i) - central));
    by_others = fmax(by_others, fabs(side[0]->spectral[between] - side[1]->spectral[between]) /
                                    (2.0 * power.width));
  }
  print_message("light by heat: off by %.1e of the largest; by way of others up to %.2g of it\n",
                worst / largest, by_others / largest);
  assert_true(by_others > 1e-3 * largest);
  assert_true(worst <= 3e-4 * largest);
  for (int k = 0; k < 2; k++) {
    um_optics_lightcurve_destroy(context, &side[k]);
    um_model_thermal_solution_destroy(context, &moved[k]);
  }
  um_optics_lightcurve_destroy(context, &linear);
  um_optics_lightcurve_destroy(context, &light);
  um_model_light_sensitivity_destroy(context, &by_heat);
  um_model_thermal_sensitivity_destroy(context, &s);
  um_model_thermal_solution_destroy(context, &heat);
  world_release(&w);
  world_release(&base);
}

/* A heater that comes, along a base that has it with hardly any power, against a run with 2 W of
 * it: it switches in the pass, once, where the wall that it warms grows cold. */
static void test_heater(void **state)
{
  (void)state;
  static const char *const overrides[] = {"time.step_s=20", "time.exposure_s=0"};
  const struct um_model_options options = {.overrides = overrides, .noverride = 2};
  const double power = 2.0, faint = 1e-9;
  struct um_model_thermal_solution *heat, *moved;
  struct um_model_thermal_sensitivity *s;
  struct um_thermal_history *h[2];
  struct world base = {0}, with[3];
  heat = world_solved(&options, MATRIX_FACTOR, &base);
  const struct um_thermal_history *own = heat->run.history;
  size_t place = um_thermal_body_place_find(base.model->body, "array");
  assert_true(place != (size_t)-1);
  size_t node = base.model->body->place[place].node[0], last = (own->ntime - 1) * own->nnode;
  double warm = own->temperature[node], cold = own->temperature[last + node];
  assert_true(warm > cold + 20.0);
  struct um_model_addition a = {.effect = um_effects_find("heater"), .target = "array"};
  const struct um_model_changes changes = {.addition = &a, .naddition = 1};
  a.value[1] = 0.5 * (warm + cold);
  a.value[2] = 2.0;
  for (int k = 0; k < 3; k++) {
    a.value[0] = k == 0 ? faint : k == 1 ? 1e-3 * power : power;
    with[k] = (struct world){.tables = base.tables, .borrowed = true};
    assert_int_equal(um_model_variant_create(context, base.model, &changes, &with[k].model), UM_OK);
  }
  const struct um_model_thermal_move move = {
      .model = with[1].model, .tables = base.tables, .step = 1e-3 * power, .base = with[0].model};
  assert_int_equal(um_model_thermal_sensitivity_create(context, heat, &move, 1, 0.0, &s), UM_OK);
  assert_int_equal(um_model_thermal_solution_move(context, heat, s, 0, power, with[2].model,
                                                  base.tables, &moved),
                   UM_OK);
  for (int k = 0; k < 2; k++)
    h[k] = solved(k == 0 ? &base : &with[2], heat,
                  k == 0 ? heat->start : moved->run.history->temperature);
  double largest = 0.0, worst = 0.0, begin = 0.0;
  for (size_t i = 0; i < own->ntime * own->nnode; i++) {
    double truth = h[1]->temperature[i] - h[0]->temperature[i];
    largest = fmax(largest, fabs(truth));
    if (i < own->nnode) begin = fmax(begin, fabs(truth));
    worst = fmax(worst, fabs(moved->run.history->temperature[i] - own->temperature[i] - truth));
  }
  print_message("heater: at most %.4f K, %.4f K at the start, off by %.1e of it\n", largest, begin,
                worst / largest);
  assert_true(largest > 2.0 * begin);
  assert_true(worst <= 2e-3 * largest + PERIODIC);
  for (int k = 0; k < 2; k++) um_thermal_history_destroy(context, &h[k]);
  um_model_thermal_solution_destroy(context, &moved);
  um_model_thermal_sensitivity_destroy(context, &s);
  um_model_thermal_solution_destroy(context, &heat);
  for (int k = 0; k < 3; k++) world_release(&with[k]);
  world_release(&base);
}

/* Temperatures again, of walls in many facets, each of which sees others. */
static void test_many_patches(void **state)
{
  (void)state;
  static const char *const overrides[] = {
      "parts.array.lumped=false", "parts.bus.lumped=false", "thermal.facet_size_m=0.4",
      "time.step_s=60",           "time.exposure_s=0",      "parts.bus.interior.capacity_J_K=3000"};
  const struct um_model_options options = {.overrides = overrides, .noverride = 6};
  differences(&options, moves, 1);
}

/* What comes or goes, and edges that move, have no derivative here; a temperature of 0 K none to
 * go on to. */
static void test_refused(void **state)
{
  (void)state;
  static const struct moved others[] = {{"heater", "bus", 0, 5.0, 0.0, 0.0},
                                        {"shadow_radius", NULL, 0, NAN, 1.0, 0.0},
                                        {"time_tag", NULL, 0, 1.0, 0.0, 0.0},
                                        {"stored_heat", "bus", 0, 1.0, 0.0, 0.0}};
  static const char *const overrides[] = {"time.step_s=60", "time.exposure_s=0"};
  const struct um_model_options options = {.overrides = overrides, .noverride = 2};
  struct world base = {0};
  struct um_model_thermal_solution *heat, *moved;
  struct um_model_thermal_sensitivity *s;
  heat = world_solved(&options, 0.6, &base);
  for (size_t k = 0; k < sizeof others / sizeof others[0]; k++) {
    struct world w = variant(&base, &others[k], others[k].width);
    const struct um_model_thermal_move move = {.model = w.model, .tables = w.tables, .step = 1.0};
    bool applicable;
    assert_int_equal(
        um_model_thermal_sensitivity_is_applicable(context, heat, w.model, w.tables, &applicable),
        UM_OK);
    if (applicable) fail_msg("%s is applicable", others[k].effect);
    assert_int_equal(um_model_thermal_sensitivity_create(context, heat, &move, 1, 0.0, &s),
                     UM_ERR_INPUT);
    assert_null(s);
    assert_string_equal(um_core_message(context),
                        "heat sensitivity 0: the model has other nodes, heaters, times or views; "
                        "accepted: the base's, with other values");
    um_core_message_clear(context);
    world_release(&w);
  }
  const struct moved power = {"internal_power", "bus", 0, NAN, 1.0, 1e-3};
  struct world w = variant(&base, &power, 1e-3);
  const struct um_model_thermal_move move = {.model = w.model, .tables = w.tables, .step = 1e-3};
  assert_int_equal(um_model_thermal_sensitivity_create(context, heat, &move, 1, 0.0, &s), UM_OK);
  assert_int_equal(
      um_model_thermal_solution_move(context, heat, s, 0, -1e5, w.model, w.tables, &moved),
      UM_ERR_NUMERIC);
  assert_null(moved);
  assert_non_null(strstr(um_core_message(context), "a parameter moved by -100000 moves a "));
  um_model_thermal_sensitivity_destroy(context, &s);
  um_model_thermal_solution_destroy(context, &heat);
  world_release(&w);
  world_release(&base);
}

/* Within-spin variation is not in the derivative. */
static void test_left_to_runs(void **state)
{
  (void)state;
  static const char *const spin[] = {"attitude.0.spin.period_s=5", "thermal.spin_loads=averaged",
                                     "time.step_s=60", "time.exposure_s=0"};
  const struct um_model_options options = {.overrides = spin, .noverride = 4};
  const struct moved power = {"internal_power", "bus", 0, NAN, 1.0, 1.0};
  struct world base = {0};
  struct um_model_thermal_solution *heat;
  bool applicable;
  heat = world_solved(&options, 3.0, &base);
  assert_non_null(base.tables->spin_variation);
  struct world w = variant(&base, &power, 1.0);
  assert_int_equal(
      um_model_thermal_sensitivity_is_applicable(context, heat, w.model, w.tables, &applicable),
      UM_OK);
  assert_false(applicable);
  um_model_thermal_solution_destroy(context, &heat);
  world_release(&w);
  world_release(&base);
}

/* A stated start with an interior that begins 5 K warmer: so do the moved models, and a watt more
 * inside has changed nothing when the run begins. */
static void test_start_offset(void **state)
{
  (void)state;
  static const char *const set[] = {"time.step_s=60", "time.exposure_s=0",
                                    "thermal.start=isothermal", "thermal.orbits_before=0.05",
                                    "parts.bus.interior.capacity_J_K=3000"};
  static const char *const with[] = {"stored_heat:bus,shift_K=5"};
  const struct um_model_options options = {
      .overrides = set, .noverride = 5, .with = with, .nwith = 1};
  const struct moved power = {"internal_power", "bus", 0, NAN, 1.0, 1e-3};
  struct world base = {0};
  struct um_model_thermal_solution *heat, *moved;
  struct um_model_thermal_sensitivity *s;
  heat = world_solved(&options, MATRIX_FACTOR, &base);
  assert_non_null(base.model->start_offset);
  struct world w = variant(&base, &power, 1e-3);
  const struct um_model_thermal_move move = {.model = w.model, .tables = w.tables, .step = 1e-3};
  assert_int_equal(um_model_thermal_sensitivity_create(context, heat, &move, 1, 0.0, &s), UM_OK);
  assert_int_equal(
      um_model_thermal_solution_move(context, heat, s, 0, 1.0, w.model, w.tables, &moved), UM_OK);
  const struct um_thermal_history *h = heat->run.history;
  double most = 0.0, bound = (h->t[0] - heat->run.from) / 3000.0; /* [K]: a watt into 3 kJ/K */
  for (size_t i = 0; i < h->nnode; i++)
    most = fmax(most, fabs(moved->run.history->temperature[i] - h->temperature[i]));
  print_message("a watt over %.0f s: %.4f K at most\n", h->t[0] - heat->run.from, most);
  assert_true(most <= bound);
  um_model_thermal_solution_destroy(context, &moved);
  um_model_thermal_sensitivity_destroy(context, &s);
  um_model_thermal_solution_destroy(context, &heat);
  world_release(&w);
  world_release(&base);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_differences),  cmocka_unit_test(test_mirrors),
      cmocka_unit_test(test_many_patches), cmocka_unit_test(test_light),
      cmocka_unit_test(test_heater),       cmocka_unit_test(test_refused),
      cmocka_unit_test(test_left_to_runs), cmocka_unit_test(test_start_offset)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
