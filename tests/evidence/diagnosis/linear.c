/* The linear statistics of a diagnosis on numbers that are known beforehand: a state and candidates
 * made here, no scenario. */
#include <math.h>
#include <string.h>

#include "evidence/diagnosis/steps_impl.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

enum { ROWS = 40 };

/* Observations y = J x of a linear model, at x = (1.2, 3, -0.5). The first and last parameter have
 * priors about 1 and 0: at those means the residual is y - J m, whatever x is. The second is free
 * and stays where it is. */
static void residual_at_the_means_of_priors(void **state)
{
  (void)state;
  double jacobian[3 * ROWS], measured[ROWS], residual[ROWS], out[ROWS];
  double x[3] = {1.2, 3.0, -0.5};
  const double mean[3] = {1.0, 3.0, 0.0}; /* of the free one: its value */
  struct um_diagnosis_block block[2] = {
      {.nfree = 2, .prior_mean = {1.0, 7.0}, .prior_sigma = {0.1, INFINITY}},
      {.nfree = 1, .prior_mean = {0.0}, .prior_sigma = {2.0}}};
  for (size_t j = 0; j < ROWS; j++) {
    double u = (double)j / ROWS;
    jacobian[j] = 1.0 + u;
    jacobian[ROWS + j] = cos(9.0 * u);
    jacobian[2 * ROWS + j] = u * u - 0.3;
    measured[j] = 2.0 * sin(5.0 * u);
    residual[j] = measured[j];
    for (size_t k = 0; k < 3; k++) residual[j] -= jacobian[k * ROWS + j] * x[k];
  }
  struct um_inference_fit fit = {
      .nobservation = ROWS, .nparameter = 3, .x = x, .residual = residual, .jacobian = jacobian};
  const struct um_diagnosis_state fitted = {
      .nblock = 2, .nnuisance = 1, .block = block, .nparameter = 3, .fit = &fit};
  const struct um_diagnosis_work work = {0};
  um_diagnosis_residual_at_means(&work, &fitted, ROWS, out);
  for (size_t j = 0; j < ROWS; j++) {
    double expected = measured[j];
    for (size_t k = 0; k < 3; k++) expected -= jacobian[k * ROWS + j] * mean[k];
    assert_true(fabs(out[j] - expected) <= 1e-14);
  }
}

/* A winner and one alternative, `behind` it in BIC, `widths` prior widths from where it vanishes;
 * what else is fitted stands 20 in chi-square worse beside it. Behind NAN: it was not fitted. */
static void groups_with(double widths, double behind, bool logarithmic,
                        struct um_diagnosis_alternative out[2], struct um_diagnosis_step *step)
{
  const struct um_effect_parameter parameter = {.name = "factor",
                                                .null_value = 2.0,
                                                .minimum = 1e-3,
                                                .maximum = 1e3,
                                                .prior_sigma = 0.1,
                                                .logarithmic = logarithmic};
  struct um_effect effect[2] = {{.name = "first", .parameters = &parameter, .nparameter = 1},
                                {.name = "second", .parameters = &parameter, .nparameter = 1}};
  struct um_sensitivity_candidate candidate[2];
  double signature[ROWS], sigma[ROWS], signal[ROWS];
  char *name[2] = {(char *)(uintptr_t) "first", (char *)(uintptr_t) "second"};
  memset(candidate, 0, sizeof candidate);
  for (size_t j = 0; j < ROWS; j++) {
    sigma[j] = 1.0;
    signature[j] = 1.0 + (double)j;
    signal[j] = 0.2 * signature[j]; /* two prior widths */
  }
  for (size_t i = 0; i < 2; i++) {
    candidate[i].name = name[i];
    candidate[i].effect = &effect[i];
    candidate[i].ncolumn = 1;
    candidate[i].null_value[0] = 2.0;
    candidate[i].step[0] = 0.02;
    candidate[i].signature = signature;
    out[i] = (struct um_diagnosis_alternative){.candidate = i,
                                               .fitted = i == 0 || !isnan(behind),
                                               .chi2 = 40.0,
                                               .chi2_prior = i == 0 ? 0.0 : 20.0,
                                               .bic = i == 0 ? 44.0 : 44.0 + behind,
                                               .held_out = 40.0};
    out[i].value[0] = 2.0;
  }
  out[1].value[0] = logarithmic ? 2.0 * exp(0.1 * widths) : 2.0 + 0.1 * widths;
  struct um_sensitivity_forward forward = {.observations = {.count = ROWS, .sigma = sigma}};
  const struct um_sensitivity_candidates candidates = {
      .count = 2, .nobservation = ROWS, .candidate = candidate};
  const struct um_diagnosis_work work = {.forward = &forward, .candidates = &candidates};
  struct um_inference_fit fit = {.nobservation = ROWS};
  const struct um_diagnosis_state fitted = {.fit = &fit};
  *step = (struct um_diagnosis_step){.nalternative = 2, .alternative = out};
  if (um_diagnosis_rank_groups(context, &work, &fitted, signal, step) != UM_OK)
    fail_msg("%s", um_core_message(context));
}

/* Up to three prior widths a value is plausible, beyond them only the prior decides:
 * docs/diagnosis.md. */
static void beyond_three_prior_widths_is_implausible(void **state)
{
  (void)state;
  static const double widths[] = {0.0, 2.9, -2.9, 3.1, -3.1, 10.0};
  for (size_t i = 0; i < sizeof widths / sizeof *widths; i++)
    for (int logarithmic = 0; logarithmic < 2; logarithmic++) {
      struct um_diagnosis_alternative alternative[2];
      struct um_diagnosis_step step;
      groups_with(widths[i], 1.0, logarithmic == 1, alternative, &step);
      bool far = fabs(widths[i]) > 3.0;
      assert_true(alternative[1].indistinguishable);
      assert_false(alternative[0].implausible);
      assert_int_equal(alternative[1].implausible, far);
      assert_int_equal(step.by_prior, far);
    }
}

/* A difference of 10 in BIC decides: odds of exp(5), 150 to 1. */
static void tied_within_ten_of_bic(void **state)
{
  (void)state;
  static const double behind[] = {0.0, 9.9, 10.1, 1000.0};
  for (size_t i = 0; i < sizeof behind / sizeof *behind; i++) {
    struct um_diagnosis_alternative alternative[2];
    struct um_diagnosis_step step;
    groups_with(1.0, behind[i], false, alternative, &step);
    assert_int_equal(alternative[1].indistinguishable, behind[i] < 10.0);
  }
}

/* Its own prior keeps an alternative out where it would be within 10 without it, and is near
 * enough, 15, to be worth a word; not one of a usual value, nor the priors of others. */
static void only_its_own_prior_keeps_out(void **state)
{
  (void)state;
  static const struct {
    double widths, behind;
    bool kept_out;
  } cases[] = {{0.0, 10.5, false}, {0.9, 10.5, false}, {1.1, 10.5, true}, {1.1, 12.0, false},
               {3.5, 14.0, true},  {3.5, 9.5, false},  {3.5, 15.1, false}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    struct um_diagnosis_alternative alternative[2];
    struct um_diagnosis_step step;
    groups_with(cases[i].widths, cases[i].behind, false, alternative, &step);
    assert_int_equal(alternative[1].excluded_by_prior, cases[i].kept_out);
  }
}

/* By the linear model the same, and not fitted: not tried, and so neither tied nor out. */
static void not_fitted_is_not_tied(void **state)
{
  (void)state;
  struct um_diagnosis_alternative alternative[2];
  struct um_diagnosis_step step;
  groups_with(0.0, NAN, false, alternative, &step);
  assert_true(alternative[1].not_tried);
  assert_false(alternative[1].indistinguishable || step.by_prior);
  groups_with(0.0, 1.0, false, alternative, &step);
  assert_false(alternative[1].not_tried);
}

/* The residual is mostly the sum of what two variants of one effect do, so that they would be the
 * best pair of three candidates: they are none, and each is one with the other effect. */
static void variants_of_one_effect_are_no_pair(void **state)
{
  (void)state;
  const struct um_effect effect[2] = {{.name = "disc"}, {.name = "other"}};
  double signature[3][ROWS], sigma[ROWS], residual[ROWS];
  struct um_sensitivity_candidate candidate[3];
  memset(candidate, 0, sizeof candidate);
  for (size_t j = 0; j < ROWS; j++) {
    double u = (double)j / ROWS;
    sigma[j] = 1.0;
    signature[0][j] = -30.0 * cos(3.0 * u); /* all three go the way of a switch */
    signature[1][j] = 30.0 * sin(9.0 * u);
    signature[2][j] = 1.0 + u;
    residual[j] = signature[0][j] + signature[1][j] + 2.0 * signature[2][j];
  }
  for (size_t i = 0; i < 3; i++) {
    candidate[i].effect = &effect[i / 2];
    candidate[i].is_switch = true;
    candidate[i].ncolumn = 1;
    candidate[i].signature = signature[i];
  }
  struct um_sensitivity_forward forward = {.observations = {.count = ROWS, .sigma = sigma}};
  const struct um_sensitivity_candidates candidates = {
      .count = 3, .nobservation = ROWS, .candidate = candidate};
  const struct um_diagnosis_work work = {.forward = &forward, .candidates = &candidates};
  struct um_inference_fit fit = {.nobservation = ROWS, .residual = residual};
  const struct um_diagnosis_state fitted = {.fit = &fit};
  struct um_diagnosis_pair best[UM_DIAGNOSIS_PAIRS];
  size_t count;
  if (um_diagnosis_pairs_find(context, &work, &fitted, best, &count) != UM_OK)
    fail_msg("%s", um_core_message(context));
  assert_int_equal(count, 2);
  for (size_t i = 0; i < count; i++) assert_int_equal(best[i].candidate[1], 2);
  /* effects of their own they are the best pair of all */
  struct um_effect third = {.name = "third"};
  candidate[1].effect = &third;
  if (um_diagnosis_pairs_find(context, &work, &fitted, best, &count) != UM_OK)
    fail_msg("%s", um_core_message(context));
  assert_int_equal(count, 3);
  assert_true(best[0].candidate[0] == 0 && best[0].candidate[1] == 1);
}

/* 90 observations, 2 nuisances, a pulse: 70 + 1.5 + (2 + 4) ln 90 = 98.498858. What is on and off
 * has one number more, ln 90 = 4.499810; no place, none. */
static void heat_costs_the_numbers_of_its_shape(void **state)
{
  (void)state;
  struct um_missing_heat place = {.nparameter = um_thermal_course_parameters(UM_HEAT_PULSE)};
  struct um_missing_heat_unexplained heat = {
      .chi2_before = 200.0, .chi2_after = 70.0, .nheat = 1, .heat = &place};
  const struct um_inference_fit fit = {.nobservation = 90, .nparameter = 2, .chi2_prior = 1.5};
  assert_true(fabs(um_diagnosis_pulse_bic(&heat, &fit) - 98.498858) <= 1e-6);
  place.nparameter = um_thermal_course_parameters(UM_HEAT_PERIODIC);
  assert_true(fabs(um_diagnosis_pulse_bic(&heat, &fit) - 98.498858 - 4.499810) <= 1e-6);
  heat.nheat = 0;
  assert_true(fabs(um_diagnosis_pulse_bic(&heat, &fit) - 71.5 - 2.0 * 4.499810) <= 1e-5);
}

/* The same 90 observations and nuisances: 200 of chi-square, of which light is worth 100. White:
 * 200 - 100 + 1.5 + 2 ln 90 = 110.499619. Where it leaves a reduced chi-square of 2 its worth is
 * over that: 100 + 90 ln 2 - 100 + 1.5 + 3 ln 90 = 77.382675. */
static void light_costs_the_noise_that_it_leaves(void **state)
{
  (void)state;
  struct um_missing_light light = {.chi2_before = 200.0, .worth = 100.0, .scale = 1.0};
  const struct um_inference_fit fit = {.nobservation = 90, .nparameter = 2, .chi2_prior = 1.5};
  assert_true(fabs(um_diagnosis_light_bic(&light, &fit) - 110.499619) <= 1e-6);
  light.scale = 2.0;
  assert_true(fabs(um_diagnosis_light_bic(&light, &fit) - 77.382675) <= 1e-5);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(light_costs_the_noise_that_it_leaves),
      cmocka_unit_test(residual_at_the_means_of_priors),
      cmocka_unit_test(beyond_three_prior_widths_is_implausible),
      cmocka_unit_test(tied_within_ten_of_bic),
      cmocka_unit_test(only_its_own_prior_keeps_out),
      cmocka_unit_test(not_fitted_is_not_tied),
      cmocka_unit_test(variants_of_one_effect_are_no_pair),
      cmocka_unit_test(heat_costs_the_numbers_of_its_shape),
  };
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
