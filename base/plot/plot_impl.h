/* Private to base/plot/. */
#ifndef UMBRA_PLOT_PLOT_IMPL_H
#define UMBRA_PLOT_PLOT_IMPL_H

#include <stdbool.h>
#include <stdio.h>

#include "base/plot/plot.h"

struct um_plot {
  FILE *file;
  char *folder, *script, *path;
  int width, height; /* of the picture at hand [pixels] */
  int objects;       /* boxes of it */
  bool titled;       /* the title is drawn with the next panel */
  int panels;        /* begun */
};

/* Run gnuplot with arguments (NULL-ended, its name first) in a folder, within limits of time and
 * memory; what it says stays in gnuplot.log there when it fails. That there are no pictures is
 * logged and no error. `script`: in messages. UM_ERR_CANCELLED: a stop was asked for.
 * UM_ERR_MEMORY. */
enum um_status um_plot_child(struct um_context *context, const char *folder, const char *script,
                             const char *const *arguments);

#endif
