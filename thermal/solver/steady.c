/* Steady state: H_i(T) = 0 for every node that is not a boundary (equation in system_build.c), by
 * KINSOL: Newton with line search, exact Jacobian at every iteration (linear.c). Residuals are
 * scaled by the node's own conductance G_i = sum_j (K_ij + 4 s R_ij T^3) + 4 s R_i,space T^3, so
 * they are temperatures [K]. Mean thermostats are steep: a first solution with a wide transition
 * leads the iteration to narrower ones. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <kinsol/kinsol.h>
#include <nvector/nvector_serial.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include "thermal/solver/exchange_solve_group.h"
#include "thermal/solver/linear_group.h"
#include "thermal/solver/solve.h"
#include "thermal/solver/steady_impl.h"
#include "thermal/solver/sundials_impl.h"

#define RESIDUAL     1e-9 /* [K] */
#define ITERATIONS   400
#define SOFTEST      1024.0 /* factor on the width of thermostats to begin with */
#define SHARPER      4.0    /* from one to the next */
#define EXCHANGE     1e-10  /* the same with exchange between surfaces */
#define LINEAR_SHARE 1e-8   /* of a right side that iterated linear solutions leave */

struct steady {
  struct um_thermal_system *system; /* borrowed */
  const double *residual;           /* [n] heat that the balance leaves [W], borrowed; NULL: 0 */
  SUNContext sun;
  N_Vector y, y_scale, f_scale;
  SUNMatrix matrix;
  struct um_thermal_linear *linear;
  SUNLinearSolver solver;
  void *kinsol;
  struct um_thermal_words words; /* of KINSOL */
};

static int heat_callback(N_Vector y, N_Vector heat, void *self)
{
  struct steady *steady = self;
  struct um_thermal_system *system = steady->system;
  if (um_core_stopped(system->context)) return -1; /* for good */
  if (!um_thermal_system_state_set(system, 0.0, N_VGetArrayPointer(y))) return 1;
  double *left = N_VGetArrayPointer(heat);
  um_thermal_system_rate(system, left);
  for (size_t k = 0; k < system->nunknown && steady->residual != NULL; k++)
    left[k] -= steady->residual[system->node[k]];
  return 0;
}

static int jacobian_callback(N_Vector y, N_Vector heat, SUNMatrix matrix, void *self,
                             N_Vector work1, N_Vector work2)
{
  (void)heat, (void)work1, (void)work2;
  struct steady *steady = self;
  struct um_thermal_system *system = steady->system;
  um_thermal_linear_pattern(system, matrix);
  if (!um_thermal_system_state_set(system, 0.0, N_VGetArrayPointer(y))) return 1;
  if (system->exchange != NULL) um_thermal_system_exchange_hold(system, false);
  return um_thermal_system_jacobian(system, SUNSparseMatrix_Data(matrix)) ? 0 : 1;
}

static enum um_status vectors_create(struct steady *steady)
{
  const struct um_thermal_system *system = steady->system;
  sunindextype n = (sunindextype)system->nunknown;
  if (SUNContext_Create(SUN_COMM_NULL, &steady->sun) != 0) goto memory;
  steady->y = N_VNew_Serial(n, steady->sun);
  steady->y_scale = N_VNew_Serial(n, steady->sun);
  steady->f_scale = N_VNew_Serial(n, steady->sun);
  steady->matrix = um_thermal_linear_matrix(system, steady->sun);
  if (steady->y == NULL || steady->y_scale == NULL || steady->f_scale == NULL ||
      steady->matrix == NULL)
    goto memory;
  UM_TRY(um_thermal_linear_create(system, &steady->linear));
  steady->solver = um_thermal_linear_sundials(steady->linear, LINEAR_SHARE, steady->sun);
  static const double of_jacobian = -1.0; /* the matrix is J itself */
  static const double tolerance = EXCHANGE;
  if (system->exchange != NULL)
    steady->solver = um_thermal_exchange_sundials(steady->system, steady->solver, &of_jacobian,
                                                  &tolerance, steady->sun);
  steady->kinsol = KINCreate(steady->sun);
  if (steady->solver == NULL || steady->kinsol == NULL) goto memory;
  return UM_OK;
memory:
  return um_core_fail(system->context, UM_ERR_MEMORY, "out of memory in the steady heat balance");
}

static void steady_free(struct steady *steady)
{
  if (steady->kinsol != NULL) KINFree(&steady->kinsol);
  if (steady->solver != NULL) SUNLinSolFree(steady->solver);
  um_thermal_linear_destroy(&steady->linear);
  if (steady->matrix != NULL) SUNMatDestroy(steady->matrix);
  if (steady->y != NULL) N_VDestroy(steady->y);
  if (steady->y_scale != NULL) N_VDestroy(steady->y_scale);
  if (steady->f_scale != NULL) N_VDestroy(steady->f_scale);
  if (steady->sun != NULL) SUNContext_Free(&steady->sun);
}

/* Start temperatures, and G_i at 300 K as scale; a node that nothing holds is refused. */
static enum um_status start_set(struct steady *steady)
{
  const struct um_thermal_system *system = steady->system;
  double *y = N_VGetArrayPointer(steady->y), *scale = N_VGetArrayPointer(steady->f_scale);
  const double slope = 4.0 * 300.0 * 300.0 * 300.0; /* d(T^4)/dT [K^3] */
  for (size_t k = 0; k < system->nunknown; k++) {
    size_t i = system->node[k];
    y[k] = system->temperature[i];
    double g = system->space[i] * slope;
    for (size_t e = system->start[i]; e < system->start[i + 1]; e++)
      g += fabs(system->linear[e]) + system->fourth[e] * slope;
    char label[96];
    if (!(g > 0.0))
      return um_core_fail(
          system->context, UM_ERR_INPUT,
          "%s has no steady temperature: nothing conducts or radiates from it",
          um_thermal_network_label(system->network, (uint32_t)i, label, sizeof label));
    /* radiation has no slope at 0 K */
    if (y[k] < 10.0) y[k] = 10.0;
    scale[k] = 1.0 / g;
  }
  N_VConst(1.0 / 300.0, steady->y_scale);
  return UM_OK;
}

static int kinsol_set_up(struct steady *steady)
{
  void *k = steady->kinsol;
  int code = um_thermal_words_of_kinsol(k, steady->sun, &steady->words);
  if (code >= 0) code = KINInit(k, heat_callback, steady->y);
  if (code >= 0) code = KINSetUserData(k, steady);
  if (code >= 0) code = KINSetLinearSolver(k, steady->solver, steady->matrix);
  if (code >= 0) code = KINSetJacFn(k, jacobian_callback);
  if (code >= 0) code = KINSetMaxSetupCalls(k, 1);
  if (code >= 0) code = KINSetNumMaxIters(k, ITERATIONS);
  if (code >= 0) code = KINSetFuncNormTol(k, RESIDUAL);
  if (code >= 0) code = KINSetScaledStepTol(k, 1e-13);
  return code;
}

static enum um_status fail(const struct steady *steady, int code, double residual)
{
  char fault[256];
  const char *why = steady->words.text[0] != '\0' ? steady->words.text : "no message";
  if (um_thermal_linear_fault(steady->linear, fault, sizeof fault)[0] != '\0') why = fault;
  return um_core_fail(steady->system->context, UM_ERR_NUMERIC,
                      "no steady heat balance found (KINSOL code %d, residual %.3g K): %s", code,
                      residual, why);
}

static enum um_status kinsol_run(struct steady *steady)
{
  struct um_thermal_system *system = steady->system;
  void *k = steady->kinsol;
  int code = kinsol_set_up(steady);
  double residual = NAN;
  system->softness = system->nthermostat > 0 ? SOFTEST : 1.0;
  /* NOLINTNEXTLINE(cert-flp30-c): ends at 1, whatever the rounding */
  for (;; system->softness /= SHARPER) {
    if (code >= 0) code = KINSol(k, steady->y, KIN_LINESEARCH, steady->y_scale, steady->f_scale);
    if (code >= 0) code = KINGetFuncNorm(k, &residual);
    UM_TRY(um_core_stop_check(system->context, "the steady heat balance was solved"));
    /* a step too small to take is a success when the residual is met */
    if (code < 0 || !(residual <= 100.0 * RESIDUAL)) return fail(steady, code, residual);
    if (system->softness <= 1.0) return UM_OK;
  }
}

static enum um_status above_zero(const struct um_thermal_system *system)
{
  char label[96];
  for (uint32_t i = 0; i < system->n; i++)
    if (!(system->temperature[i] >= 0.0))
      return um_core_fail(system->context, UM_ERR_NUMERIC,
                          "steady heat balance: %s would be at %.4g K: more heat is taken from it "
                          "than reaches it (power %g W)",
                          um_thermal_network_label(system->network, i, label, sizeof label),
                          system->temperature[i], system->power[i]);
  return UM_OK;
}

enum um_status um_thermal_steady_solve(struct um_thermal_system *system, const double *residual,
                                       double *temperature)
{
  enum um_status status;
  struct steady steady = {.system = system, .residual = residual};
  UM_CHECK(vectors_create(&steady));
  UM_CHECK(start_set(&steady));
  UM_CHECK(kinsol_run(&steady));
  if (!um_thermal_system_state_set(system, 0.0, N_VGetArrayPointer(steady.y))) {
    status = um_core_fail(system->context, UM_ERR_NUMERIC, "no steady heat balance found");
    goto done;
  }
  UM_CHECK(above_zero(system));
  memcpy(temperature, system->temperature, system->n * sizeof *temperature);
done:
  steady_free(&steady);
  return status;
}

enum um_status um_thermal_solve_steady(struct um_context *context,
                                       const struct um_thermal_network *network,
                                       const struct um_irradiation_loads *loads, size_t time,
                                       const struct um_thermal_solve_options *options,
                                       const double *start, double *temperature)
{
  struct um_thermal_system *system = NULL;
  if (loads != NULL && time >= loads->ntime)
    return um_core_fail(context, UM_ERR_INPUT, "steady state at row %zu of %zu rows of heat loads",
                        time, loads->ntime);
  double from = loads != NULL ? loads->t[time] : 0.0;
  UM_TRY(um_thermal_system_create(context, network, loads, options, start, from, UM_SYSTEM_STEADY,
                                  &system));
  if (loads != NULL) um_thermal_system_hold(system, time);
  enum um_status status = um_thermal_steady_solve(system, NULL, temperature);
  um_thermal_system_destroy(&system);
  return status;
}

enum um_status um_thermal_solve_powered(struct um_context *context,
                                        const struct um_thermal_network *network,
                                        const double *power,
                                        const struct um_thermal_solve_options *options,
                                        double *temperature)
{
  struct um_thermal_system *system = NULL;
  UM_TRY(um_thermal_system_create(context, network, NULL, options, NULL, 0.0, UM_SYSTEM_STEADY,
                                  &system));
  memcpy(system->power, power, system->n * sizeof *power);
  enum um_status status = um_thermal_steady_solve(system, NULL, temperature);
  um_thermal_system_destroy(&system);
  return status;
}
