/* Private to thermal/network/: blankets. */
#ifndef UMBRA_THERMAL_MLI_IMPL_H
#define UMBRA_THERMAL_MLI_IMPL_H

#include "thermal/network/builder_impl.h"

/* Skins over the fronts of one part and what they wrap. */
enum um_status um_thermal_mli_assemble(struct um_thermal_builder *b, size_t part);

#endif
