/* How the heat of a model is solved: tolerances, switches, surfaces that age, radiation between
 * surfaces. Private to model/. */
#ifndef UMBRA_MODEL_HEAT_SETTING_IMPL_H
#define UMBRA_MODEL_HEAT_SETTING_IMPL_H

#include "model/aging_impl.h"
#include "model/model.h"
#include "model/precomputed.h"
#include "thermal/exchange.h"
#include "thermal/solve_options.h"

struct um_model_heat_setting {
  struct um_thermal_solve_options options;
  struct um_model_aging *aging;         /* behind options.aging; NULL: nothing ages */
  struct um_thermal_exchange *exchange; /* behind options.exchange; NULL: none between surfaces */
};
/* With the optics that the model has. Model and geometry precomputation outlive it; cleared by the
 * caller, after a failure too. */
enum um_status um_model_heat_setting_make(struct um_context *context, const struct um_model *model,
                                          const struct um_model_precomputed *precomputed,
                                          struct um_model_heat_setting *out);
void um_model_heat_setting_clear(struct um_context *context, struct um_model_heat_setting *setting);

/* Tolerances and switches alone. */
struct um_thermal_solve_options um_model_heat_options(const struct um_model *model);
struct um_thermal_exchange_options um_model_exchange_options(const struct um_model *model);

#endif
