/* Loads on nodes at an instant. Every tabulated quantity is linear between grid times:
 *
 *   Q_i(t) = S(t) nu(t) sum_s w_is A_s (alpha_s - x_s) sun_s(t)
 *            + sum_s w_is A_s (alpha_s albedo_s(t) + eps_s planet_s(t))
 *
 * S irradiance, nu sunlit fraction, x extraction. The sums over surfaces are linear in the table,
 * so they are made once per grid row and interpolated as sums. */
#include "thermal/system_impl.h"

#include <math.h>
#include <string.h>

static enum um_status column_check(struct um_context *context, const char *what, const double *t,
                                   const double *x, size_t count)
{
  for (size_t k = 0; k < count; k++)
    if (!isfinite(x[k]))
      return um_core_fail(context, UM_ERR_INPUT,
                          "heat load: %s at row %zu (t = %.6f s) is %g; accepted: finite", what, k,
                          t[k], x[k]);
  return UM_OK;
}

static enum um_status table_check(struct um_context *context, const char *what,
                                  const struct um_irradiation_loads *loads, const float *x)
{
  for (size_t k = 0; k < loads->ntime; k++)
    for (size_t s = 0; s < loads->nsurface; s++)
      if (!isfinite(x[k * loads->nsurface + s]))
        return um_core_fail(context, UM_ERR_INPUT,
                            "heat load: %s on surface %zu at row %zu (t = %.6f s) is %g; "
                            "accepted: finite",
                            what, s, k, loads->t[k], (double)x[k * loads->nsurface + s]);
  return UM_OK;
}

enum um_status um_thermal_system_loads_check(struct um_context *context,
                                             const struct um_thermal_network *network,
                                             const struct um_irradiation_loads *loads)
{
  if (loads->nsurface < network->nsurface)
    return um_core_fail(context, UM_ERR_INPUT,
                        "heat loads of %zu surfaces for a network with %zu; accepted: as many",
                        loads->nsurface, network->nsurface);
  if (loads->ntime == 0)
    return um_core_fail(context, UM_ERR_INPUT, "heat loads without times; accepted: 1 or more");
  UM_TRY(column_check(context, "time", loads->t, loads->t, loads->ntime));
  for (size_t k = 1; k < loads->ntime; k++)
    if (!(loads->t[k] >= loads->t[k - 1]))
      return um_core_fail(context, UM_ERR_INPUT,
                          "heat loads: time %.6f s at row %zu is before the row above; accepted: "
                          "ascending",
                          loads->t[k], k);
  UM_TRY(column_check(context, "sunlit fraction", loads->t, loads->sunlit, loads->ntime));
  UM_TRY(column_check(context, "solar irradiance", loads->t, loads->irradiance, loads->ntime));
  UM_TRY(column_check(context, "edge", loads->edge, loads->edge, loads->nedge));
  UM_TRY(table_check(context, "sun", loads, loads->sun));
  UM_TRY(table_check(context, "albedo", loads, loads->albedo));
  UM_TRY(table_check(context, "planet", loads, loads->planet));
  return UM_OK;
}

/* Surfaces in rows per node. */
static enum um_status shares_build(struct um_thermal_system *system)
{
  struct um_context *context = system->context;
  const struct um_thermal_network *network = system->network;
  size_t n = system->n;
  UM_TRY(um_core_allocate(context, n + 1, sizeof(size_t), &system->share_start));
  for (size_t s = 0; s < network->nsurface; s++)
    for (int k = 0; k < 3 && network->attached[s]; k++)
      if (network->surface[s].node[k] != UM_THERMAL_SPACE)
        system->share_start[network->surface[s].node[k] + 1]++;
  for (size_t i = 0; i < n; i++) system->share_start[i + 1] += system->share_start[i];
  size_t count = system->share_start[n];
  UM_TRY(um_core_allocate(context, count, sizeof(uint32_t), &system->share));
  UM_TRY(um_core_allocate(context, count, sizeof(double), &system->share_weight));
  for (size_t s = 0; s < network->nsurface; s++)
    for (int k = 0; k < 3 && network->attached[s]; k++) {
      uint32_t node = network->surface[s].node[k];
      if (node == UM_THERMAL_SPACE) continue;
      size_t at = system->share_start[node]++;
      system->share[at] = (uint32_t)s;
      system->share_weight[at] = network->surface[s].weight[k] * network->surface[s].area;
    }
  /* filling moved every start to its end: shift back */
  for (size_t i = n; i > 0; i--) system->share_start[i] = system->share_start[i - 1];
  system->share_start[0] = 0;
  return UM_OK;
}

enum um_status um_thermal_system_loads_build(struct um_thermal_system *system)
{
  struct um_context *context = system->context;
  UM_TRY(um_core_allocate(context, system->n, sizeof(double), &system->now.q));
  system->now.t = NAN;
  if (system->loads == NULL) return UM_OK;
  UM_TRY(shares_build(system));
  UM_TRY(um_core_allocate(context, system->loads->ntime, sizeof(double), &system->grid));
  for (size_t k = 0; k < system->loads->ntime; k++)
    system->grid[k] = system->loads->t[k] - system->from;
  for (int k = 0; k < 2; k++) {
    UM_TRY(um_core_allocate(context, system->n, sizeof(double), &system->load_row[k].sun));
    UM_TRY(um_core_allocate(context, system->n, sizeof(double), &system->load_row[k].earth));
    system->load_row[k].row = (size_t)-1;
  }
  system->row_high = system->loads->ntime - 1;
  return UM_OK;
}

/* Sums over surfaces of one grid row; neighbouring rows live in the two places by parity. */
static const struct um_thermal_load_row *row_sum(struct um_thermal_system *system, size_t row)
{
  struct um_thermal_load_row *r = &system->load_row[row % 2];
  if (r->row == row) return r;
  const struct um_irradiation_loads *loads = system->loads;
  const struct um_thermal_surface *surface = system->network->surface;
  const float *sun = loads->sun + row * loads->nsurface;
  const float *albedo = loads->albedo + row * loads->nsurface;
  const float *planet = loads->planet + row * loads->nsurface;
  double albedo_on = system->options.albedo_on ? 1.0 : 0.0;
  double planet_on = system->options.planet_on ? 1.0 : 0.0;
  r->sun_total = r->albedo_total = r->planet_total = 0.0;
  for (size_t i = 0; i < system->n; i++) {
    double sun_sum = 0.0, albedo_sum = 0.0, planet_sum = 0.0;
    for (size_t e = system->share_start[i]; e < system->share_start[i + 1]; e++) {
      size_t s = system->share[e];
      double a = system->share_weight[e];
      sun_sum += a * (surface[s].absorptance - surface[s].extraction) * (double)sun[s];
      albedo_sum += a * surface[s].absorptance * (double)albedo[s];
      planet_sum += a * surface[s].emittance * (double)planet[s];
    }
    albedo_sum *= albedo_on;
    planet_sum *= planet_on;
    r->sun[i] = sun_sum;
    r->earth[i] = albedo_sum + planet_sum;
    if (system->fixed[i]) continue;
    r->sun_total += sun_sum;
    r->albedo_total += albedo_sum;
    r->planet_total += planet_sum;
  }
  r->row = row;
  return r;
}

void um_thermal_system_window(struct um_thermal_system *system, double begin, double end)
{
  system->now.t = NAN;
  um_thermal_system_heat_window(system, begin, end);
  if (system->loads == NULL) return;
  size_t last = system->loads->ntime - 1;
  size_t low = 0;
  while (low < last && system->grid[low + 1] <= begin) low++;
  size_t high = low;
  while (high < last && system->grid[high] < end) high++;
  system->row_low = low;
  system->row_high = high;
  system->interval = low;
}

void um_thermal_system_hold(struct um_thermal_system *system, size_t row)
{
  system->now.t = NAN;
  um_thermal_system_heat_window(system, 0.0, 0.0);
  system->row_low = system->row_high = system->interval = row;
}

void um_thermal_system_loads_at(struct um_thermal_system *system, double t)
{
  struct um_thermal_load_now *now = &system->now;
  if (now->t == t) return;
  now->t = t;
  if (system->loads == NULL) return; /* q stays zero */
  const double *grid = system->grid;
  size_t k = system->interval;
  while (k > system->row_low && t < grid[k]) k--;
  while (k + 1 < system->row_high && t >= grid[k + 1]) k++;
  system->interval = k;
  size_t next = k < system->row_high ? k + 1 : k;
  double width = grid[next] - grid[k];
  double u = width > 0.0 ? (t - grid[k]) / width : 0.0;
  u = u < 0.0 ? 0.0 : u > 1.0 ? 1.0 : u;
  const struct um_thermal_load_row *a = row_sum(system, k), *b = row_sum(system, next);
  const struct um_irradiation_loads *loads = system->loads;
  double irradiance = (1.0 - u) * loads->irradiance[k] + u * loads->irradiance[next];
  double sunlit = (1.0 - u) * loads->sunlit[k] + u * loads->sunlit[next];
  double sa = irradiance * sunlit * (1.0 - u), sb = irradiance * sunlit * u;
  for (size_t i = 0; i < system->n; i++)
    now->q[i] = sa * a->sun[i] + sb * b->sun[i] + (1.0 - u) * a->earth[i] + u * b->earth[i];
  now->solar = sa * a->sun_total + sb * b->sun_total;
  now->albedo = (1.0 - u) * a->albedo_total + u * b->albedo_total;
  now->planet = (1.0 - u) * a->planet_total + u * b->planet_total;
}
