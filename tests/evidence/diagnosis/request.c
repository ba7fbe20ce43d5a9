/* What a user asks of a diagnosis or a fit, in texts: which effects, from where, along with what,
 * and how a text that is wrong is refused. */
#include <math.h>

#include "evidence/diagnosis/request.h"
#include "model/build/build.h"
#include "tests/evidence/diagnosis/pass_test.h"

static void test_requests(void **state)
{
  (void)state;
  struct um_model *model;
  static const char *const nuisance[] = {"zero_point:vis,sigma=free", "time_tag,sigma=0.2,per=set",
                                         "zero_point:lwir"};
  static const char *const exclude[] = {"albedo"};
  static const char *const wanted[] = {"internal_power:bus,power_W=3", "area:panel",
                                       "emittance:grey_white,emittance_factor=0.9"};
  const struct um_diagnosis_request_texts texts = {.nuisance = nuisance,
                                                   .exclude = exclude,
                                                   .wanted = wanted,
                                                   .nnuisance = 3,
                                                   .nexclude = 1,
                                                   .nwanted = 3};
  struct um_diagnosis_request r;
  assert_ok(um_model_create(context, "scene", NULL, &model));
  assert_ok(um_diagnosis_request_make(context, model, &texts, &r));
  /* the scenario's first, whose place the third text takes with the prior's own width */
  assert_int_equal(r.nnuisance, 3);
  assert_string_equal(r.nuisance[0].effect->name, "zero_point");
  assert_string_equal(r.nuisance[0].target, "lwir");
  assert_true(r.nuisance[0].sigma == r.nuisance[0].effect->parameters[0].prior_sigma);
  assert_true(isinf(r.nuisance[1].sigma));
  assert_true(r.nuisance[2].target == NULL && r.nuisance[2].sigma == 0.2);
  assert_string_equal(r.nuisance[2].per, "set");
  assert_int_equal(r.nexclude, 2);
  assert_string_equal(r.exclude[0], "time_tag");
  assert_string_equal(r.exclude[1], "albedo");
  assert_int_equal(r.nwanted, 3);
  assert_true(r.wanted[0].value[0] == 3.0);
  assert_true(isnan(r.wanted[1].value[0]));
  assert_true(r.wanted[2].value[0] == 0.9);
  assert_non_null(strstr(um_core_log_text(context), "emittance_factor is now called factor"));
  um_diagnosis_request_release(context, &r);
  static const struct {
    const char *nuisance, *wanted, *says;
  } refused[] = {
      {"gravity", NULL, "--nuisance gravity: no effect is called 'gravity'; accepted: "},
      {"zero_point:swir", NULL, "--nuisance zero_point:swir: nothing that 'zero_point' acts on"},
      {"zero_point:vis,sigma=-1", NULL, "sigma '-1'; accepted: a number above 0, or free"},
      {"zero_point:vis,width=1", NULL, "'width' is not known; accepted: sigma, per"},
      {"zero_point:vis,sigma", NULL, "'sigma' is not understood; accepted: NAME=VALUE"},
      {"albedo", NULL, "effect 'albedo' has no parameters to be uncertain of"},
      {NULL, "internal_power", "--add internal_power: effect 'internal_power' needs a target"},
      {NULL, "internal_power:bus,heat_W=1", "no parameter 'heat_W'; accepted: power_W"},
      {NULL, "internal_power:bus,power_W=x", "power_W 'x'; accepted: "},
      {NULL, "area:panel,area_factor=0.9,factor=0.9", "area_factor and factor are one parameter"},
  };
  for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
    const struct um_diagnosis_request_texts one = {.nuisance = &refused[i].nuisance,
                                                   .nnuisance = refused[i].nuisance != NULL,
                                                   .wanted = &refused[i].wanted,
                                                   .nwanted = refused[i].wanted != NULL};
    um_core_message_clear(context);
    assert_int_equal(um_diagnosis_request_make(context, model, &one, &r), UM_ERR_INPUT);
    if (strstr(um_core_message(context), refused[i].says) == NULL)
      fail_msg("case %zu said: %s", i, um_core_message(context));
    um_diagnosis_request_release(context, &r);
  }
  um_model_destroy(context, &model);
}

/* Without a target it is of each that there is: parts without their sides, materials; one that is
 * named behind has a width of its own. */
static void test_of_each(void **state)
{
  (void)state;
  static const char *const nuisance[] = {"area,sigma=0.02", "heat_capacity,sigma=0.1",
                                         "emittance,sigma=0.03", "area:panel,sigma=0.01"};
  static const struct {
    const char *effect, *target;
    double sigma;
  } expected[] = {{"zero_point", "lwir", 0.02},      {"area", "bus", 0.02},
                  {"area", "panel", 0.01},           {"heat_capacity", "bus", 0.1},
                  {"heat_capacity", "panel", 0.1},   {"emittance", "grey_white", 0.03},
                  {"emittance", "grey_panel", 0.03}, {"emittance", "grey_metal", 0.03}};
  const size_t n = sizeof expected / sizeof expected[0];
  const struct um_diagnosis_request_texts texts = {.nuisance = nuisance, .nnuisance = 4};
  struct um_diagnosis_request r;
  struct um_model *model;
  assert_ok(um_model_create(context, "scene", NULL, &model));
  assert_ok(um_diagnosis_request_make(context, model, &texts, &r));
  assert_int_equal(r.nnuisance, n);
  for (size_t i = 0; i < n; i++) {
    size_t k = 0;
    while (k < n && !(strcmp(r.nuisance[k].effect->name, expected[i].effect) == 0 &&
                      strcmp(r.nuisance[k].target, expected[i].target) == 0))
      k++;
    if (k == n) fail_msg("no nuisance %s:%s", expected[i].effect, expected[i].target);
    assert_true(r.nuisance[k].sigma == expected[i].sigma);
  }
  um_diagnosis_request_release(context, &r);
  um_model_destroy(context, &model);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_requests),
                                     cmocka_unit_test(test_of_each)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
