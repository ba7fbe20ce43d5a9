/* Temperatures of a run, on their own. */
#ifndef UMBRA_MODEL_THERMAL_SOLUTION_H
#define UMBRA_MODEL_THERMAL_SOLUTION_H

#include "model/build/model.h"
#include "model/geometry/tables.h"

#define UM_MODEL_PERIODIC_TOLERANCE 0.01 /* of the repeating state of a run [K] */

/* The heat half of a run, kept: models that differ in what heat does not feel (calibration,
 * roughness, emissivity in a band) share it. Model and geometry tables outlive it. */
struct um_model_thermal_solution;
/* warm: NULL, or heat of a model with the same nodes: a periodic state is looked for from where
 * that of `warm` moves to, which takes an orbit or two in place of many; the state found differs
 * within the tolerance of the search (0.01 K). It does not touch an isothermal start.
 * tolerance_factor: on the tolerances of the integration, above 0. The run goes on from the end
 * of the periodic orbit where it can. Errors of the thermal solvers. The caller destroys. */
enum um_status um_model_thermal_solution_create(struct um_context *context,
                                                const struct um_model *model,
                                                const struct um_model_tables *tables,
                                                const struct um_model_thermal_solution *warm,
                                                double tolerance_factor,
                                                struct um_model_thermal_solution **out);
/* The same for many models next to each other: the periodic state is found to within `periodic`
 * [K], of which the search's own estimate is a few times what is left. */
enum um_status um_model_thermal_solution_near(struct um_context *context,
                                              const struct um_model *model,
                                              const struct um_model_tables *tables,
                                              const struct um_model_thermal_solution *warm,
                                              double tolerance_factor, double periodic,
                                              struct um_model_thermal_solution **out);
/* Before many models are solved from this one: what each would find anew of it is found once. Their
 * results have the same bits without. Errors of the thermal solvers. */
enum um_status um_model_thermal_solution_lead(struct um_context *context,
                                              struct um_model_thermal_solution *heat);
/* Memory that it takes, but for some per cent [bytes]. */
size_t um_model_thermal_solution_bytes(const struct um_model_thermal_solution *heat);
void um_model_thermal_solution_destroy(struct um_context *context,
                                       struct um_model_thermal_solution **heat);
/* *out: true when the model has the same temperatures on these geometry tables: network,
 * loads, times, settings and what ages are equal, number for number. What an effect refuses. */
enum um_status um_model_thermal_solution_is_compatible(struct um_context *context,
                                                       const struct um_model_thermal_solution *heat,
                                                       const struct um_model *model,
                                                       const struct um_model_tables *tables,
                                                       bool *out);

#endif
