/* The solver of exchange_solve.c as SUNDIALS wants one: a direct solver to it, around another. */
#include <stdlib.h>
#include <string.h>

#include <nvector/nvector_serial.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include "thermal/solver/exchange_solve_group.h"
#include "thermal/solver/sundials_impl.h"

struct content {
  struct um_thermal_system *system; /* borrowed */
  struct um_thermal_exchange_solver *solver;
  SUNLinearSolver inner;
  SUNMatrix matrix; /* of the last setup; borrowed */
  N_Vector work;    /* right-hand side of the inner solver */
  N_Vector answer;
  const double *scale, *tolerance;
};

static struct content *content_of(SUNLinearSolver solver) { return solver->content; }

static SUNLinearSolver_Type get_type(SUNLinearSolver solver)
{
  (void)solver;
  return SUNLINEARSOLVER_DIRECT;
}

static int initialize(SUNLinearSolver solver)
{
  return SUNLinSolInitialize(content_of(solver)->inner);
}

static int set_up(SUNLinearSolver solver, SUNMatrix matrix)
{
  content_of(solver)->matrix = matrix;
  return SUNLinSolSetup(content_of(solver)->inner, matrix);
}

static enum um_status inner_solve(void *self, size_t count, double *x)
{
  struct content *c = self;
  (void)count; /* 1 */
  size_t bytes = c->system->nunknown * sizeof *x;
  memcpy(N_VGetArrayPointer(c->work), x, bytes);
  int code = SUNLinSolSolve(c->inner, c->matrix, c->answer, c->work, 0.0);
  if (code != 0)
    return um_core_fail(c->system->context, UM_ERR_NUMERIC,
                        "the heat balance cannot be solved (code %d)", code);
  memcpy(x, N_VGetArrayPointer(c->answer), bytes);
  return UM_OK;
}

static int solve(SUNLinearSolver solver, SUNMatrix matrix, N_Vector x, N_Vector b,
                 sunrealtype unused)
{
  struct content *c = content_of(solver);
  const struct um_thermal_inner inner = {inner_solve, c};
  double *to = N_VGetArrayPointer(x), *from = N_VGetArrayPointer(b);
  (void)unused;
  if (to != from) memcpy(to, from, c->system->nunknown * sizeof *to);
  enum um_status status = um_thermal_exchange_solve(c->solver, &inner, SUNSparseMatrix_Data(matrix),
                                                    *c->scale, *c->tolerance, NULL, 1, to);
  return status == UM_OK ? 0 : SUN_ERR_EXT_FAIL;
}

static int release(SUNLinearSolver solver)
{
  if (solver == NULL) return 0;
  struct content *c = content_of(solver);
  if (c != NULL) {
    um_thermal_exchange_solver_destroy(&c->solver);
    if (c->work != NULL) N_VDestroy(c->work);
    if (c->answer != NULL) N_VDestroy(c->answer);
    if (c->inner != NULL) SUNLinSolFree(c->inner);
    free(c);
  }
  SUNLinSolFreeEmpty(solver);
  return 0;
}

SUNLinearSolver um_thermal_exchange_sundials(struct um_thermal_system *system,
                                             SUNLinearSolver inner, const double *scale,
                                             const double *tolerance, SUNContext sun)
{
  if (inner == NULL) return NULL;
  SUNLinearSolver solver = SUNLinSolNewEmpty(sun);
  struct content *c = calloc(1, sizeof *c);
  if (solver == NULL || c == NULL) {
    if (solver != NULL) SUNLinSolFreeEmpty(solver);
    free(c);
    SUNLinSolFree(inner);
    return NULL;
  }
  *c = (struct content){.system = system, .inner = inner, .scale = scale, .tolerance = tolerance};
  solver->content = c;
  solver->ops->gettype = get_type;
  solver->ops->initialize = initialize;
  solver->ops->setup = set_up;
  solver->ops->solve = solve;
  solver->ops->free = release;
  c->work = N_VNew_Serial((sunindextype)system->nunknown, sun);
  c->answer = N_VNew_Serial((sunindextype)system->nunknown, sun);
  if (c->work != NULL && c->answer != NULL &&
      um_thermal_exchange_solver_create(system, 1, &c->solver) == UM_OK)
    return solver;
  release(solver);
  return NULL;
}
