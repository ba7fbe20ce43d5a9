/* The next measurement has to tell an effect from all that it cannot be told from: among them the
 * alternative that is hardest to tell counts. A lumped plate on the pass of ENVISAT over Graz that
 * begins in the umbra, of which the visible band alone was measured. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "evidence/diagnosis/diagnose.h"
#include "tests/support/cmocka_all.h"

#define PLATE_STEP "24" /* [s] */
#include "tests/evidence/diagnosis/measured_test.h"
#include "tests/evidence/diagnosis/plate_test.h"

/* The visible band of a world with an effect. */
static struct um_compare_measurements *measure(const char *with)
{
  const struct um_model_options options = {.with = &with, .nwith = 1};
  struct um_compare_measurements *m;
  measured_make(context, path, &options, &m);
  for (size_t i = 0; i < m->count; i++)
    m->row[i].flag = strcmp(m->channel[m->row[i].channel].of, "vis") == 0 ? 0 : 1;
  return m;
}

/* Expected chi-square per observation of the next measurement, candidates being those named; of,
 * what is to be measured. All stay within the evidence, so that each alone is an alternative, too.
 */
static double next_of(const struct um_compare_measurements *m, const char *const *only, size_t n,
                      char of[32])
{
  const struct um_diagnosis_options options = {.candidates = {.only = only, .nonly = n},
                                               .no_heat = true};
  struct um_sensitivity_forward *forward;
  struct um_sensitivity_candidates *candidates;
  struct um_diagnosis *d;
  OK(um_sensitivity_forward_create(context, path, NULL, m, UM_VARIANT_TIGHT, &forward));
  OK(um_sensitivity_candidates_create(context, forward, NULL, 0, &options.candidates, &candidates));
  OK(um_diagnosis_create(context, forward, candidates, &options, &d));
  assert_int_equal(d->nstep, 1);
  size_t tied = 0;
  for (size_t i = 1; i < d->step[0].nalternative; i++)
    tied += d->step[0].alternative[i].fitted && d->step[0].alternative[i].indistinguishable;
  assert_int_equal(tied, n - 1);
  assert_string_equal(d->addition[0].effect->name, "zero_point");
  assert_non_null(d->next);
  double chi2 = d->next->chi2_difference;
  snprintf(of, 32, "%s", d->next->of);
  print_message("%zu alternatives: %s, chi-square %.4g an observation\n", tied, d->next->what,
                chi2);
  um_diagnosis_destroy(context, &d);
  um_sensitivity_candidates_destroy(context, &candidates);
  um_sensitivity_forward_destroy(context, &forward);
  return chi2;
}

/* A visible band that reads 4 % low could be a smaller plate, of which the thermal band tells by
 * 1.4 sigma an observation, or less sunlight, of which the temperature tells by 2.4. Both together
 * are told by the former. */
static void hardest_alternative_counts(void **state)
{
  (void)state;
  static const char *const smaller[] = {"zero_point:vis", "area:wing"};
  static const char *const darker[] = {"zero_point:vis", "solar_irradiance"};
  static const char *const both[] = {"zero_point:vis", "area:wing", "solar_irradiance"};
  struct um_compare_measurements *m = measure("zero_point:vis,factor=0.96");
  char of[3][32];
  double hard = next_of(m, smaller, 2, of[0]), easy = next_of(m, darker, 2, of[1]);
  double chi2 = next_of(m, both, 3, of[2]);
  assert_string_equal(of[0], "lwir");
  assert_true(easy > 2.0 * hard);
  assert_true(fabs(chi2 / hard - 1.0) <= 0.01); /* fits end within a tenth of a sigma */
  assert_string_equal(of[2], of[0]);
  um_compare_measurements_destroy(context, &m);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(hardest_alternative_counts)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
