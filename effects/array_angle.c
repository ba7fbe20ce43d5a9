/* Angle of a joint: an offset added to the fixed angle, or to the angle that tracks the Sun. */
#include "base/core/constants.h"
#include "effects/list_impl.h"
#include "geometry/geometry.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "angle_deg",
     .unit = "deg",
     .help = "added to the angle of the joint",
     .null_value = 0.0,
     .default_value = 10.0,
     .minimum = -180.0,
     .maximum = 180.0,
     .prior_sigma = 10.0,
     .prior = "offsets of 10 deg and more are flown on purpose"},
};

static enum um_status geometry(struct um_context *context, const struct um_effect_use *use,
                               struct um_geometry_part_spec *part)
{
  if (use->value[0] == 0.0 || !um_effect_acts_on(use, part->name)) return UM_OK;
  if (part->joint == UM_JOINT_NONE)
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect 'array_angle': part '%s' has no joint; accepted: a part with one",
                        part->name);
  part->joint_angle += use->value[0] * UM_DEG;
  return UM_OK;
}

const struct um_effect um_effects_array_angle = {
    UM_EFFECT_ABI,
    .name = "array_angle",
    .summary = "A solar array stands at another angle than its joint was told",
    .reference = "Payne, Gregory & Luu 2006, AMOS Conference (solar panel offsets)",
    .validity = "a constant offset about the axis of the joint",
    .separated_by = "attitude_offset: the time of the array's glint against that of the body's; "
                    "only the array's light and heat move",
    .targets = UM_TARGET_PART,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.geometry = geometry},
};
