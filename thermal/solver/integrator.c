/* Integration by CVODES (Hindmarsh et al. 2005, ACM TOMS 31:363): BDF of order 1 to 5, modified
 * Newton with the analytic Jacobian (linear.c), factored anew only when the step changes much or
 * Newton's iteration no longer converges; the symbolic factorisation is made once.
 *
 * Thermostats switch where CVODES finds the root of sensor minus threshold; the integration starts
 * anew there with the heater's other state.
 *
 * Audit. The integrals of the heat terms are CVODES quadratures: the same formula with the same
 * history as the temperatures. A linear multistep method keeps linear balances, hence the audit
 * closes to the residual of Newton's iteration, a tenth of the step's error test, and to what the
 * solution with exchange leaves of a right side (integrator_create.c). */
#include <math.h>
#include <string.h>

#include "thermal/solver/integrator_data_impl.h"
#include "thermal/solver/integrator_group.h"

#define STEPS_LIMIT  50000000u /* of one run: an end for what would never come to one */
#define SHORTEST_GAP 1e-9      /* [s] a switching this near to a stop happens there */

/* Thermostats as they are from t on, and the crossings to look for. */
static enum um_status thermostats_turn(struct um_thermal_integrator *integrator)
{
  struct um_thermal_system *system = integrator->system;
  if (integrator->switched) {
    if (!um_thermal_system_state_set(system, integrator->t, N_VGetArrayPointer(integrator->y)))
      return um_thermal_integrator_fail(integrator, CV_RHSFUNC_FAIL);
    for (size_t k = 0; k < system->nthermostat; k++)
      if (integrator->root[k] != 0) system->thermostat[k].on = !system->thermostat[k].on;
    /* others that passed at the same instant */
    um_thermal_system_thermostats_set(system, false);
  }
  integrator->switched = false;
  for (size_t k = 0; k < system->nthermostat; k++)
    integrator->root[k] = system->thermostat[k].on ? 1 : -1;
  SUN_CHECK(CVodeSetRootDirection(integrator->cvodes, integrator->root));
  return UM_OK;
}

/* Start CVODES at integrator->t up to the next stop. */
static enum um_status segment_start(struct um_thermal_integrator *integrator)
{
  struct um_thermal_system *system = integrator->system;
  double end = integrator->stop[integrator->segment];
  um_thermal_system_window(system, integrator->t, end);
  if (!integrator->initialized) {
    UM_TRY(um_thermal_integrator_set_up(integrator));
  } else {
    SUN_CHECK(CVodeReInit(integrator->cvodes, integrator->t, integrator->y));
    if (!system->options.no_audit)
      SUN_CHECK(CVodeQuadReInit(integrator->cvodes, integrator->quadrature));
  }
  if (um_thermal_integrator_has_switches(system)) UM_TRY(thermostats_turn(integrator));
  double longest;
  UM_TRY(um_thermal_integrator_longest_step(system, &longest));
  SUN_CHECK(CVodeSetMaxStep(integrator->cvodes, longest));
  SUN_CHECK(CVodeSetStopTime(integrator->cvodes, end));
  return UM_OK;
}

void um_thermal_integrator_loosen(struct um_thermal_integrator *integrator, double factor)
{
  integrator->tolerance_factor = factor;
}

enum um_status um_thermal_integrator_start(struct um_thermal_integrator *integrator,
                                           const double *temperature,
                                           const struct um_thermal_integrals *integrals)
{
  struct um_thermal_system *system = integrator->system;
  memcpy(system->temperature, temperature, system->n * sizeof *temperature);
  um_thermal_system_thermostats_set(system, true);
  double *y = N_VGetArrayPointer(integrator->y);
  for (size_t k = 0; k < system->nunknown; k++)
    y[k] =
        um_thermal_system_unknown_of(system, system->node[k], system->temperature[system->node[k]]);
  N_VConst(system->options.no_audit ? NAN : 0.0, integrator->quadrature);
  integrator->content_before = um_thermal_system_content(system, y);
  integrator->t = 0.0;
  integrator->segment = 0;
  integrator->cube = integrals != NULL ? integrals->cube : NULL;
  integrator->power4 = integrals != NULL ? integrals->power4 : NULL;
  integrator->run_steps = 0;
  integrator->switched = false;
  UM_TRY(segment_start(integrator));
  UM_TRY(um_thermal_integrator_tolerances(integrator));
  if (!um_thermal_system_state_set(system, 0.0, y)) {
    integrator->balance_lost = true;
    return um_thermal_integrator_fail(integrator, CV_RHSFUNC_FAIL);
  }
  if (integrals != NULL) {
    size_t bytes = system->n * sizeof(double);
    memset(integrals->cube, 0, bytes);
    memset(integrals->power4, 0, bytes);
    memcpy(integrator->cube_before, system->cube, bytes);
    memcpy(integrator->power4_before, system->power4, bytes);
    for (size_t k = 0; k < system->nthermostat; k++) {
      integrator->mean_slope[k] = 0.0;
      integrator->slope_before[k] = system->thermostat[k].slope;
    }
  }
  return UM_OK;
}

/* Trapezoid of |T|^3, T^4 and thermostats' slopes over the step of length h that just ended. */
static void mean_add(struct um_thermal_integrator *integrator, double h)
{
  struct um_thermal_system *system = integrator->system;
  const double *y = N_VGetArrayPointer(integrator->y);
  bool set = system->nthermostat > 0 ? um_thermal_system_state_set(system, integrator->t, y)
                                     : um_thermal_system_powers_set(system, integrator->t, y);
  if (!set) return; /* the next evaluation of the rate reports it */
  for (size_t i = 0; i < system->n; i++) {
    integrator->cube[i] += 0.5 * h * (integrator->cube_before[i] + system->cube[i]);
    integrator->power4[i] += 0.5 * h * (integrator->power4_before[i] + system->power4[i]);
    integrator->cube_before[i] = system->cube[i];
    integrator->power4_before[i] = system->power4[i];
  }
  for (size_t k = 0; k < system->nthermostat; k++) {
    double slope = system->thermostat[k].slope;
    integrator->mean_slope[k] += 0.5 * h * (integrator->slope_before[k] + slope);
    integrator->slope_before[k] = slope;
  }
}

const double *um_thermal_integrator_mean_slopes(const struct um_thermal_integrator *integrator)
{
  return integrator->mean_slope;
}

/* No temperature is below 0 K. */
static enum um_status above_zero(struct um_thermal_integrator *integrator)
{
  const struct um_thermal_system *system = integrator->system;
  const double *y = N_VGetArrayPointer(integrator->y);
  const struct um_thermal_solve_options *options = &system->options;
  double least = -options->absolute_tolerance * options->tolerance_factor, warming;
  char label[96];
  for (size_t k = 0; k < system->nunknown; k++)
    if (!(y[k] >= least * integrator->tolerance_factor))
      return um_core_fail(
          system->context, UM_ERR_NUMERIC,
          "%s is at %.4g K, %.3f s after the start of the heat integration: more heat is taken "
          "from it than reaches it (power %g W)",
          um_thermal_network_label(system->network, system->node[k], label, sizeof label),
          um_thermal_system_temperature_of(system, system->node[k], y[k], &warming), integrator->t,
          system->power[system->node[k]]);
  return UM_OK;
}

static enum um_status step_once(struct um_thermal_integrator *integrator)
{
  double end = integrator->stop[integrator->segment], before = integrator->t;
  UM_TRY(um_core_stop_check(integrator->system->context, "heat was integrated"));
  int code = CVode(integrator->cvodes, end, integrator->y, &integrator->t, CV_ONE_STEP);
  if (code < 0) return um_thermal_integrator_fail(integrator, code);
  UM_TRY(above_zero(integrator));
  integrator->steps++;
  if (++integrator->run_steps > STEPS_LIMIT)
    return um_core_fail(integrator->system->context, UM_ERR_NUMERIC,
                        "heat integration gave up %.3f s after its start: %u steps", integrator->t,
                        STEPS_LIMIT);
  if (integrator->cube != NULL) mean_add(integrator, integrator->t - before);
  if (code == CV_ROOT_RETURN) {
    integrator->switched = true;
    SUN_CHECK(CVodeGetRootInfo(integrator->cvodes, integrator->root));
  }
  if (integrator->t < end && !integrator->switched) return UM_OK;
  sunrealtype at;
  if (!integrator->system->options.no_audit)
    SUN_CHECK(CVodeGetQuad(integrator->cvodes, &at, integrator->quadrature));
  return UM_OK;
}

/* At a stop or a switching: begin anew. Not at the end of all. */
static enum um_status segment_enter(struct um_thermal_integrator *integrator)
{
  double end = integrator->stop[integrator->segment];
  if (integrator->t >= end - SHORTEST_GAP && integrator->segment + 1 < integrator->nstop) {
    integrator->t = end;
    integrator->segment++;
    return segment_start(integrator);
  }
  return integrator->switched ? segment_start(integrator) : UM_OK;
}

enum um_status um_thermal_integrator_advance(struct um_thermal_integrator *integrator,
                                             struct um_thermal_advance *out)
{
  const struct um_thermal_system *system = integrator->system;
  size_t bytes = system->nunknown * sizeof(double);
  UM_TRY(segment_enter(integrator));
  for (size_t k = 0; k < system->nthermostat; k++)
    integrator->heating[k] = system->thermostat[k].on;
  out->before = integrator->t;
  UM_TRY(step_once(integrator));
  out->t = integrator->t;
  out->heating = integrator->heating;
  out->ends =
      integrator->switched || integrator->t >= integrator->stop[integrator->segment] - SHORTEST_GAP;
  memcpy(out->y, N_VGetArrayPointer(integrator->y), bytes);
  double *const slope[2] = {out->slope_before, out->slope};
  for (int k = 0; k < 2; k++) {
    SUN_CHECK(CVodeGetDky(integrator->cvodes, k == 0 ? out->before : out->t, 1, integrator->dense));
    memcpy(slope[k], N_VGetArrayPointer(integrator->dense), bytes);
  }
  return UM_OK;
}

double um_thermal_integrator_stop(const struct um_thermal_integrator *integrator)
{
  return integrator->stop[integrator->segment];
}

enum um_status um_thermal_integrator_run(struct um_thermal_integrator *integrator, double t,
                                         double *temperature)
{
  struct um_thermal_system *system = integrator->system;
  while (integrator->t < t) {
    double end = integrator->stop[integrator->segment];
    if (integrator->t >= end - SHORTEST_GAP) {
      integrator->t = end;
      if (end >= t) break;
      integrator->segment++;
      UM_TRY(segment_start(integrator));
    } else if (integrator->switched) {
      UM_TRY(segment_start(integrator));
    }
    UM_TRY(step_once(integrator));
  }
  N_Vector y = integrator->y;
  if (t < integrator->t) {
    SUN_CHECK(CVodeGetDky(integrator->cvodes, t, 0, integrator->dense));
    y = integrator->dense;
  }
  if (!um_thermal_system_state_set(system, t, N_VGetArrayPointer(y))) {
    integrator->balance_lost = true;
    return um_thermal_integrator_fail(integrator, CV_RHSFUNC_FAIL);
  }
  memcpy(temperature, system->temperature, system->n * sizeof *temperature);
  return UM_OK;
}

void um_thermal_integrator_heating(const struct um_thermal_integrator *integrator, bool *on)
{
  const struct um_thermal_system *system = integrator->system;
  for (size_t k = 0; k < system->nthermostat; k++) on[k] = system->thermostat[k].on;
}

struct um_thermal_audit um_thermal_integrator_audit(const struct um_thermal_integrator *integrator)
{
  const double *term = N_VGetArrayPointer(integrator->quadrature);
  double begin = integrator->content_before,
         end = um_thermal_system_content(integrator->system, N_VGetArrayPointer(integrator->y));
  return (struct um_thermal_audit){.heat = {.solar = term[UM_AUDIT_SOLAR],
                                            .albedo = term[UM_AUDIT_ALBEDO],
                                            .planet = term[UM_AUDIT_PLANET],
                                            .internal = term[UM_AUDIT_INTERNAL],
                                            .conducted = term[UM_AUDIT_CONDUCTED],
                                            .radiated = term[UM_AUDIT_RADIATED],
                                            .exchanged = term[UM_AUDIT_EXCHANGED],
                                            .stored = end - begin},
                                   .content = fmax(fabs(begin), fabs(end))};
}

void um_thermal_integrator_counts(const struct um_thermal_integrator *integrator, size_t *steps,
                                  size_t *rhs_evaluations, size_t *jacobians)
{
  *steps = integrator->steps;
  *rhs_evaluations = integrator->rhs_evaluations;
  *jacobians = integrator->jacobians;
}
