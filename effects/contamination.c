/* Contamination: a film grows on a surface, and it absorbs ever more sunlight,
 *
 *   alpha(t) = alpha + r (t - t_0),  rho_d(t) = rho_d - r (t - t_0) below 2.5 um,
 *
 * t_0 the start of the scenario's time, where the surface is as its record says. The line is the
 * beginning of any law of growth; ageing that is over by t_0 is solar_absorptance. */
#include "effects/list_impl.h"

#define DAY 86400.0 /* [s] */

UM_EFFECT_ON_MATERIAL(darken,
                      adjustment->absorptance_shift += use->value[0] * (t_tai - use->epoch) / DAY)

static const struct um_effect_parameter parameters[] = {
    {.name = "absorptance_per_day",
     .unit = "1/d",
     .help = "growth of the solar absorptance; below 0 the surface is cleaned, as by atomic oxygen",
     .null_value = 0.0,
     .default_value = 1e-3,
     .minimum = -50.0,
     .maximum = 50.0,
     .prior_sigma = 0.01,
     .prior = "0.1 to 0.3 over a life in orbit; some per cent a day beside a leak or a thruster"},
};

const struct um_effect um_effects_contamination = {
    UM_EFFECT_ABI,
    .name = "contamination",
    .summary = "A film grows on a surface: it absorbs more sunlight from day to day",
    .reference = "Silverman 1995, NASA CR-4661",
    .validity = "linear in time from the scenario's start; grey in wavelength below 2.5 um; the "
                "absorptance stays within 0 to 1, the emittance as it is",
    .separated_by = "solar_absorptance: passes weeks apart, over which the one grows and the other "
                    "stays",
    .targets = UM_TARGET_MATERIAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.material = darken},
};
