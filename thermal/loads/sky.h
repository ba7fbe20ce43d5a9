/* How free every direction is before the surfaces of a rigid body: it depends on the body
 * alone, so that tables of loads of any times, places and attitudes share it. */
#ifndef UMBRA_IRRADIATION_SKY_H
#define UMBRA_IRRADIATION_SKY_H

#include "geometry/geometry.h"

struct um_irradiation_sky;

/* By rays. No joint may move: UM_ERR_INPUT. UM_ERR_CANCELLED, UM_ERR_MEMORY, UM_ERR_LIBRARY. Holds
 * nothing of the geometry afterwards, and is valid for every geometry that is equal to it
 * (um_geometry_equal). The same bits for any number of threads. The caller destroys. */
enum um_status um_irradiation_sky_create(struct um_context *context,
                                         const struct um_geometry *geometry,
                                         struct um_irradiation_sky **out);
void um_irradiation_sky_destroy(struct um_context *context, struct um_irradiation_sky **sky);
/* Memory that it takes, but for some per cent [bytes]. NULL: 0. */
size_t um_irradiation_sky_bytes(const struct um_irradiation_sky *sky);

#endif
