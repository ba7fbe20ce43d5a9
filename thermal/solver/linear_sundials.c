/* The linear solver of linear.c and its matrix as SUNDIALS's integrators call them. */
#include <nvector/nvector_serial.h>
#include <stdlib.h>
#include <string.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include "thermal/solver/linear_group.h"
#include "thermal/solver/sundials_impl.h"

/* What a set-up answers: a shorter step may help, nothing will. */
#define AGAIN    1
#define FOR_GOOD (-1)

struct content {
  struct um_thermal_linear *linear; /* borrowed */
  double tolerance;
};

static SUNLinearSolver_Type type_get(SUNLinearSolver solver)
{
  (void)solver;
  return SUNLINEARSOLVER_DIRECT;
}

static SUNLinearSolver_ID id_get(SUNLinearSolver solver)
{
  (void)solver;
  return SUNLINEARSOLVER_CUSTOM;
}

static int initialize(SUNLinearSolver solver)
{
  (void)solver;
  return 0;
}

static int set_up(SUNLinearSolver solver, SUNMatrix matrix)
{
  const struct content *content = solver->content;
  enum um_status status = um_thermal_linear_factor(content->linear, SUNSparseMatrix_Data(matrix));
  return status == UM_OK ? 0 : status == UM_ERR_NUMERIC ? AGAIN : FOR_GOOD;
}

/* A solution has codes of its own: CVODES and KINSOL take one that they do not list for a success.
 */
static int answer(enum um_status status)
{
  if (status == UM_OK) return 0;
  return status == UM_ERR_NUMERIC ? SUNLS_PACKAGE_FAIL_REC : SUN_ERR_EXT_FAIL;
}

static int solve(SUNLinearSolver solver, SUNMatrix matrix, N_Vector x, N_Vector b,
                 sunrealtype tolerance)
{
  (void)matrix, (void)tolerance; /* of a direct solver: 0 */
  const struct content *content = solver->content;
  double *out = N_VGetArrayPointer(x), *in = N_VGetArrayPointer(b);
  if (out != in) memcpy(out, in, (size_t)N_VGetLength(x) * sizeof *out);
  return answer(um_thermal_linear_solve(content->linear, 1, content->tolerance, out));
}

static int destroy(SUNLinearSolver solver)
{
  struct content *content = solver->content;
  free(content);
  solver->content = NULL;
  SUNLinSolFreeEmpty(solver);
  return 0;
}

SUNLinearSolver um_thermal_linear_sundials(struct um_thermal_linear *linear, double tolerance,
                                           SUNContext sun)
{
  SUNLinearSolver solver = SUNLinSolNewEmpty(sun);
  struct content *content = malloc(sizeof *content); /* beside SUNDIALS's own */
  if (solver == NULL || content == NULL) {
    free(content);
    SUNLinSolFreeEmpty(solver);
    return NULL;
  }
  *content = (struct content){linear, tolerance};
  solver->content = content;
  solver->ops->gettype = type_get;
  solver->ops->getid = id_get;
  solver->ops->initialize = initialize;
  solver->ops->setup = set_up;
  solver->ops->solve = solve;
  solver->ops->free = destroy;
  return solver;
}

SUNMatrix um_thermal_linear_matrix(const struct um_thermal_system *system, SUNContext sun)
{
  sunindextype n = (sunindextype)system->nunknown;
  return SUNSparseMatrix(n, n, (sunindextype)system->nnonzero, CSC_MAT, sun);
}

void um_thermal_linear_pattern(const struct um_thermal_system *system, SUNMatrix matrix)
{
  sunindextype *column = SUNSparseMatrix_IndexPointers(matrix);
  sunindextype *row = SUNSparseMatrix_IndexValues(matrix);
  for (size_t k = 0; k <= system->nunknown; k++) column[k] = (sunindextype)system->column[k];
  for (size_t k = 0; k < system->nnonzero; k++) row[k] = (sunindextype)system->row[k];
}
