/* lightcurve.csv and materials.csv. */
#include <math.h>
#include <string.h>

#include "core/constants.h"
#include "environment/airmass.h"
#include "output/csv_impl.h"
#include "output/output.h"

#define STANDARD_RANGE 1e6 /* that magnitudes of satellites are compared at [m] */

static const char *const mechanism_names[UM_MECHANISM_COUNT] = {"sun", "earth", "emitted",
                                                                "interreflected", "other"};

static void write_header(const struct um_output_run *run, FILE *file)
{
  fputs("time_utc,azimuth_deg,elevation_deg,range_km,airmass,phase_angle_deg,sunlit_fraction,"
        "sun_elevation_deg",
        file);
  for (size_t b = 0; b < run->model->nband; b++) {
    const char *name = run->model->band[b].name;
    um_output_csv_text(file, name, "_intensity_W_sr");
    for (int m = 0; m < UM_MECHANISM_COUNT; m++) {
      char tail[40];
      snprintf(tail, sizeof tail, "_%s_W_sr", mechanism_names[m]);
      um_output_csv_text(file, name, tail);
    }
    um_output_csv_text(file, name, "_stderr_W_sr");
    um_output_csv_text(file, name, "_irradiance_W_m2");
    um_output_csv_text(file, name, "_mag_ab");
    um_output_csv_text(file, name, "_mag_vega");
    um_output_csv_text(file, name, "_mag_ab_1000km");
  }
  fputc('\n', file);
}

/* The instant nearest mid-exposure stands for the geometry of an observation. */
static size_t middle(const struct um_model_precomputed *precomputed, size_t k)
{
  return k * precomputed->nsub + precomputed->nsub / 2;
}

enum um_status um_output_write_lightcurve(const struct um_output_run *run, FILE *file)
{
  const struct um_model_precomputed *precomputed = run->precomputed;
  const struct um_model_result *r = run->result;
  write_header(run, file);
  for (size_t k = 0; k < precomputed->nobs; k++) {
    const struct um_orbit_look *look = &precomputed->look[middle(precomputed, k)];
    const struct um_environment_sample *s = &precomputed->sample[middle(precomputed, k)];
    UM_TRY(um_output_stop(run));
    um_output_csv_time(file, precomputed->t_obs[k]);
    um_output_csv_number(file, look->azimuth / UM_DEG);
    um_output_csv_number(file, look->elevation / UM_DEG);
    um_output_csv_number(file, look->range * 1e-3);
    um_output_csv_number(file, um_environment_airmass(look->elevation));
    um_output_csv_number(file, um_vec3_angle(s->sun, s->to_observer) / UM_DEG);
    um_output_csv_number(file, precomputed->sunlit[k]);
    um_output_csv_number(file, look->sun_elevation / UM_DEG);
    double nearer = 5.0 * log10(look->range / STANDARD_RANGE); /* [mag] */
    for (size_t b = 0; b < r->nband; b++) {
      double part[UM_MECHANISM_COUNT], total = 0.0;
      for (int m = 0; m < UM_MECHANISM_COUNT; m++)
        total += part[m] = um_model_result_intensity(r, k, b, m);
      um_output_csv_number(file, total);
      for (int m = 0; m < UM_MECHANISM_COUNT; m++) um_output_csv_number(file, part[m]);
      um_output_csv_number(file, r->standard_error[k * r->nband + b]);
      um_output_csv_number(file, r->irradiance[k * r->nband + b]);
      um_output_csv_number(file, r->magnitude_ab[k * r->nband + b]);
      um_output_csv_number(file, r->magnitude_ab[k * r->nband + b] - r->vega_ab[b]);
      um_output_csv_number(file, r->magnitude_ab[k * r->nband + b] - nearer);
    }
    fputc('\n', file);
  }
  return UM_OK;
}

enum um_status um_output_write_materials(const struct um_output_run *run, FILE *file)
{
  const struct um_model_result *r = run->result;
  fputs("time_utc,band,material,sun,earth,emitted,interreflected,other\n", file);
  for (size_t k = 0; k < r->nobs; k++)
    for (size_t b = 0; b < r->nband; b++)
      for (size_t m = 0; m < r->nmaterial; m++) {
        UM_TRY(um_output_stop(run));
        const double *at =
            r->intensity + ((k * r->nband + b) * r->nmaterial + m) * UM_MECHANISM_COUNT;
        um_output_csv_time(file, run->precomputed->t_obs[k]);
        um_output_csv_text(file, run->model->band[b].name, "");
        um_output_csv_text(file, um_geometry_material_name(run->model->geometry, m), "");
        for (int i = 0; i < UM_MECHANISM_COUNT; i++) um_output_csv_number(file, at[i]);
        fputc('\n', file);
      }
  return UM_OK;
}
