/* Effects on optical properties, seen on one plate that nothing shadows: they change what they say
 * by the factor they say, and no temperature.
 *
 *        Sun   n    observer        I_sun = A cos_i cos_o E (rho_d/pi + F D G/(4 cos_i cos_o))
 *          \  |  /                  I_emitted = A cos_o eps B(T)
 *           \ | /                   I_earth (8-12 um) = A cos_o (1 - eps) F_earth B(T_b)
 *      ------------------
 * Sums over bins and facets leave 1e-12; what a test adds to that is said there. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "materials/bsdf.h"
#include "tests/effects/case.h"
#include "tests/support/cmocka_all.h"

#define PANEL "grey_panel"

static const char *const bands[] = {"vis", "lwir"};

static double intensity(const struct case_run *run, const char *band, int mechanism)
{
  return case_intensity(run, 1, band, PANEL, mechanism);
}

/* All mechanisms of both bands are the same to the bit, but those of a mask, bit 8 band + m. */
static void expect_same_but(const struct case_run *a, const struct case_run *b, unsigned changed)
{
  for (unsigned band = 0; band < 2; band++)
    for (int m = 0; m < UM_MECHANISM_COUNT; m++) {
      double x = intensity(a, bands[band], m), y = intensity(b, bands[band], m);
      bool same = memcmp(&x, &y, sizeof x) == 0,
           wanted = (changed >> (8 * band + (unsigned)m) & 1) == 0;
      if (same != wanted) fail_msg("%s, mechanism %d: %.17g became %.17g", bands[band], m, x, y);
    }
  assert_true(case_same_temperatures(a, b));
}
#define BIT(band, mechanism) (1u << (8u * (band) + (unsigned)(mechanism)))

static void band_emissivity_scales_emission(void **state)
{
  (void)state;
  const double eps = 0.85, factor = 0.9;
  struct case_run a = case_with(case_plate, NULL);
  struct case_run b = case_with(case_plate, "band_emissivity:" PANEL ",factor=0.9");
  /* grey panels have rho_d = 1 - eps beyond 2.5 um, so reflected sunlight and albedo rise too */
  assert_true(case_same_temperatures(&a, &b));
  for (int m = 0; m < UM_MECHANISM_COUNT; m++)
    case_near("vis", intensity(&b, "vis", m), intensity(&a, "vis", m), m == UM_MECHANISM_EMITTED);
  case_near("emitted", intensity(&b, "lwir", UM_MECHANISM_EMITTED),
            factor * intensity(&a, "lwir", UM_MECHANISM_EMITTED), 1e-12);
  case_near("earth", intensity(&b, "lwir", UM_MECHANISM_EARTH),
            (1.0 - factor * eps) / (1.0 - eps) * intensity(&a, "lwir", UM_MECHANISM_EARTH), 1e-12);
  case_release(&a);
  case_release(&b);
}

/* Cosines of one observation at the plate's front. */
static void cosines(const struct case_run *run, double *cos_i, double *cos_o, double *cos_h)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(run->model->geometry);
  const struct um_environment_sample *s = &run->tables->sample[1];
  struct um_geometry_pose *pose = NULL;
  assert_int_equal(um_geometry_pose_create(case_context(), run->model->geometry, NULL, &pose),
                   UM_OK);
  struct um_vec3 n = um_geometry_surface_normal(mesh, pose, 0);
  assert_int_equal(mesh->surface[0].back, 0);
  struct um_vec3 sun = um_quat_apply(s->q, s->sun), observer = um_quat_apply(s->q, s->to_observer);
  um_geometry_pose_destroy(case_context(), &pose);
  *cos_i = um_vec3_dot(n, sun);
  *cos_o = um_vec3_dot(n, observer);
  *cos_h = um_vec3_dot(n, um_vec3_unit(um_vec3_add(sun, observer)));
}

/* eps' = eps (1 + d (1 - 21 (1 - cos_o)^5)/20); the renderer interpolates it over angles by cubics
 * on 49 nodes, whose error is (9/16) h^4 f''''/24 < 1e-6. */
static void directional_emissivity_follows_the_angle(void **state)
{
  (void)state;
  const double eps = 0.85, d = -0.8;
  double cos_i, cos_o, cos_h;
  struct case_run a = case_with(case_plate, NULL);
  struct case_run b = case_with(case_plate, "directional_emissivity:" PANEL ",tilt=-0.8");
  cosines(&a, &cos_i, &cos_o, &cos_h);
  double factor = 1.0 + d * (1.0 - 21.0 * pow(1.0 - cos_o, 5.0)) / 20.0;
  assert_true(factor < 0.98);
  assert_true(case_same_temperatures(&a, &b));
  assert_true(intensity(&a, "vis", UM_MECHANISM_SUN) == intensity(&b, "vis", UM_MECHANISM_SUN));
  assert_true(intensity(&a, "lwir", UM_MECHANISM_SUN) == intensity(&b, "lwir", UM_MECHANISM_SUN));
  case_near("emitted", intensity(&b, "lwir", UM_MECHANISM_EMITTED),
            factor * intensity(&a, "lwir", UM_MECHANISM_EMITTED), 1e-6);
  /* the reflected Earth alone, as a rough surface has it: without earthshine and mirror */
  static const char *const dark[] = {"earthshine", "earthlight_lobe", NULL},
                           *const with[] = {"directional_emissivity:" PANEL ",tilt=-0.8", NULL};
  case_release(&a);
  case_release(&b);
  a = case_compute(case_plate, NULL, dark, NULL);
  b = case_compute(case_plate, with, dark, NULL);
  case_near("earth", intensity(&b, "lwir", UM_MECHANISM_EARTH),
            (1.0 - factor * eps) / (1.0 - eps) * intensity(&a, "lwir", UM_MECHANISM_EARTH), 1e-5);
  case_release(&a);
  case_release(&b);
}

/* I = I_diffuse + F I_lobe + what the Earth sends; the parts come from factors of zero. */
static void levels_are_linear(void **state)
{
  (void)state;
  struct case_run full = case_with(case_plate, NULL);
  struct case_run diffuse = case_with(case_plate, "specular_level:" PANEL ",factor=0");
  struct case_run lobe = case_with(case_plate, "diffuse_level:" PANEL ",factor=0");
  struct case_run more = case_with(case_plate, "specular_level:" PANEL ",factor=1.3");
  struct case_run less = case_with(case_plate, "diffuse_level:" PANEL ",factor=0.6");
  const int sun = UM_MECHANISM_SUN, earth = UM_MECHANISM_EARTH;
  double d = intensity(&diffuse, "vis", sun), l = intensity(&lobe, "vis", sun);
  assert_true(d > 0.0 && l > 0.1 * d);
  case_near("sum", d + l, intensity(&full, "vis", sun), 1e-12);
  case_near("specular_level", intensity(&more, "vis", sun), d + 1.3 * l, 1e-12);
  case_near("diffuse_level", intensity(&less, "vis", sun), 0.6 * d + l, 1e-12);
  case_near("earthshine", intensity(&less, "vis", earth), 0.6 * intensity(&full, "vis", earth),
            1e-12);
  expect_same_but(&full, &more, BIT(0, sun));
  expect_same_but(&full, &less, BIT(0, sun) | BIT(0, earth));
  case_release(&full);
  case_release(&diffuse);
  case_release(&lobe);
  case_release(&more);
  case_release(&less);
}

/* The lobe alone: D G/(4 cos_i cos_o) of alpha' over that of alpha, both widened by the Sun's disc,
 * alpha^2 + (R_sun/d)^2/8. */
static void roughness_widens_the_lobe(void **state)
{
  (void)state;
  static const char *const smooth[] = {"diffuse_level:" PANEL ",factor=0", NULL},
                           *const rough[] = {"diffuse_level:" PANEL ",factor=0",
                                             "roughness:" PANEL ",factor=1.4", NULL};
  struct case_run a = case_compute(case_plate, smooth, NULL, NULL);
  struct case_run b = case_compute(case_plate, rough, NULL, NULL);
  double cos_i, cos_o, cos_h, disc = asin(6.957e8 / a.tables->sample[1].sun_distance);
  double alpha = sqrt(0.265 * 0.265 + disc * disc / 8.0);
  double wide = sqrt(1.4 * 0.265 * 1.4 * 0.265 + disc * disc / 8.0);
  cosines(&a, &cos_i, &cos_o, &cos_h);
  double ratio = um_materials_beckmann_lobe(wide, cos_h, cos_i, cos_o) /
                 um_materials_beckmann_lobe(alpha, cos_h, cos_i, cos_o);
  assert_true(fabs(ratio - 1.0) > 0.1);
  case_near("lobe", intensity(&b, "vis", UM_MECHANISM_SUN),
            ratio * intensity(&a, "vis", UM_MECHANISM_SUN), 1e-10);
  expect_same_but(&a, &b, BIT(0, UM_MECHANISM_SUN));
  case_release(&a);
  case_release(&b);
}

/* Across the grain, x of the plate, the lobe is as wide as said: D of two roughnesses, with
 * slopes p and q of the half vector, exp(-p^2/a^2 - q^2/b^2)/(pi a b cos^4), and Smith's masking by
 * the roughness toward each direction (Heitz 2014, 5.4); without the factor the same bits. */
static void anisotropy_goes_across_the_grain(void **state)
{
  (void)state;
  static const char *const round[] = {"diffuse_level:" PANEL ",factor=0", NULL},
                           *const drawn[] = {"diffuse_level:" PANEL ",factor=0",
                                             "anisotropy:" PANEL ",factor=1.6", NULL},
                           *const none[] = {"diffuse_level:" PANEL ",factor=0",
                                            "anisotropy:" PANEL ",factor=1", NULL};
  struct case_run a = case_compute(case_plate, round, NULL, NULL);
  struct case_run b = case_compute(case_plate, drawn, NULL, NULL);
  struct case_run c = case_compute(case_plate, none, NULL, NULL);
  assert_true(case_same(&a, &c));
  const struct um_environment_sample *s = &a.tables->sample[1];
  struct um_quat to_part[1];
  um_geometry_part_rotations(a.model->geometry, NULL, to_part);
  struct um_vec3 i = um_quat_apply(to_part[0], um_quat_apply(s->q, s->sun)),
                 o = um_quat_apply(to_part[0], um_quat_apply(s->q, s->to_observer)),
                 h = um_vec3_unit(um_vec3_add(i, o));
  double disc = asin(6.957e8 / s->sun_distance), value[2];
  for (int k = 0; k < 2; k++) {
    double x = 0.265, y = k == 0 ? x : 1.6 * x;
    x = sqrt(x * x + disc * disc / 8.0);
    y = sqrt(y * y + disc * disc / 8.0);
    double p = h.x / h.z, q = h.y / h.z;
    value[k] = exp(-p * p / (x * x) - q * q / (y * y)) / (x * y);
    const struct um_vec3 both[] = {i, o};
    for (int d = 0; d < 2; d++) {
      double sine = hypot(both[d].x, both[d].y);
      double toward = hypot(x * both[d].x, y * both[d].y) / sine;
      value[k] *= um_materials_beckmann_masking(toward, both[d].z);
    }
  }
  assert_true(fabs(value[1] / value[0] - 1.0) > 0.1);
  case_near("lobe", intensity(&b, "vis", UM_MECHANISM_SUN),
            value[1] / value[0] * intensity(&a, "vis", UM_MECHANISM_SUN), 1e-6);
  expect_same_but(&a, &b, BIT(0, UM_MECHANISM_SUN));
  case_release(&a);
  case_release(&b);
  case_release(&c);
}

/* The library's Kapton, twice as thick, written to a file. */
static void write_thicker(const char *file_name)
{
  static char text[20000];
  FILE *file = fopen(UMBRA_SOURCE_DIR "/materials/library/mli_kapton.yaml", "r");
  assert_non_null(file);
  text[fread(text, 1, sizeof text - 1, file)] = '\0';
  fclose(file);
  char *thickness = strstr(text, "thickness_um: 25.4\n");
  assert_non_null(thickness);
  memcpy(thickness, "thickness_um: 50.8", 18);
  case_write(file_name, text);
}

/* Heat and light of a film made twice as thick by the effect are those of a record that says so,
 * bit for bit, and other than before. */
static void thin_film_is_a_thicker_record(void **state)
{
  (void)state;
  static const char *const thick[] = {"thin_film:mli_kapton,factor=2", NULL},
                           *const same[] = {"thin_film:mli_kapton,factor=1", NULL},
                           *const front[] = {"parts.0.front=mli_kapton", NULL},
                           *const own[] = {"parts.0.front=mli_kapton",
                                           "material_files=[thicker.yaml]", NULL};
  write_thicker("thicker.yaml");
  struct case_run a = case_compute(case_plate, NULL, NULL, front);
  struct case_run b = case_compute(case_plate, thick, NULL, front);
  struct case_run c = case_compute(case_plate, NULL, NULL, own);
  struct case_run d = case_compute(case_plate, same, NULL, front);
  remove("thicker.yaml");
  assert_true(case_same(&b, &c));
  assert_true(case_same(&a, &d));
  assert_false(case_same_temperatures(&a, &b));
  double thin = case_intensity(&a, 1, "lwir", "mli_kapton", UM_MECHANISM_EMITTED);
  assert_true(case_intensity(&b, 1, "lwir", "mli_kapton", UM_MECHANISM_EMITTED) > 1.1 * thin);
  case_release(&a);
  case_release(&b);
  case_release(&c);
  case_release(&d);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(band_emissivity_scales_emission),
      cmocka_unit_test(directional_emissivity_follows_the_angle),
      cmocka_unit_test(levels_are_linear),
      cmocka_unit_test(roughness_widens_the_lobe),
      cmocka_unit_test(anisotropy_goes_across_the_grain),
      cmocka_unit_test(thin_film_is_a_thicker_record),
  };
  return cmocka_run_group_tests(tests, case_begin, case_end);
}
