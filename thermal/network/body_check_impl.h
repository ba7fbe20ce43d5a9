/* Private to thermal/network/: what a body is refused for. */
#ifndef UMBRA_THERMAL_BODY_CHECK_IMPL_H
#define UMBRA_THERMAL_BODY_CHECK_IMPL_H

#include "thermal/network/builder_impl.h"

/* Specs against geometry and ranges. */
enum um_status um_thermal_body_check(struct um_thermal_builder *b,
                                     const struct um_thermal_part_spec *parts, size_t npart);

#endif
