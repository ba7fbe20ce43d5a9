/* The quasi-steady orbit: T with G(T) = T, where G maps the state at `from` to the state one period
 * later under the same loads.
 *
 * Plain iteration T <- G(T) is waiting orbit by orbit: a mode of decay rate a leaves exp(-a P) of
 * its error each time, 0.997 for an MLI-wrapped interior. Newton's correction
 *
 *   dT = (I - dG/dT)^-1 r,   r = G(T) - T,   dG/dT ~ exp(P J)
 *
 * with J the orbit mean of the Jacobian (|T|^3 averaged over the orbit, so that fast nodes count
 * with the slope that slow ones feel) needs 1/(1 - exp(-x)) of X = -P J, a rational function of
 * which sparse solves give (orbit_return_group.h). KINSOL's fixed point with Anderson acceleration
 * takes care of what that leaves. The correction dT estimates how far T is from the periodic state,
 * dT - r how far G(T) is, and with it the function's error of r, which may hide as much again.
 *
 * With its correction the last orbit's end is nearer. Of G(T) + (dT - r) is left the function's
 * error of r, and what an error of X does: a share e of it, for a J that is not constant over the
 * orbit and for what radiation bends over dT, at most 3/2 dT / T, moves w = (dT - r)/r = 1/(exp(x)
 * - 1) by e x (1 + w), which is e of a slow mode and e x of a fast one, x = ln(1 + 1/w). Where that
 * is good enough the orbit that would only confirm it is saved. Not with thermostats, of whose
 * slope the correction knows the mean alone: there dT - r is judged. The last end has its
 * correction either way, so that what is left depends little on where the search began.
 *
 * Thermostats act by their mean power (system_heat.c), whose slope, averaged over the orbit, is in
 * J: G is smooth. Seen from outside its narrow transition a thermostat has no slope, so a
 * correction that would carry its sensor through is ended in the middle, where it has its full one.
 *
 * The loads are taken over one window [from, from + P] whatever comes after, so a spin that is not
 * commensurate with the orbit does not keep the iteration from converging: nodes faster than the
 * orbit do not remember T(from), G does not depend on theirs, and they are right after one pass. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <kinsol/kinsol.h>
#include <nvector/nvector_serial.h>

#include "thermal/solver/exchange_solve_group.h"
#include "thermal/solver/integrator_group.h"
#include "thermal/solver/linear_group.h"
#include "thermal/solver/orbit_return_group.h"
#include "thermal/solver/solve.h"
#include "thermal/solver/sundials_impl.h"

#define ORBITS_LIMIT   40
#define ANDERSON_DEPTH 1
#define ANDERSON_DELAY 2    /* plain corrections first, while radiation is far from linear */
#define LARGEST_CHANGE 0.25 /* of a temperature, beyond where the orbit itself leads */
#define ROUGH          0.1  /* [K] down to here orbits are integrated with a factor on tolerances */
#define ROUGH_ORBITS   8    /* after so many the rough stage has done what it can */
#define ROUGH_FACTOR   30.0 /* on the tolerances; a third of the steps */
#define WORTH_A_STAGE  5.0  /* a rough stage with less loosening saves nothing */
#define LINEAR_SHARE   1e-10 /* of a right side that iterated linear solutions leave */
#define EXCHANGE       1e-11 /* the same with exchange between surfaces: slow modes are small in it */
#define FROZEN         0.03 /* of a correction, for a J that is not its mean all along the orbit */
#define SLOW_MODE      1e6  /* w of a mode that an error of X moves in proportion */
#define SLOWEST        1e-6 /* modes slower than 1e6 orbits are taken as that */

struct periodic {
  struct um_thermal_system *system;
  struct um_thermal_integrator *integrator;
  double period; /* [s] */
  SUNContext sun;
  N_Vector y, sum, right, part, one;
  struct um_thermal_linear *linear;
  struct um_thermal_exchange_solver *exchange; /* NULL: none between surfaces */
  void *kinsol;
  double *start, *end;               /* [n] [K] */
  struct um_thermal_integrals means; /* [n] over the orbit [K^3], [K^4] */
  struct um_thermal_audit audit;     /* of the last orbit */
  double *jacobian;                  /* [nnonzero] of the orbit mean [1/s] */
  double *matrix;                    /* [nnonzero] X + shift */
  double distance;                   /* of the last orbit's end [K] */
  double *drift;                     /* [n] over an orbit from the last one's end [K] */
  double wanted;                     /* distance that is good enough [K] */
  size_t orbits;
  enum um_status status;         /* of the callback */
  struct um_thermal_words words; /* of KINSOL */
};

static enum um_status memory_fail(struct periodic *periodic)
{
  return um_core_fail(periodic->system->context, UM_ERR_MEMORY,
                      "out of memory in the periodic heat balance");
}

static enum um_status inner_solve(void *self, size_t count, double *x)
{
  struct periodic *periodic = self;
  return um_thermal_linear_solve(periodic->linear, count, LINEAR_SHARE, x);
}

/* x <- (X + shift)^-1 x by the factors of the matrix. */
static enum um_status factored_solve(struct periodic *periodic, double *x)
{
  const struct um_thermal_inner inner = {inner_solve, periodic};
  if (periodic->exchange == NULL) return inner_solve(periodic, 1, x);
  return um_thermal_exchange_solve(periodic->exchange, &inner, periodic->matrix, periodic->period,
                                   EXCHANGE, NULL, 1, x);
}

/* x = (X + shift)^-1 x, factored. */
static enum um_status shift_factor(struct periodic *periodic, double shift)
{
  const struct um_thermal_system *system = periodic->system;
  for (size_t k = 0; k < system->nnonzero; k++)
    periodic->matrix[k] = -periodic->period * periodic->jacobian[k];
  for (size_t k = 0; k < system->nunknown; k++) periodic->matrix[system->diagonal[k]] += shift;
  return um_thermal_linear_factor(periodic->linear, periodic->matrix);
}

/* sum = r + (X + tiny)^-1 r + sum_k a_k (b (X + b)^-1)^k r of r = right. */
static enum um_status turn_round(struct periodic *periodic)
{
  static const double share[UM_THERMAL_RETURN_TERMS] = {UM_THERMAL_RETURN_SHARES};
  double *part = N_VGetArrayPointer(periodic->part);
  N_VScale(1.0, periodic->right, periodic->part);
  UM_TRY(shift_factor(periodic, SLOWEST));
  UM_TRY(factored_solve(periodic, part));
  N_VLinearSum(1.0, periodic->right, 1.0, periodic->part, periodic->sum);
  N_VScale(1.0, periodic->right, periodic->part);
  UM_TRY(shift_factor(periodic, UM_THERMAL_RETURN_SHIFT));
  for (int k = 0; k < UM_THERMAL_RETURN_TERMS; k++) {
    UM_TRY(factored_solve(periodic, part));
    N_VScale(UM_THERMAL_RETURN_SHIFT, periodic->part, periodic->part);
    N_VLinearSum(1.0, periodic->sum, share[k], periodic->part, periodic->sum);
  }
  return UM_OK;
}

/* Corrections that carry a sensor through its transition end in the middle of it. y: the state. */
static void thermostats_hold(const struct periodic *periodic, const double *y, double *change)
{
  const struct um_thermal_system *system = periodic->system;
  for (size_t k = 0; k < system->nthermostat; k++) {
    const struct um_thermal_network_thermostat *t = system->thermostat[k].thermostat;
    const struct um_thermal_spread *sensor = &t->sensor, *at = &t->at;
    double distance = -0.5 * (t->on + t->off), step = 0.0;
    for (size_t j = 0; j < sensor->n; j++) {
      distance += sensor->weight[j] * y[system->unknown[sensor->node[j]]];
      step += sensor->weight[j] * change[system->unknown[sensor->node[j]]];
    }
    bool inside = fabs(distance) <= UM_THERMAL_TRANSITION * (t->off - t->on);
    if (inside || distance * (distance + step) >= 0.0) continue;
    double share = -distance / step;
    for (size_t j = 0; j < sensor->n; j++) change[system->unknown[sensor->node[j]]] *= share;
    for (size_t i = 0; i < at->n && at->node != sensor->node; i++) {
      bool sensed = false;
      for (size_t j = 0; j < sensor->n; j++) sensed = sensed || sensor->node[j] == at->node[i];
      if (!sensed) change[system->unknown[at->node[i]]] *= share;
    }
  }
}

/* right: r in, the correction dT out. */
static enum um_status correct(struct periodic *periodic)
{
  struct um_thermal_system *system = periodic->system;
  memcpy(system->cube, periodic->means.cube, system->n * sizeof *system->cube);
  const double *slope = um_thermal_integrator_mean_slopes(periodic->integrator);
  for (size_t k = 0; k < system->nthermostat; k++)
    system->thermostat[k].slope = slope[k] / periodic->period;
  if (!um_thermal_system_jacobian(system, periodic->jacobian))
    return um_core_fail(system->context, UM_ERR_NUMERIC,
                        "an arithmetic node finds no balance in the orbit mean");
  if (system->exchange != NULL) um_thermal_system_exchange_hold(system, false);
  double *right = N_VGetArrayPointer(periodic->right); /* J is of the unknowns */
  for (size_t k = 0; k < system->nunknown && system->store != NULL; k++)
    right[k] /= system->warming[system->node[k]];
  char fault[256];
  enum um_status status = turn_round(periodic);
  if (status == UM_ERR_NUMERIC)
    return um_core_fail(system->context, UM_ERR_NUMERIC,
                        "the orbit-mean heat balance cannot be solved: %s",
                        um_thermal_linear_fault(periodic->linear, fault, sizeof fault));
  UM_TRY(status);
  N_VScale(1.0, periodic->sum, periodic->right);
  for (size_t k = 0; k < system->nunknown && system->store != NULL; k++)
    right[k] *= system->warming[system->node[k]];
  return UM_OK;
}

/* What may be left of a node's corrected end [K]; the comment above has the terms. */
static double left_of(double end, double drift, double change)
{
  double beyond = fabs(change - drift), bend = 1.5 * fabs(change) / fmax(end, 10.0);
  double w = beyond / fmax(fabs(drift), DBL_MIN);
  double by_rate = w < SLOW_MODE ? log1p(1.0 / w) * (1.0 + w) : 1.0;
  return UM_THERMAL_RETURN_ERROR * fabs(drift) +
         (FROZEN + bend) * beyond * (w > 0.0 ? by_rate : 0.0);
}

/* Drift over an orbit from a state that is `away`, of a node that drifted by r where it was dT
 * away: r/dT of that, nearly 1 of a fast node and little of a slow one. */
static double next_drift(double away, double drift, double change)
{
  double share = change != 0.0 ? drift / change : 0.0;
  return fmin(fmax(share, 0.0), 1.0) * away;
}

/* The orbit's end with its correction, and its mean, which is as far off where that matters: in
 * nodes that are slower than the orbit. */
static void end_correct(struct periodic *periodic, const double *y, const double *change,
                        bool known)
{
  const struct um_thermal_system *system = periodic->system;
  for (size_t k = 0; k < system->nunknown; k++) {
    uint32_t node = system->node[k];
    double *end = &periodic->end[node], *mean = &periodic->means.power4[node];
    double drift = *end - y[k], beyond = change[k] - drift;
    if (known)
      periodic->drift[node] = next_drift(left_of(*end, drift, change[k]), drift, change[k]);
    *end += beyond;
    *mean = pow(pow(*mean, 0.25) + beyond, 4);
  }
}

/* One orbit from unknowns y; end, drift and the corrected state. */
static enum um_status orbit_run(struct periodic *periodic, const double *y, double *corrected)
{
  struct um_thermal_system *system = periodic->system;
  for (size_t k = 0; k < system->nunknown; k++) periodic->start[system->node[k]] = y[k];
  UM_TRY(um_thermal_integrator_start(periodic->integrator, periodic->start, &periodic->means));
  /* eliminated nodes as they are at the start */
  memcpy(periodic->start, system->temperature, system->n * sizeof *periodic->start);
  UM_TRY(um_thermal_integrator_run(periodic->integrator, periodic->period, periodic->end));
  periodic->audit = um_thermal_integrator_audit(periodic->integrator);
  periodic->orbits++;
  for (size_t i = 0; i < system->n; i++) {
    periodic->means.cube[i] /= periodic->period;
    periodic->means.power4[i] /= periodic->period;
  }
  double *change = N_VGetArrayPointer(periodic->right);
  for (size_t i = 0; i < system->n; i++) periodic->drift[i] = periodic->end[i] - periodic->start[i];
  for (size_t k = 0; k < system->nunknown; k++) change[k] = periodic->drift[system->node[k]];
  UM_TRY(correct(periodic));
  change = N_VGetArrayPointer(periodic->right);
  double factor = 1.0, left = 0.0; /* of the corrected end [K] */
  periodic->distance = 0.0;
  for (size_t k = 0; k < system->nunknown; k++) {
    double limit = LARGEST_CHANGE * fmax(fabs(periodic->end[system->node[k]]), 10.0);
    double drift = periodic->end[system->node[k]] - y[k];
    double beyond = fabs(change[k] - drift);
    periodic->distance = fmax(periodic->distance, beyond + UM_THERMAL_RETURN_ERROR * fabs(drift));
    left = fmax(left, left_of(periodic->end[system->node[k]], drift, change[k]));
    periodic->drift[system->node[k]] = next_drift(change[k] - drift, drift, change[k]);
    if (beyond * factor > limit) factor = limit / beyond;
  }
  for (size_t k = 0; k < system->nunknown; k++) {
    double drift = periodic->end[system->node[k]] - y[k];
    change[k] = drift + factor * (change[k] - drift);
  }
  thermostats_hold(periodic, y, change);
  bool known = left <= periodic->wanted && factor == 1.0 && system->nthermostat == 0;
  if (known || periodic->distance <= periodic->wanted) end_correct(periodic, y, change, known);
  if (known) periodic->distance = left;
  /* good enough: a fixed point, which ends KINSOL's iteration */
  double take = periodic->distance <= periodic->wanted ? 0.0 : 1.0;
  for (size_t k = 0; k < system->nunknown; k++) corrected[k] = y[k] + take * change[k];
  return UM_OK;
}

static int orbit_callback(N_Vector y, N_Vector corrected, void *self)
{
  struct periodic *periodic = self;
  periodic->status = um_core_stop_check(periodic->system->context, "the periodic orbit was sought");
  if (periodic->status != UM_OK) return -1;
  periodic->status = orbit_run(periodic, N_VGetArrayPointer(y), N_VGetArrayPointer(corrected));
  if (periodic->status == UM_OK)
    periodic->status = um_core_progress_step(periodic->system->context, 1);
  return periodic->status == UM_OK ? 0 : -1;
}

static enum um_status storage_create(struct periodic *periodic)
{
  struct um_thermal_system *system = periodic->system;
  struct um_context *context = system->context;
  UM_TRY(um_core_allocate(context, system->n, sizeof(double), &periodic->start));
  UM_TRY(um_core_allocate(context, system->n, sizeof(double), &periodic->end));
  UM_TRY(um_core_allocate(context, system->n, sizeof(double), &periodic->drift));
  UM_TRY(um_core_allocate(context, system->n, sizeof(double), &periodic->means.cube));
  UM_TRY(um_core_allocate(context, system->n, sizeof(double), &periodic->means.power4));
  UM_TRY(um_core_allocate(context, system->nnonzero, sizeof(double), &periodic->jacobian));
  UM_TRY(um_core_allocate(context, system->nnonzero, sizeof(double), &periodic->matrix));
  if (SUNContext_Create(SUN_COMM_NULL, &periodic->sun) != 0) return memory_fail(periodic);
  sunindextype n = (sunindextype)system->nunknown;
  N_Vector *const vectors[5] = {&periodic->y, &periodic->sum, &periodic->right, &periodic->part,
                                &periodic->one};
  for (int k = 0; k < 5; k++) {
    *vectors[k] = N_VNew_Serial(n, periodic->sun);
    if (*vectors[k] == NULL) return memory_fail(periodic);
  }
  UM_TRY(um_thermal_linear_create(system, &periodic->linear));
  if (system->exchange != NULL)
    UM_TRY(um_thermal_exchange_solver_create(system, 1, &periodic->exchange));
  periodic->kinsol = KINCreate(periodic->sun);
  return periodic->kinsol != NULL ? UM_OK : memory_fail(periodic);
}

static void storage_free(struct periodic *periodic, struct um_context *context)
{
  if (periodic->kinsol != NULL) KINFree(&periodic->kinsol);
  um_thermal_exchange_solver_destroy(&periodic->exchange);
  um_thermal_linear_destroy(&periodic->linear);
  if (periodic->y != NULL) N_VDestroy(periodic->y);
  if (periodic->sum != NULL) N_VDestroy(periodic->sum);
  if (periodic->right != NULL) N_VDestroy(periodic->right);
  if (periodic->part != NULL) N_VDestroy(periodic->part);
  if (periodic->one != NULL) N_VDestroy(periodic->one);
  if (periodic->sun != NULL) SUNContext_Free(&periodic->sun);
  UM_FREE(context, periodic->start, periodic->end, periodic->drift, periodic->means.cube,
          periodic->means.power4, periodic->jacobian, periodic->matrix);
  um_thermal_integrator_destroy(&periodic->integrator);
  um_thermal_system_destroy(&periodic->system);
}

static struct um_thermal_periodic report_make(const struct periodic *periodic)
{
  struct um_thermal_periodic report = {
      .distance = periodic->distance, .orbits = periodic->orbits, .audit = periodic->audit};
  for (size_t i = 0; i < periodic->system->n; i++) {
    double drift = fabs(periodic->drift[i]);
    if (drift > report.drift) {
      report.drift = drift;
      report.drift_node = i;
    }
  }
  return report;
}

static enum um_status not_converged(struct periodic *periodic, double tolerance, int code)
{
  const struct um_thermal_system *system = periodic->system;
  struct um_thermal_periodic report = report_make(periodic);
  const struct um_thermal_solve_options *options = &system->options;
  /* of one step; one orbit cannot be told from another better than that */
  double step = options->relative_tolerance * 300.0 + options->absolute_tolerance;
  char label[96];
  um_thermal_network_label(system->network, (uint32_t)report.drift_node, label, sizeof label);
  return um_core_fail(
      system->context, UM_ERR_NUMERIC,
      "no periodic state after %zu orbits: %.3g K away, %s drifts %.3g K per orbit; "
      "wanted %.3g K, integrated to %.2g K a step (KINSOL code %d%s%s)",
      periodic->orbits, periodic->distance, label, report.drift, tolerance, step, code,
      periodic->words.text[0] != '\0' ? ": " : "", periodic->words.text);
}

/* Toward a fixed point within `wanted` [K], with integration tolerances times `tolerance_factor`,
 * in at most `orbits` iterations. KINSOL judges its mixed iterate, we the distance: go on until
 * that is small. *code: KINSOL's last. */
static enum um_status approach(struct periodic *periodic, double wanted, double tolerance_factor,
                               size_t orbits, int *code)
{
  size_t last = periodic->orbits + orbits;
  periodic->wanted = wanted;
  periodic->distance = INFINITY;
  um_thermal_integrator_loosen(periodic->integrator, tolerance_factor);
  *code = KINSetFuncNormTol(periodic->kinsol, wanted);
  while (*code >= 0 && !(periodic->distance <= wanted) && periodic->orbits < last) {
    *code = KINSetNumMaxIters(periodic->kinsol, (long)(last - periodic->orbits));
    if (*code >= 0)
      *code = KINSol(periodic->kinsol, periodic->y, KIN_FP, periodic->one, periodic->one);
    if (periodic->status != UM_OK) return periodic->status;
  }
  return UM_OK;
}

/* Within half of the narrowest band a state that its heaters hold is as good as their cycling. */
static bool thermostats_excuse(const struct periodic *periodic, double tolerance)
{
  const struct um_thermal_system *system = periodic->system;
  double band = INFINITY;
  for (size_t k = 0; k < system->nthermostat; k++)
    band = fmin(band, system->thermostat[k].thermostat->off - system->thermostat[k].thermostat->on);
  if (!isfinite(band) || !(periodic->distance <= 0.5 * band)) return false;
  um_core_log(
      system->context, UM_LOG_INFO,
      "the periodic state is met to %.3g K instead of %.3g K: half the band of a thermostat "
      "is %.3g K",
      periodic->distance, tolerance, 0.5 * band);
  return true;
}

static enum um_status kinsol_run(struct periodic *periodic, double tolerance)
{
  const struct um_thermal_system *system = periodic->system;
  void *kinsol = periodic->kinsol;
  double *y = N_VGetArrayPointer(periodic->y);
  for (size_t k = 0; k < system->nunknown; k++) y[k] = periodic->start[system->node[k]];
  N_VConst(1.0, periodic->one);
  int code = um_thermal_words_of_kinsol(kinsol, periodic->sun, &periodic->words);
  if (code >= 0) code = KINSetMAA(kinsol, ANDERSON_DEPTH);
  if (code >= 0) code = KINInit(kinsol, orbit_callback, periodic->y);
  if (code >= 0) code = KINSetDelayAA(kinsol, ANDERSON_DELAY);
  if (code >= 0) code = KINSetUserData(kinsol, periodic);
  if (code < 0) return not_converged(periodic, tolerance, code);
  double rough = ROUGH_FACTOR / system->options.tolerance_factor;
  if (tolerance < ROUGH && rough >= WORTH_A_STAGE) {
    UM_TRY(approach(periodic, ROUGH, rough, ROUGH_ORBITS, &code));
    /* where it ends its last correction is not made yet */
    if (periodic->distance <= ROUGH)
      N_VLinearSum(1.0, periodic->y, 1.0, periodic->right, periodic->y);
  }
  UM_TRY(approach(periodic, tolerance, 1.0, ORBITS_LIMIT, &code));
  if (periodic->distance <= tolerance || thermostats_excuse(periodic, tolerance)) return UM_OK;
  return not_converged(periodic, tolerance, code);
}

static enum um_status arguments_check(struct um_context *context,
                                      const struct um_irradiation_loads *loads, double from,
                                      double period, double tolerance)
{
  if (!(period > 0.0) || !isfinite(period) || !isfinite(from))
    return um_core_fail(
        context, UM_ERR_INPUT,
        "periodic heat run from %g s over %g s; accepted: finite, period more than 0", from,
        period);
  if (!(tolerance > 0.0) || !isfinite(tolerance))
    return um_core_fail(context, UM_ERR_INPUT,
                        "periodic heat run: tolerance %g K; accepted: more than 0", tolerance);
  /* the end of an orbit may be rounded past the last row */
  if (loads != NULL && loads->ntime > 0 &&
      !(loads->t[0] <= from && from + period <= loads->t[loads->ntime - 1] + 1e-3))
    return um_core_fail(context, UM_ERR_INPUT,
                        "periodic heat run from %.6f to %.6f s; accepted: inside its loads, %.6f "
                        "to %.6f s",
                        from, from + period, loads->t[0], loads->t[loads->ntime - 1]);
  return UM_OK;
}

enum um_status um_thermal_solve_periodic_report(
    struct um_context *context, const struct um_thermal_network *network,
    const struct um_irradiation_loads *loads, const struct um_thermal_solve_options *options,
    const double *start, double from, double period, double tolerance, double *temperature,
    double *drift, double *mean, struct um_thermal_periodic *report)
{
  enum um_status status;
  struct periodic periodic = {.period = period};
  UM_TRY(arguments_check(context, loads, from, period, tolerance));
  um_core_progress_begin(context, "orbits until one repeats", 0); /* as many as it takes */
  UM_CHECK(um_thermal_system_create(context, network, loads, options, start, from,
                                    UM_SYSTEM_PERIODIC, &periodic.system));
  UM_CHECK(um_thermal_integrator_create(periodic.system, period, &periodic.integrator));
  UM_CHECK(storage_create(&periodic));
  size_t n = periodic.system->n;
  memcpy(periodic.start, periodic.system->temperature, n * sizeof(double));
  UM_CHECK(kinsol_run(&periodic, tolerance));
  memcpy(temperature, periodic.end, n * sizeof(double));
  for (size_t i = 0; i < n && mean != NULL; i++) mean[i] = pow(periodic.means.power4[i], 0.25);
  for (size_t i = 0; i < n && drift != NULL; i++) drift[i] = periodic.drift[i];
  if (report != NULL) *report = report_make(&periodic);
done:
  um_core_progress_end(context);
  if (periodic.system != NULL) storage_free(&periodic, context);
  return status;
}

enum um_status um_thermal_solve_periodic(struct um_context *context,
                                         const struct um_thermal_network *network,
                                         const struct um_irradiation_loads *loads,
                                         const struct um_thermal_solve_options *options,
                                         const double *start, double from, double period,
                                         double tolerance, double *temperature, double *drift)
{
  struct um_thermal_periodic report;
  UM_TRY(um_thermal_solve_periodic_report(context, network, loads, options, start, from, period,
                                          tolerance, temperature, NULL, NULL, &report));
  *drift = report.distance;
  return UM_OK;
}
