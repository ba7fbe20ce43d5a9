/* What umbra forecast prints. */
#ifndef UMBRA_APP_FORECAST_H
#define UMBRA_APP_FORECAST_H

#include "forecast/forecast.h"

/* A table for each station, then what is to be said of all; folder: of the results. */
void um_app_forecast_print(const struct um_forecast *forecast, const char *folder);
/* What umbra forecast --times prints: of each pass its times, the edges of the shadow, and what sky
 * the station has; as JSON a list. */
void um_app_forecast_times(const struct um_forecast *forecast, bool json);
/* One object of JSON. */
void um_app_forecast_json(const struct um_forecast *forecast, const char *folder);

#endif
