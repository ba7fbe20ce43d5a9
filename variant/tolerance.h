/* How accurately the heat of variants is solved: errors that are asked in, tolerances and the error
 * that they leave out. What they leave is known of ENVISAT's pass (um_variant_tolerance_asked), or
 * measured of the scenario (um_variant_accuracy_measure), which costs four solutions or more. */
#ifndef UMBRA_VARIANT_TOLERANCE_H
#define UMBRA_VARIANT_TOLERANCE_H

#include "model/run/thermal_solution.h"

struct um_variant_tolerance {
  double factor;   /* above 0, on the scenario's tolerances of the integration [1] */
  double periodic; /* of the state that repeats [K] */
};
/* As a run of its own has them. */
#define UM_VARIANT_TIGHT ((struct um_variant_tolerance){1.0, UM_MODEL_PERIODIC_TOLERANCE})

/* Errors of light by heat, relative to its value, and of temperatures. */
struct um_variant_error {
  double lwir, vis;   /* [1] */
  double temperature; /* [K] */
};
/* The loosest tolerances that leave a quarter of the errors asked, or the tightest, by what they
 * leave of ENVISAT's pass: half as studies allow where they measure, and again half since the
 * scenario is another. stated: what they leave of that pass, or NULL. */
struct um_variant_tolerance um_variant_tolerance_asked(const struct um_variant_error *asked,
                                                       struct um_variant_error *stated);

#endif
