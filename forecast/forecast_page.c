/* report.html of a forecast: which passes are worth a look, when, and what each shows. */
#include <math.h>

#include "base/core/constants.h"
#include "forecast/forecast_page_impl.h"
#include "forecast/forecast_write.h"

/* To digits that are read; passes.csv has them all. */
static double rounded(double value, double step) { return step * round(value / step); }

static double significant(double value, int digits)
{
  return value > 0.0 ? rounded(value, pow(10.0, floor(log10(value)) + 1.0 - digits)) : value;
}

/* "V, brightest" in magnitudes, or "lwir, largest" in W/m^2, and its sigma. */
static enum um_status band_columns(struct um_forecast_page *k, size_t b,
                                   struct um_page_column *column, size_t *n)
{
  const struct um_forecast *f = k->f;
  bool thermal = f->thermal[b];
  double *value, *sigma;
  const char *name;
  UM_TRY(UM_PAGE_ROOM(k->w, f->npass, &value));
  UM_TRY(UM_PAGE_ROOM(k->w, f->npass, &sigma));
  for (size_t i = 0; i < f->npass; i++) {
    const struct um_forecast_pass *pass = &f->pass[i];
    value[i] = sigma[i] = NAN;
    if (pass->reason != NULL) continue;
    value[i] =
        thermal ? significant(pass->band[b].largest, 3) : rounded(pass->band[b].brightest, 0.01);
    if (f->nuncertain > 0)
      sigma[i] =
          significant(thermal ? pass->band_sigma[b].largest : pass->band_sigma[b].brightest, 2);
  }
  const char *unit = thermal ? "W/m^2" : "mag";
  if (thermal)
    UM_TRY(um_page_words(k->w, &name, "%s, largest", f->band[b]));
  else
    UM_TRY(um_page_words(k->w, &name, "%s, brightest (%s)", f->band[b], um_forecast_system(f, b)));
  column[(*n)++] = (struct um_page_column){.name = name, .unit = unit, .value = value};
  if (f->nuncertain == 0) return UM_OK;
  UM_TRY(um_page_words(k->w, &name, "%s, 1 sigma", f->band[b]));
  column[(*n)++] = (struct um_page_column){.name = name, .unit = unit, .value = sigma};
  return UM_OK;
}

static enum um_status table(struct um_forecast_page *k)
{
  static const struct um_page_figure figure = {.id = "passes",
                                               .title = "All passes",
                                               .text = "Times are UTC. Magnitudes are above the "
                                                       "atmosphere; irradiances have what effects "
                                                       "take of them.",
                                               .file = "passes.csv"};
  enum { STATION, RISE, TOP, SET, SKY, LIGHT, REASON, TEXTS };
  enum { ELEVATION, AZIMUTH, RANGE, NUMBERS };
  const struct um_forecast *f = k->f;
  const char **text[TEXTS];
  double *value[NUMBERS];
  struct um_page_column *column;
  size_t n = 0;
  bool failed = false;
  for (int c = 0; c < TEXTS; c++) UM_TRY(UM_PAGE_ROOM(k->w, f->npass, &text[c]));
  for (int c = 0; c < NUMBERS; c++) UM_TRY(UM_PAGE_ROOM(k->w, f->npass, &value[c]));
  UM_TRY(UM_PAGE_ROOM(k->w, TEXTS + NUMBERS + 2 * f->nband + f->nplace, &column));
  for (size_t i = 0; i < f->npass; i++) {
    const struct um_forecast_pass *pass = &f->pass[i];
    text[STATION][i] = f->station[pass->station].name;
    UM_TRY(um_forecast_page_clock(k, pass->pass.rise, &text[RISE][i]));
    UM_TRY(um_forecast_page_clock(k, pass->pass.culmination, &text[TOP][i]));
    UM_TRY(um_forecast_page_clock(k, pass->pass.set, &text[SET][i]));
    UM_TRY(um_forecast_page_light(k, pass, &text[LIGHT][i]));
    UM_TRY(um_forecast_page_sky(k, pass, &text[SKY][i]));
    text[REASON][i] = pass->reason != NULL ? pass->reason : "";
    failed = failed || pass->reason != NULL;
    value[ELEVATION][i] = rounded(pass->pass.culmination_elevation / UM_DEG, 0.1);
    value[AZIMUTH][i] = rounded(pass->pass.culmination_azimuth / UM_DEG, 0.1);
    value[RANGE][i] = rounded(pass->pass.culmination_range * 1e-3, 1.0);
  }
  if (f->nstation > 1)
    column[n++] = (struct um_page_column){.name = "station", .text = text[STATION]};
  column[n++] = (struct um_page_column){.name = "rises", .text = text[RISE]};
  column[n++] = (struct um_page_column){.name = "highest", .text = text[TOP]};
  column[n++] =
      (struct um_page_column){.name = "elevation", .unit = "deg", .value = value[ELEVATION]};
  for (size_t b = 0; b < f->nband; b++) UM_TRY(band_columns(k, b, column, &n));
  column[n++] = (struct um_page_column){.name = "sky", .text = text[SKY]};
  column[n++] = (struct um_page_column){.name = "satellite", .text = text[LIGHT]};
  column[n++] = (struct um_page_column){.name = "sets", .text = text[SET]};
  column[n++] = (struct um_page_column){.name = "azimuth", .unit = "deg", .value = value[AZIMUTH]};
  column[n++] = (struct um_page_column){.name = "range", .unit = "km", .value = value[RANGE]};
  if (failed) column[n++] = (struct um_page_column){.name = "not computed", .text = text[REASON]};
  um_page_section(k->page, "passes", "Which passes are there?", UM_PAGE_PLAIN);
  um_page_table(k->page, &figure, column, n, f->npass);
  return UM_OK;
}

/* ---- the page ---- */

static enum um_status lead(struct um_forecast_page *k)
{
  const struct um_forecast *f = k->f;
  size_t dark = 0, seen = 0;
  const char *from, *to;
  for (size_t i = 0; i < f->npass; i++) {
    const struct um_forecast_pass *pass = &f->pass[i];
    bool lit = pass->sunlit_at_rise || pass->sunlit_at_set || isfinite(pass->exit);
    dark += um_forecast_page_dark(pass);
    seen += um_forecast_page_dark(pass) && lit;
  }
  UM_TRY(um_forecast_page_clock(k, f->from, &from));
  UM_TRY(um_forecast_page_clock(k, f->to, &to));
  um_page_lead(k->page,
               "%zu passes above %g degrees. %zu of them are at night or in twilight, %zu of these "
               "with the satellite in sunlight at times.",
               f->npass, f->minimum_elevation / UM_DEG, dark, seen);
  um_page_fact(k->page, "days", "%s to %s UTC", from, to);
  for (size_t s = 0; s < f->nstation; s++)
    um_page_fact(k->page, "station", "%s: latitude %.4g\xc2\xb0, longitude %.4g\xc2\xb0",
                 f->station[s].name, f->station[s].latitude / UM_DEG,
                 f->station[s].longitude / UM_DEG);
  if (f->nuncertain > 0)
    um_page_fact(k->page, "uncertain", "%zu parameter%s; bands about curves are 1 sigma",
                 f->nuncertain, f->nuncertain == 1 ? "" : "s");
  return UM_OK;
}

static enum um_status fill(struct um_page_writer *w, const void *of)
{
  struct um_forecast_page whole = {.w = w, .page = w->page, .f = of}, *k = &whole;
  UM_TRY(lead(k));
  if (k->f->npass == 0) return UM_OK;
  UM_TRY(table(k));
  return um_forecast_page_curves(k);
}

enum um_status um_forecast_page(struct um_context *context, const struct um_forecast *forecast,
                                struct um_core_folder *folder)
{
  const struct um_page_head head = {.command = "umbra forecast",
                                    .kind = "forecast",
                                    .title = forecast->name,
                                    .about = ": passes"};
  return um_page_report(context, &head, fill, forecast, folder);
}
