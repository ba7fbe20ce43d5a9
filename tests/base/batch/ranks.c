/* Ranks under mpirun: the same bytes as alone, and records that outlive a dead rank. This program
 * is both: the test, and what mpirun starts ("work FOLDER WORKERS OUT MODE"). */
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "base/batch/batch.h"
#include "base/batch/records.h"
#include "base/core/file.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"

#define NPOINT 80
#define NVALUE 5000 /* 40 kB: more than MPI sends at once */

static struct um_context *context;
static char folder[UM_TEST_PATH], records[UM_TEST_PATH + 32];

static int setup(void **state)
{
  (void)state;
  if (um_test_folder_create(folder) != 0) return -1;
  snprintf(records, sizeof records, "%s/records", folder);
  return um_core_context_create(NULL, &context) == UM_OK ? 0 : -1;
}
static int teardown(void **state)
{
  (void)state;
  static const char *const names[] = {"alone", "ranks", "said"};
  um_batch_records_remove(context, records);
  um_core_context_destroy(&context);
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    char path[UM_TEST_PATH + 32];
    snprintf(path, sizeof path, "%s/%s", folder, names[i]);
    (void)unlink(path);
  }
  return rmdir(folder);
}

/* Modes of work. */
enum { PLAIN, RESUME, DEAD_RANK, REFUSED, OTHER_TASK, SILENT_RANK };

static int my_rank(void)
{
  const char *rank = getenv("OMPI_COMM_WORLD_RANK");
  return rank == NULL ? 0 : (int)strtol(rank, NULL, 10);
}

static enum um_status waves(struct um_context *c, void *user, const double *x, double *value)
{
  int mode = *(const int *)user;
  nanosleep(&(struct timespec){0, 3000000}, NULL);
  if (mode == DEAD_RANK && my_rank() == 1 && x[0] > 20.0) kill(getppid(), SIGKILL);
  if (mode == SILENT_RANK && my_rank() == 1 && x[0] > 20.0) kill(getppid(), SIGSTOP);
  if (mode == REFUSED && x[0] == 40.0) return um_core_fail(c, UM_ERR_REFUSED, "not 40");
  for (size_t k = 0; k < NVALUE; k++) value[k] = cos((double)k * x[0]);
  return UM_OK;
}

static int work(char **argument)
{
  int mode = (int)strtol(argument[3], NULL, 10);
  double x[NPOINT], *value = calloc(NPOINT * NVALUE, sizeof *value);
  char *reason[NPOINT];
  struct um_batch *batch = NULL;
  for (size_t i = 0; i < NPOINT; i++) x[i] = (double)i;
  if (value == NULL || um_core_context_create(NULL, &context) != UM_OK) return 1;
  struct um_batch_task task = {.identity = mode == OTHER_TASK ? (uint64_t)my_rank() : 1,
                               .work.ncoordinate = 1,
                               .work.nvalue = NVALUE,
                               .work.compute = waves,
                               .work.user = &mode,
                               .folder = argument[0],
                               .resume = mode == RESUME,
                               .work.silence = mode == SILENT_RANK ? 1.0 : 0.0,
                               .work.workers = (int)strtol(argument[1], NULL, 10)};
  enum um_status status = um_batch_open(context, &task, &batch);
  if (status == UM_OK && !um_batch_leads(batch)) {
    status = um_batch_serve(context, batch);
  } else if (status == UM_OK) {
    /* in three calls, as a surrogate asks */
    for (size_t n = NPOINT / 4; status == UM_OK && n <= NPOINT; n *= 2) {
      status = um_batch_run(context, batch, x, n, value, reason);
      for (size_t i = 0; status == UM_OK && i < n; i++) {
        if (reason[i] != NULL) fprintf(stderr, "%g: %s\n", x[i], reason[i]);
        um_core_free(context, reason[i]);
      }
    }
    FILE *out = status == UM_OK ? fopen(argument[2], "wb") : NULL;
    if (out != NULL) {
      fwrite(value, sizeof *value, NPOINT * NVALUE, out);
      fclose(out);
    }
  }
  fputs(um_core_log_text(context), stderr);
  if (status != UM_OK) fprintf(stderr, "rank %d: %s\n", my_rank(), um_core_message(context));
  um_batch_close(context, &batch);
  um_core_context_destroy(&context);
  free(value);
  return status == UM_OK ? 0 : 1;
}

/* Variables of a launcher that is not there, for the next process without mpirun. */
static const char *stray[2][2];

/* Run this program on `ranks` processes (0: without mpirun); the exit code; what it says is in
 * "FOLDER/said". */
static int start(int ranks, int workers, const char *out, int mode)
{
  char count[16], workers_text[16], what[16], path[UM_TEST_PATH + 32], said[UM_TEST_PATH + 32],
      self[512];
  ssize_t n = readlink("/proc/self/exe", self, sizeof self - 1);
  assert_true(n > 0);
  self[n] = '\0';
  snprintf(count, sizeof count, "%d", ranks);
  snprintf(workers_text, sizeof workers_text, "%d", workers);
  snprintf(what, sizeof what, "%d", mode);
  snprintf(path, sizeof path, "%s/%s", folder, out);
  snprintf(said, sizeof said, "%s/said", folder);
  char *arguments[] = {(char *)UMBRA_MPIEXEC,
                       "--oversubscribe",
                       "--bind-to",
                       "none",
                       "-n",
                       count,
                       self,
                       "work",
                       records,
                       workers_text,
                       path,
                       what,
                       NULL};
  pid_t child = fork();
  assert_true(child >= 0);
  if (child == 0) {
    int fd = open(said, O_WRONLY | O_CREAT | O_TRUNC, 0666), null = open("/dev/null", O_RDONLY);
    dup2(null, 0); /* mpirun reads it */
    dup2(fd, 1);
    dup2(fd, 2);
    /* in a container as root, with one network card or none */
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    setenv("OMPI_MCA_btl", "self,vader", 1);
    setenv("OMPI_MCA_btl_vader_single_copy_mechanism", "none", 1);
    /* MPI leaks from plugins that are unloaded before the sanitizer looks: no name to suppress them
     * by. Leaks of ours are seen without mpirun. */
    if (ranks > 0 || stray[0][0] != NULL) setenv("ASAN_OPTIONS", "detect_leaks=0", 1);
    for (size_t i = 0; i < 2 && stray[i][0] != NULL; i++) setenv(stray[i][0], stray[i][1], 1);
    alarm(30); /* outlives the exec: nothing here waits for ever */
    execv(ranks == 0 ? self : UMBRA_MPIEXEC, ranks == 0 ? arguments + 6 : arguments);
    _exit(127);
  }
  int state;
  assert_int_equal(waitpid(child, &state, 0), child);
  return WIFEXITED(state) ? WEXITSTATUS(state) : -1;
}

/* Bytes of a file in the test's folder. */
static char *contents(const char *name, size_t *length)
{
  char path[UM_TEST_PATH + 32], *text;
  snprintf(path, sizeof path, "%s/%s", folder, name);
  if (um_core_file_read(context, path, (size_t)1 << 24, &text, length) != UM_OK)
    fail_msg("%s", um_core_message(context));
  return text;
}

static void expect_said(const char *words)
{
  size_t n;
  char *said = contents("said", &n);
  if (strstr(said, words) == NULL) fail_msg("'%s' is not in: %s", words, said);
  um_core_free(context, said);
}

static void expect_same(void)
{
  size_t n, m;
  char *alone = contents("alone", &n), *ranks = contents("ranks", &m);
  assert_int_equal(n, NPOINT * NVALUE * sizeof(double));
  assert_int_equal(m, n);
  assert_memory_equal(ranks, alone, n);
  um_core_free(context, alone);
  um_core_free(context, ranks);
}

static void run_alone(int mode)
{
  assert_int_equal(start(0, 1, "alone", mode), 0);
  um_batch_records_remove(context, records);
}

static void test_same(void **state)
{
  (void)state;
  static const struct {
    int ranks, workers;
  } cases[] = {{0, 2}, {1, 1}, {2, 1}, {2, 2}, {4, 1}};
  run_alone(PLAIN);
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    if (start(cases[i].ranks, cases[i].workers, "ranks", PLAIN) != 0) {
      size_t n;
      fail_msg("%d ranks, %d workers: %s", cases[i].ranks, cases[i].workers, contents("said", &n));
    }
    expect_same();
    um_batch_records_remove(context, records);
  }
}

static void test_refused(void **state)
{
  (void)state;
  run_alone(REFUSED);
  assert_int_equal(start(3, 1, "ranks", REFUSED), 0);
  expect_said("40: not 40");
  expect_same();
  /* all is on record: the others are told although there is nothing to do */
  um_batch_records_remove(context, records);
}

static void test_dead_rank(void **state)
{
  (void)state;
  run_alone(PLAIN);
  assert_int_not_equal(start(3, 1, "ranks", DEAD_RANK), 0);
  expect_said("rank 1");
  expect_said("signal 9");
  char path[UM_TEST_PATH + 64];
  struct stat st;
  snprintf(path, sizeof path, "%s/points.records", records);
  assert_int_equal(stat(path, &st), 0);
  assert_true(st.st_size > 15 * NVALUE * 8);
  assert_int_equal(start(2, 1, "ranks", RESUME), 0);
  expect_same();
  /* all on record now: the other rank is told, although there is nothing to do */
  assert_int_equal(start(2, 1, "ranks", RESUME), 0);
  expect_same();
  /* and without --resume rank 0 refuses, and nobody waits */
  assert_int_not_equal(start(2, 1, "ranks", PLAIN), 0);
  expect_said("points are on record there");
}

/* A rank that is stopped is left out; mpirun ends it with the others. */
static void test_silent_rank(void **state)
{
  (void)state;
  run_alone(PLAIN);
  (void)start(3, 1, "ranks", SILENT_RANK);
  expect_said("rank 1 has not been heard of for 1 s: it is left out");
  expect_same();
}

static void test_other_task(void **state)
{
  (void)state;
  assert_int_not_equal(start(2, 1, "ranks", OTHER_TASK), 0);
  expect_said("rank 1 would compute something else");
}

/* Variables that a shell has kept: nobody leads this rank, and it does not wait for one. */
static void test_stray(void **state)
{
  (void)state;
  static const char *const cases[][2][2] = {
      {{"OMPI_COMM_WORLD_RANK", "1"}, {"OMPI_COMM_WORLD_SIZE", "2"}},
      {{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "2"}},
      {{"PMIX_RANK", "3"}, {"PMIX_NAMESPACE", "1234"}},
      {{"PMI_RANK", "1"}, {"SLURM_STEP_NUM_TASKS", "2"}}};
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    memcpy(stray, cases[i], sizeof stray);
    char says[96];
    snprintf(says, sizeof says, "this is rank %s of several, MPI says rank 0 of 1", stray[0][1]);
    int code = start(0, 1, "ranks", PLAIN);
    memset(stray, 0, sizeof stray);
    if (code != 1) fail_msg("%s=%s: exit %d", cases[i][0][0], cases[i][0][1], code);
    expect_said(says);
    um_batch_records_remove(context, records);
  }
  static const char *const first[2][2] = {{"PMIX_RANK", "0"}};
  memcpy(stray, first, sizeof stray);
  run_alone(PLAIN); /* the first of one, as a launcher that starts one says it */
  memset(stray, 0, sizeof stray);
}

int main(int argc, char **argv)
{
  if (argc == 6 && strcmp(argv[1], "work") == 0) return work(argv + 2);
#define TEST(f) cmocka_unit_test_setup_teardown(f, setup, teardown)
  static const struct CMUnitTest tests[] = {TEST(test_same),       TEST(test_refused),
                                            TEST(test_dead_rank),  TEST(test_silent_rank),
                                            TEST(test_other_task), TEST(test_stray)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
