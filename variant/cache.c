/* Geometries that are kept, least recently used ones given up first. */
#include "variant/cache_impl.h"

#include "model/build.h"
#include "model/precomputed_serves.h"

enum um_status um_variant_cache_find(struct um_context *context, struct um_variant_cache *cache,
                                     const struct um_model *model,
                                     const struct um_model_instants *instants,
                                     struct um_variant_kept **out)
{
  *out = NULL;
  for (struct um_variant_kept *k = cache->first; k != NULL; k = k->next) {
    bool serves = false;
    UM_TRY(
        um_model_precomputed_serves(context, k->model, k->precomputed, instants, model, &serves));
    if (!serves) continue;
    k->used = ++cache->clock;
    *out = k;
    return UM_OK;
  }
  return UM_OK;
}

static void drop(struct um_context *context, struct um_variant_cache *cache,
                 struct um_variant_kept **link)
{
  struct um_variant_kept *k = *link;
  *link = k->next;
  cache->bytes -= k->bytes;
  um_model_thermal_solution_destroy(context, &k->heat);
  um_model_precomputed_destroy(context, &k->precomputed);
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

enum um_status um_variant_cache_add(struct um_context *context, struct um_variant_cache *cache,
                                    struct um_model **model,
                                    struct um_model_precomputed **precomputed,
                                    struct um_variant_kept **out)
{
  struct um_variant_kept *kept = NULL, **link;
  size_t bytes = um_model_precomputed_bytes(*precomputed);
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *kept, &kept));
  while (cache->bytes + bytes > cache->most && (link = oldest(cache)) != NULL)
    drop(context, cache, link);
  *kept = (struct um_variant_kept){.model = *model,
                                   .precomputed = *precomputed,
                                   .bytes = bytes,
                                   .used = ++cache->clock,
                                   .next = cache->first};
  cache->first = kept;
  cache->bytes += bytes;
  *model = NULL;
  *precomputed = NULL;
  *out = kept;
  return UM_OK;
}

void um_variant_cache_clear(struct um_context *context, struct um_variant_cache *cache)
{
  while (cache->first != NULL) drop(context, cache, &cache->first);
}
