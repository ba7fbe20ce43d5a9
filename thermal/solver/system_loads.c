/* Loads on nodes at an instant. Every tabulated quantity is linear between grid times:
 *
 *   Q_i(t) = S(t) nu(t) sun_i(t) + albedo_i(t) + planet_i(t)
 *
 * and what the atmosphere brings, with planet_i. S irradiance, nu sunlit fraction, the sums over
 * surfaces those of load_row_impl.h. They are linear in the table, so they are made once per grid
 * row and interpolated as sums. Where surfaces age, so is what they emit to space. */
#include "thermal/solver/system_group.h"

#include <math.h>
#include <string.h>

#include "thermal/solver/load_sums_impl.h"

#define ROUNDING 1e-12 /* of absorptances and emittances that reached 0 or 1 */

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

/* What a surface absorbs and emits stays between nothing and everything. */
static enum um_status aging_check(struct um_context *context,
                                  const struct um_thermal_network *network,
                                  const struct um_irradiation_loads *loads,
                                  const struct um_thermal_aging *aging)
{
  if (aging == NULL) return UM_OK;
  if (aging->ntime != loads->ntime)
    return um_core_fail(context, UM_ERR_INPUT,
                        "surfaces that age at %zu times with heat loads of %zu; accepted: as many",
                        aging->ntime, loads->ntime);
  for (size_t k = 0; k < aging->ntime; k++)
    for (size_t s = 0; s < network->noutside; s++) {
      size_t at = k * aging->nmaterial + aging->material[s];
      double absorptance = network->surface[s].absorptance + aging->absorptance[at];
      double emittance = network->surface[s].emittance * aging->emittance[at];
      if (!network->attached[s] || (absorptance >= -ROUNDING && absorptance <= 1.0 + ROUNDING &&
                                    emittance >= -ROUNDING && emittance <= 1.0 + ROUNDING))
        continue;
      return um_core_fail(context, UM_ERR_INPUT,
                          "surface %zu at t = %.6f s has aged to an absorptance of %g and an "
                          "emittance of %g; accepted: 0 to 1",
                          s, loads->t[k], absorptance, emittance);
    }
  return UM_OK;
}

enum um_status um_thermal_system_loads_check(struct um_context *context,
                                             const struct um_thermal_network *network,
                                             const struct um_irradiation_loads *loads,
                                             const struct um_thermal_aging *aging)
{
  if (loads->nsurface < network->noutside)
    return um_core_fail(context, UM_ERR_INPUT,
                        "heat loads of %zu surfaces for a network with %zu; accepted: as many",
                        loads->nsurface, network->noutside);
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
  if (loads->gas != NULL) UM_TRY(table_check(context, "gas", loads, loads->gas));
  return aging_check(context, network, loads, aging);
}

enum um_status um_thermal_system_loads_build(struct um_thermal_system *system)
{
  struct um_context *context = system->context;
  UM_TRY(um_core_allocate(context, system->n, sizeof(double), &system->now.q));
  system->now.t = NAN;
  if (system->loads == NULL) return UM_OK;
  UM_TRY(um_thermal_load_near_make(context, system->options.sums, system->network, system->loads,
                                   system->options.aging, system->options.exchange, &system->near));
  UM_TRY(um_core_allocate(context, system->n, sizeof(double), &system->planet));
  if (system->loads->gas != NULL)
    UM_TRY(um_core_allocate(context, system->n, sizeof(double), &system->gas));
  UM_TRY(um_core_allocate(context, system->loads->ntime, sizeof(double), &system->grid));
  for (size_t k = 0; k < system->loads->ntime; k++)
    system->grid[k] = system->loads->t[k] - system->from;
  for (int k = 0; k < 2; k++) {
    UM_TRY(um_core_allocate(context, system->n, sizeof(double), &system->load_row[k].sun));
    UM_TRY(um_core_allocate(context, system->n, sizeof(double), &system->load_row[k].earth));
    if (system->options.aging != NULL)
      UM_TRY(um_core_allocate(context, system->n + system->nemission, sizeof(double),
                              &system->load_row[k].space));
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
  double albedo_on = system->options.albedo_on ? 1.0 : 0.0;
  double planet_on = system->options.planet_on ? 1.0 : 0.0;
  if (system->near != NULL)
    um_thermal_load_near_row(system->near, system->network, system->options.exchange, row, r->sun,
                             r->earth, system->planet);
  else
    um_thermal_load_row_sum(system->network, system->loads, system->options.aging,
                            system->options.exchange, row, r->sun, r->earth, system->planet,
                            system->gas);
  r->sun_total = r->albedo_total = r->planet_total = 0.0;
  for (size_t i = 0; i < system->n; i++) {
    double albedo = albedo_on * r->earth[i], planet = planet_on * system->planet[i];
    if (system->gas != NULL) planet += system->gas[i];
    r->earth[i] = albedo + planet;
    if (system->fixed[i]) continue;
    r->sun_total += r->sun[i];
    r->albedo_total += albedo;
    r->planet_total += planet;
  }
  if (r->space != NULL) um_thermal_system_emission_row(system, row, r->space);
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
  if (u == 0.0) next = k; /* nothing of the next row is asked */
  const struct um_thermal_load_row *a = row_sum(system, k), *b = row_sum(system, next);
  const struct um_irradiation_loads *loads = system->loads;
  double irradiance = (1.0 - u) * loads->irradiance[k] + u * loads->irradiance[next];
  double sunlit = (1.0 - u) * loads->sunlit[k] + u * loads->sunlit[next];
  double sa = irradiance * sunlit * (1.0 - u), sb = irradiance * sunlit * u;
  for (size_t i = 0; i < system->n; i++)
    now->q[i] = sa * a->sun[i] + sb * b->sun[i] + (1.0 - u) * a->earth[i] + u * b->earth[i];
  for (size_t i = 0; a->space != NULL && i < system->n + system->nemission; i++)
    system->emission_held[i] = (1.0 - u) * a->space[i] + u * b->space[i];
  now->solar = sa * a->sun_total + sb * b->sun_total;
  now->albedo = (1.0 - u) * a->albedo_total + u * b->albedo_total;
  now->planet = (1.0 - u) * a->planet_total + u * b->planet_total;
}
