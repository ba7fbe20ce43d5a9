/* Pieces of gnuplot scripts that pictures of measurements over time share. */
#include "compare/gnuplot.h"

#include <math.h>
#include <string.h>

#include "compare/figures.h"
#include "orbit/time.h"

#define HOUR 3600.0
#define DAY  86400.0

#define MARGIN 0.01 /* beside the first and the last instant, of the axis */

void um_compare_gnuplot_name(FILE *file, const char *name)
{
  for (; *name != '\0'; name++) {
    if (strchr("\"\\@^_{}&~", *name) != NULL) fputs("\\\\", file);
    fputc(*name == '"' ? '\'' : *name, file);
  }
}

struct um_compare_gnuplot_axis um_compare_gnuplot_axis(double first, double last)
{
  struct um_compare_gnuplot_axis axis = {first, last, 60.0, "minutes"};
  if (last - first > 4.0 * HOUR) {
    axis.unit = HOUR;
    axis.word = "hours";
  }
  if (last - first > 4.0 * DAY) {
    axis.unit = DAY;
    axis.word = "days";
  }
  return axis;
}

double um_compare_gnuplot_at(const struct um_compare_gnuplot_axis *axis, double t_tai)
{
  return (t_tai - axis->first) / axis->unit;
}

void um_compare_gnuplot_head(FILE *file, const struct um_compare_gnuplot_axis *axis, int height)
{
  char start[32];
  um_orbit_time_format(axis->first, start);
  double length = fmax(um_compare_gnuplot_at(axis, axis->last), 1e-3);
  fprintf(file,
          "set terminal pngcairo size 1100,%d enhanced font 'Sans,11'\nset encoding utf8\n"
          "set datafile separator ','\nset grid linetype 1 linecolor rgb '#dcdcdc'\n"
          "t0 = strptime('%%Y-%%m-%%dT%%H:%%M:%%S', '%s')\n"
          "m(s) = (strptime('%%Y-%%m-%%dT%%H:%%M:%%S', s) - t0) / %.1f\n"
          "own(i) = strcol(2) eq q && strcol(3) eq o\n"
          "x(i) = own(i) ? m(strcol(i)) : NaN\ny(i) = own(i) ? column(i) : NaN\n"
          "s(i) = strcol(i) eq \"\" ? 0 : column(i)\nset xrange [%.6f:%.6f]\n"
          "set key outside right top samplen 2\nset lmargin 13\n",
          height, start, axis->unit, -MARGIN * length, (1.0 + MARGIN) * length);
}

void um_compare_gnuplot_shade(FILE *file, const struct um_compare_gnuplot_axis *axis, size_t count,
                              const double *time, const enum um_compare_segment *light)
{
  int object = 1;
  for (size_t k = 0, end; k < count; k = end) {
    for (end = k + 1; end < count && light[end] == light[k]; end++) {
    }
    if (light[k] == UM_SEGMENT_SUNLIT) continue;
    double from = k == 0 ? time[0] : 0.5 * (time[k - 1] + time[k]);
    double to = end == count ? time[end - 1] : 0.5 * (time[end - 1] + time[end]);
    fprintf(file,
            "set object %d rectangle from first %.6f, graph 0 to first %.6f, graph 1 fillcolor rgb "
            "'%s' fillstyle solid noborder behind\n",
            object++, um_compare_gnuplot_at(axis, from), um_compare_gnuplot_at(axis, to),
            light[k] == UM_SEGMENT_UMBRA ? "#d8dce6" : "#eceef3");
  }
}

void um_compare_gnuplot_channel(FILE *file, const char *name,
                                const struct um_compare_channel *channel)
{
  fprintf(file, "\nset output '%s.png'\nq = \"%s\"\no = \"", name,
          um_compare_quantity_name(channel->quantity));
  for (const char *at = channel->of; *at != '\0'; at++) {
    if (*at == '"' || *at == '\\') fputc('\\', file);
    fputc(*at, file);
  }
  fprintf(file, "\"\nset yrange [*:*] %sreverse\n",
          um_compare_is_magnitude(channel->quantity) ? "" : "no");
}

void um_compare_gnuplot_xlabel(FILE *file, const struct um_compare_gnuplot_axis *axis)
{
  char start[32];
  um_orbit_time_format(axis->first, start);
  fprintf(file, "set xlabel \"%s after %s (grey: umbra, light grey: penumbra)\"\n", axis->word,
          start);
}
