/* Signatures of many candidates at once. A worker sends back the candidate as it made it, as bytes,
 * what the work took, and the columns; its pointers are the parent's own. */
#include "evidence/sensitivity/signatures_impl.h"

#include <stdio.h>
#include <string.h>

#include "evidence/sensitivity/moves_impl.h"
#include "evidence/sensitivity/scan_impl.h"
#include "evidence/sensitivity/signature_impl.h"
#include "variant/many.h"

struct work {
  const struct um_sensitivity_point *point;
  struct um_sensitivity_candidate *candidate; /* [count] */
};

/* What goes before the columns. */
struct answer {
  struct um_sensitivity_candidate candidate;
  struct um_sensitivity_effort effort;
  char why[1024]; /* of a refusal; "": none */
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

static enum um_status compute(struct um_context *context, void *user, size_t which, double *value)
{
  const struct work *work = user;
  struct um_sensitivity_forward *f = work->point->forward;
  struct answer answer = {.candidate = work->candidate[which]};
  const struct um_sensitivity_forward before = *f;
  enum um_status status = UM_OK;
  answer.candidate.signature = value + ANSWER;
  if (!answer.candidate.insensitive)
    status = um_sensitivity_signature_make(context, work->point, &answer.candidate);
  if (status != UM_OK) status = refused(context, status, &answer);
  answer.effort = um_sensitivity_forward_effort(f, &before);
  memcpy(value, &answer, sizeof answer);
  return status;
}

/* The candidate as the worker made it, but for what is the parent's own. */
static enum um_status done(struct um_context *context, void *user, size_t which,
                           enum um_status status, const double *value)
{
  struct answer answer;
  const struct work *work = user;
  struct um_sensitivity_candidate *c = &work->candidate[which];
  const struct um_sensitivity_candidate own = *c;
  size_t n = work->point->forward->observations.count, columns = columns_of(c);
  UM_TRY(status);
  memcpy(&answer, value, sizeof answer);
  um_sensitivity_forward_effort_add(work->point->forward, &answer.effort);
  *c = answer.candidate;
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

/* Heat of the first steps of all candidates. */
static enum um_status find_moves(struct um_context *context,
                                 const struct um_sensitivity_point *point,
                                 const struct um_sensitivity_candidate *candidate, size_t count)
{
  struct um_sensitivity_move *move = NULL;
  size_t n = 0;
  if (point->naddition > 0) return UM_OK; /* the heat at hand is the scenario's */
  UM_TRY(um_core_allocate(context, count + 1, UM_EFFECT_PARAMETERS_MAX * sizeof *move, &move));
  for (size_t i = 0; i < count; i++) n += um_sensitivity_signature_moves(&candidate[i], move + n);
  enum um_status status = um_sensitivity_moves_find(context, point->forward, move, n);
  um_core_free(context, move);
  return status;
}

enum um_status um_sensitivity_signatures_create(struct um_context *context,
                                                const struct um_sensitivity_point *point,
                                                struct um_sensitivity_candidate *candidate,
                                                size_t count)
{
  enum um_status status = UM_OK;
  struct um_sensitivity_forward *f = point->forward;
  struct um_sensitivity_forward_run base = {.result = NULL};
  struct work work = {point, candidate};
  struct um_workers_each tasks = {.n = count,
                                  .compute = compute,
                                  .done = done,
                                  .user = &work,
                                  .workers = um_core_context_threads(context)};
  UM_TRY(um_variant_share(context, f->evaluator, UM_VARIANT_WARM, true));
  um_core_progress_begin(context, "signatures of effects", count);
  for (size_t i = 0; i < count; i++) {
    size_t room = ANSWER + columns_of(&candidate[i]) * f->observations.count;
    UM_CHECK(um_sensitivity_scan(context, f, &candidate[i], &base));
    if (tasks.nvalue < room) tasks.nvalue = room;
  }
  UM_CHECK(find_moves(context, point, candidate, count));
  UM_CHECK(um_variant_tasks(context, f->evaluator, &tasks));
done:
  um_sensitivity_moves_clear(context, f);
  um_sensitivity_forward_run_release(context, &base);
  um_core_progress_end(context);
  return status;
}
