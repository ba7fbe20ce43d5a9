/* The whole method on a small satellite: measurements are made from a scenario that has what the
 * analyst's lacks, and the verdict must name it, or say that these observations cannot. Random
 * numbers are repeatable; the laboratory does the same on other meshes, many times. */
#include "evidence/diagnosis/diagnose.h"

#include "evidence/measurements/write.h"
#include "tests/evidence/sensitivity/forward_test.h"

/* Every 20 s: 33 times above the horizon; candidates of several kinds. */
static const char *const coarse[] = {"time.step_s=20"};
static const char *const few[] = {"emittance",      "solar_absorptance", "panel_extraction",
                                  "internal_power", "albedo_level",      "zero_point",
                                  "background",     "extinction"};
#define FEW (sizeof few / sizeof few[0])

/* m.csv from the scenario with effects; places: measured temperatures. */
static void measure(const char *const *with, size_t nwith, const char *const *place, size_t nplace)
{
  const struct um_model_options options = {
      .overrides = coarse, .noverride = 1, .with = with, .nwith = nwith};
  const struct um_compare_synth noise = {.relative = 0.01,
                                         .floor = 0.001,
                                         .seed = 11,
                                         .place = place,
                                         .nplace = nplace,
                                         .temperature_sigma = 0.3};
  struct world w = world_of(&options);
  struct um_compare_measurements *m;
  assert_ok(um_compare_synth_create(context, w.model, w.tables, w.result, &noise, "m.csv", &m));
  remove("m.csv");
  assert_ok(um_compare_measurements_write(context, m, "m.csv"));
  um_compare_measurements_destroy(context, &m);
  world_end(&w);
}

/* The scenario states what its panel gives. */
static void put_stated(void)
{
  char text[4096], more[4160];
  FILE *file = fopen(SCENARIO, "r");
  assert_non_null(file);
  size_t n = fread(text, 1, sizeof text - 1, file);
  text[n] = '\0';
  assert_int_equal(fclose(file), 0);
  const char *at = strstr(text, "    front: grey_panel\n");
  size_t before = at == NULL ? n : (size_t)(at - text);
  assert_true(before < n);
  snprintf(more, sizeof more, "%.*s    electrical_extraction: 0.18\n%s", (int)before, text,
           text + before);
  put(SCENARIO, more);
}

/* Rows of m.csv of other channels are flagged. */
static void only_channel(const char *of)
{
  struct um_compare_measurements *m = measured();
  for (size_t i = 0; i < m->count; i++)
    if (strcmp(m->channel[m->row[i].channel].of, of) != 0) m->row[i].flag = 1;
  remove("m.csv");
  assert_ok(um_compare_measurements_write(context, m, "m.csv"));
  um_compare_measurements_destroy(context, &m);
}

struct case_of {
  struct um_compare_measurements *m;
  struct um_sensitivity_forward *forward;
  struct um_sensitivity_candidates *candidates;
  struct um_diagnosis *d;
};

static enum um_status diagnose(struct um_diagnosis_options *options, struct case_of *c)
{
  *c = (struct case_of){.m = measured()};
  options->candidates.only = few;
  options->candidates.nonly = FEW;
  c->forward = forward_of(NULL, c->m);
  assert_ok(um_sensitivity_candidates_create(context, c->forward, NULL, 0, &options->candidates,
                                             &c->candidates));
  return um_diagnosis_create(context, c->forward, c->candidates, options, &c->d);
}

static void end(struct case_of *c)
{
  um_diagnosis_destroy(context, &c->d);
  um_sensitivity_candidates_destroy(context, &c->candidates);
  um_sensitivity_forward_destroy(context, &c->forward);
  um_compare_measurements_destroy(context, &c->m);
}

static const char *name_of(const struct case_of *c, size_t step)
{
  return c->candidates->candidate[c->d->step[step].candidate].name;
}

static bool is_tied(const struct case_of *c, size_t step, const char *name)
{
  const struct um_diagnosis_step *s = &c->d->step[step];
  for (size_t i = 0; i < s->nalternative; i++)
    if (s->alternative[i].indistinguishable &&
        strcmp(c->candidates->candidate[s->alternative[i].candidate].name, name) == 0)
      return true;
  return false;
}

static void assert_verdict(const struct case_of *c, enum um_diagnosis_verdict expected)
{
  if (c->d->verdict != expected)
    fail_msg("%s: %s", um_diagnosis_verdict_name(c->d->verdict), c->d->summary);
}

static const char *const places[] = {"bus.+x", "panel.front"};

static void test_complete(void **state)
{
  (void)state;
  struct um_diagnosis_options options = {0};
  struct case_of c;
  put_world("");
  measure(NULL, 0, places, 2);
  assert_ok(diagnose(&options, &c));
  assert_verdict(&c, UM_VERDICT_COMPLETE);
  assert_int_equal(c.d->nstep, 0);
  assert_non_null(strstr(c.d->summary, "Nothing is missing"));
  end(&c);
}

/* With temperatures and both bands, a changed emittance can be nothing else. */
static void test_found(void **state)
{
  (void)state;
  static const char *const hidden[] = {"emittance:grey_white,factor=0.9"};
  struct um_diagnosis_options options = {0};
  struct case_of c;
  put_world("");
  measure(hidden, 1, places, 2);
  assert_ok(diagnose(&options, &c));
  assert_verdict(&c, UM_VERDICT_FOUND);
  assert_string_equal(name_of(&c, 0), "emittance:grey_white");
  /* the estimate of a right model lies within three of its sigmas in 99.7 of 100 seeds */
  assert_true(fabs(c.d->addition[0].value[0] - 0.9) <= 3.0 * c.d->addition_sigma[0][0]);
  assert_true(c.d->chi2_reduced > 2.0);
  assert_true(c.d->chi2_reduced_after >= 0.8 && c.d->chi2_reduced_after <= 1.25);
  end(&c);
}

static void test_two(void **state)
{
  (void)state;
  static const char *const hidden[] = {"internal_power:bus,power_W=60",
                                       "zero_point:vis,factor=0.9"};
  struct um_diagnosis_options options = {0};
  struct case_of c;
  put_world("");
  measure(hidden, 2, places, 2);
  assert_ok(diagnose(&options, &c));
  assert_int_equal(c.d->naddition, 2);
  for (size_t i = 0; i < 2; i++) {
    bool power = strcmp(c.d->addition[i].effect->name, "internal_power") == 0;
    if (!power) assert_string_equal(c.d->addition[i].effect->name, "zero_point");
    double truth = power ? 60.0 : 0.9;
    assert_true(fabs(c.d->addition[i].value[0] - truth) <= 3.0 * c.d->addition_sigma[i][0]);
  }
  end(&c);
}

/* Sunlight that is not absorbed because it became electricity, or because less is absorbed: without
 * the visible band, nobody knows (docs/physics/residuals.md, 5 and 7). */
static void test_group(void **state)
{
  (void)state;
  static const char *const hidden[] = {"panel_extraction:panel,efficiency=0.15"};
  static const char *const front[] = {"panel.front"};
  struct um_diagnosis_options options = {0};
  struct case_of c;
  put_world("");
  measure(hidden, 1, front, 1);
  assert_ok(diagnose(&options, &c));
  assert_string_equal(name_of(&c, 0), "panel_extraction:panel");
  assert_false(is_tied(&c, 0, "solar_absorptance:grey_panel"));
  end(&c);

  struct um_compare_measurements *m = measured();
  for (size_t i = 0; i < m->count; i++)
    if (strcmp(m->channel[m->row[i].channel].of, "vis") == 0) m->row[i].flag = 1;
  remove("m.csv");
  assert_ok(um_compare_measurements_write(context, m, "m.csv"));
  um_compare_measurements_destroy(context, &m);
  assert_ok(diagnose(&options, &c));
  assert_verdict(&c, UM_VERDICT_NOT_IDENTIFIABLE);
  bool extraction_first = strcmp(name_of(&c, 0), "panel_extraction:panel") == 0;
  assert_true(
      is_tied(&c, 0, extraction_first ? "solar_absorptance:grey_panel" : "panel_extraction:panel"));
  /* what separates them is what was left out */
  assert_non_null(c.d->next);
  assert_string_equal(c.d->next->of, "vis");
  end(&c);
}

/* Cells that give less than the scenario states, seen by their heat alone, could as well absorb
 * more; sunlight that they reflect would tell. */
static void test_less_extraction(void **state)
{
  (void)state;
  static const char *const hidden[] = {"panel_extraction:panel,efficiency=-0.08"};
  struct um_diagnosis_options options = {0};
  struct case_of c;
  put_world("");
  put_stated();
  measure(hidden, 1, NULL, 0);
  only_channel("lwir");
  assert_ok(diagnose(&options, &c));
  assert_verdict(&c, UM_VERDICT_NOT_IDENTIFIABLE);
  print_message("  %s\n", c.d->summary);
  const char *first = name_of(&c, 0);
  bool extraction = strcmp(first, "panel_extraction:panel") == 0;
  if (!extraction) assert_string_equal(first, "solar_absorptance:grey_panel");
  assert_true(
      is_tied(&c, 0, extraction ? "solar_absorptance:grey_panel" : "panel_extraction:panel"));
  assert_non_null(c.d->next);
  assert_string_equal(c.d->next->of, "vis");
  assert_int_equal(c.d->next->segment, UM_SEGMENT_SUNLIT);
  end(&c);
}

static void test_refusals(void **state)
{
  (void)state;
  struct um_diagnosis_nuisance_effect nuisance = {
      .effect = um_effects_find("attitude_offset"), .sigma = 5.0, .per = "observation"};
  struct um_diagnosis_options options = {.nuisance = &nuisance, .nnuisance = 1};
  struct case_of c;
  put_world("");
  measure(NULL, 0, NULL, 0);
  assert_refused(diagnose(&options, &c), UM_ERR_INPUT,
                 "nuisance 'attitude_offset' per 'observation': an effect that is free at "
                 "each observation fits any measurement; accepted: per set, per all");
  end(&c);
}

/* One unknown scale on every channel hides a change of the size of the satellite. */
static void test_free_scale(void **state)
{
  (void)state;
  static const char *const hidden[] = {"zero_point,factor=0.8"};
  struct um_diagnosis_nuisance_effect nuisance = {.effect = um_effects_find("zero_point"),
                                                  .sigma = INFINITY};
  struct um_diagnosis_options options = {.nuisance = &nuisance, .nnuisance = 1};
  struct case_of c;
  put_world("");
  measure(hidden, 1, NULL, 0);
  assert_ok(diagnose(&options, &c));
  assert_verdict(&c, UM_VERDICT_NOT_IDENTIFIABLE);
  end(&c);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_complete),
      cmocka_unit_test(test_found),
      cmocka_unit_test(test_two),
      cmocka_unit_test(test_group),
      cmocka_unit_test(test_less_extraction),
      cmocka_unit_test(test_refusals),
      cmocka_unit_test(test_free_scale),
  };
  return cmocka_run_group_tests(tests, model_set_up, model_tear_down);
}
