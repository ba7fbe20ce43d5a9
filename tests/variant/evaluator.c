/* What an evaluator computes anew, and what it does not: answers are those of models of their own,
 * in any order, whatever is kept. */
#include "variant/evaluator.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "effects/effects.h"
#include "model/build/build.h"
#include "model/run/run.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"
#include "variant/many.h"

#define FILE_NAME "evaluator_scenario.yaml"

static const char *const scenario =
    "schema: 1\n"
    "name: evaluator\n"
    "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:02:00Z, step_s: 60}\n"
    "orbit: {circular: {altitude_km: 600, beta_deg: 20}}\n"
    "attitude: [{lvlh: {}}]\n"
    "observer: {direction: {unit_gcrs: [0.5, 0.7, 0.1], range_km: 1000}}\n"
    "parts:\n"
    "  - {name: box, box: {size_m: [1, 1, 1]}, outside: grey_white, lumped: true,\n"
    "     interior: {capacity_J_K: 1000, power_W: 5, conductance_W_K: 1},\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
    "  - {name: wing, plate: {size_m: [2, 1]}, pose: {position_m: [0, 1.2, 0]}, lumped: true,\n"
    "     front: grey_panel, back: grey_white,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000, through_conductance_W_m2_K: 50}}\n"
    "thermal: {start: periodic, step_s: 120, view_factor_rays: 64}\n"
    "optics: {samples: 4}\n"
    "bands:\n"
    "  vis: {from_um: 0.38, to_um: 0.78, bins: 4}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 4}\n";

#define LOOSE ((struct um_variant_tolerance){6.0, 0.05})
#define TIGHT ((struct um_variant_tolerance){1.0, 0.01})

static struct um_model *model;
static struct um_variant_evaluator *evaluator;

static void need(enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

static int set_up(void **state)
{
  (void)state;
  const struct um_variant_settings settings = {.base = TIGHT};
  FILE *file = fopen(FILE_NAME, "w");
  if (file == NULL) return -1;
  fputs(scenario, file);
  fclose(file);
  need(um_model_create(context, FILE_NAME, NULL, &model));
  need(um_variant_evaluator_create(context, model, &settings, &evaluator));
  return 0;
}

static int tear_down(void **state)
{
  (void)state;
  um_variant_evaluator_destroy(context, &evaluator);
  um_model_destroy(context, &model);
  return remove(FILE_NAME);
}

/* One change: a key, or an effect. */
struct change {
  struct um_document_change key;
  struct um_model_addition addition;
  struct um_model_changes all;
};

static struct um_model_changes key(struct change *c, const char *path, double number)
{
  c->key = (struct um_document_change){.key = path, .number = number};
  return (struct um_model_changes){.key = &c->key, .nkey = 1};
}

static struct um_model_changes effect(struct change *c, const char *name, const char *target,
                                      double value)
{
  c->addition = (struct um_model_addition){
      .effect = um_effects_find(name), .target = target, .value = {value}};
  assert_non_null(c->addition.effect);
  return (struct um_model_changes){.addition = &c->addition, .naddition = 1};
}

#define WARM(...) ((struct um_variant_heat){.start = UM_VARIANT_WARM, .tolerance = __VA_ARGS__})

/* Opens a variant, expects what it computes anew, and gives its LWIR irradiance [3]. */
static void look(const struct um_model_changes *changes, struct um_variant_tolerance tolerance,
                 bool geometry, bool heat, double *irradiance)
{
  const struct um_variant_heat how = WARM(tolerance);
  struct um_variant v;
  struct um_model_result *result;
  need(um_variant_open(context, evaluator, changes, &how, &v));
  assert_int_equal(v.fresh_geometry, geometry);
  assert_int_equal(v.fresh_heat, heat);
  need(um_variant_observe(context, evaluator, &v, &result));
  for (size_t k = 0; k < 3; k++) irradiance[k] = result->irradiance[k * result->nband + 1];
  um_model_result_destroy(context, &result);
  um_variant_close(context, &v);
}

static void only_what_changes_is_computed(void **state)
{
  (void)state;
  struct change c;
  struct um_variant base;
  double nominal[3], other[3], again[3];
  struct um_model_changes changes = {.nkey = 0};
  need(um_variant_base(context, evaluator, &base));
  look(&changes, LOOSE, false, false, nominal);
  changes = effect(&c, "zero_point", "lwir", 0.5);
  look(&changes, LOOSE, false, false, other);
  for (size_t k = 0; k < 3; k++) assert_close(other[k] / nominal[k], 0.5, 1e-12);
  changes = effect(&c, "band_emissivity", "grey_white", 0.9); /* of the light, but not behind it */
  look(&changes, LOOSE, false, false, other);
  assert_true(other[1] < nominal[1]);
  changes = effect(&c, "internal_power", "box", 0.0); /* of temperatures, and moves none */
  look(&changes, LOOSE, false, false, other);
  assert_memory_equal(other, nominal, sizeof other);
  changes = key(&c, "parts.box.interior.power_W", 50.0);
  look(&changes, LOOSE, false, true, other);
  assert_true(other[1] > nominal[1]);
  changes = key(&c, "environment.albedo", 0.31);
  look(&changes, LOOSE, true, true, other);
  look(&changes, LOOSE, false, false, again); /* geometry and heat were kept */
  assert_memory_equal(other, again, sizeof other);
  look(&changes, TIGHT, false, true, again); /* but not for another tolerance */
  changes = effect(&c, "attitude_offset", NULL, 1.0);
  look(&changes, LOOSE, true, true, other);
  look(&changes, LOOSE, false, false, again);
  assert_memory_equal(other, again, sizeof other);
}

/* Cold is a run of its own, to the bit. */
static void cold_is_a_run_of_its_own(void **state)
{
  (void)state;
  const char *const set[] = {"parts.box.interior.power_W=50"};
  const struct um_model_options options = {.overrides = set, .noverride = 1};
  const struct um_variant_heat cold = {.start = UM_VARIANT_COLD};
  struct change c;
  const struct um_model_changes changes = key(&c, "parts.box.interior.power_W", 50.0);
  struct um_model *own = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_result *a = NULL, *b = NULL;
  struct um_variant v;
  need(um_model_create(context, FILE_NAME, &options, &own));
  need(um_model_precompute(context, own, &tables));
  need(um_model_run(context, own, tables, &a));
  need(um_variant_open(context, evaluator, &changes, &cold, &v));
  need(um_variant_observe(context, evaluator, &v, &b));
  assert_memory_equal(a->irradiance, b->irradiance, a->nobs * a->nband * sizeof(double));
  um_variant_close(context, &v);
  um_model_result_destroy(context, &a);
  um_model_result_destroy(context, &b);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &own);
}

/* Where there is room for one, the one that was used last stays; one that is open is not given up.
 */
static void the_bound_holds(void **state)
{
  (void)state;
  const struct um_variant_settings settings = {.base = TIGHT, .bytes = 1};
  static const double albedo[] = {0.31, 0.32, 0.32, 0.31};
  static const bool fresh[] = {true, true, false, true};
  struct change c;
  struct um_variant_evaluator *own;
  struct um_variant v, open;
  need(um_variant_evaluator_create(context, model, &settings, &own));
  for (size_t i = 0; i < 4; i++) {
    const struct um_model_changes changes = key(&c, "environment.albedo", albedo[i]);
    need(um_variant_open(context, own, &changes, NULL, &v));
    assert_int_equal(v.fresh_geometry, fresh[i]);
    um_variant_close(context, &v);
  }
  struct um_model_changes changes = key(&c, "environment.albedo", 0.33);
  assert_int_equal(um_variant_evaluator_open_bytes(own), 0); /* what is kept is not open */
  need(um_variant_open(context, own, &changes, NULL, &open));
  assert_true(um_variant_evaluator_open_bytes(own) > 0);
  changes = key(&c, "environment.albedo", 0.34);
  need(um_variant_open(context, own, &changes, NULL, &v));
  assert_int_equal(open.tables->nobs, 3);
  um_variant_close(context, &v);
  um_variant_close(context, &open);
  assert_int_equal(um_variant_evaluator_open_bytes(own), 0);
  um_variant_evaluator_destroy(context, &own);
}

/* What a geometry shares with the scenario's takes no room of its own. */
static void what_is_shared_is_not_counted(void **state)
{
  (void)state;
  struct change c;
  struct um_variant base, open;
  need(um_variant_base(context, evaluator, &base));
  const struct um_model_changes changes = key(&c, "environment.albedo", 0.31);
  need(um_variant_open(context, evaluator, &changes, NULL, &open));
  size_t all = um_model_tables_bytes(open.tables, NULL),
         own = um_model_tables_bytes(open.tables, base.tables);
  assert_true(open.tables != base.tables && open.tables->body == base.tables->body);
  assert_true(own > 0 && own < all);
  assert_int_equal(um_variant_evaluator_open_bytes(evaluator), own);
  um_variant_close(context, &open);
}

/* Loads of another level are made of the scenario's, not traced. */
static void levels_are_scaled(void **state)
{
  (void)state;
  struct change c;
  const struct um_model_changes changes = effect(&c, "solar_irradiance", NULL, 1.1);
  struct um_variant v[2], base;
  struct um_variant_evaluator *own[2];
  for (int i = 0; i < 2; i++) {
    const struct um_variant_settings settings = {.base = TIGHT, .scaled = i == 1};
    need(um_variant_evaluator_create(context, model, &settings, &own[i]));
    need(um_variant_open(context, own[i], &changes, NULL, &v[i]));
    assert_true(v[i].fresh_geometry);
  }
  need(um_variant_base(context, own[1], &base));
  const struct um_irradiation_loads *traced = v[0].tables->loads, *scaled = v[1].tables->loads;
  const struct um_irradiation_loads *from = base.tables->loads;
  double by = v[1].model->environment.solar_irradiance / base.model->environment.solar_irradiance;
  size_t differ = 0, n = traced->ntime * traced->nsurface;
  assert_close(by, 1.1, 1e-12);
  for (size_t i = 0; i < n; i++) {
    if (scaled->albedo[i] != (float)(by * (double)from->albedo[i])) fail_msg("entry %zu", i);
    assert_close((double)scaled->albedo[i], (double)traced->albedo[i], 1e-4);
    differ += scaled->albedo[i] != traced->albedo[i];
  }
  assert_true(differ > 0 && differ < n); /* in the last bit */
  for (int i = 0; i < 2; i++) um_variant_close(context, &v[i]);
  for (int i = 0; i < 2; i++) um_variant_evaluator_destroy(context, &own[i]);
}

#define NCHANGE 6

struct seen {
  double irradiance[NCHANGE][3];
  bool refused[NCHANGE];
};

static enum um_status take(struct um_context *of, void *user, size_t which,
                           const struct um_variant *variant, const struct um_model_result *result,
                           double *value)
{
  (void)of, (void)user, (void)which, (void)variant;
  for (size_t k = 0; k < 3; k++) value[k] = result->irradiance[k * result->nband + 1];
  return UM_OK;
}

static enum um_status done(struct um_context *of, void *user, size_t which, enum um_status status,
                           const double *value)
{
  struct seen *seen = user;
  seen->refused[which] = status == UM_ERR_REFUSED;
  if (status == UM_OK) memcpy(seen->irradiance[which], value, sizeof seen->irradiance[which]);
  if (status == UM_ERR_REFUSED) um_core_message_clear(of);
  return status == UM_ERR_REFUSED ? UM_OK : status;
}

/* Many at once have the bits of one by one, in any number of processes; one that the model refuses
 * does not touch the others. */
static void many_are_as_one_by_one(void **state)
{
  (void)state;
  struct change c[NCHANGE];
  const struct um_model_changes changes[NCHANGE] = {
      key(&c[0], "parts.box.interior.power_W", 50.0),
      key(&c[1], "environment.albedo", 0.31),
      effect(&c[2], "zero_point", "lwir", 0.5),
      effect(&c[3], "internal_power", "no_such_part", 1.0),
      effect(&c[4], "attitude_offset", NULL, 1.0),
      effect(&c[5], "attitude_offset", NULL, 1.0)};
  const struct um_variant_heat how = WARM(LOOSE);
  struct seen seen[3] = {{.refused = {false}}};
  for (int i = 0; i < 3; i++) {
    struct um_variant_evaluator *own;
    const struct um_variant_settings settings = {.base = TIGHT};
    const struct um_variant_each each = {.n = NCHANGE,
                                         .changes = changes,
                                         .heat = &how,
                                         .nvalue = 3,
                                         .take = take,
                                         .done = done,
                                         .user = &seen[i],
                                         .workers = 1 + i};
    need(um_variant_evaluator_create(context, model, &settings, &own));
    need(um_variant_each(context, own, &each));
    um_variant_evaluator_destroy(context, &own);
  }
  assert_memory_equal(&seen[0], &seen[1], sizeof seen[0]);
  assert_memory_equal(&seen[0], &seen[2], sizeof seen[0]);
  double one[3];
  struct um_variant base;
  need(um_variant_base(context, evaluator, &base));
  look(&changes[0], LOOSE, false, true, one);
  assert_memory_equal(one, seen[2].irradiance[0], sizeof one);
  look(&changes[4], LOOSE, true, true, one);
  assert_memory_equal(one, seen[2].irradiance[4], sizeof one);
  assert_true(seen[0].refused[3] && !seen[0].refused[2]);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(only_what_changes_is_computed, set_up, tear_down),
      cmocka_unit_test_setup_teardown(cold_is_a_run_of_its_own, set_up, tear_down),
      cmocka_unit_test_setup_teardown(the_bound_holds, set_up, tear_down),
      cmocka_unit_test_setup_teardown(what_is_shared_is_not_counted, set_up, tear_down),
      cmocka_unit_test_setup_teardown(levels_are_scaled, set_up, tear_down),
      cmocka_unit_test_setup_teardown(many_are_as_one_by_one, set_up, tear_down)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
