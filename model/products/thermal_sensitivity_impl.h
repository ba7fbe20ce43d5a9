/* Answers of temperatures as numbers. Private to model/products/. */
#ifndef UMBRA_MODEL_THERMAL_SENSITIVITY_IMPL_H
#define UMBRA_MODEL_THERMAL_SENSITIVITY_IMPL_H

#include "model/products/thermal_sensitivity.h"
#include "model/run/thermal_solution_group.h"

struct um_model_thermal_sensitivity {
  const struct um_model_thermal_solution *heat; /* borrowed */
  size_t nmove, nrow, nnode;
  float *value; /* [nmove][nrow][nnode] dT/dp at the rows of the history */
};

/* dT/dp of the surfaces at an instant of the geometry tables, of parameter k, out [nsurface]; self:
 * the sensitivity (struct um_optics_warmth). */
void um_model_thermal_sensitivity_surfaces(const void *self, size_t k, size_t instant, double *out);

#endif
