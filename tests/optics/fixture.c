/* A small scene for the optics tests. */
#include "fixture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "tests/materials/table.h"
#include "tests/support/temporary.h"

const struct um_optics_band fixture_vis = {"vis", 0.38e-6, 0.78e-6, 20, NULL};
const struct um_optics_band fixture_lwir = {"lwir", 8e-6, 12e-6, 40, NULL};

void fixture_create(struct fixture *f)
{
  memset(f, 0, sizeof *f);
  assert_int_equal(um_core_context_create(NULL, &f->context), UM_OK);
  struct um_materials_sun sun;
  um_environment_defaults(&f->environment);
  um_environment_sun_shares(&f->environment, &sun);
  FIXTURE_OK(f, um_materials_library_create(f->context, &sun, &f->library));
}

static void scene_free(struct fixture *f)
{
  um_optics_lightcurve_destroy(f->context, &f->curve);
  um_optics_view_destroy(f->context, &f->view);
  um_geometry_destroy(&f->geometry);
  free(f->samples);
  free(f->temperature);
  free(f->albedo);
  free(f->view_factor);
  f->samples = NULL;
  f->temperature = NULL;
  f->albedo = f->view_factor = NULL;
}

void fixture_destroy(struct fixture *f)
{
  scene_free(f);
  um_materials_library_destroy(&f->library);
  um_core_context_destroy(&f->context);
}

void fixture_record(struct fixture *f, const char *text)
{
  char path[UM_TEST_PATH];
  um_test_file_create(path, text, strlen(text));
  enum um_status status = um_materials_library_read_file(f->context, f->library, path, NULL, 0);
  unlink(path);
  FIXTURE_OK(f, status);
}

void fixture_material(struct fixture *f, const char *name, double diffuse, double specular,
                      double alpha, double emissivity)
{
  char lobe[160] = "", text[1024];
  if (alpha > 0.0)
    snprintf(lobe, sizeof lobe, "  specular_reflectance: %.17g\n  beckmann_alpha: %.17g\n",
             specular, alpha);
  snprintf(text, sizeof text,
           "name: %s\nsummary: test\ncitation: test\ngrey:\n"
           "  solar_absorptance: %.17g\n  emittance: %.17g\n"
           "  band_emissivity:\n    - {from_um: 7.0, to_um: 14.0, value: %.17g}\n"
           "  vis_reflectance_diffuse: %.17g\n%s",
           name, 1.0 - diffuse - specular, emissivity, emissivity, diffuse, lobe);
  fixture_record(f, text);
}

void fixture_metal(struct fixture *f, const char *name, double n, double k, double alpha)
{
  char text[1024];
  snprintf(text, sizeof text,
           "name: %s\nsummary: test\ncitation: test\nsubstrate:\n"
           "  wavelength_um: [0.2, 50.0]\n  n: [%.17g, %.17g]\n  k: [%.17g, %.17g]\n"
           "surface:\n  beckmann_alpha: %.17g\n",
           name, n, n, k, k, alpha);
  fixture_record(f, text);
}

void fixture_measured(struct fixture *f, const char *name)
{
  const struct um_materials_lobe_kind *ggx = um_materials_lobe_kind_find("ggx");
  const struct test_brdf b = {{.kind = ggx, .alpha = 0.3, .alpha_across = 0.3}, 0.15, 0.5};
  struct um_materials_measured_grid grid = test_grid(&b, 2.5, 85.0, 2.5);
  char path[UM_TEST_PATH], text[512];
  um_test_file_create(path, "", 0);
  test_grid_write(&grid, path);
  test_grid_free(&grid);
  snprintf(text, sizeof text,
           "name: %s\nsummary: test\ncitation: test\nreflectance: {wavelength_um: [0.2, 50], "
           "diffuse: [0, 0], specular: [1, 1]}\nlobe: {kind: measured, file: %s}\n",
           name, path);
  fixture_record(f, text);
  unlink(path);
}

struct um_geometry_part_spec fixture_part(const char *name, enum um_geometry_shape shape,
                                          const struct um_geometry_skin *skin)
{
  return (struct um_geometry_part_spec){
      .name = name, .shape = shape, .rotation = {1.0, 0.0, 0.0, 0.0}, .skins = skin, .nskin = 1};
}

void fixture_scene(struct fixture *f, const struct um_geometry_part_spec *parts, size_t npart,
                   size_t ntime)
{
  scene_free(f);
  FIXTURE_OK(f, um_geometry_create(f->context, parts, npart, &f->geometry));
  size_t nmaterial = um_geometry_material_count(f->geometry);
  size_t n = um_geometry_mesh(f->geometry)->nsurface;
  assert_true(nmaterial <= FIXTURE_MATERIALS);
  for (size_t m = 0; m < nmaterial; m++) {
    f->record[m] = um_materials_library_find(f->library, um_geometry_material_name(f->geometry, m));
    assert_non_null(f->record[m]);
  }
  f->ntime = ntime;
  f->samples = calloc(ntime, sizeof *f->samples);
  f->temperature = calloc(ntime * n, sizeof *f->temperature);
  f->albedo = calloc(ntime * n, sizeof *f->albedo);
  f->view_factor = calloc(ntime * n, sizeof *f->view_factor);
  assert_true(f->samples && f->temperature && f->albedo && f->view_factor);
  for (size_t i = 0; i < ntime * n; i++) f->temperature[i] = 300.0;
  for (size_t t = 0; t < ntime; t++) {
    struct um_environment_sample *s = &f->samples[t];
    s->r = um_vec3(7.0e6, 0.0, 0.0);
    s->q = (struct um_quat){1.0, 0.0, 0.0, 0.0};
    s->sun = s->to_observer = s->pole = um_vec3(0.0, 0.0, 1.0);
    s->sun_distance = UM_AU;
    s->sunlit_fraction = 1.0;
    s->range = FIXTURE_RANGE;
  }
  f->scene = (struct um_optics_scene){.geometry = f->geometry,
                                      .environment = &f->environment,
                                      .samples = f->samples,
                                      .material = f->record,
                                      .temperature = f->temperature,
                                      .albedo = f->albedo,
                                      .view_factor = f->view_factor};
}

void fixture_run(struct fixture *f, int nsample, const struct um_optics_band *bands, size_t nband)
{
  um_optics_lightcurve_destroy(f->context, &f->curve);
  um_optics_view_destroy(f->context, &f->view);
  FIXTURE_OK(f, um_optics_view_trace(f->context, f->geometry, f->samples, f->ntime, nsample,
                                     f->seed, &f->view));
  f->scene.view = f->view;
  FIXTURE_OK(f, um_optics_lightcurve_compute(f->context, &f->scene, bands, nband, &f->curve));
}

double fixture_intensity(const struct fixture *f, size_t time, size_t band,
                         enum um_optics_mechanism mechanism)
{
  const struct um_optics_lightcurve *c = f->curve;
  double sum = 0.0;
  for (size_t m = 0; m < c->nmaterial; m++)
    sum += c->intensity[((time * c->nband + band) * c->nmaterial + m) * UM_MECHANISM_COUNT +
                        (size_t)mechanism];
  return sum;
}

void fixture_reflector(struct fixture *f, const char *name, double diffuse, double specular,
                       const char *lobe)
{
  char text[320];
  snprintf(text, sizeof text,
           "name: %s\nsummary: test\ncitation: test\nreflectance: {wavelength_um: [0.2, 50], "
           "diffuse: [%g, %g], specular: [%g, %g]}\n%s",
           name, diffuse, diffuse, specular, specular, lobe);
  fixture_record(f, text);
}

double fixture_sun(const struct fixture *f, const struct um_optics_band *band)
{
  return um_environment_solar_band(&f->environment, band->from, band->to);
}

void fixture_close(const char *what, double value, double expected, double relative)
{
  double error = fabs(value - expected) / fabs(expected);
  print_message("%-46s %.9g expected %.9g relative %.2g (accepted %.2g)\n", what, value, expected,
                error, relative);
  if (!(error <= relative)) fail_msg("%s", what);
}

double fixture_uniform(uint64_t c, uint64_t k) { return um_core_hash_uniform(um_core_hash(c, k)); }

struct um_vec3 fixture_direction(uint64_t c, uint64_t k)
{
  double z = 2.0 * fixture_uniform(c, k) - 1.0, angle = 2.0 * UM_PI * fixture_uniform(c, k + 1);
  double r = sqrt(1.0 - z * z);
  return um_vec3(r * cos(angle), r * sin(angle), z);
}

void fixture_pair(struct fixture *f, uint64_t c, double apart, size_t ntime)
{
  static const struct um_geometry_skin bus = {NULL, "blanket", NULL}, wing = {NULL, "cell", "back"};
  fixture_create(f);
  fixture_material(f, "blanket", 0.3, 0.3, 0.2, 0.7);
  fixture_material(f, "cell", 0.3, 0.1, 0.3, 0.85);
  fixture_material(f, "back", 0.5, 0.1, 0.3, 0.8);
  struct um_geometry_part_spec parts[2] = {fixture_part("bus", UM_SHAPE_BOX, &bus),
                                           fixture_part("wing", UM_SHAPE_PLATE, &wing)};
  for (size_t i = 0; i < 3; i++) parts[0].size[i] = 1.0 + fixture_uniform(c, i);
  parts[0].facet_size = parts[1].facet_size = 0.6;
  parts[1].size[0] = 1.0 + fixture_uniform(c, 5);
  parts[1].size[1] = 1.0 + 2.0 * fixture_uniform(c, 6);
  parts[1].position = um_vec3_scale(fixture_direction(c, 10), apart + fixture_uniform(c, 7));
  parts[1].rotation = um_quat_from_axis(fixture_direction(c, 20), UM_PI * fixture_uniform(c, 8));
  fixture_scene(f, parts, 2, ntime);
}

void fixture_within(const char *what, double value, double expected, double error, double largest)
{
  print_message("%-44s %.7g expected %.7g error %.2g standard error %.2g\n", what, value, expected,
                value - expected, error);
  assert_true(error > 0.0 && error <= largest * fabs(expected));
  assert_true(fabs(value - expected) <= 4.0 * error);
}
