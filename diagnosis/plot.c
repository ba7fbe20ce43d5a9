/* Pictures of a diagnosis by gnuplot: per channel data with the model before and after and the
 * residuals of both. The script is kept beside them. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/figures.h"
#include "diagnosis/plot_impl.h"
#include "output/output.h"

#define SCRIPT  "plots.gp"
#define SHADES  1000     /* instants at which the shadow is looked up */
#define LONGEST 259200.0 /* [s] beyond it single shadows are not to be seen */
#define GAP     8.0      /* median steps over which a curve is not drawn */
#define FEW     300      /* rows up to which they are drawn over the curves */

/* ---- shadow ---- */

enum um_status um_diagnosis_plot_shade(struct um_context *context, const struct um_diagnosis *d,
                                       const struct um_compare_gnuplot_axis *axis, FILE *file)
{
  const struct um_model *model = d->forward->model;
  enum um_compare_segment light[SHADES];
  double time[SHADES];
  fputs("unset object\n", file);
  if (model->points || !(axis->last - axis->first < LONGEST)) return UM_OK;
  for (size_t i = 0; i < SHADES; i++) {
    struct um_environment_sample sample;
    time[i] = axis->first + (axis->last - axis->first) * (double)i / (SHADES - 1);
    enum um_status status = um_model_sample_at(context, model, time[i], &sample);
    if (status == UM_ERR_INPUT) { /* an orbit that ends with the measurements */
      um_core_message_clear(context);
      sample.sunlit_fraction = 1.0;
    } else {
      UM_TRY(status);
    }
    light[i] = sample.sunlit_fraction >= 1.0   ? UM_SEGMENT_SUNLIT
               : sample.sunlit_fraction <= 0.0 ? UM_SEGMENT_UMBRA
                                               : UM_SEGMENT_PENUMBRA;
  }
  um_compare_gnuplot_shade(file, axis, SHADES, time, light);
  return UM_OK;
}

/* ---- channels ---- */

static int compare_numbers(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Step between rows beyond which a curve has a gap [s]. */
static enum um_status gap_of(struct um_context *context, const struct um_diagnosis *d, size_t c,
                             double *out, size_t *count)
{
  size_t *row;
  double *step = NULL;
  UM_TRY(um_diagnosis_channel_rows(context, d, c, &row, count));
  enum um_status status = um_core_allocate(context, *count, sizeof *step, &step);
  *out = INFINITY;
  if (status == UM_OK && *count > 2) {
    size_t n = *count - 1;
    for (size_t i = 0; i < n; i++) step[i] = d->forward->t[row[i + 1]] - d->forward->t[row[i]];
    qsort(step, n, sizeof *step, compare_numbers);
    *out = GAP * step[n / 2];
  }
  um_core_free(context, step);
  um_core_free(context, row);
  return status;
}

static void put_added(const struct um_diagnosis *d, FILE *f)
{
  if (d->naddition == 0) fputs("nothing added", f);
  for (size_t i = 0; i < d->naddition; i++) {
    fputs(i == 0 ? "with " : ", ", f);
    um_compare_gnuplot_name(f, d->addition[i].effect->name);
    if (d->addition[i].target == NULL) continue;
    fputs(" of ", f);
    um_compare_gnuplot_name(f, d->addition[i].target);
  }
}

static enum um_status put_title(struct um_context *context, const struct um_diagnosis *d, size_t c,
                                FILE *f)
{
  const struct um_compare_channel *channel = um_diagnosis_channel(d, c);
  struct um_compare_metrics before, after;
  UM_TRY(um_diagnosis_channel_metrics(context, d, c, d->value_before, d->dof, &before));
  UM_TRY(um_diagnosis_channel_metrics(context, d, c, d->value_after, d->dof_after, &after));
  fputs("set multiplot title \"{/:Bold ", f);
  um_compare_gnuplot_name(f, d->forward->model->scenario->name);
  fputs(": ", f);
  um_compare_gnuplot_name(f, um_compare_quantity_name(channel->quantity));
  fputc(' ', f);
  um_compare_gnuplot_name(f, channel->of);
  fputs("}\\n", f);
  put_added(d, f);
  fprintf(f, ": rms %.3g -> %.3g %s, reduced {/Symbol c}^2 %.3g -> %.3g\"\n", before.rms, after.rms,
          um_compare_residual_unit(channel->quantity), before.chi2_reduced, after.chi2_reduced);
  return UM_OK;
}

/* Largest residual in sigma, at least 1, rounded up to a number that halves well. */
static double largest_residual(const struct um_diagnosis *d, size_t c, const double *value)
{
  const struct um_diagnosis_forward *f = d->forward;
  double largest = 1.0;
  for (size_t i = 0; i < f->nrow; i++)
    if (f->channel[i] == c) largest = fmax(largest, fabs(f->measured[i] - value[i]) / f->sigma[i]);
  double power = pow(10.0, floor(log10(largest))), lead = largest / power;
  static const double round[] = {1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0};
  size_t i = 0;
  while (i < 6 && lead > round[i]) i++;
  return power * round[i];
}

static void put_data(const struct um_diagnosis *d, const struct um_compare_channel *channel,
                     size_t count, FILE *f)
{
  bool few = count <= FEW, curves = !d->forward->model->points && count > 2;
  char data[256], model[512];
  snprintf(data, sizeof data,
           "'fit.csv' every ::1 using (x(1)):(y(4)):(s(5)) with yerrorbars pointtype 7 pointsize "
           "%s linecolor rgb '%s' title 'measured'",
           few ? "0.55 linewidth 1" : "0.3 linewidth 0.5", few ? "#333333" : "#9a9a9a");
  snprintf(model, sizeof model,
           "last = 1e30, 'fit.csv' every ::1 using (x(1)):(%c(6)) with %s linecolor rgb '#d9480f' "
           "title 'before', last = 1e30, '' every ::1 using (x(1)):(%c(7)) with %s linecolor rgb "
           "'#1f4e9c' title 'after'",
           curves ? 'L' : 'y', curves ? "lines linewidth 2 dashtype (6,4)" : "points pointtype 6",
           curves ? 'L' : 'y', curves ? "lines linewidth 2" : "points pointtype 2");
  fprintf(f, "set ylabel \"[%s]\" \nplot %s, %s\n", um_compare_quantity_unit(channel->quantity),
          few ? model : data, few ? data : model);
}

/* Data and both models above, the residuals of either on scales of their own below. */
static void put_panels(const struct um_diagnosis *d, size_t c, size_t count,
                       const struct um_compare_gnuplot_axis *axis, double gap, FILE *f)
{
  fprintf(f,
          "gap = %.9g\nL(i) = own(i) ? (v = m(strcol(1)), step = v - last, last = v, "
          "step > gap ? NaN : column(i)) : NaN\n"
          "set lmargin at screen 0.1\nset rmargin at screen 0.87\nset format y '%%.4g'\n"
          "set tmargin at screen 0.925\nset bmargin at screen 0.44\nunset xlabel\n"
          "set format x ''\n",
          isfinite(gap) ? gap / axis->unit : 1e30);
  put_data(d, um_diagnosis_channel(d, c), count, f);
  static const struct {
    double top, bottom;
    const char *colour, *title;
  } panel[] = {{0.415, 0.27, "#d9480f", "before"}, {0.245, 0.08, "#1f4e9c", "after"}};
  for (int i = 0; i < 2; i++) {
    double range = largest_residual(d, c, i == 0 ? d->value_before : d->value_after);
    fprintf(f,
            "set tmargin at screen %.3f\nset bmargin at screen %.3f\nset ylabel \"residual / "
            "{/Symbol s}\" \nset yrange [%.6g:%.6g] noreverse\nset ytics %.6g\n",
            panel[i].top, panel[i].bottom, -1.1 * range, 1.1 * range, 0.5 * range);
    if (i == 1) {
      fputs("set format x '%g'\n", f);
      um_compare_gnuplot_xlabel(f, axis);
    }
    fprintf(f,
            "plot 0 with lines linecolor rgb '#888888' notitle, 'fit.csv' every ::1 using "
            "(x(1)):(y(%d)) with points pointtype 7 pointsize %s linecolor rgb '%s' title '%s'\n",
            8 + i, count <= FEW ? "0.55" : "0.3", panel[i].colour, panel[i].title);
  }
  fputs("unset multiplot\nset ytics autofreq\n", f);
}

static enum um_status put_channel(struct um_context *context, const struct um_diagnosis *d,
                                  size_t c, const struct um_compare_gnuplot_axis *axis, FILE *f)
{
  char *name;
  double gap;
  size_t count;
  UM_TRY(gap_of(context, d, c, &gap, &count));
  if (count == 0) return UM_OK;
  UM_TRY(um_compare_channel_file(context, um_diagnosis_channel(d, c), &name));
  um_compare_gnuplot_channel(f, name, um_diagnosis_channel(d, c));
  um_core_free(context, name);
  UM_TRY(put_title(context, d, c, f));
  put_panels(d, c, count, axis, gap, f);
  return UM_OK;
}

static enum um_status put_script(struct um_context *context, const struct um_diagnosis *d, FILE *f)
{
  const struct um_diagnosis_forward *forward = d->forward;
  double first = INFINITY, last = -INFINITY;
  for (size_t i = 0; i < forward->nrow; i++) {
    first = fmin(first, forward->t[i]);
    last = fmax(last, forward->t[i]);
  }
  struct um_compare_gnuplot_axis axis = um_compare_gnuplot_axis(first, last);
  um_compare_gnuplot_head(f, &axis, 900);
  UM_TRY(um_diagnosis_plot_shade(context, d, &axis, f));
  for (size_t c = 0; c < forward->measurements->nchannel; c++)
    UM_TRY(put_channel(context, d, c, &axis, f));
  if (d->nranking > 0) UM_TRY(um_diagnosis_plot_ranking(context, d, f));
  if (d->unexplained != NULL && d->unexplained->nheat > 0 && d->unexplained->heat[0].nbin > 0)
    UM_TRY(um_diagnosis_plot_heat(context, d, f));
  return UM_OK;
}

enum um_status um_diagnosis_plot(struct um_context *context, const struct um_diagnosis *diagnosis,
                                 const char *folder)
{
  char *path = NULL;
  UM_TRY(um_core_asprintf(context, &path, "%s/" SCRIPT, folder));
  FILE *file = fopen(path, "wb");
  enum um_status status = UM_OK;
  if (file == NULL)
    status = um_core_fail(context, UM_ERR_IO, "%s: %s", path, strerror(errno));
  else
    status = put_script(context, diagnosis, file);
  enum um_status closed = um_core_file_close(context, SCRIPT, &file);
  if (status == UM_OK) status = closed;
  if (status == UM_OK) um_output_plot_script(context, folder, SCRIPT);
  um_core_free(context, path);
  return status;
}
