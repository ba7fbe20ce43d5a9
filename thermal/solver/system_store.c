/* Capacities that go with temperature. With C stated at 300 K and shares w_s of it by ratios
 * r_s(T),
 *
 *   C(T) = C (1 + sum_s w_s (r_s(T) - 1)),   E(T) = integral of C(T') dT' from 300 K,
 *
 * and what is integrated in time is not T but
 *
 *   h = 300 K + E(T) / C,   dh/dt = H(T(h)) / C,   d(dh_i/dt)/dh_j = d(H_i / C_i)/dT_j  dT_j/dh_j.
 *
 * Multistep methods keep linear balances, so that the sum of C h, the heat stored, closes the audit
 * as it does where capacities are constant; there h is T, and nothing here is done. The reference
 * is 300 K: laws of capacity then differ little in h at one T, and so does the derivative by a law,
 * whose error is held to its size. r is linear between the rows of its table, E a parabola there;
 * below 0 K and beyond the table r is constant. */
#include <math.h>

#include "base/core/constants.h"
#include "thermal/solver/system_group.h"

#define ROWS       UM_THERMAL_LAW_TEMPERATURES
#define ITERATIONS 100
#define SETTLED    4e-15 /* of a temperature; rounding leaves a quarter of it */

static enum um_status shares_collect(struct um_thermal_system *system)
{
  const struct um_thermal_network *network = system->network;
  struct um_thermal_system_store *own = system->store;
  for (size_t k = 0; k < network->nstore; k++) own->start[network->store[k].node + 1]++;
  for (size_t i = 0; i < system->n; i++) own->start[i + 1] += own->start[i];
  size_t *next = NULL;
  UM_TRY(um_core_allocate(system->context, system->n, sizeof *next, &next));
  for (size_t k = 0; k < network->nstore; k++) {
    const struct um_thermal_store *store = &network->store[k];
    const struct um_thermal_ratio *ratio = network->capacity_law[store->law];
    size_t at = own->start[store->node], end = at + next[store->node];
    while (at < end && own->share[at].ratio != ratio) at++;
    if (at == end) next[store->node]++;
    own->share[at].ratio = ratio;
    own->share[at].content = own->content + store->law * ROWS;
    own->share[at].share += store->capacity / network->node[store->node].capacity;
  }
  um_core_free(system->context, next);
  return UM_OK;
}

/* The integral of r at the rows, that at 300 K being 300 K. The trapezoid is exact: r is linear
 * between rows. */
static void content_fill(const struct um_thermal_ratio *ratio, double *content)
{
  double slope, reference = um_thermal_ratio_at(ratio, UM_REFERENCE_TEMPERATURE, &slope);
  size_t k = (size_t)(UM_REFERENCE_TEMPERATURE / UM_THERMAL_LAW_STEP);
  double past = UM_REFERENCE_TEMPERATURE - (double)k * UM_THERMAL_LAW_STEP;
  content[0] = 0.0;
  for (size_t r = 1; r < ROWS; r++)
    content[r] = content[r - 1] + 0.5 * UM_THERMAL_LAW_STEP * (ratio->at[r - 1] + ratio->at[r]);
  double off = content[k] + 0.5 * past * (ratio->at[k] + reference) - UM_REFERENCE_TEMPERATURE;
  for (size_t r = 0; r < ROWS; r++) content[r] -= off;
}

enum um_status um_thermal_system_store_build(struct um_thermal_system *system)
{
  struct um_context *context = system->context;
  const struct um_thermal_network *network = system->network;
  if (network->nstore == 0 || system->kind == UM_SYSTEM_STEADY) return UM_OK;
  UM_TRY(um_core_allocate(context, 1, sizeof *system->store, &system->store));
  struct um_thermal_system_store *own = system->store;
  UM_TRY(um_core_allocate(context, system->n, sizeof(double), &system->warming));
  UM_TRY(um_core_allocate(context, system->n + 1, sizeof(size_t), &own->start));
  UM_TRY(um_core_allocate(context, network->nstore, sizeof *own->share, &own->share));
  UM_TRY(um_core_allocate(context, network->ncapacity_law, ROWS * sizeof(double), &own->content));
  for (size_t k = 0; k < network->ncapacity_law; k++)
    content_fill(network->capacity_law[k], own->content + k * ROWS);
  UM_TRY(shares_collect(system));
  um_thermal_system_store_at(system);
  return UM_OK;
}

void um_thermal_system_store_destroy(struct um_thermal_system *system)
{
  if (system->store == NULL) return;
  UM_FREE(system->context, system->store->start, system->store->share, system->store->content,
          system->store);
}

/* Integral of r to T [K], that at 300 K being 300 K, and r there. */
static double content_of(const struct um_thermal_system_share *share, double t, double *ratio)
{
  const double *r = share->ratio->at;
  if (t <= 0.0) {
    *ratio = r[0];
    return share->content[0] + r[0] * t;
  }
  double x = t / UM_THERMAL_LAW_STEP;
  if (x >= ROWS - 1) {
    *ratio = r[ROWS - 1];
    return share->content[ROWS - 1] + r[ROWS - 1] * (t - (ROWS - 1) * UM_THERMAL_LAW_STEP);
  }
  size_t k = (size_t)x;
  double u = x - (double)k;
  *ratio = (1.0 - u) * r[k] + u * r[k + 1];
  return share->content[k] + 0.5 * u * UM_THERMAL_LAW_STEP * (r[k] + *ratio);
}

/* h at T [K]; capacity: C(T) over C. */
static double unknown_at(const struct um_thermal_system *system, size_t i, double t,
                         double *capacity)
{
  const struct um_thermal_system_store *own = system->store;
  double h = t, ratio;
  *capacity = 1.0;
  for (size_t s = own->start[i]; s < own->start[i + 1]; s++) {
    const struct um_thermal_system_share *share = &own->share[s];
    if (share->ratio == NULL) break;
    h += share->share * (content_of(share, t, &ratio) - t);
    *capacity += share->share * (ratio - 1.0);
  }
  return h;
}

static bool varies(const struct um_thermal_system *system, size_t i)
{
  return system->store != NULL && system->store->start[i] < system->store->start[i + 1];
}

double um_thermal_system_unknown_of(const struct um_thermal_system *system, size_t i,
                                    double temperature)
{
  double capacity;
  return varies(system, i) ? unknown_at(system, i, temperature, &capacity) : temperature;
}

/* h is convex or concave by pieces and rises everywhere: Newton's iteration from h itself, kept
 * between the temperatures known to be too low and too high. It begins anew each time, so that an
 * answer does not depend on what was asked before. */
double um_thermal_system_temperature_of(const struct um_thermal_system *system, size_t i, double y,
                                        double *warming)
{
  double low = -INFINITY, high = INFINITY, t = y, capacity;
  *warming = 1.0;
  if (!varies(system, i)) return y;
  for (int k = 0; k < ITERATIONS; k++) {
    double miss = unknown_at(system, i, t, &capacity) - y;
    if (miss > 0.0)
      high = t;
    else
      low = t;
    double next = t - miss / capacity;
    bool done = fabs(next - t) <= SETTLED * fabs(t);
    if (!done && !(next > low && next < high) && isfinite(low) && isfinite(high))
      next = 0.5 * (low + high);
    t = next;
    if (done) break;
  }
  unknown_at(system, i, t, &capacity);
  *warming = 1.0 / capacity;
  return t;
}

void um_thermal_system_store_at(struct um_thermal_system *system)
{
  double capacity;
  for (size_t i = 0; i < system->n && system->store != NULL; i++) {
    system->warming[i] = 1.0;
    if (!varies(system, i)) continue;
    unknown_at(system, i, system->temperature[i], &capacity);
    system->warming[i] = 1.0 / capacity;
  }
}
