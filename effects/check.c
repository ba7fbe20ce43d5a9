/* Is a descriptor one that the program can work with? A user's own may hold anything. */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "effects/effects.h"

#define ALL_TARGETS                                                                                \
  (UM_TARGET_GLOBAL | UM_TARGET_PART | UM_TARGET_PART_SIDE | UM_TARGET_MATERIAL | UM_TARGET_BAND | \
   UM_TARGET_SENSOR | UM_TARGET_INTERIOR)

/* Words of a scenario's entry that a parameter would hide. */
static const char *const taken[] = {"effect", "target", "off"};

/* A word that can stand in "effect:target,name=value": a letter, then letters, digits and _. */
static bool is_word(const char *text)
{
  if (text == NULL || !isalpha((unsigned char)text[0])) return false;
  for (const char *c = text; *c != '\0'; c++)
    if (!isalnum((unsigned char)*c) && *c != '_') return false;
  return strlen(text) <= 60;
}

static bool is_text(const char *text) { return text != NULL && text[0] != '\0'; }

static enum um_status check_values(struct um_context *context, const struct um_effect *e,
                                   const struct um_effect_parameter *p)
{
  if (!(isfinite(p->minimum) && isfinite(p->maximum) && p->minimum < p->maximum))
    return um_core_fail(
        context, UM_ERR_INPUT,
        "effect '%s': parameter '%s' goes from %g to %g; accepted: finite, ascending", e->name,
        p->name, p->minimum, p->maximum);
  const struct {
    const char *word;
    double value;
  } inside[] = {{"null value", p->null_value}, {"default", p->default_value}};
  for (size_t i = 0; i < 2; i++)
    if (!(inside[i].value >= p->minimum && inside[i].value <= p->maximum))
      return um_core_fail(
          context, UM_ERR_INPUT, "effect '%s': parameter '%s': %s %g; accepted: %g to %g %s",
          e->name, p->name, inside[i].word, inside[i].value, p->minimum, p->maximum, p->unit);
  if (!(p->prior_sigma > 0.0))
    return um_core_fail(
        context, UM_ERR_INPUT,
        "effect '%s': parameter '%s': prior sigma %g; accepted: above 0, INFINITY for none",
        e->name, p->name, p->prior_sigma);
  if (p->logarithmic && !(p->minimum > 0.0))
    return um_core_fail(
        context, UM_ERR_INPUT,
        "effect '%s': parameter '%s' is logarithmic and begins at %g; accepted: above 0", e->name,
        p->name, p->minimum);
  return UM_OK;
}

/* A word, and no name that something else of the effect has or had. */
static enum um_status check_name(struct um_context *context, const struct um_effect *e,
                                 size_t index, const char *name, bool former)
{
  bool again = false;
  for (size_t i = 0; is_word(name) && i <= index; i++) {
    const struct um_effect_parameter *p = &e->parameters[i];
    again = again || ((i < index || former) && strcmp(p->name, name) == 0) ||
            (i < index && p->formerly != NULL && strcmp(p->formerly, name) == 0);
  }
  for (size_t i = 0; is_word(name) && i < sizeof taken / sizeof taken[0]; i++)
    again = again || strcmp(name, taken[i]) == 0;
  if (is_word(name) && !again) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "effect '%s': parameter %zu %s called '%.60s'; accepted: a word of "
                      "letters, digits and _, used once, not effect, target or off",
                      e->name, index + 1, former ? "was" : "is", name != NULL ? name : "");
}

static enum um_status check_parameter(struct um_context *context, const struct um_effect *e,
                                      size_t index)
{
  const struct um_effect_parameter *p = &e->parameters[index];
  UM_TRY(check_name(context, e, index, p->name, false));
  if (p->formerly != NULL) UM_TRY(check_name(context, e, index, p->formerly, true));
  if (!is_text(p->unit) || !is_text(p->help))
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect '%s': parameter '%s' has no %s; accepted: a text", e->name, p->name,
                        !is_text(p->unit) ? "unit" : "help");
  return check_values(context, e, p);
}

/* Some hook or switch is there. */
static bool acts(const struct um_effect *e)
{
  static const struct um_effect_hooks none;
  return memcmp(&e->hooks, &none, sizeof none) != 0 || e->switch_off != NULL;
}

static enum um_status check_texts(struct um_context *context, const struct um_effect *e)
{
  const struct {
    const char *word, *text;
  } texts[] = {{"summary", e->summary}, {"reference", e->reference}, {"validity", e->validity}};
  if (!is_word(e->name))
    return um_core_fail(context, UM_ERR_INPUT,
                        "an effect is called '%.60s'; accepted: a word of letters, digits and _",
                        e->name != NULL ? e->name : "");
  for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++)
    if (!is_text(texts[i].text))
      return um_core_fail(context, UM_ERR_INPUT, "effect '%s' has no %s; accepted: a text", e->name,
                          texts[i].word);
  return UM_OK;
}

enum um_status um_effects_check(struct um_context *context, const struct um_effect *effect)
{
  const struct um_effect *e = effect;
  if (e->abi_version != UM_EFFECT_ABI_VERSION || e->struct_size != sizeof *e)
    return um_core_fail(
        context, UM_ERR_INPUT,
        "an effect of ABI version %u and %u bytes; accepted: version %d and %zu bytes, as of the "
        "header effects/effect.h of this program; compile it again",
        (unsigned)e->abi_version, (unsigned)e->struct_size, UM_EFFECT_ABI_VERSION, sizeof *e);
  if (e->layout != UM_EFFECT_LAYOUT)
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect '%s' was compiled against other sizes of what its hooks change; "
                        "accepted: the headers of this program; compile it again",
                        is_word(e->name) ? e->name : "");
  UM_TRY(check_texts(context, e));
  if (e->targets == 0 || (e->targets & ~(uint32_t)ALL_TARGETS) != 0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect '%s': targets %#x; accepted: or-ed values of enum um_effect_target",
                        e->name, (unsigned)e->targets);
  if (e->nparameter > UM_EFFECT_PARAMETERS_MAX || (e->nparameter > 0 && e->parameters == NULL))
    return um_core_fail(context, UM_ERR_INPUT, "effect '%s': %zu parameters%s; accepted: up to %d",
                        e->name, e->nparameter, e->parameters == NULL ? ", none given" : "",
                        UM_EFFECT_PARAMETERS_MAX);
  for (size_t i = 0; i < e->nparameter; i++) UM_TRY(check_parameter(context, e, i));
  if (e->on_by_default && e->switch_off == NULL && e->nparameter > 0)
    return um_core_fail(
        context, UM_ERR_INPUT,
        "effect '%s' is on by default and has parameters; accepted: with switch_off", e->name);
  for (size_t i = 0; e->on_by_default && i < e->nparameter; i++)
    if (e->parameters[i].default_value != e->parameters[i].null_value)
      return um_core_fail(
          context, UM_ERR_INPUT,
          "effect '%s' is on by default and its parameter '%s' is %g then; accepted: "
          "the null value %g",
          e->name, e->parameters[i].name, e->parameters[i].default_value,
          e->parameters[i].null_value);
  if ((e->is_off == NULL) != (e->switch_on == NULL))
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect '%s': is_off and switch_on; accepted: both or none", e->name);
  if (acts(e)) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "effect '%s' has no hook; accepted: one or more",
                      e->name);
}
