/* A scenario diagnosed with its own measurements: nothing is missing, whatever number of samples
 * the analyst states. The panel stands before the box and hides and shades faces that are one facet
 * each, so that few points err by per cents. Without the model's own error in chi-square, and
 * without more points, those per cents are taken for an effect or for a discrepancy, which is said.
 */
#include "evidence/diagnosis/diagnose.h"
#include "evidence/inversion/refine.h"
#include "evidence/measurements/write.h"
#include "evidence/missing_heat/unexplained.h"
#include "evidence/sensitivity/forward_impl.h"
#include "tests/evidence/sensitivity/forward_test.h"
#include "tests/support/whole.h"

#define SHADED "[0.9, 0.2, 0.3], rotation_deg: [0, 70, 0]"

static const char *const few[] = {"emittance", "specular_level", "zero_point", "roughness"};

static void put_shaded(void)
{
  char text[4096];
  const char *at = strstr(scenario_text, "[0, 3, 0]");
  assert_non_null(at);
  um_core_context_set_threads(context, 1); /* too small to share */
  snprintf(text, sizeof text, "%.*s%s%s", (int)(at - scenario_text), scenario_text, SHADED,
           at + strlen("[0, 3, 0]"));
  put(SCENARIO, text);
}

/* umbra synth with 4096 samples, every 6 s: m.csv. */
static void measure(void)
{
  static const char *const overrides[] = {"optics.samples=4096", "time.step_s=6"};
  const struct um_model_options options = {.overrides = overrides, .noverride = 2};
  const struct um_compare_synth noise = {.relative = 0.01, .floor = 0.001, .seed = 11};
  struct world w = world_of(&options);
  struct um_compare_measurements *m;
  assert_ok(um_compare_synth_create(context, w.model, w.tables, w.result, &noise, "m.csv", &m));
  remove("m.csv");
  assert_ok(um_compare_measurements_write(context, m, "m.csv"));
  um_compare_measurements_destroy(context, &m);
  world_end(&w);
}

static struct um_sensitivity_forward *forward_with(int samples,
                                                   const struct um_compare_measurements *m)
{
  char text[40];
  const char *overrides[] = {text};
  const struct um_model_options options = {.overrides = overrides, .noverride = 1};
  snprintf(text, sizeof text, "optics.samples=%d", samples);
  return forward_of(&options, m);
}

/* umbra compare on the same model weighs by the same sigma; variants look with the same points.
 * 1e-3: heat is integrated anew. */
static void assert_as_compared(struct um_sensitivity_forward *f)
{
  struct um_sensitivity_forward_run run;
  struct um_compare_comparison *c;
  double chi2 = 0.0;
  assert_ok(um_sensitivity_forward_run(context, f, NULL, 0, NULL, &run));
  assert_int_equal(run.variant.tables->sampling.samples, f->samples);
  struct um_compare_run compared = {run.variant.model, f->plan, run.variant.tables, run.result};
  assert_ok(um_compare_create(context, &compared, 0.0, &c));
  for (size_t j = 0; j < f->observations.count; j++) {
    double residual = (f->observations.measured[j] - f->cache->base[j]) / f->observations.sigma[j];
    chi2 += residual * residual;
    const struct um_compare_residual *of = &c->residual[f->observations.row[j]];
    assert_close(f->observations.sigma[j], hypot(of->sigma, of->model_sigma),
                 1e-3 * f->observations.sigma[j]);
    assert_true(f->observations.stated_sigma[j] == of->sigma);
  }
  assert_close(chi2, c->chi2, 1e-3 * c->chi2);
  assert_close(f->observations.model_share, c->model_share, 1e-3 * c->model_share);
  um_compare_destroy(context, &c);
  um_sensitivity_forward_run_release(context, &run);
}

/* Back to the points of the scenario and the sigma of the measurements alone. */
static void withhold(struct um_sensitivity_forward *f)
{
  const struct um_variant *own = &f->base;
  struct um_model_result *result;
  f->instants.sampling = (struct um_model_sampling){
      f->samples_before, f->model->scenario->optics->interreflection_samples};
  assert_ok(um_model_tables_resample(
      context, f->model, um_variant_base_tables(context, f->evaluator), f->instants.sampling));
  assert_ok(um_model_run_with(context, f->model, own->tables, own->heat, &result));
  assert_ok(um_compare_predict(context, f->plan, own->tables, result, f->cache->predicted));
  um_model_result_destroy(context, &result);
  um_compare_modelled(f->measurements, f->observations.count, f->observations.row,
                      f->cache->predicted, f->cache->base);
  memcpy(f->observations.sigma, f->observations.stated_sigma,
         f->observations.count * sizeof(double));
  f->paths = f->paths_before; /* nothing to correct */
  um_core_free(context, f->cache->few);
  f->cache->few = NULL;
}

/* nstep: effects that were accused. */
static enum um_diagnosis_verdict diagnose(struct um_sensitivity_forward *f, double *chi2_reduced,
                                          size_t *nstep)
{
  const struct um_diagnosis_options options = {
      .candidates = {.only = few, .nonly = sizeof few / sizeof *few},
      .steps_max = 1,
      .alternatives = 2,
      .no_next = true,
      .no_heat = true};
  struct um_sensitivity_candidates *candidates;
  struct um_diagnosis *d;
  assert_ok(
      um_sensitivity_candidates_create(context, f, NULL, 0, &options.candidates, &candidates));
  assert_ok(um_diagnosis_create(context, f, candidates, &options, &d));
  enum um_diagnosis_verdict verdict = d->verdict;
  *chi2_reduced = d->chi2_reduced;
  *nstep = d->nstep + d->nscatter;
  print_message("  %s, %zu steps; baseline's reduced chi-square %.3f: %s\n",
                um_diagnosis_verdict_name(verdict), d->nstep, d->chi2_reduced, d->summary);
  um_diagnosis_destroy(context, &d);
  um_sensitivity_candidates_destroy(context, &candidates);
  return verdict;
}

/* 242 observations: reduced chi-square 1 +- 0.09. */
static void test_complete_at_any_samples(void **state)
{
  (void)state;
  static const int number[] = {4, 16};
  struct um_compare_measurements *m;
  put_shaded();
  measure();
  m = measured();
  for (int i = 0; i < um_test_number(2, 1); i++) {
    struct um_sensitivity_forward *f = forward_with(number[i], m);
    double with, without;
    size_t nstep;
    print_message("%d samples -> %d, share of the model %.2g\n", number[i], f->samples,
                  f->observations.model_share);
    assert_int_equal(f->samples_before, number[i]);
    assert_true(f->samples > number[i]);
    assert_true(f->observations.model_share > 0.0 &&
                f->observations.model_share <= UM_COMPARE_MODEL_SHARE);
    assert_as_compared(f);
    assert_int_equal(diagnose(f, &with, &nstep), UM_VERDICT_COMPLETE);
    assert_true(with >= 0.8 && with <= 1.25 && nstep == 0);
    withhold(f);
    diagnose(f, &without, &nstep);
    assert_true(without > 2.0 && nstep > 0); /* accused, or said to be a discrepancy */
    um_sensitivity_forward_destroy(context, &f);
  }
  um_compare_measurements_destroy(context, &m);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_complete_at_any_samples, model_set_up, model_tear_down),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
