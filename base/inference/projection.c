/* Nuisance directions projected out. A nuisance n_j with prior width s_j is a column with one more
 * row that asks for 0 +- 1 after scaling,
 *
 *   min_b |v - N b|^2 + sum_j (b_j / s_j)^2 = |(I - QQ') (v, 0)|^2,   QR = [N; diag(1/s)],
 *
 * so that after the rotation by Q' what is left of any v is its numbers beyond the rank. Nuisances
 * may be collinear (the rank is less) or insensitive. */
#include "base/inference/projection.h"

#include <math.h>
#include <string.h>

#include "base/inference/algebra.h"

/* s = 0 is a nuisance that is known: no column. */
static bool is_known(double sigma) { return sigma <= 0.0; }

static enum um_status check(struct um_context *context, size_t nrow,
                            const struct um_inference_nuisance *nuisance, size_t *nprior)
{
  size_t nfree = 0;
  *nprior = 0;
  for (size_t j = 0; j < nuisance->count; j++) {
    if (isinf(nuisance->prior_sigma[j]))
      nfree++;
    else if (!is_known(nuisance->prior_sigma[j]))
      (*nprior)++;
  }
  if (nrow == 0 || nfree >= nrow)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%zu nuisance parameters without prior and %zu measurements: at least one "
                        "measurement more is needed",
                        nfree, nrow);
  return UM_OK;
}

enum um_status um_inference_projection_create(struct um_context *context, size_t nrow,
                                              const struct um_inference_nuisance *nuisance,
                                              struct um_inference_projection *out)
{
  enum um_status status;
  static const struct um_inference_nuisance none = {0};
  double *column = NULL;
  *out = (struct um_inference_projection){.nrow = nrow};
  if (nuisance == NULL) nuisance = &none;
  UM_CHECK(check(context, nrow, nuisance, &out->nprior));
  size_t total = nrow + out->nprior, ncolumn = 0, prior = nrow;
  UM_CHECK(um_core_allocate(context, total, sizeof *out->work, &out->work));
  UM_CHECK(um_core_allocate(context, nuisance->count * total, sizeof *column, &column));
  for (size_t j = 0; j < nuisance->count; j++) {
    double sigma = nuisance->prior_sigma[j], *c = column + ncolumn * total;
    if (is_known(sigma)) continue;
    memcpy(c, nuisance->column + j * nrow, nrow * sizeof *c);
    if (!isinf(sigma)) c[prior++] = 1.0 / sigma;
    ncolumn++;
  }
  out->nleft = total;
  if (ncolumn > 0) {
    UM_CHECK(um_inference_qr_create(context, total, ncolumn, column, UM_INFERENCE_RANK_TOLERANCE,
                                    &out->qr));
    out->nleft = total - um_inference_qr_rank(out->qr);
  }
  status = UM_OK;
done:
  um_core_free(context, column);
  return status;
}

void um_inference_projection_destroy(struct um_context *context,
                                     struct um_inference_projection *projection)
{
  um_inference_qr_destroy(context, &projection->qr);
  um_core_free(context, projection->work);
  projection->work = NULL;
}

void um_inference_projection_apply(struct um_inference_projection *projection, const double *v,
                                   double *out)
{
  size_t total = projection->nrow + projection->nprior;
  memcpy(projection->work, v, projection->nrow * sizeof *v);
  memset(projection->work + projection->nrow, 0, projection->nprior * sizeof *v);
  if (projection->qr != NULL) um_inference_qr_rotate(projection->qr, projection->work);
  memcpy(out, projection->work + (total - projection->nleft), projection->nleft * sizeof *out);
}

void um_inference_projection_direction(struct um_inference_projection *projection,
                                       const struct um_inference_direction *direction, double *left,
                                       double *kept)
{
  size_t nrow = projection->nrow, nleft = projection->nleft;
  *kept = 0.0;
  for (size_t j = 0; j < direction->ncolumn; j++) {
    const double *c = direction->column + j * nrow;
    double *l = left + j * nleft, sigma = direction->prior_sigma[j];
    double length = sqrt(um_inference_dot(nrow, c, c)), share = 0.0;
    /* of one prior width, so that the parameter's unit does not matter */
    double visible = length * (isinf(sigma) || !(sigma > 0.0) ? 1.0 : sigma);
    um_inference_projection_apply(projection, c, l);
    if (visible >= UM_INFERENCE_VISIBLE)
      share = fmin(1.0, sqrt(um_inference_dot(nleft, l, l)) / length);
    if (share > *kept) *kept = share;
    if (!(share >= UM_INFERENCE_KEPT)) memset(l, 0, nleft * sizeof *l);
  }
}
