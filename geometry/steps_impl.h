/* Private to geometry/: how finely a shape is divided. */
#ifndef UMBRA_GEOMETRY_STEPS_IMPL_H
#define UMBRA_GEOMETRY_STEPS_IMPL_H

#include "geometry/geometry.h"

/* UM_ERR_INPUT when `count` facets are too many for facet_size. */
enum um_status um_geometry_count_check(const struct um_geometry_part_spec *spec,
                                       struct um_context *context, double count);
/* Number of steps of at most `step` (0: as long as wanted) along `length`, at least `least`. */
double um_geometry_step_count(double length, double step, double least);

#endif
