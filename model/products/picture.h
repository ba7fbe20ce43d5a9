/* Pictures of the satellite. */
#ifndef UMBRA_MODEL_PICTURE_H
#define UMBRA_MODEL_PICTURE_H

#include "model/build/model.h"
#include "model/geometry/tables.h"
#include "model/run/result.h"
#include "optics/image/image.h"

/* Picture of observation k in bands [band, band + nband), up being away from the Earth; see
 * um_optics_image_render. UM_ERR_INPUT without an observer. */
enum um_status um_model_picture(struct um_context *context, const struct um_model *model,
                                const struct um_model_tables *tables,
                                const struct um_model_result *result, size_t k, size_t band,
                                size_t nband, int width, int samples_per_pixel,
                                struct um_optics_image **out);
/* Radiance of every surface in every band at observation k, toward the observer,
 * out[nband][nsurface] [W/m^2/sr]; see um_optics_surface_radiance. UM_ERR_INPUT without an
 * observer. */
enum um_status um_model_surface_radiance(struct um_context *context, const struct um_model *model,
                                         const struct um_model_tables *tables,
                                         const struct um_model_result *result, size_t k,
                                         double *out);
/* What such a picture at an instant t_tai [s] (light received) will cost, before heat and light are
 * computed; see um_optics_image_estimate. UM_ERR_INPUT without an observer. */
enum um_status um_model_picture_estimate(struct um_context *context, const struct um_model *model,
                                         double t_tai, size_t band, int width,
                                         int samples_per_pixel, struct um_optics_image_cost *out);

#endif
