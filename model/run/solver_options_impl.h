/* How the heat of a model is solved: tolerances, switches, surfaces that age, radiation between
 * surfaces. Private to model/run/. */
#ifndef UMBRA_MODEL_SOLVER_OPTIONS_IMPL_H
#define UMBRA_MODEL_SOLVER_OPTIONS_IMPL_H

#include "model/build/aging_group.h"
#include "model/build/model.h"
#include "model/geometry/tables.h"
#include "thermal/exchange/exchange.h"
#include "thermal/network/solve_options.h"
#include "thermal/solver/load_sums.h"

struct um_model_solver_options {
  struct um_thermal_solve_options options;
  struct um_model_aging *aging;         /* behind options.aging; NULL: nothing ages */
  struct um_thermal_exchange *exchange; /* behind options.exchange; NULL: none between surfaces, or
                                           that of another model */
  struct um_thermal_load_sums *sums;    /* for models next to this one; NULL: none are kept */
};
/* Solver options that are at hand, and what they are of. */
struct um_model_heat_like {
  const struct um_model *model;
  const struct um_model_tables *tables;
  const struct um_model_solver_options *solver;
};
/* With the optics that the model has. like: of a model with the same surfaces, whose temperatures
 * the exchange begins with and whose rows of the loads serve, or NULL; where these are kept it
 * outlives the options. Model and geometry tables outlive it; cleared by the
 * caller, after a failure too. */
enum um_status um_model_solver_options_make(struct um_context *context,
                                            const struct um_model *model,
                                            const struct um_model_tables *tables,
                                            const struct um_model_heat_like *like,
                                            struct um_model_solver_options *out);
/* The same for a model that was moved from that of `like`, which outlives it: its exchange where it
 * would be the same, else one at the same temperatures, so that what differs is the move's. */
enum um_status um_model_solver_options_moved(struct um_context *context,
                                             const struct um_model *model,
                                             const struct um_model_tables *tables,
                                             const struct um_model_heat_like *like,
                                             struct um_model_solver_options *out);
/* All but the exchange. */
enum um_status um_model_solver_options_begin(struct um_context *context,
                                             const struct um_model *model,
                                             const struct um_model_tables *tables,
                                             struct um_model_solver_options *out);
/* Emittances of an exchange that are the same [1]: a surface that receives nothing else is then
 * within 40 mK at 300 K. */
#define UM_MODEL_SAME_EMITTANCE 5e-4
/* The exchange for nodes at temperature[nnode] [K] (um_thermal_exchange_renew). *change: of an
 * emittance, largest [1]; above tolerance [1] the exchange is another, and what was solved with it
 * is to be solved again. round: how often that was asked; UM_ERR_NUMERIC beyond a few. */
enum um_status um_model_solver_options_renew(struct um_context *context,
                                             const struct um_model *model,
                                             const struct um_model_tables *tables,
                                             const double *temperature, double tolerance, int round,
                                             struct um_model_solver_options *solver,
                                             double *change);
void um_model_solver_options_clear(struct um_context *context,
                                   struct um_model_solver_options *solver);

/* Tolerances and switches alone. */
struct um_thermal_solve_options um_model_heat_options(const struct um_model *model);
struct um_thermal_exchange_options um_model_exchange_options(const struct um_model *model);
/* Do surfaces of both models exchange heat in the same ways, and mirror the same shares? */
bool um_model_exchange_equal(const struct um_model *a, const struct um_model *b);

#endif
