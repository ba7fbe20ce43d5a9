/* What this program and the baselines say of one world. */
#include <math.h>
#include <string.h>

#include "effects/half.h"
#include "evidence/diagnosis/diagnose.h"
#include "evidence/diagnosis/request.h"
#include "tests/bench/bench.h"
#include "tests/bench/worlds.h"

#define WORDS 12
#define LEAST 0.01 /* probability that is kept */

/* Parts a list joined by '+' in place. */
static size_t split(char *text, const char *word[WORDS])
{
  size_t n = 0;
  char *rest = NULL;
  for (char *w = strtok_r(text, "+", &rest); w != NULL && n < WORDS; w = strtok_r(NULL, "+", &rest))
    word[n++] = w;
  return n;
}

static void begin(struct worlds_answer *a, const struct worlds_world *world, const char *method)
{
  *a = (struct worlds_answer){.probability = NAN};
  snprintf(a->world, sizeof a->world, "%s", world->name);
  snprintf(a->method, sizeof a->method, "%s", method);
}

/* Effects that stayed, each certain or as the group of its step. */
static void describe_steps(const struct um_diagnosis *d, struct worlds_answer *a)
{
  const struct um_sensitivity_candidate *candidate = d->candidates->candidate;
  for (size_t s = 0; s < d->nstep; s++) {
    const struct um_diagnosis_step *step = &d->step[s];
    char group[WORLDS_LONG] = "", said[WORLDS_TEXT];
    if (step->removed) continue;
    const char *first = candidate[step->candidate].name;
    snprintf(said, sizeof said, "%s %s", first, um_diagnosis_confidence_name(step->confidence));
    worlds_append(a->note, sizeof a->note, "; ", said);
    if (step->confidence == UM_CONFIDENCE_CERTAIN) {
      worlds_append(a->certain, sizeof a->certain, " ", first);
      continue;
    }
    worlds_append(group, sizeof group, "+", first);
    for (size_t i = 1; i < step->nalternative; i++)
      if (step->alternative[i].indistinguishable && !step->alternative[i].same_effect)
        worlds_append(group, sizeof group, "+", candidate[step->alternative[i].candidate].name);
    worlds_append(a->groups, sizeof a->groups, " ", group);
  }
}

static void add_value(struct worlds_answer *a, const char *effect, const char *target,
                      const char *parameter, double value, double sigma)
{
  char text[2 * WORLDS_TEXT];
  snprintf(text, sizeof text, "%s%s%s %s %.6g %.3g", effect, target != NULL ? ":" : "",
           target != NULL ? target : "", parameter, value, sigma);
  worlds_append(a->values, sizeof a->values, " + ", text);
}

static void describe_values(const struct um_diagnosis *d, struct worlds_answer *a)
{
  for (size_t i = 0; i < d->naddition; i++) {
    const struct um_model_addition *of = &d->addition[i];
    for (size_t p = 0; p < of->effect->nparameter; p++)
      if (d->addition_sigma[i][p] > 0.0)
        add_value(a, of->effect->name, of->target, of->effect->parameters[p].name, of->value[p],
                  d->addition_sigma[i][p]);
  }
}

/* Heat at the place that explains most; start since the first observation. */
static void describe_pulse(const struct um_diagnosis *d, struct worlds_answer *a)
{
  const struct um_missing_heat_unexplained *u = d->unexplained;
  char place[WORLDS_TEXT];
  if (u == NULL || !u->found || u->nheat == 0) return;
  const struct um_sensitivity_observations *o = &d->forward->observations;
  double first = INFINITY;
  for (size_t i = 0; i < o->count; i++) first = fmin(first, o->t[i]);
  snprintf(place, sizeof place, "pulse:%s", u->heat[0].place);
  worlds_append(a->groups, sizeof a->groups, " ", place);
  add_value(a, "pulse", u->heat[0].place, "start_s", u->heat[0].course.start - first,
            u->heat[0].start_sigma);
  add_value(a, "pulse", u->heat[0].place, "energy_J", u->heat[0].energy, u->heat[0].energy_sigma);
}

/* Of the steps, the most that is given to an effect of these names. */
static double given_to(const struct um_diagnosis *d, const char *names)
{
  double most = 0.0;
  for (size_t s = 0; s < d->nstep; s++) {
    const struct um_diagnosis_step *step = &d->step[s];
    double sum = 0.0;
    for (size_t i = 0; i < step->nalternative && !step->removed; i++)
      if (worlds_names_match(names, d->candidates->candidate[step->alternative[i].candidate].name))
        sum += step->alternative[i].probability;
    most = fmax(most, sum);
  }
  return most;
}

/* The probability that is stated for the truth, mean over what is hidden. */
static void describe_probability(const struct um_diagnosis *d, const struct worlds_world *world,
                                 struct worlds_answer *a)
{
  double sum = 0.0, n = 0.0;
  for (size_t i = 0; i < world->nhidden; i++) {
    if (world->hidden[i].optional) continue;
    sum += given_to(d, world->hidden[i].names);
    n += 1.0;
  }
  if (world->good == WORLDS_UNEXPLAINED)
    a->probability = d->probability.none;
  else if (n > 0.0)
    a->probability = sum / n;
}

/* Of steps that stayed, each probability that is worth a word. */
static void describe_stated(const struct um_diagnosis *d, struct worlds_answer *a)
{
  for (size_t s = 0; s < d->nstep; s++) {
    const struct um_diagnosis_step *step = &d->step[s];
    for (size_t i = 0; i < step->nalternative && !step->removed; i++) {
      const struct um_diagnosis_alternative *r = &step->alternative[i];
      char text[2 * WORLDS_TEXT];
      if (!(r->probability >= LEAST)) continue;
      snprintf(text, sizeof text, "%s %.6f", d->candidates->candidate[r->candidate].name,
               r->probability);
      worlds_append(a->stated, sizeof a->stated, " + ", text);
    }
  }
}

static void describe_half(const struct um_diagnosis *d, struct worlds_answer *a)
{
  size_t most = 0;
  for (size_t h = 1; h < UM_HALVES; h++)
    if (d->half[h] > d->half[most]) most = h;
  if (isfinite(d->half[most]))
    snprintf(a->half, sizeof a->half, "%s", um_effects_half_name((enum um_effects_half)most));
}

static enum um_status keep(struct um_context *context, const char *journal,
                           const struct worlds_answer *a)
{
  if (worlds_journal_append(journal, a)) return UM_OK;
  return um_core_fail(context, UM_ERR_IO, "%s: cannot be written", journal);
}

static enum um_status baselines(struct um_context *context, const struct worlds_options *options,
                                const struct worlds_world *world,
                                const struct um_sensitivity_forward *forward,
                                const struct um_sensitivity_candidates *candidates,
                                struct worlds_answer *a)
{
  for (size_t b = 0; b < WORLDS_BASELINES; b++) {
    double start = bench_cpu();
    begin(a, world, worlds_baselines[b]);
    UM_TRY(worlds_baseline(context, forward, candidates, b, a));
    a->seconds = bench_cpu() - start;
    UM_TRY(keep(context, options->journal, a));
  }
  return UM_OK;
}

/* This program's answer. *a is set where it succeeds. */
static enum um_status ask(struct um_context *context, struct um_sensitivity_forward *forward,
                          struct um_sensitivity_candidates *candidates,
                          const struct um_diagnosis_options *wanted,
                          const struct worlds_world *world, struct worlds_answer *a)
{
  struct um_diagnosis *d = NULL;
  UM_TRY(um_diagnosis_create(context, forward, candidates, wanted, &d));
  snprintf(a->verdict, sizeof a->verdict, "%s", um_diagnosis_verdict_name(d->verdict));
  describe_steps(d, a);
  describe_values(d, a);
  describe_pulse(d, a);
  describe_probability(d, world, a);
  describe_half(d, a);
  describe_stated(d, a);
  um_diagnosis_destroy(context, &d);
  return UM_OK;
}

enum um_status worlds_diagnose(struct um_context *context, const struct worlds_options *options,
                               const struct worlds_world *world)
{
  enum um_status status;
  char scenario[2 * WORLDS_TEXT], measured[2 * WORLDS_TEXT + 32], without[WORLDS_TEXT],
      set[WORLDS_TEXT], out[WORLDS_LEFT_OUT][WORLDS_TEXT];
  const char *left_out[WORDS], *key[WORDS], *exclude[WORLDS_LEFT_OUT];
  struct um_model_options model = {.without = left_out, .overrides = key};
  struct um_compare_measurements *measurements = NULL;
  struct um_sensitivity_forward *forward = NULL;
  struct um_sensitivity_candidates *candidates = NULL;
  struct um_diagnosis_request request = {0};
  struct worlds_answer *a = NULL;
  double start = bench_cpu();
  size_t folder = strcspn(world->scenario, "/"), nexclude = 0;
  snprintf(scenario, sizeof scenario, "%s/%s", options->folder, world->scenario);
  snprintf(measured, sizeof measured, "%s/%.*s/%s", options->folder, (int)folder, world->scenario,
           world->measurement);
  snprintf(without, sizeof without, "%s", world->without);
  snprintf(set, sizeof set, "%s", world->set);
  model.nwithout = split(without, left_out);
  model.noverride = split(set, key);
  if (options->open_set) worlds_left_out(world, out, &nexclude);
  for (size_t i = 0; i < nexclude; i++) exclude[i] = out[i];
  UM_CHECK(um_core_allocate(context, 1, sizeof *a, &a));
  UM_CHECK(um_compare_measurements_read(context, measured, &measurements));
  UM_CHECK(um_sensitivity_forward_create(context, scenario, &model, measurements, UM_VARIANT_TIGHT,
                                         &forward));
  UM_CHECK(um_diagnosis_request_make(context, forward->model,
                                     &(struct um_diagnosis_request_texts){0}, &request));
  const struct um_diagnosis_options wanted = {.candidates = {.only = options->only,
                                                             .nonly = options->nonly,
                                                             .exclude = exclude,
                                                             .nexclude = nexclude},
                                              .nuisance = request.nuisance,
                                              .nnuisance = request.nnuisance,
                                              .no_next = true};
  UM_CHECK(
      um_sensitivity_candidates_create(context, forward, NULL, 0, &wanted.candidates, &candidates));
  if (!options->open_set) UM_CHECK(baselines(context, options, world, forward, candidates, a));
  begin(a, world, options->open_set ? WORLDS_OPEN : WORLDS_PROGRAM);
  UM_CHECK(ask(context, forward, candidates, &wanted, world, a));
  a->seconds = bench_cpu() - start;
  UM_CHECK(keep(context, options->journal, a));
done:
  um_diagnosis_request_release(context, &request);
  um_sensitivity_candidates_destroy(context, &candidates);
  um_sensitivity_forward_destroy(context, &forward);
  um_compare_measurements_destroy(context, &measurements);
  um_core_free(context, a);
  return status;
}
