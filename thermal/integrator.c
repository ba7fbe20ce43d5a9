/* Integration by CVODES (Hindmarsh et al. 2005, ACM TOMS 31:363): BDF of order 1 to 5, modified
 * Newton with the analytic Jacobian (linear.c), factored anew only when the step changes much or
 * Newton's iteration no longer converges; the symbolic factorisation is made once.
 *
 * Stops. Where the loads jump or kink hard (eclipse edges, repeated grid times) the integration
 * ends exactly and starts anew, so no step straddles an edge. Between stops a step is at most
 * MAX_STEP_INTERVALS grid intervals long, longer ones could pass over a flash of Sun unseen, or as
 * many more as the loads are smooth over (system_smooth.c).
 *
 * Thermostats switch where CVODES finds the root of sensor minus threshold; the integration starts
 * anew there with the heater's other state.
 *
 * Audit. The integrals of the heat terms are CVODES quadratures: the same formula with the same
 * history as the temperatures. A linear multistep method keeps linear balances, hence the audit
 * closes to the residual of Newton's iteration, which is solved to NEWTON_SHARE of the step's
 * error test instead of the usual 0.1. */
#include "core/order.h"
#include "core/sort.h"
#include "thermal/exchange_solve_impl.h"
#include "thermal/integrator_impl.h"
#include "thermal/linear_impl.h"
#include "thermal/vector_impl.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cvodes/cvodes.h>
#include <nvector/nvector_serial.h>
#include <sunmatrix/sunmatrix_sparse.h>

#define MAX_STEP_INTERVALS 2.0
#define NEWTON_SHARE       1e-4
#define LINEAR_SHARE       1e-5      /* of a right side that iterated linear solutions leave */
#define EXCHANGE_SHARE     1e-4      /* the same with exchange between surfaces */
#define STEPS_LIMIT        50000000u /* of one run: an end for what would never come to one */
#define SHORTEST_SEGMENT   1e-6      /* [s] stops closer than this are one */
#define SHORTEST_GAP       1e-9      /* [s] a switching this near to a stop happens there */

struct um_thermal_integrator {
  struct um_thermal_system *system; /* borrowed */
  SUNContext sun;
  N_Vector y, dense, quadrature;
  SUNMatrix matrix;
  struct um_thermal_linear *linear;
  SUNLinearSolver solver;
  void *cvodes;
  double *stop; /* [nstop] ascending, the last one is the end [s] */
  size_t nstop, segment;
  double t;                /* [s] of y */
  double tolerance_factor; /* factor on the tolerances [1] */
  double gamma;            /* of Newton's matrix 1 - gamma J [s] */
  bool initialized;        /* CVodeInit was done */
  double *mean_cube, *cube_before;
  double *mean_slope, *slope_before; /* [nthermostat], with mean_cube */
  int *root;                         /* [nthermostat] which thermostats switch; their directions */
  bool switched;                     /* one did at t: a new start is due */
  bool *heating;                     /* [nthermostat] on during the last step */
  size_t steps, rhs_evaluations, jacobians, run_steps;
  bool balance_lost; /* an eliminated node found no temperature */
  char words[256];   /* of CVODES */
};

static void words_keep(int code, const char *module, const char *function, char *message,
                       void *self)
{
  struct um_thermal_integrator *integrator = self;
  (void)code;
  snprintf(integrator->words, sizeof integrator->words, "%s %s: %s", module, function, message);
}

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

static enum um_status fail(struct um_thermal_integrator *integrator, int code)
{
  struct um_context *context = integrator->system->context;
  UM_TRY(um_core_stop_check(context, "heat was integrated"));
  if (code == CV_MEM_FAIL)
    return um_core_fail(context, UM_ERR_MEMORY, "out of memory in the heat integration");
  char fault[256], place[128];
  const char *why = integrator->words[0] != '\0' ? integrator->words : "no message";
  if (um_thermal_linear_fault(integrator->linear, fault, sizeof fault)[0] != '\0') why = fault;
  return um_core_fail(context, UM_ERR_NUMERIC,
                      "heat integration stopped %.3f s after its start%s (CVODES code %d%s): %s",
                      integrator->t, worst_place(integrator, place, sizeof place), code,
                      integrator->balance_lost ? ", an arithmetic node finds no balance" : "", why);
}

#define SUN_CHECK(call)                                                                            \
  do {                                                                                             \
    int sun_code_ = (call);                                                                        \
    if (sun_code_ < 0) return fail(integrator, sun_code_);                                         \
  } while (0)

static int rate_callback(realtype t, N_Vector y, N_Vector rate, void *self)
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
static int newton_callback(realtype t, N_Vector y, N_Vector rate, SUNMatrix matrix,
                           booleantype kept, booleantype *fresh, realtype gamma, void *self,
                           N_Vector work1, N_Vector work2, N_Vector work3)
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
static int switch_callback(realtype t, N_Vector y, realtype *out, void *self)
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
static int audit_callback(realtype t, N_Vector y, N_Vector out, void *self)
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

/* Edges, jumps of the table and of power histories, and the end, ascending, apart by
 * SHORTEST_SEGMENT. */
static enum um_status stops_list(struct um_thermal_integrator *integrator, double duration)
{
  const struct um_thermal_system *system = integrator->system;
  const struct um_irradiation_loads *loads = system->loads;
  size_t room = 1 + (loads == NULL ? 0 : loads->nedge + loads->ntime), count = 0;
  room += um_thermal_system_heat_stops(system, NULL);
  UM_TRY(um_core_allocate(system->context, room, sizeof(double), &integrator->stop));
  double *stop = integrator->stop;
  for (size_t k = 0; loads != NULL && k < loads->nedge; k++)
    stop[count++] = loads->edge[k] - system->from;
  for (size_t k = 1; loads != NULL && k < loads->ntime; k++)
    if (system->grid[k] <= system->grid[k - 1]) stop[count++] = system->grid[k];
  count += um_thermal_system_heat_stops(system, stop + count);
  UM_TRY(um_core_sort(system->context, stop, count, sizeof *stop, um_core_order_double));
  size_t kept = 0;
  double before = 0.0;
  for (size_t k = 0; k < count; k++)
    if (stop[k] > before + SHORTEST_SEGMENT && stop[k] < duration - SHORTEST_SEGMENT)
      before = stop[kept++] = stop[k];
  stop[kept++] = duration;
  integrator->nstop = kept;
  return UM_OK;
}

static enum um_status vectors_create(struct um_thermal_integrator *integrator)
{
  struct um_thermal_system *system = integrator->system;
  struct um_context *context = system->context;
  size_t nthermostat = system->nthermostat;
  UM_TRY(um_core_allocate(context, system->n, sizeof(double), &integrator->cube_before));
  UM_TRY(um_core_allocate(context, nthermostat, sizeof(double), &integrator->mean_slope));
  UM_TRY(um_core_allocate(context, nthermostat, sizeof(double), &integrator->slope_before));
  UM_TRY(um_core_allocate(context, nthermostat, sizeof(int), &integrator->root));
  UM_TRY(um_core_allocate(context, nthermostat, sizeof(bool), &integrator->heating));
  if (SUNContext_Create(NULL, &integrator->sun) != 0) return fail(integrator, CV_MEM_FAIL);
  sunindextype n = (sunindextype)system->nunknown;
  integrator->y = um_thermal_vector_create(system->nunknown, integrator->sun);
  integrator->dense = N_VNew_Serial(n, integrator->sun);
  integrator->quadrature = N_VNew_Serial(UM_AUDIT_TERMS, integrator->sun);
  integrator->matrix = um_thermal_linear_matrix(system, integrator->sun);
  if (integrator->y == NULL || integrator->dense == NULL || integrator->quadrature == NULL ||
      integrator->matrix == NULL)
    return fail(integrator, CV_MEM_FAIL);
  UM_TRY(um_thermal_linear_create(system, &integrator->linear));
  integrator->solver =
      um_thermal_linear_sundials(integrator->linear, LINEAR_SHARE, integrator->sun);
  if (system->exchange != NULL)
    integrator->solver = um_thermal_exchange_sundials(
        system, integrator->solver, &integrator->gamma, EXCHANGE_SHARE, integrator->sun);
  if (integrator->solver == NULL) return fail(integrator, CV_MEM_FAIL);
  integrator->cvodes = CVodeCreate(CV_BDF, integrator->sun);
  if (integrator->cvodes == NULL) return fail(integrator, CV_MEM_FAIL);
  return UM_OK;
}

static enum um_status tolerances_set(struct um_thermal_integrator *integrator)
{
  const struct um_thermal_solve_options *options = &integrator->system->options;
  double factor = integrator->tolerance_factor * options->tolerance_factor;
  SUN_CHECK(CVodeSStolerances(integrator->cvodes, factor * options->relative_tolerance,
                              factor * options->absolute_tolerance));
  SUN_CHECK(CVodeSetNonlinConvCoef(integrator->cvodes, factor > 1.0 ? 0.1 : NEWTON_SHARE));
  return UM_OK;
}

static bool switches(const struct um_thermal_system *system)
{
  return system->kind == UM_SYSTEM_RUN && system->nthermostat > 0;
}

/* Settings that need an initialised CVODES. */
static enum um_status cvodes_set_up(struct um_thermal_integrator *integrator)
{
  void *cvodes = integrator->cvodes;
  SUN_CHECK(CVodeSetErrHandlerFn(cvodes, words_keep, integrator));
  SUN_CHECK(CVodeInit(cvodes, rate_callback, 0.0, integrator->y));
  SUN_CHECK(CVodeSetUserData(cvodes, integrator));
  UM_TRY(tolerances_set(integrator));
  SUN_CHECK(CVodeSetLinearSolver(cvodes, integrator->solver, integrator->matrix));
  SUN_CHECK(CVodeSetLinSysFn(cvodes, newton_callback));
  SUN_CHECK(CVodeSetMaxErrTestFails(cvodes, 20));
  SUN_CHECK(CVodeQuadInit(cvodes, audit_callback, integrator->quadrature));
  if (switches(integrator->system)) {
    SUN_CHECK(CVodeRootInit(cvodes, (int)integrator->system->nthermostat, switch_callback));
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
  UM_CHECK(stops_list(integrator, duration));
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
  um_core_free(context, i->stop);
  um_core_free(context, i->cube_before);
  um_core_free(context, i->mean_slope);
  um_core_free(context, i->slope_before);
  um_core_free(context, i->root);
  um_core_free(context, i->heating);
  um_core_free(context, i);
  *integrator = NULL;
}

/* Thermostats as they are from t on, and the crossings to look for. */
static enum um_status thermostats_turn(struct um_thermal_integrator *integrator)
{
  struct um_thermal_system *system = integrator->system;
  if (integrator->switched) {
    if (!um_thermal_system_state_set(system, integrator->t, N_VGetArrayPointer(integrator->y)))
      return fail(integrator, CV_RHSFUNC_FAIL);
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

/* The longest step [s] in the window; 0: no limit. */
static enum um_status step_limit(struct um_thermal_system *system, double *out)
{
  double longest = 0.0, interval = um_thermal_system_heat_interval(system);
  size_t rows;
  for (size_t k = system->row_low; system->loads != NULL && k < system->row_high; k++)
    longest = fmax(longest, system->grid[k + 1] - system->grid[k]);
  UM_TRY(um_thermal_system_smooth(system, &rows));
  longest *= rows == SIZE_MAX ? 0.0 : (double)rows;
  if (isfinite(interval) && (longest == 0.0 || interval < longest)) longest = interval;
  *out = MAX_STEP_INTERVALS * longest;
  return UM_OK;
}

/* Start CVODES at integrator->t up to the next stop. */
static enum um_status segment_start(struct um_thermal_integrator *integrator)
{
  struct um_thermal_system *system = integrator->system;
  double end = integrator->stop[integrator->segment];
  um_thermal_system_window(system, integrator->t, end);
  if (!integrator->initialized) {
    UM_TRY(cvodes_set_up(integrator));
  } else {
    SUN_CHECK(CVodeReInit(integrator->cvodes, integrator->t, integrator->y));
    SUN_CHECK(CVodeQuadReInit(integrator->cvodes, integrator->quadrature));
  }
  if (switches(system)) UM_TRY(thermostats_turn(integrator));
  double longest;
  UM_TRY(step_limit(system, &longest));
  SUN_CHECK(CVodeSetMaxStep(integrator->cvodes, longest));
  SUN_CHECK(CVodeSetStopTime(integrator->cvodes, end));
  return UM_OK;
}

void um_thermal_integrator_loosen(struct um_thermal_integrator *integrator, double factor)
{
  integrator->tolerance_factor = factor;
}

enum um_status um_thermal_integrator_start(struct um_thermal_integrator *integrator,
                                           const double *temperature, double *mean_cube)
{
  struct um_thermal_system *system = integrator->system;
  memcpy(system->temperature, temperature, system->n * sizeof *temperature);
  um_thermal_system_thermostats_set(system, true);
  double *y = N_VGetArrayPointer(integrator->y);
  for (size_t k = 0; k < system->nunknown; k++)
    y[k] = um_thermal_system_unknown_of(system, system->node[k], temperature[system->node[k]]);
  N_VConst(0.0, integrator->quadrature);
  integrator->t = 0.0;
  integrator->segment = 0;
  integrator->mean_cube = mean_cube;
  integrator->run_steps = 0;
  integrator->switched = false;
  UM_TRY(segment_start(integrator));
  UM_TRY(tolerances_set(integrator));
  if (!um_thermal_system_state_set(system, 0.0, y)) {
    integrator->balance_lost = true;
    return fail(integrator, CV_RHSFUNC_FAIL);
  }
  if (mean_cube != NULL) {
    memset(mean_cube, 0, system->n * sizeof *mean_cube);
    memcpy(integrator->cube_before, system->cube, system->n * sizeof *mean_cube);
    for (size_t k = 0; k < system->nthermostat; k++) {
      integrator->mean_slope[k] = 0.0;
      integrator->slope_before[k] = system->thermostat[k].slope;
    }
  }
  return UM_OK;
}

/* Trapezoid of |T|^3 and of thermostats' slopes over the step of length h that just ended. */
static void mean_add(struct um_thermal_integrator *integrator, double h)
{
  struct um_thermal_system *system = integrator->system;
  if (!um_thermal_system_state_set(system, integrator->t, N_VGetArrayPointer(integrator->y)))
    return; /* the next evaluation of the rate reports it */
  for (size_t i = 0; i < system->n; i++) {
    integrator->mean_cube[i] += 0.5 * h * (integrator->cube_before[i] + system->cube[i]);
    integrator->cube_before[i] = system->cube[i];
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
  if (code < 0) return fail(integrator, code);
  UM_TRY(above_zero(integrator));
  integrator->steps++;
  if (++integrator->run_steps > STEPS_LIMIT)
    return um_core_fail(integrator->system->context, UM_ERR_NUMERIC,
                        "heat integration gave up %.3f s after its start: %u steps", integrator->t,
                        STEPS_LIMIT);
  if (integrator->mean_cube != NULL) mean_add(integrator, integrator->t - before);
  if (code == CV_ROOT_RETURN) {
    integrator->switched = true;
    SUN_CHECK(CVodeGetRootInfo(integrator->cvodes, integrator->root));
  }
  if (integrator->t < end && !integrator->switched) return UM_OK;
  realtype at;
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
    return fail(integrator, CV_RHSFUNC_FAIL);
  }
  memcpy(temperature, system->temperature, system->n * sizeof *temperature);
  return UM_OK;
}

void um_thermal_integrator_heating(const struct um_thermal_integrator *integrator, bool *on)
{
  const struct um_thermal_system *system = integrator->system;
  for (size_t k = 0; k < system->nthermostat; k++) on[k] = system->thermostat[k].on;
}

enum um_status um_thermal_integrator_audit(struct um_thermal_integrator *integrator, double *terms,
                                           double *content)
{
  memcpy(terms, N_VGetArrayPointer(integrator->quadrature), UM_AUDIT_TERMS * sizeof *terms);
  *content = um_thermal_system_content(integrator->system, N_VGetArrayPointer(integrator->y));
  return UM_OK;
}

void um_thermal_integrator_counts(const struct um_thermal_integrator *integrator, size_t *steps,
                                  size_t *rhs_evaluations, size_t *jacobians)
{
  *steps = integrator->steps;
  *rhs_evaluations = integrator->rhs_evaluations;
  *jacobians = integrator->jacobians;
}
