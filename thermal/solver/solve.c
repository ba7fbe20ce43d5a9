/* A run of the network over its loads: temperatures at given times and the audit of energy
 *
 *   in - out - stored = 0,   stored = sum_i C_i (T_i(end) - T_i(start)),
 *
 * where in and out are integrals over the satellite's border made along the way. */
#include "thermal/solver/solve.h"

#include <math.h>

#include "base/core/constants.h"
#include "thermal/solver/integrator_group.h"

#define CLOSED 1e-6 /* of its content: the least turnover, of a satellite that is closed */
/* The audit's limit: a tenth of the 1e-3 to which LWIR is stated, 7 mK of a body in balance; or 10
 * mK of all that is warm, since a run of minutes turns over little beside what Newton's iteration
 * leaves at every step. Orbits come to 1e-6 and less. Both at the tolerances of 0.1 K
 * (tolerances.c), or tighter ones. */
#define AUDIT_TURNOVER 1e-4
#define AUDIT_CONTENT  (0.01 / 300.0)
#define AUDIT_RELATIVE 1e-5
#define AUDIT_ABSOLUTE 1e-3 /* [K] */

void um_thermal_solve_defaults(struct um_thermal_solve_options *options)
{
  *options = (struct um_thermal_solve_options){.relative_tolerance = 2e-7,
                                               .absolute_tolerance = 2e-5,
                                               .space_temperature = UM_SPACE_TEMPERATURE,
                                               .albedo_on = true,
                                               .planet_on = true,
                                               .tolerance_factor = 1.0};
}

static enum um_status times_check(struct um_context *context,
                                  const struct um_irradiation_loads *loads, double from,
                                  const double *times, size_t ntime)
{
  if (ntime == 0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "no times wanted of the heat run; accepted: 1 or more");
  if (!isfinite(from))
    return um_core_fail(context, UM_ERR_INPUT, "heat run from %g s; accepted: finite", from);
  for (size_t k = 0; k < ntime; k++)
    if (!(times[k] >= (k == 0 ? from : times[k - 1])) || !isfinite(times[k]))
      return um_core_fail(context, UM_ERR_INPUT,
                          "heat run: time %zu is %.6f s; accepted: finite, ascending, not before "
                          "the start at %.6f s",
                          k, times[k], from);
  if (loads != NULL && loads->ntime > 0 &&
      !(loads->t[0] <= from && times[ntime - 1] <= loads->t[loads->ntime - 1]))
    return um_core_fail(context, UM_ERR_INPUT,
                        "heat run from %.6f to %.6f s; accepted: inside its loads, %.6f to %.6f s",
                        from, times[ntime - 1], loads->t[0], loads->t[loads->ntime - 1]);
  return UM_OK;
}

static enum um_status history_create(struct um_context *context, size_t ntime, size_t nnode,
                                     size_t nthermostat, struct um_thermal_history **out)
{
  UM_TRY(um_core_allocate(context, 1, sizeof **out, out));
  (*out)->ntime = ntime;
  (*out)->nnode = nnode;
  (*out)->nthermostat = nthermostat;
  UM_TRY(um_core_allocate(context, ntime, sizeof(double), &(*out)->t));
  if (nthermostat > 0)
    UM_TRY(um_core_allocate(context, ntime * nthermostat, sizeof(bool), &(*out)->heating));
  if (nnode != 0 && ntime > (size_t)-1 / sizeof(double) / 2 / nnode)
    return um_core_fail(context, UM_ERR_MEMORY, "out of memory: %zu nodes at %zu times", nnode,
                        ntime);
  return um_core_allocate(context, ntime * nnode, sizeof(double), &(*out)->temperature);
}

void um_thermal_history_destroy(struct um_context *context, struct um_thermal_history **history)
{
  if (history == NULL || *history == NULL) return;
  UM_FREE(context, (*history)->t, (*history)->temperature, (*history)->heating, *history);
  *history = NULL;
}

/* Heat that goes over the border either way [J]. */
static double turnover(const struct um_thermal_heat *h, double content)
{
  double gross = fabs(h->solar) + fabs(h->albedo) + fabs(h->planet) + fabs(h->internal) +
                 fabs(h->radiated) + fabs(h->conducted) + fabs(h->exchanged);
  return fmax(gross, CLOSED * content);
}

static double error_of(const struct um_thermal_heat *h, double content)
{
  double net =
      h->solar + h->albedo + h->planet + h->internal + h->radiated + h->conducted + h->exchanged;
  double gross = turnover(h, content);
  return gross > 0.0 ? fabs(net - h->stored) / gross : 0.0;
}

double um_thermal_history_audit_limit(const struct um_thermal_history *history,
                                      const struct um_thermal_solve_options *options)
{
  if (options->tolerance_factor > 1.0) return INFINITY;
  double looser = fmax(1.0, fmax(options->relative_tolerance / AUDIT_RELATIVE,
                                 options->absolute_tolerance / AUDIT_ABSOLUTE));
  double gross = turnover(&history->audit, history->content);
  double content = gross > 0.0 ? AUDIT_CONTENT * history->content / gross : 0.0;
  return looser * fmax(AUDIT_TURNOVER, content);
}

enum um_status um_thermal_history_audit_check(struct um_context *context,
                                              const struct um_thermal_history *history,
                                              const struct um_thermal_solve_options *options)
{
  double limit = um_thermal_history_audit_limit(history, options);
  if (!(history->audit_error > limit)) return UM_OK;
  return um_core_fail(context, UM_ERR_NUMERIC,
                      "energy audit: %.1e of the heat that is turned over is not accounted for; "
                      "accepted: at most %.1e; a smaller thermal.accuracy_K makes it less",
                      history->audit_error, limit);
}

void um_thermal_history_audit_join(struct um_thermal_history *history,
                                   const struct um_thermal_audit *before)
{
  struct um_thermal_heat *to = &history->audit;
  const struct um_thermal_heat *from = &before->heat;
  to->solar += from->solar;
  to->albedo += from->albedo;
  to->planet += from->planet;
  to->internal += from->internal;
  to->conducted += from->conducted;
  to->radiated += from->radiated;
  to->exchanged += from->exchanged;
  to->stored += from->stored;
  history->content = fmax(history->content, before->content);
  history->audit_error = error_of(to, history->content);
}

static enum um_status history_run(struct um_context *context,
                                  struct um_thermal_integrator *integrator, double from,
                                  const double *times, struct um_thermal_history *history)
{
  enum um_status status;
  size_t last = history->ntime - 1;
  size_t nthermostat = history->nthermostat;
  bool *heating = history->heating;
  um_core_progress_begin(context, "heat", history->ntime);
  for (size_t k = 0; k <= last; k++) {
    history->t[k] = times[k];
    UM_CHECK(um_thermal_integrator_run(integrator, times[k] - from,
                                       history->temperature + k * history->nnode));
    if (heating != NULL) um_thermal_integrator_heating(integrator, heating + k * nthermostat);
    UM_CHECK(um_core_progress_step(context, 1));
  }
  const struct um_thermal_audit audit = um_thermal_integrator_audit(integrator);
  um_thermal_history_audit_join(history, &audit);
  um_thermal_integrator_counts(integrator, &history->steps, &history->rhs_evaluations,
                               &history->jacobians);
done:
  um_core_progress_end(context);
  return status;
}

enum um_status um_thermal_solve(struct um_context *context,
                                const struct um_thermal_network *network,
                                const struct um_irradiation_loads *loads,
                                const struct um_thermal_solve_options *options, const double *start,
                                double from, const double *times, size_t ntime,
                                struct um_thermal_history **out)
{
  enum um_status status;
  struct um_thermal_system *system = NULL;
  struct um_thermal_integrator *integrator = NULL;
  struct um_thermal_history *history = NULL;
  *out = NULL;
  UM_TRY(times_check(context, loads, from, times, ntime));
  UM_CHECK(um_thermal_system_create(context, network, loads, options, start, from, UM_SYSTEM_RUN,
                                    &system));
  UM_CHECK(um_thermal_integrator_create(system, times[ntime - 1] - from, &integrator));
  UM_CHECK(history_create(context, ntime, network->nnode, network->nthermostat, &history));
  UM_CHECK(um_thermal_integrator_start(integrator, system->first, NULL));
  UM_CHECK(history_run(context, integrator, from, times, history));
  *out = history;
  history = NULL;
done:
  um_thermal_history_destroy(context, &history);
  um_thermal_integrator_destroy(&integrator);
  um_thermal_system_destroy(&system);
  return status;
}
