/* What a value of a parameter does to the scenario: a key takes it, or the parameter of an effect.
 * `umbra run --set` or `--with` with 17 digits is the same point. */
#include "study/parameter.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/suggestions.h"
#include "effects/effects.h"
#include "model/build/effects.h"

/* --- against the scenario -------------------------------------------------------------------- */

static enum um_status blame(struct um_context *context, const struct um_study_file_parameter *p,
                            const char *key, enum um_status status)
{
  const struct um_mark *at = um_document_mark_key(&p->at, key);
  bool wrong = status == UM_ERR_INPUT || status == UM_ERR_REFUSED;
  if (wrong && at->line > 0)
    um_core_message_prefix(context, "%s:%d: %s", at->file, at->line, at->path);
  else if (wrong)
    um_core_message_prefix(context, "%s", at->file);
  return status == UM_ERR_REFUSED ? UM_ERR_INPUT : status;
}

/* The value that the scenario has of an effect's parameter: the null value where it has it not. */
static double value_in(const struct um_model *model, const struct um_study_binding *binding)
{
  for (size_t i = 0; i < model->neffect; i++) {
    const struct um_model_effect *e = &model->effect[i];
    if (!e->off && e->effect == binding->effect && um_core_words_same(e->target, binding->target))
      return e->value[binding->which];
  }
  return binding->effect->parameters[binding->which].null_value;
}

static enum um_status material_binding(struct um_context *context, const struct um_model *model,
                                       const struct um_study_file_parameter *p,
                                       struct um_study_binding *out)
{
  bool emittance = p->property == UM_STUDY_EMITTANCE;
  out->effect = um_effects_find(emittance ? "emittance" : "solar_absorptance");
  out->target = p->material;
  out->unit = "1";
  UM_TRY(blame(context, p, "material",
               um_model_check_target(context, model, out->effect, p->material)));
  for (size_t m = 0; m < um_geometry_material_count(model->geometry); m++) {
    if (strcmp(um_geometry_material_name(model->geometry, m), p->material) != 0) continue;
    out->of_record =
        emittance ? um_materials_emittance(model->material[m], NULL, UM_REFERENCE_TEMPERATURE)
                  : um_materials_solar_absorptance(model->material[m], NULL);
  }
  double had = value_in(model, out);
  out->nominal = emittance ? had * out->of_record : had + out->of_record;
  return UM_OK;
}

/* By its name, or the one it had before; results have the present one. */
static enum um_status find_parameter(struct um_context *context,
                                     const struct um_study_file_parameter *p,
                                     struct um_study_binding *out)
{
  struct um_effects_said said = {{NULL}};
  struct um_study_file_parameter present = *p;
  UM_TRY(blame(context, p, "parameter",
               um_effects_parameter_read(context, out->effect, p->parameter, &said, &out->which)));
  present.parameter = out->effect->parameters[out->which].name;
  um_study_parameter_name(&present, out->name);
  return UM_OK;
}

static enum um_status effect_binding(struct um_context *context, const struct um_model *model,
                                     const struct um_study_file_parameter *p,
                                     struct um_study_binding *out)
{
  const struct um_effect *effect = um_effects_registry_find(model->registry, p->effect);
  if (effect == NULL)
    return blame(context, p, "effect",
                 um_effects_registry_refuse(context, model->registry, p->effect));
  out->effect = effect;
  out->target = p->target;
  UM_TRY(blame(context, p, p->target != NULL ? "target" : "effect",
               um_model_check_target(context, model, effect, p->target)));
  if (effect->nparameter == 0)
    return um_document_mark_fail(context, um_document_mark_key(&p->at, "effect"),
                                 "'%s' is on or off and has no number to move", effect->name);
  if (p->parameter == NULL && effect->nparameter > 1)
    return um_document_mark_fail(context, um_document_mark_key(&p->at, "effect"),
                                 "'%s' has %zu parameters; accepted: parameter beside it, one of "
                                 "`umbra list effects %s`",
                                 effect->name, effect->nparameter, effect->name);
  if (p->parameter != NULL) UM_TRY(find_parameter(context, p, out));
  out->unit = effect->parameters[out->which].unit;
  out->nominal = value_in(model, out);
  return UM_OK;
}

enum um_status um_study_binding_find(struct um_context *context, const struct um_model *model,
                                     const struct um_study_file_parameter *p,
                                     struct um_study_binding *out)
{
  *out = (struct um_study_binding){.file = p,
                                   .distribution = um_study_distribution(p),
                                   .unit = "",
                                   .of_record = NAN,
                                   .nominal = NAN};
  um_study_parameter_name(p, out->name);
  if (p->material != NULL) UM_TRY(material_binding(context, model, p, out));
  if (p->effect != NULL) UM_TRY(effect_binding(context, model, p, out));
  if (p->key != NULL) out->nominal = um_document_number(model->document, p->key);
  if (p->unit != NULL) out->unit = p->unit;
  return UM_OK;
}

enum um_status um_study_binding_check_ends(struct um_context *context,
                                           const struct um_study_binding *binding)
{
  const struct um_mark *at = &binding->file->at;
  double least, largest;
  if (binding->effect == NULL) return UM_OK;
  const struct um_effect_parameter *of = &binding->effect->parameters[binding->which];
  um_uncertainty_distribution_ends(&binding->distribution, &least, &largest);
  if (!isnan(binding->of_record))
    return least > 0.0 && largest <= 1.0
               ? UM_OK
               : um_document_mark_fail(context, at,
                                       "%s from %g to %g; accepted: above 0, at most 1",
                                       binding->name, least, largest);
  if (least >= of->minimum && largest <= of->maximum) return UM_OK;
  return um_document_mark_fail(context, at, "%s from %g to %g; accepted: %g to %g %s",
                               binding->name, least, largest, of->minimum, of->maximum, of->unit);
}

bool um_study_binding_same(const struct um_study_binding *binding, const struct um_model *a,
                           const struct um_model *b)
{
  return binding->effect == NULL || value_in(a, binding) == value_in(b, binding);
}

/* --- changes of a point ---------------------------------------------------------------------- */

static bool same_use(const struct um_study_binding *a, const struct um_study_binding *b)
{
  return a->effect != NULL && a->effect == b->effect && um_core_words_same(a->target, b->target);
}

/* The number that the effect's parameter takes. */
static double effect_value(const struct um_study_binding *binding, double value)
{
  if (isnan(binding->of_record)) return value;
  return binding->file->property == UM_STUDY_EMITTANCE ? value / binding->of_record
                                                       : value - binding->of_record;
}

/* The effect of a binding: what is bound moves, other parameters are as the scenario has them. */
static struct um_model_addition addition_of(const struct um_model *nominal,
                                            const struct um_study_binding *binding, size_t nbinding,
                                            const double *value, size_t first)
{
  struct um_model_addition a = {.effect = binding[first].effect, .target = binding[first].target};
  struct um_study_binding each = binding[first];
  for (each.which = 0; each.which < a.effect->nparameter; each.which++)
    a.value[each.which] = value_in(nominal, &each);
  for (size_t i = first; i < nbinding; i++)
    if (same_use(&binding[first], &binding[i]))
      a.value[binding[i].which] = effect_value(&binding[i], value[i]);
  return a;
}

enum um_status um_study_changes_make(struct um_context *context, const struct um_model *nominal,
                                     const struct um_study_binding *binding, size_t nbinding,
                                     const double *value, struct um_study_changes *out)
{
  *out = (struct um_study_changes){0};
  UM_TRY(um_core_allocate(context, nbinding, sizeof *out->key, &out->key));
  UM_TRY(um_core_allocate(context, nbinding, sizeof *out->addition, &out->addition));
  for (size_t i = 0; i < nbinding; i++) {
    bool done = false;
    for (size_t j = 0; j < i; j++) done = done || same_use(&binding[j], &binding[i]);
    if (done) continue;
    if (binding[i].effect == NULL)
      out->key[out->all.nkey++] =
          (struct um_document_change){.key = binding[i].file->key, .number = value[i]};
    else
      out->addition[out->all.naddition++] = addition_of(nominal, binding, nbinding, value, i);
  }
  out->all.key = out->key;
  out->all.addition = out->addition;
  return UM_OK;
}

void um_study_changes_clear(struct um_context *context, struct um_study_changes *changes)
{
  UM_FREE(context, changes->key, changes->addition);
  *changes = (struct um_study_changes){0};
}
