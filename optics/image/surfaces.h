/* How bright every surface is toward the observer, at one instant. */
#ifndef UMBRA_OPTICS_SURFACES_H
#define UMBRA_OPTICS_SURFACES_H

#include "optics/radiance/optics.h"

/* Radiance of each surface in each band, what passes the filter, out[nband][nsurface] [W/m^2/sr]:
 * the mean over what the observer sees of it, NaN where that is less than 2 % of it. Times seen
 * area and cosine and summed it is the intensity of the light curve, within the sampling error of
 * light between surfaces. scene and time as in um_optics_image_render; view: of its geometry, whose
 * instant view_time is the sample. UM_ERR_MEMORY, UM_ERR_LIBRARY, UM_ERR_CANCELLED. Same bytes for
 * any number of threads. */
enum um_status um_optics_surface_radiance(struct um_context *context,
                                          const struct um_optics_scene *scene, size_t time,
                                          const struct um_optics_view *view, size_t view_time,
                                          const struct um_optics_band *bands, size_t nband,
                                          double *out);

#endif
