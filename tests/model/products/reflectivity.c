/* Reflectivity maps of bodies with closed forms (docs/physics/reflectivity-map.md), and looking up:
 *
 *   gamma 0:  M(p) = sum A cos^2 f V;  Lambert, f = rho/pi; sphere 2 rho R^2/3 everywhere; at gamma
 *             times [sin g + (pi - g) cos g]/pi
 *   a glossy plate at its normal: M = A (rho/pi + F D(0)/4), D(0) = 1/(pi alpha'^2), the Sun's disc
 *             widening alpha'^2 = alpha^2 + theta^2/8 (materials/lobe_beckmann.c) */
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/model/products/map_help.h"
#include "tests/support/with_context.h"

static struct um_model_map *map_of(const struct um_model *model, double step, const double *degrees,
                                   size_t nphase, size_t nplane)
{
  double phase[8];
  struct um_model_map *map = NULL;
  for (size_t i = 0; i < nphase; i++) phase[i] = degrees[i] * UM_DEG;
  struct um_model_map_grid grid = {step * UM_DEG, phase, nphase, nplane, 0.0};
  if (um_model_map_create(context, model, &grid, &map) != UM_OK)
    fail_msg("%s", um_core_message(context));
  return map;
}

/* The same at every node. Facets of 0.1 m leave up to 2e-4 in the rms over directions
 * (tests/optics/lightcurve/lightcurve.c), five times that at single nodes. */
static void sphere_is_constant(void **state)
{
  (void)state;
  static const double degrees[] = {0.0, 40.0, 90.0};
  struct um_model *model = map_model(
      context,
      "  - {name: s, sphere: {radius_m: 1}, outside: lambert, facet_size_m: 0.1, " MAP_SHELL "}\n",
      NULL);
  struct um_model_map *map = map_of(model, 30.0, degrees, 3, 2);
  for (size_t g = 0; g < 3; g++) {
    double angle = map->phase_angle[g];
    double expected = 2.0 / 3.0 * 0.2 * (sin(angle) + (UM_PI - angle) * cos(angle)) / UM_PI;
    for (size_t i = 0; i < map->nlatitude; i++)
      for (size_t j = 0; j < map->nlongitude; j++)
        for (size_t b = 0; b < 2; b++) {
          struct um_model_map_node node = um_model_map_node(map, g, i, j, b);
          assert_close(node.mean / expected, 1.0, 1e-3);
          assert_true(node.spread <= 1e-3 * expected && node.error == 0.0);
        }
  }
  um_model_map_destroy(context, &map);
  um_model_destroy(context, &model);
}

#define BOX "  - {name: b, box: {size_m: [1, 2, 3]}, outside: lambert, " MAP_SHELL "}\n"

/* Sum over the faces of a box, rho = 0.2. */
static double box(struct um_vec3 sun, struct um_vec3 observer)
{
  static const double area[] = {6.0, 3.0, 2.0};
  double s[] = {sun.x, sun.y, sun.z}, o[] = {observer.x, observer.y, observer.z}, sum = 0.0;
  for (int k = 0; k < 3; k++) {
    sum += area[k] * fmax(s[k], 0.0) * fmax(o[k], 0.0);
    sum += area[k] * fmax(-s[k], 0.0) * fmax(-o[k], 0.0);
  }
  return 0.2 / UM_PI * sum;
}

/* Cosines are kept as float: 6e-8 each. */
static void box_is_its_faces(void **state)
{
  (void)state;
  static const double degrees[] = {0.0, 75.0};
  struct um_model *model = map_model(context, BOX, NULL);
  struct um_model_map *map = map_of(model, 10.0, degrees, 2, 3);
  for (size_t g = 0; g < 2; g++)
    for (size_t k = 0; k < map->nplane[g]; k++)
      for (size_t i = 0; i < map->nlatitude; i++)
        for (size_t j = 0; j < map->nlongitude; j++) {
          struct um_vec3 sun, observer;
          double found[2];
          struct um_model_phase_vector at = {
              (-90.0 + 10.0 * (double)i) * UM_DEG, (-180.0 + 10.0 * (double)j) * UM_DEG,
              map->phase_angle[g], UM_PI * (double)k / (double)map->nplane[g]};
          um_model_phase_directions(&at, &sun, &observer);
          um_model_map_look_up(map, &at, found);
          assert_close(found[0], box(sun, observer), 1e-6);
          at.plane += UM_PI; /* Sun and observer exchanged */
          um_model_map_look_up(map, &at, found);
          assert_close(found[1], box(sun, observer), 1e-6);
        }
  um_model_map_destroy(context, &map);
  um_model_destroy(context, &model);
}

/* A plate whose normal stands at latitude 30, longitude -60: its map is largest there, at every
 * phase angle, with the value of the closed form at gamma 0. */
static void glint_lies_at_the_normal(void **state)
{
  (void)state;
  static const double degrees[] = {0.0, 50.0};
  struct um_model *model = map_model(
      context,
      "  - {name: p, plate: {size_m: [2, 1]}, front: glossy, back: lambert, pose: {rotation_deg: "
      "[0, 60, -60]}, " MAP_SHELL "}\n",
      NULL);
  struct um_model_map *map = map_of(model, 5.0, degrees, 2, 2);
  double theta = asin(UM_SOLAR_RADIUS / UM_AU), alpha2 = 0.05 * 0.05 + theta * theta / 8.0;
  double expected = 2.0 * (0.2 / UM_PI + 0.6 / (4.0 * UM_PI * alpha2));
  for (size_t g = 0; g < 2; g++) {
    double largest = 0.0;
    size_t at[2] = {0, 0};
    for (size_t i = 0; i < map->nlatitude; i++)
      for (size_t j = 0; j < map->nlongitude; j++) {
        double value = um_model_map_node(map, g, i, j, 0).mean;
        if (!(value > largest)) continue;
        largest = value;
        at[0] = i;
        at[1] = j;
      }
    assert_close(-90.0 + 5.0 * (double)at[0], 30.0, 1e-9);
    assert_close(-180.0 + 5.0 * (double)at[1], -60.0, 1e-9);
    if (g == 0) assert_close(largest / expected, 1.0, 1e-5);
  }
  um_model_map_destroy(context, &map);
  um_model_destroy(context, &model);
}

/* Places all over the sphere, none a node, some within a step of a pole. */
static struct um_model_phase_vector place(size_t i, size_t n)
{
  double z = 1.0 - 2.0 * ((double)i + 0.5) / (double)n;
  return (struct um_model_phase_vector){asin(z), remainder(2.4 * (double)i, 2.0 * UM_PI), 0.0, 0.0};
}

/* Loop: what is looked up at gamma 0 is what the box gives there. max(cos,0)^2 has second
 * derivatives of 2 at most, so linear interpolation in two steps of h errs by h^2/2 sum A rho/pi at
 * most. */
static void loop_closes_without_phase_angle(void **state)
{
  (void)state;
  static const double degrees[] = {0.0};
  struct um_model *model = map_model(context, BOX, NULL);
  double bound = 0.5 * 11.0 * 0.2 / UM_PI;
  for (double step = 5.0; step >= 2.5; step *= 0.5) {
    struct um_model_map *map = map_of(model, step, degrees, 1, 1);
    double largest = 0.0, h = step * UM_DEG;
    for (size_t i = 0; i < 997; i++) {
      struct um_model_phase_vector at = place(i, 997);
      struct um_vec3 sun, observer;
      double found[2];
      um_model_phase_directions(&at, &sun, &observer);
      um_model_map_look_up(map, &at, found);
      largest = fmax(largest, fabs(found[0] - box(sun, observer)));
    }
    print_message("step %g deg: %.3g m2/sr off at most, bound %.3g\n", step, largest,
                  bound * h * h);
    assert_true(largest <= bound * h * h);
    um_model_map_destroy(context, &map);
  }
  um_model_destroy(context, &model);
}

/* At a pole every meridian says the same of one pair of directions: 30 deg east with the plane at
 * 30 deg is 0 deg with 0, a node of this map, which look-up then gives exactly. */
static void pole_is_one_place(void **state)
{
  (void)state;
  static const double degrees[] = {60.0};
  struct um_model *model =
      map_model(context,
                "  - {name: p, plate: {size_m: [2, 1]}, front: lambert, back: lambert, pose: "
                "{rotation_deg: [40, 30, 0]}, " MAP_SHELL "}\n",
                NULL);
  struct um_model_map *map = map_of(model, 90.0, degrees, 1, 4);
  for (int south = 0; south < 2; south++) {
    double sign = south ? -1.0 : 1.0, found[2], direct[2], error[2];
    struct um_model_phase_vector at = {sign * 0.5 * UM_PI, 30.0 * UM_DEG, 60.0 * UM_DEG,
                                       sign * 30.0 * UM_DEG};
    struct um_vec3 sun, observer;
    um_model_phase_directions(&at, &sun, &observer);
    um_model_map_look_up(map, &at, found);
    assert_int_equal(
        um_model_reflectivity(context, model, "test", &sun, &observer, 1, direct, error), UM_OK);
    assert_true(direct[0] > 0.0);
    assert_close(found[0] / direct[0], 1.0, 1e-6);
  }
  um_model_map_destroy(context, &map);
  um_model_destroy(context, &model);
}

/* At a phase angle: rms over places and planes, of the mean. The error is of second order in the
 * steps but for the lines where cos_i or cos_o is clipped: it falls at least by half with half the
 * steps. A map at gamma 0 alone shows another
 * body: its error is what the look-up of one map costs. */
static void loop_with_phase_angle(void **state)
{
  (void)state;
  static const double coarse[] = {0.0, 60.0, 120.0}, fine[] = {0.0, 30.0, 60.0, 90.0, 120.0};
  struct um_model *model = map_model(context, BOX, NULL);
  double rms[3] = {0.0, 0.0, 0.0}, mean = 0.0;
  struct um_model_map *map[] = {map_of(model, 15.0, coarse, 3, 4), map_of(model, 7.5, fine, 5, 8),
                                map_of(model, 7.5, coarse, 1, 1)};
  size_t n = 997;
  for (size_t i = 0; i < n; i++) {
    struct um_model_phase_vector at = place(i, n);
    struct um_vec3 sun, observer;
    double found[2];
    at.phase_angle = (45.0 + 1e-3 * (double)i) * UM_DEG;
    at.plane = remainder(1.7 * (double)i, UM_PI) + UM_PI;
    um_model_phase_directions(&at, &sun, &observer);
    double true_value = box(sun, observer);
    mean += true_value / (double)n;
    for (size_t k = 0; k < 3; k++) {
      um_model_map_look_up(map[k], &at, found);
      rms[k] += (found[0] - true_value) * (found[0] - true_value) / (double)n;
    }
  }
  for (size_t k = 0; k < 3; k++) rms[k] = sqrt(rms[k]) / mean;
  print_message("rms over the mean: coarse %.4f, fine %.4f, at 0 deg alone %.4f\n", rms[0], rms[1],
                rms[2]);
  assert_true(rms[1] <= 0.5 * rms[0] && rms[2] > 5.0 * rms[1]);
  for (size_t k = 0; k < 3; k++) um_model_map_destroy(context, &map[k]);
  um_model_destroy(context, &model);
}

/* Directions and sunlight of a pass are those of the whole simulation: a box and a plate that
 * shades it, spinning, through the shadow's edge with its air. The same rays, so nearly the same
 * digits; the lines of sight of both are floats. */
static void pass_is_the_simulation(void **state)
{
  (void)state;
  static const double degrees[] = {0.0};
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  struct um_model_map_pass *pass = NULL;
  struct um_model *model = map_model(
      context,
      BOX "  - {name: p, plate: {size_m: [4, 2]}, front: glossy, back: lambert, pose: "
          "{position_m: [3, 0, 0]}, " MAP_SHELL "}\n",
      "{spin: {axis_gcrs: [1, 2, 3], axis_body: [0, 1, 1], period_s: 700, phase_deg: 40}}");
  struct um_model_map *map = map_of(model, 90.0, degrees, 1, 1);
  assert_int_equal(um_model_map_pass_create(context, model, map, &pass), UM_OK);
  assert_int_equal(um_model_precompute(context, model, &tables), UM_OK);
  assert_int_equal(um_model_run(context, model, tables, &result), UM_OK);
  assert_int_equal(pass->n, result->nobs);
  size_t edge = 0, dark = 0;
  for (size_t k = 0; k < pass->n; k++)
    for (size_t b = 0; b < 2; b++) {
      double expected = um_model_result_intensity(result, k, b, UM_MECHANISM_SUN);
      double light = pass->light[k * 2 + b];
      assert_close(light * pass->direct[k * 2 + b], expected, 1e-6 * expected);
      double sunlit = pass->sample[k].sunlit_fraction;
      edge += sunlit > 0.0 && sunlit < 1.0;
      dark += light == 0.0;
    }
  assert_true(edge > 0 && dark > 10 && dark < pass->n);
  um_model_map_pass_destroy(context, &pass);
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_model_map_destroy(context, &map);
  um_model_destroy(context, &model);
}

static void refused(void **state)
{
  (void)state;
  static const double falling[] = {1.0, 0.5};
  static const struct {
    struct um_model_map_grid grid;
    const char *words;
  } bad[] = {{{0.3, falling, 1, 1, 0.0}, "accepted: 90 deg or a part of it"},
             {{0.25 * UM_PI, falling, 0, 1, 0.0}, "accepted: one of each or more"},
             {{0.25 * UM_PI, falling, 2, 1, 0.0}, "accepted: from 0 to below 180, ascending"},
             {{UM_PI / 36000.0, falling, 1, 1, 0.0}, "accepted: up to 2e+07"}};
  struct um_model *model = map_model(context, BOX, NULL);
  for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
    struct um_model_map *map = NULL;
    um_core_message_clear(context);
    assert_int_equal(um_model_map_create(context, model, &bad[i].grid, &map), UM_ERR_INPUT);
    if (strstr(um_core_message(context), bad[i].words) == NULL)
      fail_msg("'%s' lacks '%s'", um_core_message(context), bad[i].words);
    assert_null(map);
  }
  um_model_destroy(context, &model);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(sphere_is_constant, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(box_is_its_faces, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(glint_lies_at_the_normal, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(loop_closes_without_phase_angle, context_set_up,
                                      context_tear_down),
      cmocka_unit_test_setup_teardown(pole_is_one_place, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(loop_with_phase_angle, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(pass_is_the_simulation, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(refused, context_set_up, context_tear_down)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
