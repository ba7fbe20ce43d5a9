/* umbra export --as network: the heat balance of a scenario for other thermal programs. */
#include <stdio.h>

#include "app/export.h"
#include "app/terminal.h"
#include "base/core/file.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/balance.h"
#include "output/network.h"

static void print(const struct um_app_options *options, size_t nodes, const char *folder)
{
  if (options->json) {
    um_core_json_text(stdout, "{", "folder", folder);
    printf(", \"nodes\": %zu}\n", nodes);
    return;
  }
  printf("%zu nodes at the balance of the mean heat\n", nodes);
  um_app_tell_results(folder);
}

static int export_network(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  struct um_thermal_network *network = NULL;
  struct um_core_folder *folder = NULL;
  struct um_model_options changes = um_app_model_options(options);
  char *out = NULL, *name = NULL;
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  UM_CHECK(um_core_asprintf(context, &name, "%s-network", model->scenario->name));
  UM_CHECK(um_app_out_folder(context, options, name, &out));
  UM_CHECK(um_core_folder_begin(context, out, options->force, &folder));
  UM_CHECK(um_model_precompute(context, model, &tables));
  if (tables->points) {
    status = um_core_fail(context, UM_ERR_INPUT,
                          "%s: heat is not followed, so there is no network; accepted: an orbit "
                          "other than points",
                          options->positional[0]);
    goto done;
  }
  UM_CHECK(um_model_balance_network(context, model, tables, &network));
  UM_CHECK(um_output_write_network(context, model, network, folder));
  UM_CHECK(um_core_folder_commit(context, &folder));
  um_app_terminal_clear();
  print(options, um_thermal_network_nodes(network), out);
done:
  um_core_folder_abort(&folder);
  um_thermal_network_destroy(&network);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
  UM_FREE(context, out, name);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}

const struct um_app_export um_app_export_network = {
    .name = "network",
    .target = "FOLDER",
    .summary = "nodes and conductors of the mean heat balance, for ESATAN, SINDA and as tables",
    .run = export_network};
