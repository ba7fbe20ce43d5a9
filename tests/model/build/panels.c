/* Panels and blankets of a scenario: the wall that their keys make is the one that the numbers
 * make, on the small satellite of tests/effects/heat_help.h. By hand, faces 0.3 mm of bare
 * aluminium (2700 kg/m3, 896 J/kg/K, 167 W/m/K), core 20 mm of the same at 32 kg/m3:
 *
 *   C = 2 x 0.0003 x 2700 x 896 + 32 x 896 x 0.02         = 2024.96 J/m2/K
 *   k t = 2 x 0.0003 x 167 + 15/32 x 32/2700 x 167 x 0.02  = 0.118755556 W/K
 *   U = 32/2700 x 167 / 0.02                               = 98.962963 W/m2/K */
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/effects/heat_help.h"

#define PANEL "material: aluminium_bare, face_mm: 0.3, core_mm: 20, core_density_kg_m3: 32"
#define OFTEN "thermal.start=isothermal", "thermal.orbits_before=0", "parts.panel.lumped=false"

static void panel_is_its_wall(void **state)
{
  (void)state;
  struct heat_run a = heat_compute(LIST(OFTEN, "parts.panel.shell={honeycomb: {" PANEL "}}"), NONE,
                                   LIST("bulk_temperature"));
  struct heat_run b = heat_compute(
      LIST(OFTEN, "parts.panel.shell={areal_heat_capacity_J_m2_K: 2024.96, conductance_W_K: "
                  "0.118755555556, through_conductance_W_m2_K: 98.962962963}"),
      NONE, NONE);
  for (size_t k = 0; k < a.result->nobs; k++) {
    heat_close("front", heat_temperature(&a, "panel.front", k),
               heat_temperature(&b, "panel.front", k), 1e-8);
    heat_close("back", heat_temperature(&a, "panel.back", k), heat_temperature(&b, "panel.back", k),
               1e-8);
  }
  heat_release(&a);
  heat_release(&b);
}

/* Steady, the front's heat that the core carries is what the back gives: U A (T_front - T_back) =
 * emission of the back less what it absorbs and what goes to the bus by 2 W/K. Lumped, 2 m2. */
static void core_conducts(void **state)
{
  (void)state;
  struct heat_run run =
      heat_compute(LIST("parts.panel.shell={honeycomb: {" PANEL "}}"), NONE, NONE);
  double front = heat_temperature(&run, "panel.front", 0);
  double back = heat_temperature(&run, "panel.back", 0);
  struct heat_budget side = heat_budget(&run, "panel", true);
  double to_bus = 2.0 * (back - heat_temperature(&run, "bus.+x.wall", 0));
  heat_close("core", 98.962962963 * 2.0 * (front - back), side.emitted - side.absorbed + to_bus,
             1e-5);
  heat_release(&run);
}

/* Seams of 9 m at 0.02 W/m/K around a cube of 6 faces of 1 m2, of which one has its own blanket:
 * what five let through more than without is 0.18 W/K / 5 m2 on each. Doenecke's e* as
 * docs/physics/mli.md prints it, at the mean temperature of wall and skin. */
static void blanket_has_seams(void **state)
{
  (void)state;
#define DOENECKE "law: doenecke, areal_heat_capacity_J_m2_K: 60"
  struct heat_run run = heat_compute(
      LIST("parts.bus.mli={" DOENECKE ", seam_length_m: 9, seam_conductance_W_m_K: 0.02}",
           "parts.bus.groups={-x: {mli: {" DOENECKE ", factor: 2}}}"),
      NONE, NONE);
  static const char *const groups[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
  struct heat_budget skin = heat_budget(&run, "bus", false);
  double leak = 0.0;
  for (size_t g = 0; g < 6; g++) {
    char outer[32], wall[32];
    snprintf(outer, sizeof outer, "bus.%s", groups[g]);
    snprintf(wall, sizeof wall, "bus.%s.wall", groups[g]);
    double w = heat_temperature(&run, wall, 0), s = heat_temperature(&run, outer, 0);
    double m = 0.5 * (w + s), own = strcmp(groups[g], "-x") == 0 ? 2.0 : 1.0;
    double e = 0.000136 / (4.0 * UM_STEFAN_BOLTZMANN * m * m) + 0.000121 * pow(m, 0.667);
    leak += own * e * UM_STEFAN_BOLTZMANN * (pow(w, 4) - pow(s, 4));
    if (own == 1.0) leak += 0.18 / 5.0 * (w - s);
  }
  heat_close("leak", leak, skin.emitted - skin.absorbed, 1e-5);
  heat_release(&run);
}

static double node_capacity(const struct heat_run *run, const char *name)
{
  const struct um_thermal_network *network = run->model->body->network;
  size_t i = um_thermal_network_find(network, name);
  if (i == (size_t)-1) fail_msg("no node is called '%s'", name);
  return um_thermal_network_capacity(network, (uint32_t)i);
}

/* 1 mm of bare aluminium as one cell (2700 x 896 x 0.001 = 2419.2 J/m2/K) before 20 mm of
 * foam as two of 10 mm, 50 x 1400 x 0.01 = 700: the front has 1209.6, the node between both 1209.6
 * + 350, the one in the foam 700, the back 350, of 2 m2. The steady flow crosses 1 mm/167 + 20
 * mm/0.03, 1.4999866 W/m2/K. */
static void layers_are_cells(void **state)
{
  (void)state;
#define FOAM "density_kg_m3: 50, specific_heat_J_kg_K: 1400, conductivity_W_m_K: 0.03"
  struct heat_run run = heat_compute(
      LIST("parts.panel.shell={layers: [{material: aluminium_bare, thickness_mm: 1, cells: 1}, "
           "{thickness_mm: 20, " FOAM "}]}"),
      NONE, NONE);
  static const struct {
    const char *node;
    double capacity;
  } nodes[] = {{"panel.front", 1209.6},
               {"panel.front.core1", 1559.6},
               {"panel.front.core2", 700.0},
               {"panel.back", 350.0}};
  for (size_t i = 0; i < sizeof nodes / sizeof nodes[0]; i++)
    heat_close(nodes[i].node, node_capacity(&run, nodes[i].node), 2.0 * nodes[i].capacity, 1e-12);
  double front = heat_temperature(&run, "panel.front", 0);
  double back = heat_temperature(&run, "panel.back", 0);
  struct heat_budget side = heat_budget(&run, "panel", true);
  double to_bus = 2.0 * (back - heat_temperature(&run, "bus.+x.wall", 0));
  heat_close("flow", 2.0 / (0.001 / 167.0 + 0.02 / 0.03) * (front - back),
             side.emitted - side.absorbed + to_bus, 1e-5);
  /* half of the foam lies on each side of its node */
  double between = back + 0.01 / 0.03 / (0.001 / 167.0 + 0.02 / 0.03) * (front - back);
  double metal = back + 0.02 / 0.03 / (0.001 / 167.0 + 0.02 / 0.03) * (front - back);
  heat_close("core", heat_temperature(&run, "panel.core", 0), 0.5 * (between + metal), 1e-8);
  heat_release(&run);
}

static void refused(void **state)
{
  (void)state;
  static const char *const bad[][2] = {
      {"parts.panel.shell={honeycomb: {material: aluminium_bar, face_mm: 0.3, core_mm: 20, "
       "core_density_kg_m3: 32}}",
       "no material is called 'aluminium_bar'"},
      {"parts.panel.shell={honeycomb: {material: black, face_mm: 0.3, core_mm: 20, "
       "core_density_kg_m3: 32}}",
       "accepted: a material that has them"},
      {"parts.panel.shell={honeycomb: {material: aluminium_bare, face_mm: 0.3, core_mm: 20, "
       "core_density_kg_m3: 3200}}",
       "3200 is not below that of the foil, 2700"},
      {"parts.panel.shell={layers: [{thickness_mm: 1, density_kg_m3: 2700}]}",
       "layers.0: density, specific heat or conductivity is missing"},
      {"parts.panel.shell={layers: [{thickness_mm: 1, material: aluminium_bar}]}",
       "no material is called 'aluminium_bar'"},
      {"parts.panel.shell={thickness_mm: 2, layers: [{thickness_mm: 1, material: aluminium_bare}]}",
       "excludes layers"},
      {"parts.bus.shell={layers: [{thickness_mm: 1, material: aluminium_bare}]}",
       "whose back meets nothing"},
      {"parts.panel.shell={thickness_mm: 1, honeycomb: {" PANEL "}}", "excludes honeycomb"}};
  for (size_t k = 0; k < sizeof bad / sizeof bad[0]; k++) {
    char message[512];
    heat_refused(LIST(bad[k][0]), NONE, message, sizeof message);
    if (strstr(message, bad[k][1]) == NULL) fail_msg("'%s' lacks '%s'", message, bad[k][1]);
  }
}

/* A wall of 1 m2 faces in two layers holds one temperature the better, the better its pipes. */
static void pipes_even_out(void **state)
{
  (void)state;
  double before = 1e9;
  static const char *const pipe[] = {"parts.panel.shell.front_share=0.5",
                                     "parts.panel.groups={plate: {heat_pipe: 50}}",
                                     "parts.panel.groups={plate: {heat_pipe: 1e6}}"};
  for (int k = 0; k < 3; k++) {
    struct heat_run run = heat_compute(LIST(pipe[k]), NONE, NONE);
    double difference =
        heat_temperature(&run, "panel.front", 0) - heat_temperature(&run, "panel.back", 0);
    print_message("%g K between the sides\n", difference);
    assert_true(difference < before);
    before = difference;
    heat_release(&run);
  }
  assert_true(before > 0.0 && before < 0.01);
}

/* A paint that is known from 100 to 300 K is warmer in the Sun: a warning with part, group, range
 * and temperature, once for the material; an error where the scenario wants one. */
static char said[512];
static void hear(void *user, enum um_core_log_level level, const char *text)
{
  (void)user;
  if (level == UM_LOG_WARNING) snprintf(said, sizeof said, "%s", text);
}

static enum um_status run_with_range(const char *range, const char *outside)
{
  struct um_context *context = NULL;
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  const char *overrides[] = {"material_files=[model_range.yaml]", "parts.panel.front=paint",
                             outside};
  const struct um_model_options options = {.overrides = overrides, .noverride = 3};
  FILE *f = fopen("model_range.yaml", "w");
  assert_non_null(f);
  fprintf(f,
          "name: paint\nsummary: s\ncitation: c\n"
          "grey: {solar_absorptance: 0.9, emittance: 0.8}\n"
          "thermal: {temperature_range_K: %s}\n",
          range);
  fclose(f);
  said[0] = '\0';
  assert_int_equal(um_core_context_create(NULL, &context), UM_OK);
  um_core_log_set_sink(context, hear, NULL);
  enum um_status status = um_model_create(context, "model_panels.yaml", &options, &model);
  if (status == UM_OK) status = um_model_precompute(context, model, &tables);
  if (status == UM_OK) status = um_model_run(context, model, tables, &result);
  if (status != UM_OK) snprintf(said, sizeof said, "%s", um_core_message(context));
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
  um_core_context_destroy(&context);
  remove("model_range.yaml");
  return status;
}

static void records_hold_somewhere(void **state)
{
  (void)state;
  assert_int_equal(run_with_range("[100, 600]", "thermal.outside_range=error"), UM_OK);
  assert_int_equal(run_with_range("[100, 300]", "thermal.outside_range=warning"), UM_OK);
  assert_non_null(strstr(said, "part panel, group plate is at 3"));
  assert_non_null(strstr(said, "its material 'paint' is known from 100 to 300 K"));
  assert_int_equal(run_with_range("[100, 300]", "thermal.outside_range=error"), UM_ERR_NUMERIC);
  assert_non_null(strstr(said, "part panel, group plate is at 3"));
  assert_non_null(strstr(said, "thermal.outside_range: warning"));
  assert_int_equal(run_with_range("[400, 600]", "thermal.outside_range=error"), UM_ERR_NUMERIC);
  assert_int_equal(run_with_range("[300, 100]", "thermal.outside_range=error"), UM_ERR_INPUT);
  assert_non_null(strstr(said, "accepted: [coldest, hottest]"));
}

static int setup(void **state)
{
  (void)state;
  return heat_setup("model_panels.yaml");
}

static int teardown(void **state)
{
  (void)state;
  return heat_teardown();
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(panel_is_its_wall),
      cmocka_unit_test(core_conducts),
      cmocka_unit_test(layers_are_cells),
      cmocka_unit_test(blanket_has_seams),
      cmocka_unit_test(refused),
      cmocka_unit_test(pipes_even_out),
      cmocka_unit_test(records_hold_somewhere),
  };
  return cmocka_run_group_tests(tests, setup, teardown);
}
