/* Geometries that are kept, least recently used ones given up first. */
#include "variant/cache_impl.h"

#include <stdint.h>

#include "base/core/suggestions.h"
#include "model/build/build.h"
#include "model/geometry/compatible.h"

enum um_status um_variant_cache_find(struct um_context *context, struct um_variant_cache *cache,
                                     const struct um_model *model,
                                     const struct um_model_instants *instants,
                                     struct um_variant_kept **out)
{
  *out = NULL;
  for (struct um_variant_kept *k = cache->first; k != NULL; k = k->next) {
    bool compatible = false;
    UM_TRY(
        um_model_tables_are_compatible(context, k->model, k->tables, instants, model, &compatible));
    if (!compatible) continue;
    k->used = ++cache->clock;
    *out = k;
    return UM_OK;
  }
  return UM_OK;
}

static bool additions_equal(const struct um_model_addition *a, const struct um_model_addition *b)
{
  if (a->effect != b->effect || a->off != b->off || !um_core_words_same(a->target, b->target))
    return false;
  for (size_t p = 0; p < a->effect->nparameter; p++)
    if (a->value[p] != b->value[p]) return false;
  return true;
}

struct um_variant_kept *um_variant_cache_find_key(struct um_variant_cache *cache,
                                                  const struct um_model_addition *key, size_t nkey)
{
  for (struct um_variant_kept *k = cache->first; k != NULL; k = k->next) {
    bool same = k->key != NULL && k->nkey == nkey;
    for (size_t i = 0; i < nkey && same; i++) same = additions_equal(&k->key[i], &key[i]);
    if (!same) continue;
    k->used = ++cache->clock;
    return k;
  }
  return NULL;
}

static void drop(struct um_context *context, struct um_variant_cache *cache,
                 struct um_variant_kept **link)
{
  struct um_variant_kept *k = *link;
  *link = k->next;
  cache->bytes -= k->bytes;
  for (size_t i = 0; i < k->nkey; i++) um_core_free(context, (void *)(uintptr_t)k->key[i].target);
  um_core_free(context, k->key);
  um_model_thermal_solution_destroy(context, &k->heat);
  um_model_tables_destroy(context, &k->tables);
  um_model_destroy(context, &k->model);
  um_core_free(context, k);
}

/* The least recently used one that no variant is open on; NULL: there is none. */
static struct um_variant_kept **oldest(struct um_variant_cache *cache)
{
  struct um_variant_kept **found = NULL;
  for (struct um_variant_kept **link = &cache->first; *link != NULL; link = &(*link)->next)
    if ((*link)->users == 0 && (found == NULL || (*link)->used < (*found)->used)) found = link;
  return found;
}

static enum um_status keep_key(struct um_context *context, const struct um_model_addition *key,
                               size_t nkey, struct um_variant_kept *kept)
{
  UM_TRY(um_core_allocate(context, nkey, sizeof *kept->key, &kept->key));
  for (size_t i = 0; i < nkey; i++) {
    char *target = NULL;
    if (key[i].target != NULL) UM_TRY(um_core_strdup(context, key[i].target, &target));
    kept->key[i] = key[i];
    kept->key[i].target = target;
    kept->nkey++;
  }
  return UM_OK;
}

enum um_status um_variant_cache_add(struct um_context *context, struct um_variant_cache *cache,
                                    const struct um_model_addition *key, size_t nkey,
                                    const struct um_model_tables *like, struct um_model **model,
                                    struct um_model_tables **tables, struct um_variant_kept **out)
{
  struct um_variant_kept *kept = NULL, **link;
  size_t bytes = um_model_tables_bytes(*tables, like);
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *kept, &kept));
  enum um_status status = key != NULL ? keep_key(context, key, nkey, kept) : UM_OK;
  if (status != UM_OK) {
    drop(context, cache, &kept);
    return status;
  }
  while (cache->bytes + bytes > cache->most && (link = oldest(cache)) != NULL)
    drop(context, cache, link);
  kept->model = *model;
  kept->tables = *tables;
  kept->bytes = bytes;
  kept->used = ++cache->clock;
  kept->next = cache->first;
  cache->first = kept;
  cache->bytes += bytes;
  *model = NULL;
  *tables = NULL;
  *out = kept;
  return UM_OK;
}

void um_variant_cache_keep_heat(struct um_variant_cache *cache, struct um_variant_kept *kept,
                                struct um_model_thermal_solution **heat,
                                struct um_variant_tolerance tolerance)
{
  size_t bytes = um_model_thermal_solution_bytes(*heat);
  kept->heat = *heat;
  kept->tolerance = tolerance;
  kept->bytes += bytes;
  cache->bytes += bytes;
  *heat = NULL;
}

void um_variant_cache_clear(struct um_context *context, struct um_variant_cache *cache)
{
  while (cache->first != NULL) drop(context, cache, &cache->first);
}
