/* Sunlight by way of several mirrors, in closed form: a shaft 1 m wide and 4 m deep, with two
 * mirrors for walls, of F = 1 if nothing is said, and a Lambert floor. */
#include <math.h>

#include "base/core/constants.h"
#include "optics/paths/photon_maps.h"
#include "tests/optics/fixture.h"

#define DEEP 4.0  /* [m] */
#define LONG 40.0 /* [m]: what the Sun's width throws out at the ends is 3e-4 */

static const struct um_optics_band line = {"line", 0.599e-6, 0.601e-6, 1, NULL};

/* Walls at x = -1/2 and x = 1/2 that face each other, floor at z = 0; Sun at 45 deg over x. */
static void shaft(struct fixture *f, const char *lobe, double reflected)
{
  static const struct um_geometry_skin skin[2] = {{NULL, "floor", "black"},
                                                  {NULL, "wall", "black"}};
  struct um_vec3 up = um_vec3(0.0, 0.0, 1.0);
  fixture_create(f);
  fixture_reflector(f, "floor", 0.5, 0.0, "");
  fixture_reflector(f, "wall", 0.0, reflected, lobe);
  fixture_material(f, "black", 0.0, 0.0, 0.0, 1.0);
  struct um_geometry_part_spec parts[3] = {fixture_part("floor", UM_SHAPE_PLATE, &skin[0]),
                                           fixture_part("left", UM_SHAPE_PLATE, &skin[1]),
                                           fixture_part("right", UM_SHAPE_PLATE, &skin[1])};
  parts[0].size[0] = 1.0;
  parts[0].size[1] = LONG;
  for (int k = 1; k < 3; k++) {
    struct um_vec3 inward = um_vec3(k == 1 ? 1.0 : -1.0, 0.0, 0.0);
    parts[k].size[0] = LONG;
    parts[k].size[1] = DEEP;
    parts[k].position = um_vec3_axpy(um_vec3_scale(up, 0.5 * DEEP), -0.5, inward);
    parts[k].rotation =
        um_core_quat_from_matrix(um_mat3_from_axes(um_vec3_cross(up, inward), up, inward));
  }
  fixture_scene(f, parts, 3, 1);
  for (size_t s = 0; s < um_geometry_mesh(f->geometry)->nsurface; s++) f->temperature[s] = 3.0;
  f->samples[0].sun = um_vec3_unit(um_vec3(1.0, 0.0, 1.0));
  f->scene.sunlight_only = true;
  f->scene.interreflection_samples = 8192;
}

static void within(const char *what, const struct fixture *f, double expected, double largest)
{
  double value = fixture_intensity(f, 0, 0, UM_MECHANISM_INTERREFLECTED);
  double error = f->curve->stderr_[0];
  fixture_within(what, value, expected, error, largest);
}

static const char *const lobes[] = {"lobe: {kind: mirror}\n", "surface: {beckmann_alpha: 0.001}\n"};

/* All sunlight that enters comes to the floor, after four mirrors in the mean, E cos 45 deg, and is
 * seen from the zenith by itself. */
static void light_down_the_shaft(void **state)
{
  (void)state;
  for (size_t k = 0; k < 2; k++) {
    struct fixture f;
    shaft(&f, lobes[k], 1.0);
    fixture_run(&f, 16, &line, 1);
    within(lobes[k], &f, 0.5 * fixture_sun(&f, &line) * LONG * sqrt(0.5) / UM_PI, 0.02);
    fixture_destroy(&f);
  }
}

/* The same seen under 45 deg, by way of four mirrors again: the opening has the floor's radiance.
 * What goes up a shaft came from its floor: no mirror shows the Sun. */
static void floor_up_the_shaft(void **state)
{
  (void)state;
  for (size_t k = 0; k < 2; k++) {
    struct fixture f;
    shaft(&f, lobes[k], 1.0);
    f.samples[0].to_observer = um_vec3_unit(um_vec3(-1.0, 0.0, 1.0));
    fixture_run(&f, 16, &line, 1);
    within(lobes[k], &f, 0.5 * fixture_sun(&f, &line) * LONG * 0.5 / UM_PI, 0.05);
    fixture_destroy(&f);
  }
}

/* Of grey surfaces every bin has its own sunlight, however many there are. */
static void bins_keep_the_fine_structure(void **state)
{
  (void)state;
  static const struct um_optics_band fine = {"fine", 0.38e-6, 0.78e-6, 400, NULL};
  struct fixture f;
  shaft(&f, lobes[0], 1.0);
  f.scene.interreflection_samples = 8;
  fixture_run(&f, 16, &fine, 1);
  const struct um_optics_lightcurve *c = f.curve;
  double first = 0.0;
  for (size_t b = 0; b < c->nbin; b++) {
    double from = c->wavelength[b] - 0.5 * c->width[b], to = c->wavelength[b] + 0.5 * c->width[b];
    double share = c->spectral[b * UM_MECHANISM_COUNT + UM_MECHANISM_INTERREFLECTED] * c->width[b] /
                   um_environment_solar_band(&f.environment, from, to);
    if (b == 0) first = share;
    assert_true(first > 0.0);
    assert_true(fabs(share - first) <= 1e-9 * first);
  }
  fixture_destroy(&f);
}

/* --- kept photons ---------------------------------------------------------------------------- */

static struct um_optics_photon_maps *keep(const struct fixture *f)
{
  struct um_optics_photon_maps *maps = NULL;
  FIXTURE_OK(f, um_optics_photon_maps_create(f->context, &f->scene, &line, 1, &maps));
  return maps;
}

/* Light of the fixture with photons that are kept; its own, traced, into `traced`. */
static double run_kept(struct fixture *f, const struct um_optics_photon_maps *maps, double *traced)
{
  fixture_run(f, 16, &line, 1);
  *traced = fixture_intensity(f, 0, 0, UM_MECHANISM_INTERREFLECTED);
  f->scene.photons = maps;
  fixture_run(f, 16, &line, 1);
  return fixture_intensity(f, 0, 0, UM_MECHANISM_INTERREFLECTED);
}

/* To mirrors of F = 0.5 the same after four of them, F^4 of the light, though kept paths went on as
 * often as F = 1 has them. */
static void kept_photons_serve_other_reflectances(void **state)
{
  (void)state;
  static const double reflected[] = {1.0, 0.5};
  struct fixture made;
  shaft(&made, lobes[0], 1.0);
  fixture_run(&made, 16, &line, 1);
  struct um_optics_photon_maps *maps = keep(&made);
  assert_non_null(maps);
  for (size_t k = 0; k < 2; k++) {
    struct fixture f;
    double traced, expected = LONG * sqrt(0.5) * pow(reflected[k], 4.0) / UM_PI;
    shaft(&f, lobes[0], reflected[k]);
    double kept = run_kept(&f, maps, &traced);
    within("kept photons", &f, 0.5 * fixture_sun(&f, &line) * expected, 0.02);
    if (k == 0) assert_memory_equal(&kept, &traced, sizeof kept);
    if (k == 1) assert_true(kept != traced); /* NOLINT: paths of another chance */
    fixture_destroy(&f);
  }
  um_optics_photon_maps_destroy(made.context, &maps);
  fixture_destroy(&made);
}

/* Another lobe, another number of paths: they are traced. */
static void kept_photons_are_of_their_mirrors(void **state)
{
  (void)state;
  struct fixture made, f;
  double traced;
  shaft(&made, lobes[0], 1.0);
  fixture_run(&made, 16, &line, 1);
  struct um_optics_photon_maps *maps = keep(&made);
  shaft(&f, lobes[1], 1.0);
  double kept = run_kept(&f, maps, &traced);
  assert_memory_equal(&kept, &traced, sizeof kept);
  fixture_destroy(&f);
  shaft(&f, lobes[0], 1.0);
  f.scene.interreflection_samples = 4096;
  kept = run_kept(&f, maps, &traced);
  assert_memory_equal(&kept, &traced, sizeof kept);
  fixture_destroy(&f);
  um_optics_photon_maps_destroy(made.context, &maps);
  fixture_destroy(&made);
}

static void nothing_to_keep(void **state)
{
  (void)state;
  struct fixture f;
  shaft(&f, lobes[0], 1.0);
  fixture_run(&f, 16, &line, 1);
  f.scene.interreflection_samples = 0;
  assert_null(keep(&f));
  f.scene.interreflection_samples = 8;
  f.scene.ages = true; /* not looked at: nothing is there that ages */
  assert_null(keep(&f));
  f.scene.ages = false;
  fixture_destroy(&f);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(light_down_the_shaft),
      cmocka_unit_test(floor_up_the_shaft),
      cmocka_unit_test(bins_keep_the_fine_structure),
      cmocka_unit_test(kept_photons_serve_other_reflectances),
      cmocka_unit_test(kept_photons_are_of_their_mirrors),
      cmocka_unit_test(nothing_to_keep),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
