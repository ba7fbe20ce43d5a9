/* Creased surfaces through the renderer: what they scatter, how they glitter, what stays. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "optics/radiance/creases.h"
#include "tests/optics/fixture.h"

static const struct um_geometry_skin skin = {NULL, "m", "m"};
static const struct um_optics_band line = {"line", 0.599e-6, 0.601e-6, 1, NULL};

/* --- a creased plate ---------------------------------------------------------------------------
 */

struct creased {
  struct fixture f;
  struct um_optics_creases *creases;
};

static void plate(struct creased *c, double size, double facet, size_t ntime)
{
  struct um_geometry_part_spec part = fixture_part("plate", UM_SHAPE_PLATE, &skin);
  part.size[0] = part.size[1] = size;
  part.facet_size = facet;
  fixture_scene(&c->f, &part, 1, ntime);
}

static enum um_status try_crease(struct creased *c, double tilt_deg, double patch, uint64_t seed)
{
  double tilt = tilt_deg * UM_DEG;
  const struct um_geometry_creasing creasing = {
      .tilt_square = tilt * tilt, .patch = patch, .seed = seed, .sheet = true};
  um_optics_creases_destroy(c->f.context, &c->creases);
  enum um_status status =
      um_optics_creases_create(c->f.context, c->f.geometry, &creasing, c->f.record, &c->creases);
  c->f.scene.creases = c->creases;
  return status;
}

static void crease(struct creased *c, double tilt_deg, double patch, uint64_t seed)
{
  FIXTURE_OK(&c->f, try_crease(c, tilt_deg, patch, seed));
}

static void release(struct creased *c)
{
  um_optics_creases_destroy(c->f.context, &c->creases);
  fixture_destroy(&c->f);
}

static struct um_vec3 direction(double zenith, double azimuth)
{
  return um_vec3(sin(zenith) * cos(azimuth), sin(zenith) * sin(azimuth), cos(zenith));
}

static double sun(const struct creased *c, size_t t)
{
  return fixture_intensity(&c->f, t, 0, UM_MECHANISM_SUN);
}

/* Aluminium at 0.6 um, Rakic 1995 rounded. */
static void put_metal(struct creased *c, double alpha)
{
  fixture_create(&c->f);
  um_core_context_set_threads(c->f.context, 1); /* runs too short to share */
  c->creases = NULL;
  fixture_metal(&c->f, "m", 1.3, 7.4, alpha);
}

/* Patches too small to tell apart are the wider lobe: the record of that alpha, but
 * for the emissivity, which stays the smooth record's, and with it the sum of lobe and what masking
 * keeps back: 1e-5. */
static void small_patches_are_the_wider_lobe(void **state)
{
  (void)state;
  double s = tan(10.0 * UM_DEG), wide = sqrt(0.0296 * 0.0296 + 2.0 * s * s);
  struct creased a, b;
  put_metal(&a, 0.0296);
  put_metal(&b, wide);
  for (int k = 0; k < 2; k++) {
    struct creased *c = k == 0 ? &a : &b;
    plate(c, 1.0, 0.0, 12);
    for (size_t t = 0; t < 12; t++) {
      c->f.samples[t].sun = direction(30.0 * UM_DEG, 0.0);
      c->f.samples[t].to_observer = direction(6.0 * UM_DEG * (double)t, UM_PI);
    }
    if (k == 0) crease(c, 10.0, 0.0, 1);
    fixture_run(&c->f, 1, &line, 1);
  }
  for (size_t t = 0; t < 12; t++) fixture_close("light", sun(&a, t), sun(&b, t), 1e-5);
  release(&a);
  release(&b);
}

/* What is reflected of sunlight, over all observers, is what is not absorbed: 1 - emissivity, of
 * patches as of the wider lobe. Observers stand on slopes of half vectors, dense where the lobe is;
 * at 20 deg incidence; 900 patches. Midpoints in slopes over +-6 standard deviations; masking keeps
 * back less than 1e-3 here and is scattered, which the rest of the sphere would add: 2e-3. */
static void energy_of_patches(void **state)
{
  enum { N = 61 };
  (void)state;
  struct creased c;
  double s = tan(4.0 * UM_DEG), alpha = 0.08, wide = sqrt(alpha * alpha + 2.0 * s * s);
  double reach = 4.2 * wide, step = 2.0 * reach / N, incidence = 20.0 * UM_DEG;
  static const double patch[] = {0.0, 1.0 / 30.0};
  struct um_vec3 i = direction(incidence, 0.0);
  put_metal(&c, alpha);
  plate(&c, 1.0, 0.0, N * N);
  double *weight = calloc(N * N, sizeof *weight);
  assert_non_null(weight);
  for (size_t t = 0; t < N * N; t++) {
    double x = -reach + ((double)(t % N) + 0.5) * step, y = -reach + ((double)(t / N) + 0.5) * step;
    struct um_vec3 h = um_vec3_unit(um_vec3(x, y, 1.0));
    double d = um_vec3_dot(i, h);
    c.f.samples[t].sun = i;
    c.f.samples[t].to_observer = um_vec3_axpy(um_vec3_scale(i, -1.0), 2.0 * d, h);
    /* dw_o = 4 (i.h) dw_h, dw_h = cos_h^3 dx dy */
    weight[t] = 4.0 * d * h.z * h.z * h.z * step * step;
    if (!(d > 0.0 && c.f.samples[t].to_observer.z > 0.0)) weight[t] = 0.0;
    if (weight[t] == 0.0) c.f.samples[t].to_observer = um_vec3(0.0, 0.0, 1.0);
  }
  double reflected[2] = {0.0, 0.0};
  for (int k = 0; k < 2; k++) {
    crease(&c, 4.0, patch[k], 3);
    fixture_run(&c.f, 1, &line, 1);
    for (size_t t = 0; t < N * N; t++) reflected[k] += weight[t] * sun(&c, t);
    reflected[k] /= fixture_sun(&c.f, &line) * cos(incidence);
  }
  double kept = 1.0 - um_materials_emissivity(c.f.record[0], NULL, 0.6e-6, cos(incidence));
  print_message("reflected: patches %.5f, wider lobe %.5f, not absorbed %.5f\n", reflected[1],
                reflected[0], kept);
  fixture_close("wider lobe", reflected[0], kept, 2e-3);
  fixture_close("patches", reflected[1], reflected[0], 2e-3);
  free(weight);
  release(&c);
}

/* --- patches -----------------------------------------------------------------------------------
 */

/* The same squares whatever the facets are, the same light when body, Sun and observer are turned
 * together, another with another seed; shares are single precision: 1e-6. */
static void patches_belong_to_the_part(void **state)
{
  (void)state;
  double light[4];
  for (int k = 0; k < 4; k++) {
    struct creased c;
    put_metal(&c, 0.03);
    plate(&c, 2.0, k == 1 ? 0.23 : 0.0, 1);
    struct um_vec3 i = direction(0.4, 1.0), o = direction(0.45, 1.0 + UM_PI);
    struct um_quat turn = um_quat_from_axis(um_vec3_unit(um_vec3(1, 2, 3)), k == 2 ? 1.3 : 0.0);
    c.f.samples[0].q = turn;
    c.f.samples[0].sun = um_quat_apply(um_quat_conjugate(turn), i);
    c.f.samples[0].to_observer = um_quat_apply(um_quat_conjugate(turn), o);
    crease(&c, 3.0, 0.1, k == 3 ? 6 : 5);
    fixture_run(&c.f, 1, &line, 1);
    light[k] = sun(&c, 0);
    release(&c);
  }
  fixture_close("finer facets", light[1], light[0], 2e-6);
  fixture_close("turned", light[2], light[0], 2e-6);
  assert_true(fabs(light[3] / light[0] - 1.0) > 1e-3);
}

/* 1 m^2 in squares of 0.1 m, one corner of the grid in the middle: 100 of them, of which the ten on
 * the diagonal belong to both triangles. Slopes have the stated variance, 110 of them within 4
 * sqrt(2/110); shares add up to 1. */
static void squares_of_a_plate(void **state)
{
  (void)state;
  struct creased c;
  put_metal(&c, 0.03);
  plate(&c, 1.0, 0.0, 1);
  crease(&c, 5.0, 0.1, 1);
  const struct um_geometry_creases *p = c.creases->patches;
  double square = 0.0, s = tan(5.0 * UM_DEG);
  /* front and back are surfaces of their own */
  assert_int_equal(p->nsurface, 4);
  assert_int_equal(p->first[4], 220);
  for (size_t surface = 0; surface < 4; surface++) {
    double sum = 0.0;
    for (size_t k = p->first[surface]; k < p->first[surface + 1]; k++) {
      sum += (double)p->share[k];
      square +=
          (double)p->along[k] * (double)p->along[k] + (double)p->across[k] * (double)p->across[k];
    }
    fixture_close("shares", sum, 1.0, 1e-6);
  }
  fixture_close("variance", square / 440.0, s * s, 4.0 * sqrt(2.0 / 400.0));
  release(&c);
}

/* A shower of glints: over 200 seeds the light of a plate of 6400 squares toward the mirror
 * direction has the wider lobe's mean, and varies as the mean of N_eff events, N_eff = N v (v + 2
 * s^2)/s^4, v = alpha^2/2 (docs/physics/creases.md). 4 standard errors each; excess kurtosis below
 * 0.2. */
static void shower_of_glints(void **state)
{
  enum { SEEDS = 200 };
  (void)state;
  struct creased c;
  double alpha = 0.05, s2 = pow(tan(5.0 * UM_DEG), 2.0), disc = UM_SOLAR_RADIUS / UM_AU;
  double v = 0.5 * alpha * alpha + disc * disc / 16.0,
         events = 6400.0 * v * (v + 2.0 * s2) / s2 / s2;
  double sum = 0.0, square = 0.0;
  put_metal(&c, alpha);
  plate(&c, 4.0, 0.0, 1);
  c.f.samples[0].sun = direction(0.5, 0.0);
  c.f.samples[0].to_observer = direction(0.5, UM_PI);
  crease(&c, 5.0, 0.0, 1);
  fixture_run(&c.f, 1, &line, 1);
  double mean = sun(&c, 0);
  for (uint64_t seed = 0; seed < SEEDS; seed++) {
    crease(&c, 5.0, 0.05, seed);
    fixture_run(&c.f, 1, &line, 1);
    double x = sun(&c, 0) / mean - 1.0;
    sum += x / SEEDS;
    square += x * x / SEEDS;
  }
  print_message("events %.0f: mean %+.4f, fluctuation %.4f, expected %.4f\n", events, sum,
                sqrt(square), 1.0 / sqrt(events));
  assert_true(fabs(sum) <= 4.0 / sqrt(events * SEEDS));
  assert_true(fabs(square * events - 1.0) <= 4.0 * sqrt(2.2 / SEEDS));
  release(&c);
}

/* Where more than 1e4 patches of a facet mirror at once nothing is drawn; nor where tilt or patch
 * are 0, or where nothing has a lobe. Too many patches are refused by the name of their part. */
static void what_is_drawn(void **state)
{
  (void)state;
  struct creased c;
  put_metal(&c, 0.05);
  plate(&c, 4.0, 0.0, 1);
  crease(&c, 5.0, 0.01, 1); /* facets of 8 m^2: 80000 patches, 28000 events */
  assert_int_equal(c.creases->patches->first[c.creases->patches->nsurface], 0);
  crease(&c, 5.0, 0.05, 1);
  assert_true(c.creases->patches->first[c.creases->patches->nsurface] > 12800);
  assert_int_equal(c.creases->nskin, 2);
  crease(&c, 0.0, 0.05, 1);
  assert_null(c.creases);
  plate(&c, 200.0, 2.0, 1);
  assert_int_equal(try_crease(&c, 29.0, 0.01, 1), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(c.f.context), "part 'plate': patches of 0.01 m"));
  release(&c);
  fixture_create(&c.f);
  fixture_material(&c.f, "m", 0.3, 0.0, 0.0, 0.7);
  plate(&c, 1.0, 0.0, 1);
  crease(&c, 5.0, 0.05, 1);
  assert_null(c.creases);
  release(&c);
}

/* Kirchhoff on creased sheet: emission and the reflection of surroundings of its own temperature
 * are those of a black body at every angle; float cosines leave 5e-7 as on flat ones (law.c). */
static void isothermal(void **state)
{
  enum { COUNT = 18 };
  (void)state;
  for (int k = 0; k < 2; k++) {
    struct creased c;
    fixture_create(&c.f);
    c.creases = NULL;
    fixture_metal(&c.f, "m", k == 0 ? 25.3 : 1.5, k == 0 ? 89.8 : 1e-3, 0.03);
    plate(&c, 1.0, 0.0, COUNT);
    crease(&c, 8.0, 0.1, 1);
    c.f.environment.brightness_temperature = 300.0;
    for (size_t s = 0; s < COUNT * 4; s++) c.f.view_factor[s] = 1.0F;
    for (size_t t = 0; t < COUNT; t++) {
      c.f.samples[t].to_observer = direction(5.0 * UM_DEG * ((double)t + 0.1), 0.0);
      c.f.samples[t].r = um_vec3(0.0, 0.0, -c.f.environment.earth_radius * (1.0 + 1e-15));
    }
    fixture_run(&c.f, 1, &fixture_lwir, 1);
    for (size_t t = 0; t < COUNT; t++) {
      double sum = fixture_intensity(&c.f, t, 0, UM_MECHANISM_EMITTED) +
                   fixture_intensity(&c.f, t, 0, UM_MECHANISM_EARTH);
      fixture_close("isothermal", sum,
                    c.f.samples[t].to_observer.z * um_core_planck_band(8e-6, 12e-6, 300.0), 5e-7);
    }
    release(&c);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(small_patches_are_the_wider_lobe),
      cmocka_unit_test(energy_of_patches),
      cmocka_unit_test(patches_belong_to_the_part),
      cmocka_unit_test(squares_of_a_plate),
      cmocka_unit_test(shower_of_glints),
      cmocka_unit_test(what_is_drawn),
      cmocka_unit_test(isothermal),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
