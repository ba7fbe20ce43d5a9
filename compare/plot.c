/* A picture per channel by gnuplot, from residuals.csv. The script is kept beside it. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/compare_impl.h"
#include "compare/series.h"
#include "orbit/time.h"
#include "output/output.h"

#define SCRIPT "plots.gp"

enum um_status um_compare_channel_file(struct um_context *context,
                                       const struct um_compare_channel *channel, char **out)
{
  UM_TRY(um_core_asprintf(context, out, "%s_%s", um_compare_quantity_name(channel->quantity),
                          channel->of));
  for (char *c = *out; *c != '\0'; c++)
    if (strchr("/\\:'\" ", *c) != NULL) *c = '_';
  return UM_OK;
}

/* A name inside a double-quoted string of gnuplot. */
static void put_name(FILE *f, const char *name)
{
  for (; *name != '\0'; name++) {
    if (strchr("\"\\@^_{}&~", *name) != NULL) fputs("\\\\", f);
    fputc(*name == '"' ? '\'' : *name, f);
  }
}

static double minutes(const struct um_compare_comparison *c, double t)
{
  return (t - c->run.trace->t_obs[0]) / 60.0;
}

/* Runs of umbra as dark, of penumbra as light boxes behind the curves, halfway to the neighbours.
 */
static void shade(const struct um_compare_comparison *c, FILE *f)
{
  const struct um_model_trace *t = c->run.trace;
  int object = 1;
  for (size_t k = 0, end; k < t->nobs; k = end) {
    for (end = k + 1; end < t->nobs && c->light[end] == c->light[k]; end++) {
    }
    if (c->light[k] == UM_SEGMENT_SUNLIT) continue;
    double from = k == 0 ? t->t_obs[0] : 0.5 * (t->t_obs[k - 1] + t->t_obs[k]);
    double to = end == t->nobs ? t->t_obs[end - 1] : 0.5 * (t->t_obs[end - 1] + t->t_obs[end]);
    fprintf(f,
            "set object %d rectangle from first %.6f, graph 0 to first %.6f, graph 1 fillcolor rgb "
            "'%s' fillstyle solid noborder behind\n",
            object++, minutes(c, from), minutes(c, to),
            c->light[k] == UM_SEGMENT_UMBRA ? "#d8dce6" : "#eceef3");
  }
}

static void head(const struct um_compare_comparison *c, FILE *f)
{
  const struct um_model_trace *t = c->run.trace;
  char start[32];
  um_orbit_time_format(t->t_obs[0], start);
  fprintf(f,
          "set terminal pngcairo size 1100,760 enhanced font 'Sans,11'\nset encoding utf8\n"
          "set datafile separator ','\nset grid linecolor rgb '#e4e4e4'\n"
          "t0 = strptime('%%Y-%%m-%%dT%%H:%%M:%%S', '%s')\n"
          "m(s) = (strptime('%%Y-%%m-%%dT%%H:%%M:%%S', s) - t0) / 60.0\n"
          "own(i) = strcol(2) eq q && strcol(3) eq o\n"
          "x(i) = own(i) ? m(strcol(i)) : NaN\ny(i) = own(i) ? column(i) : NaN\n"
          "s(i) = strcol(i) eq \"\" ? 0 : column(i)\nset xrange [%.6f:%.6f]\n"
          "set key outside right top\nset lmargin 13\n",
          start, minutes(c, t->t_obs[0]), fmax(minutes(c, t->t_obs[t->nobs - 1]), 1e-3));
  shade(c, f);
}

static void script_channel(const struct um_compare_comparison *c, size_t i, const char *name,
                           FILE *f)
{
  const struct um_compare_channel_comparison *channel = &c->channel[i];
  const struct um_compare_channel *of = &c->run.plan->measurements->channel[channel->channel];
  const char *quantity = um_compare_quantity_name(of->quantity);
  bool magnitude = of->quantity == UM_QUANTITY_MAGNITUDE_AB;
  char start[32];
  um_orbit_time_format(c->run.trace->t_obs[0], start);
  fprintf(f, "\nset output '%s.png'\nq = \"%s\"\no = \"", name, quantity);
  for (const char *at = of->of; *at != '\0'; at++) {
    if (*at == '"' || *at == '\\') fputc('\\', f);
    fputc(*at, f);
  }
  fputs("\"\nset multiplot layout 2,1 title \"", f);
  put_name(f, c->run.model->scenario->name);
  fputs(": ", f);
  put_name(f, quantity);
  fputc(' ', f);
  put_name(f, of->of);
  if (!isnan(channel->all.chi2_reduced))
    fprintf(f, ", reduced chi-square %.3g", channel->all.chi2_reduced);
  fprintf(
      f,
      "\"\nset size 1,0.6\nset origin 0,0.37\nset yrange [*:*]%s\nunset xlabel\nset ylabel "
      "\"[%s]\"\n"
      "plot 'residuals.csv' every ::1 using (x(1)):(y(4)):(s(6)) with yerrorbars pointtype 7 "
      "pointsize 0.5 linecolor rgb '#555555' title 'measured', '' every ::1 using (x(1)):(y(5)) "
      "with lines linewidth 2 linecolor rgb '#b3261e' title 'model'\n",
      magnitude ? " reverse" : "", um_compare_quantity_unit(of->quantity));
  fprintf(f,
          "set size 1,0.37\nset origin 0,0\nset yrange [*:*] noreverse\n"
          "set xlabel \"minutes after %s (grey: umbra, light grey: penumbra)\"\n"
          "set ylabel \"%s\"\n"
          "plot 0 with lines linecolor rgb '#888888' notitle, 'residuals.csv' every ::1 using "
          "(x(1)):(y(%d)) with points pointtype 7 pointsize 0.5 linecolor rgb '#1f4e9c' title "
          "'residual'\nunset multiplot\n",
          start, isnan(channel->all.chi2) ? "measured - model" : "(measured - model) / {/Symbol s}",
          isnan(channel->all.chi2) ? 7 : 8);
}

enum um_status um_compare_plot(struct um_context *context,
                               const struct um_compare_comparison *comparison, const char *folder)
{
  enum um_status status;
  char *path = NULL, *name = NULL;
  UM_TRY(um_core_asprintf(context, &path, "%s/" SCRIPT, folder));
  FILE *f = fopen(path, "w");
  if (f == NULL) {
    status = um_core_fail(context, UM_ERR_IO, "%s: %s", path, strerror(errno));
    goto done;
  }
  head(comparison, f);
  for (size_t i = 0; i < comparison->nchannel; i++) {
    const struct um_compare_measurements *m = comparison->run.plan->measurements;
    status = um_compare_channel_file(context, &m->channel[comparison->channel[i].channel], &name);
    if (status != UM_OK) break;
    script_channel(comparison, i, name, f);
    um_core_free(context, name);
    name = NULL;
  }
  if (comparison->nchannel == 0) status = UM_OK;
  enum um_status closed = um_core_file_close(context, SCRIPT, &f);
  if (status == UM_OK) status = closed;
  if (status == UM_OK) um_output_plot_script(context, folder, SCRIPT);
done:
  um_core_free(context, path);
  return status;
}
