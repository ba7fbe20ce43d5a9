/* Memory that runs out while a plan, a comparison or synthetic measurements are made: every
 * allocation fails once; each time the call returns UM_ERR_MEMORY, hands nothing out and leaves
 * nothing behind. */
#include "evidence/comparison/compare.h"
#include "evidence/inversion/synth.h"
#include "evidence/measurements/measurements.h"
#include "tests/evidence/model_test.h"
#include "tests/support/allocator.h"

static enum um_status everything(struct world *w, const struct um_compare_measurements *m)
{
  static const char *const place[] = {"interior"};
  const struct um_compare_synth o = {
      .relative = 0.01, .floor = 0.01, .place = place, .nplace = 1, .temperature_sigma = 1.0};
  struct um_compare_plan *plan = NULL;
  struct um_compare_comparison *comparison = NULL;
  struct um_compare_measurements *made = NULL;
  enum um_status status;
  UM_CHECK(um_compare_plan_create(context, w->model, m, &plan));
  struct um_compare_run run = {w->model, plan, w->tables, w->result};
  UM_CHECK(um_compare_create(context, &run, 0.0, &comparison));
  UM_CHECK(um_compare_synth_create(context, w->model, w->tables, w->result, &o, "m", &made));
done:
  if (status != UM_OK) assert_null(made);
  um_compare_measurements_destroy(context, &made);
  um_compare_destroy(context, &comparison);
  um_compare_plan_destroy(context, &plan);
  return status;
}

static void test_every_allocation(void **state)
{
  (void)state;
  struct um_test_memory memory = {0};
  struct um_core_allocator allocator = um_test_memory_allocator(&memory);
  struct um_context *kept = context;
  static const char *const shorter = "time.stop_utc=2016-09-06T18:08:16Z";
  assert_int_equal(um_core_context_create(&allocator, &context), UM_OK);
  um_core_context_set_threads(context, 1);
  struct world w = world_of(&(struct um_model_options){.overrides = &shorter, .noverride = 1});
  struct um_compare_measurements *m;
  FILE *file = fopen("m.csv", "wb");
  assert_non_null(file);
  fputs(HEAD, file);
  for (int k = 0; k < 5; k++) /* the geometry tables' own times, so that they fit the plan */
    fprintf(file,
            DAY "08:%02dZ,band_irradiance,lwir,1e-12,\n" DAY "08:%02dZ,temperature,+x,280,1\n",
            4 * k, 4 * k);
  fclose(file);
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  long alive = memory.alive;
  memory.calls = 0;
  assert_ok(everything(&w, m));
  assert_int_equal(memory.alive, alive);
  long calls = memory.calls;
  assert_true(calls > 50);
  for (long k = 1; k <= calls; k++) {
    memory.calls = 0;
    memory.fail_call = k;
    um_core_message_clear(context);
    if (everything(&w, m) != UM_ERR_MEMORY || memory.alive != alive)
      fail_msg("allocation %ld of %ld: %s; %ld blocks left", k, calls, um_core_message(context),
               memory.alive - alive);
  }
  memory.fail_call = 0;
  um_compare_measurements_destroy(context, &m);
  world_end(&w);
  um_core_context_destroy(&context);
  assert_int_equal(memory.alive, 0);
  context = kept;
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_every_allocation)};
  return cmocka_run_group_tests(tests, model_set_up, model_tear_down);
}
