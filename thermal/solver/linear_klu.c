/* LU factors by KLU (Davis and Palamadai Natarajan 2010, ACM TOMS 37:36): left-looking, entry by
 * entry, which suits networks and shells, whose factors are sparse. Pivots of the last time are
 * kept where they serve. */
#include <klu.h>
#include <string.h>

#include "thermal/solver/linear_group.h"

#define WORST_PIVOT 1e-14 /* reciprocal condition at which pivots are chosen anew */

struct um_thermal_klu {
  klu_l_common common;
  klu_l_symbolic *symbolic;
  klu_l_numeric *numeric;
  SuiteSparse_long *column, *row;
  SuiteSparse_long n;
};

enum um_status um_thermal_klu_create(const struct um_thermal_system *system,
                                     struct um_thermal_klu **out, double *flops, double *entries)
{
  enum um_status status;
  struct um_context *context = system->context;
  struct um_thermal_klu *klu = NULL;
  size_t n = system->nunknown;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *klu, &klu));
  UM_CHECK(um_core_allocate(context, n + 1, sizeof *klu->column, &klu->column));
  UM_CHECK(um_core_allocate(context, system->nnonzero, sizeof *klu->row, &klu->row));
  for (size_t k = 0; k <= n; k++) klu->column[k] = (SuiteSparse_long)system->column[k];
  for (size_t k = 0; k < system->nnonzero; k++) klu->row[k] = (SuiteSparse_long)system->row[k];
  klu->n = (SuiteSparse_long)n;
  klu_l_defaults(&klu->common);
  klu->symbolic = klu_l_analyze(klu->n, klu->column, klu->row, &klu->common);
  if (klu->symbolic == NULL)
    UM_CHECK(um_core_fail(context, UM_ERR_MEMORY, "out of memory in the heat balance"));
  *flops = klu->symbolic->est_flops;
  *entries = klu->symbolic->lnz;
  *out = klu;
  return UM_OK;
done:
  um_thermal_klu_destroy(context, &klu);
  return status;
}

void um_thermal_klu_destroy(struct um_context *context, struct um_thermal_klu **klu)
{
  if (*klu == NULL) return;
  if ((*klu)->numeric != NULL) klu_l_free_numeric(&(*klu)->numeric, &(*klu)->common);
  if ((*klu)->symbolic != NULL) klu_l_free_symbolic(&(*klu)->symbolic, &(*klu)->common);
  UM_FREE(context, (*klu)->column, (*klu)->row, *klu);
  *klu = NULL;
}

/* With the pivots of the last time. */
static bool refactor(struct um_thermal_klu *klu, double *value)
{
  if (klu->numeric == NULL) return false;
  if (!klu_l_refactor(klu->column, klu->row, value, klu->symbolic, klu->numeric, &klu->common))
    return false;
  return klu_l_rcond(klu->symbolic, klu->numeric, &klu->common) != 0 &&
         klu->common.rcond > WORST_PIVOT;
}

bool um_thermal_klu_factor(struct um_thermal_klu *klu, const double *value, size_t *where)
{
  double *a = (double *)value; /* KLU does not write to it */
  if (refactor(klu, a)) return true;
  if (klu->numeric != NULL) klu_l_free_numeric(&klu->numeric, &klu->common);
  klu->numeric = klu_l_factor(klu->column, klu->row, a, klu->symbolic, &klu->common);
  if (klu->numeric != NULL) return true;
  SuiteSparse_long singular = klu->common.singular_col;
  *where = singular >= 0 && singular < klu->n ? (size_t)singular : 0;
  return false;
}

bool um_thermal_klu_solve(struct um_thermal_klu *klu, size_t count, double *x)
{
  return klu_l_solve(klu->symbolic, klu->numeric, klu->n, (SuiteSparse_long)count, x,
                     &klu->common) != 0;
}
