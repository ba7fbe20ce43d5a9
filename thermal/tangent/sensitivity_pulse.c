/* Heat of pulses as a forcing: one watt while a pulse is on, 0 else. Ends of pulses end steps, so
 * that a step has a pulse in all of it or not at all. Heat w_a into an eliminated node a reaches
 * the unknowns that it touches through
 *
 *   dT_a = M^-1 w,   b_i = (K_ia + 4 s R_ia T_a^3) / C_i dT_a,   M = -dg/dT_a (cluster.c),
 *
 * and a itself is warmer by dT_a than the unknowns make it. Columns are in the order in which
 * pulses begin: those that have not begun are 0 and are left alone. */
#include <math.h>
#include <string.h>

#include "base/core/order.h"
#include "base/core/sort.h"
#include "thermal/tangent/sensitivity_impl.h"

/* Columns by the begin of their pulses, equal ones as they are listed. */
static void columns_order(struct um_thermal_pulses *p)
{
  for (size_t k = 0; k < p->npulse; k++) {
    size_t at = k;
    for (; at > 0 && p->pulse[p->order[at - 1]].t_from > p->pulse[k].t_from; at--)
      p->order[at] = p->order[at - 1];
    p->order[at] = k;
  }
}

enum um_status um_thermal_pulses_create(struct um_thermal_sensitivity_run *r,
                                        const struct um_thermal_forcings *forcings)
{
  struct um_thermal_pulses *p = &r->pulses;
  p->pulse = forcings->pulse;
  p->npulse = forcings->npulse;
  UM_TRY(um_core_allocate(r->context, p->npulse, sizeof *p->order, &p->order));
  UM_TRY(um_core_allocate(r->context, p->npulse, sizeof *p->acts, &p->acts));
  UM_TRY(um_core_allocate(r->context, 2 * p->npulse, sizeof *p->edge, &p->edge));
  UM_TRY(um_core_allocate(r->context, r->system->n, sizeof *p->change, &p->change));
  columns_order(p);
  for (size_t k = 0; k < p->npulse; k++) {
    p->edge[p->nedge++] = p->pulse[k].t_from - r->from;
    p->edge[p->nedge++] = p->pulse[k].t_to - r->from;
  }
  return um_core_sort(r->context, p->edge, p->nedge, sizeof *p->edge, um_core_order_double);
}

void um_thermal_pulses_release(struct um_thermal_sensitivity_run *r)
{
  um_core_free(r->context, r->pulses.order);
  um_core_free(r->context, r->pulses.acts);
  um_core_free(r->context, r->pulses.edge);
  um_core_free(r->context, r->pulses.change);
}

double um_thermal_pulses_end(const struct um_thermal_pulses *p)
{
  return p->next < p->nedge ? p->edge[p->next] : INFINITY;
}

void um_thermal_pulses_enter(struct um_thermal_sensitivity_run *r)
{
  struct um_thermal_pulses *p = &r->pulses;
  double t = r->t + UM_THERMAL_ONE_TIME;
  while (p->next < p->nedge && p->edge[p->next] <= t) p->next++;
  for (size_t k = 0; k < p->npulse; k++) {
    const struct um_thermal_pulse *pulse = &p->pulse[p->order[k]];
    p->acts[k] = pulse->t_from - r->from <= t && pulse->t_to - r->from > t;
    if (p->acts[k] && r->nvariant + k >= r->nactive) r->nactive = r->nvariant + k + 1;
  }
}

/* What a pulse puts into the nodes of an eliminated group becomes their changes [K/W]; false: none
 * of it. */
static bool group_change(const struct um_thermal_pulse *pulse,
                         const struct um_thermal_cluster *cluster, double *x)
{
  bool any = false;
  memset(x, 0, cluster->m * sizeof *x);
  for (size_t i = 0; i < pulse->nnode; i++)
    for (size_t a = 0; a < cluster->m; a++)
      if (cluster->node[a] == pulse->node[i]) {
        x[a] += pulse->weight[i];
        any = true;
      }
  if (any) um_thermal_system_cluster_answer(cluster, x);
  return any;
}

void um_thermal_pulses_force(struct um_thermal_sensitivity_run *r, size_t column, double *b)
{
  const struct um_thermal_system *system = r->system;
  size_t k = column - r->nvariant;
  const struct um_thermal_pulse *pulse = &r->pulses.pulse[r->pulses.order[k]];
  memset(b, 0, r->n * sizeof *b);
  if (!r->pulses.acts[k]) return;
  for (size_t i = 0; i < pulse->nnode; i++) {
    uint32_t u = system->unknown[pulse->node[i]];
    if (u != UM_THERMAL_NONE) b[u] += pulse->weight[i] / system->capacity[pulse->node[i]];
  }
  for (size_t g = 0; g < system->ncluster; g++)
    if (group_change(pulse, &system->cluster[g], r->pulses.change))
      um_thermal_system_cluster_pass(system, &system->cluster[g], 1.0, r->pulses.change, b);
}

void um_thermal_pulses_nodes(struct um_thermal_sensitivity_run *r, size_t column, double *s)
{
  const struct um_thermal_system *system = r->system;
  size_t k = column - r->nvariant;
  for (size_t g = 0; g < system->ncluster && r->pulses.acts[k]; g++) {
    const struct um_thermal_cluster *cluster = &system->cluster[g];
    if (!group_change(&r->pulses.pulse[r->pulses.order[k]], cluster, r->pulses.change)) continue;
    for (size_t a = 0; a < cluster->m; a++) s[cluster->node[a]] += r->pulses.change[a];
  }
}
