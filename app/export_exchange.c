/* umbra export --as exchange: view factors and radiative couplings of a scenario as tables. */
#include <stdio.h>

#include "app/export.h"
#include "app/terminal.h"
#include "base/core/file.h"
#include "model/build/build.h"
#include "model/geometry/mirrors.h"
#include "model/geometry/precompute.h"
#include "model/geometry/tables.h"
#include "output/exchange.h"

static void print(const struct um_app_options *options,
                  const struct um_geometry_view_factor_table *table, const char *folder)
{
  if (options->json) {
    um_core_json_text(stdout, "{", "folder", folder);
    printf(", \"patches_outside\": %zu, \"patches_inside\": %zu, \"rooms\": %zu, \"poses\": %zu}\n",
           table->noutside, table->patches->npatch - table->noutside, table->nroom, table->npose);
    return;
  }
  printf("%zu patches outside in %zu pose%s, %zu inside of %zu part%s\n", table->noutside,
         table->npose, table->npose == 1 ? "" : "s", table->patches->npatch - table->noutside,
         table->nroom, table->nroom == 1 ? "" : "s");
  um_app_tell_results(folder);
}

static int export_exchange(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  struct um_thermal_exchange *exchange = NULL;
  struct um_core_folder *folder = NULL;
  struct um_model_options changes = um_app_model_options(options);
  struct um_thermal_exchange_options infrared = {.infrared = true};
  struct um_model_lobes lobes = {0};
  char *out = NULL, *name = NULL;
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  UM_CHECK(um_core_asprintf(context, &name, "%s-exchange", model->scenario->name));
  UM_CHECK(um_app_out_folder(context, options, name, &out));
  UM_CHECK(um_core_folder_begin(context, out, options->force, &folder));
  UM_CHECK(um_model_precompute(context, model, &tables));
  if (tables->view_factors == NULL) {
    status = um_core_fail(context, UM_ERR_INPUT,
                          "%s: heat is not followed, so nothing is exchanged; accepted: an orbit "
                          "other than points",
                          options->positional[0]);
    goto done;
  }
  const struct um_geometry_view_factor_table *table = tables->view_factors;
  if (table->mirrors != NULL) {
    UM_CHECK(um_model_lobes_make(context, model, table->mirrors, &lobes));
    infrared.lobes = &lobes.lobes;
  }
  if (model->environment.mutual_radiation_on)
    UM_CHECK(um_thermal_exchange_create(context, model->body->network,
                                        table->ntime == 1 ? NULL : tables->loads, table, &infrared,
                                        &exchange));
  UM_CHECK(um_output_write_exchange(context, model, table, exchange, folder));
  UM_CHECK(um_core_folder_commit(context, &folder));
  um_app_terminal_clear();
  print(options, table, out);
done:
  um_core_folder_abort(&folder);
  um_model_lobes_clear(context, &lobes);
  um_thermal_exchange_destroy(context, &exchange);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
  UM_FREE(context, out, name);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}

const struct um_app_export um_app_export_exchange = {
    .name = "exchange",
    .target = "FOLDER",
    .summary = "view factors and radiative couplings of surfaces, as tables",
    .run = export_exchange};
