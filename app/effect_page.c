/* The manual's page of every effect, written from its descriptor: what it is, what it acts on, its
 * parameters, when it holds, who says so, and how a scenario names it. */
#include <math.h>
#include <string.h>

#include "app/client.h"

/* A word for the target in examples. */
static const char *example_target(const struct umbra_effect *effect)
{
  if ((effect->targets & UMBRA_TARGET_GLOBAL) != 0) return NULL;
  if ((effect->targets & UMBRA_TARGET_PART) != 0) return "PART";
  if ((effect->targets & UMBRA_TARGET_SIDE) != 0) return "PART.SIDE";
  if ((effect->targets & UMBRA_TARGET_MATERIAL) != 0) return "MATERIAL";
  if ((effect->targets & UMBRA_TARGET_BAND) != 0) return "BAND";
  return "SENSOR";
}

static void write_targets(FILE *file, const struct umbra_effect *effect)
{
  static const struct {
    enum umbra_target target;
    const char *words;
  } names[] = {{UMBRA_TARGET_GLOBAL, "everything (no target)"},
               {UMBRA_TARGET_PART, "a part"},
               {UMBRA_TARGET_SIDE, "a side or group of a part"},
               {UMBRA_TARGET_INTERIOR, "an interior of a part"},
               {UMBRA_TARGET_MATERIAL, "a material"},
               {UMBRA_TARGET_BAND, "a band"},
               {UMBRA_TARGET_SENSOR, "a sensor"}};
  const char *separator = "";
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    if ((effect->targets & (unsigned)names[i].target) == 0) continue;
    fprintf(file, "%s%s", separator, names[i].words);
    separator = ", ";
  }
}

static void write_parameters(FILE *file, const struct umbra_effect *effect)
{
  if (effect->nparameter == 0) return;
  fputs("\n| parameter | unit | vanishes at | default | range | prior sigma | from | meaning |\n"
        "|---|---|---|---|---|---|---|---|\n",
        file);
  for (size_t i = 0; i < effect->nparameter; i++) {
    const struct umbra_parameter *p = &effect->parameter[i];
    fprintf(file, "| `%s` | %s | %g | %g | %g to %g | ", p->name, p->unit, p->null_value,
            p->default_value, p->minimum, p->maximum);
    if (isfinite(p->prior_sigma))
      fprintf(file, "%g%s", p->prior_sigma, p->logarithmic ? " of ln" : "");
    else
      fputs("none", file);
    fprintf(file, " | %s | %s |\n", p->prior != NULL ? p->prior : "", p->help);
  }
}

/* In a scenario and on the command line. */
static void write_example(FILE *file, const struct umbra_effect *effect)
{
  const char *target = example_target(effect);
  fprintf(file, "\n```yaml\neffects:\n  - {effect: %s", effect->name);
  if (target != NULL) fprintf(file, ", target: %s", target);
  if (effect->on_by_default) fputs(", off: true", file);
  for (size_t i = 0; i < effect->nparameter && !effect->on_by_default; i++)
    fprintf(file, ", %s: %g", effect->parameter[i].name, effect->parameter[i].default_value);
  fprintf(file, "}\n```\n\n`umbra run SCENARIO %s %s",
          effect->on_by_default ? "--without" : "--with", effect->name);
  if (target != NULL) fprintf(file, ":%s", target);
  for (size_t i = 0; i < effect->nparameter && !effect->on_by_default; i++)
    fprintf(file, ",%s=%g", effect->parameter[i].name, effect->parameter[i].default_value);
  fputs("`\n", file);
}

void um_app_effect_page(FILE *file, const struct umbra_effect *effect)
{
  fprintf(file, "## %s\n\n%s.\n\n- acts on: ", effect->name, effect->summary);
  write_targets(file, effect);
  fprintf(file, "\n- %s by default\n- valid: %s\n- reference: %s\n",
          effect->on_by_default ? "on" : "off", effect->validity, effect->reference);
  if (effect->separated_by != NULL) fprintf(file, "- told apart from %s\n", effect->separated_by);
  write_parameters(file, effect);
  write_example(file, effect);
}

void um_app_effect_manual(FILE *file, const struct umbra *umbra)
{
  fputs(
      "# Effects\n\n"
      "Made from the descriptors in `effects/` by the build; not edited by hand.\n"
      " An effect at the value at which it vanishes "
      "leaves the result\nbit-identical to a run without it. A prior sigma is the width of a weak "
      "Gaussian prior about that value,\nwhich diagnosis and fit use; `of ln` is that of the "
      "logarithm of the parameter over it. Behind it stands\nwhat the width is taken from. A "
      "fitted value more than three widths away is called not credible. `none`:\nevery value "
      "within the range is as good as another before the data. An effect of your own is added "
      "by\n`effect_files` with `--allow-effects`, or `--effect-file`: "
      "[examples/effects](../examples/effects/README.md).\n\n"
      "Parameters of the same kind have the same name: `factor` multiplies what the effect is "
      "about,\n`shift_UNIT` is added to it, an amount goes by its quantity and unit. Names until "
      "0.4 are accepted\nwith a warning until 0.6; [CHANGELOG.md](../CHANGELOG.md) has them.\n\n"
      "| effect | by default | what it is |\n|---|---|---|\n",
      file);
  const struct umbra_effect *e;
  for (size_t i = 0; (e = umbra_effect_at(umbra, i)) != NULL; i++)
    fprintf(file, "| [%s](#%s) | %s | %s |\n", e->name, e->name, e->on_by_default ? "on" : "off",
            e->summary);
  for (size_t i = 0; (e = umbra_effect_at(umbra, i)) != NULL; i++) {
    fputc('\n', file);
    um_app_effect_page(file, e);
  }
}
