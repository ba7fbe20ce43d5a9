/* What a scenario's telescope counts of a star. */
#ifndef UMBRA_MODEL_STAR_H
#define UMBRA_MODEL_STAR_H

#include "model/build/model.h"

/* Counts per second of a star of an AB magnitude that is the same at every wavelength, through the
 * air of the scenario at an airmass (NAN: none on the way) and the effects on what sensor s counts
 * but saturation, at a time t_tai [s]. UM_ERR_MEMORY and what effects say. */
enum um_status um_model_star_rate(struct um_context *context, const struct um_model *model,
                                  size_t s, double magnitude, double airmass, double t_tai,
                                  double *rate);

#endif
