/* Memory that runs out on the way from a scenario to its results: every allocation of the context
 * fails once, at each place in turn; at every fourth once more, with all behind it. (A part of the
 * sweep takes the first forty and every ninth of the others, and of these every fourth.) Each time
 * the answer is "out of memory", nothing is left allocated, and of the results there is not even
 * the folder. (What libfyaml, Embree, SUNDIALS and HDF5 allocate does not pass through the context.
 * Lines of the log, which are lost without a word, are swept in tests/base/core/oom.c.) */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "effects/effects.h"
#include "model/build/build.h"
#include "model/build/timeline.h"
#include "model/geometry/precompute.h"
#include "model/products/picture.h"
#include "model/run/run.h"
#include "orbit/time.h"
#include "output/output.h"
#include "tests/support/allocator.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"
#include "tests/support/whole.h"

#define SETS_MAX 128

static const char scenario[] =
    "schema: 1\n"
    "name: short of memory\n"
    "time: {start_utc: 2016-03-20T04:30:00Z, stop_utc: 2016-03-20T04:30:20Z, step_s: 10,\n"
    "       exposure_s: 2, exposure_samples: 2}\n"
    "orbit: {circular: {altitude_km: 765, beta_deg: 0}}\n"
    "attitude: [{lvlh: {}}, {from_utc: 2016-03-20T04:30:10Z, sun: {axis_body: [0, 0, 1],\n"
    "            clock_body: [1, 0, 0]}}]\n"
    "observer: {direction: {unit_gcrs: [0.5, 0.8660254, 0], range_km: 1000}}\n"
    "parts:\n"
    "  - {name: bus, box: {size_m: [1, 1, 1]}, outside: grey, lumped: true,\n"
    "     interior: {capacity_J_K: 1000, power_W: 5}, groups: {\"+x\": {interior_conductance_W_K: "
    "5}},\n"
    "     mli: {effective_emittance: 0.02, areal_heat_capacity_J_m2_K: 300},\n"
    "     shell: {areal_heat_capacity_J_m2_K: 1000}}\n"
    "  - {name: wing, plate: {size_m: [1, 1]}, pose: {position_m: [1.5, 0, 0]},\n"
    "     joint: {axis: [1, 0, 0], track: sun, normal: [0, 0, 1]}, front: coated, back: black,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 1000, conductance_W_K: 0.03,\n"
    "             through_conductance_W_m2_K: 100}}\n"
    "contacts: [{a: bus.interior, b: wing, conductance_W_K: 0.5}]\n"
    "thermal: {orbits_before: 0, step_s: 600, samples: 1, relative_tolerance: 1e-3,\n"
    "          absolute_tolerance_K: 0.1}\n"
    "bands: {vis: {from_um: 0.4, to_um: 0.7, bins: 3}, lwir: {from_um: 8, to_um: 12, bins: 2}}\n"
    "optics: {samples: 2, interreflection_samples: 2}\n";

/* A scenario and what was made of it, in memory that counts. */
struct subject {
  struct um_test_memory memory;
  struct um_context *context;
  char scenario_path[UM_TEST_PATH], folder[UM_TEST_PATH], results[UM_TEST_PATH + 16];
  struct um_model_options options;
  struct um_model *model;
  struct um_model_tables *tables;
  struct um_model_result *result;
};

/* A step that leaves nothing behind. */
typedef enum um_status (*step)(struct subject *s);

static enum um_status create(struct subject *s)
{
  struct um_model *model = NULL;
  enum um_status status = um_model_create(s->context, s->scenario_path, &s->options, &model);
  if (status != UM_OK) assert_null(model);
  um_model_destroy(s->context, &model);
  return status;
}

static enum um_status create_orbit(struct subject *s)
{
  struct um_model *model = NULL;
  enum um_status status = um_model_create_orbit(s->context, s->scenario_path, &s->options, &model);
  if (status != UM_OK) assert_null(model);
  um_model_destroy(s->context, &model);
  return status;
}

static enum um_status tables(struct subject *s)
{
  struct um_model_tables *made = NULL;
  enum um_status status = um_model_precompute(s->context, s->model, &made);
  if (status != UM_OK) assert_null(made);
  um_model_tables_destroy(s->context, &made);
  return status;
}

/* Eclipses of forty orbits: more than the list of events holds at first. */
static enum um_status events(struct subject *s)
{
  struct um_environment_event *event = NULL;
  size_t count;
  double from = s->tables->t_first;
  enum um_status status = um_model_events(s->context, s->model, from, from + 2.4e5, &event, &count);
  if (status == UM_OK)
    assert_true(count > 200);
  else
    assert_null(event);
  um_core_free(s->context, event);
  return status;
}

static enum um_status run(struct subject *s)
{
  struct um_model_result *made = NULL;
  enum um_status status = um_model_run(s->context, s->model, s->tables, &made);
  if (status != UM_OK) assert_null(made);
  um_model_result_destroy(s->context, &made);
  return status;
}

static enum um_status picture(struct subject *s)
{
  struct um_optics_image *image = NULL;
  enum um_status status =
      um_model_picture(s->context, s->model, s->tables, s->result, 0, 1, 1, 8, 1, &image);
  if (status != UM_OK) assert_null(image);
  um_optics_image_destroy(s->context, &image);
  return status;
}

static void results_remove(const struct subject *s)
{
  static const char *const names[] = {".umbra",           "lightcurve.csv", "materials.csv",
                                      "temperatures.csv", "heat.csv",       "temperatures.cic",
                                      "run.nc",           "run.xdmf",       "scenario.yaml",
                                      "report.html",      "log.txt"};
  char path[2 * UM_TEST_PATH];
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    snprintf(path, sizeof path, "%s/%s", s->results, names[i]);
    assert_int_equal(remove(path), 0);
  }
  assert_int_equal(remove(s->results), 0);
}

static enum um_status write_results(struct subject *s)
{
  enum um_status status;
  struct stat there;
  struct um_core_folder *folder = NULL;
  const struct um_output_run out = {.model = s->model,
                                    .tables = s->tables,
                                    .result = s->result,
                                    .command = "run",
                                    .version = "0",
                                    .context = s->context};
  UM_CHECK(um_core_folder_begin(s->context, s->results, false, &folder));
  UM_CHECK(um_output_write_run(s->context, &out, false, folder));
  UM_CHECK(um_core_folder_commit(s->context, &folder));
  results_remove(s);
done:
  um_core_folder_abort(&folder);
  assert_true(stat(s->results, &there) != 0);
  return status;
}

static enum um_status registry(struct subject *s)
{
  struct um_effects_registry *made = NULL;
  enum um_status status = um_effects_registry_create(s->context, &made);
  if (status != UM_OK) assert_null(made);
  um_effects_registry_destroy(s->context, &made);
  return status;
}

static void begin(struct subject *s)
{
  *s = (struct subject){0};
  struct um_core_allocator allocator = um_test_memory_allocator(&s->memory);
  assert_int_equal(um_core_context_create(&allocator, &s->context), UM_OK);
  um_core_context_set_threads(s->context, 1);
  um_core_quiet_begin(s->context);
  um_test_file_create(s->scenario_path, scenario, strlen(scenario));
  assert_int_equal(um_test_folder_create(s->folder), 0);
  snprintf(s->results, sizeof s->results, "%s/results", s->folder);
  assert_int_equal(setenv("UMBRA_DATA", UMBRA_SOURCE_DIR "/tests/fuzz/data", 1), 0);
}

static void need(const struct subject *s, enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(s->context));
}

/* The model and what follows from it, with memory enough. */
static void compute(struct subject *s)
{
  need(s, um_model_create(s->context, s->scenario_path, &s->options, &s->model));
  need(s, um_model_precompute(s->context, s->model, &s->tables));
  need(s, um_model_run(s->context, s->model, s->tables, &s->result));
}

static void end(struct subject *s)
{
  um_model_result_destroy(s->context, &s->result);
  um_model_tables_destroy(s->context, &s->tables);
  um_model_destroy(s->context, &s->model);
  assert_int_equal(remove(s->scenario_path), 0);
  /* empty: not even a temporary folder is left */
  assert_int_equal(um_test_folder_remove(s->folder), 0);
  um_core_quiet_end(s->context);
  um_core_context_destroy(&s->context);
  assert_int_equal(s->memory.alive, 0);
  assert_int_equal(unsetenv("UMBRA_DATA"), 0);
}

/* The next allocation that is to fail. */
static long next(long k, bool stays_out)
{
  long stride = um_test_whole() || k < 40 ? 1 : 9;
  return k + (stays_out ? 4 * stride : stride);
}

/* Every allocation of the step fails; `least` so many there are. */
static void sweep(struct subject *s, const char *name, step take, long least)
{
  long before = s->memory.alive, count = 0;
  for (int stays_out = 0; stays_out < 2; stays_out++) {
    s->memory.stays_out = stays_out != 0;
    for (long k = 1;; k = next(k, stays_out != 0)) {
      s->memory.calls = 0;
      s->memory.fail_call = k;
      um_core_message_clear(s->context);
      enum um_status status = take(s);
      bool failed = s->memory.calls >= k;
      s->memory.fail_call = 0;
      if (s->memory.alive != before)
        fail_msg("%s: %ld blocks left, allocation %ld", name, s->memory.alive - before, k);
      if (!failed) {
        need(s, status);
        if (!stays_out) count = s->memory.calls;
        break;
      }
      if (status != UM_ERR_MEMORY)
        fail_msg("%s: allocation %ld: status %d: %s", name, k, (int)status,
                 um_core_message(s->context));
      assert_true(um_core_message(s->context)[0] != '\0');
    }
  }
  print_message("%s: %ld allocations\n", name, count);
  assert_true(count > least);
}

static void test_model(void **state)
{
  (void)state;
  struct subject s;
  begin(&s);
  compute(&s);
  sweep(&s, "scenario and model", create, 200);
  sweep(&s, "orbit alone", create_orbit, 10);
  sweep(&s, "geometry tables", tables, 50);
  sweep(&s, "eclipses", events, 1);
  sweep(&s, "run", run, 50);
  sweep(&s, "picture", picture, 3);
  sweep(&s, "results", write_results, 10);
  end(&s);
}

/* Every effect there is, on the first thing it may act on; the sum of them need not make sense. */
static void test_effects(void **state)
{
  (void)state;
  static const char *const targets[] = {NULL,         "bus",  "wing",   "bus.+x", "bus.interior",
                                        "wing.front", "grey", "coated", "lwir",   "vis"};
  struct subject s;
  char text[SETS_MAX][200];
  const char *set[SETS_MAX];
  size_t n = 0;
  begin(&s);
  need(&s, um_model_create(s.context, s.scenario_path, &s.options, &s.model));
  for (size_t i = 0; i < um_effects_count(); i++) {
    const struct um_effect *effect = um_effects_at(i);
    for (size_t t = 0; t < sizeof targets / sizeof targets[0]; t++) {
      char with[200];
      snprintf(with, sizeof with, "%s%s%s", effect->name, targets[t] != NULL ? ":" : "",
               targets[t] != NULL ? targets[t] : "");
      const char *one = with;
      const struct um_model_options options = {.with = &one, .nwith = 1};
      struct um_model *model = NULL;
      enum um_status status = um_model_create(s.context, s.scenario_path, &options, &model);
      um_model_destroy(s.context, &model);
      um_core_message_clear(s.context);
      if (status != UM_OK) continue;
      assert_true(n < SETS_MAX);
      memcpy(text[n], with, sizeof with);
      set[n] = text[n];
      n++;
      break;
    }
  }
  um_model_destroy(s.context, &s.model);
  print_message("%zu of %zu effects\n", n, um_effects_count());
  assert_true(n + 2 >= um_effects_count());
  s.options = (struct um_model_options){.with = set, .nwith = n};
  compute(&s);
  sweep(&s, "registry", registry, 0);
  sweep(&s, "model with all effects", create, 200);
  sweep(&s, "geometry tables with all effects", tables, 50);
  sweep(&s, "run with all effects", run, 50);
  end(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_model), cmocka_unit_test(test_effects)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
