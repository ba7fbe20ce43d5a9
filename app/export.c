/* umbra export: a scenario, or what follows from it, for other programs. */
#include "app/export.h"

#include <string.h>

#include "base/core/suggestions.h"

static const struct um_app_export *const kinds[] = {
#define UM_EXPORT(name) &um_app_export_##name,
#include "app/export_list.def"
#undef UM_EXPORT
};
#define KINDS (sizeof kinds / sizeof *kinds)

const char *um_app_export_name(size_t index) { return index < KINDS ? kinds[index]->name : NULL; }

void um_app_export_list(FILE *file)
{
  for (size_t i = 0; i < KINDS; i++)
    fprintf(file, "  %-12s %-10s %s\n", kinds[i]->name, kinds[i]->target, kinds[i]->summary);
}

int um_app_export(struct um_context *context, const struct um_app_options *options)
{
  char accepted[400] = "", hint[UM_CORE_WORDS_HINT];
  struct um_core_words_guess guess = {.written = options->as};
  for (size_t i = 0; i < KINDS; i++) {
    if (strcmp(options->as, kinds[i]->name) == 0) {
      if (options->out != NULL || strcmp(kinds[i]->target, "FOLDER") == 0)
        return kinds[i]->run(context, options);
      fprintf(stderr, "umbra: -o %s is missing\n", kinds[i]->target);
      return UM_APP_MISUSE;
    }
    um_core_words_append(accepted, sizeof accepted, kinds[i]->name);
    um_core_words_consider(&guess, kinds[i]->name);
  }
  (void)um_core_fail(context, UM_ERR_INPUT, "--as %.60s: unknown%s; accepted: %s", options->as,
                     um_core_words_hint(&guess, hint), accepted);
  return um_app_fail(context);
}
