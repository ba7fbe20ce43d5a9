/* Exchange between surfaces in a heat balance. Node i has the shares g_ip of the area of patch p
 * and receives, beside what it radiates as if all went to space,
 *
 *   G_i = sum_p g_ip sum_q (eps B eps)_pq sigma sum_j g_jq (T_j^4 - T_space^4).
 *
 * Everyone feels everyone, so its derivative is not in the Jacobian's pattern: it is applied as it
 * stands here, three thin matrices, and linear equations are iterated with it (exchange_solve.c).
 */
#include "thermal/solver/system_group.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "thermal/solver/load_row_impl.h"

#define ROUNDS  100
#define SETTLED 1e-10 /* change of an eliminated node, of the largest of the unknowns [1] */

/* The same in rows per patch, nodes ascending. */
static enum um_status shares_turn(struct um_thermal_system *system,
                                  struct um_thermal_system_exchange *x)
{
  struct um_context *context = system->context;
  size_t n = system->n, nshare = x->start[n], npatch = x->exchange->npatch;
  UM_TRY(um_core_allocate(context, npatch + 2, sizeof *x->patch_start, &x->patch_start));
  UM_TRY(um_core_allocate(context, nshare, sizeof *x->patch_node, &x->patch_node));
  UM_TRY(um_core_allocate(context, nshare, sizeof *x->patch_share, &x->patch_share));
  for (size_t e = 0; e < nshare; e++) x->patch_start[x->patch[e] + 2]++;
  for (size_t p = 2; p <= npatch + 1; p++) x->patch_start[p] += x->patch_start[p - 1];
  for (size_t i = 0; i < n; i++)
    for (size_t e = x->start[i]; e < x->start[i + 1]; e++) {
      size_t at = x->patch_start[x->patch[e] + 1]++;
      x->patch_node[at] = (uint32_t)i;
      x->patch_share[at] = x->share[e];
    }
  return UM_OK;
}

/* Shares of nodes in patches, in rows per node. */
static enum um_status shares_build(struct um_thermal_system *system,
                                   struct um_thermal_system_exchange *x)
{
  struct um_context *context = system->context;
  const struct um_thermal_network *network = system->network;
  size_t n = system->n;
  UM_TRY(um_core_allocate(context, n + 2, sizeof *x->start, &x->start));
  for (int pass = 0; pass < 2; pass++) {
    for (size_t s = 0; s < network->nsurface; s++) {
      const struct um_thermal_surface *surface = &network->surface[s];
      uint32_t p = x->exchange->patch[s];
      for (int k = 0; k < 3 && network->attached[s] && p != UM_THERMAL_NO_PATCH; k++) {
        uint32_t node = surface->node[k];
        if (node == UM_THERMAL_SPACE) continue;
        if (pass == 0) {
          x->start[node + 2]++;
          continue;
        }
        size_t at = x->start[node + 1]++;
        x->patch[at] = p;
        x->share[at] = surface->weight[k] * surface->area / x->exchange->area[p];
      }
    }
    if (pass == 1) break;
    for (size_t i = 2; i <= n + 1; i++) x->start[i] += x->start[i - 1];
    UM_TRY(um_core_allocate(context, x->start[n + 1], sizeof *x->patch, &x->patch));
    UM_TRY(um_core_allocate(context, x->start[n + 1], sizeof *x->share, &x->share));
  }
  return shares_turn(system, x);
}

/* Emission of the outer surfaces of each node at the emittances that the exchange is made with, and
 * what else the node radiates by itself. */
static void stated_fill(struct um_thermal_system *system)
{
  const struct um_thermal_network *network = system->network;
  struct um_thermal_system_exchange *x = system->exchange;
  for (size_t s = 0; s < network->nsurface; s++) {
    const struct um_thermal_surface *surface = &network->surface[s];
    double *sum = surface->inside ? x->rest : x->stated;
    double ratio = surface->emittance > 0.0 ? x->exchange->emittance[s] / surface->emittance : 1.0;
    for (int k = 0; k < 3 && network->attached[s]; k++)
      if (surface->node[k] != UM_THERMAL_SPACE)
        sum[surface->node[k]] += ratio * um_thermal_load_row_emission(network, NULL, 0, s, k);
  }
  for (size_t r = 0; r < network->nradiator; r++)
    if (network->radiator[r].b == UM_THERMAL_SPACE)
      x->rest[network->radiator[r].a] += UM_STEFAN_BOLTZMANN * network->radiator[r].value;
}

/* Emittance now over that of the exchange: 1 where nothing changes it. */
static double ratio_of(const struct um_thermal_system *system, size_t node)
{
  const struct um_thermal_system_exchange *x = system->exchange;
  if (!(x->stated[node] > 0.0)) return 1.0;
  return (system->space[node] - x->rest[node]) / x->stated[node];
}

enum um_status um_thermal_system_exchange_build(struct um_thermal_system *system)
{
  struct um_context *context = system->context;
  const struct um_thermal_exchange *exchange = system->options.exchange;
  if (exchange == NULL || exchange->between == NULL) return UM_OK;
  struct um_thermal_system_exchange *x = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *x, &x));
  system->exchange = x;
  x->exchange = exchange;
  x->t = NAN;
  x->tuning.threads = um_core_context_threads(context);
  UM_TRY(shares_build(system, x));
  UM_TRY(um_core_allocate(context, exchange->npatch, sizeof(double), &x->power4));
  UM_TRY(um_core_allocate(context, exchange->npatch, sizeof(double), &x->heat));
  double **const of_node[9] = {&x->gain,   &x->made,   &x->stated, &x->rest,   &x->slope,
                               &x->change, &x->follow, &x->warm,   &x->cluster};
  double **const of_inside[3] = {&x->made_inside, &x->slope_inside, &x->warm_inside};
  for (int k = 0; k < 9; k++)
    UM_TRY(um_core_allocate(context, system->n, sizeof(double), of_node[k]));
  for (int k = 0; k < 3 && exchange->noutside < exchange->npatch; k++)
    UM_TRY(um_core_allocate(context, system->n, sizeof(double), of_inside[k]));
  stated_fill(system);
  um_thermal_system_exchange_at(system, 0.0);
  return UM_OK;
}

void um_thermal_system_exchange_destroy(struct um_thermal_system *system)
{
  struct um_thermal_system_exchange *x = system->exchange;
  if (x == NULL) return;
  void *const block[] = {x->stated,      x->rest,        x->made,        x->follow,
                         x->warm,        x->start,       x->patch,       x->share,
                         x->power4,      x->heat,        x->gain,        x->slope,
                         x->change,      x->cluster,     x->made_inside, x->slope_inside,
                         x->warm_inside, x->patch_start, x->patch_node,  x->patch_share,
                         x->lot,         x->lot_power4,  x->lot_heat};
  for (size_t k = 0; k < sizeof block / sizeof block[0]; k++)
    um_core_free(system->context, block[k]);
  um_core_free(system->context, x);
  system->exchange = NULL;
}

void um_thermal_system_exchange_at(struct um_thermal_system *system, double t)
{
  struct um_thermal_system_exchange *x = system->exchange;
  if (x->t == t) return;
  x->t = t;
  if (x->exchange->npose > 1) x->fresh = false;
  um_thermal_exchange_mix(x->exchange, system->from + t, &x->mix);
}

/* `sum` and share times value of entries [e, end), one after the other. */
static double sum_over(const struct um_thermal_system_exchange *x, size_t e, size_t end,
                       const double *of, double sum)
{
  for (; e < end; e++) sum += x->patch_share[e] * of[x->patch_node[e]];
  return sum;
}

/* Four patches from p on, each in its own order: one sum alone would wait for itself. */
static void four_sums(const struct um_thermal_system_exchange *x, size_t p, const double *of)
{
  const size_t *start = x->patch_start + p;
  double sum[4] = {0.0, 0.0, 0.0, 0.0};
  size_t shortest = SIZE_MAX;
  for (size_t s = 0; s < 4; s++)
    if (start[s + 1] - start[s] < shortest) shortest = start[s + 1] - start[s];
  for (size_t k = 0; k < shortest; k++)
    for (size_t s = 0; s < 4; s++)
      sum[s] += x->patch_share[start[s] + k] * of[x->patch_node[start[s] + k]];
  for (size_t s = 0; s < 4; s++)
    x->power4[p + s] = sum_over(x, start[s] + shortest, start[s + 1], of, sum[s]);
}

/* Means over patches of what nodes have, outside and inside, then what patches absorb. */
static void gather(struct um_thermal_system *system, const struct um_thermal_between *between,
                   const struct um_thermal_mix *mix, const double *of_node, const double *inside)
{
  struct um_thermal_system_exchange *x = system->exchange;
  size_t npatch = x->exchange->npatch, outside = x->exchange->noutside, p = 0;
  for (; p + 4 <= outside; p += 4) four_sums(x, p, of_node);
  for (; p < npatch; p++)
    x->power4[p] =
        sum_over(x, x->patch_start[p], x->patch_start[p + 1], p < outside ? of_node : inside, 0.0);
  um_thermal_thread_tuning_apply(&x->tuning, x->exchange, between, mix, x->power4, x->heat);
}

static double received(const struct um_thermal_system_exchange *x, size_t node)
{
  double sum = 0.0;
  for (size_t e = x->start[node]; e < x->start[node + 1]; e++)
    sum += x->share[e] * x->heat[x->patch[e]];
  return sum;
}

/* Has the twin been asked for the same? */
static bool twin_serves(const struct um_thermal_system *system)
{
  const struct um_thermal_system_exchange *x = system->exchange, *twin = x->twin;
  bool same = twin != NULL && twin->fresh && twin->t == x->t;
  for (size_t i = 0; i < system->n && same; i++)
    same = twin->made[i] == x->made[i] &&
           (x->made_inside == NULL || twin->made_inside[i] == x->made_inside[i]);
  return same;
}

double um_thermal_system_exchange_make(struct um_thermal_system *system)
{
  struct um_thermal_system_exchange *x = system->exchange;
  double largest = 0.0;
  bool same = x->fresh; /* a state is asked for several times: rate, audit, mean slopes */
  for (size_t i = 0; i < system->n; i++) {
    double own = ratio_of(system, i) * (system->power4[i] - system->space4);
    same = same && own == x->made[i];
    x->made[i] = own;
    if (x->made_inside == NULL) continue;
    own = system->power4[i] - system->space4;
    same = same && own == x->made_inside[i];
    x->made_inside[i] = own;
  }
  if (same) return 0.0;
  x->fresh = true;
  bool twin = twin_serves(system);
  if (!twin) gather(system, x->exchange->between, &x->mix, x->made, x->made_inside);
  for (size_t i = 0; i < system->n; i++) {
    double gain = twin ? x->twin->gain[i] : received(x, i), change = fabs(gain - x->gain[i]);
    largest = change > largest || isnan(change) ? change : largest;
    x->gain[i] = gain;
  }
  return largest;
}

void um_thermal_system_exchange_hold(struct um_thermal_system *system, bool strong)
{
  struct um_thermal_system_exchange *x = system->exchange;
  x->strong = strong;
  x->held = x->mix;
  for (size_t i = 0; i < system->n; i++) {
    x->slope[i] = 4.0 * ratio_of(system, i) * system->cube[i];
    if (system->space_slope != NULL && x->stated[i] > 0.0)
      x->slope[i] += system->space_slope[i] / x->stated[i] * (system->power4[i] - system->space4);
    if (x->slope_inside != NULL) x->slope_inside[i] = 4.0 * system->cube[i];
  }
}

/* Changes of the eliminated nodes [K] that follow from those of the unknowns x, without exchange.
 */
static void clusters_follow(const struct um_thermal_system *system, const double *x, double *change)
{
  for (size_t c = 0; c < system->ncluster; c++) {
    const struct um_thermal_cluster *cluster = &system->cluster[c];
    for (size_t a = 0; a < cluster->m; a++) {
      double sum = 0.0;
      for (size_t p = 0; p < cluster->p; p++)
        sum += cluster->response[a * cluster->p + p] * x[cluster->neighbour[p]] *
               um_thermal_system_warming(system, system->node[cluster->neighbour[p]]);
      change[cluster->node[a]] = sum;
    }
  }
}

/* What eliminated nodes receive warms them, `follow` [n] beside what the unknowns do; the largest
 * change of it [K]. */
static double clusters_warm(struct um_thermal_system *system, double *follow)
{
  struct um_thermal_system_exchange *x = system->exchange;
  double largest = 0.0;
  for (size_t c = 0; c < system->ncluster; c++) {
    const struct um_thermal_cluster *cluster = &system->cluster[c];
    for (size_t a = 0; a < cluster->m; a++) x->cluster[a] = received(x, cluster->node[a]);
    um_thermal_system_cluster_answer(cluster, x->cluster);
    for (size_t a = 0; a < cluster->m; a++) {
      size_t node = cluster->node[a];
      largest = fmax(largest, fabs(x->cluster[a] - follow[node]));
      follow[node] = x->cluster[a];
    }
  }
  return largest;
}

/* Their warmth goes on to the unknowns that they touch. */
static void clusters_pass(const struct um_thermal_system *system, double factor,
                          const double *follow, double *out)
{
  double *change = system->exchange->cluster;
  for (size_t c = 0; c < system->ncluster; c++) {
    const struct um_thermal_cluster *cluster = &system->cluster[c];
    for (size_t a = 0; a < cluster->m; a++) change[a] = follow[cluster->node[a]];
    um_thermal_system_cluster_pass(system, cluster, factor, change, out);
  }
}

void um_thermal_system_exchange_tangent(struct um_thermal_system *system, double factor,
                                        const double *x, double *out)
{
  struct um_thermal_system_exchange *own = system->exchange;
  double *change = own->change, *follow = own->follow, size = 0.0;
  memset(change, 0, system->n * sizeof *change);
  memset(follow, 0, system->n * sizeof *follow);
  for (size_t k = 0; k < system->nunknown; k++) {
    change[system->node[k]] = x[k] * um_thermal_system_warming(system, system->node[k]);
    size = fabs(x[k]) > size ? fabs(x[k]) : size;
  }
  clusters_follow(system, x, change);
  for (int round = 0; round < ROUNDS; round++) {
    for (size_t i = 0; i < system->n; i++) own->warm[i] = own->slope[i] * (change[i] + follow[i]);
    for (size_t i = 0; i < system->n && own->warm_inside != NULL; i++)
      own->warm_inside[i] = own->slope_inside[i] * (change[i] + follow[i]);
    gather(system, own->strong ? own->exchange->strong : own->exchange->between, &own->held,
           own->warm, own->warm_inside);
    if (system->ncluster == 0 || !(clusters_warm(system, follow) > SETTLED * size)) break;
  }
  for (size_t k = 0; k < system->nunknown; k++) {
    size_t i = system->node[k];
    if (own->start[i] < own->start[i + 1])
      out[k] += factor * received(own, i) / system->capacity[i];
  }
  clusters_pass(system, factor, follow, out);
}
