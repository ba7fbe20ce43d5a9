/* Private to thermal/network/: heat pipes in walls. */
#ifndef UMBRA_THERMAL_HEAT_PIPE_IMPL_H
#define UMBRA_THERMAL_HEAT_PIPE_IMPL_H

#include "thermal/network/builder_impl.h"

/* After the walls of the part. */
enum um_status um_thermal_heat_pipes_assemble(struct um_thermal_builder *b, size_t part);

#endif
