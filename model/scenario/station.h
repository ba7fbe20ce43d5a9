/* Stations that measurements may name. */
#ifndef UMBRA_MODEL_STATION_H
#define UMBRA_MODEL_STATION_H

#include "model/scenario/scenario.h"

/* Index of a station by name: 0, observer.station, for "" and its own name; then those of
 * observer.stations in their order. observer: NULL has none. UM_ERR_INPUT names those there are. */
enum um_status um_model_station_find(struct um_context *context,
                                     const struct um_scenario_observer *observer, const char *name,
                                     size_t *out);

#endif
