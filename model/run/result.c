/* The result of a run as it is kept. */
#include "model/run/result.h"

#include "optics/radiance/optics.h"

double um_model_result_intensity(const struct um_model_result *result, size_t k, size_t band,
                                 int mechanism)
{
  const double *at =
      result->intensity + (k * result->nband + band) * result->nmaterial * UM_MECHANISM_COUNT;
  double sum = 0.0;
  for (size_t m = 0; m < result->nmaterial; m++)
    for (int i = 0; i < UM_MECHANISM_COUNT; i++)
      if (mechanism < 0 || i == mechanism) sum += at[m * UM_MECHANISM_COUNT + (size_t)i];
  return sum;
}

void um_model_result_destroy(struct um_context *context, struct um_model_result **result)
{
  if (result == NULL || *result == NULL) return;
  struct um_model_result *r = *result;
  for (size_t i = 0; r->place != NULL && i < r->nplace; i++) {
    UM_FREE(context, r->place[i].name, r->place[i].mean, r->place[i].minimum, r->place[i].maximum);
  }
  UM_FREE(context, r->place, r->heat, r->irradiance, r->magnitude_ab, r->measured_intensity,
          r->intensity, r->standard_error, r->irradiance_error, r->magnitude_error, r->vega_ab,
          r->count_rate, r->grey_body, r->count_rate_error, r->spectral, r->wavelength,
          r->bin_width, r->transmission, r->bin_band, r->surface_temperature, r->node_temperature,
          r->mesh.surface, r->mesh.side, r->mesh.light, r->mesh.light_mean, r);
  *result = NULL;
}
