/* What CVODES asks of a heat balance: the rate, Newton's matrix, what is left to a thermostat's
 * next switching, and the heat over the satellite's border. */
#include <string.h>

#include <sunmatrix/sunmatrix_sparse.h>

#include "thermal/solver/integrator_data_impl.h"
#include "thermal/solver/integrator_group.h"

int um_thermal_integrator_rate(sunrealtype t, N_Vector y, N_Vector rate, void *self)
{
  struct um_thermal_integrator *integrator = self;
  integrator->rhs_evaluations++;
  if (um_core_stopped(integrator->system->context)) return -1; /* for good */
  if (!um_thermal_system_state_set(integrator->system, t, N_VGetArrayPointer(y))) {
    integrator->balance_lost = true;
    return 1; /* recoverable: a shorter step */
  }
  um_thermal_system_rate(integrator->system, N_VGetArrayPointer(rate));
  return 0;
}

/* Newton's matrix I - gamma J, always with a fresh J: evaluating it costs less than a copy. */
int um_thermal_integrator_newton(sunrealtype t, N_Vector y, N_Vector rate, SUNMatrix matrix,
                                 sunbooleantype kept, sunbooleantype *fresh, sunrealtype gamma,
                                 void *self, N_Vector work1, N_Vector work2, N_Vector work3)
{
  (void)rate, (void)kept, (void)work1, (void)work2, (void)work3;
  struct um_thermal_integrator *integrator = self;
  struct um_thermal_system *system = integrator->system;
  integrator->jacobians++;
  *fresh = SUNTRUE;
  double *value = SUNSparseMatrix_Data(matrix);
  um_thermal_linear_pattern(system, matrix);
  if (!um_thermal_system_state_set(system, t, N_VGetArrayPointer(y))) return 1;
  if (!um_thermal_system_jacobian(system, value)) return 1;
  if (system->exchange != NULL) um_thermal_system_exchange_hold(system, true);
  integrator->gamma = gamma;
  for (size_t k = 0; k < system->nnonzero; k++) value[k] *= -gamma;
  for (size_t k = 0; k < system->nunknown; k++) value[system->diagonal[k]] += 1.0;
  return 0;
}

/* Sensor minus the threshold that is next, of every thermostat [K]. */
int um_thermal_integrator_switches(sunrealtype t, N_Vector y, sunrealtype *out, void *self)
{
  (void)t;
  struct um_thermal_integrator *integrator = self;
  const struct um_thermal_system *system = integrator->system;
  const double *unknown = N_VGetArrayPointer(y);
  for (size_t k = 0; k < system->nthermostat; k++) {
    const struct um_thermal_network_thermostat *t_k = system->thermostat[k].thermostat;
    double sum = 0.0, warming;
    for (size_t j = 0; j < t_k->sensor.n; j++) {
      uint32_t node = t_k->sensor.node[j];
      sum += t_k->sensor.weight[j] * um_thermal_system_temperature_of(
                                         system, node, unknown[system->unknown[node]], &warming);
    }
    out[k] = sum - (system->thermostat[k].on ? t_k->off : t_k->on);
  }
  return 0;
}

/* Heat over the satellite's border now [W]. */
int um_thermal_integrator_audit_rate(sunrealtype t, N_Vector y, N_Vector out, void *self)
{
  struct um_thermal_integrator *integrator = self;
  struct um_thermal_system *system = integrator->system;
  double *term = N_VGetArrayPointer(out);
  if (!um_thermal_system_state_set(system, t, N_VGetArrayPointer(y))) return 1;
  memset(term, 0, UM_AUDIT_TERMS * sizeof *term);
  term[UM_AUDIT_SOLAR] = system->now.solar;
  term[UM_AUDIT_ALBEDO] = system->now.albedo;
  term[UM_AUDIT_PLANET] = system->now.planet;
  const double *temperature = system->temperature, *power4 = system->power4;
  for (size_t i = 0; i < system->n; i++) {
    if (!system->fixed[i]) {
      term[UM_AUDIT_INTERNAL] += system->power[i];
      if (system->made != NULL) term[UM_AUDIT_INTERNAL] += system->made[i];
      term[UM_AUDIT_RADIATED] -= system->space[i] * (power4[i] - system->space4);
      if (system->exchange != NULL) term[UM_AUDIT_RADIATED] += system->exchange->gain[i];
      continue;
    }
    for (size_t e = system->start[i]; e < system->start[i + 1]; e++) {
      size_t j = system->other[e];
      if (system->fixed[j]) continue;
      if (um_thermal_system_link_varies(system, e)) {
        double heat = um_thermal_system_link_heat(system, e, j, i);
        term[system->fourth[e] != 0.0 ? UM_AUDIT_EXCHANGED : UM_AUDIT_CONDUCTED] += heat;
        continue;
      }
      term[UM_AUDIT_CONDUCTED] += system->linear[e] * (temperature[i] - temperature[j]);
      term[UM_AUDIT_EXCHANGED] += system->fourth[e] * (power4[i] - power4[j]);
    }
  }
  return 0;
}
