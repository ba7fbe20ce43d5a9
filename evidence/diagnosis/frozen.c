/* An effect's values from one half of the blocks of time, held before the other half: with s what
 * they change there, after nuisances, and r the residual without the effect,
 *
 *   z = r's / |s| ~ N(0, 1) where there is no such effect;   both halves: (z_1 + z_2) / sqrt 2. */
#include <math.h>

#include "base/inference/algebra.h"
#include "base/inference/projection.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/sceptic_impl.h"

/* What a half sees; the rest is 0. */
struct half {
  struct um_inference_nuisance nuisance;
  struct um_inference_direction direction;
  double *residual; /* [n] */
  double *room;     /* nuisances, own columns, residual */
};

static enum um_status half_make(struct um_context *context, const struct um_diagnosis_doubt *s,
                                const bool *kept, struct half *out)
{
  static const double low[UM_EFFECT_PARAMETERS_MAX] = {-INFINITY, -INFINITY, -INFINITY, -INFINITY,
                                                       -INFINITY, -INFINITY, -INFINITY, -INFINITY};
  static const double high[UM_EFFECT_PARAMETERS_MAX] = {INFINITY, INFINITY, INFINITY, INFINITY,
                                                        INFINITY, INFINITY, INFINITY, INFINITY};
  size_t k = s->without.nparameter, n = s->n;
  UM_TRY(um_core_allocate(context, (k + s->ncolumn + 1) * n, sizeof *out->room, &out->room));
  double *own = out->room + k * n;
  out->residual = own + s->ncolumn * n;
  um_diagnosis_keep_rows(s->d.nuisance.column, k, n, kept, out->room);
  um_diagnosis_keep_rows(s->column, s->ncolumn, n, kept, own);
  um_diagnosis_keep_rows(s->residual, 1, n, kept, out->residual);
  out->nuisance = (struct um_inference_nuisance){k, out->room, s->d.nuisance.prior_sigma};
  out->direction = (struct um_inference_direction){s->ncolumn, own, low, high, high, 0};
  return UM_OK;
}

/* z of a half with the values of the other; NaN where one of them sees nothing. */
static enum um_status foretold(struct um_context *context, const struct um_diagnosis_doubt *s,
                               const struct half *here, const struct half *other, double *z)
{
  enum um_status status;
  struct um_inference_projection projection = {0};
  struct um_inference_score score = {0};
  double *change = NULL, *left = NULL;
  *z = NAN;
  UM_CHECK(um_inference_score_test(context, s->n, other->residual, &other->nuisance, 1,
                                   &other->direction, &score));
  UM_CHECK(um_core_allocate(context, s->n, sizeof *change, &change));
  for (size_t k = 0; k < s->ncolumn && !score.absorbed; k++)
    for (size_t j = 0; j < s->n && isfinite(score.estimate[k]); j++)
      change[j] += score.estimate[k] * here->direction.column[k * s->n + j];
  UM_CHECK(um_inference_projection_create(context, s->n, &here->nuisance, &projection));
  UM_CHECK(um_core_allocate(context, 2 * projection.nleft, sizeof *left, &left));
  um_inference_projection_apply(&projection, change, left);
  um_inference_projection_apply(&projection, here->residual, left + projection.nleft);
  double length = sqrt(um_inference_dot(projection.nleft, left, left));
  if (length > 0.0) *z = um_inference_dot(projection.nleft, left, left + projection.nleft) / length;
done:
  UM_FREE(context, change, left);
  um_inference_projection_destroy(context, &projection);
  return status;
}

enum um_status um_diagnosis_frozen(struct um_context *context, const struct um_diagnosis_doubt *s,
                                   double *out)
{
  enum um_status status;
  double z[2] = {NAN, NAN};
  size_t *block = NULL;
  bool *kept = NULL;
  struct half half[2] = {0};
  UM_CHECK(um_core_allocate(context, s->n, sizeof *block, &block));
  UM_CHECK(um_core_allocate(context, s->n, sizeof *kept, &kept));
  um_diagnosis_time_blocks(&s->work->forward->observations, UM_DIAGNOSIS_BLOCKS, block);
  for (size_t h = 0; h < 2; h++) { /* blocks by turns */
    for (size_t j = 0; j < s->n; j++) kept[j] = block[j] % 2 == h;
    UM_CHECK(half_make(context, s, kept, &half[h]));
  }
  for (size_t h = 0; h < 2; h++) UM_CHECK(foretold(context, s, &half[h], &half[1 - h], &z[h]));
  *out = isnan(z[0]) ? z[1] : isnan(z[1]) ? z[0] : (z[0] + z[1]) / sqrt(2.0);
done:
  UM_FREE(context, block, kept, half[0].room, half[1].room);
  return status;
}
