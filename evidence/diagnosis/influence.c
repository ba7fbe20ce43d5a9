/* On what a verdict hangs: one channel or one row is left out, one prior of a nuisance is half or
 * twice as wide, all rows of a channel have the same sigma, or what is left goes together along
 * another coordinate, and the linear model says by how much chi-square less ln n a parameter then
 * changes, of the effect and of its alternatives. Their BIC as fitted moves by that. */
#include <math.h>
#include <string.h>

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/sceptic_impl.h"

/* What a candidate is worth by the linear model: chi-square less ln n a parameter. */
static double worth(const struct um_diagnosis_doubt *s, const struct um_inference_score *score,
                    size_t i)
{
  const struct um_sensitivity_candidate *c = &s->work->candidates->candidate[i];
  if (score[i].absorbed) return 0.0;
  return score[i].statistic - (c->is_switch ? 0.0 : score[i].dof * log((double)s->n)) -
         (c->off ? UM_DIAGNOSIS_OFF : 0.0);
}

struct variations {
  struct um_inference_score *at_first, *now; /* [count of candidates] */
  const struct um_diagnosis_step *step;
  struct um_diagnosis_sceptic *out;
};

/* Whether the effect keeps its lead: its BIC before each alternative that was fitted, and before
 * nothing, with what the linear model says that the variation changes. */
static void judge(const struct um_diagnosis_doubt *s, struct variations *v, const char *kind)
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

/* What is tested: the residual, nuisances and candidates, of which something is changed. */
struct changed {
  double *residual, *nuisance, *width,
      *column;                              /* [n], [nparameter][n], [nparameter], [columns][n] */
  struct um_inference_direction *direction; /* [count of candidates] over column */
  size_t columns;
};

static enum um_status changed_make(struct um_context *context, const struct um_diagnosis_doubt *s,
                                   struct changed *to)
{
  size_t count = s->work->candidates->count, k = s->without.nparameter;
  for (size_t i = 0; i < count; i++) to->columns += s->d.direction[i].ncolumn;
  UM_TRY(um_core_allocate(context, s->n, sizeof(double), &to->residual));
  UM_TRY(um_core_allocate(context, k * s->n, sizeof(double), &to->nuisance));
  UM_TRY(um_core_allocate(context, k, sizeof(double), &to->width));
  UM_TRY(um_core_allocate(context, to->columns * s->n, sizeof(double), &to->column));
  UM_TRY(um_core_allocate(context, count, sizeof *to->direction, &to->direction));
  memcpy(to->direction, s->d.direction, count * sizeof *to->direction);
  for (size_t i = 0; i < count; i++)
    to->direction[i].column = to->column + (s->d.direction[i].column - s->d.column);
  return UM_OK;
}

static void changed_release(struct um_context *context, struct changed *c)
{
  UM_FREE(context, c->residual, c->nuisance, c->width, c->column, c->direction);
}

/* The test with some rows alone. */
static enum um_status test_rows(struct um_context *context, const struct um_diagnosis_doubt *s,
                                struct changed *c, const bool *kept, struct um_inference_score *out)
{
  size_t k = s->without.nparameter;
  const struct um_inference_nuisance these = {k, c->nuisance, s->d.nuisance.prior_sigma};
  um_diagnosis_keep_rows(s->residual, 1, s->n, kept, c->residual);
  um_diagnosis_keep_rows(s->d.nuisance.column, k, s->n, kept, c->nuisance);
  um_diagnosis_keep_rows(s->d.column, c->columns, s->n, kept, c->column);
  return um_inference_score_test(context, s->n, c->residual, &these, s->work->candidates->count,
                                 c->direction, out);
}

/* Each channel left out in turn, but where it is the only one. kept: room [n]. */
static enum um_status vary_channels(struct um_context *context, const struct um_diagnosis_doubt *s,
                                    struct changed *changed, bool *kept, struct variations *v)
{
  const struct um_sensitivity_observations *o = &s->work->forward->observations;
  for (size_t c = 0; c < s->work->forward->measurements->nchannel; c++) {
    size_t rows = 0;
    for (size_t j = 0; j < s->n; j++) rows += kept[j] = o->channel[j] != c;
    if (rows == 0 || rows == s->n) continue;
    UM_TRY(test_rows(context, s, changed, kept, v->now));
    judge(s, v, "one channel");
  }
  return UM_OK;
}

/* Each of the rows left out that are off most, half of them at most. kept: room [n]. */
static enum um_status vary_rows(struct um_context *context, const struct um_diagnosis_doubt *s,
                                struct changed *changed, bool *kept, struct variations *v)
{
  double last = INFINITY; /* rows by |residual|, falling */
  for (size_t k = 0; k < UM_DIAGNOSIS_ROWS && k < s->n / 2; k++) {
    size_t most = s->n;
    for (size_t j = 0; j < s->n; j++)
      if (fabs(s->residual[j]) < last &&
          (most == s->n || fabs(s->residual[j]) > fabs(s->residual[most])))
        most = j;
    if (most == s->n) break;
    last = fabs(s->residual[most]);
    for (size_t j = 0; j < s->n; j++) kept[j] = j != most;
    UM_TRY(test_rows(context, s, changed, kept, v->now));
    judge(s, v, "one row");
  }
  return UM_OK;
}

/* Each prior of a nuisance half as wide and twice as wide. */
static enum um_status vary_priors(struct um_context *context, const struct um_diagnosis_doubt *s,
                                  struct changed *changed, struct variations *v)
{
  size_t n = s->without.nparameter;
  const struct um_inference_nuisance these = {n, s->d.nuisance.column, changed->width};
  for (size_t k = 0; k < n; k++)
    for (double factor = 0.5; factor < 4.0; factor *= 4.0) {
      if (isinf(s->d.nuisance.prior_sigma[k])) continue;
      memcpy(changed->width, s->d.nuisance.prior_sigma, n * sizeof *changed->width);
      changed->width[k] *= factor;
      UM_TRY(um_inference_score_test(context, s->n, s->residual, &these, s->work->candidates->count,
                                     s->d.direction, v->now));
      judge(s, v, "one prior's width");
    }
  return UM_OK;
}

/* Root of the mean square of a channel's sigmas. */
static double sigma_of(const struct um_sensitivity_observations *o, size_t channel)
{
  double sum = 0.0, rows = 0.0;
  for (size_t j = 0; j < o->count; j++) {
    if (o->channel[j] != channel) continue;
    sum += o->sigma[j] * o->sigma[j];
    rows += 1.0;
  }
  return sqrt(sum / fmax(rows, 1.0));
}

/* White noise whose sigma is the same for all rows of a channel. */
static enum um_status vary_sigma(struct um_context *context, const struct um_diagnosis_doubt *s,
                                 struct changed *to, struct variations *v)
{
  const struct um_sensitivity_observations *o = &s->work->forward->observations;
  size_t k = s->without.nparameter;
  const struct um_inference_nuisance these = {k, to->nuisance, s->d.nuisance.prior_sigma};
  for (size_t c = 0; c < s->work->forward->measurements->nchannel; c++) {
    double same = sigma_of(o, c);
    for (size_t j = 0; j < s->n; j++) {
      if (o->channel[j] != c) continue;
      double weight = o->sigma[j] / same;
      to->residual[j] = weight * s->residual[j];
      for (size_t i = 0; i < k; i++)
        to->nuisance[i * s->n + j] = weight * s->d.nuisance.column[i * s->n + j];
      for (size_t i = 0; i < to->columns; i++)
        to->column[i * s->n + j] = weight * s->d.column[i * s->n + j];
    }
  }
  UM_TRY(um_inference_score_test(context, s->n, to->residual, &these, s->work->candidates->count,
                                 to->direction, v->now));
  judge(s, v, "one sigma for all rows");
  return UM_OK;
}

/* The same tests where every discrepancy of a channel goes along this coordinate. */
static enum um_status test_kind(struct um_context *context, const struct um_diagnosis_doubt *s,
                                size_t kind, struct um_inference_noise_channel *channel,
                                double *residual, struct um_inference_score *out)
{
  struct um_diagnosis_work work = *s->work;
  struct um_inference_noise noise = *s->work->noise;
  struct um_diagnosis_directions d = {0};
  memcpy(channel, noise.channel, noise.family->nchannel * sizeof *channel);
  for (size_t c = 0; c < noise.family->nchannel; c++) channel[c].kind = kind;
  noise.channel = channel;
  work.noise = &noise;
  enum um_status status = um_diagnosis_directions_make(context, &work, &s->without, &d);
  if (status == UM_OK) {
    um_diagnosis_residual_at_means(&work, &s->without, s->n, residual);
    status = um_inference_score_test(context, s->n, residual, &d.nuisance, work.candidates->count,
                                     d.direction, out);
  }
  um_diagnosis_directions_release(context, &d);
  return status;
}

/* Each coordinate in place of those along which discrepancies were found to go. */
static enum um_status vary_kind(struct um_context *context, const struct um_diagnosis_doubt *s,
                                struct changed *changed, struct variations *v)
{
  enum um_status status = UM_OK;
  const struct um_inference_noise *noise = s->work->noise;
  struct um_inference_noise_channel *channel = NULL;
  UM_TRY(um_core_allocate(context, noise->family->nchannel, sizeof *channel, &channel));
  for (size_t kind = 0; kind < noise->family->nkind && status == UM_OK; kind++) {
    bool other = false;
    for (size_t c = 0; c < noise->family->nchannel; c++)
      other = other || (noise->channel[c].ratio > 0.0 && noise->channel[c].kind != kind);
    if (!other) continue;
    status = test_kind(context, s, kind, channel, changed->residual, v->now);
    if (status == UM_OK) judge(s, v, "another correlation");
  }
  um_core_free(context, channel);
  return status;
}

static enum um_status vary_noise(struct um_context *context, const struct um_diagnosis_doubt *s,
                                 struct changed *changed, struct variations *v)
{
  return s->work->noise == NULL ? vary_sigma(context, s, changed, v)
                                : vary_kind(context, s, changed, v);
}

enum um_status um_diagnosis_influence(struct um_context *context,
                                      const struct um_diagnosis_doubt *s,
                                      const struct um_diagnosis_step *step,
                                      struct um_diagnosis_sceptic *out)
{
  enum um_status status;
  size_t count = s->work->candidates->count;
  struct variations v = {.step = step, .out = out};
  struct changed changed = {0};
  bool *kept = NULL;
  UM_CHECK(um_core_allocate(context, count, sizeof *v.at_first, &v.at_first));
  UM_CHECK(um_core_allocate(context, count, sizeof *v.now, &v.now));
  UM_CHECK(um_core_allocate(context, s->n, sizeof *kept, &kept));
  UM_CHECK(changed_make(context, s, &changed));
  UM_CHECK(um_inference_score_test(context, s->n, s->residual, &s->d.nuisance, count,
                                   s->d.direction, v.at_first));
  UM_CHECK(vary_channels(context, s, &changed, kept, &v));
  UM_CHECK(vary_rows(context, s, &changed, kept, &v));
  UM_CHECK(vary_priors(context, s, &changed, &v));
  UM_CHECK(vary_noise(context, s, &changed, &v));
done:
  UM_FREE(context, v.at_first, v.now, kept);
  changed_release(context, &changed);
  return status;
}
