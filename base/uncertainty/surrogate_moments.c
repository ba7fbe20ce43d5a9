/* Mean, variance and Sobol' indices of a surrogate in closed form.
 *
 * On each axis h_k = sum_(l <= k) r_lk p_l with p_l orthonormal under the parameter's distribution,
 * which is the QR decomposition of the h_k at the nodes of a quadrature. Axis by axis the surpluses
 * become coefficients c_nu of products of p (a polynomial chaos), on the same terms, since with a
 * term all lower ones are there. Then (Sudret 2008, Reliab. Eng. Syst. Saf. 93:964)
 *   mean = c_0,  V = sum_(nu != 0) c_nu^2,  V_i = sum over nu of axis i alone,
 *   V_Ti = sum over nu with nu_i > 0. */
#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/uncertainty/surrogate_impl.h"

#define NODES    256
#define ROUNDING 1e-13 /* of a value, below which its variation is none */

struct quadrature {
  size_t n;
  double *place, *weight; /* [n] */
};

/* Nodes equally likely for a list, otherwise Gauss and Legendre's over the shares. */
static enum um_status make_quadrature(struct um_context *context,
                                      const struct um_uncertainty_distribution *law,
                                      struct quadrature *q)
{
  bool list = law->kind == UM_UNCERTAINTY_LIST;
  q->n = list ? law->nvalue : NODES;
  UM_TRY(um_core_allocate(context, q->n, sizeof *q->place, &q->place));
  UM_TRY(um_core_allocate(context, q->n, sizeof *q->weight, &q->weight));
  gsl_integration_glfixed_table *table = list ? NULL : gsl_integration_glfixed_table_alloc(NODES);
  if (!list && table == NULL)
    return um_core_fail(context, UM_ERR_MEMORY, "out of memory for a quadrature");
  for (size_t i = 0; i < q->n; i++) {
    double u = 0.0, w = 1.0 / (double)q->n, value;
    if (list) {
      value = law->value[i];
    } else {
      gsl_integration_glfixed_point(0.0, 1.0, i, &u, &w, table);
      value = um_uncertainty_distribution_value(law, u);
    }
    q->place[i] = um_uncertainty_distribution_place(law, value);
    q->weight[i] = w;
  }
  if (table != NULL) gsl_integration_glfixed_table_free(table);
  return UM_OK;
}

/* r [levels][levels], r[l][k]: modified Gram and Schmidt, twice, of columns h_k(node) sqrt(weight).
 * A list of m values carries polynomials below degree m only: the rest is 0 on it. */
static enum um_status triangle(struct um_context *context, const struct um_uncertainty_surrogate *s,
                               size_t levels, const struct quadrature *q,
                               double r[UM_UNCERTAINTY_LEVELS][UM_UNCERTAINTY_LEVELS])
{
  enum um_status status;
  double *column = NULL, h[UM_UNCERTAINTY_LEVELS];
  UM_CHECK(um_core_allocate(context, levels, q->n * sizeof *column, &column));
  memset(r, 0, sizeof(double) * UM_UNCERTAINTY_LEVELS * UM_UNCERTAINTY_LEVELS);
  for (size_t i = 0; i < q->n; i++) {
    um_uncertainty_axis_basis(&s->axis, q->place[i], levels, h);
    for (size_t k = 0; k < levels; k++) column[k * q->n + i] = h[k] * sqrt(q->weight[i]);
  }
  for (size_t k = 0; k < levels; k++) {
    double *c = column + k * q->n, length = 0.0, before = 0.0;
    for (size_t i = 0; i < q->n; i++) before += c[i] * c[i];
    for (size_t round = 0; round < 2; round++)
      for (size_t l = 0; l < k; l++) {
        double product = 0.0;
        for (size_t i = 0; i < q->n; i++) product += column[l * q->n + i] * c[i];
        for (size_t i = 0; i < q->n; i++) c[i] -= product * column[l * q->n + i];
        r[l][k] += product;
      }
    for (size_t i = 0; i < q->n; i++) length += c[i] * c[i];
    r[k][k] = length > 1e-24 * before ? sqrt(length) : 0.0;
    for (size_t i = 0; i < q->n; i++) c[i] = r[k][k] > 0.0 ? c[i] / r[k][k] : 0.0;
  }
done:
  um_core_free(context, column);
  return status;
}

/* weight [nterm][nterm]: c_nu = sum_mu weight[nu][mu] s_mu is one axis after the other, which is
 * built for all axes at once: prod_i r^i(nu_i, mu_i), 0 unless nu <= mu. */
static enum um_status make_weights(struct um_context *context,
                                   const struct um_uncertainty_surrogate *s,
                                   const struct um_uncertainty_distribution *law, double *weight)
{
  double r[UM_UNCERTAINTY_LEVELS][UM_UNCERTAINTY_LEVELS];
  for (size_t i = 0; i < s->nterm * s->nterm; i++) weight[i] = 1.0;
  for (size_t axis = 0; axis < s->d; axis++) {
    struct quadrature q = {0};
    enum um_status status = make_quadrature(context, &law[axis], &q);
    if (status == UM_OK) status = triangle(context, s, s->levels[axis], &q, r);
    UM_FREE(context, q.place, q.weight);
    UM_TRY(status);
    for (size_t a = 0; a < s->nterm; a++)
      for (size_t b = 0; b < s->nterm; b++)
        weight[a * s->nterm + b] *= r[s->term[a].degree[axis]][s->term[b].degree[axis]];
  }
  return UM_OK;
}

/* Which sums a coefficient belongs to: the only axis that it varies with, or SIZE_MAX. */
static size_t only_axis(const struct um_uncertainty_surrogate *s, size_t t)
{
  size_t only = SIZE_MAX;
  for (size_t k = 0; k < s->d; k++) {
    if (s->term[t].degree[k] == 0) continue;
    if (only != SIZE_MAX) return SIZE_MAX;
    only = k;
  }
  return only;
}

/* Sums of value k over the coefficients c [nterm]. */
static void sums(const struct um_uncertainty_surrogate *s, const double *c, double *variance,
                 double *alone, double *any)
{
  *variance = 0.0;
  for (size_t k = 0; k < s->d; k++) alone[k] = any[k] = 0.0;
  for (size_t t = 0; t < s->nterm; t++) {
    double square = c[t] * c[t];
    size_t only = only_axis(s, t);
    bool varies = false;
    if (only != SIZE_MAX) alone[only] += square;
    for (size_t k = 0; k < s->d; k++) {
      if (s->term[t].degree[k] == 0) continue;
      any[k] += square;
      varies = true;
    }
    if (varies) *variance += square;
  }
}

enum um_status
um_uncertainty_surrogate_moments(struct um_context *context,
                                 const struct um_uncertainty_surrogate *surrogate,
                                 const struct um_uncertainty_distribution *distribution,
                                 double *mean, double *variance, double *first, double *total)
{
  enum um_status status;
  const struct um_uncertainty_surrogate *s = surrogate;
  size_t n = s->nterm;
  double *weight = NULL, *work = NULL;
  UM_CHECK(um_core_allocate(context, n, n * sizeof *weight, &weight));
  UM_CHECK(um_core_allocate(context, n, sizeof *work, &work));
  UM_CHECK(make_weights(context, s, distribution, weight));
  for (size_t k = 0; k < s->nvalue; k++) {
    double v, alone[UM_UNCERTAINTY_SURROGATE_DIMENSIONS_MAX],
        any[UM_UNCERTAINTY_SURROGATE_DIMENSIONS_MAX], scale = 0.0;
    for (size_t a = 0; a < n; a++) {
      double c = 0.0;
      for (size_t b = a; b < n; b++) c += weight[a * n + b] * s->term[b].surplus[k];
      work[a] = c;
    }
    for (size_t t = 0; t < n; t++) scale = fmax(scale, fabs(s->term[t].surplus[k]));
    sums(s, work, &v, alone, any);
    bool none = !(sqrt(v) > ROUNDING * scale);
    if (mean != NULL) mean[k] = s->nowhere[k] ? NAN : work[0];
    if (variance != NULL) variance[k] = s->nowhere[k] ? NAN : none ? 0.0 : v;
    for (size_t i = 0; i < s->d; i++) {
      if (first != NULL) first[i * s->nvalue + k] = none ? NAN : alone[i] / v;
      if (total != NULL) total[i * s->nvalue + k] = none ? NAN : any[i] / v;
    }
  }
done:
  UM_FREE(context, weight, work);
  return status;
}
