/* What a person asks a diagnosis for: texts checked against the registry and the model. */
#include "evidence/diagnosis/request.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/core/suggestions.h"
#include "effects/effects.h"
#include "evidence/diagnosis/steps_impl.h"
#include "evidence/sensitivity/targets.h"
#include "model/build/effect_files.h"
#include "model/build/effects.h"

/* Of whom. */
struct asked {
  const struct um_model *model;
  const struct um_compare_measurements *measurements;
};

static enum um_status find_effect(struct um_context *context, const struct um_model *model,
                                  const char *name, const struct um_effect **out)
{
  *out = um_model_effects_find(model, name);
  return *out != NULL ? UM_OK : um_effects_registry_refuse(context, model->registry, name);
}

/* Width of the prior of an effect whose parameters all have the same. */
static enum um_status own_sigma(struct um_context *context, const struct um_effect *effect,
                                double *out)
{
  if (effect->nparameter == 0 || effect->on_by_default)
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect '%s' has no parameters to be uncertain of; accepted: an effect "
                        "with parameters",
                        effect->name);
  *out = effect->parameters[0].prior_sigma;
  for (size_t p = 1; p < um_effect_fitted(effect); p++)
    if (effect->parameters[p].prior_sigma != *out)
      return um_core_fail(context, UM_ERR_INPUT,
                          "the parameters of '%s' have priors of different widths; accepted: "
                          "sigma=S for all of them",
                          effect->name);
  return UM_OK;
}

/* A later nuisance of the same effect and target takes the place of an earlier one. */
static enum um_status put_nuisance(struct um_context *context, struct um_diagnosis_request *r,
                                   const struct um_diagnosis_nuisance_effect *nuisance)
{
  size_t i = 0;
  while (i < r->nnuisance && !(r->nuisance[i].effect == nuisance->effect &&
                               um_core_words_same(r->nuisance[i].target, nuisance->target)))
    i++;
  if (i == r->nnuisance) {
    UM_TRY(um_core_reallocate(context, i + 1, sizeof *r->nuisance, (void **)&r->nuisance));
    r->nnuisance++;
  }
  r->nuisance[i] = *nuisance;
  return UM_OK;
}

/* Copy a text; the request owns the copy. */
static enum um_status keep(struct um_context *context, struct um_diagnosis_request *r,
                           const char *text, char **out)
{
  UM_TRY(um_core_reallocate(context, r->ntext + 1, sizeof *r->text, (void **)&r->text));
  UM_TRY(um_core_strdup(context, text, out));
  r->text[r->ntext++] = *out;
  return UM_OK;
}

/* The same nuisance in each set, a value of its own: "vis@night1", "vis@night2". */
static enum um_status put_in_sets(struct um_context *context, struct um_diagnosis_request *r,
                                  const struct um_compare_measurements *m,
                                  const struct um_diagnosis_nuisance_effect *nuisance)
{
  struct um_diagnosis_nuisance_effect one = *nuisance;
  char text[512], *target;
  for (size_t i = 0; i < m->nfile; i++) {
    snprintf(text, sizeof text, "%s@%s",
             nuisance->target != NULL ? nuisance->target : UM_EFFECTS_ALL, m->file[i].name);
    UM_TRY(keep(context, r, text, &target));
    one.target = target;
    UM_TRY(put_nuisance(context, r, &one));
  }
  return UM_OK;
}

/* A target that names a set names one that is there. */
static enum um_status check_set(struct um_context *context, const struct um_compare_measurements *m,
                                const struct um_effect *effect, const char *target)
{
  const char *set = um_effects_set_of(effect, target);
  char accepted[320] = "", hint[UM_CORE_WORDS_HINT];
  struct um_core_words_guess guess = {.written = set};
  if (set == NULL || m == NULL || um_compare_set_find(m, set) != UM_COMPARE_NOWHERE) return UM_OK;
  for (size_t i = 0; i < m->nfile; i++) {
    um_core_words_append(accepted, sizeof accepted, m->file[i].name);
    um_core_words_consider(&guess, m->file[i].name);
  }
  return um_core_fail(context, UM_ERR_INPUT, "no set is called '%.60s'%s; accepted: %s", set,
                      um_core_words_hint(&guess, hint), accepted);
}

/* First and last time of a set [s TAI]. */
static void span(const struct um_compare_measurements *m, size_t set, double out[2])
{
  out[0] = INFINITY;
  out[1] = -INFINITY;
  for (size_t i = 0; i < m->count; i++) {
    if (m->row[i].set != set) continue;
    out[0] = fmin(out[0], m->row[i].t_tai);
    out[1] = fmax(out[1], m->row[i].t_tai);
  }
}

/* Observations are followed in their order: a clock of its own for one of two sets that overlap
 * would change it. */
static enum um_status check_clocks(struct um_context *context,
                                   const struct um_compare_measurements *m,
                                   const struct um_effect *effect)
{
  double a[2], b[2];
  if (effect->hooks.time == NULL && effect->hooks.exposure == NULL) return UM_OK;
  for (size_t i = 0; i < m->nfile; i++)
    for (size_t k = 0; k < i; k++) {
      span(m, i, a);
      span(m, k, b);
      if (a[0] > b[1] || b[0] > a[1]) continue;
      return um_core_fail(context, UM_ERR_INPUT,
                          "'%s' of one set alone, while sets '%s' and '%s' overlap in time; "
                          "accepted: one value for all sets (per=all)",
                          effect->name, m->file[k].name, m->file[i].name);
    }
  return UM_OK;
}

static enum um_status check_target(struct um_context *context, const struct asked *asked,
                                   const struct um_effect *effect, const char *target)
{
  UM_TRY(um_model_check_target(context, asked->model, effect, target));
  UM_TRY(check_set(context, asked->measurements, effect, target));
  bool of_one = asked->measurements != NULL && um_effects_set_of(effect, target) != NULL;
  return of_one ? check_clocks(context, asked->measurements, effect) : UM_OK;
}

static enum um_status add_nuisance(struct um_context *context, const struct asked *asked,
                                   struct um_diagnosis_request *r, const char *name,
                                   const char *target, double sigma, const char *per);

/* Does a place lie in another one of the list? */
static bool lies_in_another(const struct um_sensitivity_targets *targets, const char *place)
{
  for (size_t i = 0; i < targets->count; i++) {
    size_t n = strlen(targets->name[i]);
    if (strncmp(place, targets->name[i], n) == 0 && place[n] == '.') return true;
  }
  return false;
}

/* A nuisance of an effect that acts on something, without saying on what: of each that there is. */
static enum um_status add_each(struct um_context *context, const struct asked *asked,
                               struct um_diagnosis_request *r, const struct um_effect *effect,
                               double sigma, const char *per)
{
  struct um_sensitivity_targets targets;
  enum um_status status;
  char *target;
  UM_TRY(um_sensitivity_targets_of(context, asked->model, effect, &targets));
  for (size_t i = 0; i < targets.count; i++) {
    if (lies_in_another(&targets, targets.name[i])) continue;
    UM_CHECK(keep(context, r, targets.name[i], &target));
    UM_CHECK(add_nuisance(context, asked, r, effect->name, target, sigma, per));
  }
  status = targets.count > 0
               ? UM_OK
               : um_core_fail(context, UM_ERR_INPUT, "'%s' has nothing to act on in this scenario",
                              effect->name);
done:
  um_sensitivity_targets_release(context, &targets);
  return status;
}

/* One value for all sets or, where the effect acts on what is measured, one in each. */
static enum um_status add_nuisance(struct um_context *context, const struct asked *asked,
                                   struct um_diagnosis_request *r, const char *name,
                                   const char *target, double sigma, const char *per)
{
  const struct um_effect *effect;
  UM_TRY(find_effect(context, asked->model, name, &effect));
  if (target == NULL && (effect->targets & UM_TARGET_GLOBAL) == 0)
    return add_each(context, asked, r, effect, sigma, per);
  UM_TRY(check_target(context, asked, effect, target));
  if (isnan(sigma))
    UM_TRY(own_sigma(context, effect, &sigma));
  else if (effect->nparameter == 0 || effect->on_by_default)
    UM_TRY(own_sigma(context, effect, &sigma)); /* says why not */
  const struct um_diagnosis_nuisance_effect nuisance = {effect, target, sigma, per};
  UM_TRY(um_diagnosis_nuisance_check(context, &nuisance)); /* before anything is computed */
  bool several = asked->measurements != NULL && asked->measurements->nfile > 1,
       own = um_effects_may_be_of_a_set(effect);
  if (several && per != NULL && strcmp(per, "set") == 0 && !own)
    return um_core_fail(context, UM_ERR_INPUT,
                        "'%s' acts on the satellite, which is one in all sets; accepted: per all",
                        effect->name);
  bool apart = several && own && um_effects_set_of(effect, target) == NULL &&
               !(per != NULL && strcmp(per, "all") == 0);
  if (apart) UM_TRY(check_clocks(context, asked->measurements, effect));
  return apart ? put_in_sets(context, r, asked->measurements, &nuisance)
               : put_nuisance(context, r, &nuisance);
}

/* ---- texts of the command line ---- */

/* Cut "effect[:target][,rest]" in place; target NULL: none; rest "" at the end. */
static void cut(char *text, char **target, char **rest)
{
  *rest = text + strcspn(text, ",");
  if (**rest != '\0') *(*rest)++ = '\0';
  *target = strchr(text, ':');
  if (*target != NULL) *(*target)++ = '\0';
}

/* The next "name=value" of the rest. */
static enum um_status next_pair(struct um_context *context, char **rest, char **name, char **value)
{
  *name = *rest;
  *rest += strcspn(*rest, ",");
  if (**rest != '\0') *(*rest)++ = '\0';
  *value = strchr(*name, '=');
  if (*value == NULL)
    return um_core_fail(context, UM_ERR_INPUT, "'%.60s' is not understood; accepted: NAME=VALUE",
                        *name);
  *(*value)++ = '\0';
  return UM_OK;
}

static enum um_status read_sigma(struct um_context *context, const char *text, double *out)
{
  *out = INFINITY;
  if (strcmp(text, "free") == 0) return UM_OK;
  if (um_core_number_parse(text, out) && *out > 0.0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "sigma '%.60s'; accepted: a number above 0, or free",
                      text);
}

static enum um_status take_nuisance(struct um_context *context, const struct asked *asked,
                                    struct um_diagnosis_request *r, const char *typed)
{
  char *text, *target, *rest, *name, *value;
  const char *per = NULL;
  double sigma = NAN;
  UM_TRY(keep(context, r, typed, &text));
  cut(text, &target, &rest);
  while (*rest != '\0') {
    UM_TRY(next_pair(context, &rest, &name, &value));
    if (strcmp(name, "sigma") == 0)
      UM_TRY(read_sigma(context, value, &sigma));
    else if (strcmp(name, "per") == 0)
      per = value;
    else
      return um_core_fail(context, UM_ERR_INPUT, "'%.60s' is not known; accepted: sigma, per",
                          name);
  }
  return add_nuisance(context, asked, r, text, target, sigma, per);
}

static enum um_status set_start(struct um_context *context, struct um_model_addition *a,
                                struct um_effects_said *said, const char *name, const char *text)
{
  size_t p;
  UM_TRY(um_effects_parameter_read(context, a->effect, name, said, &p));
  const struct um_effect_parameter *parameter = &a->effect->parameters[p];
  if (um_core_number_parse(text, &a->value[p]) && a->value[p] >= parameter->minimum &&
      a->value[p] <= parameter->maximum)
    return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "%s '%.60s'; accepted: %g to %g %s", name, text,
                      parameter->minimum, parameter->maximum, parameter->unit);
}

static enum um_status take_wanted(struct um_context *context, const struct asked *asked,
                                  struct um_diagnosis_request *r, const char *typed)
{
  char *text, *target, *rest, *name, *value;
  struct um_model_addition wanted = {0};
  struct um_effects_said said = {{NULL}};
  UM_TRY(keep(context, r, typed, &text));
  cut(text, &target, &rest);
  UM_TRY(find_effect(context, asked->model, text, &wanted.effect));
  UM_TRY(check_target(context, asked, wanted.effect, target));
  wanted.target = target;
  for (size_t p = 0; p < wanted.effect->nparameter; p++) wanted.value[p] = NAN;
  while (*rest != '\0') {
    UM_TRY(next_pair(context, &rest, &name, &value));
    UM_TRY(set_start(context, &wanted, &said, name, value));
  }
  for (size_t i = 0; i < r->nwanted; i++)
    if (r->wanted[i].effect == wanted.effect && um_core_words_same(r->wanted[i].target, target))
      return um_core_fail(context, UM_ERR_INPUT, "'%s' is asked for twice; accepted: once", text);
  UM_TRY(um_core_reallocate(context, r->nwanted + 1, sizeof *r->wanted, (void **)&r->wanted));
  r->wanted[r->nwanted++] = wanted;
  return UM_OK;
}

static enum um_status add_exclude(struct um_context *context, struct um_diagnosis_request *r,
                                  const char *text)
{
  UM_TRY(um_core_reallocate(context, r->nexclude + 1, sizeof *r->exclude, (void **)&r->exclude));
  r->exclude[r->nexclude++] = text;
  return UM_OK;
}

/* ---- the scenario ---- */

static enum um_status take_nuisance_of(struct um_context *context, const struct asked *asked,
                                       struct um_diagnosis_request *r, const char *target,
                                       const struct um_scenario_nuisance *n)
{
  if (n->free && !isnan(n->sigma))
    return um_document_mark_fail(context, &n->at, "both sigma and free; accepted: one of them");
  enum um_status status =
      add_nuisance(context, asked, r, n->effect, target, n->free ? INFINITY : n->sigma, n->per);
  if (status == UM_ERR_INPUT)
    um_core_message_prefix(context, "%s:%d: %s", n->at.file, n->at.line, n->at.path);
  return status;
}

/* Those that a set states for itself; of sets that are not measured here none. */
static enum um_status take_set(struct um_context *context, const struct asked *asked,
                               struct um_diagnosis_request *r, const struct um_scenario_set *set)
{
  const struct um_scenario_nuisance *nuisance = set->nuisance.items;
  char text[512], *target;
  if (asked->measurements == NULL ||
      um_compare_set_find(asked->measurements, set->name) == UM_COMPARE_NOWHERE)
    return UM_OK;
  for (size_t i = 0; i < set->nuisance.count; i++) {
    const char *of = nuisance[i].target;
    snprintf(text, sizeof text, "%s@%s", of != NULL ? of : UM_EFFECTS_ALL, set->name);
    UM_TRY(keep(context, r, text, &target));
    UM_TRY(take_nuisance_of(context, asked, r, target, &nuisance[i]));
  }
  return UM_OK;
}

static enum um_status take_scenario(struct um_context *context, const struct asked *asked,
                                    struct um_diagnosis_request *r)
{
  const struct um_scenario_measurements *from = asked->model->scenario->measurements;
  if (from == NULL) return UM_OK;
  const struct um_scenario_nuisance *nuisance = from->nuisance.items;
  for (size_t i = 0; i < from->nuisance.count; i++)
    UM_TRY(take_nuisance_of(context, asked, r, nuisance[i].target, &nuisance[i]));
  const struct um_scenario_set *set = from->sets.items;
  for (size_t i = 0; i < from->sets.count; i++) UM_TRY(take_set(context, asked, r, &set[i]));
  const char *const *exclude = from->exclude.items;
  for (size_t i = 0; i < from->exclude.count; i++) UM_TRY(add_exclude(context, r, exclude[i]));
  return UM_OK;
}

/* ---- the whole ---- */

typedef enum um_status take_text(struct um_context *context, const struct asked *asked,
                                 struct um_diagnosis_request *r, const char *typed);

static enum um_status take_texts(struct um_context *context, const struct asked *asked,
                                 struct um_diagnosis_request *r, const char *option,
                                 take_text *take, const char *const *text, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    enum um_status status = take(context, asked, r, text[i]);
    if (status == UM_ERR_INPUT) um_core_message_prefix(context, "%s %s", option, text[i]);
    UM_TRY(status);
  }
  return UM_OK;
}

enum um_status um_diagnosis_request_make(struct um_context *context, const struct um_model *model,
                                         const struct um_diagnosis_request_texts *texts,
                                         struct um_diagnosis_request *out)
{
  const struct asked asked = {model, texts->measurements};
  *out = (struct um_diagnosis_request){0};
  UM_TRY(take_scenario(context, &asked, out));
  UM_TRY(take_texts(context, &asked, out, "--nuisance", take_nuisance, texts->nuisance,
                    texts->nnuisance));
  UM_TRY(take_texts(context, &asked, out, texts->option != NULL ? texts->option : "--add",
                    take_wanted, texts->wanted, texts->nwanted));
  for (size_t i = 0; i < texts->nexclude; i++) UM_TRY(add_exclude(context, out, texts->exclude[i]));
  return UM_OK;
}

void um_diagnosis_request_release(struct um_context *context, struct um_diagnosis_request *request)
{
  for (size_t i = 0; i < request->ntext; i++) um_core_free(context, request->text[i]);
  UM_FREE(context, request->text, request->nuisance, request->wanted, request->exclude);
  *request = (struct um_diagnosis_request){0};
}
