/* Scenarios: read, checked, changed. */
#include "library/scenario_impl.h"

#include <math.h>
#include <string.h>

#include "effects/effects.h"
#include "model/scenario/scenario_read.h"

#define IN_MEMORY "scenario.yaml" /* what messages call a text without a path */

/* Is the scenario good as it stands? */
static enum um_status check(struct um_context *context, const struct um_library_source *source)
{
  struct um_document *document = NULL;
  const struct um_scenario *scenario;
  UM_TRY(um_model_scenario_read(context, source->path, source->text, NULL, 0, source->set,
                                source->nset, &document, &scenario));
  um_document_destroy(&document);
  return UM_OK;
}

static enum um_status read(struct um_context *context, const char *path, const char *text,
                           struct um_library_source *source)
{
  struct um_document *document = NULL;
  const struct um_scenario *scenario;
  if (path == NULL && text == NULL)
    return um_core_fail(context, UM_ERR_INPUT, "no scenario; accepted: a path, or a text");
  UM_TRY(um_model_scenario_read(context, path != NULL ? path : IN_MEMORY, text, NULL, 0, NULL, 0,
                                &document, &scenario));
  enum um_status status = um_core_strdup(context, scenario->at.file, &source->path);
  if (status == UM_OK) status = um_document_text(context, document, &source->text);
  um_document_destroy(&document);
  return status;
}

enum umbra_status umbra_scenario_read(struct umbra *umbra, const char *path, const char *text,
                                      struct umbra_scenario **out)
{
  struct um_context *context = um_library_begin(umbra);
  struct umbra_scenario *scenario = NULL;
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *scenario, &scenario));
  scenario->session = um_library_session_share(umbra);
  UM_CHECK(read(context, path, text, &scenario->source));
  *out = scenario;
done:
  if (status != UM_OK) umbra_scenario_close(&scenario);
  return um_library_status(status);
}

void umbra_scenario_close(struct umbra_scenario **scenario)
{
  if (scenario == NULL || *scenario == NULL) return;
  struct umbra *session = (*scenario)->session;
  um_document_destroy(&(*scenario)->document);
  um_library_source_release(session->context, &(*scenario)->source);
  um_core_free(session->context, *scenario);
  *scenario = NULL;
  um_library_session_drop(&session);
}

enum um_status um_library_take_key(struct um_context *context, const char *key, double number,
                                   const char *text, struct um_document_change *out)
{
  if (strchr(key, '=') != NULL)
    return um_core_fail(context, UM_ERR_INPUT, "'%s': no key holds '='", key);
  if (text == NULL && !isfinite(number))
    return um_core_fail(context, UM_ERR_INPUT, "%s: %g; accepted: a finite number", key, number);
  *out = (struct um_document_change){
      .key = key, .number = text == NULL ? number : (double)NAN, .text = text, .as_written = true};
  return UM_OK;
}

static enum um_status read_value(struct um_context *context, const char *name, double value,
                                 struct um_effects_said *said,
                                 struct um_library_effect_numbers *out)
{
  size_t p;
  UM_TRY(um_effects_parameter_read(context, out->effect, name, said, &p));
  const struct um_effect_parameter *parameter = &out->effect->parameters[p];
  out->said[p] = true;
  out->value[p] = value;
  if (value >= parameter->minimum && value <= parameter->maximum) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "%s: %s: %g is out of range; accepted: %g to %g %s",
                      out->effect->name, name, value, parameter->minimum, parameter->maximum,
                      parameter->unit);
}

enum um_status um_library_read_effect_change(struct um_context *context,
                                             const struct um_effects_registry *registry,
                                             const struct umbra_effect_change *change,
                                             struct um_library_effect_numbers *out)
{
  struct um_effects_said said = {{NULL}};
  UM_TRY(
      um_library_check_size(context, "struct umbra_effect_change", change->size, sizeof *change));
  if (change->effect == NULL)
    return um_core_fail(context, UM_ERR_INPUT, "a change names no effect; accepted: one");
  const struct um_effect *effect = um_effects_registry_find(registry, change->effect);
  if (effect == NULL) return um_effects_registry_refuse(context, registry, change->effect);
  *out = (struct um_library_effect_numbers){.effect = effect};
  for (size_t p = 0; p < change->nparameter; p++)
    UM_TRY(read_value(context, change->parameter[p], change->value[p], &said, out));
  if (change->target != NULL && effect->targets == UM_TARGET_GLOBAL)
    return um_core_fail(context, UM_ERR_INPUT, "%s acts on everything; accepted: no target",
                        effect->name);
  if (change->target == NULL && !change->off && (effect->targets & UM_TARGET_GLOBAL) == 0)
    return um_core_fail(context, UM_ERR_INPUT, "%s needs a target", effect->name);
  return UM_OK;
}

enum um_status um_library_take_change(struct um_context *context,
                                      const struct um_effects_registry *registry,
                                      const struct umbra_effect_change *change,
                                      struct um_library_source *source)
{
  struct um_library_effect_numbers numbers;
  const char *name[UM_EFFECT_PARAMETERS_MAX];
  double value[UM_EFFECT_PARAMETERS_MAX];
  size_t n = 0;
  UM_TRY(um_library_read_effect_change(context, registry, change, &numbers));
  for (size_t p = 0; p < numbers.effect->nparameter; p++) {
    if (!numbers.said[p]) continue;
    name[n] = numbers.effect->parameters[p].name;
    value[n++] = numbers.value[p];
  }
  const struct um_model_change typed = {.effect = change->effect,
                                        .target = change->target,
                                        .off = change->off != 0,
                                        .parameter = name,
                                        .value = value,
                                        .nparameter = n};
  return um_library_source_add_change(context, source, &typed);
}

enum um_status um_library_check_change(struct um_context *context,
                                       const struct umbra_change *change, size_t index)
{
  UM_TRY(um_library_check_size(context, "struct umbra_change", change->size, sizeof *change));
  if ((change->key == NULL) != (change->effect == NULL)) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "change %zu; accepted: a key or an effect", index + 1);
}

static enum um_status take(struct umbra *umbra, const struct umbra_change *change, size_t index,
                           struct um_library_source *source)
{
  struct um_context *context = umbra->context;
  struct um_document_change key;
  UM_TRY(um_library_check_change(context, change, index));
  if (change->key == NULL)
    return um_library_take_change(context, umbra->registry, change->effect, source);
  UM_TRY(um_library_take_key(context, change->key, change->number, change->text, &key));
  return um_library_source_add_set(context, source, &key);
}

enum umbra_status umbra_scenario_change(struct umbra *umbra, struct umbra_scenario *scenario,
                                        const struct umbra_change *change, size_t n)
{
  struct um_context *context = um_library_begin(umbra);
  struct um_library_source *source = &scenario->source;
  size_t nset = source->nset, nchange = source->nchange;
  enum um_status status = UM_OK;
  um_document_destroy(&scenario->document);
  for (size_t i = 0; status == UM_OK && i < n; i++) status = take(umbra, &change[i], i, source);
  if (status == UM_OK && source->nset > nset) status = check(context, source);
  while (status != UM_OK && source->nset > nset) um_library_source_drop_set(context, source);
  while (status != UM_OK && source->nchange > nchange)
    um_library_source_drop_change(context, source);
  return um_library_status(status);
}

enum umbra_status umbra_scenario_set(struct umbra *umbra, struct umbra_scenario *scenario,
                                     const char *key, const char *value)
{
  struct umbra_change change = UMBRA_CHANGE;
  change.key = key;
  change.number = NAN;
  change.text = value;
  return umbra_scenario_change(umbra, scenario, &change, 1);
}

enum umbra_status umbra_scenario_set_number(struct umbra *umbra, struct umbra_scenario *scenario,
                                            const char *key, double value)
{
  struct umbra_change change = UMBRA_CHANGE;
  change.key = key;
  change.number = value;
  return umbra_scenario_change(umbra, scenario, &change, 1);
}

enum umbra_status umbra_scenario_effect(struct umbra *umbra, struct umbra_scenario *scenario,
                                        const struct umbra_effect_change *effect)
{
  struct umbra_change change = UMBRA_CHANGE;
  change.effect = effect;
  return umbra_scenario_change(umbra, scenario, &change, 1);
}

static struct umbra_value value_of(const struct um_document_value *v)
{
  static const enum umbra_value_kind kinds[] = {[UM_DOCUMENT_NUMBER] = UMBRA_VALUE_NUMBER,
                                                [UM_DOCUMENT_TEXT] = UMBRA_VALUE_TEXT,
                                                [UM_DOCUMENT_LIST] = UMBRA_VALUE_LIST,
                                                [UM_DOCUMENT_GROUP] = UMBRA_VALUE_GROUP};
  struct umbra_value out = {.kind = kinds[v->kind],
                            .number = v->number,
                            .text = v->text,
                            .count = v->count,
                            .name = v->name,
                            .nname = v->name != NULL ? v->count : 0};
  bool word = v->kind == UM_DOCUMENT_TEXT && !v->quoted;
  bool yes = word && strcmp(v->text, "true") == 0, no = word && strcmp(v->text, "false") == 0;
  if (!yes && !no) return out;
  out.kind = UMBRA_VALUE_FLAG;
  out.number = yes ? 1.0 : 0.0;
  return out;
}

enum umbra_status umbra_scenario_get(struct umbra *umbra, struct umbra_scenario *scenario,
                                     const char *key, const struct umbra_value **out)
{
  struct um_context *context = um_library_begin(umbra);
  const struct um_library_source *source = &scenario->source;
  const struct um_scenario *read;
  struct um_document_value value;
  enum um_status status = UM_OK;
  *out = NULL;
  if (scenario->document == NULL)
    UM_CHECK(um_model_scenario_read(context, source->path, source->text, NULL, 0, source->set,
                                    source->nset, &scenario->document, &read));
  UM_CHECK(um_document_value(scenario->document, key, &value));
  if (value.kind == UM_DOCUMENT_NOTHING)
    UM_CHECK(um_core_fail(context, UM_ERR_INPUT, "%s: the scenario states nothing there", key));
  scenario->value = value_of(&value);
  *out = &scenario->value;
done:
  return um_library_status(status);
}
