/* A user's own effects as shared objects: the worked example is loaded, acts as its equation says
 * and leaves every bit at its null value; objects that are no effects are refused with a line that
 * says why. OBJECTS is the folder they are built in. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "base/core/file_snapshot.h"
#include "effects/effects.h"
#include "model/build/build.h"
#include "model/build/effect_files.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/effects/case.h"
#include "tests/support/cmocka_all.h"

#define EXAMPLE OBJECTS "/pileup.so"

static struct um_effects_registry *registry_of(const char *path)
{
  struct um_effects_registry *registry = NULL;
  assert_int_equal(um_effects_registry_create(case_context(), &registry), UM_OK);
  if (um_effects_registry_load(case_context(), registry, path) != UM_OK)
    fail_msg("%s", um_core_message(case_context()));
  return registry;
}

static void object_joins_the_registry(void **state)
{
  (void)state;
  char names[4096];
  struct um_effects_registry *registry = registry_of(EXAMPLE);
  size_t n = um_effects_count();
  assert_int_equal(um_effects_registry_count(registry), n + 1);
  assert_ptr_equal(um_effects_registry_at(registry, 0), um_effects_at(0));
  const struct um_effect *e = um_effects_registry_at(registry, n);
  assert_string_equal(e->name, "pileup");
  assert_ptr_equal(um_effects_registry_find(registry, "pileup"), e);
  assert_ptr_equal(um_effects_registry_find(registry, "albedo"), um_effects_find("albedo"));
  assert_null(um_effects_find("pileup"));
  um_effects_registry_names(registry, names, sizeof names);
  assert_non_null(strstr(names, "pileup"));
  /* again: nothing new; another object: its two behind it */
  assert_int_equal(um_effects_registry_load(case_context(), registry, EXAMPLE), UM_OK);
  assert_int_equal(um_effects_registry_count(registry), n + 1);
  assert_int_equal(um_effects_registry_load(case_context(), registry, OBJECTS "/pair.so"), UM_OK);
  assert_int_equal(um_effects_registry_count(registry), n + 3);
  assert_string_equal(um_effects_registry_at(registry, n + 2)->name, "twice_more");
  um_effects_registry_destroy(case_context(), &registry);
  assert_null(registry);
  assert_int_equal(um_effects_registry_count(NULL), n);
}

/* With the key of the scenario in front. */
static void scenario_with(const char *files, char *out, size_t size)
{
  snprintf(out, size, "effect_files: [%s]\n%s", files, case_plate);
}

/* E' = E (1 + q E), one product and one sum: equal to rounding. */
static void example_acts(void **state)
{
  (void)state;
  char scenario[4096], with[64];
  scenario_with(EXAMPLE, scenario, sizeof scenario);
  struct case_run plain = case_with(case_plate, NULL);
  struct case_run loaded = case_with(scenario, NULL);
  struct case_run null = case_with(scenario, "pileup,q_m2_W=0");
  double e = plain.result->irradiance[0], q = -0.03 / e;
  assert_true(e > 0.0);
  snprintf(with, sizeof with, "pileup:vis,q_m2_W=%.17g", q);
  struct case_run bent = case_with(scenario, with);
  assert_true(case_same(&plain, &loaded));
  assert_true(case_same(&plain, &null));
  assert_true(case_same_temperatures(&plain, &bent));
  for (size_t k = 0; k < plain.result->nobs; k++) {
    double vis = plain.result->irradiance[2 * k];
    case_near("vis", bent.result->irradiance[2 * k], vis * (1.0 + q * vis), 1e-15);
    assert_true(bent.result->irradiance[2 * k + 1] == plain.result->irradiance[2 * k + 1]);
    assert_true(bent.result->magnitude_ab[2 * k] > plain.result->magnitude_ab[2 * k]);
  }
  assert_int_equal(um_model_effects_count(bent.model), um_effects_count() + 1);
  assert_non_null(um_model_effects_find(bent.model, "pileup"));
  assert_null(um_model_effects_find(plain.model, "pileup"));
  case_release(&plain);
  case_release(&loaded);
  case_release(&null);
  case_release(&bent);
}

/* Its own message, through um_core_fail of the program. */
static void hook_can_refuse(void **state)
{
  (void)state;
  char scenario[4096];
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  const char *const with[] = {"pileup,q_m2_W=-1e15"};
  const struct um_model_options options = {.with = with, .nwith = 1, .allow_effects = true};
  scenario_with(EXAMPLE, scenario, sizeof scenario);
  case_write("own_refuses.yaml", scenario);
  assert_int_equal(um_model_create(case_context(), "own_refuses.yaml", &options, &model), UM_OK);
  assert_int_equal(um_model_precompute(case_context(), model, &tables), UM_OK);
  assert_int_equal(um_model_run(case_context(), model, tables, &result), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(case_context()), "accepted: above -0.5"));
  um_model_tables_destroy(case_context(), &tables);
  um_model_destroy(case_context(), &model);
  remove("own_refuses.yaml");
  um_core_message_clear(case_context());
}

/* A scenario alone loads nothing, whoever asks: neither without options nor with another file
 * named.
 */
static void scenario_alone_loads_nothing(void **state)
{
  (void)state;
  char scenario[4096];
  const char *const other[] = {OBJECTS "/pair.so"};
  const struct um_model_options options[] = {{0}, {.effect_files = other, .neffect_file = 1}};
  scenario_with(EXAMPLE, scenario, sizeof scenario);
  case_write("own_alone.yaml", scenario);
  for (size_t i = 0; i < 3; i++) {
    struct um_model *model = NULL;
    um_core_message_clear(case_context());
    assert_int_equal(
        um_model_create(case_context(), "own_alone.yaml", i < 2 ? &options[i] : NULL, &model),
        UM_ERR_INPUT);
    assert_null(model);
    assert_non_null(strstr(um_core_message(case_context()), "own_alone.yaml:1: effect_files: "));
    assert_non_null(strstr(um_core_message(case_context()), "accepted: --allow-effects"));
  }
  um_core_message_clear(case_context());
  remove("own_alone.yaml");
}

/* A path of the scenario is one beside its file; --effect-file adds to it. */
static void files_are_found(void **state)
{
  (void)state;
  struct um_model *model = NULL;
  char scenario[4096];
  const char *const files[] = {OBJECTS "/pair.so", EXAMPLE};
  const struct um_model_options options = {.effect_files = files, .neffect_file = 2};
  scenario_with("pileup.so", scenario, sizeof scenario);
  case_write(OBJECTS "/own_beside.yaml", scenario);
  assert_int_equal(um_model_create(case_context(), OBJECTS "/own_beside.yaml", &options, &model),
                   UM_OK);
  assert_int_equal(um_model_effects_count(model), um_effects_count() + 3);
  um_model_destroy(case_context(), &model);
  remove(OBJECTS "/own_beside.yaml");
}

/* The first bytes of the example: a copy that was interrupted. */
static void write_cut(const char *file_name, size_t n)
{
  char *bytes = malloc(n);
  FILE *from = fopen(EXAMPLE, "rb"), *to = fopen(file_name, "wb");
  assert_true(bytes != NULL && from != NULL && to != NULL);
  assert_int_equal(fread(bytes, 1, n, from), n);
  assert_int_equal(fwrite(bytes, 1, n, to), n);
  assert_int_equal(fclose(to), 0);
  fclose(from);
  free(bytes);
}

static void cut_objects_are_refused(void **state)
{
  (void)state;
  static const size_t length[] = {20, 64, 100, 1000, 5000, 9000};
  for (size_t i = 0; i < sizeof length / sizeof length[0]; i++) {
    struct um_effects_registry *registry = NULL;
    write_cut(OBJECTS "/cut.so", length[i]);
    um_core_message_clear(case_context());
    assert_int_equal(um_effects_registry_create(case_context(), &registry), UM_OK);
    assert_int_equal(um_effects_registry_load(case_context(), registry, OBJECTS "/cut.so"),
                     UM_ERR_IO);
    assert_non_null(strstr(um_core_message(case_context()), "accepted: a"));
    um_effects_registry_destroy(case_context(), &registry);
  }
  um_core_message_clear(case_context());
  remove(OBJECTS "/cut.so");
}

/* While files are held an object may not change, and its message names it once. */
static void changed_objects_are_refused(void **state)
{
  (void)state;
  static const char file[] = OBJECTS "/changed.so";
  struct um_effects_registry *registry = NULL;
  FILE *example = fopen(EXAMPLE, "rb");
  assert_true(example != NULL && fseek(example, 0, SEEK_END) == 0);
  write_cut(file, (size_t)ftell(example));
  fclose(example);
  assert_int_equal(um_core_snapshot_begin(case_context()), UM_OK);
  assert_int_equal(um_effects_registry_create(case_context(), &registry), UM_OK);
  assert_int_equal(um_effects_registry_load(case_context(), registry, file), UM_OK);
  FILE *more = fopen(file, "ab");
  assert_true(more != NULL && fputc('\n', more) == '\n' && fclose(more) == 0);
  assert_int_equal(um_effects_registry_load(case_context(), registry, file), UM_ERR_IO);
  const char *message = um_core_message(case_context()), *name = strstr(message, "changed.so");
  assert_non_null(name);
  assert_non_null(strstr(name, "changed.so: has changed since it was read first"));
  assert_null(strstr(name + 1, "changed.so"));
  um_core_message_clear(case_context());
  um_effects_registry_destroy(case_context(), &registry);
  um_core_snapshot_end(case_context());
  remove(file);
}

static const struct {
  const char *file, *says;
} bad[] = {
    {OBJECTS "/bad_1.so", "ABI version 8"},
    {OBJECTS "/bad_2.so", "compile it again"},
    {OBJECTS "/bad_3.so", "no effect in it; accepted: a symbol um_effect"},
    {OBJECTS "/bad_4.so", "effect 'zero_point': there is a built-in effect of that name"},
    {OBJECTS "/bad_5.so", "parameter 'strength': default 3; accepted: -1 to 2 1"},
    {OBJECTS "/bad_6.so", "effect 'bad' has no hook"},
    {OBJECTS "/bad_7.so", "effect 'bad': there is already an effect of that name"},
    {OBJECTS "/bad_8.so", "compiled against other sizes of what its hooks change"},
    {UMBRA_SOURCE_DIR "/README.md", "accepted: a shared object"},
    {OBJECTS, "is not a plain file but a folder"},
    {OBJECTS "/none.so", "No such file"},
};

static void bad_objects_are_refused(void **state)
{
  (void)state;
  struct um_context *context = case_context();
  struct um_effects_registry *registry = registry_of(EXAMPLE);
  for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
    char scenario[4096];
    um_core_message_clear(context);
    enum um_status status = um_effects_registry_load(context, registry, bad[i].file);
    if (status != UM_ERR_INPUT && status != UM_ERR_IO) fail_msg("%s was accepted", bad[i].file);
    const char *message = um_core_message(context);
    if (strstr(message, bad[i].says) == NULL || strncmp(message, bad[i].file, 8) != 0 ||
        strchr(message, '\n') != NULL)
      fail_msg("'%s' does not hold '%s'", message, bad[i].says);
    assert_int_equal(um_effects_registry_count(registry), um_effects_count() + 1);
    um_core_message_clear(context);
    scenario_with(bad[i].file, scenario, sizeof scenario);
    case_refused(scenario, "albedo", bad[i].says);
    assert_non_null(strstr(um_core_message(context), ".yaml:1: effect_files: "));
  }
  um_effects_registry_destroy(context, &registry);
}

/* What a descriptor may not say, one change of a good one each. */
static void descriptors_are_checked(void **state)
{
  (void)state;
  struct um_context *context = case_context();
  struct um_effects_registry *registry = registry_of(EXAMPLE);
  const struct um_effect *good = um_effects_registry_find(registry, "pileup");
  assert_int_equal(um_effects_check(context, good), UM_OK);
  for (int i = 0; i < 16; i++) {
    struct um_effect e = *good;
    struct um_effect_parameter p[2] = {good->parameters[0], good->parameters[0]};
    e.parameters = p;
    if (i == 0) e.name = "two words";
    if (i == 1) e.summary = NULL;
    if (i == 2) e.reference = "";
    if (i == 3) e.targets = 0;
    if (i == 4) e.targets = 1024;
    if (i == 5) e.nparameter = UM_EFFECT_PARAMETERS_MAX + 1;
    if (i == 6) e.nparameter = 2; /* twice the same name */
    if (i == 7) e.parameters = NULL;
    if (i == 8) p[0].name = "target";
    if (i == 9) p[0].null_value = NAN;
    if (i == 10) p[0].maximum = INFINITY;
    if (i == 11) p[0].prior_sigma = 0.0;
    if (i == 12) p[0].logarithmic = true; /* and reaches below 0 */
    if (i == 13) e.on_by_default = 1;
    if (i == 14) e.validity = NULL;
    if (i == 15) { /* a switch that is off its null value by default */
      e.on_by_default = 1;
      e.switch_off = um_effects_find("albedo")->switch_off;
    }
    um_core_message_clear(context);
    if (um_effects_check(context, &e) != UM_ERR_INPUT) fail_msg("change %d was accepted", i);
    assert_non_null(strstr(um_core_message(context), "accepted: "));
  }
  um_core_message_clear(context);
  um_effects_registry_destroy(context, &registry);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(object_joins_the_registry), cmocka_unit_test(example_acts),
      cmocka_unit_test(hook_can_refuse),           cmocka_unit_test(scenario_alone_loads_nothing),
      cmocka_unit_test(files_are_found),           cmocka_unit_test(bad_objects_are_refused),
      cmocka_unit_test(cut_objects_are_refused),   cmocka_unit_test(changed_objects_are_refused),
      cmocka_unit_test(descriptors_are_checked),
  };
  return cmocka_run_group_tests(tests, case_begin, case_end);
}
