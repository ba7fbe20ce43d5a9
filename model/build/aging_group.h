/* Optics of materials that change during a run. Private to the rooms of model/. */
#ifndef UMBRA_MODEL_AGING_GROUP_H
#define UMBRA_MODEL_AGING_GROUP_H

#include "model/build/model.h"
#include "thermal/loads/loads.h"
#include "thermal/network/solve_options.h"

/* Adjustments [material of the geometry] that the effects make at t_tai [s]. */
enum um_status um_model_materials_at(struct um_context *context, const struct um_model *model,
                                     double t_tai, struct um_materials_adjustment *out);
/* The same at n instants, [n][material]; NULL where none differs from model->adjustment. The caller
 * frees. */
enum um_status um_model_materials_over(struct um_context *context, const struct um_model *model,
                                       const struct um_environment_sample *sample, size_t n,
                                       struct um_materials_adjustment **out);

/* For the heat balance, at the rows of the loads; table borrows the arrays. */
struct um_model_aging {
  struct um_thermal_aging table;
  double *absorptance, *emittance;
  uint32_t *material;
};
/* NULL where nothing ages. The caller destroys. */
enum um_status um_model_aging_create(struct um_context *context, const struct um_model *model,
                                     const struct um_irradiation_loads *loads,
                                     struct um_model_aging **out);
bool um_model_aging_equal(const struct um_model_aging *a, const struct um_model_aging *b);
void um_model_aging_destroy(struct um_context *context, struct um_model_aging **aging);

#endif
