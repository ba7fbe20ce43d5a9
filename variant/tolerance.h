/* How accurately the heat of a variant is solved. */
#ifndef UMBRA_VARIANT_TOLERANCE_H
#define UMBRA_VARIANT_TOLERANCE_H

struct um_variant_tolerance {
  double factor;   /* >= 1, on the scenario's tolerances of the integration [1] */
  double periodic; /* of the state that repeats [K] */
};

#endif
