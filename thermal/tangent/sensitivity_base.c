/* The base of sensitivities: states and slopes at the ends of CVODES's internal steps, cubic
 * between them,
 *
 *   T(t) = h00 T_0 + h10 h T'_0 + h01 T_1 + h11 h T'_1   (Hermite),
 *
 * whose error h^4/384 T'''' is that of one step of order 3: far below what sensitivities want of
 * steps that meet 2e-7. Only what the present step needs is kept, but in the orbit of a periodic
 * state, which is gone round until its answer closes: points and stretches of the first time serve
 * the others. */
#include <string.h>

#include "base/core/interpolation.h"
#include "thermal/tangent/sensitivity_impl.h"

#define POINTS 64                 /* kept at first */
#define MOST   ((size_t)32 << 20) /* bytes that are kept of a whole way */

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

static void stretches_drop(struct um_thermal_base *base)
{
  struct um_context *context = base->system->context;
  for (size_t k = 0; k < base->nstretch; k++) um_core_free(context, base->stretch[k].heating);
  um_core_free(context, base->stretch);
  base->stretch = NULL;
  base->nstretch = 0;
}

void um_thermal_base_release(struct um_thermal_base *base)
{
  if (base->system == NULL) return;
  struct um_context *context = base->system->context;
  stretches_drop(base);
  um_core_free(context, base->last.y);
  um_core_free(context, base->last.slope);
  um_core_free(context, base->last.slope_before);
  um_core_free(context, base->heating);
  UM_FREE(context, base->store_t, base->store_y, base->store_slope);
  um_thermal_integrator_destroy(&base->integrator);
  um_thermal_system_destroy(&base->system);
}

/* --- points ----------------------------------------------------------------------------------- */

static void stretch_show(struct um_thermal_base *base, size_t first)
{
  size_t n = base->system->nunknown;
  base->first = first;
  base->t = base->store_t + first;
  base->y = base->store_y + first * n;
  base->slope = base->store_slope + first * n;
}

static enum um_status point_add(struct um_thermal_base *base, double t, const double *y,
                                const double *slope)
{
  struct um_context *context = base->system->context;
  size_t n = base->system->nunknown, at = base->first + base->npoint;
  if (at == base->room) {
    size_t room = base->room == 0 ? POINTS : 2 * base->room;
    UM_TRY(um_core_reallocate(context, room, sizeof(double), &base->store_t));
    UM_TRY(um_core_reallocate(context, room, n * sizeof(double), &base->store_y));
    UM_TRY(um_core_reallocate(context, room, n * sizeof(double), &base->store_slope));
    base->room = room;
    stretch_show(base, base->first);
  }
  base->store_t[at] = t;
  memcpy(base->store_y + at * n, y, n * sizeof *y);
  memcpy(base->store_slope + at * n, slope, n * sizeof *slope);
  base->npoint++;
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
  if (base->kept || first < base->npoint / 2) return; /* moving costs */
  memmove(base->store_t, base->t + first, left * sizeof(double));
  memmove(base->store_y, base->y + first * n, left * n * sizeof(double));
  memmove(base->store_slope, base->slope + first * n, left * n * sizeof(double));
  base->npoint = left;
}

/* --- a way that is kept ----------------------------------------------------------------------- */

void um_thermal_base_keep(struct um_thermal_base *base) { base->kept = true; }

/* The present stretch has ended: it is kept, if there is room. */
static enum um_status stretch_keep(struct um_thermal_base *base)
{
  struct um_context *context = base->system->context;
  size_t m = base->system->nthermostat, n = base->nstretch;
  if ((base->first + base->npoint) * (1 + 2 * base->system->nunknown) * sizeof(double) > MOST) {
    base->kept = false;
    stretches_drop(base);
    return UM_OK;
  }
  UM_TRY(um_core_reallocate(context, n + 1, sizeof *base->stretch, &base->stretch));
  base->stretch[n] = (struct um_thermal_base_stretch){
      .first = base->first, .count = base->npoint, .stop = base->stop};
  base->nstretch++;
  UM_TRY(um_core_allocate(context, m, sizeof(bool), &base->stretch[n].heating));
  memcpy(base->stretch[n].heating, base->heating, m * sizeof(bool));
  return UM_OK;
}

/* The first two points of a stretch that is kept. */
static void stretch_again(struct um_thermal_base *base, size_t k)
{
  const struct um_thermal_base_stretch *stretch = &base->stretch[k];
  base->now = k;
  stretch_show(base, stretch->first);
  base->npoint = 2;
  base->ended = stretch->count == 2;
  base->stop = stretch->stop;
  memcpy(base->heating, stretch->heating, base->system->nthermostat * sizeof(bool));
}

/* --- stretches -------------------------------------------------------------------------------- */

/* The next step, and its end as a point. */
static enum um_status advance(struct um_thermal_base *base)
{
  UM_TRY(um_thermal_integrator_advance(base->integrator, &base->last));
  base->ended = base->last.ends;
  return UM_OK;
}

/* The first step of a stretch from state y, behind those that are kept; y may be last.y. */
static enum um_status stretch_begin(struct um_thermal_base *base, const double *y)
{
  const struct um_thermal_system *system = base->system;
  size_t n = system->nunknown;
  stretch_show(base, base->kept ? base->first + base->npoint : 0);
  base->npoint = 0;
  /* its slope is known after the first step */
  UM_TRY(point_add(base, 0.0, y, y));
  UM_TRY(advance(base));
  base->store_t[base->first] = base->last.before;
  memcpy(base->store_slope + base->first * n, base->last.slope_before, n * sizeof(double));
  memcpy(base->heating, base->last.heating, system->nthermostat * sizeof(bool));
  base->stop = um_thermal_integrator_stop(base->integrator);
  UM_TRY(point_add(base, base->last.t, base->last.y, base->last.slope));
  return base->kept && base->ended ? stretch_keep(base) : UM_OK;
}

enum um_status um_thermal_base_start(struct um_thermal_base *base, const double *temperature)
{
  const struct um_thermal_system *system = base->system;
  base->again = base->kept && base->nstretch > 0 && base->ended;
  if (base->again) {
    stretch_again(base, 0);
    return UM_OK;
  }
  stretches_drop(base);
  base->first = base->npoint = 0;
  UM_TRY(um_thermal_integrator_start(base->integrator, temperature, NULL));
  for (size_t k = 0; k < system->nunknown; k++)
    base->last.y[k] =
        um_thermal_system_unknown_of(system, system->node[k], temperature[system->node[k]]);
  return stretch_begin(base, base->last.y);
}

enum um_status um_thermal_base_next(struct um_thermal_base *base)
{
  if (!base->again) return stretch_begin(base, base->last.y);
  stretch_again(base, base->now + 1);
  return UM_OK;
}

enum um_status um_thermal_base_reach(struct um_thermal_base *base, double t)
{
  while (!base->ended && base->t[base->npoint - 1] < t) {
    if (base->again) {
      base->npoint++;
      base->ended = base->npoint == base->stretch[base->now].count;
      continue;
    }
    UM_TRY(advance(base));
    UM_TRY(point_add(base, base->last.t, base->last.y, base->last.slope));
    if (base->kept && base->ended) UM_TRY(stretch_keep(base));
  }
  return UM_OK;
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
  return base->t[base->npoint - 1] - base->t[base->npoint - 2];
}
