/* umbra export --as trajectory: orbit and attitude as the tables that scenarios take. */
#include "app/export.h"
#include "app/terminal.h"
#include "base/core/file.h"
#include "model/build/build.h"
#include "output/trajectory.h"

static void print(const struct um_app_options *options, const struct um_output_instants *instants)
{
  if (options->json) {
    um_core_json_text(stdout, "{", "folder", options->out);
    printf(", \"rows\": %zu", instants->count);
    um_core_json_field(stdout, ", ", "step_s", instants->step);
    printf("}\n");
    return;
  }
  printf("%zu rows every %g s in %s/orbit.csv and %s/attitude.csv; a scenario takes them by\n"
         "  orbit: {table: %s/orbit.csv}\n  attitude: [{table: %s/attitude.csv}]\n",
         instants->count, instants->step, options->out, options->out, options->out, options->out);
}

static int export_trajectory(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_core_folder *folder = NULL;
  struct um_output_instants instants;
  struct um_model_options changes = um_app_model_options(options);
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  UM_CHECK(um_output_instants_choose(context, model, &instants));
  UM_CHECK(um_core_folder_begin(context, options->out, options->force, &folder));
  UM_CHECK(um_output_write_trajectory(context, model, &instants, folder));
  UM_CHECK(um_core_folder_commit(context, &folder));
  um_app_terminal_clear();
  print(options, &instants);
done:
  um_core_folder_abort(&folder);
  um_model_destroy(context, &model);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}

const struct um_app_export um_app_export_trajectory = {
    .name = "trajectory",
    .target = "FOLDER",
    .summary =
        "orbit and attitude as .csv and as .oem, .aem (CCSDS), for orbit.table and attitude.table",
    .run = export_trajectory};
