/* What a user says of a frame. */
#ifndef UMBRA_APP_FRAME_OPTIONS_H
#define UMBRA_APP_FRAME_OPTIONS_H

#include "app/app.h"
#include "model/products/frame.h"

/* --psf, --motion, --seed, --border, --width and --samples; stars are left to the caller.
 * UM_ERR_INPUT names the option. */
enum um_status um_app_frame_options(struct um_context *context,
                                    const struct um_app_options *options,
                                    struct um_model_frame_options *out, uint64_t *seed);

#endif
