/* Draws from the posterior of a fit: simulation-based calibration of the whole way (Talts et al.
 * 2018, arXiv 1804.06788), from the plate's own effects and priors; the same draws by any number of
 * processes; a pair of which only the product is known; a refusal where draws are worth too little.
 */
#include <stdlib.h>

#include "model/build/effect_files.h"

#define PLATE_STEP "60"
#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "base/inference/distributions.h"
#include "tests/evidence/diagnosis/plate_diagnosis_test.h"

struct fitted {
  struct um_compare_measurements *measured;
  struct um_sensitivity_forward *forward;
  struct um_model_options options;
};

static struct fitted begin(const char *const *with)
{
  struct fitted f = {0};
  measure(&(struct lists){.with = with}, &f.measured);
  OK(um_sensitivity_forward_create(context, path, &f.options, f.measured, UM_VARIANT_TIGHT,
                                   &f.forward));
  return f;
}

static void finish(struct fitted *f)
{
  um_sensitivity_forward_destroy(context, &f->forward);
  um_compare_measurements_destroy(context, &f->measured);
}

static struct um_model_addition use(const struct fitted *f, const char *name, const char *target)
{
  struct um_model_addition out = {.effect = um_model_effects_find(f->forward->model, name),
                                  .target = target};
  for (size_t p = 0; p < UM_EFFECT_PARAMETERS_MAX; p++) out.value[p] = NAN;
  return out;
}

static struct um_diagnosis *fit(const struct fitted *f, const struct um_model_addition *wanted,
                                size_t n, size_t draws, uint64_t seed)
{
  const struct um_diagnosis_options options = {.no_heat = true, .draws = draws, .seed = seed};
  struct um_diagnosis *d;
  OK(um_diagnosis_fit_effects(context, f->forward, wanted, n, &options, &d));
  return d;
}

static double normal(uint64_t key, uint64_t i)
{
  double u = um_core_hash_uniform(um_core_hash(key, 2 * i));
  return sqrt(-2.0 * log(1.0 - u)) *
         cos(2.0 * UM_PI * um_core_hash_uniform(um_core_hash(key, 2 * i + 1)));
}

/* ---- calibration ---- */

enum { SETS = 80, BINS = 5, EFFECTS = 2 };

/* Measurements of a truth whose parameters are drawn from their priors, with noise of the stated
 * sigma. */
static void measure_truth(struct fitted *f, const struct um_model_addition *wanted, uint64_t key,
                          double *truth)
{
  struct um_sensitivity_observations *o = &f->forward->observations;
  struct um_model_addition true_use[EFFECTS];
  for (size_t k = 0; k < EFFECTS; k++) {
    const struct um_effect_parameter *p = &wanted[k].effect->parameters[0];
    true_use[k] = wanted[k];
    do
      truth[k] = um_effect_physical(p, um_effect_transformed(p, p->null_value) +
                                           p->prior_sigma * normal(key++, k));
    while (truth[k] < p->minimum || truth[k] > p->maximum);
    true_use[k].value[0] = truth[k];
  }
  OK(um_sensitivity_forward_evaluate(context, f->forward, true_use, EFFECTS, o->measured));
  for (size_t j = 0; j < o->count; j++) o->measured[j] += o->sigma[j] * normal(key, 100 + j);
}

/* Ranks of 80 truths in five bins each: p of chi-square, the least of the parameters'. */
static double calibration(void)
{
  struct fitted f = begin(NULL);
  const struct um_model_addition wanted[EFFECTS] = {use(&f, "extinction", "lwir"),
                                                    use(&f, "zero_point", "vis")};
  double counts[EFFECTS][BINS] = {{0}}, least = 1.0;
  for (size_t s = 0; s < SETS; s++) {
    double truth[EFFECTS];
    measure_truth(&f, wanted, um_core_hash(77, s), truth);
    struct um_diagnosis *d = fit(&f, wanted, EFFECTS, 300, s);
    const struct um_diagnosis_posterior *p = d->posterior;
    assert_true(p->nfitted == EFFECTS && p->n == 300);
    for (size_t k = 0; k < EFFECTS; k++) {
      double rank = 0.0;
      for (size_t i = 0; i < p->n; i++)
        rank += p->value[i * p->nfitted + k] < truth[k] ? p->weight[i] : 0.0;
      counts[k][(size_t)fmin(BINS - 1, rank * BINS)] += 1.0;
    }
    um_diagnosis_destroy(context, &d);
  }
  for (size_t k = 0; k < EFFECTS; k++) {
    double chi2 = 0.0, expected = (double)SETS / BINS;
    for (size_t b = 0; b < BINS; b++) chi2 += pow(counts[k][b] - expected, 2.0) / expected;
    least = fmin(least, um_inference_chi2_q(chi2, BINS - 1));
  }
  finish(&f);
  return least;
}

/* Chance refuses uniform ranks in 2 of 1000 draws of this test. */
static void test_calibration(void **state)
{
  (void)state;
  double right = calibration();
  print_message("  p %.3g\n", right);
  assert_true(right > 1e-3);
}

/* ---- the rest ---- */

/* Intervals are those of the curvature where the model is nearly linear; the band holds the fit; as
 * many processes as one likes; another seed gives other draws. */
static void test_draws(void **state)
{
  (void)state;
  struct fitted f = begin(LIST("extinction:lwir,k_mag=0.1"));
  const struct um_model_addition wanted = use(&f, "extinction", "lwir");
  struct um_diagnosis *d = fit(&f, &wanted, 1, 1000, 3);
  const struct um_diagnosis_posterior *p = d->posterior;
  double value = d->addition[0].value[0], sigma = d->addition_sigma[0][0];
  print_message("  %.5f +- %.5f: %.5f (%.5f .. %.5f), worth %.0f\n", value, sigma, p->quantile[2],
                p->quantile[1], p->quantile[3], p->effective);
  assert_true(p->sound && p->effective > 600.0);
  assert_true(fabs(p->quantile[2] - value) < 0.2 * sigma);
  assert_true(fabs((p->quantile[3] - p->quantile[1]) / (2.0 * sigma) - 1.0) < 0.12);
  assert_true(fabs((p->quantile[4] - p->quantile[0]) / (3.92 * sigma) - 1.0) < 0.12);
  for (size_t j = 0; j < p->nobservation; j++)
    assert_true(p->band[j] <= d->value_after[j] &&
                d->value_after[j] <= p->band[2 * p->nobservation + j]);
  um_core_context_set_threads(context, 3);
  struct um_diagnosis *again = fit(&f, &wanted, 1, 1000, 3);
  um_core_context_set_threads(context, 1);
  assert_memory_equal(p->value, again->posterior->value, 1000 * sizeof *p->value);
  assert_memory_equal(p->weight, again->posterior->weight, 1000 * sizeof *p->weight);
  um_diagnosis_destroy(context, &again);
  again = fit(&f, &wanted, 1, 1000, 4);
  assert_true(again->posterior->value[0] != p->value[0]);
  um_diagnosis_destroy(context, &again);
  um_diagnosis_destroy(context, &d);
  finish(&f);
}

/* The same without rows in LWIR. */
static struct fitted begin_vis(const char *const *with)
{
  struct fitted f = begin(with);
  for (size_t i = 0; i < f.measured->count; i++)
    if (strcmp(f.measured->channel[f.measured->row[i].channel].of, "vis") != 0)
      f.measured->row[i].flag = 1;
  um_sensitivity_forward_destroy(context, &f.forward);
  OK(um_sensitivity_forward_create(context, path, &f.options, f.measured, UM_VARIANT_TIGHT,
                                   &f.forward));
  return f;
}

/* A plate that is measured by its light alone, in VIS: area and the zero point are one factor.
 * Their product is known as well as light is: 13 rows of 1 %. */
static void test_product(void **state)
{
  (void)state;
  struct fitted f = begin_vis(LIST("zero_point:vis,factor=1.08"));
  const struct um_model_addition wanted[2] = {use(&f, "area", "wing"),
                                              use(&f, "zero_point", "vis")};
  struct um_diagnosis *d = fit(&f, wanted, 2, 1000, 1);
  char words[640];
  assert_int_equal(d->ntie, 1);
  um_diagnosis_tie_text(d->fitted, &d->tie[0], words);
  print_message("  %s; worth %.0f\n", words, d->posterior->effective);
  assert_non_null(strstr(words, "area:wing factor and zero_point:vis factor cannot be told apart"));
  assert_non_null(strstr(words, "their product"));
  assert_true(d->tie[0].product && d->tie[0].correlation < -0.98);
  assert_true(fabs(d->tie[0].value - 1.08) < 4.0 * d->tie[0].sigma && d->tie[0].sigma < 0.01);
  um_diagnosis_destroy(context, &d);
  d = fit(&f, wanted, 2, 0, 0); /* the curvature says the same */
  assert_true(d->posterior == NULL && d->ntie == 1 && d->tie[0].product);
  um_diagnosis_destroy(context, &d);
  finish(&f);
}

/* One factor of light that is known no better by measurements than by its prior: normal, with mean
 * and deviation in closed form. It is drawn by its logarithm, and that must not show. */
static void test_wide(void **state)
{
  (void)state;
  struct fitted f = begin_vis(NULL);
  struct um_model_addition wanted = use(&f, "area", "wing");
  const struct um_effect_parameter *of = &wanted.effect->parameters[0];
  struct um_sensitivity_observations *o = &f.forward->observations;
  double prior = 1.0 / (of->prior_sigma * of->prior_sigma), known = 0.0, pull = prior;
  double *base = calloc(o->count, sizeof *base);
  assert_true(base != NULL && !of->logarithmic);
  OK(um_sensitivity_forward_evaluate(context, f.forward, NULL, 0, base));
  for (size_t j = 0; j < o->count; j++) known += base[j] * base[j] / (o->sigma[j] * o->sigma[j]);
  double wider = sqrt(known / prior);
  for (size_t j = 0; j < o->count; j++) {
    o->sigma[j] *= wider;
    o->measured[j] = 1.1 * base[j];
    pull += base[j] * o->measured[j] / (o->sigma[j] * o->sigma[j]);
  }
  struct um_diagnosis *d = fit(&f, &wanted, 1, 2000, 2);
  const struct um_diagnosis_posterior *p = d->posterior;
  double mean = 0.0, square = 0.0, deviation = sqrt(1.0 / (2.0 * prior));
  for (size_t i = 0; i < p->n; i++) mean += p->weight[i] * p->value[i];
  for (size_t i = 0; i < p->n; i++) square += p->weight[i] * pow(p->value[i] - mean, 2.0);
  double error = deviation / sqrt(p->effective);
  print_message("  %.4f +- %.4f of %.4f +- %.4f, worth %.0f\n", mean, sqrt(square),
                pull / (2.0 * prior), deviation, p->effective);
  assert_close(mean, pull / (2.0 * prior), 3.0 * error);
  assert_close(sqrt(square), deviation, 3.0 * error);
  free(base);
  um_diagnosis_destroy(context, &d);
  finish(&f);
}

/* Ten draws are worth no interval; a switch alone has no posterior. */
static void test_refusals(void **state)
{
  (void)state;
  struct fitted f = begin(NULL);
  const struct um_model_addition wanted = use(&f, "extinction", "lwir");
  struct um_diagnosis *d = fit(&f, &wanted, 1, 10, 1);
  assert_true(!d->posterior->sound && d->posterior->effective <= 10.0);
  um_diagnosis_destroy(context, &d);
  const struct um_diagnosis_options many = {.no_heat = true, .draws = (size_t)1 << 40};
  assert_int_equal(um_diagnosis_fit_effects(context, f.forward, &wanted, 1, &many, &d),
                   UM_ERR_INPUT);
  finish(&f);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_draws), cmocka_unit_test(test_product),
                                     cmocka_unit_test(test_wide), cmocka_unit_test(test_refusals),
                                     cmocka_unit_test(test_calibration)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
