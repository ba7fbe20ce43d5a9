/* A picture per channel by gnuplot, from residuals.csv. The script is kept beside it. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/compare_impl.h"
#include "compare/figures.h"
#include "compare/gnuplot.h"
#include "output/output.h"

#define SCRIPT "plots.gp"

static void script_channel(const struct um_compare_comparison *c,
                           const struct um_compare_gnuplot_axis *axis, size_t i, const char *name,
                           FILE *f)
{
  const struct um_compare_channel_comparison *channel = &c->channel[i];
  const struct um_compare_channel *of = &c->run.plan->measurements->channel[channel->channel];
  um_compare_gnuplot_channel(f, name, of);
  fputs("set multiplot layout 2,1 title \"", f);
  um_compare_gnuplot_name(f, c->run.model->scenario->name);
  fputs(": ", f);
  um_compare_gnuplot_name(f, um_compare_quantity_name(of->quantity));
  fputc(' ', f);
  um_compare_gnuplot_name(f, of->of);
  if (!isnan(channel->all.chi2_reduced))
    fprintf(f, ", reduced chi-square %.3g", channel->all.chi2_reduced);
  fprintf(
      f,
      "\"\nset size 1,0.6\nset origin 0,0.37\nunset xlabel\nset ylabel \"[%s]\"\n"
      "plot 'residuals.csv' every ::1 using (x(1)):(y(4)):(s(6)) with yerrorbars pointtype 7 "
      "pointsize 0.5 linecolor rgb '#555555' title 'measured', '' every ::1 using (x(1)):(y(5)) "
      "with lines linewidth 2 linecolor rgb '#b3261e' title 'model'\n"
      "set size 1,0.37\nset origin 0,0\nset yrange [*:*] noreverse\n",
      um_compare_quantity_unit(of->quantity));
  um_compare_gnuplot_xlabel(f, axis);
  fprintf(f,
          "set ylabel \"%s\"\n"
          "plot 0 with lines linecolor rgb '#888888' notitle, 'residuals.csv' every ::1 using "
          "(x(1)):(y(%d)) with points pointtype 7 pointsize 0.5 linecolor rgb '#1f4e9c' title "
          "'residual'\nunset multiplot\n",
          isnan(channel->all.chi2) ? "measured - model" : "(measured - model) / {/Symbol s}",
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
  const struct um_model_trace *t = comparison->run.trace;
  struct um_compare_gnuplot_axis axis = um_compare_gnuplot_axis(t->t_obs[0], t->t_obs[t->nobs - 1]);
  um_compare_gnuplot_head(f, &axis, 760);
  um_compare_gnuplot_shade(f, &axis, t->nobs, t->t_obs, comparison->light);
  for (size_t i = 0; i < comparison->nchannel; i++) {
    const struct um_compare_measurements *m = comparison->run.plan->measurements;
    status = um_compare_channel_file(context, &m->channel[comparison->channel[i].channel], &name);
    if (status != UM_OK) break;
    script_channel(comparison, &axis, i, name, f);
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
