/* Heat capacity and conductivity of a wall or solid at its own temperature, where its material's
 * record has tables (thermal.by_temperature):
 *
 *   C(T) dT/dt = div(k(T) grad T) + loads.
 *
 * Numbers that a scenario states itself hold at every temperature. */
#include "effects/list_impl.h"

UM_EFFECT_SWITCH(switch_off, environment->bulk_by_temperature = false)

const struct um_effect um_effects_bulk_temperature = {
    UM_EFFECT_ABI,
    .name = "bulk_temperature",
    .summary = "Walls and solids store and conduct heat as their material does at their own "
               "temperature",
    .reference = "Incropera and DeWitt 2002, app. A; NIST Cryogenic Materials Database",
    .validity = "walls and solids that take heat capacity or conductivity from a record with "
                "tables; constant beyond the tables' ends. Off: those of 300 K",
    .separated_by = "heat_capacity: the same factor warm and cold; at 300 K it does nothing",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
