/* A history of heat, h_b in every bin, as smooth as the observations allow (Phillips 1962, J. ACM
 * 9:84; Tikhonov):
 *
 *   min_h |r - D h|^2 + lambda |L h|^2,   (L h)_b = second difference of h over the bins,
 *
 * with the largest lambda at which |r - D h|^2 is what noise alone would leave (Morozov 1966): the
 * number of observations, or, where the best history leaves more, that and a unit for each of its
 * bins. sigma: of the posterior, (D'D + lambda L'L)^-1, which takes the true history to be smooth.
 */
#include "evidence/missing_heat/history_impl.h"

#include <math.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "evidence/missing_heat/policy.h"

struct history {
  size_t n, nobservation;
  double *r, *y;    /* [n][n] by columns, [n]: D compressed, and what it meets */
  double chi2_left; /* chi-square that no history explains */
  double *column;   /* [n][nobservation] with the damping below */
  double *right;    /* [nobservation] */
  double *work;     /* [n][n] */
};

static void history_release(struct um_context *context, struct history *h)
{
  UM_FREE(context, h->r, h->y, h->column, h->right, h->work);
}

static enum um_status history_create(struct um_context *context,
                                     const struct um_missing_heat_bins *bins,
                                     const double *residual, struct history *h)
{
  enum um_status status;
  size_t n = bins->nbin, nleft = bins->nleft, least = n < nleft ? n : nleft;
  struct um_inference_qr *qr = NULL;
  double *rotated = NULL;
  *h = (struct history){.n = n, .nobservation = n + (n > 2 ? n - 2 : 0)};
  UM_CHECK(um_core_allocate(context, n * n, sizeof *h->r, &h->r));
  UM_CHECK(um_core_allocate(context, n, sizeof *h->y, &h->y));
  UM_CHECK(um_core_allocate(context, n * h->nobservation, sizeof *h->column, &h->column));
  UM_CHECK(um_core_allocate(context, h->nobservation, sizeof *h->right, &h->right));
  UM_CHECK(um_core_allocate(context, n * n, sizeof *h->work, &h->work));
  UM_CHECK(um_core_allocate(context, nleft, sizeof *rotated, &rotated));
  UM_CHECK(
      um_inference_qr_create(context, nleft, n, bins->column, UM_MISSING_HEAT_RANK_TOLERANCE, &qr));
  memcpy(rotated, residual, nleft * sizeof *rotated);
  um_inference_qr_rotate(qr, rotated);
  um_inference_qr_compress(qr, h->r);
  memcpy(h->y, rotated, least * sizeof *rotated);
  h->chi2_left = um_inference_dot(nleft - least, rotated + least, rotated + least);
done:
  um_core_free(context, rotated);
  um_inference_qr_destroy(context, &qr);
  return status;
}

/* D over sqrt(lambda) L; second differences as if bins were alike, which they nearly are. */
static void damp(struct history *h, double lambda)
{
  double root = sqrt(lambda);
  memset(h->column, 0, h->n * h->nobservation * sizeof *h->column);
  for (size_t j = 0; j < h->n; j++) {
    memcpy(h->column + j * h->nobservation, h->r + j * h->n, h->n * sizeof *h->column);
    for (size_t k = h->n; k < h->nobservation; k++) {
      size_t b = k - h->n;
      h->column[j * h->nobservation + k] = j == b || j == b + 2 ? root
                                           : j == b + 1         ? -2.0 * root
                                                                : 0.0;
    }
  }
  memset(h->right, 0, h->nobservation * sizeof *h->right);
  memcpy(h->right, h->y, h->n * sizeof *h->right);
}

/* The history at lambda and its chi-square; covariance [n][n] or NULL. */
static enum um_status solve(struct um_context *context, struct history *h, double lambda,
                            double *heat, double *chi2, double *covariance)
{
  struct um_inference_qr *qr = NULL;
  damp(h, lambda);
  UM_TRY(um_inference_qr_create(context, h->nobservation, h->n, h->column,
                                UM_MISSING_HEAT_RANK_TOLERANCE, &qr));
  um_inference_qr_rotate(qr, h->right);
  um_inference_qr_solve(qr, h->right, heat);
  if (covariance != NULL) um_inference_qr_covariance(qr, h->work, covariance, NULL);
  um_inference_qr_destroy(context, &qr);
  *chi2 = h->chi2_left;
  for (size_t i = 0; i < h->n; i++) {
    double left = h->y[i];
    for (size_t j = 0; j < h->n; j++) left -= h->r[j * h->n + i] * heat[j];
    *chi2 += left * left;
  }
  return UM_OK;
}

enum um_status um_missing_heat_history(struct um_context *context,
                                       const struct um_missing_heat_bins *bins,
                                       const double *residual, double *heat, double *sigma)
{
  enum um_status status;
  struct history h = {0};
  double *covariance = NULL, chi2, least, n = (double)bins->nbin;
  UM_CHECK(history_create(context, bins, residual, &h));
  UM_CHECK(um_core_allocate(context, bins->nbin * bins->nbin, sizeof *covariance, &covariance));
  /* trace(D'D) / trace(L'L), nearly: each of the n - 2 rows of L adds 1 + 4 + 1 to its own */
  double scale = um_inference_dot(bins->nbin * bins->nbin, h.r, h.r) / (6.0 * n);
  double low = -UM_MISSING_HEAT_DECADES, high = UM_MISSING_HEAT_DECADES;
  if (!(scale > 0.0)) scale = 1.0;
  UM_CHECK(solve(context, &h, scale * pow(10.0, low), heat, &least, NULL));
  double wanted = fmax((double)bins->nleft, least + n);
  for (int k = 0; k < UM_MISSING_HEAT_HALVINGS; k++) {
    double middle = 0.5 * (low + high);
    UM_CHECK(solve(context, &h, scale * pow(10.0, middle), heat, &chi2, NULL));
    if (chi2 <= wanted)
      low = middle;
    else
      high = middle;
  }
  UM_CHECK(solve(context, &h, scale * pow(10.0, low), heat, &chi2, covariance));
  for (size_t b = 0; b < bins->nbin; b++) sigma[b] = sqrt(covariance[b * bins->nbin + b]);
done:
  um_core_free(context, covariance);
  history_release(context, &h);
  return status;
}
