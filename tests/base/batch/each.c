/* Tasks in stages: what is on record is told and not computed, the rest is, with the same answers.
 */
#include "base/batch/each.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/batch/records.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"

#define N      20
#define NVALUE 300 /* more than one record's and no multiple of it */
#define STAGES 3

static struct um_context *context;
static char folder[UM_TEST_PATH], file[UM_TEST_PATH + 32];

struct told {
  double value[STAGES][N][NVALUE], inner[N];
  size_t stage, steps, cancel_at; /* cancel_at 0: never */
  struct um_batch *batch;
};

static int setup(void **state)
{
  (void)state;
  if (um_test_folder_create(folder) != 0) return -1;
  snprintf(file, sizeof file, "%s/points.records", folder);
  return um_core_context_create(NULL, &context) == UM_OK ? 0 : -1;
}

static int teardown(void **state)
{
  (void)state;
  um_batch_records_remove(context, folder);
  um_core_context_destroy(&context);
  return access(folder, F_OK) == 0 ? -1 : 0;
}

static enum um_status inner(struct um_context *c, void *user, size_t which, double *value)
{
  (void)c;
  *value = *(const double *)user + (double)which;
  return UM_OK;
}

static enum um_status take_inner(struct um_context *c, void *user, size_t which,
                                 enum um_status status, const double *value)
{
  (void)c, (void)which;
  if (status == UM_OK) *(double *)user = *value;
  return status;
}

/* A task asks for tasks of its own, which are no stage. Task 5 of the second stage is refused. */
static enum um_status compute(struct um_context *c, void *user, size_t which, double *value)
{
  const struct told *told = user;
  double own = (double)(told->stage * N + which);
  const struct um_workers_each more = {
      .n = 1, .nvalue = 1, .compute = inner, .done = take_inner, .user = &own};
  if (told->stage == 1 && which == 5) return um_core_fail(c, UM_ERR_REFUSED, "not 5");
  UM_TRY(um_batch_each(c, told->batch, &more));
  for (size_t k = 0; k < NVALUE; k++) value[k] = sin(own + (double)k);
  return UM_OK;
}

static enum um_status done(struct um_context *c, void *user, size_t which, enum um_status status,
                           const double *value)
{
  struct told *told = user;
  if (status == UM_OK) memcpy(told->value[told->stage][which], value, NVALUE * sizeof *value);
  if (status == UM_ERR_REFUSED) um_core_message_clear(c);
  return status == UM_ERR_REFUSED ? UM_OK : status;
}

static bool progress(void *self, const char *task, size_t so_far, size_t total)
{
  struct told *told = self;
  (void)task, (void)total, (void)so_far;
  return told->cancel_at == 0 || ++told->steps < told->cancel_at;
}

/* All stages; *computed: records written. */
static enum um_status run(bool resume, int workers, struct told *told, size_t *before,
                          size_t *written)
{
  enum um_status status = UM_OK;
  struct um_batch_task task = um_batch_each_task();
  task.identity = 42;
  task.folder = folder;
  task.resume = resume;
  um_core_message_clear(context);
  if (um_batch_open(context, &task, &told->batch) != UM_OK)
    fail_msg("%s", um_core_message(context));
  *before = um_batch_recorded(told->batch);
  um_core_progress_set_sink(context, progress, told);
  um_core_progress_begin(context, "tasks", 0);
  for (told->stage = 0; told->stage < STAGES && status == UM_OK; told->stage++) {
    const struct um_workers_each each = {.n = N,
                                         .nvalue = NVALUE,
                                         .compute = compute,
                                         .done = done,
                                         .user = told,
                                         .workers = workers};
    status = um_batch_each(context, told->batch, &each);
  }
  um_core_progress_end(context);
  um_core_progress_set_sink(context, NULL, NULL);
  *written = um_batch_recorded(told->batch) - *before;
  um_batch_close(context, &told->batch);
  return status;
}

static void expect_all(const struct told *told)
{
  for (size_t s = 0; s < STAGES; s++)
    for (size_t i = 0; i < N; i++)
      for (size_t k = 0; k < NVALUE; k++)
        assert_true(told->value[s][i][k] ==
                    (s == 1 && i == 5 ? 0.0 : sin((double)(s * N + i) + (double)k)));
}

/* Stopped anywhere and gone on with, by one process or three: every answer is there, and no task is
 * on record twice. What was refused is tried again. */
static void test_resumed(void **state)
{
  (void)state;
  static struct told told;
  size_t before, written, whole;
  told = (struct told){0};
  assert_int_equal(run(false, 1, &told, &before, &whole), UM_OK);
  expect_all(&told);
  assert_int_equal(whole, (N * STAGES - 1) * ((NVALUE + 127) / 128));
  told = (struct told){0};
  assert_int_equal(run(true, 3, &told, &before, &written), UM_OK);
  expect_all(&told);
  assert_int_equal(before, whole);
  assert_int_equal(written, 0);
  for (size_t at = 8; at < 80; at += 33) {
    um_batch_records_remove(context, folder);
    assert_int_equal(mkdir(folder, 0700), 0);
    told = (struct told){.cancel_at = at};
    assert_int_equal(run(false, at % 2 == 0 ? 1 : 3, &told, &before, &written), UM_ERR_CANCELLED);
    assert_true(written < whole && (at % 2 == 1 || written > 0));
    size_t some = written;
    told = (struct told){0};
    assert_int_equal(run(true, at % 2 == 0 ? 3 : 1, &told, &before, &written), UM_OK);
    expect_all(&told);
    assert_int_equal(before, some);
    assert_int_equal(written, whole - some);
  }
}

/* Of a task whose last part was not written whole nothing is taken. */
static void test_cut(void **state)
{
  (void)state;
  static struct told told;
  size_t before, written, whole;
  struct stat st;
  told = (struct told){0};
  assert_int_equal(run(false, 1, &told, &before, &whole), UM_OK);
  assert_int_equal(stat(file, &st), 0);
  assert_int_equal(truncate(file, st.st_size - 7), 0);
  told = (struct told){0};
  assert_int_equal(run(true, 1, &told, &before, &written), UM_OK);
  expect_all(&told);
  assert_int_equal(before, whole - 1);
  assert_int_equal(written, (NVALUE + 127) / 128); /* the task, with the parts that were whole */
}

int main(void)
{
  static const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_resumed, setup, teardown),
      cmocka_unit_test_setup_teardown(test_cut, setup, teardown)};
  return cmocka_run_group_tests_name("each", tests, NULL, NULL);
}
