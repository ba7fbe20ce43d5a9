/* Heat of first steps, many in one run. What moves the network alone is moved by a thousandth of
 * the step, which keeps curvature out; what moves the loads, which are kept to 24 bits, by the step
 * itself, in which they are linear. */
#include "evidence/sensitivity/moves_impl.h"

#include <math.h>
#include <omp.h>
#include <string.h>

#include "effects/effects.h"

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

/* The variant of a move; *share: of the step that it took. */
static enum um_status move_open(struct um_context *context, struct um_sensitivity_forward *forward,
                                const struct um_sensitivity_move *move, struct um_variant *v,
                                double *share)
{
  struct um_model_addition a = addition_of(move, SMALL);
  const struct um_model_changes changes = {.addition = &a, .naddition = 1};
  bool loads = false;
  UM_TRY(um_variant_reaches_geometry(context, forward->evaluator, &a, 1, &loads));
  *share = loads ? 1.0 : SMALL;
  a = addition_of(move, *share);
  return um_variant_open(context, forward->evaluator, &changes, NULL, v);
}

/* Has the move heat of its own that a sensitivity finds? */
static enum um_status is_wanted(struct um_context *context,
                                const struct um_sensitivity_forward *forward,
                                const struct um_variant *v, bool *out)
{
  const struct um_model_thermal_solution *heat = forward->base.heat;
  bool compatible;
  UM_TRY(um_model_thermal_solution_is_compatible(context, heat, v->model, v->tables, &compatible));
  *out = false;
  return compatible
             ? UM_OK
             : um_model_thermal_sensitivity_is_applicable(context, heat, v->model, v->tables, out);
}

/* Moves of one run. */
struct batch {
  struct um_model_thermal_move move[BATCH];
  struct um_variant variant[BATCH]; /* of each, open until the run */
  size_t of[BATCH];                 /* of the moves that are kept */
  size_t count;
};

static void batch_clear(struct um_context *context, struct batch *batch)
{
  for (size_t k = 0; k < batch->count; k++) um_variant_close(context, &batch->variant[k]);
  batch->count = 0;
}

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
  enum um_status status = um_model_thermal_sensitivity_create(context, forward->base.heat,
                                                              batch->move, batch->count, &found);
  if (status == UM_ERR_NUMERIC)
    um_core_message_clear(context);
  else
    UM_TRY(status);
  if (found != NULL) moves->batch[moves->nbatch++] = found;
  for (size_t k = 0; k < batch->count; k++) {
    moves->moved[batch->of[k]].sensitivity = found;
    moves->moved[batch->of[k]].which = k;
  }
  if (found != NULL) {
    forward->heat_batches++;
    forward->heat_sensitivities += batch->count;
  }
  forward->heat_seconds += omp_get_wtime() - begin;
  batch_clear(context, batch);
  return UM_OK;
}

/* Into the batch; a move that is refused is left to the one who takes the step. */
static enum um_status take(struct um_context *context, struct um_sensitivity_forward *forward,
                           const struct um_sensitivity_move *move, struct batch *batch)
{
  struct um_sensitivity_moves *moves = forward->cache->moves;
  struct um_variant *v = &batch->variant[batch->count];
  double share = NAN;
  bool wanted = false;
  uint32_t reach = um_effects_reach(move->effect);
  if ((reach & UM_REACH_THERMAL) == 0 || (reach & UM_REACH_GEOMETRY) != 0) return UM_OK;
  *v = (struct um_variant){0};
  enum um_status status = move_open(context, forward, move, v, &share);
  if (status == UM_OK) status = is_wanted(context, forward, v, &wanted);
  if (status == UM_OK && wanted) {
    moves->moved[moves->count] = (struct um_sensitivity_moved){.move = *move};
    batch->of[batch->count] = moves->count++;
    batch->move[batch->count++] =
        (struct um_model_thermal_move){v->model, v->tables, share * move->step};
    return UM_OK;
  }
  um_variant_close(context, v);
  if (status != UM_ERR_REFUSED && status != UM_ERR_INPUT && status != UM_ERR_NUMERIC) return status;
  um_core_message_clear(context);
  return UM_OK;
}

enum um_status um_sensitivity_moves_find(struct um_context *context,
                                         struct um_sensitivity_forward *forward,
                                         const struct um_sensitivity_move *move, size_t n)
{
  enum um_status status;
  struct batch *batch = NULL;
  bool applicable;
  size_t numbers = um_thermal_network_nodes(forward->model->body->network) *
                   (1 + forward->base.tables->nobs * forward->base.tables->nsub);
  double begin = omp_get_wtime();
  um_core_quiet_begin(context);
  um_sensitivity_moves_clear(context, forward);
  UM_CHECK(um_model_thermal_sensitivity_is_applicable(context, forward->base.heat, forward->model,
                                                      forward->base.tables, &applicable));
  if (!applicable)
    n = 0; /* what the scenario as it stands forbids: no model need be built to see it */
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
  if (batch != NULL) batch_clear(context, batch);
  um_core_free(context, batch);
  if (status != UM_OK) um_sensitivity_moves_clear(context, forward);
  forward->seconds += omp_get_wtime() - begin;
  return status;
}

void um_sensitivity_moves_clear(struct um_context *context, struct um_sensitivity_forward *forward)
{
  um_sensitivity_moves_destroy(context, &forward->cache->moves);
}
