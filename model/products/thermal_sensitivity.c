/* Sensitivities of a model's temperatures: networks, loads and exchange of the moved models become
 * variants of the base's (thermal/tangent/sensitivity.h). Start offsets are of both alike, so that
 * of a periodic start S is that of the periodic state. */
#include "model/products/thermal_sensitivity_impl.h"

#include <math.h>
#include <string.h>

#include "model/build/start_offset_group.h"
#include "model/geometry/thermal_equal_group.h"
#include "thermal/tangent/sensitivity.h"

/* Of a step over the largest answer (thermal/tangent/sensitivity.h). Of ENVISAT's pass 2e-4 leaves
 * 4e-4 of the largest answer in the means of parts, and up to 8e-3 in a facet of foil that the Sun
 * grazes; of hidden-effect 1e-3 in every node (tests/model/products/thermal_sensitivity.c); where
 * few columns share their steps 1.7e-3 (tests/evidence/sensitivity/matrix.c, thin_film, where 1e-4
 * leaves 3.6e-4). */
#define TOLERANCE 1e-4

/* --- what it is applicable to ----------------------------------------------------------------- */

/* The same instants and edges; what falls in between may differ. */
static bool grids_equal(const struct um_irradiation_loads *a, const struct um_irradiation_loads *b)
{
  return a == b || (a->ntime == b->ntime && a->nedge == b->nedge && a->nsurface == b->nsurface &&
                    memcmp(a->t, b->t, a->ntime * sizeof *a->t) == 0 &&
                    (a->nedge == 0 || memcmp(a->edge, b->edge, a->nedge * sizeof *a->edge) == 0));
}

/* base: what `model` was made from. */
static bool values_differ_alone(const struct um_model_thermal_solution *heat,
                                const struct um_model *base, const struct um_model *model,
                                const struct um_model_tables *tables)
{
  struct um_thermal_solve_options options = um_model_heat_options(model);
  const struct um_scenario_thermal *a = heat->model->scenario->thermal,
                                   *b = model->scenario->thermal;
  const struct um_model_tables *own = heat->tables;
  struct um_thermal_exchange_options x = um_model_exchange_options(heat->model),
                                     y = um_model_exchange_options(model);
  return !own->points && !tables->points && own->spin_variation == NULL &&
         tables->spin_variation == NULL && (a->start != UM_START_PERIODIC || !isnan(own->period)) &&
         a->start == b->start && um_model_heat_options_equal(&options, &heat->solver.options) &&
         um_model_times_equal(own, tables) && grids_equal(own->loads, tables->loads) &&
         um_thermal_network_nodes(heat->model->body->network) ==
             um_thermal_network_nodes(base->body->network) &&
         um_thermal_network_thermostats(heat->model->body->network) == 0 &&
         um_thermal_network_structure_equal(base->body->network, model->body->network) &&
         x.infrared == y.infrared && x.solar == y.solar &&
         um_model_view_factors_equal(own->view_factors, tables->view_factors) &&
         um_geometry_mesh(heat->model->geometry)->nsurface ==
             um_geometry_mesh(model->geometry)->nsurface &&
         um_model_start_offset_equal(heat->model, model);
}

enum um_status um_model_thermal_sensitivity_is_applicable(
    struct um_context *context, const struct um_model_thermal_solution *heat,
    const struct um_model *model, const struct um_model_tables *tables, bool *out)
{
  (void)context;
  *out = values_differ_alone(heat, heat->model, model, tables);
  return UM_OK;
}

/* --- sensitivities --------------------------------------------------------------------------- */

struct work {
  struct um_context *context;
  const struct um_model_thermal_solution *heat;
  double tolerance;
  struct um_model_solver_options *solver; /* [nmove] */
  const struct um_model *base;            /* of the moves */
  struct um_thermal_variant *variant;     /* [nmove] */
  double *begin;                          /* [nmove][nnode] start temperatures of the moved [K] */
  double *start;                          /* [nmove][nnode] S of a periodic start */
  struct um_model_thermal_sensitivity *to;
};

static enum um_status keep(void *user, size_t row, const double *temperature, const double *s)
{
  struct um_model_thermal_sensitivity *to = user;
  (void)temperature;
  for (size_t k = 0; k < to->nmove; k++)
    for (size_t i = 0; i < to->nnode; i++)
      to->value[(k * to->nrow + row) * to->nnode + i] = (float)s[k * to->nnode + i];
  return UM_OK;
}

static enum um_status variants_make(struct work *w, const struct um_model_thermal_move *move,
                                    size_t nmove)
{
  const struct um_model_thermal_solution *heat = w->heat;
  const struct um_model_heat_like like = {heat->model, heat->tables, &heat->solver};
  for (size_t k = 0; k < nmove; k++) {
    if (move[k].base != move[0].base ||
        !values_differ_alone(heat, w->base, move[k].model, move[k].tables))
      return um_core_fail(w->context, UM_ERR_INPUT,
                          "heat sensitivity %zu: the model has other nodes, heaters, times or "
                          "views; accepted: the base's, with other values",
                          k);
    UM_TRY(um_model_solver_options_moved(w->context, move[k].model, move[k].tables, &like,
                                         &w->solver[k]));
    double *begin = w->begin + k * w->to->nnode;
    for (uint32_t i = 0; i < w->to->nnode; i++)
      begin[i] = um_thermal_network_temperature(move[k].model->body->network, i);
    UM_TRY(um_model_start_offset_add(w->context, move[k].model, begin));
    w->variant[k] = (struct um_thermal_variant){.network = move[k].model->body->network,
                                                .loads = move[k].tables->loads,
                                                .options = &w->solver[k].options,
                                                .step = move[k].step,
                                                .start = begin};
  }
  return UM_OK;
}

static enum um_status follow(struct work *w)
{
  const struct um_model_thermal_solution *heat = w->heat;
  const struct um_model_tables *p = heat->tables;
  const struct um_thermal_network *network = w->base->body->network;
  const struct um_thermal_forcings forcings = {.variant = w->variant, .nvariant = w->to->nmove};
  struct um_thermal_sensitivity_options how = {.tolerance = w->tolerance};
  if (heat->model->scenario->thermal->start == UM_START_PERIODIC) {
    UM_TRY(um_thermal_sensitivity_periodic(w->context, network, p->loads, &heat->solver.options,
                                           heat->start, p->t_start, p->period, w->variant,
                                           w->to->nmove, &how, w->start));
    how.start = w->start;
  }
  return um_thermal_sensitivity(w->context, network, p->loads, &heat->solver.options, heat->start,
                                heat->run.from, heat->run.history->t, w->to->nrow, &forcings, &how,
                                keep, w->to);
}

enum um_status um_model_thermal_sensitivity_create(struct um_context *context,
                                                   const struct um_model_thermal_solution *heat,
                                                   const struct um_model_thermal_move *move,
                                                   size_t nmove, double tolerance,
                                                   struct um_model_thermal_sensitivity **out)
{
  enum um_status status;
  size_t n = um_thermal_network_nodes(heat->model->body->network);
  struct work w = {.context = context,
                   .heat = heat,
                   .base = nmove > 0 && move[0].base != NULL ? move[0].base : heat->model,
                   .tolerance = tolerance > 0.0 ? tolerance : TOLERANCE};
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *w.to, &w.to));
  *w.to = (struct um_model_thermal_sensitivity){
      .heat = heat, .nmove = nmove, .nrow = heat->run.history->ntime, .nnode = n};
  UM_CHECK(um_core_allocate(context, nmove, w.to->nrow * n * sizeof(float), &w.to->value));
  UM_CHECK(um_core_allocate(context, nmove, n * sizeof(double), &w.begin));
  UM_CHECK(um_core_allocate(context, nmove, n * sizeof(double), &w.start));
  UM_CHECK(um_core_allocate(context, nmove, sizeof *w.solver, &w.solver));
  UM_CHECK(um_core_allocate(context, nmove, sizeof *w.variant, &w.variant));
  UM_CHECK(variants_make(&w, move, nmove));
  UM_CHECK(follow(&w));
  *out = w.to;
  w.to = NULL;
done:
  for (size_t k = 0; w.solver != NULL && k < nmove; k++)
    um_model_solver_options_clear(context, &w.solver[k]);
  UM_FREE(context, w.solver, w.variant, w.begin, w.start);
  um_model_thermal_sensitivity_destroy(context, &w.to);
  return status;
}

void um_model_thermal_sensitivity_destroy(struct um_context *context,
                                          struct um_model_thermal_sensitivity **sensitivity)
{
  if (sensitivity == NULL || *sensitivity == NULL) return;
  UM_FREE(context, (*sensitivity)->value, *sensitivity);
  *sensitivity = NULL;
}

void um_model_thermal_sensitivity_surfaces(const void *self, size_t k, size_t instant, double *out)
{
  const struct um_model_thermal_sensitivity *s = self;
  const struct um_model_heat_run *run = &s->heat->run;
  size_t row = instant + (run->before ? 1 : 0);
  um_thermal_surface_answers(s->heat->model->body->network,
                             run->history->temperature + row * s->nnode,
                             s->value + (k * s->nrow + row) * s->nnode, out);
}

/* --- a solution that is moved ---------------------------------------------------------------- */

static enum um_status history_move(struct um_context *context,
                                   const struct um_thermal_history *from, const float *s,
                                   double step, struct um_thermal_history *to)
{
  size_t n = from->ntime * from->nnode;
  to->ntime = from->ntime;
  to->nnode = from->nnode;
  to->audit = from->audit;
  to->audit_error = from->audit_error;
  to->content = from->content;
  UM_TRY(um_core_allocate(context, to->ntime, sizeof *to->t, &to->t));
  UM_TRY(um_core_allocate(context, n, sizeof *to->temperature, &to->temperature));
  memcpy(to->t, from->t, to->ntime * sizeof *to->t);
  for (size_t i = 0; i < n; i++) {
    to->temperature[i] = from->temperature[i] + step * (double)s[i];
    if (!(to->temperature[i] > 0.0))
      return um_core_fail(context, UM_ERR_NUMERIC,
                          "a parameter moved by %g moves a temperature of %.4g K to %.4g K", step,
                          from->temperature[i], to->temperature[i]);
  }
  return UM_OK;
}

enum um_status um_model_thermal_solution_move(
    struct um_context *context, const struct um_model_thermal_solution *heat,
    const struct um_model_thermal_sensitivity *sensitivity, size_t which, double step,
    const struct um_model *model, const struct um_model_tables *tables,
    struct um_model_thermal_solution **out)
{
  enum um_status status;
  const float *s = sensitivity->value + which * sensitivity->nrow * sensitivity->nnode;
  struct um_model_thermal_solution *moved = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *moved, &moved));
  *moved = (struct um_model_thermal_solution){
      .model = model,
      .tables = tables,
      .periodic_distance = heat->periodic_distance,
      .moved = true,
      .run = {.before = heat->run.before, .from = heat->run.from}};
  UM_CHECK(um_model_solver_options_begin(context, model, tables, &moved->solver));
  moved->solver.options.tolerance_factor = heat->solver.options.tolerance_factor;
  UM_CHECK(um_core_allocate(context, 1, sizeof *moved->run.history, &moved->run.history));
  UM_CHECK(history_move(context, heat->run.history, s, step, moved->run.history));
  UM_CHECK(um_model_heat_run_surfaces(context, moved));
  *out = moved;
  moved = NULL;
done:
  um_model_thermal_solution_destroy(context, &moved);
  return status;
}
