/* What the air at the edge of the shadow holds: ozone and aerosols times a factor, clouds higher or
 * lower (environment/shadow_light.c). Ozone dims orange light, haze and clouds what passes below 10
 * km, the aerosol of the stratosphere what passes at 15 to 25 km. */
#include "effects/list_impl.h"

UM_EFFECT_ON_ENVIRONMENT(change, environment->ozone_factor *= use->value[0];
                         environment->haze *= use->value[2]; environment->aerosol *= use->value[1];
                         environment->cloud_shift += use->value[3] * 1e3)

static void ozone(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  double whole = n->environment->ozone_dobson * n->environment->ozone_factor;
  um_effect_state(out, "vertical column of ozone at the shadow's edge", "DU", whole, 0.0, INFINITY);
}
static void haze(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  um_effect_state(out, "optical depth of the troposphere's aerosol at the shadow's edge", "1",
                  n->environment->haze, 0.0, INFINITY);
}
static void aerosol(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  um_effect_state(out, "optical depth of the stratosphere's aerosol at the shadow's edge", "1",
                  n->environment->aerosol, 0.0, INFINITY);
}
static void clouds(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  double whole = n->environment->cloud_top + n->environment->cloud_shift;
  um_effect_state(out, "height of the clouds' tops at the shadow's edge", "km", 1e-3 * whole,
                  -INFINITY, INFINITY);
}

static const char *refusal(const struct um_effect_nominal *n)
{
  const struct um_environment *e = n->environment;
  bool round = e->shadow == UM_SHADOW_SPHERE || e->shadow == UM_SHADOW_OBLATE;
  if (e->shadow_refraction_on && round && e->disc != UM_DISC_POINT) return NULL;
  return "no air is at the edge of the shadow";
}

#define FACTOR(amount, low, high, sigma, from, whole, said)                                        \
  {                                                                                                \
    .name = amount "_factor", .unit = "1", .help = said, .null_value = 1.0, .default_value = 1.0,  \
    .minimum = (low), .maximum = (high), .prior_sigma = (sigma), .logarithmic = true,              \
    .stated = (whole), .prior = (from)                                                             \
  }

static const struct um_effect_parameter parameters[] = {
    FACTOR("ozone", 0.3, 2.0, 0.12, "seasons and weather about the annual mean of a latitude, SBUV",
           ozone, "of ozone, as stated or of the latitude"),
    FACTOR("aerosol", 0.1, 100.0, 0.7,
           "8th to 90th percentile of SAGE III, 2017 to 2026: 0.5 to 2.4; 15 after Pinatubo",
           aerosol, "of the stratosphere's aerosol"),
    FACTOR("haze", 0.05, 20.0, 0.7, "AERONET, clear ocean to hazy land: 0.03 to 0.3", haze,
           "of the troposphere's aerosol"),
    {.name = "cloud_top_shift_km",
     .unit = "km",
     .help = "added to the height of the clouds' tops",
     .null_value = 0.0,
     .default_value = 0.0,
     .minimum = -8.0,
     .maximum = 8.0,
     .prior_sigma = 2.0,
     .stated = clouds,
     .prior = "rays that reach 7 km: 30 % in the tropics, 60 % at high latitudes, SAGE"},
};

const struct um_effect um_effects_shadow_air = {
    UM_EFFECT_ABI,
    .name = "shadow_air",
    .summary =
        "The air at the edge of the shadow holds other ozone, aerosol and clouds than stated",
    .reference = "Link 1969, Eclipse Phenomena in Astronomy; Woodbury & McCormick 1986, J. "
                 "Geophys. Res. 91:2775",
    .validity = "while shadow_refraction is on; the same all around the Earth and all the time; "
                "the bending of light stays",
    .separated_by = "shadow_radius and time_tag: light in two bands, whose ratio changes with the "
                    "height at which the rays pass",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.environment = change},
    .refusal = refusal,
};
