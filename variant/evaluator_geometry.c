/* Geometry of variants: the scenario's own, one that is kept, or traced anew. */
#include "effects/effects.h"
#include "model/build/build.h"
#include "model/geometry/compatible.h"
#include "variant/evaluator_impl.h"

static enum um_status keep_photons(struct um_context *context, struct um_variant_evaluator *e)
{
  if (!e->settings.photons) return UM_OK;
  return um_model_precompute_photons(context, e->model, e->tables);
}

enum um_status um_variant_base_geometry(struct um_context *context, struct um_variant_evaluator *e)
{
  if (e->tables != NULL) return UM_OK;
  UM_TRY(um_model_precompute_over(context, e->model, e->settings.instants, &e->tables));
  return keep_photons(context, e);
}

enum um_status um_variant_paths(struct um_context *context, struct um_variant_evaluator *evaluator,
                                int base, int others)
{
  for (struct um_variant_kept *kept = evaluator->cache.first; kept != NULL; kept = kept->next)
    kept->tables->sampling.paths = others;
  if (evaluator->tables->sampling.paths == base && evaluator->tables->photons != NULL) return UM_OK;
  um_variant_base_tables(context, evaluator)->sampling.paths = base;
  return keep_photons(context, evaluator);
}

enum um_status um_variant_trace_over(struct um_context *context,
                                     const struct um_variant_evaluator *e,
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
  if (e->settings.scaled) { /* of the scenario's, whatever was asked for before */
    UM_TRY(um_variant_base_geometry(context, e));
    UM_TRY(um_model_precompute_scaled(context, e->model, e->tables, v->model, e->settings.instants,
                                      &traced));
  }
  if (traced == NULL)
    UM_TRY(um_variant_trace_over(context, e, v->model, e->settings.instants, &traced));
  enum um_status status = um_variant_cache_add(context, &e->cache, key, nkey, e->tables,
                                               &v->own_model, &traced, &v->kept);
  um_model_tables_destroy(context, &traced);
  return status;
}

static void use(struct um_variant *v)
{
  v->kept->users++;
  v->tables = v->kept->tables;
}

size_t um_variant_reaching(const struct um_variant_evaluator *e, const struct um_model *model,
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
  size_t nkey = um_variant_reaching(e, v->model, changes->addition, changes->naddition, key);
  if (nkey > 0) {
    v->kept = um_variant_cache_find_key(&e->cache, key, nkey);
    if (v->kept == NULL) status = trace(context, e, key, nkey, v);
    if (status == UM_OK) use(v);
  } else {
    status = um_variant_base_geometry(context, e);
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

enum um_status um_variant_find_geometry(struct um_context *context, struct um_variant_evaluator *e,
                                        const struct um_model_changes *changes,
                                        struct um_variant *v)
{
  if (changes->nkey + changes->nwith + changes->nwithout == 0)
    return find_by_effects(context, e, changes, v);
  return find_by_numbers(context, e, v);
}
