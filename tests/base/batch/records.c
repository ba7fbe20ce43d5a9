/* Points on record: computed once, found again by their bits, whatever became of the process. */
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/batch/batch.h"
#include "base/batch/records.h"
#include "tests/support/allocator.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"

#define NVALUE 5

static struct um_context *context;
static char folder[UM_TEST_PATH], file[UM_TEST_PATH + 32];
static size_t computed;

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

/* v_k = x^k / y; refused below 0, no number at 13. */
static enum um_status powers(struct um_context *c, void *user, const double *x, double *value)
{
  (void)user;
  computed++;
  if (x[0] < 0.0) return um_core_fail(c, UM_ERR_REFUSED, "%g lies below 0", x[0]);
  if (x[0] == 77.0) return um_core_fail(c, UM_ERR_MEMORY, "no memory for 77");
  for (size_t k = 0; k < NVALUE; k++) value[k] = pow(x[0], (double)k) / x[1];
  return UM_OK;
}

static struct um_batch_task task(bool resume)
{
  return (struct um_batch_task){.identity = 42,
                                .work.ncoordinate = 2,
                                .work.nvalue = NVALUE,
                                .work.compute = powers,
                                .folder = folder,
                                .resume = resume};
}

static struct um_batch *opened(bool resume)
{
  struct um_batch_task t = task(resume);
  struct um_batch *batch;
  if (um_batch_open(context, &t, &batch) != UM_OK) fail_msg("%s", um_core_message(context));
  return batch;
}

static void expect_values(const double *x, size_t n, const double *value, char *const *reason)
{
  for (size_t i = 0; i < n; i++) {
    assert_null(reason[i]);
    for (size_t k = 0; k < NVALUE; k++)
      assert_true(value[i * NVALUE + k] == pow(x[2 * i], (double)k) / x[2 * i + 1]);
  }
}

/* In the order asked; twice the same, and again later, is computed once. */
static void test_once(void **state)
{
  (void)state;
  static const double x[] = {3, 2, 1, 7, 3, 2, 0.1, 0.3, 0.0, 5};
  double value[5 * NVALUE];
  char *reason[5];
  computed = 0;
  struct um_batch *batch = opened(false);
  assert_true(um_batch_leads(batch));
  assert_int_equal(um_batch_run(context, batch, x, 3, value, reason), UM_OK);
  assert_int_equal(computed, 2);
  expect_values(x, 3, value, reason);
  assert_int_equal(um_batch_run(context, batch, x, 5, value, reason), UM_OK);
  assert_int_equal(computed, 4);
  assert_int_equal(um_batch_recorded(batch), 4);
  expect_values(x, 5, value, reason);
  um_batch_close(context, &batch);
  batch = opened(true);
  assert_int_equal(um_batch_recorded(batch), 4);
  memset(value, 0, sizeof value);
  assert_int_equal(um_batch_run(context, batch, x, 5, value, reason), UM_OK);
  assert_int_equal(computed, 4);
  expect_values(x, 5, value, reason);
  um_batch_close(context, &batch);
}

static bool accepts(void *user, const double *x, const double *value)
{
  ++*(size_t *)user;
  assert_true(value[0] == 1.0 / x[1]);
  return x[0] != 3.0;
}

/* What others have put on record is looked at once, and computed anew where it is not accepted;
 * what this process has computed is not asked about. */
static void test_accepts(void **state)
{
  (void)state;
  static const double x[] = {3, 2, 1, 7};
  double value[2 * NVALUE];
  char *reason[2];
  size_t looked = 0;
  computed = 0;
  for (int again = 0; again < 2; again++) {
    struct um_batch *batch;
    struct um_batch_task t = task(again);
    t.accepts = accepts;
    t.work.user = &looked;
    assert_int_equal(um_batch_open(context, &t, &batch), UM_OK);
    for (int run = 0; run < 2; run++) {
      assert_int_equal(um_batch_run(context, batch, x, 2, value, reason), UM_OK);
      expect_values(x, 2, value, reason);
      assert_int_equal(looked, again ? 2 : 0);
      assert_int_equal(computed, again ? 3 : 2);
      assert_int_equal(um_batch_recorded(batch), 2);
    }
    um_batch_close(context, &batch);
  }
  assert_non_null(strstr(um_core_log_text(context),
                         "1 points on record hold values that no computation gives"));
}

/* A refused point says why, then and after a resume; the others are computed. */
static void test_refused(void **state)
{
  (void)state;
  static const double x[] = {1, 1, -4, 1, 2, 1};
  computed = 0;
  for (int again = 0; again < 2; again++) {
    double value[3 * NVALUE];
    char *reason[3];
    struct um_batch *batch = opened(again);
    assert_int_equal(um_batch_run(context, batch, x, 3, value, reason), UM_OK);
    expect_values(x, 1, value, reason);
    expect_values(x + 4, 1, value + 2 * (size_t)NVALUE, reason + 2);
    assert_string_equal(reason[1], "-4 lies below 0");
    for (size_t k = 0; k < NVALUE; k++) assert_true(isnan(value[NVALUE + k]));
    um_core_free(context, reason[1]);
    assert_string_equal(um_core_message(context), "");
    um_batch_close(context, &batch);
  }
  assert_int_equal(computed, 3);
}

/* An error that is not of one point ends the work; what was done before it stays. */
static void test_end(void **state)
{
  (void)state;
  static const double x[] = {1, 1, 77, 1, 2, 1};
  double value[3 * NVALUE];
  char *reason[3];
  struct um_batch *batch = opened(false);
  assert_int_equal(um_batch_run(context, batch, x, 3, value, reason), UM_ERR_MEMORY);
  assert_non_null(strstr(um_core_message(context), ": 1 points are on record: no memory for 77"));
  um_core_message_clear(context);
  assert_int_equal(um_batch_recorded(batch), 1);
  um_batch_close(context, &batch);
  batch = opened(true);
  assert_int_equal(um_batch_recorded(batch), 1);
  um_batch_close(context, &batch);
}

static void expect_refusal(struct um_batch_task t, const char *words)
{
  struct um_batch *batch;
  assert_int_equal(um_batch_open(context, &t, &batch), UM_ERR_IO);
  assert_null(batch);
  if (strstr(um_core_message(context), words) == NULL) fail_msg("%s", um_core_message(context));
  um_core_message_clear(context);
}

/* Records are not mixed, not overwritten, not shared. */
static void test_other(void **state)
{
  (void)state;
  static const double x[] = {1, 1};
  double value[NVALUE];
  char *reason[1];
  struct um_batch *batch = opened(false);
  assert_int_equal(um_batch_run(context, batch, x, 1, value, reason), UM_OK);
  expect_refusal(task(true), "another process");
  um_batch_close(context, &batch);
  expect_refusal(task(false), "points are on record there");
  struct um_batch_task t = task(true);
  t.identity++;
  expect_refusal(t, "points of other work");
  t = task(true);
  t.work.nvalue++;
  expect_refusal(t, "points of other work");
  assert_int_equal(truncate(file, 0), 0);
  int fd = open(file, O_WRONLY);
  assert_int_equal(write(fd, "time_utc,q0,q1,q2,q3\n2016-09-21T20:30:00,1,0,0,0\n", 49), 49);
  close(fd);
  expect_refusal(task(true), "is not a file of records");
  expect_refusal(task(false), "points are on record there");
}

/* Cut anywhere, or with any byte changed, the whole records before that stay and the rest is
 * computed again. */
static void test_torn(void **state)
{
  (void)state;
  double x[] = {1, 1, 2, 1, 3, 1, 4, 1}, value[4 * NVALUE];
  char *reason[4];
  struct stat st;
  struct um_batch *batch = opened(false);
  assert_int_equal(um_batch_run(context, batch, x, 4, value, reason), UM_OK);
  um_batch_close(context, &batch);
  assert_int_equal(stat(file, &st), 0);
  off_t record = 8 + 8 * (2 + NVALUE) + 4, header = st.st_size - 4 * record;
  for (off_t at = 0; at < st.st_size; at += at < header + record ? 1 : 17)
    for (int torn = 0; torn < 2; torn++) {
      size_t whole = at < header ? 0 : (size_t)((at - header) / record);
      if (torn == 0 && at < header) continue; /* a wrong header is refused: test_other */
      if (torn) {
        assert_int_equal(truncate(file, at), 0);
      } else {
        char byte;
        int fd = open(file, O_RDWR);
        assert_int_equal(pread(fd, &byte, 1, at), 1);
        byte = (char)(byte ^ 0x10);
        assert_int_equal(pwrite(fd, &byte, 1, at), 1);
        close(fd);
      }
      computed = 0;
      batch = opened(true);
      assert_int_equal(um_batch_recorded(batch), whole);
      struct stat cut;
      assert_int_equal(stat(file, &cut), 0);
      assert_int_equal(cut.st_size, header + (off_t)whole * record);
      assert_int_equal(um_batch_run(context, batch, x, 4, value, reason), UM_OK);
      assert_int_equal(computed, 4 - whole);
      expect_values(x, 4, value, reason);
      um_batch_close(context, &batch);
      struct stat now;
      assert_int_equal(stat(file, &now), 0);
      assert_int_equal(now.st_size, st.st_size);
    }
}

/* Shares compute each point once between them, and a process without a share gathers all. */
static void test_shares(void **state)
{
  (void)state;
  double x[22], value[11 * NVALUE];
  char *reason[11];
  for (size_t i = 0; i < 11; i++) {
    x[2 * i] = (double)i;
    x[2 * i + 1] = 3.0;
  }
  computed = 0;
  for (size_t s = 3; s-- > 0;) { /* the last one first: it must leave the others theirs */
    struct um_batch_task t = task(false);
    struct um_batch *batch;
    t.share = s;
    t.nshare = 3;
    assert_int_equal(um_batch_open(context, &t, &batch), UM_OK);
    /* those before are on record already, and are not asked of this one */
    assert_int_equal(um_batch_run(context, batch, x, 11, value, reason), UM_OK);
    for (size_t i = 0; i < 11; i++) {
      assert_int_equal(reason[i] == NULL, i % 3 >= s);
      um_core_free(context, reason[i]);
    }
    um_batch_close(context, &batch);
  }
  struct um_batch *batch = opened(true);
  assert_int_equal(um_batch_run(context, batch, x, 11, value, reason), UM_OK);
  expect_values(x, 11, value, reason);
  assert_int_equal(computed, 11);
  um_batch_close(context, &batch);
}

/* Every allocation fails once: no memory is lost, and the records can be resumed. */
static void test_memory(void **state)
{
  (void)state;
  static const double x[] = {1, 1, -4, 1, 2, 1};
  for (long fail = 1;; fail++) {
    struct um_test_memory memory = {0};
    struct um_core_allocator allocator = um_test_memory_allocator(&memory);
    struct um_context *c;
    double value[3 * NVALUE];
    char *reason[3];
    assert_int_equal(um_core_context_create(&allocator, &c), UM_OK);
    memory.calls = 0;
    memory.fail_call = fail;
    struct um_batch_task t = task(true);
    struct um_batch *batch;
    enum um_status status = um_batch_open(c, &t, &batch);
    if (status == UM_OK) status = um_batch_run(c, batch, x, 3, value, reason);
    if (status == UM_OK) um_core_free(c, reason[1]);
    um_batch_close(c, &batch);
    bool reached = memory.calls >= fail;
    um_core_context_destroy(&c);
    assert_int_equal(memory.alive, 0);
    assert_int_equal(status, reached ? UM_ERR_MEMORY : UM_OK);
    if (!reached) return;
  }
}

int main(void)
{
#define TEST(f) cmocka_unit_test_setup_teardown(f, setup, teardown)
  static const struct CMUnitTest tests[] = {
      TEST(test_once),  TEST(test_accepts), TEST(test_refused), TEST(test_end),
      TEST(test_other), TEST(test_torn),    TEST(test_shares),  TEST(test_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
