/* Effects and keys with their documentation. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/listing.h"
#include "effects/effects.h"
#include "environment/environment.h"
#include "library/key_unit_impl.h"
#include "library/session_impl.h"
#include "model/build/sensor_preset.h"
#include "model/scenario/scenario_schema.h"

#define SAME(ours, theirs)                                                                         \
  _Static_assert((int)UMBRA_TARGET_##ours == (int)UM_TARGET_##theirs, "a number of its "           \
                                                                      "own: " #ours)
SAME(GLOBAL, GLOBAL);
SAME(PART, PART);
SAME(SIDE, PART_SIDE);
SAME(MATERIAL, MATERIAL);
SAME(BAND, BAND);
SAME(SENSOR, SENSOR);
SAME(INTERIOR, INTERIOR);

static struct umbra_parameter parameter_of(const struct um_effect *effect, size_t p)
{
  const struct um_effect_parameter *from = &effect->parameters[p];
  return (struct umbra_parameter){.name = from->name,
                                  .unit = from->unit,
                                  .help = from->help,
                                  .null_value = from->null_value,
                                  .default_value = from->default_value,
                                  .minimum = from->minimum,
                                  .maximum = from->maximum,
                                  .prior_sigma = from->prior_sigma,
                                  .prior = from->prior,
                                  .logarithmic = from->logarithmic,
                                  .fitted = p < um_effect_fitted(effect)};
}

static enum um_status list_effects(struct umbra *umbra)
{
  struct um_context *context = umbra->context;
  size_t n = um_effects_registry_count(umbra->registry);
  struct umbra_effect *effect;
  UM_TRY(um_core_arena_allocate(context, &umbra->memory, n, sizeof *effect, &effect));
  for (size_t i = 0; i < n; i++) {
    const struct um_effect *from = um_effects_registry_at(umbra->registry, i);
    struct umbra_parameter *parameter;
    UM_TRY(um_core_arena_allocate(context, &umbra->memory, from->nparameter, sizeof *parameter,
                                  &parameter));
    for (size_t p = 0; p < from->nparameter; p++) parameter[p] = parameter_of(from, p);
    effect[i] = (struct umbra_effect){.name = from->name,
                                      .summary = from->summary,
                                      .reference = from->reference,
                                      .validity = from->validity,
                                      .separated_by = from->separated_by,
                                      .targets = from->targets,
                                      .on_by_default = from->on_by_default,
                                      .parameter = parameter,
                                      .nparameter = from->nparameter};
  }
  umbra->effect = effect;
  umbra->neffect = n;
  return UM_OK;
}

static enum um_status keep_text(struct umbra *umbra, const char *text, const char **out)
{
  char *copy;
  size_t n = strlen(text) + 1;
  UM_TRY(um_core_arena_allocate(umbra->context, &umbra->memory, n, 1, &copy));
  memcpy(copy, text, n);
  *out = copy;
  return UM_OK;
}

static enum umbra_key_type type_of(enum um_schema_type type)
{
  switch (type) {
  case UM_SCHEMA_NUMBER:
    return UMBRA_KEY_NUMBER;
  case UM_SCHEMA_INTEGER:
    return UMBRA_KEY_INTEGER;
  case UM_SCHEMA_BOOL:
    return UMBRA_KEY_BOOL;
  case UM_SCHEMA_TEXT:
  case UM_SCHEMA_PARSED:
    return UMBRA_KEY_TEXT;
  case UM_SCHEMA_CHOICE:
    return UMBRA_KEY_CHOICE;
  case UM_SCHEMA_VECTOR:
  case UM_SCHEMA_NUMBERS:
    return UMBRA_KEY_NUMBERS;
  case UM_SCHEMA_TEXTS:
    return UMBRA_KEY_TEXTS;
  case UM_SCHEMA_MAP:
    return UMBRA_KEY_MAP;
  case UM_SCHEMA_LIST:
  case UM_SCHEMA_DICT:
  case UM_SCHEMA_REST:
    break;
  }
  return UMBRA_KEY_LIST;
}

static bool has_default(const struct um_schema_field *field)
{
  bool number = field->type == UM_SCHEMA_NUMBER || field->type == UM_SCHEMA_INTEGER ||
                field->type == UM_SCHEMA_BOOL || field->type == UM_SCHEMA_CHOICE ||
                field->type == UM_SCHEMA_VECTOR;
  return number && !field->required;
}

static enum um_status count_key(void *self, const char *path, const struct um_schema_field *field)
{
  (void)path;
  (void)field;
  (*(size_t *)self)++;
  return UM_OK;
}

static enum um_status add_key(void *self, const char *path, const struct um_schema_field *field)
{
  struct umbra *umbra = self;
  struct umbra_key *key = &umbra->key[umbra->nkey++];
  char unit[UM_LIBRARY_UNIT], accepted[640];
  bool bounded = field->minimum != field->maximum;
  *key = (struct umbra_key){.help = field->help,
                            .type = type_of(field->type),
                            .required = field->required,
                            .minimum = bounded && isfinite(field->minimum) ? field->minimum : NAN,
                            .maximum = bounded && isfinite(field->maximum) ? field->maximum : NAN,
                            .default_value = has_default(field) ? field->default_value : NAN,
                            .choice = field->choices};
  um_library_key_unit(field->key, unit);
  um_document_schema_accepted(field, accepted, sizeof accepted);
  if (unit[0] != '\0') UM_TRY(keep_text(umbra, unit, &key->unit));
  UM_TRY(keep_text(umbra, accepted, &key->accepted));
  return keep_text(umbra, path, &key->path);
}

static enum um_status list_keys(struct umbra *umbra)
{
  size_t n = 0;
  UM_TRY(um_document_schema_walk(&um_model_scenario_schema, count_key, &n));
  UM_TRY(
      um_core_arena_allocate(umbra->context, &umbra->memory, n, sizeof *umbra->key, &umbra->key));
  return um_document_schema_walk(&um_model_scenario_schema, add_key, umbra);
}

enum um_status um_library_catalogue(struct umbra *umbra)
{
  UM_TRY(um_effects_registry_create(umbra->context, &umbra->registry));
  UM_TRY(list_effects(umbra));
  return list_keys(umbra);
}

/* The list of files grows in new memory: models borrow the one that they were built with. */
static enum um_status load_effects(struct umbra *umbra, const char *path)
{
  struct um_context *context = umbra->context;
  const char **file;
  size_t n = umbra->neffect_file;
  UM_TRY(um_core_arena_allocate(context, &umbra->memory, n + 1, sizeof *file, &file));
  for (size_t i = 0; i < n; i++) file[i] = umbra->effect_file[i];
  UM_TRY(um_effects_registry_load(context, umbra->registry, path));
  char *absolute = realpath(path, NULL);
  enum um_status status = keep_text(umbra, absolute != NULL ? absolute : path, &file[n]);
  free(absolute);
  UM_TRY(status);
  UM_TRY(list_effects(umbra));
  umbra->effect_file = file;
  umbra->neffect_file++;
  return UM_OK;
}

enum umbra_status umbra_effects_load(struct umbra *umbra, const char *path)
{
  (void)um_library_begin(umbra);
  return um_library_status(load_effects(umbra, path));
}

enum umbra_status umbra_effect_find(struct umbra *umbra, const char *name,
                                    const struct umbra_effect **out)
{
  struct um_context *context = um_library_begin(umbra);
  *out = NULL;
  for (size_t i = 0; i < umbra->neffect; i++)
    if (strcmp(umbra->effect[i].name, name) == 0) *out = &umbra->effect[i];
  if (*out != NULL) return UMBRA_OK;
  return um_library_status(um_effects_registry_refuse(context, umbra->registry, name));
}

const struct umbra_effect *umbra_effect_at(const struct umbra *umbra, size_t index)
{
  return index < umbra->neffect ? &umbra->effect[index] : NULL;
}

const struct umbra_key *umbra_key_at(const struct umbra *umbra, size_t index)
{
  return index < umbra->nkey ? &umbra->key[index] : NULL;
}

static enum um_status keep_names(struct umbra *umbra, size_t n, const char ***out)
{
  return um_core_arena_allocate(umbra->context, &umbra->memory, n, sizeof **out, out);
}

static enum um_status list_materials(struct umbra *umbra, const char ***out, size_t *count)
{
  struct um_materials_library *library;
  UM_TRY(um_environment_library_create(umbra->context, true, &library));
  *count = um_materials_library_count(library);
  enum um_status status = keep_names(umbra, *count, out);
  for (size_t i = 0; status == UM_OK && i < *count; i++)
    status = keep_text(umbra, um_materials_name(um_materials_library_at(library, i)), &(*out)[i]);
  um_materials_library_destroy(&library);
  return status;
}

static enum um_status list_sensors(struct umbra *umbra, const char ***out, size_t *count)
{
  char **names;
  UM_TRY(um_model_sensor_presets(umbra->context, &names, count));
  enum um_status status = keep_names(umbra, *count, out);
  for (size_t i = 0; status == UM_OK && i < *count; i++)
    status = keep_text(umbra, names[i], &(*out)[i]);
  um_core_listing_free(umbra->context, names, *count);
  return status;
}

static enum um_status list_data(struct umbra *umbra, enum umbra_names kind)
{
  const char **names = NULL;
  size_t count = 0;
  if (kind == UMBRA_MATERIALS)
    UM_TRY(list_materials(umbra, &names, &count));
  else if (kind == UMBRA_SENSORS)
    UM_TRY(list_sensors(umbra, &names, &count));
  else
    return um_core_fail(umbra->context, UM_ERR_INPUT,
                        "no names of kind %d come with the program; accepted: UMBRA_MATERIALS, "
                        "UMBRA_SENSORS",
                        (int)kind);
  umbra->data[kind].name = names;
  umbra->data[kind].count = count;
  return UM_OK;
}

enum umbra_status umbra_data_names(struct umbra *umbra, enum umbra_names kind,
                                   const char *const **out, size_t *count)
{
  bool known = (int)kind >= 0 && (int)kind < UM_LIBRARY_NAMES;
  (void)um_library_begin(umbra);
  *out = NULL;
  *count = 0;
  if (!known || umbra->data[kind].name == NULL) {
    enum um_status status = list_data(umbra, kind);
    if (status != UM_OK) return um_library_status(status);
  }
  *out = umbra->data[kind].name;
  *count = umbra->data[kind].count;
  return UMBRA_OK;
}
