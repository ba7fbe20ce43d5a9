/* Signatures of many candidates at once. Those that move heat go in groups: one run of heat's
 * tangent and one pass of light serve a group, in the worker that has it, and are gone with it. A
 * group does not depend on the number of workers. A worker sends back the candidate as it made it,
 * as bytes, and the columns; its pointers are the parent's own. */
#include "evidence/sensitivity/signatures_impl.h"

#include <stdio.h>
#include <string.h>

#include "evidence/sensitivity/moves_impl.h"
#include "evidence/sensitivity/policy.h"
#include "evidence/sensitivity/scan_impl.h"
#include "evidence/sensitivity/signature_impl.h"

#define HEAT_MOVES 64 /* moves in one run of heat */

/* Candidates that look for their heat together, or one candidate. */
struct task {
  size_t first, count; /* in work.order */
};
struct work {
  const struct um_sensitivity_point *point;
  struct um_sensitivity_candidate *candidate; /* [count] */
  bool *is_done;                              /* [count] */
  bool heat;         /* tasks are groups: a candidate whose heat is not found together is left */
  size_t *order;     /* [count] candidates as tasks take them */
  struct task *task; /* [ntask] */
  size_t ntask;
};

/* What goes before the columns. */
struct answer {
  struct um_sensitivity_candidate candidate;
  char why[1024]; /* of a refusal; "": none */
  bool left;      /* nothing was done */
};
#define ANSWER ((sizeof(struct answer) + sizeof(double) - 1) / sizeof(double)) /* [doubles] */

static size_t columns_of(const struct um_sensitivity_candidate *c)
{
  return c->is_switch ? 1 : c->effect->nparameter;
}

/* An effect may refuse a value. That is no error: its message is the reason. */
static enum um_status refused(struct um_context *context, enum um_status status,
                              struct answer *answer)
{
  if (status != UM_ERR_REFUSED && status != UM_ERR_NUMERIC) return status;
  answer->candidate.insensitive = true;
  snprintf(answer->why, sizeof answer->why, "%s", um_core_message(context));
  um_core_message_clear(context);
  return UM_OK;
}

static size_t room_of(const struct work *work, size_t which)
{
  return ANSWER + columns_of(&work->candidate[which]) * work->point->forward->observations.count;
}

static size_t moves_of(const struct work *work, const struct task *task,
                       struct um_sensitivity_move *move)
{
  size_t n = 0;
  for (size_t i = 0; i < task->count; i++)
    n += um_sensitivity_signature_moves(&work->candidate[work->order[task->first + i]], move + n);
  return n;
}

/* Heat of the first steps of a task's candidates. */
static enum um_status find_moves(struct um_context *context, const struct work *work,
                                 const struct task *task)
{
  struct um_sensitivity_move *move = NULL;
  UM_TRY(um_core_allocate(context, task->count, UM_EFFECT_PARAMETERS_MAX * sizeof *move, &move));
  size_t n = moves_of(work, task, move);
  enum um_status status =
      um_sensitivity_moves_find(context, work->point->forward, move, n,
                                work->point->derivatives ? 0.0 : UM_SENSITIVITY_HEAT_TOLERANCE);
  um_core_free(context, move);
  return status;
}

/* Is heat of any of a candidate's moves known? */
static bool found(const struct work *work, size_t which)
{
  struct um_sensitivity_move move[UM_EFFECT_PARAMETERS_MAX];
  size_t n = um_sensitivity_signature_moves(&work->candidate[which], move);
  for (size_t k = 0; k < n; k++)
    if (um_sensitivity_moves_of(work->point->forward->cache->moves, &move[k]) != NULL) return true;
  return false;
}

static enum um_status compute_one(struct um_context *context, const struct work *work, size_t which,
                                  double *value)
{
  struct answer answer = {.candidate = work->candidate[which]};
  enum um_status status = UM_OK;
  answer.candidate.signature = value + ANSWER;
  answer.left = work->heat && !found(work, which);
  if (!answer.candidate.insensitive && !answer.left)
    status = um_sensitivity_signature_make(context, work->point, &answer.candidate);
  if (status != UM_OK) status = refused(context, status, &answer);
  memcpy(value, &answer, sizeof answer);
  return status;
}

static enum um_status compute(struct um_context *context, void *user, size_t which, double *value)
{
  const struct work *work = user;
  const struct task *task = &work->task[which];
  enum um_status status = UM_OK;
  if (work->heat) UM_CHECK(find_moves(context, work, task));
  for (size_t i = 0; i < task->count; i++) {
    size_t of = work->order[task->first + i];
    UM_CHECK(compute_one(context, work, of, value));
    value += room_of(work, of);
  }
done:
  um_sensitivity_moves_clear(context, work->point->forward);
  return status;
}

/* Can this be an answer? A record is a file that anybody may have written. */
static bool is_sound(const struct answer *answer, size_t columns, size_t nparameter)
{
  const struct um_sensitivity_candidate *c = &answer->candidate;
  bool sound = c->ncolumn <= columns && c->nunidentified <= nparameter &&
               memchr(answer->why, '\0', sizeof answer->why) != NULL;
  for (size_t k = 0; sound && k < c->ncolumn; k++)
    sound = nparameter == 0 || c->parameter[k] < nparameter;
  for (size_t k = 0; sound && k < c->nunidentified; k++) sound = c->unidentified[k] < nparameter;
  return sound;
}

/* The candidate as the worker made it, but for what is the parent's own. */
static enum um_status take(struct um_context *context, const struct work *work, size_t which,
                           const double *value, bool *is_done)
{
  struct answer answer;
  struct um_sensitivity_candidate *c = &work->candidate[which];
  const struct um_sensitivity_candidate own = *c;
  size_t n = work->point->forward->observations.count, columns = columns_of(c);
  memcpy(&answer, value, sizeof answer);
  *is_done = !answer.left;
  if (answer.left) return UM_OK;
  if (!is_sound(&answer, columns, own.effect->nparameter))
    return um_core_fail(context, UM_ERR_IO, "%s: its signature on record is none", own.name);
  *c = answer.candidate;
  c->effect = own.effect;
  c->is_switch = own.is_switch;
  c->name = own.name;
  c->target = own.target;
  c->why = own.why;
  c->signature = NULL;
  if (answer.why[0] != '\0') UM_TRY(um_core_strdup(context, answer.why, &c->why));
  UM_TRY(um_core_allocate(context, columns * n, sizeof *c->signature, &c->signature));
  if (!c->insensitive) {
    memcpy(c->signature, value + ANSWER, columns * n * sizeof *c->signature);
    return UM_OK;
  }
  c->ncolumn = columns;
  for (size_t k = 0; k < columns; k++) c->parameter[k] = k;
  return UM_OK;
}

static enum um_status done(struct um_context *context, void *user, size_t which,
                           enum um_status status, const double *value)
{
  struct work *work = user;
  const struct task *task = &work->task[which];
  size_t ndone = 0;
  UM_TRY(status);
  for (size_t i = 0; i < task->count; i++) {
    size_t of = work->order[task->first + i], room = room_of(work, of);
    UM_TRY(take(context, work, of, value, &work->is_done[of]));
    value += room;
    ndone += work->is_done[of];
  }
  /* a task is a step, so that a group has one beside its candidates */
  return um_core_progress_step(context, work->heat ? ndone : 0);
}

/* What a candidate moves at the scenario: nothing that heat feels, the network, or the loads too.
 */
enum moved { MOVED_NONE, MOVED_NETWORK, MOVED_LOADS };

static enum um_status moved_by(struct um_context *context, const struct work *work, size_t which,
                               enum moved *out, size_t *nmove)
{
  struct um_sensitivity_move move[UM_EFFECT_PARAMETERS_MAX];
  bool loads = false;
  *nmove = um_sensitivity_signature_moves(&work->candidate[which], move);
  *out = MOVED_NONE;
  if (*nmove == 0 || !um_sensitivity_moves_heat(work->candidate[which].effect)) return UM_OK;
  for (size_t k = 0; k < *nmove && !loads; k++)
    UM_TRY(um_sensitivity_moves_loads(context, work->point->forward, &move[k], &loads));
  *out = loads ? MOVED_LOADS : MOVED_NETWORK;
  return UM_OK;
}

/* Candidates of a kind in groups of about `most` moves, in their order. *n: candidates so far. */
static void make_groups_of(struct work *work, const enum moved *moved, const size_t *nmove,
                           size_t count, enum moved kind, size_t most, size_t *n)
{
  size_t moves = most;
  for (size_t i = 0; i < count; i++) {
    if (moved[i] != kind) continue;
    if (moves + nmove[i] > most) {
      work->task[work->ntask++] = (struct task){.first = *n};
      moves = 0;
    }
    work->task[work->ntask - 1].count++;
    work->order[(*n)++] = i;
    moves += nmove[i];
  }
}

/* Groups of all candidates that may move heat. What moves the loads has a geometry of its own,
 * which is traced for heat and kept for light: so many are a group as may be open at once, so that
 * none is traced twice. One whose heat turns out to be none of the group's is left. */
static enum um_status make_groups(struct um_context *context, struct work *work, size_t count)
{
  enum um_status status;
  enum moved *moved = NULL;
  size_t *nmove = NULL, n = 0;
  UM_CHECK(um_core_allocate(context, count, sizeof *moved, &moved));
  UM_CHECK(um_core_allocate(context, count, sizeof *nmove, &nmove));
  for (size_t i = 0; i < count; i++) UM_CHECK(moved_by(context, work, i, &moved[i], &nmove[i]));
  make_groups_of(work, moved, nmove, count, MOVED_NETWORK, HEAT_MOVES, &n);
  make_groups_of(work, moved, nmove, count, MOVED_LOADS,
                 um_sensitivity_moves_open(work->point->forward, HEAT_MOVES), &n);
  work->heat = true;
done:
  UM_FREE(context, moved, nmove);
  return status;
}

/* Every candidate that is left is a task. */
static void make_singles(struct work *work, size_t count)
{
  work->ntask = 0;
  for (size_t i = 0; i < count; i++) {
    if (work->is_done[i]) continue;
    work->order[work->ntask] = i;
    work->task[work->ntask] = (struct task){work->ntask, 1};
    work->ntask++;
  }
  work->heat = false;
}

static enum um_status run_tasks(struct um_context *context, struct work *work)
{
  struct um_workers_each tasks = {.n = work->ntask,
                                  .compute = compute,
                                  .done = done,
                                  .user = work,
                                  .workers = um_core_context_threads(context)};
  for (size_t t = 0; t < work->ntask; t++) {
    size_t room = 0;
    for (size_t i = 0; i < work->task[t].count; i++)
      room += room_of(work, work->order[work->task[t].first + i]);
    if (tasks.nvalue < room) tasks.nvalue = room;
  }
  return um_sensitivity_forward_tasks(context, work->point->forward, &tasks);
}

enum um_status um_sensitivity_signatures_create(struct um_context *context,
                                                const struct um_sensitivity_point *point,
                                                struct um_sensitivity_candidate *candidate,
                                                size_t count)
{
  enum um_status status = UM_OK;
  struct um_sensitivity_forward *f = point->forward;
  struct um_model_result *base = NULL;
  struct work work = {.point = point, .candidate = candidate};
  bool possible = false;
  UM_TRY(um_variant_share(context, f->evaluator, UM_VARIANT_WARM, true));
  /* with additions the heat at hand is not the scenario's */
  if (point->naddition == 0) UM_TRY(um_sensitivity_moves_possible(context, f, &possible));
  UM_CHECK(um_core_allocate(context, count, sizeof *work.order, &work.order));
  UM_CHECK(um_core_allocate(context, count, sizeof *work.task, &work.task));
  UM_CHECK(um_core_allocate(context, count, sizeof *work.is_done, &work.is_done));
  for (size_t i = 0; i < count; i++)
    UM_CHECK(um_sensitivity_scan(context, f, &candidate[i], &base));
  if (!point->derivatives && point->naddition == 0)
    UM_CHECK(um_sensitivity_scan_rates(context, f, candidate, count));
  if (possible) UM_CHECK(make_groups(context, &work, count));
  um_core_progress_begin(context, "signatures of effects", work.ntask + count);
  status = run_tasks(context, &work);
  if (status == UM_OK) {
    make_singles(&work, count);
    status = run_tasks(context, &work);
  }
  um_core_progress_end(context);
done:
  um_model_result_destroy(context, &base);
  UM_FREE(context, work.order, work.task, work.is_done);
  return status;
}
