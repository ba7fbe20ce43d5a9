/* How the temperatures of a run answer to parameters: forward sensitivities along the history that
 * was found (thermal/tangent/sensitivity.h), many at once, and the solution of a model that such a
 * parameter has moved by any step,
 *
 *   T(p + h) = T(p) + h S(t),   S = dT/dp,
 *
 * in place of a run of its own, whose noise would be in every difference. */
#ifndef UMBRA_MODEL_THERMAL_SENSITIVITY_H
#define UMBRA_MODEL_THERMAL_SENSITIVITY_H

#include "model/run/thermal_solution.h"

/* Can the answer of temperatures to what makes a model from heat's be a sensitivity? Not where
 * nodes, heaters or power histories come or go, times of the observations or of the loads move or
 * edges of the shadow do, where a start is not the periodic state or the one that is stated, or
 * view factors differ; where loads are means over a turn, whose within-spin variation is added to
 * temperatures afterwards; and where thermostats switch: between switchings a derivative says
 * little of a step.
 * *out: yes or no. Does not fail but for memory. */
enum um_status um_model_thermal_sensitivity_is_applicable(
    struct um_context *context, const struct um_model_thermal_solution *heat,
    const struct um_model *model, const struct um_model_tables *tables, bool *out);

/* One parameter moved by `step` [its unit], not 0: a hundredth of what is plausible or less, as
 * curvature over the step is in the answer. Borrowed for the call. */
struct um_model_thermal_move {
  const struct um_model *model;
  const struct um_model_tables *tables;
  double step;
  /* What `model` was made from, where that is not heat's own model: heat's with thermostats of
     hardly any power, which switch where its temperatures pass them. Of all moves of a call the
     same. NULL: heat's own. */
  const struct um_model *base;
};

/* Answers of all nodes at all instants of a run. */
struct um_model_thermal_sensitivity;

/* Of moves [nmove] that the function above lets pass: their periodic start, then the way through
 * the observations. tolerance: error of a step over the largest answer [1]; 0: 2e-4, whose accuracy
 * is 1e-3 of a parameter's largest answer in every node of hidden-effect
 * (tests/model/products/thermal_sensitivity.c); of a body with foil in means of places, its single
 * facets are up to 8e-3 off (decision 0017). UM_ERR_INPUT where a move does not serve;
 * UM_ERR_NUMERIC. The caller destroys. */
enum um_status um_model_thermal_sensitivity_create(struct um_context *context,
                                                   const struct um_model_thermal_solution *heat,
                                                   const struct um_model_thermal_move *move,
                                                   size_t nmove, double tolerance,
                                                   struct um_model_thermal_sensitivity **out);
void um_model_thermal_sensitivity_destroy(struct um_context *context,
                                          struct um_model_thermal_sensitivity **sensitivity);

/* Temperatures of `model`, which parameter `which` has moved by `step` [its unit], from those of
 * heat: for light and places; it has no exchange between surfaces, so that what flows is not known,
 * and heat's audit. UM_ERR_NUMERIC where a temperature would fall to 0 K. The caller destroys. */
enum um_status um_model_thermal_solution_move(
    struct um_context *context, const struct um_model_thermal_solution *heat,
    const struct um_model_thermal_sensitivity *sensitivity, size_t which, double step,
    const struct um_model *model, const struct um_model_tables *tables,
    struct um_model_thermal_solution **out);

#endif
