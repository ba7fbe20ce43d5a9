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
    um_core_free(context, r->place[i].name);
    um_core_free(context, r->place[i].mean);
    um_core_free(context, r->place[i].minimum);
    um_core_free(context, r->place[i].maximum);
  }
  um_core_free(context, r->place);
  um_core_free(context, r->heat);
  um_core_free(context, r->irradiance);
  um_core_free(context, r->magnitude_ab);
  um_core_free(context, r->measured_intensity);
  um_core_free(context, r->intensity);
  um_core_free(context, r->standard_error);
  um_core_free(context, r->irradiance_error);
  um_core_free(context, r->magnitude_error);
  um_core_free(context, r->vega_ab);
  um_core_free(context, r->count_rate);
  um_core_free(context, r->grey_body);
  um_core_free(context, r->count_rate_error);
  um_core_free(context, r->spectral);
  um_core_free(context, r->wavelength);
  um_core_free(context, r->bin_width);
  um_core_free(context, r->transmission);
  um_core_free(context, r->bin_band);
  um_core_free(context, r->surface_temperature);
  um_core_free(context, r->node_temperature);
  um_core_free(context, r);
  *result = NULL;
}
