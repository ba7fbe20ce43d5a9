/* Light on the page of a run: curves of every band, and what they are made of. */
#include <math.h>

#include "base/core/constants.h"
#include "model/build/bands.h"
#include "output/lightcurve_impl.h"
#include "output/page_impl.h"

#define LOG_ABOVE 5.0 /* largest over the mean in sunlight, from where an axis is logarithmic */

static bool has_magnitudes(const struct um_output_run *run, size_t band)
{
  const struct um_model_result *r = run->result;
  if (run->model->band[band].to > UM_INFRARED_FROM) return false;
  for (size_t k = 0; k < r->nobs; k++)
    if (isfinite(r->magnitude_ab[k * r->nband + band])) return true;
  return false;
}

/* Mirrors outshine the rest by orders of magnitude. */
static enum um_page_scale scale_of(const struct um_output_run *run, const double *value)
{
  double largest = 0.0, sum = 0.0;
  size_t lit = 0;
  for (size_t k = 0; k < run->result->nobs; k++) {
    largest = fmax(largest, value[k]);
    if (!(run->tables->sunlit[k] > UM_UMBRA_MOST)) continue;
    sum += value[k];
    lit++;
  }
  return lit > 0 && largest > LOG_ABOVE * sum / (double)lit ? UM_PAGE_LOG : UM_PAGE_LINEAR;
}

/* "vis_mag_ab", as lightcurve.csv calls it. */
static enum um_status column_name(struct um_output_page *p, size_t band, size_t column,
                                  const char **out)
{
  return um_page_words(p->w, out, "%s%s", p->run->model->band[band].name,
                       um_output_lightcurve_tail(column));
}

static enum um_status heading(struct um_output_page *p, size_t band, const char *what,
                              const char **out)
{
  const struct um_optics_band *b = &p->run->model->band[band];
  return um_page_words(p->w, out, "%s %g\xe2\x80\x93%g \xc2\xb5m, %s", b->name, b->from * 1e6,
                       b->to * 1e6, what);
}

/* Magnitudes with the error of their flux: dm = 2.5 / ln 10 of its relative error. */
static enum um_status magnitudes(struct um_output_page *p, size_t band,
                                 struct um_page_series series[2], struct um_page_panel *panel)
{
  const struct um_model_result *r = p->run->result;
  double *ab, *vega, *error;
  const char *name;
  UM_TRY(um_output_page_column(p, &ab));
  UM_TRY(um_output_page_column(p, &vega));
  UM_TRY(um_output_page_column(p, &error));
  for (size_t k = 0; k < r->nobs; k++) {
    size_t at = k * r->nband + band;
    ab[k] = isfinite(r->magnitude_ab[at]) ? r->magnitude_ab[at] : (double)NAN;
    vega[k] = ab[k] - r->vega_ab[band];
    error[k] = 2.5 / M_LN10 * r->magnitude_error[at] / pow(10.0, -0.4 * ab[k]);
  }
  const char *column[2];
  UM_TRY(column_name(p, band, UM_LIGHTCURVE_MAG_AB, &column[0]));
  UM_TRY(column_name(p, band, UM_LIGHTCURVE_MAG_VEGA, &column[1]));
  UM_TRY(heading(p, band, "magnitude", &name));
  bool is_vega = um_model_band_is_vega(p->run->model, band); /* the other one can be shown, too */
  series[0] = (struct um_page_series){.name = "AB",
                                      .role = "model",
                                      .column = column[0],
                                      .hidden = is_vega,
                                      .value = ab,
                                      .error = error};
  series[1] = (struct um_page_series){.name = "Vega",
                                      .role = "model",
                                      .column = column[1],
                                      .hidden = !is_vega,
                                      .value = vega,
                                      .error = error};
  *panel = (struct um_page_panel){
      .name = name, .unit = "mag", .scale = UM_PAGE_MAGNITUDE, .series = series, .nseries = 2};
  return UM_OK;
}

static enum um_status intensities(struct um_output_page *p, size_t band,
                                  struct um_page_series *series, struct um_page_panel *panel)
{
  const struct um_model_result *r = p->run->result;
  double *value, *error;
  const char *name;
  UM_TRY(um_output_page_column(p, &value));
  UM_TRY(um_output_page_column(p, &error));
  for (size_t k = 0; k < r->nobs; k++) {
    value[k] = um_model_result_intensity(r, k, band, -1);
    error[k] = r->standard_error[k * r->nband + band];
  }
  const char *column;
  UM_TRY(column_name(p, band, UM_LIGHTCURVE_TOTAL, &column));
  UM_TRY(heading(p, band, "radiant intensity", &name));
  *series = (struct um_page_series){.name = p->run->model->band[band].name,
                                    .role = "model",
                                    .column = column,
                                    .value = value,
                                    .error = error};
  *panel = (struct um_page_panel){.name = name,
                                  .unit = "W/sr",
                                  .scale = scale_of(p->run, value),
                                  .series = series,
                                  .nseries = 1};
  return UM_OK;
}

/* The extremes of a band, as the lead has them. */
static void say(struct um_output_page *p, size_t band)
{
  const struct um_model_result *r = p->run->result;
  const char *name = p->run->model->band[band].name;
  size_t most = 0, least = 0;
  for (size_t k = 1; k < r->nobs; k++) {
    double value = um_model_result_intensity(r, k, band, -1);
    if (value > um_model_result_intensity(r, most, band, -1)) most = k;
    if (value < um_model_result_intensity(r, least, band, -1)) least = k;
  }
  double low = um_model_result_intensity(r, least, band, -1);
  double high = um_model_result_intensity(r, most, band, -1);
  if (has_magnitudes(p->run, band))
    um_page_fact(p->page, name, "%.4g to %.4g W/sr; brightest AB %.2f, Vega %.2f", low, high,
                 r->magnitude_ab[most * r->nband + band],
                 r->magnitude_ab[most * r->nband + band] - r->vega_ab[band]);
  else
    um_page_fact(p->page, name, "%.4g to %.4g W/sr", low, high);
}

enum um_status um_output_page_light(struct um_output_page *p)
{
  const struct um_output_run *run = p->run;
  size_t n = run->result->nband, npanel = 0;
  struct um_page_series *series;
  struct um_page_panel *panel;
  if (!run->model->has_observer) return UM_OK;
  UM_TRY(UM_PAGE_ROOM(p->w, 3 * n, &series));
  UM_TRY(UM_PAGE_ROOM(p->w, 2 * n, &panel));
  for (size_t b = 0; b < n; b++) {
    say(p, b);
    UM_TRY(intensities(p, b, &series[3 * b], &panel[npanel++]));
    if (has_magnitudes(run, b)) UM_TRY(magnitudes(p, b, &series[3 * b + 1], &panel[npanel++]));
  }
  um_page_section(p->page, "light", "What does the telescope see?", UM_PAGE_PLAIN);
  um_page_text(p->page, "Radiant intensity toward the observer, above the atmosphere. The band "
                        "about a curve is one standard error of the ray tracing.");
  if (p->w->nshade > 0)
    um_page_text(p->page, "Shaded: the satellite is in the Earth's umbra or penumbra.");
  um_page_writer_picture(p->w, "lightcurve.svg");
  const struct um_page_figure figure = {
      .id = "light", .title = "Light curves", .file = "lightcurve.csv"};
  um_page_axes(p->page, &figure, &p->w->time, p->w->shade, p->w->nshade, panel, npanel);
  return UM_OK;
}

/* One panel a band of what adds up to it: by mechanism, or by material. */
static enum um_status parts_of(struct um_output_page *p, size_t band, bool by_material,
                               struct um_page_series *series, struct um_page_panel *panel)
{
  static const char *const names[] = {[UM_MECHANISM_SUN] = "Sun",
                                      [UM_MECHANISM_EARTH] = "Earth",
                                      [UM_MECHANISM_EMITTED] = "emitted",
                                      [UM_MECHANISM_INTERREFLECTED] = "inter-reflected",
                                      [UM_MECHANISM_OTHER] = "Moon"};
  const struct um_model_result *r = p->run->result;
  size_t n = by_material ? r->nmaterial : UM_MECHANISM_COUNT, used = 0;
  const char *name;
  for (size_t i = 0; i < n; i++) {
    double *value, largest = 0.0;
    UM_TRY(um_output_page_column(p, &value));
    for (size_t k = 0; k < r->nobs; k++) {
      const double *at = r->intensity + (k * r->nband + band) * r->nmaterial * UM_MECHANISM_COUNT;
      if (!by_material) value[k] = um_model_result_intensity(r, k, band, (int)i);
      for (size_t m = 0; by_material && m < UM_MECHANISM_COUNT; m++)
        value[k] += at[i * UM_MECHANISM_COUNT + m];
      largest = fmax(largest, fabs(value[k]));
    }
    if (!(largest > 0.0)) continue;
    series[used++] = (struct um_page_series){
        .name = by_material ? um_geometry_material_name(p->run->model->geometry, i) : names[i],
        .role = "part",
        .mark = UM_PAGE_AREA,
        .value = value};
  }
  UM_TRY(heading(p, band, by_material ? "by material" : "by mechanism", &name));
  *panel = (struct um_page_panel){
      .name = name, .unit = "W/sr", .stacked = true, .series = series, .nseries = used};
  return UM_OK;
}

static enum um_status split(struct um_output_page *p, bool by_material,
                            const struct um_page_figure *figure)
{
  const struct um_model_result *r = p->run->result;
  size_t n = by_material ? r->nmaterial : UM_MECHANISM_COUNT;
  struct um_page_series *series;
  struct um_page_panel *panel;
  UM_TRY(UM_PAGE_ROOM(p->w, n * r->nband, &series));
  UM_TRY(UM_PAGE_ROOM(p->w, r->nband, &panel));
  for (size_t b = 0; b < r->nband; b++)
    UM_TRY(parts_of(p, b, by_material, &series[b * n], &panel[b]));
  um_page_axes(p->page, figure, &p->w->time, p->w->shade, p->w->nshade, panel, r->nband);
  return UM_OK;
}

enum um_status um_output_page_split(struct um_output_page *p)
{
  static const struct um_page_figure mechanism = {
      .id = "mechanisms",
      .title = "Light by mechanism",
      .text = "Sun, Moon, Earth: reflected once. Emitted: the satellite's own heat. "
              "Inter-reflected: light that left one surface and was reflected by another."};
  static const struct um_page_figure material = {.id = "materials", .title = "Light by material"};
  if (!p->run->model->has_observer || p->run->result->nmaterial == 0) return UM_OK;
  um_page_section(p->page, "origin", "Where does the light come from?", UM_PAGE_PLAIN);
  UM_TRY(split(p, false, &mechanism));
  return split(p, true, &material);
}

enum um_status um_output_page_counts(struct um_output_page *p)
{
  const struct um_model_result *r = p->run->result;
  static const struct um_page_figure figure = {.id = "counts", .title = "Count rates"};
  struct um_page_series *series;
  struct um_page_panel *panel;
  if (!p->run->model->has_observer || r->nsensor == 0) return UM_OK;
  UM_TRY(UM_PAGE_ROOM(p->w, r->nsensor, &series));
  UM_TRY(UM_PAGE_ROOM(p->w, r->nsensor, &panel));
  for (size_t s = 0; s < r->nsensor; s++) {
    double *value, *error;
    UM_TRY(um_output_page_column(p, &value));
    UM_TRY(um_output_page_column(p, &error));
    for (size_t k = 0; k < r->nobs; k++) {
      value[k] = r->count_rate[k * r->nsensor + s];
      error[k] = r->count_rate_error[k * r->nsensor + s];
    }
    series[s] = (struct um_page_series){
        .name = p->run->model->sensor[s].name, .role = "model", .value = value, .error = error};
    panel[s] = (struct um_page_panel){
        .name = p->run->model->sensor[s].name, .unit = "1/s", .series = &series[s], .nseries = 1};
  }
  um_page_section(p->page, "counts", "What does the detector count?", UM_PAGE_PLAIN);
  um_page_text(p->page, "Expected counts of the satellite, without the sky and without noise.");
  um_page_writer_picture(p->w, "counts.svg");
  um_page_axes(p->page, &figure, &p->w->time, p->w->shade, p->w->nshade, panel, r->nsensor);
  return UM_OK;
}
