/* Worker processes are forked from one that has computed with many threads: their runs, which start
 * threads of their own kind and build scenes of their own, end, and give the same bits. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/batch/batch.h"
#include "base/batch/records.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"

#define NPOINT 4
#define NVALUE 10 /* five observations of two bands */

/* Intensities of a run of the box with some power in it. */
static enum um_status run(struct um_context *context, void *user, const double *coordinate,
                          double *value)
{
  (void)user;
  enum um_status status;
  char change[64];
  const char *const changes[] = {change};
  struct um_model_options options = {.overrides = changes, .noverride = 1};
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  snprintf(change, sizeof change, "optics.samples=%.0f", coordinate[0]);
  UM_CHECK(um_model_create(context, UMBRA_SOURCE_DIR "/tests/app/data/box.yaml", &options, &model));
  UM_CHECK(um_model_precompute(context, model, &tables));
  UM_CHECK(um_model_run(context, model, tables, &result));
  for (size_t i = 0; i < NVALUE; i++)
    value[i] = um_model_result_intensity(result, i / result->nband, i % result->nband, -1);
done:
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
  return status;
}

static void test_fork(void **state)
{
  (void)state;
  static const double x[NPOINT] = {4, 8, 12, 16};
  double here[NPOINT * NVALUE], there[NPOINT * NVALUE];
  char folder[UM_TEST_PATH], *reason[NPOINT];
  struct um_context *context;
  struct um_batch *batch;
  assert_int_equal(um_test_folder_create(folder), 0);
  assert_int_equal(um_core_context_create(NULL, &context), UM_OK);
  um_core_context_set_threads(context, 4);
  for (size_t i = 0; i < NPOINT; i++)
    if (run(context, NULL, &x[i], here + i * NVALUE) != UM_OK)
      fail_msg("%s", um_core_message(context));
  assert_true(here[NVALUE - 1] > 1.0);
  struct um_batch_task task = {.identity = 1,
                               .work.ncoordinate = 1,
                               .work.nvalue = NVALUE,
                               .work.compute = run,
                               .folder = folder,
                               .work.workers = 2};
  assert_int_equal(um_batch_open(context, &task, &batch), UM_OK);
  assert_int_equal(um_batch_run(context, batch, x, NPOINT, there, reason), UM_OK);
  for (size_t i = 0; i < NPOINT; i++)
    if (reason[i] != NULL) fail_msg("%s", reason[i]);
  assert_memory_equal(here, there, sizeof here);
  um_batch_close(context, &batch);
  um_batch_records_remove(context, folder);
  um_core_context_destroy(&context);
}

int main(void)
{
  static const struct CMUnitTest tests[] = {cmocka_unit_test(test_fork)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
