/* Picture of a forecast: what is seen of each pass against the time of night in UTC, a colour a
 * night. Nights part at noon of the station's mean solar time. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/plot/plot.h"
#include "forecast/forecast_write.h"
#include "orbit/time.h"

#define WIDTH   1100 /* pixels */
#define LEFT    90
#define RIGHT   (WIDTH - 30)
#define TOP     80
#define PANEL   220
#define GAP     34
#define KEYS    8   /* nights with a name */
#define FAINTER 3.0 /* shown below the brightest of the faintest pass: the umbra is not [mag] */
#define HOUR    3600.0
#define DAY     86400.0

/* UTC of a time, and the noon of mean solar time at a station before it, as modified Julian dates.
 */
static void clock_of(const struct um_forecast_station *station, double t, double *utc, double *noon)
{
  double mjd, seconds, turn = station->longitude / (2.0 * UM_PI);
  um_orbit_time_utc_clock(t, &mjd, &seconds);
  *utc = mjd + seconds / DAY;
  *noon = floor(*utc + turn - 0.5) + 0.5 - turn;
}

/* The night's noon as a modified Julian date, and hours since 0 h UTC of its date. */
static void night_of(const struct um_forecast_station *station, double t, double *night,
                     double *hours)
{
  double utc;
  clock_of(station, t, &utc, night);
  *hours = (utc - floor(*night)) * DAY / HOUR;
}

static bool is_shown(const struct um_forecast_pass *pass, size_t station)
{
  return pass->reason == NULL && pass->station == station;
}

/* A block of data a pass: hours, then two columns a band, and where something is uncertain two more
 * a band of its sigmas behind them all. Its night begins at its rise. */
static void data(struct um_plot *plot, const struct um_forecast *f, size_t i)
{
  const size_t n = UM_FORECAST_CURVE;
  const struct um_forecast_pass *pass = &f->pass[i];
  double night, hours;
  night_of(&f->station[pass->station], pass->pass.rise, &night, &hours);
  um_plot_add(plot, "$pass%zu << EOD\n", i);
  for (size_t k = 0; k < n; k++) {
    um_plot_add(plot, "%.5f", hours + (pass->curve_at[k] - pass->pass.rise) / HOUR);
    for (size_t b = 0; b < f->nband; b++)
      um_plot_add(plot, ",%g,%g", pass->curve[2 * b * n + k], pass->curve[(2 * b + 1) * n + k]);
    for (size_t b = 0; f->nuncertain > 0 && b < f->nband; b++)
      um_plot_add(plot, ",%g,%g", pass->curve_sigma[2 * b * n + k],
                  pass->curve_sigma[(2 * b + 1) * n + k]);
    um_plot_add(plot, "\n");
  }
  um_plot_add(plot, "EOD\n");
}

/* UTC dates of a pass's night, six hours before and after midnight of mean solar time:
 * "2016-09-21/22", or one date where they are the same. */
static void date(const struct um_forecast_station *station, double t, char out[32])
{
  double utc, noon;
  char morning[32];
  clock_of(station, t, &utc, &noon);
  um_orbit_time_format(t + (noon + 0.25 - utc) * DAY, out);
  um_orbit_time_format(t + (noon + 0.75 - utc) * DAY, morning);
  out[10] = '\0';
  if (strncmp(out, morning, 10) != 0) snprintf(out + 10, 22, "/%.2s", morning + 8);
}

/* Where curves lie [h]. */
static void extent(const struct um_forecast *f, size_t station, double *from, double *to)
{
  *from = INFINITY;
  *to = -INFINITY;
  for (size_t i = 0; i < f->npass; i++) {
    double night, hours;
    const struct um_forecast_pass *pass = &f->pass[i];
    if (!is_shown(pass, station)) continue;
    night_of(&f->station[station], pass->pass.rise, &night, &hours);
    *from = fmin(*from, hours);
    *to = fmax(*to, hours + (pass->pass.set - pass->pass.rise) / HOUR);
  }
}

/* "linecolor rgb '#..'" by day, "linetype N" of the night by night. */
static void colour(struct um_plot *plot, bool day, size_t nights)
{
  if (day)
    um_plot_add(plot, "linecolor rgb %s ", "#c4c8d0");
  else
    um_plot_add(plot, "linetype %zu ", (nights - 1) % 8 + 1);
}

/* One sigma to both sides of a curve. */
static void shade(struct um_plot *plot, const struct um_forecast *f, size_t pass, size_t band,
                  double power)
{
  size_t value = 2 + 2 * band + (f->thermal[band] ? 1 : 0), sigma = value + 2 * f->nband;
  um_plot_add(
      plot,
      ", $pass%zu using 1:((column(%zu) - column(%zu)) / %g):((column(%zu) + column(%zu)) / "
      "%g) with filledcurves fillstyle transparent solid 0.3 noborder ",
      pass, value, sigma, power, value, sigma, power);
}

static void curves(struct um_plot *plot, const struct um_forecast *f, size_t station, size_t band,
                   double power)
{
  double last = NAN, night, hours;
  size_t nights = 0;
  bool day_named = false;
  um_plot_add(plot, "plot NaN notitle");
  for (size_t i = 0; i < f->npass; i++) {
    const struct um_forecast_pass *pass = &f->pass[i];
    char title[32] = "";
    bool day = strcmp(um_forecast_sky(pass->sun_elevation), "day") == 0;
    if (!is_shown(pass, station)) continue;
    night_of(&f->station[station], pass->pass.rise, &night, &hours);
    if (!day && night != last) {
      if (nights < KEYS) date(&f->station[station], pass->pass.rise, title);
      nights++;
      last = night;
    }
    if (day && !day_named) {
      snprintf(title, sizeof title, "by day");
      day_named = true;
    }
    if (f->nuncertain > 0) {
      shade(plot, f, i, band, f->thermal[band] ? power : 1.0);
      colour(plot, day, nights);
      um_plot_add(plot, "notitle");
    }
    um_plot_add(plot, ", $pass%zu using 1:(column(%zu) / %g) with lines linewidth 1.6 ", i,
                2 + 2 * band + (f->thermal[band] ? 1 : 0), f->thermal[band] ? power : 1.0);
    colour(plot, day, nights);
    um_plot_add(plot, "title %s noenhanced", title);
  }
  um_plot_add(plot, "\n");
}

/* The clock of UTC, "22:30", over what the curves span [h]. */
static void hours_axis(struct um_plot *plot, double from, double to, bool named)
{
  const double most[] = {12.0, 5.0, 1.5, 0.5}, steps[] = {2.0, 1.0, 0.5, 0.25};
  double step = 1.0 / 30.0; /* of a pass alone: two minutes */
  for (size_t i = sizeof most / sizeof *most; i-- > 0;)
    if (to - from > most[i]) step = steps[i];
  um_plot_xnumbers(plot, named);
  um_plot_add(plot, "set xtics (");
  for (double first = ceil(from / step) * step, h = first; h <= to; h += step) {
    char label[16] = "";
    int minutes = (int)lround(fmod(h, 24.0) * 60.0);
    if (named) snprintf(label, sizeof label, "%02d:%02d", minutes / 60, minutes % 60);
    um_plot_add(plot, h > first ? ", %s %.4f" : "%s %.4f", label, h);
  }
  um_plot_add(plot, ")\n");
  if (named) um_plot_add(plot, "set xlabel %s noenhanced\n", "UTC");
}

static void panel(struct um_plot *plot, const struct um_forecast *f, size_t station, size_t band,
                  double from, double to)
{
  double largest = 0.0;
  char unit[80], words[160];
  double bright = INFINITY, faint = -INFINITY;
  bool seen = false; /* gnuplot refuses curves without a point */
  for (size_t i = 0; i < f->npass; i++) {
    if (!is_shown(&f->pass[i], station)) continue;
    const struct um_forecast_band *of = &f->pass[i].band[band];
    largest = fmax(largest, of->largest);
    bright = fmin(bright, of->brightest);
    faint = fmax(faint, of->brightest);
    seen = seen || isfinite(f->thermal[band] ? of->largest : of->brightest);
  }
  double power = um_plot_power(largest, "W/m^2", unit);
  if (f->thermal[band])
    snprintf(words, sizeof words, "irradiance [%s]", unit);
  else
    snprintf(words, sizeof words, "magnitude (%s)", um_forecast_system(f, band));
  um_plot_ylabel(plot, f->band[band], words);
  if (!seen)
    um_plot_add(plot, "set yrange [0:1] noreverse\nset format y ''\n");
  else if (f->thermal[band])
    um_plot_add(plot, "set yrange [0:*] noreverse\nset format y '%%g'\n");
  else
    um_plot_add(plot, "set yrange [%.3f:%.3f] reverse\nset format y '%%g'\n", bright - 0.5,
                faint + FAINTER);
  int top = TOP + (int)band * (PANEL + GAP);
  um_plot_panel(plot, LEFT, top, RIGHT, top + PANEL);
  hours_axis(plot, from, to, band + 1 == f->nband);
  if (seen)
    curves(plot, f, station, band, power);
  else
    um_plot_add(plot, "plot -1 notitle\n");
}

static void picture(struct um_plot *plot, const struct um_forecast *f, size_t station)
{
  char name[160], title[320];
  double from, to;
  extent(f, station, &from, &to);
  if (!(to > from) || f->nband == 0) return;
  snprintf(name, sizeof name, "passes-%.100s", f->station[station].name);
  snprintf(title, sizeof title, "%.120s over %.120s", f->name, f->station[station].name);
  um_plot_picture(plot, f->nstation == 1 ? "passes" : name, WIDTH,
                  TOP + (int)f->nband * (PANEL + GAP) + 30);
  um_plot_title(plot, title,
                f->nuncertain > 0 ? "a colour a night, named by its dates in UTC; shaded: 1 sigma"
                                  : "a colour a night, named by its dates in UTC");
  for (size_t i = 0; i < f->npass; i++)
    if (is_shown(&f->pass[i], station)) data(plot, f, i);
  double margin = fmax(0.02 * (to - from), 0.05);
  um_plot_add(plot, "set xrange [%.4f:%.4f]\n", from - margin, to + margin);
  for (size_t b = 0; b < f->nband; b++) panel(plot, f, station, b, from - margin, to + margin);
}

enum um_status um_forecast_plot(struct um_context *context, const struct um_forecast *forecast,
                                const char *folder)
{
  struct um_plot *plot = NULL;
  UM_TRY(um_plot_create(context, folder, "passes.gp", &plot));
  for (size_t s = 0; s < forecast->nstation; s++) picture(plot, forecast, s);
  return um_plot_draw(context, &plot);
}
