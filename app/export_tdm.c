/* umbra export --as tdm: what the observer sees as a tracking data message. */
#include <stdio.h>

#include "app/export.h"
#include "app/target.h"
#include "app/terminal.h"
#include "base/core/file.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "output/tdm.h"

static enum um_status write(struct um_context *context, const struct um_output_run *run,
                            const char *path)
{
  struct um_core_whole_file whole;
  UM_TRY(um_core_whole_begin(context, path, &whole));
  enum um_status status = um_output_write_tdm(run, whole.file);
  return um_core_whole_end(context, &whole, status);
}

static int export_tdm(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  struct um_model_options changes = um_app_model_options(options);
  UM_CHECK(um_app_check_picture(context, options, ".tdm"));
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  UM_CHECK(um_model_precompute(context, model, &tables));
  UM_CHECK(um_model_run(context, model, tables, &result));
  const struct um_output_run run = {.model = model, .tables = tables, .result = result};
  UM_CHECK(write(context, &run, options->out));
  um_app_terminal_clear();
  if (options->json) {
    um_core_json_text(stdout, "{", "file", options->out);
    printf(", \"observations\": %zu}\n", result->nobs);
  } else {
    printf("%s: magnitudes, angles and ranges of %zu observations\n", options->out, result->nobs);
  }
done:
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}

const struct um_app_export um_app_export_tdm = {
    .name = "tdm",
    .target = "FILE.tdm",
    .summary = "magnitudes, angles and ranges as a tracking data message of CCSDS",
    .run = export_tdm};
