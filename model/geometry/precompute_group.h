/* Times of observations and of loads. Private to the rooms of model/. */
#ifndef UMBRA_MODEL_PRECOMPUTE_GROUP_H
#define UMBRA_MODEL_PRECOMPUTE_GROUP_H

#include "model/build/model.h"
#include "model/geometry/precompute.h"
#include "model/geometry/tables.h"

/* The time at which an observation of that tag was really made, of a set of measurements or, NULL,
 * of none. */
double um_model_true_time(const struct um_model *model, const char *set, double tag);

/* The set of measurements of an observation; NULL: of none. */
const char *um_model_instant_set(const struct um_model_instants *instants, size_t k);
/* What tables remember of that. */
enum um_status um_model_tables_keep_sets(struct um_context *context,
                                         const struct um_model_instants *instants,
                                         struct um_model_tables *tables);

/* What geometry tables are to be of, before anything is traced. */
struct um_model_precompute_plan {
  struct um_model_tables *tables; /* observations, span, turn, events; no loads, no view */
  double *grid;                   /* [ngrid] times of the loads */
  size_t ngrid;
  double *edge; /* [tables->nevent] times at which the integration stops */
};
/* instants NULL, or without times: over the scenario's own window. Errors of
 * um_model_precompute_at. Cleared by the caller, after a failure too. */
enum um_status um_model_precompute_plan(struct um_context *context, const struct um_model *model,
                                        const struct um_model_instants *instants,
                                        struct um_model_precompute_plan *out);
void um_model_precompute_plan_clear(struct um_context *context,
                                    struct um_model_precompute_plan *plan);

/* Observations of an orbit alone: what is seen when, from where; no loads, no lines of sight.
 * Errors of um_model_precompute_at; the caller destroys. */
enum um_status um_model_precompute_observed(struct um_context *context,
                                            const struct um_model *model,
                                            const struct um_model_instants *instants,
                                            struct um_model_tables **out);

/* Lines of sight of what stands in the geometry tables, and its sampling; none without an
 * observer. Errors of um_optics_view_trace. */
enum um_status um_model_precompute_view(struct um_context *context, const struct um_model *model,
                                        struct um_model_sampling sampling,
                                        struct um_model_tables *tables);

/* As um_model_precompute_over without points, with tables that serve the model (body_tables.h);
 * NULL: they are traced. */
enum um_status um_model_precompute_with(struct um_context *context, const struct um_model *model,
                                        const struct um_model_instants *instants,
                                        struct um_model_body_tables *body,
                                        struct um_model_tables **out);

#endif
