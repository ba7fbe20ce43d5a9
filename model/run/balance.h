/* Temperatures at which every node is in balance under loads that do not change. */
#ifndef UMBRA_MODEL_BALANCE_H
#define UMBRA_MODEL_BALANCE_H

#include "model/build/model.h"
#include "model/geometry/tables.h"

/* temperature[nnode] [K] under the loads of the first observation. Thermostats by their mean power,
 * joints as they stand then. Errors of um_thermal_solve_steady. */
enum um_status um_model_balance_steady(struct um_context *context, const struct um_model *model,
                                       const struct um_model_tables *tables, double *temperature);
/* The same under the heat that every node absorbs and releases in the mean over the first orbit of
 * the loads: H_i(T) + (1/P) int Q_i dt = 0. As emission is proportional to T^4, this is above the
 * mean of the temperatures. What moving joints change of the exchange between
 * surfaces is left out: they stand as at the beginning of the orbit. UM_ERR_INPUT: no orbit to
 * average over. */
enum um_status um_model_balance_orbit(struct um_context *context, const struct um_model *model,
                                      const struct um_model_tables *tables, double *temperature);
/* The balance of an orbit's mean as a network of nodes and conductors, which begin at its
 * temperatures (thermal/solver/flat.h); where no whole orbit is computed, that of the first
 * observation. The caller destroys. */
enum um_status um_model_balance_network(struct um_context *context, const struct um_model *model,
                                        const struct um_model_tables *tables,
                                        struct um_thermal_network **out);

#endif
