/* Columns of lightcurve.csv: the table and the pictures that are drawn from it. Private to output/.
 */
#ifndef UMBRA_OUTPUT_LIGHTCURVE_IMPL_H
#define UMBRA_OUTPUT_LIGHTCURVE_IMPL_H

#include "optics/optics.h"

#define UM_LIGHTCURVE_BEFORE 8 /* columns before those of the first band */

/* Of each band; the mechanisms in their own order. */
enum um_lightcurve_column {
  UM_LIGHTCURVE_TOTAL,
  UM_LIGHTCURVE_MECHANISM,
  UM_LIGHTCURVE_STDERR = UM_LIGHTCURVE_MECHANISM + UM_MECHANISM_COUNT,
  UM_LIGHTCURVE_IRRADIANCE,
  UM_LIGHTCURVE_MAG_AB,
  UM_LIGHTCURVE_MAG_VEGA,
  UM_LIGHTCURVE_MAG_1000_KM,
  UM_LIGHTCURVE_COLUMNS
};

#endif
