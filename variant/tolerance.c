/* The choices of tolerances, and what each leaves of ENVISAT's pass against a run of its own. The
 * scenario as it stands has 0.029 K and 3.8e-4 in LWIR, 0.0033 K and 2.4e-5, and the same with the
 * last (tests/bench/variant.c); what is stated has room for variants. Looser ones do not pay: steps
 * of an integration are then as long as loads are smooth over. Heat makes no light in VIS. */
#include "variant/tolerance_impl.h"

#define SHARE 0.25 /* of the asked error */

const struct um_variant_tolerance_choice um_variant_tolerance_choices[UM_VARIANT_CHOICES] = {
    {{3.0, 0.05}, {5e-4, 0.0, 0.045}},
    {{1.0, 0.02}, {7e-5, 0.0, 0.020}},
    {{1.0, UM_MODEL_PERIODIC_TOLERANCE}, {3.3e-5, 0.0, 0.0036}}};

struct um_variant_tolerance um_variant_tolerance_asked(const struct um_variant_error *asked,
                                                       struct um_variant_error *stated)
{
  const struct um_variant_tolerance_choice *choice = um_variant_tolerance_choices;
  const struct um_variant_tolerance_choice *last = choice + UM_VARIANT_CHOICES - 1;
  while (choice < last &&
         !(choice->leaves.lwir <= SHARE * asked->lwir && choice->leaves.vis <= SHARE * asked->vis &&
           choice->leaves.temperature <= SHARE * asked->temperature))
    choice++;
  if (stated != NULL) *stated = choice->leaves;
  return choice->tolerance;
}
