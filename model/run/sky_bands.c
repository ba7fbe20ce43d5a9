/* Scattered light per observation and band, for effects that leave some of it in a reading. */
#include "model/run/parts_impl.h"

#include "model/build/effects_group.h"
#include "model/run/counts.h"
#include "model/run/sky_light.h"

/* An effect that is not there by itself. */
static bool is_asked(const struct um_model *model)
{
  struct um_effect_use use;
  for (size_t i = 0; um_model_effect_next(model, &i, &use);)
    if (use.effect->hooks.observation != NULL && !use.effect->on_by_default) return true;
  return false;
}

enum um_status um_model_sky_bands(struct um_context *context, const struct um_model *model,
                                  const struct um_model_tables *tables,
                                  const struct um_model_result *result, double **out)
{
  if (model->sky_light == NULL || !is_asked(model)) return UM_OK;
  UM_TRY(um_core_allocate(context, result->nobs * result->nband, sizeof **out, out));
  for (size_t k = 0; k < result->nobs; k++)
    for (size_t b = 0; b < result->nband; b++) {
      const struct um_optics_band *band = &model->band[b];
      struct um_instrument_bins bins = um_model_bins(result, b, NULL);
      struct um_model_sky sky;
      um_model_sky(model, tables, k, band->from, band->to, &sky);
      (*out)[k * result->nband + b] = um_model_sky_band(&sky, &bins);
    }
  return UM_OK;
}
