/* Four simple methods on the candidates and signatures of this program. All are linear about the
 * scenario as it stands: residual r = sum of columns times values, whitened. A switch is on or off:
 * its column counts whole and costs no parameter. A candidate whose best value leaves its range is
 * passed over. Values are unbounded otherwise and have no prior. */
#include <gsl/gsl_cdf.h>
#include <math.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "base/inference/distributions.h"
#include "base/inference/policy.h"
#include "tests/bench/worlds.h"

const char *const worlds_baselines[WORLDS_BASELINES] = {"bic", "hold-out", "forward",
                                                        "discrepancy"};

#define LEVEL     0.01
#define FOLDS     5
#define STEPS_MAX 4
#define COLUMNS   (STEPS_MAX * UM_EFFECT_PARAMETERS_MAX)

struct problem {
  struct um_context *context;
  const struct um_sensitivity_candidates *candidates;
  size_t n, nchannel;
  const double *t;
  const size_t *channel;
  double *r, *sigma;              /* [n] whitened residual; of the observations */
  size_t *fold;                   /* [n] block of time */
  double *column, *rotated, *fit; /* [COLUMNS][n], [n], [n] room */
};

struct solution {
  double chi2, dof;
  double x[COLUMNS], deviation[COLUMNS]; /* of the columns of the candidates in turn */
  size_t ncolumn;
};

static const struct um_sensitivity_candidate *get(const struct problem *p, size_t i)
{
  return &p->candidates->candidate[i];
}

/* Least squares by candidates `which` [m] on the rows whose block is not `without` (FOLDS: all);
 * p->fit is what they explain of r, in all rows. */
static enum um_status solve(const struct problem *p, const double *r, const size_t *which, size_t m,
                            size_t without, struct solution *out)
{
  enum um_status status = UM_OK;
  struct um_inference_qr *qr = NULL;
  double work[COLUMNS * COLUMNS], covariance[COLUMNS * COLUMNS];
  bool determined[COLUMNS];
  size_t of[COLUMNS], at[COLUMNS];
  *out = (struct solution){0};
  memset(p->fit, 0, p->n * sizeof *p->fit);
  for (size_t i = 0; i < m; i++) {
    const struct um_sensitivity_candidate *c = get(p, which[i]);
    for (size_t k = 0; k < c->ncolumn; k++)
      if (c->is_switch)
        for (size_t j = 0; j < p->n; j++) p->fit[j] += c->signature[j] / p->sigma[j];
      else {
        of[out->ncolumn] = which[i];
        at[out->ncolumn++] = k;
      }
  }
  for (size_t k = 0; k < out->ncolumn; k++)
    for (size_t j = 0; j < p->n; j++)
      p->column[k * p->n + j] =
          p->fold[j] == without ? 0.0 : get(p, of[k])->signature[at[k] * p->n + j] / p->sigma[j];
  for (size_t j = 0; j < p->n; j++) p->rotated[j] = p->fold[j] == without ? 0.0 : r[j] - p->fit[j];
  if (out->ncolumn > 0) {
    UM_CHECK(um_inference_qr_create(p->context, p->n, out->ncolumn, p->column,
                                    UM_INFERENCE_RANK_TOLERANCE, &qr));
    um_inference_qr_rotate(qr, p->rotated);
    um_inference_qr_solve(qr, p->rotated, out->x);
    um_inference_qr_covariance(qr, work, covariance, determined);
    out->dof = (double)um_inference_qr_rank(qr);
  }
  for (size_t k = 0; k < out->ncolumn; k++) {
    out->deviation[k] = determined[k] ? sqrt(covariance[k * out->ncolumn + k]) : (double)NAN;
    for (size_t j = 0; j < p->n; j++)
      p->fit[j] += out->x[k] * get(p, of[k])->signature[at[k] * p->n + j] / p->sigma[j];
  }
  for (size_t j = 0; j < p->n; j++)
    if (p->fold[j] != without) out->chi2 += (r[j] - p->fit[j]) * (r[j] - p->fit[j]);
done:
  um_inference_qr_destroy(p->context, &qr);
  return status;
}

/* Whether the last candidate's values lie within its range. */
static bool is_within(const struct problem *p, size_t candidate, const struct solution *s)
{
  const struct um_sensitivity_candidate *c = get(p, candidate);
  if (c->insensitive) return false;
  if (c->is_switch) return true;
  for (size_t k = 0; k < c->ncolumn; k++) {
    size_t of = c->parameter[k];
    double value = c->null_value[of] + s->x[s->ncolumn - c->ncolumn + k];
    if (!(value >= c->minimum[of] && value <= c->maximum[of])) return false;
  }
  return true;
}

static void name(const struct problem *p, const size_t *which, size_t m, const struct solution *s,
                 struct worlds_answer *out)
{
  size_t k = 0;
  snprintf(out->verdict, sizeof out->verdict, m > 0 ? "found" : "complete");
  for (size_t i = 0; i < m; i++) {
    const struct um_sensitivity_candidate *c = get(p, which[i]);
    worlds_append(out->certain, sizeof out->certain, " ", c->name);
    for (size_t j = 0; j < c->ncolumn && !c->is_switch; j++, k++) {
      char text[WORLDS_TEXT];
      snprintf(text, sizeof text, "%s %s %.6g %.3g", c->name,
               c->effect->parameters[c->parameter[j]].name,
               c->null_value[c->parameter[j]] + s->x[k], s->deviation[k]);
      worlds_append(out->values, sizeof out->values, " + ", text);
    }
  }
}

static double square(size_t n, const double *v) { return um_inference_dot(n, v, v); }

/* The one candidate of least BIC, where that is below the scenario's. */
static enum um_status by_bic(const struct problem *p, struct worlds_answer *out)
{
  double best = square(p->n, p->r), penalty = log((double)p->n);
  size_t winner = SIZE_MAX;
  struct solution s, of_winner = {0};
  for (size_t i = 0; i < p->candidates->count; i++) {
    UM_TRY(solve(p, p->r, &i, 1, FOLDS, &s));
    double bic = s.chi2 + s.dof * penalty;
    if (!is_within(p, i, &s) || !(bic < best)) continue;
    best = bic;
    winner = i;
    of_winner = s;
  }
  name(p, &winner, winner != SIZE_MAX, &of_winner, out);
  return UM_OK;
}

static enum um_status held_out(const struct problem *p, size_t candidate, double *sum)
{
  struct solution s;
  *sum = 0.0;
  for (size_t k = 0; k < FOLDS; k++) {
    UM_TRY(solve(p, p->r, &candidate, 1, k, &s));
    for (size_t j = 0; j < p->n; j++)
      if (p->fold[j] == k) *sum += (p->r[j] - p->fit[j]) * (p->r[j] - p->fit[j]);
  }
  return UM_OK;
}

/* The candidate that predicts held-out blocks best, where an F-test of the whole bears it out. */
static enum um_status by_hold_out(const struct problem *p, struct worlds_answer *out)
{
  double null = square(p->n, p->r), best = null;
  size_t winner = SIZE_MAX;
  struct solution s, of_winner = {0};
  for (size_t i = 0; i < p->candidates->count; i++) {
    double sum;
    UM_TRY(solve(p, p->r, &i, 1, FOLDS, &s));
    if (!is_within(p, i, &s)) continue;
    UM_TRY(held_out(p, i, &sum));
    if (!(sum < best)) continue;
    best = sum;
    winner = i;
    of_winner = s;
  }
  double spent = fmax(1.0, of_winner.dof), left = (double)p->n - spent;
  double f = (null - of_winner.chi2) / spent / (of_winner.chi2 / left);
  bool bears_out = winner != SIZE_MAX && f > 0.0 && gsl_cdf_fdist_Q(f, spent, left) < LEVEL;
  name(p, &winner, bears_out, &of_winner, out);
  return UM_OK;
}

/* One after the other, the most significant by likelihood ratio, at 1 % a step. */
static enum um_status by_forward(const struct problem *p, struct worlds_answer *out)
{
  size_t which[STEPS_MAX + 1], m = 0;
  struct solution s, now = {.chi2 = square(p->n, p->r)};
  for (bool goes_on = true; goes_on && m < STEPS_MAX;) {
    double best = 0.0, least = LEVEL;
    size_t winner = SIZE_MAX;
    struct solution of_winner = {0};
    for (size_t i = 0; i < p->candidates->count; i++) {
      bool taken = false;
      for (size_t k = 0; k < m; k++) taken |= which[k] == i;
      if (taken) continue;
      which[m] = i;
      UM_TRY(solve(p, p->r, which, m + 1, FOLDS, &s));
      if (!is_within(p, i, &s)) continue;
      double gain = now.chi2 - s.chi2, q = um_inference_chi2_q(gain, fmax(1.0, s.dof - now.dof));
      /* where tails underflow the greater gain wins */
      if (!(q < least) && !(q == least && q == 0.0 && gain > best)) continue;
      least = q;
      best = gain;
      winner = i;
      of_winner = s;
    }
    goes_on = winner != SIZE_MAX;
    if (!goes_on) break;
    which[m++] = winner;
    now = of_winner;
  }
  name(p, which, m, &now, out);
  return UM_OK;
}

/* A smooth discrepancy first; then the candidate that spans most of it. */
static enum um_status by_discrepancy(const struct problem *p, struct worlds_answer *out)
{
  enum um_status status;
  double *smooth = NULL, best = 0.0;
  size_t winner = SIZE_MAX;
  struct solution s, of_winner = {0};
  bool found;
  UM_CHECK(um_core_allocate(p->context, p->n, sizeof *smooth, &smooth));
  UM_CHECK(
      worlds_discrepancy(p->context, p->n, p->t, p->channel, p->nchannel, p->r, smooth, &found));
  double all = square(p->n, smooth);
  for (size_t i = 0; found && i < p->candidates->count; i++) {
    UM_CHECK(solve(p, smooth, &i, 1, FOLDS, &s));
    double along = um_inference_dot(p->n, p->fit, smooth), length = square(p->n, p->fit);
    double share = along > 0.0 && length > 0.0 ? along * along / length / all : 0.0;
    if (!is_within(p, i, &s) || !(share > best)) continue;
    best = share;
    winner = i;
    of_winner = s;
  }
  name(p, &winner, winner != SIZE_MAX, &of_winner, out);
  if (found) snprintf(out->note, sizeof out->note, "share %.3f", best);
done:
  um_core_free(p->context, smooth);
  return status;
}

/* Blocks of as many observations each, in order of time. */
static void make_folds(struct problem *p)
{
  for (size_t i = 0; i < p->n; i++) {
    size_t before = 0;
    for (size_t j = 0; j < p->n; j++) before += p->t[j] < p->t[i];
    p->fold[i] = before * FOLDS / p->n;
  }
}

enum um_status worlds_baseline(struct um_context *context,
                               const struct um_sensitivity_forward *forward,
                               const struct um_sensitivity_candidates *candidates, size_t which,
                               struct worlds_answer *out)
{
  static enum um_status (*const methods[WORLDS_BASELINES])(
      const struct problem *, struct worlds_answer *) = {by_bic, by_hold_out, by_forward,
                                                         by_discrepancy};
  enum um_status status;
  const struct um_sensitivity_observations *o = &forward->observations;
  double *block = NULL;
  struct problem p = {.context = context,
                      .candidates = candidates,
                      .n = o->count,
                      .nchannel = forward->measurements->nchannel,
                      .t = o->t,
                      .channel = o->channel,
                      .sigma = o->sigma};
  UM_CHECK(um_core_allocate(context, (COLUMNS + 3) * p.n, sizeof *block, &block));
  UM_CHECK(um_core_allocate(context, p.n, sizeof *p.fold, &p.fold));
  p.column = block;
  p.r = block + COLUMNS * p.n;
  p.rotated = p.r + p.n;
  p.fit = p.rotated + p.n;
  for (size_t j = 0; j < p.n; j++) p.r[j] = (o->measured[j] - candidates->base[j]) / o->sigma[j];
  make_folds(&p);
  UM_CHECK(methods[which](&p, out));
done:
  UM_FREE(context, block, p.fold);
  return status;
}
