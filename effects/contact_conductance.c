/* Conductance of contacts, hinges and brackets: Q = f G (T_a - T_b). The temperatures of parts draw
 * together over minutes to hours, in sunlight and in the dark. */
#include "effects/list_impl.h"
#include "thermal/network/body.h"

/* The place itself, or one of the part: "bus" and "bus.+x" are both met by the target "bus". */
static bool acts_on(const struct um_effect_use *use, const char *place)
{
  if (um_effect_acts_on(use, place)) return true;
  size_t n = strlen(use->target);
  return strncmp(use->target, place, n) == 0 && place[n] == '.';
}

static enum um_status scale(struct um_context *context, const struct um_effect_use *use,
                            struct um_thermal_contact *contact)
{
  (void)context;
  if (acts_on(use, contact->a) || acts_on(use, contact->b)) contact->conductance *= use->value[0];
  return UM_OK;
}

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  um_effect_state(out, "conductance of the contact", "W/K",
                  n->contact_conductance * out->null_value, -INFINITY, INFINITY);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "of the conductance that the scenario states",
     .null_value = 1.0,
     .default_value = 3.0,
     .minimum = 0.001,
     .maximum = 1000.0,
     .prior_sigma = 2.0,
     .logarithmic = true,
     .stated = stated,
     .change = UM_CHANGE_SCALES,
     .prior = "0.05 to 5 W/K for one joint, a factor of 10 either way",
     .formerly = "conductance_factor"},
};

const struct um_effect um_effects_contact_conductance = {
    UM_EFFECT_ABI,
    .name = "contact_conductance",
    .summary = "Contacts, hinges or brackets conduct better or worse than stated",
    .reference = "Gilmore 2002, Spacecraft Thermal Control Handbook I, ch. 8",
    .validity = "contacts of the scenario: all, or those with an end on the part or place named",
    .separated_by = "internal_power and through_conductance: temperatures of both ends over hours "
                    "draw together, in sunlight and in the dark alike",
    .targets = UM_TARGET_GLOBAL | UM_TARGET_PART | UM_TARGET_PART_SIDE,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.contact = scale},
};
