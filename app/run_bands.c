/* What a run says of the light of each band. */
#include "app/run_bands.h"

#include <math.h>
#include <stdio.h>

#include "app/app.h"
#include "base/core/constants.h"
#include "model/build/bands.h"
#include "output/band_summary.h"

/* Radiant energy toward the observer per material over the run, one band [W s/sr]. */
static void material_energy(const struct um_model_result *r, size_t band, double *out)
{
  for (size_t m = 0; m < r->nmaterial; m++) out[m] = 0.0;
  for (size_t k = 0; k < r->nobs; k++)
    for (size_t m = 0; m < r->nmaterial; m++)
      for (int i = 0; i < UM_MECHANISM_COUNT; i++)
        out[m] += r->intensity[((k * r->nband + band) * r->nmaterial + m) * UM_MECHANISM_COUNT +
                               (size_t)i];
}

/* Magnitudes in the system of the band, and in AB: of instants that are seen, outside the umbra. */
struct magnitudes {
  const char *system;         /* "Vega" or "AB" */
  double brightest, faintest; /* [mag] of that system; NAN: none is seen, or the band is thermal */
  double vega;                /* AB less that [mag] */
};

static struct magnitudes magnitudes_of(const struct um_output_run *run, size_t band)
{
  const struct um_model_result *r = run->result;
  bool is_vega = um_model_band_is_vega(run->model, band);
  struct magnitudes m = {is_vega ? "Vega" : "AB", NAN, NAN, is_vega ? r->vega_ab[band] : 0.0};
  if (um_model_band_is_thermal(&run->model->band[band]) && !is_vega) return m;
  for (size_t k = 0; k < r->nobs; k++) {
    double magnitude = r->magnitude_ab[k * r->nband + band] - m.vega;
    if (run->tables->hidden[k] || !isfinite(magnitude)) continue;
    if (!(run->tables->sunlit[k] > UM_UMBRA_MOST)) continue;
    m.brightest = fmin(m.brightest, magnitude); /* of a NaN and a number the number */
    m.faintest = fmax(m.faintest, magnitude);
  }
  return m;
}

static void print_magnitudes(const struct um_output_run *run, size_t band)
{
  struct magnitudes m = magnitudes_of(run, band);
  if (isnan(m.brightest)) return;
  printf("      magnitude in sunlight, without air, %s (%s): %.2f to %.2f",
         run->model->band[band].name, m.system, m.brightest, m.faintest);
  if (m.vega != 0.0) printf("; AB: %.2f to %.2f", m.brightest + m.vega, m.faintest + m.vega);
  printf("\n");
}

void um_app_run_print_band(const struct um_output_run *run, size_t band, double *work)
{
  const struct um_model_result *r = run->result;
  struct um_output_band_summary s = um_output_band_summary(run->tables, r, band, work);
  double sum = 0.0;
  printf("%-5s %.4g to %.4g W/sr", run->model->band[band].name, s.low, s.high);
  if (s.umbra > 0)
    printf(
        "; %zu of %zu instants in the umbra: Sun term at most %.3g W/sr, total at least %.4g W/sr",
        s.umbra, r->nobs, s.umbra_sun, s.umbra_low);
  if (s.lit > 0)
    printf("; Monte-Carlo error %.2g %% in the median, above %g %% at %zu of %zu instants",
           100.0 * s.median, 100.0 * UM_OUTPUT_LARGE_ERROR, s.large, s.lit);
  material_energy(r, band, work);
  for (size_t m = 0; m < r->nmaterial; m++) sum += work[m];
  printf("\n      shares of materials over the run:");
  for (size_t m = 0; m < r->nmaterial; m++)
    printf("%s %s %.1f %%", m > 0 ? "," : "", um_geometry_material_name(run->model->geometry, m),
           sum > 0.0 ? 100.0 * work[m] / sum : 0.0);
  printf("\n");
  print_magnitudes(run, band);
}

void um_app_run_json_band(const struct um_output_run *run, size_t band, double *work)
{
  const struct um_model_result *r = run->result;
  struct um_output_band_summary s = um_output_band_summary(run->tables, r, band, work);
  double sum = 0.0;
  um_core_json_text(stdout, "{", "name", run->model->band[band].name);
  um_core_json_field(stdout, ", ", "lowest_W_sr", s.low);
  um_core_json_field(stdout, ", ", "highest_W_sr", s.high);
  um_core_json_field(stdout, ", ", "relative_error", s.error);
  um_core_json_field(stdout, ", ", "relative_error_median", s.median);
  printf(", \"instants_above_5_percent\": %zu, \"umbra_instants\": %zu", s.large, s.umbra);
  um_core_json_field(stdout, ", ", "umbra_sun_W_sr", s.umbra > 0 ? s.umbra_sun : (double)NAN);
  um_core_json_field(stdout, ", ", "umbra_lowest_W_sr", s.umbra_low);
  um_core_json_field(stdout, ", ", "finer_facets_largest", r->mesh.light[band]);
  um_core_json_field(stdout, ", ", "finer_facets_mean", r->mesh.light_mean[band]);
  struct magnitudes magnitude = magnitudes_of(run, band);
  um_core_json_text(stdout, ", ", "magnitude_system", magnitude.system);
  um_core_json_field(stdout, ", ", "brightest_mag", magnitude.brightest);
  um_core_json_field(stdout, ", ", "faintest_mag", magnitude.faintest);
  um_core_json_field(stdout, ", ", "brightest_mag_ab", magnitude.brightest + magnitude.vega);
  um_core_json_field(stdout, ", ", "faintest_mag_ab", magnitude.faintest + magnitude.vega);
  printf(", \"share_by_material\": {");
  material_energy(r, band, work);
  for (size_t m = 0; m < r->nmaterial; m++) sum += work[m];
  for (size_t m = 0; m < r->nmaterial; m++) {
    printf("%s", m > 0 ? ", " : "");
    um_core_json_string(stdout, um_geometry_material_name(run->model->geometry, m));
    printf(": ");
    um_core_json_number(stdout, sum > 0.0 ? work[m] / sum : 0.0);
  }
  printf("}}");
}
