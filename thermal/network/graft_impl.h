/* Private to thermal/network/: parts that are stated as nodes and conductors. */
#ifndef UMBRA_THERMAL_GRAFT_IMPL_H
#define UMBRA_THERMAL_GRAFT_IMPL_H

#include "thermal/network/builder_impl.h"

/* Nodes of the groups of a part of kind NODES. */
enum um_status um_thermal_graft_assemble(struct um_thermal_builder *b, size_t part);
/* Its conductors and radiators, once its interiors stand; nothing for other kinds. */
enum um_status um_thermal_graft_links(struct um_thermal_builder *b, size_t part);

#endif
