/* Private to thermal/network/: capacities and conduction of walls and solids by temperature. */
#ifndef UMBRA_THERMAL_BULK_LAW_IMPL_H
#define UMBRA_THERMAL_BULK_LAW_IMPL_H

#include "thermal/network/builder_impl.h"

/* The network's laws for `law`, UM_THERMAL_NO_LAW where it is constant. */
enum um_status um_thermal_bulk_laws(struct um_thermal_builder *b,
                                    const struct um_thermal_bulk_law *law,
                                    struct um_thermal_bulk_index *out);
enum um_status um_thermal_bulk_conductor(struct um_thermal_builder *b,
                                         const struct um_thermal_bulk_index *law, uint32_t one,
                                         uint32_t other, double conductance);
/* `capacity` [J/K] of the node follows. */
enum um_status um_thermal_bulk_capacity(struct um_thermal_builder *b,
                                        const struct um_thermal_bulk_index *law, uint32_t node,
                                        double capacity);

#endif
