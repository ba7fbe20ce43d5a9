/* What a run says of the light of each band. */
#include "app/run_bands.h"

#include <math.h>
#include <stdio.h>

#include "app/app.h"
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
