/* Which candidates there are, and that their signatures are derivatives. */
#include "evidence/sensitivity/candidates.h"
#include "evidence/sensitivity/stated.h"
#include "tests/evidence/sensitivity/forward_test.h"

static struct um_sensitivity_candidates *candidates_of(struct um_sensitivity_forward *f,
                                                       const char *const *only, size_t nonly)
{
  struct um_sensitivity_candidates_options o = {.only = only, .nonly = nonly};
  struct um_sensitivity_candidates *list;
  assert_ok(um_sensitivity_candidates_create(context, f, NULL, 0, &o, &list));
  return list;
}

static const struct um_sensitivity_candidate *named(const struct um_sensitivity_candidates *list,
                                                    const char *name)
{
  for (size_t i = 0; i < list->count; i++)
    if (strcmp(list->candidate[i].name, name) == 0) return &list->candidate[i];
  fail_msg("no candidate %s", name);
  return NULL;
}

/* Parts; groups where a part has several, beside the part; materials in use; bands where there is
 * more than one; the interior beside the walls for a thermostat; places of contacts that touch
 * different ones; switches that are off. What is one thing under two names is there once: the
 * contact of bus.interior and panel goes by "panel", that of +x and -x by "bus.+x"; "bus" touches
 * both. */
static void test_list(void **state)
{
  (void)state;
  static const char *const only[] = {
      "internal_power", "zero_point", "roughness", "time_tag", "contact_conductance",
      "mli_emittance",  "albedo",     "earth_ir",  "heater"};
  static const char *const expected[] = {"albedo",
                                         "earth_ir=off",
                                         "internal_power:bus",
                                         "internal_power:panel",
                                         "heater:bus",
                                         "heater:bus.interior",
                                         "heater:bus.+x",
                                         "heater:bus.-x",
                                         "heater:bus.+y",
                                         "heater:bus.-y",
                                         "heater:bus.+z",
                                         "heater:bus.-z",
                                         "heater:panel",
                                         "mli_emittance:bus",
                                         "mli_emittance:bus.+x",
                                         "mli_emittance:bus.-x",
                                         "mli_emittance:bus.+y",
                                         "mli_emittance:bus.-y",
                                         "mli_emittance:bus.+z",
                                         "mli_emittance:bus.-z",
                                         "mli_emittance:panel",
                                         "contact_conductance:bus",
                                         "contact_conductance:panel",
                                         "contact_conductance:bus.+x",
                                         "roughness:grey_white",
                                         "roughness:grey_panel",
                                         "roughness:grey_metal",
                                         "time_tag",
                                         "zero_point:vis",
                                         "zero_point:lwir"};
  static const char *const off[] = {"albedo"};
  const struct um_model_options options = {.without = off, .nwithout = 1};
  put_world("");
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(&options, m);
  struct um_sensitivity_candidates *list = candidates_of(f, only, sizeof only / sizeof only[0]);
  assert_int_equal(list->count, sizeof expected / sizeof expected[0]);
  for (size_t i = 0; i < list->count; i++)
    assert_string_equal(list->candidate[i].name, expected[i]);
  const struct um_sensitivity_candidate *c = named(list, "internal_power:panel");
  assert_true(c->insensitive);
  assert_string_equal(c->why, "effect 'internal_power': the part 'panel' has no interior that "
                              "could take the power; accepted: a part with interior");
  assert_string_equal(um_core_message(context), "");
  /* a thermostat begins at the temperature that its place was measured to have */
  c = named(list, "heater:bus.interior");
  assert_true(!c->insensitive && c->null_value[1] == 290.0);
  c = named(list, "albedo");
  assert_true(c->is_switch && !c->off && !c->insensitive && c->ncolumn == 1);
  /* what is on is tried off: the Earth's own heat, which is less of a temperature */
  const struct um_sensitivity_candidate *on = named(list, "earth_ir=off");
  assert_true(on->is_switch && on->off && !on->insensitive && on->signature[3] < 0.0);
  assert_true(um_sensitivity_is_on(f, on->effect) && !um_sensitivity_is_on(f, c->effect));
  /* albedo warms: the whole change of a temperature observation is above 0 */
  assert_true(c->signature[3] > 0.0);
  um_sensitivity_candidates_destroy(context, &list);
  assert_null(list);

  /* additions are not listed again; what is excluded neither */
  struct um_model_addition a = addition_of("zero_point", "vis", 0.9);
  static const char *const two[] = {"zero_point", "extinction"}, *const one[] = {"extinction:lwir"};
  struct um_sensitivity_candidates_options o = {
      .only = two, .nonly = 2, .exclude = one, .nexclude = 1};
  assert_ok(um_sensitivity_candidates_create(context, f, &a, 1, &o, &list));
  assert_int_equal(list->count, 2);
  assert_string_equal(list->candidate[0].name, "extinction:vis");
  assert_string_equal(list->candidate[1].name, "zero_point:lwir");
  assert_int_equal(list->ndropped, 0);
  um_sensitivity_candidates_destroy(context, &list);
  /* what is asked for and is none is named with the reason */
  static const char *const none[] = {"extinction:lwir", "penumbra", "zero_point:vis"};
  o = (struct um_sensitivity_candidates_options){
      .only = none, .nonly = 3, .exclude = one, .nexclude = 1};
  assert_ok(um_sensitivity_candidates_create(context, f, NULL, 0, &o, &list));
  assert_int_equal(list->count, 2);
  assert_true(named(list, "penumbra=off")->off); /* it is on by default */
  assert_int_equal(list->ndropped, 1);
  assert_string_equal(list->dropped[0].name, "extinction:lwir");
  assert_string_equal(list->dropped[0].why, "it is excluded");
  um_sensitivity_candidates_destroy(context, &list);
  static const char *const nowhere[] = {"extinction:swir"};
  o = (struct um_sensitivity_candidates_options){.only = nowhere, .nonly = 1};
  um_core_message_clear(context);
  assert_int_equal(um_sensitivity_candidates_create(context, f, NULL, 0, &o, &list), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(context), "--only extinction:swir: nothing that "
                                                   "'extinction' acts on is called 'swir'"));
  /* nothing but off stands behind '=' */
  static const char *const valued[] = {"albedo=0.3"};
  o = (struct um_sensitivity_candidates_options){.only = valued, .nonly = 1};
  um_core_message_clear(context);
  assert_int_equal(um_sensitivity_candidates_create(context, f, NULL, 0, &o, &list), UM_ERR_INPUT);
  static const char *const wrong[] = {"zero_pont:vis"};
  o = (struct um_sensitivity_candidates_options){.only = wrong, .nonly = 1};
  um_core_message_clear(context);
  assert_int_equal(um_sensitivity_candidates_create(context, f, NULL, 0, &o, &list), UM_ERR_INPUT);
  assert_non_null(
      strstr(um_core_message(context),
             "no effect is called 'zero_pont'; did you mean 'zero_point'?; accepted: "));
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

/* Calibrations are linear: d(f E)/df = E and d(E + b)/db = 1, to the rounding of the difference
 * (E of 16 digits, moved by a hundredth of it). */
static void test_linear(void **state)
{
  (void)state;
  static const char *const only[] = {"zero_point:lwir", "background:lwir"};
  put_world("");
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(NULL, m);
  struct um_sensitivity_candidates *list = candidates_of(f, only, 2);
  const double *zero = named(list, "zero_point:lwir")->signature;
  const double *background = named(list, "background:lwir")->signature;
  for (size_t j = 0; j < f->observations.count; j++) {
    bool lwir = strcmp(m->channel[f->observations.channel[j]].of, "lwir") == 0;
    assert_true(fabs(zero[j] - (lwir ? list->base[j] : 0.0)) <= 1e-12 * fabs(list->base[j]));
    assert_true(fabs(background[j] - (lwir ? 1.0 : 0.0)) <= 1e-12);
  }
  um_sensitivity_candidates_destroy(context, &list);
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

/* Against central differences of runs of their own, of half the step: the one-sided difference is
 * off by its curvature, h f''/2, and the heat by the search for the periodic state (0.04 sigma, see
 * forward.c). Steps are a fifth of a prior width; where a response goes like a power of a factor
 * between -2 and 2 that is at most a tenth of it. In the mean over the observations, as the score
 * takes them. */
static void test_central(void **state)
{
  (void)state;
  static const char *const only[] = {"internal_power:bus", "emittance:grey_panel", "area:panel",
                                     "time_tag"};
  put_world("");
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(NULL, m);
  struct um_sensitivity_candidates *list = candidates_of(f, only, 4);
  assert_int_equal(list->count, 4);
  for (size_t i = 0; i < list->count; i++) {
    const struct um_sensitivity_candidate *c = &list->candidate[i];
    double low[48], high[48], h = 0.5 * fabs(c->step[0]), off = 0.0, length = 0.0;
    assert_true(!c->insensitive && c->ncolumn == 1);
    struct um_model_addition a = addition_of(c->effect->name, c->target, c->null_value[0] - h);
    assert_ok(fresh_values(NULL, f, &a, 1, low));
    a.value[0] = c->null_value[0] + h;
    assert_ok(fresh_values(NULL, f, &a, 1, high));
    for (size_t j = 0; j < f->observations.count; j++) {
      double central = (high[j] - low[j]) / f->observations.sigma[j];
      double own = c->signature[j] * 2.0 * h / f->observations.sigma[j];
      off += (own - central) * (own - central) / (double)f->observations.count;
      length += central * central / (double)f->observations.count;
    }
    if (!(sqrt(off) <= 0.1 * sqrt(length) + 0.04))
      fail_msg("%s: %g of %g sigma", c->name, sqrt(off), sqrt(length));
  }
  um_sensitivity_candidates_destroy(context, &list);
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

/* Interiors by name stand for their part, but for one whose temperature is given; `interior` goes
 * by the part's name. */
static void test_interiors(void **state)
{
  (void)state;
  static const char *const only[] = {"internal_power"};
  static const char *const expected[] = {"internal_power:bus", "internal_power:bus.frame",
                                         "internal_power:panel.boards"};
  static const char *const inside[] = {
      "parts.bus.interiors={frame: {capacity_J_K: 200, power_W: 3, conductance_W_K: 2}, room: "
      "{temperature_K: 280}}",
      "parts.panel.interiors={boards: {capacity_J_K: 100, conductance_W_K: 1}}"};
  const struct um_model_options options = {.overrides = inside, .noverride = 2};
  put_world("");
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(&options, m);
  struct um_sensitivity_candidates *list = candidates_of(f, only, 1);
  assert_int_equal(list->count, 3);
  for (size_t i = 0; i < 3; i++) {
    assert_string_equal(list->candidate[i].name, expected[i]);
    assert_false(list->candidate[i].insensitive);
  }
  /* down to where nothing is released: 3 W are stated in the frame */
  assert_close(named(list, "internal_power:bus.frame")->minimum[0], -3.0, 1e-12);
  um_sensitivity_candidates_destroy(context, &list);
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

/* An effect whose hook leaves the environment as it is has nothing to act on: cloud in the mirror
 * of an Earth that is the same everywhere. A switch that is off stays a candidate, and so does an
 * effect whose default values do nothing. */
static void test_environment(void **state)
{
  (void)state;
  static const char *const only[] = {"cloud_in_mirror", "albedo_level", "earth_map", "shadow_air"};
  static const char *const knocke[] = {"environment.earth=knocke"};
  put_world("");
  struct um_compare_measurements *m = measured();
  for (int varied = 0; varied < 2; varied++) {
    const struct um_model_options options = {.overrides = knocke, .noverride = (size_t)varied};
    struct um_sensitivity_forward *f = forward_of(&options, m);
    struct um_sensitivity_candidates *list = candidates_of(f, only, 4);
    assert_int_equal(list->count, varied ? 4 : 3);
    named(list, "albedo_level");
    named(list, "shadow_air");
    named(list, varied ? "cloud_in_mirror" : "earth_map");
    if (varied) named(list, "earth_map=off");
    um_sensitivity_candidates_destroy(context, &list);
    um_sensitivity_forward_destroy(context, &f);
  }
  um_compare_measurements_destroy(context, &m);
}

/* A parameter at its upper bound is moved down; three angles are one candidate of three columns;
 * anew on a model that has something added, a signature stands at that model. */
static void test_steps(void **state)
{
  (void)state;
  static const char *const only[] = {"panel_extraction:panel", "attitude_offset", "zero_point:vis"};
  put_world("effects:\n  - {effect: panel_extraction, target: panel, efficiency: 0.4}\n");
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(NULL, m);
  struct um_sensitivity_candidates *list = candidates_of(f, only, 3);
  const struct um_sensitivity_candidate *c = named(list, "panel_extraction:panel");
  const struct um_effect_parameter *p = &c->effect->parameters[0];
  assert_true(c->null_value[0] == 0.4 && !c->insensitive);
  assert_true(c->null_value[0] + c->step[0] <= p->maximum);
  assert_true(c->null_value[0] + c->step[0] >= p->minimum);
  /* electricity is heat that is missing: the panel's front is row 2 */
  assert_true(c->signature[2] < 0.0);
  assert_int_equal(named(list, "attitude_offset")->ncolumn, 3);
  double before = named(list, "zero_point:vis")->signature[45], base[48];
  um_sensitivity_candidates_destroy(context, &list);
  struct um_model_addition a = addition_of("diffuse_level", "grey_white", 1.5);
  assert_ok(um_sensitivity_forward_evaluate(context, f, &a, 1, base));
  const struct um_sensitivity_candidates_options o = {.only = only, .nonly = 3};
  assert_ok(um_sensitivity_candidates_create(context, f, &a, 1, &o, &list));
  const struct um_sensitivity_candidate *zero = named(list, "zero_point:vis");
  assert_true(zero->signature[45] != before);
  for (size_t j = 0; j < f->observations.count; j++)
    if (strcmp(m->channel[f->observations.channel[j]].of, "vis") == 0)
      assert_true(fabs(zero->signature[j] - base[j]) <= 1e-12 * base[j]);
  um_sensitivity_candidates_destroy(context, &list);
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

/* What adds to a stated value goes down as far as the whole stays physical; sides that cannot hold
 * cells give no electricity; a factor ends where an albedo passes 1; a switch with two discs is two
 * candidates. */
static void test_ranges(void **state)
{
  (void)state;
  static const char *const only[] = {"panel_extraction", "interior_capacity", "exposure",
                                     "albedo_level",     "penumbra",          "internal_power:bus"};
  put_world("environment: {albedo: 0.5, disc: point}\n");
  struct um_compare_measurements *m = measured();
  const char *const cells[] = {"parts.panel.electrical_extraction=0.18", "time.exposure_s=2"};
  const struct um_model_options options = {.overrides = cells, .noverride = 2};
  for (int given = 0; given < 2; given++) {
    struct um_sensitivity_forward *f = forward_of(given ? &options : NULL, m);
    struct um_sensitivity_candidates *list = candidates_of(f, only, 6);
    const struct um_sensitivity_candidate *panel = named(list, "panel_extraction:panel");
    assert_false(panel->insensitive);
    assert_close(panel->minimum[0], given ? -0.18 : 0.0, 1e-15);
    assert_true(panel->maximum[0] == 0.4);
    const struct um_sensitivity_candidate *bright = named(list, "panel_extraction:bus");
    assert_true(bright->insensitive);
    assert_non_null(strstr(bright->why, "solar cells"));
    assert_true(named(list, "interior_capacity:bus")->minimum[0] == -4000.0);
    assert_close(named(list, "internal_power:bus")->minimum[0], -20.0, 1e-12);
    assert_true(named(list, "exposure")->minimum[0] == (given ? -4.0 : 0.0));
    assert_true(named(list, "albedo_level")->maximum[0] == 2.0);
    size_t discs = 0;
    for (size_t i = 0; i < list->count; i++)
      if (strcmp(list->candidate[i].name, "penumbra") == 0)
        assert_true(list->candidate[i].null_value[0] == (discs++ == 0 ? 1.0 : 0.0));
    um_sensitivity_candidates_destroy(context, &list);
    um_sensitivity_forward_destroy(context, &f);
  }
  um_compare_measurements_destroy(context, &m);
}

/* Each effect that changes a stated number knows it, as what it makes of it, within what is
 * physical. */
static void test_stated(void **state)
{
  (void)state;
  static const struct {
    const char *effect, *target;
    double value, stated, whole;
  } cases[] = {
      {"solar_irradiance", NULL, 0.9, 1361.0, 1224.9},
      {"albedo_level", NULL, 1.5, 0.3, 0.45},
      {"albedo_level", NULL, 9.0, 0.3, 1.0},
      {"earthshine_level", NULL, 2.0, 0.3, 0.6},
      {"earth_ir_level", NULL, 0.8, 237.0, 189.6},
      {"earth_brightness", NULL, -20.0, 270.0, 250.0},
      {"shadow_radius", NULL, 5.0, 6378.137, 6383.137},
      {"solar_absorptance", "grey_white", 0.1, 0.2, 0.3},
      {"emittance", "grey_panel", 0.9, 0.85, 0.765},
      {"panel_extraction", "panel", -0.08, 0.18, 0.1},
      {"panel_extraction", "panel.plate", -0.5, 0.18, 0.0},
      {"internal_power", "bus", 5.0, 20.0, 25.0},
      {"internal_power", "bus", -30.0, 20.0, 0.0},
      {"interior_capacity", "bus", -1000.0, 4000.0, 3000.0},
      {"heat_capacity", "panel", 1.5, 2000.0, 3000.0},
      {"through_conductance", "panel", 2.0, 50.0, 100.0},
      {"area", "panel", 1.1, 2.0, 2.2},
      {"spin_period", NULL, 0.01, 240.0, 242.4},
      {"exposure", NULL, 5.0, 4.0, 9.0},
      {"mli_creases", "panel", 7.0, 9.0, 16.0},
      {"mli_creases", "panel", -20.0, 9.0, 0.0},
      {"mli_creases", "bus", 9.0, 16.0, 25.0}, /* one side of sheet, the others panels */
      {"panel_flatness", "bus", 0.75, 0.25, 1.0},
  };
  const char *const cells[] = {"parts.panel.electrical_extraction=0.18", "time.exposure_s=2",
                               "parts.panel.creases={tilt_rms_deg: 3}",
                               "parts.bus.flatness={tilt_rms_deg: 0.5}",
                               "parts.bus.groups.+x={creases: {tilt_rms_deg: 4}}"};
  const struct um_model_options options = {.overrides = cells, .noverride = 5};
  put_world("");
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(&options, m);
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    const struct um_effect *effect = um_effects_find(cases[i].effect);
    struct um_effect_stated stated;
    assert_non_null(effect);
    if (!um_sensitivity_stated_find(f, effect, cases[i].target, 0, effect->parameters[0].null_value,
                                    &stated))
      fail_msg("%s: nothing is stated", cases[i].effect);
    print_message("  %-20s %s %g %s\n", cases[i].effect, stated.what, stated.value, stated.unit);
    assert_close(stated.value, cases[i].stated, 1e-9 * cases[i].stated);
    assert_close(um_sensitivity_stated_whole(&stated, cases[i].value), cases[i].whole,
                 1e-9 * cases[i].stated);
  }
  struct um_effect_stated none;
  assert_false(um_sensitivity_stated_find(f, um_effects_find("zero_point"), "vis", 0, 1.0, &none));
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

static void compare_lists(const struct um_sensitivity_candidates *one,
                          const struct um_sensitivity_candidates *other)
{
  assert_int_equal(one->count, other->count);
  for (size_t i = 0; i < one->count; i++) {
    const struct um_sensitivity_candidate *a = &one->candidate[i], *b = &other->candidate[i];
    assert_string_equal(a->name, b->name);
    assert_string_equal(a->why == NULL ? "" : a->why, b->why == NULL ? "" : b->why);
    assert_int_equal(a->insensitive, b->insensitive);
    assert_int_equal(a->ncolumn, b->ncolumn);
    assert_int_equal(a->nunidentified, b->nunidentified);
    assert_memory_equal(a->null_value, b->null_value, sizeof a->null_value);
    assert_memory_equal(a->parameter, b->parameter, a->ncolumn * sizeof *a->parameter);
    assert_memory_equal(a->step, b->step, a->ncolumn * sizeof *a->step);
    assert_memory_equal(a->signature, b->signature,
                        a->ncolumn * one->nobservation * sizeof *a->signature);
  }
}

/* Signatures by any number of processes, and anew by a forward that has kept what it can, have the
 * same bits, those that are refused the same reason; what was done is counted. Effects that heat
 * feels, that geometry does, behind the light, one that is refused, a switch. */
static void test_workers(void **state)
{
  (void)state;
  static const char *const only[] = {
      "interior_capacity", "internal_power",   "area",   "zero_point",
      "along_track",       "panel_extraction", "heater", "penumbra"};
  const int threads = um_core_context_threads(context);
  put_world("environment: {disc: point}\n");
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_candidates *list[3];
  struct um_sensitivity_forward *f[3];
  size_t before = 0;
  for (int i = 0; i < 3; i++) {
    um_core_context_set_threads(context, i == 1 ? 3 : 1);
    if (i < 2)
      f[i] = forward_of(NULL, m);
    else
      before = (f[i] = f[0])->evaluations;
    list[i] = candidates_of(f[i], only, sizeof only / sizeof only[0]);
    if (i == 1) assert_int_equal(f[0]->evaluations, f[1]->evaluations);
    if (i == 1) assert_int_equal(f[0]->heat_runs, f[1]->heat_runs);
  }
  um_core_context_set_threads(context, threads);
  assert_true(named(list[1], "panel_extraction:bus")->insensitive);
  assert_false(named(list[1], "internal_power:bus")->insensitive);
  compare_lists(list[0], list[1]);
  compare_lists(list[0], list[2]);
  /* all but the first run of the scenario and that for its noise */
  assert_int_equal(f[0]->evaluations - before, before - 2);
  for (int i = 0; i < 3; i++) um_sensitivity_candidates_destroy(context, &list[i]);
  for (int i = 0; i < 2; i++) um_sensitivity_forward_destroy(context, &f[i]);
  um_compare_measurements_destroy(context, &m);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_list, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_interiors, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_environment, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_linear, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_central, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_steps, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_ranges, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_stated, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_workers, model_set_up, model_tear_down),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
