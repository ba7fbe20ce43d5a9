/* White furnace: a surface that absorbs nothing, under sunlight at an angle, seen from everywhere.
 */
#include <math.h>
#include <stdio.h>

#include "base/core/constants.h"
#include "materials/bsdf.h"
#include "tests/optics/fixture.h"

#define RINGS    256 /* of half vectors, of equal share of the facets */
#define TURNS    24
#define COSINES  16 /* of observers, of equal projected solid angle */
#define AZIMUTHS 32

static const struct um_geometry_skin skin = {NULL, "m", "m"};
static const struct um_optics_band line[] = {{"vis", 0.599e-6, 0.601e-6, 1, NULL},
                                             {"lwir", 9.99e-6, 10.01e-6, 1, NULL}};

/* A plate of F = 1 at all wavelengths and angles. */
static void white_plate(struct fixture *f, double alpha, size_t ntime)
{
  char text[256];
  struct um_geometry_part_spec part = fixture_part("plate", UM_SHAPE_PLATE, &skin);
  part.size[0] = part.size[1] = 1.0;
  fixture_create(f);
  um_core_context_set_threads(f->context, 1); /* runs too short to share */
  snprintf(text, sizeof text,
           "name: m\nsummary: test\ncitation: test\nreflectance: {wavelength_um: [0.2, 50], "
           "diffuse: [0, 0], specular: [1, 1]}\nsurface: {beckmann_alpha: %.17g}\n",
           alpha);
  fixture_record(f, text);
  fixture_scene(f, &part, 1, ntime);
}

/* The lobe is gathered over half vectors as facets are distributed, u = 1 - exp(-tan^2/alpha^2):
 * the mean of f cos_o 4 (i.h)/(D cos_h); what facets pass on, which is broad, over observers of
 * equal projected solid angle. alpha: with the Sun's disc. */
static void place_observers(struct fixture *f, struct um_vec3 i, double alpha, double *weight)
{
  size_t t = 0;
  for (int k = 0; k < RINGS; k++)
    for (int j = 0; j < TURNS; j++, t++) {
      double tangent = alpha * sqrt(-log1p(-(k + 0.5) / RINGS)), phi = UM_PI * (j + 0.5) / TURNS;
      struct um_vec3 h = um_vec3_unit(um_vec3(tangent * cos(phi), tangent * sin(phi), 1.0));
      double d = um_vec3_dot(i, h);
      struct um_vec3 o = um_vec3_axpy(um_vec3_scale(i, -1.0), 2.0 * d, h);
      bool seen = d > 0.0 && o.z > 0.0;
      f->samples[t].to_observer = seen ? o : um_vec3(0.0, 0.0, 1.0);
      weight[t] =
          seen ? 4.0 * d / (um_materials_beckmann_distribution(alpha, h.z) * h.z * RINGS * TURNS)
               : 0.0;
    }
  for (int k = 0; k < COSINES; k++)
    for (int j = 0; j < AZIMUTHS; j++, t++) {
      double c = sqrt((k + 0.5) / COSINES), s = sqrt(1.0 - c * c),
             phi = 2.0 * UM_PI * (j + 0.5) / AZIMUTHS;
      f->samples[t].to_observer = um_vec3(s * cos(phi), s * sin(phi), c);
      weight[t] = UM_PI / (c * COSINES * AZIMUTHS);
    }
  for (t = 0; t < f->ntime; t++) f->samples[t].sun = i;
}

/* docs/physics/roughness-and-lobes.md, Smith's masking taken apart, good to 1.5e-4; the midpoints
 * here add 3e-4. With multiple_scattering nothing is lost, 1 within 1e-3. */
static void nothing_is_lost(void **state)
{
  enum { LOBE = RINGS * TURNS, ALL = LOBE + COSINES * AZIMUTHS };
  static const double zenith[] = {0.0, 30.0, 60.0, 75.0};
  static const struct {
    double alpha, albedo[4];
  } row[] = {{0.0296, {1.0, 1.0, 1.0, 1.0}},
             {0.265, {0.999986, 0.996818, 0.939120, 0.903363}},
             {0.326, {0.999155, 0.985204, 0.912995, 0.900835}},
             {0.513, {0.933629, 0.894827, 0.866644, 0.899773}}};
  static double weight[ALL], alone[2][ALL];
  (void)state;
  for (size_t a = 0; a < sizeof row / sizeof row[0]; a++)
    for (size_t z = 0; z < 4; z++) {
      struct fixture f;
      double disc = asin(UM_SOLAR_RADIUS / UM_AU),
             alpha = sqrt(row[a].alpha * row[a].alpha + disc * disc / 8.0);
      struct um_vec3 i = um_vec3(sin(zenith[z] * UM_DEG), 0.0, cos(zenith[z] * UM_DEG));
      white_plate(&f, row[a].alpha, ALL);
      place_observers(&f, i, alpha, weight);
      f.environment.multiple_scattering_on = false;
      fixture_run(&f, 1, line, 2);
      for (size_t k = 0; k < 2; k++)
        for (size_t t = 0; t < ALL; t++)
          alone[k][t] = fixture_intensity(&f, t, k, UM_MECHANISM_SUN);
      f.environment.multiple_scattering_on = true;
      fixture_run(&f, 1, line, 2);
      for (size_t k = 0; k < 2; k++) {
        double light = fixture_sun(&f, &line[k]) * i.z, lobe = 0.0, multiple = 0.0;
        for (size_t t = 0; t < LOBE; t++) lobe += weight[t] * alone[k][t] / light;
        for (size_t t = LOBE; t < ALL; t++)
          multiple +=
              weight[t] * (fixture_intensity(&f, t, k, UM_MECHANISM_SUN) - alone[k][t]) / light;
        print_message("alpha %g at %g deg, %s: %.5f without, %.5f with\n", row[a].alpha, zenith[z],
                      line[k].name, lobe, lobe + multiple);
        fixture_close("lobe alone", lobe, row[a].albedo[z], 4.5e-4);
        fixture_close("white furnace", lobe + multiple, 1.0, 1e-3);
      }
      fixture_destroy(&f);
    }
}

/* Sun and observer may change places: I/(cos_i cos_o) stays, with what facets pass on and without.
 * Cosines of sight are single precision. */
static void reciprocity(void **state)
{
  (void)state;
  for (int on = 0; on < 2; on++) {
    struct fixture f;
    white_plate(&f, 0.513, 2);
    f.environment.multiple_scattering_on = on != 0;
    f.samples[0].sun = f.samples[1].to_observer = um_vec3_unit(um_vec3(0.3, 0.4, 0.5));
    f.samples[1].sun = f.samples[0].to_observer = um_vec3_unit(um_vec3(-0.9, 0.2, 0.3));
    fixture_run(&f, 1, line, 1);
    fixture_close("changed places", fixture_intensity(&f, 0, 0, UM_MECHANISM_SUN),
                  fixture_intensity(&f, 1, 0, UM_MECHANISM_SUN), 1e-6);
    fixture_destroy(&f);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(nothing_is_lost),
                                     cmocka_unit_test(reciprocity)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
