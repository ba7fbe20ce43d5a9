/* Where temperatures begin: stated or periodic, and the exchange between surfaces with the
 * emittances at the temperatures of what follows. */
#include <math.h>
#include <string.h>

#include "model/run/thermal_solution.h"
#include "model/run/thermal_solution_group.h"

#define DRAFT_TOLERANCE 0.1   /* of a draft: a rough search while emittances are not known [K] */
#define DRAFT_FACTOR    30.0  /* of a draft, on the tolerances of the integration */
#define ROUNDING        1e-9  /* an emittance that moves by less is constant */
#define DRAFT_INSTANTS  128   /* that a mean of a stated start's run is made of */
#define DRAFT_EMITTANCE 0.003 /* an emittance that moves by less is known: the next is the same */

/* From heat->start to within `wanted` of the periodic start [K], surfaces exchanging what they do
 * now. draft: roughly. heat->mean: of the steady state itself where there is no orbit. */
static enum um_status search(struct um_context *context, struct um_model_thermal_solution *heat,
                             double wanted, bool draft)
{
  const struct um_model_tables *tables = heat->tables;
  const struct um_thermal_network *network = heat->model->body->network;
  struct um_thermal_solve_options options = heat->solver.options;
  struct um_thermal_periodic report;
  if (isnan(tables->period)) {
    UM_TRY(um_thermal_solve_steady(context, network, tables->loads, 0, &options, heat->start,
                                   heat->start));
    memcpy(heat->mean, heat->start, um_thermal_network_nodes(network) * sizeof *heat->mean);
    return UM_OK;
  }
  if (draft) options.tolerance_factor = fmax(options.tolerance_factor, DRAFT_FACTOR);
  UM_TRY(um_thermal_solve_periodic_report(context, network, tables->loads, &options, heat->start,
                                          tables->t_start, tables->period, wanted, heat->start,
                                          heat->drift, heat->mean, &report));
  heat->periodic_distance = report.distance;
  heat->orbit = report.audit;
  return UM_OK;
}

/* heat->mean: temperatures of a rough run from a stated start over its last orbit, or all of it
 * where it is shorter, of the fourth power [K]. */
static enum um_status run_roughly(struct um_context *context,
                                  struct um_model_thermal_solution *heat)
{
  const struct um_model_tables *tables = heat->tables;
  const struct um_thermal_network *network = heat->model->body->network;
  struct um_thermal_solve_options options = heat->solver.options;
  struct um_thermal_history *h = NULL;
  size_t n = um_thermal_network_nodes(network);
  double end = tables->loads->t[tables->loads->ntime - 1], time[DRAFT_INSTANTS];
  double *mean = heat->mean;
  if (!(end > tables->t_start)) {
    memcpy(mean, heat->start, n * sizeof *mean);
    return UM_OK;
  }
  double from = fmax(tables->t_start, end - fmax(tables->period, 0.0));
  if (!(from < end)) from = tables->t_start;
  for (size_t k = 0; k < DRAFT_INSTANTS; k++)
    time[k] = from + (end - from) * ((double)k + 0.5) / DRAFT_INSTANTS;
  options.tolerance_factor = fmax(options.tolerance_factor, DRAFT_FACTOR);
  UM_TRY(um_thermal_solve(context, network, tables->loads, &options, heat->start, tables->t_start,
                          time, DRAFT_INSTANTS, &h));
  memset(mean, 0, n * sizeof *mean);
  for (size_t k = 0; k < DRAFT_INSTANTS; k++)
    for (size_t i = 0; i < n; i++) mean[i] += pow(h->temperature[k * n + i], 4) / DRAFT_INSTANTS;
  for (size_t i = 0; i < n; i++) mean[i] = pow(mean[i], 0.25);
  um_thermal_history_destroy(context, &h);
  return UM_OK;
}

/* Of a stated start one rough run and one renewal, whatever is known of other models: results are
 * smooth in what the model is made of, and the same bits from anywhere. */
static enum um_status settle_stated(struct um_context *context,
                                    struct um_model_thermal_solution *heat)
{
  double change;
  UM_TRY(um_model_solver_options_renew(context, heat->model, heat->tables, heat->start, 0.0, 0,
                                       &heat->solver, &change));
  if (!(change > ROUNDING)) return UM_OK; /* no emittance depends on temperature */
  UM_TRY(run_roughly(context, heat));
  return um_model_solver_options_renew(context, heat->model, heat->tables, heat->mean, 0.0, 0,
                                       &heat->solver, &change);
}

bool um_model_thermal_can_extrapolate(const struct um_model_thermal_solution *heat)
{
  return heat->model->scenario->thermal->start == UM_START_PERIODIC &&
         !isnan(heat->tables->period) &&
         um_thermal_network_thermostats(heat->model->body->network) == 0;
}

enum um_status um_model_thermal_residual(struct um_context *context,
                                         const struct um_model_thermal_solution *heat,
                                         double *residual)
{
  const struct um_model_tables *tables = heat->tables;
  return um_thermal_orbit_mean_residual(context, heat->model->body->network, tables->loads,
                                        &heat->solver.options, tables->t_start, tables->period,
                                        heat->mean, residual);
}

/* heat->mean and start of a model next to that of `warm`, moved as their mean balances differ; the
 * exchange at the temperatures of that. */
static enum um_status extrapolate(struct um_context *context,
                                  const struct um_model_thermal_solution *warm,
                                  struct um_model_thermal_solution *heat)
{
  enum um_status status = UM_OK;
  const struct um_model_tables *tables = heat->tables;
  const struct um_thermal_network *network = heat->model->body->network;
  size_t n = um_thermal_network_nodes(network);
  double *found = NULL, change = INFINITY;
  if (warm->residual == NULL) {
    UM_TRY(um_core_allocate(context, n, sizeof *found, &found));
    UM_CHECK(um_model_thermal_residual(context, warm, found));
  }
  const double *residual = warm->residual != NULL ? warm->residual : found;
  memcpy(heat->mean, warm->mean, n * sizeof *heat->mean);
  for (int round = 1; change > UM_MODEL_SAME_EMITTANCE; round++) {
    UM_CHECK(um_thermal_orbit_mean_solve(context, network, tables->loads, &heat->solver.options,
                                         tables->t_start, tables->period, residual, heat->mean));
    UM_CHECK(um_model_solver_options_renew(context, heat->model, tables, heat->mean,
                                           UM_MODEL_SAME_EMITTANCE, round, &heat->solver, &change));
  }
  for (size_t i = 0; i < n; i++)
    if (um_thermal_network_kind(network, (uint32_t)i) != UM_NODE_BOUNDARY)
      heat->start[i] = warm->start[i] + heat->mean[i] - warm->mean[i];
done:
  um_core_free(context, found);
  return status;
}

/* What is known of the emittances that a periodic state will have. */
enum known { KNOWN_NOTHING, KNOWN_OF_ANOTHER, KNOWN_NEARLY };

/* Periodic start and exchange by turns until the emittances are the same, from built[nnode] [K].
 * Means over the orbit serve it in sunlight and in shadow. Drafts come first where emittances
 * depend on temperature and are not known nearly. */
static enum um_status settle_periodic(struct um_context *context,
                                      struct um_model_thermal_solution *heat, enum known known,
                                      double tolerance, const double *built)
{
  size_t n = um_thermal_network_nodes(heat->model->body->network);
  /* as exactly as the state: 5e-4 of what is exchanged moves a temperature by 0.01 K */
  const double same = UM_MODEL_SAME_EMITTANCE * tolerance / UM_MODEL_PERIODIC_TOLERANCE;
  double change = 0.0;
  if (known == KNOWN_NOTHING)
    UM_TRY(um_model_solver_options_renew(context, heat->model, heat->tables, heat->start, same, 0,
                                         &heat->solver, &change));
  bool draft = change > ROUNDING || (known == KNOWN_OF_ANOTHER && heat->solver.exchange != NULL);
  change = INFINITY;
  for (int round = 1; change > same; round++) {
    enum um_status status = search(context, heat, draft ? DRAFT_TOLERANCE : tolerance, draft);
    if (draft && status == UM_ERR_NUMERIC) { /* too rough for this body: search it as it is */
      um_core_message_clear(context);
      memcpy(heat->start, built, n * sizeof *built);
      draft = false;
      continue;
    }
    UM_TRY(status);
    UM_TRY(um_model_solver_options_renew(context, heat->model, heat->tables, heat->mean, same,
                                         round, &heat->solver, &change));
    if (!draft) continue;
    draft = change > DRAFT_EMITTANCE;
    change = INFINITY; /* the search itself is to come */
  }
  return UM_OK;
}

enum um_status um_model_thermal_start(struct um_context *context,
                                      const struct um_model_thermal_solution *warm,
                                      double periodic_tolerance,
                                      struct um_model_thermal_solution *heat)
{
  const struct um_thermal_network *network = heat->model->body->network;
  size_t n = um_thermal_network_nodes(network);
  double *built = NULL;
  enum um_status status;
  enum known known = KNOWN_NOTHING;
  heat->periodic_distance = NAN;
  if (heat->tables->points) return UM_OK;
  bool periodic = heat->model->scenario->thermal->start == UM_START_PERIODIC;
  if (!periodic) return settle_stated(context, heat);
  if (warm != NULL && um_thermal_network_nodes(warm->model->body->network) != n) warm = NULL;
  for (size_t i = 0; i < n && warm != NULL; i++)
    if (um_thermal_network_kind(network, (uint32_t)i) != UM_NODE_BOUNDARY)
      heat->start[i] = warm->start[i];
  UM_TRY(um_core_allocate(context, n, sizeof *built, &built));
  memcpy(built, heat->start, n * sizeof *built);
  if (warm != NULL) known = KNOWN_OF_ANOTHER;
  if (warm != NULL && um_model_thermal_can_extrapolate(warm) &&
      um_model_thermal_can_extrapolate(heat)) {
    status = extrapolate(context, warm, heat);
    known = KNOWN_NEARLY;
    if (status == UM_ERR_NUMERIC) { /* no such balance: from where the other stands */
      um_core_message_clear(context);
      memcpy(heat->start, built, n * sizeof *built);
      known = KNOWN_OF_ANOTHER;
    } else if (status != UM_OK) {
      goto done;
    }
  }
  UM_CHECK(settle_periodic(context, heat, known, periodic_tolerance, built));
done:
  um_core_free(context, built);
  return status;
}
