/* Temperatures: from the start through the observations. */
#include "model/run/thermal_solution.h"

#include <math.h>
#include <string.h>

#include "model/build/start_offset_group.h"
#include "model/geometry/thermal_equal_group.h"
#include "model/run/solver_options_impl.h"
#include "model/run/thermal_solution_group.h"
#include "thermal/solver/spin_variation.h"

/* The paper's reduction: every surface of a material at the material's mean temperature. */
static enum um_status to_material_means(struct um_context *context, const struct um_model *model,
                                        size_t ninstant, double *surface)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  size_t nmaterial = um_geometry_material_count(model->geometry);
  double *sum = NULL;
  UM_TRY(um_core_allocate(context, 2 * nmaterial, sizeof *sum, &sum));
  for (size_t i = 0; i < ninstant; i++) {
    double *t = surface + i * mesh->nsurface;
    if (um_core_stopped(context)) break; /* found where the light is computed */
    memset(sum, 0, 2 * nmaterial * sizeof *sum);
    for (size_t s = 0; s < mesh->nsurface; s++) {
      size_t m = mesh->surface[s].material;
      double area = mesh->area[mesh->surface[s].facet];
      sum[2 * m] += area * t[s];
      sum[2 * m + 1] += area;
    }
    for (size_t s = 0; s < mesh->nsurface; s++) {
      size_t m = mesh->surface[s].material;
      t[s] = sum[2 * m] / sum[2 * m + 1];
    }
  }
  um_core_free(context, sum);
  return UM_OK;
}

/* Without a track every node stays at its start temperature. */
static enum um_status hold_start(struct um_context *context, struct um_model_thermal_solution *heat)
{
  const struct um_model_tables *tables = heat->tables;
  struct um_thermal_history *h = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *h, &h));
  heat->run.history = h;
  h->ntime = tables->nobs;
  h->nnode = um_thermal_network_nodes(heat->model->body->network);
  UM_TRY(um_core_allocate(context, h->ntime, sizeof *h->t, &h->t));
  UM_TRY(um_core_allocate(context, h->ntime * h->nnode, sizeof(double), &h->temperature));
  for (size_t k = 0; k < h->ntime; k++) {
    h->t[k] = tables->sample[k].t_tai;
    memcpy(h->temperature + k * h->nnode, heat->start, h->nnode * sizeof(double));
  }
  return UM_OK;
}

/* Is the periodic orbit over when the observations begin? Its end is then a state to go on from,
 * which saves following it again. Not with a thermostat, which remembers whether it was on, unless
 * its phase is stated, nor where the run begins off the periodic state. */
static bool goes_on(const struct um_model_thermal_solution *heat)
{
  const struct um_model_tables *tables = heat->tables;
  return !isnan(heat->periodic_distance) && heat->model->start_offset == NULL &&
         um_thermal_network_phases_stated(heat->model->body->network) &&
         tables->t_periodic_end <= tables->sample[0].t_tai + 1e-6;
}

/* From the start, or the end of the periodic orbit, through the observations. */
static enum um_status follow(struct um_context *context, struct um_model_thermal_solution *heat)
{
  enum um_status status;
  const struct um_model_tables *tables = heat->tables;
  size_t ninstant = tables->nobs * tables->nsub;
  struct um_model_heat_run *run = &heat->run;
  double *times = NULL;
  UM_CHECK(um_core_allocate(context, ninstant + 1, sizeof *times, &times));
  double before = tables->t_first - tables->period, from = tables->t_start;
  bool on = goes_on(heat);
  if (on) from = fmin(tables->t_periodic_end, tables->sample[0].t_tai);
  run->from = from;
  run->before = before >= from - 1e-6;
  if (run->before) times[0] = fmax(before, from);
  for (size_t i = 0; i < ninstant; i++) times[i + (run->before ? 1 : 0)] = tables->sample[i].t_tai;
  UM_CHECK(um_thermal_solve(context, heat->model->body->network, tables->loads,
                            &heat->solver.options, heat->start, from, times,
                            ninstant + (run->before ? 1 : 0), &run->history));
  if (on) um_thermal_history_audit_join(run->history, &heat->orbit);
  UM_CHECK(um_thermal_history_audit_check(context, run->history, &heat->solver.options));
done:
  um_core_free(context, times);
  return status;
}

/* What nodes vary within a turn over whose means the loads went; the row an orbit before the first
 * instant gets what that instant gets, so that their difference is that of the means. */
static enum um_status variation_add(struct um_context *context,
                                    struct um_model_thermal_solution *heat)
{
  const struct um_model_tables *tables = heat->tables;
  const struct um_thermal_history *h = heat->run.history;
  size_t shift = heat->run.before ? 1 : 0;
  if (tables->spin_variation == NULL) return UM_OK;
  for (size_t k = 0; k < h->ntime; k++) {
    UM_TRY(um_core_stop_check(context, "temperatures within a turn were added"));
    UM_TRY(um_thermal_spin_variation_add(
        context, heat->model->body->network, tables->spin_variation, &heat->solver.options,
        tables->load_row[k < shift ? 0 : k - shift], 1.0, h->temperature + k * h->nnode));
  }
  return UM_OK;
}

enum um_status um_model_heat_run_surfaces(struct um_context *context,
                                          struct um_model_thermal_solution *heat)
{
  const struct um_model *model = heat->model;
  size_t nsurface = um_geometry_mesh(model->geometry)->nsurface;
  size_t ninstant = heat->tables->nobs * heat->tables->nsub;
  struct um_model_heat_run *run = &heat->run;
  size_t nnode = run->history->nnode;
  UM_TRY(um_core_allocate(context, ninstant * nsurface, sizeof(double), &run->surface));
  for (size_t i = 0; i < ninstant; i++)
    um_thermal_surface_temperatures(model->body->network,
                                    run->history->temperature + (i + (run->before ? 1 : 0)) * nnode,
                                    run->surface + i * nsurface);
  if (model->scenario->thermal->temperature_in_optics == 1)
    return to_material_means(context, model, ninstant, run->surface);
  return UM_OK;
}

/* How a solution is asked for. */
struct solution_options {
  const struct um_model_thermal_solution *warm; /* NULL: from nothing */
  double tolerance_factor;
  double periodic; /* of the state that repeats [K] */
};

static enum um_status solution_make(struct um_context *context, const struct um_model *model,
                                    const struct um_model_tables *tables,
                                    const struct solution_options *options,
                                    struct um_model_thermal_solution **out)
{
  enum um_status status;
  const struct um_model_thermal_solution *warm = options->warm;
  const struct um_thermal_network *network = model->body->network;
  size_t n = um_thermal_network_nodes(network);
  struct um_model_thermal_solution *heat = NULL;
  bool periodic = model->scenario->thermal->start == UM_START_PERIODIC;
  struct um_model_heat_like like = {NULL, NULL, NULL};
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *heat, &heat));
  *heat = (struct um_model_thermal_solution){.model = model, .tables = tables};
  if (warm != NULL && periodic)
    like = (struct um_model_heat_like){warm->model, warm->tables, &warm->solver};
  UM_CHECK(um_model_solver_options_make(context, model, tables, like.model != NULL ? &like : NULL,
                                        &heat->solver));
  heat->solver.options.tolerance_factor = options->tolerance_factor;
  heat->solver.options.no_audit = warm != NULL;
  UM_CHECK(um_core_allocate(context, n, sizeof *heat->start, &heat->start));
  UM_CHECK(um_core_allocate(context, n, sizeof *heat->mean, &heat->mean));
  if (periodic && !isnan(tables->period))
    UM_CHECK(um_core_allocate(context, n, sizeof *heat->drift, &heat->drift));
  for (size_t i = 0; i < n; i++)
    heat->start[i] = um_thermal_network_temperature(network, (uint32_t)i);
  UM_CHECK(um_model_thermal_start(context, warm, options->periodic, heat));
  UM_CHECK(um_model_start_offset_add(context, model, heat->start));
  /* temperatures that are stated are those of that instant, not means over its turn */
  if (tables->spin_variation != NULL && model->scenario->thermal->start == UM_START_ISOTHERMAL)
    UM_CHECK(um_thermal_spin_variation_add(context, network, tables->spin_variation,
                                           &heat->solver.options, 0, -1.0, heat->start));
  UM_CHECK(tables->points ? hold_start(context, heat) : follow(context, heat));
  UM_CHECK(variation_add(context, heat));
  UM_CHECK(um_model_heat_run_surfaces(context, heat));
  *out = heat;
  heat = NULL;
done:
  um_model_thermal_solution_destroy(context, &heat);
  return status;
}

enum um_status um_model_thermal_solution_create(struct um_context *context,
                                                const struct um_model *model,
                                                const struct um_model_tables *tables,
                                                const struct um_model_thermal_solution *warm,
                                                double tolerance_factor,
                                                struct um_model_thermal_solution **out)
{
  const struct solution_options options = {warm, tolerance_factor, UM_MODEL_PERIODIC_TOLERANCE};
  return solution_make(context, model, tables, &options, out);
}

enum um_status um_model_thermal_solution_near(struct um_context *context,
                                              const struct um_model *model,
                                              const struct um_model_tables *tables,
                                              const struct um_model_thermal_solution *warm,
                                              double tolerance_factor, double periodic,
                                              struct um_model_thermal_solution **out)
{
  const struct solution_options options = {warm, tolerance_factor, periodic};
  return solution_make(context, model, tables, &options, out);
}

/* Rows of the loads as heat of the nodes. */
static enum um_status keep_sums(struct um_context *context, struct um_model_thermal_solution *heat)
{
  if (heat->solver.sums != NULL || heat->solver.aging != NULL || heat->tables->loads == NULL)
    return UM_OK;
  return um_thermal_load_sums_create(context, heat->model->body->network, heat->tables->loads,
                                     &heat->solver.sums);
}

enum um_status um_model_thermal_solution_lead(struct um_context *context,
                                              struct um_model_thermal_solution *heat)
{
  if (heat->residual != NULL || heat->tables->points) return UM_OK;
  UM_TRY(keep_sums(context, heat));
  if (!um_model_thermal_can_extrapolate(heat)) return UM_OK;
  UM_TRY(um_core_allocate(context, um_thermal_network_nodes(heat->model->body->network),
                          sizeof *heat->residual, &heat->residual));
  enum um_status status = um_model_thermal_residual(context, heat, heat->residual);
  if (status == UM_OK) return UM_OK;
  um_core_free(context, heat->residual);
  heat->residual = NULL;
  if (status != UM_ERR_NUMERIC) return status;
  um_core_message_clear(context); /* no such balance, as each would find */
  return UM_OK;
}

size_t um_model_thermal_solution_bytes(const struct um_model_thermal_solution *heat)
{
  const struct um_thermal_history *h = heat->run.history;
  size_t nsurface = um_geometry_mesh(heat->model->geometry)->nsurface;
  return (h->ntime * h->nnode + heat->tables->nobs * heat->tables->nsub * nsurface) *
         sizeof(double);
}

void um_model_thermal_solution_destroy(struct um_context *context,
                                       struct um_model_thermal_solution **heat)
{
  if (heat == NULL || *heat == NULL) return;
  um_thermal_history_destroy(context, &(*heat)->run.history);
  UM_FREE(context, (*heat)->run.surface, (*heat)->start, (*heat)->mean, (*heat)->residual,
          (*heat)->drift);
  um_model_solver_options_clear(context, &(*heat)->solver);
  um_core_free(context, *heat);
  *heat = NULL;
}

/* Optics stand in the networks, which are compared themselves. */
static bool exchange_equal(const struct um_model_thermal_solution *heat,
                           const struct um_model *model, const struct um_model_tables *tables)
{
  return um_model_exchange_equal(heat->model, model) &&
         um_model_view_factors_equal(heat->tables->view_factors, tables->view_factors);
}

enum um_status um_model_thermal_solution_is_compatible(struct um_context *context,
                                                       const struct um_model_thermal_solution *heat,
                                                       const struct um_model *model,
                                                       const struct um_model_tables *tables,
                                                       bool *out)
{
  struct um_thermal_solve_options options = um_model_heat_options(model);
  const struct um_scenario_thermal *a = heat->model->scenario->thermal,
                                   *b = model->scenario->thermal;
  struct um_model_aging *aging = NULL;
  *out = um_model_heat_options_equal(&options, &heat->solver.options) && a->start == b->start &&
         a->temperature_in_optics == b->temperature_in_optics &&
         um_geometry_mesh(heat->model->geometry)->nsurface ==
             um_geometry_mesh(model->geometry)->nsurface &&
         um_model_times_equal(heat->tables, tables) &&
         um_model_loads_equal(heat->tables->loads, tables->loads) &&
         um_model_loads_equal(heat->tables->spin_variation, tables->spin_variation) &&
         um_thermal_network_equal(heat->model->body->network, model->body->network) &&
         exchange_equal(heat, model, tables) && um_model_start_offset_equal(heat->model, model);
  if (!*out || tables->points) return UM_OK;
  UM_TRY(um_model_aging_create(context, model, tables->loads, &aging));
  *out = um_model_aging_equal(heat->solver.aging, aging);
  um_model_aging_destroy(context, &aging);
  return UM_OK;
}
