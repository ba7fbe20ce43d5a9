/* The base of sensitivities: states and slopes at the ends of CVODES's internal steps, cubic
 * between them,
 *
 *   T(t) = h00 T_0 + h10 h T'_0 + h01 T_1 + h11 h T'_1   (Hermite),
 *
 * whose error h^4/384 T'''' is that of one step of order 3: far below what sensitivities want of
 * steps that meet 2e-7. Only what the present step needs is kept. */
#include <string.h>

#include "base/core/interpolation.h"
#include "thermal/tangent/sensitivity_impl.h"

#define POINTS 64 /* kept at first */

enum um_status um_thermal_base_create(struct um_context *context,
                                      const struct um_thermal_network *network,
                                      const struct um_irradiation_loads *loads,
                                      const struct um_thermal_solve_options *options,
                                      const double *start, double from,
                                      enum um_thermal_system_kind kind, double duration,
                                      struct um_thermal_base *base)
{
  UM_TRY(
      um_thermal_system_create(context, network, loads, options, start, from, kind, &base->system));
  UM_TRY(um_thermal_integrator_create(base->system, duration, &base->integrator));
  size_t n = base->system->nunknown;
  UM_TRY(um_core_allocate(context, n, sizeof(double), &base->last.y));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &base->last.slope));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &base->last.slope_before));
  return um_core_allocate(context, base->system->nthermostat, sizeof(bool), &base->heating);
}

void um_thermal_base_release(struct um_thermal_base *base)
{
  if (base->system == NULL) return;
  struct um_context *context = base->system->context;
  um_core_free(context, base->last.y);
  um_core_free(context, base->last.slope);
  um_core_free(context, base->last.slope_before);
  um_core_free(context, base->heating);
  um_core_free(context, base->t);
  um_core_free(context, base->y);
  um_core_free(context, base->slope);
  um_thermal_integrator_destroy(&base->integrator);
  um_thermal_system_destroy(&base->system);
}

static enum um_status point_add(struct um_thermal_base *base, double t, const double *y,
                                const double *slope)
{
  struct um_context *context = base->system->context;
  size_t n = base->system->nunknown;
  if (base->npoint == base->room) {
    size_t room = base->room == 0 ? POINTS : 2 * base->room;
    UM_TRY(um_core_reallocate(context, room, sizeof(double), &base->t));
    UM_TRY(um_core_reallocate(context, room, n * sizeof(double), &base->y));
    UM_TRY(um_core_reallocate(context, room, n * sizeof(double), &base->slope));
    base->room = room;
  }
  base->t[base->npoint] = t;
  memcpy(base->y + base->npoint * n, y, n * sizeof *y);
  memcpy(base->slope + base->npoint * n, slope, n * sizeof *slope);
  base->npoint++;
  return UM_OK;
}

/* The first step of a stretch from state y; y may be last.y. */
static enum um_status stretch_begin(struct um_thermal_base *base, const double *y)
{
  const struct um_thermal_system *system = base->system;
  size_t n = system->nunknown;
  base->npoint = 0;
  /* its slope is known after the first step */
  UM_TRY(point_add(base, 0.0, y, y));
  UM_TRY(um_thermal_integrator_advance(base->integrator, &base->last));
  base->t[0] = base->last.before;
  memcpy(base->slope, base->last.slope_before, n * sizeof(double));
  memcpy(base->heating, base->last.heating, system->nthermostat * sizeof(bool));
  base->ended = base->last.ends;
  return point_add(base, base->last.t, base->last.y, base->last.slope);
}

enum um_status um_thermal_base_start(struct um_thermal_base *base, const double *temperature)
{
  const struct um_thermal_system *system = base->system;
  UM_TRY(um_thermal_integrator_start(base->integrator, temperature, NULL));
  /* a thermostat's phase moves the start */
  const double *begins = system->nthermostat > 0 ? system->temperature : temperature;
  for (size_t k = 0; k < system->nunknown; k++)
    base->last.y[k] =
        um_thermal_system_unknown_of(system, system->node[k], begins[system->node[k]]);
  return stretch_begin(base, base->last.y);
}

enum um_status um_thermal_base_next(struct um_thermal_base *base)
{
  return stretch_begin(base, base->last.y);
}

enum um_status um_thermal_base_reach(struct um_thermal_base *base, double t)
{
  while (!base->ended && base->t[base->npoint - 1] < t) {
    UM_TRY(um_thermal_integrator_advance(base->integrator, &base->last));
    base->ended = base->last.ends;
    UM_TRY(point_add(base, base->last.t, base->last.y, base->last.slope));
  }
  return UM_OK;
}

/* The point at or before t that is not the last. */
static size_t point_find(const struct um_thermal_base *base, double t)
{
  return um_core_interval_find(base->t, base->npoint, t);
}

void um_thermal_base_drop(struct um_thermal_base *base, double t)
{
  size_t n = base->system->nunknown, first = point_find(base, t), left = base->npoint - first;
  if (first < base->npoint / 2) return; /* moving costs */
  memmove(base->t, base->t + first, left * sizeof(double));
  memmove(base->y, base->y + first * n, left * n * sizeof(double));
  memmove(base->slope, base->slope + first * n, left * n * sizeof(double));
  base->npoint = left;
}

void um_thermal_base_at(const struct um_thermal_base *base, double t, double *y)
{
  size_t n = base->system->nunknown, k = point_find(base, t);
  const double *y0 = base->y + k * n, *y1 = y0 + n;
  const double *d0 = base->slope + k * n, *d1 = d0 + n;
  double h = base->t[k + 1] - base->t[k], u = h > 0.0 ? (t - base->t[k]) / h : 0.0;
  double w1 = u * u * (3.0 - 2.0 * u), w0 = 1.0 - w1;
  double v0 = h * u * (1.0 - u) * (1.0 - u), v1 = -h * u * u * (1.0 - u);
  for (size_t i = 0; i < n; i++) y[i] = w0 * y0[i] + w1 * y1[i] + v0 * d0[i] + v1 * d1[i];
}

double um_thermal_base_step(const struct um_thermal_base *base)
{
  return base->last.t - base->last.before;
}
