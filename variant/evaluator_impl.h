/* An evaluator, and what its files give each other. Private to variant/. */
#ifndef UMBRA_VARIANT_EVALUATOR_IMPL_H
#define UMBRA_VARIANT_EVALUATOR_IMPL_H

#include "variant/cache_impl.h"
#include "variant/evaluator.h"

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

/* --- evaluator_geometry.c -------------------------------------------------------------------- */

/* The scenario's own, traced once. */
enum um_status um_variant_base_geometry(struct um_context *context, struct um_variant_evaluator *e);
/* Over instants, with what the scenario's own geometry, if it is traced, has of the body alone. */
enum um_status um_variant_trace_over(struct um_context *context,
                                     const struct um_variant_evaluator *e,
                                     const struct um_model *model,
                                     const struct um_model_instants *instants,
                                     struct um_model_tables **out);
/* The additions that reach the geometry of the scenario with them, into key [naddition]; NULL: they
 * are counted. */
size_t um_variant_reaching(const struct um_variant_evaluator *e, const struct um_model *model,
                           const struct um_model_addition *addition, size_t naddition,
                           struct um_model_addition *key);
/* That of a variant with a model: the scenario's own, one that is kept, or a new one. */
enum um_status um_variant_find_geometry(struct um_context *context, struct um_variant_evaluator *e,
                                        const struct um_model_changes *changes,
                                        struct um_variant *v);

/* --- evaluator_heat.c ------------------------------------------------------------------------ */

/* The scenario's own, solved once. */
enum um_status um_variant_base_heat(struct um_context *context, struct um_variant_evaluator *e);

#endif
