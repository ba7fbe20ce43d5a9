/* Light between surfaces after any number of reflections, through lobes and diffuse parts:
 * enclosures of one temperature, parallel plates, flat mirrors in sunlight and before the Earth, in
 * closed form. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "optics/paths/interreflection_group.h"
#include "optics/paths/photons_group.h"
#include "optics/paths/posed_scenes_group.h"
#include "tests/optics/fixture.h"

#define WIDE 4000.0 /* side of plates 1 m apart [m]: the share near the edges is 1e-3 */

static const struct um_optics_band thermal = {"lwir", 8e-6, 12e-6, 4, NULL};
static const struct um_optics_band line = {"line", 0.599e-6, 0.601e-6, 1, NULL};

/* What a surface sends by way of others, as if all of it were seen. */
struct bench {
  struct um_optics_spectra *spectra;
  struct um_optics_posed_scenes *scenes;
  struct um_optics_work *work;
  struct um_optics_instant now;
  struct um_optics_photons photons;
  struct um_optics_paths paths;
};

static void bench_create(struct fixture *f, const struct um_optics_band *band, int nsample,
                         struct bench *b)
{
  memset(b, 0, sizeof *b);
  FIXTURE_OK(f, um_optics_spectra_create(f->context, &f->scene, 0, 1, band, 1, &b->spectra));
  FIXTURE_OK(f, um_core_allocate(f->context, 1, sizeof *b->scenes, &b->scenes));
  FIXTURE_OK(f, um_optics_posed_scenes_prepare(f->context, f->geometry, f->samples, 1, nsample,
                                               b->scenes));
  FIXTURE_OK(f, um_optics_work_create(f->context, b->spectra, UM_OPTICS_PATHS, 1, &b->work));
  b->now = um_optics_instant(&f->scene, 0);
  um_optics_light(b->spectra, &f->scene, &b->now, b->work);
  um_optics_turn(b->spectra, &f->scene, &b->now, b->work);
  FIXTURE_OK(f, um_optics_photons_reserve(f->context, b->spectra, &b->scenes->posed[0], 1, 1,
                                          &b->photons));
  b->paths = (struct um_optics_paths){.spectra = b->spectra,
                                      .scene = &f->scene,
                                      .instant = &b->now,
                                      .posed = &b->scenes->posed[0],
                                      .work = b->work,
                                      .factor = 1};
  um_optics_photons_trace(&b->paths, 0, &b->photons);
}

static void bench_destroy(struct fixture *f, struct bench *b)
{
  um_optics_photons_clear(f->context, &b->photons);
  um_optics_work_destroy(f->context, 1, &b->work);
  um_optics_posed_scenes_clear(f->context, b->scenes);
  um_core_free(f->context, b->scenes);
  um_optics_spectra_destroy(f->context, &b->spectra);
}

/* Surface of a part that is of a material. */
static size_t surface_of(const struct fixture *f, size_t part, const char *material)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(f->geometry);
  for (size_t s = 0; s < mesh->nsurface; s++)
    if (mesh->surface[s].part == part &&
        strcmp(um_geometry_material_name(f->geometry, mesh->surface[s].material), material) == 0)
      return s;
  fail_msg("part %zu has no surface of %s", part, material);
  return 0;
}

/* Six walls that face inward, each of its own kind, one of a measured table: emitted and reflected
 * together are B(T) whichever way one looks, to rounding. Without telescoping the sum would be good
 * to the sampling error alone. */
static void enclosure_is_black(void **state)
{
  (void)state;
  static const char *const name[6] = {"table", "beckmann", "thin", "ggx", "mirror", "metal"};
  static const struct {
    double x[3], z[3];
  } axes[6] = {{{0, 1, 0}, {1, 0, 0}},  {{0, 1, 0}, {-1, 0, 0}}, {{0, 0, 1}, {0, 1, 0}},
               {{0, 0, 1}, {0, -1, 0}}, {{1, 0, 0}, {0, 0, 1}},  {{1, 0, 0}, {0, 0, -1}}};
  struct fixture f;
  struct um_geometry_part_spec parts[6];
  struct um_geometry_skin skin[6];
  fixture_create(&f);
  fixture_measured(&f, "table");
  fixture_reflector(&f, "beckmann", 0.2, 0.5, "surface: {beckmann_alpha: 0.3}\n");
  fixture_reflector(&f, "thin", 0.05, 0.9, "surface: {beckmann_alpha: 0.001}\n");
  fixture_reflector(&f, "ggx", 0.1, 0.6, "lobe: {kind: ggx, alpha: 0.2}\n");
  fixture_reflector(&f, "mirror", 0.0, 0.95, "lobe: {kind: mirror}\n");
  fixture_metal(&f, "metal", 10.0, 30.0, 0.2);
  fixture_material(&f, "black", 0.0, 0.0, 0.0, 1.0);
  for (int i = 0; i < 6; i++) {
    struct um_vec3 x = um_vec3(axes[i].x[0], axes[i].x[1], axes[i].x[2]);
    struct um_vec3 z = um_vec3(axes[i].z[0], axes[i].z[1], axes[i].z[2]);
    skin[i] = (struct um_geometry_skin){NULL, name[i], "black"};
    parts[i] = fixture_part(name[i], UM_SHAPE_PLATE, &skin[i]);
    parts[i].size[0] = parts[i].size[1] = 1.0;
    parts[i].position = um_vec3_scale(z, -0.5);
    parts[i].rotation = um_core_quat_from_matrix(um_mat3_from_axes(x, um_vec3_cross(z, x), z));
  }
  fixture_scene(&f, parts, 6, 1);
  for (int k = 0; k < 6; k++) {
    struct um_vec3 inward = um_vec3(axes[k].z[0], axes[k].z[1], axes[k].z[2]);
    struct um_vec3 aside = um_vec3(axes[k].x[0], axes[k].x[1], axes[k].x[2]);
    struct bench b;
    f.samples[0].to_observer = um_vec3_unit(um_vec3_axpy(inward, 0.7, aside));
    bench_create(&f, &thermal, 24, &b);
    size_t s = surface_of(&f, (size_t)k, name[k]),
           skin_of = um_geometry_mesh(f.geometry)->surface[s].material;
    assert_true(um_optics_interreflection(&b.paths, &b.photons, s, 1.0));
    double cosine = um_vec3_dot(f.samples[0].to_observer, inward), planck[4], row[4];
    um_optics_spectra_planck(b.spectra, 300.0, planck);
    const double *emissivity = um_optics_spectra_emissivity(b.spectra, skin_of, cosine, row);
    for (size_t i = 0; i < b.spectra->nbin; i++)
      fixture_close(name[k], emissivity[i] * planck[i] + b.work->reflected[i], planck[i], 1e-10);
    bench_destroy(&f, &b);
  }
  fixture_destroy(&f);
}

static void plates(struct fixture *f, const char *low, const char *high, double warm, double cold)
{
  struct um_geometry_skin skin[2] = {{NULL, low, "black"}, {NULL, high, "black"}};
  struct um_geometry_part_spec parts[2] = {fixture_part("low", UM_SHAPE_PLATE, &skin[0]),
                                           fixture_part("high", UM_SHAPE_PLATE, &skin[1])};
  for (int i = 0; i < 2; i++) parts[i].size[0] = parts[i].size[1] = WIDE;
  parts[1].position = um_vec3(0.0, 0.0, 1.0);
  parts[1].rotation = um_quat_from_axis(um_vec3(1.0, 0.0, 0.0), UM_PI);
  fixture_scene(f, parts, 2, 1);
  const struct um_geometry_mesh *mesh = um_geometry_mesh(f->geometry);
  for (size_t s = 0; s < mesh->nsurface; s++)
    f->temperature[s] = mesh->surface[s].part == 0 ? warm : cold;
}

/* A plate of any lobe at T1 over a Lambert plate at T2, without end: the Lambert one has one
 * radiance J2 = eps2 B2 + rho2 (eps1 B1 + (1 - eps1) J2), eps1 hemispherical, and the other
 * reflects (1 - eps1(o)) J2. */
static void parallel_plates(void **state)
{
  (void)state;
  static const char *const lobe[] = {"surface: {beckmann_alpha: 0.05}\n",
                                     "surface: {beckmann_alpha: 0.5}\n",
                                     "lobe: {kind: ggx, alpha: 0.3}\n", "lobe: {kind: mirror}\n"};
  for (size_t k = 0; k < sizeof lobe / sizeof lobe[0]; k++) {
    struct fixture f;
    struct bench b;
    fixture_create(&f);
    fixture_reflector(&f, "shiny", 0.3, 0.6, lobe[k]);
    fixture_reflector(&f, "grey", 0.8, 0.0, "");
    fixture_material(&f, "black", 0.0, 0.0, 0.0, 1.0);
    plates(&f, "shiny", "grey", 200.0, 300.0);
    f.samples[0].to_observer = um_vec3_unit(um_vec3(0.6, 0.0, 0.8));
    f.samples[0].sunlit_fraction = 0.0;
    const struct um_optics_band band = {"lwir", 8e-6, 12e-6, 1, NULL};
    bench_create(&f, &band, 4096, &b);
    size_t s = surface_of(&f, 0, "shiny");
    assert_true(um_optics_interreflection(&b.paths, &b.photons, s, 1.0));
    double b1 = um_core_planck_band(8e-6, 12e-6, 200.0),
           b2 = um_core_planck_band(8e-6, 12e-6, 300.0);
    double j2 = (0.2 * b2 + 0.8 * 0.1 * b1) / (1.0 - 0.8 * 0.9);
    fixture_within(lobe[k], b.work->reflected[0] * 4e-6, 0.9 * j2, sqrt(b.work->band_variance[0]),
                   0.03);
    bench_destroy(&f, &b);
    fixture_destroy(&f);
  }
}

/* The same with an emissivity that is tilted: its hemispherical mean and J2 stay, and toward a
 * grazing o, eps' = eps + d eps (1 - 21 (1 - cos)^5)/20, the other reflects (1 - eps') J2, with a
 * lobe or without. */
static void tilted_plate(void **state)
{
  (void)state;
  static const char *const record[] = {
      "reflectance: {wavelength_um: [0.2, 50], diffuse: [0.2, 0.2], specular: [0.3, 0.3]}\n"
      "surface: {beckmann_alpha: 0.3}\n",
      "reflectance: {wavelength_um: [0.2, 50], diffuse: [0.5, 0.5]}\n",
      "grey: {solar_absorptance: 0.5, emittance: 0.5, vis_reflectance_diffuse: 0.2, "
      "specular_reflectance: 0.3, beckmann_alpha: 0.3}\n"};
  const struct um_optics_band band = {"lwir", 8e-6, 12e-6, 1, NULL};
  for (size_t k = 0; k < 2 * sizeof record / sizeof record[0]; k++) {
    struct um_materials_adjustment change[3];
    struct fixture f;
    struct bench b;
    char text[512];
    double tilt = k % 2 == 0 ? 0.9 : -0.9, cosine = 0.1;
    fixture_create(&f);
    snprintf(text, sizeof text, "name: plate\nsummary: test\ncitation: test\n%s", record[k / 2]);
    fixture_record(&f, text);
    fixture_reflector(&f, "grey", 0.8, 0.0, "");
    fixture_material(&f, "black", 0.0, 0.0, 0.0, 1.0);
    plates(&f, "plate", "grey", 200.0, 300.0);
    for (size_t m = 0; m < 3; m++) {
      change[m] = um_materials_no_adjustment;
      if (strcmp(um_geometry_material_name(f.geometry, m), "plate") == 0)
        change[m].emissivity_tilt = tilt;
    }
    f.scene.adjustment = change;
    f.samples[0].to_observer = um_vec3(sqrt(1.0 - cosine * cosine), 0.0, cosine);
    f.samples[0].sunlit_fraction = 0.0;
    bench_create(&f, &band, 4096, &b);
    size_t s = surface_of(&f, 0, "plate");
    assert_true(um_optics_interreflection(&b.paths, &b.photons, s, 1.0));
    double b1 = um_core_planck_band(8e-6, 12e-6, 200.0),
           b2 = um_core_planck_band(8e-6, 12e-6, 300.0);
    double j2 = (0.2 * b2 + 0.8 * 0.5 * b1) / (1.0 - 0.8 * 0.5);
    double emissivity = 0.5 + tilt * 0.5 * (1.0 - 21.0 * pow(1.0 - cosine, 5.0)) / 20.0;
    fixture_within("tilted", b.work->reflected[0] * 4e-6, (1.0 - emissivity) * j2,
                   sqrt(b.work->band_variance[0]), 0.03);
    bench_destroy(&f, &b);
    fixture_destroy(&f);
  }
}

/* A wide floor and an upright wall of 1 m^2 that is a mirror of F = 1. */
static void mirror_and_floor(struct fixture *f, const char *lobe)
{
  static const struct um_geometry_skin skin[2] = {{NULL, "floor", "black"},
                                                  {NULL, "wall", "black"}};
  fixture_create(f);
  fixture_reflector(f, "floor", 0.5, 0.0, "");
  fixture_reflector(f, "wall", 0.0, 1.0, lobe);
  fixture_material(f, "black", 0.0, 0.0, 0.0, 1.0);
  struct um_geometry_part_spec parts[2] = {fixture_part("floor", UM_SHAPE_PLATE, &skin[0]),
                                           fixture_part("wall", UM_SHAPE_PLATE, &skin[1])};
  parts[0].size[0] = parts[0].size[1] = 12.0;
  parts[0].facet_size = 1.5;
  parts[0].position = um_vec3(4.0, 0.0, 0.0);
  parts[1].size[0] = parts[1].size[1] = 1.0;
  parts[1].position = um_vec3(0.0, 0.0, 0.5);
  parts[1].rotation = um_core_quat_from_matrix(
      um_mat3_from_axes(um_vec3(0.0, 1.0, 0.0), um_vec3(0.0, 0.0, 1.0), um_vec3(1.0, 0.0, 0.0)));
  fixture_scene(f, parts, 2, 1);
  for (size_t s = 0; s < um_geometry_mesh(f->geometry)->nsurface; s++) f->temperature[s] = 3.0;
}

static const char *const mirrors[] = {
    "lobe: {kind: mirror}\n", "surface: {beckmann_alpha: 0.001}\n",
    "surface: {beckmann_alpha: 0.03}\n", "surface: {beckmann_alpha: 0.1}\n"};

/* The wall throws the sunlight that it gets on the floor, E A sin z, and the floor sends rho/pi of
 * it to the zenith. */
static void mirror_lights_floor(void **state)
{
  (void)state;
  for (size_t k = 0; k < 4; k++) {
    struct fixture f;
    mirror_and_floor(&f, mirrors[k]);
    f.samples[0].sun = um_vec3_unit(um_vec3(1.0, 0.0, 1.0));
    f.scene.interreflection_samples = 2048;
    fixture_run(&f, 16, &line, 1);
    double expected = 0.5 * fixture_sun(&f, &line) * sqrt(0.5) / UM_PI;
    fixture_within(mirrors[k], fixture_intensity(&f, 0, 0, UM_MECHANISM_INTERREFLECTED), expected,
                   f.curve->stderr_[0], 0.1);
    fixture_destroy(&f);
  }
}

/* The Sun grazes the wall and lights the floor; the observer sees that in the wall: L A cos_o. */
static void floor_in_mirror(void **state)
{
  (void)state;
  for (size_t k = 0; k < 3; k++) {
    struct fixture f;
    mirror_and_floor(&f, mirrors[k]);
    f.samples[0].sun = um_vec3_unit(um_vec3(-1e-3, 1.0, 1.0));
    f.samples[0].to_observer = um_vec3_unit(um_vec3(1.0, 0.0, 1.0));
    f.scene.interreflection_samples = 256;
    f.scene.interreflection_most = 1;
    fixture_run(&f, 16, &line, 1);
    double radiance = 0.5 * fixture_sun(&f, &line) * um_vec3_unit(um_vec3(0.0, 1.0, 1.0)).z / UM_PI;
    double value = fixture_intensity(&f, 0, 0, UM_MECHANISM_INTERREFLECTED);
    fixture_within(mirrors[k], value, radiance * sqrt(0.5), f.curve->stderr_[0] + 1e-5 * value,
                   0.1);
    fixture_destroy(&f);
  }
}

/* A wall without end, a mirror, stands upright on a floor and faces the Earth: the floor gets the
 * Earth once more, mirrored, F(90 deg) B, beside the Earth itself, which is none of this part. */
static void mirrored_earth(void **state)
{
  (void)state;
  static const struct um_geometry_skin skin[2] = {{NULL, "floor", "black"},
                                                  {NULL, "wall", "black"}};
  struct fixture f;
  struct bench b;
  fixture_create(&f);
  fixture_reflector(&f, "floor", 0.5, 0.0, "");
  fixture_reflector(&f, "wall", 0.0, 1.0, "lobe: {kind: mirror}\n");
  fixture_material(&f, "black", 0.0, 0.0, 0.0, 1.0);
  struct um_geometry_part_spec parts[2] = {fixture_part("floor", UM_SHAPE_PLATE, &skin[0]),
                                           fixture_part("wall", UM_SHAPE_PLATE, &skin[1])};
  parts[0].size[0] = parts[0].size[1] = 1.0;
  parts[0].position = um_vec3(1.0, 0.0, 0.0);
  parts[1].size[0] = parts[1].size[1] = WIDE;
  parts[1].position = um_vec3(0.0, 0.0, 0.0);
  parts[1].rotation = um_core_quat_from_matrix(
      um_mat3_from_axes(um_vec3(0.0, 1.0, 0.0), um_vec3(0.0, 0.0, 1.0), um_vec3(1.0, 0.0, 0.0)));
  fixture_scene(&f, parts, 2, 1);
  for (size_t s = 0; s < um_geometry_mesh(f.geometry)->nsurface; s++) f.temperature[s] = 3.0;
  f.samples[0].r = um_vec3(-7.0e6, 0.0, 0.0); /* the Earth toward +x */
  f.samples[0].sunlit_fraction = 0.0;
  f.samples[0].sun = um_vec3(-1.0, 0.0, 0.0); /* behind the satellite's back: all it sees is lit */
  const struct um_optics_band band = {"lwir", 8e-6, 12e-6, 1, NULL};
  f.environment.earthshine_on = false;
  bench_create(&f, &band, 4096, &b);
  b.scenes->posed[0].exchange->count[surface_of(&f, 0, "floor")] = 4096; /* small beside the wall */
  assert_true(um_optics_interreflection(&b.paths, &b.photons, surface_of(&f, 0, "floor"), 1.0));
  double factor = um_environment_plate_view_factor(7.0e6 / f.environment.earth_radius, 0.5 * UM_PI);
  fixture_within("the Earth in a mirror", b.work->reflected[0] * 4e-6,
                 0.5 * factor *
                     um_core_planck_band(8e-6, 12e-6, f.environment.brightness_temperature),
                 sqrt(b.work->band_variance[0]), 0.05);
  bench_destroy(&f, &b);
  fixture_destroy(&f);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(enclosure_is_black), cmocka_unit_test(parallel_plates),
      cmocka_unit_test(tilted_plate),       cmocka_unit_test(mirror_lights_floor),
      cmocka_unit_test(floor_in_mirror),    cmocka_unit_test(mirrored_earth),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
