/* Curves and paths of passes on the page of a forecast: all of them over the days, and the best one
 * by one. */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "evidence/comparison/shade.h"
#include "forecast/forecast_page_impl.h"
#include "model/build/build.h"
#include "model/build/timeline.h"
#include "orbit/time.h"

#define N      UM_FORECAST_CURVE
#define SHOWN  12    /* passes one by one */
#define DRAWN  300   /* passes of an overview */
#define NIGHT  300.0 /* between looks at the Sun [s], */
#define NIGHTS 20000 /* .. of which there are no more than so many */

/* What of the sky belongs to a pass, at the instants of its curves. */
struct um_forecast_track {
  size_t n, row[N];                           /* of the curves: a short pass has some twice */
  double time[N];                             /* seconds since 1970, UTC */
  double azimuth[N], elevation[N], sunlit[N]; /* [deg], [deg], [1] */
  struct um_page_shade *shadow;               /* [nshadow] */
  size_t nshadow;
};

/* The scenario's orbit over the days, as the station sees it. */
static enum um_status orbit_of(struct um_forecast_page *k, size_t station, struct um_model **out)
{
  const struct um_forecast_held *held = (const void *)k->f; /* its first member */
  return um_forecast_orbit(k->w->context, &held->work, k->f, station, out);
}

/* The path of a pass, and the shadow behind its curves. */
static enum um_status follow(struct um_forecast_page *k, const struct um_model *orbit, size_t i)
{
  const struct um_forecast_pass *pass = &k->f->pass[i];
  struct um_forecast_track *track = &k->track[i];
  for (size_t j = 0; j < N; j++) {
    struct um_environment_sample sample;
    struct um_orbit_look look;
    double t = pass->curve_at[j];
    if (j > 0 && !(t > pass->curve_at[j - 1])) continue;
    UM_TRY(um_model_sample_seen(k->w->context, orbit, t, &sample, &look));
    track->time[track->n] = um_orbit_time_unix(t);
    track->azimuth[track->n] = look.azimuth / UM_DEG;
    track->elevation[track->n] = look.elevation / UM_DEG;
    track->sunlit[track->n] = sample.sunlit_fraction;
    track->row[track->n++] = j;
  }
  UM_TRY(um_compare_page_shade(k->w, orbit, pass->curve_at[0], pass->curve_at[N - 1]));
  track->shadow = k->w->shade;
  track->nshadow = k->w->nshade;
  return UM_OK;
}

/* Night and twilight of a station over the days, behind `shade` [*n], which has the room. */
static enum um_status nights(struct um_forecast_page *k, const struct um_model *orbit, size_t count,
                             struct um_page_shade *shade, size_t *n)
{
  static const char *const names[] = {"night", "twilight", ""};
  double step = (k->f->to - k->f->from) / (double)(count - 1);
  int last = 2;
  for (size_t j = 0; j < count; j++) {
    struct um_orbit_look look;
    double t = k->f->from + step * (double)j;
    UM_TRY(um_orbit_observer_look(k->w->context, &orbit->observer, orbit->trajectory, t, &look));
    const char *sky = um_forecast_sky(look.sun_elevation);
    int now = strcmp(sky, "night") == 0 ? 0 : strcmp(sky, "day") == 0 ? 2 : 1;
    double to = um_orbit_time_unix(t), from = last != 2 ? shade[*n - 1].to : to;
    if (now != 2 && now == last)
      shade[*n - 1].to = to;
    else if (now != 2) {
      shade[*n] = (struct um_page_shade){from, to, names[now]};
      (*n)++;
    }
    last = now;
  }
  return UM_OK;
}

/* ---- curves ---- */

/* Value of a band along a pass: magnitudes, or irradiances of its own heat. */
static const double *curve_of(const struct um_forecast *f, const double *curve, size_t b)
{
  return curve + (2 * b + (f->thermal[b] ? 1 : 0)) * N;
}

/* Panels of bands below that of the elevation. value, low, high: [nband][count]; low NULL: none. */
static enum um_status panels(struct um_forecast_page *k, size_t count, const double *elevation,
                             const double *value, const double *low, const double *high,
                             struct um_page_panel **out)
{
  const struct um_forecast *f = k->f;
  struct um_page_series *series;
  UM_TRY(UM_PAGE_ROOM(k->w, 1 + f->nband, &series));
  UM_TRY(UM_PAGE_ROOM(k->w, 1 + f->nband, out));
  series[0] = (struct um_page_series){.name = "elevation", .role = "model", .value = elevation};
  (*out)[0] = (struct um_page_panel){
      .name = "elevation", .unit = "deg", .zero = true, .series = series, .nseries = 1};
  for (size_t b = 0; b < f->nband; b++) {
    const char *name;
    UM_TRY(um_page_words(k->w, &name, "%s, %s%s%s", f->band[b],
                         f->thermal[b] ? "irradiance" : "magnitude (",
                         f->thermal[b] ? "" : um_forecast_system(f, b), f->thermal[b] ? "" : ")"));
    series[1 + b] = (struct um_page_series){.name = f->band[b],
                                            .role = "model",
                                            .value = value + b * count,
                                            .low = low != NULL ? low + b * count : NULL,
                                            .high = high != NULL ? high + b * count : NULL};
    (*out)[1 + b] =
        (struct um_page_panel){.name = name,
                               .unit = f->thermal[b] ? "W/m^2" : "mag",
                               .scale = f->thermal[b] ? UM_PAGE_LINEAR : UM_PAGE_MAGNITUDE,
                               .series = &series[1 + b],
                               .nseries = 1};
  }
  return UM_OK;
}

/* All passes of a station over the days. A gap parts one from the next. */
static enum um_status overview(struct um_forecast_page *k, const struct um_model *orbit,
                               size_t station)
{
  const struct um_forecast *f = k->f;
  struct um_page_panel *panel;
  struct um_page_shade *shade;
  double *time, *elevation, *value;
  const char *id, *title, *of;
  size_t npass = 0, drawn = 0, nshade = 0, at = 0;
  size_t looks = (size_t)fmin(2.0 + (f->to - f->from) / NIGHT, NIGHTS);
  for (size_t i = 0; i < f->npass && npass < DRAWN; i++)
    if (f->pass[i].station == station && f->pass[i].reason == NULL) npass++;
  size_t most = npass * (N + 1);
  if (npass == 0) return UM_OK;
  UM_TRY(UM_PAGE_ROOM(k->w, most, &time));
  UM_TRY(UM_PAGE_ROOM(k->w, most, &elevation));
  UM_TRY(UM_PAGE_ROOM(k->w, most * f->nband, &value));
  UM_TRY(UM_PAGE_ROOM(k->w, looks, &shade));
  for (size_t i = 0; i < f->npass && drawn < npass; i++) {
    const struct um_forecast_pass *pass = &f->pass[i];
    if (pass->station != station || pass->reason != NULL) continue;
    UM_TRY(follow(k, orbit, i));
    const struct um_forecast_track *track = &k->track[i];
    for (size_t j = 0; j <= track->n; j++, at++) {
      bool gap = j == track->n;
      time[at] = gap ? track->time[j - 1] + 1.0 : track->time[j];
      elevation[at] = gap ? (double)NAN : track->elevation[j];
      for (size_t b = 0; b < f->nband; b++)
        value[b * most + at] = gap ? (double)NAN : curve_of(f, pass->curve, b)[track->row[j]];
    }
    drawn++;
  }
  UM_TRY(nights(k, orbit, looks, shade, &nshade));
  UM_TRY(panels(k, most, elevation, value, NULL, NULL, &panel));
  UM_TRY(um_page_words(k->w, &id, "overview-%zu", station + 1));
  UM_TRY(um_page_words(k->w, &title, "Over %s", f->station[station].name));
  UM_TRY(um_page_words(k->w, &of, "The first %d passes. Drag over one to see it closer.", DRAWN));
  const struct um_page_figure figure = {
      .id = id, .title = title, .text = npass == DRAWN ? of : "Drag over a pass to see it closer."};
  const struct um_page_axis axis = {"time", "UTC", UM_PAGE_TIME, time, at};
  um_page_axes(k->page, &figure, &axis, shade, nshade, panel, 1 + f->nband);
  return UM_OK;
}

/* ---- one pass ---- */

/* Curves of the bands, and how far they are uncertain at one sigma, to both sides: [nband][N]. */
static enum um_status spread(struct um_forecast_page *k, const struct um_forecast_pass *pass,
                             const struct um_forecast_track *track, double *value, double **low,
                             double **high)
{
  const struct um_forecast *f = k->f;
  *low = *high = NULL;
  for (size_t b = 0; b < f->nband; b++)
    for (size_t j = 0; j < track->n; j++)
      value[b * N + j] = curve_of(f, pass->curve, b)[track->row[j]];
  if (f->nuncertain == 0) return UM_OK;
  UM_TRY(UM_PAGE_ROOM(k->w, f->nband * N, low));
  UM_TRY(UM_PAGE_ROOM(k->w, f->nband * N, high));
  for (size_t b = 0; b < f->nband; b++)
    for (size_t j = 0; j < track->n; j++) {
      double sigma = curve_of(f, pass->curve_sigma, b)[track->row[j]];
      (*low)[b * N + j] = value[b * N + j] - sigma;
      (*high)[b * N + j] = value[b * N + j] + sigma;
    }
  return UM_OK;
}

static enum um_status one(struct um_forecast_page *k, size_t i, size_t number)
{
  const struct um_forecast *f = k->f;
  const struct um_forecast_pass *pass = &f->pass[i];
  const struct um_forecast_track *track = &k->track[i];
  const char *id[2], *title[2], *when, *lit, *sky_now, *over = f->station[pass->station].name;
  struct um_page_panel *panel;
  double *value, *low, *high;
  UM_TRY(um_forecast_page_clock(k, pass->pass.culmination, &when));
  UM_TRY(um_forecast_page_light(k, pass, &lit));
  UM_TRY(um_forecast_page_sky(k, pass, &sky_now));
  UM_TRY(um_page_words(k->w, &id[0], "pass-%zu", number));
  UM_TRY(um_page_words(k->w, &title[0], "%s%s%s, %.0f\xc2\xb0 high, %s, %s", when,
                       f->nstation > 1 ? " over " : "", f->nstation > 1 ? over : "",
                       pass->pass.culmination_elevation / UM_DEG, sky_now, lit));
  UM_TRY(um_page_words(k->w, &id[1], "sky-%zu", number));
  UM_TRY(um_page_words(k->w, &title[1], "Path over %s, %s", over, when));
  const struct um_page_mark_at mark[] = {{track->time[0], "rises"},
                                         {um_orbit_time_unix(pass->pass.culmination), "highest"},
                                         {track->time[track->n - 1], "sets"}};
  const struct um_page_sky sky = {track->time,
                                  track->azimuth,
                                  track->elevation,
                                  track->sunlit,
                                  track->n,
                                  mark,
                                  sizeof mark / sizeof mark[0]};
  const struct um_page_figure along = {.id = id[0], .title = title[0]};
  const struct um_page_figure across = {.id = id[1], .title = title[1]};
  const struct um_page_axis time = {"time", "UTC", UM_PAGE_TIME, track->time, track->n};
  UM_TRY(UM_PAGE_ROOM(k->w, f->nband * N, &value));
  UM_TRY(spread(k, pass, track, value, &low, &high));
  UM_TRY(panels(k, N, track->elevation, value, low, high, &panel));
  um_page_axes(k->page, &along, &time, track->shadow, track->nshadow, panel, 1 + f->nband);
  um_page_sky(k->page, &across, &sky);
  return UM_OK;
}

/* Is a pass more worth a look than another: by night before by day, then the brighter, then the
 * warmer, then the higher. */
static bool is_better(const struct um_forecast *f, const struct um_forecast_pass *a,
                      const struct um_forecast_pass *b)
{
  if (um_forecast_page_dark(a) != um_forecast_page_dark(b)) return um_forecast_page_dark(a);
  for (size_t n = 0; n < f->nband; n++) {
    double u = f->thermal[n] ? -a->band[n].largest : a->band[n].brightest;
    double v = f->thermal[n] ? -b->band[n].largest : b->band[n].brightest;
    if (isnan(u) != isnan(v)) return isnan(v);
    if (u < v || u > v) return u < v;
  }
  return a->pass.culmination_elevation > b->pass.culmination_elevation;
}

/* The best passes, by time: best[*n] of SHOWN. */
static void choose(const struct um_forecast_page *k, size_t *best, size_t *n)
{
  const struct um_forecast *f = k->f;
  size_t rank[SHOWN];
  *n = 0;
  for (size_t i = 0; i < f->npass; i++) {
    if (f->pass[i].reason != NULL || k->track[i].n == 0) continue;
    size_t at = *n;
    while (at > 0 && is_better(f, &f->pass[i], &f->pass[rank[at - 1]])) at--;
    if (at == SHOWN) continue;
    if (*n < SHOWN) (*n)++;
    for (size_t j = *n - 1; j > at; j--) rank[j] = rank[j - 1];
    rank[at] = i;
  }
  for (size_t i = 0, m = 0; i < f->npass && m < *n; i++)
    for (size_t j = 0; j < *n; j++)
      if (rank[j] == i) best[m++] = i;
}

enum um_status um_forecast_page_curves(struct um_forecast_page *k)
{
  enum um_status status = UM_OK;
  const struct um_forecast *f = k->f;
  size_t best[SHOWN], n;
  UM_TRY(UM_PAGE_ROOM(k->w, f->npass, &k->track));
  um_page_section(k->page, "when", "When is it up, and how bright is it?", UM_PAGE_PLAIN);
  um_page_text(k->page, "Shaded: night, and twilight from sunset on, at the station.");
  if (f->nstation == 1) um_page_writer_picture(k->w, "passes.svg");
  for (size_t s = 0; f->nstation > 1 && s < f->nstation; s++) {
    const char *name;
    UM_TRY(um_page_words(k->w, &name, "passes-%s.svg", f->station[s].name));
    um_page_writer_picture(k->w, name);
  }
  for (size_t s = 0; status == UM_OK && s < f->nstation; s++) {
    struct um_model *orbit = NULL;
    status = orbit_of(k, s, &orbit);
    if (status == UM_OK) status = overview(k, orbit, s);
    um_model_destroy(k->w->context, &orbit);
  }
  if (status != UM_OK) return status;
  choose(k, best, &n);
  um_page_section(k->page, "best", "What does a pass look like?", UM_PAGE_PLAIN);
  if (n < f->npass)
    um_page_text(k->page, "%zu of %zu passes: by night before by day, the brightest first chosen.",
                 n, f->npass);
  um_page_text(k->page, "Shaded: the satellite is in the Earth's umbra or penumbra.");
  for (size_t i = 0; i < n; i++) UM_TRY(one(k, best[i], i + 1));
  return UM_OK;
}
