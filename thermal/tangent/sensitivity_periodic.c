/* Sensitivities of the periodic state, S(0) = S(P), sought as in periodic.c: with r = S(P) - S(0)
 * and X = -P J of the orbit's mean, S(0) takes the rational function of orbit_return_group.h of r,
 * which leaves what J does within the orbit. S(P) is linear in S(0): only the first orbit has the
 * forcing, the others follow what was taken, to a tenth of its size. */
#include <math.h>
#include <string.h>

#include "thermal/solver/orbit_return_group.h"
#include "thermal/tangent/sensitivity_impl.h"

#define TOLERANCE    2e-5
#define ORBITS       20
#define COARSE       0.02 /* tolerance of an orbit that follows a correction */
#define SLOWEST      1e-6 /* modes slower than 1e6 orbits are taken as that */
#define FROZEN       0.02 /* of a correction, for a J that is not its mean all along the orbit */
#define LINEAR_SHARE 1e-8 /* of a right side that iterated linear solutions leave */

struct periodic {
  struct um_thermal_sensitivity_run run;
  double period;
  double *cube, *slope; /* orbit sums, then means */
  double *total;        /* [ncolumn][n] S(0) found so far */
  double *taken;        /* [ncolumn][n] what the present orbit starts with */
  double *left, *part;  /* [ncolumn][n] S(P) - S(0), scratch */
};

/* part = (X + shift)^-1 part, of a matrix to be factored, and again. */
static enum um_status shift_factor(struct periodic *p, double shift)
{
  struct um_thermal_sensitivity_run *r = &p->run;
  for (size_t k = 0; k < r->system->nnonzero; k++) r->matrix[k] = -p->period * r->jacobian[k];
  for (size_t k = 0; k < r->n; k++) r->matrix[r->system->diagonal[k]] += shift;
  return um_thermal_linear_factor(r->linear, r->matrix);
}
static enum um_status factored_solve(struct periodic *p)
{
  return um_thermal_sensitivity_solve(&p->run, p->period, LINEAR_SHARE, NULL, p->part);
}

/* taken = r + (X + tiny)^-1 r + sum_k a_k (b (X + b)^-1)^k r. */
static enum um_status turn_round(struct periodic *p)
{
  static const double share[UM_THERMAL_RETURN_TERMS] = {UM_THERMAL_RETURN_SHARES};
  size_t count = p->run.ncolumn * p->run.n;
  memcpy(p->part, p->left, count * sizeof *p->part);
  UM_TRY(shift_factor(p, SLOWEST));
  UM_TRY(factored_solve(p));
  for (size_t k = 0; k < count; k++) p->taken[k] = p->left[k] + p->part[k];
  memcpy(p->part, p->left, count * sizeof *p->part);
  UM_TRY(shift_factor(p, UM_THERMAL_RETURN_SHIFT));
  for (int term = 0; term < UM_THERMAL_RETURN_TERMS; term++) {
    UM_TRY(factored_solve(p));
    for (size_t k = 0; k < count; k++) {
      p->part[k] *= UM_THERMAL_RETURN_SHIFT;
      p->taken[k] += share[term] * p->part[k];
    }
  }
  return UM_OK;
}

static enum um_status correct(struct periodic *p)
{
  struct um_thermal_sensitivity_run *r = &p->run;
  char fault[256];
  memcpy(r->system->cube, p->cube, r->system->n * sizeof *p->cube);
  for (size_t k = 0; k < r->system->nthermostat; k++) r->system->thermostat[k].slope = p->slope[k];
  if (!um_thermal_system_jacobian(r->system, r->jacobian))
    return um_core_fail(r->context, UM_ERR_NUMERIC,
                        "an arithmetic node finds no balance in the orbit mean");
  if (r->exchange != NULL) um_thermal_system_exchange_hold(r->system, false);
  enum um_status status = turn_round(p);
  if (status != UM_ERR_NUMERIC || um_core_message(r->context)[0] != '\0') return status;
  return um_core_fail(r->context, UM_ERR_NUMERIC, "periodic heat sensitivities: %s",
                      um_thermal_linear_fault(r->linear, fault, sizeof fault));
}

/* One orbit from `taken`; left = S(P) - S(0) in all: the first time that of S(0) = taken with the
 * forcing, then what is left of it and of what was taken. */
static enum um_status orbit(struct periodic *p, bool first)
{
  struct um_thermal_sensitivity_run *r = &p->run;
  size_t count = r->ncolumn * r->n;
  memcpy(r->s, p->taken, count * sizeof *r->s);
  for (size_t c = 0; c < r->ncolumn; c++) r->largest[c] = um_thermal_sensitivity_size(r, r->s, c);
  r->forced = first;
  if (first) {
    r->mean_cube = p->cube;
    r->mean_slope = p->slope;
  }
  UM_TRY(um_thermal_sensitivity_follow(r, p->period));
  for (size_t i = 0; i < r->system->n && first; i++) p->cube[i] /= p->period;
  for (size_t k = 0; k < r->system->nthermostat && first; k++) p->slope[k] /= p->period;
  r->mean_cube = NULL;
  for (size_t k = 0; k < count; k++) {
    p->total[k] += p->taken[k];
    p->left[k] = (first ? 0.0 : p->left[k]) + r->s[k] - p->taken[k];
  }
  return UM_OK;
}

/* Largest of what a correction takes beyond what is left, over the answer's size, of any column:
 * the distance of S(P) from the periodic answer. With the correction, FROZEN of that is left: its
 * own distance was 0.009 of the one before on ENVISAT's orbit. */
static double distance(const struct periodic *p)
{
  const struct um_thermal_sensitivity_run *r = &p->run;
  double worst = 0.0;
  for (size_t c = 0; c < r->ncolumn; c++) {
    double largest = 0.0, beyond = 0.0;
    for (size_t k = c * r->n; k < (c + 1) * r->n; k++) {
      largest = fmax(largest, fabs(p->total[k]));
      beyond = fmax(beyond, fabs(p->taken[k] - p->left[k]));
    }
    if (beyond > 0.0) worst = fmax(worst, beyond / fmax(largest, beyond));
  }
  return worst;
}

static enum um_status periodic_find(struct periodic *p, double tolerance)
{
  struct um_thermal_sensitivity_run *r = &p->run;
  size_t count = r->ncolumn * r->n;
  double away = INFINITY;
  r->tolerance = tolerance;
  for (int k = 0; k < ORBITS; k++) {
    UM_TRY(orbit(p, k == 0));
    UM_TRY(correct(p));
    away = distance(p);
    if (FROZEN * away <= tolerance) {
      for (size_t i = 0; i < count; i++) p->total[i] += p->taken[i];
      return UM_OK;
    }
    /* what is followed need only be known to a share of itself */
    r->tolerance = fmin(COARSE, fmax(tolerance, 0.1 * tolerance / away));
  }
  return um_core_fail(r->context, UM_ERR_NUMERIC,
                      "no periodic heat sensitivities after %d orbits: %.3g of the answer away, "
                      "wanted %.3g",
                      ORBITS, away, tolerance);
}

static enum um_status periodic_storage(struct periodic *p)
{
  const struct um_thermal_sensitivity_run *r = &p->run;
  double **const all[4] = {&p->total, &p->taken, &p->left, &p->part};
  for (int k = 0; k < 4; k++)
    UM_TRY(um_core_allocate(r->context, r->ncolumn, r->n * sizeof(double), all[k]));
  UM_TRY(um_core_allocate(r->context, r->system->n, sizeof(double), &p->cube));
  return um_core_allocate(r->context, r->system->nthermostat, sizeof(double), &p->slope);
}

enum um_status um_thermal_sensitivity_periodic(
    struct um_context *context, const struct um_thermal_network *network,
    const struct um_irradiation_loads *loads, const struct um_thermal_solve_options *options,
    const double *start, double from, double period, const struct um_thermal_variant *variant,
    size_t nvariant, const struct um_thermal_sensitivity_options *how, double *sensitivity)
{
  enum um_status status;
  struct periodic p = {.run = {.context = context}, .period = period};
  struct um_thermal_sensitivity_run *r = &p.run;
  const struct um_thermal_sensitivity_subject of = {context, network, loads, options, start, from};
  const struct um_thermal_forcings forcings = {.variant = variant, .nvariant = nvariant};
  double tolerance = how != NULL && how->tolerance > 0.0 ? how->tolerance : TOLERANCE;
  if (!(period > 0.0) || !isfinite(period) || !isfinite(from))
    return um_core_fail(context, UM_ERR_INPUT,
                        "periodic heat sensitivities from %g s over %g s; accepted: finite, period "
                        "more than 0",
                        from, period);
  UM_TRY(um_thermal_sensitivity_check(&of, &forcings, how));
  UM_CHECK(um_thermal_sensitivity_run_create(&of, &forcings, UM_SYSTEM_PERIODIC, period, r));
  UM_CHECK(periodic_storage(&p));
  for (size_t c = 0; c < nvariant && how != NULL && how->start != NULL; c++)
    for (size_t k = 0; k < r->n; k++)
      p.taken[c * r->n + k] = how->start[c * r->system->n + r->system->node[k]] /
                              um_thermal_system_warming(r->system, r->system->node[k]);
  UM_CHECK(periodic_find(&p, tolerance));
  r->forced = true;
  for (size_t k = 0; k < r->n; k++) {
    size_t i = r->system->node[k];
    r->y[k] = um_thermal_system_unknown_of(r->system, i, r->system->first[i]);
  }
  um_thermal_system_window(r->system, 0.0, period);
  for (size_t c = 0; c < nvariant; c++) um_thermal_system_window(r->variant[c], 0.0, period);
  UM_CHECK(um_thermal_sensitivity_nodes(r, 0.0, p.total, sensitivity));
done:
  um_core_free(context, p.total);
  um_core_free(context, p.taken);
  um_core_free(context, p.left);
  um_core_free(context, p.part);
  um_core_free(context, p.cube);
  um_core_free(context, p.slope);
  um_thermal_sensitivity_run_free(r);
  return status;
}
