/* The arrays of a light curve. Private to optics/lightcurve/. */
#ifndef UMBRA_OPTICS_CURVE_IMPL_H
#define UMBRA_OPTICS_CURVE_IMPL_H

#include "optics/radiance/radiance_group.h"

/* Of zeros but for the bins. um_optics_lightcurve_destroy, after a failure too. */
enum um_status um_optics_curve_create(struct um_context *context,
                                      const struct um_optics_spectra *spectra, size_t ntime,
                                      struct um_optics_lightcurve *curve);

#endif
