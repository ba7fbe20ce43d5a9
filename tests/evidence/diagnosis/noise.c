/* What is not noise of the stated sigma: sigmas that are too small, spikes, a discrepancy of the
 * model. Nobody is accused for them, an effect is still named beside them, and they are said. */
#define PLATE_STEP "5"
#include "base/core/constants.h"
#include "evidence/diagnosis/steps_impl.h"
#include "tests/evidence/diagnosis/plate_diagnosis_test.h"

static const char *const looked_for[] = {
    "emittance",  "solar_absorptance", "albedo_level",  "earth_ir_level",
    "zero_point", "background",        "heat_capacity", NULL};

static const struct um_diagnosis_scatter *scatter_of(const struct diagnosed *c, const char *band)
{
  for (size_t i = 0; i < c->d->nscatter; i++)
    if (strcmp(c->measured->channel[c->d->scatter[i].channel].of, band) == 0)
      return &c->d->scatter[i];
  return NULL;
}

/* Every sigma is two thirds of what it should be. */
static void understate(struct um_compare_measurements *m)
{
  for (size_t i = 0; i < m->count; i++) m->row[i].sigma /= 1.5;
}

static void test_understated(void **state)
{
  (void)state;
  struct diagnosed c = diagnose(&(struct lists){.only = looked_for, .spoil = understate});
  assert_int_equal(c.d->verdict, UM_VERDICT_COMPLETE);
  says(&c, "times its sigma");
  for (int b = 0; b < 2; b++) {
    const struct um_diagnosis_scatter *s = scatter_of(&c, b == 0 ? "vis" : "lwir");
    assert_non_null(s); /* 144 rows: within 6 % */
    assert_true(fabs(s->scale - 1.5) < 0.25 && s->along == NULL);
  }
  assert_true(c.d->probability.nothing > 0.5);
  end(&c);
}

/* Three rows in a hundred are off by 8 to 20 sigma. */
static void spike(struct um_compare_measurements *m)
{
  for (size_t i = 20; i < m->count; i += 33)
    m->row[i].value += (i % 2 == 0 ? 8.0 + (double)(i % 13) : -9.0) * m->row[i].sigma;
}

static void test_spikes(void **state)
{
  (void)state;
  struct diagnosed c = diagnose(&(struct lists){.only = looked_for, .spoil = spike});
  assert_int_equal(c.d->verdict, UM_VERDICT_COMPLETE);
  assert_int_equal(c.d->nscatter, 0);
  size_t n = 0;
  for (size_t i = 20; i < c.measured->count; i += 33) n++;
  assert_int_equal(c.d->noutlier, n);
  for (size_t i = 0; i < n; i++) assert_int_equal((c.d->outlier[i] - 20) % 33, 0);
  says(&c, "rows are set aside as outliers");
  end(&c);
}

/* One row in seventeen is far off, either way: that is no accident of the detector. */
static void often_off(struct um_compare_measurements *m)
{
  for (size_t i = 5; i < m->count; i += 17)
    m->row[i].value += (i % 4 < 2 ? 30.0 : -30.0) * m->row[i].sigma;
}

static void test_too_many_spikes(void **state)
{
  (void)state;
  struct diagnosed c = diagnose(&(struct lists){.only = looked_for, .spoil = often_off});
  assert_int_equal(c.d->verdict, UM_VERDICT_UNEXPLAINED);
  end(&c);
}

/* Four rows of a channel are set aside, every `apart`-th of its 144. */
static bool are_accidents(struct diagnosed *c, size_t apart)
{
  size_t outlier[4], nth = 0, n = 0;
  for (size_t i = 0; i < c->measured->count && n < 4; i++)
    if (c->measured->row[i].channel == 0 && nth++ % apart == 0) outlier[n++] = i;
  struct um_diagnosis own = *c->d;
  own.outlier = outlier;
  own.noutlier = n;
  return !um_diagnosis_discrepancy_is_large(&own);
}

/* That they follow one another by chance has odds of 1e-4: it is the edge of a shadow that lies
 * elsewhere. */
static void test_run_of_outliers(void **state)
{
  (void)state;
  struct diagnosed c = diagnose(&(struct lists){.only = looked_for});
  assert_true(are_accidents(&c, 9) && are_accidents(&c, 2));
  assert_false(are_accidents(&c, 1));
  end(&c);
}

/* LWIR is off along a wave. */
static void add_wave(struct um_compare_measurements *m, double sigmas, double period)
{
  for (size_t i = 0; i < m->count; i++) {
    struct um_compare_measurement *row = &m->row[i];
    if (strcmp(m->channel[row->channel].of, "lwir") != 0) continue;
    row->value += sigmas * row->sigma * sin(2.0 * UM_PI * (row->t_tai - m->row[0].t_tai) / period);
  }
}

/* By 2.5 sigma (3.5 at most), in 5 minutes, as no effect makes it. */
static void wave(struct um_compare_measurements *m) { add_wave(m, 3.5, 300.0); }

/* Once over the pass, much as an effect does: significant, but worth less than a discrepancy. */
static void slow_wave(struct um_compare_measurements *m) { add_wave(m, 4.0, 750.0); }

static void test_resembling(void **state)
{
  (void)state;
  struct diagnosed c = diagnose(&(struct lists){.only = looked_for, .spoil = slow_wave});
  assert_int_equal(c.d->verdict, UM_VERDICT_COMPLETE);
  assert_int_equal(c.d->naddition, 0);
  end(&c);
}

static void test_discrepancy(void **state)
{
  (void)state;
  struct diagnosed c = diagnose(&(struct lists){.only = looked_for, .spoil = wave});
  const struct um_diagnosis_scatter *s = scatter_of(&c, "lwir");
  assert_int_equal(c.d->verdict, UM_VERDICT_COMPLETE);
  assert_non_null(s);
  assert_non_null(s->along);
  print_message("%.2f sigma of 2.47\n", s->sigmas);
  assert_true(s->sigmas > 1.8 && s->sigmas < 3.0 && scatter_of(&c, "vis") == NULL);
  says(&c, "the model is off by");
  end(&c);
}

/* The front reflects more, in turns of the plate, and what does that is not looked for: 3 sigma and
 * 4 % of the light rms, as much as may be called a discrepancy. Light that explains all of it with
 * three numbers does better. Where no light is looked for it is called one. */
static void test_light_beside_it(void **state)
{
  (void)state;
  static const char *const others[] = {"emittance", "earth_ir_level", "heat_capacity", NULL};
  for (int light = 0; light < 2; light++) {
    struct diagnosed c =
        diagnose(&(struct lists){.with = LIST("diffuse_level:grey_panel,factor=1.35"),
                                 .only = others,
                                 .no_light = light == 0});
    print_message("%s, BIC of the light %.0f\n", um_diagnosis_verdict_name(c.d->verdict),
                  c.d->light.worth);
    if (light == 0) {
      assert_true(c.d->verdict != UM_VERDICT_UNEXPLAINED && c.d->nscatter > 0);
      says(&c, "the model is off by");
    } else {
      assert_int_equal(c.d->verdict, UM_VERDICT_UNEXPLAINED);
      assert_true(c.d->light.found && c.d->nscatter == 0 && c.d->naddition == 0);
      says(&c, "A correction of light explains it");
      assert_null(strstr(c.d->summary, "Missing heat"));
    }
    end(&c);
  }
}

/* The same with a front that emits a tenth less than the analyst has it. */
static void test_effect_beside_it(void **state)
{
  (void)state;
  struct diagnosed c = diagnose(&(struct lists){
      .with = LIST("emittance:grey_panel,factor=0.9"), .only = looked_for, .spoil = wave});
  assert_true(c.d->verdict == UM_VERDICT_FOUND || c.d->verdict == UM_VERDICT_NOT_IDENTIFIABLE);
  assert_int_equal(c.d->naddition, 1);
  const struct um_diagnosis_alternative *r = alternative(&c, 0, "emittance:grey_panel");
  assert_true(r->fitted && (r == &c.d->step[0].alternative[0] || r->indistinguishable));
  print_message("%.3f +- %.3f, probability %.2f\n", r->value[0], r->sigma[0], r->probability);
  assert_true(fabs(r->value[0] - 0.9) < 3.0 * r->sigma[0]);
  print_message("%zu changes\n", c.d->sceptic.variations);
  assert_true(c.d->sceptic.variations > 2 + 20 + 3); /* along other coordinates */
  says(&c, "the model is off by");
  end(&c);
}

/* Where noise is what is stated, nothing of this happens. */
static void test_white(void **state)
{
  (void)state;
  struct diagnosed c = diagnose(
      &(struct lists){.with = LIST("emittance:grey_panel,factor=0.9"), .only = looked_for});
  assert_true(!c.d->weighed && c.d->nscatter == 0 && c.d->noutlier == 0);
  const struct um_diagnosis_probability *p = &c.d->probability;
  /* blocks by turns halve the information: each half foretells sqrt(G / 2) of the other's
   * chi-square G / 2, together sqrt G, within the scatter of 1 */
  const struct um_diagnosis_sceptic *q = &c.d->sceptic;
  assert_true(q->asked && fabs(q->frozen - sqrt(c.d->chi2 - c.d->chi2_after)) < 4.0);
  assert_true(q->search_p < 0.002 && q->flips < q->variations);
  assert_int_equal(q->variations, 2 + 20 + 1); /* channels, rows, sigmas */
  assert_true(fabs(p->nothing + p->one + p->several + p->none - 1.0) < 1e-12 && p->one > 0.99);
  end(&c);
}

/* Fits of the front's emittance, a tenth less than the analyst has it, to the same draw of noise:
 * with its sigmas, with two thirds of them, with spikes. Sigma within a tenth is the same: by the
 * stated sigmas alone it would be two thirds (288 rows tell a scale within 6 %). So is the value:
 * a row in 32 set aside moves it by sqrt(1 / 32) = 0.18 sigma, within three times that. Nothing is
 * said of what is white. */
static void test_fit(void **state)
{
  (void)state;
  static void (*const spoil[])(struct um_compare_measurements *) = {NULL, understate, spike};
  double value = 0.0, sigma = 0.0;
  for (size_t i = 0; i < 3; i++) {
    struct diagnosed c = diagnose(&(struct lists){.with = LIST("emittance:grey_panel,factor=0.9"),
                                                  .only = LIST("emittance:grey_panel"),
                                                  .spoil = spoil[i]});
    const struct um_diagnosis_options options = {.no_heat = true};
    struct um_model_addition wanted = c.d->addition[0];
    struct um_diagnosis *d;
    for (size_t p = 0; p < UM_EFFECT_PARAMETERS_MAX; p++) wanted.value[p] = NAN;
    OK(um_diagnosis_fit_effects(context, c.forward, &wanted, 1, &options, &d));
    print_message("  fit: %.5f +- %.5f, %s\n", d->addition[0].value[0], d->addition_sigma[0][0],
                  d->summary);
    if (i == 0) value = d->addition[0].value[0];
    if (i == 0) sigma = d->addition_sigma[0][0];
    assert_int_equal(d->verdict, UM_VERDICT_FOUND);
    assert_true(fabs(d->addition[0].value[0] - value) < 0.54 * sigma);
    assert_true(fabs(d->addition_sigma[0][0] / sigma - 1.0) < 0.1);
    assert_int_equal(d->weighed, i > 0);
    assert_int_equal(d->nscatter, i == 1 ? 2 : 0);
    assert_true(i == 2 ? d->noutlier > 0 : d->noutlier == 0);
    assert_true((strstr(d->summary, "times its sigma") != NULL) == (i == 1));
    um_diagnosis_destroy(context, &d);
    end(&c);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_understated),
                                     cmocka_unit_test(test_spikes),
                                     cmocka_unit_test(test_too_many_spikes),
                                     cmocka_unit_test(test_run_of_outliers),
                                     cmocka_unit_test(test_discrepancy),
                                     cmocka_unit_test(test_resembling),
                                     cmocka_unit_test(test_effect_beside_it),
                                     cmocka_unit_test(test_light_beside_it),
                                     cmocka_unit_test(test_white),
                                     cmocka_unit_test(test_fit)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
