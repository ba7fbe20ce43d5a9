/* Pictures of a study. */
#include "study/plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "study/plot_impl.h"

const char *um_study_colour(size_t i)
{
  static const char *const colour[] = {"#0072b2", "#e69f00", "#009e73", "#cc79a7",
                                       "#56b4e9", "#d55e00", "#f0e442", "#555555"};
  return colour[i % (sizeof colour / sizeof *colour)];
}

bool um_study_is_curve(const struct um_study_result *result,
                       const struct um_study_quantity *quantity)
{
  return quantity->count == result->ntime && quantity->count > 1;
}

void um_study_extent(const struct um_study_result *result, size_t parameter, double *least,
                     double *largest)
{
  *least = INFINITY;
  *largest = -INFINITY;
  for (size_t j = 0; j < result->npoint; j++) {
    *least = fmin(*least, result->parameter[j * result->nparameter + parameter]);
    *largest = fmax(*largest, result->parameter[j * result->nparameter + parameter]);
  }
}

void um_study_axis_words(const struct um_study_result *result, size_t parameter, char *out,
                         size_t size)
{
  const char *unit = result->parameter_unit[parameter];
  bool none = unit[0] == '\0' || strcmp(unit, "1") == 0;
  snprintf(out, size, "%s%s%s%s", result->parameter_name[parameter], none ? "" : " [",
           none ? "" : unit, none ? "" : "]");
}

void um_study_plot_xaxis(struct um_plot *plot, const struct um_study_result *result,
                         size_t parameter, int width)
{
  char words[300];
  double least, largest;
  um_study_extent(result, parameter, &least, &largest);
  um_study_axis_words(result, parameter, words, sizeof words);
  double room = 0.02 * (largest - least);
  um_plot_add(plot, "set xlabel %s noenhanced\nset xtics %.9g\nset xrange [%.9g:%.9g]\n", words,
              um_plot_spacing((largest - least) * (width < 300 ? 1.0 : 0.6)), least - room,
              largest + room);
}

double um_study_axis_unit(const struct um_study_quantity *quantity, double largest, char out[100])
{
  char unit[80];
  bool power_of_ten = strcmp(quantity->unit, "mag") != 0 && strcmp(quantity->unit, "K") != 0;
  const char *raised = strcmp(quantity->unit, "W/m2") == 0 ? "W/m^2" : quantity->unit;
  double power = um_plot_power(power_of_ten ? largest : 1.0,
                               strcmp(quantity->unit, "1") == 0 ? "" : raised, unit);
  snprintf(out, 100, unit[0] != '\0' ? "[%s]" : "%s", unit);
  return power;
}

enum um_status um_study_plot(struct um_context *context, const struct um_study_result *result,
                             const struct um_study_statistics *statistics, const double *weight,
                             struct um_core_folder *folder)
{
  enum um_status status;
  struct um_plot *plot = NULL;
  UM_TRY(um_plot_create(context, um_core_folder_path(folder), "plots.gp", &plot));
  um_study_plot_curves(plot, result, statistics);
  um_study_plot_limits(plot, result);
  UM_CHECK(um_study_plot_surfaces(context, plot, result, statistics, folder));
  UM_CHECK(um_study_plot_scatter(context, plot, result, weight, folder));
  if (weight != NULL) UM_CHECK(um_study_plot_posterior(context, plot, result, weight, folder));
  UM_CHECK(um_plot_draw(context, &plot));
done:
  um_plot_destroy(context, &plot);
  return status;
}
