/* Who solves A x = b, A = I - g J or a multiple of J.
 *
 * KLU takes any matrix. Where a factorisation would cost more than DENSE operations per entry of
 * its factors, the factors have dense blocks (solids, large shells), and CHOLMOD's kernels are tens
 * of times faster; but it wants a symmetric positive matrix. With D = diag(C_i),
 *
 *   D A = C + g K,   K_ij = -(K_ij + 4 s R_ij T_j^3),
 *
 * is symmetric where nodes are coupled by constant conduction and radiate to space alone: then its
 * factors solve. Radiation between nodes of different temperature, arithmetic nodes between such,
 * and mean thermostats make it differ from its transpose. Then rows are scaled anew, D_i = C_i
 * exp(r_i) with r_i from sweeps toward D_i a_ij = D_j a_ji (a skin over one wall is met exactly:
 * exp(r) = T_skin^3 / T_wall^3), CHOLMOD factors the symmetric neighbour
 *
 *   P_ii = D_i a_ii,   P_ij = -sqrt(D_i a_ij D_j a_ji),
 *
 * in which every link is a positive semidefinite block, and GMRES (Saad and Schultz 1986, SIAM J.
 * Sci. Stat. Comput. 7:856) solves P^-1 D A x = P^-1 D b. A matrix whose neighbour is not positive
 * definite, or that GMRES does not solve in KRYLOV products, is KLU's from then on. Sums are in
 * fixed order: a solution does not depend on threads. */
#include "thermal/solver/linear_group.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define DENSE       40.0  /* operations per entry of the factors beyond which CHOLMOD is taken */
#define DENSE_MIXED 250.0 /* the same where the balance is not symmetric */
#define KRYLOV      40    /* most products of one solution */
#define NEARLY      1e-12 /* relative difference of mirrored entries that rounding makes */
#define SWEEPS      2     /* toward a scaling */
#define STEEPEST    5.0   /* largest |r_i| of one sweep */
#define NO_MIRROR   ((size_t)-1)

struct um_thermal_linear {
  const struct um_thermal_system *system; /* borrowed */
  struct um_thermal_klu *klu;             /* NULL while CHOLMOD serves */
  struct um_thermal_cholmod *cholmod;     /* NULL while KLU serves */
  const double *value;                    /* [nnonzero] of the last factorisation, borrowed */
  size_t *mirror;                         /* [nnonzero] place of the transposed entry */
  size_t *lower;                          /* [nlower] places of the lower triangle */
  size_t nlower;
  double *scale;    /* [nunknown] D, with the sign of the diagonal */
  bool symmetric;   /* the last matrix was */
  bool singular;    /* the last matrix was, */
  size_t where;     /* at this unknown */
  double *basis;    /* [KRYLOV + 1][nunknown] */
  double *combined; /* [nunknown] */
};

/* --- the pattern ---------------------------------------------------------------------------- */

static enum um_status mirrors_build(struct um_thermal_linear *linear)
{
  const struct um_thermal_system *system = linear->system;
  UM_TRY(um_core_allocate(system->context, system->nnonzero, sizeof(size_t), &linear->mirror));
  for (size_t k = 0; k < system->nunknown; k++)
    for (size_t e = (size_t)system->column[k]; e < (size_t)system->column[k + 1]; e++) {
      size_t slot = um_thermal_system_slot(system, k, (size_t)system->row[e]);
      linear->mirror[e] = (size_t)system->row[slot] == k ? slot : NO_MIRROR;
    }
  return UM_OK;
}

/* Lower triangle of the entries that have a mirror: of the others the neighbour has none. */
static enum um_status cholmod_take(struct um_thermal_linear *linear)
{
  enum um_status status;
  const struct um_thermal_system *system = linear->system;
  struct um_context *context = system->context;
  size_t n = system->nunknown;
  int64_t *column = NULL, *row = NULL;
  UM_CHECK(mirrors_build(linear));
  UM_CHECK(um_core_allocate(context, system->nnonzero, sizeof(size_t), &linear->lower));
  UM_CHECK(um_core_allocate(context, n, sizeof(double), &linear->scale));
  UM_CHECK(um_core_allocate(context, n + 1, sizeof *column, &column));
  UM_CHECK(um_core_allocate(context, system->nnonzero, sizeof *row, &row));
  for (size_t k = 0; k < n; k++) {
    for (size_t e = (size_t)system->column[k]; e < (size_t)system->column[k + 1]; e++) {
      if (system->row[e] < (int64_t)k || linear->mirror[e] == NO_MIRROR) continue;
      row[linear->nlower] = system->row[e];
      linear->lower[linear->nlower++] = e;
    }
    column[k + 1] = (int64_t)linear->nlower;
  }
  UM_CHECK(um_thermal_cholmod_create(context, n, column, row, &linear->cholmod));
done:
  UM_FREE(context, column, row);
  return status;
}

/* Has the system what makes its balance asymmetric? */
static bool is_mixed(const struct um_thermal_system *system)
{
  if (system->ncluster > 0) return true;
  for (size_t k = 0; k < system->nthermostat; k++)
    if (system->thermostat[k].slot != NULL) return true;
  for (size_t k = 0; k < system->nunknown; k++) {
    size_t i = system->node[k];
    for (size_t e = system->start[i]; e < system->start[i + 1]; e++)
      if ((system->fourth[e] != 0.0 || um_thermal_system_link_varies(system, e)) &&
          system->unknown[system->other[e]] != UM_THERMAL_NONE)
        return true;
  }
  return false;
}

enum um_status um_thermal_linear_create(const struct um_thermal_system *system,
                                        struct um_thermal_linear **out)
{
  enum um_status status;
  struct um_context *context = system->context;
  struct um_thermal_linear *linear = NULL;
  double flops, entries;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *linear, &linear));
  linear->system = system;
  UM_CHECK(um_thermal_klu_create(system, &linear->klu, &flops, &entries));
  enum um_thermal_factors wanted = system->options.factors;
  bool cholesky =
      wanted == UM_THERMAL_CHOLESKY || (wanted == UM_THERMAL_FACTORS_BY_STRUCTURE &&
                                        flops > (is_mixed(system) ? DENSE_MIXED : DENSE) * entries);
  if (cholesky) {
    um_thermal_klu_destroy(context, &linear->klu);
    UM_CHECK(cholmod_take(linear));
  }
  *out = linear;
  return UM_OK;
done:
  um_thermal_linear_destroy(&linear);
  return status;
}

void um_thermal_linear_destroy(struct um_thermal_linear **linear)
{
  if (linear == NULL || *linear == NULL) return;
  struct um_thermal_linear *l = *linear;
  struct um_context *context = l->system->context;
  um_thermal_klu_destroy(context, &l->klu);
  um_thermal_cholmod_destroy(context, &l->cholmod);
  UM_FREE(context, l->mirror, l->lower, l->scale, l->basis, l->combined, l);
  *linear = NULL;
}

const char *um_thermal_linear_method(const struct um_thermal_linear *linear)
{
  return linear->klu != NULL ? "KLU" : "CHOLMOD";
}

/* --- factors -------------------------------------------------------------------------------- */

static enum um_status klu_factor(struct um_thermal_linear *linear)
{
  linear->singular = !um_thermal_klu_factor(linear->klu, linear->value, &linear->where);
  return linear->singular ? UM_ERR_NUMERIC : UM_OK;
}

const char *um_thermal_linear_fault(const struct um_thermal_linear *linear, char *text, size_t size)
{
  char label[96];
  text[0] = '\0';
  if (linear != NULL && linear->singular)
    snprintf(text, size, "the heat balance is singular at %s: nothing holds its temperature",
             um_thermal_network_label(linear->system->network, linear->system->node[linear->where],
                                      label, sizeof label));
  return text;
}

/* From now on KLU. */
static enum um_status klu_instead(struct um_thermal_linear *linear)
{
  double flops, entries;
  um_thermal_cholmod_destroy(linear->system->context, &linear->cholmod);
  UM_TRY(um_thermal_klu_create(linear->system, &linear->klu, &flops, &entries));
  return klu_factor(linear);
}

static bool nearly_equal(double a, double b) { return fabs(a - b) <= NEARLY * (fabs(a) + fabs(b)); }

/* D = C with the sign of the diagonal; is D A symmetric? */
static bool scale_begin(struct um_thermal_linear *linear)
{
  const struct um_thermal_system *system = linear->system;
  const double *value = linear->value;
  bool symmetric = true;
  double sign = value[system->diagonal[0]] < 0.0 ? -1.0 : 1.0;
  for (size_t k = 0; k < system->nunknown; k++)
    linear->scale[k] = sign * system->capacity[system->node[k]] *
                       um_thermal_system_warming(system, system->node[k]);
  for (size_t k = 0; k < system->nunknown && symmetric; k++)
    for (size_t e = (size_t)system->column[k]; e < (size_t)system->column[k + 1]; e++) {
      size_t mirror = linear->mirror[e];
      double opposite = mirror == NO_MIRROR ? 0.0 : value[mirror] * linear->scale[k];
      if (!nearly_equal(value[e] * linear->scale[system->row[e]], opposite)) symmetric = false;
    }
  return symmetric;
}

/* One sweep: r_i such that the entries of row i are, in the mean weighted by their size, those of
 * column i. */
static void scale_sweep(struct um_thermal_linear *linear)
{
  const struct um_thermal_system *system = linear->system;
  const double *value = linear->value;
  for (size_t k = 0; k < system->nunknown; k++) {
    double weight = 0.0, sum = 0.0;
    for (size_t e = (size_t)system->column[k]; e < (size_t)system->column[k + 1]; e++) {
      size_t mirror = linear->mirror[e];
      if (mirror == NO_MIRROR || e == mirror) continue;
      double below = value[e] * linear->scale[system->row[e]];
      double across = value[mirror] * linear->scale[k];
      if (!(below * across > 0.0)) continue;
      double size = sqrt(below * across);
      weight += size;
      if (!nearly_equal(below, across)) sum += size * log(below / across);
    }
    if (weight > 0.0) linear->scale[k] *= exp(fmax(-STEEPEST, fmin(STEEPEST, sum / weight)));
  }
}

/* The lower triangle of P. */
static void neighbour_fill(struct um_thermal_linear *linear)
{
  const struct um_thermal_system *system = linear->system;
  double *out = um_thermal_cholmod_values(linear->cholmod);
  size_t at = 0;
  for (size_t k = 0; k < system->nunknown; k++)
    for (; at < linear->nlower && linear->lower[at] < (size_t)system->column[k + 1]; at++) {
      size_t e = linear->lower[at];
      double below = linear->value[e] * linear->scale[system->row[e]];
      double across = linear->value[linear->mirror[e]] * linear->scale[k];
      if (linear->symmetric || linear->mirror[e] == e)
        out[at] = below;
      else
        out[at] = below * across > 0.0 ? copysign(sqrt(below * across), below) : 0.0;
    }
}

enum um_status um_thermal_linear_factor(struct um_thermal_linear *linear, const double *value)
{
  linear->value = value;
  if (linear->klu != NULL) return klu_factor(linear);
  linear->symmetric = scale_begin(linear);
  for (int sweep = 0; sweep < SWEEPS && !linear->symmetric; sweep++) scale_sweep(linear);
  neighbour_fill(linear);
  if (um_thermal_cholmod_factor(linear->cholmod)) return UM_OK;
  return klu_instead(linear);
}

/* --- GMRES ---------------------------------------------------------------------------------- */

static double dot(size_t n, const double *a, const double *b)
{
  double sum[4] = {0.0, 0.0, 0.0, 0.0};
  size_t k = 0;
  for (; k + 4 <= n; k += 4)
    for (size_t s = 0; s < 4; s++) sum[s] += a[k + s] * b[k + s];
  for (; k < n; k++) sum[0] += a[k] * b[k];
  return sum[0] + sum[1] + sum[2] + sum[3];
}

/* y = P^-1 D A x. */
static bool product(struct um_thermal_linear *linear, const double *x, double *y)
{
  const struct um_thermal_system *system = linear->system;
  memset(y, 0, system->nunknown * sizeof *y);
  for (size_t k = 0; k < system->nunknown; k++)
    for (size_t e = (size_t)system->column[k]; e < (size_t)system->column[k + 1]; e++)
      y[system->row[e]] += linear->value[e] * x[k];
  for (size_t k = 0; k < system->nunknown; k++) y[k] *= linear->scale[k];
  return um_thermal_cholmod_solve(linear->cholmod, 1, y);
}

/* The small least-squares problem of GMRES: rotated columns h and the residual g. */
struct rotations {
  double h[KRYLOV][KRYLOV + 1], g[KRYLOV + 1], c[KRYLOV], s[KRYLOV];
};

/* Column m of the Hessenberg matrix is in; returns the residual. */
static double rotate(struct rotations *r, size_t m)
{
  double *h = r->h[m];
  for (size_t j = 0; j < m; j++) {
    double a = h[j], b = h[j + 1];
    h[j] = r->c[j] * a + r->s[j] * b;
    h[j + 1] = -r->s[j] * a + r->c[j] * b;
  }
  double length = hypot(h[m], h[m + 1]);
  r->c[m] = length > 0.0 ? h[m] / length : 1.0;
  r->s[m] = length > 0.0 ? h[m + 1] / length : 0.0;
  h[m] = length;
  r->g[m + 1] = -r->s[m] * r->g[m];
  r->g[m] *= r->c[m];
  return fabs(r->g[m + 1]);
}

/* x = basis y with h y = g, the first `count` of them; false where h is singular. */
static bool combine(const struct rotations *r, const double *basis, size_t count, size_t n,
                    double *x)
{
  double y[KRYLOV];
  for (size_t i = count; i-- > 0;) {
    double sum = r->g[i];
    for (size_t j = i + 1; j < count; j++) sum -= r->h[j][i] * y[j];
    if (!(fabs(r->h[i][i]) > 0.0)) return false;
    y[i] = sum / r->h[i][i];
  }
  memset(x, 0, n * sizeof *x);
  for (size_t i = 0; i < count; i++)
    for (size_t k = 0; k < n; k++) x[k] += y[i] * basis[i * n + k];
  return true;
}

/* x: D b in, A^-1 b out; false: not solved, x is lost. */
static bool iterate(struct um_thermal_linear *linear, double tolerance, double *x)
{
  size_t n = linear->system->nunknown;
  double *basis = linear->basis;
  struct rotations r;
  memcpy(basis, x, n * sizeof *x);
  if (!um_thermal_cholmod_solve(linear->cholmod, 1, basis)) return false;
  double begin = sqrt(dot(n, basis, basis));
  memset(x, 0, n * sizeof *x);
  if (begin == 0.0) return true;
  if (!isfinite(begin)) return false;
  for (size_t k = 0; k < n; k++) basis[k] /= begin;
  r.g[0] = begin;
  for (size_t m = 0; m < KRYLOV; m++) {
    double *next = basis + (m + 1) * n;
    if (!product(linear, basis + m * n, next)) return false;
    for (size_t j = 0; j <= m; j++) {
      const double *v = basis + j * n;
      double h = r.h[m][j] = dot(n, next, v);
      for (size_t k = 0; k < n; k++) next[k] -= h * v[k];
    }
    double length = r.h[m][m + 1] = sqrt(dot(n, next, next));
    for (size_t k = 0; k < n && length > 0.0; k++) next[k] /= length;
    if (rotate(&r, m) <= tolerance * begin) return combine(&r, basis, m + 1, n, x);
  }
  return false;
}

static enum um_status iterate_all(struct um_thermal_linear *linear, size_t count, double tolerance,
                                  double *x)
{
  const struct um_thermal_system *system = linear->system;
  size_t n = system->nunknown;
  if (linear->basis == NULL)
    UM_TRY(um_core_allocate(system->context, (KRYLOV + 1) * n, sizeof(double), &linear->basis));
  if (linear->combined == NULL)
    UM_TRY(um_core_allocate(system->context, n, sizeof(double), &linear->combined));
  for (size_t c = 0; c < count; c++) {
    for (size_t k = 0; k < n; k++) linear->combined[k] = linear->scale[k] * x[c * n + k];
    if (!iterate(linear, tolerance, linear->combined)) {
      UM_TRY(klu_instead(linear));
      return um_thermal_klu_solve(linear->klu, count - c, x + c * n) ? UM_OK : UM_ERR_NUMERIC;
    }
    memcpy(x + c * n, linear->combined, n * sizeof *x);
  }
  return UM_OK;
}

enum um_status um_thermal_linear_solve(struct um_thermal_linear *linear, size_t count,
                                       double tolerance, double *x)
{
  size_t n = linear->system->nunknown;
  if (linear->klu != NULL)
    return um_thermal_klu_solve(linear->klu, count, x) ? UM_OK : UM_ERR_NUMERIC;
  if (!linear->symmetric) return iterate_all(linear, count, tolerance, x);
  for (size_t c = 0; c < count; c++)
    for (size_t k = 0; k < n; k++) x[c * n + k] *= linear->scale[k];
  return um_thermal_cholmod_solve(linear->cholmod, count, x) ? UM_OK : UM_ERR_NUMERIC;
}
