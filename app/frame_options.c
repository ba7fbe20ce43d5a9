/* The options of a frame. */
#include "app/frame_options.h"

#include <stdlib.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/number.h"

#define SPREADS "gaussian, moffat:BETA, airy, seeing:R0_M or a file in .csv"

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

static enum um_status parse_seed(struct um_context *context, const char *text, uint64_t *seed)
{
  char *end;
  if (text == NULL) return UM_OK;
  *seed = strtoull(text, &end, 10);
  if (text[0] >= '0' && text[0] <= '9' && *end == '\0') return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "--seed %s; accepted: a whole number", text);
}

enum um_status um_app_frame_options(struct um_context *context,
                                    const struct um_app_options *options,
                                    struct um_model_frame_options *out, uint64_t *seed)
{
  *out = (struct um_model_frame_options){
      .width = options->width > 0 ? options->width : UM_APP_FRAME_WIDTH,
      .samples = options->samples > 0 ? options->samples : UM_APP_FRAME_SAMPLES,
      .border = options->border > 0 ? options->border : 1};
  UM_TRY(parse_spread(context, options->psf, out));
  UM_TRY(parse_motion(context, options->motion, out));
  return parse_seed(context, options->seed, seed);
}
