/* Effects as sentences, in the words of their own descriptions. */
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "evidence/diagnosis/doubt.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/summary_impl.h"
#include "evidence/diagnosis/value_text.h"

#define GROUP 3 /* effects of a group that are said */

void um_diagnosis_words_add(struct um_diagnosis_words *words, const char *format, ...)
{
  va_list list;
  va_start(list, format);
  int n = vsnprintf(words->at + words->used, words->size - words->used, format, list);
  va_end(list);
  if (n > 0) words->used += (size_t)n;
  if (words->used >= words->size) words->used = words->size - 1;
}
#define add um_diagnosis_words_add

/* ---- one effect ---- */

static bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

/* What the effect is in its own words. inside: of a sentence; "MLI" stays as it is. */
static void add_description(struct um_diagnosis_words *words, const struct um_diagnosis *d,
                            const struct um_effect *effect, bool inside)
{
  const char *text = effect->summary;
  if (um_sensitivity_is_on(d->forward, effect)) {
    add(words, inside ? "too much in the scenario: " : "Too much in the scenario: ");
    inside = true;
  }
  if (inside && is_capital(text[0]) && !is_capital(text[1]))
    add(words, "%c%s", text[0] - 'A' + 'a', text + 1);
  else
    add(words, "%s", text);
}

/* "emittance:white factor 0.900 +- 0.010, emittance 0.7700 +- 0.0085 instead of 0.85" */
static void add_use(struct um_diagnosis_words *words, const struct um_diagnosis *d,
                    const struct um_effect *effect, const char *target, const double *value,
                    const double *sigma, bool wholes)
{
  char values[UM_DIAGNOSIS_VALUES_MAX];
  um_diagnosis_values_text(d->forward, effect, target, value, sigma, wholes, values);
  bool off = um_sensitivity_is_on(d->forward, effect);
  add(words, "%s%s%s%s%s", effect->name, target != NULL ? ":" : "", target != NULL ? target : "",
      off || values[0] != '\0' ? " " : "", off ? "off" : values);
}

/* ", 42 %" among what was fitted in that step and nothing. */
static void add_probability(struct um_diagnosis_words *words, double p)
{
  if (p > 0.99)
    add(words, ", over 99 %%");
  else if (p >= 0.01)
    add(words, ", %.0f %%", 100.0 * p);
}

/* ---- alternatives of one effect ---- */

/* The first alternative that only its prior or the end of its range excludes. */
static void add_excluded(struct um_diagnosis_words *words, const struct um_diagnosis *d,
                         const struct um_diagnosis_step *step)
{
  size_t n = 0;
  for (size_t i = 1; i < step->nalternative; i++) {
    const struct um_diagnosis_alternative *r = &step->alternative[i];
    const struct um_sensitivity_candidate *c = &d->candidates->candidate[r->candidate];
    bool tied = step->by_prior && r->indistinguishable;
    if (!tied && !r->excluded_by_prior && !r->excluded_by_range) continue;
    if (n++ > 0) continue;
    add(words, "; ");
    add_use(words, d, c->effect, c->target, r->value, r->sigma, true);
    if (r->excluded_by_range)
      add(words, " would fit as well, but its range ends there");
    else
      add(words, " fits as well, but is %.2g prior widths from the usual value",
          um_diagnosis_prior_widths(c, r->value));
  }
  if (n > 1) add(words, ", and so for %zu more", n - 1);
}

/* The first few names of the alternatives that are tied, or that were not tried. */
static void add_names(struct um_diagnosis_words *words, const struct um_diagnosis *d,
                      const struct um_diagnosis_step *step, bool not_tried, const char *label)
{
  size_t others = 0, n = 0;
  for (size_t i = 1; i < step->nalternative; i++) {
    const struct um_diagnosis_alternative *r = &step->alternative[i];
    if (!(not_tried ? r->not_tried : r->indistinguishable)) continue;
    others++;
    if (n == GROUP) continue;
    add(words, "%s%s", n++ == 0 ? label : ", ", d->candidates->candidate[r->candidate].name);
  }
  if (others > n) add(words, " and %zu more", others - n);
}

/* What does as well, behind the winner. */
static void add_group(struct um_diagnosis_words *words, const struct um_diagnosis *d,
                      const struct um_diagnosis_step *step)
{
  size_t others = 0;
  for (size_t i = 1; i < step->nalternative; i++) {
    const struct um_diagnosis_alternative *r = &step->alternative[i];
    const struct um_sensitivity_candidate *c = &d->candidates->candidate[r->candidate];
    if (!r->indistinguishable) continue;
    if (++others >= GROUP) continue;
    bool again = c->effect == d->candidates->candidate[step->candidate].effect;
    add(words, "; or ");
    if (!again) add_description(words, d, c->effect, true);
    add(words, again ? "" : " (");
    add_use(words, d, c->effect, c->target, r->value, r->sigma, false);
    add_probability(words, r->probability);
    add(words, again ? "" : ")");
  }
  if (others >= GROUP) add(words, "; or %zu more", others - GROUP + 1);
}

/* ---- classes ---- */

static int class_of(const struct um_diagnosis *d, size_t i)
{
  const struct um_diagnosis_step *step = um_diagnosis_step_of(d, &d->addition[i]);
  return step == NULL || d->candidates == NULL ? UM_DIAGNOSIS_CHOSEN : (int)step->confidence;
}

/* What the effect explains, in BIC; 0 where nobody asked. */
static double worth(const struct um_diagnosis *d, size_t i)
{
  const struct um_diagnosis_step *step = um_diagnosis_step_of(d, &d->addition[i]);
  return step == NULL || isnan(step->delta_bic) ? 0.0 : -step->delta_bic;
}

/* The addition of a class that stands n-th by its worth; SIZE_MAX: there are fewer. */
static size_t find(const struct um_diagnosis *d, int confidence, size_t n)
{
  for (size_t i = 0; i < d->naddition; i++) {
    size_t before = 0;
    if (class_of(d, i) != confidence) continue;
    for (size_t k = 0; k < d->naddition; k++)
      before += class_of(d, k) == confidence &&
                (worth(d, k) > worth(d, i) || (worth(d, k) == worth(d, i) && k < i));
    if (before == n) return i;
  }
  return SIZE_MAX;
}

/* "Walls hold more heat than stated (heat_capacity:bus factor 1.20 +- 0.02; certain, over 99 %)" */
static void add_effect(struct um_diagnosis_words *words, const struct um_diagnosis *d, size_t i,
                       int confidence)
{
  const struct um_model_addition *a = &d->addition[i];
  const struct um_diagnosis_step *step =
      confidence == UM_DIAGNOSIS_CHOSEN ? NULL : um_diagnosis_step_of(d, a);
  add_description(words, d, a->effect, false);
  add(words, " (");
  add_use(words, d, a->effect, a->target, a->value, d->addition_sigma[i],
          confidence != UM_CONFIDENCE_ONE_OF_GROUP);
  if (confidence == UM_CONFIDENCE_CERTAIN) add(words, "; certain");
  if (step != NULL && step->nalternative > 0)
    add_probability(words, step->alternative[0].probability);
  if (confidence == UM_CONFIDENCE_UNCERTAIN) add(words, "; %s", um_diagnosis_doubt_of(d, step));
  add(words, ")");
  if (step == NULL) return;
  if (confidence == UM_CONFIDENCE_ONE_OF_GROUP) add_group(words, d, step);
  if (confidence == UM_CONFIDENCE_SMALL) add_names(words, d, step, false, ", or ");
  if (confidence != UM_CONFIDENCE_SMALL) add_excluded(words, d, step);
  add_names(words, d, step, true, "; not fitted, though the linear model rates them as good: ");
}

size_t um_diagnosis_words_class(struct um_diagnosis_words *words, const struct um_diagnosis *d,
                                int confidence, const char *first, const char *again, size_t *left)
{
  size_t n = 0;
  for (size_t i; (i = find(d, confidence, n)) != SIZE_MAX; n++) {
    if (*left == 0) break;
    --*left;
    bool missing = d->verdict != UM_VERDICT_FOUND || !d->addition[i].off;
    add(words, "%s%s", words->used > 0 ? " " : "", !missing ? "" : n == 0 ? first : again);
    add_effect(words, d, i, confidence);
    add(words, ".");
  }
  size_t said = n;
  while (find(d, confidence, n) != SIZE_MAX) n++;
  return n - said;
}
