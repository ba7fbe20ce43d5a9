/* Pictures of a finished folder by gnuplot, from the CSV files that lie in it. The script is kept
 * beside them, so that a user can change a picture without computing again. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "orbit/time.h"
#include "output/gnuplot_impl.h"
#include "output/output.h"

#define PEAK_CONTRAST 5.0 /* highest over mean in sunlight that asks for a logarithmic axis */
#define LOG_FLOOR     1e-5

/* Minutes from the first observation, the abscissa of every picture. */
static double minutes(const struct um_output_run *run, double t)
{
  return (t - run->trace->t_obs[0]) / 60.0;
}

/* A name with the underscores gnuplot would take for subscripts replaced. */
static void print_title(FILE *f, const char *name)
{
  for (; *name != '\0'; name++) fputc(*name == '_' ? ' ' : *name == '"' ? '\'' : *name, f);
}

/* Intervals of zero sunlight as grey boxes behind the curves. */
static void shade(const struct um_output_run *run, FILE *f)
{
  const struct um_model_trace *t = run->trace;
  int object = 1;
  for (size_t k = 0; k < t->nobs; k++) {
    if (t->sunlit[k] > 0.0) continue;
    size_t end = k;
    while (end + 1 < t->nobs && !(t->sunlit[end + 1] > 0.0)) end++;
    fprintf(f,
            "set object %d rectangle from first %.6f, graph 0 to first %.6f, graph 1 fillcolor rgb "
            "'#d8dce6' fillstyle solid noborder behind\n",
            object++, minutes(run, t->t_obs[k]), minutes(run, t->t_obs[end]));
    k = end;
  }
}

static void head(const struct um_output_run *run, FILE *f, const char *picture, int height)
{
  char start[32];
  um_orbit_time_format(run->trace->t_obs[0], start);
  fprintf(f,
          "set terminal pngcairo size 1100,%d enhanced font 'Sans,11'\nset output '%s'\n"
          "set datafile separator ','\nset encoding utf8\nset grid linecolor rgb '#e4e4e4'\n"
          "set timefmt '%%Y-%%m-%%dT%%H:%%M:%%S'\nt0 = strptime('%%Y-%%m-%%dT%%H:%%M:%%S', '%s')\n"
          "m(s) = (strptime('%%Y-%%m-%%dT%%H:%%M:%%S', s) - t0) / 60.0\n"
          "set xrange [0:%.6f]\n",
          height, picture, start,
          fmax(minutes(run, run->trace->t_obs[run->trace->nobs - 1]), 1e-3));
}

/* Specular peaks outshine the rest by orders of magnitude; such a band gets a logarithmic axis,
 * five decades down from its maximum. */
static void ordinate(const struct um_output_run *run, FILE *f, size_t band)
{
  const struct um_model_result *r = run->result;
  double largest = 0.0, lit = 0.0;
  size_t n = 0;
  for (size_t k = 0; k < r->nobs; k++) {
    double total = um_model_result_intensity(r, k, band, -1);
    largest = fmax(largest, total);
    if (!(run->trace->sunlit[k] > 0.0)) continue;
    lit += total;
    n++;
  }
  if (n > 0 && largest > PEAK_CONTRAST * lit / (double)n)
    fprintf(f, "set logscale y\nset yrange [%.3g:%.3g]\nset format y '10^{%%T}'\n",
            LOG_FLOOR * largest, 2.0 * largest);
  else
    fputs("unset logscale y\nset yrange [0:*]\nset format y '%g'\n", f);
}

/* Columns of lightcurve.csv: eight before the bands, then nine per band. */
static void script_lightcurve(const struct um_output_run *run, FILE *f)
{
  static const char *const colour[] = {"#1f4e9c", "#b3261e", "#3a7d34", "#7b3fa0"};
  char start[32];
  size_t n = run->model->nband;
  head(run, f, "lightcurve.png", 300 * (int)n + 60);
  shade(run, f);
  um_orbit_time_format(run->trace->t_obs[0], start);
  fprintf(f, "set multiplot layout %zu,1 title \"", n);
  print_title(f, run->model->scenario->name);
  fputs("\"\nset lmargin 13\nset key outside right top\n", f);
  for (size_t b = 0; b < n; b++) {
    const struct um_optics_band *band = &run->model->band[b];
    size_t first = 9 + 9 * b;
    fprintf(f, "set ylabel \"");
    print_title(f, band->name);
    fprintf(f, " %g-%g um\\nradiant intensity [W/sr]\"\n", band->from * 1e6, band->to * 1e6);
    ordinate(run, f, b);
    if (b + 1 == n)
      fprintf(f, "set xlabel \"minutes after %s UTC (grey: no sunlight on the satellite)\"\n",
              start);
    fprintf(f,
            "plot 'lightcurve.csv' every ::1 using (m(strcol(1))):%zu with lines linewidth 2.4 "
            "linecolor rgb '%s' title 'total', '' every ::1 using (m(strcol(1))):%zu with lines "
            "linewidth 1.2 dashtype 2 linecolor rgb '#e69f00' title 'Sun', '' every ::1 using "
            "(m(strcol(1))):%zu with lines "
            "linecolor rgb '#009e73' title 'Earth', '' every ::1 using (m(strcol(1))):%zu with "
            "lines linecolor rgb '#888888' title 'emitted'\n",
            first, colour[b % 4], first + 1, first + 2, first + 3);
  }
  fputs("unset multiplot\nunset object\nset lmargin\nset key default\nunset logscale y\n"
        "set yrange [*:*]\nset format y "
        "'%g'\n",
        f);
}

static void script_temperatures(const struct um_output_run *run, FILE *f)
{
  head(run, f, "temperatures.png", 560);
  shade(run, f);
  fputs("set title \"", f);
  print_title(f, run->model->scenario->name);
  fputs(": mean temperatures (dashed: lowest and highest of each material)\"\n"
        "set ylabel 'temperature [K]'\nset xlabel 'minutes after the first observation'\n"
        "set key outside right top\nplot ",
        f);
  bool first = true;
  int style = 1;
  for (size_t p = 0; p < run->result->nplace; p++) {
    const char *name = run->result->place[p].name;
    bool material = strncmp(name, "material:", 9) == 0;
    const char *dot = strchr(name, '.');
    bool interior = dot != NULL && strcmp(dot, ".interior") == 0;
    if (!material && !interior) continue;
    fprintf(f,
            "%s'temperatures.csv' every ::1 using (m(strcol(1))):%zu with lines linewidth 1.8 "
            "linetype %d title \"",
            first ? "" : ", ", 2 + 3 * p, style);
    print_title(f, material ? name + 9 : name);
    fputc('"', f);
    for (size_t k = 1; material && k < 3; k++)
      fprintf(
          f,
          ", '' every ::1 using (m(strcol(1))):%zu with lines linewidth 0.6 dashtype 2 linetype "
          "%d notitle",
          2 + 3 * p + k, style);
    first = false;
    style++;
  }
  fputs("\n", f);
}

enum um_status um_output_plot_run(struct um_context *context, const char *folder,
                                  const struct um_output_run *run)
{
  enum um_status status;
  char *path = NULL;
  UM_TRY(um_core_asprintf(context, &path, "%s/plots.gp", folder));
  FILE *f = fopen(path, "w");
  if (f == NULL) {
    status = um_core_fail(context, UM_ERR_IO, "%s: %s", path, strerror(errno));
    goto done;
  }
  if (run->model->has_observer) script_lightcurve(run, f);
  script_temperatures(run, f);
  UM_CHECK(um_core_file_close(context, "plots.gp", &f));
  um_output_gnuplot_run(context, folder, "plots.gp");
done:
  um_core_free(context, path);
  return status;
}
