/* All files of a run into one folder. */
#include "output/output.h"

#include "model/build/scenario_text.h"
#include "output/page.h"
#include "output/plots_impl.h"

typedef enum um_status (*writer)(const struct um_output_run *run, FILE *file);

static enum um_status write_file(struct um_context *context, const struct um_output_run *run,
                                 struct um_core_folder *folder, const char *name, writer write)
{
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, folder, name, &file));
  enum um_status status = write(run, file);
  enum um_status closed = um_core_file_close(context, name, &file);
  return status != UM_OK ? status : closed;
}

static enum um_status write_text(struct um_context *context, struct um_core_folder *folder,
                                 const char *name, const char *text)
{
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, folder, name, &file));
  fputs(text, file);
  return um_core_file_close(context, name, &file);
}

static enum um_status write_log(struct um_context *context, const struct um_output_run *run,
                                struct um_core_folder *folder)
{
  char *text;
  UM_TRY(um_core_asprintf(context, &text, "%s%s", run->log != NULL ? run->log : "",
                          um_core_log_text(context)));
  enum um_status status = write_text(context, folder, "log.txt", text);
  um_core_free(context, text);
  return status;
}

static enum um_status write_netcdf(struct um_context *context, const struct um_output_run *run,
                                   struct um_core_folder *folder)
{
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, folder, "run.nc", &file));
  enum um_status status = um_output_write_netcdf(context, run, file);
  enum um_status closed = um_core_file_close(context, "run.nc", &file);
  return status != UM_OK ? status : closed;
}

static enum um_status write_scenario(struct um_context *context, const struct um_output_run *run,
                                     struct um_core_folder *folder)
{
  const struct um_model *model = run->model;
  char *text = NULL;
  UM_TRY(um_model_scenario_text(context, model, model->effect, model->neffect, run->options,
                                um_core_folder_path(folder), &text));
  enum um_status status = write_text(context, folder, "scenario.yaml", text);
  um_core_free(context, text);
  return status;
}

enum um_status um_output_write_run(struct um_context *context, const struct um_output_run *run,
                                   bool pictures, struct um_core_folder *folder)
{
  if (run->model->has_observer) {
    UM_TRY(write_file(context, run, folder, "lightcurve.csv", um_output_write_lightcurve));
    UM_TRY(write_file(context, run, folder, "materials.csv", um_output_write_materials));
    if (run->model->nsensor > 0)
      UM_TRY(write_file(context, run, folder, "counts.csv", um_output_write_counts));
  }
  UM_TRY(write_file(context, run, folder, "temperatures.csv", um_output_write_temperatures));
  UM_TRY(write_file(context, run, folder, "heat.csv", um_output_write_heat));
  UM_TRY(write_file(context, run, folder, "temperatures.cic", um_output_write_cic));
  UM_TRY(write_file(context, run, folder, "run.xdmf", um_output_write_xdmf));
  UM_TRY(write_scenario(context, run, folder));
  UM_TRY(write_netcdf(context, run, folder));
  if (pictures) UM_TRY(um_output_plot_run(context, um_core_folder_path(folder), run));
  if (pictures) UM_TRY(write_text(context, folder, "plots.py", um_output_plots_py));
  UM_TRY(um_output_write_page(context, run, folder));
  return write_log(context, run, folder);
}
