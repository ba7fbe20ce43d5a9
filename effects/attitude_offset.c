/* Attitude offset: the body is turned from what the law says by a constant rotation vector theta in
 * body axes, about theta/|theta| by |theta|. */
#include "base/core/constants.h"
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "x_deg",
     .unit = "deg",
     .help = "turn about the body axis x",
     .null_value = 0.0,
     .default_value = 0.0,
     .minimum = -180.0,
     .maximum = 180.0,
     .prior_sigma = 5.0,
     .prior = "0.1 to 10 deg"},
    {.name = "y_deg",
     .unit = "deg",
     .help = "turn about the body axis y",
     .null_value = 0.0,
     .default_value = 0.0,
     .minimum = -180.0,
     .maximum = 180.0,
     .prior_sigma = 5.0,
     .prior = "0.1 to 10 deg"},
    {.name = "z_deg",
     .unit = "deg",
     .help = "turn about the body axis z",
     .null_value = 0.0,
     .default_value = 0.0,
     .minimum = -180.0,
     .maximum = 180.0,
     .prior_sigma = 5.0,
     .prior = "0.1 to 10 deg"},
};

static struct um_quat attitude(const struct um_effect_use *use, double t_tai, struct um_quat q)
{
  struct um_vec3 theta =
      um_vec3_scale(um_vec3(use->value[0], use->value[1], use->value[2]), UM_DEG); /* [rad] */
  double angle = um_vec3_norm(theta);
  (void)t_tai;
  if (!(angle > 0.0)) return q;
  return um_quat_then(q, um_quat_from_axis(um_vec3_scale(theta, 1.0 / angle), angle));
}

const struct um_effect um_effects_attitude_offset = {
    UM_EFFECT_ABI,
    .name = "attitude_offset",
    .summary = "The body stands at a constant angle from its attitude law",
    .reference = "Shuster 1993, J. Astronaut. Sci. 41:439",
    .validity = "constant in the body frame; it turns with a spinning body",
    .separated_by = "time_tag, spin_period and array_angle: glints of several sides in different "
                    "directions; one turn must move them all, and temperatures with them",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.attitude = attitude},
};
