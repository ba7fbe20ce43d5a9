/* Kinds of export: a file of app/ and a line of app/export_list.def each. */
#ifndef UMBRA_APP_EXPORT_H
#define UMBRA_APP_EXPORT_H

#include "app/app.h"

struct um_app_export {
  const char *name;    /* as --as takes it */
  const char *summary; /* what is written, for help */
  const char *target;  /* "FILE.obj", "FOLDER": what -o names */
  um_app_command *run; /* options->out is set; it is checked and written whole here */
};

#define UM_EXPORT(name) extern const struct um_app_export um_app_export_##name;
#include "app/export_list.def"
#undef UM_EXPORT

#endif
