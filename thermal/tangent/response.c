/* Responses of temperatures to small heat along a base history.
 *
 * The base runs once, at the wanted times and in the middle of every step. A step takes the
 * Jacobian of its middle, eliminated nodes included (jacobian.c), and goes on by response_step.c. A
 * source acts at full strength in a step or not at all: its ends end steps. Heat w_a into an
 * eliminated node a reaches the unknowns it touches through
 *
 *   dT_a = M^-1 w,   b_i = (K_ia + 4 s R_ia T_a^3) / C_i dT_a,   M = -dg/dT_a (cluster.c),
 *
 * and its own temperature is the elimination's answer to the unknowns plus dT_a. Columns are in the
 * order in which sources begin, so those that have not begun are left alone. Wanted times need not
 * end a step. */
#include "thermal/tangent/response.h"

#include <math.h>
#include <string.h>

#include "thermal/solver/solve.h"
#include "thermal/tangent/response_impl.h"

static enum um_status sources_check(const struct um_thermal_response_run *r)
{
  for (size_t k = 0; k < r->nsource; k++) {
    const struct um_thermal_response_source *source = &r->source[k];
    if (!(source->t_from <= source->t_to) || !isfinite(source->t_from) || !isfinite(source->t_to))
      return um_core_fail(r->context, UM_ERR_INPUT,
                          "heat response %zu from %g s to %g s; accepted: finite, in this order", k,
                          source->t_from, source->t_to);
    for (size_t i = 0; i < source->nnode; i++)
      if (source->node[i] >= r->system->n || !isfinite(source->weight[i]))
        return um_core_fail(r->context, UM_ERR_INPUT,
                            "heat response %zu: node %lu with weight %g; accepted: below %zu, "
                            "finite",
                            k, (unsigned long)source->node[i], source->weight[i], r->system->n);
  }
  return UM_OK;
}

/* Columns by the begin of their sources, equal ones as they are listed. */
static void columns_order(struct um_thermal_response_run *r)
{
  for (size_t k = 0; k < r->nsource; k++) {
    size_t at = k;
    for (; at > 0 && r->source[r->order[at - 1]].t_from > r->source[k].t_from; at--)
      r->order[at] = r->order[at - 1];
    r->order[at] = k;
  }
}

/* State and Jacobian at a time [s from `from`] and given temperatures [n]; eliminated groups are
 * linearised. */
static enum um_status linearize(struct um_thermal_response_run *r, double t,
                                const double *temperature)
{
  struct um_thermal_system *system = r->system;
  um_thermal_system_loads_at(system, t); /* surfaces that age emit as they do then */
  if (system->exchange != NULL) um_thermal_system_exchange_at(system, t);
  memcpy(system->temperature, temperature, system->n * sizeof *temperature);
  um_thermal_system_store_at(system);
  um_thermal_system_powers(system);
  if (system->exchange != NULL) um_thermal_system_exchange_hold(system, false);
  if (um_thermal_system_jacobian(system, r->jacobian)) return UM_OK;
  return um_core_fail(r->context, UM_ERR_NUMERIC,
                      "an arithmetic node finds no balance in the heat responses");
}

static bool acts(const struct um_thermal_response_source *source, double from, double begin,
                 double end)
{
  return source->t_from - from <= begin + UM_THERMAL_ONE_TIME &&
         source->t_to - from >= end - UM_THERMAL_ONE_TIME;
}

/* What a source puts into the nodes of an eliminated group becomes their changes [K/W]; false: none
 * of it. */
static bool group_answer(const struct um_thermal_response_source *source,
                         const struct um_thermal_cluster *cluster, double *x)
{
  bool any = false;
  memset(x, 0, cluster->m * sizeof *x);
  for (size_t i = 0; i < source->nnode; i++)
    for (size_t a = 0; a < cluster->m; a++)
      if (cluster->node[a] == source->node[i]) {
        x[a] += source->weight[i];
        any = true;
      }
  if (any) um_thermal_system_cluster_answer(cluster, x);
  return any;
}

static bool column_rate(void *user, size_t column, double *b)
{
  struct um_thermal_response_run *r = user;
  const struct um_thermal_system *system = r->system;
  const struct um_thermal_response_source *source = &r->source[r->order[column]];
  if (!acts(source, r->from, r->begin, r->end)) return false;
  memset(b, 0, system->nunknown * sizeof *b);
  for (size_t i = 0; i < source->nnode; i++) {
    uint32_t u = system->unknown[source->node[i]];
    if (u != UM_THERMAL_NONE) b[u] += source->weight[i] / system->capacity[source->node[i]];
  }
  for (size_t g = 0; g < system->ncluster; g++) {
    const struct um_thermal_cluster *cluster = &system->cluster[g];
    if (!group_answer(source, cluster, r->cluster)) continue;
    for (size_t a = 0; a < cluster->m; a++) {
      uint32_t node = cluster->node[a];
      for (size_t e = system->start[node]; e < system->start[node + 1]; e++) {
        uint32_t i = system->other[e], u = system->unknown[i];
        if (u == UM_THERMAL_NONE) continue;
        b[u] += um_thermal_system_link_in(system, e, i, node, system->cube) * r->cluster[a] /
                system->capacity[i];
      }
    }
  }
  return true;
}

/* Sources that have begun before t. */
static size_t begun(const struct um_thermal_response_run *r, double t)
{
  size_t n = r->begun ? r->nsource : 0;
  while (n < r->nsource && r->source[r->order[n]].t_from - r->from < t - UM_THERMAL_ONE_TIME) n++;
  return n;
}

/* Responses of all nodes at t, temperatures linearised there: as they are before a source that
 * switches at t does so, at the start after it. */
static void out_fill(struct um_thermal_response_run *r, double t, const double *columns)
{
  const struct um_thermal_system *system = r->system;
  double begin = fmax(t - 2.0 * UM_THERMAL_ONE_TIME, 0.0);
  for (size_t column = 0; column < r->nsource; column++) {
    const struct um_thermal_response_source *source = &r->source[r->order[column]];
    const double *s = columns + column * system->nunknown;
    double *out = r->out + r->order[column] * system->n;
    for (size_t k = 0; k < system->nunknown; k++)
      out[system->node[k]] = s[k] * um_thermal_system_warming(system, system->node[k]);
    for (size_t g = 0; g < system->ncluster; g++) {
      const struct um_thermal_cluster *cluster = &system->cluster[g];
      bool heated = acts(source, r->from, begin, begin + 2.0 * UM_THERMAL_ONE_TIME) &&
                    group_answer(source, cluster, r->cluster);
      for (size_t a = 0; a < cluster->m; a++) {
        double sum = heated ? r->cluster[a] : 0.0;
        for (size_t p = 0; p < cluster->p; p++)
          sum += cluster->response[a * cluster->p + p] * out[system->node[cluster->neighbour[p]]];
        out[cluster->node[a]] = sum;
      }
    }
  }
}

/* The base and who takes what is wanted. */
struct march {
  const double *times; /* [ntime] */
  size_t ntime, next;
  const double *base;           /* temperatures at all times of um_thermal_response_times */
  const size_t *middle, *place; /* of the same */
  um_thermal_response_take *take;
  void *user;
};

static enum um_status hand_over(struct um_thermal_response_run *r, struct march *m,
                                const double *columns)
{
  const double *temperature = m->base + m->place[m->next] * r->system->n;
  if (r->system->ncluster > 0 || r->system->store != NULL)
    UM_TRY(linearize(r, m->times[m->next] - r->from, temperature));
  out_fill(r, m->times[m->next] - r->from, columns);
  UM_TRY(m->take(m->user, m->next, temperature, r->out));
  m->next++;
  return UM_OK;
}

static enum um_status step_take(struct um_thermal_response_run *r, struct march *m, size_t k)
{
  size_t stride = r->nsource * r->system->nunknown;
  UM_TRY(um_core_stop_check(r->context, "heat responses were computed"));
  struct um_thermal_step step = {
      .rate = column_rate, .user = r, .taken = r->inside, .stride = stride};
  r->begin = r->grid[k];
  r->end = r->grid[k + 1];
  for (size_t i = m->next; i < m->ntime && m->times[i] - r->from < r->end - UM_THERMAL_ONE_TIME;
       i++)
    step.inside[step.ninside++] = (m->times[i] - r->from - r->begin) / (r->end - r->begin);
  UM_TRY(linearize(r, 0.5 * (r->begin + r->end), m->base + m->middle[k] * r->system->n));
  UM_TRY(um_thermal_stepper_factor(r->stepper, r->jacobian, r->end - r->begin));
  UM_TRY(um_thermal_stepper_step(r->stepper, r->s, begun(r, r->end), &step));
  for (size_t i = 0; i < step.ninside; i++) UM_TRY(hand_over(r, m, r->inside + i * stride));
  return UM_OK;
}

static enum um_status march(struct um_thermal_response_run *r, struct march *m)
{
  for (size_t k = 0; k <= r->nstep; k++) {
    while (m->next < m->ntime && m->times[m->next] - r->from <= r->grid[k] + UM_THERMAL_ONE_TIME)
      UM_TRY(hand_over(r, m, r->s));
    if (k < r->nstep) UM_TRY(step_take(r, m, k));
  }
  return UM_OK;
}

static void start_take(struct um_thermal_response_run *r, const double *start)
{
  r->begun = true;
  for (size_t column = 0; column < r->nsource; column++)
    for (size_t k = 0; k < r->system->nunknown; k++)
      r->s[column * r->system->nunknown + k] =
          start[r->order[column] * r->system->n + r->system->node[k]] /
          um_thermal_system_warming(r->system, r->system->node[k]);
}

static enum um_status storage_create(struct um_thermal_response_run *r)
{
  struct um_thermal_system *system = r->system;
  UM_TRY(um_thermal_stepper_create(system, &r->stepper));
  UM_TRY(um_core_allocate(r->context, r->nsource, sizeof *r->order, &r->order));
  UM_TRY(um_core_allocate(r->context, r->nsource * system->nunknown, sizeof(double), &r->s));
  UM_TRY(um_core_allocate(r->context, UM_THERMAL_INSIDE * r->nsource,
                          system->nunknown * sizeof(double), &r->inside));
  UM_TRY(um_core_allocate(r->context, r->nsource * system->n, sizeof(double), &r->out));
  UM_TRY(um_core_allocate(r->context, system->n, sizeof(double), &r->cluster));
  return um_core_allocate(r->context, system->nnonzero, sizeof(double), &r->jacobian);
}

static void storage_free(struct um_thermal_response_run *r)
{
  um_thermal_stepper_destroy(&r->stepper);
  um_thermal_system_destroy(&r->system);
  void *const block[] = {r->order, r->s, r->inside, r->out, r->cluster, r->jacobian, r->grid};
  for (size_t k = 0; k < sizeof block / sizeof block[0]; k++) um_core_free(r->context, block[k]);
}

/* The base along the grid, then the responses. */
static enum um_status run(struct um_thermal_response_run *r, const double *times, size_t ntime,
                          um_thermal_response_take *take, void *user)
{
  enum um_status status;
  const struct um_thermal_system *system = r->system;
  struct um_thermal_history *base = NULL;
  double *all = NULL;
  size_t *middle = NULL, *place = NULL;
  UM_CHECK(um_core_allocate(r->context, r->nstep + ntime, sizeof *all, &all));
  UM_CHECK(um_core_allocate(r->context, r->nstep, sizeof *middle, &middle));
  UM_CHECK(um_core_allocate(r->context, ntime, sizeof *place, &place));
  um_thermal_response_times(r, times, ntime, all, middle, place);
  UM_CHECK(um_thermal_solve(r->context, system->network, system->loads, &system->options,
                            system->first, r->from, all, r->nstep + ntime, &base));
  struct march m = {times, ntime, 0, base->temperature, middle, place, take, user};
  UM_CHECK(march(r, &m));
done:
  um_thermal_history_destroy(r->context, &base);
  um_core_free(r->context, all);
  um_core_free(r->context, middle);
  um_core_free(r->context, place);
  return status;
}

static enum um_status times_check(struct um_context *context, double from, const double *times,
                                  size_t ntime)
{
  for (size_t k = 0; k < ntime; k++)
    if (!(times[k] >= (k == 0 ? from : times[k - 1])) || !isfinite(times[k]))
      return um_core_fail(context, UM_ERR_INPUT,
                          "heat responses: time %zu is %.6f s; accepted: finite, ascending, not "
                          "before the start at %.6f s",
                          k, times[k], from);
  if (ntime > 0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "no times wanted of the heat responses; accepted: 1 or more");
}

enum um_status um_thermal_response(struct um_context *context,
                                   const struct um_thermal_network *network,
                                   const struct um_irradiation_loads *loads,
                                   const struct um_thermal_solve_options *options,
                                   const double *start, double from, const double *times,
                                   size_t ntime, const struct um_thermal_response_source *source,
                                   size_t nsource, const struct um_thermal_response_options *how,
                                   um_thermal_response_take *take, void *user)
{
  enum um_status status;
  struct um_thermal_response_run r = {
      .context = context, .source = source, .nsource = nsource, .from = from};
  UM_TRY(times_check(context, from, times, ntime));
  UM_CHECK(um_thermal_system_create(context, network, loads, options, start, from, UM_SYSTEM_RUN,
                                    &r.system));
  UM_CHECK(sources_check(&r));
  UM_CHECK(storage_create(&r));
  columns_order(&r);
  if (how != NULL && how->start != NULL) start_take(&r, how->start);
  UM_CHECK(um_thermal_response_grid(&r, times, ntime, how));
  UM_CHECK(run(&r, times, ntime, take, user));
done:
  storage_free(&r);
  return status;
}
