/* What the renderer reflects of sunlight, over all observers, is what the heat network does not
 * absorb: one record for both. */
#include <math.h>

#include "base/core/constants.h"
#include "tests/optics/fixture.h"

static const struct um_geometry_skin skin = {NULL, "metal", "metal"};

#define COSINES  24
#define AZIMUTHS 48

/* A plate of a rough metal under sunlight at an angle, seen from COSINES x AZIMUTHS directions of
 * equal projected solid angle: pi times the mean of the radiance is what is reflected. Aluminium
 * and copper at 0.6 um (index 1.3 + 7.4i, 0.2 + 3.1i, Rakic 1995 rounded). Midpoints hold 2e-3 for
 * these lobes; what facets pass on to each other is 0.05 to 0.12 of the light (1 - E of the lobe).
 */
static void test_reflected_is_not_absorbed(void **state)
{
  (void)state;
  static const struct {
    double n, k, alpha, incidence;
  } tried[] = {{1.3, 7.4, 0.5, 0.0}, {1.3, 7.4, 0.5, 60.0}, {0.2, 3.1, 0.4, 45.0}};
  const struct um_optics_band band = {"line", 0.599e-6, 0.601e-6, 1, NULL};
  for (size_t i = 0; i < sizeof tried / sizeof tried[0]; i++) {
    struct fixture f;
    fixture_create(&f);
    fixture_metal(&f, "metal", tried[i].n, tried[i].k, tried[i].alpha);
    struct um_geometry_part_spec plate = fixture_part("plate", UM_SHAPE_PLATE, &skin);
    plate.size[0] = plate.size[1] = 1.0;
    fixture_scene(&f, &plate, 1, COSINES * AZIMUTHS);
    double angle = tried[i].incidence * UM_DEG;
    for (size_t t = 0; t < f.ntime; t++) {
      double c = sqrt(((double)(t / AZIMUTHS) + 0.5) / COSINES), s = sqrt(1.0 - c * c);
      double phi = 2.0 * UM_PI * ((double)(t % AZIMUTHS) + 0.5) / AZIMUTHS;
      f.samples[t].sun = um_vec3(sin(angle), 0.0, cos(angle));
      f.samples[t].to_observer = um_vec3(s * cos(phi), s * sin(phi), c);
    }
    fixture_run(&f, 1, &band, 1);
    double sum = 0.0;
    for (size_t t = 0; t < f.ntime; t++)
      sum += fixture_intensity(&f, t, 0, UM_MECHANISM_SUN) / f.samples[t].to_observer.z;
    double reflected = UM_PI * sum / (double)f.ntime / (fixture_sun(&f, &band) * cos(angle));
    double absorbed = um_materials_emissivity(f.record[0], NULL, 0.6e-6, cos(angle));
    print_message("reflected %.4f, absorbed %.4f\n", reflected, absorbed);
    fixture_close("reflected + absorbed", reflected + absorbed, 1.0, 2e-3);
    fixture_destroy(&f);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_reflected_is_not_absorbed)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
