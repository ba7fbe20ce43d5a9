/* The reflectance of material records over wavelength, as tables and pictures. */
#include "output/spectrum_plot.h"

#include <math.h>

#include "base/core/csv.h"
#include "base/plot/plot.h"

#define SCRIPT  "spectra.gp"
#define FROM_UM 0.25
#define TO_UM   25.0
#define STEPS   1500 /* even in the logarithm; fringes of thin films are broader */

/* Pixels. */
#define WIDTH  900
#define HEIGHT 420
#define LEFT   80
#define RIGHT  880
#define TOP    92
#define BOTTOM 364

static enum um_status write_table(struct um_context *context,
                                  const struct um_materials_record *record,
                                  struct um_core_folder *folder)
{
  enum um_status status;
  char *name = NULL;
  FILE *file = NULL;
  UM_CHECK(um_core_asprintf(context, &name, "%s.csv", um_materials_name(record)));
  UM_CHECK(um_core_folder_open(context, folder, name, &file));
  fputs("wavelength_um,reflectance_normal,reflectance_hemispherical\n", file);
  for (int i = 0; i <= STEPS; i++) {
    double um = FROM_UM * pow(TO_UM / FROM_UM, (double)i / STEPS);
    fprintf(file, "%.5g,%.4f,%.4f\n", um,
            1.0 - um_materials_emissivity(record, NULL, um * 1e-6, 1.0),
            um_materials_hemispherical_reflectance(record, NULL, um * 1e-6));
  }
  status = um_core_file_close(context, name, &file);
done:
  um_core_free(context, name);
  return status;
}

/* Grey where nothing was measured. */
static void shade(struct um_plot *plot, double from_um, double to_um)
{
  if (!(from_um < to_um)) return;
  um_plot_add(plot,
              "set object rectangle from first %.6g,graph 0 to first %.6g,graph 1 behind "
              "fillcolor rgb '#e4e4e4' fillstyle solid noborder\n",
              from_um, to_um);
}

static void draw_record(struct um_plot *plot, const struct um_materials_record *record)
{
  struct um_materials_measured_range range = um_materials_measured_range(record);
  bool measured = !isnan(range.from);
  char table[256], words[80] = "shaded: no measured constants or reflectance";
  snprintf(table, sizeof table, "%.200s.csv", um_materials_name(record));
  if (measured)
    snprintf(words, sizeof words, "measured from %.3g to %.3g µm; shaded: constant outside",
             range.from * 1e6, range.to * 1e6);
  um_plot_picture(plot, um_materials_name(record), WIDTH, HEIGHT);
  um_plot_title(plot, um_materials_name(record), words);
  um_plot_panel(plot, LEFT, TOP, RIGHT, BOTTOM);
  shade(plot, FROM_UM, measured ? fmin(range.from * 1e6, TO_UM) : TO_UM);
  if (measured) shade(plot, range.to * 1e6, TO_UM);
  um_plot_add(plot,
              "set logscale x\nset xrange [%g:%g]\nset yrange [0:1]\nset format x '%%g'\nset xtics "
              "(0.25, 0.5, 1, 2, 4, 8, 15, 25)\nset xlabel 'wavelength [µm]'\n",
              FROM_UM, TO_UM);
  um_plot_ylabel(plot, "", "reflectance");
  um_plot_add(plot,
              "plot %s every ::1 using 1:3 with lines linewidth 1.3 linecolor rgb '#e69f00' title "
              "'of light from all sides', '' every ::1 using 1:2 with lines linewidth 2 linecolor "
              "rgb '#1f4e9c' title 'normal incidence'\n",
              table);
}

enum um_status um_output_spectra(struct um_context *context,
                                 const struct um_materials_record *const *record, size_t count,
                                 bool pictures, struct um_core_folder *folder)
{
  struct um_plot *plot = NULL;
  for (size_t i = 0; i < count; i++) UM_TRY(write_table(context, record[i], folder));
  if (!pictures) return UM_OK;
  UM_TRY(um_plot_create(context, um_core_folder_path(folder), SCRIPT, &plot));
  for (size_t i = 0; i < count; i++) draw_record(plot, record[i]);
  return um_plot_draw(context, &plot);
}
