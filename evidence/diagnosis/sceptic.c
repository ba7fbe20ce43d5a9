/* What convinces a sceptic, of the effect that explains most. All of it is linear in observations
 * and costs no run of the model but one without the effect.
 *
 *   frozen      its values from one half of the blocks of time, by its Jacobian; s what they change
 *               in the other half, after nuisances: z = r's / |s| is N(0, 1) where there is no such
 *               effect. Both halves: (z_1 + z_2) / sqrt 2
 *   search      the least p among all candidates in draws of noise
 *   influence   its lead with one channel, one row, one prior's width, or the noise changed
 *   open set    what would be said, were it not in the catalogue */
#include <math.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "base/inference/distributions.h"
#include "base/inference/projection.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

/* The state without the effect, as linear statistics have it. */
struct sceptic {
  const struct um_diagnosis_work *work;
  const struct um_diagnosis_state *state; /* with it */
  size_t b;                               /* its block */
  struct um_diagnosis_state without;
  struct um_diagnosis_directions d; /* of the candidates, beside `without` */
  double *residual;                 /* [n] of `without`, whitened */
  double *column;                   /* [ncolumn][n] its own, whitened */
  size_t n, ncolumn;
  double *kept;  /* room: nuisances, columns and residual with rows left out */
  double *width; /* [nparameter] of the nuisances, one of them changed */
};

static enum um_status own_columns(struct um_context *context, struct sceptic *s)
{
  const struct um_diagnosis_block *block = &s->state->block[s->b];
  const double *sigma = s->work->forward->observations.sigma;
  size_t first = 0;
  for (size_t i = 0; i < s->b; i++) first += s->state->block[i].nfree;
  s->ncolumn = block->nfree > 0 ? block->nfree : 1;
  UM_TRY(um_core_allocate(context, s->ncolumn * s->n, sizeof *s->column, &s->column));
  for (size_t j = 0; j < s->n && block->nfree == 0; j++)
    s->column[j] = (s->state->fit->value[j] - s->without.fit->value[j]) / sigma[j];
  if (block->nfree > 0)
    memcpy(s->column, s->state->fit->jacobian + first * s->n,
           s->ncolumn * s->n * sizeof *s->column);
  for (size_t k = 0; k < s->ncolumn; k++)
    um_inference_noise_whiten(s->work->noise, s->column + k * s->n);
  return UM_OK;
}

static enum um_status begin(struct um_context *context, struct sceptic *s)
{
  UM_TRY(um_diagnosis_without(context, s->work, s->state, s->b, &s->without));
  UM_TRY(um_diagnosis_directions_make(context, s->work, &s->without, &s->d));
  UM_TRY(um_core_allocate(context, s->n, sizeof *s->residual, &s->residual));
  um_diagnosis_residual_at_means(s->work, &s->without, s->n, s->residual);
  UM_TRY(own_columns(context, s));
  UM_TRY(um_core_allocate(context, s->without.nparameter, sizeof *s->width, &s->width));
  return um_core_allocate(context, (s->without.nparameter + s->ncolumn + 1) * s->n, sizeof *s->kept,
                          &s->kept);
}

static void release(struct um_context *context, struct sceptic *s)
{
  UM_FREE(context, s->residual, s->column, s->kept, s->width);
  um_diagnosis_directions_release(context, &s->d);
  um_diagnosis_state_release(context, &s->without);
}

/* ---- frozen ---- */

/* Blocks of time by turns: every channel has about as many rows in each. */
static bool in_half(const struct sceptic *s, size_t j, int half)
{
  const struct um_sensitivity_observations *o = &s->work->forward->observations;
  double first = INFINITY, last = -INFINITY;
  for (size_t i = 0; i < s->n; i++) {
    first = fmin(first, o->t[i]);
    last = fmax(last, o->t[i]);
  }
  double at = last > first ? (o->t[j] - first) / (last - first) : 0.0;
  return ((int)fmin(UM_DIAGNOSIS_BLOCKS * at, UM_DIAGNOSIS_BLOCKS - 1.0)) % 2 == half;
}

struct half {
  struct um_inference_nuisance nuisance;
  struct um_inference_direction direction;
  const double *residual;
};

/* Everything with rows outside a half set to 0. */
static struct half half_of(const struct sceptic *s, const bool *in)
{
  static const double low[UM_EFFECT_PARAMETERS_MAX] = {-INFINITY, -INFINITY, -INFINITY, -INFINITY,
                                                       -INFINITY, -INFINITY, -INFINITY, -INFINITY};
  static const double high[UM_EFFECT_PARAMETERS_MAX] = {INFINITY, INFINITY, INFINITY, INFINITY,
                                                        INFINITY, INFINITY, INFINITY, INFINITY};
  size_t k = s->without.nparameter;
  double *nuisance = s->kept, *column = nuisance + k * s->n, *residual = column + s->ncolumn * s->n;
  for (size_t i = 0; i < k * s->n; i++) nuisance[i] = in[i % s->n] ? s->d.nuisance.column[i] : 0.0;
  for (size_t i = 0; i < s->ncolumn * s->n; i++) column[i] = in[i % s->n] ? s->column[i] : 0.0;
  for (size_t i = 0; i < s->n; i++) residual[i] = in[i] ? s->residual[i] : 0.0;
  return (struct half){
      {k, nuisance, s->d.nuisance.prior_sigma}, {s->ncolumn, column, low, high, high, 0}, residual};
}

/* z of the half of `in`, with the values of the other; NaN where it sees nothing. */
static enum um_status foretold(struct um_context *context, struct sceptic *s, bool *in, double *z)
{
  enum um_status status;
  struct um_inference_projection projection = {0};
  struct um_inference_score score = {0};
  double *change = NULL, *left = NULL;
  *z = NAN;
  for (size_t j = 0; j < s->n; j++) in[j] = !in[j];
  struct half other = half_of(s, in);
  UM_CHECK(um_inference_score_test(context, s->n, other.residual, &other.nuisance, 1,
                                   &other.direction, &score));
  for (size_t j = 0; j < s->n; j++) in[j] = !in[j];
  struct half here = half_of(s, in);
  UM_CHECK(um_core_allocate(context, s->n, sizeof *change, &change));
  for (size_t k = 0; k < s->ncolumn && !score.absorbed; k++)
    for (size_t j = 0; j < s->n && isfinite(score.estimate[k]); j++)
      change[j] += score.estimate[k] * here.direction.column[k * s->n + j];
  UM_CHECK(um_inference_projection_create(context, s->n, &here.nuisance, &projection));
  UM_CHECK(um_core_allocate(context, 2 * projection.nleft, sizeof *left, &left));
  um_inference_projection_apply(&projection, change, left);
  um_inference_projection_apply(&projection, here.residual, left + projection.nleft);
  double length = sqrt(um_inference_dot(projection.nleft, left, left));
  if (length > 0.0) *z = um_inference_dot(projection.nleft, left, left + projection.nleft) / length;
done:
  UM_FREE(context, change, left);
  um_inference_projection_destroy(context, &projection);
  return status;
}

static enum um_status frozen(struct um_context *context, struct sceptic *s, double *out)
{
  enum um_status status;
  double z[2] = {NAN, NAN};
  bool *in = NULL;
  UM_CHECK(um_core_allocate(context, s->n, sizeof *in, &in));
  for (int half = 0; half < 2; half++) {
    for (size_t j = 0; j < s->n; j++) in[j] = in_half(s, j, half);
    UM_CHECK(foretold(context, s, in, &z[half]));
  }
  *out = isnan(z[0]) ? z[1] : isnan(z[1]) ? z[0] : (z[0] + z[1]) / sqrt(2.0);
done:
  um_core_free(context, in);
  return status;
}

/* ---- influence ---- */

/* What a candidate is worth by the linear model: chi-square less ln n a parameter. */
static double worth(const struct sceptic *s, const struct um_inference_score *score, size_t i)
{
  const struct um_sensitivity_candidate *c = &s->work->candidates->candidate[i];
  if (score[i].absorbed) return 0.0;
  return score[i].statistic - (c->is_switch ? 0.0 : score[i].dof * log((double)s->n));
}

struct variations {
  struct um_inference_score *at_first, *now; /* [count of candidates] */
  const struct um_diagnosis_step *step;
  struct um_diagnosis_sceptic *out;
};

/* Whether the effect keeps its lead: its BIC before each alternative that was fitted, and before
 * nothing, with what the linear model says that the variation changes. */
static void judge(const struct sceptic *s, struct variations *v, const char *kind)
{
  const struct um_diagnosis_alternative *winner = &v->step->alternative[0];
  size_t w = winner->candidate;
  double own = worth(s, v->now, w) - worth(s, v->at_first, w);
  bool flips = v->step->delta_bic - own > 0.0;
  for (size_t i = 1; i < v->step->nalternative && !flips; i++) {
    const struct um_diagnosis_alternative *r = &v->step->alternative[i];
    if (!r->fitted || r->same_effect || r->indistinguishable) continue;
    double theirs = worth(s, v->now, r->candidate) - worth(s, v->at_first, r->candidate);
    flips = r->bic - winner->bic + own - theirs < 0.0;
  }
  v->out->variations++;
  v->out->flips += flips;
  if (flips && v->out->flips_by == NULL) v->out->flips_by = kind;
}

static enum um_status test(struct um_context *context, struct sceptic *s, struct variations *v,
                           const struct um_inference_nuisance *nuisance, const double *residual,
                           const char *kind)
{
  UM_TRY(um_inference_score_test(context, s->n, residual, nuisance, s->work->candidates->count,
                                 s->d.direction, v->now));
  judge(s, v, kind);
  return UM_OK;
}

/* Rows that count for nothing: their residual, nuisances and signatures are 0. */
static void leave_out(struct sceptic *s, const bool *out, double *nuisance, double *residual,
                      double *column, const double *column_before, size_t ncolumn)
{
  for (size_t i = 0; i < s->without.nparameter * s->n; i++)
    nuisance[i] = out[i % s->n] ? 0.0 : s->d.nuisance.column[i];
  for (size_t j = 0; j < s->n; j++) residual[j] = out[j] ? 0.0 : s->residual[j];
  for (size_t i = 0; i < ncolumn * s->n; i++) column[i] = out[i % s->n] ? 0.0 : column_before[i];
}

/* Each channel in turn, then each of the rows that are off most. */
static enum um_status vary_rows(struct um_context *context, struct sceptic *s, struct variations *v)
{
  enum um_status status;
  const struct um_sensitivity_observations *o = &s->work->forward->observations;
  size_t columns = 0, nchannel = s->work->forward->measurements->nchannel, channels = 0;
  double *before = NULL, *nuisance = NULL, *residual = NULL;
  bool *out = NULL, *done_row = NULL;
  for (size_t i = 0; i < s->work->candidates->count; i++) columns += s->d.direction[i].ncolumn;
  UM_CHECK(um_core_allocate(context, columns * s->n, sizeof *before, &before));
  memcpy(before, s->d.column, columns * s->n * sizeof *before);
  UM_CHECK(um_core_allocate(context, s->without.nparameter * s->n, sizeof *nuisance, &nuisance));
  UM_CHECK(um_core_allocate(context, s->n, sizeof *residual, &residual));
  UM_CHECK(um_core_allocate(context, s->n, sizeof *out, &out));
  UM_CHECK(um_core_allocate(context, s->n, sizeof *done_row, &done_row));
  const struct um_inference_nuisance these = {s->without.nparameter, nuisance,
                                              s->d.nuisance.prior_sigma};
  for (size_t c = 0; c < nchannel; c++)
    for (size_t j = 0; j < s->n; j++)
      if (o->channel[j] == c) {
        channels++;
        break;
      }
  for (size_t c = 0; c < nchannel && channels > 1; c++) {
    size_t rows = 0;
    for (size_t j = 0; j < s->n; j++) rows += out[j] = o->channel[j] == c;
    if (rows == 0) continue;
    leave_out(s, out, nuisance, residual, s->d.column, before, columns);
    UM_CHECK(test(context, s, v, &these, residual, "one channel"));
  }
  for (size_t k = 0; k < UM_DIAGNOSIS_ROWS && k < s->n / 2; k++) {
    size_t most = s->n;
    for (size_t j = 0; j < s->n; j++)
      if (!done_row[j] && (most == s->n || fabs(s->residual[j]) > fabs(s->residual[most])))
        most = j;
    done_row[most] = true;
    for (size_t j = 0; j < s->n; j++) out[j] = j == most;
    leave_out(s, out, nuisance, residual, s->d.column, before, columns);
    UM_CHECK(test(context, s, v, &these, residual, "one row"));
  }
  memcpy(s->d.column, before, columns * s->n * sizeof *before);
done:
  UM_FREE(context, before, nuisance, residual, out, done_row);
  return status;
}

/* Each prior of a nuisance half as wide and twice as wide. */
static enum um_status vary_priors(struct um_context *context, struct sceptic *s,
                                  struct variations *v)
{
  const struct um_inference_nuisance these = {s->without.nparameter, s->d.nuisance.column,
                                              s->width};
  for (size_t k = 0; k < s->without.nparameter; k++)
    for (double factor = 0.5; factor < 4.0; factor *= 4.0) {
      if (isinf(s->d.nuisance.prior_sigma[k])) continue;
      memcpy(s->width, s->d.nuisance.prior_sigma, s->without.nparameter * sizeof *s->width);
      s->width[k] *= factor;
      UM_TRY(test(context, s, v, &these, s->residual, "one prior's width"));
    }
  return UM_OK;
}

static enum um_status influence(struct um_context *context, struct sceptic *s,
                                const struct um_diagnosis_step *step,
                                struct um_diagnosis_sceptic *out)
{
  enum um_status status;
  size_t count = s->work->candidates->count;
  struct variations v = {.step = step, .out = out};
  UM_CHECK(um_core_allocate(context, count, sizeof *v.at_first, &v.at_first));
  UM_CHECK(um_core_allocate(context, count, sizeof *v.now, &v.now));
  UM_CHECK(um_inference_score_test(context, s->n, s->residual, &s->d.nuisance, count,
                                   s->d.direction, v.at_first));
  UM_CHECK(vary_rows(context, s, &v));
  UM_CHECK(vary_priors(context, s, &v));
done:
  UM_FREE(context, v.at_first, v.now);
  return status;
}

/* ---- open set ---- */

/* The best alternative that is another effect; NULL: none was fitted. */
static const struct um_diagnosis_alternative *another(const struct um_diagnosis_step *step)
{
  for (size_t i = 1; i < step->nalternative; i++)
    if (step->alternative[i].fitted && !step->alternative[i].same_effect)
      return &step->alternative[i];
  return NULL;
}

static void open_set(const struct um_diagnosis_step *step, double dof,
                     struct um_diagnosis_sceptic *out)
{
  const struct um_diagnosis_alternative *winner = &step->alternative[0], *next = another(step);
  double without = winner->bic - step->delta_bic;
  if (next == NULL || !(next->bic < without - UM_DIAGNOSIS_EVIDENCE)) return; /* nothing */
  out->else_candidate = next->candidate;
  out->has_else = true;
  out->else_behind = next->bic - winner->bic;
  out->else_reduced = next->chi2 / dof;
}

enum um_status um_diagnosis_sceptic_ask(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        const struct um_diagnosis_state *state,
                                        struct um_diagnosis *d)
{
  enum um_status status = UM_OK;
  struct sceptic s = {.work = work, .state = state, .n = work->forward->observations.count};
  const struct um_diagnosis_step *step = NULL;
  for (size_t i = 0; i < d->nstep && step == NULL; i++)
    if (!d->step[i].removed) step = &d->step[i];
  if (step == NULL || step->nalternative == 0) return UM_OK;
  for (s.b = state->nnuisance; s.b < state->nblock; s.b++)
    if (state->block[s.b].candidate == step->candidate) break;
  if (s.b == state->nblock) return UM_OK;
  UM_CHECK(begin(context, &s));
  d->sceptic = (struct um_diagnosis_sceptic){.asked = true, .step = (size_t)(step - d->step)};
  UM_CHECK(frozen(context, &s, &d->sceptic.frozen));
  UM_CHECK(um_inference_search_p(context, s.n, &s.d.nuisance, work->candidates->count,
                                 s.d.direction, step->alternative[0].score.p, UM_DIAGNOSIS_DRAWS, 1,
                                 &d->sceptic.search_p));
  UM_CHECK(influence(context, &s, step, &d->sceptic));
  open_set(step, d->dof_after, &d->sceptic);
done:
  release(context, &s);
  return status;
}
