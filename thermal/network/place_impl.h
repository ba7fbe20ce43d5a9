/* Private to thermal/network/: places by name. */
#ifndef UMBRA_THERMAL_PLACE_IMPL_H
#define UMBRA_THERMAL_PLACE_IMPL_H

#include "thermal/network/builder_impl.h"

/* Where a name points inside a part: what follows the part's name, "", ".group", ".group.back",
 * ".front", ".back" or that of an interior, ".NAME"; ".inside" is ".back" of a part that radiates
 * inside. A wall of one layer is both front and back. */
struct um_thermal_where {
  uint32_t part, group; /* group UM_GEOMETRY_NONE: all */
  bool front, back;
  uint32_t interior; /* node, or UM_THERMAL_SPACE: a place of the surface */
};
/* false: there is no such place in where->part. */
bool um_thermal_where_find(const struct um_thermal_builder *b, const char *suffix,
                           struct um_thermal_where *where);

/* Every place that has temperatures of its own. */
enum um_status um_thermal_places_build(struct um_thermal_builder *b, struct um_thermal_body *body);

#endif
