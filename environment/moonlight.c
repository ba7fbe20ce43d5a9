/* The Moon as a lamp.
 *
 *   E(lambda) = A(g, lambda) (R/d)^2 (1 au/D)^2 E_sun(lambda)
 *
 * with A the reflectance of the disc, R the Moon's radius, d and D its distances from satellite and
 * Sun (Kieffer & Stone 2005, Astron. J. 129:2887, eq. 8 with Omega = pi (R/d)^2), and (eq. 10)
 *
 *   ln A = sum_0..3 a_i g^i + sum_1..3 b_j Phi^(2j-1) + d_1 exp(-g/p_1) + d_2 exp(-g/p_2)
 *          + d_3 cos((g - p_3)/p_4)
 *
 * g the phase angle, Phi the Sun's selenographic longitude, which is the longitude from the
 * observer where libration is left out (up to 7 % of the light). ln A is linear in the
 * coefficients, so that smoothing them over wavelength smooths it: each is a cubic in x =
 * ln(lambda/0.55 um), least squares over the 32 bands of their table 4. */
#include "environment/moonlight.h"

#include <math.h>

#include "base/core/constants.h"

#define TERMS     10
#define MIDDLE    0.55e-6               /* [m] */
#define SHORTEST  0.35e-6               /* [m] */
#define LONGEST   2.4e-6                /* [m] */
#define HEAT      3e-6                  /* from here on the Moon's own heat [m] */
#define ASKED     0.6e-6                /* [m] */
#define LEAST     1e-4                  /* of the sunlight [1] */
#define LAST      97.0                  /* phase angle that was measured [deg] */
#define OBLIQUITY (23.4392911 * UM_DEG) /* [rad] */

/* a_0..a_3, b_1..b_3, d_1..d_3: powers 0 to 3 of x. */
static const double course[TERMS][4] = {
    {-2.10957, 0.96151, -0.48219, 0.21550},      {-1.63189, 0.23198, -0.20899, 0.03874},
    {0.35320, -0.25244, 0.06446, 0.18374},       {-0.19564, 0.10104, -0.00853, -0.08935},
    {0.041732, 0.012611, -0.016562, 0.007507},   {0.010125, 0.009333, 0.033515, -0.031979},
    {-0.003708, -0.003628, -0.011233, 0.010335}, {0.34748, 0.11917, 0.29364, -0.25756},
    {-0.08769, -0.27182, -0.17445, 0.17894},     {0.00662, 0.03804, -0.00215, -0.02771}};

/* Magnitudes below the full Moon at a phase angle [deg]: Krisciunas & Schaefer 1991, eq. 9. */
static double magnitudes(double g) { return 0.026 * g + 4e-9 * g * g * g * g; }

double um_environment_moon_reflectance(double phase, double longitude, double wavelength)
{
  double degrees = fabs(phase) / UM_DEG, g = fmin(degrees, LAST) * UM_DEG;
  double f = fmin(fmax(longitude, -g), g), f2 = f * f;
  const double p[4] = {4.06054, 12.8802, -30.5858, 16.7498}; /* [deg] */
  double at = g / UM_DEG;
  const double term[TERMS] = {
      1.0,    g,           g * g,           g * g * g,       f,
      f * f2, f * f2 * f2, exp(-at / p[0]), exp(-at / p[1]), cos((at - p[2]) / p[3])};
  double x = log(fmin(fmax(wavelength, SHORTEST), LONGEST) / MIDDLE), sum = 0.0;
  for (int k = 0; k < TERMS; k++) {
    const double *c = course[k];
    sum += term[k] * (c[0] + x * (c[1] + x * (c[2] + x * c[3])));
  }
  double dimmer = degrees > LAST ? magnitudes(degrees) - magnitudes(LAST) : 0.0;
  return exp(sum) * pow(10.0, -0.4 * dimmer);
}

double um_environment_moon_radius(double distance)
{
  return asin(fmin(UM_LUNAR_RADIUS / distance, 1.0));
}

/* Sunlight on the Moon's disc, of that without an Earth: the centre and six places around it, each
 * for a seventh of the disc. */
static double eclipse_of(const struct um_environment *environment, struct um_vec3 moon,
                         struct um_vec3 sun, struct um_vec3 pole)
{
  double radius = UM_LUNAR_RADIUS * sqrt(0.5 * (1.0 + 1.0 / 7.0)), sum = 0.0;
  struct um_vec3 across, up, out = um_vec3_unit(moon);
  um_core_vec3_frame(out, &across, &up);
  for (int i = 0; i < 7; i++) {
    double angle = i * UM_PI / 3.0, r = i == 6 ? 0.0 : radius;
    struct um_vec3 at =
        um_vec3_axpy(um_vec3_axpy(moon, r * cos(angle), across), r * sin(angle), up);
    struct um_vec3 to = um_vec3_sub(sun, at);
    double distance = um_vec3_norm(to);
    sum += um_environment_sunlit_fraction(environment, at, um_vec3_scale(to, 1.0 / distance),
                                          distance, pole);
  }
  return sum / 7.0;
}

/* Longitude from one direction to another along the ecliptic [rad]. */
static double longitude_between(struct um_vec3 from, struct um_vec3 to)
{
  struct um_vec3 pole = um_vec3(0.0, -sin(OBLIQUITY), cos(OBLIQUITY));
  struct um_vec3 a = um_vec3_axpy(from, -um_vec3_dot(from, pole), pole);
  struct um_vec3 b = um_vec3_axpy(to, -um_vec3_dot(to, pole), pole);
  return atan2(um_vec3_dot(um_vec3_cross(a, b), pole), um_vec3_dot(a, b));
}

void um_environment_moonlight(const struct um_environment *environment,
                              const struct um_environment_sample *sample,
                              struct um_environment_moonlight *out)
{
  *out = (struct um_environment_moonlight){.scale = 0.0};
  if (!environment->moonlight_on || !(sample->moon_distance > UM_LUNAR_RADIUS)) return;
  struct um_vec3 moon = um_vec3_axpy(sample->r, sample->moon_distance, sample->moon);
  struct um_vec3 sun = um_vec3_axpy(sample->r, sample->sun_distance, sample->sun);
  struct um_vec3 to_sun = um_vec3_sub(sun, moon), back = um_vec3_scale(sample->moon, -1.0);
  double far = um_vec3_norm(to_sun), size = UM_LUNAR_RADIUS / sample->moon_distance;
  struct um_environment even = *environment;
  if (even.disc == UM_DISC_LIMB_DARKENED) even.disc = UM_DISC_UNIFORM;
  /* as far as a Sun of its apparent size would be */
  um_environment_shadow_light(&even, sample->r, sample->moon, UM_SOLAR_RADIUS / size, sample->pole,
                              &out->earth);
  out->scale = size * size * (UM_AU / far) * (UM_AU / far);
  out->phase = um_vec3_angle(to_sun, back);
  out->longitude = longitude_between(back, to_sun);
  out->eclipse = eclipse_of(environment, moon, sun, sample->pole);
}

void um_environment_moon_place(const struct um_environment *environment, struct um_vec3 moon,
                               struct um_environment_sample *sample)
{
  struct um_environment_moonlight light;
  double relative = UM_AU / sample->sun_distance, sunlit = sample->sunlit_fraction;
  sample->moon = um_vec3_sub(moon, sample->r);
  sample->moon_distance = um_vec3_norm(sample->moon);
  sample->moon = um_vec3_scale(sample->moon, 1.0 / sample->moon_distance);
  um_environment_moonlight(environment, sample, &light);
  if (um_environment_moonlight_at(&light, ASKED) > LEAST * sunlit * relative * relative) return;
  sample->moon = um_vec3(0.0, 0.0, 0.0);
  sample->moon_distance = 0.0;
}

double um_environment_moonlight_at(const struct um_environment_moonlight *light, double wavelength)
{
  if (!(light->scale > 0.0) || wavelength > HEAT) return 0.0;
  return light->scale * light->eclipse *
         um_environment_moon_reflectance(light->phase, light->longitude, wavelength) *
         um_environment_shadow_light_at(&light->earth, wavelength);
}
