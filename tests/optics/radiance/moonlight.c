/* The Moon as the second lamp: what the Sun's machinery does with the Sun it does with the Moon. */
#include <math.h>
#include <stdlib.h>

#include "base/core/constants.h"
#include "optics/lightcurve/adapt.h"
#include "tests/optics/fixture.h"

static const struct um_geometry_skin grey = {NULL, "grey", "grey"};

/* The Moon in place of the Sun of a sample: in its direction and of its apparent size, while the
 * Sun stands elsewhere and does not shine. */
static void exchange_lamps(struct um_environment_sample *s, struct um_vec3 sun)
{
  s->moon = s->sun;
  s->moon_distance = UM_LUNAR_RADIUS * s->sun_distance / UM_SOLAR_RADIUS;
  s->sun = sun;
  s->sunlit_fraction = 0.0;
}

/* A full Moon overhead of a Lambert plate of 6 m^2 and reflectance 0.2, 384400 km from the
 * satellite and 5 deg from opposition: a 445000th of the Sun's light at 0.55 um (the reflectance of
 * tests/environment/moonlight.c, times (R/d)^2), I = E a A cos_i cos_o / pi. */
static void a_plate_under_the_full_moon(void **state)
{
  (void)state;
  struct fixture f;
  fixture_create(&f);
  fixture_material(&f, "grey", 0.2, 0.0, 0.0, 0.8);
  struct um_geometry_part_spec plate = fixture_part("plate", UM_SHAPE_PLATE, &grey);
  plate.size[0] = 2.0;
  plate.size[1] = 3.0;
  fixture_scene(&f, &plate, 1, 3);
  struct um_optics_band green = {"green", 0.549e-6, 0.551e-6, 1, NULL};
  for (size_t t = 0; t < 3; t++) {
    struct um_environment_sample *s = &f.samples[t];
    s->moon = um_vec3(sin(0.3), 0.0, cos(0.3));
    s->moon_distance = 384400e3;
    s->sun = um_vec3(-sin(0.3 - 5.0 * UM_DEG), 0.0, -cos(0.3 - 5.0 * UM_DEG));
    s->sunlit_fraction = 0.0;
    s->to_observer = um_vec3(0.0, -sin(0.5), cos(0.5));
  }
  f.samples[1].moon = um_vec3(sin(2.0), 0.0, cos(2.0)); /* behind the plate */
  f.samples[2].moon = um_vec3(0.0, 0.0, 0.0);
  f.samples[2].moon_distance = 0.0;
  fixture_run(&f, 1, &green, 1);
  double full = fixture_sun(&f, &green) * 0.2 * 6.0 / UM_PI * cos(0.3) * cos(0.5);
  fixture_close("Lambert plate under the full Moon [W/sr]",
                fixture_intensity(&f, 0, 0, UM_MECHANISM_OTHER),
                full / 445000.0 / (1.00257 * 1.00257), 1e-3); /* 1.00257 au from the Sun */
  for (size_t t = 0; t < 3; t++) {
    assert_true(fixture_intensity(&f, t, 0, UM_MECHANISM_SUN) == 0.0);
    assert_true(t == 0 || fixture_intensity(&f, t, 0, UM_MECHANISM_OTHER) == 0.0);
  }
  assert_int_equal(f.view->moon.nrow, 2);
  fixture_destroy(&f);
}

/* A box and a plate, with lobes, that shadow each other: under a Moon of the Sun's size where the
 * Sun stood, all is what it was in sunlight times E_moon/E_sun, wavelength by wavelength, and so is
 * its standard error by band; rounding apart, for the rays are the same. */
static void moonlight_is_sunlight_of_another_colour(void **state)
{
  (void)state;
  for (uint64_t c = 0; c < 6; c++) {
    struct fixture f;
    fixture_pair(&f, c, 1.2, 2);
    for (size_t t = 0; t < 2; t++) {
      f.samples[t].sun = fixture_direction(c, 30);
      f.samples[t].to_observer = fixture_direction(c, 40);
    }
    f.environment.shadow = UM_SHADOW_NONE;
    exchange_lamps(&f.samples[1], fixture_direction(c, 50));
    struct um_optics_band narrow = {"narrow", 0.5499e-6, 0.5501e-6, 1, NULL};
    const struct um_optics_band bands[] = {narrow, fixture_vis};
    fixture_run(&f, 64, bands, 2);
    struct um_environment_moonlight light;
    um_environment_moonlight(&f.environment, &f.samples[1], &light);
    const struct um_optics_lightcurve *curve = f.curve;
    for (size_t b = 0; b < curve->nbin; b++) {
      const double *sun = curve->spectral + b * UM_MECHANISM_COUNT;
      const double *moon = sun + curve->nbin * UM_MECHANISM_COUNT;
      double expected =
          sun[UM_MECHANISM_SUN] * um_environment_moonlight_at(&light, curve->wavelength[b]);
      double error = fabs(moon[UM_MECHANISM_OTHER] - expected);
      if (!(error <= 1e-12 * expected)) fail_msg("scene %d, bin %zu: off by %g", (int)c, b, error);
      assert_true(moon[UM_MECHANISM_SUN] == 0.0 && sun[UM_MECHANISM_OTHER] == 0.0);
      for (int m = UM_MECHANISM_EARTH; m < UM_MECHANISM_OTHER; m++) assert_true(moon[m] == sun[m]);
    }
    double in_sun = fixture_intensity(&f, 0, 0, UM_MECHANISM_SUN),
           ratio = curve->stderr_[0] / in_sun;
    if (in_sun > 0.0 && ratio > 1e-9)
      fixture_close("its relative error",
                    curve->stderr_[2] / fixture_intensity(&f, 1, 0, UM_MECHANISM_OTHER), ratio,
                    1e-9);
    fixture_destroy(&f);
  }
}

/* Where both shine, as in the penumbra, each gives what it gives alone; paths between surfaces do
 * not know the Moon. */
static void both_at_once_are_their_sum(void **state)
{
  (void)state;
  double of[3][UM_MECHANISM_COUNT];
  struct fixture f;
  fixture_pair(&f, 3, 1.2, 1);
  struct um_environment_sample *s = f.samples;
  f.environment.shadow = UM_SHADOW_NONE;
  s->sun = fixture_direction(3, 30);
  s->to_observer = fixture_direction(3, 40);
  s->moon = fixture_direction(3, 60);
  f.scene.interreflection_samples = 8;
  for (int i = 0; i < 3; i++) {
    s->moon_distance = i == 2 ? 0.0 : 4e8;
    s->sunlit_fraction = i == 1 ? 0.0 : 0.01;
    fixture_run(&f, 16, &fixture_vis, 1);
    for (int m = 0; m < UM_MECHANISM_COUNT; m++)
      of[i][m] = fixture_intensity(&f, 0, 0, (enum um_optics_mechanism)m);
  }
  assert_true(of[0][UM_MECHANISM_OTHER] > 0.0 && of[2][UM_MECHANISM_OTHER] == 0.0);
  assert_true(of[0][UM_MECHANISM_OTHER] == of[1][UM_MECHANISM_OTHER]);
  assert_true(of[0][UM_MECHANISM_SUN] > 0.0 && of[0][UM_MECHANISM_INTERREFLECTED] > 0.0);
  for (int m = 0; m < UM_MECHANISM_OTHER; m++) assert_true(of[0][m] == of[2][m]);
  fixture_destroy(&f);
}

/* An instant that only the Moon lights gets the points that its error asks for, as others do. */
static void dim_instants_are_adapted_too(void **state)
{
  (void)state;
  struct fixture f;
  fixture_pair(&f, 4, 1.2, 2);
  f.environment.shadow = UM_SHADOW_NONE;
  for (size_t t = 0; t < 2; t++) {
    f.samples[t].sun = fixture_direction(4, 30);
    f.samples[t].to_observer = fixture_direction(4, 40);
  }
  exchange_lamps(&f.samples[1], fixture_direction(4, 50));
  const struct um_optics_band narrow = {"narrow", 0.5499e-6, 0.5501e-6, 1, NULL};
  struct um_optics_adaptation did;
  fixture_run(&f, 16, &narrow, 1);
  FIXTURE_OK(&f, um_optics_adapt(f.context, &f.scene, &narrow, 1, 5e-4, f.view, &did));
  print_message("%d points in sunlight, %d in moonlight\n", f.view->nsample[0], f.view->nsample[1]);
  assert_true(f.view->nsample[0] > 16);
  assert_int_equal(f.view->nsample[0], f.view->nsample[1]);
  fixture_destroy(&f);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(a_plate_under_the_full_moon),
      cmocka_unit_test(moonlight_is_sunlight_of_another_colour),
      cmocka_unit_test(both_at_once_are_their_sum),
      cmocka_unit_test(dim_instants_are_adapted_too),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
