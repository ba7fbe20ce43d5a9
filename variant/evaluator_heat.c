/* Heat of variants: some at hand that is the same number for number, or solved. */
#include <omp.h>

#include "variant/evaluator_impl.h"

enum um_status um_variant_base_heat(struct um_context *context, struct um_variant_evaluator *e)
{
  if (e->heat != NULL) return UM_OK;
  UM_TRY(um_variant_base_geometry(context, e));
  double begin = omp_get_wtime();
  UM_TRY(um_model_thermal_solution_near(context, e->model, e->tables, NULL, e->settings.base.factor,
                                        e->settings.base.periodic, &e->heat));
  /* what each warm start would find anew is found once */
  UM_TRY(um_model_thermal_solution_lead(context, e->heat));
  e->seconds_heat = omp_get_wtime() - begin;
  return UM_OK;
}

/* May heat of the model start from the scenario's own? Same nodes on the same number of surfaces.
 */
static bool starts_warm(const struct um_variant_evaluator *e, const struct um_model *model)
{
  return um_geometry_mesh(e->model->geometry)->nsurface ==
             um_geometry_mesh(model->geometry)->nsurface &&
         um_thermal_network_nodes(e->model->body->network) ==
             um_thermal_network_nodes(model->body->network);
}

static enum um_status solve(struct um_context *context, const struct um_variant_evaluator *e,
                            const struct um_variant_heat *how, const struct um_variant *v,
                            struct um_model_thermal_solution **out)
{
  const struct um_model_thermal_solution *warm = starts_warm(e, v->model) ? e->heat : NULL;
  switch (how->start) {
  case UM_VARIANT_EXTRAPOLATED:
    return um_model_thermal_solution_move(context, e->heat, how->sensitivity, how->which, how->step,
                                          v->model, v->tables, out);
  case UM_VARIANT_WARM:
    return um_model_thermal_solution_near(context, v->model, v->tables, warm, how->tolerance.factor,
                                          how->tolerance.periodic, out);
  case UM_VARIANT_COLD:
    break;
  }
  return um_model_thermal_solution_create(context, v->model, v->tables, NULL, 1.0, out);
}

static bool tolerances_equal(const struct um_variant_tolerance *a,
                             const struct um_variant_tolerance *b)
{
  return a->factor == b->factor && a->periodic == b->periodic;
}

/* Heat at hand that is the variant's, number for number. */
static enum um_status look_for_heat(struct um_context *context,
                                    const struct um_variant_evaluator *e,
                                    const struct um_variant_heat *how, struct um_variant *v)
{
  const struct um_variant_kept *kept = v->kept;
  const struct um_model_thermal_solution *at_hand[] = {
      kept != NULL && how->start == UM_VARIANT_WARM &&
              tolerances_equal(&kept->tolerance, &how->tolerance)
          ? kept->heat
          : NULL,
      e->heat};
  for (size_t i = 0; i < sizeof at_hand / sizeof at_hand[0] && v->heat == NULL; i++) {
    bool compatible = false;
    if (at_hand[i] == NULL) continue;
    UM_TRY(um_model_thermal_solution_is_compatible(context, at_hand[i], v->model, v->tables,
                                                   &compatible));
    if (compatible) v->heat = at_hand[i];
  }
  return UM_OK;
}

enum um_status um_variant_heat_again(struct um_context *context, struct um_variant_evaluator *e,
                                     const struct um_variant_heat *how, struct um_variant *v)
{
  double begin = omp_get_wtime();
  if (how->start != UM_VARIANT_COLD) UM_TRY(um_variant_base_heat(context, e));
  um_model_thermal_solution_destroy(context, &v->own_heat);
  v->heat = NULL;
  um_core_quiet_begin(context);
  enum um_status status = solve(context, e, how, v, &v->own_heat);
  um_core_quiet_end(context);
  UM_TRY(status);
  v->heat = v->own_heat;
  v->fresh_heat = true;
  v->moved = how->start == UM_VARIANT_EXTRAPOLATED ? *how : (struct um_variant_heat){0};
  v->seconds_heat = omp_get_wtime() - begin;
  return UM_OK;
}

enum um_status um_variant_find_heat(struct um_context *context, struct um_variant_evaluator *e,
                                    const struct um_variant_heat *how, struct um_variant *v)
{
  struct um_variant_kept *kept = v->kept;
  v->heat = NULL;
  v->fresh_heat = false;
  if (how->start != UM_VARIANT_COLD) UM_TRY(um_variant_base_heat(context, e));
  if (how->start != UM_VARIANT_COLD) UM_TRY(look_for_heat(context, e, how, v));
  if (v->heat != NULL) return UM_OK;
  UM_TRY(um_variant_heat_again(context, e, how, v));
  /* new heat of a model that is kept stays with it */
  if (how->start != UM_VARIANT_WARM || kept == NULL || kept->model != v->model ||
      kept->heat != NULL)
    return UM_OK;
  um_variant_cache_keep_heat(&e->cache, kept, &v->own_heat, how->tolerance);
  return UM_OK;
}
