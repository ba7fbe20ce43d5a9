/* Which band or place of a model answers a channel of measurements. */
#include <math.h>
#include <string.h>

#include "evidence/comparison/places_group.h"
#include "evidence/comparison/predict_source_impl.h"
#include "model/build/bands.h"
#include "optics/instrument/grey_body.h"

static size_t first_used(const struct um_compare_measurements *m, size_t channel)
{
  for (size_t i = 0; i < m->count; i++)
    if (m->row[i].channel == channel && m->row[i].flag == 0) return i;
  return UM_COMPARE_NOWHERE;
}

/* Of light, of which the scenario needs an observer. */
static bool is_light(enum um_compare_quantity quantity)
{
  return quantity != UM_QUANTITY_TEMPERATURE;
}

/* All thermal bands together, which the first one stands for. */
static enum um_status find_thermal(struct um_context *context, const struct um_model *model,
                                   enum um_compare_quantity quantity, const char *of, size_t *out)
{
  size_t n = um_model_thermal_bands(model);
  if (strcmp(of, UM_COMPARE_THERMAL) != 0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "'%s'; accepted: " UM_COMPARE_THERMAL ", all bands of %g to %g um together",
                        of, UM_INSTRUMENT_THERMAL_FROM * 1e6, UM_INSTRUMENT_THERMAL_TO * 1e6);
  if (n < 3)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s wants light in three bands of %g to %g um, the scenario has %zu; "
                        "accepted: a scenario with three or more",
                        um_compare_quantity_name(quantity), UM_INSTRUMENT_THERMAL_FROM * 1e6,
                        UM_INSTRUMENT_THERMAL_TO * 1e6, n);
  for (*out = 0; !um_model_band_is_thermal(&model->band[*out]);) (*out)++;
  return UM_OK;
}

/* Band, sensor or place by the name in the column `of`. */
static enum um_status find(struct um_context *context, const struct um_model *model,
                           enum um_compare_quantity quantity, const char *of, size_t *out)
{
  if (quantity == UM_QUANTITY_TEMPERATURE) return um_compare_place_find(context, model, of, out);
  if (quantity == UM_QUANTITY_COUNT_RATE) return um_model_sensor_require(context, model, of, out);
  if (um_compare_is_grey_body(quantity)) return find_thermal(context, model, quantity, of, out);
  return um_model_band_require(context, model, of, out);
}

enum um_status um_compare_source_find(struct um_context *context, const struct um_model *model,
                                      const struct um_compare_measurements *m, size_t channel,
                                      size_t *out)
{
  size_t row = first_used(m, channel);
  enum um_compare_quantity quantity = m->channel[channel].quantity;
  const char *of = m->channel[channel].of;
  *out = UM_COMPARE_NOWHERE;
  if (row == UM_COMPARE_NOWHERE) return UM_OK;
  int line = m->row[row].line;
  if (is_light(quantity) && !model->has_observer)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s:%d: column 'quantity': %s wants an observer, which the scenario has "
                        "not; accepted: temperature",
                        um_compare_row_path(m, row), line, um_compare_quantity_name(quantity));
  if (quantity == UM_QUANTITY_TEMPERATURE && model->points)
    return um_core_fail(
        context, UM_ERR_INPUT,
        "%s:%d: column 'quantity': temperature wants heat that is followed along an "
        "orbit, orbit.points has none; accepted: band_irradiance, "
        "radiant_intensity, magnitude_ab, magnitude_vega, count_rate, characteristic_temperature, "
        "infrared_cross_section",
        um_compare_row_path(m, row), line);
  enum um_status status = find(context, model, quantity, of, out);
  if (status != UM_OK)
    um_core_message_prefix(context, "%s:%d: column 'of'", um_compare_row_path(m, row), line);
  if (status != UM_OK || quantity != UM_QUANTITY_MAGNITUDE_VEGA || isfinite(model->vega_ab[*out]))
    return status;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s:%d: column 'of': band '%s' leaves 0.12 to 40 um, where Vega is known; "
                      "accepted: magnitude_ab",
                      um_compare_row_path(m, row), line, of);
}
