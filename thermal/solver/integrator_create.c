/* The making of an integration: vectors, solvers, CVODES and its settings. */
#include <nvector/nvector_serial.h>

#include "thermal/solver/exchange_solve_group.h"
#include "thermal/solver/integrator_data_impl.h"
#include "thermal/solver/integrator_group.h"
#include "thermal/solver/vector_impl.h"

/* Newton's iteration ends at CVODES' own 0.1 of the error test: 1e-4 makes ENVISAT's temperatures
 * no more accurate and its run a fifth longer. What iterations about the exchange leave stays in
 * the heat balance of a closed room. */
#define LINEAR_SHARE   1e-5 /* of a right side that iterated linear solutions leave */
#define EXCHANGE_SHARE 3e-4 /* the same with exchange between surfaces */
#define EXCHANGE_LOOSE 1e-2 /* the same where tolerances are looser than asked */

static enum um_status vectors_create(struct um_thermal_integrator *integrator)
{
  struct um_thermal_system *system = integrator->system;
  struct um_context *context = system->context;
  size_t nthermostat = system->nthermostat;
  UM_TRY(um_core_allocate(context, system->n, sizeof(double), &integrator->cube_before));
  UM_TRY(um_core_allocate(context, system->n, sizeof(double), &integrator->power4_before));
  UM_TRY(um_core_allocate(context, nthermostat, sizeof(double), &integrator->mean_slope));
  UM_TRY(um_core_allocate(context, nthermostat, sizeof(double), &integrator->slope_before));
  UM_TRY(um_core_allocate(context, nthermostat, sizeof(int), &integrator->root));
  UM_TRY(um_core_allocate(context, nthermostat, sizeof(bool), &integrator->heating));
  if (SUNContext_Create(SUN_COMM_NULL, &integrator->sun) != 0)
    return um_thermal_integrator_fail(integrator, CV_MEM_FAIL);
  sunindextype n = (sunindextype)system->nunknown;
  integrator->y = um_thermal_vector_create(system->nunknown, integrator->sun);
  integrator->dense = N_VNew_Serial(n, integrator->sun);
  integrator->quadrature = N_VNew_Serial(UM_AUDIT_TERMS, integrator->sun);
  integrator->matrix = um_thermal_linear_matrix(system, integrator->sun);
  if (integrator->y == NULL || integrator->dense == NULL || integrator->quadrature == NULL ||
      integrator->matrix == NULL)
    return um_thermal_integrator_fail(integrator, CV_MEM_FAIL);
  UM_TRY(um_thermal_linear_create(system, &integrator->linear));
  integrator->solver =
      um_thermal_linear_sundials(integrator->linear, LINEAR_SHARE, integrator->sun);
  if (system->exchange != NULL)
    integrator->solver =
        um_thermal_exchange_sundials(system, integrator->solver, &integrator->gamma,
                                     &integrator->exchange_share, integrator->sun);
  if (integrator->solver == NULL) return um_thermal_integrator_fail(integrator, CV_MEM_FAIL);
  integrator->cvodes = CVodeCreate(CV_BDF, integrator->sun);
  if (integrator->cvodes == NULL) return um_thermal_integrator_fail(integrator, CV_MEM_FAIL);
  return UM_OK;
}

enum um_status um_thermal_integrator_tolerances(struct um_thermal_integrator *integrator)
{
  const struct um_thermal_solve_options *options = &integrator->system->options;
  double factor = integrator->tolerance_factor * options->tolerance_factor;
  SUN_CHECK(CVodeSStolerances(integrator->cvodes, factor * options->relative_tolerance,
                              factor * options->absolute_tolerance));
  integrator->exchange_share = factor > 1.0 ? EXCHANGE_LOOSE : EXCHANGE_SHARE;
  return UM_OK;
}

bool um_thermal_integrator_has_switches(const struct um_thermal_system *system)
{
  return system->kind == UM_SYSTEM_RUN && system->nthermostat > 0;
}

/* Settings that need an initialised CVODES. */
enum um_status um_thermal_integrator_set_up(struct um_thermal_integrator *integrator)
{
  void *cvodes = integrator->cvodes;
  SUN_CHECK(um_thermal_words_of_cvodes(cvodes, integrator->sun, &integrator->words));
  SUN_CHECK(CVodeInit(cvodes, um_thermal_integrator_rate, 0.0, integrator->y));
  SUN_CHECK(CVodeSetUserData(cvodes, integrator));
  UM_TRY(um_thermal_integrator_tolerances(integrator));
  SUN_CHECK(CVodeSetLinearSolver(cvodes, integrator->solver, integrator->matrix));
  SUN_CHECK(CVodeSetLinSysFn(cvodes, um_thermal_integrator_newton));
  SUN_CHECK(CVodeSetMaxErrTestFails(cvodes, 20));
  if (!integrator->system->options.no_audit)
    SUN_CHECK(CVodeQuadInit(cvodes, um_thermal_integrator_audit_rate, integrator->quadrature));
  if (um_thermal_integrator_has_switches(integrator->system)) {
    SUN_CHECK(CVodeRootInit(cvodes, (int)integrator->system->nthermostat,
                            um_thermal_integrator_switches));
    SUN_CHECK(CVodeSetNoInactiveRootWarn(cvodes));
  }
  integrator->initialized = true;
  return UM_OK;
}

enum um_status um_thermal_integrator_create(struct um_thermal_system *system, double duration,
                                            struct um_thermal_integrator **out)
{
  enum um_status status;
  struct um_thermal_integrator *integrator = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(system->context, 1, sizeof *integrator, &integrator));
  integrator->system = system;
  integrator->tolerance_factor = 1.0;
  UM_CHECK(um_thermal_integrator_stops(integrator, duration));
  UM_CHECK(vectors_create(integrator));
  *out = integrator;
  return UM_OK;
done:
  um_thermal_integrator_destroy(&integrator);
  return status;
}

void um_thermal_integrator_destroy(struct um_thermal_integrator **integrator)
{
  if (integrator == NULL || *integrator == NULL) return;
  struct um_thermal_integrator *i = *integrator;
  struct um_context *context = i->system->context;
  if (i->cvodes != NULL) CVodeFree(&i->cvodes);
  if (i->solver != NULL) SUNLinSolFree(i->solver);
  um_thermal_linear_destroy(&i->linear);
  if (i->matrix != NULL) SUNMatDestroy(i->matrix);
  if (i->y != NULL) N_VDestroy(i->y);
  if (i->dense != NULL) N_VDestroy(i->dense);
  if (i->quadrature != NULL) N_VDestroy(i->quadrature);
  if (i->sun != NULL) SUNContext_Free(&i->sun);
  UM_FREE(context, i->stop, i->cube_before, i->power4_before, i->mean_slope, i->slope_before,
          i->root, i->heating, i);
  *integrator = NULL;
}
