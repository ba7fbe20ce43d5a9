/* Replaces two effects by a better pair. The best single candidate may be neither of two hidden
 * effects, but one that resembles their sum. So after each step all pairs are ranked by what they
 * explain together in the linear model,
 *
 *   S_ij = |projection of r on [D_i D_j]|^2,     with the priors as pseudo-observations,
 *
 * beside the other effects. The best pairs are fitted. */
#include <math.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "base/inference/projection.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/steps_impl.h"
#include "evidence/diagnosis/trials_impl.h"

#define COLUMNS (2 * UM_EFFECT_PARAMETERS_MAX)

/* Columns of all candidates after the projection. */
struct left {
  size_t n;         /* observations */
  double *column;   /* one after another */
  size_t *at;       /* [count] first column of a candidate */
  double *residual; /* [n] */
};

static void left_release(struct um_context *context, struct left *left)
{
  UM_FREE(context, left->column, left->at, left->residual);
}

static enum um_status left_make(struct um_context *context, const struct um_diagnosis_work *work,
                                const struct um_diagnosis_state *state,
                                const struct um_diagnosis_directions *d, struct left *left)
{
  enum um_status status;
  size_t rows = work->forward->observations.count, count = work->candidates->count, columns = 0;
  struct um_inference_projection projection = {0};
  double *residual = NULL;
  UM_CHECK(um_core_allocate(context, count, sizeof *left->at, &left->at));
  for (size_t i = 0; i < count; i++) {
    left->at[i] = columns;
    columns += d->direction[i].ncolumn;
  }
  UM_CHECK(um_core_allocate(context, rows, sizeof *residual, &residual));
  um_diagnosis_residual_at_means(work, state, rows, residual);
  UM_CHECK(um_inference_projection_create(context, rows, &d->nuisance, &projection));
  left->n = projection.nleft;
  UM_CHECK(um_core_allocate(context, columns * left->n, sizeof *left->column, &left->column));
  UM_CHECK(um_core_allocate(context, left->n, sizeof *left->residual, &left->residual));
  um_inference_projection_apply(&projection, residual, left->residual);
  for (size_t i = 0; i < count; i++) {
    double kept;
    um_inference_projection_direction(&projection, &d->direction[i],
                                      left->column + left->at[i] * left->n, &kept);
  }
done:
  um_core_free(context, residual);
  um_inference_projection_destroy(context, &projection);
  return status;
}

/* Chi-square that two candidates explain together; -1 where the best values are on the wrong side
 * of a bound at null. matrix: [COLUMNS][n + COLUMNS], rotated: [n + COLUMNS]. */
static enum um_status explained(struct um_context *context, const struct left *left,
                                const struct um_inference_direction *direction,
                                const struct um_diagnosis_pair *pair, double *matrix,
                                double *rotated, double *out)
{
  struct um_inference_qr *qr = NULL;
  const struct um_inference_direction *d[2] = {&direction[pair->candidate[0]],
                                               &direction[pair->candidate[1]]};
  size_t columns = d[0]->ncolumn + d[1]->ncolumn, rows = left->n + columns, c = 0;
  double x[COLUMNS];
  for (int i = 0; i < 2; i++)
    for (size_t k = 0; k < d[i]->ncolumn; k++, c++) {
      double *column = matrix + c * rows;
      memcpy(column, left->column + (left->at[pair->candidate[i]] + k) * left->n,
             left->n * sizeof *column);
      for (size_t j = left->n; j < rows; j++) column[j] = 0.0;
      column[left->n + c] = 1.0 / d[i]->prior_sigma[k];
    }
  UM_TRY(um_inference_qr_create(context, rows, columns, matrix, UM_INFERENCE_RANK_TOLERANCE, &qr));
  memcpy(rotated, left->residual, left->n * sizeof *rotated);
  for (size_t j = left->n; j < rows; j++) rotated[j] = 0.0;
  um_inference_qr_rotate(qr, rotated);
  um_inference_qr_solve(qr, rotated, x);
  *out = um_inference_dot(um_inference_qr_rank(qr), rotated, rotated);
  um_inference_qr_destroy(context, &qr);
  c = 0;
  for (int i = 0; i < 2; i++)
    for (size_t k = 0; k < d[i]->ncolumn; k++, c++)
      if ((d[i]->minimum_step[k] == 0.0 && x[c] < 0.0) ||
          (d[i]->maximum_step[k] == 0.0 && x[c] > 0.0))
        *out = -1.0;
  return UM_OK;
}

/* Insert the pair into the list of the best, which is sorted by worth, falling. */
static void offer(struct um_diagnosis_pair *best, size_t *count, struct um_diagnosis_pair pair)
{
  size_t at = *count < UM_DIAGNOSIS_PAIRS ? (*count)++ : UM_DIAGNOSIS_PAIRS;
  for (; at > 0 && (at == UM_DIAGNOSIS_PAIRS || best[at - 1].worth < pair.worth); at--) {
    if (at == UM_DIAGNOSIS_PAIRS && !(best[at - 1].worth < pair.worth)) return;
    if (at < UM_DIAGNOSIS_PAIRS) best[at] = best[at - 1];
  }
  if (at < UM_DIAGNOSIS_PAIRS) best[at] = pair;
}

static bool is_open(const struct um_diagnosis_work *work, const struct um_diagnosis_state *state,
                    size_t i)
{
  const struct um_sensitivity_candidate *c = &work->candidates->candidate[i];
  /* rough ones need a scan each, and there are too many pairs */
  return !c->insensitive && !um_diagnosis_is_rough(c) && !um_diagnosis_is_taken(state, c);
}

enum um_status um_diagnosis_pairs_find(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_diagnosis_state *state,
                                       struct um_diagnosis_pair best[UM_DIAGNOSIS_PAIRS],
                                       size_t *count)
{
  const struct um_sensitivity_candidate *all = work->candidates->candidate;
  enum um_status status;
  struct um_diagnosis_directions d = {0};
  struct left left = {0};
  double *matrix = NULL, *rotated = NULL, penalty = log((double)work->forward->observations.count);
  *count = 0;
  UM_CHECK(um_diagnosis_directions_make(context, work, state, &d));
  UM_CHECK(left_make(context, work, state, &d, &left));
  UM_CHECK(um_core_allocate(context, COLUMNS * (left.n + COLUMNS), sizeof *matrix, &matrix));
  UM_CHECK(um_core_allocate(context, left.n + COLUMNS, sizeof *rotated, &rotated));
  for (size_t i = 0; i < work->candidates->count; i++) {
    if (!is_open(work, state, i)) continue;
    for (size_t j = i + 1; j < work->candidates->count; j++) {
      if (!is_open(work, state, j) || um_diagnosis_is_same_effect(&all[i], &all[j])) continue;
      struct um_diagnosis_pair pair = {{i, j}, 0.0};
      double columns = (double)(d.direction[i].ncolumn + d.direction[j].ncolumn);
      UM_CHECK(explained(context, &left, d.direction, &pair, matrix, rotated, &pair.worth));
      if (pair.worth < 0.0) continue;
      pair.worth -= columns * penalty;
      offer(best, count, pair);
    }
  }
done:
  UM_FREE(context, rotated, matrix);
  left_release(context, &left);
  um_diagnosis_directions_release(context, &d);
  return status;
}

/* Trials of the pairs that are not the two blocks as they are; how many. */
static size_t trials_of(const struct um_diagnosis_pair *pair, size_t count, const size_t now[2],
                        double prune_above, struct um_diagnosis_trial *trial)
{
  size_t n = 0;
  for (size_t i = 0; i < count; i++) {
    const size_t *c = pair[i].candidate;
    if ((c[0] == now[0] && c[1] == now[1]) || (c[0] == now[1] && c[1] == now[0])) continue;
    trial[n++] = (struct um_diagnosis_trial){
        .candidate = {c[0], c[1]}, .ncandidate = 2, .prune_above = prune_above, .lead = -INFINITY};
  }
  return n;
}

/* Try pairs instead of the last block and block b. */
static enum um_status swap_with(struct um_context *context, const struct um_diagnosis_work *work,
                                size_t b, struct um_diagnosis_state *state, bool *better)
{
  enum um_status status;
  struct um_diagnosis_state less = {0}, without = {0};
  struct um_diagnosis_pair best[UM_DIAGNOSIS_PAIRS];
  struct um_diagnosis_trial trial[UM_DIAGNOSIS_PAIRS] = {{.ncandidate = 0}};
  size_t count = 0, now[2] = {state->block[b].candidate, state->block[state->nblock - 1].candidate};
  UM_CHECK(um_diagnosis_without(context, work, state, state->nblock - 1, &less));
  UM_CHECK(um_diagnosis_without(context, work, &less, b, &without));
  UM_CHECK(um_diagnosis_pairs_find(context, work, &without, best, &count));
  count = trials_of(best, count, now, state->fit->bic - UM_DIAGNOSIS_BETTER, trial);
  UM_CHECK(um_diagnosis_trials_fit(context, work, &without, trial, count));
  for (size_t i = 0; i < count; i++) {
    if (trial[i].refused || !(trial[i].state.fit->bic < state->fit->bic - UM_DIAGNOSIS_BETTER))
      continue;
    struct um_diagnosis_state other = *state;
    *state = trial[i].state;
    trial[i].state = other;
    *better = true;
  }
done:
  um_diagnosis_trials_release(context, trial, UM_DIAGNOSIS_PAIRS);
  um_diagnosis_state_release(context, &without);
  um_diagnosis_state_release(context, &less);
  return status;
}

enum um_status um_diagnosis_pair_swap(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      struct um_diagnosis_state *state)
{
  for (size_t b = state->nnuisance; b + 1 < state->nblock; b++) {
    bool better = false;
    UM_TRY(swap_with(context, work, b, state, &better));
    if (better) break; /* blocks have moved; the next step looks again */
  }
  return UM_OK;
}
