/* Steps of a run, private to the folder. */
#ifndef UMBRA_MODEL_RUN_IMPL_H
#define UMBRA_MODEL_RUN_IMPL_H

#include "model/model.h"

/* Temperatures at every instant of the trace (run_thermal.c). history: rows are an instant one
 * orbit before the first (when `before`), then the trace's instants. */
struct um_model_heat_run {
  struct um_thermal_history *history;
  bool before;
  double *surface; /* [ninstant][nsurface] [K] */
};
struct um_model_heat {
  const struct um_model *model;       /* borrowed */
  const struct um_model_trace *trace; /* borrowed */
  struct um_thermal_solve_options options;
  double *start;         /* [nnode] start temperatures [K] */
  double periodic_drift; /* what the periodic start left [K]; NaN when isothermal */
  struct um_model_heat_run run;
};
/* What interiors have stored from before: added to start temperatures [nnode]; the same in both
 * models, whose networks are equal (start_offset.c). UM_ERR_INPUT below 0 K. */
enum um_status um_model_start_offset_add(struct um_context *context, const struct um_model *model,
                                         double *temperature);
bool um_model_start_offset_equal(const struct um_model *a, const struct um_model *b);
/* Histories of places and their heat (run_places.c). */
enum um_status um_model_run_places(struct um_context *context, const struct um_model *model,
                                   const struct um_model_trace *trace,
                                   const struct um_model_heat_run *run,
                                   struct um_model_result *result);
/* Light curves (run_optics.c). */
enum um_status um_model_run_optics(struct um_context *context, const struct um_model *model,
                                   const struct um_model_trace *trace,
                                   const struct um_model_heat_run *run,
                                   struct um_model_result *result);
/* Scene of the trace's instants for the optics; albedo and view_factor are gathered into new
 * memory that um_model_scene_release frees. */
enum um_status um_model_scene_make(struct um_context *context, const struct um_model *model,
                                   const struct um_model_trace *trace, const double *surface,
                                   struct um_optics_scene *out);
void um_model_scene_release(struct um_context *context, struct um_optics_scene *scene);

#endif
