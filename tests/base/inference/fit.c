/* Fits whose answers are known: certified problems, closed forms of linear models with bounds and
 * priors, what a fit may cost, and models that refuse. */
#include "base/inference/fit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "nist_test.h"
#include "tests/base/inference/observations_test.h"
#include "tests/support/memory_sweep.h"
#include "tests/support/with_context.h"

#define ROWS 12

static enum um_status nist_evaluate(struct um_context *c, void *user, const double *x,
                                    double *value)
{
  const struct nist_problem *p = user;
  (void)c;
  for (size_t i = 0; i < p->nobservation; i++) value[i] = p->model(x, p->x[i]);
  return UM_OK;
}

struct nist_room {
  struct um_inference_fit_parameter parameter[NIST_PARAMETERS_MAX];
  double sigma[NIST_ROWS_MAX];
};

/* A certified problem from one of its starts, every observation with this sigma; in `room`. */
static struct um_inference_fit_problem nist_problem_of(const struct nist_problem *p, size_t from,
                                                       double sigma, struct nist_room *room)
{
  for (size_t i = 0; i < p->nobservation; i++) room->sigma[i] = sigma;
  for (size_t j = 0; j < p->nparameter; j++)
    room->parameter[j] = (struct um_inference_fit_parameter){
        p->start[from][j], -INFINITY, INFINITY, 0.0, INFINITY, 1e-8 * fabs(p->start[from][j])};
  return (struct um_inference_fit_problem){.nobservation = p->nobservation,
                                           .nparameter = p->nparameter,
                                           .measured = p->y,
                                           .sigma = room->sigma,
                                           .parameter = room->parameter,
                                           .evaluate = nist_evaluate,
                                           .user = (void *)p,
                                           .iterations_max = 500};
}

/* sigma of an observation: the certified residual deviation s makes the sigma of a parameter the
 * certified one; s / 1e4 makes the end of the fit, 0.03 sigma still to be gained and as much that a
 * Jacobian which still serves may hide, 6e-6 of the certified deviation. */
static void solve_nist(struct um_context *c, const struct nist_problem *p, size_t from,
                       double finer)
{
  double s = sqrt(p->squares / (double)(p->nobservation - p->nparameter));
  struct nist_room room;
  struct um_inference_fit *fit;
  struct um_inference_fit_problem problem = nist_problem_of(p, from, s / finer, &room);
  problem.tolerance = 1e-3 / (finer * finer);
  assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_OK);
  double digits = 20.0;
  for (size_t j = 0; j < p->nparameter; j++)
    digits = fmin(digits, -log10(fabs(fit->x[j] / p->certified[j] - 1.0) + 1e-20));
  print_message("%s from start %zu: %.1f digits, %zu steps, %zu evaluations\n", p->name, from + 1,
                digits, fit->iterations, fit->evaluations);
  assert_true(fit->converged);
  assert_close(fit->chi2 * s * s / finer / finer / p->squares, 1.0, 1e-9);
  for (size_t j = 0; j < p->nparameter; j++) {
    assert_close((fit->x[j] - p->certified[j]) / p->deviation[j], 0.0, 6e-6);
    /* the last Jacobian was made or moved within such a distance, too short for it to bend */
    assert_close(fit->sigma[j] * finer / p->deviation[j], 1.0, 1e-4);
  }
  um_inference_fit_destroy(c, &fit);
}

/* A certified problem that has to come below half its least sum of squares is pruned on the way;
 * one that has to come below twice that ends where it does without being asked. None comes below
 * 0. */
static void test_beaten(void **state)
{
  struct um_context *c = *state;
  const struct nist_problem *p = &nist[0];
  double free_of[NIST_PARAMETERS_MAX],
      s = sqrt(p->squares / (double)(p->nobservation - p->nparameter));
  struct nist_room room;
  struct um_inference_fit_problem problem = nist_problem_of(p, 0, s, &room);
  size_t evaluations = 0;
  problem.tolerance = 1e-6;
  const double asked[] = {INFINITY, 2.0, 0.5, 0.0, -1.0}; /* of the least */
  for (size_t k = 0; k < sizeof asked / sizeof *asked; k++) {
    struct um_inference_fit *fit;
    problem.prunes = isfinite(asked[k]);
    problem.prune_above = asked[k] * p->squares / (s * s);
    assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_OK);
    print_message("asked for %g of the least: %zu evaluations\n", asked[k], fit->evaluations);
    assert_int_equal(fit->converged, k < 2);
    if (k == 0) {
      memcpy(free_of, fit->x, p->nparameter * sizeof *free_of);
      evaluations = fit->evaluations;
    }
    for (size_t j = 0; j < p->nparameter && k == 1; j++) assert_close(fit->x[j], free_of[j], 0.0);
    if (k == 1) assert_int_equal(fit->evaluations, evaluations);
    if (k >= 2) assert_true(fit->evaluations < evaluations);
    um_inference_fit_destroy(c, &fit);
  }
}

/* What was packed comes back as it was. */
static void test_packed(void **state)
{
  struct um_context *c = *state;
  const struct nist_problem *p = &nist[0];
  struct nist_room room;
  struct um_inference_fit_problem problem = nist_problem_of(p, 0, 1.0, &room);
  struct um_inference_fit *fit, *back;
  const size_t n = p->nparameter, m = p->nobservation;
  double *numbers = calloc(um_inference_fit_packed(m, n) + 1, sizeof *numbers);
  assert_non_null(numbers);
  assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_OK);
  fit->at_bound[n - 1] = true;
  numbers[um_inference_fit_packed(m, n)] = -7.0;
  um_inference_fit_pack(fit, numbers);
  assert_true(numbers[um_inference_fit_packed(m, n)] == -7.0); /* no further */
  assert_int_equal(um_inference_fit_unpack(c, numbers, m, n, &back), UM_OK);
  assert_true(back->chi2 == fit->chi2 && back->bic == fit->bic);
  assert_true(back->evaluations == fit->evaluations && back->converged == fit->converged);
  assert_memory_equal(back->x, fit->x, n * sizeof *fit->x);
  assert_memory_equal(back->sigma, fit->sigma, n * sizeof *fit->sigma);
  assert_memory_equal(back->covariance, fit->covariance, n * n * sizeof *fit->covariance);
  assert_memory_equal(back->at_bound, fit->at_bound, n * sizeof *fit->at_bound);
  assert_memory_equal(back->value, fit->value, m * sizeof *fit->value);
  assert_memory_equal(back->residual, fit->residual, m * sizeof *fit->residual);
  assert_memory_equal(back->jacobian, fit->jacobian, n * m * sizeof *fit->jacobian);
  um_inference_fit_destroy(c, &back);
  um_inference_fit_destroy(c, &fit);
  free(numbers);
}

static void test_certified(void **state)
{
  for (size_t k = 0; k < sizeof nist / sizeof *nist; k++)
    for (size_t from = nist[k].flat_start; from < 2; from++)
      solve_nist(*state, &nist[k], from, 1e4);
}

/* Linear models value = sum_j x_j a_j with what a test wants to know and to happen. */
struct linear {
  size_t n, calls;
  double column[4][ROWS], y[ROWS], sigma[ROWS];
  double refuse_above; /* value of x[0] that the model refuses; 0: none */
  double bend;         /* x[0]^2 bend beside x[0] */
  const struct um_inference_fit_parameter *parameter;
  bool left; /* asked outside its bounds */
  enum um_status with;
};

static enum um_status evaluate(struct um_context *c, void *user, const double *x, double *value)
{
  struct linear *l = user;
  l->calls++;
  for (size_t j = 0; j < l->n; j++)
    l->left |= !(x[j] >= l->parameter[j].minimum && x[j] <= l->parameter[j].maximum);
  if (l->refuse_above != 0.0 && x[0] > l->refuse_above)
    return um_core_fail(c, l->with, "the model refuses %g", x[0]);
  for (size_t i = 0; i < ROWS; i++) {
    value[i] = 0.0;
    for (size_t j = 0; j < l->n; j++) value[i] += x[j] * l->column[j][i];
    if (l->n > 0) value[i] += l->bend * x[0] * x[0] * l->column[0][i];
  }
  return UM_OK;
}

static struct linear linear_model(size_t n)
{
  struct linear l = {.n = n, .with = UM_ERR_REFUSED};
  for (size_t i = 0; i < ROWS; i++) {
    double t = (double)i / (ROWS - 1);
    l.column[0][i] = 1.0;
    l.column[1][i] = t;
    l.column[2][i] = t * t;
    l.column[3][i] = -2.0 * t;
    l.sigma[i] = 0.2 + 0.1 * (double)(i % 3);
    l.y[i] = 2.0 + 3.0 * t + l.sigma[i] * rows_normal(31, i);
  }
  return l;
}

static struct um_inference_fit_problem problem_of(struct linear *l,
                                                  const struct um_inference_fit_parameter *p)
{
  l->parameter = p;
  return (struct um_inference_fit_problem){.nobservation = ROWS,
                                           .nparameter = l->n,
                                           .measured = l->y,
                                           .sigma = l->sigma,
                                           .parameter = p,
                                           .evaluate = evaluate,
                                           .user = l};
}

/* Whitened columns and observations, for the normal equations. */
static void whiten(const struct linear *l, double column[4][ROWS], double y[ROWS])
{
  for (size_t i = 0; i < ROWS; i++) {
    for (size_t j = 0; j < 4; j++) column[j][i] = l->column[j][i] / l->sigma[i];
    y[i] = l->y[i] / l->sigma[i];
  }
}

static const struct um_inference_fit_parameter FREE = {0.0, -INFINITY, INFINITY,
                                                       0.0, INFINITY,  0.1};

/* What is known to be linear is pruned without an evaluation, whatever the length of its column;
 * where it comes below what is asked, it is fitted as ever. */
static void test_sure(void **state)
{
  struct um_context *c = *state;
  struct linear l = linear_model(1);
  const struct um_inference_fit_parameter p = FREE;
  double none[ROWS] = {0.0}, half[ROWS], first = 0.0;
  struct um_inference_fit *fit;
  struct um_inference_fit_problem problem = problem_of(&l, &p);
  assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_OK);
  double least = fit->chi2, x = fit->x[0];
  um_inference_fit_destroy(c, &fit);
  for (size_t i = 0; i < ROWS; i++) {
    half[i] = 0.5 * l.column[0][i];
    first += pow(l.y[i] / l.sigma[i], 2);
  }
  problem.value = none;
  problem.jacobian = half;
  problem.prunes = problem.sure = true;
  for (int below = 0; below < 2; below++) {
    l.calls = 0;
    problem.prune_above = below ? least + 0.5 : least - 0.1 * (first - least);
    assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_OK);
    assert_int_equal(fit->converged, below);
    assert_int_equal(l.calls > 0, below);
    if (below) assert_close(fit->x[0], x, 1e-6);
    um_inference_fit_destroy(c, &fit);
  }
}

/* One parameter of a prior in a linear model: posterior precision w + 1/s^2, mean by precisions
 * (conjugate normal). Three parameters: the normal equations. Tolerance: one Gauss-Newton step with
 * differences of a linear model, rounding over the step. */
static void test_priors(void **state)
{
  struct um_context *c = *state;
  struct linear l = linear_model(3);
  struct um_inference_fit_parameter p[3] = {FREE, FREE, FREE};
  struct um_inference_fit *fit;
  double column[4][ROWS], y[ROWS], x[4], variance[4];
  const double width[3] = {INFINITY, 0.3, 0.1}, mean[3] = {0.0, 4.0, -1.0};
  whiten(&l, column, y);
  double least = rows_normal_equations(ROWS, 3, column[0], y, width, mean, x, variance);
  for (size_t j = 0; j < 3; j++) p[j].prior_sigma = width[j], p[j].prior_mean = mean[j];
  struct um_inference_fit_problem problem = problem_of(&l, p);
  assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_OK);
  assert_true(fit->converged);
  assert_close(fit->chi2 + fit->chi2_prior, least, 1e-9);
  assert_close(fit->bic, least + 3.0 * log(ROWS), 1e-9);
  for (size_t j = 0; j < 3; j++) {
    assert_close(fit->x[j], x[j], 1e-9);
    assert_close(fit->sigma[j], sqrt(variance[j]), 1e-9);
    assert_close(fit->covariance[4 * j], variance[j], 1e-9);
  }
  for (size_t i = 0; i < ROWS; i++)
    assert_close(fit->residual[i], (l.y[i] - fit->value[i]) / l.sigma[i], 1e-12);
  um_inference_fit_destroy(c, &fit);

  l.n = 1;
  double precision = 1.0 / (0.05 * 0.05), weighted = precision * 1.5;
  for (size_t i = 0; i < ROWS; i++) {
    precision += 1.0 / (l.sigma[i] * l.sigma[i]);
    weighted += l.y[i] / (l.sigma[i] * l.sigma[i]);
  }
  p[0].prior_mean = 1.5;
  p[0].prior_sigma = 0.05;
  problem = problem_of(&l, p);
  assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_OK);
  assert_close(fit->x[0], weighted / precision, 1e-9);
  assert_close(fit->sigma[0], 1.0 / sqrt(precision), 1e-9);
  um_inference_fit_destroy(c, &fit);
}

/* The slope may be 1 at most and wants 3: it ends at 1 exactly, and the offset is the weighted mean
 * of what is left, its sigma that of a weighted mean. The model is never asked beyond. */
static void test_bounds(void **state)
{
  struct um_context *c = *state;
  struct linear l = linear_model(2);
  struct um_inference_fit_parameter p[2] = {FREE, FREE};
  struct um_inference_fit *fit;
  p[1].start = 0.3;
  p[1].minimum = 0.0;
  p[1].maximum = 1.0;
  double precision = 0.0, weighted = 0.0;
  for (size_t i = 0; i < ROWS; i++) {
    precision += 1.0 / (l.sigma[i] * l.sigma[i]);
    weighted += (l.y[i] - l.column[1][i]) / (l.sigma[i] * l.sigma[i]);
  }
  struct um_inference_fit_problem problem = problem_of(&l, p);
  for (int from = 0; from < 3; from++) { /* inside, on the wrong bound, on the right one */
    p[1].start = from == 0 ? 0.3 : from == 1 ? 0.0 : 1.0;
    assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_OK);
    assert_true(fit->converged && fit->at_bound[1] && !fit->at_bound[0] && !l.left);
    assert_close(fit->x[1], 1.0, 0.0);
    assert_close(fit->x[0], weighted / precision, 1e-9);
    assert_close(fit->sigma[0], 1.0 / sqrt(precision), 1e-9);
    assert_true(isnan(fit->sigma[1]));
    um_inference_fit_destroy(c, &fit);
  }
  p[1].maximum = 10.0; /* from a bound to within */
  p[1].start = 0.0;
  assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_OK);
  double column[4][ROWS], y[ROWS], x[4];
  whiten(&l, column, y);
  const double width[2] = {INFINITY, INFINITY}, mean[2] = {0};
  rows_normal_equations(ROWS, 2, column[0], y, width, mean, x, NULL);
  assert_close(fit->x[1], x[1], 1e-9);
  assert_false(fit->at_bound[1]);
  um_inference_fit_destroy(c, &fit);
}

/* What a model may cost. Linear with its Jacobian and its values at the start handed in: the one
 * evaluation at the solution. A bend of 2 % of the change: two. A Jacobian a fifth too steep: the
 * step, its correction by the secant, a difference at the solution. */
static void test_evaluations(void **state)
{
  struct um_context *c = *state;
  struct linear l = linear_model(1);
  struct um_inference_fit_parameter p = FREE;
  struct um_inference_fit *fit;
  double jacobian[ROWS], value[ROWS] = {0};
  const double bend[3] = {0.0, 0.005, 0.0}, steep[3] = {1.0, 1.0, 1.2};
  const size_t most[3] = {1, 2, 4};
  for (size_t k = 0; k < 3; k++) {
    struct um_inference_fit_problem problem = problem_of(&l, &p);
    l.calls = 0;
    l.bend = bend[k];
    for (size_t i = 0; i < ROWS; i++) jacobian[i] = steep[k] * l.column[0][i];
    problem.jacobian = jacobian;
    problem.value = value;
    assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_OK);
    print_message("bend %g, Jacobian %g times its own: %zu evaluations\n", bend[k], steep[k],
                  fit->evaluations);
    assert_true(fit->converged);
    assert_int_equal(fit->evaluations, l.calls);
    assert_true(fit->evaluations <= most[k]);
    /* sum w y / sum w of x + bend x^2 = mean; at the end chi-square falls by 1e-3 no more */
    double precision = 0.0, weighted = 0.0;
    for (size_t i = 0; i < ROWS; i++) {
      precision += 1.0 / (l.sigma[i] * l.sigma[i]);
      weighted += l.y[i] / (l.sigma[i] * l.sigma[i]);
    }
    double x = fit->x[0] + l.bend * fit->x[0] * fit->x[0];
    assert_close((x - weighted / precision) * sqrt(precision), 0.0, sqrt(1e-3));
    assert_close(fit->sigma[0] * sqrt(precision), 1.0, 0.06);
    um_inference_fit_destroy(c, &fit);
  }
  l.bend = 0.0; /* nothing to do: the values handed in are the best there is */
  struct um_inference_fit_problem problem = problem_of(&l, &p);
  double best = 0.0, precision = 0.0;
  for (size_t i = 0; i < ROWS; i++) {
    best += l.y[i] / (l.sigma[i] * l.sigma[i]);
    precision += 1.0 / (l.sigma[i] * l.sigma[i]);
    jacobian[i] = 1.0;
  }
  p.start = best / precision;
  for (size_t i = 0; i < ROWS; i++) value[i] = p.start;
  problem.jacobian = jacobian;
  problem.value = value;
  l.calls = 0;
  assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_OK);
  assert_int_equal(l.calls, 0);
  um_inference_fit_destroy(c, &fit);
}

/* The model refuses above 3.7, the first step aims further with a Jacobian that is too flat; the
 * fit shortens it and leaves no message. At the start the refusal is the caller's. */
static void test_refusals(void **state)
{
  struct um_context *c = *state;
  struct um_inference_fit_parameter p = FREE;
  struct um_inference_fit *fit;
  double jacobian[ROWS];
  for (int k = 0; k < 2; k++) {
    struct linear l = linear_model(1);
    struct um_inference_fit_problem problem = problem_of(&l, &p);
    l.refuse_above = 3.7; /* the weighted mean is 3.6 */
    l.with = k == 0 ? UM_ERR_REFUSED : UM_ERR_NUMERIC;
    for (size_t i = 0; i < ROWS; i++) jacobian[i] = 0.4;
    problem.jacobian = jacobian;
    assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_OK);
    assert_true(fit->converged);
    assert_true(fit->x[0] > 3.3 && fit->x[0] < 3.7);
    assert_string_equal(um_core_message(c), "");
    um_inference_fit_destroy(c, &fit);

    p.start = 5.0;
    assert_int_equal(um_inference_fit_create(c, &problem, &fit), l.with);
    assert_string_equal(um_core_message(c), "the model refuses 5");
    assert_null(fit);
    um_core_message_clear(c);
    p.start = 0.0;
    l.with = UM_ERR_CANCELLED; /* this is the end wherever it happens */
    assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_ERR_CANCELLED);
    um_core_message_clear(c);
  }
}

static enum um_status evaluate_all(struct um_context *c, void *user, size_t n, const double *x,
                                   double *value)
{
  const struct linear *l = user;
  for (size_t i = 0; i < n; i++) {
    enum um_status status = evaluate(c, user, x + i * l->n, value + i * ROWS);
    if (status == UM_OK) continue;
    if (status == UM_ERR_CANCELLED) return status;
    um_core_message_clear(c);
    value[i * ROWS] = NAN;
  }
  return UM_OK;
}

/* Differences that are asked for all at once give the bits of one after another, at as many
 * evaluations, with a bound in the way, a step that is refused and a parameter that is held. */
static void test_at_once(void **state)
{
  struct um_context *c = *state;
  struct um_inference_fit *fit[2];
  size_t calls[2];
  for (int k = 0; k < 2; k++) {
    struct linear l = linear_model(3);
    struct um_inference_fit_parameter p[3] = {FREE, FREE, FREE};
    struct um_inference_fit_problem problem = problem_of(&l, p);
    l.refuse_above = 0.5;
    p[1].maximum = 0.3;
    p[2].minimum = p[2].maximum = 0.0;
    p[2].prior_mean = 0.0;
    p[2].prior_sigma = 1.0;
    if (k == 1) problem.evaluate_all = evaluate_all;
    assert_int_equal(um_inference_fit_create(c, &problem, &fit[k]), UM_OK);
    calls[k] = l.calls;
    assert_false(l.left);
    l.with = UM_ERR_CANCELLED;
    struct um_inference_fit *none;
    assert_int_equal(um_inference_fit_create(c, &problem, &none), UM_ERR_CANCELLED);
    um_core_message_clear(c);
  }
  assert_int_equal(calls[0], calls[1]);
  assert_int_equal(fit[0]->evaluations, fit[1]->evaluations);
  assert_memory_equal(fit[0]->x, fit[1]->x, 3 * sizeof *fit[0]->x);
  assert_memory_equal(fit[0]->jacobian, fit[1]->jacobian, 3 * ROWS * sizeof *fit[0]->jacobian);
  um_inference_fit_destroy(c, &fit[0]);
  um_inference_fit_destroy(c, &fit[1]);
}

static void test_refused(void **state)
{
  struct um_context *c = *state;
  struct linear l = linear_model(2);
  struct um_inference_fit_parameter p[2] = {FREE, FREE};
  struct um_inference_fit_problem problem = problem_of(&l, p);
  struct um_inference_fit *fit;
  problem.nobservation = 1;
  assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_ERR_INPUT);
  assert_string_equal(um_core_message(c),
                      "2 parameters without prior cannot be fitted to 1 measurements");
  um_core_message_clear(c);
  problem.nobservation = ROWS;
  p[1].maximum = -1.0;
  assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_ERR_INPUT);
  assert_string_equal(um_core_message(c),
                      "parameter 2 of a fit starts at 0, outside its range -inf .. -1");
  um_core_message_clear(c);
  p[1].maximum = INFINITY;
  p[1].step = 0.0;
  assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_ERR_INPUT);
  um_core_message_clear(c);
  p[1].step = 1.0;
  p[0].prior_sigma = NAN;
  assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_ERR_INPUT);
  um_core_message_clear(c);
  p[0].prior_sigma = INFINITY;
  l.sigma[2] = 0.0;
  assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_ERR_INPUT);
  assert_string_equal(um_core_message(c),
                      "observation 3 of a fit has the sigma 0; above 0 is needed");
  um_core_message_clear(c);
}

/* Columns 1 and 3 are one: their parameters have no sigma, the others do. No parameter: the model
 * as it is. */
static void test_undetermined(void **state)
{
  struct um_context *c = *state;
  struct linear l = linear_model(4);
  struct um_inference_fit_parameter p[4] = {FREE, FREE, FREE, FREE};
  struct um_inference_fit_problem problem = problem_of(&l, p);
  struct um_inference_fit *fit;
  double column[4][ROWS], y[ROWS], x[4];
  const double width[3] = {INFINITY, INFINITY, INFINITY}, mean[3] = {0};
  whiten(&l, column, y);
  double least = rows_normal_equations(ROWS, 3, column[0], y, width, mean, x, NULL);
  assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_OK);
  assert_close(fit->chi2, least, 1e-8);
  assert_true(isinf(fit->sigma[1]) && isinf(fit->sigma[3]));
  assert_true(isfinite(fit->sigma[0]) && isfinite(fit->sigma[2]));
  assert_close(fit->x[1] - 2.0 * fit->x[3], x[1], 1e-7);
  um_inference_fit_destroy(c, &fit);
  l.n = problem.nparameter = 0;
  assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_OK);
  assert_true(fit->converged);
  assert_int_equal(fit->evaluations, 1);
  double chi2 = 0.0;
  for (size_t i = 0; i < ROWS; i++) chi2 += y[i] * y[i];
  assert_close(fit->chi2, chi2, 1e-10);
  assert_close(fit->bic, chi2, 1e-10);
  um_inference_fit_destroy(c, &fit);
}

/* A linear model, so that one step is the refit: each fold by the normal equations of the rest.
 * Tolerance: the pull towards the start, a millionth where observations determine a parameter. */
static void test_held_out(void **state)
{
  struct um_context *c = *state;
  struct linear l = linear_model(3);
  struct um_inference_fit_parameter p[3] = {FREE, FREE, FREE};
  struct um_inference_fit_problem problem = problem_of(&l, p);
  struct um_inference_fit *fit;
  double column[4][ROWS], y[ROWS], x[4], expected = 0.0, out;
  const double width[3] = {INFINITY, INFINITY, 0.3}, mean[3] = {0.0, 0.0, 0.5};
  size_t fold[ROWS];
  p[2].prior_mean = 0.5;
  p[2].prior_sigma = 0.3;
  whiten(&l, column, y);
  for (size_t i = 0; i < ROWS; i++) fold[i] = i % 4;
  for (size_t k = 0; k < 4; k++) {
    double part[4][ROWS] = {{0}}, y_part[ROWS];
    for (size_t i = 0; i < ROWS; i++) {
      for (size_t j = 0; j < 3; j++) part[j][i] = fold[i] == k ? 0.0 : column[j][i];
      y_part[i] = fold[i] == k ? 0.0 : y[i];
    }
    rows_normal_equations(ROWS, 3, part[0], y_part, width, mean, x, NULL);
    for (size_t i = 0; i < ROWS; i++) {
      double r = y[i] - x[0] * column[0][i] - x[1] * column[1][i] - x[2] * column[2][i];
      if (fold[i] == k) expected += r * r;
    }
  }
  assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_OK);
  size_t calls = l.calls;
  assert_int_equal(um_inference_fit_held_out(c, &problem, fit, fold, 4, &out), UM_OK);
  assert_close(out / expected, 1.0, 1e-5);
  assert_int_equal(l.calls, calls);
  um_inference_fit_destroy(c, &fit);
}

/* A parameter that only the observations of one fold know predicts nothing there: chi-square of
 * those observations is that of its start. */
static void test_held_out_unknown(void **state)
{
  struct um_context *c = *state;
  struct linear l = linear_model(1);
  struct um_inference_fit_parameter p = FREE;
  struct um_inference_fit_problem problem = problem_of(&l, &p);
  struct um_inference_fit *fit;
  double expected = 0.0, out;
  size_t fold[ROWS];
  p.start = 0.5;
  for (size_t i = 0; i < ROWS; i++) {
    fold[i] = i / 6;
    l.column[0][i] = i < 6;
    double r = (l.y[i] - (i < 6 ? 0.5 : 0.0)) / l.sigma[i];
    expected += r * r;
  }
  assert_int_equal(um_inference_fit_create(c, &problem, &fit), UM_OK);
  assert_int_equal(um_inference_fit_held_out(c, &problem, fit, fold, 2, &out), UM_OK);
  assert_close(out, expected, 1e-6 * expected);
  assert_true(fit->chi2 < expected - 100.0); /* seen, they are explained */
  um_inference_fit_destroy(c, &fit);
}

static enum um_status everything(struct um_context *c)
{
  struct linear l = linear_model(3);
  struct um_inference_fit_parameter p[3] = {FREE, FREE, FREE};
  struct um_inference_fit_problem problem = problem_of(&l, p);
  struct um_inference_fit *fit = NULL;
  enum um_status status;
  size_t fold[ROWS] = {0, 1};
  double out;
  l.bend = 0.1;
  p[0].start = 5.0;
  p[1].maximum = 1.0;
  UM_CHECK(um_inference_fit_create(c, &problem, &fit));
  UM_CHECK(um_inference_fit_held_out(c, &problem, fit, fold, 2, &out));
done:
  if (status != UM_OK && l.calls == 0) assert_null(fit);
  um_inference_fit_destroy(c, &fit);
  return status;
}

static void test_memory(void **state)
{
  (void)state;
  memory_sweep(everything, 40);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_certified),
                                     cmocka_unit_test(test_beaten),
                                     cmocka_unit_test(test_sure),
                                     cmocka_unit_test(test_priors),
                                     cmocka_unit_test(test_bounds),
                                     cmocka_unit_test(test_evaluations),
                                     cmocka_unit_test(test_refusals),
                                     cmocka_unit_test(test_refused),
                                     cmocka_unit_test(test_undetermined),
                                     cmocka_unit_test(test_held_out),
                                     cmocka_unit_test(test_held_out_unknown),
                                     cmocka_unit_test(test_memory),
                                     cmocka_unit_test(test_packed),
                                     cmocka_unit_test(test_at_once)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
