/* Private to thermal/network/: lumped walls. */
#ifndef UMBRA_THERMAL_LUMP_IMPL_H
#define UMBRA_THERMAL_LUMP_IMPL_H

#include "thermal/network/builder_impl.h"

/* Nodes, capacities and conduction of one part of lumped walls. */
enum um_status um_thermal_lump_assemble(struct um_thermal_builder *b, size_t part);

#endif
