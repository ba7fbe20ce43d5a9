/* Light of the Earth: docs/physics/earthlight.md. */
#include <math.h>
#include <stdio.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "tests/optics/fixture.h"

static const struct um_geometry_skin skin = {NULL, "grey", "grey"};

/* Nadir face at 765 km (F 0.797, T_b 270 K): reflected Earth over own emission in 8-12 um. The
 * ratios follow from (1 - eps) F L(270 K) / (eps L(T)); tolerance: half a digit of the printed
 * ratio and of the printed F. */
static void test_reflected_ratio(void **state)
{
  (void)state;
  const double emissivity[] = {0.78, 0.62, 0.85, 0.05, 0.80};
  const double kelvin[] = {240.0, 240.0, 210.0, 280.0, 260.0};
  const double ratio[] = {0.44, 0.96, 0.65, 12.5, 0.25};
  const double half_digit[] = {0.005, 0.005, 0.005, 0.05, 0.005};
  for (size_t k = 0; k < 5; k++) {
    struct fixture f;
    fixture_create(&f);
    fixture_material(&f, "grey", 0.1, 0.0, 0.0, emissivity[k]);
    struct um_geometry_part_spec plate = fixture_part("plate", UM_SHAPE_PLATE, &skin);
    plate.size[0] = plate.size[1] = 1.0;
    fixture_scene(&f, &plate, 1, 1);
    f.environment.brightness_temperature = 270.0;
    size_t n = um_geometry_mesh(f.geometry)->nsurface;
    for (size_t i = 0; i < n; i++) {
      f.temperature[i] = kelvin[k];
      f.view_factor[i] = 0.797F;
    }
    fixture_run(&f, 1, &fixture_lwir, 1);
    double reflected = fixture_intensity(&f, 0, 0, UM_MECHANISM_EARTH);
    fixture_close("reflected Earth / emitted",
                  reflected / fixture_intensity(&f, 0, 0, UM_MECHANISM_EMITTED), ratio[k],
                  half_digit[k] / ratio[k] + 0.0005 / 0.797);
    /* band radiances of docs/physics/earthlight.md: L(270 K) = 22.3839 */
    fixture_close("  reflected [W/sr]", reflected, (1.0 - emissivity[k]) * 0.797 * 22.3839, 4e-6);
    f.environment.earth_reflection_on = false;
    fixture_run(&f, 1, &fixture_lwir, 1);
    assert_true(fixture_intensity(&f, 0, 0, UM_MECHANISM_EARTH) == 0.0);
    fixture_destroy(&f);
  }
}

/* Earthshine: a flux of 0.2366 E_sun (nadir plate over the sub-solar point,
 * docs/physics/earthlight.md), spread like sunlight, reflected by rho_d: rho_d 0.2366 E_band / pi
 * per area. */
static void test_earthshine(void **state)
{
  (void)state;
  struct fixture f;
  fixture_create(&f);
  fixture_material(&f, "grey", 0.2, 0.5, 0.1, 0.8);
  struct um_geometry_part_spec plate = fixture_part("plate", UM_SHAPE_PLATE, &skin);
  plate.size[0] = plate.size[1] = 1.0;
  fixture_scene(&f, &plate, 1, 1);
  size_t n = um_geometry_mesh(f.geometry)->nsurface;
  for (size_t i = 0; i < n; i++) f.albedo[i] = (float)(0.2366 * 1361.0);
  f.samples[0].sunlit_fraction = 0.0; /* the lit Earth is still there */
  fixture_run(&f, 1, &fixture_vis, 1);
  fixture_close("earthshine [W/sr]", fixture_intensity(&f, 0, 0, UM_MECHANISM_EARTH),
                0.2 * 0.2366 * fixture_sun(&f, &fixture_vis) / UM_PI, 1e-7);
  f.environment.earthshine_on = false;
  fixture_run(&f, 1, &fixture_vis, 1);
  assert_true(fixture_intensity(&f, 0, 0, UM_MECHANISM_EARTH) < 1e-20);
  fixture_destroy(&f);
}

/* ---- the Earth in a lobe, by brute force ---- */

#define DEEP  0.6  /* what a lobe reflects here, F */
#define FLAT  0.05 /* beside it, Lambert */
#define ALPHA 0.2

/* Records that state a lobe in one band or both; what they reflect in each. Tables are constant
 * outside; a grey record states its lobe below 2.5 um alone. */
static const struct stated {
  const char *name, *text;
  bool mirror;
  double flat[2], lobe[2]; /* VIS, LWIR */
} stated[] = {
    {"whole",
     "reflectance: {wavelength_um: [0.3, 20], diffuse: [0.05, 0.05], specular: [0.6, 0.6]}\n"
     "surface: {beckmann_alpha: 0.2}\n",
     false,
     {FLAT, FLAT},
     {DEEP, DEEP}},
    {"infrared_alone",
     "reflectance: {wavelength_um: [0.3, 3, 7, 20], diffuse: [0.3, 0.3, 0.05, 0.05], "
     "specular: [0, 0, 0.6, 0.6]}\nsurface: {beckmann_alpha: 0.2}\n",
     false,
     {0.3, FLAT},
     {0.0, DEEP}},
    {"visible_alone",
     "reflectance: {wavelength_um: [0.3, 1, 7, 20], diffuse: [0.05, 0.05, 0.65, 0.65], "
     "specular: [0.6, 0.6, 0, 0]}\nlobe: {alpha: 0.2}\n",
     false,
     {FLAT, FLAT + DEEP},
     {DEEP, 0.0}},
    {"begins_at_9_um",
     "reflectance: {wavelength_um: [9, 20], diffuse: [0.05, 0.05], specular: [0.6, 0.6]}\n"
     "surface: {beckmann_alpha: 0.2}\n",
     false,
     {FLAT, FLAT},
     {DEEP, DEEP}},
    {"ends_at_2_um",
     "reflectance: {wavelength_um: [0.3, 2], diffuse: [0.05, 0.05], specular: [0.6, 0.6]}\n"
     "surface: {beckmann_alpha: 0.2}\n",
     false,
     {FLAT, FLAT},
     {DEEP, DEEP}},
    {"gap",
     "reflectance: {wavelength_um: [0.3, 1, 2, 5, 7, 20], diffuse: [0.05, 0.05, 0.65, 0.65, 0.05, "
     "0.05], specular: [0.6, 0.6, 0, 0, 0.6, 0.6]}\nsurface: {beckmann_alpha: 0.2}\n",
     false,
     {FLAT, FLAT},
     {DEEP, DEEP}},
    {"true_mirror",
     "reflectance: {wavelength_um: [0.3, 20], diffuse: [0.05, 0.05], specular: [0.6, 0.6]}\n"
     "lobe: mirror\n",
     true,
     {FLAT, FLAT},
     {DEEP, DEEP}},
    {"grey",
     "grey: {solar_absorptance: 0.35, emittance: 0.35, vis_reflectance_diffuse: 0.05, "
     "specular_reflectance: 0.6, beckmann_alpha: 0.2}\n",
     false,
     {FLAT, FLAT + DEEP},
     {DEEP, 0.0}},
};

/* 1 + Smith's Lambda of Beckmann's facets (Walter et al. 2007). */
static double shadowed(double cosine)
{
  double tangent = sqrt(1.0 - cosine * cosine) / cosine;
  if (!(tangent > 1e-9)) return 1.0;
  double a = 1.0 / (ALPHA * tangent);
  return 1.0 + 0.5 * (erf(a) - 1.0) + exp(-a * a) / (2.0 * a * sqrt(UM_PI));
}

/* Cook-Torrance with F = 1, separable masking [1/sr]. */
static double cook_torrance(struct um_vec3 i, struct um_vec3 o)
{
  struct um_vec3 h = um_vec3_unit(um_vec3_add(i, o));
  double c2 = h.z * h.z, d = exp(-(1.0 - c2) / (c2 * ALPHA * ALPHA));
  d /= UM_PI * ALPHA * ALPHA * c2 * c2;
  return d / (shadowed(i.z) * shadowed(o.z) * 4.0 * i.z * o.z);
}

/* Sums over the directions of the visible Earth, seen from a plate of normal z: of what falls in,
 * and of what the lobe sends on; uniform, and lit by the Sun. */
struct sums {
  double flat[2], lobe[2]; /* [lit, uniform] */
};

static void add_direction(struct um_vec3 i, struct um_vec3 up, struct um_vec3 sun, struct um_vec3 o,
                          double solid_angle, struct sums *s)
{
  double radiance[2] = {fmax(0.0, um_vec3_dot(up, sun)), 1.0};
  if (!(i.z > 0.0)) return;
  double f = cook_torrance(i, o);
  for (int k = 0; k < 2; k++) {
    s->flat[k] += radiance[k] * i.z * solid_angle;
    s->lobe[k] += radiance[k] * f * i.z * solid_angle;
  }
}

/* h: distance over the Earth's radius. */
static struct sums by_directions(double h, struct um_vec3 nadir, struct um_vec3 sun,
                                 struct um_vec3 o)
{
  enum { RING = 300, AROUND = 600 };
  struct um_vec3 e1, e2;
  struct sums s = {{0.0, 0.0}, {0.0, 0.0}};
  double rho = asin(1.0 / h);
  um_core_vec3_frame(nadir, &e1, &e2);
  for (int a = 0; a < RING; a++) {
    double eta = rho * (a + 0.5) / RING, gamma = asin(h * sin(eta)) - eta; /* at the geocentre */
    for (int b = 0; b < AROUND; b++) {
      double phi = 2.0 * UM_PI * (b + 0.5) / AROUND;
      struct um_vec3 out = um_vec3_axpy(um_vec3_scale(e1, cos(phi)), sin(phi), e2);
      add_direction(um_vec3_axpy(um_vec3_scale(nadir, cos(eta)), sin(eta), out),
                    um_vec3_axpy(um_vec3_scale(nadir, -cos(gamma)), sin(gamma), out), sun, o,
                    sin(eta) * rho / RING * 2.0 * UM_PI / AROUND, &s);
    }
  }
  return s;
}

/* What a mirror shows in place of a lobe: one direction. */
static void mirrored(double h, struct um_vec3 nadir, struct um_vec3 sun, struct um_vec3 o,
                     double lobe[2])
{
  struct um_vec3 i = um_vec3(-o.x, -o.y, o.z);
  double eta = acos(um_vec3_dot(i, nadir)), gamma = asin(fmin(1.0, h * sin(eta))) - eta;
  struct um_vec3 out = um_vec3_unit(um_vec3_axpy(i, -cos(eta), nadir));
  struct um_vec3 up = um_vec3_axpy(um_vec3_scale(nadir, -cos(gamma)), sin(gamma), out);
  bool seen = eta < asin(1.0 / h);
  lobe[0] = seen ? fmax(0.0, um_vec3_dot(up, sun)) : 0.0;
  lobe[1] = seen ? 1.0 : 0.0;
}

static struct um_vec3 from_normal(double zenith, double azimuth)
{
  double z = zenith * UM_DEG, a = azimuth * UM_DEG;
  return um_vec3(sin(z) * cos(a), sin(z) * sin(a), cos(z));
}

/* Places of nadir, observer and Sun [deg from the normal, azimuth]; the lobe looks at the Earth,
 * at its edge, past it. */
static const double place[][6] = {{40, 0, 50, 160, 130, 75},
                                  {45, 0, 20, 90, 110, 300},
                                  {90, 0, 30, 20, 120, 200},
                                  {90, 0, 45, 180, 100, 330},
                                  {120, 0, 10, 0, 60, 30}};
enum { PLACES = sizeof place / sizeof place[0], SURFACES = 8 };

#define H_RATIO (1.0 + 765e3 / UM_EARTH_RADIUS)

static const struct um_optics_band two[] = {{"vis", 0.5e-6, 0.6e-6, 2, NULL},
                                            {"lwir", 10e-6, 10.2e-6, 1, NULL}};

/* A plate before the Earth of the sums. */
static void before_earth(struct fixture *f, const struct stated *record, const struct sums *s,
                         float *brightness)
{
  const struct um_geometry_skin side = {NULL, record->name, record->name};
  struct um_geometry_part_spec plate = fixture_part("plate", UM_SHAPE_PLATE, &side);
  plate.size[0] = plate.size[1] = 1.0;
  fixture_scene(f, &plate, 1, PLACES);
  const struct um_environment *e = &f->environment;
  size_t n = um_geometry_mesh(f->geometry)->nsurface;
  assert_true(n <= SURFACES);
  for (size_t t = 0; t < PLACES; t++) {
    struct um_environment_sample *sample = &f->samples[t];
    sample->r = um_vec3_scale(from_normal(place[t][0], place[t][1]), -H_RATIO * e->earth_radius);
    sample->to_observer = from_normal(place[t][2], place[t][3]);
    sample->sun = from_normal(place[t][4], place[t][5]);
    for (size_t i = t * n; i < (t + 1) * n; i++) {
      f->albedo[i] = (float)(s[t].flat[0] * e->albedo * e->solar_irradiance / UM_PI);
      f->view_factor[i] = (float)(s[t].flat[1] / UM_PI);
      brightness[i] = (float)e->brightness_temperature;
    }
  }
}

static void earth_in_lobe(struct fixture *f, const struct stated *record, const struct sums *s,
                          bool varies)
{
  float brightness[PLACES * SURFACES];
  double worst = 0.0, unit[2] = {f->environment.albedo * fixture_sun(f, &two[0]) / UM_PI,
                                 um_core_planck_band(two[1].from, two[1].to,
                                                     f->environment.brightness_temperature)};
  before_earth(f, record, s, brightness);
  if (varies) f->scene.brightness = brightness;
  fixture_run(f, 1, two, 2);
  f->scene.brightness = NULL;
  for (size_t t = 0; t < PLACES; t++) {
    const struct um_environment_sample *sample = &f->samples[t];
    double lobe[2] = {s[t].lobe[0], s[t].lobe[1]};
    if (record->mirror)
      mirrored(H_RATIO, from_normal(place[t][0], place[t][1]), sample->sun, sample->to_observer,
               lobe);
    for (size_t k = 0; k < 2; k++) {
      double value = fixture_intensity(f, t, k, UM_MECHANISM_EARTH) / sample->to_observer.z;
      double expected = record->flat[k] * s[t].flat[k] / UM_PI + record->lobe[k] * lobe[k];
      double error = fabs(value / unit[k] - expected);
      worst = fmax(worst, error);
      if (!(error <= 0.006))
        fail_msg("%s, place %zu, %s: L/L_E %.4f, by directions %.4f", record->name, t, two[k].name,
                 value / unit[k], expected);
    }
  }
  print_message("the Earth in a lobe, %s: L/L_E at most %.4f off (accepted 0.006)\n", record->name,
                worst);
}

/* The lobe of a record holds at every wavelength for which the record states one: L/L_E of sunlit
 * ground and of the Earth's infrared against sums over the directions of its disc. 0.006: F times
 * the 0.01 of the few facets that light curves take. What is reflected of the infrared as by a
 * Lambert surface would be up to 0.4 off. */
static void test_stated_lobe(void **state)
{
  (void)state;
  struct fixture f;
  struct sums s[PLACES];
  for (size_t t = 0; t < PLACES; t++)
    s[t] =
        by_directions(H_RATIO, from_normal(place[t][0], place[t][1]),
                      from_normal(place[t][4], place[t][5]), from_normal(place[t][2], place[t][3]));
  fixture_create(&f);
  for (size_t k = 0; k < sizeof stated / sizeof stated[0]; k++) {
    char text[512];
    snprintf(text, sizeof text, "name: %s\nsummary: test\ncitation: test\n%s", stated[k].name,
             stated[k].text);
    fixture_record(&f, text);
    earth_in_lobe(&f, &stated[k], s, false);
  }
  earth_in_lobe(&f, &stated[0], s, true);
  fixture_destroy(&f);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_stated_lobe),
      cmocka_unit_test(test_reflected_ratio),
      cmocka_unit_test(test_earthshine),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
