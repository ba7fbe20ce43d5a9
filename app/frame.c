/* umbra frame: what a sensor's detector records at an instant, as FITS. */
#include "model/frame.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "app/app.h"
#include "app/picture.h"
#include "core/constants.h"
#include "core/number.h"
#include "core/words.h"
#include "model/build.h"
#include "model/precompute.h"
#include "model/run.h"
#include "orbit/time.h"
#include "output/fits.h"

#define FRAME_WIDTH   256 /* pixels of the picture that is put on the detector */
#define FRAME_SAMPLES 8
#define SPREADS       "gaussian, moffat:BETA, airy, seeing:R0_M or a file in .csv"

/* "name:number" */
static bool parameter(const char *text, const char *name, double *out)
{
  size_t n = strlen(name);
  return strncmp(text, name, n) == 0 && text[n] == ':' && um_core_number_parse(text + n + 1, out);
}

static enum um_status parse_spread(struct um_context *context, const char *text,
                                   struct um_model_frame_options *o)
{
  size_t n = text == NULL ? 0 : strlen(text);
  if (text == NULL || strcmp(text, "gaussian") == 0) return UM_OK;
  if (strcmp(text, "airy") == 0) {
    o->spread = UM_SPREAD_AIRY;
    return UM_OK;
  }
  if (parameter(text, "moffat", &o->beta) && o->beta > 1.0 && o->beta <= 100.0) {
    o->spread = UM_SPREAD_MOFFAT;
    return UM_OK;
  }
  if (parameter(text, "seeing", &o->r0) && o->r0 > 0.0 && o->r0 <= 10.0) {
    o->spread = UM_SPREAD_SEEING;
    return UM_OK;
  }
  if (n > 4 && strcmp(text + n - 4, ".csv") == 0) {
    o->spread = UM_SPREAD_FILE;
    o->path = text;
    return UM_OK;
  }
  return um_core_fail(context, UM_ERR_INPUT,
                      "--psf %s; accepted: " SPREADS ", BETA above 1 up to 100, R0_M above 0 up to "
                      "10",
                      text);
}

/* "ARCSEC_S,DEG" */
static enum um_status parse_motion(struct um_context *context, const char *text,
                                   struct um_model_frame_options *o)
{
  char word[64];
  if (text == NULL) return UM_OK;
  if (strlen(text) < sizeof word) {
    strcpy(word, text);
    char *comma = strchr(word, ',');
    if (comma != NULL) *comma++ = '\0';
    if (comma != NULL && um_core_number_parse(word, &o->motion) &&
        um_core_number_parse(comma, &o->motion_angle) && o->motion >= 0.0) {
      o->motion_angle *= UM_DEG;
      return UM_OK;
    }
  }
  return um_core_fail(context, UM_ERR_INPUT,
                      "--motion %s; accepted: RATE,ANGLE, arcsec/s of 0 or more and degrees from "
                      "the right counter-clockwise",
                      text);
}

static enum um_status find_sensor(struct um_context *context, const struct um_model *model,
                                  const char *name, size_t *out)
{
  struct um_core_words_guess guess = {.written = name};
  char accepted[320] = "", hint[UM_CORE_WORDS_HINT];
  for (size_t s = 0; s < model->nsensor; s++) {
    *out = s;
    if (strcmp(model->sensor[s].name, name) == 0) return UM_OK;
    um_core_words_append(accepted, sizeof accepted, model->sensor[s].name);
    um_core_words_consider(&guess, model->sensor[s].name);
  }
  return um_core_fail(
      context, UM_ERR_INPUT, "--sensor %s: the scenario has no such sensor%s; accepted: %s", name,
      um_core_words_hint(&guess, hint), model->nsensor == 0 ? "none, it has no sensors" : accepted);
}

static enum um_status write_frame(struct um_context *context, const struct um_app_options *options,
                                  const struct um_model *model, size_t s,
                                  const struct um_model_frame *f, const uint64_t *seed)
{
  const struct um_model_sensor *sensor = &model->sensor[s];
  const struct um_instrument_readout readout = {.background = f->background,
                                                .read_noise = sensor->optics.read_noise,
                                                .gain = sensor->optics.gain,
                                                .saturation = sensor->optics.saturation,
                                                .seed = seed != NULL ? *seed : 0,
                                                .noiseless = seed == NULL};
  float *counts = NULL;
  size_t n = (size_t)f->frame.width * (size_t)f->frame.height;
  UM_TRY(um_core_allocate(context, n, sizeof *counts, &counts));
  size_t saturated = um_instrument_frame_read(&f->frame, &readout, counts);
  double full = f->frame.source / sensor->optics.gain, peak = 0.0;
  for (size_t i = 0; i < n; i++) peak = fmax(peak, (double)counts[i]);
  const struct um_output_card cards[] = {
      {"BUNIT", 0.0, "adu", "counts of a pixel"},
      {"OBJECT", 0.0, model->scenario->name, "scenario"},
      {"INSTRUME", 0.0, sensor->name, "sensor"},
      {"FILTER", 0.0, model->band[sensor->band].name, "band"},
      {"DATE-OBS", 0.0, options->time_utc, "UTC, mid-exposure"},
      {"EXPTIME", sensor->exposure, NULL, "[s]"},
      {"GAIN", sensor->optics.gain, NULL, "[e/adu]"},
      {"RDNOISE", sensor->optics.read_noise, NULL, "[e]"},
      {"PIXSCALE", sensor->optics.pixel, NULL, "[arcsec]"},
      {"BACKGRND", f->background / sensor->optics.gain, NULL, "expected, of a pixel [adu]"},
      {"SRCCOUNT", full, NULL, "expected, of the whole source [adu]"},
      {"OUTSIDE", f->frame.outside / sensor->optics.gain, NULL, "of these, beside the frame [adu]"},
      {"NSATUR", (double)saturated, NULL, "saturated pixels"}};
  enum um_status status = um_output_write_fits(context, counts, f->frame.width, f->frame.height,
                                               cards, sizeof cards / sizeof cards[0], options->out);
  if (status == UM_OK)
    printf("%s: %d x %d pixels of %g arcsec, %.6g counts of the source, %.4g of the sky in each "
           "pixel, brightest pixel %.6g, %zu saturated\n",
           options->out, f->frame.width, f->frame.height, sensor->optics.pixel, full,
           f->background / sensor->optics.gain, peak, saturated);
  um_core_free(context, counts);
  return status;
}

static enum um_status frame(struct um_context *context, const struct um_app_options *options,
                            const struct um_model *model, const struct um_model_frame_options *o,
                            const uint64_t *seed)
{
  enum um_status status;
  struct um_model_precomputed *precomputed = NULL;
  struct um_model_result *result = NULL;
  struct um_model_frame f = {0};
  size_t s = 0;
  UM_TRY(find_sensor(context, model, options->sensor, &s));
  UM_CHECK(um_model_precompute(context, model, &precomputed));
  UM_CHECK(um_model_run(context, model, precomputed, &result));
  UM_CHECK(um_model_frame_create(context, model, precomputed, result, 0, s, o, &f));
  UM_CHECK(write_frame(context, options, model, s, &f, seed));
done:
  um_model_frame_clear(context, &f);
  um_model_result_destroy(context, &result);
  um_model_precomputed_destroy(context, &precomputed);
  return status;
}

static enum um_status parse_seed(struct um_context *context, const char *text, uint64_t *seed)
{
  char *end;
  if (text == NULL) return UM_OK;
  *seed = strtoull(text, &end, 10);
  if (text[0] >= '0' && text[0] <= '9' && *end == '\0') return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "--seed %s; accepted: a whole number", text);
}

int um_app_frame(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_app_instant instant = {0};
  struct um_model_frame_options o = {.width = options->width > 0 ? options->width : FRAME_WIDTH,
                                     .samples =
                                         options->samples > 0 ? options->samples : FRAME_SAMPLES};
  uint64_t seed = 0;
  UM_CHECK(parse_spread(context, options->psf, &o));
  UM_CHECK(parse_motion(context, options->motion, &o));
  UM_CHECK(parse_seed(context, options->seed, &seed));
  UM_CHECK(um_app_check_picture(context, options));
  UM_CHECK(um_app_instant_create(context, options, &instant));
  UM_CHECK(um_model_create(context, options->positional[0], &instant.changes, &model));
  UM_CHECK(frame(context, options, model, &o, options->seed != NULL ? &seed : NULL));
done:
  um_model_destroy(context, &model);
  um_app_instant_destroy(context, &instant);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
