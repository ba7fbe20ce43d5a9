/* Spin period: P (1 + r) in place of P. The phase at the reference time of the law is kept, so that
 * the error of the phase grows like -2 pi r (t - t_0) / P. Free motion is slower as a whole by the
 * same factor when its rates are. */
#include "effects/list_impl.h"

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  um_effect_state(out, "spin period", "s", n->spin_period * (1.0 + out->null_value), -INFINITY,
                  INFINITY);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "relative_shift",
     .unit = "1",
     .help = "relative error of the period",
     .null_value = 0.0,
     .default_value = 0.01,
     .minimum = -0.5,
     .maximum = 0.5,
     .prior_sigma = 0.05,
     .stated = stated,
     .change = UM_CHANGE_STRETCHES,
     .prior = "1e-4 to 0.1; 175 and 213 s are both printed for ENVISAT",
     .formerly = "relative"},
};

static enum um_status law(struct um_context *context, const struct um_effect_use *use,
                          struct um_orbit_attitude_law *to)
{
  (void)context;
  if (to->kind == UM_ATTITUDE_SPIN || to->kind == UM_ATTITUDE_MAGNETIC)
    to->period *= 1.0 + use->value[0];
  if (to->kind == UM_ATTITUDE_TUMBLE)
    to->rate = um_vec3_scale(to->rate, 1.0 / (1.0 + use->value[0]));
  return UM_OK;
}

const struct um_effect um_effects_spin_period = {
    UM_EFFECT_ABI,
    .name = "spin_period",
    .summary = "The body spins slower or faster than its law says",
    .reference = "Kucharski et al. 2014, IEEE Trans. Geosci. Remote Sens. 52:7651",
    .validity = "laws of the kind spin or tumble, or magnetic with a period; others stay; the "
                "phase is kept at at_utc, by default the start",
    .separated_by =
        "time_tag and attitude_offset: many revolutions; its lag grows with time, theirs stays",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.law = law},
};
