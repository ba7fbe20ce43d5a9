/* A forecast in words: passes as a table, or their number as JSON. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>

#include "app/app.h"
#include "app/forecast.h"
#include "base/core/constants.h"
#include "orbit/time.h"

#define SYSTEMS 512 /* longest list of bands with their systems [byte] */

static void print_time(double t, const char *otherwise)
{
  char utc[32];
  if (isfinite(t)) um_orbit_time_format(t, utc);
  printf(" %-8.8s", isfinite(t) ? utc + 11 : otherwise);
}

/* What the shadow does to a pass. */
static const char *shadow_words(const struct um_forecast_pass *pass)
{
  if (isfinite(pass->entry) || isfinite(pass->exit)) return "-";
  return pass->sunlit_at_rise ? "sunlit" : "in it";
}

/* "+-0.05" behind a number, where something is uncertain; nothing where it is not known. */
static void print_sigma(const char *format, int width, double sigma)
{
  printf("+-");
  if (isfinite(sigma))
    printf(format, sigma); /* NOLINT: formats are literals */
  else
    printf("%-*s", width, "?");
}

static void print_magnitude(const struct um_forecast *f, double magnitude, double sigma)
{
  bool seen = isfinite(magnitude);
  if (seen)
    printf(" %6.2f", magnitude);
  else
    printf(" %6s", "dark");
  if (f->nuncertain > 0 && seen)
    print_sigma("%-4.2f", 4, sigma);
  else if (f->nuncertain > 0)
    printf("%6s", "");
}

static void print_band(const struct um_forecast *f, const struct um_forecast_pass *pass, size_t b)
{
  const struct um_forecast_band *band = &pass->band[b];
  const struct um_forecast_band sigma =
      f->nuncertain > 0 ? pass->band_sigma[b] : (struct um_forecast_band){.error = NAN};
  if (!f->thermal[b]) {
    print_magnitude(f, band->brightest, sigma.brightest);
    print_magnitude(f, band->culmination, sigma.culmination);
    return;
  }
  printf(" %9.2e", band->largest);
  if (f->nuncertain > 0) print_sigma("%-7.1e", 7, sigma.largest);
}

static void print_pass(const struct um_forecast *f, const struct um_forecast_pass *pass)
{
  char date[32];
  um_orbit_time_format(pass->pass.rise, date);
  printf("%.10s", date);
  print_time(pass->pass.rise, "");
  print_time(pass->pass.culmination, "");
  print_time(pass->pass.set, "");
  printf(" %4.0f %4.0f %5.0f", pass->pass.culmination_elevation / UM_DEG,
         pass->pass.culmination_azimuth / UM_DEG, pass->pass.culmination_range * 1e-3);
  print_time(pass->entry, shadow_words(pass));
  print_time(pass->exit, "-");
  printf(" %5.0f %-12s", pass->sun_elevation / UM_DEG, um_forecast_sky(pass->sun_elevation));
  if (pass->reason != NULL) {
    printf(" not computed: %s\n", pass->reason);
    return;
  }
  for (size_t b = 0; b < f->nband; b++) print_band(f, pass, b);
  for (size_t p = 0; p < f->nplace; p++) {
    printf(" %7.1f", pass->place[p].mean);
    if (f->nuncertain > 0) print_sigma("%-5.1f", 5, pass->place_sigma[p].mean);
  }
  printf("\n");
}

static void print_head(const struct um_forecast *f)
{
  printf("%-10s %-8s %-8s %-8s %4s %4s %5s %-8s %-8s %5s %-12s", "date", "rise", "highest", "set",
         "elev", "az", "km", "in shade", "till", "Sun", "sky");
  const int more = f->nuncertain > 0 ? 1 : 0; /* columns of "+-" and a sigma */
  for (size_t b = 0; b < f->nband; b++) {
    if (f->thermal[b])
      printf(" %9.9s%*s", f->band[b], 9 * more, "");
    else
      printf(" %6.6s%*s %6s%*s", f->band[b], 6 * more, "", "at top", 6 * more, "");
  }
  for (size_t p = 0; p < f->nplace; p++) printf(" %7.7s%*s", f->place[p], 7 * more, "");
  printf("\n");
}

/* " (V: Vega, vis: AB)"; empty: no band has magnitudes here. */
static void name_systems(const struct um_forecast *f, char out[SYSTEMS])
{
  size_t used = 0;
  out[0] = '\0';
  for (size_t b = 0; b < f->nband && used < SYSTEMS; b++)
    if (!f->thermal[b])
      used += (size_t)snprintf(out + used, SYSTEMS - used, "%s%.40s: %s", used == 0 ? " (" : ", ",
                               f->band[b], um_forecast_system(f, b));
  if (used > 0 && used < SYSTEMS) snprintf(out + used, SYSTEMS - used, ")");
}

/* Who gives most of each band's error bar. */
static void print_leaders(const struct um_forecast *f)
{
  size_t told = 0;
  double share;
  if (f->nuncertain == 0) return;
  printf("+- is 1 sigma by %zu uncertain parameter%s, to first order", f->nuncertain,
         f->nuncertain == 1 ? "" : "s");
  for (size_t b = 0; b < f->nband; b++) {
    size_t first = um_forecast_leader(f, b, &share);
    if (first == SIZE_MAX) continue;
    printf("%s %s by %s (%.0f %%)", told++ == 0 ? "; most of the variance of" : ", of", f->band[b],
           f->uncertain[first].name, 100.0 * share);
  }
  printf("\n");
}

void um_app_forecast_print(const struct um_forecast *f, const char *folder)
{
  char systems[SYSTEMS];
  name_systems(f, systems);
  for (size_t s = 0; s < f->nstation; s++) {
    size_t n = 0;
    for (size_t i = 0; i < f->npass; i++) n += f->pass[i].station == s ? 1 : 0;
    printf("%s over %s: %zu passes above %g deg, UTC; bands: brightest magnitude and that at "
           "culmination%s, or largest irradiance [W/m^2]; mean temperatures [K]\n",
           f->name, f->station[s].name, n, f->minimum_elevation / UM_DEG, systems);
    if (n > 0) print_head(f);
    for (size_t i = 0; i < f->npass; i++)
      if (f->pass[i].station == s) print_pass(f, &f->pass[i]);
  }
  double delay = 0.0;
  for (size_t i = 0; i < f->npass; i++) delay = fmax(delay, f->pass[i].delay);
  if (delay > 1.0)
    printf("elements are old: times may be wrong by %.2g s (1 sigma) at the end\n", delay);
  print_leaders(f);
  um_app_tell_results(folder);
}

/* Of each band the parameter that gives most of its variance, and its share. */
static void json_leaders(const struct um_forecast *f)
{
  size_t told = 0;
  double share;
  printf(", \"uncertain\": %zu, \"most_of_the_variance\": {", f->nuncertain);
  for (size_t b = 0; b < f->nband; b++) {
    size_t first = um_forecast_leader(f, b, &share);
    if (first == SIZE_MAX) continue;
    if (told++ > 0) printf(", ");
    um_core_json_string(stdout, f->band[b]);
    um_core_json_text(stdout, ": {", "parameter", f->uncertain[first].name);
    printf(", \"share\": %.6g}", share);
  }
  printf("}");
}

void um_app_forecast_json(const struct um_forecast *f, const char *folder)
{
  size_t failed = 0;
  for (size_t i = 0; i < f->npass; i++) failed += f->pass[i].reason != NULL ? 1 : 0;
  um_core_json_text(stdout, "{", "name", f->name);
  um_core_json_text(stdout, ", ", "folder", folder);
  printf(", \"passes\": %zu, \"not_computed\": %zu, \"magnitudes\": {", f->npass, failed);
  for (size_t b = 0; b < f->nband; b++) {
    if (b > 0) printf(", ");
    um_core_json_string(stdout, f->band[b]);
    printf(": \"%s\"", um_forecast_system(f, b));
  }
  printf("}");
  if (f->nuncertain > 0) json_leaders(f);
  printf("}\n");
}
