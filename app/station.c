/* Stations as --station says them. */
#include "app/station.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/number.h"
#include "base/core/text.h"

enum um_status um_app_station_parse(struct um_context *context, const char *text,
                                    struct um_forecast_station *out)
{
  double value[3] = {NAN, NAN, NAN};
  char *name, *comma;
  UM_TRY(um_core_strdup(context, text, &name));
  out->name = name;
  bool good = true;
  for (int i = 2; i >= 0 && good; i--) {
    good = (comma = strrchr(name, ',')) != NULL;
    if (!good) break;
    *comma = '\0';
    good = um_core_number_parse(comma + 1 + strspn(comma + 1, " "), &value[i]);
  }
  if (!good || !um_core_name_is_safe(name) || name[0] == '\0' || fabs(value[0]) > 90.0 ||
      fabs(value[1]) > 360.0 || !(value[2] > -1000.0 && value[2] < 1e5))
    return um_core_fail(
        context, UM_ERR_INPUT,
        "--station '%s': accepted: NAME,LATITUDE,LONGITUDE,HEIGHT in degrees (north "
        "and east) and metres, e.g. --station Graz,47.067,15.493,495",
        text);
  out->latitude = value[0] * UM_DEG;
  out->longitude = value[1] * UM_DEG;
  out->height = value[2];
  return UM_OK;
}
