/* Every kind and place of a correction with every coordinate and curve, by least squares: with
 * columns d_i = unit times function i after the nuisances, and the residual r,
 *
 *   (d'd) v = d'r,   chi-square explained = v'd'r,   covariance (d'd)^-1. */
#include "evidence/missing_light/search_impl.h"

#include <math.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>

#include "base/core/sort.h"
#include "base/inference/algebra.h"
#include "evidence/missing_light/policy.h"

#define ABSORBED 1e-8 /* of a column's square that others leave [1]: it is one of them */

/* Function of number i of an attempt, and the band that it acts on. */
static size_t number_band(const struct um_missing_light_observations *o,
                          const struct um_missing_light_attempt *a, size_t i)
{
  if (a->band == UM_MISSING_LIGHT_OWN) return i / a->curve.n;
  return a->band == UM_MISSING_LIGHT_GREY ? o->nband : a->band;
}

/* One column; how many observations it rests on. */
static size_t fill_column(const struct um_missing_light_observations *o,
                          const struct um_missing_light_attempt *a, size_t i, double *column)
{
  size_t n = o->nobservation, rests = 0, band = number_band(o, a, i);
  const double *unit = o->unit + um_missing_light_unit(o, a->kind, a->material) * n;
  const double *u = o->coordinate + (size_t)a->coordinate * n;
  for (size_t j = 0; j < n; j++) {
    bool acts = o->of[j] < o->nband && (band == o->nband || o->of[j] == band);
    double f = acts ? um_effect_curve_function(&a->curve, i % a->curve.n, u[j]) : 0.0;
    column[j] = acts && isfinite(unit[j]) ? f * unit[j] : 0.0;
    rests += fabs(f) > 0.1 && column[j] != 0.0;
  }
  return rests;
}

/* The solution of gram [n][n], which is lost, for right [n], and the diagonal of its inverse;
 * false: a column is a sum of others. */
static bool solve(size_t n, double gram[UM_MISSING_LIGHT_NUMBERS][UM_MISSING_LIGHT_NUMBERS],
                  const double *right, double *x, double *variance)
{
  double whole[UM_MISSING_LIGHT_NUMBERS];
  gsl_matrix_view m = gsl_matrix_view_array_with_tda(gram[0], n, n, UM_MISSING_LIGHT_NUMBERS);
  gsl_vector_const_view b = gsl_vector_const_view_array(right, n);
  gsl_vector_view to = gsl_vector_view_array(x, n);
  for (size_t i = 0; i < n; i++) whole[i] = gram[i][i];
  gsl_set_error_handler_off();
  if (gsl_linalg_cholesky_decomp1(&m.matrix) != GSL_SUCCESS) return false;
  for (size_t i = 0; i < n; i++)
    if (!(gram[i][i] * gram[i][i] > ABSORBED * whole[i])) return false;
  gsl_linalg_cholesky_solve(&m.matrix, &b.vector, &to.vector);
  gsl_linalg_cholesky_invert(&m.matrix);
  for (size_t i = 0; i < n; i++) variance[i] = gram[i][i];
  return true;
}

void um_missing_light_fit(struct um_missing_light_search *s, struct um_missing_light_attempt *a)
{
  struct um_missing_light_observations *o = s->o;
  double gram[UM_MISSING_LIGHT_NUMBERS][UM_MISSING_LIGHT_NUMBERS];
  double right[UM_MISSING_LIGHT_NUMBERS], variance[UM_MISSING_LIGHT_NUMBERS];
  size_t n = a->nvalue = a->curve.n * (a->band == UM_MISSING_LIGHT_OWN ? o->nband : 1);
  a->chi2 = 0.0;
  s->tried++;
  for (size_t i = 0; i < n; i++) {
    if (fill_column(o, a, i, s->column) < UM_MISSING_LIGHT_ROWS) return;
    um_inference_projection_apply(&o->projection, s->column, s->left + i * o->nleft);
    for (size_t k = 0; k <= i; k++)
      gram[i][k] = gram[k][i] =
          um_inference_dot(o->nleft, s->left + i * o->nleft, s->left + k * o->nleft);
    right[i] = um_inference_dot(o->nleft, s->left + i * o->nleft, o->residual);
  }
  if (!solve(n, gram, right, a->value, variance)) return;
  for (size_t i = 0; i < n && a->kind == UM_LIGHT_FACTOR; i++)
    if (!(fabs(a->value[i]) <= UM_MISSING_LIGHT_FACTOR)) return;
  for (size_t i = 0; i < n; i++) {
    a->chi2 += a->value[i] * right[i];
    a->sigma[i] = sqrt(variance[i]);
  }
}

size_t um_missing_light_numbers(const struct um_missing_light_attempt *a)
{
  bool placed = a->curve.kind == UM_CURVE_BUMP || a->curve.kind == UM_CURVE_EDGE;
  return a->nvalue + (placed ? 2 : a->curve.kind == UM_CURVE_FALL ? 1 : 0);
}

/* Does it act on emitted light? */
static bool is_thermal(const struct um_missing_light_observations *o,
                       const struct um_missing_light_attempt *a)
{
  bool all = a->band == UM_MISSING_LIGHT_GREY || a->band == UM_MISSING_LIGHT_OWN, any = false;
  for (size_t b = 0; b < o->nband; b++) any = any || ((all || b == a->band) && o->thermal[b]);
  return any;
}

/* Is the coordinate one that the place knows? Emitted light does not know where the Sun is. */
static bool is_odd(const struct um_missing_light_observations *o,
                   const struct um_missing_light_attempt *a)
{
  enum um_effect_coordinate c = a->coordinate;
  bool sky = c >= UM_COORDINATE_AIRMASS; /* of the station, with elevation and azimuth */
  bool body = c >= UM_COORDINATE_SUN_X && c <= UM_COORDINATE_TURN_Z;
  bool earth = c == UM_COORDINATE_NADIR_SUN || c == UM_COORDINATE_SUNLIT;
  bool time = c == UM_COORDINATE_TIME; /* which costs UM_MISSING_LIGHT_TIME everywhere */
  bool sun = c == UM_COORDINATE_PHASE || (c >= UM_COORDINATE_SUN_X && c <= UM_COORDINATE_SUN_Z) ||
             (c >= UM_COORDINATE_BISECTOR_X && c <= UM_COORDINATE_BISECTOR_Z) || earth;
  if (sun && is_thermal(o, a)) return true;
  if (a->kind == UM_LIGHT_IRRADIANCE) return !sky && !time;
  if (a->kind == UM_LIGHT_INTENSITY || a->material < o->nmaterial) return sky || earth || time;
  return body;
}

double um_missing_light_worth(const struct um_missing_light_observations *o,
                              const struct um_missing_light_attempt *a, double scale)
{
  double n = (double)o->nobservation, odd = is_odd(o, a) ? UM_MISSING_LIGHT_ODD : 0.0;
  double k = (double)(um_missing_light_numbers(a) + UM_MISSING_LIGHT_CHOSEN);
  double time = a->coordinate == UM_COORDINATE_TIME ? UM_MISSING_LIGHT_TIME : 0.0;
  return a->chi2 / scale - k * log(n) - time - odd;
}

bool um_missing_light_range(const struct um_missing_light_observations *o,
                            enum um_effect_coordinate coordinate, double *from, double *to)
{
  const double *u = o->coordinate + (size_t)coordinate * o->nobservation;
  bool share = um_effect_is_circular(coordinate) || coordinate == UM_COORDINATE_SUNLIT ||
               coordinate == UM_COORDINATE_AIRMASS;
  *from = INFINITY;
  *to = -INFINITY;
  for (size_t j = 0; j < o->nobservation; j++) {
    if (!isfinite(u[j])) continue;
    *from = fmin(*from, u[j]);
    *to = fmax(*to, u[j]);
  }
  return *to - *from > (share ? UM_MISSING_LIGHT_RANGE_SHARE : UM_MISSING_LIGHT_RANGE);
}

/* One curve with the bands alone, alike and each on its own. */
static void try_bands(struct um_missing_light_search *s, size_t slot,
                      struct um_missing_light_attempt *a)
{
  struct um_missing_light_observations *o = s->o;
  for (size_t i = 0; i < o->nband + 2; i++) {
    a->band = i < o->nband ? i : i == o->nband ? UM_MISSING_LIGHT_GREY : UM_MISSING_LIGHT_OWN;
    if (i >= o->nband && o->nband < 2) continue; /* the same */
    if (a->band == UM_MISSING_LIGHT_GREY && a->kind != UM_LIGHT_FACTOR) continue;
    if (a->band == UM_MISSING_LIGHT_OWN && a->curve.n * o->nband > UM_MISSING_LIGHT_NUMBERS)
      continue;
    um_missing_light_fit(s, a);
    struct um_missing_light_attempt *best =
        &s->best[slot * UM_MISSING_LIGHT_COUNTS + um_missing_light_numbers(a)];
    if (a->chi2 > best->chi2) *best = *a;
  }
}

/* Every curve along a coordinate. */
static void try_curves(struct um_missing_light_search *s, size_t slot,
                       struct um_missing_light_attempt *a, double from, double to)
{
  int circular = um_effect_is_circular(a->coordinate);
  double range = to - from;
  bool opens = !circular || range < UM_MISSING_LIGHT_ARC; /* lines do not close */
  for (size_t n = 1; n <= UM_MISSING_LIGHT_KNOTS && opens; n++) {
    if (n == 1 && a->coordinate != UM_COORDINATE_PHASE) continue; /* a constant, once */
    a->curve = (struct um_effect_curve){UM_CURVE_HATS, n, from, to, 0};
    try_bands(s, slot, a);
  }
  for (size_t n = 1; n <= UM_MISSING_LIGHT_WAVES && circular; n++) {
    a->curve = (struct um_effect_curve){UM_CURVE_WAVES, 2 * n, 0.0, 1.0, 1};
    try_bands(s, slot, a);
  }
  for (int w = -2; w < UM_MISSING_LIGHT_WIDTHS && !circular; w++) {
    double length = ldexp(UM_MISSING_LIGHT_WIDEST * range, -w);
    a->curve = (struct um_effect_curve){UM_CURVE_FALL, 1, from, length, 0};
    try_bands(s, slot, a);
    a->curve = (struct um_effect_curve){UM_CURVE_FALL, 1, to, -length, 0};
    try_bands(s, slot, a);
  }
  for (int w = 0; w < UM_MISSING_LIGHT_WIDTHS; w++)
    for (size_t p = 0; p < UM_MISSING_LIGHT_PLACES; p++) {
      double at = s->sorted[(2 * p + 1) * s->nsorted / (2 * UM_MISSING_LIGHT_PLACES)];
      double width = ldexp(UM_MISSING_LIGHT_WIDEST * range, -w);
      a->curve = (struct um_effect_curve){UM_CURVE_BUMP, 1, at, width, circular};
      try_bands(s, slot, a);
      for (int sign = -1; sign <= 1 && !circular && w % 3 == 0; sign += 2) {
        a->curve = (struct um_effect_curve){UM_CURVE_EDGE, 1, at, 0.5 * sign * width, 0};
        try_bands(s, slot, a);
      }
    }
}

static int ascending(const void *a, const void *b)
{
  const double *x = a, *y = b;
  return (*x > *y) - (*x < *y);
}

/* The values of a coordinate in order: places of curves have as many observations between them. */
static enum um_status sort_values(struct um_context *context, struct um_missing_light_search *s,
                                  enum um_effect_coordinate coordinate)
{
  const double *u = s->o->coordinate + (size_t)coordinate * s->o->nobservation;
  s->nsorted = 0;
  for (size_t j = 0; j < s->o->nobservation; j++)
    if (isfinite(u[j])) s->sorted[s->nsorted++] = u[j];
  return um_core_sort(context, s->sorted, s->nsorted, sizeof *s->sorted, ascending);
}

enum um_status um_missing_light_search_create(struct um_context *context,
                                              struct um_missing_light_observations *o,
                                              struct um_missing_light_search *out)
{
  struct um_missing_light_search *s = out;
  *s = (struct um_missing_light_search){.o = o, .nslot = (o->nmaterial + 3) * UM_COORDINATES};
  UM_TRY(um_core_allocate(context, s->nslot * UM_MISSING_LIGHT_COUNTS, sizeof *s->best, &s->best));
  UM_TRY(um_core_allocate(context, o->nobservation, sizeof *s->column, &s->column));
  UM_TRY(um_core_allocate(context, o->nobservation, sizeof *s->sorted, &s->sorted));
  UM_TRY(um_core_allocate(context, UM_MISSING_LIGHT_NUMBERS * o->nleft, sizeof *s->left, &s->left));
  for (size_t i = 0; i < o->nmaterial + 3; i++)
    for (size_t c = 0; c < UM_COORDINATES; c++) {
      struct um_missing_light_attempt a = {.coordinate = (enum um_effect_coordinate)c};
      double from, to;
      a.kind = i <= o->nmaterial       ? UM_LIGHT_FACTOR
               : i == o->nmaterial + 1 ? UM_LIGHT_INTENSITY
                                       : UM_LIGHT_IRRADIANCE;
      a.material = i < o->nmaterial ? i : o->nmaterial;
      if (i < o->nmaterial && o->nmaterial == 1) continue; /* the same as all */
      UM_TRY(um_core_stop_check(context, "missing light was looked for"));
      if (!um_missing_light_range(o, a.coordinate, &from, &to)) continue;
      UM_TRY(sort_values(context, s, a.coordinate));
      try_curves(s, i * UM_COORDINATES + c, &a, from, to);
    }
  return UM_OK;
}

void um_missing_light_search_release(struct um_context *context, struct um_missing_light_search *s)
{
  UM_FREE(context, s->best, s->column, s->left, s->sorted);
}
