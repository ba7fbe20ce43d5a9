/* Light curves of every kind of lobe: a mirror's glint, energy, and what is reflected of what is
 * not absorbed. */
#include <math.h>
#include <stdio.h>

#include "base/core/constants.h"
#include "materials/lobe.h"
#include "tests/optics/fixture.h"

static const struct um_geometry_skin skin = {NULL, "m", "m"};
static const struct um_optics_band line = {"line", 0.599e-6, 0.601e-6, 1, NULL};

static void grey(struct fixture *f, double specular, const char *lobe)
{
  char text[512];
  snprintf(
      text, sizeof text,
      "name: m\nsummary: test\ncitation: test\ngrey: {solar_absorptance: %.17g, emittance: 0.1, "
      "specular_reflectance: %.17g}\nlobe: %s\n",
      1.0 - specular, specular, lobe);
  fixture_record(f, text);
}

static void plate(struct fixture *f, size_t ntime, struct um_vec3 sun)
{
  struct um_geometry_part_spec part = fixture_part("plate", UM_SHAPE_PLATE, &skin);
  part.size[0] = part.size[1] = 1.0;
  fixture_scene(f, &part, 1, ntime);
  for (size_t t = 0; t < ntime; t++) f->samples[t].sun = sun;
}

static struct um_vec3 direction(double zenith, double azimuth)
{
  return um_vec3(sin(zenith) * cos(azimuth), sin(zenith) * sin(azimuth), cos(zenith));
}

/* docs/physics/light-curves.md: a flat mirror of 1 m^2, F = 0.9, at 1000 km has -7.0452 mag (Sun
 * -26.74) within the Sun's disc, nothing outside; at 30 deg the area is cos 30 deg of it. Cosines
 * of sight are single precision: 1e-4 of the disc's radius, hence steps of 1e-3 on both sides. */
static void a_glint_is_the_sun(void **state)
{
  static const double turned[] = {0.0, 0.5, 0.999, 1.001, 2.0};
  double theta = asin(UM_SOLAR_RADIUS / UM_AU);
  (void)state;
  for (int tilt = 0; tilt < 2; tilt++)
    for (int k = 0; k < 5; k++) {
      double zenith = tilt * 30.0 * UM_DEG;
      struct fixture f;
      fixture_create(&f);
      grey(&f, 0.9, "mirror");
      plate(&f, 2, direction(zenith, 0.0));
      f.samples[0].to_observer = direction(zenith + turned[k] * theta, UM_PI);
      f.samples[1].to_observer =
          um_vec3_unit(um_vec3(-sin(zenith), tan(turned[k] * theta), cos(zenith)));
      fixture_run(&f, 1, &fixture_vis, 1);
      for (size_t t = 0; t < 2; t++) {
        double i = fixture_intensity(&f, t, 0, UM_MECHANISM_SUN) / f.samples[t].to_observer.z;
        double m = -26.74 - 2.5 * log10(i / fixture_sun(&f, &fixture_vis) / 1e12);
        if (turned[k] > 1.0)
          assert_true(i == 0.0);
        else if (!(fabs(m + 7.0452) <= 1e-4))
          fail_msg("glint %.5f mag, -7.0452 expected", m);
      }
      fixture_destroy(&f);
    }
}

/* int I d Omega = E F A cos_i whatever the roughness: observers about the mirror direction on rings
 * delta = pi s^3 (a mirror's within its disc). The midpoint rule holds 3e-3; what masking, the
 * horizon and min(1, cos_i/cos_o) of the powers take at 20 deg incidence is below 1e-3 for these.
 */
static void energy_whatever_the_roughness(void **state)
{
  enum { RINGS = 120, TURNS = 48 };
  static const char *const lobes[] = {"{alpha: 0.003}",
                                      "{alpha: 0.03}",
                                      "{kind: ggx, alpha: 0.001}",
                                      "{kind: ggx, alpha: 0.003}",
                                      "{kind: ggx, alpha: 0.01, masking: height_correlated}",
                                      "{kind: phong, alpha: 0.003}",
                                      "{kind: phong, exponent: 1e5}",
                                      "{kind: ashikhmin_shirley, alpha: 0.003}",
                                      "{kind: ashikhmin_shirley, exponent: 1e5}",
                                      "mirror"};
  double incidence = 20.0 * UM_DEG, theta = asin(UM_SOLAR_RADIUS / UM_AU);
  (void)state;
  for (size_t k = 0; k < sizeof lobes / sizeof lobes[0]; k++) {
    struct fixture f;
    bool mirror = k + 1 == sizeof lobes / sizeof lobes[0];
    double range = mirror ? theta * pow(RINGS / (RINGS - 1.0), 3.0) : UM_PI, sum = 0.0;
    struct um_vec3 axis = direction(incidence, UM_PI), t, b;
    um_core_vec3_frame(axis, &t, &b);
    fixture_create(&f);
    grey(&f, 0.9, lobes[k]);
    plate(&f, (size_t)RINGS * TURNS, direction(incidence, 0.0));
    for (size_t n = 0; n < f.ntime; n++) {
      double s = ((double)(n / TURNS) + 0.5) / RINGS, delta = range * s * s * s;
      double phi = 2.0 * UM_PI * ((double)(n % TURNS) + 0.5) / TURNS;
      struct um_vec3 o = um_vec3_scale(axis, cos(delta));
      o = um_vec3_axpy(o, sin(delta) * cos(phi), t);
      f.samples[n].to_observer = um_vec3_unit(um_vec3_axpy(o, sin(delta) * sin(phi), b));
    }
    fixture_run(&f, 1, &line, 1);
    for (size_t n = 0; n < f.ntime; n++) {
      double s = ((double)(n / TURNS) + 0.5) / RINGS;
      if (f.samples[n].to_observer.z > 0.0)
        sum += fixture_intensity(&f, n, 0, UM_MECHANISM_SUN) * sin(range * s * s * s) * 3.0 *
               range * s * s / RINGS * 2.0 * UM_PI / TURNS;
    }
    fixture_close(lobes[k], sum, fixture_sun(&f, &line) * 0.9 * cos(incidence),
                  mirror ? 1e-2 : 3e-3);
    fixture_destroy(&f);
  }
}

/* A brushed plate seen face-on while the Sun moves along its grain and across: f is a bell curve of
 * half vectors, exp(-tan^2 theta_h/alpha^2) with the alpha of that direction, widened by the Sun's
 * disc; over the square of what is lit, the peak is F/(4 pi alpha alpha_across). Turned with the
 * part, by a fixed joint, and seen from the back, the grain goes along. 1e-5: cosines of sight are
 * single precision; masking is below 1e-9. */
static void grain_goes_with_the_part(void **state)
{
  enum { PLAIN, TURNED, JOINT, BACK, CASES };
  double alpha[2] = {0.02, 0.1}, theta = asin(UM_SOLAR_RADIUS / UM_AU);
  (void)state;
  for (int a = 0; a < 2; a++) alpha[a] = sqrt(alpha[a] * alpha[a] + theta * theta / 8.0);
  for (int k = 0; k < CASES; k++) {
    struct fixture f;
    struct um_geometry_part_spec part = fixture_part("plate", UM_SHAPE_PLATE, &skin);
    fixture_create(&f);
    grey(&f, 0.5, "{alpha: 0.02, alpha_across: 0.1}");
    part.size[0] = part.size[1] = 1.0;
    if (k != PLAIN) part.grain = um_vec3(0.0, -3.0, 1.0); /* along y, and upright */
    if (k == TURNED) part.rotation = um_quat_from_axis(um_vec3(0.0, 0.0, 1.0), 0.5 * UM_PI);
    if (k == JOINT) {
      part.joint = UM_JOINT_FIXED;
      part.joint_axis = um_vec3(0.0, 0.0, 1.0);
      part.joint_angle = 0.5 * UM_PI;
    }
    fixture_scene(&f, &part, 1, 3);
    double side = k == BACK ? -1.0 : 1.0, tilt[2] = {0.02, 0.1};
    int along = k == BACK ? 1 : 0; /* which axis of the body the grain lies along */
    f.samples[0].sun = f.samples[0].to_observer = um_vec3(0.0, 0.0, side);
    for (size_t t = 1; t < 3; t++) {
      double angle = 2.0 * tilt[t - 1];
      bool x = (t == 1) == (along == 0);
      f.samples[t].to_observer = um_vec3(0.0, 0.0, side);
      f.samples[t].sun = um_vec3(x ? sin(angle) : 0.0, x ? 0.0 : sin(angle), side * cos(angle));
    }
    fixture_run(&f, 1, &line, 1);
    double e = 0.5 * fixture_sun(&f, &line), diffuse = (1.0 - 0.5 - 0.5) / UM_PI;
    for (size_t t = 0; t < 3; t++) {
      double slope = t == 0 ? 0.0 : tan(tilt[t - 1]) / alpha[t - 1];
      double c = t == 0 ? 1.0 : cos(tilt[t - 1]);
      double expected = e * exp(-slope * slope) / (4.0 * UM_PI * alpha[0] * alpha[1] * pow(c, 4.0));
      fixture_close("brushed plate [W/sr]",
                    fixture_intensity(&f, t, 0, UM_MECHANISM_SUN) - e * diffuse, expected, 1e-5);
    }
    fixture_destroy(&f);
  }
}

/* A plate of metal under sunlight, seen from directions of equal projected solid angle: what is
 * reflected and what is absorbed is all there is, for every kind and masking. Midpoints hold 3e-3;
 * M carries what the lobe loses, up to 0.2 of the light here. */
static void reflected_and_absorbed(void **state)
{
  enum { COSINES = 24, AZIMUTHS = 48 };
  static const char *const lobes[] = {"{alpha: 0.5, masking: height_correlated}",
                                      "{kind: ggx, alpha: 0.4}",
                                      "{kind: ggx, alpha: 0.4, masking: height_correlated}",
                                      "{kind: phong, exponent: 8}",
                                      "{kind: ashikhmin_shirley, exponent: 10}",
                                      "{kind: lambert}"};
  (void)state;
  for (size_t k = 0; k < sizeof lobes / sizeof lobes[0]; k++)
    for (double angle = 0.0; angle < 70.0; angle += 60.0) {
      struct fixture f;
      char text[512];
      double sum = 0.0, c0 = cos(angle * UM_DEG);
      snprintf(
          text, sizeof text,
          "name: m\nsummary: test\ncitation: test\nsubstrate: {wavelength_um: [0.2, 50], n: [0.2, "
          "0.2], k: [3.1, 3.1]}\nlobe: %s\n",
          lobes[k]);
      fixture_create(&f);
      fixture_record(&f, text);
      plate(&f, COSINES * AZIMUTHS, direction(angle * UM_DEG, 0.0));
      for (size_t t = 0; t < f.ntime; t++) {
        double c = sqrt(((double)(t / AZIMUTHS) + 0.5) / COSINES);
        f.samples[t].to_observer =
            direction(acos(c), 2.0 * UM_PI * ((double)(t % AZIMUTHS) + 0.5) / AZIMUTHS);
      }
      fixture_run(&f, 1, &line, 1);
      for (size_t t = 0; t < f.ntime; t++)
        sum += fixture_intensity(&f, t, 0, UM_MECHANISM_SUN) / f.samples[t].to_observer.z;
      double reflected = UM_PI * sum / (double)f.ntime / (fixture_sun(&f, &line) * c0);
      double absorbed = um_materials_emissivity(f.record[0], NULL, 0.6e-6, c0);
      fixture_close(lobes[k], reflected + absorbed, 1.0, 3e-3);
      fixture_destroy(&f);
    }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(a_glint_is_the_sun),
      cmocka_unit_test(energy_whatever_the_roughness),
      cmocka_unit_test(grain_goes_with_the_part),
      cmocka_unit_test(reflected_and_absorbed),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
