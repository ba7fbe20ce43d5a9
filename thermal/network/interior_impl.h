/* Private to thermal/network/: what is inside parts. */
#ifndef UMBRA_THERMAL_INTERIOR_IMPL_H
#define UMBRA_THERMAL_INTERIOR_IMPL_H

#include "thermal/network/builder_impl.h"

/* Names and ranges of the interiors of a part. */
enum um_status um_thermal_interiors_check(const struct um_thermal_builder *b,
                                          const struct um_thermal_part_spec *spec);
/* Room for the nodes of all parts; specs are checked. */
enum um_status um_thermal_interiors_allocate(struct um_thermal_builder *b);
/* Nodes of the interiors of a part. */
enum um_status um_thermal_interiors_add(struct um_thermal_builder *b, size_t part);
/* The nodes of interior i of a part with their shares of its capacity; returns how many, 1 or 2. */
size_t um_thermal_interior_nodes(const struct um_thermal_builder *b, size_t part, size_t i,
                                 uint32_t node[2], double share[2]);
/* Conductors to the walls, which stand. */
enum um_status um_thermal_interiors_couple(struct um_thermal_builder *b, size_t part);

#endif
