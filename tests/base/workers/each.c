/* Tasks by number: the same answers from any number of processes, whatever fails or dies. */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include "base/workers/each.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

#define N    50
#define MOST 3

/* Seen by the processes, too. */
static struct shared {
  volatile int deaths; /* that task 7 has before it */
  volatile bool fatal; /* task 11 fails as no task may */
} * shared;

struct told {
  double value[N][MOST];
  enum um_status status[N];
  char message[N][80];
  size_t count, steps;
  size_t cancel_at; /* steps; 0: never */
};

/* Odd thirteens are refused; a task fills `which % MOST + 1` values. */
static enum um_status compute(struct um_context *of, void *user, size_t which, double *value)
{
  (void)user;
  if (which == 7 && shared->deaths > 0) {
    shared->deaths--;
    raise(SIGKILL);
  }
  if (which == 11 && shared->fatal) return um_core_fail(of, UM_ERR_MEMORY, "nothing left");
  if (which % 13 == 5) return um_core_fail(of, UM_ERR_REFUSED, "not %zu", which);
  for (size_t k = 0; k < which % MOST + 1; k++) value[k] = sin((double)(which + k));
  return UM_OK;
}

static enum um_status done(struct um_context *of, void *user, size_t which, enum um_status status,
                           const double *value)
{
  struct told *told = user;
  told->count++;
  told->status[which] = status;
  if (status == UM_OK) {
    memcpy(told->value[which], value, sizeof told->value[which]);
    return UM_OK;
  }
  assert_null(value);
  snprintf(told->message[which], sizeof told->message[which], "%s", um_core_message(of));
  if (status != UM_ERR_REFUSED) return status;
  um_core_message_clear(of);
  return UM_OK;
}

static bool progress(void *self, const char *task, size_t so_far, size_t total)
{
  struct told *told = self;
  (void)task, (void)total;
  told->steps = so_far;
  return told->cancel_at == 0 || so_far < told->cancel_at;
}

static enum um_status run(int workers, struct told *told)
{
  const struct um_workers_each each = {
      .n = N, .nvalue = MOST, .compute = compute, .done = done, .user = told, .workers = workers};
  um_core_message_clear(context);
  um_core_progress_set_sink(context, progress, told);
  um_core_progress_begin(context, "tasks", N);
  enum um_status status = um_workers_each(context, &each);
  um_core_progress_end(context);
  um_core_progress_set_sink(context, NULL, NULL);
  /* no process stays */
  assert_true(waitpid(-1, NULL, WNOHANG) == -1 && errno == ECHILD);
  return status;
}

static void any_number_gives_the_same(void **state)
{
  (void)state;
  static struct told alone, few, many;
  alone = few = many = (struct told){0};
  assert_int_equal(run(0, &alone), UM_OK);
  assert_int_equal(run(3, &few), UM_OK);
  assert_int_equal(run(200, &many), UM_OK);
  assert_int_equal(alone.count, N);
  assert_int_equal(few.steps, N);
  assert_int_equal(alone.status[5], UM_ERR_REFUSED);
  assert_string_equal(few.message[5], "not 5");
  assert_true(alone.value[4][1] == sin(5.0) && alone.value[4][2] == 0.0);
  assert_memory_equal(&alone, &few, sizeof alone);
  assert_memory_equal(&alone, &many, sizeof alone);
}

/* A worker that dies has its task done by another; a task that kills two ends the work. */
static void who_dies_is_replaced(void **state)
{
  (void)state;
  static struct told alone, told;
  alone = told = (struct told){0};
  assert_int_equal(run(1, &alone), UM_OK);
  shared->deaths = 1;
  assert_int_equal(run(2, &told), UM_OK);
  assert_int_equal(shared->deaths, 0);
  assert_memory_equal(&alone, &told, sizeof told);
  shared->deaths = 2;
  assert_int_equal(run(2, &told), UM_ERR_LIBRARY);
  assert_non_null(strstr(um_core_message(context), "died, twice (signal 9"));
}

static void errors_and_stops_end_the_work(void **state)
{
  (void)state;
  for (int workers = 1; workers < 4; workers += 2) {
    static struct told told;
    told = (struct told){0}; /* no stop: other workers may be past it before task 11 has answered */
    shared->fatal = true;
    assert_int_equal(run(workers, &told), UM_ERR_MEMORY);
    assert_string_equal(um_core_message(context), "nothing left");
    shared->fatal = false;
    told = (struct told){.cancel_at = 20};
    assert_int_equal(run(workers, &told), UM_ERR_CANCELLED);
    assert_true(told.count >= 20 && told.count < N);
  }
}

static int set_up(void **state)
{
  shared = mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return shared == MAP_FAILED ? -1 : context_set_up(state);
}

static int tear_down(void **state)
{
  munmap((void *)shared, sizeof *shared);
  return context_tear_down(state);
}

int main(void)
{
  static const struct CMUnitTest tests[] = {cmocka_unit_test(any_number_gives_the_same),
                                            cmocka_unit_test(who_dies_is_replaced),
                                            cmocka_unit_test(errors_and_stops_end_the_work)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
