/* Pictures of what a diagnosis found: the ranking of the candidates, the history of missing heat.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "diagnosis/distributions_impl.h"
#include "diagnosis/plot_impl.h"

#define BARS 15
#define WIDE 40.0 /* ratio of bars beyond which their axis is logarithmic */

enum role { OTHER, RIVAL, WINNER };
struct bar {
  const struct um_diagnosis_rival *rival;
  enum role role;
};

/* The winner of the first step and those that cannot be told from it. */
static enum role role_of(const struct um_diagnosis *d, size_t candidate)
{
  if (d->nstep == 0) return OTHER;
  const struct um_diagnosis_step *step = &d->step[0];
  if (step->candidate == candidate) return WINNER;
  for (size_t i = 0; i < step->nrival; i++)
    if (step->rival[i].candidate == candidate && step->rival[i].indistinguishable) return RIVAL;
  return OTHER;
}

static int by_explained(const void *a, const void *b)
{
  const struct bar *x = a, *y = b;
  double p = x->rival->score.statistic, q = y->rival->score.statistic;
  if (p != q) return p < q ? 1 : -1;
  return x->rival->candidate < y->rival->candidate ? -1 : 1;
}

/* The best bars, falling; the winner is among them. Out: [nranking], of which *shown are drawn. */
static enum um_status choose_bars(struct um_context *context, const struct um_diagnosis *d,
                                  struct bar **out, size_t *shown, size_t *tested)
{
  struct bar *bar;
  *tested = 0;
  UM_TRY(um_core_allocate(context, d->nranking, sizeof *bar, &bar));
  for (size_t i = 0; i < d->nranking; i++)
    if (!d->ranking[i].score.absorbed && isfinite(d->ranking[i].score.statistic))
      bar[(*tested)++] = (struct bar){&d->ranking[i], role_of(d, d->ranking[i].candidate)};
  qsort(bar, *tested, sizeof *bar, by_explained);
  *shown = *tested < BARS ? *tested : BARS;
  for (size_t i = *shown; i < *tested; i++)
    if (bar[i].role == WINNER) bar[*shown - 1] = bar[i];
  *out = bar;
  return UM_OK;
}

/* Chi-square of one parameter that is as rare as `level` among n tests (Sidak). */
static double threshold(double level, size_t n)
{
  double p = 1.0 - pow(1.0 - level, 1.0 / (double)(n > 0 ? n : 1)), low = 0.0, high = 1000.0;
  for (int i = 0; i < 60; i++) {
    double middle = 0.5 * (low + high);
    if (um_diagnosis_chi2_q(middle, 1.0) > p)
      low = middle;
    else
      high = middle;
  }
  return low;
}

/* A text in a data block of gnuplot. */
static void put_quoted(FILE *f, const char *text)
{
  for (; *text != '\0'; text++) fputc(*text == '"' || *text == '\\' ? '\'' : *text, f);
}

/* "-> power_W 4.2 +- 0.3 W" of the first parameter. */
static void put_estimate(const struct um_diagnosis *d, const struct um_diagnosis_rival *rival,
                         FILE *f)
{
  const struct um_diagnosis_candidate *candidate = um_diagnosis_candidate_of(d, rival);
  if (candidate->is_switch || candidate->ncolumn == 0) return;
  const struct um_effect_parameter *parameter =
      &candidate->effect->parameters[candidate->parameter[0]];
  double value, sigma;
  um_diagnosis_estimate(candidate, &rival->score, 0, &value, &sigma);
  char text[80];
  um_diagnosis_value_text(value, sigma, "±", text);
  bool within = value >= parameter->minimum && value <= parameter->maximum;
  fprintf(f, "   %s %s", parameter->name, within ? text : "beyond its range");
}

enum um_status um_diagnosis_plot_ranking(struct um_context *context,
                                         const struct um_diagnosis *diagnosis, FILE *file)
{
  static const char *const colour[] = {"0xb8bcc6", "0xe8a33d", "0x1f4e9c"};
  const struct um_diagnosis *d = diagnosis;
  struct bar *bar;
  size_t shown, tested;
  UM_TRY(choose_bars(context, d, &bar, &shown, &tested));
  double line = threshold(d->level > 0.0 ? d->level : 0.01, tested), longest = line;
  for (size_t i = 0; i < shown; i++) longest = fmax(longest, bar[i].rival->score.statistic);
  bool wide = longest > WIDE * line;
  fputs("\nreset\n$ranking << EOD\n", file);
  for (size_t i = 0; i < shown; i++) {
    const struct um_diagnosis_rival *rival = bar[i].rival;
    fputc('"', file);
    put_quoted(file, um_diagnosis_candidate_of(d, rival)->name);
    fprintf(file, "\",%.6g,%s,\"", fmax(rival->score.statistic, wide ? 1.0 : 0.0),
            colour[bar[i].role]);
    fprintf(file, " %.4g", rival->score.statistic);
    put_estimate(d, rival, file);
    fputs("\"\n", file);
  }
  fprintf(file,
          "EOD\nset terminal pngcairo size 1100,%zu noenhanced font 'Sans,11'\nset encoding utf8\n"
          "set datafile separator ','\nset output 'ranking.png'\n"
          "set title \"%s: what each effect alone would explain of the baseline's χ² of %.4g "
          "(%.4g degrees of freedom)\" noenhanced\n",
          190 + 34 * shown, d->forward->model->scenario->name, d->chi2, d->dof);
  fprintf(file,
          "set style fill solid noborder\nset yrange [%.1f:-0.6]\nset grid xtics linecolor rgb "
          "'#e4e4e4'\nset tics out nomirror\nset border 3\nset key at screen 0.5, screen "
          "0.01 center bottom horizontal samplen 2 width -2\nset xlabel 'χ² explained, after "
          "nuisances; "
          "behind it "
          "the linear estimate'\n"
          "set bmargin 6\nset lmargin 34\nset rmargin 4\n%sset xrange [%s:%.6g]\n",
          (double)shown - 0.4, wide ? "set logscale x\n" : "", wide ? "1" : "0",
          wide ? pow(longest, 1.7) : 1.6 * longest);
  fprintf(file,
          "set arrow 1 from first %.6g, graph 0 to first %.6g, graph 1 nohead front linewidth 1.5 "
          "dashtype (6,4) linecolor rgb '#b3261e'\n"
          "plot $ranking using 2:0:(%s):2:($0-0.36):($0+0.36):3:ytic(1) with boxxyerror linecolor "
          "rgb variable notitle, '' using 2:0:4 with labels left offset 0.3,0 font 'Sans,9' "
          "textcolor rgb '#333333' notitle, NaN with boxes linecolor rgb '#1f4e9c' title 'chosen "
          "first', NaN with boxes linecolor rgb '#e8a33d' title 'cannot be told from it', NaN with "
          "boxes linecolor rgb '#b8bcc6' title 'others', NaN with lines linewidth 1.5 dashtype "
          "(6,4) linecolor rgb '#b3261e' title '%.3g %% by chance among %zu (one parameter)'\n",
          line, line, wide ? "1" : "0", 100.0 * (d->level > 0.0 ? d->level : 0.01), tested);
  um_core_free(context, bar);
  return UM_OK;
}

/* ---- heat ---- */

enum um_status um_diagnosis_plot_heat(struct um_context *context,
                                      const struct um_diagnosis *diagnosis, FILE *file)
{
  const struct um_diagnosis_heat *h = &diagnosis->unexplained->heat[0];
  struct um_compare_gnuplot_axis axis = um_compare_gnuplot_axis(h->t[0], h->t[h->nbin]);
  char energy[80];
  um_diagnosis_value_text(h->energy, h->energy_sigma, "±", energy);
  fputs("\nreset\n", file);
  um_compare_gnuplot_head(file, &axis, 560);
  UM_TRY(um_diagnosis_plot_shade(context, diagnosis, &axis, file));
  fputs("$heat << EOD\n", file);
  for (size_t i = 0; i < h->nbin; i++)
    fprintf(file, "%.6f,%.6f,%.6g,%.6g\n", um_compare_gnuplot_at(&axis, h->t[i]),
            um_compare_gnuplot_at(&axis, h->t[i + 1]), h->heat[i], h->sigma[i]);
  fputs("EOD\nset output 'heat.png'\nset title \"{/:Bold ", file);
  um_compare_gnuplot_name(file, diagnosis->forward->model->scenario->name);
  fputs(": missing heat of ", file);
  um_compare_gnuplot_name(file, h->place);
  fprintf(file,
          "}\\nbest pulse %s J\"\nset key inside right top\nset ylabel "
          "\"[W]\"\n",
          energy);
  um_compare_gnuplot_xlabel(file, &axis);
  double from = um_compare_gnuplot_at(&axis, h->start), to = um_compare_gnuplot_at(&axis, h->stop);
  fprintf(file,
          "$pulse << EOD\n0,0\n%.6f,0\n%.6f,%.6g\n%.6f,%.6g\n%.6f,0\n%.6f,0\nEOD\n"
          "set style fill transparent solid 0.25 noborder\n"
          "plot 0 with lines linecolor rgb '#888888' notitle, $heat using 1:3:1:2:($3-$4):($3+$4) "
          "with boxxyerror linecolor rgb '#1f4e9c' title 'one sigma', $heat using 1:3:($2-$1):(0) "
          "with vectors nohead linewidth 2 linecolor rgb '#1f4e9c' title 'reconstructed', $pulse "
          "using 1:2 with lines linewidth 2 dashtype (6,4) linecolor rgb '#c2410c' title 'best "
          "pulse'\n",
          from, from, h->power, to, h->power, to, um_compare_gnuplot_at(&axis, axis.last));
  return UM_OK;
}
