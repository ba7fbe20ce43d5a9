/* How the heat of a pass answers to what is uncertain: forward sensitivities along the heat that
 * the pass has, many parameters a run (model/products/thermal_sensitivity.h). What moves the
 * network alone is moved by a thousandth of its sigma, which keeps curvature out; what moves loads,
 * which are kept to 24 bits, by the sigma itself, in which they are linear. */
#include "effects/effects.h"
#include "forecast/forecast_impl.h"

#define SMALL   1e-3 /* of sigma */
#define STEP    1e-3 /* error of a step of heat: an error bar is asked to a hundredth */
#define AT_ONCE 16   /* variants that are open at once, some with a geometry of their own */

/* Parameters of one run. */
struct batch {
  struct um_variant variant[AT_ONCE]; /* open */
  struct um_model_thermal_move move[AT_ONCE];
  size_t which[AT_ONCE], count;
};

static void batch_clear(struct um_context *context, struct batch *batch)
{
  for (size_t i = 0; i < batch->count; i++) um_variant_close(context, &batch->variant[i]);
  batch->count = 0;
}

static enum um_status batch_run(struct um_context *context, const struct um_variant *base,
                                struct batch *batch, struct um_forecast_tangents *out)
{
  struct um_model_thermal_sensitivity *run;
  if (batch->count == 0) return UM_OK;
  enum um_status status = um_model_thermal_sensitivity_create(context, base->heat, batch->move,
                                                              batch->count, STEP, &run);
  if (status == UM_OK) {
    for (size_t i = 0; i < batch->count; i++)
      out->of[batch->which[i]] = (struct um_forecast_tangent){run, i};
    out->run[out->nrun++] = run;
  }
  batch_clear(context, batch);
  if (status != UM_ERR_NUMERIC) return status;
  um_core_message_clear(context); /* left to runs */
  return UM_OK;
}

/* The variant of a parameter moved by `step`. */
static enum um_status move(struct um_context *context, struct um_variant_evaluator *evaluator,
                           const struct um_variant *base, const struct um_study_binding *binding,
                           double step, struct um_variant *v)
{
  const double at = binding->nominal + step;
  struct um_study_changes changes;
  enum um_status status = um_study_changes_make(context, base->model, binding, 1, &at, &changes);
  if (status == UM_OK) status = um_variant_open(context, evaluator, &changes.all, NULL, v);
  um_study_changes_clear(context, &changes);
  return status;
}

/* Do loads move with it? Then it has a geometry of its own. */
static enum um_status moves_loads(struct um_context *context,
                                  const struct um_variant_evaluator *evaluator,
                                  const struct um_variant *base,
                                  const struct um_study_binding *binding, double step, bool *out)
{
  const double at = binding->nominal + step;
  struct um_study_changes changes;
  *out = false;
  if (binding->effect == NULL) return UM_OK;
  enum um_status status = um_study_changes_make(context, base->model, binding, 1, &at, &changes);
  if (status == UM_OK)
    status = um_variant_reaches_geometry(context, evaluator, changes.all.addition,
                                         changes.all.naddition, out);
  um_study_changes_clear(context, &changes);
  return status;
}

/* Has it heat of its own that a sensitivity finds? */
static enum um_status is_wanted(struct um_context *context, const struct um_variant *base,
                                const struct um_study_binding *binding, const struct um_variant *v,
                                bool *out)
{
  bool same = false;
  *out = false;
  if (binding->effect == NULL && v->tables != base->tables) return UM_OK; /* shapes or places */
  UM_TRY(um_model_thermal_solution_is_compatible(context, base->heat, v->model, v->tables, &same));
  return same ? UM_OK
              : um_model_thermal_sensitivity_is_applicable(context, base->heat, v->model, v->tables,
                                                           out);
}

/* By what effects declare. */
static bool may_have(const struct um_effect *effect)
{
  uint32_t reach = effect == NULL ? UM_REACH_THERMAL : um_effects_reach(effect);
  return (reach & UM_REACH_THERMAL) != 0 && (reach & UM_REACH_GEOMETRY) == 0;
}

/* Into the batch; what the model refuses is left to runs, which say so. */
static enum um_status take(struct um_context *context, const struct um_forecast_unknowns *u,
                           struct um_variant_evaluator *evaluator, const struct um_variant *base,
                           size_t which, struct batch *batch)
{
  const struct um_study_binding *binding = &u->binding[which];
  struct um_variant *v = &batch->variant[batch->count];
  double step = um_forecast_uncertain_step(u, which, 1);
  bool loads = false, wanted = false;
  if (!may_have(binding->effect)) return UM_OK;
  if (!(step > 0.0)) step = -um_forecast_uncertain_step(u, which, 0);
  *v = (struct um_variant){0};
  enum um_status status = moves_loads(context, evaluator, base, binding, step, &loads);
  if (!loads) step *= SMALL;
  if (status == UM_OK) status = move(context, evaluator, base, binding, step, v);
  if (status == UM_OK) status = is_wanted(context, base, binding, v, &wanted);
  if (status == UM_OK && wanted) {
    batch->which[batch->count] = which;
    batch->move[batch->count++] =
        (struct um_model_thermal_move){.model = v->model, .tables = v->tables, .step = step};
    return UM_OK;
  }
  um_variant_close(context, v);
  if (!um_forecast_is_of_changes(status)) return status;
  um_core_message_clear(context);
  return UM_OK;
}

enum um_status um_forecast_tangents_find(struct um_context *context,
                                         const struct um_forecast_unknowns *u,
                                         struct um_variant_evaluator *evaluator,
                                         const struct um_variant *base,
                                         struct um_forecast_tangents *out)
{
  enum um_status status = UM_OK;
  struct batch *batch = NULL;
  *out = (struct um_forecast_tangents){.nrun = 0};
  UM_CHECK(um_core_allocate(context, 1, sizeof *batch, &batch));
  UM_CHECK(um_core_allocate(context, u->n, sizeof *out->of, &out->of));
  UM_CHECK(um_core_allocate(context, u->n, sizeof *out->run, &out->run));
  for (size_t i = 0; i < u->n; i++) {
    UM_CHECK(take(context, u, evaluator, base, i, batch));
    if (batch->count == AT_ONCE) UM_CHECK(batch_run(context, base, batch, out));
  }
  UM_CHECK(batch_run(context, base, batch, out));
done:
  if (batch != NULL) batch_clear(context, batch);
  um_core_free(context, batch);
  return status;
}

void um_forecast_tangents_clear(struct um_context *context, struct um_forecast_tangents *tangents)
{
  for (size_t i = 0; i < tangents->nrun; i++)
    um_model_thermal_sensitivity_destroy(context, &tangents->run[i]);
  UM_FREE(context, tangents->run, tangents->of);
  *tangents = (struct um_forecast_tangents){.nrun = 0};
}
