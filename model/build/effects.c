/* The effects of a scenario: its own list, then --with and --without, checked against the registry.
 */
#include "model/build/effects.h"
#include "model/build/effects_group.h"
#include "model/build/steps_impl.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/core/suggestions.h"
#include "effects/effects.h"
#include "model/build/bands.h"
#include "model/build/effect_files.h"
#include "model/scenario/fail_group.h"

/* Where a use was written; NULL mark for the command line. */
struct origin {
  const struct um_mark *at;
  const char *option, *text; /* "--with", as typed */
};

static enum um_status blame(struct um_context *context, const struct origin *from, const char *key,
                            enum um_status status)
{
  if (from->at != NULL) return um_model_blame(context, from->at, key, status);
  um_core_message_prefix(context, "%s %s", from->option, from->text);
  return status;
}

static enum um_status find(struct um_context *context, const struct um_model *model,
                           const struct origin *from, const char *name,
                           const struct um_effect **out)
{
  *out = um_model_effects_find(model, name);
  if (*out != NULL) return UM_OK;
  return blame(context, from, "effect", um_effects_registry_refuse(context, model->registry, name));
}

/* Part the target of a use: on what it acts, and in which set of measurements. */
static enum um_status part_target(struct um_context *context, struct um_model *model,
                                  struct um_model_effect *use)
{
  char *place = NULL;
  use->place = use->target;
  use->set = um_effects_set_of(use->effect, use->target);
  if (use->set == NULL) return UM_OK;
  size_t n = um_effects_place_of(use->effect, use->target);
  UM_TRY(um_core_arena_allocate(context, &model->memory, n + 1, 1, &place));
  memcpy(place, use->target, n);
  use->place = n > 0 ? place : NULL;
  return UM_OK;
}

/* The use of an effect on a target, made with its default values when there is none. */
static enum um_status use_of(struct um_context *context, struct um_model *model,
                             const struct um_effect *effect, const char *target,
                             struct um_model_effect **out)
{
  for (size_t i = 0; i < model->neffect; i++)
    if (model->effect[i].effect == effect && um_core_words_same(model->effect[i].target, target)) {
      *out = &model->effect[i];
      return UM_OK;
    }
  UM_TRY(um_core_reallocate(context, model->neffect + 1, sizeof *model->effect, &model->effect));
  *out = &model->effect[model->neffect++];
  **out = (struct um_model_effect){.effect = effect, .target = target};
  for (size_t p = 0; p < effect->nparameter; p++)
    (*out)->value[p] = effect->parameters[p].default_value;
  return part_target(context, model, *out);
}

static enum um_status set_value(struct um_context *context, const struct origin *from,
                                struct um_model_effect *use, size_t p, const char *name,
                                double value)
{
  const struct um_effect_parameter *parameter = &use->effect->parameters[p];
  if (!(value >= parameter->minimum && value <= parameter->maximum))
    return blame(context, from, name,
                 um_core_fail(context, UM_ERR_INPUT, "%g is out of range; accepted: %g to %g %s",
                              value, parameter->minimum, parameter->maximum, parameter->unit));
  use->value[p] = value;
  return UM_OK;
}

/* By a name as it was written. */
static enum um_status set_parameter(struct um_context *context, const struct origin *from,
                                    struct um_model_effect *use, struct um_effects_said *said,
                                    const char *name, double value)
{
  size_t p;
  enum um_status status = um_effects_parameter_read(context, use->effect, name, said, &p);
  if (status != UM_OK) return blame(context, from, name, status);
  return set_value(context, from, use, p, name, value);
}

/* With or without a target, as the effect has it. */
static enum um_status check_kind(struct um_context *context, const struct um_effect *effect,
                                 const char *target)
{
  const char *set = um_effects_set_of(effect, target);
  if (set != NULL && set[0] == '\0')
    return um_core_fail(context, UM_ERR_INPUT,
                        "no set is named behind '@'; accepted: the name of a set of measurements");
  if (set != NULL && um_effects_place_of(effect, target) == 0) target = NULL;
  if (set != NULL && target != NULL && effect->targets == UM_TARGET_GLOBAL)
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect '%s' acts on everything; accepted: no target, or '" UM_EFFECTS_ALL
                        "@%s'",
                        effect->name, set);
  if (target == NULL && (effect->targets & UM_TARGET_GLOBAL) == 0)
    return um_core_fail(context, UM_ERR_INPUT, "effect '%s' needs a target", effect->name);
  if (target != NULL && effect->targets == UM_TARGET_GLOBAL)
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect '%s' acts on everything; accepted: no target", effect->name);
  return UM_OK;
}

/* The same for a use; that its target exists is checked when that is built. */
static enum um_status check_target(struct um_context *context, const struct origin *from,
                                   const struct um_effect *effect, const char *target)
{
  enum um_status status = check_kind(context, effect, target);
  return status == UM_OK ? status : blame(context, from, "target", status);
}

static enum um_status take_scenario(struct um_context *context, struct um_model *model,
                                    const struct um_scenario_effect *from)
{
  const struct um_effect *effect = NULL;
  struct um_model_effect *use = NULL;
  struct origin origin = {.at = &from->at, .option = "effects", .text = from->effect};
  UM_TRY(find(context, model, &origin, from->effect, &effect));
  UM_TRY(check_target(context, &origin, effect, from->target));
  UM_TRY(use_of(context, model, effect, from->target, &use));
  use->off = from->off;
  use->at = &from->at;
  struct um_effects_said said = {{NULL}};
  const struct um_schema_number *parameter = from->parameters.items;
  for (size_t p = 0; p < from->parameters.count; p++)
    UM_TRY(set_parameter(context, &origin, use, &said, parameter[p].name, parameter[p].value));
  return UM_OK;
}

/* The use that an option or a change is about, on or off; NULL: all uses of an effect were turned
 * off. */
static enum um_status take_use(struct um_context *context, struct um_model *model,
                               const struct origin *origin, const char *name, const char *target,
                               bool off, struct um_model_effect **out)
{
  const struct um_effect *effect = NULL;
  *out = NULL;
  UM_TRY(find(context, model, origin, name, &effect));
  if (!off || target != NULL) UM_TRY(check_target(context, origin, effect, target));
  if (off && target == NULL) { /* all of its uses */
    bool any = false;
    for (size_t i = 0; i < model->neffect; i++)
      if (model->effect[i].effect == effect) any = model->effect[i].off = true;
    if (any || !effect->on_by_default) return UM_OK;
  }
  UM_TRY(use_of(context, model, effect, target, out));
  (*out)->off = off;
  (*out)->at = NULL;
  (*out)->option = origin->option;
  (*out)->text = origin->text;
  return UM_OK;
}

static enum um_status take_change(struct um_context *context, struct um_model *model,
                                  const struct um_model_change *change)
{
  struct um_model_effect *use = NULL;
  struct um_effects_said said = {{NULL}};
  const struct origin origin = {.option = "effect", .text = change->effect};
  UM_TRY(take_use(context, model, &origin, change->effect, change->target, change->off, &use));
  for (size_t p = 0; use != NULL && p < change->nparameter; p++)
    UM_TRY(set_parameter(context, &origin, use, &said, change->parameter[p], change->value[p]));
  return UM_OK;
}

/* "effect[:target][,name=value]...", cut in place. */
static enum um_status take_text(struct um_context *context, struct um_model *model, char *text,
                                const struct origin *origin, bool off)
{
  struct um_model_effect *use = NULL;
  struct um_effects_said said = {{NULL}};
  char *rest = text + strcspn(text, ",");
  if (*rest != '\0') *rest++ = '\0';
  char *target = strchr(text, ':');
  if (target != NULL) *target++ = '\0';
  UM_TRY(take_use(context, model, origin, text, target, off, &use));
  if (use == NULL) return UM_OK;
  while (*rest != '\0') {
    char *next = rest + strcspn(rest, ",");
    if (*next != '\0') *next++ = '\0';
    char *equals = strchr(rest, '=');
    double value;
    if (equals == NULL || !um_core_number_parse(equals + 1, &value))
      return blame(context, origin, rest,
                   um_core_fail(context, UM_ERR_INPUT,
                                "'%.60s' is not understood; accepted: NAME=NUMBER", rest));
    *equals = '\0';
    UM_TRY(set_parameter(context, origin, use, &said, rest, value));
    rest = next;
  }
  return UM_OK;
}

static enum um_status take_option(struct um_context *context, struct um_model *model,
                                  const char *option, const char *typed, bool off)
{
  size_t n = strlen(typed) + 1;
  char *text = NULL;
  struct origin origin = {.option = option, .text = typed};
  UM_TRY(um_core_arena_allocate(context, &model->memory, n, 1, &text));
  memcpy(text, typed, n);
  return take_text(context, model, text, &origin, off);
}

enum um_status um_model_check_with(struct um_context *context, const struct um_model *model,
                                   const char *typed)
{
  struct um_model scratch = *model;
  scratch.memory = (struct um_core_arena){NULL};
  const struct origin origin = {.option = "--with", .text = typed};
  char *text;
  scratch.effect = NULL;
  scratch.neffect = 0;
  UM_TRY(um_core_strdup(context, typed, &text));
  enum um_status status = take_text(context, &scratch, text, &origin, false);
  um_core_arena_release(context, &scratch.memory);
  UM_FREE(context, scratch.effect, text);
  return status;
}

/* Two entries of one effect on one target would leave it to their order which one counts. */
static enum um_status check_listed_once(struct um_context *context,
                                        const struct um_scenario_effect *uses, size_t k)
{
  for (size_t i = 0; i < k; i++)
    if (strcmp(uses[i].effect, uses[k].effect) == 0 &&
        um_core_words_same(uses[i].target, uses[k].target))
      return um_model_fail(context, &uses[k].at, "effect",
                           "'%s' is already listed on line %d; accepted: once", uses[k].effect,
                           uses[i].at.line);
  return UM_OK;
}

/* Core switches: on, but where keys of `environment` hold them off. */
static enum um_status take_defaults(struct um_context *context, struct um_model *model)
{
  struct um_environment environment;
  um_model_scenario_environment(model->scenario, &environment);
  for (size_t i = 0; i < um_model_effects_count(model); i++) {
    const struct um_effect *effect = um_model_effects_at(model, i);
    struct um_model_effect *use = NULL;
    if (!effect->on_by_default) continue;
    UM_TRY(use_of(context, model, effect, NULL, &use));
    use->off_by_keys = effect->is_off != NULL && effect->is_off(&environment);
    use->off = use->off_by_keys;
  }
  return UM_OK;
}

/* Those of the scenario, then those of the options. */
static enum um_status take_all(struct um_context *context, struct um_model *model,
                               const struct um_model_options *options)
{
  const struct um_scenario_effect *uses = model->scenario->effects.items;
  UM_TRY(take_defaults(context, model));
  for (size_t k = 0; k < model->scenario->effects.count; k++) {
    UM_TRY(check_listed_once(context, uses, k));
    UM_TRY(take_scenario(context, model, &uses[k]));
  }
  for (size_t k = 0; k < options->nwith; k++)
    UM_TRY(take_option(context, model, "--with", options->with[k], false));
  for (size_t k = 0; k < options->nwithout; k++)
    UM_TRY(take_option(context, model, "--without", options->without[k], true));
  for (size_t k = 0; k < options->nchange; k++)
    UM_TRY(take_change(context, model, &options->change[k]));
  return UM_OK;
}

static enum um_status keep_text(struct um_context *context, struct um_model *model,
                                const char *from, const char **out)
{
  char *copy;
  UM_TRY(um_core_arena_allocate(context, &model->memory, strlen(from) + 1, 1, &copy));
  strcpy(copy, from);
  *out = copy;
  return UM_OK;
}

static enum um_status keep_texts(struct um_context *context, struct um_model *model,
                                 const char *const *from, size_t n, const char *const **out)
{
  const char **texts = NULL;
  UM_TRY(um_core_arena_allocate(context, &model->memory, n, sizeof *texts, &texts));
  for (size_t i = 0; i < n; i++) UM_TRY(keep_text(context, model, from[i], &texts[i]));
  *out = texts;
  return UM_OK;
}

enum um_status um_model_build_effects(struct um_context *context, struct um_model *model,
                                      const struct um_model_options *options)
{
  struct um_model_options *kept = &model->options;
  UM_TRY(um_model_build_effect_files(context, model, options));
  if (options != NULL) {
    kept->nwith = options->nwith;
    kept->nwithout = options->nwithout;
    kept->change = options->change;
    kept->nchange = options->nchange;
    UM_TRY(keep_texts(context, model, options->with, kept->nwith, &kept->with));
    UM_TRY(keep_texts(context, model, options->without, kept->nwithout, &kept->without));
  }
  UM_TRY(take_all(context, model, kept));
  for (size_t i = 0; i < model->neffect; i++) {
    const struct um_model_effect *e = &model->effect[i];
    if (e->effect->on_by_default ? !e->off : e->off) continue;
    um_core_log(context, UM_LOG_INFO, "effect %s%s%s is %s", e->effect->name,
                e->target != NULL ? ":" : "", e->target != NULL ? e->target : "",
                e->off ? "off" : "on");
  }
  return UM_OK;
}

static enum um_status add_effects(struct um_context *context, struct um_model *model,
                                  const struct um_model_addition *addition, size_t naddition)
{
  size_t listed = model->neffect;
  for (size_t i = 0; i < naddition; i++) {
    const struct um_effect *effect = addition[i].effect;
    struct um_model_effect *use = NULL;
    struct origin origin = {.option = "addition", .text = effect->name};
    const char *target = NULL;
    if (addition[i].target != NULL) UM_TRY(keep_text(context, model, addition[i].target, &target));
    UM_TRY(check_target(context, &origin, effect, target));
    UM_TRY(use_of(context, model, effect, target, &use));
    use->off = addition[i].off;
    use->at = NULL;
    use->option = origin.option;
    use->text = origin.text;
    for (size_t p = 0; p < effect->nparameter && !use->off; p++)
      UM_TRY(set_value(context, &origin, use, p, effect->parameters[p].name, addition[i].value[p]));
  }
  um_model_effects_sort(model, model->effect + listed, model->neffect - listed);
  return UM_OK;
}

enum um_status um_model_vary_effects(struct um_context *context, struct um_model *model,
                                     const struct um_model_changes *changes)
{
  static const char *const listed[] = {"effects", "environment", NULL};
  const struct um_model *origin = model->origin;
  if (um_model_origin_says(model, listed)) {
    UM_TRY(um_core_allocate(context, origin->neffect, sizeof *model->effect, &model->effect));
    memcpy(model->effect, origin->effect, origin->neffect * sizeof *model->effect);
    model->neffect = origin->neffect;
  } else if (origin->origin != NULL) { /* whose additions would be lost */
    return um_core_fail(context, UM_ERR_INPUT,
                        "effects and environment of a variant; accepted: changes of the scenario "
                        "that it was made from");
  } else {
    UM_TRY(take_all(context, model, &model->options));
  }
  for (size_t k = 0; k < changes->nwith; k++)
    UM_TRY(take_option(context, model, "--with", changes->with[k], false));
  for (size_t k = 0; k < changes->nwithout; k++)
    UM_TRY(take_option(context, model, "--without", changes->without[k], true));
  return add_effects(context, model, changes->addition, changes->naddition);
}

/* The names that an effect can act on, in words and beside what was typed. Parts, materials and
 * bands outlive the guess; a side does not: `side` keeps the nearest one. */
struct target_names {
  char accepted[700], side[256];
  struct um_core_words_guess guess;
};

static void add_target(struct target_names *names, const char *name)
{
  um_core_words_append(names->accepted, sizeof names->accepted, name);
  um_core_words_consider(&names->guess, name);
}

/* A name that does not outlive the guess. */
static void add_place(struct target_names *names, const char *part, const char *of)
{
  char name[256];
  snprintf(name, sizeof name, "%s.%s", part, of);
  add_target(names, name);
  if (names->guess.nearest != name) return;
  snprintf(names->side, sizeof names->side, "%s", name);
  names->guess.nearest = names->side;
}

/* `interior` goes by the name of its part, where that is not the name of the walls. */
static void list_interiors(const struct um_model *model, bool walls, struct target_names *names)
{
  const struct um_scenario_part *part = model->scenario->parts.items;
  for (size_t p = 0; p < model->scenario->parts.count; p++)
    for (size_t i = 0; i < um_model_interior_count(&part[p]); i++) {
      const struct um_scenario_interior *interior = um_model_interior_at(&part[p], i);
      if (interior->name != NULL || walls)
        add_place(names, part[p].name, um_model_interior_name(interior));
    }
}

static void list_targets(const struct um_model *model, uint32_t targets, struct target_names *names)
{
  const struct um_geometry *g = model->geometry;
  for (size_t i = 0; (targets & UM_TARGET_PART) != 0 && i < um_geometry_part_count(g); i++)
    add_target(names, um_geometry_part_name(g, i));
  for (size_t i = 0; (targets & UM_TARGET_PART_SIDE) != 0 && i < um_geometry_group_count(g); i++) {
    const struct um_geometry_group *group = um_geometry_group(g, i);
    add_place(names, um_geometry_part_name(g, group->part), group->name);
  }
  if ((targets & UM_TARGET_INTERIOR) != 0)
    list_interiors(model, (targets & UM_TARGET_PART_SIDE) != 0, names);
  for (size_t i = 0; (targets & UM_TARGET_MATERIAL) != 0 && i < um_geometry_material_count(g); i++)
    add_target(names, um_geometry_material_name(g, i));
  for (size_t b = 0; (targets & UM_TARGET_BAND) != 0 && b < model->nband; b++)
    add_target(names, model->band[b].name);
}

/* Is there a side, group or interior of that name, "part.name"? */
static bool side_exists(const struct um_model *model, const char *target)
{
  const struct um_geometry *g = model->geometry;
  const char *dot = strchr(target, '.');
  if (dot == NULL) return false;
  for (size_t i = 0; i < um_geometry_group_count(g); i++) {
    const struct um_geometry_group *group = um_geometry_group(g, i);
    const char *part = um_geometry_part_name(g, group->part);
    if (strlen(part) != (size_t)(dot - target) || strncmp(part, target, strlen(part)) != 0)
      continue;
    if (strcmp(group->name, dot + 1) == 0 || strcmp(dot, ".interior") == 0) return true;
    if (group->back_material != UM_GEOMETRY_NONE &&
        (strcmp(dot, ".front") == 0 || strcmp(dot, ".back") == 0))
      return true;
  }
  return false;
}

/* Is there one under `interiors` of that name, "part.name"? */
static bool interior_exists(const struct um_model *model, const char *target)
{
  const struct um_scenario_part *part = model->scenario->parts.items;
  for (size_t p = 0; p < model->scenario->parts.count; p++) {
    size_t n = strlen(part[p].name);
    if (strncmp(part[p].name, target, n) != 0 || target[n] != '.') continue;
    size_t i = um_model_interior_find(&part[p], target + n + 1);
    if (i != UM_MODEL_NO_INTERIOR && um_model_interior_at(&part[p], i)->name != NULL) return true;
  }
  return false;
}

static bool built_target_exists(const struct um_model *model, uint32_t targets, const char *target)
{
  const struct um_geometry *g = model->geometry;
  if ((targets & UM_TARGET_PART) != 0 && um_geometry_part_find(g, target) != (size_t)-1)
    return true;
  if ((targets & UM_TARGET_PART_SIDE) != 0 && side_exists(model, target)) return true;
  if ((targets & (UM_TARGET_PART_SIDE | UM_TARGET_INTERIOR)) != 0 && interior_exists(model, target))
    return true;
  for (size_t m = 0; (targets & UM_TARGET_MATERIAL) != 0 && m < um_geometry_material_count(g); m++)
    if (strcmp(um_geometry_material_name(g, m), target) == 0) return true;
  return (targets & UM_TARGET_BAND) != 0 && um_model_band_find(model, target) != (size_t)-1;
}

enum um_status um_model_check_target(struct um_context *context, const struct um_model *model,
                                     const struct um_effect *effect, const char *target)
{
  struct target_names names = {.guess = {.written = target}};
  char hint[UM_CORE_WORDS_HINT];
  const char *set = um_effects_set_of(effect, target);
  char place[256];
  UM_TRY(check_kind(context, effect, target));
  if (set != NULL) { /* whether there is such a set, measurements say */
    snprintf(place, sizeof place, "%.*s", (int)um_effects_place_of(effect, target), target);
    target = place[0] != '\0' ? place : NULL;
    names.guess.written = target;
  }
  if (target == NULL || built_target_exists(model, effect->targets, target)) return UM_OK;
  list_targets(model, effect->targets, &names);
  return um_core_fail(context, UM_ERR_INPUT,
                      "nothing that '%s' acts on is called '%.60s'%s; accepted: %s", effect->name,
                      target, um_core_words_hint(&names.guess, hint), names.accepted);
}

enum um_status um_model_check_effects(struct um_context *context, const struct um_model *model)
{
  for (size_t i = 0; i < model->neffect; i++) {
    const struct um_model_effect *e = &model->effect[i];
    if (e->off) continue;
    enum um_status status = um_model_check_target(context, model, e->effect, e->target);
    const struct origin from = {.at = e->at, .option = e->option, .text = e->text};
    if (status != UM_OK) return blame(context, &from, "target", status);
  }
  return UM_OK;
}

bool um_model_effect_next(const struct um_model *model, size_t *index, struct um_effect_use *use)
{
  while (*index < model->neffect) {
    const struct um_model_effect *e = &model->effect[(*index)++];
    if (e->off) continue;
    *use = (struct um_effect_use){e->effect, e->place, e->value, model->scenario->time->start};
    return true;
  }
  return false;
}

bool um_model_effect_next_in(const struct um_model *model, const char *set, size_t *index,
                             struct um_effect_use *use)
{
  while (um_model_effect_next(model, index, use)) {
    const char *of = model->effect[*index - 1].set;
    if (of == NULL || (set != NULL && strcmp(of, set) == 0)) return true;
  }
  return false;
}
