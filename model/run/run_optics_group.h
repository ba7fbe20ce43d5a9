/* Light of a run. Private to the rooms of model/. */
#ifndef UMBRA_MODEL_RUN_OPTICS_GROUP_H
#define UMBRA_MODEL_RUN_OPTICS_GROUP_H

#include "model/run/result.h"
#include "model/run/thermal_solution_group.h"

/* What air and instrument make of a light curve (um_model_run_light); NULL: nothing. */
enum um_status um_model_run_optics(struct um_context *context, const struct um_model *model,
                                   const struct um_model_tables *tables,
                                   const struct um_optics_lightcurve *curve,
                                   struct um_model_result *result);
/* A band irradiance [W/m^2] through all effects on observations, in order: those of the sky, then
 * switches of the detector. set: of measurements; NULL: none. at->value is not read. */
enum um_status um_model_observe(struct um_context *context, const struct um_model *model,
                                const char *set, const struct um_effect_observation *at,
                                double *value);
/* Scene of the geometry tables' instants for the optics; albedo, view_factor, brightness
 * and, where surfaces age, adjustment are new memory that um_model_scene_release frees. */
enum um_status um_model_scene_make(struct um_context *context, const struct um_model *model,
                                   const struct um_model_tables *tables, const double *surface,
                                   struct um_optics_scene *out);
/* Paths of light between surfaces of runs on the geometry tables; 0 where they are off. */
int um_model_paths(const struct um_model *model, const struct um_model_tables *tables);
void um_model_scene_release(struct um_context *context, struct um_optics_scene *scene);

#endif
