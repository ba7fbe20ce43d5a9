/* What the air at the edge of the shadow holds: more or less ozone and aerosol, clouds higher or
 * lower (environment/shadow_light.c). Ozone dims orange light, haze and clouds what passes below 10
 * km, the aerosol of the stratosphere what passes at 15 to 25 km. */
#include "effects/list_impl.h"

static enum um_status change(struct um_context *context, const struct um_effect_use *use,
                             struct um_environment *environment)
{
  environment->ozone_factor *= 1.0 + 0.01 * use->value[0];
  environment->aerosol += use->value[1];
  environment->haze += use->value[2];
  environment->cloud_shift += use->value[3] * 1e3; /* km -> m */
  if (environment->aerosol >= 0.0 && environment->haze >= 0.0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "effect 'shadow_air': aerosol_depth %g and haze_depth %g make the depths %g "
                      "and %g; accepted: 0 and more",
                      use->value[1], use->value[2], environment->aerosol, environment->haze);
}

static void aerosol(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  um_effect_state(out, "optical depth of the stratosphere's aerosol at the shadow's edge", "1",
                  n->environment->aerosol, 0.0, INFINITY);
}
static void haze(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  um_effect_state(out, "optical depth of the troposphere's aerosol at the shadow's edge", "1",
                  n->environment->haze, 0.0, INFINITY);
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

#define AMOUNT(title, of, low, high, sigma, from, whole, said)                                     \
  {                                                                                                \
    .name = (title), .unit = (of), .help = (said), .null_value = 0.0, .default_value = 0.0,        \
    .minimum = (low), .maximum = (high), .prior_sigma = (sigma), .stated = (whole),                \
    .prior = (from)                                                                                \
  }

static const struct um_effect_parameter parameters[] = {
    AMOUNT("ozone_percent", "%", -80.0, 150.0, 12.0,
           "seasons and weather about the annual mean of a latitude, SBUV", NULL,
           "more ozone than stated, or than the latitude has"),
    AMOUNT("aerosol_depth", "1", -0.05, 1.0, 0.01,
           "8th to 90th percentile of SAGE III, 2017 to 2026: 0.004 to 0.02; 0.15 after Pinatubo",
           aerosol, "of the stratosphere's aerosol at 0.55 um, beside the scenario's"),
    AMOUNT("haze_depth", "1", -1.0, 5.0, 0.1, "AERONET, clear ocean to hazy land: 0.03 to 0.3",
           haze, "of the troposphere's aerosol at 0.55 um, beside the scenario's"),
    AMOUNT("cloud_top_km", "km", -8.0, 8.0, 2.0,
           "rays that reach 7 km: 30 % in the tropics, 60 % at high latitudes, SAGE", clouds,
           "added to the height of the clouds' tops"),
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
