/* A verdict says what it knows: each effect with a label of its own, what only a prior or a range
 * decided, whole values beside changes, what would tell alternatives apart. On a lumped plate that
 * is cheap to compute, seen on the pass of ENVISAT over Graz that begins in the umbra. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "evidence/diagnosis/steps_impl.h"
#include "tests/support/cmocka_all.h"

#define PLATE_STEP "12" /* [s] */
#include "tests/evidence/diagnosis/plate_diagnosis_test.h"

/* ---- tests ---- */

/* The Sun could be fainter as well as the calibration off, were it not known to 1.7 %: by 6 % its
 * prior keeps it out, which is said; by 10 % it is so far behind that it is not. */
static void prior_is_said(void **state)
{
  (void)state;
  struct lists lists = {.with = LIST("zero_point:vis,factor=0.9425"),
                        .only = LIST("zero_point:vis", "solar_irradiance"),
                        .of = "vis"};
  struct diagnosed c = diagnose(&lists);
  assert_int_equal(c.d->verdict, UM_VERDICT_FOUND);
  const struct um_diagnosis_alternative *sun = alternative(&c, 0, "solar_irradiance");
  assert_true(sun->excluded_by_prior && !sun->excluded_by_range && !sun->indistinguishable);
  assert_true(fabs(sun->chi2 - c.d->chi2_after) < UM_DIAGNOSIS_EVIDENCE);
  static const char missing[] =
      "Missing: The calibration of a band is off by a factor (zero_point:vis factor 0.";
  assert_int_equal(strncmp(c.d->summary, missing, strlen(missing)), 0);
  says(&c, "; certain");
  says(&c, "; solar_irradiance factor 0.");
  says(&c, "instead of 1361 W/m^2 ");
  says(&c, " fits as well, but is ");
  assert_int_equal(c.d->step[0].confidence, UM_CONFIDENCE_CERTAIN);
  end(&c);

  lists.with = LIST("zero_point:vis,factor=0.9");
  c = diagnose(&lists);
  assert_int_equal(c.d->verdict, UM_VERDICT_FOUND);
  sun = alternative(&c, 0, "solar_irradiance");
  assert_true(sun->bic - c.d->step[0].alternative[0].bic >= UM_DIAGNOSIS_NEXT_BEST);
  assert_false(sun->excluded_by_prior);
  assert_null(strstr(c.d->summary, "solar_irradiance"));
  end(&c);
}

/* Cells that give 2 % of the sunlight could give nothing: a wing that takes up a little more heat
 * than that is out of reach of its extraction, and one much hotter is far behind. */
static void range_is_said(void **state)
{
  (void)state;
  struct lists lists = {.set = LIST("parts.wing.electrical_extraction=0.02"),
                        .with = LIST("solar_absorptance:grey_panel,shift=0.031"),
                        .only = LIST("solar_absorptance:grey_panel", "panel_extraction"),
                        .of = "lwir"};
  struct diagnosed c = diagnose(&lists);
  const struct um_diagnosis_alternative *none = alternative(&c, 0, "panel_extraction:wing");
  print_message("  behind by %g\n", none->bic - c.d->step[0].alternative[0].bic);
  assert_true(none->excluded_by_range && !none->excluded_by_prior && !none->indistinguishable);
  says(&c, "; panel_extraction:wing efficiency ");
  says(&c, " would fit as well, but its range ends there");
  end(&c);
  lists.with = LIST("solar_absorptance:grey_panel,shift=0.08");
  c = diagnose(&lists);
  none = alternative(&c, 0, "panel_extraction:wing");
  assert_false(none->excluded_by_range);
  assert_null(strstr(c.d->summary, "panel_extraction"));
  end(&c);
}

/* A factor stands beside the whole that it makes: 0.8439 of 237 W/m^2. */
static void values_are_whole(void **state)
{
  (void)state;
  struct lists lists = {.with = LIST("earth_ir_level,factor=0.8439"),
                        .only = LIST("earth_ir_level", "zero_point:vis")};
  struct diagnosed c = diagnose(&lists);
  assert_int_equal(c.d->verdict, UM_VERDICT_FOUND);
  double value, sigma = 237.0 * c.d->addition_sigma[0][0];
  const char *at = strstr(c.d->summary, ", outgoing longwave radiation ");
  assert_non_null(at);
  value = strtod(at + strlen(", outgoing longwave radiation "), NULL);
  assert_true(fabs(value - 200.0) <= 3.0 * sigma + 0.05);
  says(&c, "instead of 237 W/m^2; certain");
  end(&c);
}

/* Rows about the highest point of the pass tell a calibration from extinction by nothing but its
 * prior; rows toward the horizon, which the scenario has, would. Sigma that is asked of them is the
 * measurement's, 1 % and a thousandth of the peak, whatever error the model had where it was
 * compared: it has none where it is planned (a plate needs no sampling). */
static void next_is_at_high_airmass(void **state)
{
  (void)state;
  struct lists lists = {.with = LIST("zero_point:lwir,factor=0.95"),
                        .only = LIST("zero_point:lwir", "extinction:lwir"),
                        /* the same heat whenever the rows begin */
                        .set = LIST("thermal.start=periodic", "thermal.orbits_before=1"),
                        .of = "lwir",
                        .from = 360.0,
                        .to = 456.0};
  struct diagnosed c = diagnose(&lists);
  assert_int_equal(c.d->verdict, UM_VERDICT_NOT_IDENTIFIABLE);
  assert_int_equal(strncmp(c.d->summary, "One of these, not known which: ", 31), 0);
  assert_true(strstr(c.d->summary, "Missing") == NULL);
  says(&c, "The calibration of a band is off by a factor (zero_point:lwir factor ");
  says(&c, " %); or the atmosphere dims the satellite, more toward the horizon (extinction:lwir ");
  assert_int_equal(c.d->nnext, 1);
  assert_ptr_equal(c.d->next, &c.d->next_of[0]);
  assert_string_equal(c.d->next->of, "lwir");
  assert_non_null(c.d->next->what);
  print_message("  %s, %g\n", c.d->next->what, c.d->next->chi2_difference);
  assert_true(c.d->next->airmass > 1.5);
  assert_non_null(strstr(c.d->next->what, "at an airmass above "));
  assert_null(c.d->next->told_apart_by);
  double sigma = c.d->next->sigma;
  end(&c);
  lists.model = 1.0;
  c = diagnose(&lists);
  assert_non_null(c.d->next);
  print_message("  sigma %.6g and %.6g W/m^2\n", sigma, c.d->next->sigma);
  assert_string_equal(c.d->next->of, "lwir");
  assert_true(fabs(c.d->next->sigma / sigma - 1.0) <= 0.01);
  end(&c);
}

/* What is painted alike on both sides and seen by its reflection alone: nothing of the scenario
 * tells the paint from the calibration, what the effects themselves say is said. */
static void told_apart_in_words(void **state)
{
  (void)state;
  const struct lists lists = {.set = LIST("parts.wing.front=white_paint"),
                              .with = LIST("zero_point:vis,factor=0.9"),
                              .only = LIST("zero_point:vis", "diffuse_level")};
  struct diagnosed c = diagnose(&lists);
  assert_int_equal(c.d->verdict, UM_VERDICT_NOT_IDENTIFIABLE);
  assert_int_equal(c.d->nnext, 1);
  assert_null(c.d->next->what);
  assert_non_null(c.d->next->told_apart_by);
  assert_non_null(strstr(c.d->next->told_apart_by, "standard stars in the same night"));
  end(&c);
}

/* A large effect that is certain beside a small one that nobody can name. */
static void each_effect_has_its_label(void **state)
{
  (void)state;
  const struct lists lists = {
      .with = LIST("zero_point:vis,factor=1.018"),
      .only = LIST("earth_ir", "zero_point:vis", "diffuse_level", "area", "emittance"),
      .without = "earth_ir"};
  struct diagnosed c = diagnose(&lists);
  assert_int_equal(c.d->verdict, UM_VERDICT_NOT_IDENTIFIABLE);
  assert_int_equal(c.d->nstep, 2);
  assert_string_equal(c.d->step[0].addition.effect->name, "earth_ir");
  assert_int_equal(c.d->step[0].confidence, UM_CONFIDENCE_CERTAIN);
  assert_int_equal(c.d->step[1].confidence, UM_CONFIDENCE_SMALL);
  assert_true(-c.d->step[1].delta_bic < UM_DIAGNOSIS_SMALL);
  static const char certain[] = "Certain: Thermal radiation of the Earth heats the satellite "
                                "(earth_ir; certain, over 99 %). Small, and what it is cannot be "
                                "known: ";
  if (strncmp(c.d->summary, certain, strlen(certain)) != 0) fail_msg("%s", c.d->summary);
  says(&c, ", or ");
  end(&c);
}

/* The shadow's edge in rows of a second: a point Sun lacks the penumbra, of a uniform disc as well
 * as of a limb-darkened one. */
static void both_discs_are_tried(void **state)
{
  (void)state;
  struct lists lists = {.set = LIST("environment.disc=point", "time.start_utc=2016-09-06T18:09:50Z",
                                    "time.stop_utc=2016-09-06T18:10:25Z", "time.step_s=0.5",
                                    "thermal.orbits_before=0.02"),
                        .only = LIST("penumbra", "zero_point:vis"),
                        .of = "vis"};
  static const char *const discs[] = {"environment.disc=uniform", "environment.disc=limb_darkened"};
  for (int darkened = 0; darkened < 2; darkened++) {
    lists.truth = LIST(discs[darkened]);
    struct diagnosed c = diagnose(&lists);
    assert_true(c.d->naddition >= 1);
    assert_string_equal(c.d->addition[0].effect->name, "penumbra");
    assert_true(c.d->addition[0].value[0] == (double)darkened);
    assert_int_equal(c.d->step[0].confidence, UM_CONFIDENCE_CERTAIN);
    for (size_t i = 1; i < c.d->step[0].nalternative; i++)
      if (c.d->step[0].alternative[i].same_effect)
        assert_false(c.d->step[0].alternative[i].indistinguishable);
    end(&c);
  }
}

/* ---- by hand ---- */

/* What is left is accepted though it is not noise: said so. */
static void allowance_is_said(void **state)
{
  (void)state;
  const struct um_diagnosis_state nothing = {0};
  struct um_diagnosis d = {.naddition = 1, .chi2_reduced_after = 1.2};
  d.final_whiteness =
      (struct um_inference_whiteness){.p_chi2 = 1e-5, .p_white = 0.5, .p_worst = 0.5, .worst = 1.3};
  assert_int_equal(um_diagnosis_judge(&nothing, &d), UM_VERDICT_FOUND);
  assert_true(d.allowance);
  struct um_diagnosis white = {.naddition = 1, .chi2_reduced_after = 1.0};
  white.final_whiteness =
      (struct um_inference_whiteness){.p_chi2 = 0.5, .p_white = 0.5, .p_worst = 0.5, .worst = 1.0};
  assert_int_equal(um_diagnosis_judge(&nothing, &white), UM_VERDICT_FOUND);
  assert_false(white.allowance);
  white.verdict = UM_VERDICT_FOUND;
  d.naddition = white.naddition = 0; /* no forward to ask about values */
  char *sentence;
  OK(um_diagnosis_summary_write(context, &white, &sentence));
  assert_null(strstr(sentence, "not quite noise"));
  um_core_free(context, sentence);
  d.verdict = UM_VERDICT_FOUND;
  OK(um_diagnosis_summary_write(context, &d, &sentence));
  assert_non_null(strstr(sentence, "What is left is not quite noise (p 1e-05)."));
  um_core_free(context, sentence);
}

/* Certain without an alternative or where all are implausible, one of a group, small below 20;
 * where chi-square is too large, differences are worth less. */
static void confidence_classes(void **state)
{
  (void)state;
  struct um_diagnosis_alternative a[2] = {{.fitted = true, .bic = 100.0},
                                          {.fitted = true, .bic = 114.0}};
  struct um_diagnosis_step step = {.nalternative = 2, .alternative = a, .delta_bic = -9300.0};
  struct um_diagnosis d = {.nstep = 1, .step = &step, .verdict = UM_VERDICT_FOUND};
  um_diagnosis_confidence_assign(&d);
  assert_int_equal(step.confidence, UM_CONFIDENCE_CERTAIN);
  d.verdict = UM_VERDICT_UNEXPLAINED;
  d.chi2_reduced_after = 2.0;
  um_diagnosis_confidence_assign(&d);
  assert_int_equal(step.confidence, UM_CONFIDENCE_ONE_OF_GROUP);
  step.delta_bic = -39.0;
  um_diagnosis_confidence_assign(&d);
  assert_int_equal(step.confidence, UM_CONFIDENCE_SMALL);
  d.verdict = UM_VERDICT_NOT_IDENTIFIABLE;
  a[1].indistinguishable = true;
  um_diagnosis_confidence_assign(&d);
  assert_int_equal(step.confidence, UM_CONFIDENCE_ONE_OF_GROUP);
  step.delta_bic = -14.0;
  um_diagnosis_confidence_assign(&d);
  assert_int_equal(step.confidence, UM_CONFIDENCE_SMALL);
  step.by_prior = true;
  um_diagnosis_confidence_assign(&d);
  assert_int_equal(step.confidence, UM_CONFIDENCE_CERTAIN);
}

/* An effect that others replaced stays on record, one that is still there does not. */
static void superseded_stays(void **state)
{
  (void)state;
  static const struct um_effect one = {.name = "one"}, two = {.name = "two"},
                                three = {.name = "three"};
  struct um_diagnosis_alternative a[2] = {{.bic = 120.0}, {.bic = 90.0}};
  struct um_diagnosis_step step[2] = {
      {.addition = {.effect = &one, .value = {0.5}}, .chi2 = 110.0, .alternative = &a[0]},
      {.addition = {.effect = &two, .target = "bus"}, .chi2 = 80.0, .alternative = &a[1]}};
  struct um_diagnosis_block block[2] = {{.addition = {.effect = &two, .target = "bus"}},
                                        {.addition = {.effect = &three}}};
  const struct um_diagnosis_state state_after = {.nblock = 2, .block = block};
  struct um_diagnosis d = {.nstep = 2, .step = step};
  OK(um_diagnosis_superseded_take(context, &d));
  d.nstep = 0; /* the steps are made anew from the blocks */
  um_diagnosis_superseded_keep(&state_after, &d);
  assert_int_equal(d.nsuperseded, 1);
  assert_ptr_equal(d.superseded[0].addition.effect, &one);
  assert_true(d.superseded[0].alone && d.superseded[0].bic == 120.0);
  um_core_free(context, d.superseded);
}

/* An abstaining verdict begins with the residual; missing heat stands with start, energy, place. */
static void abstaining_begins_with_the_residual(void **state)
{
  (void)state;
  static char channel[] = "temperature bus.+y", coordinate[] = "since_shadow_entry_s";
  static char place[] = "bus.+y";
  struct um_missing_heat heat = {.place = place,
                                 .course = {UM_HEAT_PULSE, 0.0, 90.0, NAN},
                                 .stop = 90.0,
                                 .power = 48.9,
                                 .last_sigma = 6.0,
                                 .behind = {30.0, 0.0, 3.1, 40.0},
                                 .start_sigma = 4.0,
                                 .energy = 4400.0,
                                 .energy_sigma = 300.0};
  struct um_missing_heat_unexplained u = {.nheat = 1, .heat = &heat, .found = true};
  struct um_sensitivity_candidates none = {0};
  struct um_diagnosis d = {
      .verdict = UM_VERDICT_UNEXPLAINED,
      .candidates = &none,
      .chi2_reduced = 9.0,
      .residual = {.channel = channel, .coordinate = coordinate, .chi2_reduced = 20.0, .mean = 3.0},
      .unexplained = &u};
  char *sentence;
  OK(um_diagnosis_summary_write(context, &d, &sentence));
  print_message("  %s\n", sentence);
  static const char begins[] =
      "No effect of the catalogue explains the measurements. The scenario is off most in "
      "temperature bus.+y (measured 3 sigma above it on average, ";
  assert_int_equal(strncmp(sentence, begins, strlen(begins)), 0);
  assert_non_null(strstr(
      sentence, "), and the residual correlates with the time since it entered the shadow."));
  assert_non_null(strstr(sentence, "4400 +- 300 J in bus.+y from "));
  assert_non_null(
      strstr(sentence, "+- 4 s, a pulse of 48.9 W for 90 +- 6 s; or a decay (BIC +3.1)"));
  um_core_free(context, sentence);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(allowance_is_said),    cmocka_unit_test(confidence_classes),
      cmocka_unit_test(superseded_stays),     cmocka_unit_test(abstaining_begins_with_the_residual),
      cmocka_unit_test(prior_is_said),        cmocka_unit_test(range_is_said),
      cmocka_unit_test(values_are_whole),     cmocka_unit_test(next_is_at_high_airmass),
      cmocka_unit_test(told_apart_in_words),  cmocka_unit_test(each_effect_has_its_label),
      cmocka_unit_test(both_discs_are_tried),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
