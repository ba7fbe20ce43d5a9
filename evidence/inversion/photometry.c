/* Frames to count rates, stars to a calibration. */
#include "evidence/inversion/photometry.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "base/core/text.h"
#include "environment/airmass.h"
#include "evidence/comparison/predict.h"
#include "evidence/measurements/set_group.h"
#include "model/build/timeline.h"
#include "model/products/star.h"
#include "orbit/time.h"
#include "output/fits.h"

/* ---- frames ---- */

/* A number by one of two keys; UM_ERR_INPUT where neither is there. */
static enum um_status number(struct um_context *context, const struct um_output_fits *f,
                             const char *key, const char *other, double *out)
{
  *out = um_output_fits_number(f, key);
  if (isnan(*out) && other != NULL) *out = um_output_fits_number(f, other);
  if (isfinite(*out)) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "%s: header has no %s%s%s; accepted: a number",
                      f->path, key, other != NULL ? " or " : "", other != NULL ? other : "");
}

/* Mid-exposure: what DATE-AVG says, else half an exposure after the start. */
static enum um_status read_time(struct um_context *context, const struct um_output_fits *f,
                                double exposure, double *t)
{
  char text[72];
  const char *key = "DATE-AVG";
  um_output_fits_text(f, key, text);
  if (text[0] == '\0') {
    key = "DATE-OBS";
    um_output_fits_text(f, key, text);
  }
  enum um_status status = um_orbit_time_parse(context, text, t);
  if (status != UM_OK) um_core_message_prefix(context, "%s: %s", f->path, key);
  if (strcmp(key, "DATE-OBS") == 0) *t += 0.5 * exposure;
  return status;
}

/* The sensor's name, of the printable ASCII that FITS allows (Pence et al. 2010, 4.2.1). */
static enum um_status read_sensor(struct um_context *context, const struct um_output_fits *f,
                                  char out[72])
{
  um_output_fits_text(f, "INSTRUME", out);
  for (const unsigned char *c = (const unsigned char *)out; *c != '\0'; c++)
    if (*c < 0x20 || *c > 0x7e)
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s: INSTRUME holds the byte 0x%02x; accepted: printable ASCII (0x20 to "
                          "0x7e)",
                          f->path, *c);
  if (um_core_name_is_safe(out)) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s: INSTRUME is '%s'; accepted: " UM_CORE_NAME_ACCEPTED, f->path, out);
}

static enum um_status measure(struct um_context *context, const struct um_output_fits *f,
                              const struct um_instrument_aperture *aperture,
                              struct um_compare_photometry *out)
{
  struct um_instrument_counts counts = {.width = f->width, .height = f->height, .value = f->value};
  struct um_instrument_aperture a = *aperture;
  UM_TRY(number(context, f, "EXPTIME", "EXPOSURE", &out->exposure));
  UM_TRY(number(context, f, "GAIN", "EGAIN", &counts.gain));
  UM_TRY(number(context, f, "RDNOISE", NULL, &counts.read_noise));
  if (!(out->exposure > 0.0))
    return um_core_fail(context, UM_ERR_INPUT, "%s: exposure of %g s; accepted: above 0", f->path,
                        out->exposure);
  UM_TRY(read_time(context, f, out->exposure, &out->t_tai));
  counts.saturation = um_output_fits_number(f, "SATURATE");
  if (isnan(counts.saturation)) counts.saturation = INFINITY;
  out->airmass = um_output_fits_number(f, "AIRMASS");
  UM_TRY(read_sensor(context, f, out->sensor));
  a.x = isnan(a.x) ? 0.5 * (f->width - 1) : a.x - 1.0;
  a.y = isnan(a.y) ? 0.5 * (f->height - 1) : a.y - 1.0;
  enum um_status status = um_instrument_aperture_sum(context, &counts, &a, &out->sum);
  if (status != UM_OK) um_core_message_prefix(context, "%s", f->path);
  out->rate = out->sum.net / out->exposure;
  out->sigma = out->sum.error / out->exposure;
  return status;
}

enum um_status um_compare_photometry_measure(struct um_context *context, const char *path,
                                             const struct um_instrument_aperture *aperture,
                                             struct um_compare_photometry *out)
{
  struct um_output_fits *f = NULL;
  *out = (struct um_compare_photometry){0};
  UM_TRY(um_output_read_fits(context, path, &f));
  enum um_status status = measure(context, f, aperture, out);
  um_output_fits_destroy(context, &f);
  return status;
}

static int by_time(const void *a, const void *b)
{
  const struct um_compare_photometry *x = a, *y = b;
  return (x->t_tai > y->t_tai) - (x->t_tai < y->t_tai);
}

static enum um_status add(struct um_context *context, const struct um_compare_photometry *p,
                          struct um_compare_set *set)
{
  struct um_compare_measurement row = {.t_tai = p->t_tai,
                                       .value = p->rate,
                                       .sigma = p->sigma,
                                       .exposure = p->exposure,
                                       .flag = p->sum.saturated > 0,
                                       .satellite_height = NAN,
                                       .azimuth = NAN,
                                       .elevation = NAN,
                                       .line = 2 + (int)set->made->count,
                                       .station = SIZE_MAX};
  if (p->sensor[0] == '\0')
    return um_core_fail(context, UM_ERR_INPUT,
                        "a header has no INSTRUME; accepted: the scenario's name of the sensor");
  UM_TRY(um_compare_set_channel(context, set, UM_QUANTITY_COUNT_RATE, p->sensor, &row.channel));
  UM_TRY(um_compare_set_track(context, set, "", &row.track));
  return um_compare_set_add(context, set, &row);
}

enum um_status um_compare_photometry_set(struct um_context *context,
                                         const struct um_compare_photometry *frame, size_t n,
                                         const char *path, struct um_compare_measurements **out)
{
  enum um_status status;
  struct um_compare_set set = {0};
  struct um_compare_photometry *sorted = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, n, sizeof *sorted, &sorted));
  memcpy(sorted, frame, n * sizeof *sorted);
  qsort(sorted, n, sizeof *sorted, by_time);
  UM_CHECK(um_compare_set_begin(context, path, "time_utc", &set));
  for (size_t i = 0; i < n; i++) UM_CHECK(add(context, &sorted[i], &set));
  UM_CHECK(um_compare_set_finish(context, &set, out));
done:
  um_core_free(context, sorted);
  um_compare_set_abandon(context, &set);
  return status;
}

/* ---- calibration ---- */

struct stars {
  struct um_core_csv *csv;
  struct um_instrument_star *star;
  size_t *row; /* of each star */
  size_t n;
};

static enum um_status read_stars(struct um_context *context, const struct um_model *model, size_t s,
                                 struct stars *stars)
{
  static const char *const name[] = {"magnitude_ab", "airmass", "count_rate", "sigma"};
  const struct um_core_csv *csv = stars->csv;
  size_t at[4], flag = um_core_csv_find(csv, "flag"), rows = um_core_csv_rows(csv);
  for (int c = 0; c < 4; c++) UM_TRY(um_core_csv_require(context, csv, name[c], &at[c]));
  UM_TRY(um_core_allocate(context, rows, sizeof *stars->star, &stars->star));
  UM_TRY(um_core_allocate(context, rows, sizeof *stars->row, &stars->row));
  for (size_t i = 0; i < rows; i++) {
    double value[4], bad = 0.0;
    if (flag != (size_t)-1 && um_core_csv_text(csv, i, flag)[0] != '\0')
      UM_TRY(um_core_csv_number(context, csv, i, flag, &bad));
    if (bad != 0.0) continue;
    for (int c = 0; c < 4; c++) UM_TRY(um_core_csv_number(context, csv, i, at[c], &value[c]));
    if (!(value[1] > 0.99 && value[1] < 40.0))
      return um_core_csv_fail(context, csv, i, at[1], "%g; accepted: 1 to 38", value[1]);
    struct um_instrument_star *star = &stars->star[stars->n];
    *star = (struct um_instrument_star){value[1], value[2], value[3], 0.0};
    UM_TRY(um_model_star_rate(context, model, s, value[0], value[1], model->scenario->time->start,
                              &star->predicted));
    stars->row[stars->n++] = i;
  }
  return UM_OK;
}

enum um_status um_compare_calibration_read(struct um_context *context, const struct um_model *model,
                                           size_t s, const char *path, double extinction,
                                           struct um_instrument_calibration *out)
{
  enum um_status status;
  struct stars stars = {0};
  size_t at = 0;
  UM_CHECK(um_core_csv_read(context, path, &stars.csv));
  UM_CHECK(read_stars(context, model, s, &stars));
  status = um_instrument_calibrate(context, stars.star, stars.n, extinction, out, &at);
  if (status == UM_ERR_INPUT && at < stars.n)
    um_core_message_prefix(context, "%s:%d", path, um_core_csv_line(stars.csv, stars.row[at]));
  else if (status == UM_ERR_INPUT)
    um_core_message_prefix(context, "%s", path);
done:
  UM_FREE(context, stars.star, stars.row);
  um_core_csv_destroy(&stars.csv);
  return status;
}

/* Airmass of a row; UM_ERR_INPUT where nothing is seen through the air. */
static enum um_status airmass_of(struct um_context *context, const struct um_model *model,
                                 const struct um_compare_plan *plan, size_t row, double *out)
{
  struct um_environment_sample sample;
  struct um_orbit_look look;
  const struct um_compare_measurements *m = plan->measurements;
  size_t k = plan->observation[row];
  UM_TRY(um_compare_plan_sample(context, model, plan, k, &sample, &look));
  *out = um_environment_airmass(look.elevation);
  if (!isnan(*out)) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s:%d: elevation %.2f deg has no airmass; accepted: rows above the horizon "
                      "of a station, or a flag that leaves the row out",
                      um_compare_row_path(m, row), m->row[row].line, look.elevation / UM_DEG);
}

enum um_status um_compare_calibrate(struct um_context *context, const struct um_model *model,
                                    size_t s, const struct um_instrument_calibration *calibration,
                                    struct um_compare_measurements *measurements, size_t *rows)
{
  enum um_status status;
  struct um_compare_measurements *m = measurements;
  struct um_compare_plan *plan = NULL;
  *rows = 0;
  UM_CHECK(um_compare_plan_create(context, model, m, &plan));
  for (size_t i = 0; i < m->count; i++) {
    struct um_compare_measurement *row = &m->row[i];
    double airmass, relative;
    if (plan->observation[i] == UM_COMPARE_NOWHERE || plan->source[row->channel] != s ||
        m->channel[row->channel].quantity != UM_QUANTITY_COUNT_RATE)
      continue;
    UM_CHECK(airmass_of(context, model, plan, i, &airmass));
    double factor = um_instrument_calibration_factor(calibration, airmass, &relative);
    row->value /= factor;
    if (!isnan(row->sigma)) row->sigma = hypot(row->sigma / factor, row->value * relative);
    (*rows)++;
  }
  if (*rows == 0)
    status = um_core_fail(context, UM_ERR_INPUT,
                          "%s: no row of count_rate '%s'; accepted: some with flag 0", m->path,
                          model->sensor[s].name);
done:
  um_compare_plan_destroy(context, &plan);
  return status;
}
