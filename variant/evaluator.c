/* One scenario, computed again and again with something changed. */
#include "effects/effects.h"
#include "model/build/build.h"
#include "model/geometry/compatible.h"
#include "model/run/run.h"
#include "variant/evaluator_impl.h"

enum um_status um_variant_evaluator_create(struct um_context *context, const struct um_model *model,
                                           const struct um_variant_settings *settings,
                                           struct um_variant_evaluator **out)
{
  UM_TRY(um_core_allocate(context, 1, sizeof **out, out));
  (*out)->model = model;
  (*out)->settings = *settings;
  (*out)->cache.most = settings->bytes > 0 ? settings->bytes : UM_VARIANT_BYTES;
  return UM_OK;
}

enum um_status um_variant_evaluator_of(struct um_context *context, const struct um_variant *variant,
                                       const struct um_variant_settings *settings,
                                       struct um_variant_evaluator **out)
{
  UM_TRY(um_variant_evaluator_create(context, variant->model, settings, out));
  (*out)->lent = true;
  (*out)->tables = variant->own_tables;
  (*out)->heat = variant->own_heat;
  return UM_OK;
}

void um_variant_evaluator_destroy(struct um_context *context,
                                  struct um_variant_evaluator **evaluator)
{
  struct um_variant_evaluator *e = *evaluator;
  if (e == NULL) return;
  um_variant_cache_clear(context, &e->cache);
  um_optics_lightcurve_destroy(context, &e->light);
  if (!e->lent) {
    um_model_thermal_solution_destroy(context, &e->heat);
    um_model_tables_destroy(context, &e->tables);
  }
  um_core_free(context, e);
  *evaluator = NULL;
}

double um_variant_base_seconds_heat(const struct um_variant_evaluator *evaluator)
{
  return evaluator->seconds_heat;
}

size_t um_variant_evaluator_bound(struct um_variant_evaluator *evaluator, size_t bytes)
{
  size_t before = evaluator->cache.most;
  evaluator->cache.most = bytes;
  return before;
}

struct um_model_tables *um_variant_base_tables(struct um_context *context,
                                               struct um_variant_evaluator *evaluator)
{
  um_optics_lightcurve_destroy(context, &evaluator->light);
  return evaluator->tables;
}

size_t um_variant_evaluator_open_bytes(const struct um_variant_evaluator *evaluator)
{
  size_t bytes = 0;
  for (const struct um_variant_kept *k = evaluator->cache.first; k != NULL; k = k->next)
    bytes += k->users > 0 ? k->bytes : 0;
  return bytes;
}

enum um_status um_variant_base(struct um_context *context, struct um_variant_evaluator *evaluator,
                               struct um_variant *out)
{
  UM_TRY(um_variant_base_heat(context, evaluator));
  *out = (struct um_variant){.model = evaluator->model,
                             .tables = evaluator->tables,
                             .heat = evaluator->heat,
                             .light_alike = true};
  return UM_OK;
}

enum um_status um_variant_share(struct um_context *context, struct um_variant_evaluator *evaluator,
                                enum um_variant_start start, bool light)
{
  struct um_variant_evaluator *e = evaluator;
  UM_TRY(um_variant_base_geometry(context, e));
  if (start == UM_VARIANT_COLD) return UM_OK;
  UM_TRY(um_variant_base_heat(context, e));
  if (!light || e->light != NULL) return UM_OK;
  return um_model_run_light(context, e->model, e->tables, e->heat, &e->light);
}

static enum um_status make_model(struct um_context *context, const struct um_variant_evaluator *e,
                                 const struct um_model_changes *changes, struct um_variant *out)
{
  *out = (struct um_variant){0};
  UM_TRY(um_model_variant_create(context, e->model, changes, &out->own_model));
  out->model = out->own_model;
  return UM_OK;
}

static bool additions_all(const struct um_model_changes *changes,
                          bool (*is)(const struct um_effect *effect))
{
  bool all = changes->nkey + changes->nwith + changes->nwithout + changes->nsource == 0;
  for (size_t i = 0; i < changes->naddition; i++) all = all && is(changes->addition[i].effect);
  return all;
}

bool um_variant_acts_behind(const struct um_model_changes *changes)
{
  return additions_all(changes, um_effects_act_behind);
}

enum um_status um_variant_reaches_geometry(struct um_context *context,
                                           const struct um_variant_evaluator *evaluator,
                                           const struct um_model_addition *addition,
                                           size_t naddition, bool *out)
{
  const struct um_model_changes changes = {.addition = addition, .naddition = naddition};
  struct um_variant v;
  uint32_t reach = 0;
  for (size_t i = 0; i < naddition; i++) reach |= um_effects_reach(addition[i].effect);
  *out = false;
  if ((reach & (UM_REACH_GEOMETRY | UM_REACH_LIGHT)) == 0) return UM_OK; /* whatever the values */
  enum um_status status = make_model(context, evaluator, &changes, &v);
  *out = status == UM_OK && um_variant_reaching(evaluator, v.model, addition, naddition, NULL) > 0;
  um_variant_close(context, &v);
  return status;
}

enum um_status um_variant_open(struct um_context *context, struct um_variant_evaluator *evaluator,
                               const struct um_model_changes *changes,
                               const struct um_variant_heat *heat, struct um_variant *out)
{
  enum um_status status;
  um_core_quiet_begin(context); /* what is to say of the scenario was said once */
  UM_CHECK(make_model(context, evaluator, changes, out));
  out->light_alike = additions_all(changes, um_effects_light_alike);
  UM_CHECK(um_variant_find_geometry(context, evaluator, changes, out));
  if (heat != NULL) UM_CHECK(um_variant_find_heat(context, evaluator, heat, out));
done:
  um_core_quiet_end(context);
  return status;
}

enum um_status um_variant_open_over(struct um_context *context,
                                    struct um_variant_evaluator *evaluator,
                                    const struct um_model_instants *instants,
                                    const struct um_model_changes *changes,
                                    const struct um_variant_heat *heat, struct um_variant *out)
{
  enum um_status status;
  um_core_quiet_begin(context);
  UM_CHECK(make_model(context, evaluator, changes, out));
  UM_CHECK(um_variant_trace_over(context, evaluator, out->model, instants, &out->own_tables));
  out->tables = out->own_tables;
  out->fresh_geometry = true;
  if (heat != NULL) UM_CHECK(um_variant_heat_again(context, evaluator, heat, out));
done:
  um_core_quiet_end(context);
  return status;
}

/* Does light answer to the variant's temperatures alone, and is the answer known? */
static bool warms_alone(const struct um_variant_evaluator *e, const struct um_variant *v)
{
  return v->moved.light != NULL && v->heat == v->own_heat && v->tables == e->tables &&
         um_model_light_is_compatible(e->model, v->model);
}

static enum um_status observe_warmed(struct um_context *context, struct um_variant_evaluator *e,
                                     const struct um_variant *v, struct um_model_result **out)
{
  struct um_optics_lightcurve *light = NULL;
  UM_TRY(um_variant_share(context, e, UM_VARIANT_WARM, true));
  UM_TRY(um_model_light_move(context, e->light, v->moved.light, v->moved.which, v->moved.step,
                             &light));
  enum um_status status = um_model_run_behind(context, v->model, v->tables, v->heat, light, out);
  um_optics_lightcurve_destroy(context, &light);
  return status;
}

enum um_status um_variant_observe(struct um_context *context,
                                  struct um_variant_evaluator *evaluator,
                                  const struct um_variant *v, struct um_model_result **out)
{
  struct um_variant_evaluator *e = evaluator;
  *out = NULL;
  if (warms_alone(e, v)) return observe_warmed(context, e, v, out);
  if (!v->light_alike || v->heat != e->heat || v->tables != e->tables)
    return um_model_run_observed(context, v->model, v->tables, v->heat, out);
  UM_TRY(um_variant_share(context, e, UM_VARIANT_WARM, true));
  return um_model_run_behind(context, v->model, v->tables, v->heat, e->light, out);
}

void um_variant_close(struct um_context *context, struct um_variant *variant)
{
  if (variant->kept != NULL) variant->kept->users--;
  um_model_thermal_solution_destroy(context, &variant->own_heat);
  um_model_tables_destroy(context, &variant->own_tables);
  um_model_destroy(context, &variant->own_model);
  *variant = (struct um_variant){0};
}
