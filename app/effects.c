/* umbra effects: the registry as a table, or the manual's page of one effect. */
#include "effects/effects.h"
#include "app/app.h"

static void json_parameter(const struct um_effect_parameter *p)
{
  um_core_json_text(stdout, "{", "name", p->name);
  um_core_json_text(stdout, ", ", "unit", p->unit);
  um_core_json_field(stdout, ", ", "default", p->default_value);
  um_core_json_field(stdout, ", ", "minimum", p->minimum);
  um_core_json_field(stdout, ", ", "maximum", p->maximum);
  um_core_json_field(stdout, ", ", "null_value", p->null_value);
  um_core_json_field(stdout, ", ", "prior_sigma", p->prior_sigma);
  printf(", \"logarithmic\": %s", p->logarithmic ? "true" : "false");
  um_core_json_text(stdout, ", ", "help", p->help);
  printf("}");
}

static void json_effect(const struct um_effect *e)
{
  um_core_json_text(stdout, "{", "name", e->name);
  printf(", \"on_by_default\": %s, \"summary\": ", e->on_by_default ? "true" : "false");
  um_core_json_string(stdout, e->summary);
  um_core_json_text(stdout, ", ", "validity", e->validity);
  um_core_json_text(stdout, ", ", "reference", e->reference);
  printf(", \"separated_by\": ");
  if (e->separated_by != NULL)
    um_core_json_string(stdout, e->separated_by);
  else
    printf("null");
  printf(", \"parameters\": [");
  for (size_t i = 0; i < e->nparameter; i++) {
    if (i > 0) printf(", ");
    json_parameter(&e->parameters[i]);
  }
  printf("]}");
}

static void print_json(const struct um_effects_registry *registry)
{
  size_t n = um_effects_registry_count(registry);
  puts("[");
  for (size_t i = 0; i < n; i++) {
    printf("  ");
    json_effect(um_effects_registry_at(registry, i));
    printf("%s\n", i + 1 < n ? "," : "");
  }
  puts("]");
}

static void print_table(const struct um_effects_registry *registry)
{
  for (size_t i = 0; i < um_effects_registry_count(registry); i++) {
    const struct um_effect *e = um_effects_registry_at(registry, i);
    printf("%-22s %-4s %s\n", e->name, e->on_by_default ? "on" : "off", e->summary);
  }
}

static enum um_status print_one(struct um_context *context,
                                const struct um_effects_registry *registry, const char *name,
                                bool json)
{
  const struct um_effect *e = um_effects_registry_find(registry, name);
  if (e == NULL) return um_effects_registry_refuse(context, registry, name);
  if (json) {
    json_effect(e);
    printf("\n");
  } else {
    um_effects_write_markdown(stdout, e);
  }
  return UM_OK;
}

int um_app_effects(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_effects_registry *registry = NULL;
  UM_CHECK(um_effects_registry_create(context, &registry));
  for (size_t i = 0; i < options->neffect_file; i++)
    UM_CHECK(um_effects_registry_load(context, registry, options->effect_file[i]));
  if (options->npositional == 1)
    UM_CHECK(print_one(context, registry, options->positional[0], options->json));
  else if (options->json)
    print_json(registry);
  else
    print_table(registry);
done:
  um_effects_registry_destroy(context, &registry);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
