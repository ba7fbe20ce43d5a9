/* A scenario as it is used, for another folder.
 *
 * The text is the user's own with its comments; --set stands in it, --with, --without and
 * --effect-file become entries of `effects` and `effect_files`, names of files lead from the new
 * folder. */
#include "model/build/scenario_text.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/core/csv.h"
#include "base/core/file.h"
#include "base/core/suggestions.h"
#include "effects/effects.h"
#include "model/scenario/scenario_schema.h"

/* Texts that are overrides of a document. */
struct overrides {
  struct um_context *context;
  char **text; /* [count] */
  size_t count;
};

static enum um_status add_override(struct overrides *o, char *text)
{
  enum um_status status =
      um_core_reallocate(o->context, o->count + 1, sizeof *o->text, (void **)&o->text);
  if (status == UM_OK)
    o->text[o->count++] = text;
  else
    um_core_free(o->context, text);
  return status;
}

static void release(struct overrides *o)
{
  for (size_t i = 0; i < o->count; i++) um_core_free(o->context, o->text[i]);
  um_core_free(o->context, o->text);
}

/* A parameter as the scenario's own entry has it: the name that it is written by, and its value. */
static struct um_schema_number listed(const struct um_scenario_effect *entry,
                                      const struct um_effect *effect, size_t p)
{
  const struct um_schema_number *number = entry->parameters.items;
  const struct um_effect_parameter *of = &effect->parameters[p];
  for (size_t i = 0; i < entry->parameters.count; i++)
    if (um_effects_parameter_find(effect, number[i].name) == p) return number[i];
  return (struct um_schema_number){.name = of->name, .value = of->default_value};
}

/* Entry `position` of the list, where the use differs from it. */
static enum um_status change_entry(struct overrides *o, const struct um_scenario_effect *entry,
                                   size_t position, const struct um_model_effect *use)
{
  char *text;
  if (use->off != entry->off) {
    UM_TRY(um_core_asprintf(o->context, &text, "effects.%zu.off=%s", position,
                            use->off ? "true" : "false"));
    UM_TRY(add_override(o, text));
  }
  for (size_t p = 0; p < use->effect->nparameter; p++) {
    char number[32];
    const struct um_schema_number written = listed(entry, use->effect, p);
    if (use->value[p] == written.value) continue;
    um_core_number_text(use->value[p], number);
    UM_TRY(
        um_core_asprintf(o->context, &text, "effects.%zu.%s=%s", position, written.name, number));
    UM_TRY(add_override(o, text));
  }
  return UM_OK;
}

/* A name in double quotes of YAML, without them where it is a plain word and not YAML's null. */
static void quote(const char *name, size_t size, char *out)
{
  size_t n = 0;
  bool plain = strspn(name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.+-") ==
                   strlen(name) &&
               strchr("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_", name[0]) != NULL &&
               strcasecmp(name, "null") != 0;
  if (!plain) out[n++] = '"';
  for (; *name != '\0' && n + 4 < size; name++) {
    if (*name == '"' || *name == '\\') out[n++] = '\\';
    out[n++] = *name;
  }
  if (!plain) out[n++] = '"';
  out[n] = '\0';
}

static enum um_status new_entry(struct overrides *o, const struct um_model_effect *use)
{
  char text[2048], target[1024], number[32];
  size_t n = (size_t)snprintf(text, sizeof text, "effects.+={effect: %s", use->effect->name);
  if (use->target != NULL) {
    quote(use->target, sizeof target, target);
    n += (size_t)snprintf(text + n, sizeof text - n, ", target: %s", target);
  }
  if (use->off) n += (size_t)snprintf(text + n, sizeof text - n, ", off: true");
  for (size_t p = 0; p < use->effect->nparameter && !use->off; p++) {
    um_core_number_text(use->value[p], number);
    n += (size_t)snprintf(text + n, sizeof text - n, ", %s: %s", use->effect->parameters[p].name,
                          number);
  }
  char *copy;
  UM_TRY(um_core_asprintf(o->context, &copy, "%s}", text));
  return add_override(o, copy);
}

/* Does an entry have to say this? Not that a switch is off which keys of `environment` hold off
 * already, nor that one is on by default. One that was asked for may be held off by another key. */
static bool is_needed(const struct um_model_effect *use)
{
  if (use->off) return use->effect->on_by_default != 0 && !use->off_by_keys;
  bool changed = !use->effect->on_by_default || use->option != NULL;
  for (size_t p = 0; p < use->effect->nparameter; p++)
    changed = changed || use->value[p] != use->effect->parameters[p].default_value;
  return changed;
}

static enum um_status list_effects(struct overrides *o, const struct um_scenario *scenario,
                                   const struct um_model_effect *use, size_t count)
{
  const struct um_scenario_effect *entry = scenario->effects.items;
  enum um_status status = UM_OK;
  for (size_t i = 0; status == UM_OK && i < count; i++) {
    size_t k = 0;
    while (k < scenario->effects.count && !(strcmp(entry[k].effect, use[i].effect->name) == 0 &&
                                            um_core_words_same(entry[k].target, use[i].target)))
      k++;
    if (k < scenario->effects.count)
      status = change_entry(o, &entry[k], k, &use[i]);
    else if (is_needed(&use[i]))
      status = new_entry(o, &use[i]);
  }
  return status;
}

/* Does the scenario list the file already? */
static enum um_status is_listed(struct um_context *context, const struct um_scenario *scenario,
                                const char *absolute, bool *listed)
{
  const char *const *file = scenario->effect_files.items;
  *listed = false;
  for (size_t i = 0; i < scenario->effect_files.count && !*listed; i++) {
    char *path;
    UM_TRY(um_core_path_resolve(context, scenario->at.file, file[i], &path));
    char *real = realpath(path, NULL);
    *listed = real != NULL && strcmp(real, absolute) == 0;
    free(real);
    um_core_free(context, path);
  }
  return UM_OK;
}

static enum um_status list_effect_file(struct overrides *o, const struct um_scenario *scenario,
                                       const char *absolute)
{
  bool listed;
  char *quoted = NULL, *text = NULL;
  size_t size = 2 * strlen(absolute) + 8;
  UM_TRY(is_listed(o->context, scenario, absolute, &listed));
  if (listed) return UM_OK;
  UM_TRY(um_core_allocate(o->context, size, 1, &quoted));
  quote(absolute, size, quoted);
  enum um_status status = um_core_asprintf(o->context, &text, "effect_files.+=%s", quoted);
  um_core_free(o->context, quoted);
  return status == UM_OK ? add_override(o, text) : status;
}

/* Shared objects of the command line, which the effects may come from. */
static enum um_status list_effect_files(struct overrides *o, const struct um_scenario *scenario,
                                        const struct um_model_options *options)
{
  for (size_t i = 0; i < options->neffect_file; i++) {
    char *absolute = realpath(options->effect_files[i], NULL);
    if (absolute == NULL)
      return um_core_fail(o->context, UM_ERR_IO, "%s: %s", options->effect_files[i],
                          strerror(errno));
    enum um_status status = list_effect_file(o, scenario, absolute);
    free(absolute);
    UM_TRY(status);
  }
  return UM_OK;
}

enum um_status um_model_scenario_text(struct um_context *context, const struct um_model *model,
                                      const struct um_model_effect *use, size_t nuse,
                                      const struct um_model_options *options, const char *folder,
                                      char **out)
{
  struct overrides o = {.context = context};
  struct um_document *document = NULL;
  char *text = NULL;
  void *root;
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_document_text(context, model->document, &text)); /* --set stands in it */
  if (options != NULL) UM_CHECK(list_effect_files(&o, model->scenario, options));
  UM_CHECK(list_effects(&o, model->scenario, use, nuse));
  UM_CHECK(um_document_parse(context, model->scenario->at.file, text, &um_model_scenario_schema,
                             (const char *const *)o.text, o.count, &document, &root));
  UM_CHECK(um_document_move(context, document, &um_model_scenario_schema, folder));
  UM_CHECK(um_document_text(context, document, out));
done:
  um_document_destroy(&document);
  release(&o);
  um_core_free(context, text);
  return status;
}
