/* A run of both halves. */
#ifndef UMBRA_MODEL_RUN_H
#define UMBRA_MODEL_RUN_H

#include "model/build/model.h"
#include "model/run/result.h"
#include "model/run/run_light.h"
#include "model/run/thermal_solution.h"

/* Run on geometry tables made from the same model. Where the scenario asks for a relative
 * error (optics.relative_error), its lines of sight are traced again with the points that this
 * takes, and stay so. */
enum um_status um_model_run(struct um_context *context, const struct um_model *model,
                            struct um_model_tables *tables, struct um_model_result **out);
/* The same, and what finer facets would change of it (result->mesh). */
enum um_status um_model_run_stated(struct um_context *context, const struct um_model *model,
                                   struct um_model_tables *tables, struct um_model_result **out);

/* Run with heat that matches. um_model_run is this with heat of its own and a factor on tolerances
 * of 1. */
enum um_status um_model_run_with(struct um_context *context, const struct um_model *model,
                                 const struct um_model_tables *tables,
                                 const struct um_model_thermal_solution *heat,
                                 struct um_model_result **out);
/* The same for who asks for what is observed alone, light and temperatures: the result has no heat
 * of places (heat is NULL). */
enum um_status um_model_run_observed(struct um_context *context, const struct um_model *model,
                                     const struct um_model_tables *tables,
                                     const struct um_model_thermal_solution *heat,
                                     struct um_model_result **out);

/* um_model_run_observed of the body turned by a rotation vector in its own axes [rad] at every
 * observed instant, with the temperatures and the loads that it has: lines of sight alone are
 * traced anew. */
enum um_status um_model_run_turned(struct um_context *context, const struct um_model *model,
                                   const struct um_model_tables *tables,
                                   const struct um_model_thermal_solution *heat,
                                   struct um_vec3 turn, struct um_model_result **out);

/* um_model_run_observed of a model whose light is at hand: air, instrument and temperatures. */
enum um_status um_model_run_behind(struct um_context *context, const struct um_model *model,
                                   const struct um_model_tables *tables,
                                   const struct um_model_thermal_solution *heat,
                                   const struct um_optics_lightcurve *light,
                                   struct um_model_result **out);
/* The light of um_model_run_cold_light through air and instrument: the result has neither
 * temperatures nor heat, and its numbers of bands beyond 2.5 um mean nothing. Errors of
 * um_model_run_observed. Test: model/run/cold. */
enum um_status um_model_run_cold(struct um_context *context, const struct um_model *model,
                                 const struct um_model_tables *tables,
                                 struct um_model_result **out);
/* Temperatures of places alone: the result has no light and no heat. */
enum um_status um_model_run_places(struct um_context *context, const struct um_model *model,
                                   const struct um_model_tables *tables,
                                   const struct um_model_thermal_solution *heat,
                                   struct um_model_result **out);

#endif
