/* Exports of a run: a folder of files that its result gives. */
#include <stdio.h>

#include "app/export.h"
#include "app/terminal.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"

static void print(const struct um_app_options *options, size_t observations, const char *folder)
{
  if (options->json) {
    um_core_json_text(stdout, "{", "folder", folder);
    printf(", \"observations\": %zu}\n", observations);
    return;
  }
  printf("%zu observations\n", observations);
  um_app_tell_results(folder);
}

int um_app_export_run(struct um_context *context, const struct um_app_options *options,
                      const char *kind, bool of_geometry, um_app_export_write *write)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  struct um_core_folder *folder = NULL;
  struct um_model_options changes = um_app_model_options(options);
  char *out = NULL, *name = NULL;
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  UM_CHECK(um_core_asprintf(context, &name, "%s-%s", model->scenario->name, kind));
  UM_CHECK(um_app_out_folder(context, options, name, &out));
  UM_CHECK(um_core_folder_begin(context, out, options->force, &folder));
  UM_CHECK(um_model_precompute(context, model, &tables));
  if (!of_geometry) UM_CHECK(um_model_run(context, model, tables, &result));
  const struct um_output_run run = {.model = model,
                                    .tables = tables,
                                    .result = result,
                                    .version = UM_APP_VERSION,
                                    .context = context};
  UM_CHECK(write(context, &run, folder));
  UM_CHECK(um_core_folder_commit(context, &folder));
  um_app_terminal_clear();
  print(options, tables->nobs, out);
done:
  um_core_folder_abort(&folder);
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
  UM_FREE(context, out, name);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
