/* A script from its first line to the pictures. */
#include "base/plot/plot.h"

#include <math.h>
#include <string.h>

#include "base/core/file.h"
#include "base/plot/plot_impl.h"

#define NAME_MAX_BYTES 150  /* of a picture's name */
#define RESOLUTION     96.0 /* pixels to the inch */
#define FINE           1.5  /* dots of a PNG to the pixel */

/* ---- life ---- */

enum um_status um_plot_create(struct um_context *context, const char *folder, const char *script,
                              struct um_plot **out)
{
  enum um_status status;
  struct um_plot *plot = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *plot, &plot));
  UM_CHECK(um_core_strdup(context, folder, &plot->folder));
  UM_CHECK(um_core_strdup(context, script, &plot->script));
  UM_CHECK(um_core_asprintf(context, &plot->path, "%s/%s", folder, script));
  UM_CHECK(um_core_file_create(context, plot->path, &plot->file));
  fputs("# Pictures by gnuplot from the files beside this one. kind: png, svg or pdf, as in\n"
        "#   gnuplot -e \"kind='pdf'\" FILE\n"
        "if (!exists('kind')) kind = 'png'\n"
        "set encoding utf8\n",
        plot->file);
  *out = plot;
  plot = NULL;
done:
  um_plot_destroy(context, &plot);
  return status;
}

void um_plot_destroy(struct um_context *context, struct um_plot **plot)
{
  if (plot == NULL || *plot == NULL) return;
  if ((*plot)->file != NULL) fclose((*plot)->file);
  UM_FREE(context, (*plot)->folder, (*plot)->script, (*plot)->path, *plot);
  *plot = NULL;
}

static enum um_status draw(struct um_context *context, const struct um_plot *plot)
{
  char *kinds = NULL;
  const char *script = plot->script; /* a plain name of ours */
  UM_TRY(um_core_asprintf(context, &kinds,
                          "kind = 'png'; load '%s'; kind = 'svg'; load '%s'; kind = 'pdf'; load "
                          "'%s'",
                          script, script, script));
  const char *arguments[] = {"gnuplot", "-d", "-e", kinds, NULL};
  enum um_status status = um_plot_child(context, plot->folder, script, arguments);
  um_core_free(context, kinds);
  return status;
}

enum um_status um_plot_draw(struct um_context *context, struct um_plot **plot)
{
  fputs("unset multiplot\nset output\n", (*plot)->file);
  enum um_status status = um_core_file_close(context, (*plot)->path, &(*plot)->file);
  if (status == UM_OK) status = draw(context, *plot);
  um_plot_destroy(context, plot);
  return status;
}

/* ---- pictures ---- */

/* Nothing that a shell, a path or gnuplot's own `set output '| command'` would know. */
static void file_name(const char *name, char out[NAME_MAX_BYTES + 1])
{
  static const char kept[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-+";
  size_t n = 0;
  for (; name[n] != '\0' && n < NAME_MAX_BYTES; n++) {
    bool ascii = (unsigned char)name[n] < 0x80;
    out[n] = name[n];
    if (ascii && strchr(kept, name[n]) == NULL) out[n] = '_';
    if (n == 0 && strchr(".-", name[n]) != NULL) out[n] = '_';
  }
  while (n > 0 && name[n] != '\0' && ((unsigned char)out[n - 1] & 0xc0) == 0x80) n--;
  if (n > 0 && name[n] != '\0' && (unsigned char)out[n - 1] >= 0xc0) n--;
  if (n == 0) out[n++] = '_';
  out[n] = '\0';
}

static void terminals(struct um_plot *plot, int width, int height)
{
  um_plot_add(plot,
              "if (kind eq 'png') set terminal pngcairo size %.0f,%.0f enhanced font 'Sans,11' "
              "fontscale %g linewidth %g pointscale %g\n"
              "if (kind eq 'svg') set terminal svg size %d,%d enhanced font 'Sans,11' linewidth 1 "
              "background '#ffffff'\n"
              "if (kind eq 'pdf') set terminal pdfcairo size %.4fin,%.4fin enhanced color font "
              "'Sans,11' fontscale 0.75 linewidth 1.6 pointscale 0.6\n",
              FINE * width, FINE * height, FINE, FINE, FINE, width, height, width / RESOLUTION,
              height / RESOLUTION);
}

void um_plot_picture(struct um_plot *plot, const char *name, int width, int height)
{
  char file[NAME_MAX_BYTES + 1];
  file_name(name, file);
  plot->width = width;
  plot->height = height;
  plot->objects = 0;
  plot->panels = 0;
  plot->titled = false;
  um_plot_add(plot, "\nunset multiplot\nreset\n");
  terminals(plot, width, height);
  um_plot_add(
      plot,
      "set output %s.'.'.kind\nset datafile separator ','\nset minussign\n"
      "set border linewidth 0.8 front\nset xtics in scale 0.7,0.4 mirror\n"
      "set ytics in scale 0.7,0.4 mirror\nset tics front\nset errorbars 0\nset pointintervalbox 0\n"
      "set grid linetype 1 linewidth 0.5 linecolor '#dddddd' back\n"
      "set key at graph 1,1 right bottom horizontal samplen 2.2 width 1 height 0.4 maxrows 1\n"
      "set linetype 1 linecolor '#1f4e9c'\nset linetype 2 linecolor '#c2410c'\n"
      "set linetype 3 linecolor '#2f855a'\nset linetype 4 linecolor '#7b3fa0'\n"
      "set linetype 5 linecolor '#b7791f'\nset linetype 6 linecolor '#0e7490'\n"
      "set linetype 7 linecolor '#be185d'\nset linetype 8 linecolor '#4a5568'\n"
      "set linetype cycle 8\nset multiplot\n",
      file);
}

void um_plot_title(struct um_plot *plot, const char *title, const char *below)
{
  um_plot_add(plot, "set label 901 %s at screen %.4f,%.4f left font 'Sans:Bold,12' noenhanced\n",
              title, 18.0 / plot->width, 1.0 - 20.0 / plot->height);
  um_plot_add(plot, "set label 902 %s at screen %.4f,%.4f left noenhanced\n", below,
              18.0 / plot->width, 1.0 - 42.0 / plot->height);
  plot->titled = true;
}

void um_plot_panel(struct um_plot *plot, int left, int top, int right, int bottom)
{
  if (plot->panels++ > 0 && plot->titled) {
    um_plot_add(plot, "unset label 901\nunset label 902\n");
    plot->titled = false;
  }
  um_plot_add(plot,
              "set lmargin at screen %.5f\nset rmargin at screen %.5f\nset tmargin at screen "
              "%.5f\nset bmargin at screen %.5f\n",
              (double)left / plot->width, (double)right / plot->width,
              1.0 - (double)top / plot->height, 1.0 - (double)bottom / plot->height);
}

void um_plot_ylabel(struct um_plot *plot, const char *name, const char *words)
{
  bool two = name[0] != '\0' && words[0] != '\0';
  um_plot_add(plot, "set label 903 %s at screen %.5f, graph 0.5 center rotate noenhanced\n", name,
              (two ? 16.0 : 26.0) / plot->width);
  um_plot_add(plot, "set label 904 %s at screen %.5f, graph 0.5 center rotate\n", words,
              (two ? 38.0 : 26.0) / plot->width);
}

void um_plot_xnumbers(struct um_plot *plot, bool shown)
{
  if (shown)
    um_plot_add(plot, "set format x '%%g'\n");
  else
    um_plot_add(plot, "set format x ''\nunset xlabel\n");
}

double um_plot_spacing(double length)
{
  if (!(length > 0.0) || !isfinite(length)) return 1.0;
  double power = pow(10.0, floor(log10(length / 4.0))), lead = length / 4.0 / power;
  return power * (lead < 1.5 ? 1.0 : lead < 3.5 ? 2.0 : lead < 7.5 ? 5.0 : 10.0);
}

void um_plot_unit(const char *unit, char out[80])
{
  size_t n = 0;
  for (const char *at = unit; *at != '\0' && n + 3 < 80; at++) {
    bool raised = at[0] == '^' && (at[1] == '2' || at[1] == '3');
    if (raised) {
      memcpy(out + n, at[1] == '2' ? "²" : "³", 2);
      n += 2;
      at++;
    } else {
      out[n++] = *at;
    }
  }
  out[n] = '\0';
}

double um_plot_power(double largest, const char *unit, char out[80])
{
  if (!(largest > 0.0) || !isfinite(largest) || (largest >= 0.05 && largest < 2e4)) {
    snprintf(out, 80, "%s", unit);
    return 1.0;
  }
  double power = floor(log10(largest));
  snprintf(out, 80, "10^{%s%.0f} %s", power < 0.0 ? "−" : "", fabs(power), unit);
  return pow(10.0, power);
}
