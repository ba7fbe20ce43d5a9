/* Worker processes: forked, given points, listened to, replaced when they die. */
#include "base/batch/crew_impl.h"

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

#include "base/batch/worker_impl.h"
#include "base/core/child.h"

#define STILLBORN_MOST 20
#define SETTLE         0.1 /* longest wait for other threads to sleep before a fork [s] */
#define LOOKS          30  /* at the processor clock of a worker before it counts as silent */

struct worker {
  pid_t process;            /* 0: none */
  int end;                  /* socket to it; -1: none */
  bool busy;                /* has a point */
  double processor, silent; /* its processor clock when last looked at, and how long it stood [s] */
  size_t number;            /* that point's */
  size_t got;               /* bytes of its answer so far */
  char *answer;             /* [room] */
};

struct um_batch_crew {
  const struct um_batch_task *task;
  void (*before)(void *self);
  void *before_self;
  size_t n, room,
      stillborn; /* stillborn: workers that died without a point since the last answer */
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
static void leave_others(struct um_batch_crew *crew)
{
  for (size_t i = 0; i < crew->n; i++)
    if (crew->worker[i].end >= 0) close(crew->worker[i].end);
  if (crew->before != NULL) crew->before(crew->before_self);
}

static enum um_status hire(struct um_context *context, struct um_batch_crew *crew, struct worker *w)
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
    leave_others(crew);
    um_batch_worker_live(context, crew->task, ends[1], parent);
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

enum um_status um_batch_crew_create(struct um_context *context, const struct um_batch_task *task,
                                    void (*before)(void *self), void *before_self,
                                    struct um_batch_crew **out)
{
  enum um_status status;
  struct um_batch_crew *crew;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *crew, &crew));
  crew->task = task;
  crew->before = before;
  crew->before_self = before_self;
  crew->silence = task->silence > 0.0 ? task->silence : UM_BATCH_SILENCE;
  crew->looked = read_clock(CLOCK_MONOTONIC);
  size_t n = task->workers < 1 ? 1 : (size_t)task->workers, values = task->nvalue * sizeof(double);
  crew->room = sizeof(struct um_batch_worker_head) +
               (values > UM_BATCH_REASON_LONGEST ? values : UM_BATCH_REASON_LONGEST) + 1;
  UM_CHECK(um_core_allocate(context, n, sizeof *crew->worker, &crew->worker));
  UM_CHECK(um_core_allocate(context, n, sizeof *crew->wait, &crew->wait));
  for (; crew->n < n; crew->n++) {
    crew->worker[crew->n].end = -1;
    UM_CHECK(um_core_allocate(context, crew->room, 1, &crew->worker[crew->n].answer));
  }
  for (size_t i = 0; i < n; i++) UM_CHECK(hire(context, crew, &crew->worker[i]));
  *out = crew;
  crew = NULL;
done:
  um_batch_crew_destroy(context, &crew);
  return status;
}

size_t um_batch_crew_size(const struct um_batch_crew *crew) { return crew->n; }

size_t um_batch_crew_idle(const struct um_batch_crew *crew)
{
  size_t idle = 0;
  for (size_t i = 0; i < crew->n; i++) idle += crew->worker[i].busy ? 0 : 1;
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

void um_batch_crew_give(struct um_batch_crew *crew, size_t number, const double *coordinate)
{
  struct worker *w = crew->worker;
  while (w->busy) w++;
  uint64_t told = number;
  w->busy = true;
  w->silent = 0.0;
  w->number = number;
  w->got = 0;
  send_all(w->end, &told, sizeof told);
  send_all(w->end, coordinate, crew->task->ncoordinate * sizeof *coordinate);
}

/* A worker that is gone, or silent, is buried and replaced; a point that it had is answered for. */
static enum um_status bury(struct um_context *context, struct um_batch_crew *crew, struct worker *w,
                           um_batch_answered *answered, void *self)
{
  int state = 0;
  char reason[96];
  close(w->end);
  w->end = -1;
  um_core_child_end(w->process, &state); /* it may have closed its end only */
  w->process = 0;
  if (!(w->silent < crew->silence))
    snprintf(reason, sizeof reason, "stopped or stuck: it did nothing for %g s", crew->silence);
  else if (WIFSIGNALED(state))
    snprintf(reason, sizeof reason, "signal %d, %s", WTERMSIG(state), strsignal(WTERMSIG(state)));
  else
    snprintf(reason, sizeof reason, "exit code %d", WEXITSTATUS(state));
  struct um_batch_answer answer = {.number = w->number, .died = true, .reason = reason};
  bool had_point = w->busy;
  crew->stillborn = had_point ? 0 : crew->stillborn + 1;
  if (crew->stillborn > STILLBORN_MOST)
    return um_core_fail(context, UM_ERR_LIBRARY, "worker processes die without work: %s", reason);
  UM_TRY(hire(context, crew, w));
  return had_point ? answered(context, self, &answer) : UM_OK;
}

/* Bytes of a whole answer, as far as its head tells. */
static size_t wanted(const struct um_batch_crew *crew, const struct worker *w)
{
  struct um_batch_worker_head head;
  if (w->got < sizeof head) return sizeof head;
  memcpy(&head, w->answer, sizeof head);
  return sizeof head + (head.reason > 0 ? head.reason : crew->task->nvalue * sizeof(double));
}

/* What a worker has written so far; *gone: it is dead. */
static void listen_to(const struct um_batch_crew *crew, struct worker *w, bool *gone)
{
  for (size_t want; w->got < (want = wanted(crew, w));) {
    ssize_t n = want > crew->room ? 0 : read(w->end, w->answer + w->got, want - w->got);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && errno == EAGAIN) return;
    if (n <= 0) {
      *gone = true;
      return;
    }
    w->got += (size_t)n;
  }
}

static enum um_status hear(struct um_context *context, struct um_batch_crew *crew, struct worker *w,
                           um_batch_answered *answered, void *self)
{
  bool gone = false;
  listen_to(crew, w, &gone);
  if (gone) return bury(context, crew, w, answered, self);
  if (!w->busy || w->got < wanted(crew, w)) return UM_OK;
  struct um_batch_worker_head head;
  memcpy(&head, w->answer, sizeof head);
  w->answer[w->got] = '\0';
  w->busy = false;
  w->got = 0;
  /* the head is 16 bytes of memory that malloc aligned: values behind it are aligned, too */
  const void *behind = w->answer + sizeof head;
  struct um_batch_answer answer = {.number = w->number, .status = (enum um_status)head.status};
  if (head.reason > 0)
    answer.reason = behind;
  else
    answer.value = behind;
  return answered(context, self, &answer);
}

/* Time counts by looks: that in which this process was stopped itself is no silence of others. */
static enum um_status look_for_silence(struct um_context *context, struct um_batch_crew *crew,
                                       um_batch_answered *answered, void *self)
{
  double t = read_clock(CLOCK_MONOTONIC), gap = crew->silence / LOOKS;
  double passed = fmin(t - crew->looked, 2.0 * gap);
  if (passed < gap) return UM_OK;
  crew->looked = t;
  for (size_t i = 0; i < crew->n; i++) {
    struct worker *w = &crew->worker[i];
    clockid_t clock;
    double processor = clock_getcpuclockid(w->process, &clock) == 0 ? read_clock(clock) : NAN;
    w->silent = w->busy && processor == w->processor ? w->silent + passed : 0.0;
    w->processor = processor;
    if (!(w->silent < crew->silence)) UM_TRY(bury(context, crew, w, answered, self));
  }
  return UM_OK;
}

enum um_status um_batch_crew_wait(struct um_context *context, struct um_batch_crew *crew,
                                  double seconds, um_batch_answered *answered, void *self)
{
  for (size_t i = 0; i < crew->n; i++)
    crew->wait[i] = (struct pollfd){.fd = crew->worker[i].end, .events = POLLIN};
  int ready = poll(crew->wait, (nfds_t)crew->n, (int)(1e3 * seconds));
  for (size_t i = 0; ready > 0 && i < crew->n; i++)
    if (crew->wait[i].revents != 0) UM_TRY(hear(context, crew, &crew->worker[i], answered, self));
  return look_for_silence(context, crew, answered, self);
}

void um_batch_crew_destroy(struct um_context *context, struct um_batch_crew **crew)
{
  if (crew == NULL || *crew == NULL) return;
  struct um_batch_crew *c = *crew;
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
  *crew = NULL;
}
