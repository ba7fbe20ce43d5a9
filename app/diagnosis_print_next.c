/* What a diagnosis leaves open, for a person: what to measure next, missing heat, what was not
 * tried.
 */
#include <stdio.h>

#include "app/diagnosis.h"
#include "evidence/diagnosis/report/channels.h"
#include "evidence/diagnosis/report/next_text.h"
#include "orbit/time.h"

/* All alternatives that the same tells from the winner are one line, that of the first. */
static void print_next(const struct um_diagnosis *d)
{
  if (d->nnext > 0) printf("\nnext measurement, to tell\n");
  for (size_t i = 0; i < d->nnext; i++) {
    const struct um_diagnosis_next *next = &d->next_of[i];
    char text[UM_DIAGNOSIS_NEXT_TEXT];
    size_t before = 0;
    while (before < i && !um_diagnosis_report_next_same(&d->next_of[before], next)) before++;
    if (before < i) continue;
    printf("  %s from ", d->candidates->candidate[d->step[next->step].candidate].name);
    for (size_t k = i; k < d->nnext; k++)
      if (um_diagnosis_report_next_same(&d->next_of[k], next))
        printf("%s%s", k > i ? ", " : "", d->candidates->candidate[d->next_of[k].candidate].name);
    um_diagnosis_report_next_text(next, text);
    printf(": %s\n", text);
  }
}

/* What was asked for and could not be tried, or was not worth a fit. */
static void print_missed(const struct um_diagnosis *d)
{
  if (d->chosen && d->nmissed > 0) printf("\nnot tried\n");
  for (size_t i = 0; d->chosen && i < d->nmissed; i++)
    printf("  %s: %s\n", d->missed[i].name, d->missed[i].why);
}

static void print_unexplained(const struct um_missing_heat_unexplained *u)
{
  if (u == NULL) return;
  printf("\nunexplained:");
  if (u->channel != NULL) printf(" worst in %s", u->channel);
  if (u->coordinate != NULL) printf(", correlates with %s (p %.2g)", u->coordinate, u->p);
  printf("\n");
  for (size_t i = 0; i < u->nheat && i < 3; i++) {
    const struct um_missing_heat *h = &u->heat[i];
    char start[32], energy[80], shape[UM_MISSING_HEAT_TEXT];
    um_orbit_time_format(h->course.start, start);
    um_missing_heat_text(h, shape);
    um_diagnosis_report_value_text(h->energy, h->energy_sigma, "+-", energy);
    printf("  %s %s: %s J from %s +- %.2g s%s; explains a chi-square of %.4g\n",
           i == 0 && u->found ? "missing heat of"
           : i == 0           ? "at most heat of"
                              : "or of",
           h->place, energy, start, h->start_sigma, shape, h->chi2_explained);
  }
}

void um_app_diagnosis_print_next(const struct um_diagnosis *diagnosis)
{
  print_next(diagnosis);
  print_unexplained(diagnosis->unexplained);
  print_missed(diagnosis);
}
