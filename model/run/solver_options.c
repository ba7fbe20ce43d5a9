/* How the heat of a model is solved. */
#include "model/run/solver_options_impl.h"

#include "model/geometry/mirrors.h"
#include "model/geometry/thermal_equal_group.h"
#include "model/scenario/tolerances.h"
#include "thermal/solver/solve.h"

#define ROUNDS 10 /* of a start and its exchange, each of which leaves a tenth or less */

struct um_thermal_solve_options um_model_heat_options(const struct um_model *model)
{
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  const struct um_scenario_thermal *thermal = model->scenario->thermal;
  um_model_tolerances(thermal, &options.relative_tolerance, &options.absolute_tolerance);
  options.space_temperature = thermal->space_temperature_K;
  options.albedo_on = model->environment.albedo_on;
  options.planet_on = model->environment.planet_on;
  return options;
}

struct um_thermal_exchange_options um_model_exchange_options(const struct um_model *model)
{
  return (struct um_thermal_exchange_options){.infrared = model->environment.mutual_radiation_on,
                                              .solar = model->environment.solar_reflection_on};
}

bool um_model_exchange_equal(const struct um_model *a, const struct um_model *b)
{
  struct um_thermal_exchange_options x = um_model_exchange_options(a),
                                     y = um_model_exchange_options(b);
  return x.infrared == y.infrared && x.solar == y.solar && um_model_mirrors_equal(a, b);
}

/* Is the radiation between surfaces that of a model which is at hand? aging: of this model. */
static bool exchange_is_compatible(const struct um_model_heat_like *like,
                                   const struct um_model *model,
                                   const struct um_model_tables *tables,
                                   const struct um_model_aging *aging)
{
  if (like->solver->options.exchange == NULL) return false;
  return um_model_exchange_equal(like->model, model) &&
         um_model_aging_equal(like->solver->aging, aging) &&
         um_thermal_network_optics_equal(like->model->body->network, model->body->network) &&
         um_model_view_factors_equal(like->tables->view_factors, tables->view_factors) &&
         um_model_loads_equal(like->tables->loads, tables->loads);
}

/* Do surfaces reflect the same sunlight to each other as those of a model that is at hand? */
static bool sunlight_equal(const struct um_model_heat_like *like, const struct um_model *model,
                           const struct um_model_tables *tables,
                           const struct um_model_solver_options *solver)
{
  return like->tables == tables &&
         um_model_exchange_options(like->model).solar == um_model_exchange_options(model).solar &&
         um_model_mirrors_equal_in_sunlight(like->model, model) &&
         um_model_aging_equal(like->solver->aging, solver->aging) &&
         um_thermal_network_solar_equal(like->model->body->network, model->body->network);
}

enum um_status um_model_solver_options_begin(struct um_context *context,
                                             const struct um_model *model,
                                             const struct um_model_tables *tables,
                                             struct um_model_solver_options *out)
{
  *out = (struct um_model_solver_options){.options = um_model_heat_options(model)};
  if (!tables->points) UM_TRY(um_model_aging_create(context, model, tables->loads, &out->aging));
  if (out->aging != NULL) out->options.aging = &out->aging->table;
  return UM_OK;
}

static enum um_status exchange_make(struct um_context *context, const struct um_model *model,
                                    const struct um_model_tables *tables,
                                    const struct um_model_heat_like *like,
                                    struct um_model_solver_options *out)
{
  struct um_thermal_exchange_options exchange = um_model_exchange_options(model);
  if (tables->view_factors == NULL) return UM_OK;
  exchange.aging = out->options.aging;
  if (like != NULL) exchange.like = like->solver->options.exchange;
  if (exchange.like != NULL) exchange.like_sunlight = sunlight_equal(like, model, tables, out);
  struct um_model_lobes lobes = {0};
  enum um_status status = UM_OK;
  if (tables->view_factors->mirrors != NULL) {
    UM_CHECK(um_model_lobes_make(context, model, tables->view_factors->mirrors, &lobes));
    exchange.lobes = &lobes.lobes;
    exchange.mirrored = tables->mirrored;
  }
  UM_CHECK(um_thermal_exchange_create(context, model->body->network, tables->loads,
                                      tables->view_factors, &exchange, &out->exchange));
  out->options.exchange = out->exchange;
done:
  um_model_lobes_clear(context, &lobes);
  return status;
}

enum um_status um_model_solver_options_make(struct um_context *context,
                                            const struct um_model *model,
                                            const struct um_model_tables *tables,
                                            const struct um_model_heat_like *like,
                                            struct um_model_solver_options *out)
{
  UM_TRY(um_model_solver_options_begin(context, model, tables, out));
  if (like != NULL) out->options.sums = like->solver->sums;
  return exchange_make(context, model, tables, like, out);
}

enum um_status um_model_solver_options_moved(struct um_context *context,
                                             const struct um_model *model,
                                             const struct um_model_tables *tables,
                                             const struct um_model_heat_like *like,
                                             struct um_model_solver_options *out)
{
  UM_TRY(um_model_solver_options_begin(context, model, tables, out));
  out->options.sums = like->solver->sums;
  if (!exchange_is_compatible(like, model, tables, out->aging))
    return exchange_make(context, model, tables, like, out);
  out->options.exchange = like->solver->options.exchange;
  return UM_OK;
}

enum um_status um_model_solver_options_renew(struct um_context *context,
                                             const struct um_model *model,
                                             const struct um_model_tables *tables,
                                             const double *temperature, double tolerance, int round,
                                             struct um_model_solver_options *solver, double *change)
{
  UM_TRY(um_thermal_exchange_renew(context, model->body->network, tables->view_factors,
                                   solver->options.aging, temperature, tolerance, solver->exchange,
                                   change));
  if (*change <= tolerance || round < ROUNDS) return UM_OK;
  return um_core_fail(context, UM_ERR_NUMERIC,
                      "emittances of surfaces that see each other do not settle with their "
                      "temperatures: after %d starts one moves by %.2g of 1; accepted: %.2g",
                      round, *change, tolerance);
}

void um_model_solver_options_clear(struct um_context *context,
                                   struct um_model_solver_options *solver)
{
  um_model_aging_destroy(context, &solver->aging);
  um_thermal_exchange_destroy(context, &solver->exchange);
  um_thermal_load_sums_destroy(context, &solver->sums);
}
