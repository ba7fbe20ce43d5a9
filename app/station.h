/* Stations as --station says them. */
#ifndef UMBRA_APP_STATION_H
#define UMBRA_APP_STATION_H

#include "forecast/forecast.h"

/* "NAME,LATITUDE,LONGITUDE,HEIGHT" in degrees north and east and metres; the numbers are read from
 * behind, as a name may hold commas. out->name is the caller's to free, after a failure, too.
 * UM_ERR_INPUT, UM_ERR_MEMORY. */
enum um_status um_app_station_parse(struct um_context *context, const char *text,
                                    struct um_forecast_station *out);

#endif
