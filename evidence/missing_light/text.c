/* A correction of light in words. */
#include "evidence/missing_light/light.h"

#include <math.h>
#include <stdio.h>

#include "evidence/measurements/time_text.h"

const char *um_missing_light_kind_name(enum um_missing_light_kind kind)
{
  static const char *const name[] = {"factor", "intensity", "irradiance"};
  return name[kind];
}

struct words {
  const char *name, *text, *unit;
};
static const struct words words[UM_COORDINATES] = {
    {"time_s", "time", ""},
    {"phase_deg", "the phase angle", " deg"},
    {"sun_from_x_deg", "the Sun's angle from the body's x axis", " deg"},
    {"sun_from_y_deg", "the Sun's angle from the body's y axis", " deg"},
    {"sun_from_z_deg", "the Sun's angle from the body's z axis", " deg"},
    {"observer_from_x_deg", "the observer's angle from the body's x axis", " deg"},
    {"observer_from_y_deg", "the observer's angle from the body's y axis", " deg"},
    {"observer_from_z_deg", "the observer's angle from the body's z axis", " deg"},
    {"glint_from_x_deg", "the angle of a glint from the body's x axis", " deg"},
    {"glint_from_y_deg", "the angle of a glint from the body's y axis", " deg"},
    {"glint_from_z_deg", "the angle of a glint from the body's z axis", " deg"},
    {"turn_about_x", "the body's turn about its x axis", " turns"},
    {"turn_about_y", "the body's turn about its y axis", " turns"},
    {"turn_about_z", "the body's turn about its z axis", " turns"},
    {"sun_from_nadir_deg", "the angle between Sun and Earth", " deg"},
    {"sunlit_fraction", "the sunlit fraction", ""},
    {"airmass", "the airmass", ""},
    {"elevation_deg", "the elevation at the station", " deg"},
    {"azimuth", "the azimuth at the station", " turns"},
};

const char *um_missing_light_coordinate_name(enum um_effect_coordinate coordinate)
{
  return words[coordinate].name;
}

/* A place on the coordinate. */
static void place_text(const struct um_missing_light *l, double u, char out[48])
{
  if (l->coordinate == UM_COORDINATE_TIME)
    um_compare_time_text(u, out);
  else
    snprintf(out, 48, "%.4g%s", u, words[l->coordinate].unit);
}

static const char *unit_of(enum um_missing_light_kind kind)
{
  static const char *const unit[] = {"", " W/sr", " W/m^2"};
  return unit[kind];
}

/* What the curve does where it does most, of the first band that has one. */
static double most_of(const struct um_missing_light *l, double *at)
{
  double most = 0.0;
  *at = l->from;
  for (int i = 0; i <= 200; i++) {
    double u = l->from + i / 200.0 * (l->to - l->from);
    double value = um_effect_curve_at(&l->curve, l->value, u);
    if (!(fabs(value) > fabs(most))) continue;
    most = value;
    *at = u;
  }
  return most;
}

void um_missing_light_text(const struct um_missing_light *l, char out[UM_MISSING_LIGHT_TEXT])
{
  char from[48], to[48], place[48], bands[160] = "";
  double at, most = most_of(l, &at);
  size_t used = 0;
  for (size_t b = 0; b < l->nband && used < sizeof bands - 40; b++)
    used += (size_t)snprintf(bands + used, sizeof bands - used, "%s%.30s",
                             b == 0             ? ""
                             : b + 1 < l->nband ? ", "
                                                : " and ",
                             l->band[b]);
  place_text(l, l->from, from);
  place_text(l, l->to, to);
  place_text(l, at, place);
  const char *what = l->kind == UM_LIGHT_FACTOR      ? "the light"
                     : l->kind == UM_LIGHT_INTENSITY ? "light of its own at the satellite"
                                                     : "light that is not the satellite's";
  if (l->kind == UM_LIGHT_FACTOR)
    snprintf(out, UM_MISSING_LIGHT_TEXT,
             "%s of %.100s in %s is off by %+.3g %% at %s, as a curve along %s that was seen from "
             "%s to %s",
             what, l->material != NULL ? l->material : "everything", bands, 100.0 * most, place,
             words[l->coordinate].text, from, to);
  else
    snprintf(out, UM_MISSING_LIGHT_TEXT,
             "%s in %s, %+.3g%s at %s, as a curve along %s that was seen from %s to %s", what,
             bands, most, unit_of(l->kind), place, words[l->coordinate].text, from, to);
}
