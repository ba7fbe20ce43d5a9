/* Kinds of export: a file of app/ and a line of app/export_list.def each. */
#ifndef UMBRA_APP_EXPORT_H
#define UMBRA_APP_EXPORT_H

#include "app/app.h"
#include "base/core/file.h"
#include "output/output.h"

struct um_app_export {
  const char *name;    /* as --as takes it */
  const char *summary; /* what is written, for help */
  const char *target;  /* "FILE.obj", "FOLDER": what -o names */
  um_app_command *run; /* options->out is set; it is checked and written whole here */
};

/* Makes a folder, "NAME-kind" where -o names none, of what `write` puts there of a run;
 * of_geometry: run->result is not wanted and stays NULL. Prints the number of observations. */
typedef enum um_status um_app_export_write(struct um_context *context,
                                           const struct um_output_run *run,
                                           struct um_core_folder *folder);
int um_app_export_run(struct um_context *context, const struct um_app_options *options,
                      const char *kind, bool of_geometry, um_app_export_write *write);

#define UM_EXPORT(name) extern const struct um_app_export um_app_export_##name;
#include "app/export_list.def"
#undef UM_EXPORT

#endif
