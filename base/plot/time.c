/* The axis of time and the Earth's shadow on it. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/plot/plot_impl.h"

#define HOUR   3600.0
#define DAY    86400.0
#define MARGIN 0.01 /* beside the first and the last instant, of the axis */

struct um_plot_time um_plot_time(double first, double last, const char *start)
{
  struct um_plot_time time = {.first = first, .last = last, .unit = 60.0, .word = "minutes"};
  snprintf(time.start, sizeof time.start, "%s", start);
  if (last - first > 4.0 * HOUR) {
    time.unit = HOUR;
    time.word = "hours";
  }
  if (last - first > 4.0 * DAY) {
    time.unit = DAY;
    time.word = "days";
  }
  return time;
}

double um_plot_time_at(const struct um_plot_time *time, double t_tai)
{
  return (t_tai - time->first) / time->unit;
}

void um_plot_time_axis(struct um_plot *plot, const struct um_plot_time *time)
{
  double length = fmax(um_plot_time_at(time, time->last), 1e-3);
  um_plot_add(plot,
              "clock = '%%Y-%%m-%%dT%%H:%%M:%%S'\nt0 = strptime(clock, %s)\n"
              "x(i) = (strptime(clock, strcol(i)) - t0) / %.1f\n"
              "set xrange [%.6f:%.6f]\n",
              time->start, time->unit, -MARGIN * length, (1.0 + MARGIN) * length);
}

void um_plot_time_label(struct um_plot *plot, const struct um_plot_time *time)
{
  char text[128], start[32];
  snprintf(start, sizeof start, "%s", time->start);
  if (strlen(start) > 10 && start[10] == 'T') start[10] = ' ';
  size_t n = strcspn(start, "Z");
  if (n > 4 && strncmp(start + n - 4, ".000", 4) == 0) n -= 4;
  snprintf(text, sizeof text, "%s after %.*s UTC%s", time->word, (int)n, start,
           plot->objects > 0 ? "; grey: umbra, light grey: penumbra" : "");
  um_plot_add(plot, "set xlabel %s noenhanced\n", text);
}

bool um_plot_shadow_next(size_t count, const double *t, const double *sunlit, size_t *k,
                         struct um_plot_shadow *out)
{
  while (*k < count) {
    size_t first = *k, end = first + 1;
    bool lit = sunlit[first] >= UM_SUNLIGHT_LEAST, dark = sunlit[first] <= UM_UMBRA_MOST;
    while (end < count && (sunlit[end] >= UM_SUNLIGHT_LEAST) == lit &&
           (sunlit[end] <= UM_UMBRA_MOST) == dark)
      end++;
    *k = end;
    if (lit) continue;
    out->from = first == 0 ? t[0] : 0.5 * (t[first - 1] + t[first]);
    out->to = end == count ? t[end - 1] : 0.5 * (t[end - 1] + t[end]);
    out->umbra = dark;
    return true;
  }
  return false;
}

void um_plot_shade(struct um_plot *plot, const struct um_plot_time *time, size_t count,
                   const double *t_tai, const double *sunlit)
{
  struct um_plot_shadow shadow;
  for (size_t k = 0; um_plot_shadow_next(count, t_tai, sunlit, &k, &shadow);)
    um_plot_add(plot,
                "set object %d rectangle from first %.6f, graph 0 to first %.6f, graph 1 "
                "fillcolor rgb %s fillstyle solid noborder behind\n",
                ++plot->objects, um_plot_time_at(time, shadow.from),
                um_plot_time_at(time, shadow.to), shadow.umbra ? "#d8dce6" : "#eceef3");
}
