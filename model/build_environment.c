/* From the scenario's environment and effects to the configuration of Sun and Earth. */
#include <string.h>

#include "core/constants.h"
#include "effects/effects.h"
#include "model/model_impl.h"

static void environment_from_scenario(const struct um_scenario_environment *from,
                                      struct um_environment *to)
{
  um_environment_defaults(to);
  to->solar_irradiance = from->solar_irradiance_W_m2;
  to->spectrum = (enum um_environment_spectrum)from->solar_spectrum;
  to->solar_temperature = from->solar_temperature_K;
  to->albedo = from->albedo;
  to->outgoing_longwave = from->olr_W_m2;
  to->brightness_temperature = from->brightness_temperature_K;
  to->earth_radius = from->earth_radius_km * 1e3;
  to->shadow = (enum um_environment_shadow)from->shadow;
  to->shadow_radius = from->shadow_radius_km * 1e3;
  to->disc = (enum um_environment_disc)from->disc;
  to->limb_darkening = from->limb_darkening;
}

static enum um_status find_effect(struct um_context *context, const char *name, size_t length,
                                  const struct um_effect **out)
{
  char text[64], names[512];
  if (length < sizeof text) {
    memcpy(text, name, length);
    text[length] = '\0';
    *out = um_effects_find(text);
    if (*out != NULL) return UM_OK;
  }
  um_effects_names(names, sizeof names);
  return um_core_fail(context, UM_ERR_INPUT, "no effect is called '%.*s'; accepted: %s",
                      (int)(length > 60 ? 60 : length), name, names);
}

/* Two entries of one effect on one target would leave it to their order which one counts. */
static enum um_status check_listed_once(struct um_context *context,
                                        const struct um_scenario_effect *uses, size_t k)
{
  const char *target = uses[k].target == NULL ? "" : uses[k].target;
  for (size_t i = 0; i < k; i++)
    if (strcmp(uses[i].effect, uses[k].effect) == 0 &&
        strcmp(uses[i].target == NULL ? "" : uses[i].target, target) == 0)
      return um_model_fail(context, &uses[k].at, "effect",
                           "'%s' is already listed on line %d; accepted: once", uses[k].effect,
                           uses[i].at.line);
  return UM_OK;
}

/* `state` of each registered effect, from the scenario's list, then --with, then --without. */
static enum um_status collect_states(struct um_context *context, const struct um_model *model,
                                     const struct um_model_options *options, bool *on)
{
  for (size_t i = 0; i < um_effects_count(); i++) on[i] = um_effects_at(i)->on_by_default != 0;
  const struct um_scenario_effect *uses = model->scenario->effects.items;
  for (size_t k = 0; k < model->scenario->effects.count; k++) {
    const struct um_effect *effect = NULL;
    UM_TRY(um_model_blame(context, &uses[k].at, "effect",
                          find_effect(context, uses[k].effect, strlen(uses[k].effect), &effect)));
    if (uses[k].target != NULL && effect->targets == UM_TARGET_GLOBAL)
      return um_model_fail(context, &uses[k].at, "target",
                           "effect '%s' acts on everything; accepted: no target", effect->name);
    UM_TRY(check_listed_once(context, uses, k));
    for (size_t i = 0; i < um_effects_count(); i++)
      if (um_effects_at(i) == effect) on[i] = !uses[k].off;
  }
  for (int pass = 0; options != NULL && pass < 2; pass++) {
    const char *const *texts = pass == 0 ? options->with : options->without;
    size_t n = pass == 0 ? options->nwith : options->nwithout;
    for (size_t k = 0; k < n; k++) {
      const struct um_effect *effect = NULL;
      size_t length = strcspn(texts[k], ":,");
      enum um_status status = find_effect(context, texts[k], length, &effect);
      if (status == UM_OK && texts[k][length] == ':' && effect->targets == UM_TARGET_GLOBAL)
        status = um_core_fail(context, UM_ERR_INPUT, "effect '%s' takes no target", effect->name);
      if (status == UM_OK && texts[k][length] == ',' && effect->nparameter == 0)
        status = um_core_fail(context, UM_ERR_INPUT, "effect '%s' has no parameters", effect->name);
      if (status != UM_OK) {
        um_core_message_prefix(context, "%s %s", pass == 0 ? "--with" : "--without", texts[k]);
        return status;
      }
      for (size_t i = 0; i < um_effects_count(); i++)
        if (um_effects_at(i) == effect) on[i] = pass == 0;
    }
  }
  return UM_OK;
}

enum um_status um_model_build_environment(struct um_context *context, struct um_model *model,
                                          const struct um_model_options *options)
{
  environment_from_scenario(model->scenario->environment, &model->environment);
  model->sun_frozen = model->scenario->environment->sun == UM_SUN_FROZEN;
  enum um_status status;
  bool *on = NULL;
  UM_TRY(um_core_allocate(context, um_effects_count(), sizeof *on, &on));
  UM_CHECK(collect_states(context, model, options, on));
  for (size_t i = 0; i < um_effects_count(); i++) {
    const struct um_effect *effect = um_effects_at(i);
    if (on[i] || effect->switch_off == NULL) continue;
    UM_CHECK(effect->switch_off(context, &model->environment));
    um_core_log(context, UM_LOG_INFO, "effect %s is off", effect->name);
  }
done:
  um_core_free(context, on);
  return status;
}
