/* Sunlight and moonlight that the air scatters into a run's line of sight. */
#ifndef UMBRA_MODEL_SKY_LIGHT_H
#define UMBRA_MODEL_SKY_LIGHT_H

#include "model/build/model.h"
#include "model/geometry/tables.h"
#include "optics/instrument/photometry.h"

#define UM_MODEL_SKY_NODES 91

/* The scattered light of a direction at an instant. */
struct um_model_sky {
  const struct um_environment *environment;
  bool lit;
  double relative[UM_MODEL_SKY_NODES]; /* radiance over the Sun's irradiance at 1 au [1/sr], every
                                          10 nm from 0.30 um on */
};
/* Behind the satellite at observation k, for wavelengths between two [m]. Dark without
 * model->sky_light, without the effect atmosphere, below the horizon. The Moon counts while the Sun
 * is more than 1 deg down, where moonlight is on. */
void um_model_sky(const struct um_model *model, const struct um_model_tables *tables, size_t k,
                  double from, double to, struct um_model_sky *out);
/* Mean radiance between two wavelengths of those [m] [W/m^2/sr/m]. Test: model/sky_light. */
double um_model_sky_radiance(const struct um_model_sky *sky, double from, double to);
/* The same through a filter [W/m^2/sr]. */
double um_model_sky_band(const struct um_model_sky *sky, const struct um_instrument_bins *bins);

#endif
