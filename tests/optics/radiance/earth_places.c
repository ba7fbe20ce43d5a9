/* An Earth that differs by place, wavelength and angle, in lobes and before rough plates: light
 * curves against sums over the directions of its disc, whose radiances are asked for one by one.
 * Plates stand tilted; records are a table, a mirror, a metal of n and k, and a grey one. */
#include <math.h>
#include <stdio.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "environment/earth_infrared.h"
#include "environment/ground_view.h"
#include "materials/bsdf.h"
#include "tests/optics/fixture.h"

#define FLAT     0.05
#define DEEP     0.6
#define ALPHA    0.2
#define METAL_N  25.3 /* aluminium at 10 um */
#define METAL_K  89.8
#define H_RATIO  (1.0 + 765e3 / UM_EARTH_RADIUS)
#define BINS     8
#define SURFACES 8

static const struct um_optics_band two[] = {{"vis", 0.5e-6, 0.6e-6, 1, NULL},
                                            {"lwir", 8e-6, 12e-6, BINS, NULL}};

enum kind { TABLE, MIRROR, METAL, GREY, KINDS };
static const char *const names[KINDS] = {"table", "mirror", "metal", "grey"};

/* Nadir, observer and Sun [deg from the normal, azimuth]; lobes look near the nadir, at the limb,
 * across the terminator. */
static const double place[][6] = {{20, 0, 25, 160, 60, 75},
                                  {40, 0, 50, 160, 130, 75},
                                  {60, 30, 20, 90, 110, 300},
                                  {90, 0, 45, 180, 100, 330},
                                  {110, 0, 60, 170, 60, 30}};
enum { PLACES = sizeof place / sizeof place[0] };

/* Of the body frame, in which all sums are made; the satellite stands turned in GCRS. */
static const struct um_vec3 pole = {0.36, 0.48, 0.8}, greenwich = {0.8, -0.6, 0.0};
static const struct um_quat attitude = {0.5, 0.1, -0.7, 0.5}; /* GCRS to body */
static struct um_vec3 of_gcrs(struct um_vec3 body)
{
  return um_quat_apply(um_quat_conjugate(attitude), body);
}
#define TIME 5.2e8 /* [s] */

static struct um_vec3 from_normal(double zenith, double azimuth)
{
  double z = zenith * UM_DEG, a = azimuth * UM_DEG;
  return um_vec3(sin(z) * cos(a), sin(z) * sin(a), cos(z));
}

static double shadowed(double cosine)
{
  double tangent = sqrt(fmax(0.0, 1.0 - cosine * cosine)) / cosine;
  if (!(tangent > 1e-9)) return 1.0;
  double a = 1.0 / (ALPHA * tangent);
  return 1.0 + 0.5 * (erf(a) - 1.0) + exp(-a * a) / (2.0 * a * sqrt(UM_PI));
}

/* Cook-Torrance with F = 1 [1/sr] (tests/optics/radiance/earth.c). */
static double cook_torrance(struct um_vec3 i, struct um_vec3 o, double *cos_d)
{
  struct um_vec3 h = um_vec3_unit(um_vec3_add(i, o));
  double c2 = h.z * h.z, d = exp(-(1.0 - c2) / (c2 * ALPHA * ALPHA));
  *cos_d = um_vec3_dot(i, h);
  d /= UM_PI * ALPHA * ALPHA * c2 * c2;
  return d / (shadowed(i.z) * shadowed(o.z) * 4.0 * i.z * o.z);
}

/* Share of a lobe with F = 1 that facets do not keep back. The infrared has all of it: what a
 * surface does not absorb it reflects (docs/physics/earthlight.md). */
static double whole_lobe(struct um_vec3 o)
{
  enum { RING = 400, AROUND = 400 };
  double sum = 0.0, cos_d;
  for (int a = 0; a < RING; a++)
    for (int b = 0; b < AROUND; b++) {
      double z = (a + 0.5) / RING, s = sqrt(1.0 - z * z), phi = 2.0 * UM_PI * (b + 0.5) / AROUND;
      struct um_vec3 i = um_vec3(s * cos(phi), s * sin(phi), z);
      sum += cook_torrance(i, o, &cos_d) * z * 2.0 * UM_PI / (RING * AROUND);
    }
  return sum;
}

/* Radiance of 8-12 um [W/m^2/sr] and albedo times the Sun's cosine [1] from a direction; toward:
 * back to the satellite. */
struct shown {
  double infrared, lit;
};
static struct shown shown_by(const struct um_environment_ground_view *view, const double *ratio,
                             struct um_vec3 up, struct um_vec3 sun, struct um_vec3 toward,
                             double cosine, double cover)
{
  struct um_environment_ground g = um_environment_ground_at(view, up);
  struct um_environment_ground_parts p = um_environment_ground_split(&g, ratio);
  struct shown out = {0.0, g.albedo * fmax(0.0, um_vec3_dot(up, sun))};
  double c = fmin(fmax(p.cover + cover, 0.0), 1.0);
  out.lit *= um_environment_ground_toward(view, &g, up, sun, toward);
  const int n = 16;
  for (int b = 0; b < n; b++) {
    double from = 8e-6 + 4e-6 * b / n, to = from + 4e-6 / n;
    double clear, cloud, unused;
    um_environment_earth_ratios(from, to, p.surface, &cosine, 1, &clear, &unused);
    um_environment_earth_ratios(from, to, p.top, &cosine, 1, &unused, &cloud);
    out.infrared += (1.0 - c) * clear * um_core_planck_band(from, to, p.surface) +
                    c * cloud * um_core_planck_band(from, to, p.top);
  }
  return out;
}

/* [lit, infrared] by kind of lobe, and without one. */
struct sums {
  double flat[2], lobe[KINDS][2];
};

static struct sums by_directions(const struct um_environment *e, const double *at, double cover)
{
  enum { RING = 40, AROUND = 60 };
  struct um_vec3 nadir = from_normal(at[0], at[1]), o = from_normal(at[2], at[3]);
  struct um_vec3 sun = from_normal(at[4], at[5]), e1, e2;
  struct um_vec3 mirror = um_vec3(-o.x, -o.y, o.z);
  const struct um_environment_globe globe = {TIME, pole, greenwich};
  struct um_environment_ground_view view = um_environment_ground_view(e, &globe, UM_AU);
  double ratio[UM_EARTH_TEMPERATURES], rho = asin(1.0 / H_RATIO);
  struct sums s = {{0.0}, {{0.0}}};
  um_environment_earth_window_fill(ratio);
  um_core_vec3_frame(nadir, &e1, &e2);
  for (int a = 0; a <= RING; a++) { /* the last: where a mirror looks */
    double share = (a + 0.5) / RING, crowded = sqrt(1.0 - (1.0 - share) * (1.0 - share));
    double eta = a < RING ? asin(crowded / H_RATIO) : acos(um_vec3_dot(mirror, nadir));
    double se = H_RATIO * sin(eta), gamma = asin(fmin(se, 1.0)) - eta;
    double low = a / (double)RING, high = (a + 1.0) / RING;
    double width = a < RING ? cos(asin(sqrt(1.0 - (1.0 - low) * (1.0 - low)) / H_RATIO)) -
                                  cos(asin(sqrt(1.0 - (1.0 - high) * (1.0 - high)) / H_RATIO))
                            : 0.0;
    for (int b = 0; b < (a < RING ? AROUND : 1); b++) {
      double phi = 2.0 * UM_PI * (b + 0.5) / AROUND;
      struct um_vec3 out = a < RING ? um_vec3_axpy(um_vec3_scale(e1, cos(phi)), sin(phi), e2)
                                    : um_vec3_unit(um_vec3_axpy(mirror, -cos(eta), nadir));
      struct um_vec3 i = um_vec3_axpy(um_vec3_scale(nadir, cos(eta)), sin(eta), out);
      struct um_vec3 up = um_vec3_axpy(um_vec3_scale(nadir, -cos(gamma)), sin(gamma), out);
      if (!(i.z > 0.0) || (a == RING && eta >= rho)) continue;
      double w = sqrt(fmax(0.0, 1.0 - se * se));
      struct um_vec3 back = um_vec3_scale(i, -1.0);
      struct shown as_is = shown_by(&view, ratio, up, sun, back, w, 0.0);
      struct shown in_lobe = cover != 0.0 ? shown_by(&view, ratio, up, sun, back, w, cover) : as_is;
      if (a == RING) {
        s.lobe[MIRROR][0] = DEEP * in_lobe.lit;
        s.lobe[MIRROR][1] = DEEP * in_lobe.infrared;
        continue;
      }
      double solid_angle = width * 2.0 * UM_PI / AROUND, cos_d;
      double f = cook_torrance(i, o, &cos_d) * i.z * solid_angle;
      double metal = um_materials_fresnel(METAL_N, METAL_K, cos_d);
      s.flat[0] += as_is.lit * i.z * solid_angle;
      s.flat[1] += as_is.infrared * i.z * solid_angle;
      s.lobe[TABLE][0] += DEEP * in_lobe.lit * f;
      s.lobe[TABLE][1] += DEEP * in_lobe.infrared * f;
      s.lobe[METAL][0] += metal * in_lobe.lit * f;
      s.lobe[METAL][1] += metal * in_lobe.infrared * f;
    }
  }
  s.lobe[GREY][0] = s.lobe[TABLE][0];
  double whole = whole_lobe(o);
  s.lobe[TABLE][1] /= whole;
  s.lobe[METAL][1] /= whole;
  return s;
}

static void records_make(struct fixture *f)
{
  fixture_record(f, "name: table\nsummary: test\ncitation: test\n"
                    "reflectance: {wavelength_um: [0.3, 20], diffuse: [0.05, 0.05], "
                    "specular: [0.6, 0.6]}\nsurface: {beckmann_alpha: 0.2}\n");
  fixture_record(f, "name: mirror\nsummary: test\ncitation: test\n"
                    "reflectance: {wavelength_um: [0.3, 20], diffuse: [0.05, 0.05], "
                    "specular: [0.6, 0.6]}\nlobe: mirror\n");
  fixture_metal(f, "metal", METAL_N, METAL_K, ALPHA);
  fixture_material(f, "grey", FLAT, DEEP, ALPHA, 1.0 - FLAT - DEEP);
}

/* A plate that sees the Earth of the place, with the loads that the environment has for it. */
static void scene_make(struct fixture *f, const char *name, float *brightness)
{
  const struct um_geometry_skin side = {NULL, name, name};
  struct um_geometry_part_spec plate = fixture_part("plate", UM_SHAPE_PLATE, &side);
  plate.size[0] = plate.size[1] = 1.0;
  fixture_scene(f, &plate, 1, PLACES);
  const struct um_environment *e = &f->environment;
  const struct um_environment_globe globe = {TIME, pole, greenwich};
  const struct um_vec3 normal = {0.0, 0.0, 1.0};
  size_t n = um_geometry_mesh(f->geometry)->nsurface;
  assert_true(n <= SURFACES);
  for (size_t t = 0; t < PLACES; t++) {
    struct um_environment_sample *sample = &f->samples[t];
    struct um_environment_earth_flux flux;
    struct um_vec3 nadir = from_normal(place[t][0], place[t][1]);
    struct um_vec3 r = um_vec3_scale(nadir, -H_RATIO * e->earth_radius);
    struct um_vec3 sun = from_normal(place[t][4], place[t][5]);
    sample->q = attitude;
    sample->r = of_gcrs(r);
    sample->to_observer = of_gcrs(from_normal(place[t][2], place[t][3]));
    sample->sun = of_gcrs(sun);
    sample->pole = of_gcrs(pole);
    sample->greenwich = of_gcrs(greenwich);
    sample->t_tai = TIME + (double)t * 1e-3;
    um_environment_earth_flux(e, &globe, r, sun, sample->sun_distance, &normal, 1, &flux);
    for (size_t i = t * n; i < (t + 1) * n; i++) {
      f->albedo[i] = (float)flux.albedo;
      f->view_factor[i] = (float)flux.view_factor;
      brightness[i] = (float)flux.brightness;
    }
  }
}

static double off; /* the largest */

/* Light of the Earth within 1 % of what the same plate sends in its brightest place. */
static void hold(struct fixture *f, enum kind kind, double cover, const struct sums *sums)
{
  float brightness[PLACES * SURFACES];
  double expected[PLACES][2], most[2] = {0.0}, worst[2] = {0.0};
  f->environment.mirror_cloud = cover;
  scene_make(f, names[kind], brightness);
  f->scene.brightness = brightness;
  fixture_run(f, 1, two, 2);
  f->scene.brightness = NULL;
  double unit = fixture_sun(f, &two[0]) / UM_PI;
  for (size_t t = 0; t < PLACES; t++) {
    struct sums s = sums[t];
    double flat = kind == METAL ? 0.0 : FLAT;
    expected[t][0] = unit * (flat * s.flat[0] / UM_PI + s.lobe[kind][0]);
    if (kind == GREY) flat += DEEP;
    expected[t][1] = flat * s.flat[1] / UM_PI + s.lobe[kind][1];
    for (int k = 0; k < 2; k++) most[k] = fmax(most[k], expected[t][k]);
  }
  for (size_t t = 0; t < PLACES; t++)
    for (size_t k = 0; k < 2; k++) {
      double value =
          fixture_intensity(f, t, k, UM_MECHANISM_EARTH) / from_normal(place[t][2], place[t][3]).z;
      print_message("  %s, place %zu, %s: %.4g, by directions %.4g\n", names[kind], t, two[k].name,
                    value, expected[t][k]);
      worst[k] = fmax(worst[k], fabs(value - expected[t][k]) / most[k]);
    }
  print_message("%s, cover %+.1f: VIS %.4f, LWIR %.4f of the brightest\n", names[kind], cover,
                worst[0], worst[1]);
  off = fmax(off, fmax(worst[0], worst[1]));
}

static void sums_fill(const struct fixture *f, double cover, struct sums *sums)
{
  for (size_t t = 0; t < PLACES; t++) sums[t] = by_directions(&f->environment, place[t], cover);
}

static void places_in_lobes(void **state)
{
  (void)state;
  struct fixture f;
  struct sums sums[PLACES];
  struct um_environment_daylight *daylight;
  fixture_create(&f);
  f.environment.earth = UM_EARTH_KNOCKE;
  f.environment.multiple_scattering_on = false; /* facets keep back what they throw at others */
  records_make(&f);
  sums_fill(&f, 0.0, sums);
  for (int kind = 0; kind < KINDS; kind++) hold(&f, (enum kind)kind, 0.0, sums);
  sums_fill(&f, 0.5, sums);
  hold(&f, TABLE, 0.5, sums);
  hold(&f, MIRROR, 0.5, sums);
  assert_true(off <= 0.01);
  off = 0.0;
  assert_int_equal(um_environment_daylight_make(f.context, &daylight), UM_OK);
  f.environment.daylight = daylight;
  sums_fill(&f, 0.0, sums);
  for (int kind = 0; kind < KINDS; kind++) hold(&f, (enum kind)kind, 0.0, sums);
  assert_true(off <= 0.02);
  um_core_free(f.context, daylight);
  fixture_destroy(&f);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(places_in_lobes)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
