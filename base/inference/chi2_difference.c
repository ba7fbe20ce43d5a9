/* Expected chi-square between a change s of the observations and the best that a direction with
 * columns D and prior widths w can do in its place, nuisances along,
 *
 *   min_b |s - D b|^2 + sum_j (b_j / w_j)^2   with s and D after the nuisances,
 *
 * which is the minimum over both at once since the nuisances were projected with their priors. The
 * widths are observations of their own, value 0. The change itself is certain: no prior for s. */
#include <math.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "base/inference/projection.h"
#include "base/inference/score.h"

/* s [nleft]; left [ncolumn][nleft]; both are not changed. */
static enum um_status against(struct um_context *context, size_t nleft, const double *s,
                              const struct um_inference_direction *d, const double *left,
                              double *out)
{
  enum um_status status;
  struct um_inference_qr *qr = NULL;
  double *column = NULL, *rotated = NULL;
  size_t total = nleft + d->ncolumn, n = 0;
  UM_CHECK(um_core_allocate(context, d->ncolumn * total, sizeof *column, &column));
  UM_CHECK(um_core_allocate(context, total, sizeof *rotated, &rotated));
  for (size_t j = 0; j < d->ncolumn; j++) {
    double sigma = d->prior_sigma[j], *c = column + n * total;
    const double *l = left + j * nleft;
    if (sigma <= 0.0 || um_inference_dot(nleft, l, l) <= 0.0) continue;
    memcpy(c, l, nleft * sizeof *c);
    if (!isinf(sigma)) c[nleft + j] = 1.0 / sigma;
    n++;
  }
  memcpy(rotated, s, nleft * sizeof *s);
  UM_CHECK(um_inference_qr_create(context, total, n, column, UM_INFERENCE_RANK_TOLERANCE, &qr));
  um_inference_qr_rotate(qr, rotated);
  size_t rank = um_inference_qr_rank(qr);
  *out = um_inference_dot(total - rank, rotated + rank, rotated + rank);
done:
  UM_FREE(context, column, rotated);
  um_inference_qr_destroy(context, &qr);
  return status;
}

enum um_status
um_inference_chi2_difference(struct um_context *context, size_t nobservation, const double *signal,
                             const struct um_inference_nuisance *nuisance, size_t ndirection,
                             const struct um_inference_direction *direction, double *out)
{
  enum um_status status;
  struct um_inference_projection projection = {0};
  double *s = NULL, *left = NULL;
  size_t widest = 0;
  for (size_t i = 0; i < ndirection; i++)
    widest = direction[i].ncolumn > widest ? direction[i].ncolumn : widest;
  UM_CHECK(um_inference_projection_create(context, nobservation, nuisance, &projection));
  UM_CHECK(um_core_allocate(context, projection.nleft, sizeof *s, &s));
  UM_CHECK(um_core_allocate(context, widest * projection.nleft, sizeof *left, &left));
  um_inference_projection_apply(&projection, signal, s);
  for (size_t i = 0; i < ndirection; i++) {
    double kept;
    um_inference_projection_direction(&projection, &direction[i], left, &kept);
    UM_CHECK(against(context, projection.nleft, s, &direction[i], left, &out[i]));
  }
done:
  UM_FREE(context, s, left);
  um_inference_projection_destroy(context, &projection);
  return status;
}
