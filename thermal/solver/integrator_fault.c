/* What is said of an integration that failed: CVODES' words or the linear solver's, when, and where
 * the last step was worst. */
#include <math.h>
#include <stdio.h>

#include "thermal/solver/integrator_data_impl.h"

/* ", worst at node 'x'" by the last step's error test, "" before one. */
static const char *worst_place(struct um_thermal_integrator *integrator, char *text, size_t size)
{
  const struct um_thermal_system *system = integrator->system;
  N_Vector error = integrator->dense;
  char label[96];
  double largest = 0.0;
  size_t worst = 0;
  text[0] = '\0';
  if (!integrator->initialized || error == NULL || integrator->steps == 0 ||
      CVodeGetEstLocalErrors(integrator->cvodes, error) < 0)
    return text;
  const double *e = N_VGetArrayPointer(error);
  for (size_t k = 0; k < system->nunknown; k++)
    if (fabs(e[k]) > largest) {
      largest = fabs(e[k]);
      worst = k;
    }
  if (largest > 0.0)
    snprintf(text, size, ", worst at %s",
             um_thermal_network_label(system->network, system->node[worst], label, sizeof label));
  return text;
}

enum um_status um_thermal_integrator_fail(struct um_thermal_integrator *integrator, int code)
{
  struct um_context *context = integrator->system->context;
  UM_TRY(um_core_stop_check(context, "heat was integrated"));
  if (code == CV_MEM_FAIL)
    return um_core_fail(context, UM_ERR_MEMORY, "out of memory in the heat integration");
  char fault[256], place[128];
  const char *why = integrator->words.text[0] != '\0' ? integrator->words.text : "no message";
  if (um_thermal_linear_fault(integrator->linear, fault, sizeof fault)[0] != '\0') why = fault;
  return um_core_fail(context, UM_ERR_NUMERIC,
                      "heat integration stopped %.3f s after its start%s (CVODES code %d%s): %s",
                      integrator->t, worst_place(integrator, place, sizeof place), code,
                      integrator->balance_lost ? ", an arithmetic node finds no balance" : "", why);
}
