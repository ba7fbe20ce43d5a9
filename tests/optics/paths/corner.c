/* Two unit plates that meet at a right angle: self-shadow and inter-reflection in closed form.
 *
 *        z
 *        |  wall: x = 0, faces +x
 *        |
 *        +------- x   floor: z = 0, faces +z
 */
#include <math.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "tests/optics/fixture.h"

#define FACTOR 0.200044 /* perpendicular unit squares, Howell C-14: docs/physics/exchange.md */

static const struct um_geometry_skin floor_skin = {NULL, "floor", "black"};
static const struct um_geometry_skin wall_skin = {NULL, "wall", "black"};

static void corner(struct fixture *f, double facet_size, size_t ntime)
{
  fixture_create(f);
  fixture_material(f, "floor", 0.4, 0.0, 0.0, 0.6);
  fixture_material(f, "wall", 0.7, 0.0, 0.0, 0.6);
  fixture_material(f, "black", 0.0, 0.0, 0.0, 1.0);
  struct um_geometry_part_spec parts[2];
  parts[0] = fixture_part("floor", UM_SHAPE_PLATE, &floor_skin);
  parts[0].position = um_vec3(0.5, 0.5, 0.0);
  parts[1] = fixture_part("wall", UM_SHAPE_PLATE, &wall_skin);
  parts[1].position = um_vec3(0.0, 0.5, 0.5);
  parts[1].rotation = um_core_quat_from_matrix(
      um_mat3_from_axes(um_vec3(0.0, 1.0, 0.0), um_vec3(0.0, 0.0, 1.0), um_vec3(1.0, 0.0, 0.0)));
  for (int i = 0; i < 2; i++) {
    parts[i].size[0] = parts[i].size[1] = 1.0;
    parts[i].facet_size = facet_size;
  }
  fixture_scene(f, parts, 2, ntime);
}

/* Sun behind the wall at zenith angle z, observer at the zenith: the wall's shadow covers tan z of
 * the floor, I = E rho cos z (1 - tan z)/pi. The Sun's disc blurs the edge symmetrically; its mean
 * changes by tan''/2 theta^2/4 = 1e-5. */
static void test_shadow(void **state)
{
  (void)state;
  struct fixture f;
  corner(&f, 0.25, 4);
  for (size_t t = 0; t < 4; t++) {
    double zenith = (10.0 + 10.0 * (double)t) * UM_DEG;
    f.samples[t].sun = um_vec3(-sin(zenith), 0.0, cos(zenith));
  }
  fixture_run(&f, 256, &fixture_vis, 1);
  double e = fixture_sun(&f, &fixture_vis);
  for (size_t t = 0; t < 4; t++) {
    double zenith = (10.0 + 10.0 * (double)t) * UM_DEG;
    fixture_within("shadowed floor [W/sr]", fixture_intensity(&f, t, 0, UM_MECHANISM_SUN),
                   e * 0.4 * cos(zenith) * (1.0 - tan(zenith)) / UM_PI, f.curve->stderr_[t], 0.02);
  }
  fixture_destroy(&f);
}

/* The same corner with Sun and observer exchanged: the part that is seen is now cut instead. */
static void test_shadow_reciprocity(void **state)
{
  (void)state;
  struct fixture f;
  corner(&f, 0.25, 2);
  struct um_vec3 slant = um_vec3(-sin(0.5), 0.0, cos(0.5));
  f.samples[0].sun = f.samples[1].to_observer = slant;
  fixture_run(&f, 256, &fixture_vis, 1);
  double there = fixture_intensity(&f, 0, 0, UM_MECHANISM_SUN);
  double back = fixture_intensity(&f, 1, 0, UM_MECHANISM_SUN);
  double error = hypot(f.curve->stderr_[0], f.curve->stderr_[1]);
  fixture_within("observer in the Sun's place [W/sr]", back, there, error, 0.05);
  fixture_destroy(&f);
}

/* Emission of each plate reflected by the other, both seen under 45 deg: each sends
 * (1 - eps) eps B F A cos 45 deg. */
static void test_emission_reflected(void **state)
{
  (void)state;
  struct fixture f;
  corner(&f, 0.5, 1);
  f.samples[0].to_observer = um_vec3(sqrt(0.5), 0.0, sqrt(0.5));
  f.scene.interreflection_samples = 2048;
  f.scene.interreflection_most = 1;
  fixture_run(&f, 4, &fixture_lwir, 1);
  double b = um_core_planck_band(8e-6, 12e-6, 300.0);
  fixture_within("emission of two plates, reflected once [W/sr]",
                 fixture_intensity(&f, 0, 0, UM_MECHANISM_INTERREFLECTED),
                 2.0 * 0.4 * 0.6 * b * FACTOR * sqrt(0.5), f.curve->stderr_[0], 0.05);
  fixture_close("  their own emission [W/sr]", fixture_intensity(&f, 0, 0, UM_MECHANISM_EMITTED),
                2.0 * 0.6 * b * sqrt(0.5), 2e-7);
  fixture_destroy(&f);
}

/* Sun straight on to the wall, edge-on to the floor, observer above the floor: floor radiance
 * rho_f rho_w E F / pi. */
static void test_sunlight_reflected(void **state)
{
  (void)state;
  struct fixture f;
  corner(&f, 0.5, 1);
  f.samples[0].sun = um_vec3(1.0, 0.0, 0.0);
  f.scene.interreflection_samples = 2048;
  f.scene.interreflection_most = 1;
  fixture_run(&f, 4, &fixture_vis, 1);
  double expected = 0.4 * 0.7 * fixture_sun(&f, &fixture_vis) * FACTOR / UM_PI;
  fixture_within("sunlit wall seen in the floor [W/sr]",
                 fixture_intensity(&f, 0, 0, UM_MECHANISM_INTERREFLECTED), expected,
                 f.curve->stderr_[0], 0.05);
  fixture_destroy(&f);
}

/* Observer behind the wall at tan = 0.5: the wall hides the near half of the floor, the strip
 * [0.5, 1] remains. A F of the strip to the wall = 0.2000438 - 0.5 * 0.2923734 (Howell C-14 for the
 * whole and the near half). */
static void test_hidden_share(void **state)
{
  (void)state;
  struct fixture f;
  corner(&f, 0.5, 1);
  f.samples[0].sun = um_vec3(1.0, 0.0, 0.0);
  f.samples[0].to_observer = um_vec3(-sin(atan(0.5)), 0.0, cos(atan(0.5)));
  f.scene.interreflection_samples = 2048;
  f.scene.interreflection_most = 1;
  fixture_run(&f, 64, &fixture_vis, 1);
  double expected = 0.4 * 0.7 * fixture_sun(&f, &fixture_vis) * 0.0538571 / UM_PI * cos(atan(0.5));
  fixture_within("half-hidden floor [W/sr]",
                 fixture_intensity(&f, 0, 0, UM_MECHANISM_INTERREFLECTED), expected,
                 f.curve->stderr_[0], 0.1);
  fixture_destroy(&f);
}

/* A convex body has nothing to inter-reflect: exactly zero, and no error. */
static void test_convex(void **state)
{
  (void)state;
  static const struct um_geometry_skin skin = {NULL, "grey", NULL};
  struct fixture f;
  fixture_create(&f);
  fixture_material(&f, "grey", 0.4, 0.0, 0.0, 0.6);
  struct um_geometry_part_spec box = fixture_part("box", UM_SHAPE_BOX, &skin);
  box.size[0] = box.size[1] = box.size[2] = 1.0;
  fixture_scene(&f, &box, 1, 1);
  f.samples[0].to_observer = um_vec3(0.6, 0.0, 0.8);
  f.scene.interreflection_samples = 64;
  const struct um_optics_band bands[] = {fixture_vis, fixture_lwir};
  fixture_run(&f, 16, bands, 2);
  for (size_t k = 0; k < 2; k++) {
    assert_true(fixture_intensity(&f, 0, k, UM_MECHANISM_INTERREFLECTED) == 0.0);
    assert_true(f.curve->stderr_[k] == 0.0);
  }
  fixture_destroy(&f);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_shadow),
      cmocka_unit_test(test_shadow_reciprocity),
      cmocka_unit_test(test_emission_reflected),
      cmocka_unit_test(test_sunlight_reflected),
      cmocka_unit_test(test_hidden_share),
      cmocka_unit_test(test_convex),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
