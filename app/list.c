/* umbra list: what there is of a kind, or the page of one. */
#include <string.h>

#include "app/app.h"
#include "base/core/text.h"

static const struct um_app_thing things[] = {
    {"materials", "surfaces that parts are made of", UM_APP_MATERIALS, um_app_materials},
    {"filters", "transmission curves of bands, with the Sun and Vega in them", UM_APP_FILTERS,
     um_app_filters},
    {"sensors", "telescopes with detectors", UM_APP_SENSORS, um_app_sensors},
    {"effects", "physical effects and their parameters", UM_APP_EFFECTS, um_app_effects},
    {"keys", "what a scenario.yaml may hold: its reference, or its JSON Schema", UM_APP_SECTIONS,
     um_app_schema},
    {"scenarios", "satellites and passes to begin with", UM_APP_SHIPPED, um_app_scenarios},
};

const struct um_app_thing *um_app_thing_at(size_t index)
{
  return index < sizeof things / sizeof things[0] ? &things[index] : NULL;
}

int um_app_list(struct um_context *context, const struct um_app_options *options)
{
  const char *word = options->positional[0];
  const struct um_app_thing *thing = NULL;
  for (size_t i = 0; i < sizeof things / sizeof things[0]; i++)
    if (strcmp(things[i].word, word) == 0) thing = &things[i];
  if (thing == NULL) {
    fputs("umbra: nothing is listed under '", stderr);
    um_core_text_put(stderr, word);
    fputs("'; accepted: ", stderr);
    for (size_t i = 0; i < sizeof things / sizeof things[0]; i++)
      fprintf(stderr, "%s%s", i > 0 ? ", " : "", things[i].word);
    fputc('\n', stderr);
    return UM_APP_MISUSE;
  }
  if (options->neffect_file > 0 && thing->offers != UM_APP_EFFECTS) {
    fprintf(stderr, "umbra: --effect-file belongs to umbra list effects, not to %s\n", word);
    return UM_APP_MISUSE;
  }
  if (thing->offers != UM_APP_MATERIALS &&
      um_app_options_refuse(options, "spectra force no-plots", "belongs to umbra list materials"))
    return UM_APP_MISUSE;
  struct um_app_options of = *options; /* its lists are the caller's */
  of.npositional--;
  for (int i = 0; i < of.npositional; i++) of.positional[i] = options->positional[i + 1];
  return thing->run(context, &of);
}
