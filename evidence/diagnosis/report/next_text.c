/* What to measure next, in words. */
#include "evidence/diagnosis/report/next_text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "evidence/measurements/time_text.h"

/* Without thousandths of a second where there are none. */
static void time_text(double t_tai, char out[40])
{
  static const char none[] = ".000Z";
  um_compare_time_text(t_tai, out);
  size_t n = strlen(out), k = sizeof none - 1;
  if (n > k && strcmp(out + n - k, none) == 0) memcpy(out + n - k, "Z", 2);
}

void um_diagnosis_report_next_text(const struct um_diagnosis_next *next,
                                   char out[UM_DIAGNOSIS_NEXT_TEXT])
{
  char from[40], to[40];
  if (next->what == NULL) {
    snprintf(out, UM_DIAGNOSIS_NEXT_TEXT, "%s%s%s",
             isnan(next->from) ? "not looked for" : "nothing that this scenario observes",
             next->told_apart_by != NULL ? "; told apart from " : "",
             next->told_apart_by != NULL ? next->told_apart_by : "");
    return;
  }
  time_text(next->from, from);
  time_text(next->to, to);
  snprintf(out, UM_DIAGNOSIS_NEXT_TEXT,
           "%s, %s to %s; a value of sigma %.3g %s there is worth a chi-square of %.3g", next->what,
           from, to, next->sigma, um_compare_quantity_unit(next->quantity), next->chi2_difference);
}

bool um_diagnosis_report_next_same(const struct um_diagnosis_next *a,
                                   const struct um_diagnosis_next *b)
{
  char one[UM_DIAGNOSIS_NEXT_TEXT], other[UM_DIAGNOSIS_NEXT_TEXT];
  if (a->step != b->step) return false;
  um_diagnosis_report_next_text(a, one);
  um_diagnosis_report_next_text(b, other);
  return strcmp(one, other) == 0;
}
