/* Start value of the temperature at which a thermostat switches, which does nothing by itself.
 * Where its place was measured, the coldest measurements are near it, since the heater kept the
 * place from growing colder. Elsewhere it is a cold quarter of the model's own range. */
#include "evidence/sensitivity/scan_impl.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/order.h"
#include "evidence/sensitivity/policy.h"
#include "model/run/run.h"

bool um_sensitivity_is_of(const char *measured, const char *target)
{
  const char *dot = strchr(target, '.');
  return strcmp(measured, target) == 0 || (dot != NULL && strcmp(measured, dot + 1) == 0);
}

static enum um_status measured_cold(struct um_context *context,
                                    const struct um_sensitivity_forward *f, const char *target,
                                    double *out)
{
  double *value = NULL;
  size_t n = 0;
  *out = NAN;
  UM_TRY(um_core_allocate(context, f->observations.count, sizeof *value, &value));
  for (size_t j = 0; j < f->observations.count; j++) {
    const struct um_compare_channel *c = &f->measurements->channel[f->observations.channel[j]];
    if (c->quantity == UM_QUANTITY_TEMPERATURE && um_sensitivity_is_of(c->of, target))
      value[n++] = f->observations.measured[j];
  }
  if (n > 0) {
    qsort(value, n, sizeof *value, um_core_order_double);
    *out = value[(size_t)(UM_SENSITIVITY_COLDEST * (double)(n - 1))];
  }
  um_core_free(context, value);
  return UM_OK;
}

static double modelled_cold(const struct um_model_result *result, const char *target)
{
  for (size_t p = 0; p < result->nplace; p++) {
    const struct um_model_place_history *place = &result->place[p];
    if (strcmp(place->name, target) != 0) continue;
    double low = INFINITY, high = -INFINITY;
    for (size_t k = 0; k < result->nobs; k++) {
      low = fmin(low, place->mean[k]); /* which the thermostat senses */
      high = fmax(high, place->mean[k]);
    }
    return low + UM_SENSITIVITY_COLD_SHARE * (high - low);
  }
  return NAN;
}

enum um_status um_sensitivity_scan(struct um_context *context,
                                   struct um_sensitivity_forward *forward,
                                   struct um_sensitivity_candidate *c,
                                   struct um_model_result **base)
{
  for (size_t p = 0; p < c->effect->nparameter; p++) {
    double at;
    if (!c->effect->parameters[p].is_temperature || c->target == NULL) continue;
    UM_TRY(measured_cold(context, forward, c->target, &at));
    if (isnan(at) && *base == NULL)
      UM_TRY(um_model_run_places(context, forward->model, forward->base.tables, forward->base.heat,
                                 base));
    if (isnan(at)) at = modelled_cold(*base, c->target);
    if (at >= c->effect->parameters[p].minimum && at <= c->effect->parameters[p].maximum)
      c->null_value[p] = at;
  }
  return UM_OK;
}
