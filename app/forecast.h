/* What umbra forecast prints. */
#ifndef UMBRA_APP_FORECAST_H
#define UMBRA_APP_FORECAST_H

#include "forecast/forecast.h"

/* A table for each station, then what is to be said of all; folder: of the results. */
void um_app_forecast_print(const struct um_forecast *forecast, const char *folder);
/* One object of JSON. */
void um_app_forecast_json(const struct um_forecast *forecast, const char *folder);

#endif
