/* What measurements leave of each parameter: shares of the points and of their weights. */
#include <math.h>
#include <stdio.h>

#include "base/core/csv.h"
#include "study/plot_impl.h"

#define BINS   24
#define WIDTH  1000
#define LEFT   80
#define TOP    92
#define PANEL  220
#define ACROSS 3
#define GAP    56
#define BELOW  64

struct histogram {
  double least, width, prior[BINS], posterior[BINS];
};

static void count(const struct um_study_result *r, const double *weight, size_t i,
                  struct histogram *h)
{
  double largest = -INFINITY;
  *h = (struct histogram){.least = INFINITY};
  for (size_t p = 0; p < r->npoint; p++) {
    h->least = fmin(h->least, r->parameter[p * r->nparameter + i]);
    largest = fmax(largest, r->parameter[p * r->nparameter + i]);
  }
  h->width = (largest - h->least) / BINS;
  for (size_t p = 0; p < r->npoint; p++) {
    double at = h->width > 0.0 ? (r->parameter[p * r->nparameter + i] - h->least) / h->width : 0.0;
    size_t bin = at < BINS ? (size_t)at : BINS - 1;
    h->prior[bin] += 1.0 / (double)r->npoint;
    h->posterior[bin] += weight[p];
  }
}

static void write(const struct um_study_result *r, const double *weight, FILE *file)
{
  fputs("parameter,middle,width,prior,posterior\n", file);
  for (size_t i = 0; i < r->nparameter; i++) {
    struct histogram h;
    count(r, weight, i, &h);
    for (size_t b = 0; b < BINS; b++) {
      um_core_csv_put(file, r->parameter_name[i], "");
      fprintf(file, ",%.9g,%.9g,%.9g,%.9g\n", h.least + ((double)b + 0.5) * h.width, h.width,
              h.prior[b], h.posterior[b]);
    }
  }
}

enum um_status um_study_plot_posterior(struct um_context *context, struct um_plot *plot,
                                       const struct um_study_result *result, const double *weight,
                                       struct um_core_folder *folder)
{
  const struct um_study_result *r = result;
  FILE *file = NULL;
  double squares = 0.0;
  char words[160];
  UM_TRY(um_core_folder_open(context, folder, "posterior.csv", &file));
  write(r, weight, file);
  UM_TRY(um_core_file_close(context, "posterior.csv", &file));
  for (size_t p = 0; p < r->npoint; p++) squares += weight[p] * weight[p];
  int rows = (int)((r->nparameter + ACROSS - 1) / ACROSS);
  int across = r->nparameter < ACROSS ? (int)r->nparameter : ACROSS;
  int wide = (WIDTH - LEFT - 24 - (across - 1) * GAP) / across;
  um_plot_picture(plot, "posterior", WIDTH, TOP + rows * (PANEL + BELOW));
  snprintf(words, sizeof words, "before and after the measurements; worth %.3g of %zu points",
           1.0 / squares, r->npoint);
  um_plot_title(plot, r->name, words);
  for (size_t i = 0; i < r->nparameter; i++) {
    int left = LEFT + (int)i % ACROSS * (wide + GAP), top = TOP + (int)i / ACROSS * (PANEL + BELOW);
    size_t first = 1 + i * BINS, last = first + BINS - 1;
    um_plot_panel(plot, left, top, left + wide, top + PANEL);
    um_plot_ylabel(plot, "", i % ACROSS == 0 ? "share of the points" : "");
    um_study_plot_xaxis(plot, r, i, wide);
    um_plot_add(plot,
                "set yrange [0:*]\n"
                "plot 'posterior.csv' every ::%zu::%zu using 2:4:3 with boxes fillstyle solid "
                "noborder fillcolor rgb '#cccccc' title %s, '' every ::%zu::%zu using 2:5:3 with "
                "boxes fillstyle empty linewidth 1.6 linecolor rgb '#0072b2' title %s\n",
                first, last, i == 0 ? "before" : "", first, last, i == 0 ? "after" : "");
  }
  return UM_OK;
}
