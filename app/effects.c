/* umbra list effects: all effects as a table, or the manual's page of one. */
#include "app/client.h"
#include "base/core/json.h"

static void json_parameter(const struct umbra_parameter *p)
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

static void json_effect(const struct umbra_effect *e)
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
    json_parameter(&e->parameter[i]);
  }
  printf("]}");
}

static void print_json(const struct umbra *umbra)
{
  const struct umbra_effect *effect;
  puts("[");
  for (size_t i = 0; (effect = umbra_effect_at(umbra, i)) != NULL; i++) {
    printf("  ");
    json_effect(effect);
    puts(umbra_effect_at(umbra, i + 1) != NULL ? "," : "");
  }
  puts("]");
}

static void print_table(const struct umbra *umbra)
{
  const struct umbra_effect *e;
  for (size_t i = 0; (e = umbra_effect_at(umbra, i)) != NULL; i++)
    printf("%-22s %-4s %s\n", e->name, e->on_by_default ? "on" : "off", e->summary);
}

static enum umbra_status print_one(struct umbra *umbra, const char *name, bool json)
{
  const struct umbra_effect *effect;
  enum umbra_status status = umbra_effect_find(umbra, name, &effect);
  if (status != UMBRA_OK) return status;
  if (json) {
    json_effect(effect);
    printf("\n");
  } else {
    um_app_effect_page(stdout, effect);
  }
  return UMBRA_OK;
}

int um_app_effects(struct um_context *context, const struct um_app_options *options)
{
  (void)context;
  struct umbra *umbra;
  enum umbra_status status = UMBRA_OK;
  int code = um_app_session_open(&umbra);
  if (code != UM_APP_DONE) return code;
  for (size_t i = 0; status == UMBRA_OK && i < options->neffect_file; i++)
    status = umbra_effects_load(umbra, options->effect_file[i]);
  if (status == UMBRA_OK && options->npositional == 1)
    status = print_one(umbra, options->positional[0], options->json);
  else if (status == UMBRA_OK && options->json)
    print_json(umbra);
  else if (status == UMBRA_OK)
    print_table(umbra);
  if (status != UMBRA_OK) code = um_app_session_fail(umbra);
  umbra_close(&umbra);
  return code;
}
