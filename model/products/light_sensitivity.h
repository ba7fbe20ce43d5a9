/* How the light of a run answers to parameters that move its temperatures alone: one pass over what
 * is seen and over the paths between surfaces serves all of them (optics/lightcurve/warmth.h). */
#ifndef UMBRA_MODEL_LIGHT_SENSITIVITY_H
#define UMBRA_MODEL_LIGHT_SENSITIVITY_H

#include "model/products/thermal_sensitivity.h"
#include "optics/radiance/optics.h"

struct um_model_light_sensitivity;

/* Of all parameters of the sensitivity, at the temperatures of the heat that it was made of; *out
 * is NULL without an observer, and where optics see the means of materials. Errors of
 * um_model_run_light. The caller destroys. */
enum um_status um_model_light_sensitivity_create(struct um_context *context,
                                                 const struct um_model_thermal_sensitivity *thermal,
                                                 struct um_model_light_sensitivity **out);
void um_model_light_sensitivity_destroy(struct um_context *context,
                                        struct um_model_light_sensitivity **sensitivity);
/* The light that parameter `which`, moved by `step` [its unit], makes of that of the same run
 * (um_model_run_light). The caller destroys by um_optics_lightcurve_destroy. */
enum um_status um_model_light_move(struct um_context *context,
                                   const struct um_optics_lightcurve *light,
                                   const struct um_model_light_sensitivity *sensitivity,
                                   size_t which, double step, struct um_optics_lightcurve **out);

#endif
