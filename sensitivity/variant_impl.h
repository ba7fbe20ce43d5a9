/* Which geometry precomputation serves a scenario with additions. Private to sensitivity/. */
#ifndef UMBRA_SENSITIVITY_VARIANT_IMPL_H
#define UMBRA_SENSITIVITY_VARIANT_IMPL_H

#include "model/model.h"

/* The additions that the geometry precomputation of the scenario as it stands does not serve, 0
 * when it serves; key: room for [naddition]. */
size_t um_sensitivity_variant_key(const struct um_model *scenario, const struct um_model *variant,
                                  const struct um_model_addition *addition, size_t naddition,
                                  struct um_model_addition *key);
/* Do both keys ask for the same precomputation, number for number? */
bool um_sensitivity_variant_same_key(const struct um_model_addition *a, size_t na,
                                     const struct um_model_addition *b, size_t nb);

#endif
