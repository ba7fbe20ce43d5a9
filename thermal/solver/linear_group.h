/* Private to the rooms of thermal/: linear equations A x = b on the pattern of a system's Jacobian,
 * A = I - g J or a multiple of J. Who solves them is found from the structure (linear.c). */
#ifndef UMBRA_THERMAL_LINEAR_GROUP_H
#define UMBRA_THERMAL_LINEAR_GROUP_H

#include <sundials/sundials_linearsolver.h>

#include "thermal/solver/system_group.h"

struct um_thermal_linear;

/* Analyses the pattern once. UM_ERR_MEMORY. The system is borrowed. */
enum um_status um_thermal_linear_create(const struct um_thermal_system *system,
                                        struct um_thermal_linear **out);
void um_thermal_linear_destroy(struct um_thermal_linear **linear);
/* Factor A = value[nnonzero], borrowed until the next call. UM_ERR_NUMERIC, without a message,
 * since a shorter step may do: A is singular. UM_ERR_MEMORY. */
enum um_status um_thermal_linear_factor(struct um_thermal_linear *linear, const double *value);
/* x[count][nunknown] <- A^-1 x. tolerance: of the residual over that of x = 0, both seen through
 * the symmetric neighbour of A, where one is iterated with; else it is solved to rounding.
 * UM_ERR_NUMERIC without a message; UM_ERR_MEMORY. */
enum um_status um_thermal_linear_solve(struct um_thermal_linear *linear, size_t count,
                                       double tolerance, double *x);
/* Where the last matrix was singular, into text: "the heat balance is singular at node 'x': ...",
 * "" where it was not or linear is NULL. Returns text. */
const char *um_thermal_linear_fault(const struct um_thermal_linear *linear, char *text,
                                    size_t size);
/* "KLU", "CHOLMOD"; borrowed. */
const char *um_thermal_linear_method(const struct um_thermal_linear *linear);

/* The same as SUNDIALS wants it: matrices are SUNMATRIX_SPARSE in columns on the system's pattern.
 * NULL: out of memory. Freed with SUNLinSolFree; the linear stays with the caller. */
SUNLinearSolver um_thermal_linear_sundials(struct um_thermal_linear *linear, double tolerance,
                                           SUNContext sun);
/* A matrix for it; NULL: out of memory. */
SUNMatrix um_thermal_linear_matrix(const struct um_thermal_system *system, SUNContext sun);
/* The pattern into it, which SUNDIALS clears. */
void um_thermal_linear_pattern(const struct um_thermal_system *system, SUNMatrix matrix);

/* --- linear_klu.c: LU factors of any matrix, the only place that knows KLU ------------------ */
struct um_thermal_klu;
/* flops, entries: estimates of one factorisation and of its factors. */
enum um_status um_thermal_klu_create(const struct um_thermal_system *system,
                                     struct um_thermal_klu **out, double *flops, double *entries);
void um_thermal_klu_destroy(struct um_context *context, struct um_thermal_klu **klu);
/* false: singular at unknown *where. */
bool um_thermal_klu_factor(struct um_thermal_klu *klu, const double *value, size_t *where);
bool um_thermal_klu_solve(struct um_thermal_klu *klu, size_t count, double *x);

/* --- linear_cholmod.c: factors of a symmetric positive matrix, the only place that knows CHOLMOD
 */
struct um_thermal_cholmod;
/* Pattern: lower triangle in columns, diagonals first. */
enum um_status um_thermal_cholmod_create(struct um_context *context, size_t n,
                                         const int64_t *column, const int64_t *row,
                                         struct um_thermal_cholmod **out);
void um_thermal_cholmod_destroy(struct um_context *context, struct um_thermal_cholmod **cholmod);
/* Values of the lower triangle, to be filled before factor. */
double *um_thermal_cholmod_values(struct um_thermal_cholmod *cholmod);
/* false: not positive definite, or out of memory. */
bool um_thermal_cholmod_factor(struct um_thermal_cholmod *cholmod);
bool um_thermal_cholmod_solve(struct um_thermal_cholmod *cholmod, size_t count, double *x);

#endif
