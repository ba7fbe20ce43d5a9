/* Light of the Earth: D.5 of the physics notes. */
#include <math.h>

#include "core/constants.h"
#include "fixture.h"

static const struct um_geometry_skin skin = {NULL, "grey", "grey"};

/* Nadir face at 765 km (F 0.797, T_b 270 K): reflected Earth over own emission in 8-12 um. The
 * ratios follow from (1 - eps) F L(270 K) / (eps L(T)); tolerance: half a digit of the printed
 * ratio and of the printed F. */
static void test_reflected_ratio(void **state)
{
  (void)state;
  const double emissivity[] = {0.78, 0.62, 0.85, 0.05, 0.80};
  const double kelvin[] = {240.0, 240.0, 210.0, 280.0, 260.0};
  const double ratio[] = {0.44, 0.96, 0.65, 12.5, 0.25};
  const double half_digit[] = {0.005, 0.005, 0.005, 0.05, 0.005};
  for (size_t k = 0; k < 5; k++) {
    struct fixture f;
    fixture_create(&f);
    fixture_material(&f, "grey", 0.1, 0.0, 0.0, emissivity[k]);
    struct um_geometry_part_spec plate = fixture_part("plate", UM_SHAPE_PLATE, &skin);
    plate.size[0] = plate.size[1] = 1.0;
    fixture_scene(&f, &plate, 1, 1);
    f.environment.brightness_temperature = 270.0;
    size_t n = um_geometry_mesh(f.geometry)->nsurface;
    for (size_t i = 0; i < n; i++) {
      f.temperature[i] = kelvin[k];
      f.view_factor[i] = 0.797F;
    }
    fixture_run(&f, 1, &fixture_lwir, 1);
    double reflected = fixture_intensity(&f, 0, 0, UM_MECHANISM_EARTH);
    fixture_close("reflected Earth / emitted",
                  reflected / fixture_intensity(&f, 0, 0, UM_MECHANISM_EMITTED), ratio[k],
                  half_digit[k] / ratio[k] + 0.0005 / 0.797);
    /* band radiances of D.5: L(270 K) = 22.3839 */
    fixture_close("  reflected [W/sr]", reflected, (1.0 - emissivity[k]) * 0.797 * 22.3839, 4e-6);
    f.environment.earth_reflection_on = false;
    fixture_run(&f, 1, &fixture_lwir, 1);
    assert_true(fixture_intensity(&f, 0, 0, UM_MECHANISM_EARTH) == 0.0);
    fixture_destroy(&f);
  }
}

/* Earthshine: a flux of 0.2366 E_sun (nadir plate over the sub-solar point, D.5), spread like
 * sunlight, reflected by rho_d: rho_d 0.2366 E_band / pi per area. */
static void test_earthshine(void **state)
{
  (void)state;
  struct fixture f;
  fixture_create(&f);
  fixture_material(&f, "grey", 0.2, 0.5, 0.1, 0.8);
  struct um_geometry_part_spec plate = fixture_part("plate", UM_SHAPE_PLATE, &skin);
  plate.size[0] = plate.size[1] = 1.0;
  fixture_scene(&f, &plate, 1, 1);
  size_t n = um_geometry_mesh(f.geometry)->nsurface;
  for (size_t i = 0; i < n; i++) f.albedo[i] = (float)(0.2366 * 1361.0);
  f.samples[0].sunlit_fraction = 0.0; /* the lit Earth is still there */
  fixture_run(&f, 1, &fixture_vis, 1);
  fixture_close("earthshine [W/sr]", fixture_intensity(&f, 0, 0, UM_MECHANISM_EARTH),
                0.2 * 0.2366 * fixture_sun(&f, &fixture_vis) / UM_PI, 1e-7);
  f.environment.earthshine_on = false;
  fixture_run(&f, 1, &fixture_vis, 1);
  assert_true(fixture_intensity(&f, 0, 0, UM_MECHANISM_EARTH) < 1e-20);
  fixture_destroy(&f);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_reflected_ratio),
      cmocka_unit_test(test_earthshine),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
