/* Candidates that were not fitted, each with its reason. Who asks for an effect is told what became
 * of it. A verdict claims nothing of what was not tried. */
#include "evidence/diagnosis/steps_impl.h"

#include <stdio.h>

static const struct um_inference_score *score_of(const struct um_diagnosis *d, size_t candidate)
{
  for (size_t i = 0; i < d->nranking; i++)
    if (d->ranking[i].candidate == candidate) return &d->ranking[i].score;
  return NULL;
}

/* Why a candidate could not be tested; NULL: it was. */
static const char *untested(const struct um_sensitivity_candidate *c,
                            const struct um_inference_score *score, enum um_diagnosis_fate fate)
{
  if (c->insensitive && c->why != NULL) return c->why;
  if (c->insensitive && um_effect_fitted(c->effect) > 1)
    return "no observation changes with it where its search begins";
  if (c->insensitive || score == NULL) return "no observation changes with it";
  if (score->absorbed) return "what is fitted with it has the same signature";
  if (fate == UM_FATE_REFUSED) return "the model refuses the values that it needs";
  return NULL;
}

/* Why a candidate that was tested was not fitted. */
static void unworthy(const struct um_sensitivity_candidate *c,
                     const struct um_inference_score *score, double level,
                     struct um_diagnosis_missed *missed)
{
  size_t size = sizeof missed->why;
  if (score->p >= UM_INFERENCE_WRONG_SIDE)
    snprintf(missed->why, size,
             c->is_switch ? "the measurements are off the other way"
                          : "its best value is beyond the end of its range");
  else
    snprintf(missed->why, size, "it explains a chi-square of %.3g%s, %s", score->statistic,
             c->nunidentified > 0 ? " where its search begins" : "",
             score->p_corrected < level ? "too little for a fit" : "no more than noise does");
}

static void judge(const struct um_diagnosis_work *work, size_t i, struct um_diagnosis *d)
{
  const struct um_sensitivity_candidate *c = &work->candidates->candidate[i];
  const struct um_inference_score *score = score_of(d, i);
  struct um_diagnosis_missed missed = {.name = c->name};
  if (work->fate[i] == UM_FATE_FITTED) return;
  const char *why = untested(c, score, work->fate[i]);
  missed.tested = why == NULL;
  if (missed.tested && !d->chosen) return;
  if (why != NULL)
    snprintf(missed.why, sizeof missed.why, "%s", why);
  else
    unworthy(c, score, work->level, &missed);
  d->missed[d->nmissed++] = missed;
}

enum um_status um_diagnosis_missed_find(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        struct um_diagnosis *d)
{
  const struct um_sensitivity_candidates *all = work->candidates;
  d->chosen = work->options->candidates.nonly > 0;
  d->nasked = all->count + all->ndropped;
  UM_TRY(um_core_allocate(context, d->nasked, sizeof *d->missed, &d->missed));
  for (size_t i = 0; i < all->ndropped; i++) {
    struct um_diagnosis_missed *m = &d->missed[d->nmissed++];
    m->name = all->dropped[i].name;
    snprintf(m->why, sizeof m->why, "%s", all->dropped[i].why);
  }
  for (size_t i = 0; i < all->count; i++) judge(work, i, d);
  return UM_OK;
}
