/* Bands and sensors by name, and the bins of a band. */
#include "model/build/bands.h"

#include <math.h>
#include <string.h>

#include "base/core/suggestions.h"
#include "model/scenario/scenario.h"
#include "optics/instrument/grey_body.h"

size_t um_model_band_find(const struct um_model *model, const char *name)
{
  for (size_t b = 0; b < model->nband; b++)
    if (strcmp(model->band[b].name, name) == 0) return b;
  return (size_t)-1;
}

enum um_status um_model_band_require(struct um_context *context, const struct um_model *model,
                                     const char *name, size_t *out)
{
  struct um_core_words_guess guess = {.written = name};
  char accepted[320] = "", hint[UM_CORE_WORDS_HINT];
  *out = um_model_band_find(model, name);
  if (*out != (size_t)-1) return UM_OK;
  for (size_t b = 0; b < model->nband; b++) {
    um_core_words_append(accepted, sizeof accepted, model->band[b].name);
    um_core_words_consider(&guess, model->band[b].name);
  }
  return um_core_fail(context, UM_ERR_INPUT, "the scenario has no band '%s'%s; accepted: %s", name,
                      um_core_words_hint(&guess, hint), accepted);
}

enum um_status um_model_sensor_require(struct um_context *context, const struct um_model *model,
                                       const char *name, size_t *out)
{
  struct um_core_words_guess guess = {.written = name};
  char accepted[320] = "", hint[UM_CORE_WORDS_HINT];
  for (*out = 0; *out < model->nsensor; (*out)++) {
    if (strcmp(model->sensor[*out].name, name) == 0) return UM_OK;
    um_core_words_append(accepted, sizeof accepted, model->sensor[*out].name);
    um_core_words_consider(&guess, model->sensor[*out].name);
  }
  *out = (size_t)-1;
  if (model->nsensor == 0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "'%s' is not a sensor: the scenario has none; accepted: a scenario with "
                        "sensors",
                        name);
  return um_core_fail(context, UM_ERR_INPUT, "the scenario has no sensor '%s'%s; accepted: %s",
                      name, um_core_words_hint(&guess, hint), accepted);
}

bool um_model_band_is_thermal(const struct um_optics_band *band)
{
  return band->from >= UM_INSTRUMENT_THERMAL_FROM && band->to <= UM_INSTRUMENT_THERMAL_TO;
}

bool um_model_band_is_vega(const struct um_model *model, size_t band)
{
  static const char *const systems[] = {"johnson_", "cousins_", "gaia_", "wise_"};
  const struct um_scenario_band *from = model->scenario->bands.items;
  if (model->scenario->bands.count == 0 || !isfinite(model->vega_ab[band])) return false;
  bool vega = um_document_mark_key(&from[band].at, "vega_magnitude") != &from[band].at;
  for (size_t i = 0; from[band].filter != NULL && i < sizeof systems / sizeof *systems; i++)
    vega = vega || strncmp(from[band].filter, systems[i], strlen(systems[i])) == 0;
  return vega;
}

size_t um_model_thermal_bands(const struct um_model *model)
{
  size_t n = 0;
  for (size_t b = 0; b < model->nband; b++) n += um_model_band_is_thermal(&model->band[b]);
  return n;
}

enum um_status um_model_band_bins(struct um_context *context, const struct um_optics_band *band,
                                  struct um_instrument_bins *out)
{
  double *wavelength, *width;
  size_t n = (size_t)band->bins;
  *out = (struct um_instrument_bins){.n = n, .transmission = band->transmission};
  UM_TRY(um_core_allocate(context, 2 * n, sizeof *wavelength, &wavelength));
  width = wavelength + n;
  for (size_t i = 0; i < n; i++) {
    double from = um_optics_band_edge(band, (int)i), to = um_optics_band_edge(band, (int)i + 1);
    wavelength[i] = 0.5 * (from + to);
    width[i] = to - from;
  }
  out->wavelength = wavelength;
  out->width = width;
  return UM_OK;
}

void um_model_band_bins_clear(struct um_context *context, struct um_instrument_bins *bins)
{
  um_core_free(context, (void *)(uintptr_t)bins->wavelength);
  *bins = (struct um_instrument_bins){0};
}
