/* The sky's scattered light: against the closed form of a thin plane layer, photons followed one by
 * one through the same air, and zeniths that were measured by day and at twilight. */
#include "environment/sky_light.h"

#include "base/core/constants.h"
#include "environment/shadow_light.h"
#include "tests/environment/check.h"
#include "tests/support/reference.h"

static struct um_environment_limb limb;

static struct um_environment sky_of(double height, double aerosol, double ozone)
{
  struct um_environment e;
  um_environment_defaults(&e);
  if (limb.straight.bending[0] == 0.0) um_environment_limb_make(&e, &limb);
  e.limb = &limb;
  e.sky = um_environment_clear_sky_of(UM_SKY_US_STANDARD, height);
  e.sky.aerosol = aerosol;
  e.sky.ozone_dobson = ozone;
  return e;
}

static struct um_environment_sky_light *made(struct um_context *context,
                                             const struct um_environment *e, double height,
                                             double from, double to)
{
  struct um_environment_sky_light *light = NULL;
  if (um_environment_sky_light_make(context, e, height, from, to, &light) != UM_OK)
    fail_msg("%s", um_core_message(context));
  return light;
}

/* Radiance of the zenith over irradiance [1/sr]; elevation of the Sun [deg]. */
static double zenith(const struct um_environment_sky_light *light, const struct um_environment *e,
                     double elevation, double wavelength, bool once)
{
  struct um_environment_sky_path path;
  um_environment_sky_path(light, e, 0.5 * UM_PI, elevation * UM_DEG, sin(elevation * UM_DEG),
                          &path);
  return um_environment_sky_path_radiance(&path, wavelength, once);
}

/* Light scattered once by a plane layer of air alone, seen from below (Chandrasekhar 1960, section
 * 29): L = P(Theta) mu_0/(mu_0 - mu) (exp(-tau/mu_0) - exp(-tau/mu)), P = 3/(16 pi) (1 + cos^2). */
static void a_high_sun_has_the_closed_form(void **state)
{
  struct um_environment e = sky_of(0.0, 0.0, 0.0);
  e.aerosol = 0.0;
  struct um_environment_sky_light *light = made(*state, &e, 0.0, 0.4e-6, 0.7e-6);
  static const double wavelength[] = {0.35e-6, 0.45e-6, 0.55e-6, 0.7e-6, 1.0e-6};
  for (size_t i = 0; i < sizeof wavelength / sizeof wavelength[0]; i++)
    for (double sun = 35.0; sun <= 75.0; sun += 20.0)
      for (double look = 40.0; look <= 90.0; look += 25.0) {
        double depth[UM_LIMB_CONSTITUENTS], mu0 = sin(sun * UM_DEG), mu = sin(look * UM_DEG);
        double c = mu * mu0 + cos(sun * UM_DEG) * cos(look * UM_DEG) * cos(2.0);
        um_environment_limb_depth(wavelength[i], depth);
        double tau = depth[UM_LIMB_AIR];
        double expected = 3.0 / (16.0 * UM_PI) * (1.0 + c * c) * mu0 / (mu0 - mu) *
                          (exp(-tau / mu0) - exp(-tau / mu));
        struct um_environment_sky_path path;
        um_environment_sky_path(light, &e, look * UM_DEG, sun * UM_DEG, c, &path);
        double value = um_environment_sky_path_radiance(&path, wavelength[i], true);
        /* round Earth, and molecules that are not quite round: 1.4 % of P */
        check_near("plane layer", value / expected, 1.0, 0.025);
      }
  um_core_free(*state, light);
}

/* Photons backward from the zenith through a round atmosphere of air alone over a Lambert ground,
 * the lamp looked at from every scattering (Marchuk et al. 1980, The Monte Carlo Methods in
 * Atmospheric Optics, ch. 4): true phase function, every order, steps of 1/20 of a free path. */
static uint64_t random_state;
static double uniform(void)
{
  random_state = random_state * 6364136223846793005ULL + 1442695040888963407ULL;
  return (double)(random_state >> 11) / 9007199254740992.0;
}

static struct um_vec3 turned(struct um_vec3 d, double cosine)
{
  struct um_vec3 t, b;
  double sine = sqrt(1.0 - cosine * cosine), azimuth = 2.0 * UM_PI * uniform();
  um_core_vec3_frame(d, &t, &b);
  return um_vec3_axpy(um_vec3_axpy(um_vec3_scale(d, cosine), sine * cos(azimuth), t),
                      sine * sin(azimuth), b);
}

static double lamp_at(const struct um_environment_slant *slant, struct um_vec3 r,
                      struct um_vec3 lamp, double depth)
{
  double column[UM_LIMB_CONSTITUENTS], dilution = 0.0, height = um_vec3_norm(r) - slant->radius;
  if (!um_environment_slant_sun(slant, height, um_vec3_angle(r, lamp), column, &dilution))
    return 0.0;
  return dilution * exp(-depth * column[UM_LIMB_AIR]);
}

/* One photon; first: what it brings after one scattering, rest: after more. */
static void follow(const struct um_environment_slant *slant, struct um_vec3 lamp, double depth,
                   double *first, double *rest)
{
  const double even = 0.25 / UM_PI, g = 0.01415; /* depolarisation 0.0279 */
  struct um_vec3 r = um_vec3(0.0, 0.0, slant->radius + 1.0), d = um_vec3(0.0, 0.0, 1.0);
  double weight = 1.0;
  *first = *rest = 0.0;
  for (int order = 1; order <= 12; order++) {
    double left = -log(1.0 - uniform());
    if (order == 1) { /* anywhere on the line of sight: at twilight what is high counts */
      double z = 98e3 * uniform(), below[UM_LIMB_CONSTITUENTS], above[UM_LIMB_CONSTITUENTS];
      um_environment_slant_up(slant, 0.0, 1.0, below);
      um_environment_slant_up(slant, z, 1.0, above);
      weight = 98e3 * depth * um_environment_slant_density(slant, UM_LIMB_AIR, z) *
               exp(-depth * (below[UM_LIMB_AIR] - above[UM_LIMB_AIR]));
      r = um_vec3(0.0, 0.0, slant->radius + z);
      left = 0.0;
    }
    bool ground = false;
    for (;;) {
      double height = um_vec3_norm(r) - slant->radius;
      if (height > 99e3) return;
      if (height < 0.0) {
        ground = true;
        break;
      }
      double k = depth * um_environment_slant_density(slant, UM_LIMB_AIR, height);
      double step = fmin(0.05 / k, 100.0 + 0.05 * height);
      if (left <= k * step) {
        r = um_vec3_axpy(r, left / k, d);
        break;
      }
      left -= k * step;
      r = um_vec3_axpy(r, step, d);
    }
    struct um_vec3 up = um_vec3_unit(r);
    double cosine = um_vec3_dot(d, lamp), bring;
    if (ground) {
      r = um_vec3_scale(up, slant->radius + 0.5);
      weight *= 0.15;
      bring = fmax(um_vec3_dot(up, lamp), 0.0) / UM_PI;
      d = turned(up, sqrt(uniform()));
    } else {
      bring = 0.75 * even * (1.0 + 3.0 * g + (1.0 - g) * cosine * cosine) / (1.0 + 2.0 * g);
      double c;
      do c = 2.0 * uniform() - 1.0;
      while (2.0 * uniform() > 1.0 + c * c);
      d = turned(d, c);
    }
    double value = weight * bring * lamp_at(slant, r, lamp, depth);
    if (order == 1)
      *first += value;
    else
      *rest += value;
  }
}

static void orders_are_those_of_photons(void **state)
{
  static const struct {
    double elevation, wavelength;
    int n;
    double allowed; /* of what is scattered more than once: all but the first order go evenly */
  } row[] = {{50.0, 0.45e-6, 20000, 0.10},
             {10.0, 0.45e-6, 20000, 0.10},
             {10.0, 0.60e-6, 20000, 0.10},
             {-4.0, 0.45e-6, 60000, 0.15},
             {-7.0, 0.40e-6, 400000, 0.15}};
  struct um_environment e = sky_of(0.0, 0.0, 0.0);
  e.aerosol = 0.0;
  struct um_environment_sky_light *light = made(*state, &e, 0.0, 0.36e-6, 0.65e-6);
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    double depth[UM_LIMB_CONSTITUENTS], sum[2] = {0.0, 0.0}, square[2] = {0.0, 0.0};
    double a = row[i].elevation * UM_DEG, n = row[i].n;
    um_environment_limb_depth(row[i].wavelength, depth);
    random_state = 20261123 + i;
    for (int k = 0; k < row[i].n; k++) {
      double value[2];
      follow(&light->slant, um_vec3(cos(a), 0.0, sin(a)), depth[UM_LIMB_AIR], &value[0], &value[1]);
      for (int m = 0; m < 2; m++) sum[m] += value[m] / n;
      for (int m = 0; m < 2; m++) square[m] += value[m] * value[m] / n;
    }
    double once = zenith(light, &e, row[i].elevation, row[i].wavelength, true);
    double all = zenith(light, &e, row[i].elevation, row[i].wavelength, false);
    double error[2];
    for (int m = 0; m < 2; m++) error[m] = sqrt((square[m] - sum[m] * sum[m]) / n);
    print_message("%3.0f deg %.2f um: once %.4g, photons %.4g +- %.1g; more %.4g, %.4g +- %.1g\n",
                  row[i].elevation, row[i].wavelength * 1e6, once, sum[0], error[0], all - once,
                  sum[1], error[1]);
    check_near("once", once, sum[0], 4.0 * error[0] + 0.02 * sum[0]);
    check_near("more", all - once, sum[1], 4.0 * error[1] + row[i].allowed * sum[1]);
  }
  um_core_free(*state, light);
}

static double magnitudes(double radiance, double zero)
{
  double arcsec = UM_DEG / 3600.0;
  return -2.5 * log10(radiance * arcsec * arcsec / zero);
}

/* Paranal: ozone of the subtropics, aerosol of a desert coast far from dust. */
static void twilight_is_that_of_paranal(void **state)
{
  struct um_environment e = sky_of(2635.0, 0.03, 260.0);
  struct um_environment_sky_light *light = made(*state, &e, 2635.0, 0.36e-6, 0.8e-6);
  struct um_core_csv *csv = reference_open(*state, "twilight-paranal");
  for (size_t b = 0; b < um_core_csv_rows(csv); b++) {
    double l = reference_number(*state, csv, b, "effective_um") * 1e-6, square = 0.0, worst = 0.0;
    double zero = reference_number(*state, csv, b, "zero_W_m2_um") * 1e6, mean = 0.0;
    double night = reference_number(*state, csv, b, "night");
    for (int x = 0; x <= 10; x++) {
      double expected = reference_number(*state, csv, b, "a0") +
                        x * reference_number(*state, csv, b, "a1") +
                        x * x * reference_number(*state, csv, b, "a2");
      double radiance =
          um_environment_solar_spectrum(&e, l) * zenith(light, &e, -5.0 - x, l, false);
      double ours = magnitudes(radiance, zero);
      ours = -2.5 * log10(pow(10.0, -0.4 * ours) + pow(10.0, -0.4 * night));
      double off = ours - expected;
      print_message(" %+.2f", off);
      mean += off / 11.0;
      square += off * off / 11.0;
      worst = fmax(worst, fabs(off));
    }
    print_message("  %s mean %+.2f rms %.2f\n", reference_text(*state, csv, b, "band"), mean,
                  sqrt(square));
    check_below("worst [mag]", worst, 0.55);
    check_below("rms [mag]", sqrt(square), 0.40);
  }
  um_core_csv_destroy(&csv);
  um_core_free(*state, light);
}

/* Luminous efficiency by a Gaussian through its peak and width (Wyman et al. 2013, J. Comput.
 * Graph. Tech. 2(2):1, eq. 4, the lobe of y): 0.821 and 0.286. */
static double eye(double nm)
{
  double a = (nm - 568.8) / (nm < 568.8 ? 46.9 : 40.5);
  double b = (nm - 530.9) / (nm < 530.9 ? 16.3 : 31.1);
  return 0.821 * exp(-0.5 * a * a) + 0.286 * exp(-0.5 * b * b);
}

/* [cd/m^2] */
static double luminance(const struct um_environment_sky_light *light,
                        const struct um_environment *e, double elevation)
{
  double sum = 0.0;
  for (double nm = 405.0; nm < 750.0; nm += 10.0)
    sum += 683.0 * 10e-9 * eye(nm) * um_environment_solar_spectrum(e, nm * 1e-9) *
           zenith(light, e, elevation, nm * 1e-9, false);
  return sum;
}

/* The two sites differ from each other by up to 1.1 mag at the same depression, more than their
 * heights explain: ours lies between them, or within 0.7 mag of each, at 15 deg of depression 1.0.
 */
static void twilight_is_that_of_koomen(void **state)
{
  static const char *const name[] = {"sacramento_peak_c_ft2", "maryland_c_ft2"};
  static const double height[] = {2800.0, 30.0}, aerosol[] = {0.05, 0.15};
  const double night = 1.4e-5 * 10.7639;
  for (size_t site = 0; site < 2; site++) {
    struct um_environment e = sky_of(height[site], aerosol[site], 344.0);
    struct um_environment_sky_light *light = made(*state, &e, height[site], 0.4e-6, 0.75e-6);
    struct um_core_csv *csv = reference_open(*state, "twilight-koomen");
    for (size_t k = 0; k < um_core_csv_rows(csv); k++) {
      double measured = reference_number(*state, csv, k, name[site]) * 10.7639;
      double elevation = reference_number(*state, csv, k, "sun_elevation_deg");
      double off = -2.5 * log10((luminance(light, &e, elevation) + night) / measured);
      print_message(" %+.2f", off);
      check_below(name[site], fabs(off), elevation < -14.0 ? 1.0 : 0.7);
    }
    print_message("  %s\n", name[site]);
    um_core_csv_destroy(&csv);
    um_core_free(*state, light);
  }
}

/* By day: Karayel et al. 1984, Energy and Buildings 6:283, of three years in San Francisco,
 * L = (1.376 T - 1.81) tan h + 0.38 kcd/m^2, T the optical depth of the air over that of clean dry
 * air: ozone and aerosol here make 0.097, 0.03 and 0.1 to 2.3. */
static void a_clear_day_is_as_bright_as_measured(void **state)
{
  struct um_environment e = sky_of(0.0, 0.1, 344.0);
  e.sky.aerosol -= e.aerosol; /* of which the stratosphere has its part */
  struct um_environment_sky_light *light = made(*state, &e, 0.0, 0.4e-6, 0.75e-6);
  for (double h = 15.0; h <= 60.0; h += 15.0) {
    double measured = ((1.376 * 2.3 - 1.81) * tan(h * UM_DEG) + 0.38) * 1e3;
    double ours = luminance(light, &e, h);
    print_message("%2.0f deg: %.0f cd/m^2, measured %.0f\n", h, ours, measured);
    check_near("by day", ours / measured, 1.0, 0.6);
  }
  um_core_free(*state, light);
}

/* No step and no rise on the way into the night, whatever the direction; the Chappuis band makes
 * the zenith bluer than by Rayleigh alone. */
static void fades_evenly(void **state)
{
  struct um_environment e = sky_of(500.0, 0.1, 344.0), bare = sky_of(500.0, 0.1, 0.0);
  struct um_environment_sky_light *light = made(*state, &e, 500.0, 0.42e-6, 0.8e-6);
  struct um_environment_sky_light *without = made(*state, &bare, 500.0, 0.42e-6, 0.8e-6);
  for (double look = 10.0; look <= 90.0; look += 40.0)
    for (int side = -1; side <= 1; side += 2) {
      double before = NAN;
      for (double h = 0.0; h > -19.0; h -= 0.1) {
        struct um_environment_sky_path path;
        double c =
            sin(look * UM_DEG) * sin(h * UM_DEG) + side * cos(look * UM_DEG) * cos(h * UM_DEG);
        um_environment_sky_path(light, &e, look * UM_DEG, h * UM_DEG, c, &path);
        double now = um_environment_sky_path_radiance(&path, 0.55e-6, false);
        assert_true(now > 0.0);
        if (h < -1.0) assert_true(now < before && now > 0.70 * before);
        before = now;
      }
    }
  double colour = zenith(light, &e, -5.0, 0.45e-6, false) / zenith(light, &e, -5.0, 0.6e-6, false);
  double grey =
      zenith(without, &bare, -5.0, 0.45e-6, false) / zenith(without, &bare, -5.0, 0.6e-6, false);
  print_message("0.45 over 0.60 um with ozone %.2f, without %.2f\n", colour, grey);
  assert_true(colour > 1.8 * grey);
  um_core_free(*state, light);
  um_core_free(*state, without);
}

static int begin(void **state)
{
  return um_core_context_create(NULL, (struct um_context **)state) != UM_OK;
}

static int end(void **state)
{
  um_core_context_destroy((struct um_context **)state);
  return 0;
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(a_high_sun_has_the_closed_form),
      cmocka_unit_test(orders_are_those_of_photons),
      cmocka_unit_test(twilight_is_that_of_paranal),
      cmocka_unit_test(twilight_is_that_of_koomen),
      cmocka_unit_test(a_clear_day_is_as_bright_as_measured),
      cmocka_unit_test(fades_evenly),
  };
  return cmocka_run_group_tests(tests, begin, end);
}
