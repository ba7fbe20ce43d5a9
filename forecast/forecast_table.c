/* Forecasts as CSV: a row a pass, and the curves. */
#include <math.h>
#include <stdio.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "forecast/forecast_write.h"
#include "orbit/time.h"

static void put_time(FILE *file, double t)
{
  char text[32] = "";
  if (isfinite(t)) um_orbit_time_format(t, text);
  fprintf(file, ",%s", text);
}

static void head_sigmas(const struct um_forecast *f, size_t band, FILE *file)
{
  static const char *const of_band[] = {"_brightest_sigma_mag", "_culmination_sigma_mag",
                                        "_largest_sigma_W_m2", "_culmination_sigma_W_m2"};
  for (size_t i = 0; f->nuncertain > 0 && i < sizeof of_band / sizeof *of_band; i++)
    um_core_csv_put_text(file, f->band[band], of_band[i]);
}

static void head(const struct um_forecast *f, FILE *file)
{
  static const char *const of_band[2][8] = {
      {"_brightest_mag_ab", "_brightest_utc", "_culmination_mag_ab", "_brightest_error_mag",
       "_largest_W_m2", "_largest_utc", "_culmination_W_m2", "_largest_W_sr"},
      {"_brightest_mag_vega", "_brightest_utc", "_culmination_mag_vega", "_brightest_error_mag",
       "_largest_W_m2", "_largest_utc", "_culmination_W_m2", "_largest_W_sr"}};
  static const char *const of_place[] = {".mean_K",       ".lowest_K",       ".highest_K",
                                         ".mean_sigma_K", ".lowest_sigma_K", ".highest_sigma_K"};
  const size_t nplace = f->nuncertain > 0 ? 6 : 3;
  fputs("pass,station,rise_utc,rise_azimuth_deg,culmination_utc,culmination_azimuth_deg,"
        "culmination_elevation_deg,culmination_range_km,set_utc,set_azimuth_deg,"
        "shadow_entry_utc,shadow_exit_utc,sunlit_at_rise,sunlit_at_set,sun_elevation_deg,sky,"
        "orbit_error_s",
        file);
  for (size_t b = 0; b < f->nband; b++) {
    for (size_t i = 0; i < 8; i++)
      um_core_csv_put_text(file, f->band[b], of_band[!isnan(f->vega_ab[b])][i]);
    head_sigmas(f, b, file);
  }
  for (size_t p = 0; p < f->nplace; p++)
    for (size_t i = 0; i < nplace; i++) um_core_csv_put_text(file, f->place[p], of_place[i]);
  fputs(",reason\n", file);
}

static void geometry(const struct um_forecast_pass *pass, FILE *file)
{
  const struct um_orbit_pass *p = &pass->pass;
  put_time(file, p->rise);
  um_core_csv_put_exact(file, p->rise_azimuth / UM_DEG);
  put_time(file, p->culmination);
  um_core_csv_put_exact(file, p->culmination_azimuth / UM_DEG);
  um_core_csv_put_exact(file, p->culmination_elevation / UM_DEG);
  um_core_csv_put_exact(file, p->culmination_range * 1e-3);
  put_time(file, p->set);
  um_core_csv_put_exact(file, p->set_azimuth / UM_DEG);
  put_time(file, pass->entry);
  put_time(file, pass->exit);
  fprintf(file, ",%d,%d", pass->sunlit_at_rise, pass->sunlit_at_set);
  um_core_csv_put_exact(file, pass->sun_elevation / UM_DEG);
  fprintf(file, ",%s", um_forecast_sky(pass->sun_elevation));
}

static void put_place(FILE *file, const struct um_forecast_place *place)
{
  um_core_csv_put_exact(file, place->mean);
  um_core_csv_put_exact(file, place->lowest);
  um_core_csv_put_exact(file, place->highest);
}

static void put_sigmas(FILE *file, const struct um_forecast_band *sigma)
{
  um_core_csv_put_exact(file, sigma->brightest);
  um_core_csv_put_exact(file, sigma->culmination);
  um_core_csv_put_exact(file, sigma->largest);
  um_core_csv_put_exact(file, sigma->irradiance_culmination);
}

void um_forecast_csv(const struct um_forecast *f, FILE *file)
{
  head(f, file);
  for (size_t i = 0; i < f->npass; i++) {
    const struct um_forecast_pass *pass = &f->pass[i];
    fprintf(file, "%zu,", i + 1);
    um_core_csv_put(file, f->station[pass->station].name, "");
    geometry(pass, file);
    um_core_csv_put_exact(file, pass->delay);
    for (size_t b = 0; b < f->nband; b++) {
      const struct um_forecast_band *band = &pass->band[b];
      um_core_csv_put_exact(file, band->brightest);
      put_time(file, band->brightest_at);
      um_core_csv_put_exact(file, band->culmination);
      um_core_csv_put_exact(file, band->error);
      um_core_csv_put_exact(file, band->largest);
      put_time(file, band->largest_at);
      um_core_csv_put_exact(file, band->irradiance_culmination);
      um_core_csv_put_exact(file, band->intensity);
      if (f->nuncertain > 0) put_sigmas(file, &pass->band_sigma[b]);
    }
    for (size_t p = 0; p < f->nplace; p++) {
      put_place(file, &pass->place[p]);
      if (f->nuncertain > 0) put_place(file, &pass->place_sigma[p]);
    }
    um_core_csv_put_text(file, pass->reason == NULL ? "" : pass->reason, "");
    fputc('\n', file);
  }
}

void um_forecast_curves(const struct um_forecast *f, FILE *file)
{
  const size_t n = UM_FORECAST_CURVE;
  fputs("pass,station,time_utc", file);
  for (size_t b = 0; b < f->nband; b++) {
    um_core_csv_put_text(file, f->band[b], isnan(f->vega_ab[b]) ? "_mag_ab" : "_mag_vega");
    um_core_csv_put_text(file, f->band[b], "_W_m2");
    if (f->nuncertain == 0) continue;
    um_core_csv_put_text(file, f->band[b], "_sigma_mag");
    um_core_csv_put_text(file, f->band[b], "_sigma_W_m2");
  }
  fputc('\n', file);
  for (size_t i = 0; i < f->npass; i++)
    for (size_t k = 0; k < n; k++) {
      const struct um_forecast_pass *pass = &f->pass[i];
      /* a pass of fewer instants than a curve has, has some of them twice */
      if (pass->reason != NULL || (k > 0 && !(pass->curve_at[k] > pass->curve_at[k - 1]))) continue;
      fprintf(file, "%zu,", i + 1);
      um_core_csv_put(file, f->station[pass->station].name, "");
      put_time(file, pass->curve_at[k]);
      for (size_t b = 0; b < f->nband; b++) {
        um_core_csv_put_exact(file, pass->curve[2 * b * n + k]);
        um_core_csv_put_exact(file, pass->curve[(2 * b + 1) * n + k]);
        if (f->nuncertain == 0) continue;
        um_core_csv_put_exact(file, pass->curve_sigma[2 * b * n + k]);
        um_core_csv_put_exact(file, pass->curve_sigma[(2 * b + 1) * n + k]);
      }
      fputc('\n', file);
    }
}
