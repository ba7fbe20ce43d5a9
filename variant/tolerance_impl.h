/* Private to variant/: the choices of tolerances, from the loosest. */
#ifndef UMBRA_VARIANT_TOLERANCE_IMPL_H
#define UMBRA_VARIANT_TOLERANCE_IMPL_H

#include "variant/tolerance.h"

#define UM_VARIANT_CHOICES 3
struct um_variant_tolerance_choice {
  struct um_variant_tolerance tolerance;
  struct um_variant_error leaves; /* of ENVISAT's pass */
};
extern const struct um_variant_tolerance_choice um_variant_tolerance_choices[UM_VARIANT_CHOICES];

#endif
