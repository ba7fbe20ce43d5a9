/* Periodograms and folded curves as files, and a picture of them by gnuplot. */
#include "evidence/inversion/period_write.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/core/file.h"
#include "base/plot/plot.h"
#include "evidence/comparison/figures.h"
#include "evidence/inversion/period_report.h"

/* Pixels. */
#define WIDTH  1000
#define LEFT   100
#define RIGHT  980
#define TOP    70
#define PANEL  270
#define MIDDLE 64
#define BELOW  52

static void put_channel(const struct um_compare_channel *of, FILE *f)
{
  fprintf(f, "%s,", um_compare_quantity_name(of->quantity));
  um_core_csv_put(f, of->of, "");
  fputc(',', f);
}

static void put_periodograms(const struct um_compare_period_report *r, FILE *f)
{
  fputs("quantity,of,period_s,frequency_Hz,power\n", f);
  for (size_t c = 0; c < r->count; c++) {
    const struct um_compare_channel *of = &r->measurements->channel[r->entry[c].channel];
    const struct um_compare_period *p = r->entry[c].period;
    for (size_t i = 0; i < p->count; i++) {
      put_channel(of, f);
      fprintf(f, "%.9g,%.9g,%.6g\n", 1.0 / p->frequency[i], p->frequency[i], p->power[i]);
    }
  }
}

static void put_folded(const struct um_compare_period_report *r, FILE *f)
{
  fputs("quantity,of,phase,count,mean,sigma\n", f);
  for (size_t c = 0; c < r->count; c++) {
    const struct um_compare_channel *of = &r->measurements->channel[r->entry[c].channel];
    for (size_t b = 0; b < UM_COMPARE_FOLD_BINS; b++) {
      const struct um_compare_fold_bin *bin = &r->entry[c].bin[b];
      put_channel(of, f);
      fprintf(f, "%.6g,%zu,", ((double)b + 0.5) / UM_COMPARE_FOLD_BINS, bin->count);
      if (bin->count > 0) fprintf(f, "%.9g", bin->mean);
      fputc(',', f);
      if (!isnan(bin->sigma)) fprintf(f, "%.6g", bin->sigma);
      fputc('\n', f);
    }
  }
}

/* Numbers of a logarithmic axis: 1, 2 and 5, of many decades 1 alone. */
static void ticks(struct um_plot *plot, double low, double high)
{
  static const double lead[] = {1.0, 2.0, 5.0};
  bool few = high < 3e3 * low;
  um_plot_add(plot, "set xtics (");
  for (double power = pow(10.0, floor(log10(low))); power <= high; power *= 10.0)
    for (size_t i = 0; i < (few ? 3 : 1); i++)
      if (lead[i] * power >= low && lead[i] * power <= high)
        um_plot_add(plot, "%g, ", lead[i] * power);
  um_plot_add(plot, "%g)\n", 1e300); /* off the axis: a list has an end */
}

/* Periods that are drawn, and where the one that was found stands. first: row of periodogram.csv,
 * counted from its header. */
static void periodogram(struct um_plot *plot, const struct um_compare_period *p, size_t first)
{
  double low = INFINITY, high = 0.0, most = 0.0;
  for (size_t i = 0; i < p->count; i++) {
    low = fmin(low, 1.0 / p->frequency[i]);
    high = fmax(high, 1.0 / p->frequency[i]);
    most = fmax(most, p->power[i]);
  }
  ticks(plot, low, high);
  um_plot_ylabel(plot, "", "share of χ² explained");
  um_plot_panel(plot, LEFT, TOP, RIGHT, TOP + PANEL);
  um_plot_add(
      plot,
      "set logscale x\nset xrange [%.6g:%.6g]\nset yrange [0:%.3g]\nset xlabel 'period "
      "[s]'\nset arrow 1 from first %.9g, graph 0 to first %.9g, graph 1 nohead back "
      "dashtype (6,4) linecolor rgb '#b3261e'\n"
      "plot 'periodogram.csv' every ::%zu::%zu using 3:5 with lines linewidth 1.2 linecolor "
      "rgb '#1f4e9c' notitle\nunset arrow 1\nunset logscale x\nset xtics autofreq\n",
      low, high, most > 0.0 ? fmin(1.1 * most, 1.0) : 1.0, p->period, p->period, first,
      first + p->count - 1);
}

/* Two turns, the second paler. first: row of folded.csv. */
static void folded(struct um_plot *plot, const struct um_compare_period_entry *entry,
                   const char *unit, size_t first)
{
  double largest = 0.0;
  char own[80], words[120];
  for (size_t b = 0; b < UM_COMPARE_FOLD_BINS; b++)
    if (entry->bin[b].count > 0) largest = fmax(largest, fabs(entry->bin[b].mean));
  double power = um_plot_power(largest, unit, own);
  snprintf(words, sizeof words, "mean [%s]", own);
  um_plot_ylabel(plot, "", words);
  um_plot_panel(plot, LEFT, TOP + PANEL + MIDDLE, RIGHT, TOP + 2 * PANEL + MIDDLE);
  um_plot_add(plot,
              "set xrange [0:2]\nset yrange [*:*]\nset xlabel %s\n"
              "y(i) = column(i) / %g\ns(i) = strcol(i) eq '' ? 0 : column(i) / %g\nplot ",
              um_compare_period_is_named(entry->period) ? "phase"
                                                        : "phase by the highest peak’s period",
              power, power);
  for (int turn = 0; turn < 2; turn++)
    um_plot_add(plot,
                "'folded.csv' every ::%zu::%zu using ($3+%d):(y(5)):(s(6)) with yerrorlines "
                "pointtype 7 pointsize 0.7 linecolor rgb %s notitle, ",
                first, first + UM_COMPARE_FOLD_BINS - 1, turn, turn == 0 ? "#b3261e" : "#d99a95");
  um_plot_add(plot, "NaN notitle\n");
}

/* As the table says it. */
static void found_words(const struct um_compare_period *p, char out[120])
{
  int decimals = p->period_sigma > 0.0 && p->period_sigma < 10.0
                     ? (int)fmin(1.0 - floor(log10(p->period_sigma)), 9.0)
                     : 0;
  if (um_compare_period_is_named(p))
    snprintf(out, 120, "period %.*f ± %.*f s, false-alarm probability %.2g", decimals, p->period,
             decimals, p->period_sigma, p->false_alarm);
  else
    snprintf(out, 120, "no period: noise peaks as high (at %.4g s), false-alarm probability %.2g",
             p->period, p->false_alarm);
}

static enum um_status draw(struct um_context *context, const struct um_compare_period_report *r,
                           const char *folder)
{
  enum um_status status = UM_OK;
  struct um_plot *plot = NULL;
  char *name = NULL, *file = NULL, words[200], found[120];
  size_t row = 1;
  UM_CHECK(um_plot_create(context, folder, "period.gp", &plot));
  for (size_t c = 0; c < r->count; c++) {
    const struct um_compare_channel *of = &r->measurements->channel[r->entry[c].channel];
    const struct um_compare_period *p = r->entry[c].period;
    UM_CHECK(um_compare_channel_file(context, of, &name));
    UM_CHECK(um_core_asprintf(context, &file, "period_%s", name));
    um_plot_picture(plot, file, WIDTH, TOP + 2 * PANEL + MIDDLE + BELOW);
    um_compare_channel_words(of, words, sizeof words);
    found_words(p, found);
    um_plot_title(plot, words, found);
    periodogram(plot, p, row);
    folded(plot, &r->entry[c], um_compare_residual_unit(of->quantity),
           1 + c * UM_COMPARE_FOLD_BINS);
    row += p->count;
    UM_FREE(context, name, file);
    name = file = NULL;
  }
  status = um_plot_draw(context, &plot);
done:
  UM_FREE(context, name, file);
  um_plot_destroy(context, &plot);
  return status;
}

enum um_status um_compare_period_write(struct um_context *context,
                                       const struct um_compare_period_report *report, bool plots,
                                       struct um_core_folder *folder)
{
  FILE *f = NULL;
  UM_TRY(um_core_folder_open(context, folder, "periodogram.csv", &f));
  put_periodograms(report, f);
  UM_TRY(um_core_file_close(context, "periodogram.csv", &f));
  UM_TRY(um_core_folder_open(context, folder, "folded.csv", &f));
  put_folded(report, f);
  UM_TRY(um_core_file_close(context, "folded.csv", &f));
  return plots ? draw(context, report, um_core_folder_path(folder)) : UM_OK;
}
