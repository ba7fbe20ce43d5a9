/* Light between surfaces with kept first turns is that without to the last digit, whatever share of
 * the paths takes the lobe; a lobe of another width is traced. */
#include <string.h>

#include "base/core/constants.h"
#include "optics/paths/first_turns_group.h"
#include "optics/paths/photon_maps_group.h"
#include "tests/optics/fixture.h"

#define PATHS 64

static const struct um_optics_band line = {"line", 0.599e-6, 0.601e-6, 1, NULL};

/* A small plate over a wide one, both glossy, seen from the side. */
static void scene(struct fixture *f, double diffuse, double specular, double alpha)
{
  static const struct um_geometry_skin skin = {NULL, "gloss", "black"};
  fixture_create(f);
  fixture_material(f, "gloss", diffuse, specular, alpha, 0.5);
  fixture_material(f, "black", 0.0, 0.0, 0.0, 1.0);
  struct um_geometry_part_spec parts[2] = {fixture_part("low", UM_SHAPE_PLATE, &skin),
                                           fixture_part("high", UM_SHAPE_PLATE, &skin)};
  parts[0].size[0] = parts[0].size[1] = 4.0;
  parts[1].size[0] = parts[1].size[1] = 1.0;
  parts[1].position = um_vec3(0.4, 0.0, 0.8);
  parts[1].rotation = um_quat_from_axis(um_vec3(1.0, 0.0, 0.0), 0.9 * UM_PI);
  fixture_scene(f, parts, 2, 2);
  for (size_t k = 0; k < 2; k++) {
    f->samples[k].to_observer = um_vec3_unit(um_vec3(-0.3, 0.8 - 1.6 * (double)k, 0.6));
    f->samples[k].sun = um_vec3_unit(um_vec3(0.2, -0.5, 1.0));
  }
  f->scene.interreflection_samples = PATHS;
}

static size_t bytes_of(const struct um_optics_lightcurve *c)
{
  return c->ntime * c->nbin * UM_MECHANISM_COUNT * sizeof *c->spectral;
}

/* Of the scene without and with what is kept. */
static void same_light(struct fixture *f, const struct um_optics_photon_maps *maps)
{
  double traced[256], error = 0.0;
  f->scene.photons = NULL;
  fixture_run(f, 16, &line, 1);
  size_t bytes = bytes_of(f->curve);
  assert_true(bytes <= sizeof traced);
  memcpy(traced, f->curve->spectral, bytes);
  error = f->curve->stderr_[0];
  assert_true(fixture_intensity(f, 0, 0, UM_MECHANISM_INTERREFLECTED) > 0.0);
  f->scene.photons = maps;
  fixture_run(f, 16, &line, 1);
  assert_memory_equal(f->curve->spectral, traced, bytes);
  assert_memory_equal(&f->curve->stderr_[0], &error, sizeof error);
  f->scene.photons = NULL;
}

static void kept_turns_leave_light_as_it_is(void **state)
{
  (void)state;
  static const struct {
    double diffuse, specular, alpha;
  } other[] = {{0.3, 0.3, 0.4}, {0.55, 0.05, 0.4}, {0.02, 0.8, 0.4}, {0.3, 0.3, 0.25}};
  struct fixture made;
  struct um_optics_photon_maps *maps = NULL;
  scene(&made, 0.3, 0.3, 0.4);
  fixture_run(&made, 16, &line, 1);
  FIXTURE_OK(&made, um_optics_photon_maps_create(made.context, &made.scene, &line, 1, &maps));
  assert_non_null(maps);
  for (size_t k = 0; k < sizeof other / sizeof other[0]; k++) {
    struct fixture f;
    scene(&f, other[k].diffuse, other[k].specular, other[k].alpha);
    same_light(&f, maps);
    fixture_destroy(&f);
  }
  um_optics_photon_maps_destroy(made.context, &maps);
  fixture_destroy(&made);
}

/* Most paths of the wide plate pass beside the small one, some meet it. */
static void most_paths_meet_nothing(void **state)
{
  (void)state;
  struct fixture f;
  struct um_optics_photon_maps *maps = NULL;
  scene(&f, 0.3, 0.3, 0.4);
  fixture_run(&f, 16, &line, 1);
  FIXTURE_OK(&f, um_optics_photon_maps_create(f.context, &f.scene, &line, 1, &maps));
  const uint8_t *bits = um_optics_photon_maps_turns(maps, 0)->bits;
  size_t meets[2] = {0, 0};
  for (size_t i = 0; i < PATHS; i++)
    for (int way = 0; way < 2; way++)
      meets[way] += (bits[i / 4] >> (2 * (i % 4) + (size_t)way)) & 1;
  print_message("of the first %d paths %zu meet something by the cosine, %zu by the lobe\n", PATHS,
                meets[0], meets[1]);
  for (int way = 0; way < 2; way++) assert_in_range(meets[way], 1, PATHS / 2);
  um_optics_photon_maps_destroy(f.context, &maps);
  fixture_destroy(&f);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(kept_turns_leave_light_as_it_is),
                                     cmocka_unit_test(most_paths_meet_nothing)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
