/* One scenario, computed again and again with something changed. */
#include "variant/evaluator.h"

#include <omp.h>

#include "effects/effects.h"
#include "model/build/build.h"
#include "model/geometry/compatible.h"
#include "model/run/run.h"
#include "variant/cache_impl.h"

struct um_variant_evaluator {
  const struct um_model *model; /* the scenario as it stands */
  struct um_variant_settings settings;
  struct um_model_tables *tables;         /* its geometry; NULL: not yet */
  struct um_model_thermal_solution *heat; /* and heat */
  struct um_optics_lightcurve *light;     /* and light */
  bool lent;                              /* geometry and heat are an open variant's */
  double seconds_heat;                    /* wall time that it took [s] */
  struct um_variant_cache cache;          /* of variants */
};

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

bool um_variant_evaluator_is_full(const struct um_variant_evaluator *evaluator)
{
  size_t bytes = 0;
  for (const struct um_variant_kept *k = evaluator->cache.first; k != NULL; k = k->next)
    bytes += k->users > 0 ? k->bytes : 0;
  return bytes > evaluator->cache.most;
}

/* --- geometry -------------------------------------------------------------------------------- */

static enum um_status keep_photons(struct um_context *context, struct um_variant_evaluator *e)
{
  if (!e->settings.photons) return UM_OK;
  return um_model_precompute_photons(context, e->model, e->tables);
}

static enum um_status base_geometry(struct um_context *context, struct um_variant_evaluator *e)
{
  if (e->tables != NULL) return UM_OK;
  UM_TRY(um_model_precompute_over(context, e->model, e->settings.instants, &e->tables));
  return keep_photons(context, e);
}

enum um_status um_variant_paths(struct um_context *context, struct um_variant_evaluator *evaluator,
                                int paths)
{
  struct um_model_tables *base = um_variant_base_tables(context, evaluator);
  base->sampling.paths = paths;
  for (struct um_variant_kept *kept = evaluator->cache.first; kept != NULL; kept = kept->next)
    kept->tables->sampling.paths = paths;
  return keep_photons(context, evaluator);
}

/* Over instants, with what the scenario's own geometry, if it is traced, has of the body alone. */
static enum um_status trace_over(struct um_context *context, const struct um_variant_evaluator *e,
                                 const struct um_model *model,
                                 const struct um_model_instants *instants,
                                 struct um_model_tables **out)
{
  if (e->tables == NULL) return um_model_precompute_over(context, model, instants, out);
  return um_model_precompute_like(context, e->model, e->tables, model, instants, out);
}

static enum um_status trace(struct um_context *context, struct um_variant_evaluator *e,
                            const struct um_model_addition *key, size_t nkey, struct um_variant *v)
{
  struct um_model_tables *traced = NULL;
  v->fresh_geometry = true;
  UM_TRY(trace_over(context, e, v->model, e->settings.instants, &traced));
  enum um_status status =
      um_variant_cache_add(context, &e->cache, key, nkey, &v->own_model, &traced, &v->kept);
  um_model_tables_destroy(context, &traced);
  return status;
}

static void use(struct um_variant *v)
{
  v->kept->users++;
  v->tables = v->kept->tables;
}

/* The additions that reach the geometry of the scenario with them, into key [naddition]; NULL: they
 * are counted. */
static size_t reaching(const struct um_variant_evaluator *e, const struct um_model *model,
                       const struct um_model_addition *addition, size_t naddition,
                       struct um_model_addition *key)
{
  size_t nkey = 0;
  bool lit = !um_model_light_is_compatible(e->model, model);
  for (size_t i = 0; i < naddition; i++) {
    uint32_t reach = um_effects_reach(addition[i].effect);
    if ((reach & UM_REACH_GEOMETRY) == 0 && !(lit && (reach & UM_REACH_LIGHT) != 0)) continue;
    if (key != NULL) key[nkey] = addition[i];
    nkey++;
  }
  return nkey;
}

/* By what effects declare: the scenario's own geometry where none reaches it, else one that was
 * traced for the same, or a new one. */
static enum um_status find_by_effects(struct um_context *context, struct um_variant_evaluator *e,
                                      const struct um_model_changes *changes, struct um_variant *v)
{
  enum um_status status = UM_OK;
  struct um_model_addition *key = NULL;
  UM_TRY(um_core_allocate(context, changes->naddition, sizeof *key, &key));
  size_t nkey = reaching(e, v->model, changes->addition, changes->naddition, key);
  if (nkey > 0) {
    v->kept = um_variant_cache_find_key(&e->cache, key, nkey);
    if (v->kept == NULL) status = trace(context, e, key, nkey, v);
    if (status == UM_OK) use(v);
  } else {
    status = base_geometry(context, e);
    v->tables = e->tables;
  }
  um_core_free(context, key);
  return status;
}

/* By what geometries are built of: the scenario's own, if it is traced, one that is kept, or a new
 * one. */
static enum um_status find_by_numbers(struct um_context *context, struct um_variant_evaluator *e,
                                      struct um_variant *v)
{
  const struct um_model_instants *instants = e->settings.instants;
  bool compatible = false;
  if (e->tables != NULL)
    UM_TRY(um_model_tables_are_compatible(context, e->model, e->tables, instants, v->model,
                                          &compatible));
  v->tables = e->tables;
  if (compatible) return UM_OK;
  UM_TRY(um_variant_cache_find(context, &e->cache, v->model, instants, &v->kept));
  if (v->kept == NULL) UM_TRY(trace(context, e, NULL, 0, v));
  use(v);
  return UM_OK;
}

static enum um_status find_geometry(struct um_context *context, struct um_variant_evaluator *e,
                                    const struct um_model_changes *changes, struct um_variant *v)
{
  if (changes->nkey + changes->nwith + changes->nwithout == 0)
    return find_by_effects(context, e, changes, v);
  return find_by_numbers(context, e, v);
}

/* --- heat ------------------------------------------------------------------------------------ */

static enum um_status base_heat(struct um_context *context, struct um_variant_evaluator *e)
{
  if (e->heat != NULL) return UM_OK;
  UM_TRY(base_geometry(context, e));
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
  if (how->start != UM_VARIANT_COLD) UM_TRY(base_heat(context, e));
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
  if (how->start != UM_VARIANT_COLD) UM_TRY(base_heat(context, e));
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

/* --- variants -------------------------------------------------------------------------------- */

enum um_status um_variant_base(struct um_context *context, struct um_variant_evaluator *evaluator,
                               struct um_variant *out)
{
  UM_TRY(base_heat(context, evaluator));
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
  UM_TRY(base_geometry(context, e));
  if (start == UM_VARIANT_COLD) return UM_OK;
  UM_TRY(base_heat(context, e));
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
  enum um_status status = make_model(context, evaluator, &changes, &v);
  *out = status == UM_OK && reaching(evaluator, v.model, addition, naddition, NULL) > 0;
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
  UM_CHECK(find_geometry(context, evaluator, changes, out));
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
  UM_CHECK(trace_over(context, evaluator, out->model, instants, &out->own_tables));
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
