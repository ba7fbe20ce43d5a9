/* The list of candidates: every effect, on every target that it has in this model. */
#include "evidence/sensitivity/candidates.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/suggestions.h"
#include "effects/effects.h"
#include "evidence/sensitivity/signatures_impl.h"
#include "evidence/sensitivity/stated.h"
#include "evidence/sensitivity/targets_impl.h"
#include "model/build/effect_files.h"
#include "model/build/effects.h"

/* --- which ----------------------------------------------------------------------------------- */

/* What is on by default is tried off, and said to be. */
#define OFF "=off"

/* Is "effect", "effect:target" or "effect=off" this candidate? */
static bool means(const char *text, const struct um_effect *effect, const char *target)
{
  size_t n = strlen(effect->name);
  if (strncmp(text, effect->name, n) != 0) return false;
  if (text[n] == '\0' || (effect->on_by_default && strcmp(text + n, OFF) == 0)) return true;
  return text[n] == ':' && target != NULL && strcmp(text + n + 1, target) == 0;
}

/* Of the name that "effect", "effect:target" or "effect=off" begins with. */
static size_t name_length(const char *text)
{
  size_t n = strcspn(text, ":"), m = strcspn(text, "=");
  return strcmp(text + m, OFF) == 0 ? m : n;
}

static bool listed(const char *const *text, size_t count, const struct um_effect *effect,
                   const char *target)
{
  for (size_t i = 0; i < count; i++)
    if (means(text[i], effect, target)) return true;
  return false;
}

/* Every text begins with the name of an effect. */
static enum um_status check_names(struct um_context *context, const struct um_model *model,
                                  const char *option, const char *const *text, size_t count)
{
  for (size_t i = 0; i < count; i++) {
    char name[64] = "";
    size_t n = name_length(text[i]);
    memcpy(name, text[i], n < sizeof name ? n : sizeof name - 1);
    if (n < sizeof name && um_model_effects_find(model, name) != NULL) continue;
    enum um_status status = um_effects_registry_refuse(context, model->registry, name);
    um_core_message_prefix(context, "%s %.80s", option, text[i]);
    return status;
  }
  return UM_OK;
}

static bool already(const struct um_model_addition *addition, size_t naddition,
                    const struct um_effect *effect, const char *target)
{
  for (size_t i = 0; i < naddition; i++)
    if (addition[i].effect == effect && um_core_words_same(addition[i].target, target)) return true;
  return false;
}

/* Does the scenario have a core switch off, by its effects or its environment? */
static bool is_off(const struct um_model *model, const struct um_effect *effect)
{
  for (size_t i = 0; i < model->neffect; i++)
    if (model->effect[i].effect == effect && model->effect[i].off) return true;
  return effect->is_off != NULL && effect->is_off(&model->environment);
}

bool um_sensitivity_is_on(const struct um_sensitivity_forward *forward,
                          const struct um_effect *effect)
{
  return effect->on_by_default && !is_off(forward->model, effect);
}

/* --- list ------------------------------------------------------------------------------------ */

static enum um_status add(struct um_context *context, const struct um_sensitivity_forward *forward,
                          const struct um_effect *effect, const char *target, bool off,
                          struct um_sensitivity_candidates *list)
{
  UM_TRY(um_core_reallocate(context, list->count + 1, sizeof *list->candidate, &list->candidate));
  struct um_sensitivity_candidate *c = &list->candidate[list->count++];
  *c = (struct um_sensitivity_candidate){
      .effect = effect, .is_switch = effect->on_by_default != 0, .off = off};
  UM_TRY(um_core_asprintf(context, &c->name, "%s%s%s%s", effect->name, target != NULL ? ":" : "",
                          target != NULL ? target : "", off ? OFF : ""));
  if (target != NULL) UM_TRY(um_core_strdup(context, target, &c->target));
  um_sensitivity_forward_null(forward, effect, target, c->null_value);
  for (size_t p = 0; p < effect->nparameter; p++)
    um_sensitivity_stated_range(forward, effect, target, p, c->null_value[p], &c->minimum[p],
                                &c->maximum[p]);
  const char *why = um_sensitivity_stated_refusal(forward, effect, target);
  c->insensitive = why != NULL;
  return why == NULL ? UM_OK : um_core_strdup(context, why, &c->why);
}

/* A switch that has values is also tried with the ends of their ranges: the Sun as a uniform disc.
 */
static enum um_status add_variants(struct um_context *context,
                                   const struct um_sensitivity_forward *forward,
                                   const struct um_effect *effect, const char *target,
                                   struct um_sensitivity_candidates *list)
{
  for (size_t p = 0; effect->on_by_default && p < effect->nparameter; p++) {
    const struct um_effect_parameter *of = &effect->parameters[p];
    const double end[] = {of->minimum, of->maximum};
    for (size_t i = 0; i < 2; i++) {
      if (end[i] == of->null_value) continue;
      UM_TRY(add(context, forward, effect, target, false, list));
      list->candidate[list->count - 1].null_value[p] = end[i];
    }
  }
  return UM_OK;
}

static enum um_status add_effect(struct um_context *context,
                                 const struct um_sensitivity_forward *forward,
                                 const struct um_effect *effect,
                                 const struct um_model_addition *addition, size_t naddition,
                                 const struct um_sensitivity_candidates_options *o,
                                 struct um_sensitivity_candidates *list)
{
  enum um_status status;
  struct um_sensitivity_targets targets = {0};
  bool off = um_sensitivity_is_on(forward, effect);
  if (off ? o != NULL && o->derivatives : !effect->on_by_default && effect->nparameter == 0)
    return UM_OK;
  UM_CHECK(um_sensitivity_targets_create(context, forward, effect, &targets));
  for (size_t k = 0; k < targets.count; k++) {
    const char *target = targets.name[k];
    if (already(addition, naddition, effect, target)) continue;
    if (o != NULL && o->nonly > 0 && !listed(o->only, o->nonly, effect, target)) continue;
    if (o != NULL && listed(o->exclude, o->nexclude, effect, target)) continue;
    UM_CHECK(add(context, forward, effect, target, off, list));
    if (!off) UM_CHECK(add_variants(context, forward, effect, target, list));
  }
done:
  um_sensitivity_targets_release(context, &targets);
  return status;
}

/* --- what was asked for and is no candidate --------------------------------------------------- */

static enum um_status drop(struct um_context *context, const char *name, const char *why,
                           struct um_sensitivity_candidates *list)
{
  UM_TRY(um_core_reallocate(context, list->ndropped + 1, sizeof *list->dropped, &list->dropped));
  struct um_sensitivity_dropped *dropped = &list->dropped[list->ndropped++];
  *dropped = (struct um_sensitivity_dropped){0};
  UM_TRY(um_core_strdup(context, name, &dropped->name));
  return um_core_strdup(context, why, &dropped->why);
}

/* Why an entry of `only` whose effect and target exist is no candidate. */
static const char *why_none(const struct um_effect *effect, const char *target,
                            const struct um_sensitivity_candidates_options *o)
{
  if (!effect->on_by_default && effect->nparameter == 0) return "it has nothing to fit";
  if (listed(o->exclude, o->nexclude, effect, target)) return "it is excluded";
  if (target == NULL) return "the scenario has nothing that it acts on";
  return "it is there already, or another target is the same thing";
}

static bool is_listed(const char *text, const struct um_sensitivity_candidates *list)
{
  for (size_t i = 0; i < list->count; i++)
    if (means(text, list->candidate[i].effect, list->candidate[i].target)) return true;
  return false;
}

static enum um_status look_for_dropped(struct um_context *context,
                                       const struct um_sensitivity_forward *forward,
                                       const struct um_sensitivity_candidates_options *o,
                                       struct um_sensitivity_candidates *list)
{
  for (size_t i = 0; o != NULL && i < o->nonly; i++) {
    const char *text = o->only[i], *colon = strchr(text, ':');
    char name[64] = "";
    if (is_listed(text, list)) continue;
    memcpy(name, text, name_length(text)); /* it fits: check_names found the effect */
    const struct um_effect *effect = um_model_effects_find(forward->model, name);
    const char *target = colon == NULL ? NULL : colon + 1;
    enum um_status status =
        target == NULL ? UM_OK : um_model_check_target(context, forward->model, effect, target);
    if (status == UM_ERR_INPUT) um_core_message_prefix(context, "--only %.80s", text);
    UM_TRY(status);
    UM_TRY(drop(context, text, why_none(effect, target, o), list));
  }
  return UM_OK;
}

static enum um_status make_list(struct um_context *context,
                                const struct um_sensitivity_forward *forward,
                                const struct um_model_addition *addition, size_t naddition,
                                const struct um_sensitivity_candidates_options *o,
                                struct um_sensitivity_candidates *list)
{
  for (size_t i = 0; o != NULL && i < o->nwanted; i++)
    UM_TRY(add(context, forward, o->wanted[i].effect, o->wanted[i].target, o->wanted[i].off, list));
  if (list->count > 0) return UM_OK;
  if (o != NULL) {
    UM_TRY(check_names(context, forward->model, "--only", o->only, o->nonly));
    UM_TRY(check_names(context, forward->model, "--exclude", o->exclude, o->nexclude));
  }
  for (size_t i = 0; i < um_model_effects_count(forward->model); i++)
    UM_TRY(add_effect(context, forward, um_model_effects_at(forward->model, i), addition, naddition,
                      o, list));
  return look_for_dropped(context, forward, o, list);
}

/* --- what is kept ----------------------------------------------------------------------------- */

static void release(struct um_context *context, struct um_sensitivity_candidate *c)
{
  um_core_free(context, c->name);
  um_core_free(context, c->target);
  um_core_free(context, c->signature);
  um_core_free(context, c->why);
}

/* Whether two candidates are one thing under two names: the same effect, the same steps, and
 * exactly the same change of the observations. */
static const struct um_sensitivity_candidate *repeated(const struct um_sensitivity_candidates *list,
                                                       size_t which)
{
  const struct um_sensitivity_candidate *c = &list->candidate[which];
  size_t bytes = c->ncolumn * list->nobservation * sizeof *c->signature;
  for (size_t i = 0; i < which && !c->insensitive; i++) {
    const struct um_sensitivity_candidate *before = &list->candidate[i];
    if (before->effect == c->effect && !before->insensitive && before->ncolumn == c->ncolumn &&
        memcmp(before->signature, c->signature, bytes) == 0)
      return before;
  }
  return NULL;
}

/* Keep the first of candidates that are one thing. asked: the others are recorded as dropped. */
static enum um_status keep_different(struct um_context *context, bool asked,
                                     struct um_sensitivity_candidates *list)
{
  size_t kept = 0, count = list->count;
  char why[200];
  for (size_t i = 0; i < count; i++) {
    /* compacted in one array: those before are final */
    struct um_sensitivity_candidate c = list->candidate[i];
    list->candidate[i] = (struct um_sensitivity_candidate){0};
    list->candidate[kept] = c;
    const struct um_sensitivity_candidate *same = repeated(list, kept);
    if (same == NULL) {
      kept++;
      continue;
    }
    snprintf(why, sizeof why, "does the same as %.150s", same->name);
    if (asked) UM_TRY(drop(context, c.name, why, list));
    release(context, &list->candidate[kept]);
    list->candidate[kept] = (struct um_sensitivity_candidate){0};
  }
  list->count = kept;
  return UM_OK;
}

/* Signatures by few paths between surfaces: their sampling error is a share of themselves, and a
 * hundredth of a signature takes a ten-thousandth from a score. */
static enum um_status make_signatures(struct um_context *context,
                                      struct um_sensitivity_point *point,
                                      struct um_sensitivity_candidates *list)
{
  enum um_status status;
  struct um_sensitivity_forward *f = point->forward;
  double *base = NULL;
  UM_CHECK(um_sensitivity_forward_paths(
      context, f, point->derivatives ? UM_SENSITIVITY_DERIVATIVES : UM_SENSITIVITY_SIGNATURES));
  point->base = list->base;
  if (f->cache->few != NULL && point->naddition > 0) {
    UM_CHECK(um_core_allocate(context, list->nobservation, sizeof *base, &base));
    UM_CHECK(um_sensitivity_forward_evaluate(context, f, point->addition, point->naddition, base));
    point->base = base;
  }
  UM_CHECK(um_sensitivity_forward_noise(context, f, &point->noise));
  UM_CHECK(um_sensitivity_signatures_create(context, point, list->candidate, list->count));
  UM_CHECK(um_sensitivity_forward_paths(context, f, UM_SENSITIVITY_VALUES));
done:
  um_core_free(context, base);
  return status;
}

enum um_status
um_sensitivity_candidates_create(struct um_context *context, struct um_sensitivity_forward *forward,
                                 const struct um_model_addition *addition, size_t naddition,
                                 const struct um_sensitivity_candidates_options *options,
                                 struct um_sensitivity_candidates **out)
{
  enum um_status status;
  struct um_sensitivity_candidates *list = NULL;
  struct um_sensitivity_point point = {.forward = forward,
                                       .addition = addition,
                                       .naddition = naddition,
                                       .derivatives = options != NULL && options->derivatives};
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *list, &list));
  list->nobservation = forward->observations.count;
  UM_CHECK(make_list(context, forward, addition, naddition, options, list));
  UM_CHECK(um_core_allocate(context, list->nobservation, sizeof *list->base, &list->base));
  UM_CHECK(um_sensitivity_forward_evaluate(context, forward, addition, naddition, list->base));
  UM_CHECK(make_signatures(context, &point, list));
  if (options == NULL || options->nwanted == 0)
    UM_CHECK(keep_different(context, options != NULL && options->nonly > 0, list));
  *out = list;
  list = NULL;
done:
  um_sensitivity_candidates_destroy(context, &list);
  return status;
}

void um_sensitivity_candidates_destroy(struct um_context *context,
                                       struct um_sensitivity_candidates **candidates)
{
  if (candidates == NULL || *candidates == NULL) return;
  for (size_t i = 0; i < (*candidates)->count; i++) release(context, &(*candidates)->candidate[i]);
  for (size_t i = 0; i < (*candidates)->ndropped; i++) {
    um_core_free(context, (*candidates)->dropped[i].name);
    um_core_free(context, (*candidates)->dropped[i].why);
  }
  um_core_free(context, (*candidates)->dropped);
  um_core_free(context, (*candidates)->candidate);
  um_core_free(context, (*candidates)->base);
  um_core_free(context, *candidates);
  *candidates = NULL;
}
