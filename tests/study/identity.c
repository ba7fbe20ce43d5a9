/* What points are made of is looked at as it lies in the folder, though files are held. */
#include "study/identity.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/core/file_snapshot.h"
#include "model/build/build.h"
#include "tests/fuzz/wing.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

#define OK(call)                                                                                   \
  do {                                                                                             \
    if ((call) != UM_OK) fail_msg("%s", um_core_message(context));                                 \
  } while (0)

static void count(void *n, const char *path, uint64_t digest)
{
  (void)path;
  (void)digest;
  ++*(size_t *)n;
}

/* Another share may have begun the folder anew since it was looked at first. */
static void test_list_changes(void **state)
{
  (void)state;
  char path[UM_TEST_PATH], folder[UM_TEST_PATH], list[UM_TEST_PATH + 16];
  const struct um_model_options options = {0};
  struct um_model *model;
  struct um_study_identity *identity;
  struct um_batch *batch;
  size_t before = 0, after = 0;
  setenv("UMBRA_DATA", UMBRA_SOURCE_DIR "/tests/fuzz/data", 1);
  um_test_file_create(path, wing, sizeof wing - 1);
  assert_int_equal(um_test_folder_create(folder), 0);
  snprintf(list, sizeof list, "%s/made-of.txt", folder);
  OK(um_core_snapshot_begin(context));
  OK(um_model_create(context, path, &options, &model));
  OK(um_study_identity_create(context, "0", model, &options, &identity));
  um_core_snapshot_each(context, count, &before);
  const struct um_batch_task task = {.work.ncoordinate = 1, .work.nvalue = 1, .folder = folder};
  OK(um_study_identity_open(context, identity, &task, &batch));
  um_batch_close(context, &batch);
  OK(um_study_identity_check(context, identity, folder));
  FILE *file = fopen(list, "w");
  assert_non_null(file);
  fputs("0123456789abcdef program umbra\n", file);
  assert_int_equal(fclose(file), 0);
  assert_int_equal(um_study_identity_check(context, identity, folder), UM_ERR_IO);
  assert_non_null(strstr(um_core_message(context), "the program has other bytes than when this"));
  um_core_snapshot_each(context, count, &after);
  assert_int_equal(after, before); /* the list is no part of what it lists */
  um_study_records_remove(context, folder);
  assert_int_not_equal(access(folder, F_OK), 0);
  um_study_identity_destroy(context, &identity);
  um_model_destroy(context, &model);
  um_core_snapshot_end(context);
  unlink(path);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_list_changes)};
  return cmocka_run_group_tests_name("identity", tests, context_set_up, context_tear_down);
}
