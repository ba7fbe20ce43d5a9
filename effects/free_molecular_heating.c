/* Heat of the air that strikes a satellite in a low orbit. In free-molecular flow a surface that
 * faces the motion takes
 *
 *   q = a f rho v^3 / 2 cos(theta),
 *
 * rho the density at mean solar activity (environment/atmosphere.h), v the velocity over the
 * atmosphere, a = 0.9 the accommodation of energy, f a factor for the Sun's activity: 59 W/m^2 at
 * 200 km, 0.76 at 400 km, 0.003 at 765 km. Off unless a scenario asks for it: rho is known to a
 * factor of 3 at 400 km, and above 500 km it is less than what any other load is known to. */
#include "effects/list_impl.h"

#define ACCOMMODATION 0.9 /* 0.8 to 1 for engineering surfaces in atomic oxygen */

UM_EFFECT_ON_ENVIRONMENT(add, environment->gas_density_factor += ACCOMMODATION * use->value[0])

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "f of the density at mean solar activity, with an accommodation of 0.9",
     .null_value = 0.0,
     .default_value = 1.0,
     .minimum = 0.0,
     .maximum = 100.0,
     .prior_sigma = 3.0,
     .prior = "0.3 to 3 of the mean at 400 km between quiet and active Sun, 0.1 to 10 at 700 km",
     .formerly = "density_factor"},
};

const struct um_effect um_effects_free_molecular_heating = {
    UM_EFFECT_ABI,
    .name = "free_molecular_heating",
    .summary = "The thin air of a low orbit heats what faces the motion",
    .reference = "Gilmore 2002, Spacecraft Thermal Control Handbook I, ch. 2; Vallado 2013, table "
                 "8-4 (CIRA-72)",
    .validity = "130 to 1000 km, circular speeds (thermal motion of the gas left out); heat is "
                "reported with the Earth's infrared. An orbit, not points",
    .separated_by = "earth_ir_level and internal_power: it comes from ahead, day and night, and is "
                    "gone on what looks backward",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.environment = add},
};
