/* All files of a forecast. */
#include "forecast/forecast_write.h"

static enum um_status write_file(struct um_context *context, struct um_core_folder *folder,
                                 const char *name, const struct um_forecast *f,
                                 void (*write)(const struct um_forecast *f, FILE *file))
{
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, folder, name, &file));
  write(f, file);
  return um_core_file_close(context, name, &file);
}

enum um_status um_forecast_write(struct um_context *context, const struct um_forecast *f,
                                 bool pictures, struct um_core_folder *folder)
{
  UM_TRY(write_file(context, folder, "passes.csv", f, um_forecast_csv));
  UM_TRY(write_file(context, folder, "curves.csv", f, um_forecast_curves));
  UM_TRY(write_file(context, folder, "passes.ics", f, um_forecast_ics));
  if (f->nuncertain > 0)
    UM_TRY(write_file(context, folder, "contributions.csv", f, um_forecast_contributions));
  if (pictures) UM_TRY(um_forecast_plot(context, f, um_core_folder_path(folder)));
  return um_forecast_page(context, f, folder);
}
