/* Words of a pass on the page of a forecast. */
#include <math.h>
#include <string.h>

#include "forecast/forecast_page_impl.h"
#include "orbit/time.h"

bool um_forecast_page_dark(const struct um_forecast_pass *pass)
{
  return strcmp(um_forecast_sky(pass->sun_elevation), "day") != 0;
}

/* "night", "civil twilight" */
enum um_status um_forecast_page_sky(struct um_forecast_page *k, const struct um_forecast_pass *pass,
                                    const char **out)
{
  const char *sky = um_forecast_sky(pass->sun_elevation);
  bool whole = !um_forecast_page_dark(pass) || strcmp(sky, "night") == 0;
  return um_page_words(k->w, out, "%s%s", sky, whole ? "" : " twilight");
}

/* "2016-09-21 20:36:59"; empty where t is not known. */
enum um_status um_forecast_page_clock(struct um_forecast_page *k, double t, const char **out)
{
  char utc[32];
  if (!isfinite(t)) return um_page_words(k->w, out, "%s", "");
  um_orbit_time_format(t, utc);
  return um_page_words(k->w, out, "%.10s %.8s", utc, utc + 11);
}

enum um_status um_forecast_page_light(struct um_forecast_page *k,
                                      const struct um_forecast_pass *pass, const char **out)
{
  char entry[32] = "", exit[32] = "";
  if (isfinite(pass->entry)) um_orbit_time_format(pass->entry, entry);
  if (isfinite(pass->exit)) um_orbit_time_format(pass->exit, exit);
  if (entry[0] == '\0' && exit[0] == '\0')
    return um_page_words(k->w, out, "%s", pass->sunlit_at_rise ? "sunlit" : "in the shadow");
  return um_page_words(k->w, out, "%s%.8s%s%s%.8s", entry[0] != '\0' ? "dark from " : "",
                       entry[0] != '\0' ? entry + 11 : "",
                       entry[0] != '\0' && exit[0] != '\0' ? ", " : "",
                       exit[0] != '\0' ? "lit from " : "", exit[0] != '\0' ? exit + 11 : "");
}
