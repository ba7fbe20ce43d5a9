/* umbra export --as vtu: the satellite with its temperatures, for ParaView, VTK and meshio. */
#include <stdio.h>

#include "app/export.h"
#include "app/terminal.h"
#include "base/core/file.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "output/vtu.h"

static void print(const struct um_app_options *options, const struct um_model_result *result,
                  const char *folder)
{
  if (options->json) {
    um_core_json_text(stdout, "{", "folder", folder);
    printf(", \"observations\": %zu}\n", result->nobs);
    return;
  }
  printf("%zu observations\n", result->nobs);
  um_app_tell_results(folder);
}

static int export_vtu(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  struct um_core_folder *folder = NULL;
  struct um_model_options changes = um_app_model_options(options);
  char *out = NULL, *name = NULL;
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  UM_CHECK(um_core_asprintf(context, &name, "%s-vtu", model->scenario->name));
  UM_CHECK(um_app_out_folder(context, options, name, &out));
  UM_CHECK(um_core_folder_begin(context, out, options->force, &folder));
  UM_CHECK(um_model_precompute(context, model, &tables));
  UM_CHECK(um_model_run(context, model, tables, &result));
  const struct um_output_run run = {.model = model, .tables = tables, .result = result};
  UM_CHECK(um_output_write_vtu(context, &run, folder));
  UM_CHECK(um_core_folder_commit(context, &folder));
  um_app_terminal_clear();
  print(options, result, out);
done:
  um_core_folder_abort(&folder);
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
  UM_FREE(context, out, name);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}

const struct um_app_export um_app_export_vtu = {
    .name = "vtu",
    .target = "FOLDER",
    .summary = "the satellite with its temperatures at every instant, for ParaView and meshio",
    .run = export_vtu};
