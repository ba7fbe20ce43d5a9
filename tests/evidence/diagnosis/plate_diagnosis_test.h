/* A diagnosis of the plate, from what its truth has and what the analyst looks for. */
#ifndef UMBRA_TESTS_DIAGNOSIS_PLATE_DIAGNOSIS_TEST_H
#define UMBRA_TESTS_DIAGNOSIS_PLATE_DIAGNOSIS_TEST_H

#include <math.h>
#include <string.h>

#include "evidence/diagnosis/diagnose.h"
#include "tests/evidence/diagnosis/measured_test.h"
#include "tests/evidence/diagnosis/plate_test.h"

struct lists {
  const char *const *set, *const *with, *const *only; /* end with NULL, or NULL */
  const char *const *truth;                           /* more --set of the truth */
  const char *without;                                /* that the analyst lacks */
  const char *not_there;                              /* on by default, off in the truth */
  const char *of;                                     /* the only band measured; NULL: both */
  double from, to;     /* rows left in [s since the start]; both 0: all */
  size_t alternatives; /* fitted in a round; 0: as many as usual */
  void (*spoil)(struct um_compare_measurements *); /* what measurements have beside noise */
  bool no_light;                                   /* is not looked for */
  double model; /* sampling error of the model, of the measurement's sigma */
};

static inline size_t count(const char *const *list)
{
  size_t n = 0;
  while (list != NULL && list[n] != NULL) n++;
  return n;
}

struct diagnosed {
  struct um_compare_measurements *measured;
  struct um_sensitivity_forward *forward;
  struct um_sensitivity_candidates *candidates;
  struct um_diagnosis *d;
  struct um_model_options options;
};

static inline void measure(const struct lists *lists, struct um_compare_measurements **out)
{
  const char *set[8];
  size_t n = 0;
  for (size_t i = 0; i < count(lists->set); i++) set[n++] = lists->set[i];
  for (size_t i = 0; i < count(lists->truth); i++) set[n++] = lists->truth[i];
  const struct um_model_options options = {.overrides = set,
                                           .noverride = n,
                                           .with = lists->with,
                                           .nwith = count(lists->with),
                                           .without = &lists->not_there,
                                           .nwithout = lists->not_there != NULL};
  double first = measured_make(context, path, &options, out);
  for (size_t i = 0; i < (*out)->count; i++) {
    struct um_compare_measurement *row = &(*out)->row[i];
    double since = row->t_tai - first;
    bool in = lists->of == NULL || strcmp((*out)->channel[row->channel].of, lists->of) == 0;
    row->flag = in && (lists->to == 0.0 || (since >= lists->from && since <= lists->to)) ? 0 : 1;
  }
  if (lists->spoil != NULL) lists->spoil(*out);
}

static inline struct diagnosed diagnose(const struct lists *lists)
{
  struct diagnosed c = {.options = {.overrides = lists->set,
                                    .noverride = count(lists->set),
                                    .without = &lists->without,
                                    .nwithout = lists->without != NULL}};
  const struct um_diagnosis_options options = {
      .candidates = {.only = lists->only, .nonly = count(lists->only)},
      .alternatives = lists->alternatives,
      .no_heat = true,
      .no_light = lists->no_light};
  measure(lists, &c.measured);
  OK(um_sensitivity_forward_create(context, path, &c.options, c.measured, UM_VARIANT_TIGHT,
                                   &c.forward));
  for (size_t j = 0; lists->model > 0.0 && j < c.forward->observations.count; j++) {
    c.forward->observations.model_sigma[j] = lists->model * c.forward->observations.stated_sigma[j];
    c.forward->observations.sigma[j] =
        hypot(c.forward->observations.stated_sigma[j], c.forward->observations.model_sigma[j]);
  }
  OK(um_sensitivity_candidates_create(context, c.forward, NULL, 0, &options.candidates,
                                      &c.candidates));
  OK(um_diagnosis_create(context, c.forward, c.candidates, &options, &c.d));
  print_message("  %s: %s\n", um_diagnosis_verdict_name(c.d->verdict), c.d->summary);
  return c;
}

static inline void end(struct diagnosed *c)
{
  um_diagnosis_destroy(context, &c->d);
  um_sensitivity_candidates_destroy(context, &c->candidates);
  um_sensitivity_forward_destroy(context, &c->forward);
  um_compare_measurements_destroy(context, &c->measured);
}

static inline const struct um_diagnosis_alternative *alternative(const struct diagnosed *c,
                                                                 size_t step, const char *name)
{
  const struct um_diagnosis_step *s = &c->d->step[step];
  for (size_t i = 0; i < s->nalternative; i++)
    if (strcmp(c->candidates->candidate[s->alternative[i].candidate].name, name) == 0)
      return &s->alternative[i];
  fail_msg("no alternative %s", name);
  return NULL;
}

static inline void says(const struct diagnosed *c, const char *words)
{
  if (strstr(c->d->summary, words) == NULL) fail_msg("no '%s' in: %s", words, c->d->summary);
}

#define LIST(...) ((const char *const[]){__VA_ARGS__, NULL})

#endif
