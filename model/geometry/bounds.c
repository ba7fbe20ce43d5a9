/* What a run would ask of memory, reckoned before it is asked for, and the key that decides it; and
 * of the scenario, times and places. */
#include "model/geometry/bounds_impl.h"

#include <math.h>
#include <stdio.h>

#include "model/scenario/fail_group.h"

#define LOAD_ROWS_MOST 5e6 /* instants of the heat loads: 580 days of one every 10 s */
#define INSTANTS_MOST  5e6 /* observed ones, those inside exposures counted */
#define MEMORY_MOST    8e9 /* of one table [bytes] */

/* Bytes of an instant of the loads: sample, grid, and fifteen floats a surface, five without
 * angular moments (thermal/loads/loads.h). */
static double load_row_bytes(const struct um_model *model)
{
  double nsurface = (double)um_geometry_mesh(model->geometry)->nsurface;
  double nfloat = model->environment.absorptance_by_angle ? 15.0 : 5.0;
  return (double)sizeof(struct um_environment_sample) + 48.0 + nfloat * sizeof(float) * nsurface;
}

/* The mark of the law that turns fastest, where a spin decides the grid; NULL: none spins. */
static const struct um_mark *fastest_spin(const struct um_scenario *scenario)
{
  const struct um_scenario_attitude *law = scenario->attitude.items;
  struct um_scenario_turn turn, best = {.period_s = INFINITY};
  for (size_t i = 0; i < scenario->attitude.count; i++)
    if (um_scenario_turn(&law[i], &turn) && fabs(turn.period_s) < fabs(best.period_s)) best = turn;
  return best.mark;
}

enum um_status um_model_check_load_rows(struct um_context *context, const struct um_model *model,
                                        const struct um_model_tables *tables, double span,
                                        double step)
{
  const struct um_scenario *scenario = model->scenario;
  const struct um_scenario_thermal *thermal = scenario->thermal;
  const struct um_mark *spin = fastest_spin(scenario);
  double rows = span / step, bytes = rows * load_row_bytes(model);
  if (rows <= LOAD_ROWS_MOST && bytes <= MEMORY_MOST) return UM_OK;
  char cost[160];
  snprintf(
      cost, sizeof cost,
      "%.3g instants of the heat loads (%.3g GB), one every %.3g s for %.3g s; accepted: up to "
      "%g of them and %g GB",
      rows, bytes * 1e-9, step, span, LOAD_ROWS_MOST, MEMORY_MOST * 1e-9);
  if (!isnan(thermal->step_s))
    return um_model_fail(context, &thermal->at, "step_s", "%s, by a longer step", cost);
  if (spin != NULL && step < 1.0)
    return um_model_fail(context, spin, "period_s", "%s, by a slower spin or thermal.step_s", cost);
  double before = tables->t_first - tables->t_start;
  if (!isnan(tables->period) && before > 0.5 * span && thermal->orbits_before > 1.0)
    return um_model_fail(context, &thermal->at, "orbits_before", "%s, by fewer orbits", cost);
  return um_model_fail(context, &scenario->time->at, "stop_utc",
                       "%s, by a shorter span, thermal.step_s, or coarser facets", cost);
}

enum um_status um_model_check_instants(struct um_context *context, const struct um_model *model,
                                       size_t nobs, size_t nsub)
{
  const struct um_scenario_time *time = model->scenario->time;
  double n = (double)nobs * (double)nsub, nsurface = 0.0, nnode = 0.0, nmaterial = 0.0, nbin = 0.0;
  if (model->geometry != NULL) nsurface = (double)um_geometry_mesh(model->geometry)->nsurface;
  if (model->geometry != NULL) nmaterial = (double)um_geometry_material_count(model->geometry);
  if (model->body != NULL) nnode = (double)um_thermal_network_nodes(model->body->network);
  for (size_t b = 0; b < model->nband; b++) nbin += model->band[b].bins;
  /* a surface: sight, temperature and Earth loads; a node: temperature; a bin: five mechanisms */
  double bytes = n * (400.0 + 64.0 * nsurface + 8.0 * nnode + 40.0 * nbin +
                      80.0 * (double)model->nband * nmaterial);
  if (n <= INSTANTS_MOST && bytes <= MEMORY_MOST) return UM_OK;
  return um_model_fail(
      context, &time->at, nsub > 1 ? "exposure_samples" : "step_s",
      "%.3g observed instants (%zu observations of %zu) of %g surfaces, %g nodes and %g bins, %.3g "
      "GB; accepted: up to %g instants and %g GB",
      n, nobs, nsub, nsurface, nnode, nbin, bytes * 1e-9, INSTANTS_MOST, MEMORY_MOST * 1e-9);
}

enum um_status um_model_check_track(struct um_context *context, const struct um_model *model)
{
  if (!model->points) return UM_OK;
  return um_model_fail(context, &model->scenario->orbit->at, "points",
                       "has no times and places of its own; accepted: measurements with "
                       "satellite_height_km, azimuth_deg and elevation_deg (umbra compare, "
                       "diagnose, fit)");
}
