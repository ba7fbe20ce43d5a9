/* Pictures: they add up to the light curve, and left is left. */
#include <math.h>

#include "core/constants.h"
#include "fixture.h"

static const struct um_geometry_skin ball_skin = {NULL, "blanket", NULL};
static const struct um_geometry_skin plate_skin = {NULL, "cell", "blanket"};
static const struct um_optics_band vis = {"vis", 0.38e-6, 0.78e-6, 3, NULL};
static const struct um_optics_band lwir = {"lwir", 8e-6, 12e-6, 3, NULL};

/* Shaded plate behind a ball. */
static void scene(struct fixture *f)
{
  fixture_create(f);
  fixture_material(f, "blanket", 0.3, 0.3, 0.2, 0.7);
  fixture_record(f,
                 "name: cell\nsummary: test\ncitation: test\n"
                 "grey: {solar_absorptance: 0.7, emittance: 0.85, vis_reflectance_diffuse: 0.2, "
                 "specular_reflectance: 0.1}\nlobe: {kind: ggx, alpha: 0.1, alpha_across: 0.5}\n");
  struct um_geometry_part_spec parts[2];
  parts[0] = fixture_part("ball", UM_SHAPE_SPHERE, &ball_skin);
  parts[0].radius = 0.5;
  parts[0].facet_size = 0.2;
  parts[0].position = um_vec3(0.3, 0.4, 1.0);
  parts[1] = fixture_part("plate", UM_SHAPE_PLATE, &plate_skin);
  parts[1].size[0] = 2.0;
  parts[1].size[1] = 3.0;
  parts[1].facet_size = 0.3;
  parts[1].grain = um_vec3(1.0, 2.0, 0.5);
  fixture_scene(f, parts, 2, 2);
  size_t n = um_geometry_mesh(f->geometry)->nsurface;
  for (size_t t = 0; t < 2; t++) {
    f->samples[t].sun = um_vec3_unit(um_vec3(0.3, -0.2, 1.0));
    f->samples[t].to_observer = um_vec3_unit(um_vec3(-0.4, 0.1, 1.0));
    f->samples[t].q = um_quat_from_axis(um_vec3(0.0, 0.0, 1.0), 0.4 * (double)t);
    for (size_t i = 0; i < n; i++) {
      f->temperature[t * n + i] = 260.0 + 2.0 * (double)(i % 30);
      f->albedo[t * n + i] = 50.0F;
      f->view_factor[t * n + i] = 0.2F;
    }
  }
}

static double image_sum(const struct um_optics_image *image)
{
  double sum = 0.0;
  size_t npixel = (size_t)image->width * (size_t)image->height;
  for (size_t p = 0; p < npixel; p++)
    for (size_t b = 0; b < image->nbin; b++)
      sum += (double)image->radiance[p * image->nbin + b] * image->bin_width[b];
  return sum * image->pixel_size * image->pixel_size;
}

/* Sum over pixels of radiance times pixel area = radiant intensity. The light curve states its own
 * standard error (shadow edge on 64 points per facet); the picture's outline and shadow edge, ~700
 * pixels of 16 points each, leave about 2e-4 of the sum: 1e-3 is five times that. */
static void test_sum(void **state)
{
  (void)state;
  struct fixture f;
  scene(&f);
  f.scene.interreflection_samples = 32;
  const struct um_optics_band bands[] = {vis, lwir};
  fixture_run(&f, 64, bands, 2);
  struct um_optics_image_options options = {120, 16, um_vec3(0.0, 1.0, 0.0)};
  for (size_t t = 0; t < 2; t++)
    for (size_t k = 0; k < 2; k++) {
      struct um_optics_image *image;
      FIXTURE_OK(&f, um_optics_image_render(f.context, &f.scene, t, &bands[k], &options, &image));
      double total = 0.0, error = f.curve->stderr_[t * 2 + k], sum = image_sum(image);
      for (int m = 0; m < UM_MECHANISM_COUNT; m++)
        total += fixture_intensity(&f, t, k, (enum um_optics_mechanism)m);
      print_message("%s: picture %.6g light curve %.6g +- %.2g [W/sr], %.2g of it\n", bands[k].name,
                    sum, total, error, sum / total - 1.0);
      assert_true(fabs(sum - total) <= 4.0 * error + 1e-3 * total);
      um_optics_image_destroy(f.context, &image);
      assert_null(image);
    }
  fixture_destroy(&f);
}

/* Seen from +z with +y up, a small box at (+2, +1) is on the upper right. */
static void test_orientation(void **state)
{
  (void)state;
  struct fixture f;
  fixture_create(&f);
  fixture_material(&f, "blanket", 0.3, 0.0, 0.0, 0.7);
  struct um_geometry_part_spec parts[2];
  for (int i = 0; i < 2; i++) {
    parts[i] = fixture_part(i == 0 ? "large" : "small", UM_SHAPE_BOX, &ball_skin);
    for (int k = 0; k < 3; k++) parts[i].size[k] = i == 0 ? 1.0 : 0.2;
  }
  parts[1].position = um_vec3(2.0, 1.0, 0.0);
  fixture_scene(&f, parts, 2, 1);
  struct um_optics_image_options options = {100, 4, um_vec3(0.0, 1.0, 0.0)};
  struct um_optics_image *image;
  FIXTURE_OK(&f, um_optics_image_render(f.context, &f.scene, 0, &vis, &options, &image));
  size_t small = 0, large = 0, wrong = 0;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(f.geometry);
  for (int y = 0; y < image->height; y++)
    for (int x = 0; x < image->width; x++) {
      uint32_t s = image->surface[y * image->width + x];
      if (s == UM_GEOMETRY_NONE) continue;
      if (mesh->surface[s].part == 1) {
        small++;
        if (x < image->width / 2 || y > image->height / 2) wrong++;
      } else {
        large++;
      }
    }
  double pixel = image->pixel_size * image->pixel_size;
  print_message("areas by pixel centres: %.4f (1) and %.4f (0.04) m^2\n", (double)large * pixel,
                (double)small * pixel);
  assert_int_equal(wrong, 0);
  /* an edge may fall a pixel off on each axis */
  assert_true(fabs(sqrt((double)large * pixel) - 1.0) <= image->pixel_size);
  assert_true(fabs(sqrt((double)small * pixel) - 0.2) <= image->pixel_size);
  um_optics_image_destroy(f.context, &image);
  options.up_gcrs = um_vec3(0.0, 0.0, 1.0);
  assert_int_equal(um_optics_image_render(f.context, &f.scene, 0, &vis, &options, &image),
                   UM_ERR_INPUT);
  assert_null(image);
  fixture_destroy(&f);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_sum),
      cmocka_unit_test(test_orientation),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
