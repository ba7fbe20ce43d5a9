/* Building the light that the air scatters. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_SKY_LIGHT_IMPL_H
#define UMBRA_MODEL_BUILD_SKY_LIGHT_IMPL_H

#include "model/build/model.h"

/* What observer.air scatters in the wavelengths of the model's bands, into model->sky_light; left
 * NULL without air, with air of a file, whose radiance is the file's, and where no band is known.
 * A variant borrows that of its origin where it is the same. After the bands. UM_ERR_MEMORY. */
enum um_status um_model_build_sky_light(struct um_context *context, struct um_model *model);

#endif
