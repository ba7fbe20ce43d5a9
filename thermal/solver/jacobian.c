/* Jacobian of the unknowns in compressed columns on a pattern fixed once:
 *
 *   d(dT_i/dt)/dT_j = (K_ij + 4 s R_ij T_j^3) / C_i                              i != j
 *   d(dT_i/dt)/dT_i = -(sum_j (K_ij + 4 s R_ij T_i^3) + 4 s R_i,space T_i^3) / C_i
 *
 * plus (K_ia + 4 s R_ia T_a^3) / C_i dT_a/dT_j for every eliminated node a that i touches, plus
 * w_i v_j / C_i dP/dT of a thermostat taken by its mean power, weights w where it heats and v where
 * it senses. Links by temperature have slopes of their own (link_law.c), and where capacities go
 * with it column j is times dT_j over the change of its unknown (system_store.c). */
#include "thermal/solver/system_group.h"

#include <stdlib.h>
#include <string.h>

static int row_compare(const void *pa, const void *pb)
{
  int64_t a = *(const int64_t *)pa, b = *(const int64_t *)pb;
  return (a > b) - (a < b);
}

/* Rows of every column with duplicates; fills when `row` is not NULL. next[nunknown] counts. */
static void columns_scan(const struct um_thermal_system *system, size_t *next, int64_t *row)
{
  for (size_t k = 0; k < system->nunknown; k++) {
    size_t i = system->node[k];
    if (row != NULL) row[next[k]] = (int64_t)k;
    next[k]++;
    for (size_t e = system->start[i]; e < system->start[i + 1]; e++) {
      uint32_t u = system->unknown[system->other[e]];
      if (u == UM_THERMAL_NONE) continue;
      if (row != NULL) row[next[k]] = (int64_t)u; /* the pattern is symmetric */
      next[k]++;
    }
  }
  for (size_t c = 0; c < system->ncluster; c++) {
    const struct um_thermal_cluster *cluster = &system->cluster[c];
    for (size_t a = 0; a < cluster->p; a++)
      for (size_t b = 0; b < cluster->p; b++) {
        size_t k = cluster->neighbour[b];
        if (row != NULL) row[next[k]] = (int64_t)cluster->neighbour[a];
        next[k]++;
      }
  }
  for (size_t k = 0; k < system->nthermostat; k++) {
    const struct um_thermal_system_thermostat *own = &system->thermostat[k];
    const struct um_thermal_spread *at = &own->thermostat->at, *sensor = &own->thermostat->sensor;
    for (size_t j = 0; j < sensor->n && own->slot != NULL; j += own->every)
      for (size_t i = 0; i < at->n; i++) {
        size_t column = system->unknown[sensor->node[j]];
        if (row != NULL) row[next[column]] = (int64_t)system->unknown[at->node[i]];
        next[column]++;
      }
  }
}

size_t um_thermal_system_slot(const struct um_thermal_system *system, size_t row, size_t column)
{
  size_t low = (size_t)system->column[column], high = (size_t)system->column[column + 1];
  while (low + 1 < high) {
    size_t middle = (low + high) / 2;
    if ((size_t)system->row[middle] <= row)
      low = middle;
    else
      high = middle;
  }
  return low;
}

/* Where each link and each pair of cluster neighbours adds. */
static enum um_status slots_build(struct um_thermal_system *system)
{
  struct um_context *context = system->context;
  UM_TRY(um_core_allocate(context, system->start[system->n], sizeof(size_t), &system->link_slot));
  UM_TRY(um_core_allocate(context, system->nunknown, sizeof(size_t), &system->diagonal));
  for (size_t k = 0; k < system->nunknown; k++) {
    size_t i = system->node[k];
    system->diagonal[k] = um_thermal_system_slot(system, k, k);
    for (size_t e = system->start[i]; e < system->start[i + 1]; e++) {
      uint32_t u = system->unknown[system->other[e]];
      if (u != UM_THERMAL_NONE) system->link_slot[e] = um_thermal_system_slot(system, k, u);
    }
  }
  for (size_t c = 0; c < system->ncluster; c++) {
    struct um_thermal_cluster *cluster = &system->cluster[c];
    for (size_t b = 0; b < cluster->p; b++)
      for (size_t a = 0; a < cluster->p; a++)
        cluster->slot[b * cluster->p + a] =
            um_thermal_system_slot(system, cluster->neighbour[a], cluster->neighbour[b]);
  }
  for (size_t k = 0; k < system->nthermostat; k++) {
    const struct um_thermal_system_thermostat *own = &system->thermostat[k];
    const struct um_thermal_spread *at = &own->thermostat->at, *sensor = &own->thermostat->sensor;
    for (size_t j = 0; j < sensor->n && own->slot != NULL; j += own->every)
      for (size_t i = 0; i < at->n; i++)
        own->slot[j / own->every * at->n + i] = um_thermal_system_slot(
            system, system->unknown[at->node[i]], system->unknown[sensor->node[j]]);
  }
  return UM_OK;
}

enum um_status um_thermal_system_pattern_build(struct um_thermal_system *system)
{
  enum um_status status;
  struct um_context *context = system->context;
  size_t n = system->nunknown;
  size_t *first = NULL, *next = NULL;
  UM_CHECK(um_core_allocate(context, n + 1, sizeof(size_t), &first));
  UM_CHECK(um_core_allocate(context, n, sizeof(size_t), &next));
  UM_CHECK(um_core_allocate(context, n + 1, sizeof(int64_t), &system->column));
  columns_scan(system, next, NULL);
  for (size_t k = 0; k < n; k++) first[k + 1] = first[k] + next[k];
  UM_CHECK(um_core_allocate(context, first[n], sizeof(int64_t), &system->row));
  memcpy(next, first, n * sizeof *next);
  columns_scan(system, next, system->row);
  size_t at = 0;
  for (size_t k = 0; k < n; k++) {
    qsort(system->row + first[k], first[k + 1] - first[k], sizeof(int64_t), row_compare);
    /* keep each row once; reads stay ahead of writes */
    int64_t last = -1;
    for (size_t e = first[k]; e < first[k + 1]; e++) {
      int64_t r = system->row[e];
      if (r != last) system->row[at++] = r;
      last = r;
    }
    system->column[k + 1] = (int64_t)at;
  }
  system->nnonzero = at;
  UM_CHECK(slots_build(system));
done:
  UM_FREE(context, first, next);
  return status;
}

/* Heat that an unknown i loses or gains through the eliminated nodes it touches. */
static bool clusters_add(struct um_thermal_system *system, double *value)
{
  for (size_t c = 0; c < system->ncluster; c++) {
    struct um_thermal_cluster *cluster = &system->cluster[c];
    if (!um_thermal_system_cluster_linearize(system, cluster)) return false;
    for (size_t a = 0; a < cluster->m; a++) {
      uint32_t node = cluster->node[a];
      for (size_t e = system->start[node]; e < system->start[node + 1]; e++) {
        uint32_t i = system->other[e], u = system->unknown[i];
        if (u == UM_THERMAL_NONE) continue;
        double gain =
            um_thermal_system_link_in(system, e, i, node, system->cube) / system->capacity[i];
        size_t at = 0;
        while (cluster->neighbour[at] != u) at++;
        for (size_t b = 0; b < cluster->p; b++)
          value[cluster->slot[b * cluster->p + at]] += gain * cluster->response[a * cluster->p + b];
      }
    }
  }
  return true;
}

static void thermostats_add(const struct um_thermal_system *system, double *value)
{
  for (size_t k = 0; k < system->nthermostat; k++) {
    const struct um_thermal_system_thermostat *own = &system->thermostat[k];
    const struct um_thermal_spread *at = &own->thermostat->at, *sensor = &own->thermostat->sensor;
    for (size_t j = 0; j < sensor->n && own->slot != NULL; j += own->every)
      for (size_t i = 0; i < at->n; i++)
        value[own->slot[j / own->every * at->n + i]] += own->slope * own->share * at->weight[i] *
                                                        sensor->weight[j] /
                                                        system->capacity[at->node[i]];
  }
}

bool um_thermal_system_jacobian(struct um_thermal_system *system, double *value)
{
  const double *cube = system->cube;
  memset(value, 0, system->nnonzero * sizeof *value);
  for (size_t k = 0; k < system->nunknown; k++) {
    size_t i = system->node[k];
    double inverse = 1.0 / system->capacity[i];
    double loss = um_thermal_system_space_loss(system, i, cube);
    for (size_t e = system->start[i]; e < system->start[i + 1]; e++) {
      size_t j = system->other[e];
      loss += um_thermal_system_link_out(system, e, i, j, cube);
      if (system->unknown[j] != UM_THERMAL_NONE)
        value[system->link_slot[e]] += um_thermal_system_link_in(system, e, i, j, cube) * inverse;
    }
    value[system->diagonal[k]] -= loss * inverse;
  }
  thermostats_add(system, value);
  if (!clusters_add(system, value)) return false;
  for (size_t k = 0; k < system->nunknown && system->warming != NULL; k++)
    for (int64_t e = system->column[k]; e < system->column[k + 1]; e++)
      value[e] *= system->warming[system->node[k]];
  return true;
}
