/* What must hold whatever the numbers: sums, umbra, threads, Kirchhoff, reciprocity, errors. */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "optics/image/image.h"
#include "tests/optics/fixture.h"
#include "tests/support/allocator.h"

static const struct um_geometry_skin body_skin = {NULL, "blanket", NULL};
static const struct um_geometry_skin wing_skin = {NULL, "cell", "back"};
static const struct um_optics_band bands[] = {{"vis", 0.38e-6, 0.78e-6, 8, NULL},
                                              {"lwir", 8e-6, 12e-6, 10, NULL}};

/* A box with a wing that shades it and turns with the Sun; every mechanism is at work. */
static void satellite(struct fixture *f, size_t ntime, bool turning)
{
  fixture_create(f);
  fixture_material(f, "blanket", 0.3, 0.3, 0.2, 0.7);
  fixture_material(f, "cell", 0.05, 0.1, 0.1, 0.85);
  fixture_metal(f, "back", 10.0, 20.0, 0.3);
  struct um_geometry_part_spec parts[2];
  parts[0] = fixture_part("bus", UM_SHAPE_BOX, &body_skin);
  parts[0].size[0] = 1.0;
  parts[0].size[1] = 1.5;
  parts[0].size[2] = 2.0;
  parts[0].facet_size = 0.7;
  parts[1] = fixture_part("wing", UM_SHAPE_PLATE, &wing_skin);
  parts[1].size[0] = 1.0;
  parts[1].size[1] = 3.0;
  parts[1].facet_size = 0.7;
  parts[1].position = um_vec3(1.3, 0.2, 0.1);
  if (turning) {
    parts[1].joint = UM_JOINT_SUN;
    parts[1].joint_axis = um_vec3(0.0, 1.0, 0.0);
    parts[1].joint_normal = um_vec3(0.0, 0.0, 1.0);
  }
  fixture_scene(f, parts, 2, ntime);
  size_t n = um_geometry_mesh(f->geometry)->nsurface;
  for (size_t t = 0; t < ntime; t++) {
    struct um_environment_sample *s = &f->samples[t];
    s->sun = um_vec3_unit(um_vec3(sin(0.1 * (double)t), 0.4, cos(0.1 * (double)t)));
    s->to_observer = um_vec3_unit(um_vec3(1.0, cos(0.3 * (double)t), 0.5));
    s->q = um_quat_from_axis(um_vec3(0.6, 0.0, 0.8), 0.2 * (double)t);
    for (size_t i = 0; i < n; i++) {
      f->temperature[t * n + i] = 250.0 + 3.0 * (double)(i % 20) + (double)t;
      f->albedo[t * n + i] = (float)(100.0 + (double)i);
      f->view_factor[t * n + i] = (float)(0.01 * (double)(i % 50));
    }
  }
  f->scene.interreflection_samples = 8;
}

/* Mechanisms of all bins, and materials of all bands, sum to the same total: only the order of
 * additions differs. */
static void test_sums(void **state)
{
  (void)state;
  struct fixture f;
  satellite(&f, 5, false);
  fixture_run(&f, 16, bands, 2);
  const struct um_optics_lightcurve *c = f.curve;
  for (size_t t = 0; t < 5; t++)
    for (size_t k = 0; k < 2; k++)
      for (size_t m = 0; m < UM_MECHANISM_COUNT; m++) {
        double by_bin = 0.0, by_material = fixture_intensity(&f, t, k, (enum um_optics_mechanism)m);
        for (size_t b = 0; b < c->nbin; b++)
          if (c->band[b] == k)
            by_bin += c->spectral[(t * c->nbin + b) * UM_MECHANISM_COUNT + m] * c->width[b];
        assert_true(fabs(by_bin - by_material) <= 1e-12 * fabs(by_bin));
        if (m == UM_MECHANISM_OTHER) assert_true(by_bin == 0.0);
        if (m != UM_MECHANISM_OTHER) assert_true(by_bin > 0.0);
      }
  fixture_destroy(&f);
}

/* The Sun term is exactly zero in the umbra, and so is what it would send between surfaces; the
 * rest stays. */
static void test_umbra(void **state)
{
  (void)state;
  struct fixture f;
  satellite(&f, 3, false);
  for (size_t t = 0; t < 3; t++) f.samples[t].sunlit_fraction = 0.0;
  f.environment.earthshine_on = false;
  fixture_run(&f, 16, bands, 2);
  for (size_t t = 0; t < 3; t++) {
    for (size_t b = 0; b < f.curve->nbin; b++)
      assert_true(
          f.curve->spectral[(t * f.curve->nbin + b) * UM_MECHANISM_COUNT + UM_MECHANISM_SUN] ==
          0.0);
    assert_true(fixture_intensity(&f, t, 0, UM_MECHANISM_SUN) == 0.0);
    assert_true(fixture_intensity(&f, t, 0, UM_MECHANISM_INTERREFLECTED) < 1e-20);
    assert_true(fixture_intensity(&f, t, 1, UM_MECHANISM_EMITTED) > 1.0);
    assert_true(fixture_intensity(&f, t, 1, UM_MECHANISM_INTERREFLECTED) > 0.0);
  }
  fixture_destroy(&f);
}

/* Penumbra: the Sun term is proportional to the sunlit fraction and to 1/d^2. */
static void test_penumbra(void **state)
{
  (void)state;
  struct fixture f;
  satellite(&f, 1, false);
  fixture_run(&f, 16, bands, 1);
  double full = fixture_intensity(&f, 0, 0, UM_MECHANISM_SUN);
  f.samples[0].sunlit_fraction = 0.25;
  fixture_run(&f, 16, bands, 1);
  fixture_close("Sun term at a quarter of the disc [W/sr]",
                fixture_intensity(&f, 0, 0, UM_MECHANISM_SUN), 0.25 * full, 1e-14);
  fixture_destroy(&f);
}

static void run_threads(bool turning, int threads, struct fixture *f)
{
  satellite(f, 70, turning);
  um_core_context_set_threads(f->context, threads);
  fixture_run(f, 8, bands, 2);
}

/* One, two and three threads: the same bytes, with and without a turning wing. */
static void test_threads(void **state)
{
  (void)state;
  for (int turning = 0; turning < 2; turning++) {
    struct fixture one;
    run_threads(turning, 1, &one);
    for (int threads = 2; threads < 4; threads++) {
      struct fixture many;
      run_threads(turning, threads, &many);
      const struct um_optics_lightcurve *a = one.curve, *b = many.curve;
      const struct um_optics_view *v = one.view, *w = many.view;
      size_t ns = v->ntime * v->nsurface;
      assert_memory_equal(v->seen, w->seen, ns * sizeof *v->seen);
      assert_memory_equal(v->sun.share, w->sun.share, ns * sizeof *v->sun.share);
      assert_memory_equal(v->sun.cos_half, w->sun.cos_half, ns * sizeof *v->sun.cos_half);
      assert_memory_equal(a->spectral, b->spectral,
                          a->ntime * a->nbin * UM_MECHANISM_COUNT * sizeof *a->spectral);
      assert_memory_equal(a->intensity, b->intensity,
                          a->ntime * a->nband * a->nmaterial * UM_MECHANISM_COUNT *
                              sizeof *a->intensity);
      assert_memory_equal(a->stderr_, b->stderr_, a->ntime * a->nband * sizeof *a->stderr_);
      fixture_destroy(&many);
    }
    fixture_destroy(&one);
  }
}

#define METAL                                                                                      \
  "summary: test\ncitation: test\nsubstrate: {wavelength_um: [0.2, 50], n: [25, 25], k: [90, "     \
  "90]}\n"

/* Kirchhoff: a surface at T that looks at surroundings at T sends out B(T), whatever its optics and
 * angle: emission plus reflected "Earth" of view factor 1 and brightness temperature T. 1e-7: the
 * cosines that make the projected area are float; the spectra agree to rounding. */
static void test_isothermal(void **state)
{
  (void)state;
  static const struct um_geometry_skin skins[] = {
      {NULL, "blanket", "blanket"}, {NULL, "cell", "cell"},     {NULL, "metal", "metal"},
      {NULL, "glass", "glass"},     {NULL, "ground", "ground"}, {NULL, "mirror", "mirror"},
      {NULL, "table", "table"},     {NULL, "paint", "paint"},   {NULL, "phong", "phong"}};
  for (size_t k = 0; k < sizeof skins / sizeof skins[0]; k++) {
    enum { COUNT = 18 };
    struct fixture f;
    fixture_create(&f);
    fixture_material(&f, "blanket", 0.3, 0.3, 0.2, 0.7);
    fixture_material(&f, "cell", 0.05, 0.1, 0.1, 0.05);
    fixture_metal(&f, "metal", 25.3, 89.8, 0.5);
    fixture_metal(&f, "glass", 1.5, 1e-3, 0.02);
    fixture_record(&f, "name: ground\n" METAL "lobe: {kind: ggx, alpha: 0.3}\n");
    fixture_record(&f, "name: mirror\n" METAL "lobe: mirror\n");
    fixture_measured(&f, "table");
    fixture_reflector(&f, "paint", 0.05, 0.6, "surface: {beckmann_alpha: 0.3}\n");
    fixture_reflector(&f, "phong", 0.1, 0.7, "lobe: {kind: phong, alpha: 0.3}\n");
    struct um_geometry_part_spec plate = fixture_part("plate", UM_SHAPE_PLATE, &skins[k]);
    plate.size[0] = plate.size[1] = 1.0;
    fixture_scene(&f, &plate, 1, COUNT);
    f.environment.brightness_temperature = 300.0;
    size_t n = um_geometry_mesh(f.geometry)->nsurface;
    for (size_t i = 0; i < COUNT * n; i++) f.view_factor[i] = 1.0F;
    for (size_t t = 0; t < COUNT; t++) {
      double angle = 5.0 * UM_DEG * ((double)t + 0.1);
      f.samples[t].to_observer = um_vec3(sin(angle), 0.0, cos(angle));
      /* on the ground, looking down */
      f.samples[t].r = um_vec3(0.0, 0.0, -f.environment.earth_radius * (1.0 + 1e-15));
    }
    fixture_run(&f, 1, &fixture_lwir, 1);
    double worst = 0.0;
    for (size_t t = 0; t < COUNT; t++) {
      double sum = fixture_intensity(&f, t, 0, UM_MECHANISM_EMITTED) +
                   fixture_intensity(&f, t, 0, UM_MECHANISM_EARTH);
      double expected = f.samples[t].to_observer.z * um_core_planck_band(8e-6, 12e-6, 300.0);
      worst = fmax(worst, fabs(sum / expected - 1.0));
    }
    print_message("isothermal surroundings, %s: worst %.2g (accepted 5e-7)\n", skins[k].front,
                  worst);
    /* float cosine at 85.5 deg: 0.5 ulp of 0.078 is 4e-9 absolute, 5e-8 relative */
    assert_true(worst <= 5e-7);
    fixture_destroy(&f);
  }
}

/* f_r(i, o) = f_r(o, i) and what is lit and seen is the same both ways: Sun and observer may change
 * places. Exact for a convex body but for float cosines. */
static void test_reciprocity(void **state)
{
  (void)state;
  struct fixture f;
  fixture_create(&f);
  fixture_material(&f, "blanket", 0.3, 0.3, 0.2, 0.7);
  struct um_geometry_part_spec box = fixture_part("bus", UM_SHAPE_BOX, &body_skin);
  box.size[0] = box.size[1] = box.size[2] = 1.0;
  fixture_scene(&f, &box, 1, 2);
  f.samples[0].sun = f.samples[1].to_observer = um_vec3_unit(um_vec3(1.0, 2.0, 0.5));
  f.samples[1].sun = f.samples[0].to_observer = um_vec3_unit(um_vec3(2.0, 0.3, 1.0));
  fixture_run(&f, 1, bands, 1);
  fixture_close("Sun and observer exchanged [W/sr]", fixture_intensity(&f, 0, 0, UM_MECHANISM_SUN),
                fixture_intensity(&f, 1, 0, UM_MECHANISM_SUN), 3e-7);
  fixture_destroy(&f);
}

static void expect_message(struct fixture *f, enum um_status status, enum um_status expected,
                           const char *part)
{
  print_message("  %s\n", um_core_message(f->context));
  assert_int_equal(status, expected);
  assert_non_null(strstr(um_core_message(f->context), part));
  um_core_message_clear(f->context);
}

/* What cannot be computed is refused with its name. */
static void test_refusals(void **state)
{
  (void)state;
  struct fixture f;
  satellite(&f, 2, false);
  fixture_run(&f, 4, bands, 2);
  struct um_optics_view *view = NULL;
  struct um_optics_lightcurve *curve = NULL;
  expect_message(&f, um_optics_view_trace(f.context, f.geometry, f.samples, 2, 0, 0, &view),
                 UM_ERR_INPUT, "0 points");
  f.samples[1].to_observer = um_vec3(0.0, 0.0, 0.0);
  expect_message(&f, um_optics_view_trace(f.context, f.geometry, f.samples, 2, 4, 0, &view),
                 UM_ERR_INPUT, "sample 1");
  assert_null(view);
  struct um_optics_band bad = {"swir", 2e-6, 1e-6, 3, NULL};
  expect_message(&f, um_optics_lightcurve_compute(f.context, &f.scene, &bad, 1, &curve),
                 UM_ERR_INPUT, "'swir'");
  bad = (struct um_optics_band){"mwir", 3e-6, 5e-6, 0, NULL};
  expect_message(&f, um_optics_lightcurve_compute(f.context, &f.scene, &bad, 1, &curve),
                 UM_ERR_INPUT, "'mwir': 0 bins");
  const struct um_materials_record *record = f.record[1];
  f.record[1] = NULL;
  expect_message(&f, um_optics_lightcurve_compute(f.context, &f.scene, bands, 2, &curve),
                 UM_ERR_INPUT, "has no record");
  f.record[1] = record;
  f.temperature[3] = NAN;
  expect_message(&f, um_optics_lightcurve_compute(f.context, &f.scene, bands, 2, &curve),
                 UM_ERR_NUMERIC, "temperature");
  assert_null(curve);
  fixture_destroy(&f);
}

/* Every allocation of a run fails once: UM_ERR_MEMORY, nothing left behind (a sanitizer build sees
 * leaks), and the next run works. */
static void test_memory(void **state)
{
  (void)state;
  struct um_test_memory memory = {0};
  const struct um_core_allocator allocator = um_test_memory_allocator(&memory);
  struct fixture f;
  satellite(&f, 2, true);
  struct um_context *own = f.context, *context;
  assert_int_equal(um_core_context_create(&allocator, &context), UM_OK);
  um_core_context_set_threads(context, 1);
  struct um_optics_image_options options = {8, 2, um_vec3(0.0, 1.0, 0.0)};
  long step = 0;
  for (;; step++) {
    struct um_optics_view *view = NULL;
    struct um_optics_lightcurve *curve = NULL;
    struct um_optics_image *image = NULL;
    um_core_message_clear(context);
    memory.calls = 0;
    memory.fail_call = step + 1;
    enum um_status status = um_optics_view_trace(context, f.geometry, f.samples, 2, 4, 0, &view);
    f.scene.view = view;
    if (status == UM_OK) status = um_optics_lightcurve_compute(context, &f.scene, bands, 2, &curve);
    if (status == UM_OK)
      status = um_optics_image_render(context, &f.scene, 1, bands, 2, &options, &image);
    bool exhausted = memory.calls < memory.fail_call;
    memory.fail_call = 0;
    assert_int_equal(status, exhausted ? UM_OK : UM_ERR_MEMORY);
    if (exhausted) assert_true(view != NULL && curve != NULL && image != NULL);
    um_optics_image_destroy(context, &image);
    um_optics_lightcurve_destroy(context, &curve);
    um_optics_view_destroy(context, &view);
    if (exhausted) break;
  }
  print_message("every one of %ld allocations failed once\n", step);
  assert_true(step > 50);
  um_core_context_destroy(&context);
  f.context = own;
  fixture_destroy(&f);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_sums),       cmocka_unit_test(test_umbra),
      cmocka_unit_test(test_penumbra),   cmocka_unit_test(test_threads),
      cmocka_unit_test(test_isothermal), cmocka_unit_test(test_reciprocity),
      cmocka_unit_test(test_refusals),   cmocka_unit_test(test_memory),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
