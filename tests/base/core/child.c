/* Work in a child: what it says comes back whole, and however it ends, it has ended. */
#include "base/core/child.h"

#include <errno.h>
#include <math.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "base/core/sort.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

static const struct um_core_child_limits limits = {20.0, 512};

static double now(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void expect_no_child(void)
{
  assert_int_equal(waitpid(-1, NULL, WNOHANG), -1);
  assert_int_equal(errno, ECHILD);
}

/* `size` bytes that tell their place, from beyond what a pipe holds. */
static int speak(void *self, int pipe_end)
{
  size_t size = *(const size_t *)self;
  char *text = malloc(size);
  if (text == NULL || pipe_end <= STDERR_FILENO) return 1;
  for (size_t i = 0; i < size; i++) text[i] = (char)(i % 251);
  return um_core_child_write(pipe_end, text, size) ? 7 : 1;
}

static void test_answer(void **state)
{
  (void)state;
  static const size_t sizes[] = {0, 1, 65535, 65536, 3000001};
  for (size_t s = 0; s < sizeof sizes / sizeof sizes[0]; s++) {
    struct um_core_child_result r;
    size_t size = sizes[s];
    assert_int_equal(um_core_child_run(context, "test", speak, &size, &limits, &r), UM_OK);
    assert_int_equal(r.end, UM_CHILD_EXITED);
    assert_int_equal(r.code, 7);
    assert_int_equal(r.count, size);
    for (size_t i = 0; i < size; i++)
      if (r.answer[i] != (char)(i % 251)) fail_msg("byte %zu of %zu", i, size);
    um_core_free(context, r.answer);
    expect_no_child();
  }
}

/* With 0, 1 and 2 closed the pipe still lies above them: nothing that is printed gets into it. */
static void test_closed_streams(void **state)
{
  (void)state;
  pid_t child = fork();
  assert_true(child >= 0);
  if (child == 0) {
    struct um_core_child_result r;
    size_t size = 70000;
    for (int fd = 0; fd < 3; fd++) close(fd);
    enum um_status status = um_core_child_run(context, "test", speak, &size, &limits, &r);
    _exit(status == UM_OK && r.code == 7 && r.count == size ? 0 : 1);
  }
  int code;
  assert_int_equal(waitpid(child, &code, 0), child);
  assert_int_equal(code, 0);
}

static int crash(void *self, int pipe_end)
{
  (void)self;
  (void)pipe_end;
  signal(SIGSEGV, SIG_DFL); /* a sanitizer has one of its own */
  raise(SIGSEGV);
  return 0;
}

static int sleep_long(void *self, int pipe_end)
{
  (void)self;
  close(pipe_end); /* silent, as a program that an exec started */
  sleep(1000);
  return 0;
}

static int work_long(void *self, int pipe_end)
{
  (void)self;
  (void)pipe_end;
  while (getpid() > 0) continue;
  return 0;
}

static void test_ends(void **state)
{
  (void)state;
  static const um_core_child_work work[] = {sleep_long, work_long};
  struct um_core_child_limits short_limits = {0.3, SIZE_MAX};
  struct um_core_child_result r;
  assert_int_equal(um_core_child_run(context, "test", crash, NULL, &limits, &r), UM_OK);
  assert_int_equal(r.end, UM_CHILD_SIGNALLED);
  assert_int_equal(r.code, SIGSEGV);
  um_core_free(context, r.answer);
  for (int i = 0; i < 2; i++) {
    double begin = now();
    assert_int_equal(um_core_child_run(context, "test", work[i], NULL, &short_limits, &r), UM_OK);
    assert_int_equal(r.end, UM_CHILD_TIMED_OUT);
    assert_true(now() - begin < 20.0);
    um_core_free(context, r.answer);
    expect_no_child();
  }
}

static double stop_at;
static atomic_int asked;
static bool stop(void *self)
{
  (void)self;
  asked++;
  return now() > stop_at;
}

static void test_stop(void **state)
{
  (void)state;
  static const um_core_child_work work[] = {sleep_long, work_long};
  um_core_context_set_stop(context, stop, NULL);
  for (int i = 0; i < 2; i++) {
    struct um_core_child_result r;
    stop_at = now() + 0.3;
    um_core_message_clear(context);
    assert_int_equal(um_core_child_run(context, "gnuplot", work[i], NULL, &limits, &r),
                     UM_ERR_CANCELLED);
    assert_string_equal(um_core_message(context), "cancelled while gnuplot worked");
    assert_true(now() - stop_at < 20.0);
    assert_null(r.answer);
    expect_no_child();
  }
  um_core_context_set_stop(context, NULL, NULL);
}

struct item {
  unsigned key, place;
};
static int by_key(const void *a, const void *b)
{
  const struct item *x = a, *y = b;
  return (x->key > y->key) - (x->key < y->key);
}

/* Longer than a run of the merge, not of whole runs, with many equal keys that keep their order. */
static void test_sort(void **state)
{
  (void)state;
  static const size_t counts[] = {0, 1, 1000, 131072, 131073, 500000};
  for (size_t c = 0; c < sizeof counts / sizeof counts[0]; c++) {
    size_t n = counts[c];
    struct item *item = calloc(n + 1, sizeof *item);
    assert_non_null(item);
    for (size_t i = 0; i < n; i++)
      item[i] = (struct item){(unsigned)(i * 2654435761u) % 1000u, (unsigned)i};
    assert_int_equal(um_core_sort(context, item, n, sizeof *item, by_key), UM_OK);
    for (size_t i = 1; i < n; i++)
      if (item[i].key < item[i - 1].key ||
          (item[i].key == item[i - 1].key && item[i].place < item[i - 1].place))
        fail_msg("%zu items: %zu and %zu are out of order", n, i - 1, i);
    free(item);
  }
  struct item *item = calloc(300000, sizeof *item);
  assert_non_null(item);
  um_core_context_set_stop(context, stop, NULL);
  stop_at = 0.0;
  um_core_message_clear(context);
  assert_int_equal(um_core_sort(context, item, 300000, sizeof *item, by_key), UM_ERR_CANCELLED);
  um_core_context_set_stop(context, NULL, NULL);
  free(item);
}

/* A lock that another thread holds while it computes, as those below Embree do. */
struct holder {
  pthread_mutex_t lock;
  atomic_bool holds;
  int pipe[2];
};

static void *hold(void *self)
{
  struct holder *holder = self;
  char byte;
  pthread_mutex_lock(&holder->lock);
  atomic_store(&holder->holds, true);
  for (double until = now() + 0.1; now() < until;) continue;
  pthread_mutex_unlock(&holder->lock);
  return read(holder->pipe[0], &byte, 1) == 1 ? self : NULL; /* sleeps */
}

/* Who forks while that thread runs gives its child a lock that nobody opens. */
static void test_settle(void **state)
{
  (void)state;
  pthread_t thread;
  int status = 0;
  struct holder holder = {.lock = PTHREAD_MUTEX_INITIALIZER};
  assert_int_equal(pipe(holder.pipe), 0);
  assert_int_equal(pthread_create(&thread, NULL, hold, &holder), 0);
  while (!atomic_load(&holder.holds)) continue;
  um_core_child_settle(20.0);
  pid_t child = fork();
  if (child == 0) _exit(pthread_mutex_trylock(&holder.lock) == 0 ? 0 : 1);
  assert_int_equal(waitpid(child, &status, 0), child);
  assert_true(WIFEXITED(status));
  assert_int_equal(WEXITSTATUS(status), 0);
  assert_int_equal(write(holder.pipe[1], "x", 1), 1);
  assert_int_equal(pthread_join(thread, NULL), 0);
  close(holder.pipe[0]);
  close(holder.pipe[1]);
}

/* Progress without a sink hears a stop too, and says what was done. */
static void test_progress_stops(void **state)
{
  (void)state;
  um_core_context_set_stop(context, stop, NULL);
  stop_at = INFINITY;
  um_core_message_clear(context);
  um_core_progress_begin(context, "tracing", 10);
  assert_int_equal(um_core_progress_step(context, 1), UM_OK);
  assert_false(um_core_stopped(context));
  stop_at = 0.0;
  assert_true(um_core_stopped(context));
  assert_int_equal(um_core_progress_step(context, 1), UM_ERR_CANCELLED);
  assert_string_equal(um_core_message(context), "cancelled while tracing");
  um_core_progress_end(context);
  um_core_context_set_stop(context, NULL, NULL);
  assert_int_equal(um_core_stop_check(NULL, "x"), UM_OK);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_answer),        cmocka_unit_test(test_closed_streams),
      cmocka_unit_test(test_ends),          cmocka_unit_test(test_stop),
      cmocka_unit_test(test_settle),        cmocka_unit_test(test_sort),
      cmocka_unit_test(test_progress_stops)};
  return cmocka_run_group_tests_name("child", tests, context_set_up, context_tear_down);
}
