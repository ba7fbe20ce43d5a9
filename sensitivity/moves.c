/* Heat of first steps, many in one run. What moves the network alone is moved by a thousandth of
 * the step, which keeps curvature out; what moves the loads, which are kept to 24 bits, by the step
 * itself, in which they are linear. */
#include "sensitivity/moves_impl.h"

#include <omp.h>
#include <string.h>

#include "compare/predict.h"
#include "effects/effects.h"
#include "model/build.h"
#include "model/precompute.h"
#include "sensitivity/variant_impl.h"

#define SMALL         1e-3      /* of a step */
#define BATCH         48        /* moves in one run */
#define BATCH_NUMBERS (1 << 25) /* answers that one run may keep: 256 MiB */

static struct um_model_addition addition_of(const struct um_sensitivity_move *move, double share)
{
  struct um_model_addition a = {.effect = move->effect, .target = move->target};
  memcpy(a.value, move->at, move->effect->nparameter * sizeof *a.value);
  a.value[move->parameter] += share * move->step;
  return a;
}

/* The model of a move, and its loads where they are others; *share: of the step that it took. */
static enum um_status move_build(struct um_context *context, struct um_sensitivity_forward *forward,
                                 const struct um_sensitivity_move *move,
                                 struct um_sensitivity_cached *to, double *share)
{
  struct um_model_addition a = addition_of(move, SMALL), key;
  const struct um_model_changes changes = {.addition = &a, .naddition = 1};
  *share = SMALL;
  UM_TRY(um_model_variant_create(context, forward->model, &changes, &to->model));
  if (um_sensitivity_variant_key(forward->model, to->model, &a, 1, &key) == 0) return UM_OK;
  um_model_destroy(context, &to->model);
  *share = 1.0;
  a = addition_of(move, 1.0);
  UM_TRY(um_model_variant_create(context, forward->model, &changes, &to->model));
  UM_TRY(um_core_allocate(context, 1, sizeof *to->key, &to->key));
  to->nkey = um_sensitivity_variant_key(forward->model, to->model, &a, 1, to->key);
  return um_compare_plan_trace(context, to->model, forward->plan, &to->precomputed);
}

/* Has the move heat of its own that a sensitivity finds? */
static enum um_status is_wanted(struct um_context *context,
                                const struct um_sensitivity_forward *forward,
                                const struct um_sensitivity_cached *of, bool *out)
{
  const struct um_model_thermal_solution *heat = forward->cache->own.heat;
  const struct um_model_precomputed *precomputed =
      of->precomputed != NULL ? of->precomputed : forward->precomputed;
  bool matches;
  UM_TRY(um_model_thermal_solution_matches(context, heat, of->model, precomputed, &matches));
  *out = false;
  return matches ? UM_OK
                 : um_model_thermal_sensitivity_serves(context, heat, of->model, precomputed, out);
}

/* Moves of one run. */
struct batch {
  struct um_model_thermal_move move[BATCH];
  size_t of[BATCH]; /* of the moves that are kept */
  size_t count;
};

/* The run of a batch; where it finds no answer, its moves are left to runs of their own. */
static enum um_status batch_run(struct um_context *context, struct um_sensitivity_forward *forward,
                                struct batch *batch)
{
  struct um_sensitivity_moves *moves = forward->cache->moves;
  struct um_model_thermal_sensitivity *found = NULL;
  if (batch->count == 0) return UM_OK;
  double begin = omp_get_wtime();
  UM_TRY(um_core_reallocate(context, moves->nbatch + 1,
                            sizeof(struct um_model_thermal_sensitivity *), (void **)&moves->batch));
  enum um_status status = um_model_thermal_sensitivity_create(context, forward->cache->own.heat,
                                                              batch->move, batch->count, &found);
  if (status == UM_ERR_NUMERIC)
    um_core_message_clear(context);
  else
    UM_TRY(status);
  if (found != NULL) moves->batch[moves->nbatch++] = found;
  for (size_t k = 0; k < batch->count; k++) {
    struct um_sensitivity_moved *moved = &moves->moved[batch->of[k]];
    moved->sensitivity = found;
    moved->which = k;
    if (moved->cached.nkey == 0) um_sensitivity_cached_clear(context, &moved->cached);
  }
  if (found != NULL) {
    forward->heat_batches++;
    forward->heat_sensitivities += batch->count;
  }
  forward->heat_seconds += omp_get_wtime() - begin;
  batch->count = 0;
  return UM_OK;
}

/* Into the batch; a move that is refused is left to the one who takes the step. */
static enum um_status take(struct um_context *context, struct um_sensitivity_forward *forward,
                           const struct um_sensitivity_move *move, struct batch *batch)
{
  struct um_sensitivity_moves *moves = forward->cache->moves;
  struct um_sensitivity_moved *to = &moves->moved[moves->count];
  double share;
  bool wanted = false;
  uint32_t reach = um_effects_reach(move->effect);
  if ((reach & UM_REACH_THERMAL) == 0 || (reach & UM_REACH_PRECOMPUTED) != 0) return UM_OK;
  *to = (struct um_sensitivity_moved){.move = *move};
  moves->count++; /* released with the others from now on */
  enum um_status status = move_build(context, forward, move, &to->cached, &share);
  if (status == UM_OK) status = is_wanted(context, forward, &to->cached, &wanted);
  if (status == UM_ERR_REFUSED || status == UM_ERR_INPUT || status == UM_ERR_NUMERIC) {
    um_core_message_clear(context);
    um_sensitivity_cached_clear(context, &to->cached);
    return UM_OK;
  }
  UM_TRY(status);
  if (!wanted) {
    if (to->cached.nkey == 0) um_sensitivity_cached_clear(context, &to->cached);
    return UM_OK;
  }
  batch->of[batch->count] = moves->count - 1;
  batch->move[batch->count++] = (struct um_model_thermal_move){
      to->cached.model,
      to->cached.precomputed != NULL ? to->cached.precomputed : forward->precomputed,
      share * move->step};
  return UM_OK;
}

enum um_status um_sensitivity_moves_find(struct um_context *context,
                                         struct um_sensitivity_forward *forward,
                                         const struct um_sensitivity_move *move, size_t n)
{
  enum um_status status;
  struct batch *batch = NULL;
  size_t numbers = um_thermal_network_nodes(forward->model->body->network) *
                   (1 + forward->precomputed->nobs * forward->precomputed->nsub);
  double begin = omp_get_wtime();
  um_core_quiet_begin(context);
  um_sensitivity_moves_clear(context, forward);
  UM_CHECK(um_core_allocate(context, 1, sizeof *batch, &batch));
  UM_CHECK(um_core_allocate(context, 1, sizeof *forward->cache->moves, &forward->cache->moves));
  UM_CHECK(um_core_allocate(context, n, sizeof *forward->cache->moves->moved,
                            &forward->cache->moves->moved));
  for (size_t i = 0; i < n; i++) {
    UM_CHECK(take(context, forward, &move[i], batch));
    if (batch->count == BATCH || (batch->count + 1) * numbers > BATCH_NUMBERS)
      UM_CHECK(batch_run(context, forward, batch));
  }
  UM_CHECK(batch_run(context, forward, batch));
done:
  um_core_quiet_end(context);
  um_core_free(context, batch);
  if (status != UM_OK) um_sensitivity_moves_clear(context, forward);
  forward->seconds += omp_get_wtime() - begin;
  return status;
}

void um_sensitivity_moves_clear(struct um_context *context, struct um_sensitivity_forward *forward)
{
  um_sensitivity_moves_destroy(context, &forward->cache->moves);
}
