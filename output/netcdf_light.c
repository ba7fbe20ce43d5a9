/* run.nc: light toward the observer, by band and by wavelength, material and mechanism. */
#include <math.h>

#include "output/lightcurve_impl.h"
#include "output/netcdf_impl.h"

static enum um_status put_bands(const struct um_output_netcdf *w)
{
  const char **names = NULL, *mechanisms[UM_MECHANISM_COUNT];
  for (size_t i = 0; i < UM_MECHANISM_COUNT; i++)
    mechanisms[i] = um_optics_mechanism_name((enum um_optics_mechanism)i);
  size_t n = w->length[UM_NC_BAND];
  UM_TRY(um_core_allocate(w->context, n, sizeof *names, &names));
  for (size_t i = 0; i < n; i++) names[i] = w->run->model->band[i].name;
  enum um_status status = um_output_netcdf_names(w, UM_NC_BAND, "spectral bands", names);
  um_core_free(w->context, names);
  UM_TRY(status);
  return um_output_netcdf_names(w, UM_NC_MECHANISM, "how the light comes about", mechanisms);
}

static enum um_status put_bins(const struct um_output_netcdf *w)
{
  const struct um_model_result *r = w->run->result;
  const enum um_output_dimension wl = UM_NC_WAVELENGTH;
  int *band = NULL;
  UM_TRY(
      um_output_netcdf_double(w, "wavelength", &wl, 1, "m", "centre of each bin", r->wavelength));
  UM_TRY(um_output_netcdf_double(w, "wavelength_width", &wl, 1, "m", "width of each bin",
                                 r->bin_width));
  UM_TRY(um_output_netcdf_double(w, "transmission", &wl, 1, "1",
                                 "mean of the band's filter over each bin", r->transmission));
  UM_TRY(um_core_allocate(w->context, r->nbin, sizeof *band, &band));
  for (size_t i = 0; i < r->nbin; i++) band[i] = (int)r->bin_band[i];
  enum um_status status =
      um_output_netcdf_int(w, "wavelength_band", &wl, 1, "index into band of each bin", band);
  um_core_free(w->context, band);
  return status;
}

/* A magnitude of no light is infinite: missing in a file. vega: less that of Vega. */
static enum um_status put_magnitude(const struct um_output_netcdf *w, const char *name,
                                    const char *meaning, bool vega)
{
  const struct um_model_result *r = w->run->result;
  const enum um_output_dimension tb[2] = {UM_NC_TIME, UM_NC_BAND};
  size_t n = r->nobs * r->nband;
  double *v = NULL;
  UM_TRY(um_core_allocate(w->context, n, sizeof *v, &v));
  for (size_t i = 0; i < n; i++) {
    double m = r->magnitude_ab[i] - (vega ? r->vega_ab[i % r->nband] : 0.0);
    v[i] = isfinite(m) ? m : (double)NAN;
  }
  enum um_status status = um_output_netcdf_double(w, name, tb, 2, "mag", meaning, v);
  um_core_free(w->context, v);
  return status;
}

static enum um_status put_counts(const struct um_output_netcdf *w)
{
  const struct um_model_result *r = w->run->result;
  const enum um_output_dimension ts[2] = {UM_NC_TIME, UM_NC_SENSOR};
  const char **names = NULL;
  if (r->nsensor == 0) return UM_OK;
  UM_TRY(um_core_allocate(w->context, r->nsensor, sizeof *names, &names));
  for (size_t i = 0; i < r->nsensor; i++) names[i] = w->run->model->sensor[i].name;
  enum um_status status =
      um_output_netcdf_names(w, UM_NC_SENSOR, "telescopes with detectors", names);
  um_core_free(w->context, names);
  UM_TRY(status);
  UM_TRY(um_output_netcdf_double(w, "count_rate", ts, 2, "s-1", "counts, NaN where hidden",
                                 r->count_rate));
  return um_output_netcdf_double(w, "count_rate_error", ts, 2, "s-1",
                                 "Monte-Carlo error of the counts", r->count_rate_error);
}

/* What an infrared observer concludes from the thermal bands, as lightcurve.csv has it. */
static enum um_status put_grey_bodies(const struct um_output_netcdf *w)
{
  static const struct {
    const char *name, *unit, *meaning;
  } variable[UM_LIGHTCURVE_GREY] = {
      {"characteristic_temperature", "K", "of one grey body through the thermal bands"},
      {"characteristic_temperature_error", "K", "of it by the Monte-Carlo error of the bands"},
      {"infrared_cross_section", "m2", "emissivity times area seen of that grey body"},
      {"infrared_cross_section_error", "m2", "of it by the Monte-Carlo error of the bands"},
      {"grey_body_chi2", "1", "chi-square of that grey body"},
      {"cold_temperature", "K", "of the colder of two grey bodies, NaN: one explains as much"},
      {"cold_cross_section", "m2", "emissivity times area seen of the colder one"},
      {"hot_temperature", "K", "of the hotter of two grey bodies, NaN: one explains as much"},
      {"hot_cross_section", "m2", "emissivity times area seen of the hotter one"}};
  const enum um_output_dimension time = UM_NC_TIME;
  const struct um_model_result *r = w->run->result;
  double *v = NULL, value[UM_LIGHTCURVE_GREY];
  enum um_status status = UM_OK;
  if (r->grey_body == NULL) return UM_OK;
  UM_TRY(um_core_allocate(w->context, r->nobs, sizeof *v, &v));
  for (size_t c = 0; c < um_output_grey_columns(w->run->model) && status == UM_OK; c++) {
    for (size_t k = 0; k < r->nobs; k++) {
      um_output_grey_values(&r->grey_body[k], value);
      v[k] = value[c];
    }
    status = um_output_netcdf_double(w, variable[c].name, &time, 1, variable[c].unit,
                                     variable[c].meaning, v);
  }
  um_core_free(w->context, v);
  return status;
}

enum um_status um_output_netcdf_light(const struct um_output_netcdf *w)
{
  const struct um_model_result *r = w->run->result;
  const enum um_output_dimension tb[2] = {UM_NC_TIME, UM_NC_BAND};
  const enum um_output_dimension twk[3] = {UM_NC_TIME, UM_NC_WAVELENGTH, UM_NC_MECHANISM};
  const enum um_output_dimension tbmk[4] = {UM_NC_TIME, UM_NC_BAND, UM_NC_MATERIAL,
                                            UM_NC_MECHANISM};
  if (r->nband == 0) return UM_OK;
  UM_TRY(put_bands(w));
  UM_TRY(put_bins(w));
  UM_TRY(um_output_netcdf_double(w, "irradiance", tb, 2, "W m-2",
                                 "at the aperture, NaN where hidden", r->irradiance));
  UM_TRY(put_magnitude(w, "magnitude_ab", "AB magnitude without an atmosphere, NaN: none", false));
  UM_TRY(put_magnitude(w, "magnitude_vega",
                       "magnitude relative to Vega without an atmosphere, NaN: none", true));
  UM_TRY(put_counts(w));
  UM_TRY(put_grey_bodies(w));
  UM_TRY(um_output_netcdf_double(w, "standard_error", tb, 2, "W sr-1",
                                 "Monte-Carlo error of the intensity", r->standard_error));
  UM_TRY(um_output_netcdf_double(w, "intensity", tbmk, 4, "W sr-1",
                                 "radiant intensity toward the observer", r->intensity));
  return um_output_netcdf_float(w, "spectral_intensity", twk, 3, "W sr-1 m-1",
                                "spectral radiant intensity toward the observer, before any filter",
                                r->spectral);
}
