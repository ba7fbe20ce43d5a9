/* MEASURED... of a command line, or what the scenario lists. */
#include "app/measured.h"

#include "evidence/measurements/listed.h"
#include "model/scenario/scenario_read.h"

static enum um_status read_listed(struct um_context *context, const struct um_app_options *options,
                                  struct um_compare_measurements **out)
{
  const struct um_model_options changes = um_app_model_options(options);
  struct um_document *document = NULL;
  const struct um_scenario *scenario;
  UM_TRY(um_model_scenario_read(context, options->positional[0], NULL, changes.overrides,
                                changes.noverride, NULL, 0, &document, &scenario));
  enum um_status status = um_compare_measurements_listed(context, scenario, out);
  um_document_destroy(&document);
  return status;
}

enum um_status um_app_measured_read(struct um_context *context,
                                    const struct um_app_options *options,
                                    struct um_compare_measurements **out)
{
  size_t n = 1 + options->nmore;
  const char **path = NULL;
  *out = NULL;
  if (options->npositional < 2) return read_listed(context, options, out);
  UM_TRY(um_core_allocate(context, n, sizeof *path, (void *)&path));
  path[0] = options->positional[1];
  for (size_t i = 1; i < n; i++) path[i] = options->more[i - 1];
  enum um_status status = um_compare_measurements_read_all(context, path, n, out);
  um_core_free(context, (void *)path);
  return status;
}
