/* Worker processes: the same values as alone, whatever dies, stops or fills up in between. */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "base/batch/batch.h"
#include "base/batch/records.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"

#define NPOINT 600
#define NVALUE 300

static struct um_context *context;
static double silence; /* of the next batch that is opened [s], 0: as it comes */
static char folder[UM_TEST_PATH], file[UM_TEST_PATH + 32];

/* Seen by every process of a test. */
static struct shared {
  volatile int started[NPOINT]; /* how often a point was begun */
  volatile int process[NPOINT]; /* by whom last */
  volatile int deaths;          /* that the point of deaths still has before it */
  volatile size_t done;         /* as progress told */
  volatile int nap_us;          /* that each point takes */
} * shared;

static int setup(void **state)
{
  (void)state;
  if (um_test_folder_create(folder) != 0) return -1;
  snprintf(file, sizeof file, "%s/points.records", folder);
  shared = mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) return -1;
  return um_core_context_create(NULL, &context) == UM_OK ? 0 : -1;
}
static int teardown(void **state)
{
  (void)state;
  munmap((void *)shared, sizeof *shared);
  um_batch_records_remove(context, folder);
  um_core_context_destroy(&context);
  bool clean = access(folder, F_OK) != 0 && waitpid(-1, NULL, WNOHANG) == -1 && errno == ECHILD;
  return clean ? 0 : -1;
}

static double now(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void nap(double seconds)
{
  nanosleep(&(struct timespec){(time_t)seconds, (long)((seconds - (double)(time_t)seconds) * 1e9)},
            NULL);
}

/* added to a coordinate */
enum {
  DIES = 1000,
  REFUSED = 2000,
  NO_MEMORY = 3000,
  SLEEPS = 4000,
  STOPS = 5000,
  WORKS = 6000,
  NAPS = 7000
};

/* v_k = cos(k x + y); and what may go wrong. */
static enum um_status waves(struct um_context *c, void *user, const double *x, double *value)
{
  (void)user;
  int i = (int)x[0] % 1000, kind = (int)x[0] - i;
  shared->started[i]++;
  shared->process[i] = (int)getpid();
  if (shared->nap_us > 0) nap(1e-6 * (double)shared->nap_us);
  if (kind == DIES && shared->deaths-- > 0) raise(SIGKILL);
  if (kind == REFUSED) return um_core_fail(c, UM_ERR_NUMERIC, "no answer at %d", i);
  if (kind == NO_MEMORY) return um_core_fail(c, UM_ERR_MEMORY, "no memory at %d", i);
  if (kind == SLEEPS) nap(100.0);
  if (kind == STOPS && shared->deaths-- > 0) raise(SIGSTOP);
  if (kind == NAPS) nap(2.3 * silence);
  for (double until = now() + 2.5 * silence; kind == WORKS && now() < until;) continue;
  for (size_t k = 0; k < NVALUE; k++) value[k] = cos((double)k * x[0] + x[1]);
  return UM_OK;
}

static void ask(double *x)
{
  for (size_t i = 0; i < NPOINT; i++) {
    x[2 * i] = (double)i;
    x[2 * i + 1] = 0.25;
  }
}

static struct um_batch *opened(int workers, bool resume)
{
  struct um_batch_task t = {.identity = 7,
                            .work.ncoordinate = 2,
                            .work.nvalue = NVALUE,
                            .work.compute = waves,
                            .folder = folder,
                            .resume = resume,
                            .work.workers = workers,
                            .work.silence = silence};
  struct um_batch *batch;
  if (um_batch_open(context, &t, &batch) != UM_OK) fail_msg("%s", um_core_message(context));
  return batch;
}

static void expect_waves(const double *x, const double *value)
{
  for (size_t k = 0; k < NVALUE; k++) assert_true(value[k] == cos((double)k * x[0] + x[1]));
}

static void test_same(void **state)
{
  (void)state;
  double x[2 * NPOINT], *value = calloc(NPOINT * NVALUE, sizeof *value);
  char *reason[NPOINT];
  ask(x);
  for (int workers = 1; workers <= 4; workers++) {
    struct um_batch *batch = opened(workers, false);
    memset((void *)shared->started, 0, sizeof shared->started);
    /* in two parts: workers stay for the second */
    assert_int_equal(um_batch_run(context, batch, x, 20, value, reason), UM_OK);
    assert_int_equal(um_batch_run(context, batch, x, NPOINT, value, reason), UM_OK);
    for (size_t i = 0; i < NPOINT; i++) {
      assert_null(reason[i]);
      expect_waves(x + 2 * i, value + i * NVALUE);
      assert_int_equal(shared->started[i], 1);
      assert_int_equal(shared->process[i] == getpid(), workers == 1);
    }
    um_batch_close(context, &batch);
    assert_int_equal(unlink(file), 0);
  }
  free(value);
}

/* One worker's death costs nothing; two over one point cost the point, which a resume computes. */
static void test_death(void **state)
{
  (void)state;
  double x[2 * NPOINT], *value = calloc(NPOINT * NVALUE, sizeof *value);
  char *reason[NPOINT];
  ask(x);
  x[2 * 11] += DIES;
  for (int deaths = 1; deaths <= 2; deaths++) {
    struct um_batch *batch = opened(2, false);
    shared->deaths = deaths;
    assert_int_equal(um_batch_run(context, batch, x, NPOINT, value, reason), UM_OK);
    for (size_t i = 0; i < NPOINT; i++)
      if (i != 11 || deaths == 1) {
        assert_null(reason[i]);
        expect_waves(x + 2 * i, value + i * NVALUE);
      }
    assert_non_null(
        strstr(um_core_log_text(context), "died (signal 9, Killed); the point is handed"));
    if (deaths == 2) {
      assert_non_null(strstr(reason[11], "died, twice (signal 9, Killed)"));
      assert_true(isnan(value[11 * NVALUE]));
      um_core_free(context, reason[11]);
    }
    assert_int_equal(um_batch_recorded(batch), deaths == 1 ? NPOINT : NPOINT - 1);
    assert_int_equal(um_batch_lost(batch), deaths - 1);
    um_batch_tell_lost(context, batch, x, NPOINT, "row", 1);
    assert_int_equal(strstr(um_core_log_text(context),
                            "row 12: not on record: the process that computed it died, twice") !=
                         NULL,
                     deaths == 2);
    if (deaths == 2) {
      double many[12][2];
      for (int i = 0; i < 12; i++) memcpy(many[i], x + 2 * 11, sizeof many[i]);
      um_batch_tell_lost(context, batch, many[0], 12, "row", 1);
      assert_non_null(strstr(um_core_log_text(context),
                             "row 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 and 2 more: not on record: "));
    }
    um_batch_close(context, &batch);
    if (deaths == 2) {
      batch = opened(2, true);
      assert_int_equal(um_batch_run(context, batch, x, NPOINT, value, reason), UM_OK);
      assert_null(reason[11]);
      assert_int_equal(um_batch_lost(batch), 0);
      expect_waves(x + 2 * 11, value + 11 * NVALUE);
      um_batch_close(context, &batch);
    }
    assert_int_equal(unlink(file), 0);
  }
  free(value);
}

/* A worker that is stopped is replaced, its point handed out again; one that is stopped over the
 * same point again costs it; a point that is worked at for longer than that is left alone. */
static void test_silent(void **state)
{
  (void)state;
  double x[8] = {STOPS, 0, WORKS + 1, 0, 2, 0, 3, 0}, value[4 * NVALUE];
  char *reason[4];
  silence = 0.8;
  for (int stops = 1; stops <= 2; stops++) {
    struct um_batch *batch = opened(2, false);
    double begin = now();
    memset((void *)shared->started, 0, sizeof shared->started);
    shared->deaths = stops;
    assert_int_equal(um_batch_run(context, batch, x, 4, value, reason), UM_OK);
    assert_true(now() - begin < 10.0);
    assert_int_equal(shared->started[0], 2);
    assert_int_equal(shared->started[1], 1);
    for (size_t i = stops == 1 ? 0 : 1; i < 4; i++) {
      assert_null(reason[i]);
      expect_waves(x + 2 * i, value + i * NVALUE);
    }
    assert_non_null(strstr(um_core_log_text(context),
                           "died (stopped or stuck: it did nothing for 0.8 s); the point is handed "
                           "out again"));
    if (stops == 2) assert_non_null(strstr(reason[0], "died, twice (stopped or stuck"));
    um_core_free(context, reason[0]);
    um_batch_close(context, &batch);
    assert_int_equal(unlink(file), 0);
  }
  silence = 0.0;
}

/* The process that looks is stopped itself and goes on: what it has not seen is no silence. The
 * workers use no processor all the while, but before and behind it only for 0.7 of what counts. */
static void test_leader_stopped(void **state)
{
  (void)state;
  double x[4] = {NAPS, 0, NAPS + 1, 0}, value[2 * NVALUE];
  char *reason[2];
  int code;
  silence = 0.8;
  pid_t child = fork();
  if (child == 0) {
    struct um_batch *batch = opened(2, false);
    enum um_status status = um_batch_run(context, batch, x, 2, value, reason);
    _exit(status == UM_OK && strstr(um_core_log_text(context), "died") == NULL ? 0 : 1);
  }
  while (shared->started[0] == 0 || shared->started[1] == 0) nap(1e-3);
  nap(0.3 * silence); /* workers have been looked at */
  kill(child, SIGSTOP);
  nap(1.6 * silence);
  kill(child, SIGCONT);
  assert_int_equal(waitpid(child, &code, 0), child);
  assert_true(WIFEXITED(code) && WEXITSTATUS(code) == 0);
  assert_int_equal(shared->started[0] + shared->started[1], 2);
  silence = 0.0;
}

static void test_refused(void **state)
{
  (void)state;
  double x[2 * NPOINT], *value = calloc(NPOINT * NVALUE, sizeof *value);
  char *reason[NPOINT];
  ask(x);
  x[2 * 3] += REFUSED;
  for (int again = 0; again < 2; again++) {
    struct um_batch *batch = opened(2, again);
    assert_int_equal(um_batch_run(context, batch, x, NPOINT, value, reason), UM_OK);
    assert_string_equal(reason[3], "no answer at 3");
    um_core_free(context, reason[3]);
    expect_waves(x, value);
    um_batch_close(context, &batch);
  }
  assert_int_equal(shared->started[3], 1);
  free(value);
}

static void test_end(void **state)
{
  (void)state;
  double x[2 * NPOINT], *value = calloc(NPOINT * NVALUE, sizeof *value);
  char *reason[NPOINT];
  ask(x);
  x[2 * 30] += NO_MEMORY;
  x[2 * 31] += SLEEPS; /* or the other worker goes on until a busy machine has told of the error */
  struct um_batch *batch = opened(2, false);
  assert_int_equal(um_batch_run(context, batch, x, NPOINT, value, reason), UM_ERR_MEMORY);
  assert_non_null(strstr(um_core_message(context), "no memory at 30"));
  um_core_message_clear(context);
  size_t recorded = um_batch_recorded(batch);
  assert_true(recorded >= 29 && recorded <= 30); /* the other worker may be at one before it */
  /* and the same batch goes on */
  x[2 * 30] -= NO_MEMORY;
  x[2 * 31] -= SLEEPS;
  assert_int_equal(um_batch_run(context, batch, x, NPOINT, value, reason), UM_OK);
  expect_waves(x + 2 * 30, value + 30 * NVALUE);
  um_batch_close(context, &batch);
  free(value);
}

static double stop_at;
static bool stop(void *self)
{
  (void)self;
  return now() > stop_at;
}

/* A worker that hears nothing is no obstacle. */
static void test_stop(void **state)
{
  (void)state;
  double x[4] = {SLEEPS, 0, SLEEPS + 1, 0}, value[2 * NVALUE];
  char *reason[2];
  struct um_batch *batch = opened(2, false);
  stop_at = now() + 0.3;
  um_core_context_set_stop(context, stop, NULL);
  assert_int_equal(um_batch_run(context, batch, x, 2, value, reason), UM_ERR_CANCELLED);
  assert_true(now() < stop_at + 20.0);
  assert_non_null(strstr(um_core_message(context), "cancelled while computing points"));
  um_batch_close(context, &batch);
}

/* A disk without room: a clear word, and what was kept before is whole. */
static void test_full(void **state)
{
  (void)state;
  double x[2 * NPOINT], *value = calloc(NPOINT * NVALUE, sizeof *value);
  char *reason[NPOINT];
  struct rlimit before, small;
  ask(x);
  for (int workers = 1; workers <= 2; workers++) {
    struct um_batch *batch = opened(workers, false);
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    small = before;
    small.rlim_cur = (rlim_t)(48 + 10.5 * (8 + 8 * (2 + NVALUE) + 4));
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    enum um_status status = um_batch_run(context, batch, x, NPOINT, value, reason);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    assert_int_equal(status, UM_ERR_IO);
    assert_non_null(strstr(um_core_message(context), "10 points are on record"));
    assert_non_null(strstr(um_core_message(context), "a point cannot be kept: File too large"));
    um_core_message_clear(context);
    um_batch_close(context, &batch);
    size_t logged = strlen(um_core_log_text(context));
    batch = opened(workers, true);
    assert_int_equal(um_batch_recorded(batch), 10);
    assert_int_equal(strlen(um_core_log_text(context)), logged); /* nothing was torn */
    assert_int_equal(um_batch_run(context, batch, x, NPOINT, value, reason), UM_OK);
    for (size_t i = 0; i < NPOINT; i++) expect_waves(x + 2 * i, value + i * NVALUE);
    um_batch_close(context, &batch);
    assert_int_equal(unlink(file), 0);
  }
  free(value);
}

static bool note_done(void *self, const char *task, size_t done, size_t total)
{
  (void)self;
  (void)task;
  (void)total;
  shared->done = done;
  return true;
}

/* The points that the file holds, by its layout, as documented in base/batch/records_impl.h. */
static size_t read_recorded(bool recorded[NPOINT])
{
  unsigned char record[8 + 8 * (2 + NVALUE) + 4];
  size_t n = 0;
  memset(recorded, 0, NPOINT * sizeof *recorded);
  FILE *in = fopen(file, "rb");
  if (in == NULL) return 0;
  fseek(in, 48, SEEK_SET);
  while (fread(record, sizeof record, 1, in) == 1) {
    double x;
    memcpy(&x, record + 8, sizeof x);
    recorded[(int)x] = true;
    n++;
  }
  fclose(in);
  return n;
}

/* Killed at 20 random moments: nothing that was told to be done is computed again, no worker
 * outlives its parent, and the values are those of one go. */
static void test_kill(void **state)
{
  (void)state;
  double x[2 * NPOINT], *value = calloc(NPOINT * NVALUE, sizeof *value);
  char *reason[NPOINT];
  bool recorded[NPOINT], before[NPOINT] = {false};
  size_t nbefore = 0, kills = 0;
  ask(x);
  assert_int_equal(prctl(PR_SET_CHILD_SUBREAPER, 1), 0); /* its orphans come to this process */
  srand(20160921);
  for (shared->nap_us = 12000; kills < 20; kills++) {
    shared->done = 0;
    memset((void *)shared->started, 0, sizeof shared->started);
    pid_t child = fork();
    if (child == 0) {
      um_core_progress_set_sink(context, note_done, NULL);
      struct um_batch *batch = opened(1 + (int)(kills % 3), true);
      _exit(um_batch_run(context, batch, x, NPOINT, value, reason) == UM_OK ? 0 : 1);
    }
    nap(1e-6 * (double)(rand() % 250000));
    size_t done = shared->done;
    kill(child, SIGKILL);
    while (waitpid(-1, NULL, 0) > 0) continue; /* workers too: ends only when they have died */
    size_t n = read_recorded(recorded);
    assert_true(n >= nbefore + done);
    for (size_t i = 0; i < NPOINT; i++) {
      assert_false(before[i] && shared->started[i] > 0);
      assert_false(before[i] && !recorded[i]);
      assert_true(shared->started[i] <= 1);
    }
    memcpy(before, recorded, sizeof before);
    nbefore = n;
  }
  assert_int_equal(prctl(PR_SET_CHILD_SUBREAPER, 0), 0);
  assert_true(nbefore > 3 && nbefore < NPOINT); /* the kills were neither too early nor too late */
  shared->nap_us = 0;
  struct um_batch *batch = opened(2, true);
  assert_int_equal(um_batch_run(context, batch, x, NPOINT, value, reason), UM_OK);
  for (size_t i = 0; i < NPOINT; i++) expect_waves(x + 2 * i, value + i * NVALUE);
  um_batch_close(context, &batch);
  free(value);
}

/* Power fails in the moment in which points are told to be done. */
static bool die_when_told(void *self, const char *task, size_t done, size_t total)
{
  note_done(self, task, done, total);
  if (done > 0) raise(SIGKILL);
  return true;
}

static void test_told(void **state)
{
  (void)state;
  double x[2 * NPOINT], *value = calloc(NPOINT * NVALUE, sizeof *value);
  char *reason[NPOINT];
  bool recorded[NPOINT];
  size_t before = 0;
  ask(x);
  assert_int_equal(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);
  shared->nap_us = 5000;
  for (int workers = 1; workers <= 4; workers++) {
    shared->done = 0;
    pid_t child = fork();
    if (child == 0) {
      um_core_progress_set_sink(context, die_when_told, NULL);
      struct um_batch *batch = opened(workers, true);
      _exit(um_batch_run(context, batch, x, NPOINT, value, reason) == UM_OK ? 0 : 1);
    }
    while (waitpid(-1, NULL, 0) > 0) continue;
    size_t n = read_recorded(recorded);
    assert_true(shared->done > 0);
    assert_true(n >= before + shared->done);
    before = n;
  }
  assert_int_equal(prctl(PR_SET_CHILD_SUBREAPER, 0), 0);
  free(value);
}

/* A worker in the middle of a long point dies with its parent, which tells it nothing. */
static void test_orphan(void **state)
{
  (void)state;
  double x[4] = {SLEEPS, 0, SLEEPS + 1, 0}, value[2 * NVALUE], until = now() + 5.0;
  char *reason[2];
  int left = 3; /* the parent and two workers */
  assert_int_equal(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);
  pid_t child = fork();
  if (child == 0) {
    struct um_batch *batch = opened(2, false);
    _exit(um_batch_run(context, batch, x, 2, value, reason) == UM_OK ? 0 : 1);
  }
  while ((shared->started[0] == 0 || shared->started[1] == 0) && now() < until) nap(1e-3);
  kill(child, SIGKILL);
  for (until = now() + 5.0; left > 0 && now() < until;) {
    if (waitpid(-1, NULL, WNOHANG) > 0)
      left--;
    else
      nap(1e-3);
  }
  for (int i = 0; i < 2 && left > 0; i++) kill(shared->process[i], SIGKILL);
  while (waitpid(-1, NULL, 0) > 0) continue;
  assert_int_equal(prctl(PR_SET_CHILD_SUBREAPER, 0), 0);
  assert_int_equal(left, 0);
}

int main(void)
{
#define TEST(f) cmocka_unit_test_setup_teardown(f, setup, teardown)
  static const struct CMUnitTest tests[] = {
      TEST(test_same),    TEST(test_death), TEST(test_silent), TEST(test_leader_stopped),
      TEST(test_refused), TEST(test_end),   TEST(test_stop),   TEST(test_full),
      TEST(test_kill),    TEST(test_told),  TEST(test_orphan)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
