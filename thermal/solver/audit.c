/* Energy of a stretch of time: what came over the satellite's border, and what its content says. */
#include <math.h>

#include "thermal/solver/integrator_data_impl.h"
#include "thermal/solver/integrator_group.h"
#include "thermal/solver/solve.h"

#define CLOSED 1e-6 /* of its content, the turnover of a satellite that nothing enters or leaves   \
                     */

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

static double error_of(const struct um_thermal_heat *h, double content)
{
  const double term[UM_AUDIT_TERMS] = {h->solar,    h->albedo,    h->planet,   h->internal,
                                       h->radiated, h->conducted, h->exchanged};
  double net = 0.0, gross = 0.0;
  for (int k = 0; k < UM_AUDIT_TERMS; k++) {
    net += term[k];
    gross += fabs(term[k]);
  }
  gross = fmax(gross, CLOSED * content);
  return gross > 0.0 ? fabs(net - h->stored) / gross : 0.0;
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
