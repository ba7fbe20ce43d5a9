/* Elimination of massless nodes. Connected groups of arithmetic nodes are solved by Newton on their
 * own balances g(T_a; T_d) = 0 with dense LU factors; the implicit function theorem gives
 *
 *   dT_a/dT_d = -(dg/dT_a)^-1 dg/dT_d,
 *
 * which the Jacobian of the unknowns needs. Groups are small (a skin node, a fitting); one of more
 * than 512 nodes is refused: give those nodes a capacity. */
#include "thermal/solver/system_group.h"

#include <math.h>
#include <string.h>

#define LARGEST_CLUSTER 512
#define NEWTON_LIMIT    100

static bool is_eliminated(const struct um_thermal_system *system, size_t node)
{
  return !system->fixed[node] && system->unknown[node] == UM_THERMAL_NONE;
}

/* Nodes of the group that holds `seed`, breadth first, into list; mark[node] = group + 1. */
static size_t group_collect(const struct um_thermal_system *system, uint32_t seed, uint32_t group,
                            uint32_t *mark, uint32_t *list)
{
  size_t count = 0;
  list[count++] = seed;
  mark[seed] = group + 1;
  for (size_t k = 0; k < count; k++)
    for (size_t e = system->start[list[k]]; e < system->start[list[k] + 1]; e++) {
      uint32_t j = system->other[e];
      if (!is_eliminated(system, j) || mark[j] != 0) continue;
      mark[j] = group + 1;
      list[count++] = j;
    }
  return count;
}

static enum um_status cluster_fill(struct um_thermal_system *system,
                                   struct um_thermal_cluster *cluster, const uint32_t *list,
                                   size_t m, uint32_t *seen, uint32_t stamp, uint32_t *touched)
{
  struct um_context *context = system->context;
  size_t p = 0;
  for (size_t a = 0; a < m; a++)
    for (size_t e = system->start[list[a]]; e < system->start[list[a] + 1]; e++) {
      uint32_t u = system->unknown[system->other[e]];
      if (u == UM_THERMAL_NONE || seen[u] == stamp) continue;
      seen[u] = stamp;
      touched[p++] = u;
    }
  cluster->m = m;
  cluster->p = p;
  UM_TRY(um_core_allocate(context, m, sizeof(uint32_t), &cluster->node));
  UM_TRY(um_core_allocate(context, p, sizeof(uint32_t), &cluster->neighbour));
  UM_TRY(um_core_allocate(context, m * m, sizeof(double), &cluster->matrix));
  UM_TRY(um_core_allocate(context, m * p, sizeof(double), &cluster->response));
  UM_TRY(um_core_allocate(context, m, sizeof(double), &cluster->balance));
  UM_TRY(um_core_allocate(context, m, sizeof(uint32_t), &cluster->pivot));
  UM_TRY(um_core_allocate(context, p * p, sizeof(size_t), &cluster->slot));
  memcpy(cluster->node, list, m * sizeof *list);
  memcpy(cluster->neighbour, touched, p * sizeof *touched);
  return UM_OK;
}

static enum um_status group_check(struct um_thermal_system *system, const uint32_t *list, size_t m)
{
  char label[96];
  um_thermal_network_label(system->network, list[0], label, sizeof label);
  if (m > LARGEST_CLUSTER)
    return um_core_fail(system->context, UM_ERR_INPUT,
                        "%s belongs to %zu connected arithmetic nodes; accepted: up to %d; give "
                        "them a capacity",
                        label, m, LARGEST_CLUSTER);
  bool held = false;
  for (size_t a = 0; a < m && !held; a++) {
    held = system->space[list[a]] > 0.0;
    for (size_t e = system->start[list[a]]; e < system->start[list[a] + 1] && !held; e++)
      held = !is_eliminated(system, system->other[e]) &&
             (system->linear[e] != 0.0 || system->fourth[e] != 0.0);
  }
  if (!held)
    return um_core_fail(system->context, UM_ERR_INPUT,
                        "%s is arithmetic and coupled to nothing that holds its temperature; "
                        "accepted: a conductor to a diffusive or boundary node or to space",
                        label);
  return UM_OK;
}

enum um_status um_thermal_system_clusters_build(struct um_thermal_system *system)
{
  enum um_status status = UM_OK;
  struct um_context *context = system->context;
  size_t n = system->n, eliminated = 0;
  for (size_t i = 0; i < n; i++) eliminated += is_eliminated(system, i);
  if (eliminated == 0) return UM_OK;
  uint32_t *mark = NULL, *list = NULL, *seen = NULL, *touched = NULL;
  UM_CHECK(um_core_allocate(context, n, sizeof(uint32_t), &mark));
  UM_CHECK(um_core_allocate(context, n, sizeof(uint32_t), &list));
  UM_CHECK(um_core_allocate(context, n, sizeof(uint32_t), &seen));
  UM_CHECK(um_core_allocate(context, n, sizeof(uint32_t), &touched));
  UM_CHECK(um_core_allocate(context, eliminated, sizeof *system->cluster, &system->cluster));
  for (uint32_t i = 0; i < n; i++) {
    if (!is_eliminated(system, i) || mark[i] != 0) continue;
    size_t m = group_collect(system, i, (uint32_t)system->ncluster, mark, list);
    UM_CHECK(group_check(system, list, m));
    struct um_thermal_cluster *cluster = &system->cluster[system->ncluster++];
    UM_CHECK(cluster_fill(system, cluster, list, m, seen, (uint32_t)system->ncluster, touched));
  }
done:
  UM_FREE(context, mark, list, seen, touched);
  return status;
}

void um_thermal_system_clusters_destroy(struct um_thermal_system *system)
{
  struct um_context *context = system->context;
  for (size_t k = 0; k < system->ncluster; k++) {
    struct um_thermal_cluster *c = &system->cluster[k];
    UM_FREE(context, c->node, c->neighbour, c->matrix, c->response, c->balance, c->pivot, c->slot);
  }
  um_core_free(context, system->cluster);
}

/* LU with partial pivoting in place, row-major; false when singular. */
static bool lu_factor(double *a, uint32_t *pivot, size_t m)
{
  for (size_t k = 0; k < m; k++) {
    size_t best = k;
    for (size_t i = k + 1; i < m; i++)
      if (fabs(a[i * m + k]) > fabs(a[best * m + k])) best = i;
    pivot[k] = (uint32_t)best;
    if (!(fabs(a[best * m + k]) > 0.0)) return false;
    for (size_t j = 0; j < m && best != k; j++) {
      double swap = a[k * m + j];
      a[k * m + j] = a[best * m + j];
      a[best * m + j] = swap;
    }
    for (size_t i = k + 1; i < m; i++) {
      double f = a[i * m + k] /= a[k * m + k];
      for (size_t j = k + 1; j < m; j++) a[i * m + j] -= f * a[k * m + j];
    }
  }
  return true;
}

/* Solve for one right-hand side, element i at x[i * stride]. */
static void lu_solve(const double *a, const uint32_t *pivot, size_t m, double *x, size_t stride)
{
  for (size_t k = 0; k < m; k++) {
    double swap = x[k * stride];
    x[k * stride] = x[pivot[k] * stride];
    x[pivot[k] * stride] = swap;
    for (size_t i = k + 1; i < m; i++) x[i * stride] -= a[i * m + k] * x[k * stride];
  }
  for (size_t k = m; k-- > 0;) {
    for (size_t j = k + 1; j < m; j++) x[k * stride] -= a[k * m + j] * x[j * stride];
    x[k * stride] /= a[k * m + k];
  }
}

/* Place of a node inside its cluster; clusters are short lists. */
static size_t place_of(const struct um_thermal_cluster *cluster, uint32_t node)
{
  for (size_t a = 0; a < cluster->m; a++)
    if (cluster->node[a] == node) return a;
  return cluster->m;
}

/* matrix = -dg/dT_a, which is positive definite without negative conductors. */
static void matrix_fill(const struct um_thermal_system *system, struct um_thermal_cluster *cluster)
{
  size_t m = cluster->m;
  memset(cluster->matrix, 0, m * m * sizeof *cluster->matrix);
  for (size_t a = 0; a < m; a++) {
    uint32_t i = cluster->node[a];
    double diagonal = um_thermal_system_space_loss(system, i, system->cube);
    for (size_t e = system->start[i]; e < system->start[i + 1]; e++) {
      uint32_t j = system->other[e];
      diagonal += um_thermal_system_link_out(system, e, i, j, system->cube);
      if (!is_eliminated(system, j)) continue;
      cluster->matrix[a * m + place_of(cluster, j)] -=
          um_thermal_system_link_in(system, e, i, j, system->cube);
    }
    cluster->matrix[a * m + a] += diagonal;
  }
}

static bool cluster_solve(struct um_thermal_system *system, struct um_thermal_cluster *cluster)
{
  size_t m = cluster->m;
  double *t = system->temperature;
  for (int iteration = 0; iteration < NEWTON_LIMIT; iteration++) {
    for (size_t a = 0; a < m; a++)
      cluster->balance[a] = um_thermal_system_node_heat(system, cluster->node[a]);
    matrix_fill(system, cluster);
    if (!lu_factor(cluster->matrix, cluster->pivot, m)) {
      /* at 0 K radiation has no slope: start from a warm guess */
      for (size_t a = 0; a < m; a++) t[cluster->node[a]] += 100.0;
      um_thermal_system_powers(system);
      continue;
    }
    lu_solve(cluster->matrix, cluster->pivot, m, cluster->balance, 1);
    bool done = true;
    for (size_t a = 0; a < m; a++) {
      uint32_t i = cluster->node[a];
      double limit = fabs(t[i]) + 10.0; /* [K] the first steps from a cold guess overshoot */
      double step = fmax(-limit, fmin(limit, cluster->balance[a]));
      if (!(fabs(step) <= 1e-11 * fabs(t[i]) + 1e-12)) done = false;
      t[i] += step;
      um_thermal_system_node_powers(system, i);
    }
    if (done) return true;
  }
  return false;
}

bool um_thermal_system_clusters_solve(struct um_thermal_system *system)
{
  for (size_t k = 0; k < system->ncluster; k++)
    if (!cluster_solve(system, &system->cluster[k])) return false;
  return true;
}

bool um_thermal_system_cluster_linearize(struct um_thermal_system *system,
                                         struct um_thermal_cluster *cluster)
{
  size_t m = cluster->m, p = cluster->p;
  matrix_fill(system, cluster);
  if (!lu_factor(cluster->matrix, cluster->pivot, m)) return false;
  memset(cluster->response, 0, m * p * sizeof *cluster->response);
  for (size_t a = 0; a < m; a++)
    for (size_t e = system->start[cluster->node[a]]; e < system->start[cluster->node[a] + 1]; e++) {
      uint32_t j = system->other[e], u = system->unknown[j];
      if (u == UM_THERMAL_NONE) continue;
      size_t b = 0;
      while (cluster->neighbour[b] != u) b++;
      cluster->response[a * p + b] +=
          um_thermal_system_link_in(system, e, cluster->node[a], j, system->cube);
    }
  for (size_t b = 0; b < p; b++)
    lu_solve(cluster->matrix, cluster->pivot, m, cluster->response + b, p);
  return true;
}

void um_thermal_system_cluster_answer(const struct um_thermal_cluster *cluster, double *x)
{
  lu_solve(cluster->matrix, cluster->pivot, cluster->m, x, 1);
}

void um_thermal_system_cluster_pass(const struct um_thermal_system *system,
                                    const struct um_thermal_cluster *cluster, double factor,
                                    const double *change, double *out)
{
  for (size_t a = 0; a < cluster->m; a++) {
    uint32_t node = cluster->node[a];
    for (size_t e = system->start[node]; e < system->start[node + 1]; e++) {
      uint32_t i = system->other[e], u = system->unknown[i];
      if (u == UM_THERMAL_NONE) continue;
      out[u] += factor * um_thermal_system_link_in(system, e, i, node, system->cube) * change[a] /
                system->capacity[i];
    }
  }
}
