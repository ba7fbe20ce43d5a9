/* Sensitivities beside a run: stretch by stretch between stops of the loads and switchings of
 * thermostats, wanted times by cubic interpolation of a step.
 *
 * Where thermostat m switches, its instant moves by dt_k, and S_k jumps,
 *
 *   dt_k = -(v . S_k - dtheta_m/dp_k) / (v . dT/dt),   S_k <- S_k - dP_m w / C dt_k,
 *
 * v the sensor's weights, theta_m the threshold that was passed, dP_m = +-P_m, w where it heats.
 */
#include "thermal/tangent/sensitivity.h"

#include <math.h>
#include <string.h>

#include "thermal/tangent/sensitivity_impl.h"

#define TOLERANCE  5e-5
#define FIRST_STEP 1.0 /* [s] */

static enum um_status times_check(struct um_context *context, double from, const double *times,
                                  size_t ntime)
{
  for (size_t k = 0; k < ntime; k++)
    if (!(times[k] >= (k == 0 ? from : times[k - 1])) || !isfinite(times[k]))
      return um_core_fail(context, UM_ERR_INPUT,
                          "heat sensitivities: time %zu is %.6f s; accepted: finite, ascending, "
                          "not before the start at %.6f s",
                          k, times[k], from);
  if (ntime > 0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "no times wanted of the heat sensitivities; accepted: 1 or more");
}

/* --- storage -------------------------------------------------------------------------------- */

static enum um_status systems_create(struct um_thermal_sensitivity_run *r,
                                     const struct um_thermal_sensitivity_subject *of,
                                     const struct um_thermal_forcings *forcings,
                                     enum um_thermal_system_kind kind, double duration)
{
  UM_TRY(um_thermal_base_create(of->context, of->network, of->loads, of->options, of->start,
                                of->from, kind, duration, &r->base));
  UM_TRY(um_thermal_system_create(of->context, of->network, of->loads, of->options, of->start,
                                  of->from, kind, &r->system));
  UM_TRY(um_core_allocate(of->context, forcings->nvariant, sizeof *r->variant, &r->variant));
  for (; r->nvariant < forcings->nvariant; r->nvariant++) {
    const struct um_thermal_variant *v = &forcings->variant[r->nvariant];
    const struct um_thermal_solve_options *options = v->options != NULL ? v->options : of->options;
    UM_TRY(um_thermal_system_create(of->context, v->network, v->loads, options, v->start, of->from,
                                    kind, &r->variant[r->nvariant]));
    struct um_thermal_system_exchange *own = r->variant[r->nvariant]->exchange;
    if (own != NULL && own->exchange == r->system->exchange->exchange)
      own->twin = r->system->exchange;
  }
  return UM_OK;
}

enum um_status um_thermal_sensitivity_run_create(const struct um_thermal_sensitivity_subject *of,
                                                 const struct um_thermal_forcings *forcings,
                                                 enum um_thermal_system_kind kind, double duration,
                                                 struct um_thermal_sensitivity_run *r)
{
  struct um_context *context = of->context;
  size_t ncolumn = forcings->nvariant + forcings->npulse;
  *r = (struct um_thermal_sensitivity_run){.context = context,
                                           .from = of->from,
                                           .ncolumn = ncolumn,
                                           .nactive = forcings->nvariant,
                                           .forced = true,
                                           .tolerance = TOLERANCE};
  UM_TRY(systems_create(r, of, forcings, kind, duration));
  UM_TRY(um_thermal_pulses_create(r, forcings));
  UM_TRY(um_core_allocate(context, ncolumn, sizeof *r->width, &r->width));
  for (size_t c = 0; c < ncolumn; c++)
    r->width[c] = c < r->nvariant ? forcings->variant[c].step : 1.0;
  UM_TRY(um_thermal_linear_create(r->system, &r->linear));
  if (r->system->exchange != NULL)
    UM_TRY(um_thermal_exchange_solver_create(r->system, ncolumn > 1 ? UM_THERMAL_LOT : 1,
                                             &r->exchange));
  r->n = r->system->nunknown;
  UM_TRY(um_core_allocate(context, r->system->nnonzero, sizeof(double), &r->jacobian));
  UM_TRY(um_core_allocate(context, r->system->nnonzero, sizeof(double), &r->matrix));
  double **const one[3] = {&r->y, &r->rate, &r->moved};
  for (int k = 0; k < 3; k++) UM_TRY(um_core_allocate(context, r->n, sizeof(double), one[k]));
  double **const all[8] = {&r->s,        &r->next,     &r->known,    &r->error,
                           &r->stage[0], &r->stage[1], &r->stage[2], &r->stage[3]};
  for (int k = 0; k < 8; k++)
    UM_TRY(um_core_allocate(context, ncolumn, r->n * sizeof(double), all[k]));
  return um_core_allocate(context, ncolumn, sizeof(double), &r->largest);
}

void um_thermal_sensitivity_run_free(struct um_thermal_sensitivity_run *r)
{
  void *block[] = {r->jacobian, r->matrix,   r->y,        r->rate,    r->moved,
                   r->s,        r->next,     r->error,    r->known,   r->stage[0],
                   r->stage[1], r->stage[2], r->stage[3], r->largest, r->width};
  for (size_t k = 0; k < sizeof block / sizeof block[0]; k++) um_core_free(r->context, block[k]);
  um_thermal_linear_destroy(&r->linear);
  um_thermal_exchange_solver_destroy(&r->exchange);
  for (size_t c = 0; c < r->nvariant; c++) um_thermal_system_destroy(&r->variant[c]);
  um_thermal_pulses_release(r);
  um_core_free(r->context, r->variant);
  um_thermal_system_destroy(&r->system);
  um_thermal_base_release(&r->base);
}

/* --- a run ---------------------------------------------------------------------------------- */

/* The system of a column; of a pulse, the base's. */
static struct um_thermal_system *column_system(const struct um_thermal_sensitivity_run *r,
                                               size_t column)
{
  return column < r->nvariant ? r->variant[column] : r->system;
}

/* Do unknowns of a column stand for other temperatures than the base's? */
static bool stores_vary(const struct um_thermal_sensitivity_run *r, size_t column)
{
  return r->system->store != NULL || column_system(r, column)->store != NULL;
}

/* dT_i / dp of an unknown y whose own answer is s. */
static double answer_of(const struct um_thermal_sensitivity_run *r, size_t column, size_t i,
                        double y, double s)
{
  double warming, of_variant;
  if (!stores_vary(r, column)) return s;
  double base = um_thermal_system_temperature_of(r->system, i, y, &warming);
  double moved = um_thermal_system_temperature_of(column_system(r, column), i, y, &of_variant);
  return s * warming + (r->forced ? (moved - base) / r->width[column] : 0.0);
}

/* The unknown's answer to a change of its temperature by t_moved per unit of the parameter. */
static double unknown_answer(const struct um_thermal_sensitivity_run *r, size_t column, size_t i,
                             double t_moved)
{
  const struct um_thermal_system *system = r->system, *variant = column_system(r, column);
  if (!stores_vary(r, column)) return t_moved;
  double t = system->first[i], warming;
  double y = um_thermal_system_unknown_of(system, i, t);
  double moved = um_thermal_system_unknown_of(variant, i, t);
  um_thermal_system_temperature_of(system, i, y, &warming);
  return t_moved / warming + (moved - y) / r->width[column];
}

/* Row of a column's answer. */
static size_t answer_row(const struct um_thermal_sensitivity_run *r, size_t column)
{
  if (column < r->nvariant) return column;
  return r->nvariant + r->pulses.order[column - r->nvariant];
}

/* Columns at time 0 from [ncolumn][nnode], or from the start temperatures (NULL). */
static void start_take(struct um_thermal_sensitivity_run *r, const double *start)
{
  const struct um_thermal_system *system = r->system;
  if (start != NULL) r->nactive = r->ncolumn;
  for (size_t c = 0; c < r->ncolumn; c++) {
    const double *first = system->first, *moved = column_system(r, c)->first;
    const double *given = start != NULL ? start + answer_row(r, c) * system->n : NULL;
    for (size_t k = 0; k < r->n; k++) {
      size_t i = system->node[k];
      double s = given != NULL ? given[i] : (moved[i] - first[i]) / r->width[c];
      s = unknown_answer(r, c, i, s);
      r->s[c * r->n + k] = s;
    }
    r->largest[c] = um_thermal_sensitivity_size(r, r->s, c);
  }
}

/* The base from the system's start temperatures. */
static enum um_status start_run(struct um_thermal_sensitivity_run *r)
{
  const struct um_thermal_system *base = r->base.system;
  for (size_t i = 0; i < base->n; i++)
    base->temperature[i] = r->system->temperature[i] = base->first[i];
  for (size_t c = 0; c < r->nvariant; c++)
    memcpy(r->variant[c]->temperature, base->temperature, base->n * sizeof(double));
  for (size_t c = 0; c < r->nvariant; c++)
    for (size_t i = 0; i < base->n; i++)
      if (base->fixed[i]) r->variant[c]->temperature[i] = r->variant[c]->first[i];
  r->t = 0.0;
  r->h = FIRST_STEP;
  um_thermal_pulses_enter(r);
  UM_TRY(um_thermal_base_start(&r->base, base->temperature));
  return um_thermal_sensitivity_begin(r);
}

/* The jump of all columns at a switching; slope: of the unknowns before it [K/s]. */
static void switch_jump(struct um_thermal_sensitivity_run *r, size_t m, bool was_on,
                        const double *slope)
{
  const struct um_thermal_system *system = r->system;
  const struct um_thermal_network_thermostat *t = system->thermostat[m].thermostat;
  const double *y = r->base.y; /* where the stretch begins */
  double speed = 0.0, warming, power = was_on ? -t->power : t->power;
  for (size_t j = 0; j < t->sensor.n; j++) {
    uint32_t u = system->unknown[t->sensor.node[j]];
    um_thermal_system_temperature_of(system, t->sensor.node[j], y[u], &warming);
    speed += t->sensor.weight[j] * slope[u] * warming;
  }
  for (size_t c = 0; c < r->nvariant && speed != 0.0; c++) {
    const struct um_thermal_network_thermostat *v = r->variant[c]->thermostat[m].thermostat;
    double *s = r->s + c * r->n;
    double moved = 0.0;
    if (r->forced) moved = (was_on ? v->off - t->off : v->on - t->on) / r->width[c];
    for (size_t j = 0; j < t->sensor.n; j++) {
      uint32_t u = system->unknown[t->sensor.node[j]];
      moved -= t->sensor.weight[j] * answer_of(r, c, t->sensor.node[j], y[u], s[u]);
    }
    double dt = moved / speed;
    for (size_t i = 0; i < t->at.n; i++)
      s[system->unknown[t->at.node[i]]] -=
          power * t->at.weight[i] / system->capacity[t->at.node[i]] * dt;
  }
}

/* From the end of a stretch into the next. */
static enum um_status stretch_next(struct um_thermal_sensitivity_run *r)
{
  const struct um_thermal_base *base = &r->base;
  /* still as before what happens: the base goes on below */
  memcpy(r->rate, base->last.slope, r->n * sizeof *r->rate);
  r->t = base->t[base->npoint - 1];
  UM_TRY(um_thermal_base_next(&r->base));
  for (size_t m = 0; m < r->system->nthermostat && r->system->kind == UM_SYSTEM_RUN; m++)
    if (r->system->thermostat[m].on != r->base.heating[m])
      switch_jump(r, m, r->system->thermostat[m].on, r->rate);
  return um_thermal_sensitivity_begin(r);
}

/* All nodes of all columns from their unknowns, at time t with the base's unknowns in r->y. */
enum um_status um_thermal_sensitivity_nodes(struct um_thermal_sensitivity_run *r, double t,
                                            const double *columns, double *out)
{
  struct um_thermal_system *system = r->system;
  bool lost = !um_thermal_system_state_set(system, t, r->y);
  for (size_t g = 0; g < system->ncluster && !lost; g++)
    lost = !um_thermal_system_cluster_linearize(system, &system->cluster[g]);
  if (r->exchange != NULL) um_thermal_system_exchange_hold(system, false);
  for (size_t c = 0; c < r->ncolumn && !lost; c++) {
    struct um_thermal_system *variant = column_system(r, c);
    double *s = out + answer_row(r, c) * system->n, inverse = 1.0 / r->width[c];
    if (system->ncluster > 0 && c < r->nvariant)
      lost = !um_thermal_system_state_set(variant, t, r->y);
    for (size_t i = 0; i < system->n; i++)
      s[i] = (variant->temperature[i] - system->temperature[i]) * inverse;
    for (size_t k = 0; k < r->n; k++)
      s[system->node[k]] = answer_of(r, c, system->node[k], r->y[k], columns[c * r->n + k]);
    if (c >= r->nvariant) um_thermal_pulses_nodes(r, c, s);
    if (r->exchange != NULL && system->ncluster > 0) {
      um_thermal_system_exchange_tangent(system, 0.0, columns + c * r->n, r->moved);
      for (size_t g = 0; g < system->ncluster; g++)
        for (size_t a = 0; a < system->cluster[g].m; a++)
          s[system->cluster[g].node[a]] +=
              um_thermal_system_exchange_followed(system, system->cluster[g].node[a]);
      continue;
    }
    for (size_t g = 0; g < system->ncluster; g++) {
      const struct um_thermal_cluster *cluster = &system->cluster[g];
      for (size_t a = 0; a < cluster->m; a++)
        for (size_t p = 0; p < cluster->p; p++)
          s[cluster->node[a]] +=
              cluster->response[a * cluster->p + p] * columns[c * r->n + cluster->neighbour[p]] *
              um_thermal_system_warming(system, system->node[cluster->neighbour[p]]);
    }
  }
  if (!lost) return UM_OK;
  return um_core_fail(r->context, UM_ERR_NUMERIC,
                      "heat sensitivities: an arithmetic node finds no balance %.3f s after the "
                      "start",
                      t);
}

/* What the caller wants. */
struct wanted {
  const double *times; /* [ntime] */
  size_t ntime, next;
  double from;
  double *columns, *out; /* [ncolumn][nunknown], [ncolumn][nnode] */
  um_thermal_sensitivity_take *take;
  void *user;
};

/* Hand over times[next] = from + t, columns as given. */
static enum um_status hand_over(struct um_thermal_sensitivity_run *r, struct wanted *w, double t,
                                const double *columns)
{
  um_thermal_base_at(&r->base, t, r->y);
  UM_TRY(um_thermal_sensitivity_nodes(r, t, columns, w->out));
  UM_TRY(w->take(w->user, w->next, r->system->temperature, w->out));
  w->next++;
  return UM_OK;
}

/* Times within the step of length h that has just ended at r->t. */
static enum um_status hand_over_step(struct um_thermal_sensitivity_run *r, struct wanted *w,
                                     double begin)
{
  double h = r->t - begin;
  while (w->next < w->ntime && w->times[w->next] - w->from <= r->t + UM_THERMAL_ONE_TIME) {
    double t = fmin(w->times[w->next] - w->from, r->t), u = (t - begin) / h;
    double w1 = u * u * (3.0 - 2.0 * u), w0 = 1.0 - w1;
    double v0 = h * u * (1.0 - u) * (1.0 - u), v1 = -h * u * u * (1.0 - u);
    for (size_t k = 0; k < r->nactive * r->n; k++)
      w->columns[k] = w0 * r->next[k] + w1 * r->s[k] + v0 * r->stage[0][k] + v1 * r->stage[3][k];
    UM_TRY(hand_over(r, w, t, w->columns));
  }
  return UM_OK;
}

/* From time 0 to `end`; w NULL: nothing is wanted on the way. */
static enum um_status run(struct um_thermal_sensitivity_run *r, double end, struct wanted *w)
{
  UM_TRY(start_run(r));
  while (w != NULL && w->next < w->ntime && w->times[w->next] - w->from <= UM_THERMAL_ONE_TIME)
    UM_TRY(hand_over(r, w, 0.0, r->s));
  while (r->t < end - UM_THERMAL_ONE_TIME) {
    const struct um_thermal_base *base = &r->base;
    if (base->ended && r->t >= base->t[base->npoint - 1] - UM_THERMAL_ONE_TIME)
      UM_TRY(stretch_next(r));
    if (r->t >= um_thermal_pulses_end(&r->pulses) - UM_THERMAL_ONE_TIME)
      UM_TRY(um_thermal_sensitivity_edge(r));
    double begin = r->t;
    UM_TRY(um_thermal_sensitivity_step(r, fmin(end, um_thermal_pulses_end(&r->pulses))));
    if (w != NULL) UM_TRY(hand_over_step(r, w, begin));
    um_thermal_base_drop(&r->base, r->t);
  }
  return UM_OK;
}

enum um_status um_thermal_sensitivity_follow(struct um_thermal_sensitivity_run *r, double end)
{
  return run(r, end, NULL);
}

enum um_status um_thermal_sensitivity(struct um_context *context,
                                      const struct um_thermal_network *network,
                                      const struct um_irradiation_loads *loads,
                                      const struct um_thermal_solve_options *options,
                                      const double *start, double from, const double *times,
                                      size_t ntime, const struct um_thermal_forcings *forcings,
                                      const struct um_thermal_sensitivity_options *how,
                                      um_thermal_sensitivity_take *take, void *user)
{
  enum um_status status;
  struct um_thermal_sensitivity_run r = {.context = context};
  struct wanted w = {.times = times, .ntime = ntime, .from = from, .take = take, .user = user};
  const struct um_thermal_sensitivity_subject of = {context, network, loads, options, start, from};
  UM_TRY(times_check(context, from, times, ntime));
  UM_TRY(um_thermal_sensitivity_check(&of, forcings, how));
  double end = times[ntime - 1] - from;
  UM_CHECK(
      um_thermal_sensitivity_run_create(&of, forcings, UM_SYSTEM_RUN, fmax(end, FIRST_STEP), &r));
  UM_CHECK(um_core_allocate(context, r.ncolumn, r.n * sizeof(double), &w.columns));
  UM_CHECK(um_core_allocate(context, r.ncolumn, r.system->n * sizeof(double), &w.out));
  if (how != NULL && how->tolerance > 0.0) r.tolerance = how->tolerance;
  start_take(&r, how != NULL ? how->start : NULL);
  UM_CHECK(run(&r, end, &w));
  um_core_log(context, UM_LOG_DEBUG, "heat sensitivities: %zu parameters in %zu steps, %zu refused",
              r.ncolumn, r.steps, r.refused);
done:
  um_core_free(context, w.columns);
  um_core_free(context, w.out);
  um_thermal_sensitivity_run_free(&r);
  return status;
}
