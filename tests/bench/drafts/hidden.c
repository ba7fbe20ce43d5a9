/* Ten effects that no catalogue has, one by HIDDEN: seven of light, three of heat. None is a curve
 * of effects/curve.h along a coordinate of effects/view.h but by chance. */
#include "effects/effect.h"

static const struct um_effect_parameter parameters[] = {{.name = "share",
                                                         .unit = "1",
                                                         .help = "how much of it",
                                                         .null_value = 0.0,
                                                         .default_value = 1.0,
                                                         .minimum = -10.0,
                                                         .maximum = 10.0,
                                                         .prior_sigma = 1.0}};

#if HIDDEN <= 8
static double toward(struct um_vec3 v, double x, double y, double z)
{
  return fmax(0.0, um_vec3_dot(v, um_vec3_unit(um_vec3(x, y, z))));
}

static enum um_status light(struct um_context *context, const struct um_effect_use *use,
                            struct um_effect_observation *o)
{
  const struct um_effect_view *v = o->view;
  double a = use->value[0];
  (void)context;
  if (v == NULL) return UM_OK;
  int visible = o->band[0] == 'v', below = !o->exo_atmospheric;
  double away = um_vec3_angle(v->sun, v->nadir), square = v->range * v->range;
  struct um_vec3 middle = um_vec3_unit(um_vec3_add(v->sun, v->observer));
  switch (HIDDEN) {
  case 1: /* a bank of cloud */
    if (below && o->elevation < 0.5236) o->value *= 1.0 - 0.3 * a;
    break;
  case 2: /* foil that is brighter where the Sun is behind the observer */
    if (visible)
      o->value *= 1.0 + 0.5 * a * exp(-tan(0.5 * um_vec3_angle(v->sun, v->observer)) / 0.4) *
                            um_effect_share(v, "mli");
    break;
  case 3: /* cells that are brighter at grazing incidence */
    if (visible)
      o->value *=
          1.0 + 2.0 * a * pow(1.0 - toward(v->sun, 0, 0, 1), 3.0) * um_effect_share(v, "cell");
    break;
  case 4: /* a lamp */
    if (visible) o->value += 10.0 * a * toward(v->observer, 0, 0, 1) / square;
    break;
  case 5: /* a facet that nobody drew: a lobe about a normal between the axes */
    if (visible)
      o->value += 40.0 * a * pow(toward(middle, 0.3, 0.1, 0.95), 20.0) * v->sunlit / square;
    break;
  case 6: /* the lit limb, in both bands */
    o->value *= 1.0 + a * (visible ? 0.3 : 0.1) / (1.0 + exp((away - 1.3) / 0.05));
    break;
  case 7: /* a detector that warms up */
    o->value *= 1.0 + 0.2 * a * (1.0 - exp(-(o->t_tai - use->epoch) / 200.0));
    break;
  default: /* light of a city */
    if (visible && below)
      o->value += 5e-12 * a * exp(2.0 * (cos(v->azimuth - 1.2) - 1.0)) * sqrt(v->airmass);
  }
  return UM_OK;
}
#define HOOKS                                                                                      \
  {                                                                                                \
    .observation = light                                                                           \
  }
#else
static void put(struct um_thermal_part_spec *spec, const char *place, double power,
                struct um_thermal_course course)
{
  spec->timed[spec->ntimed++] = (struct um_thermal_timed){place, power, course};
}

static enum um_status heat(struct um_context *context, const struct um_effect_use *use,
                           const char *part, struct um_thermal_part_spec *spec)
{
  double a = use->value[0], t = use->epoch;
  (void)context;
  if (a == 0.0) return UM_OK;
  if (HIDDEN == 9 && strcmp(part, "bus") == 0) { /* a battery: a burst on a load that stays */
    put(spec, "-x", 600.0 * a, (struct um_thermal_course){UM_HEAT_DECAY, t + 100.0, 400.0, NAN});
    put(spec, "-x", 200.0 * a, (struct um_thermal_course){UM_HEAT_STEP, t + 100.0, INFINITY, NAN});
  }
  for (int i = 0; i < 3 && HIDDEN == 10 && strcmp(part, "array") == 0; i++) /* a relay, unevenly */
    put(spec, "", 400.0 * a,
        (struct um_thermal_course){UM_HEAT_PULSE, t + 60.0 + 200.0 * i, 40.0 + 20.0 * i, NAN});
  return UM_OK;
}
#define HOOKS                                                                                      \
  {                                                                                                \
    .part = heat                                                                                   \
  }
#endif

const struct um_effect um_effect = {
    UM_EFFECT_ABI,
    .name = "hidden",
    .summary = "One of ten that no catalogue has",
    .reference = "none",
    .validity = "this bench",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = HOOKS,
};
