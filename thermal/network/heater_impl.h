/* Private to thermal/network/: heat made inside. */
#ifndef UMBRA_THERMAL_HEATER_IMPL_H
#define UMBRA_THERMAL_HEATER_IMPL_H

#include "thermal/network/builder_impl.h"

/* Powers, power histories and heaters of one part. */
enum um_status um_thermal_heat_assemble(struct um_thermal_builder *b, size_t part);

#endif
