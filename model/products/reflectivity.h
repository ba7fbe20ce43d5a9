/* What a body sends of sunlight toward an observer, by directions in body axes alone. */
#ifndef UMBRA_MODEL_REFLECTIVITY_H
#define UMBRA_MODEL_REFLECTIVITY_H

#include "model/build/model.h"

/* Reflectivity of the body for n pairs of unit directions in body axes, to the Sun and to the
 * observer: radiant intensity of sunlight reflected once over the irradiance of the Sun, in each
 * band and through its filter,
 *   M = int I T d lambda / int E T d lambda = sum over facets of A V cos_i cos_o f   [m^2/sr]
 * value[n][nband]; error[n][nband] its standard error by the traced fractions, or NULL. The Sun is
 * a disc as seen from 1 au; joints that follow the Sun follow it; surfaces are as at
 * time.start_utc. The Earth, light between surfaces and heat are not in it. Work is done in blocks
 * of bounded memory; progress: one step per pair, `task` names it. Directions that are opposite are
 * allowed. UM_ERR_INPUT, UM_ERR_MEMORY, UM_ERR_LIBRARY, UM_ERR_CANCELLED. Checks:
 * tests/model/products/reflectivity.c. */
enum um_status um_model_reflectivity(struct um_context *context, const struct um_model *model,
                                     const char *task, const struct um_vec3 *sun,
                                     const struct um_vec3 *observer, size_t n, double *value,
                                     double *error);

/* Irradiance of the Sun through the filter of a band at 1 au, above all air [W/m^2]. */
double um_model_solar_irradiance(const struct um_model *model, size_t band);
/* Sunlight at a place per bin of a band, with distance, shadow and the Earth's air at its edge;
 * out[bins] [W/m^2/m]. */
void um_model_sunlight(const struct um_model *model, const struct um_environment_sample *sample,
                       size_t band, double *out);
/* The same through the filter [W/m^2]; scratch [bins of the band]. */
double um_model_sunlight_band(const struct um_model *model,
                              const struct um_environment_sample *sample, size_t band,
                              double *scratch);

#endif
