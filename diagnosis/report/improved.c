/* improved/scenario.yaml: the user's scenario as it was run, with what was found.
 *
 * The text is the user's own with its comments; --set, --with and --without stand in it, names of
 * files lead from the new folder, fitted nuisances and effects are entries of `effects`. */
#include "diagnosis/report/improved_impl.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "core/csv.h"
#include "core/file.h"
#include "core/words.h"
#include "model/scenario_schema.h"

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

/* ---- the effects as they are at the end ---- */

/* The same effect on the same target is replaced. */
static void take(struct um_model_effect *use, size_t *count,
                 const struct um_model_addition *addition)
{
  size_t i = 0;
  while (i < *count && !(use[i].effect == addition->effect &&
                         um_core_words_same(use[i].target, addition->target)))
    i++;
  if (i == *count)
    use[(*count)++] =
        (struct um_model_effect){.effect = addition->effect, .target = addition->target};
  use[i].off = false;
  use[i].option = "found";
  memcpy(use[i].value, addition->value, sizeof use[i].value);
}

/* Uses of the model, then nuisances, then what was added; the caller frees. */
static enum um_status collect(struct um_context *context, const struct um_diagnosis *d,
                              struct um_model_effect **out, size_t *count)
{
  const struct um_model *model = d->forward->model;
  *count = model->neffect;
  UM_TRY(um_core_allocate(context, *count + d->nnuisance + d->naddition, sizeof **out, out));
  if (*count > 0) memcpy(*out, model->effect, *count * sizeof **out);
  for (size_t i = 0; i < d->nnuisance; i++) take(*out, count, &d->nuisance[i]);
  for (size_t i = 0; i < d->naddition; i++) take(*out, count, &d->addition[i]);
  return UM_OK;
}

/* ---- as overrides ---- */

/* What the scenario's own entry says of a parameter. */
static double listed_value(const struct um_scenario_effect *entry, const struct um_effect *effect,
                           size_t p)
{
  const struct um_schema_number *number = entry->parameters.items;
  for (size_t i = 0; i < entry->parameters.count; i++)
    if (strcmp(number[i].name, effect->parameters[p].name) == 0) return number[i].value;
  return effect->parameters[p].default_value;
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
    if (use->value[p] == listed_value(entry, use->effect, p)) continue;
    um_core_number_text(use->value[p], number);
    UM_TRY(um_core_asprintf(o->context, &text, "effects.%zu.%s=%s", position,
                            use->effect->parameters[p].name, number));
    UM_TRY(add_override(o, text));
  }
  return UM_OK;
}

/* A name in double quotes of YAML, without them where it is a plain word. */
static void quote(const char *name, size_t size, char *out)
{
  size_t n = 0;
  bool plain = strspn(name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.+-") ==
                   strlen(name) &&
               strchr("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_", name[0]) != NULL;
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

/* Does an entry have to say this? Not that an effect is off, which keys of `environment` say of a
 * switch already, nor that a switch is on by default;
 * one that was asked for may be held off by another key of the scenario. */
static bool is_needed(const struct um_model_effect *use)
{
  if (use->off) return use->effect->on_by_default != 0 && !use->off_by_keys;
  bool changed = !use->effect->on_by_default || use->option != NULL;
  for (size_t p = 0; p < use->effect->nparameter; p++)
    changed = changed || use->value[p] != use->effect->parameters[p].default_value;
  return changed;
}

static enum um_status list_effects(struct overrides *o, const struct um_diagnosis *d)
{
  const struct um_scenario *scenario = d->forward->model->scenario;
  const struct um_scenario_effect *entry = scenario->effects.items;
  struct um_model_effect *use = NULL;
  size_t count;
  UM_TRY(collect(o->context, d, &use, &count));
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
  um_core_free(o->context, use);
  return status;
}

/* Shared objects of the command line, which the effects may come from; the same name twice is one.
 */
static enum um_status list_effect_files(struct overrides *o, const struct um_model_options *options)
{
  for (size_t i = 0; i < options->neffect_file; i++) {
    char *absolute = realpath(options->effect_files[i], NULL), *text = NULL;
    if (absolute == NULL)
      return um_core_fail(o->context, UM_ERR_IO, "%s: %s", options->effect_files[i],
                          strerror(errno));
    size_t size = 2 * strlen(absolute) + 8;
    char *quoted = NULL;
    enum um_status status = um_core_allocate(o->context, size, 1, &quoted);
    if (status == UM_OK) {
      quote(absolute, size, quoted);
      status = um_core_asprintf(o->context, &text, "effect_files.+=%s", quoted);
    }
    um_core_free(o->context, quoted);
    free(absolute);
    UM_TRY(status);
    UM_TRY(add_override(o, text));
  }
  return UM_OK;
}

/* Shared objects of --effect-file, by absolute names. */
static enum um_status list_files(struct overrides *o, const struct um_model_options *options)
{
  for (size_t i = 0; i < options->neffect_file; i++) {
    char quoted[2048], *text, *real = realpath(options->effect_files[i], NULL);
    if (real == NULL)
      return um_core_fail(o->context, UM_ERR_IO, "%s: %s", options->effect_files[i],
                          strerror(errno));
    quote(real, sizeof quoted, quoted);
    free(real);
    UM_TRY(um_core_asprintf(o->context, &text, "effect_files.+=%s", quoted));
    UM_TRY(add_override(o, text));
  }
  return UM_OK;
}

/* ---- the text ---- */

/* The scenario's text with all changes; the caller frees. */
static enum um_status make_text(struct um_context *context, const struct um_diagnosis *d,
                                const char *folder, char **out)
{
  const struct um_model *model = d->forward->model;
  struct overrides o = {.context = context};
  struct um_document *document = NULL;
  char *text = NULL;
  void *root;
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_document_text(context, model->document, &text)); /* --set stands in it */
  UM_CHECK(list_files(&o, &d->forward->options));
  UM_CHECK(list_effects(&o, d));
  UM_CHECK(list_effect_files(&o, &d->forward->options));
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

/* Text of a comment: one line. */
static void put_line(FILE *file, const char *text)
{
  for (; *text != '\0'; text++) fputc((unsigned char)*text < 0x20 ? ' ' : *text, file);
  fputc('\n', file);
}

static void put_head(FILE *file, const struct um_diagnosis *d, const char *command,
                     const char *version)
{
  fprintf(file, "# Written by umbra %s: ", version);
  put_line(file, command);
  fprintf(file, "# Verdict: %s. ", um_diagnosis_verdict_name(d->verdict));
  put_line(file, d->sentence != NULL ? d->sentence : "");
  fprintf(file, "# Reduced chi-square %.4g before, %.4g after.\n", d->chi2_reduced,
          d->chi2_reduced_after);
}

enum um_status um_diagnosis_report_improved_write(struct um_context *context,
                                                  const struct um_diagnosis *diagnosis,
                                                  const char *command, const char *version,
                                                  const char *path)
{
  char *folder = NULL, *name = NULL, *text = NULL;
  enum um_status status;
  UM_CHECK(um_core_asprintf(context, &folder, "%s/improved", path));
  UM_CHECK(um_core_asprintf(context, &name, "%s/scenario.yaml", folder));
  if (mkdir(folder, 0777) != 0)
    UM_CHECK(um_core_fail(context, UM_ERR_IO, "%s: %s", folder, strerror(errno)));
  UM_CHECK(make_text(context, diagnosis, folder, &text));
  FILE *file = fopen(name, "wb");
  if (file == NULL)
    UM_CHECK(um_core_fail(context, UM_ERR_IO, "%s: cannot be written: %s", name, strerror(errno)));
  put_head(file, diagnosis, command, version);
  fputs(text, file);
  status = um_core_file_close(context, "improved/scenario.yaml", &file);
done:
  um_core_free(context, folder);
  um_core_free(context, name);
  um_core_free(context, text);
  return status;
}
