/* Cholesky factors by CHOLMOD (Chen, Davis, Hager and Rajamanickam 2008, ACM TOMS 35:22): columns
 * of like pattern are taken together and go through dense kernels, which suits solids, whose
 * factors fill. It orders by AMD and, where that fills much, by METIS's nested dissection, and
 * keeps what fills less.
 *
 * The dense kernels are those of the BLAS that CHOLMOD is linked with, held to one thread
 * (cholmod_library.c): more would split the work, which may change the last digits. */
#include <omp.h>
#include <string.h>

#include "thermal/solver/cholmod_library_impl.h"
#include "thermal/solver/linear_group.h"

struct um_thermal_cholmod {
  const struct um_thermal_cholmod_library *library;
  cholmod_common common;
  cholmod_sparse matrix; /* lower triangle; arrays are owned */
  cholmod_factor *factor;
  cholmod_dense *answer, *work1, *work2;
  bool started;
};

static enum um_status pattern_copy(struct um_context *context, size_t n, const int64_t *column,
                                   const int64_t *row, struct um_thermal_cholmod *cholmod)
{
  size_t entries = (size_t)column[n];
  SuiteSparse_long *start = NULL, *index = NULL;
  UM_TRY(um_core_allocate(context, n + 1, sizeof *start, &start));
  cholmod->matrix.p = start;
  UM_TRY(um_core_allocate(context, entries, sizeof *index, &index));
  cholmod->matrix.i = index;
  UM_TRY(um_core_allocate(context, entries, sizeof(double), &cholmod->matrix.x));
  for (size_t k = 0; k <= n; k++) start[k] = (SuiteSparse_long)column[k];
  for (size_t k = 0; k < entries; k++) index[k] = (SuiteSparse_long)row[k];
  cholmod->matrix.nrow = cholmod->matrix.ncol = n;
  cholmod->matrix.nzmax = entries;
  cholmod->matrix.stype = -1;
  cholmod->matrix.itype = CHOLMOD_LONG;
  cholmod->matrix.xtype = CHOLMOD_REAL;
  cholmod->matrix.dtype = CHOLMOD_DOUBLE;
  cholmod->matrix.sorted = cholmod->matrix.packed = 1;
  return UM_OK;
}

enum um_status um_thermal_cholmod_create(struct um_context *context, size_t n,
                                         const int64_t *column, const int64_t *row,
                                         struct um_thermal_cholmod **out)
{
  enum um_status status;
  struct um_thermal_cholmod *cholmod = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *cholmod, &cholmod));
  UM_CHECK(um_thermal_cholmod_open(context, &cholmod->library));
  UM_CHECK(pattern_copy(context, n, column, row, cholmod));
  cholmod->started = cholmod->library->start(&cholmod->common) != 0;
  cholmod->common.print = 0;
  cholmod->common.final_ll = 1; /* L D Lt would not see what is not positive */
  if (cholmod->started)
    cholmod->factor = cholmod->library->analyze(&cholmod->matrix, &cholmod->common);
  if (cholmod->factor == NULL)
    UM_CHECK(um_core_fail(context, UM_ERR_MEMORY, "out of memory in the heat balance"));
  *out = cholmod;
  return UM_OK;
done:
  um_thermal_cholmod_destroy(context, &cholmod);
  return status;
}

void um_thermal_cholmod_destroy(struct um_context *context, struct um_thermal_cholmod **cholmod)
{
  struct um_thermal_cholmod *c = *cholmod;
  if (c == NULL) return;
  if (c->started) {
    c->library->free_factor(&c->factor, &c->common);
    c->library->free_dense(&c->answer, &c->common);
    c->library->free_dense(&c->work1, &c->common);
    c->library->free_dense(&c->work2, &c->common);
    c->library->finish(&c->common);
  }
  UM_FREE(context, c->matrix.p, c->matrix.i, c->matrix.x, c);
  *cholmod = NULL;
}

double *um_thermal_cholmod_values(struct um_thermal_cholmod *cholmod) { return cholmod->matrix.x; }

/* CHOLMOD begins four threads for every small block, which costs more than the block: none. */
bool um_thermal_cholmod_factor(struct um_thermal_cholmod *cholmod)
{
  int levels = omp_get_max_active_levels();
  omp_set_max_active_levels(0);
  int made = cholmod->library->factorize(&cholmod->matrix, cholmod->factor, &cholmod->common);
  omp_set_max_active_levels(levels);
  return made != 0 && cholmod->common.status == CHOLMOD_OK;
}

bool um_thermal_cholmod_solve(struct um_thermal_cholmod *cholmod, size_t count, double *x)
{
  size_t n = cholmod->matrix.nrow;
  cholmod_dense right = {.nrow = n,
                         .ncol = count,
                         .nzmax = n * count,
                         .d = n,
                         .x = x,
                         .xtype = CHOLMOD_REAL,
                         .dtype = CHOLMOD_DOUBLE};
  if (!cholmod->library->solve2(CHOLMOD_A, cholmod->factor, &right, NULL, &cholmod->answer, NULL,
                                &cholmod->work1, &cholmod->work2, &cholmod->common))
    return false;
  memcpy(x, cholmod->answer->x, n * count * sizeof *x);
  return true;
}
