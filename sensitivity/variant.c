/* What of the scenario's own geometry precomputation still holds for a scenario with additions. It
 * is geometry and light before any optical property acts; factors that act behind it (earthshine,
 * reflected Earth radiation, and the switches of the heat loads) leave it alone. */
#include "sensitivity/variant_impl.h"

#include "core/words.h"
#include "effects/effects.h"

static bool same_region(const struct um_environment_region *a,
                        const struct um_environment_region *b)
{
  return a->everywhere == b->everywhere && a->latitude == b->latitude &&
         a->longitude == b->longitude && a->radius == b->radius && a->edge == b->edge &&
         a->from_tai == b->from_tai && a->to_tai == b->to_tai && a->ramp == b->ramp &&
         a->albedo_factor == b->albedo_factor && a->albedo_offset == b->albedo_offset &&
         a->longwave_factor == b->longwave_factor && a->longwave_offset == b->longwave_offset &&
         a->brightness_shift == b->brightness_shift;
}

/* The same ground. A brightness temperature is of the light alone while it is one for all of the
 * Earth; where places differ the precomputation has it. */
static bool same_earth(const struct um_environment *a, const struct um_environment *b)
{
  if (!um_environment_earth_varies(a) && !um_environment_earth_varies(b)) return true;
  return a->earth == b->earth && a->map == b->map && a->albedo_factor == b->albedo_factor &&
         a->longwave_factor == b->longwave_factor && a->brightness_shift == b->brightness_shift &&
         a->brightness_temperature == b->brightness_temperature &&
         same_region(&a->region, &b->region);
}

/* The same air at the edge of the shadow; the table of the limb is the scenario's in both. */
static bool same_air(const struct um_environment *a, const struct um_environment *b)
{
  if (a->shadow_refraction_on != b->shadow_refraction_on) return false;
  return !a->shadow_refraction_on ||
         (a->air_factor == b->air_factor && a->ozone_dobson == b->ozone_dobson &&
          a->haze == b->haze && a->aerosol == b->aerosol && a->cloud_top == b->cloud_top);
}

/* Do both environments give the same geometry precomputation? */
static bool same_light(const struct um_environment *a, const struct um_environment *b)
{
  return a->solar_irradiance == b->solar_irradiance && a->albedo == b->albedo &&
         a->outgoing_longwave == b->outgoing_longwave && a->earth_radius == b->earth_radius &&
         a->shadow == b->shadow && a->shadow_radius == b->shadow_radius && a->disc == b->disc &&
         a->limb_darkening == b->limb_darkening && a->moonlight_on == b->moonlight_on &&
         a->gas_density_factor == b->gas_density_factor && same_air(a, b) && same_earth(a, b) &&
         (a->specular_exchange_on || !b->specular_exchange_on) && /* paths by mirrors are there */
         (a->absorptance_by_angle || !b->absorptance_by_angle);   /* angular moments are */
}

size_t um_sensitivity_variant_key(const struct um_model *scenario, const struct um_model *variant,
                                  const struct um_model_addition *addition, size_t naddition,
                                  struct um_model_addition *key)
{
  bool lit = !same_light(&scenario->environment, &variant->environment);
  size_t count = 0;
  for (size_t i = 0; i < naddition; i++) {
    uint32_t reach = um_effects_reach(addition[i].effect);
    if ((reach & UM_REACH_PRECOMPUTED) != 0 || (lit && (reach & UM_REACH_LIGHT) != 0))
      key[count++] = addition[i];
  }
  return count;
}

static bool same_addition(const struct um_model_addition *a, const struct um_model_addition *b)
{
  if (a->effect != b->effect || !um_core_words_same(a->target, b->target)) return false;
  for (size_t p = 0; p < a->effect->nparameter; p++)
    if (a->value[p] != b->value[p]) return false;
  return true;
}

bool um_sensitivity_variant_same_key(const struct um_model_addition *a, size_t na,
                                     const struct um_model_addition *b, size_t nb)
{
  if (na != nb) return false;
  for (size_t i = 0; i < na; i++)
    if (!same_addition(&a[i], &b[i])) return false;
  return true;
}
