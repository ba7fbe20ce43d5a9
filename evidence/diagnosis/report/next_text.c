/* What to measure next, in words. */
#include "evidence/diagnosis/report/next_text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "evidence/measurements/time_text.h"

/* Without thousandths of a second where there are none. */
static void time_text(double t_tai, char out[40])
{
  static const char none[] = ".000Z";
  um_compare_time_text(t_tai, out);
  size_t n = strlen(out), k = sizeof none - 1;
  if (n > k && strcmp(out + n - k, none) == 0) memcpy(out + n - k, "Z", 2);
}

/* "42 s", "12 min" */
static void lasts(double seconds, char out[24])
{
  if (seconds < 120.0)
    snprintf(out, 24, "%.2g s", seconds);
  else if (seconds < 7200.0)
    snprintf(out, 24, "%.2g min", seconds / 60.0);
  else
    snprintf(out, 24, "%.2g h", seconds / 3600.0);
}

void um_diagnosis_report_next_text(const struct um_diagnosis_next *next,
                                   char out[UM_DIAGNOSIS_NEXT_TEXT])
{
  char from[40], to[40], time[24], sigma[64], of[128], phase[64] = "";
  if (next->what == NULL) {
    snprintf(out, UM_DIAGNOSIS_NEXT_TEXT, "%s%s%s",
             isnan(next->from) ? "not looked for" : "nothing that this scenario observes",
             next->told_apart_by != NULL ? "; told apart from " : "",
             next->told_apart_by != NULL ? next->told_apart_by : "");
    return;
  }
  time_text(next->from, from);
  time_text(next->to, to);
  double values = um_diagnosis_next_values(next);
  if (!isnan(next->phase_from))
    snprintf(phase, sizeof phase, " at phase angles of %.0f to %.0f deg", next->phase_from / UM_DEG,
             next->phase_to / UM_DEG);
  snprintf(sigma, sizeof sigma, "of sigma %.3g %s", next->sigma,
           um_compare_quantity_unit(next->quantity));
  lasts(values * next->cadence, time);
  if (values > 1.0)
    snprintf(of, sizeof of, "%.0f values %s, %s of them", values, sigma, time);
  else
    snprintf(of, sizeof of, "one value %s", sigma);
  snprintf(out, UM_DIAGNOSIS_NEXT_TEXT, "%s%s, %s to %s: 5 sigma by %s", next->what, phase, from,
           to, of);
}

void um_diagnosis_report_pass_text(const struct um_diagnosis_pass *pass,
                                   char out[UM_DIAGNOSIS_NEXT_TEXT])
{
  char rise[40], from[40], time[24];
  const char *over = pass->station[0] != '\0' ? " over " : "";
  time_text(floor(pass->rise + 0.5), rise);
  int n = snprintf(out, UM_DIAGNOSIS_NEXT_TEXT, "%s%s%s, up to %.0f deg, Sun at %.0f deg: ", rise,
                   over, pass->station, pass->elevation / UM_DEG, pass->sun_elevation / UM_DEG);
  if (n < 0 || n >= UM_DIAGNOSIS_NEXT_TEXT) return;
  if (pass->of == NULL) {
    snprintf(out + n, UM_DIAGNOSIS_NEXT_TEXT - (size_t)n, "nothing is seen");
    return;
  }
  int m = snprintf(out + n, UM_DIAGNOSIS_NEXT_TEXT - (size_t)n, "%.2g sigma in %s", pass->sigmas,
                   pass->of);
  if (m < 0 || isnan(pass->seconds)) return;
  time_text(floor(pass->from + 0.5), from);
  lasts(pass->seconds, time);
  n += m;
  if (n < UM_DIAGNOSIS_NEXT_TEXT)
    snprintf(out + n, UM_DIAGNOSIS_NEXT_TEXT - (size_t)n, ", 5 within %s from %s on", time, from);
}

const struct um_diagnosis_pass *um_diagnosis_report_best_pass(const struct um_diagnosis_next *next)
{
  const struct um_diagnosis_pass *best = NULL;
  for (size_t i = 0; i < next->npass; i++)
    if (next->pass[i].of != NULL && (best == NULL || next->pass[i].sigmas > best->sigmas))
      best = &next->pass[i];
  return best;
}

bool um_diagnosis_report_next_same(const struct um_diagnosis_next *a,
                                   const struct um_diagnosis_next *b)
{
  char one[UM_DIAGNOSIS_NEXT_TEXT], other[UM_DIAGNOSIS_NEXT_TEXT];
  if (a->step != b->step || a->npass > 0 || b->npass > 0) return a == b;
  um_diagnosis_report_next_text(a, one);
  um_diagnosis_report_next_text(b, other);
  return strcmp(one, other) == 0;
}
