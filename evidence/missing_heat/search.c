/* Every course between two edges, on a grid: all starts; all ends of a pulse; constants of a decay
 * that grow by a half; periods so close that the last switch moves by a quarter of a period, and
 * four shares of it that are on. */
#include <math.h>
#include <string.h>

#include "evidence/missing_heat/fit_impl.h"
#include "evidence/missing_heat/policy.h"

static void try(const struct um_missing_heat_bins *bins, struct um_thermal_course course,
                struct um_missing_heat_choice *choice)
{
  struct um_missing_heat_fit *best = &choice->of[course.shape];
  if (!um_missing_heat_course_allowed(bins, &course)) return;
  choice->tried++;
  struct um_missing_heat_weighed w = um_missing_heat_bins_weigh(bins, &course);
  if (!(w.chi2 > best->chi2)) return;
  *best = (struct um_missing_heat_fit){
      .course = course, .chi2 = w.chi2, .power = w.power, .energy = w.power * w.length};
}

static void try_periods(const struct um_missing_heat_bins *bins, double start,
                        struct um_missing_heat_choice *choice)
{
  static const double on[] = {0.15, 0.35, 0.6, 0.85};
  double span = bins->edge[bins->nbin] - bins->edge[0];
  for (double turns = 1.0; turns <= 0.5 * UM_MISSING_HEAT_BINS_MAX; turns += 0.25)
    for (size_t k = 0; k < sizeof on / sizeof *on; k++)
      try(bins,
          (struct um_thermal_course){UM_HEAT_PERIODIC, start, on[k] * span / turns, span / turns},
          choice);
}

void um_missing_heat_search(const struct um_missing_heat_bins *bins,
                            struct um_missing_heat_choice *choice)
{
  const double *edge = bins->edge;
  double span = edge[bins->nbin] - edge[0];
  *choice = (struct um_missing_heat_choice){.scale = 1.0};
  for (int s = 0; s < UM_HEAT_SHAPES; s++)
    choice->of[s].course =
        (struct um_thermal_course){(enum um_thermal_course_shape)s, edge[0], span, span};
  for (size_t i = 0; i < bins->nbin; i++) {
    try(bins, (struct um_thermal_course){UM_HEAT_STEP, edge[i], INFINITY, NAN}, choice);
    for (size_t j = i + 1; j <= bins->nbin; j++)
      try(bins, (struct um_thermal_course){UM_HEAT_PULSE, edge[i], edge[j] - edge[i], NAN}, choice);
    for (double last = 0.5 * span / UM_MISSING_HEAT_BINS_MAX; last < 3.0 * span; last *= 1.5)
      try(bins, (struct um_thermal_course){UM_HEAT_DECAY, edge[i], last, NAN}, choice);
    try_periods(bins, edge[i], choice);
  }
}
