/* The verdict in words. What is missing comes first, in the words of the effects. Where the verdict
 * abstains it names no effect as the one: it says what is certain, groups, and what the residual
 * looks like. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/steps_impl.h"
#include "evidence/diagnosis/summary_impl.h"
#include "evidence/diagnosis/value_text.h"
#include "orbit/time.h"

#define add um_diagnosis_words_add

/* ---- what is left ---- */

static void add_channel(struct um_diagnosis_words *text, const struct um_diagnosis *d,
                        size_t channel)
{
  const struct um_compare_channel *c = &d->forward->measurements->channel[channel];
  add(text, "%s %s", um_compare_quantity_name(c->quantity), c->label);
}

/* How what is left differs from noise of the stated sigma. between: before the first one. */
static void add_scatter(struct um_diagnosis_words *text, const struct um_diagnosis *d,
                        const char *between)
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
    if (s->scale < UM_DIAGNOSIS_SCATTERS) continue;
    add(text, "%s", between);
    add_channel(text, d, s->channel);
    add(text, " scatters %.2g times its sigma", s->scale);
    between = "; ";
  }
  if (d->noutlier > 0)
    add(text, "%s%zu row%s set aside as outliers", between, d->noutlier,
        d->noutlier == 1 ? " is" : "s are");
  if (d->nscatter + d->noutlier > 0) add(text, ".");
}

/* ---- verdicts that abstain ---- */

/* "since_shadow_entry_s" as a person says it; as it is where this list does not know it. */
static const char *coordinate_words(const char *coordinate, char out[160])
{
  static const struct {
    const char *name, *words;
  } known[] = {{"time_s", "time"},
               {"model", "how large the value is"},
               {"phase_angle_deg", "the phase angle"},
               {"range_km", "the distance to the observer"},
               {"moon_separation_deg", "the distance from the Moon in the sky"},
               {"azimuth_deg", "the azimuth"},
               {"elevation_deg", "the elevation"},
               {"sun_elevation_deg", "the elevation of the Sun at the station"},
               {"sunlit_fraction", "how much of the Sun's disc is seen"},
               {"since_shadow_entry_s", "the time since it entered the shadow"},
               {"since_shadow_exit_s", "the time since it left the shadow"},
               {"spin_phase", "the phase of the spin"},
               {"albedo_W_m2", "the sunlight that the Earth reflects"},
               {"earth_view", "how much of the Earth it sees"}};
  static const char sun[] = "sun_on.", unit[] = "_W_m2";
  for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
    if (strcmp(coordinate, known[i].name) == 0) return known[i].words;
  size_t n = strlen(coordinate), before = sizeof sun - 1, behind = sizeof unit - 1;
  if (strncmp(coordinate, sun, before) != 0 || n < before + behind) return coordinate;
  snprintf(out, 160, "the sunlight on %.*s", (int)(n - before - behind), coordinate + before);
  return out;
}

static void add_residual(struct um_diagnosis_words *text, const struct um_diagnosis *d)
{
  const struct um_missing_heat_residual *r = &d->residual;
  char words[160];
  if (r->channel == NULL) return;
  add(text,
      " The scenario is off most in %s (measured %.2g sigma %s it on average, chi-square %.3g "
      "per observation)",
      r->channel, fabs(r->mean), r->mean < 0.0 ? "below" : "above", r->chi2_reduced);
  if (r->coordinate != NULL && r->p < UM_DIAGNOSIS_CORRELATES)
    add(text, ", and the residual correlates with %s", coordinate_words(r->coordinate, words));
  add(text, ".");
}

/* Effects that a free nuisance which moved may stand for. */
static void add_absorbed(struct um_diagnosis_words *text, const struct um_diagnosis *d)
{
  size_t n = 0;
  for (size_t i = 0; i < d->nranking && n < 6; i++) {
    if (!(d->ranking[i].score.kept < UM_DIAGNOSIS_RESEMBLES)) continue;
    add(text, "%s%s", n++ == 0 ? "; it may stand for " : ", ",
        d->candidates->candidate[d->ranking[i].candidate].name);
  }
}

static void add_heat(struct um_diagnosis_words *text, const struct um_missing_heat_unexplained *u)
{
  char start[40], shape[UM_MISSING_HEAT_TEXT], energy[80];
  if (u == NULL || u->nheat == 0 || !(u->heat[0].energy_sigma > 0.0)) return; /* rows see no heat */
  const struct um_missing_heat *h = &u->heat[0];
  um_orbit_time_format(h->course.start, start);
  um_missing_heat_text(h, shape);
  um_diagnosis_value_text(h->energy, h->energy_sigma, "+-", energy);
  add(text, " %s %s J in %s from %s +- %.2g s%s.",
      u->found ? "Missing heat explains it:" : "Missing heat explains only a part:", energy,
      h->place, start, h->start_sigma, shape);
}

/* That nothing explains the residual. It claims no more than was tried. */
static const char *claim(const struct um_diagnosis *d)
{
  size_t untested = 0;
  for (size_t i = 0; i < d->nmissed; i++) untested += !d->missed[i].tested;
  if (d->chosen && untested >= d->nasked) return "None of the effects asked for could be tried.";
  if (d->chosen) return "None of the effects asked for explains the measurements.";
  return untested > 0 ? "No effect of the catalogue that could be tried explains the measurements."
                      : "No effect of the catalogue explains the measurements.";
}

static bool is_missed(const struct um_diagnosis *d, size_t i)
{
  bool tested = d->verdict == UM_VERDICT_UNEXPLAINED && d->naddition == 0;
  return d->chosen && (tested || !d->missed[i].tested);
}

void um_diagnosis_say_missed(const struct um_diagnosis *d, size_t most,
                             char out[UM_DIAGNOSIS_SUMMARY_MAX])
{
  struct um_diagnosis_words words = {out, UM_DIAGNOSIS_SUMMARY_MAX, 0}, *text = &words;
  size_t n = 0, said = 0;
  out[0] = '\0';
  for (size_t i = 0; i < d->nmissed; i++) n += is_missed(d, i);
  if (n == 0) return;
  if (most == 1 && n > 1) {
    add(text, "%zu of the effects asked for were not tried.", n);
    return;
  }
  for (size_t i = 0; i < d->nmissed && said < most; i++)
    if (is_missed(d, i))
      add(text, "%s%s (%s)", said++ == 0 ? "Not tried: " : ", ", d->missed[i].name,
          d->missed[i].why);
  if (n > said) add(text, " and %zu more", n - said);
  add(text, ".");
}

/* ---- verdicts ---- */

static void say_complete(struct um_diagnosis_words *text, const struct um_diagnosis *d)
{
  if (d->nscatter + d->noutlier == 0)
    add(text, "Nothing is missing: what is left is noise of the stated sigma.");
  else
    add_scatter(text, d, "Nothing is missing, but ");
}

/* The effects of all classes; how many were left out, of those that it may name. */
static size_t say_classes(struct um_diagnosis_words *text, const struct um_diagnosis *d,
                          const char *certain, const char *again, size_t *left)
{
  size_t more = um_diagnosis_words_class(text, d, UM_DIAGNOSIS_CHOSEN, "Fitted: ", "And: ", left);
  more += um_diagnosis_words_class(text, d, UM_CONFIDENCE_CERTAIN, certain, again, left);
  if (d->verdict == UM_VERDICT_UNEXPLAINED) return more;
  more += um_diagnosis_words_class(text, d, UM_CONFIDENCE_ONE_OF_GROUP,
                                   "One of these, not known which: ", "And one of these: ", left);
  more += um_diagnosis_words_class(text, d, UM_CONFIDENCE_UNCERTAIN,
                                   "Needed, but not certain: ", "Not certain, too: ", left);
  more += um_diagnosis_words_class(text, d, UM_CONFIDENCE_SMALL,
                                   "Small, and what it is cannot be known: ", "Small, too: ", left);
  return more;
}

/* Returns how many were left out. */
static size_t say_unexplained(struct um_diagnosis_words *text, const struct um_diagnosis *d,
                              size_t *left)
{
  char light[UM_DIAGNOSIS_LIGHT_TEXT], half[UM_DIAGNOSIS_HALF_TEXT];
  size_t more;
  if (d->candidates == NULL) { /* chosen, not found */
    more = um_diagnosis_words_class(text, d, UM_DIAGNOSIS_CHOSEN, "Fitted: ", "And: ", left);
    add(text, " What is left is not noise.");
    return more;
  }
  add(text, "%s",
      d->naddition == 0 ? claim(d)
      : d->chosen       ? "The effects asked for do not explain all of it."
                        : "The effects of the catalogue do not explain all of it.");
  more = say_classes(text, d, "Certain all the same: ", "Certain, too: ", left);
  add_residual(text, d);
  bool heats = d->unexplained != NULL && d->unexplained->found;
  if (heats || !d->light.found) add_heat(text, d->unexplained); /* light explains all of it */
  um_diagnosis_light_text(d, light);
  um_diagnosis_half_text(d, half);
  add(text, "%s%s", light, half);
  return more;
}

void um_diagnosis_say_effects(const struct um_diagnosis *d, size_t most,
                              char out[UM_DIAGNOSIS_SUMMARY_MAX])
{
  struct um_diagnosis_words words = {out, UM_DIAGNOSIS_SUMMARY_MAX, 0}, *text = &words;
  size_t more = 0;
  out[0] = '\0';
  switch (d->verdict) {
  case UM_VERDICT_COMPLETE:
    say_complete(text, d);
    break;
  case UM_VERDICT_FOUND:
    more = say_classes(text, d, "Missing: ", "Missing, too: ", &most);
    break;
  case UM_VERDICT_NOT_IDENTIFIABLE:
    if (d->naddition == 0) {
      add(text, "A value that was left free has moved far, and what it stands for cannot be known");
      add_absorbed(text, d);
      add(text, ".");
    }
    more = say_classes(text, d, "Certain: ", "Certain, too: ", &most);
    break;
  case UM_VERDICT_UNEXPLAINED:
    more = say_unexplained(text, d, &most);
    break;
  }
  if (more > 0) add(text, " %zu smaller one%s more.", more, more == 1 ? "" : "s");
}

void um_diagnosis_say_noise(const struct um_diagnosis *d, char out[UM_DIAGNOSIS_SUMMARY_MAX])
{
  struct um_diagnosis_words words = {out, UM_DIAGNOSIS_SUMMARY_MAX, 0}, *text = &words;
  out[0] = '\0';
  if (d->allowance && !d->weighed)
    add(text, "What is left is not quite noise (p %.1g).",
        fmin(d->final_whiteness.p_chi2,
             fmin(d->final_whiteness.p_white, d->final_whiteness.p_worst)));
  if (d->verdict == UM_VERDICT_COMPLETE) return;
  add_scatter(text, d, text->used > 0 ? " Besides, " : "Besides, ");
}

enum um_status um_diagnosis_summary_write(struct um_context *context, const struct um_diagnosis *d,
                                          char **out)
{
  char effects[UM_DIAGNOSIS_SUMMARY_MAX], noise[UM_DIAGNOSIS_SUMMARY_MAX],
      missed[UM_DIAGNOSIS_SUMMARY_MAX];
  um_diagnosis_say_effects(d, SIZE_MAX, effects);
  um_diagnosis_say_noise(d, noise);
  um_diagnosis_say_missed(d, UM_DIAGNOSIS_NAMES, missed);
  return um_core_asprintf(context, out, "%s%s%s%s%s", effects, noise[0] != '\0' ? " " : "", noise,
                          missed[0] != '\0' ? " " : "", missed);
}
