/* Heat, and light by it, of first steps, as many in one run as have room with geometries of their
 * own. What moves the network alone is moved by a thousandth of the step, which keeps curvature
 * out; what moves the loads, which are kept to 24 bits, by the step itself, in which they are
 * linear. Heaters that come switch with the scenario's own temperatures: at no power they warm
 * nothing. */
#include "evidence/sensitivity/moves_impl.h"

#include <math.h>
#include <omp.h>
#include <string.h>

#include "effects/effects.h"
#include "evidence/sensitivity/policy.h"

#define SMALL 1e-3                /* of a step */
#define FAINT 1e-9                /* of a step: a heater of so little power warms nothing */
#define BYTES ((size_t)128 << 20) /* that answers of one run may take */

static struct um_model_addition addition_of(const struct um_sensitivity_move *move, double share)
{
  struct um_model_addition a = {.effect = move->effect, .target = move->target};
  memcpy(a.value, move->at, move->effect->nparameter * sizeof *a.value);
  a.value[move->parameter] += share * move->step;
  return a;
}

/* A move that is refused is left to the one who takes the step. */
static enum um_status left(struct um_context *context, enum um_status status)
{
  if (status != UM_ERR_REFUSED && status != UM_ERR_INPUT && status != UM_ERR_NUMERIC) return status;
  um_core_message_clear(context);
  return UM_OK;
}

enum um_status um_sensitivity_moves_loads(struct um_context *context,
                                          const struct um_sensitivity_forward *forward,
                                          const struct um_sensitivity_move *move, bool *out)
{
  const struct um_model_addition a = addition_of(move, SMALL);
  *out = false;
  return left(context, um_variant_reaches_geometry(context, forward->evaluator, &a, 1, out));
}

/* The variant of a move of a share of its step. */
static enum um_status move_open(struct um_context *context, struct um_sensitivity_forward *forward,
                                const struct um_sensitivity_move *move, double share,
                                struct um_variant *v)
{
  const struct um_model_addition a = addition_of(move, share);
  const struct um_model_changes changes = {.addition = &a, .naddition = 1};
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
  struct um_model_thermal_move *move; /* [most] */
  struct um_variant *variant;         /* [most] of each, open until the run */
  size_t count, most;
  struct um_variant base;                    /* of its moves, in place of the scenario */
  const struct um_sensitivity_move **heater; /* [nheater] moves that are left for a run with one */
  size_t nheater;
  double tolerance; /* of heat */
};

static void batch_clear(struct um_context *context, struct batch *batch)
{
  for (size_t k = 0; k < batch->count; k++) um_variant_close(context, &batch->variant[k]);
  batch->count = 0;
}

/* As many moves as keep their answers within BYTES. */
static size_t moves_most(const struct um_sensitivity_forward *f)
{
  size_t most = BYTES / (um_thermal_network_nodes(f->model->body->network) *
                         (1 + f->base.tables->nobs * f->base.tables->nsub) * sizeof(float));
  return most < 1 ? 1 : most;
}

size_t um_sensitivity_moves_open(const struct um_sensitivity_forward *forward, size_t most)
{
  size_t own = um_model_tables_bytes(forward->base.tables, forward->base.tables);
  size_t open = 1 + UM_SENSITIVITY_OPEN / (own + 1); /* the one that goes beyond is taken, too */
  return open < most ? open : most;
}

/* Does it move nothing but temperatures? */
static bool warms(const struct um_sensitivity_moved *m)
{
  return um_effects_reach(m->move.effect) == UM_REACH_THERMAL;
}

/* The run of a batch, of the moves from `first` on; where it finds no answer, they are left to runs
 * of their own. */
static enum um_status batch_run(struct um_context *context, struct um_sensitivity_forward *forward,
                                const struct batch *batch, size_t first)
{
  struct um_sensitivity_moves *moves = forward->cache->moves;
  struct um_sensitivity_moved *moved = moves->moved + first;
  struct um_sensitivity_answers *run = &moves->run[moves->nrun];
  bool light = false;
  double begin = omp_get_wtime();
  enum um_status status = um_model_thermal_sensitivity_create(
      context, forward->base.heat, batch->move, batch->count, batch->tolerance, &run->thermal);
  if (status == UM_ERR_NUMERIC) {
    um_core_message_clear(context);
    return UM_OK;
  }
  UM_TRY(status);
  moves->nrun++;
  forward->heat_batches++;
  forward->heat_sensitivities += batch->count;
  forward->heat_seconds += omp_get_wtime() - begin;
  for (size_t k = 0; k < batch->count; k++) light = light || warms(&moved[k]);
  if (light) UM_TRY(um_model_light_sensitivity_create(context, run->thermal, &run->light));
  for (size_t k = 0; k < batch->count; k++) {
    moved[k].sensitivity = run->thermal;
    moved[k].light = warms(&moved[k]) ? run->light : NULL;
    moved[k].which = k;
  }
  return UM_OK;
}

/* The run of a batch that is full, or of the last. */
static enum um_status batch_end(struct um_context *context, struct um_sensitivity_forward *forward,
                                struct batch *batch)
{
  if (batch->count == 0) return UM_OK;
  enum um_status status =
      batch_run(context, forward, batch, forward->cache->moves->count - batch->count);
  batch_clear(context, batch);
  return status;
}

bool um_sensitivity_moves_heat(const struct um_effect *effect)
{
  uint32_t reach = um_effects_reach(effect);
  return (reach & UM_REACH_THERMAL) != 0 && (reach & UM_REACH_GEOMETRY) == 0;
}

/* Its answer is known, and it is in the batch. */
static void put(struct um_sensitivity_moves *moves, const struct um_sensitivity_move *move,
                double step, struct batch *batch)
{
  const struct um_variant *v = &batch->variant[batch->count];
  moves->moved[moves->count++] = (struct um_sensitivity_moved){.move = *move};
  batch->move[batch->count++] =
      (struct um_model_thermal_move){v->model, v->tables, step, batch->base.model};
}

/* Does a thermostat come with the variant, which the scenario has not? */
static bool switches(const struct um_sensitivity_forward *f, const struct um_variant *v)
{
  return um_thermal_network_thermostats(v->model->body->network) >
         um_thermal_network_thermostats(f->model->body->network);
}

/* Into the batch, or, of a heater, left for the run of those. loads: they move with it. */
static enum um_status take(struct um_context *context, struct um_sensitivity_forward *forward,
                           const struct um_sensitivity_move *move, bool loads, struct batch *batch)
{
  struct um_variant *v = &batch->variant[batch->count];
  bool wanted = false;
  double share = loads ? 1.0 : SMALL;
  *v = (struct um_variant){0};
  enum um_status status = move_open(context, forward, move, share, v);
  if (status == UM_OK) status = is_wanted(context, forward, v, &wanted);
  if (status == UM_OK && wanted) {
    put(forward->cache->moves, move, share * move->step, batch);
    return UM_OK;
  }
  if (status == UM_OK && switches(forward, v)) batch->heater[batch->nheater++] = move;
  um_variant_close(context, v);
  return left(context, status);
}

/* Moves [n] that move the loads, or those that do not. A run of those that do ends where their
 * loads fill the memory, which the others need not wait for. */
static enum um_status take_all(struct um_context *context, struct um_sensitivity_forward *forward,
                               const struct um_sensitivity_move *move, size_t n, bool loads,
                               struct batch *batch)
{
  for (size_t i = 0; i < n; i++) {
    bool own = false;
    if (!um_sensitivity_moves_heat(move[i].effect)) continue;
    UM_TRY(um_sensitivity_moves_loads(context, forward, &move[i], &own));
    if (own != loads) continue;
    UM_TRY(take(context, forward, &move[i], loads, batch));
    if (batch->count == batch->most ||
        um_variant_evaluator_open_bytes(forward->evaluator) > UM_SENSITIVITY_OPEN)
      UM_TRY(batch_end(context, forward, batch));
  }
  return UM_OK;
}

/* The variant of all heaters together, each so faint that it warms nothing; `which` has a share of
 * its step. */
static enum um_status heaters_open(struct um_context *context,
                                   struct um_sensitivity_forward *forward,
                                   const struct batch *batch, size_t which, struct um_variant *v)
{
  struct um_model_addition *a;
  UM_TRY(um_core_allocate(context, batch->nheater, sizeof *a, &a));
  for (size_t i = 0; i < batch->nheater; i++)
    a[i] = addition_of(batch->heater[i], i == which ? SMALL : FAINT);
  const struct um_model_changes changes = {.addition = a, .naddition = batch->nheater};
  enum um_status status = um_variant_open(context, forward->evaluator, &changes, NULL, v);
  um_core_free(context, a);
  return status;
}

/* The run of heaters that come: along the scenario with all of them, faint, they switch where its
 * temperatures pass their thresholds. */
static enum um_status heaters_find(struct um_context *context,
                                   struct um_sensitivity_forward *forward, struct batch *batch)
{
  struct um_sensitivity_moves *moves = forward->cache->moves;
  if (batch->nheater == 0) return UM_OK;
  enum um_status status = heaters_open(context, forward, batch, SIZE_MAX, &batch->base);
  for (size_t i = 0; i < batch->nheater && status == UM_OK; i++) {
    struct um_variant *v = &batch->variant[batch->count];
    *v = (struct um_variant){0};
    status = heaters_open(context, forward, batch, i, v);
    if (status == UM_OK) put(moves, batch->heater[i], SMALL * batch->heater[i]->step, batch);
    if (status != UM_OK) um_variant_close(context, v);
    if (batch->count == batch->most) UM_TRY(batch_end(context, forward, batch));
  }
  if (status == UM_OK) return batch_end(context, forward, batch);
  moves->count -= batch->count;
  batch_clear(context, batch);
  return left(context, status);
}

enum um_status um_sensitivity_moves_find(struct um_context *context,
                                         struct um_sensitivity_forward *forward,
                                         const struct um_sensitivity_move *move, size_t n,
                                         double tolerance)
{
  enum um_status status;
  struct batch batch = {.most = moves_most(forward), .tolerance = tolerance};
  struct um_sensitivity_moves *moves = NULL;
  double begin = omp_get_wtime();
  um_core_quiet_begin(context);
  um_sensitivity_moves_clear(context, forward);
  UM_CHECK(um_core_allocate(context, 1, sizeof *moves, &moves));
  forward->cache->moves = moves;
  UM_CHECK(um_core_allocate(context, n, sizeof *moves->moved, &moves->moved));
  UM_CHECK(um_core_allocate(context, n, sizeof *moves->run, &moves->run));
  UM_CHECK(um_core_allocate(context, n, sizeof *batch.move, &batch.move));
  UM_CHECK(um_core_allocate(context, n, sizeof *batch.variant, &batch.variant));
  UM_CHECK(um_core_allocate(context, n, sizeof(void *), &batch.heater));
  UM_CHECK(take_all(context, forward, move, n, false, &batch));
  UM_CHECK(take_all(context, forward, move, n, true, &batch));
  UM_CHECK(batch_end(context, forward, &batch));
  UM_CHECK(heaters_find(context, forward, &batch));
done:
  um_core_quiet_end(context);
  batch_clear(context, &batch);
  um_variant_close(context, &batch.base);
  UM_FREE(context, batch.move, batch.variant, batch.heater);
  if (status != UM_OK) um_sensitivity_moves_clear(context, forward);
  forward->seconds += omp_get_wtime() - begin;
  return status;
}

enum um_status um_sensitivity_moves_possible(struct um_context *context,
                                             const struct um_sensitivity_forward *forward,
                                             bool *out)
{
  return um_model_thermal_sensitivity_is_applicable(context, forward->base.heat, forward->model,
                                                    forward->base.tables, out);
}

void um_sensitivity_moves_clear(struct um_context *context, struct um_sensitivity_forward *forward)
{
  um_sensitivity_moves_destroy(context, &forward->cache->moves);
}
