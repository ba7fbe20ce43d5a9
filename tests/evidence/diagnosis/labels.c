/* A verdict claims no more than was done: what is near nothing is not certain, what was not fitted
 * is not tied, what was not tried is named, an effect is no alternative to itself. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "evidence/diagnosis/diagnosis_impl.h"
#include "evidence/diagnosis/doubt.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"
#include "evidence/diagnosis/trials_impl.h"

#define PLATE_STEP "24" /* [s] */
#include "tests/evidence/diagnosis/plate_diagnosis_test.h"

/* ---- by hand ---- */

/* An effect of one parameter whose best value and sigma are given; what is left is noise. */
struct one {
  struct um_effect_parameter parameter;
  struct um_effect effect;
  struct um_sensitivity_candidate candidate;
  struct um_sensitivity_candidates candidates;
  struct um_diagnosis_alternative alternative[2];
  struct um_diagnosis_step step;
  struct um_diagnosis d;
};

static void one_make(struct one *o, double null_value, bool logarithmic, double value, double sigma)
{
  *o = (struct one){.parameter = {.name = "capacity_J_K",
                                  .unit = "J/K",
                                  .null_value = null_value,
                                  .minimum = -1e9,
                                  .maximum = 1e9,
                                  .prior_sigma = INFINITY,
                                  .logarithmic = logarithmic},
                    .effect = {.name = "capacity", .nparameter = 1},
                    .candidate = {.ncolumn = 1, .null_value = {null_value}},
                    .alternative = {{.fitted = true, .bic = 100.0}, {.fitted = false, .bic = NAN}}};
  static char name[] = "capacity";
  o->candidate.name = name;
  o->effect.parameters = &o->parameter;
  o->candidate.effect = &o->effect;
  o->candidates = (struct um_sensitivity_candidates){.count = 1, .candidate = &o->candidate};
  o->step = (struct um_diagnosis_step){.addition = {.effect = &o->effect, .value = {value}},
                                       .sigma = {sigma},
                                       .delta_bic = -300.0,
                                       .nalternative = 1,
                                       .alternative = o->alternative};
  o->d = (struct um_diagnosis){.candidates = &o->candidates,
                               .nstep = 1,
                               .step = &o->step,
                               .naddition = 1,
                               .chi2_reduced_after = 1.0};
  o->d.final_whiteness =
      (struct um_inference_whiteness){.p_chi2 = 0.5, .p_white = 0.5, .p_worst = 0.5, .worst = 1.0};
}

static void assert_judged(struct one *o, enum um_diagnosis_verdict verdict,
                          enum um_diagnosis_confidence confidence)
{
  const struct um_diagnosis_state nothing = {0};
  o->d.verdict = um_diagnosis_judge(&nothing, &o->d);
  assert_int_equal(o->d.verdict, verdict);
  um_diagnosis_confidence_assign(&o->d);
  assert_int_equal(o->step.confidence, confidence);
}

/* 115,568 +- 107,477 J/K is 1.1 sigma from nothing: whatever its BIC, it is not certain. */
static void near_nothing_is_not_certain(void **state)
{
  (void)state;
  struct one o;
  one_make(&o, 0.0, false, 115568.0, 107477.0);
  assert_judged(&o, UM_VERDICT_NOT_IDENTIFIABLE, UM_CONFIDENCE_UNCERTAIN);
  assert_string_equal(um_diagnosis_confidence_name(o.step.confidence), "uncertain");
  one_make(&o, 0.0, false, 115568.0, 50000.0); /* 2.3 sigma */
  assert_judged(&o, UM_VERDICT_FOUND, UM_CONFIDENCE_CERTAIN);
  /* observations that scatter by 1.2 of what they say: 2.1 of such sigmas, then 1.9 */
  o.d.chi2_reduced_after = 1.2;
  assert_judged(&o, UM_VERDICT_FOUND, UM_CONFIDENCE_CERTAIN);
  o.d.chi2_reduced_after = 1.45;
  assert_judged(&o, UM_VERDICT_NOT_IDENTIFIABLE, UM_CONFIDENCE_UNCERTAIN);
  /* a factor 0.5 is ln 2 from 1, which is 2.8 of its sigma 0.125 / 0.5, and 1.7 of 0.2 / 0.5 */
  one_make(&o, 1.0, true, 0.5, 0.125);
  assert_judged(&o, UM_VERDICT_FOUND, UM_CONFIDENCE_CERTAIN);
  o.step.sigma[0] = 0.2;
  assert_judged(&o, UM_VERDICT_NOT_IDENTIFIABLE, UM_CONFIDENCE_UNCERTAIN);
  /* without a sigma at the end of its range, or as a switch */
  one_make(&o, 0.0, false, 5.0, NAN);
  assert_judged(&o, UM_VERDICT_FOUND, UM_CONFIDENCE_CERTAIN);
  one_make(&o, 0.0, false, 0.0, NAN);
  o.candidate.is_switch = true;
  assert_judged(&o, UM_VERDICT_FOUND, UM_CONFIDENCE_CERTAIN);
}

/* Odds of the effect are 0.35 to 0.5, and exp(-dBIC / 2): 99 are reached at a gain of 9.9. White
 * noise has been tested by p. */
static void near_a_discrepancy_is_not_certain(void **state)
{
  (void)state;
  struct one o;
  one_make(&o, 0.0, false, 5.0, 1.0);
  o.d.final_whiteness.chi2 = o.d.final_whiteness.dof = 100.0;
  o.step.delta_bic = -9.8;
  assert_judged(&o, UM_VERDICT_FOUND, UM_CONFIDENCE_CERTAIN);
  o.d.weighed = true;
  assert_judged(&o, UM_VERDICT_NOT_IDENTIFIABLE, UM_CONFIDENCE_UNCERTAIN);
  assert_non_null(strstr(um_diagnosis_doubt_of(&o.d, &o.step), "an error of the model"));
  o.step.delta_bic = -10.0;
  assert_judged(&o, UM_VERDICT_FOUND, UM_CONFIDENCE_CERTAIN);
  struct um_diagnosis_alternative tested[10] = {0}; /* ten candidates share the prior */
  o.d.ranking = tested;
  o.d.nranking = 10;
  assert_judged(&o, UM_VERDICT_NOT_IDENTIFIABLE, UM_CONFIDENCE_UNCERTAIN);
  o.step.delta_bic = -14.6;
  assert_judged(&o, UM_VERDICT_FOUND, UM_CONFIDENCE_CERTAIN);
}

/* What 13 of 25 small changes alter is not certain; 12 of them may. */
static void what_hangs_on_little_is_not_certain(void **state)
{
  (void)state;
  struct one o;
  one_make(&o, 0.0, false, 5.0, 1.0);
  o.d.sceptic = (struct um_diagnosis_sceptic){.asked = true, .variations = 25, .flips = 12};
  assert_judged(&o, UM_VERDICT_FOUND, UM_CONFIDENCE_CERTAIN);
  o.d.sceptic.flips = 13;
  assert_judged(&o, UM_VERDICT_NOT_IDENTIFIABLE, UM_CONFIDENCE_UNCERTAIN);
  assert_non_null(strstr(um_diagnosis_doubt_of(&o.d, &o.step), "small changes"));
}

/* One that was not fitted leaves the winner uncertain, and is called not tried. */
static void not_tried_is_no_tie(void **state)
{
  (void)state;
  struct one o;
  one_make(&o, 0.0, false, 5.0, 1.0);
  o.step.nalternative = 2;
  o.alternative[1].not_tried = true;
  assert_judged(&o, UM_VERDICT_NOT_IDENTIFIABLE, UM_CONFIDENCE_ONE_OF_GROUP);
  o.step.delta_bic = -10.0;
  assert_judged(&o, UM_VERDICT_NOT_IDENTIFIABLE, UM_CONFIDENCE_SMALL);
}

/* What does a little better than the effect of a step does not take its place in the list. */
static void effect_leads_its_alternatives(void **state)
{
  (void)state;
  struct um_diagnosis_alternative a[3] = {{.candidate = 7, .fitted = true, .bic = 99.0},
                                          {.candidate = 4, .fitted = true, .bic = 100.0},
                                          {.candidate = 5, .fitted = true, .bic = 103.0}};
  struct um_diagnosis_step step = {.nalternative = 3, .alternative = a};
  assert_true(um_diagnosis_put_first(&step, 4));
  assert_true(a[0].candidate == 4 && a[1].candidate == 7 && a[2].candidate == 5);
  assert_false(um_diagnosis_put_first(&step, 8));
}

/* ---- on the plate ---- */

/* A visible band that reads 2 % high: calibration, size, paint, the Sun. With one fit in a round
 * all others are left to those that score as well, and every one of them is fitted. */
static void ties_are_fitted(void **state)
{
  (void)state;
  const struct lists lists = {.with = LIST("zero_point:vis,factor=1.02"),
                              .only = LIST("zero_point:vis", "area:wing", "diffuse_level",
                                           "extinction:vis", "solar_irradiance"),
                              .of = "vis",
                              .alternatives = 1};
  struct diagnosed c = diagnose(&lists);
  size_t tied = 0;
  assert_true(c.d->nstep == 1);
  for (size_t i = 0; i < c.d->step[0].nalternative; i++) {
    const struct um_diagnosis_alternative *r = &c.d->step[0].alternative[i];
    assert_false(r->not_tried);
    assert_true(r->fitted || !r->indistinguishable);
    assert_true(i == 0 || r->candidate != c.d->step[0].candidate);
    tied += r->indistinguishable;
  }
  assert_true(tied >= 2);
  end(&c);
}

/* Both bands read low, by 10 and 15 %: a scale of each, or the size and a scale of either, which
 * differ by their priors alone, less than 2 in BIC. What was added stays, and what would do a
 * little better in its place is named behind it. */
static void added_effect_leads_a_better_one(void **state)
{
  (void)state;
  const struct lists lists = {.with =
                                  LIST("zero_point:vis,factor=0.9", "zero_point:lwir,factor=0.85"),
                              .only = LIST("zero_point", "area:wing")};
  struct diagnosed c = diagnose(&lists);
  size_t better = 0;
  assert_int_equal(c.d->naddition, 2);
  for (size_t s = 0; s < c.d->nstep; s++) {
    const struct um_diagnosis_alternative *own = &c.d->step[s].alternative[0];
    assert_true(own->candidate == c.d->step[s].candidate);
    assert_false(own->indistinguishable);
    for (size_t i = 1; i < c.d->step[s].nalternative; i++)
      better += c.d->step[s].alternative[i].fitted && c.d->step[s].alternative[i].bic < own->bic;
  }
  assert_true(better > 0);
  end(&c);
}

/* A fit that has to come below a BIC that its own parameters already pay more for can win nothing:
 * it ends on the way. One that may end anywhere goes on to its minimum. */
static void hopeless_fit_is_pruned(void **state)
{
  (void)state;
  const struct lists lists = {.with = LIST("heat_capacity:wing,factor=10"),
                              .only = LIST("heat_capacity:wing")};
  struct diagnosed c = diagnose(&lists);
  const struct um_diagnosis_options options = {0};
  const size_t first = 0;
  enum um_diagnosis_fate fate = UM_FATE_NOT_FITTED;
  const struct um_diagnosis_work work = {
      .forward = c.forward, .candidates = c.candidates, .options = &options, .fate = &fate};
  struct um_diagnosis_state bare = {0}, whole = {0}, pruned = {0};
  assert_int_equal(c.candidates->count, 1);
  OK(um_diagnosis_state_fit(context, &work, &bare, c.candidates->base, NULL, INFINITY));
  OK(um_diagnosis_with(context, &work, &bare, &first, 1, INFINITY, &whole));
  OK(um_diagnosis_with(context, &work, &bare, &first, 1, 1.0, &pruned)); /* ln n is above 1 */
  print_message("whole: %zu steps, chi2 %g; pruned: %zu steps, chi2 %g\n", whole.fit->iterations,
                whole.fit->chi2, pruned.fit->iterations, pruned.fit->chi2);
  assert_true(whole.fit->converged && !pruned.fit->converged);
  assert_true(pruned.fit->iterations < whole.fit->iterations);
  um_diagnosis_state_release(context, &pruned);
  um_diagnosis_state_release(context, &whole);
  um_diagnosis_state_release(context, &bare);
  end(&c);
}

/* A pair took the place of two effects, and one of the pair was taken out again: what is left has
 * a step of its own, and those of the others are gone. */
static void what_is_left_of_a_pair_has_its_step(void **state)
{
  (void)state;
  const struct lists lists = {.with = LIST("zero_point:vis,factor=0.9"),
                              .only = LIST("zero_point", "area:wing")};
  struct diagnosed c = diagnose(&lists);
  const struct um_diagnosis_options options = {0};
  size_t n = c.forward->observations.count, left = c.d->step[0].candidate;
  size_t *fold = calloc(n, sizeof *fold);
  enum um_diagnosis_fate *fate = calloc(c.candidates->count, sizeof *fate);
  struct um_diagnosis_shape *shape = calloc(c.candidates->count, sizeof *shape);
  assert_true(fold != NULL && fate != NULL && shape != NULL && c.candidates->count == 3);
  for (size_t j = 0; j < n; j++) fold[j] = j % 2;
  const struct um_diagnosis_work work = {.forward = c.forward,
                                         .candidates = c.candidates,
                                         .options = &options,
                                         .level = 0.01,
                                         .alternatives = 8,
                                         .fold = fold,
                                         .nfold = 2,
                                         .fate = fate,
                                         .shape = shape};
  struct um_diagnosis_state bare = {0}, alone = {0};
  struct um_diagnosis d = {.candidates = c.candidates};
  OK(um_core_allocate(context, 2, sizeof *d.step, &d.step));
  d.nstep = 2;
  d.step[0].candidate = (left + 1) % 3;
  d.step[1].candidate = (left + 2) % 3;
  OK(um_diagnosis_state_fit(context, &work, &bare, c.candidates->base, NULL, INFINITY));
  OK(um_diagnosis_with(context, &work, &bare, &left, 1, INFINITY, &alone));
  OK(um_diagnosis_leave_one_out(context, &work, &alone, &d));
  assert_int_equal(d.nstep, 1);
  assert_true(d.step[0].candidate == left && !d.step[0].removed);
  assert_true(fabs(d.step[0].delta_bic - c.d->step[0].delta_bic) <= 0.1); /* as a fit converges */
  um_diagnosis_steps_clear(context, &d);
  um_core_free(context, d.step);
  um_diagnosis_state_release(context, &alone);
  um_diagnosis_state_release(context, &bare);
  free(fold);
  free(fate);
  free(shape);
  end(&c);
}

/* Fits of many processes are those of one alone, bit for bit; the model was evaluated as often. */
static void trials_are_as_one_by_one(void **state)
{
  (void)state;
  const struct lists lists = {.with = LIST("zero_point:vis,factor=0.9"),
                              .only = LIST("zero_point", "area:wing")};
  struct diagnosed c = diagnose(&lists);
  const struct um_diagnosis_options options = {0};
  const int threads = um_core_context_threads(context);
  enum um_diagnosis_fate fate[3] = {UM_FATE_NOT_FITTED};
  const struct um_diagnosis_work work = {
      .forward = c.forward, .candidates = c.candidates, .options = &options, .fate = fate};
  struct um_diagnosis_state bare = {0}, alone = {0};
  size_t evaluations[2], pair[2] = {0, 2};
  assert_int_equal(c.candidates->count, 3);
  OK(um_diagnosis_state_fit(context, &work, &bare, c.candidates->base, NULL, INFINITY));
  OK(um_diagnosis_with(context, &work, &bare, pair, 2, INFINITY, &alone));
  for (int i = 0; i < 2; i++) {
    struct um_diagnosis_trial trial[] = {
        {.candidate = {1}, .ncandidate = 1, .prune_above = 1.0, .lead = -INFINITY},
        {.candidate = {0, 2}, .ncandidate = 2, .prune_above = INFINITY, .lead = -INFINITY}};
    const struct um_diagnosis_state *s = &trial[1].state;
    evaluations[i] = c.forward->evaluations;
    um_core_context_set_threads(context, i == 0 ? 1 : 3);
    OK(um_diagnosis_trials_fit(context, &work, &bare, trial, 2));
    evaluations[i] = c.forward->evaluations - evaluations[i];
    assert_true(s->nblock == 2 && s->nnuisance == 0 && s->nparameter == alone.nparameter);
    assert_memory_equal(s->block, alone.block, 2 * sizeof *s->block);
    assert_true(s->fit->bic == alone.fit->bic && s->fit->iterations == alone.fit->iterations);
    assert_memory_equal(s->fit->jacobian, alone.fit->jacobian,
                        s->nparameter * c.forward->observations.count * sizeof(double));
    assert_false(trial[0].refused);
    um_diagnosis_trials_release(context, trial, 2);
  }
  um_core_context_set_threads(context, threads);
  assert_int_equal(evaluations[0], evaluations[1]);
  assert_true(fate[0] == UM_FATE_FITTED && fate[1] == UM_FATE_FITTED);
  um_diagnosis_state_release(context, &alone);
  um_diagnosis_state_release(context, &bare);
  end(&c);
}

/* A correction of light that another one is as good as leaves the half open by as much: 2 in BIC
 * are odds of e to 1. */
static void halves_have_what_could_be_in_its_place(void **state)
{
  (void)state;
  struct um_inference_fit fit = {.nobservation = 100};
  const struct um_diagnosis_state bare = {.fit = &fit};
  struct um_diagnosis d = {
      .verdict = UM_VERDICT_UNEXPLAINED,
      .light = {.any = true,
                .kind = UM_LIGHT_FACTOR,
                .coordinate = UM_COORDINATE_TURN_Y,
                .worth = 100.0,
                .nalternative = 1,
                .alternative = {
                    {.kind = UM_LIGHT_FACTOR, .coordinate = UM_COORDINATE_SUNLIT, .behind = 2.0}}}};
  um_diagnosis_halves_assign(&bare, &d);
  assert_true(fabs(d.half[UM_HALF_EARTH] / d.half[UM_HALF_SURFACE] - exp(-1.0)) < 1e-12);
  assert_true(fabs(d.half[UM_HALF_EARTH] + d.half[UM_HALF_SURFACE] - 1.0) < 1e-12);
}

/* What is on by default is tried off: air that the truth has not is found too much, and no shadow
 * is moved for it. Where the shadow is moved, or nothing is, no switch is turned. */
static void what_is_too_much_is_found(void **state)
{
  (void)state;
  struct lists lists = {
      .not_there = "shadow_refraction",
      .only = LIST("shadow_radius", "oblateness", "shadow_refraction", "time_tag", "albedo")};
  struct diagnosed c = diagnose(&lists);
  assert_int_equal(c.d->verdict, UM_VERDICT_FOUND);
  assert_int_equal(c.d->naddition, 1);
  assert_true(c.d->addition[0].off);
  assert_string_equal(c.d->addition[0].effect->name, "shadow_refraction");
  /* no number is free, but the odds are 1 to 100: 2 ln 100 */
  assert_true(fabs(c.d->bic_after - c.d->step[0].chi2 - 2.0 * log(100.0)) < 0.05);
  assert_int_equal(
      strncmp(c.d->summary, "Too much in the scenario: the Earth's air bends, spreads", 55), 0);
  says(&c, "(shadow_refraction off; certain");
  end(&c);
  lists.not_there = NULL;
  c = diagnose(&lists);
  assert_int_equal(c.d->verdict, UM_VERDICT_COMPLETE);
  end(&c);
  lists.with = LIST("shadow_radius,shift_km=-15");
  c = diagnose(&lists);
  assert_int_equal(c.d->verdict, UM_VERDICT_FOUND);
  assert_string_equal(c.d->addition[0].effect->name, "shadow_radius");
  end(&c);
}

/* Of the visible band alone nothing is said by the heat of the wing, and the inside of the wing has
 * no power: both are named with the reason, and nothing is claimed of them. */
static void what_is_not_tried_is_named(void **state)
{
  (void)state;
  struct lists lists = {.with = LIST("zero_point:vis,factor=0.9"),
                        .only = LIST("heat_capacity:wing", "internal_power:wing"),
                        .of = "vis"};
  struct diagnosed c = diagnose(&lists);
  assert_int_equal(c.d->verdict, UM_VERDICT_UNEXPLAINED);
  assert_int_equal(
      strncmp(c.d->summary, "None of the effects asked for could be tried. The scenario is", 61),
      0);
  says(&c,
       " Not tried: internal_power:wing (effect 'internal_power': the part 'wing' has no "
       "interior that could take the power; accepted: a part with interior), heat_capacity:wing "
       "(no observation changes with it).");
  assert_int_equal(c.d->nmissed, 2);
  assert_false(c.d->missed[0].tested || c.d->missed[1].tested);
  end(&c);
  /* one that was tested, and one that stands for the same thing under another name */
  lists.only = LIST("extinction:vis", "aperture_loss:lwir");
  lists.with = LIST("zero_point:vis,factor=1.001");
  c = diagnose(&lists);
  assert_int_equal(c.d->verdict, UM_VERDICT_COMPLETE);
  says(&c, " Not tried: aperture_loss:lwir (no observation changes with it).");
  assert_int_equal(c.d->nmissed, 2);
  end(&c);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(near_nothing_is_not_certain),
                                     cmocka_unit_test(near_a_discrepancy_is_not_certain),
                                     cmocka_unit_test(what_hangs_on_little_is_not_certain),
                                     cmocka_unit_test(not_tried_is_no_tie),
                                     cmocka_unit_test(effect_leads_its_alternatives),
                                     cmocka_unit_test(ties_are_fitted),
                                     cmocka_unit_test(added_effect_leads_a_better_one),
                                     cmocka_unit_test(hopeless_fit_is_pruned),
                                     cmocka_unit_test(what_is_left_of_a_pair_has_its_step),
                                     cmocka_unit_test(trials_are_as_one_by_one),
                                     cmocka_unit_test(halves_have_what_could_be_in_its_place),
                                     cmocka_unit_test(what_is_too_much_is_found),
                                     cmocka_unit_test(what_is_not_tried_is_named)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
