/* The verdict in words. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "diagnosis/diagnose_impl.h"

#define RESEMBLES 0.3 /* share of a signature that the nuisances leave */

struct text {
  char at[2048];
  size_t used;
};

static void add(struct text *text, const char *format, ...) UM_PRINTF(2, 3);
static void add(struct text *text, const char *format, ...)
{
  va_list list;
  va_start(list, format);
  int n = vsnprintf(text->at + text->used, sizeof text->at - text->used, format, list);
  va_end(list);
  if (n > 0) text->used += (size_t)n;
  if (text->used >= sizeof text->at) text->used = sizeof text->at - 1;
}

static void add_name(struct text *text, const struct um_effect *effect, const char *target)
{
  add(text, "%s%s%s", effect->name, target != NULL ? ":" : "", target != NULL ? target : "");
}

static void add_use(struct text *text, const struct um_diagnosis_addition *use, const double *sigma)
{
  add_name(text, use->effect, use->target);
  for (size_t p = 0; p < use->effect->nparameter; p++) {
    const struct um_effect_parameter *of = &use->effect->parameters[p];
    if (isnan(sigma[p]) && use->value[p] == of->null_value) continue;
    add(text, " %s %.4g", of->name, use->value[p]);
    if (!isnan(sigma[p])) add(text, " +- %.2g", sigma[p]);
  }
}

static void add_group(struct text *text, const struct um_diagnosis *d,
                      const struct um_diagnosis_step *step)
{
  size_t n = 0;
  for (size_t i = 1; i < step->nrival && !step->removed; i++) {
    const struct um_diagnosis_candidate *c = &d->candidates->candidate[step->rival[i].candidate];
    if (!step->rival[i].indistinguishable) continue;
    add(text, "%s%s", n++ == 0 ? "; these data cannot tell it from " : ", ", c->name);
  }
  if (n > 0 && step->by_prior) add(text, " (which would need an incredible value)");
}

static void add_absorbed(struct text *text, const struct um_diagnosis *d)
{
  size_t n = 0;
  for (size_t i = 0; i < d->nranking && n < 6; i++) {
    if (!(d->ranking[i].score.kept < RESEMBLES)) continue;
    add(text, "%s%s", n++ == 0 ? "; it does what these would: " : ", ",
        d->candidates->candidate[d->ranking[i].candidate].name);
  }
}

enum um_status um_diagnosis_sentence(struct um_context *context, const struct um_diagnosis *d,
                                     char **out)
{
  struct text text = {{0}, 0};
  for (size_t i = 0; i < d->naddition; i++) {
    add(&text, i == 0 ? "Missing: " : " and ");
    add_use(&text, &d->addition[i], d->addition_sigma[i]);
    for (size_t s = 0; s < d->nstep; s++)
      if (d->step[s].addition.effect == d->addition[i].effect &&
          d->step[s].addition.target == d->addition[i].target)
        add_group(&text, d, &d->step[s]);
  }
  if (d->naddition > 0)
    add(&text, ". Reduced chi-square falls from %.4g to %.4g", d->chi2_reduced,
        d->chi2_reduced_after);
  if (d->verdict == UM_VERDICT_COMPLETE)
    add(&text,
        "Nothing is missing: the residual is noise of the stated sigma (reduced chi-square "
        "%.3g)",
        d->chi2_reduced);
  if (d->verdict == UM_VERDICT_NOT_IDENTIFIABLE && d->naddition == 0) {
    add(&text,
        "Not identifiable: a free nuisance has moved far, and what it stands for cannot be known");
    add_absorbed(&text, d);
  }
  if (d->verdict == UM_VERDICT_UNEXPLAINED) {
    add(&text, "%s",
        d->naddition > 0 ? "; what is left" : "No effect of the catalogue explains it");
    add(&text, d->naddition > 0 ? " is not noise" : "");
    if (d->unexplained != NULL && d->unexplained->found)
      add(&text, "; heat of %.4g +- %.2g J in %s would", d->unexplained->heat[0].energy,
          d->unexplained->heat[0].energy_sigma, d->unexplained->heat[0].place);
  }
  add(&text, ".");
  return um_core_strdup(context, text.at, out);
}
