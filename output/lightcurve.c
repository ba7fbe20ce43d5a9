/* lightcurve.csv and materials.csv. */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "environment/airmass.h"
#include "model/build/bands.h"
#include "output/csv_impl.h"
#include "output/lightcurve_impl.h"
#include "output/output.h"

#define STANDARD_RANGE 1e6 /* that magnitudes of satellites are compared at [m] */

#define MECHANISM(m) [UM_LIGHTCURVE_MECHANISM + (m)]
/* What stands behind the band's name. */
static const char *const tails[UM_LIGHTCURVE_COLUMNS] = {
    [UM_LIGHTCURVE_TOTAL] = "_intensity_W_sr",
    MECHANISM(UM_MECHANISM_SUN) = "_sun_W_sr",
    MECHANISM(UM_MECHANISM_EARTH) = "_earth_W_sr",
    MECHANISM(UM_MECHANISM_EMITTED) = "_emitted_W_sr",
    MECHANISM(UM_MECHANISM_INTERREFLECTED) = "_interreflected_W_sr",
    MECHANISM(UM_MECHANISM_OTHER) = "_other_W_sr",
    [UM_LIGHTCURVE_STDERR] = "_stderr_W_sr",
    [UM_LIGHTCURVE_IRRADIANCE] = "_irradiance_W_m2",
    [UM_LIGHTCURVE_MAG_AB] = "_mag_ab",
    [UM_LIGHTCURVE_MAG_VEGA] = "_mag_vega",
    [UM_LIGHTCURVE_MAG_1000_KM] = "_mag_ab_1000km"};

const char *um_output_lightcurve_tail(size_t column) { return tails[column]; }

/* Behind the bands where three of them are thermal: one grey body, and from five on two. */
static const char *const grey_columns[UM_LIGHTCURVE_GREY] = {",characteristic_temperature_K",
                                                             ",characteristic_temperature_error_K",
                                                             ",infrared_cross_section_m2",
                                                             ",infrared_cross_section_error_m2",
                                                             ",grey_body_chi2",
                                                             ",cold_temperature_K",
                                                             ",cold_cross_section_m2",
                                                             ",hot_temperature_K",
                                                             ",hot_cross_section_m2"};

size_t um_output_grey_columns(const struct um_model *model)
{
  size_t n = um_model_thermal_bands(model);
  return n >= 5 ? UM_LIGHTCURVE_GREY : n >= 3 ? UM_LIGHTCURVE_GREY_ONE : 0;
}

void um_output_grey_values(const struct um_model_grey_body *grey, double out[UM_LIGHTCURVE_GREY])
{
  bool two = um_instrument_grey_body_prefers_two(&grey->one, &grey->two);
  for (size_t i = 0; i < UM_LIGHTCURVE_GREY; i++) out[i] = NAN;
  if (grey->one.n > 0) {
    out[0] = grey->one.temperature[0];
    out[1] = grey->temperature_error;
    out[2] = grey->one.area[0];
    out[3] = grey->area_error;
    out[4] = grey->one.chi2;
  }
  for (size_t j = 0; two && j < 2; j++) {
    out[5 + 2 * j] = grey->two.temperature[j];
    out[6 + 2 * j] = grey->two.area[j];
  }
}

static void write_header(const struct um_output_run *run, FILE *file)
{
  fputs("time_utc,azimuth_deg,elevation_deg,range_km,airmass,phase_angle_deg,sunlit_fraction,"
        "sun_elevation_deg",
        file);
  for (size_t b = 0; b < run->model->nband; b++)
    for (int c = 0; c < UM_LIGHTCURVE_COLUMNS; c++)
      um_core_csv_put_text(file, run->model->band[b].name, tails[c]);
  for (size_t c = 0; c < um_output_grey_columns(run->model); c++) fputs(grey_columns[c], file);
  fputc('\n', file);
}

/* The instant nearest mid-exposure stands for the geometry of an observation. */
static size_t middle(const struct um_model_tables *tables, size_t k)
{
  return k * tables->nsub + tables->nsub / 2;
}

enum um_status um_output_write_lightcurve(const struct um_output_run *run, FILE *file)
{
  const struct um_model_tables *tables = run->tables;
  const struct um_model_result *r = run->result;
  write_header(run, file);
  for (size_t k = 0; k < tables->nobs; k++) {
    const struct um_orbit_look *look = &tables->look[middle(tables, k)];
    const struct um_environment_sample *s = &tables->sample[middle(tables, k)];
    UM_TRY(um_output_stop(run));
    um_output_csv_time(file, tables->t_obs[k]);
    um_core_csv_put_number(file, look->azimuth / UM_DEG);
    um_core_csv_put_number(file, look->elevation / UM_DEG);
    um_core_csv_put_number(file, look->range * 1e-3);
    um_core_csv_put_number(file, um_environment_airmass_toward(look->elevation));
    um_core_csv_put_number(file, um_vec3_angle(s->sun, s->to_observer) / UM_DEG);
    um_core_csv_put_number(file, tables->sunlit[k]);
    um_core_csv_put_number(file, look->sun_elevation / UM_DEG);
    double nearer = 5.0 * log10(look->range / STANDARD_RANGE); /* [mag] */
    for (size_t b = 0; b < r->nband; b++) {
      double value[UM_LIGHTCURVE_COLUMNS] = {0.0};
      size_t at = k * r->nband + b;
      for (int m = 0; m < UM_MECHANISM_COUNT; m++)
        value[UM_LIGHTCURVE_TOTAL] += value[UM_LIGHTCURVE_MECHANISM + m] =
            um_model_result_intensity(r, k, b, m);
      value[UM_LIGHTCURVE_STDERR] = r->standard_error[at];
      value[UM_LIGHTCURVE_IRRADIANCE] = r->irradiance[at];
      value[UM_LIGHTCURVE_MAG_AB] = r->magnitude_ab[at];
      value[UM_LIGHTCURVE_MAG_VEGA] = r->magnitude_ab[at] - r->vega_ab[b];
      value[UM_LIGHTCURVE_MAG_1000_KM] = r->magnitude_ab[at] - nearer;
      for (int c = 0; c < UM_LIGHTCURVE_COLUMNS; c++) um_core_csv_put_number(file, value[c]);
    }
    double grey[UM_LIGHTCURVE_GREY];
    if (r->grey_body != NULL) um_output_grey_values(&r->grey_body[k], grey);
    for (size_t c = 0; r->grey_body != NULL && c < um_output_grey_columns(run->model); c++)
      um_core_csv_put_number(file, grey[c]);
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
        um_output_csv_time(file, run->tables->t_obs[k]);
        um_core_csv_put_text(file, run->model->band[b].name, "");
        um_core_csv_put_text(file, um_geometry_material_name(run->model->geometry, m), "");
        for (int i = 0; i < UM_MECHANISM_COUNT; i++) um_core_csv_put_number(file, at[i]);
        fputc('\n', file);
      }
  return UM_OK;
}
