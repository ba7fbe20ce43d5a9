/* Orbit mean-elements messages (CCSDS 502.0-B-3, 2023, section 4): keywords, their units and
 * ranges, and what SGP4 asks of them. MEAN_MOTION_DOT and _DDOT are those of two-line elements,
 * half and a sixth of the derivatives. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/number.h"
#include "orbit/omm_impl.h"
#include "orbit/time.h"

#define NINE_DIGITS 999999999.0
#define REV_PER_DAY (2.0 * UM_PI / 1440.0) /* [rad/min] */

/* Keywords of words come first, then those of numbers. */
enum { OBJECT_ID, CENTER_NAME, REF_FRAME, TIME_SYSTEM, THEORY, EPOCH, NUMBERS };

/* What is accepted of a word; NULL: anything. Absent is as the first. */
static const struct {
  const char *keyword, *accepted[4];
} words[NUMBERS] = {
    [OBJECT_ID] = {"OBJECT_ID", {NULL}},
    [CENTER_NAME] = {"CENTER_NAME", {"EARTH", NULL}},
    [REF_FRAME] = {"REF_FRAME", {"TEME", NULL}},
    [TIME_SYSTEM] = {"TIME_SYSTEM", {"UTC", NULL}},
    [THEORY] = {"MEAN_ELEMENT_THEORY", {"SGP4", "SGP/SGP4", "SGP", NULL}},
    [EPOCH] = {"EPOCH", {NULL}},
};

static const struct number {
  const char *keyword, *unit;
  double minimum, maximum, factor; /* factor: to what the set holds */
  size_t offset;                   /* in the set */
  bool required;
} numbers[UM_ORBIT_OMM_KEYWORDS - NUMBERS] = {
    {"MEAN_MOTION", " rev/day", 1e-8, 20.0, REV_PER_DAY, offsetof(struct um_orbit_tle, mean_motion),
     true},
    {"ECCENTRICITY", "", 0.0, 0.9999999, 1.0, offsetof(struct um_orbit_tle, eccentricity), true},
    {"INCLINATION", " deg", 0.0, 180.0, UM_DEG, offsetof(struct um_orbit_tle, inclination), true},
    {"RA_OF_ASC_NODE", " deg", -360.0, 360.0, UM_DEG, offsetof(struct um_orbit_tle, raan), true},
    {"ARG_OF_PERICENTER", " deg", -360.0, 360.0, UM_DEG,
     offsetof(struct um_orbit_tle, argument_of_perigee), true},
    {"MEAN_ANOMALY", " deg", -360.0, 360.0, UM_DEG, offsetof(struct um_orbit_tle, mean_anomaly),
     true},
    {"BSTAR", " per Earth radius", -10.0, 10.0, 1.0, offsetof(struct um_orbit_tle, bstar), true},
    {"MEAN_MOTION_DOT", " rev/day^2", -1.0, 1.0, 1.0,
     offsetof(struct um_orbit_tle, mean_motion_dot), false},
    {"MEAN_MOTION_DDOT", " rev/day^3", -10.0, 10.0, 1.0,
     offsetof(struct um_orbit_tle, mean_motion_ddot), false},
    {.keyword = "NORAD_CAT_ID", .unit = "", .minimum = 0.0, .maximum = NINE_DIGITS},
};
#define CATALOGUE (UM_ORBIT_OMM_KEYWORDS - 1)

const char *um_orbit_omm_keyword(size_t which)
{
  return which < NUMBERS ? words[which].keyword : numbers[which - NUMBERS].keyword;
}

size_t um_orbit_omm_find(const char *keyword)
{
  size_t which = 0;
  while (which < UM_ORBIT_OMM_KEYWORDS && strcmp(keyword, um_orbit_omm_keyword(which)) != 0)
    which++;
  return which;
}

enum um_status um_orbit_omm_put(struct um_context *context, const char *name,
                                struct um_orbit_omm *omm, size_t which, const char *text, int line)
{
  if (omm->text[which] != NULL)
    return um_core_fail(context, UM_ERR_INPUT, "%s:%d: %s stands in line %d already", name, line,
                        um_orbit_omm_keyword(which), omm->line[which]);
  omm->text[which] = text;
  omm->line[which] = line;
  return UM_OK;
}

static enum um_status refuse(struct um_context *context, const char *name,
                             const struct um_orbit_omm *omm, size_t which, const char *accepted)
{
  return um_core_fail(context, UM_ERR_INPUT, "%s:%d: %s: '%.40s'; accepted: %s", name,
                      omm->line[which], um_orbit_omm_keyword(which), omm->text[which], accepted);
}

static enum um_status missing(struct um_context *context, const char *name,
                              const struct um_orbit_omm *omm, size_t which)
{
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s:%d: the mean-elements message that begins here has no %s", name,
                      omm->begin, um_orbit_omm_keyword(which));
}

static enum um_status check_word(struct um_context *context, const char *name,
                                 const struct um_orbit_omm *omm, size_t which)
{
  const char *const *accepted = words[which].accepted, *text = omm->text[which];
  if (text == NULL || accepted[0] == NULL) return UM_OK;
  for (size_t k = 0; accepted[k] != NULL; k++)
    if (strcmp(text, accepted[k]) == 0) return UM_OK;
  return refuse(context, name, omm, which, accepted[0]);
}

static enum um_status read_epoch(struct um_context *context, const char *name,
                                 const struct um_orbit_omm *omm, struct um_orbit_tle *out)
{
  char why[256];
  if (omm->text[EPOCH] == NULL) return missing(context, name, omm, EPOCH);
  if (!um_orbit_time_parse_message(omm->text[EPOCH], "UTC", &out->epoch_tai, why, sizeof why))
    return refuse(context, name, omm, EPOCH, why);
  um_orbit_time_utc(out->epoch_tai, out->epoch_jd);
  return UM_OK;
}

static enum um_status read_number(struct um_context *context, const char *name,
                                  const struct um_orbit_omm *omm, size_t which, double *out)
{
  const struct number *n = &numbers[which - NUMBERS];
  char accepted[96];
  if (um_core_number_parse(omm->text[which], out) && *out >= n->minimum && *out <= n->maximum)
    return UM_OK;
  snprintf(accepted, sizeof accepted, "%.10g to %.10g%s", n->minimum, n->maximum, n->unit);
  return refuse(context, name, omm, which, accepted);
}

static enum um_status read_catalogue(struct um_context *context, const char *name,
                                     const struct um_orbit_omm *omm, struct um_orbit_tle *out)
{
  double number = 0.0;
  if (omm->text[CATALOGUE] != NULL) UM_TRY(read_number(context, name, omm, CATALOGUE, &number));
  if (number != floor(number)) return refuse(context, name, omm, CATALOGUE, "a whole number");
  out->catalogue_number = (int)number;
  return UM_OK;
}

enum um_status um_orbit_omm_make(struct um_context *context, const char *name,
                                 const struct um_orbit_omm *omm, struct um_orbit_tle *out)
{
  *out = (struct um_orbit_tle){0};
  for (size_t k = 0; k < NUMBERS; k++) UM_TRY(check_word(context, name, omm, k));
  if (omm->text[OBJECT_ID] != NULL)
    snprintf(out->designator, sizeof out->designator, "%s", omm->text[OBJECT_ID]);
  UM_TRY(read_epoch(context, name, omm, out));
  for (size_t k = NUMBERS; k < CATALOGUE; k++) {
    const struct number *n = &numbers[k - NUMBERS];
    double *value = (double *)((char *)out + n->offset);
    if (omm->text[k] == NULL && n->required) return missing(context, name, omm, k);
    if (omm->text[k] == NULL) continue;
    UM_TRY(read_number(context, name, omm, k, value));
    *value *= n->factor;
  }
  return read_catalogue(context, name, omm, out);
}

enum um_status um_orbit_elements_add(struct um_context *context, struct um_orbit_elements *elements,
                                     const struct um_orbit_tle *set)
{
  size_t n = elements->count;
  if ((n & (n - 1)) == 0) /* room for twice as many */
    UM_TRY(um_core_reallocate(context, n == 0 ? 1 : 2 * n, sizeof *set, (void **)&elements->set));
  elements->set[elements->count++] = *set;
  return UM_OK;
}

enum um_status um_orbit_omm_add(struct um_context *context, const char *name,
                                const struct um_orbit_omm *omm, struct um_orbit_elements *elements)
{
  struct um_orbit_tle set;
  UM_TRY(um_orbit_omm_make(context, name, omm, &set));
  return um_orbit_elements_add(context, elements, &set);
}
