/* A frame drawn by gnuplot from raw numbers, which go when it is drawn. */
#include "output/frame_plot.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/core/file.h"
#include "base/core/order.h"
#include "base/plot/plot.h"

#define SCRIPT  "frame.gp"
#define RAW     "frame.raw"
#define PICTURE "frame"

/* Pixels of the picture. */
#define SIDE   560 /* the longer side of the frame */
#define LEFT   80
#define TOP    64
#define BOTTOM 54
#define RIGHT  130
#define SCALE  16 /* width of the colour bar */
#define LEAST  80 /* of the shorter side */

/* Half of the range from the 16th to the 84th hundredth: sigma of the sky's pixels. */
static enum um_status noise_of(struct um_context *context, const struct um_output_frame *f,
                               double *sigma, double *largest)
{
  size_t n = (size_t)f->width * (size_t)f->height;
  double *v;
  UM_TRY(um_core_allocate(context, n, sizeof *v, &v));
  for (size_t i = 0; i < n; i++) v[i] = (double)f->counts[i];
  qsort(v, n, sizeof *v, um_core_order_double);
  *sigma = 0.5 * (v[(size_t)(0.84 * (double)(n - 1))] - v[(size_t)(0.16 * (double)(n - 1))]);
  *largest = v[n - 1];
  um_core_free(context, v);
  return UM_OK;
}

static enum um_status write_raw(struct um_context *context, const struct um_output_frame *f,
                                const char *path)
{
  FILE *file;
  UM_TRY(um_core_file_create(context, path, &file));
  fwrite(f->counts, sizeof *f->counts, (size_t)f->width * (size_t)f->height, file);
  return um_core_file_close(context, path, &file);
}

static void script(struct um_plot *plot, const struct um_output_frame *f, double sigma,
                   double largest)
{
  double unit = (double)SIDE / (f->width > f->height ? f->width : f->height);
  int width = (int)fmax(LEAST, unit * f->width), height = (int)fmax(LEAST, unit * f->height);
  int all = LEFT + width + RIGHT, tall = TOP + height + BOTTOM;
  double above = fmax(largest - f->sky, 1e-30);
  double soft = fmax(sigma, 1e-4 * above); /* linear below, logarithmic above */
  um_plot_picture(plot, PICTURE, all, tall);
  um_plot_title(plot, f->title, f->below);
  um_plot_panel(plot, LEFT, TOP, LEFT + width, TOP + height);
  um_plot_add(plot,
              "unset grid\nunset key\nset xrange [0.5:%.1f]\nset yrange [0.5:%.1f]\nset format x "
              "'%%g'\nset format y '%%g'\nset xlabel 'pixel'\nset xtics %g\nset ytics %g\n"
              "set palette gray\n",
              f->width + 0.5, f->height + 0.5, um_plot_spacing(f->width),
              um_plot_spacing(f->height));
  um_plot_ylabel(plot, "", "pixel");
  um_plot_add(plot, "s(v) = asinh((v - %.9g)/%.9g)\nset cbrange [s(%.9g):s(%.9g)]\n", f->sky, soft,
              f->sky - 2.0 * sigma, largest);
  um_plot_add(plot,
              "set colorbox user origin screen %.5f,%.5f size screen %.5f,%.5f\nset cblabel "
              "'counts of a pixel' offset 2,0\n",
              (LEFT + width + 14.0) / all, (double)BOTTOM / tall, (double)SCALE / all,
              (double)height / tall);
  for (int i = 0; i <= 4; i++) { /* evenly spread in the stretch */
    double v = f->sky + soft * sinh(asinh(above / soft) * i / 4.0);
    char number[32];
    snprintf(number, sizeof number, "%.3g", v);
    um_plot_add(plot, i == 0 ? "set cbtics (%s s(%.9g))\n" : "set cbtics add (%s s(%.9g))\n",
                number, v);
  }
  um_plot_add(plot, "unset arrow\n");
  for (size_t i = 0; i < f->nstar; i++) {
    char words[32];
    snprintf(words, sizeof words, "%.2f mag", f->star[i].magnitude);
    um_plot_add(plot,
                f->star[i].x > 0.5 * f->width ? "set label %zu %s at first %.3f,%.3f right offset "
                                                "-1.2,1 font ',9' textcolor rgb '#e69f00' front\n"
                                              : "set label %zu %s at first %.3f,%.3f left offset "
                                                "1.2,1 font ',9' textcolor rgb '#e69f00' front\n",
                10 + i, words, f->star[i].x, f->star[i].y);
  }
  um_plot_add(plot,
              "plot '" RAW "' binary array=(%d,%d) format='%%float' flipy dx=1 dy=1 "
              "origin=(1,1) using (s($1)) with image notitle\n",
              f->width, f->height);
}

/* Pictures lie in a folder of their own until one takes its name: what the script and its numbers
 * are called can then neither meet a user's files nor be a user's word. */
static enum um_status draw_in(struct um_context *context, const struct um_output_frame *f,
                              const char *folder)
{
  enum um_status status;
  struct um_plot *plot = NULL;
  char *raw = NULL;
  double sigma, largest;
  UM_CHECK(noise_of(context, f, &sigma, &largest));
  UM_CHECK(um_core_asprintf(context, &raw, "%s/" RAW, folder));
  UM_CHECK(write_raw(context, f, raw));
  UM_CHECK(um_plot_create(context, folder, SCRIPT, &plot));
  script(plot, f, sigma, largest);
  status = um_plot_draw(context, &plot);
done:
  um_core_free(context, raw);
  return status;
}

enum um_status um_output_plot_frame(struct um_context *context, const struct um_output_frame *frame,
                                    const char *path)
{
  static const char *const left[] = {RAW, SCRIPT, PICTURE ".png", PICTURE ".svg", PICTURE ".pdf"};
  enum um_status status = UM_OK;
  char *folder = NULL, *made = NULL;
  UM_TRY(um_core_file_partial(context, path, &folder));
  if (mkdir(folder, 0700) != 0)
    status = um_core_fail(context, UM_ERR_IO, "%s: %s", folder, strerror(errno));
  if (status == UM_OK) status = draw_in(context, frame, folder);
  if (status == UM_OK) status = um_core_asprintf(context, &made, "%s/" PICTURE ".png", folder);
  if (status == UM_OK) (void)rename(made, path); /* without gnuplot there is none */
  um_core_free(context, made);
  for (size_t i = 0; i < sizeof left / sizeof left[0]; i++) {
    char *file = NULL;
    if (um_core_asprintf(context, &file, "%s/%s", folder, left[i]) == UM_OK) (void)remove(file);
    um_core_free(context, file);
  }
  (void)rmdir(folder);
  um_core_free(context, folder);
  return status;
}
