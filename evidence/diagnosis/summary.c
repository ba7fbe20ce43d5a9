/* The verdict in words. Where something is found, it is named first. Where the verdict abstains,
 * the residual is described first. Each effect has its class of confidence. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/steps_impl.h"
#include "evidence/diagnosis/value_text.h"
#include "orbit/time.h"

#define NOT_TRIED "; not fitted, though the linear model rates them as good: "

struct text {
  char at[8192];
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

/* "emittance:white factor 0.9 +- 0.01 (emittance 0.77 instead of 0.85)" */
static void add_use(struct text *text, const struct um_diagnosis *d, const struct um_effect *effect,
                    const char *target, const double *value, const double *sigma)
{
  char values[UM_DIAGNOSIS_VALUES_MAX];
  um_diagnosis_values_text(d->forward, effect, target, value, sigma, values);
  add(text, "%s%s%s%s%s", effect->name, target != NULL ? ":" : "", target != NULL ? target : "",
      values[0] != '\0' ? " " : "", values);
}

static void add_addition(struct text *text, const struct um_diagnosis *d,
                         const struct um_model_addition *a, const double *sigma)
{
  add_use(text, d, a->effect, a->target, a->value, sigma);
}

/* One that was fitted, with its values. */
static void add_alternative(struct text *text, const struct um_diagnosis *d,
                            const struct um_diagnosis_alternative *r)
{
  const struct um_sensitivity_candidate *c = &d->candidates->candidate[r->candidate];
  add_use(text, d, c->effect, c->target, r->value, r->sigma);
}

/* ---- alternatives of one effect ---- */

/* Alternatives that only their prior or the end of their range excludes. */
static void add_excluded(struct text *text, const struct um_diagnosis *d,
                         const struct um_diagnosis_step *step)
{
  for (size_t i = 1; i < step->nalternative; i++) {
    const struct um_diagnosis_alternative *r = &step->alternative[i];
    const struct um_sensitivity_candidate *c = &d->candidates->candidate[r->candidate];
    bool tied = step->by_prior && r->indistinguishable;
    if (!tied && !r->excluded_by_prior && !r->excluded_by_range) continue;
    add(text, "; ");
    add_alternative(text, d, r);
    if (r->excluded_by_range)
      add(text, " would fit as well, but its range ends there");
    else
      add(text, " fits as well, but is %.2g prior widths from the usual value",
          um_diagnosis_prior_widths(c, r->value));
  }
}

/* The next best that is neither tied nor excluded, and the same effect with another switch value.
 */
static void add_next_best(struct text *text, const struct um_diagnosis *d,
                          const struct um_diagnosis_step *step)
{
  bool said = false;
  for (size_t i = 1; i < step->nalternative; i++) {
    const struct um_diagnosis_alternative *r = &step->alternative[i];
    double behind = r->bic - step->alternative[0].bic;
    if (!r->fitted || r->indistinguishable || r->excluded_by_prior || r->excluded_by_range)
      continue;
    if (!(behind < UM_DIAGNOSIS_NEXT_BEST) || (said && !r->same_effect)) continue;
    add(text, "; %s", r->same_effect ? "or " : "next best ");
    add_alternative(text, d, r);
    add(text, " (BIC %+.1f)", behind);
    said = said || !r->same_effect;
  }
}

/* The label, and the first few names of the alternatives that are tied, or that were not tried. */
static void add_names(struct text *text, const struct um_diagnosis *d,
                      const struct um_diagnosis_step *step, bool not_tried, const char *label)
{
  size_t others = 0, n = 0;
  for (size_t i = 1; i < step->nalternative; i++) {
    const struct um_diagnosis_alternative *r = &step->alternative[i];
    if (!(not_tried ? r->not_tried : r->indistinguishable)) continue;
    others++;
    if (n == UM_DIAGNOSIS_NAMES) continue;
    add(text, "%s%s", n++ == 0 ? label : ", ", d->candidates->candidate[r->candidate].name);
  }
  if (others > n) add(text, " and %zu more", others - n);
}

/* The alternatives of a group, with their values. */
static void add_group(struct text *text, const struct um_diagnosis *d,
                      const struct um_diagnosis_step *step)
{
  for (size_t i = 1; i < step->nalternative; i++) {
    if (!step->alternative[i].indistinguishable) continue;
    add(text, " or ");
    add_alternative(text, d, &step->alternative[i]);
  }
  add_names(text, d, step, true, NOT_TRIED);
}

static void add_small(struct text *text, const struct um_diagnosis *d,
                      const struct um_diagnosis_step *step)
{
  add(text, ", worth %.3g in BIC", -step->delta_bic);
  add_names(text, d, step, false, ", or ");
  add_names(text, d, step, true, NOT_TRIED);
}

/* ---- the effects ---- */

/* The effects of a class of confidence, behind its label. */
static void add_confidence(struct text *text, const struct um_diagnosis *d,
                           enum um_diagnosis_confidence confidence, const char *label)
{
  size_t n = 0;
  for (size_t i = 0; i < d->naddition; i++) {
    const struct um_diagnosis_step *step = um_diagnosis_step_of(d, &d->addition[i]);
    if (step == NULL || step->confidence != confidence) continue;
    add(text, "%s%s", n > 0 && confidence == UM_CONFIDENCE_CERTAIN ? " and " : label,
        n > 0 && confidence == UM_CONFIDENCE_CERTAIN ? "" : ": ");
    add_addition(text, d, &d->addition[i], d->addition_sigma[i]);
    if (confidence == UM_CONFIDENCE_ONE_OF_GROUP) add_group(text, d, step);
    if (confidence == UM_CONFIDENCE_SMALL) add_small(text, d, step);
    if (confidence != UM_CONFIDENCE_SMALL) {
      add_excluded(text, d, step);
      add_next_best(text, d, step);
    }
    n++;
  }
}

static void add_all(struct text *text, const struct um_diagnosis *d, const char *label)
{
  for (size_t i = 0; i < d->naddition; i++) {
    add(text, "%s", i == 0 ? label : " and ");
    add_addition(text, d, &d->addition[i], d->addition_sigma[i]);
    const struct um_diagnosis_step *step = um_diagnosis_step_of(d, &d->addition[i]);
    if (step == NULL) continue;
    add_excluded(text, d, step);
    add_next_best(text, d, step);
  }
}

static void add_superseded(struct text *text, const struct um_diagnosis *d)
{
  for (size_t i = 0; i < d->nsuperseded; i++) {
    const struct um_diagnosis_superseded *s = &d->superseded[i];
    if (!s->alone || s->bic - d->bic_after > UM_DIAGNOSIS_FAR_BEHIND) continue;
    add(text, ". Found first and then replaced: ");
    add_addition(text, d, &s->addition, s->sigma);
    add(text, " (BIC %+.1f)", s->bic - d->bic_after);
  }
}

static void add_fall(struct text *text, const struct um_diagnosis *d)
{
  add(text, ". Reduced chi-square falls from %.4g to %.4g", d->chi2_reduced, d->chi2_reduced_after);
  if (d->allowance && !d->weighed)
    add(text, "; what is left is not quite noise (p %.1g)",
        fmin(d->final_whiteness.p_chi2,
             fmin(d->final_whiteness.p_white, d->final_whiteness.p_worst)));
}

/* ---- what is left ---- */

static void add_channel(struct text *text, const struct um_diagnosis *d, size_t channel)
{
  const struct um_compare_channel *c = &d->forward->measurements->channel[channel];
  add(text, "%s %s", um_compare_quantity_name(c->quantity), c->of);
}

/* How what is left differs from noise of the stated sigma. between: before the first one. */
static void add_scatter(struct text *text, const struct um_diagnosis *d, const char *between)
{
  for (size_t i = 0; i < d->nscatter; i++) {
    const struct um_diagnosis_scatter *s = &d->scatter[i];
    enum um_compare_quantity quantity = d->forward->measurements->channel[s->channel].quantity;
    if (s->along != NULL) {
      add(text, "%sthe model is off by ", between);
      if (quantity == UM_QUANTITY_TEMPERATURE)
        add(text, "%.2g K", s->rms);
      else
        add(text, "%.2g %%", 100.0 * s->share);
      add(text, " rms (%.2g sigma) in ", s->sigmas);
      add_channel(text, d, s->channel);
      add(text, ", along %s", s->along);
      between = "; ";
    }
    if (!(s->scale > 1.0)) continue;
    add(text, "%s", between);
    add_channel(text, d, s->channel);
    add(text, " scatters %.2g times its sigma", s->scale);
    between = "; ";
  }
  if (d->noutlier > 0)
    add(text, "%s%zu row%s set aside as outliers", between, d->noutlier,
        d->noutlier == 1 ? " is" : "s are");
}

/* ---- verdicts that abstain ---- */

static void add_residual(struct text *text, const struct um_diagnosis *d)
{
  const struct um_missing_heat_residual *r = &d->residual;
  if (r->channel == NULL) return;
  add(text,
      "the residual is worst in %s (chi-square %.3g per observation; measured %.2g sigma %s the "
      "model on average)",
      r->channel, r->chi2_reduced, fabs(r->mean), r->mean < 0.0 ? "below" : "above");
  if (r->coordinate != NULL && r->p < UM_DIAGNOSIS_CORRELATES)
    add(text, " and correlates with %s", r->coordinate);
}

/* Effects that a free nuisance which moved may stand for. */
static void add_absorbed(struct text *text, const struct um_diagnosis *d)
{
  size_t n = 0;
  for (size_t i = 0; i < d->nranking && n < 6; i++) {
    if (!(d->ranking[i].score.kept < UM_DIAGNOSIS_RESEMBLES)) continue;
    add(text, "%s%s", n++ == 0 ? "; it may stand for " : ", ",
        d->candidates->candidate[d->ranking[i].candidate].name);
  }
}

static void add_heat(struct text *text, const struct um_missing_heat_unexplained *u)
{
  char start[40], shape[UM_MISSING_HEAT_TEXT];
  if (u == NULL || u->nheat == 0 || !(u->heat[0].energy_sigma > 0.0)) return; /* rows see no heat */
  const struct um_missing_heat *h = &u->heat[0];
  um_orbit_time_format(h->course.start, start);
  um_missing_heat_text(h, shape);
  add(text, ". %s %.4g +- %.2g J in %s from %s +- %.2g s%s",
      u->found ? "Missing heat explains it:" : "Missing heat explains only a part:", h->energy,
      h->energy_sigma, h->place, start, h->start_sigma, shape);
}

static void say_not_identifiable(struct text *text, const struct um_diagnosis *d)
{
  if (d->naddition == 0) {
    add(text,
        "Not identifiable: a free nuisance has moved far, and what it stands for cannot be known");
    add_absorbed(text, d);
    return;
  }
  add(text, "Not identifiable: ");
  add_residual(text, d);
  add_confidence(text, d, UM_CONFIDENCE_CERTAIN, ". Certain");
  add_confidence(text, d, UM_CONFIDENCE_UNCERTAIN, ". Needed, but within two sigmas of no effect");
  add_confidence(text, d, UM_CONFIDENCE_ONE_OF_GROUP, ". One of a group");
  add_confidence(text, d, UM_CONFIDENCE_SMALL, ". Small and unknown");
  add_superseded(text, d);
  add_fall(text, d);
}

/* That nothing explains the residual. It claims no more than was tried. */
static const char *claim(const struct um_diagnosis *d)
{
  size_t untested = 0;
  for (size_t i = 0; i < d->nmissed; i++) untested += !d->missed[i].tested;
  if (d->chosen && untested >= d->nasked) return "none of the effects asked for could be tried";
  if (d->chosen) return "none of the effects asked for explains it";
  return untested > 0 ? "no effect of the catalogue that could be tried explains it"
                      : "no effect of the catalogue explains it";
}

/* Candidates that were not fitted, each with its reason. tested: also those that were tested. */
static void add_missed(struct text *text, const struct um_diagnosis *d, bool tested)
{
  size_t n = 0, more = 0;
  for (size_t i = 0; d->chosen && i < d->nmissed; i++) {
    const struct um_diagnosis_missed *m = &d->missed[i];
    if (m->tested && !tested) continue;
    if (n < UM_DIAGNOSIS_NAMES)
      add(text, "%s%s (%s)", n == 0 ? "; not tried: " : ", ", m->name, m->why);
    else
      more++;
    n++;
  }
  if (more > 0) add(text, " and %zu more", more);
}

static void say_unexplained(struct text *text, const struct um_diagnosis *d)
{
  if (d->candidates == NULL) { /* chosen, not found */
    add_all(text, d, "Fitted: ");
    add_fall(text, d);
    add(text, "; what is left is not noise");
    return;
  }
  add(text, "Unexplained: ");
  add_residual(text, d);
  if (d->naddition == 0) {
    add(text, "%s%s", d->residual.channel != NULL ? "; " : "", claim(d));
    add_missed(text, d, true);
  } else {
    add_all(text, d, ". The best of the catalogue only mimics it: ");
    add_fall(text, d);
    add(text, "; what is left is not noise");
  }
  add_heat(text, d->unexplained);
  char more[UM_DIAGNOSIS_LIGHT_TEXT + UM_DIAGNOSIS_HALF_TEXT];
  um_diagnosis_light_text(d, more);
  um_diagnosis_half_text(d, more + strlen(more));
  add(text, "%s", more);
}

enum um_status um_diagnosis_summary_write(struct um_context *context, const struct um_diagnosis *d,
                                          char **out)
{
  struct text text = {{0}, 0};
  switch (d->verdict) {
  case UM_VERDICT_COMPLETE:
    if (d->nscatter + d->noutlier > 0)
      add_scatter(&text, d, "Nothing is missing, but ");
    else
      add(&text,
          "Nothing is missing: the residual is noise of the stated sigma (reduced chi-square %.3g)",
          d->chi2_reduced);
    break;
  case UM_VERDICT_FOUND:
    add_all(&text, d, d->candidates == NULL ? "Fitted: " : "Missing: ");
    add_superseded(&text, d);
    add_fall(&text, d);
    break;
  case UM_VERDICT_NOT_IDENTIFIABLE:
    say_not_identifiable(&text, d);
    break;
  case UM_VERDICT_UNEXPLAINED:
    say_unexplained(&text, d);
    break;
  }
  if (d->verdict != UM_VERDICT_COMPLETE) add_scatter(&text, d, ". Besides, ");
  if (d->verdict != UM_VERDICT_UNEXPLAINED || d->naddition > 0) add_missed(&text, d, false);
  add(&text, ".");
  return um_core_strdup(context, text.at, out);
}
