/* Periodograms and folded curves as files, and a picture of them by gnuplot. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/figures.h"
#include "compare/period_report.h"
#include "output/output.h"

#define SCRIPT "period.gp"

static enum um_status open_in(struct um_context *context, const char *folder, const char *name,
                              FILE **out)
{
  char *path = NULL;
  UM_TRY(um_core_asprintf(context, &path, "%s/%s", folder, name));
  *out = fopen(path, "w");
  enum um_status status = UM_OK;
  if (*out == NULL) status = um_core_fail(context, UM_ERR_IO, "%s: %s", path, strerror(errno));
  um_core_free(context, path);
  return status;
}

static void put_periodograms(const struct um_compare_period_report *r, FILE *f)
{
  fputs("quantity,of,period_s,frequency_Hz,power\n", f);
  for (size_t c = 0; c < r->count; c++) {
    const struct um_compare_channel *of = &r->measurements->channel[r->entry[c].channel];
    const struct um_compare_period *p = r->entry[c].period;
    for (size_t i = 0; i < p->count; i++)
      fprintf(f, "%s,%s,%.9g,%.9g,%.6g\n", um_compare_quantity_name(of->quantity), of->of,
              1.0 / p->frequency[i], p->frequency[i], p->power[i]);
  }
}

static void put_folded(const struct um_compare_period_report *r, FILE *f)
{
  fputs("quantity,of,phase,count,mean,sigma\n", f);
  for (size_t c = 0; c < r->count; c++) {
    const struct um_compare_channel *of = &r->measurements->channel[r->entry[c].channel];
    for (size_t b = 0; b < UM_COMPARE_FOLD_BINS; b++) {
      const struct um_compare_fold_bin *bin = &r->entry[c].bin[b];
      fprintf(f, "%s,%s,%.6g,%zu,", um_compare_quantity_name(of->quantity), of->of,
              ((double)b + 0.5) / UM_COMPARE_FOLD_BINS, bin->count);
      if (bin->count > 0) fprintf(f, "%.9g", bin->mean);
      fputc(',', f);
      if (!isnan(bin->sigma)) fprintf(f, "%.6g", bin->sigma);
      fputc('\n', f);
    }
  }
}

static enum um_status put_script(struct um_context *context,
                                 const struct um_compare_period_report *r, FILE *f)
{
  fputs("set terminal pngcairo size 1000,760 enhanced font 'Sans,11'\nset encoding utf8\n"
        "set datafile separator ','\nset grid linecolor rgb '#e4e4e4'\nunset key\n"
        "own(i) = strcol(1) eq q && strcol(2) eq o\ny(i) = own(i) ? column(i) : NaN\n"
        "s(i) = strcol(i) eq \"\" ? 0 : column(i)\n",
        f);
  for (size_t c = 0; c < r->count; c++) {
    const struct um_compare_channel *of = &r->measurements->channel[r->entry[c].channel];
    const struct um_compare_period *p = r->entry[c].period;
    char *name = NULL;
    UM_TRY(um_compare_channel_file(context, of, &name));
    fprintf(f,
            "\nset output 'period_%s.png'\nq = \"%s\"\no = \"%s\"\nset multiplot layout 2,1 title "
            "\"period %.6g +- %.2g s, false alarm %.2g\"\nset logscale x\nset xlabel 'period "
            "[s]'\nset ylabel 'share of chi-square explained'\nset yrange [0:1]\n"
            "plot 'periodogram.csv' every ::1 using (y(3)):(y(5)) with lines linecolor rgb "
            "'#1f4e9c'\nunset logscale x\nset xlabel 'phase'\nset ylabel 'mean, linear flux'\nset "
            "yrange [*:*]\nplot 'folded.csv' every ::1 using (y(3)):(y(5)):(s(6)) with yerrorlines "
            "pointtype 7 linecolor rgb '#b3261e', '' every ::1 using (y(3)+1):(y(5)):(s(6)) with "
            "yerrorlines pointtype 7 linecolor rgb '#d99a95'\nunset multiplot\n",
            name, um_compare_quantity_name(of->quantity), of->of, p->period, p->period_sigma,
            p->false_alarm);
    um_core_free(context, name);
  }
  return UM_OK;
}

enum um_status um_compare_period_write(struct um_context *context,
                                       const struct um_compare_period_report *report, bool plots,
                                       const char *folder)
{
  FILE *f = NULL;
  UM_TRY(open_in(context, folder, "periodogram.csv", &f));
  put_periodograms(report, f);
  UM_TRY(um_core_file_close(context, "periodogram.csv", &f));
  UM_TRY(open_in(context, folder, "folded.csv", &f));
  put_folded(report, f);
  UM_TRY(um_core_file_close(context, "folded.csv", &f));
  if (!plots) return UM_OK;
  UM_TRY(open_in(context, folder, SCRIPT, &f));
  enum um_status status = put_script(context, report, f);
  enum um_status closed = um_core_file_close(context, SCRIPT, &f);
  UM_TRY(status);
  UM_TRY(closed);
  um_output_plot_script(context, folder, SCRIPT);
  return UM_OK;
}
