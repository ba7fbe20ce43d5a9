/* satellite.png: pictures of several instants and bands side by side, drawn by gnuplot. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "output/gnuplot_impl.h"
#include "output/output.h"

#define SCRIPT   "satellite.gp"
#define DECADES  1e-4 /* lower end of a logarithmic scale */
#define CONTRAST 30   /* brightest over faintest picture of a row that asks for one */

/* Radiance over the band [W/m^2/sr]. */
static float pixel_radiance(const struct um_optics_image *image, size_t pixel)
{
  double sum = 0.0;
  for (size_t b = 0; b < image->nbin; b++)
    sum += image->radiance[pixel * image->nbin + b] * image->bin_width[b];
  return (float)sum;
}

struct scale {
  double largest;  /* of all pixels of a row [W/m^2/sr] */
  double faintest; /* largest of the faintest picture that shows anything */
};

static struct scale scale_of(const struct um_output_panel *panels, size_t columns)
{
  struct scale s = {0.0, INFINITY};
  for (size_t c = 0; c < columns; c++) {
    const struct um_optics_image *image = panels[c].image;
    double own = 0.0;
    for (size_t i = 0; i < (size_t)image->width * (size_t)image->height; i++)
      own = fmax(own, pixel_radiance(image, i));
    s.largest = fmax(s.largest, own);
    if (own > 0.0) s.faintest = fmin(s.faintest, own);
  }
  return s;
}

/* Radiances of one picture as raw floats, the sky as NaN (drawn as nothing). */
static enum um_status write_raw(struct um_context *context, const struct um_optics_image *image,
                                const char *folder, size_t index)
{
  char *path = NULL;
  UM_TRY(um_core_asprintf(context, &path, "%s/panel%zu.raw", folder, index));
  FILE *f = fopen(path, "wb");
  enum um_status status = UM_OK;
  if (f == NULL) {
    status = um_core_fail(context, UM_ERR_IO, "%s: %s", path, strerror(errno));
  } else {
    for (size_t i = 0; i < (size_t)image->width * (size_t)image->height; i++) {
      float v = image->surface[i] == UM_GEOMETRY_NONE ? NAN : pixel_radiance(image, i);
      fwrite(&v, sizeof v, 1, f);
    }
    status = um_core_file_close(context, path, &f);
  }
  um_core_free(context, path);
  return status;
}

static void script_row(FILE *f, const struct um_output_panel *panels, size_t columns, size_t first)
{
  struct scale s = scale_of(panels, columns);
  bool log_scale = s.largest > CONTRAST * s.faintest;
  fprintf(f, "%s logscale cb\n", log_scale ? "set" : "unset");
  fprintf(f, "set cbrange [%.6g:%.6g]\n", log_scale ? DECADES * s.largest : 0.0,
          s.largest > 0.0 ? s.largest : 1.0);
  for (size_t c = 0; c < columns; c++) {
    const struct um_optics_image *image = panels[c].image;
    fprintf(f,
            "set title '%s  %s'\nset cblabel '%s radiance [W/m^2/sr]'\n"
            "plot 'panel%zu.raw' binary array=(%d,%d) format='%%float' flipy dx=%.6g dy=%.6g with "
            "image notitle\n",
            panels[c].band, panels[c].caption, panels[c].band, first + c, image->width,
            image->height, image->pixel_size, image->pixel_size);
  }
}

static void remove_raw(const char *folder, size_t n)
{
  char path[4096];
  for (size_t i = 0; i < n; i++) {
    snprintf(path, sizeof path, "%s/panel%zu.raw", folder, i);
    (void)remove(path);
  }
  snprintf(path, sizeof path, "%s/" SCRIPT, folder);
  (void)remove(path);
}

enum um_status um_output_plot_panels(struct um_context *context,
                                     const struct um_output_panel *panels, size_t rows,
                                     size_t columns, const char *folder)
{
  enum um_status status;
  char *path = NULL;
  for (size_t i = 0; i < rows * columns; i++)
    UM_TRY(write_raw(context, panels[i].image, folder, i));
  UM_TRY(um_core_asprintf(context, &path, "%s/" SCRIPT, folder));
  FILE *f = fopen(path, "w");
  if (f == NULL) {
    status = um_core_fail(context, UM_ERR_IO, "%s: %s", path, strerror(errno));
    goto done;
  }
  fprintf(f,
          "set terminal pngcairo size %zu,%zu font 'Sans,10'\nset output 'satellite.png'\n"
          "set palette defined (0 '#000004', 0.15 '#2b0b57', 0.4 '#982766', 0.65 '#e65d2f', 0.85 "
          "'#fcb519', 1 '#fcffa4')\nset size ratio -1\nset xlabel '[m]' offset 0,0.5\nunset "
          "ylabel\nset autoscale xfix\nset autoscale yfix\n"
          "set format cb '%%.1e'\nset multiplot layout %zu,%zu\n",
          460 * columns, 400 * rows, rows, columns);
  for (size_t r = 0; r < rows; r++) script_row(f, panels + r * columns, columns, r * columns);
  fputs("unset multiplot\n", f);
  UM_CHECK(um_core_file_close(context, SCRIPT, &f));
  um_output_gnuplot_run(context, folder, SCRIPT);
done:
  remove_raw(folder, rows * columns);
  um_core_free(context, path);
  return status;
}
