/* limits.csv and its picture. */
#include "output/cases.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/plot/plot.h"
#include "output/csv_impl.h"

#define WIDTH  1100 /* pixels */
#define LEFT   230
#define ROW    26 /* of a bar */
#define MARGIN 96 /* above and below the bars */
#define ROWS   60 /* shown at most */
#define RIGHT  170

void um_output_write_cases(const struct um_variant_cases *cases, FILE *file)
{
  fputs("case,analysis,place,mean_K,lowest_K,highest_K,minimum_K,maximum_K,uncertainty_K,"
        "margin_low_K,margin_high_K\n",
        file);
  for (size_t i = 0; i < cases->count; i++)
    for (size_t p = 0; p < cases->item[i].nplace; p++) {
      const struct um_variant_case *c = &cases->item[i];
      const struct um_variant_case_place *place = &c->place[p];
      um_core_csv_put(file, c->name, "");
      um_core_csv_put_text(file, um_variant_analysis_name(c->analysis), "");
      um_core_csv_put_text(file, place->name, "");
      const double value[] = {place->mean,       place->lowest,     place->highest,
                              place->minimum,    place->maximum,    place->uncertainty,
                              place->margin_low, place->margin_high};
      for (size_t k = 0; k < sizeof value / sizeof value[0]; k++)
        um_core_csv_put_number(file, value[k]);
      fputc('\n', file);
    }
}

static bool has_limit(const struct um_variant_case_place *place)
{
  return !isnan(place->minimum) || !isnan(place->maximum);
}

bool um_output_case_shows(const struct um_variant_cases *cases,
                          const struct um_variant_case_place *place)
{
  for (size_t i = 0; i < cases->count; i++)
    for (size_t p = 0; p < cases->item[i].nplace; p++)
      if (has_limit(&cases->item[i].place[p])) return has_limit(place);
  const char *dot = strchr(place->name, '.');
  return dot == NULL || strcmp(dot, ".interior") == 0;
}

const struct um_variant_case_place *um_output_case_place(const struct um_variant_case *c,
                                                         const char *name)
{
  for (size_t p = 0; p < c->nplace; p++)
    if (strcmp(c->place[p].name, name) == 0) return &c->place[p];
  return NULL;
}

/* What is drawn: bars of these places, one of each case. */
struct bars {
  const struct um_variant_cases *cases;
  const struct um_variant_case_place *row[ROWS]; /* [nrow] places of the first case */
  size_t nrow, nall;
  double low, high; /* of bars, with their uncertainty, and bounds [K] */
};

static double uncertainty_of(const struct um_variant_case_place *place)
{
  return has_limit(place) ? place->uncertainty : 0.0;
}

static struct bars bars_of(const struct um_variant_cases *cases)
{
  struct bars b = {.cases = cases, .low = INFINITY, .high = -INFINITY};
  for (size_t p = 0; p < cases->item[0].nplace; p++) {
    const struct um_variant_case_place *first = &cases->item[0].place[p];
    if (!um_output_case_shows(cases, first) || b.nall++ >= ROWS) continue;
    b.row[b.nrow++] = first;
    for (size_t i = 0; i < cases->count; i++) {
      const struct um_variant_case_place *place =
          um_output_case_place(&cases->item[i], first->name);
      if (place == NULL) continue;
      double u = uncertainty_of(place);
      b.low = fmin(b.low, fmin(place->lowest - u, place->minimum));
      b.high = fmax(b.high, fmax(place->highest + u, place->maximum));
    }
  }
  return b;
}

/* Height of a bar's middle, downwards, in rows. */
static double middle(const struct bars *b, size_t row, size_t i)
{
  return (double)row + ((double)i + 0.5) / (double)b->cases->count * 0.8 + 0.1;
}

static void put_table(struct um_plot *plot, const struct bars *b)
{
  double least = 0.002 * (b->high - b->low); /* a bar of one temperature is seen */
  um_plot_add(plot, "$bars << EOD\n");
  for (size_t row = 0; row < b->nrow; row++)
    for (size_t i = 0; i < b->cases->count; i++) {
      const struct um_variant_case_place *place =
          um_output_case_place(&b->cases->item[i], b->row[row]->name);
      if (place == NULL) continue;
      um_plot_add(plot, "%zu,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f\n", i, middle(b, row, i),
                  place->lowest - least, place->highest + least, place->minimum, place->maximum,
                  uncertainty_of(place));
    }
  um_plot_add(plot, "EOD\n");
}

/* Names at the left, margins at the right. */
static void put_words(struct um_plot *plot, const struct bars *b)
{
  for (size_t row = 0; row < b->nrow; row++) {
    um_plot_add(plot, "set label %s at graph -0.01, first %.2f right noenhanced\n",
                b->row[row]->name, (double)row + 0.5);
    if (row > 0)
      um_plot_add(plot,
                  "set arrow from graph 0, first %.1f to graph 1, first %.1f nohead "
                  "linecolor rgb '#dddddd' back\n",
                  (double)row, (double)row);
    for (size_t i = 0; i < b->cases->count; i++) {
      const struct um_variant_case_place *place =
          um_output_case_place(&b->cases->item[i], b->row[row]->name);
      char words[60];
      if (place == NULL || isnan(um_variant_case_margin(place))) continue;
      bool exceeded = um_variant_case_exceeded(place);
      snprintf(words, sizeof words, "%.2f K%s", um_variant_case_margin(place),
               exceeded ? " EXCEEDED" : "");
      um_plot_add(plot, "set label %s at graph 1.01, first %.4f left font ',10' textcolor rgb %s\n",
                  words, middle(b, row, i), exceeded ? "#b2182b" : "#444444");
    }
  }
}

static void draw(struct um_plot *plot, const struct bars *b)
{
  static const char *const colour[] = {"#b2182b", "#2166ac", "#1b7837", "#762a83", "#8c510a"};
  const size_t ncolour = sizeof colour / sizeof colour[0];
  double half = 0.3 / (double)b->cases->count, space = fmax(2.0, 0.05 * (b->high - b->low));
  put_table(plot, b);
  um_plot_add(plot, "set yrange [%.1f:0]\nset xrange [%.2f:%.2f]\nunset ytics\n", (double)b->nrow,
              b->low - space, b->high + space);
  um_plot_add(plot, "set xlabel 'temperature [K]'\nset key noenhanced\n");
  put_words(plot, b);
  um_plot_add(plot, "plot ");
  for (size_t i = 0; i < b->cases->count; i++)
    um_plot_add(plot,
                "$bars using ($1==%zu ? 0.5*($3+$4) : NaN):2:($3-$7):($4+$7):($2-%.4f):($2+%.4f) "
                "with boxxyerror fillstyle transparent solid 0.35 noborder linecolor rgb %s "
                "notitle, $bars using ($1==%zu ? 0.5*($3+$4) : NaN):2:3:4:($2-%.4f):($2+%.4f) with "
                "boxxyerror fillstyle solid noborder linecolor rgb %s title %s, ",
                i, 0.5 * half, 0.5 * half, colour[i % ncolour], i, half, half, colour[i % ncolour],
                b->cases->item[i].name);
  um_plot_add(plot,
              "$bars using 5:2:(0.0):(%.4f) with vectors nohead linewidth 2 linecolor rgb 'black' "
              "title 'limits', $bars using 5:2:(0.0):(-%.4f) with vectors nohead linewidth 2 "
              "linecolor rgb 'black' notitle, $bars using 6:2:(0.0):(%.4f) with vectors nohead "
              "linewidth 2 linecolor rgb 'black' notitle, $bars using 6:2:(0.0):(-%.4f) with "
              "vectors nohead linewidth 2 linecolor rgb 'black' notitle\n",
              1.4 * half, 1.4 * half, 1.4 * half, 1.4 * half);
}

enum um_status um_output_plot_cases(struct um_context *context,
                                    const struct um_variant_cases *cases, const char *folder)
{
  struct um_plot *plot = NULL;
  struct bars b = bars_of(cases);
  char below[160];
  if (b.nrow == 0) return UM_OK;
  int height = 2 * MARGIN + (int)(b.nrow * cases->count) * ROW;
  snprintf(below, sizeof below,
           "lowest to highest temperature of each case; pale: its uncertainty; right: margin, "
           "the uncertainty counted against it");
  size_t n = strlen(below);
  if (b.nall > b.nrow)
    snprintf(below + n, sizeof below - n, "; the first %zu of %zu places", b.nrow, b.nall);
  UM_TRY(um_plot_create(context, folder, "limits.gp", &plot));
  um_plot_picture(plot, "limits", WIDTH, height);
  um_plot_title(plot, cases->scenario, below);
  um_plot_panel(plot, LEFT, MARGIN, WIDTH - RIGHT, height - MARGIN);
  draw(plot, &b);
  return um_plot_draw(context, &plot);
}
