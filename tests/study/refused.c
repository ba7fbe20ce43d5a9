/* What a study is refused for when its scenario is known: one line each that says where. */
#include <string.h>

#include "tests/study/world.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

static const struct {
  const char *study, *words;
} refused[] = {
    {"parameters: [{key: parts.box.interior.powr_W, from: 0, to: 1}]\n", "powr_W"},
    {"parameters: [{key: parts.box.interior.power_W, from: -1, to: 1e9}]\n",
     "'parts.box.interior.power_W' at 1000000000"},
    {"parameters: [{key: parts.box.interior.capacity_J_K, from: -5, to: 100}]\n",
     "'parts.box.interior.capacity_J_K' at -5"},
    {"parameters: [{material: grey_pannel, property: emittance, from: 0.1, to: 0.9}]\n",
     "grey_panel"},
    {"parameters: [{material: grey_panel, property: emittance, from: 0.5, to: 1.2}]\n",
     "accepted: above 0, at most 1"},
    {"parameters: [{effect: emitance, target: grey_panel, from: 0.5, to: 1}]\n", "emittance"},
    {"parameters: [{effect: emittance, from: 0.5, to: 1}]\n", "needs a target"},
    {"parameters: [{effect: attitude_offset, from: 0.5, to: 1}]\n", "parameter beside it"},
    {"parameters: [{effect: emittance, target: grey_panel, parameter: level, from: 0.5, to: 1}]\n",
     "accepted: factor"},
    {"parameters: [{effect: emittance, target: grey_panel, parameter: emittance_factor, from: 0.5, "
     "to: 1},\n"
     "  {effect: emittance, target: grey_panel, parameter: factor, from: 0.5, to: 1}]\n",
     "moves what 'emittance:grey_panel.factor'"},
    {"parameters: [{effect: emittance, target: grey_panel, from: 0.01, to: 1}]\n",
     "accepted: 0.1 to 10"},
    {"parameters: [{effect: zero_point, target: vis, from: 0.9, to: 1.1}]\n"
     "outputs: {bands: [lwir]}\n",
     "'zero_point:vis' changes nothing"},
    {"parameters: [{key: parts.box.interior.power_W, from: 0, to: 9}]\noutputs: {bands: "
     "[visual]}\n",
     "no band 'visual'"},
    {"parameters: [{key: parts.box.interior.power_W, from: 0, to: 9}]\noutputs: {places: [bos]}\n",
     "no place 'bos'"},
    /* one number under two names: what is said names both */
    {"parameters: [{key: parts.box.interior.power_W, from: 0, to: 100},\n"
     "  {key: parts.box.interior.power_W, name: q, from: 0, to: 50}]\n",
     "'q' moves what 'parts.box.interior.power_W' of line 4 moves"},
    {"parameters: [{key: parts.wing.shell.areal_heat_capacity_J_m2_K, from: 1000, to: 2000},\n"
     "  {key: parts.01.shell.areal_heat_capacity_J_m2_K, from: 1000, to: 2000}]\n",
     "'parts.01.shell.areal_heat_capacity_J_m2_K' moves what"},
    {"parameters: [{key: bands.vis.bins, from: 4, to: 8},\n"
     "  {key: bands.vis, from: 1, to: 2}]\n",
     "'bands.vis' moves what 'bands.vis.bins' of line 4 moves"},
    {"parameters: [{key: parts.1, from: 1, to: 2},\n"
     "  {key: parts.wing.shell.areal_heat_capacity_J_m2_K, from: 4, to: 8}]\n",
     "'parts.wing.shell.areal_heat_capacity_J_m2_K' moves what 'parts.1' of line 4 moves"},
    {"parameters: [{material: grey_panel, property: emittance, from: 0.6, to: 0.9},\n"
     "  {effect: emittance, target: grey_panel, from: 0.9, to: 1.1}]\n",
     "'emittance:grey_panel' moves what 'grey_panel.emittance' of line 4 moves"},
    {"parameters: [{effect: zero_point, target: vis, from: 0.9, to: 1},\n"
     "  {effect: zero_point, target: vis, parameter: factor, from: 0.9, to: 1}]\n",
     "'zero_point:vis.factor' moves what 'zero_point:vis' of line 4 moves"},
    {"parameters: [{effect: zero_point, target: lwir, from: 0.9, to: 1},\n"
     "  {key: \"effects.zero_point:lwir.factor\", from: 0.9, to: 1}]\n",
     "'effects.zero_point:lwir.factor' moves what 'zero_point:lwir' of line 4 moves"},
};

static void test_refused(void **state)
{
  (void)state;
  static const char *const quick[] = {"thermal.start=isothermal", "thermal.orbits_before=0.05",
                                      "effects=[{effect: zero_point, target: lwir, factor: 0.95}]"};
  struct um_study_run_options options = world_options(1, false);
  options.model = (struct um_model_options){.overrides = quick, .noverride = 3};
  for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
    struct um_study *study = NULL;
    world_put(refused[i].study);
    enum um_status status = um_study_create(context, WORLD_STUDY, &options, &study);
    const char *message = um_core_message(context);
    if (status != UM_ERR_INPUT || strstr(message, refused[i].words) == NULL ||
        strstr(message, WORLD_STUDY ":4: ") == NULL)
      if (strstr(message, WORLD_STUDY ":5: ") == NULL || strstr(message, refused[i].words) == NULL)
        fail_msg("%s -> %d %s", refused[i].study, (int)status, message);
    assert_null(study);
    assert_null(strchr(message, '\n'));
    um_core_message_clear(context);
  }
  world_clear(context);
}

/* A parameter by the name it had before is said once, and called by its present one. */
static void test_former_name(void **state)
{
  (void)state;
  static const char *const quick[] = {"thermal.start=isothermal", "thermal.orbits_before=0.05"};
  struct um_study_run_options options = world_options(1, false);
  struct um_study *study = NULL;
  char text[4096] = "";
  options.model = (struct um_model_options){.overrides = quick, .noverride = 2};
  world_put("parameters: [{effect: emittance, target: grey_panel, parameter: emittance_factor, "
            "from: 0.8, to: 1}]\n");
  um_core_log_clear(context);
  assert_int_equal(um_study_create(context, WORLD_STUDY, &options, &study), UM_OK);
  const char *warning = strstr(um_core_log_text(context), "emittance_factor is now called factor");
  assert_non_null(warning);
  assert_null(strstr(warning + 1, "emittance_factor is now called factor"));
  FILE *file = tmpfile();
  assert_non_null(file);
  assert_int_equal(um_study_print_check(context, study, false, file), UM_OK);
  rewind(file);
  text[fread(text, 1, sizeof text - 1, file)] = '\0';
  fclose(file);
  assert_non_null(strstr(text, "emittance:grey_panel.factor "));
  assert_null(strstr(text, "emittance_factor"));
  um_study_destroy(context, &study);
  world_clear(context);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_refused),
                                     cmocka_unit_test(test_former_name)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
