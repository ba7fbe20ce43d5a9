/* gnuplot as a child process, private to the folder. */
#ifndef UMBRA_OUTPUT_GNUPLOT_IMPL_H
#define UMBRA_OUTPUT_GNUPLOT_IMPL_H

#include "core/context.h"

/* Run a script in a folder. What goes wrong is a logged warning: pictures are not results. */
void um_output_gnuplot_run(struct um_context *context, const char *folder, const char *script);

#endif
