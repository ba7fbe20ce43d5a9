/* Ranks: messages between the leading process and those that serve it. */
#include "base/batch/ranks_impl.h"

#include <mpi.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/batch/launch_impl.h"
#include "base/batch/ranks_inbox_impl.h"

#define PULSES   12   /* signs of life of a rank in the time after which it counts as lost */
#define LOOK     2e-3 /* between two looks at the messages of a rank that serves [s] */
#define FAREWELL 2.0  /* longest wait for the others at the end [s] */
#define NOBODY   UINT64_MAX

enum tag { TAG_HELLO = 1, TAG_POINT, TAG_ANSWER, TAG_PULSE, TAG_STOP, TAG_BYE };

struct hello {
  uint64_t identity, ncoordinate, nvalue, workers;
};

/* Of an answer; values or a reason stand behind it. */
struct answer_head {
  uint64_t number; /* NOBODY: the rank's work has ended with `status` */
  int32_t status, died;
  uint64_t reason; /* [byte], 0: values */
};

struct peer {
  size_t workers, idle; /* of its processes */
  uint64_t *given;      /* [workers] its points, NOBODY where there is none */
  double heard;         /* when last [s] */
  bool lost;
};

struct um_batch_ranks {
  const struct um_batch_task *task;
  int rank, size;
  struct peer *peer; /* [size] on rank 0 */
  struct um_batch_inbox *inbox;
  char *buffer;   /* of one message that is sent */
  double silence; /* after which a rank counts as lost [s] */
  double pulse;   /* when last sent [s] */
  double looked;  /* when rank 0 last heard the others [s] */
  bool stopped;   /* rank 0 has said so */
};

/* One process joins once, however many batches it opens; it leaves at its end, unless some of the
 * others may never come. */
static bool joined, broken;

static double now(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void finalize(void)
{
  if (!broken) MPI_Finalize();
}

enum um_status um_batch_ranks_look(struct um_context *context, bool *several, size_t *rank)
{
  long r, n;
  (void)context;
  um_batch_launch_told(&r, &n);
  *several = r >= 0 && n != 1;
  *rank = *several ? (size_t)r : 0;
  return UM_OK;
}

/* Variables that a shell has kept, or that a launcher set which this MPI does not understand, make
 * a rank that nobody leads. */
static enum um_status check_place(struct um_context *context, const struct um_batch_ranks *ranks)
{
  long r, n;
  um_batch_launch_told(&r, &n);
  if (r == ranks->rank && (ranks->size > 1 || n <= 1)) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "the environment says that this is rank %ld of several, MPI says rank %d of "
                      "%d; accepted: a start by mpirun or srun of the MPI that Umbra was built "
                      "with, or no OMPI_COMM_WORLD_RANK, PMIX_RANK and PMI_RANK",
                      r, ranks->rank, ranks->size);
}

enum um_status um_batch_ranks_join(struct um_context *context, const struct um_batch_task *task,
                                   struct um_batch_ranks **out)
{
  enum um_status status = UM_OK;
  struct um_batch_ranks *ranks;
  int level;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *ranks, &ranks));
  ranks->task = task;
  ranks->silence = task->work.silence > 0.0 ? task->work.silence : UM_WORKERS_SILENCE;
  ranks->looked = now();
  if (!joined) {
    um_batch_launch_forget_stray();
    if (MPI_Init_thread(NULL, NULL, MPI_THREAD_FUNNELED, &level) != MPI_SUCCESS) {
      um_core_free(context, ranks);
      return um_core_fail(context, UM_ERR_LIBRARY, "MPI does not start");
    }
    joined = true;
    atexit(finalize);
  }
  MPI_Comm_rank(MPI_COMM_WORLD, &ranks->rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks->size);
  UM_CHECK(check_place(context, ranks));
  size_t values = task->work.nvalue * sizeof(double),
         point = (task->work.ncoordinate + 1) * sizeof(double);
  size_t longest = sizeof(struct answer_head) + 1 + point + UM_WORKERS_REASON_LONGEST + values;
  bool leads = ranks->rank == 0; /* it speaks with all others, they with it alone */
  UM_CHECK(um_core_allocate(context, (size_t)ranks->size, sizeof *ranks->peer, &ranks->peer));
  for (int r = 0; r < ranks->size; r++) ranks->peer[r].heard = now();
  UM_CHECK(um_core_allocate(context, longest, 1, &ranks->buffer));
  /* last: whoever has it can hear */
  UM_CHECK(um_batch_inbox_create(context, leads ? 1 : 0, leads ? ranks->size : 1, longest,
                                 &ranks->inbox));
  *out = ranks;
  return UM_OK;
done:
  broken = ranks->size > 1;
  um_batch_ranks_leave(context, &ranks);
  return status;
}

size_t um_batch_ranks_idle(const struct um_batch_ranks *ranks)
{
  size_t idle = 0;
  for (int r = 1; r < ranks->size; r++) idle += ranks->peer[r].lost ? 0 : ranks->peer[r].idle;
  return idle;
}

static void mark(struct peer *peer, uint64_t from, uint64_t to)
{
  for (size_t i = 0; i < peer->workers; i++)
    if (peer->given[i] == from) {
      peer->given[i] = to;
      return;
    }
}

void um_batch_ranks_give(struct um_batch_ranks *ranks, size_t number, const double *coordinate)
{
  int r = 1;
  while (ranks->peer[r].lost || ranks->peer[r].idle == 0) r++;
  uint64_t told = number;
  size_t n = ranks->task->work.ncoordinate * sizeof *coordinate;
  ranks->peer[r].idle--;
  mark(&ranks->peer[r], NOBODY, number);
  memcpy(ranks->buffer, &told, sizeof told);
  memcpy(ranks->buffer + sizeof told, coordinate, n);
  MPI_Send(ranks->buffer, (int)(sizeof told + n), MPI_BYTE, r, TAG_POINT, MPI_COMM_WORLD);
}

static enum um_status welcome(struct um_context *context, const struct um_batch_ranks *ranks,
                              const struct um_batch_message *message)
{
  struct hello h;
  struct peer *peer = &ranks->peer[message->from];
  memcpy(&h, message->data, sizeof h);
  if (h.identity != ranks->task->identity || h.ncoordinate != ranks->task->work.ncoordinate ||
      h.nvalue != ranks->task->work.nvalue)
    return um_core_fail(context, UM_ERR_INPUT,
                        "rank %d would compute something else: its files or its Umbra differ",
                        message->from);
  peer->workers = peer->idle = (size_t)h.workers;
  um_core_free(context, peer->given);
  UM_TRY(um_core_allocate(context, peer->workers, sizeof *peer->given, &peer->given));
  for (size_t i = 0; i < peer->workers; i++) peer->given[i] = NOBODY;
  return UM_OK;
}

static enum um_status hand_on(struct um_context *context, const struct um_batch_ranks *ranks,
                              const struct um_batch_message *message, um_workers_answered *answered,
                              void *self)
{
  struct answer_head head;
  struct peer *peer = &ranks->peer[message->from];
  memcpy(&head, message->data, sizeof head);
  const void *behind = message->data + sizeof head; /* aligned: the head is 24 bytes */
  if (head.number == NOBODY)
    return um_core_fail(context, (enum um_status)head.status, "rank %d: %s", message->from,
                        (const char *)behind);
  struct um_workers_answer answer = {
      .number = (size_t)head.number, .status = (enum um_status)head.status, .died = head.died != 0};
  if (head.reason > 0)
    answer.reason = behind;
  else
    answer.value = behind;
  mark(peer, head.number, NOBODY);
  peer->idle++;
  return answered(context, self, &answer);
}

/* A rank that is silent has lost its points; what it says later is not heard. */
static enum um_status lose(struct um_context *context, struct um_batch_ranks *ranks, int r,
                           um_workers_answered *answered, void *self)
{
  struct peer *peer = &ranks->peer[r];
  peer->lost = true;
  broken = true;
  um_core_log(context, UM_LOG_WARNING, "rank %d has not been heard of for %g s: it is left out", r,
              ranks->silence);
  for (size_t i = 0; i < peer->workers; i++) {
    struct um_workers_answer answer = {
        .number = (size_t)peer->given[i], .died = true, .reason = "its rank is silent"};
    if (peer->given[i] != NOBODY) UM_TRY(answered(context, self, &answer));
  }
  return UM_OK;
}

enum um_status um_batch_ranks_hear(struct um_context *context, struct um_batch_ranks *ranks,
                                   um_workers_answered *answered, void *self)
{
  struct um_batch_message message;
  /* time in which this process was stopped, or did something else, is no silence of others */
  double away = now() - ranks->looked - ranks->silence / PULSES;
  for (int r = 1; away > 0.0 && r < ranks->size; r++) ranks->peer[r].heard += away;
  ranks->looked = now();
  while (um_batch_inbox_take(ranks->inbox, &message)) {
    ranks->peer[message.from].heard = now();
    if (ranks->peer[message.from].lost) continue;
    if (message.tag == TAG_HELLO) UM_TRY(welcome(context, ranks, &message));
    if (message.tag == TAG_ANSWER) UM_TRY(hand_on(context, ranks, &message, answered, self));
  }
  for (int r = 1; r < ranks->size; r++)
    if (!ranks->peer[r].lost && now() - ranks->peer[r].heard > ranks->silence)
      UM_TRY(lose(context, ranks, r, answered, self));
  return UM_OK;
}

static void send_answer(struct um_batch_ranks *ranks, uint64_t number,
                        const struct um_workers_answer *answer)
{
  struct answer_head head = {number, (int32_t)answer->status, answer->died, 0};
  size_t bytes = ranks->task->work.nvalue * sizeof *answer->value;
  if (answer->reason != NULL)
    head.reason = bytes = strnlen(answer->reason, UM_WORKERS_REASON_LONGEST);
  memcpy(ranks->buffer, &head, sizeof head);
  if (bytes > 0)
    memcpy(ranks->buffer + sizeof head,
           answer->reason == NULL ? (const void *)answer->value : answer->reason, bytes);
  MPI_Send(ranks->buffer, (int)(sizeof head + bytes), MPI_BYTE, 0, TAG_ANSWER, MPI_COMM_WORLD);
}

static enum um_status pass_on(struct um_context *context, void *self,
                              const struct um_workers_answer *answer)
{
  (void)context;
  send_answer(self, answer->number, answer);
  return UM_OK;
}

/* What rank 0 says. */
static void obey(struct um_batch_ranks *ranks, struct um_workers_pool *pool)
{
  struct um_batch_message message;
  while (!ranks->stopped && um_batch_inbox_take(ranks->inbox, &message)) {
    ranks->stopped = message.tag == TAG_STOP;
    if (message.tag != TAG_POINT) continue;
    uint64_t number;
    memcpy(&number, message.data, sizeof number);
    /* the number is as long as a coordinate: what stands behind it is aligned */
    const void *coordinate = message.data + sizeof number;
    um_workers_pool_give(pool, (size_t)number, coordinate);
  }
  if (now() - ranks->pulse < ranks->silence / PULSES) return;
  ranks->pulse = now();
  MPI_Send(NULL, 0, MPI_BYTE, 0, TAG_PULSE, MPI_COMM_WORLD);
}

enum um_status um_batch_ranks_serve(struct um_context *context, struct um_batch_ranks *ranks,
                                    struct um_workers_pool *pool)
{
  enum um_status status = UM_OK;
  struct hello hello = {ranks->task->identity, ranks->task->work.ncoordinate,
                        ranks->task->work.nvalue, um_workers_pool_size(pool)};
  MPI_Send(&hello, (int)sizeof hello, MPI_BYTE, 0, TAG_HELLO, MPI_COMM_WORLD);
  while (status == UM_OK && !ranks->stopped) {
    obey(ranks, pool);
    if (ranks->stopped) break;
    status = um_workers_pool_wait(context, pool, LOOK, pass_on, ranks);
    if (status == UM_OK) status = um_core_stop_check(context, "serving a batch");
  }
  broken = broken || status == UM_ERR_CANCELLED; /* rank 0 may be gone, too */
  if (status == UM_OK) MPI_Send(NULL, 0, MPI_BYTE, 0, TAG_BYE, MPI_COMM_WORLD);
  if (status != UM_OK && status != UM_ERR_CANCELLED) {
    struct um_workers_answer answer = {.status = status, .reason = um_core_message(context)};
    send_answer(ranks, NOBODY, &answer);
  }
  return status;
}

/* Rank 0: every other one is told, and what they still say is taken, so that none waits. */
static void dismiss(struct um_context *context, struct um_batch_ranks *ranks)
{
  struct um_batch_message message;
  int left = 0;
  for (int r = 1; r < ranks->size; r++) {
    MPI_Request request;
    if (ranks->peer[r].lost) continue;
    MPI_Isend(NULL, 0, MPI_BYTE, r, TAG_STOP, MPI_COMM_WORLD, &request);
    MPI_Request_free(&request);
    left++;
  }
  for (double end = now() + FAREWELL; left > 0 && now() < end && !um_core_stopped(context);) {
    if (!um_batch_inbox_take(ranks->inbox, &message)) {
      nanosleep(&(struct timespec){0, 1000000}, NULL);
      continue;
    }
    struct answer_head head = {0};
    if (ranks->peer[message.from].lost) continue;
    if (message.tag == TAG_ANSWER) memcpy(&head, message.data, sizeof head);
    if (message.tag == TAG_BYE || (message.tag == TAG_ANSWER && head.number == NOBODY)) left--;
  }
  broken = broken || left > 0;
}

void um_batch_ranks_leave(struct um_context *context, struct um_batch_ranks **ranks)
{
  if (ranks == NULL || *ranks == NULL) return;
  struct um_batch_ranks *r = *ranks;
  if (r->rank == 0 && r->inbox != NULL) dismiss(context, r);
  for (int i = 0; r->peer != NULL && i < r->size; i++) um_core_free(context, r->peer[i].given);
  um_batch_inbox_destroy(context, &r->inbox);
  um_core_free(context, r->peer);
  um_core_free(context, r->buffer);
  um_core_free(context, r);
  *ranks = NULL;
}
