/* Light curves of bodies with closed forms. Source: docs/physics/light-curves.md (phase functions
 * of Lambert sphere, cylinder and plate, Cook-Torrance plate, thermal anchors), each checked there
 * by independent quadrature. */
#include <math.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "tests/optics/fixture.h"

static const struct um_geometry_skin grey = {NULL, "grey", "grey"};
static const struct um_geometry_skin grey_closed = {NULL, "grey", NULL};

static struct um_vec3 polar(double theta, double phi)
{
  return um_vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
}

/* (2/3 pi) [sin g + (pi - g) cos g] */
static double sphere_phase(double g)
{
  return 2.0 / (3.0 * UM_PI) * (sin(g) + (UM_PI - g) * cos(g));
}

/* I = E a A cos_i cos_o / pi. Cosines are kept as float: 6e-8 each. */
static void test_flat_lambert(void **state)
{
  (void)state;
  struct fixture f;
  fixture_create(&f);
  fixture_material(&f, "grey", 0.2, 0.0, 0.0, 0.8);
  struct um_geometry_part_spec plate = fixture_part("plate", UM_SHAPE_PLATE, &grey);
  plate.size[0] = 2.0;
  plate.size[1] = 3.0;
  fixture_scene(&f, &plate, 1, 3);
  const double i[] = {30.0, 70.0, 120.0}, o[] = {50.0, 10.0, 40.0};
  for (size_t t = 0; t < 3; t++) {
    f.samples[t].sun = polar(i[t] * UM_DEG, 1.0);
    f.samples[t].to_observer = polar(o[t] * UM_DEG, -2.0);
  }
  fixture_run(&f, 1, &fixture_vis, 1);
  double e = fixture_sun(&f, &fixture_vis);
  for (size_t t = 0; t < 2; t++) {
    double expected = e * 0.2 * 6.0 / UM_PI * cos(i[t] * UM_DEG) * cos(o[t] * UM_DEG);
    fixture_close("flat Lambert plate [W/sr]", fixture_intensity(&f, t, 0, UM_MECHANISM_SUN),
                  expected, 3e-7);
  }
  /* lit from behind */
  assert_true(fixture_intensity(&f, 2, 0, UM_MECHANISM_SUN) == 0.0);
  fixture_destroy(&f);
}

/* RMS relative error over phase angles and orientations of a sphere of facets; returns their mean
 * size through *size. */
static double sphere_error(struct fixture *f, double facet_size, double *size)
{
  static const double phase[] = {10.0, 30.0, 60.0, 90.0};
  struct um_geometry_part_spec sphere = fixture_part("sphere", UM_SHAPE_SPHERE, &grey_closed);
  sphere.radius = 1.0;
  sphere.facet_size = facet_size;
  fixture_scene(f, &sphere, 1, 64);
  for (size_t t = 0; t < 64; t++) {
    struct um_vec3 s =
        polar(acos(1.0 - 2.0 * ((double)(t / 4) + 0.5) / 16.0), 2.4 * (double)(t / 4));
    /* turned by the phase angle toward some side */
    struct um_vec3 side, other;
    um_core_vec3_frame(s, &side, &other);
    double g = phase[t % 4] * UM_DEG;
    f->samples[t].sun = s;
    f->samples[t].to_observer = um_vec3_axpy(um_vec3_scale(s, cos(g)), sin(g), side);
  }
  fixture_run(f, 1, &fixture_vis, 1);
  double sum = 0.0, e = fixture_sun(f, &fixture_vis);
  for (size_t t = 0; t < 64; t++) {
    double p = fixture_intensity(f, t, 0, UM_MECHANISM_SUN) / (e * 0.2);
    double error = p / sphere_phase(phase[t % 4] * UM_DEG) - 1.0;
    sum += error * error / 64.0;
  }
  *size = 1.0 / sqrt((double)um_geometry_mesh(f->geometry)->nfacet);
  return sqrt(sum);
}

/* Facets of size h leave an error of order h^2. The terminator falls irregularly across facets,
 * hence 16 orientations and a bracket of +-0.3 on the order observed from the coarsest to the
 * finest; 2e-4 at the finest is the bound that its h^2 (facet angle 0.1 rad squared over 50)
 * suggests. */
static void test_lambert_sphere(void **state)
{
  (void)state;
  const double facet[] = {0.4, 0.2, 0.1};
  double error[3], size[3];
  struct fixture f;
  fixture_create(&f);
  fixture_material(&f, "grey", 0.2, 0.0, 0.0, 0.8);
  for (int i = 0; i < 3; i++) error[i] = sphere_error(&f, facet[i], &size[i]);
  double order = log(error[0] / error[2]) / log(size[0] / size[2]);
  print_message("Lambert sphere: rms errors %.3g %.3g %.3g, observed order %.2f\n", error[0],
                error[1], error[2], order);
  assert_true(fabs(order - 2.0) <= 0.3);
  assert_true(error[2] <= 2e-4);
  fixture_destroy(&f);
}

/* Broadside I = (E a r L / 2 pi) [sin g + (pi - g) cos g]; N facets around: O(1/N^2). */
static void test_lambert_cylinder(void **state)
{
  (void)state;
  struct fixture f;
  fixture_create(&f);
  fixture_material(&f, "grey", 0.3, 0.0, 0.0, 0.8);
  struct um_geometry_part_spec cylinder = fixture_part("can", UM_SHAPE_CYLINDER, &grey_closed);
  cylinder.radius = 0.5;
  cylinder.height = 2.0;
  cylinder.facet_size = 0.05;
  fixture_scene(&f, &cylinder, 1, 3);
  for (size_t t = 0; t < 3; t++) {
    f.samples[t].sun = polar(0.5 * UM_PI, 0.2);
    f.samples[t].to_observer = polar(0.5 * UM_PI, 0.2 + 60.0 * UM_DEG * (double)t);
  }
  fixture_run(&f, 1, &fixture_vis, 1);
  double e = fixture_sun(&f, &fixture_vis);
  for (size_t t = 0; t < 3; t++) {
    double g = 60.0 * UM_DEG * (double)t;
    double expected = e * 0.3 * 0.5 * 2.0 / (2.0 * UM_PI) * (sin(g) + (UM_PI - g) * cos(g));
    fixture_close("Lambert cylinder [W/sr]", fixture_intensity(&f, t, 0, UM_MECHANISM_SUN),
                  expected, 4e-3);
  }
  fixture_destroy(&f);
}

/* 1 m^2, F = 0.9, incidence and reflection at 30 deg, 1000 km: -1.5211 and 3.2386 mag (Sun -26.74)
 * without the Sun's disc, which lowers the peak by 2.5 log10(1 + alpha_sun^2/alpha^2): 3.3 mmag at
 * alpha 0.0296. Tolerance: the four printed decimals. */
static void test_cook_torrance_plate(void **state)
{
  (void)state;
  const double alpha[] = {0.0296, 0.265}, magnitude[] = {-1.5211, 3.2386};
  struct um_geometry_part_spec plate = fixture_part("plate", UM_SHAPE_PLATE, &grey);
  plate.size[0] = plate.size[1] = 1.0;
  for (int k = 0; k < 2; k++) {
    struct fixture f;
    fixture_create(&f);
    fixture_material(&f, "grey", 0.0, 0.9, alpha[k], 0.05);
    fixture_scene(&f, &plate, 1, 1);
    f.samples[0].sun = polar(30.0 * UM_DEG, 0.0);
    f.samples[0].to_observer = polar(30.0 * UM_DEG, UM_PI);
    fixture_run(&f, 1, &fixture_vis, 1);
    double ratio =
        fixture_intensity(&f, 0, 0, UM_MECHANISM_SUN) / fixture_sun(&f, &fixture_vis) / 1e12;
    double theta = asin(UM_SOLAR_RADIUS / UM_AU);
    double disc = 2.5 * log10(1.0 + theta * theta / 8.0 / (alpha[k] * alpha[k]));
    double m = -26.74 - 2.5 * log10(ratio);
    print_message("Cook-Torrance alpha %.4f: %.4f mag, expected %.4f + %.4f by the disc\n",
                  alpha[k], m, magnitude[k], disc);
    assert_true(fabs(m - magnitude[k] - disc) <= 1e-4);
    fixture_destroy(&f);
  }
}

#define GRID 161

/* The lobe sends out what falls in: int I d Omega = E F A cos_i G. A grid of observers around the
 * mirror direction, +-7 widths of the lobe, by the trapezoidal rule (exact for a bell curve that
 * vanishes at its edges). Half vectors at 30 deg incidence and alpha 0.01: neither masking (1e-12)
 * nor the horizon matters; the remaining error is the trapezoid's and the float cosines'. */
static void test_mirror_energy(void **state)
{
  (void)state;
  struct fixture f;
  fixture_create(&f);
  fixture_material(&f, "grey", 0.0, 0.9, 0.01, 0.05);
  struct um_geometry_part_spec plate = fixture_part("plate", UM_SHAPE_PLATE, &grey);
  plate.size[0] = plate.size[1] = 1.0;
  fixture_scene(&f, &plate, 1, (size_t)GRID * GRID);
  struct um_vec3 mirror = polar(30.0 * UM_DEG, UM_PI), u, v;
  um_core_vec3_frame(mirror, &u, &v);
  const double reach = 0.14, step = 2.0 * reach / (GRID - 1);
  double weight[GRID * GRID];
  for (size_t t = 0; t < GRID * GRID; t++) {
    double x = -reach + step * (double)(t % GRID), y = -reach + step * (double)(t / GRID);
    struct um_vec3 d = um_vec3_axpy(um_vec3_axpy(mirror, x, u), y, v);
    double r = um_vec3_norm(d);
    weight[t] = step * step / (r * r * r); /* gnomonic: d Omega = dx dy / r^3 */
    f.samples[t].sun = polar(30.0 * UM_DEG, 0.0);
    f.samples[t].to_observer = um_vec3_scale(d, 1.0 / r);
  }
  struct um_optics_band band = {"vis", 0.5e-6, 0.6e-6, 1, NULL};
  fixture_run(&f, 1, &band, 1);
  double sum = 0.0;
  for (size_t t = 0; t < GRID * GRID; t++)
    sum += weight[t] * fixture_intensity(&f, t, 0, UM_MECHANISM_SUN);
  fixture_close("energy of a narrow lobe [W]", sum,
                fixture_sun(&f, &band) * 0.9 * cos(30.0 * UM_DEG), 1e-4);
  fixture_destroy(&f);
}

/* 65 m^2, eps 0.85, face-on, 1000 km (docs/physics/light-curves.md); sources are exact bin means,
 * so the printed digits are the tolerance. */
static void test_thermal_anchor(void **state)
{
  (void)state;
  const double kelvin[] = {280.0, 250.0, 200.0, 320.0};
  const double irradiance[] = {1.5001e-9, 8.044e-10, 1.923e-10, 2.894e-9};
  const double digits[] = {4e-5, 7e-5, 3e-4, 2e-4};
  struct fixture f;
  fixture_create(&f);
  fixture_material(&f, "grey", 0.2, 0.0, 0.0, 0.85);
  struct um_geometry_part_spec plate = fixture_part("array", UM_SHAPE_PLATE, &grey);
  plate.size[0] = 13.0;
  plate.size[1] = 5.0;
  fixture_scene(&f, &plate, 1, 4);
  size_t n = um_geometry_mesh(f.geometry)->nsurface;
  for (size_t i = 0; i < 4 * n; i++) f.temperature[i] = kelvin[i / n];
  fixture_run(&f, 1, &fixture_lwir, 1);
  for (size_t t = 0; t < 4; t++) {
    double value = fixture_intensity(&f, t, 0, UM_MECHANISM_EMITTED);
    fixture_close("array in 8-12 um at 1000 km [W/m^2]", value / 1e12, irradiance[t], digits[t]);
    fixture_close("  the same against Planck's integral", value,
                  65.0 * 0.85 * um_core_planck_band(8e-6, 12e-6, kelvin[t]), 1e-8);
  }
  fixture_destroy(&f);
}

/* Unit cube along (1,1,1): projected area sqrt 3. */
static void test_cube_projection(void **state)
{
  (void)state;
  struct fixture f;
  fixture_create(&f);
  fixture_material(&f, "grey", 0.2, 0.0, 0.0, 0.85);
  struct um_geometry_part_spec cube = fixture_part("cube", UM_SHAPE_BOX, &grey_closed);
  cube.size[0] = cube.size[1] = cube.size[2] = 1.0;
  fixture_scene(&f, &cube, 1, 1);
  f.samples[0].to_observer = um_vec3_unit(um_vec3(1.0, 1.0, 1.0));
  fixture_run(&f, 1, &fixture_lwir, 1);
  fixture_close("projected area of a cube [m^2]",
                fixture_intensity(&f, 0, 0, UM_MECHANISM_EMITTED) /
                    (0.85 * um_core_planck_band(8e-6, 12e-6, 300.0)),
                sqrt(3.0), 2e-7);
  fixture_destroy(&f);
}

/* Tables of black bodies: a plate over temperatures in one run, so that all lie between nodes; bin
 * means against Planck's integral. The interpolation is good to 4e-9 (spectra.c). */
static void test_planck_tables(void **state)
{
  (void)state;
  enum { COUNT = 300 };
  struct fixture f;
  fixture_create(&f);
  fixture_material(&f, "grey", 0.2, 0.0, 0.0, 1.0);
  struct um_geometry_part_spec plate = fixture_part("plate", UM_SHAPE_PLATE, &grey);
  plate.size[0] = plate.size[1] = 1.0;
  fixture_scene(&f, &plate, 1, COUNT);
  size_t n = um_geometry_mesh(f.geometry)->nsurface;
  for (size_t i = 0; i < COUNT * n; i++)
    f.temperature[i] = 30.0 * pow(50.0, (double)(i / n) / (COUNT - 1)); /* 30 to 1500 K */
  const struct um_optics_band bands[] = {{"vis", 0.38e-6, 0.78e-6, 5, NULL},
                                         {"lwir", 8e-6, 12e-6, 40, NULL}};
  fixture_run(&f, 1, bands, 2);
  double worst = 0.0;
  for (size_t t = 0; t < COUNT; t++)
    for (size_t b = 0; b < f.curve->nbin; b++) {
      double w = f.curve->width[b], l = f.curve->wavelength[b];
      double expected = um_core_planck_band(l - 0.5 * w, l + 0.5 * w, f.temperature[t * n]) / w;
      double value =
          f.curve->spectral[(t * f.curve->nbin + b) * UM_MECHANISM_COUNT + UM_MECHANISM_EMITTED];
      if (expected > 1e-290) worst = fmax(worst, fabs(value / expected - 1.0));
    }
  print_message("black-body tables: worst relative error %.2g (accepted 5e-9)\n", worst);
  assert_true(worst <= 5e-9);
  fixture_destroy(&f);
}

/* Aluminium at 10 um (25.3 + 89.8 i, docs/physics/fresnel.md), by Fresnel's equations, at many
 * angles: the optics' table against the record itself. Both interpolate in sqrt(cos); 1e-4 of the
 * emissivity bounds the difference of the two grids. */
static void test_directional_emissivity(void **state)
{
  (void)state;
  enum { COUNT = 90 };
  const struct um_geometry_skin skin = {NULL, "metal", "metal"};
  struct fixture f;
  fixture_create(&f);
  fixture_metal(&f, "metal", 25.3, 89.8, 0.1);
  struct um_geometry_part_spec plate = fixture_part("plate", UM_SHAPE_PLATE, &skin);
  plate.size[0] = plate.size[1] = 1.0;
  fixture_scene(&f, &plate, 1, COUNT);
  for (size_t t = 0; t < COUNT; t++)
    f.samples[t].to_observer = polar(((double)t + 0.3) * UM_DEG, 0.4);
  fixture_run(&f, 1, &fixture_lwir, 1);
  assert_false(um_materials_emissivity_is_diffuse(f.record[0], NULL));
  double worst = 0.0;
  for (size_t t = 0; t < COUNT; t++)
    for (size_t b = 0; b < f.curve->nbin; b++) {
      double cosine = f.samples[t].to_observer.z, w = f.curve->width[b], l = f.curve->wavelength[b];
      double expected = cosine * um_materials_emissivity(f.record[0], NULL, l, cosine) *
                        um_core_planck_band(l - 0.5 * w, l + 0.5 * w, 300.0) / w;
      double value =
          f.curve->spectral[(t * f.curve->nbin + b) * UM_MECHANISM_COUNT + UM_MECHANISM_EMITTED];
      worst = fmax(worst, fabs(value / expected - 1.0));
    }
  print_message("directional emission: worst relative error %.2g (accepted 1e-4)\n", worst);
  assert_true(worst <= 1e-4);
  fixture_destroy(&f);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_flat_lambert),           cmocka_unit_test(test_lambert_sphere),
      cmocka_unit_test(test_lambert_cylinder),       cmocka_unit_test(test_cook_torrance_plate),
      cmocka_unit_test(test_mirror_energy),          cmocka_unit_test(test_thermal_anchor),
      cmocka_unit_test(test_cube_projection),        cmocka_unit_test(test_planck_tables),
      cmocka_unit_test(test_directional_emissivity),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
