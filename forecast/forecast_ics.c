/* Forecasts as a calendar: iCalendar, RFC 5545. The same forecast gives the same bytes: DTSTAMP is
 * the forecast's beginning, and a UID is that of its pass and station. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "forecast/forecast_write.h"
#include "orbit/time.h"

#define FOLD 75   /* bytes of a line without its end (RFC 5545, 3.1) */
#define LINE 2048 /* longest line before it is folded */

/* Bytes of the character of UTF-8 that begins here; 1 for what is none. */
static size_t character(const char *at)
{
  size_t n = 1;
  if (((unsigned char)at[0] & 0xc0) != 0xc0) return 1;
  while (n < 4 && ((unsigned char)at[n] & 0xc0) == 0x80) n++;
  return n;
}

void um_forecast_ics_escape(const char *text, char *out, size_t size)
{
  size_t n = 0;
  while (*text != '\0') {
    size_t bytes = character(text);
    bool marked = strchr("\\;,\n", *text) != NULL;
    if (n + bytes + 2 > size) break;
    if (marked) out[n++] = '\\';
    if (*text == '\n')
      out[n++] = 'n';
    else if ((unsigned char)*text >= 0x20 && *text != 0x7f) {
      memcpy(out + n, text, bytes);
      n += bytes;
    }
    text += bytes;
  }
  out[n] = '\0';
}

void um_forecast_ics_line(FILE *file, const char *line)
{
  size_t column = 0;
  while (*line != '\0') {
    size_t bytes = character(line);
    if (column + bytes > FOLD) {
      fputs("\r\n ", file);
      column = 1;
    }
    fwrite(line, 1, bytes, file);
    column += bytes;
    line += bytes;
  }
  fputs("\r\n", file);
}

/* "20160921T203300Z" to the nearest second. */
static void stamp(double t_tai, char out[32])
{
  char utc[32];
  size_t n = 0;
  um_orbit_time_format(floor(t_tai + 0.5), utc);
  for (const char *at = utc; *at != '\0' && *at != '.'; at++)
    if (*at != '-' && *at != ':') out[n++] = *at;
  out[n++] = 'Z';
  out[n] = '\0';
}

static void put_stamp(FILE *file, const char *name, double t_tai)
{
  char when[32], line[64];
  stamp(t_tai, when);
  snprintf(line, sizeof line, "%s:%s", name, when);
  um_forecast_ics_line(file, line);
}

static void put_text(FILE *file, const char *name, const char *text)
{
  char escaped[LINE], line[LINE + 32];
  um_forecast_ics_escape(text, escaped, sizeof escaped);
  snprintf(line, sizeof line, "%s:%s", name, escaped);
  um_forecast_ics_line(file, line);
}

/* Append to a text that is cut where it is full. */
static void append(char text[LINE], const char *format, ...) UM_PRINTF(2, 3);
static void append(char text[LINE], const char *format, ...)
{
  size_t n = strlen(text);
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text + n, LINE - n, format, arguments);
  va_end(arguments);
}

static void append_time(char text[LINE], const char *what, double t)
{
  char utc[32];
  if (!isfinite(t)) return;
  um_orbit_time_format(t, utc);
  append(text, "\n%s %.8s UTC", what, utc + 11);
}

static void describe(const struct um_forecast *f, const struct um_forecast_pass *pass,
                     char text[LINE])
{
  const struct um_orbit_pass *p = &pass->pass;
  text[0] = '\0';
  append(text, "culminates at %.0f deg, azimuth %.0f deg, %.0f km; Sun at %.0f deg (%s)",
         p->culmination_elevation / UM_DEG, p->culmination_azimuth / UM_DEG,
         p->culmination_range * 1e-3, pass->sun_elevation / UM_DEG,
         um_forecast_sky(pass->sun_elevation));
  append_time(text, "rises", p->rise);
  append(text, ", azimuth %.0f deg", p->rise_azimuth / UM_DEG);
  append_time(text, "culminates", p->culmination);
  append_time(text, "sets", p->set);
  append(text, ", azimuth %.0f deg", p->set_azimuth / UM_DEG);
  append_time(text, "enters the shadow", pass->entry);
  append_time(text, "leaves the shadow", pass->exit);
  for (size_t b = 0; b < f->nband; b++) {
    const struct um_forecast_band *band = &pass->band[b];
    if (f->thermal[b]) {
      append(text, "\n%s: up to %.3g W/m^2", f->band[b], band->largest);
    } else if (isfinite(band->brightest)) {
      append(text, "\n%s: brightest %.1f mag (%s)", f->band[b], band->brightest,
             um_forecast_system(f, b));
      append_time(text, "at", band->brightest_at);
      if (isfinite(band->culmination)) append(text, "\n%.1f mag at culmination", band->culmination);
    } else {
      append(text, "\n%s: dark", f->band[b]);
    }
  }
  for (size_t i = 0; i < f->nplace; i++)
    append(text, "\n%s %.0f K", f->place[i], pass->place[i].mean);
}

/* The first band of reflected light; nband: none. */
static size_t first_reflected(const struct um_forecast *f)
{
  size_t b = 0;
  while (b < f->nband && f->thermal[b]) b++;
  return b;
}

static void event(const struct um_forecast *f, const struct um_forecast_pass *pass, FILE *file)
{
  const struct um_forecast_station *station = &f->station[pass->station];
  char text[LINE], when[32];
  size_t b = first_reflected(f);
  um_forecast_ics_line(file, "BEGIN:VEVENT");
  stamp(pass->pass.culmination, when);
  snprintf(text, sizeof text, "%s-%.4f-%.4f-%s@umbra", when, station->latitude / UM_DEG,
           station->longitude / UM_DEG, f->name);
  put_text(file, "UID", text);
  put_stamp(file, "DTSTAMP", f->from);
  put_stamp(file, "DTSTART", pass->pass.rise);
  put_stamp(file, "DTEND", pass->pass.set);
  text[0] = '\0';
  append(text, "%s over %s, %.0f deg", f->name, station->name,
         pass->pass.culmination_elevation / UM_DEG);
  if (b < f->nband && isfinite(pass->band[b].brightest))
    append(text, ", %s %.1f mag", f->band[b], pass->band[b].brightest);
  append(text, " (%s)", um_forecast_sky(pass->sun_elevation));
  put_text(file, "SUMMARY", text);
  put_text(file, "LOCATION", station->name);
  snprintf(text, sizeof text, "GEO:%.6f;%.6f", station->latitude / UM_DEG,
           station->longitude / UM_DEG);
  um_forecast_ics_line(file, text);
  describe(f, pass, text);
  put_text(file, "DESCRIPTION", text);
  um_forecast_ics_line(file, "TRANSP:TRANSPARENT");
  um_forecast_ics_line(file, "END:VEVENT");
}

void um_forecast_ics(const struct um_forecast *f, FILE *file)
{
  um_forecast_ics_line(file, "BEGIN:VCALENDAR");
  um_forecast_ics_line(file, "VERSION:2.0");
  um_forecast_ics_line(file, "PRODID:-//Umbra//forecast//EN");
  um_forecast_ics_line(file, "CALSCALE:GREGORIAN");
  for (size_t i = 0; i < f->npass; i++)
    if (f->pass[i].reason == NULL) event(f, &f->pass[i], file);
  um_forecast_ics_line(file, "END:VCALENDAR");
}
