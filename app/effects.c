/* umbra effects: the registry as a table or one effect in full. */
#include <string.h>

#include "app/app.h"
#include "effects/effects.h"

static void print_one(const struct um_effect *e)
{
  printf("%s\n  %s.\n  %s by default\n  valid: %s\n  reference: %s\n", e->name, e->summary,
         e->on_by_default ? "on" : "off", e->validity, e->reference);
  for (size_t i = 0; i < e->nparameter; i++) {
    const struct um_effect_parameter *p = &e->parameters[i];
    printf("  %s [%s], default %g, %g to %g, vanishes at %g: %s\n", p->name, p->unit, p->fallback,
           p->minimum, p->maximum, p->null_value, p->help);
  }
}

static void json_parameter(const struct um_effect_parameter *p)
{
  printf("{\"name\": ");
  um_core_json_string(stdout, p->name);
  printf(", \"unit\": ");
  um_core_json_string(stdout, p->unit);
  printf(", \"default\": ");
  um_core_json_number(stdout, p->fallback);
  printf(", \"minimum\": ");
  um_core_json_number(stdout, p->minimum);
  printf(", \"maximum\": ");
  um_core_json_number(stdout, p->maximum);
  printf(", \"null_value\": ");
  um_core_json_number(stdout, p->null_value);
  printf(", \"help\": ");
  um_core_json_string(stdout, p->help);
  printf("}");
}

static void json_effect(const struct um_effect *e)
{
  printf("{\"name\": ");
  um_core_json_string(stdout, e->name);
  printf(", \"on_by_default\": %s, \"summary\": ", e->on_by_default ? "true" : "false");
  um_core_json_string(stdout, e->summary);
  printf(", \"validity\": ");
  um_core_json_string(stdout, e->validity);
  printf(", \"reference\": ");
  um_core_json_string(stdout, e->reference);
  printf(", \"parameters\": [");
  for (size_t i = 0; i < e->nparameter; i++) {
    if (i > 0) printf(", ");
    json_parameter(&e->parameters[i]);
  }
  printf("]}");
}

static void print_json(void)
{
  puts("[");
  for (size_t i = 0; i < um_effects_count(); i++) {
    printf("  ");
    json_effect(um_effects_at(i));
    printf("%s\n", i + 1 < um_effects_count() ? "," : "");
  }
  puts("]");
}

int um_app_effects(struct um_context *context, const struct um_app_options *options)
{
  if (options->npositional == 1) {
    const struct um_effect *e = um_effects_find(options->positional[0]);
    if (e == NULL) {
      char names[2048];
      um_effects_names(names, sizeof names);
      um_core_fail(context, UM_ERR_INPUT, "no effect is called '%s'; accepted: %s",
                   options->positional[0], names);
      return um_app_fail(context);
    }
    if (options->json) {
      json_effect(e);
      printf("\n");
    } else {
      print_one(e);
    }
    return UM_APP_DONE;
  }
  if (options->json) {
    print_json();
    return UM_APP_DONE;
  }
  for (size_t i = 0; i < um_effects_count(); i++) {
    const struct um_effect *e = um_effects_at(i);
    printf("%-20s %-4s %s\n", e->name, e->on_by_default ? "on" : "off", e->summary);
  }
  return UM_APP_DONE;
}
