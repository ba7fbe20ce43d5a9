/* satellite.png: pictures of several instants and bands side by side, drawn by gnuplot. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/plot/plot.h"
#include "output/output.h"

#define SCRIPT   "satellite.gp"
#define DECADES  1e-4 /* lower end of a logarithmic scale */
#define CONTRAST 30   /* brightest over faintest picture of a row that asks for one */

/* Pixels of the whole. */
#define LEFT   96
#define TOP    46
#define SIDE   290
#define GAP    12
#define SCALE  16  /* width of the colour bar */
#define RIGHT  124 /* colour bar and its numbers */
#define BOTTOM 52

/* Of a panel's side. */
#define MARGIN  0.04
#define COMPASS 0.10 /* an arrow across the line of sight */
#define CORNER  0.40 /* what the arrows and their names need */
#define SHORT   0.25 /* of an arrow: what is less points along the line of sight */
#define NEAR    0.8  /* cosine between arrows whose names would overlap */

/* ---- radiance ---- */

/* Radiance of the band, through its filter, of each spectrum of a picture [W/m^2/sr]. */
static enum um_status weigh(struct um_context *context, const struct um_optics_image *image,
                            size_t band, double (**out)[2])
{
  double *weight = NULL;
  UM_TRY(um_core_allocate(context, image->nbin, sizeof *weight, &weight));
  enum um_status status = um_core_allocate(context, image->nspectrum, sizeof **out, out);
  for (size_t b = image->first[band]; b < image->first[band + 1]; b++)
    weight[b] = image->transmission[b] * image->bin_width[b];
  if (status == UM_OK) um_optics_image_weigh(image, weight, *out);
  um_core_free(context, weight);
  return status;
}

/* Radiances of one picture as raw floats, the sky as NaN (drawn as nothing); the largest. */
static enum um_status write_pixels(struct um_context *context, const struct um_output_panel *panel,
                                   const char *path, double *largest)
{
  const struct um_optics_image *image = panel->image;
  double(*weighed)[2] = NULL;
  FILE *f = NULL;
  enum um_status status;
  UM_CHECK(weigh(context, image, panel->index, &weighed));
  UM_CHECK(um_core_file_create(context, path, &f));
  for (int y = 0; y < image->height; y++)
    for (int x = 0; x < image->width; x++) {
      float v = (float)um_optics_image_pixel(image, (const double(*)[2])weighed, x, y);
      *largest = fmax(*largest, v);
      if (!um_optics_image_covered(image, x, y)) v = NAN;
      fwrite(&v, sizeof v, 1, f);
    }
  status = um_core_file_close(context, path, &f);
done:
  um_core_free(context, weighed);
  return status;
}

static enum um_status write_raw(struct um_context *context, const struct um_output_panel *panel,
                                const char *folder, size_t index, double *largest)
{
  char *path = NULL;
  UM_TRY(um_core_asprintf(context, &path, "%s/panel%zu.raw", folder, index));
  enum um_status status = write_pixels(context, panel, path, largest);
  um_core_free(context, path);
  return status;
}

struct scale {
  double largest;  /* of all pixels of a row [W/m^2/sr] */
  double faintest; /* largest of the faintest picture that shows anything */
};

/* largest: of each picture of a row. */
static struct scale scale_of(const double *largest, size_t columns)
{
  struct scale s = {0.0, INFINITY};
  for (size_t c = 0; c < columns; c++) {
    s.largest = fmax(s.largest, largest[c]);
    if (largest[c] > 0.0) s.faintest = fmin(s.faintest, largest[c]);
  }
  return s;
}

/* ---- directions ---- */

struct direction {
  const char *name;
  double right, up, toward; /* unit vector in the picture, toward the observer out of it */
};

static struct direction direction_of(const struct um_environment_sample *s, struct um_vec3 v,
                                     const char *name)
{
  struct um_vec3 toward = s->to_observer, up = s->r; /* up is away from the Earth */
  up = um_vec3_unit(um_vec3_axpy(up, -um_vec3_dot(up, toward), toward));
  return (struct direction){name, um_vec3_dot(v, um_vec3_cross(up, toward)), um_vec3_dot(v, up),
                            um_vec3_dot(v, toward)};
}

/* Centre of the corner that shows least of the satellite, lower right where several do [panel]. */
static void emptiest_corner(const struct um_optics_image *image, double span, double out[2])
{
  size_t covered[4] = {0}, best = 0;
  for (int y = 0; y < image->height; y++)
    for (int x = 0; x < image->width; x++) {
      if (!um_optics_image_covered(image, x, y)) continue;
      double right = (x + 0.5 - 0.5 * image->width) * image->pixel_size / span;
      double up = (0.5 * image->height - y - 0.5) * image->pixel_size / span;
      if (fabs(right) < 0.5 - CORNER || fabs(up) < 0.5 - CORNER) continue;
      covered[(right < 0.0 ? 1 : 0) + (up > 0.0 ? 2 : 0)]++;
    }
  for (size_t i = 1; i < 4; i++)
    if (covered[i] < covered[best]) best = i;
  out[0] = best % 2 == 1 ? 0.5 * CORNER : 1.0 - 0.5 * CORNER;
  out[1] = best >= 2 ? 1.0 - 0.5 * CORNER : 0.5 * CORNER;
}

/* Whether an arrow before this one points almost the same way. */
static bool is_near(const struct direction *d, size_t i)
{
  for (size_t j = 0; j < i; j++)
    if (d[i].right * d[j].right + d[i].up * d[j].up >
        NEAR * hypot(d[i].right, d[i].up) * hypot(d[j].right, d[j].up))
      return true;
  return false;
}

/* A name about a place of the panel: it ends there, is centred or begins there. */
static void name(struct um_plot *plot, size_t label, const char *text, const char *colour,
                 double right, double up, int side)
{
  um_plot_add(plot, "set label %zu %s at graph %.4f,%.4f ", label, text, right, up);
  if (side == 0)
    um_plot_add(plot, "center ");
  else if (side < 0)
    um_plot_add(plot, "right ");
  else
    um_plot_add(plot, "left ");
  um_plot_add(plot, "font ',9' textcolor rgb %s front\n", colour);
}

/* Sun, north and nadir; one that is along the line of sight is named with the mark of an arrow seen
 * from its tip or its tail. */
static void compass(struct um_plot *plot, const struct um_output_panel *panel, double span)
{
  const struct um_environment_sample *s = panel->sample;
  bool dark = !(s->sunlit_fraction > UM_UMBRA_MOST);
  struct direction d[] = {direction_of(s, um_vec3_scale(um_vec3_unit(s->r), -1.0), "nadir"),
                          direction_of(s, s->pole, "N"),
                          direction_of(s, s->sun, dark ? "(Sun)" : "Sun")};
  static const char *const colour[] = {"#2f6f9f", "#333333", "#c27c00"};
  double at[2];
  int along = 0;
  emptiest_corner(panel->image, span, at);
  um_plot_add(plot, "unset arrow\n");
  for (size_t i = 0; i < sizeof d / sizeof d[0]; i++) {
    double length = hypot(d[i].right, d[i].up), far = COMPASS * length + 0.035;
    char text[24];
    if (length < SHORT) {
      snprintf(text, sizeof text, "%s %s", d[i].toward > 0.0 ? "⊙" : "⊗", d[i].name);
      name(plot, i + 1, text, colour[i], at[0] - 0.5 * CORNER + 0.02,
           at[1] - 0.5 * CORNER + 0.03 + 0.06 * along, 1);
      along++;
      continue;
    }
    um_plot_add(plot,
                "set arrow %zu from graph %.4f,%.4f rto graph %.4f,%.4f size graph 0.025,22 filled "
                "linewidth 1.4 linecolor rgb %s front\n",
                i + 1, at[0], at[1], COMPASS * d[i].right, COMPASS * d[i].up, colour[i]);
    int side = d[i].right < 0.0 ? -1 : 1;
    double aside = is_near(d, i) ? 0.03 * side : 0.0; /* beside the arrow's middle */
    if (aside != 0.0) far *= 0.5;
    if (fabs(d[i].right) < 0.3 * length && !is_near(d, i)) side = 0;
    name(plot, i + 1, d[i].name, colour[i], at[0] + far * d[i].right / length + aside,
         at[1] + far * d[i].up / length, side);
  }
}

/* ---- script ---- */

static void row(struct um_plot *plot, const struct um_output_panel *panels, const double *largest,
                size_t r, size_t rows, size_t columns, double span)
{
  const struct um_optics_band *band = panels[r * columns].band;
  struct scale s = scale_of(largest + r * columns, columns);
  bool log_scale = s.largest > CONTRAST * s.faintest;
  int top = TOP + (int)r * (SIDE + GAP), width = LEFT + (int)columns * (SIDE + GAP) + RIGHT;
  int height = TOP + (int)rows * (SIDE + GAP) + BOTTOM;
  char name[200];
  snprintf(name, sizeof name, "%.150s %g–%g µm", band->name, band->from * 1e6, band->to * 1e6);
  if (log_scale)
    um_plot_add(plot, "set logscale cb\nset format cb '10^{%%T}'\n");
  else
    um_plot_add(plot, "unset logscale cb\nset format cb '%%g'\n");
  um_plot_add(plot, "set cbrange [%.6g:%.6g]\n", log_scale ? DECADES * s.largest : 0.0,
              s.largest > 0.0 ? s.largest : 1.0);
  for (size_t c = 0; c < columns; c++) {
    const struct um_output_panel *panel = &panels[r * columns + c];
    int left = LEFT + (int)c * (SIDE + GAP);
    um_plot_panel(plot, left, top, left + SIDE, top + SIDE);
    if (r == 0)
      um_plot_add(plot, "set label 10 %s at graph 0.5,1.045 center font ',10'\n", panel->caption);
    else
      um_plot_add(plot, "unset label 10\n");
    um_plot_add(plot, c == 0 ? "set format y '%%g'\n" : "set format y ''\n");
    if (r + 1 == rows) um_plot_add(plot, "set format x '%%g'\nset xlabel '[m]'\n");
    um_plot_ylabel(plot, c == 0 ? name : "", c == 0 ? "[m]" : "");
    if (c + 1 == columns)
      um_plot_add(plot,
                  "set colorbox user origin screen %.5f,%.5f size screen %.5f,%.5f\n"
                  "set cblabel 'radiance [W/m^2/sr]' offset 1,0\n",
                  (left + SIDE + GAP) / (double)width, 1.0 - (top + SIDE) / (double)height,
                  SCALE / (double)width, SIDE / (double)height);
    else
      um_plot_add(plot, "unset colorbox\n");
    compass(plot, panel, span);
    um_plot_add(plot,
                "plot 'panel%zu.raw' binary array=(%d,%d) format='%%float' flipy dx=%.6g dy=%.6g "
                "center=(0,0) with image notitle\nunset label 1\nunset label 2\nunset label 3\n",
                r * columns + c, panel->image->width, panel->image->height,
                panel->image->pixel_size, panel->image->pixel_size);
  }
}

static void script(struct um_plot *plot, const struct um_output_panel *panels,
                   const double *largest, size_t rows, size_t columns)
{
  double span = 0.0; /* [m] */
  for (size_t i = 0; i < rows * columns; i++) {
    const struct um_optics_image *image = panels[i].image;
    span = fmax(span, fmax(image->width, image->height) * image->pixel_size);
  }
  span *= 1.0 + 2.0 * MARGIN;
  um_plot_picture(plot, "satellite", LEFT + (int)columns * (SIDE + GAP) + RIGHT,
                  TOP + (int)rows * (SIDE + GAP) + BOTTOM);
  um_plot_add(plot,
              "unset grid\nset xtics %g\nset ytics %g\nset xrange [%.6g:%.6g]\nset yrange "
              "[%.6g:%.6g]\nset format x ''\n"
              "set palette defined (0 '#000004', 0.15 '#2b0b57', 0.4 '#982766', 0.65 '#e65d2f', "
              "0.85 '#fcb519', 1 '#fcffa4')\n",
              um_plot_spacing(span), um_plot_spacing(span), -0.5 * span, 0.5 * span, -0.5 * span,
              0.5 * span);
  for (size_t r = 0; r < rows; r++) row(plot, panels, largest, r, rows, columns, span);
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
  struct um_plot *plot = NULL;
  double *largest = NULL; /* of each picture [W/m^2/sr] */
  UM_TRY(um_core_allocate(context, rows * columns, sizeof *largest, &largest));
  for (size_t i = 0; i < rows * columns; i++)
    UM_CHECK(write_raw(context, &panels[i], folder, i, &largest[i]));
  UM_CHECK(um_plot_create(context, folder, SCRIPT, &plot));
  script(plot, panels, largest, rows, columns);
  status = um_plot_draw(context, &plot);
done:
  um_core_free(context, largest);
  remove_raw(folder, rows * columns);
  return status;
}
