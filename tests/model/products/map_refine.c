/* Cells of a map are refined where lobes are narrow. A box turned off the axes, a glossy lobe of
 * 2.9 deg on its sides: on a grid of 9 deg the glints stand between the nodes. The renderer at
 * places of the test's own says what looking up should have said, and holds what the map states of
 * its own error. */
#include "model/products/map_error.h"
#include "tests/model/products/map_help.h"
#include "tests/support/with_context.h"

#define STEP  (9.0 * UM_DEG)
#define TURNS "pose: {rotation_deg: [17, 23, 31]}"

static struct um_model *glossy(void)
{
  return map_model(
      context,
      "  - {name: b, box: {size_m: [1, 2, 3]}, outside: glossy, " TURNS ", " MAP_SHELL "}\n", NULL);
}

static struct um_model_map *map_to(const struct um_model *model, double tolerance)
{
  static const double degrees[] = {0.0, 40.0, 80.0};
  double phase[3];
  struct um_model_map *map = NULL;
  for (size_t i = 0; i < 3; i++) phase[i] = degrees[i] * UM_DEG;
  struct um_model_map_grid grid = {STEP, phase, 3, 4, tolerance};
  if (um_model_map_create(context, model, &grid, &map) != UM_OK)
    fail_msg("%s", um_core_message(context));
  return map;
}

#define PLACES 2000

/* rms of looking up less computed: over the mean of what is computed, and over its own rms, at
 * places about the six normals as far as 6 deg: golden-angle spirals about each. */
struct off {
  double of_mean, of_rms;
};

static struct off off_of(const struct um_model *model, const struct um_model_map *map)
{
  static struct um_vec3 sun[PLACES], observer[PLACES];
  static struct um_model_phase_vector at[PLACES];
  static double computed[2 * PLACES];
  double squares = 0.0, mean = 0.0, all = 0.0;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  struct um_geometry_pose *pose = NULL;
  assert_int_equal(um_geometry_pose_create(context, model->geometry, NULL, &pose), UM_OK);
  for (size_t i = 0; i < PLACES; i++) {
    struct um_vec3 n = um_geometry_surface_normal(mesh, pose, 2 * (i % 6)), across[2];
    double away = tan(6.0 * UM_DEG) * sqrt(((double)(i / 6) + 0.5) / (PLACES / 6.0 + 1.0));
    double angle = 2.399963 * (double)(i / 6);
    um_core_vec3_frame(n, &across[0], &across[1]);
    n = um_vec3_axpy(um_vec3_axpy(n, away * cos(angle), across[0]), away * sin(angle), across[1]);
    n = um_vec3_unit(n);
    at[i] = (struct um_model_phase_vector){asin(n.z), atan2(n.y, n.x),
                                           80.0 * UM_DEG * fmod(0.618034 * (double)i, 1.0),
                                           2.0 * UM_PI * fmod(0.754878 * (double)i, 1.0)};
    um_model_phase_directions(&at[i], &sun[i], &observer[i]);
  }
  um_geometry_pose_destroy(context, &pose);
  assert_int_equal(
      um_model_reflectivity(context, model, "test", sun, observer, PLACES, computed, NULL), UM_OK);
  for (size_t i = 0; i < PLACES; i++) {
    double found[2];
    um_model_map_look_up(map, &at[i], found);
    squares += (found[0] - computed[2 * i]) * (found[0] - computed[2 * i]) / PLACES;
    mean += computed[2 * i] / PLACES;
    all += computed[2 * i] * computed[2 * i] / PLACES;
  }
  return (struct off){sqrt(squares) / mean, sqrt(squares / all)};
}

static double stated(const struct um_model *model, const struct um_model_map *map)
{
  struct um_model_map_error *error = NULL;
  assert_int_equal(um_model_map_error_measure(context, model, map, &error), UM_OK);
  const struct um_model_map_off *off = &error->off[(size_t)UM_MAP_AT_NORMALS * map->nband];
  double rms = off->rms / off->mean;
  assert_true(error->n[UM_MAP_AT_NORMALS] > 0 && error->n[UM_MAP_EVERYWHERE] > 0);
  assert_true(off->largest >= off->rms && off->at.phase_angle <= 80.0 * UM_DEG);
  um_model_map_error_destroy(context, &error);
  return rms;
}

/* The tolerance is of single places; the rms of all is within it, the grid alone is off by more
 * than half of the light. What is stated is drawn from 5 deg about normals, and from other places:
 * within a half of what the test finds. */
static void lobes_between_nodes(void **state)
{
  (void)state;
  struct um_model *model = glossy();
  double own[2];
  struct off off[2];
  size_t nodes[2];
  for (int refined = 0; refined < 2; refined++) {
    struct um_model_map *map = map_to(model, refined ? 0.1 : 0.0);
    off[refined] = off_of(model, map);
    own[refined] = stated(model, map);
    nodes[refined] = map->nnode;
    assert_true((map->cell != NULL) == (refined == 1));
    assert_int_equal(map->unfinished, 0);
    print_message("%zu nodes: rms %.4f of the mean, stated %.4f; %.4f of the rms\n", map->nnode,
                  off[refined].of_mean, own[refined], off[refined].of_rms);
    um_model_map_destroy(context, &map);
  }
  assert_true(off[0].of_rms > 0.5 && off[1].of_rms < 0.1);
  assert_true(nodes[1] > nodes[0] && nodes[1] < 8 * nodes[0]);
  for (int k = 0; k < 2; k++) assert_true(fabs(log(own[k] / off[k].of_mean)) < log(1.5));
  um_model_destroy(context, &model);
}

/* A finer tolerance: smaller error, more nodes. A mean over directions that the grid alone gets
 * wrong by its glints on nodes: a box along the axes has its normals there. Over all directions at
 * gamma 0 a glossy face of area A sends, with the lobe's D normalised, integral of D cos over the
 * sphere = 1: A (rho/pi 2 pi/3 + F/4) / (4 pi), but for D's width. */
static void mean_of_glints_on_nodes(void **state)
{
  (void)state;
  static const double zero[] = {0.0};
  struct um_model *model = map_model(
      context, "  - {name: b, box: {size_m: [1, 2, 3]}, outside: glossy, " MAP_SHELL "}\n", NULL);
  double expected = 22.0 * (0.2 * 2.0 / 3.0 + 0.6 / 4.0) / (4.0 * UM_PI), mean[3];
  static const double tolerance[] = {0.0, 0.2, 0.02};
  size_t nodes[3];
  for (int i = 0; i < 3; i++) {
    struct um_model_map_grid grid = {STEP, zero, 1, 1, tolerance[i]};
    struct um_model_map *map = NULL;
    assert_int_equal(um_model_map_create(context, model, &grid, &map), UM_OK);
    mean[i] = um_model_map_mean(map, 0, 0) / expected;
    nodes[i] = map->nnode;
    print_message("tolerance %g: %zu nodes, mean over the closed form %.4f\n", tolerance[i],
                  map->nnode, mean[i]);
    um_model_map_destroy(context, &map);
  }
  assert_true(mean[0] > 2.0);
  assert_close(mean[1], 1.0, 0.05);
  assert_close(mean[2], 1.0, 0.01);
  assert_true(nodes[2] > nodes[1]);
  um_model_destroy(context, &model);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(lobes_between_nodes, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(mean_of_glints_on_nodes, context_set_up, context_tear_down)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
