/* Columns of lightcurve.csv: the table and the pictures that are drawn from it. Private to output/.
 */
#ifndef UMBRA_OUTPUT_LIGHTCURVE_IMPL_H
#define UMBRA_OUTPUT_LIGHTCURVE_IMPL_H

#include "model/build/model.h"
#include "model/run/result.h"
#include "optics/radiance/optics.h"

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

/* Columns of grey bodies, behind those of the bands. */
#define UM_LIGHTCURVE_GREY_ONE 5
#define UM_LIGHTCURVE_GREY     9

/* How many of them a run has: 0 with fewer than three thermal bands, _ONE with fewer than five. */
size_t um_output_grey_columns(const struct um_model *model);
/* Their values; NaN where there are none, two components only where they explain more (BIC). */
void um_output_grey_values(const struct um_model_grey_body *grey, double out[UM_LIGHTCURVE_GREY]);

/* What stands behind the band's name in the header of a column. */
const char *um_output_lightcurve_tail(size_t column);

#endif
