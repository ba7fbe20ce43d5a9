/* Geometries that are kept, least recently used ones given up first. Private to variant/. */
#ifndef UMBRA_VARIANT_CACHE_IMPL_H
#define UMBRA_VARIANT_CACHE_IMPL_H

#include "model/build/model.h"
#include "model/geometry/precompute.h"
#include "model/run/thermal_solution.h"
#include "variant/tolerance.h"

/* A geometry, the model it was traced of, and heat on it. */
struct um_variant_kept {
  struct um_model_addition *key; /* [nkey] effects that reach it, targets owned; NULL: of changes of
                                    keys, too */
  size_t nkey;
  struct um_model *model;
  struct um_model_tables *tables;
  struct um_model_thermal_solution *heat; /* of `model`; NULL: not asked for, or that of another */
  struct um_variant_tolerance tolerance;  /* of that heat */
  size_t bytes;                           /* of geometry and heat */
  size_t used;                            /* when it was asked for last */
  size_t users;                           /* variants that are open on it: it is not given up */
  struct um_variant_kept *next;
};
struct um_variant_cache {
  struct um_variant_kept *first;
  size_t bytes, most; /* that they take, and may take */
  size_t clock;
};

/* The one whose geometry serves the model, by what it is built of (um_model_tables_are_compatible);
 * *out NULL: none does. */
enum um_status um_variant_cache_find(struct um_context *context, struct um_variant_cache *cache,
                                     const struct um_model *model,
                                     const struct um_model_instants *instants,
                                     struct um_variant_kept **out);
/* The one that was traced for the same effects with the same numbers; NULL: none. Nothing is looked
 * at but the key. */
struct um_variant_kept *um_variant_cache_find_key(struct um_variant_cache *cache,
                                                  const struct um_model_addition *key, size_t nkey);
/* Takes model and geometry, and gives up others for them; what is larger than all that may be kept
 * stays until the next. key: copied; NULL: it is found by what it is built of alone. UM_ERR_MEMORY:
 * they stay the caller's. like: who holds what it shares of the body, which is
 * not counted; NULL: nobody. */
enum um_status um_variant_cache_add(struct um_context *context, struct um_variant_cache *cache,
                                    const struct um_model_addition *key, size_t nkey,
                                    const struct um_model_tables *like, struct um_model **model,
                                    struct um_model_tables **tables, struct um_variant_kept **out);
/* Takes heat of a kept model, which has none yet. */
void um_variant_cache_keep_heat(struct um_variant_cache *cache, struct um_variant_kept *kept,
                                struct um_model_thermal_solution **heat,
                                struct um_variant_tolerance tolerance);
void um_variant_cache_clear(struct um_context *context, struct um_variant_cache *cache);

#endif
