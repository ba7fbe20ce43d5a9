/* umbra forecast --times: when the satellite is above a station, where it meets the Earth's shadow,
 * and what sky the station has. */
#include <stdio.h>
#include <string.h>

#include "app/app.h"
#include "app/forecast.h"
#include "base/core/constants.h"
#include "orbit/time.h"

static const char *event_text(enum um_environment_event_kind kind)
{
  switch (kind) {
  case UM_EVENT_PENUMBRA_ENTRY:
    return "enters the penumbra";
  case UM_EVENT_HALF_ENTRY:
    return "half of the Sun is hidden";
  case UM_EVENT_UMBRA_ENTRY:
    return "enters the umbra";
  case UM_EVENT_UMBRA_EXIT:
    return "leaves the umbra";
  case UM_EVENT_HALF_EXIT:
    return "half of the Sun is back";
  case UM_EVENT_PENUMBRA_EXIT:
    return "is in full sunlight";
  }
  return "";
}

static void print_point(const char *what, double t, double azimuth)
{
  char utc[32];
  um_orbit_time_format(t, utc);
  printf("  %-12s %s  azimuth %7.3f deg", what, utc, azimuth / UM_DEG);
}

/* "civil twilight", "night" */
static void print_sky(double sun_elevation)
{
  const char *sky = um_forecast_sky(sun_elevation);
  bool whole = strcmp(sky, "day") == 0 || strcmp(sky, "night") == 0;
  printf("  %-12s %s%s, the Sun at %.1f deg when it culminates\n", "sky", sky,
         whole ? "" : " twilight", sun_elevation / UM_DEG);
}

static void print_pass(const struct um_forecast_pass *pass)
{
  const struct um_orbit_pass *p = &pass->pass;
  print_point("rises", p->rise, p->rise_azimuth);
  printf("\n");
  print_point("culminates", p->culmination, p->culmination_azimuth);
  printf("  elevation %.3f deg  range %.1f km\n", p->culmination_elevation / UM_DEG,
         p->culmination_range * 1e-3);
  print_point("sets", p->set, p->set_azimuth);
  printf("\n");
  print_sky(pass->sun_elevation);
  if (pass->nevent == 0)
    printf("  %-12s %s\n", "light",
           pass->sunlit_at_rise ? "in sunlight all the time" : "in the shadow all the time");
  for (size_t i = 0; i < pass->nevent; i++) {
    char utc[32];
    um_orbit_time_format(pass->event[i].t_tai, utc);
    printf("    %s  %s\n", utc, event_text(pass->event[i].kind));
  }
}

static void json_pass(const struct um_forecast *f, const struct um_forecast_pass *pass)
{
  const struct um_orbit_pass *p = &pass->pass;
  char rise[32], culmination[32], set[32];
  um_orbit_time_format(p->rise, rise);
  um_orbit_time_format(p->culmination, culmination);
  um_orbit_time_format(p->set, set);
  um_core_json_text(stdout, "  {", "station", f->station[pass->station].name);
  printf(", \"rise_utc\": \"%s\", \"culmination_utc\": \"%s\", \"set_utc\": \"%s\", "
         "\"culmination_elevation_deg\": %.6f, \"culmination_range_km\": %.6f, "
         "\"sun_elevation_deg\": %.6f, \"sky\": \"%s\", \"sunlit_at_rise\": %s, "
         "\"sunlit_at_set\": %s, \"shadow\": [",
         rise, culmination, set, p->culmination_elevation / UM_DEG, p->culmination_range * 1e-3,
         pass->sun_elevation / UM_DEG, um_forecast_sky(pass->sun_elevation),
         pass->sunlit_at_rise ? "true" : "false", pass->sunlit_at_set ? "true" : "false");
  for (size_t i = 0; i < pass->nevent; i++) {
    char utc[32];
    um_orbit_time_format(pass->event[i].t_tai, utc);
    printf("%s{\"utc\": \"%s\", \"event\": \"%s\"}", i > 0 ? ", " : "", utc,
           event_text(pass->event[i].kind));
  }
  printf("]}");
}

static void print_station(const struct um_forecast *f, size_t station)
{
  char from[32], to[32];
  size_t n = 0;
  for (size_t i = 0; i < f->npass; i++) n += f->pass[i].station == station ? 1 : 0;
  um_orbit_time_format(f->from, from);
  um_orbit_time_format(f->to, to);
  printf("%zu passes above %g deg over %s from %s to %s\n", n, f->minimum_elevation / UM_DEG,
         f->station[station].name, from, to);
  for (size_t i = 0, k = 0; i < f->npass; i++) {
    if (f->pass[i].station != station) continue;
    printf("pass %zu\n", ++k);
    print_pass(&f->pass[i]);
  }
}

void um_app_forecast_times(const struct um_forecast *forecast, bool json)
{
  const struct um_forecast *f = forecast;
  for (size_t s = 0; !json && s < f->nstation; s++) print_station(f, s);
  if (!json) return;
  puts("[");
  for (size_t i = 0; i < f->npass; i++) {
    json_pass(f, &f->pass[i]);
    puts(i + 1 < f->npass ? "," : "");
  }
  puts("]");
}
