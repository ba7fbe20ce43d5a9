/* Worker processes: forked, given points, listened to, replaced when they die. */
#include "base/workers/pool.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "base/core/child.h"
#include "base/workers/worker_impl.h"

#define FAILED_AT_START_MOST 20
#define SETTLE               0.1 /* longest wait for other threads to sleep before a fork [s] */
#define LOOKS                30  /* at the processor clock of a worker before it counts as silent */

struct worker {
  pid_t process;            /* 0: none */
  int end;                  /* socket to it; -1: none */
  bool busy;                /* has a point */
  double processor, silent; /* its processor clock when last looked at, and how long it stood [s] */
  size_t number;            /* that point's */
  size_t got;               /* bytes of its answer so far */
  char *answer;             /* [room] */
};

struct um_workers_pool {
  const struct um_workers_task *task;
  void (*before)(void *self);
  void *before_self;
  size_t n, room, failed_at_start; /* failed_at_start: workers that died without a point since the
                                      last answer */
  struct worker *worker;
  struct pollfd *wait;    /* [n] */
  double silence, looked; /* longest, and when it was last looked for [s] */
};

static double read_clock(clockid_t clock)
{
  struct timespec t;
  return clock_gettime(clock, &t) != 0 ? NAN : (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* In the child: only its own end stays open. */
static void leave_others(struct um_workers_pool *pool)
{
  for (size_t i = 0; i < pool->n; i++)
    if (pool->worker[i].end >= 0) close(pool->worker[i].end);
  if (pool->before != NULL) pool->before(pool->before_self);
}

static enum um_status hire(struct um_context *context, struct um_workers_pool *pool,
                           struct worker *w)
{
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0)
    return um_core_fail(context, UM_ERR_LIBRARY, "no socket to a worker process: %s",
                        strerror(errno));
  for (int i = 0; i < 2; i++) (void)fcntl(ends[i], F_SETFD, FD_CLOEXEC);
  pid_t parent = getpid();
  fflush(NULL);
  um_core_child_settle(SETTLE);
  pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    leave_others(pool);
    um_workers_worker_run(context, pool->task, ends[1], parent);
  }
  int why = errno;
  close(ends[1]);
  if (child < 0) {
    close(ends[0]);
    return um_core_fail(context, UM_ERR_LIBRARY, "no worker process: %s", strerror(why));
  }
  (void)fcntl(ends[0], F_SETFL, fcntl(ends[0], F_GETFL) | O_NONBLOCK);
  w->process = child;
  w->end = ends[0];
  w->busy = false;
  w->silent = 0.0;
  w->got = 0;
  return UM_OK;
}

enum um_status um_workers_pool_create(struct um_context *context,
                                      const struct um_workers_task *task,
                                      void (*before)(void *self), void *before_self,
                                      struct um_workers_pool **out)
{
  enum um_status status;
  struct um_workers_pool *pool;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *pool, &pool));
  pool->task = task;
  pool->before = before;
  pool->before_self = before_self;
  pool->silence = task->silence > 0.0 ? task->silence : UM_WORKERS_SILENCE;
  pool->looked = read_clock(CLOCK_MONOTONIC);
  size_t n = task->workers < 1 ? 1 : (size_t)task->workers, values = task->nvalue * sizeof(double);
  pool->room = sizeof(struct um_workers_answer_head) +
               (values > UM_WORKERS_REASON_LONGEST ? values : UM_WORKERS_REASON_LONGEST) + 1;
  UM_CHECK(um_core_allocate(context, n, sizeof *pool->worker, &pool->worker));
  UM_CHECK(um_core_allocate(context, n, sizeof *pool->wait, &pool->wait));
  for (; pool->n < n; pool->n++) {
    pool->worker[pool->n].end = -1;
    UM_CHECK(um_core_allocate(context, pool->room, 1, &pool->worker[pool->n].answer));
  }
  for (size_t i = 0; i < n; i++) UM_CHECK(hire(context, pool, &pool->worker[i]));
  *out = pool;
  pool = NULL;
done:
  um_workers_pool_destroy(context, &pool);
  return status;
}

size_t um_workers_pool_size(const struct um_workers_pool *pool) { return pool->n; }

size_t um_workers_pool_idle(const struct um_workers_pool *pool)
{
  size_t idle = 0;
  for (size_t i = 0; i < pool->n; i++) idle += pool->worker[i].busy ? 0 : 1;
  return idle;
}

/* A worker that cannot be written to is dead, which its reading end will tell. Coordinates are few:
 * they fit the socket of a worker that waits. */
static void send_all(int end, const void *data, size_t bytes)
{
  const char *at = data;
  while (bytes > 0) {
    ssize_t n = send(end, at, bytes, MSG_NOSIGNAL);
    struct pollfd wait = {.fd = end, .events = POLLOUT};
    if (n < 0 && errno == EAGAIN) (void)poll(&wait, 1, 50);
    if (n < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (n <= 0) return;
    at += n;
    bytes -= (size_t)n;
  }
}

void um_workers_pool_give(struct um_workers_pool *pool, size_t number, const double *coordinate)
{
  struct worker *w = pool->worker;
  while (w->busy) w++;
  uint64_t told = number;
  w->busy = true;
  w->silent = 0.0;
  w->number = number;
  w->got = 0;
  send_all(w->end, &told, sizeof told);
  send_all(w->end, coordinate, pool->task->ncoordinate * sizeof *coordinate);
}

/* A worker that is gone, or silent, is buried and replaced; a point that it had is answered for. */
static enum um_status bury(struct um_context *context, struct um_workers_pool *pool,
                           struct worker *w, um_workers_answered *answered, void *self)
{
  int state = 0;
  char reason[96];
  close(w->end);
  w->end = -1;
  um_core_child_end(w->process, &state); /* it may have closed its end only */
  w->process = 0;
  if (!(w->silent < pool->silence))
    snprintf(reason, sizeof reason, "stopped or stuck: it did nothing for %g s", pool->silence);
  else if (WIFSIGNALED(state))
    snprintf(reason, sizeof reason, "signal %d, %s", WTERMSIG(state), strsignal(WTERMSIG(state)));
  else
    snprintf(reason, sizeof reason, "exit code %d", WEXITSTATUS(state));
  struct um_workers_answer answer = {.number = w->number, .died = true, .reason = reason};
  bool had_point = w->busy;
  pool->failed_at_start = had_point ? 0 : pool->failed_at_start + 1;
  if (pool->failed_at_start > FAILED_AT_START_MOST)
    return um_core_fail(context, UM_ERR_LIBRARY, "worker processes die without work: %s", reason);
  UM_TRY(hire(context, pool, w));
  return had_point ? answered(context, self, &answer) : UM_OK;
}

/* Bytes of a whole answer, as far as its head tells. */
static size_t wanted(const struct um_workers_pool *pool, const struct worker *w)
{
  struct um_workers_answer_head head;
  if (w->got < sizeof head) return sizeof head;
  memcpy(&head, w->answer, sizeof head);
  return sizeof head + (head.reason > 0 ? head.reason : pool->task->nvalue * sizeof(double));
}

/* What a worker has written so far; *gone: it is dead. */
static void listen_to(const struct um_workers_pool *pool, struct worker *w, bool *gone)
{
  for (size_t want; w->got < (want = wanted(pool, w));) {
    ssize_t n = want > pool->room ? 0 : read(w->end, w->answer + w->got, want - w->got);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && errno == EAGAIN) return;
    if (n <= 0) {
      *gone = true;
      return;
    }
    w->got += (size_t)n;
  }
}

static enum um_status hear(struct um_context *context, struct um_workers_pool *pool,
                           struct worker *w, um_workers_answered *answered, void *self)
{
  bool gone = false;
  listen_to(pool, w, &gone);
  if (gone) return bury(context, pool, w, answered, self);
  if (!w->busy || w->got < wanted(pool, w)) return UM_OK;
  struct um_workers_answer_head head;
  memcpy(&head, w->answer, sizeof head);
  w->answer[w->got] = '\0';
  w->busy = false;
  w->got = 0;
  /* the head is 16 bytes of memory that malloc aligned: values behind it are aligned, too */
  const void *behind = w->answer + sizeof head;
  struct um_workers_answer answer = {.number = w->number, .status = (enum um_status)head.status};
  if (head.reason > 0)
    answer.reason = behind;
  else
    answer.value = behind;
  return answered(context, self, &answer);
}

/* Time counts by looks: that in which this process was stopped itself is no silence of others. */
static enum um_status look_for_silence(struct um_context *context, struct um_workers_pool *pool,
                                       um_workers_answered *answered, void *self)
{
  double t = read_clock(CLOCK_MONOTONIC), gap = pool->silence / LOOKS;
  double passed = fmin(t - pool->looked, 2.0 * gap);
  if (passed < gap) return UM_OK;
  pool->looked = t;
  for (size_t i = 0; i < pool->n; i++) {
    struct worker *w = &pool->worker[i];
    clockid_t clock;
    double processor = clock_getcpuclockid(w->process, &clock) == 0 ? read_clock(clock) : NAN;
    w->silent = w->busy && processor == w->processor ? w->silent + passed : 0.0;
    w->processor = processor;
    if (!(w->silent < pool->silence)) UM_TRY(bury(context, pool, w, answered, self));
  }
  return UM_OK;
}

enum um_status um_workers_pool_wait(struct um_context *context, struct um_workers_pool *pool,
                                    double seconds, um_workers_answered *answered, void *self)
{
  for (size_t i = 0; i < pool->n; i++)
    pool->wait[i] = (struct pollfd){.fd = pool->worker[i].end, .events = POLLIN};
  int ready = poll(pool->wait, (nfds_t)pool->n, (int)(1e3 * seconds));
  for (size_t i = 0; ready > 0 && i < pool->n; i++)
    if (pool->wait[i].revents != 0) UM_TRY(hear(context, pool, &pool->worker[i], answered, self));
  return look_for_silence(context, pool, answered, self);
}

void um_workers_pool_destroy(struct um_context *context, struct um_workers_pool **pool)
{
  if (pool == NULL || *pool == NULL) return;
  struct um_workers_pool *c = *pool;
  for (size_t i = 0; i < c->n; i++) {
    if (c->worker[i].process > 0) kill(c->worker[i].process, SIGKILL);
    if (c->worker[i].end >= 0) close(c->worker[i].end);
  }
  for (size_t i = 0; i < c->n; i++) {
    int state;
    if (c->worker[i].process > 0) um_core_child_end(c->worker[i].process, &state);
    um_core_free(context, c->worker[i].answer);
  }
  um_core_free(context, c->worker);
  um_core_free(context, c->wait);
  um_core_free(context, c);
  *pool = NULL;
}
