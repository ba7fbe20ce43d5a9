/* What is measured: its name, its unit, and its value in linear flux. Nothing here fails. */
#ifndef UMBRA_COMPARE_QUANTITY_H
#define UMBRA_COMPARE_QUANTITY_H

#include <stdbool.h>

enum um_compare_quantity {
  UM_QUANTITY_BAND_IRRADIANCE,   /* at the aperture [W/m^2] */
  UM_QUANTITY_RADIANT_INTENSITY, /* [W/sr] */
  UM_QUANTITY_MAGNITUDE_AB,      /* exo-atmospheric, photon counting */
  UM_QUANTITY_MAGNITUDE_VEGA,
  UM_QUANTITY_COUNT_RATE,                 /* [1/s] */
  UM_QUANTITY_TEMPERATURE,                /* [K] */
  UM_QUANTITY_CHARACTERISTIC_TEMPERATURE, /* of all thermal bands together [K] */
  UM_QUANTITY_INFRARED_CROSS_SECTION,     /* [m^2] */
  UM_QUANTITY_COUNT
};
/* What stands in the column `of` of quantities of all thermal bands together. */
#define UM_COMPARE_THERMAL "thermal"

/* Name as in files ("band_irradiance") and unit ("W/m^2"); borrowed. */
const char *um_compare_quantity_name(enum um_compare_quantity quantity);
const char *um_compare_quantity_unit(enum um_compare_quantity quantity);

/* Of all thermal bands together (optics/instrument/grey_body.h)? */
bool um_compare_is_grey_body(enum um_compare_quantity quantity);
bool um_compare_is_magnitude(enum um_compare_quantity quantity);
/* Unit of residuals: magnitudes are compared as flux. Borrowed. */
const char *um_compare_residual_unit(enum um_compare_quantity quantity);

/* A value and its sigma in linear flux: magnitudes become flux relative to magnitude 0,
 *   F = 10^(-0.4 m),  sigma_F = 0.4 ln 10 F sigma_m,
 * +infinity being no light; other quantities pass through. sigma NaN stays NaN. */
struct um_compare_linear {
  double value, sigma;
};
struct um_compare_linear um_compare_linear(enum um_compare_quantity quantity, double value,
                                           double sigma);

#endif
