/* Pictures: they add up to the light curve, and left is left. */
#include <math.h>
#include <stdlib.h>

#include "base/core/constants.h"
#include "optics/image/image.h"
#include "optics/image/surfaces.h"
#include "tests/optics/fixture.h"

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

/* Sum over pixels of a band's radiance times pixel area [W/sr], by weighted spectra. */
static double image_sum(const struct um_optics_image *image, size_t band)
{
  double sum = 0.0, weight[16] = {0.0};
  double(*weighed)[2] = calloc(image->nspectrum, sizeof *weighed);
  assert_non_null(weighed);
  assert_true(image->nbin <= 16);
  for (size_t b = image->first[band]; b < image->first[band + 1]; b++)
    weight[b] = image->bin_width[b];
  um_optics_image_weigh(image, weight, weighed);
  for (int y = 0; y < image->height; y++)
    for (int x = 0; x < image->width; x++)
      sum += um_optics_image_pixel(image, (const double(*)[2])weighed, x, y);
  free(weighed);
  return sum * image->pixel_size * image->pixel_size;
}

/* Sum over surfaces of radiance times the projected area that is seen = radiant intensity: with
 * the shares of the view itself nothing is sampled but light between surfaces, whose error the
 * light curve states. Surfaces of which less than 2 % is seen are left out: 1e-3 of the sum. */
static void test_surfaces(void **state)
{
  (void)state;
  struct fixture f;
  scene(&f);
  f.scene.interreflection_samples = 32;
  const struct um_optics_band bands[] = {vis, lwir};
  fixture_run(&f, 64, bands, 2);
  size_t n = um_geometry_mesh(f.geometry)->nsurface, dark = 0;
  double *radiance = calloc(2 * n, sizeof *radiance);
  assert_non_null(radiance);
  for (size_t t = 0; t < 2; t++) {
    FIXTURE_OK(&f,
               um_optics_surface_radiance(f.context, &f.scene, t, f.view, t, bands, 2, radiance));
    for (size_t k = 0; k < 2; k++) {
      double sum = 0.0, total = 0.0, error = f.curve->stderr_[t * 2 + k];
      for (size_t s = 0; s < n; s++) {
        double seen = (double)f.view->seen[t * n + s];
        if (isnan(radiance[k * n + s]))
          dark++;
        else
          sum += radiance[k * n + s] * seen * f.view->area[s] *
                 (double)f.view->cos_observer[t * n + s];
      }
      for (int m = 0; m < UM_MECHANISM_COUNT; m++)
        total += fixture_intensity(&f, t, k, (enum um_optics_mechanism)m);
      fixture_within("intensity of surfaces", sum, total, error + 2.5e-4 * total, 0.05);
    }
  }
  assert_true(dark > 0);
  free(radiance);
  fixture_destroy(&f);
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
  for (size_t t = 0; t < 2; t++) {
    struct um_optics_image *image;
    FIXTURE_OK(&f, um_optics_image_render(f.context, &f.scene, t, bands, 2, &options, &image));
    for (size_t k = 0; k < 2; k++) {
      double total = 0.0, error = f.curve->stderr_[t * 2 + k], sum = image_sum(image, k);
      for (int m = 0; m < UM_MECHANISM_COUNT; m++)
        total += fixture_intensity(&f, t, k, (enum um_optics_mechanism)m);
      print_message("%s: picture %.6g light curve %.6g +- %.2g [W/sr], %.2g of it\n", bands[k].name,
                    sum, total, error, sum / total - 1.0);
      assert_true(fabs(sum - total) <= 4.0 * error + 1e-3 * total);
    }
    um_optics_image_destroy(f.context, &image);
    assert_null(image);
  }
  fixture_destroy(&f);
}

/* In the umbra the picture's lamp is the Moon: of the Sun's size and where the Sun stood, it makes
 * the same picture, dimmer. */
static void test_moonlight(void **state)
{
  (void)state;
  struct fixture f;
  scene(&f);
  struct um_environment_sample *s = f.samples;
  size_t n = um_geometry_mesh(f.geometry)->nsurface;
  for (size_t i = 0; i < 2 * n; i++) f.albedo[i] = f.view_factor[i] = 0.0F;
  f.environment.shadow = UM_SHADOW_NONE;
  s[1] = s[0];
  s[1].moon = s[0].sun;
  s[1].moon_distance = UM_LUNAR_RADIUS * s[0].sun_distance / UM_SOLAR_RADIUS;
  s[1].sun = um_vec3(0.0, 0.6, -0.8);
  s[1].sunlit_fraction = 0.0;
  struct um_optics_band narrow = {"narrow", 0.5499e-6, 0.5501e-6, 1, NULL};
  struct um_optics_image_options options = {60, 4, um_vec3(0.0, 1.0, 0.0)};
  struct um_optics_image *image[2];
  struct um_environment_moonlight light;
  um_environment_moonlight(&f.environment, &s[1], &light);
  for (size_t t = 0; t < 2; t++)
    FIXTURE_OK(&f, um_optics_image_render(f.context, &f.scene, t, &narrow, 1, &options, &image[t]));
  fixture_close("picture by moonlight, of that by sunlight",
                image_sum(image[1], 0) / image_sum(image[0], 0),
                um_environment_moonlight_at(&light, 0.55e-6), 1e-6);
  for (size_t t = 0; t < 2; t++) um_optics_image_destroy(f.context, &image[t]);
  fixture_destroy(&f);
}

/* What a pixel sees is not told by wavelength: a band of a picture of several is the picture of
 * that band alone, bit by bit, and the expanded radiances add up to weighted spectra (float
 * precision). */
static void test_factors(void **state)
{
  (void)state;
  struct fixture f;
  scene(&f);
  const struct um_optics_band bands[] = {vis, lwir};
  struct um_optics_image_options options = {50, 16, um_vec3(0.0, 1.0, 0.0)};
  struct um_optics_image *both, *one;
  FIXTURE_OK(&f, um_optics_image_render(f.context, &f.scene, 0, bands, 2, &options, &both));
  FIXTURE_OK(&f, um_optics_image_render(f.context, &f.scene, 0, &lwir, 1, &options, &one));
  assert_int_equal(both->nbin, 6);
  assert_int_equal(both->first[1], 3);
  double weight[] = {0.0, 0.0, 0.0, 1.0, 1.0, 1.0}, quantile, brightest = 0.0, cut = 0.0;
  double(*weighed)[2] = calloc(both->nspectrum, sizeof *weighed);
  assert_non_null(weighed);
  um_optics_image_weigh(both, weight, weighed);
  FIXTURE_OK(
      &f, um_optics_image_quantile(f.context, both, (const double(*)[2])weighed, 0.9, &quantile));
  double seen = 0.0, above = 0.0;
  for (int y = 0; y < both->height; y++) {
    float a[50 * 4], b[50 * 4];
    const struct um_optics_image_span in_both = {y, 0, 50, 3, 3, 4}, alone = {y, 0, 50, 0, 3, 4};
    um_optics_image_expand(both, &in_both, a);
    um_optics_image_expand(one, &alone, b);
    for (int x = 0; x < 50; x++) {
      double sum = 0.0, pixel;
      for (int k = 0; k < 3; k++) {
        assert_true(a[4 * x + k] == b[4 * x + k]);
        sum += (double)a[4 * x + k];
      }
      pixel = um_optics_image_pixel(both, (const double(*)[2])weighed, x, y);
      assert_true(fabs(sum - pixel) <= 1e-6 * pixel);
      brightest = fmax(brightest, pixel);
      size_t n;
      const struct um_optics_image_share *share = um_optics_image_shares(both, x, y, &n);
      for (size_t i = 0; i < n; i++) {
        assert_true(share[i].lit <= share[i].seen && share[i].seen <= 16);
        const double *level = weighed[share[i].spectrum];
        seen += share[i].seen;
        above += level[0] > quantile ? share[i].seen - share[i].lit : 0;
        above += level[0] + level[1] > quantile ? share[i].lit : 0;
        cut = fmax(cut, level[0] + level[1]);
      }
    }
  }
  print_message("a tenth lies above %.4g, the brightest is %.4g; %.4f lie above\n", quantile, cut,
                above / seen);
  assert_true(above <= 0.1 * seen && quantile < cut && brightest <= cut * (1.0 + 1e-12));
  free(weighed);
  um_optics_image_destroy(f.context, &both);
  um_optics_image_destroy(f.context, &one);
  fixture_destroy(&f);
}

/* Told beforehand from a few lines: the picture's size to the pixel, what it covers to 5 %, and
 * more bytes than it takes. */
static void test_estimate(void **state)
{
  (void)state;
  struct fixture f;
  scene(&f);
  struct um_optics_image_options options = {200, 4, um_vec3(0.0, 1.0, 0.0)};
  struct um_optics_image_cost cost;
  struct um_optics_image *image;
  FIXTURE_OK(&f, um_optics_image_estimate(f.context, &f.scene, 0, &vis, 1, &options, &cost));
  FIXTURE_OK(&f, um_optics_image_render(f.context, &f.scene, 0, &vis, 1, &options, &image));
  assert_int_equal(cost.width, image->width);
  assert_int_equal(cost.height, image->height);
  assert_true(cost.pixel_size == image->pixel_size);
  double covered = 0.0, bytes = 2.0 * sizeof(float) * (double)(image->nspectrum * image->nbin);
  for (int y = 0; y < image->height; y++) {
    const struct um_optics_image_row *row = &image->row[y];
    for (uint32_t i = 0; i < row->count; i++) covered += row->first[i + 1] > row->first[i];
    if (row->count > 0) bytes += 4.0 * (row->count + 1.0) + 8.0 * row->first[row->count];
  }
  covered /= (double)image->width * image->height;
  print_message("covered %.4f, told %.4f; %.0f bytes, told %.0f; %.3f s told\n", covered,
                cost.covered, bytes, cost.bytes, cost.seconds);
  assert_true(fabs(cost.covered - covered) <= 0.05 * covered);
  assert_true(cost.bytes >= bytes && cost.seconds > 0.0);
  um_optics_image_destroy(f.context, &image);
  options.samples_per_pixel = 4097;
  assert_int_equal(um_optics_image_estimate(f.context, &f.scene, 0, &vis, 1, &options, &cost),
                   UM_ERR_INPUT);
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
  FIXTURE_OK(&f, um_optics_image_render(f.context, &f.scene, 0, &vis, 1, &options, &image));
  size_t small = 0, large = 0, wrong = 0;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(f.geometry);
  for (int y = 0; y < image->height; y++)
    for (int x = 0; x < image->width; x++) {
      size_t n;
      const struct um_optics_image_share *share = um_optics_image_shares(image, x, y, &n);
      if (!um_optics_image_covered(image, x, y)) continue;
      assert_true(n > 0);
      if (mesh->surface[image->surface[share[0].spectrum]].part == 1) {
        small++;
        if (x < image->width / 2 || y > image->height / 2) wrong++;
      } else {
        large++;
      }
    }
  double pixel = image->pixel_size * image->pixel_size;
  print_message("areas by covered pixels: %.4f (1) and %.4f (0.04) m^2\n", (double)large * pixel,
                (double)small * pixel);
  assert_int_equal(wrong, 0);
  /* an edge may fall a pixel off on each axis */
  assert_true(fabs(sqrt((double)large * pixel) - 1.0) <= image->pixel_size);
  assert_true(fabs(sqrt((double)small * pixel) - 0.2) <= image->pixel_size);
  um_optics_image_destroy(f.context, &image);
  options.up_gcrs = um_vec3(0.0, 0.0, 1.0);
  assert_int_equal(um_optics_image_render(f.context, &f.scene, 0, &vis, 1, &options, &image),
                   UM_ERR_INPUT);
  assert_null(image);
  fixture_destroy(&f);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_sum),       cmocka_unit_test(test_surfaces),
      cmocka_unit_test(test_moonlight), cmocka_unit_test(test_factors),
      cmocka_unit_test(test_estimate),  cmocka_unit_test(test_orientation),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
