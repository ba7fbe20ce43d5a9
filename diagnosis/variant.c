/* A scenario with effects added, and what of the scenario's own geometry still holds for it.
 *
 * The trace is geometry and light before any optical property acts. It hangs on shapes, orbit,
 * attitude, times of observation, and of the environment on what the loads are made of: Sun, Earth
 * and shadow. Factors that act behind the trace (earthshine, reflected Earth radiation, and the
 * switches of the heat loads) leave it alone. */
#include <stdio.h>
#include <string.h>

#include "diagnosis/forward_impl.h"

enum um_status um_diagnosis_addition_text(struct um_context *context,
                                          const struct um_diagnosis_addition *addition, char **out)
{
  const struct um_effect *effect = addition->effect;
  size_t room = strlen(effect->name) + 2, at;
  if (addition->target != NULL) room += strlen(addition->target) + 1;
  for (size_t p = 0; p < effect->nparameter; p++) room += strlen(effect->parameters[p].name) + 32;
  UM_TRY(um_core_allocate(context, room, 1, out));
  at = (size_t)snprintf(*out, room, "%s%s%s", effect->name, addition->target != NULL ? ":" : "",
                        addition->target != NULL ? addition->target : "");
  for (size_t p = 0; p < effect->nparameter; p++)
    at += (size_t)snprintf(*out + at, room - at, ",%s=%.17g", effect->parameters[p].name,
                           addition->value[p]);
  return UM_OK;
}

enum um_status um_diagnosis_variant_create(struct um_context *context,
                                           const struct um_diagnosis_forward *forward,
                                           const struct um_diagnosis_addition *addition,
                                           size_t naddition, struct um_model **out)
{
  enum um_status status;
  struct um_model_options options = forward->cache->options;
  char **text = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, naddition, sizeof *text, &text));
  for (size_t i = 0; i < naddition; i++)
    UM_CHECK(um_diagnosis_addition_text(context, &addition[i], &text[i]));
  options.last = (const char *const *)text;
  options.nlast = naddition;
  UM_CHECK(um_model_create(context, forward->path, &options, out));
done:
  for (size_t i = 0; text != NULL && i < naddition; i++) um_core_free(context, text[i]);
  um_core_free(context, text);
  return status;
}

/* Does the trace depend on this effect, whatever its values? */
static bool moves(const struct um_effect *effect)
{
  const struct um_effect_hooks *h = &effect->hooks;
  return h->geometry != NULL || h->time != NULL || h->exposure != NULL || h->along_track != NULL ||
         h->law != NULL || h->attitude != NULL;
}

static bool lights(const struct um_effect *effect)
{
  return effect->hooks.environment != NULL || effect->on_by_default;
}

/* Do both environments give the same trace? */
static bool same_light(const struct um_environment *a, const struct um_environment *b)
{
  return a->solar_irradiance == b->solar_irradiance && a->albedo == b->albedo &&
         a->outgoing_longwave == b->outgoing_longwave && a->earth_radius == b->earth_radius &&
         a->shadow == b->shadow && a->shadow_radius == b->shadow_radius && a->disc == b->disc &&
         a->limb_darkening == b->limb_darkening;
}

enum um_status um_diagnosis_variant_key(struct um_context *context,
                                        const struct um_diagnosis_forward *forward,
                                        const struct um_model *variant,
                                        const struct um_diagnosis_addition *addition,
                                        size_t naddition, char **out)
{
  bool lit = !same_light(&forward->model->environment, &variant->environment);
  UM_TRY(um_core_strdup(context, "", out));
  for (size_t i = 0; i < naddition; i++) {
    char *text = NULL, *longer = NULL;
    if (!moves(addition[i].effect) && !(lit && lights(addition[i].effect))) continue;
    enum um_status status = um_diagnosis_addition_text(context, &addition[i], &text);
    if (status == UM_OK) status = um_core_asprintf(context, &longer, "%s%s;", *out, text);
    um_core_free(context, text);
    um_core_free(context, *out);
    *out = longer;
    UM_TRY(status);
  }
  return UM_OK;
}
