/* What a diagnosis leaves open, for a person: what to measure next, missing heat, what was not
 * tried.
 */
#include <stdio.h>

#include "evidence/diagnosis/report/next_text.h"
#include "evidence/diagnosis/report/report_impl.h"
#include "evidence/diagnosis/value_text.h"
#include "orbit/time.h"

/* Does one line say both? Alternatives that the same tells from the winner, and those that nothing
 * of the scenario does. */
static bool is_one_line(const struct um_diagnosis_next *a, const struct um_diagnosis_next *b)
{
  if (a->what == NULL && b->what == NULL && a->step == b->step && a->npass + b->npass == 0)
    return true;
  return um_diagnosis_report_next_same(a, b);
}

/* Of alternatives that are one line the words are those of the first, the hardest to tell. */
static void print_next(FILE *file, const struct um_diagnosis *d)
{
  if (d->nnext > 0) fputs("\nnext measurement, to tell\n", file);
  for (size_t i = 0; i < d->nnext; i++) {
    const struct um_diagnosis_next *next = &d->next_of[i];
    char text[UM_DIAGNOSIS_NEXT_TEXT];
    size_t before = 0;
    while (before < i && !is_one_line(&d->next_of[before], next)) before++;
    if (before < i) continue;
    fprintf(file, "  %s from ", d->candidates->candidate[d->step[next->step].candidate].name);
    for (size_t k = i; k < d->nnext; k++)
      if (is_one_line(&d->next_of[k], next))
        fprintf(file, "%s%s", k > i ? ", " : "",
                d->candidates->candidate[d->next_of[k].candidate].name);
    um_diagnosis_report_next_text(next, text);
    fprintf(file, ": %s\n", text);
    for (size_t k = 0; k < next->npass; k++) {
      um_diagnosis_report_pass_text(&next->pass[k], text);
      fprintf(file, "    pass of %s\n", text);
    }
  }
}

/* What was asked for and could not be tried, or was not worth a fit. */
static void print_missed(FILE *file, const struct um_diagnosis *d)
{
  if (d->chosen && d->nmissed > 0) fprintf(file, "\nnot tried\n");
  for (size_t i = 0; d->chosen && i < d->nmissed; i++)
    fprintf(file, "  %s: %s\n", d->missed[i].name, d->missed[i].why);
}

static void print_unexplained(FILE *file, const struct um_missing_heat_unexplained *u)
{
  if (u == NULL) return;
  fprintf(file, "\nunexplained:");
  if (u->channel != NULL) fprintf(file, " worst in %s", u->channel);
  if (u->coordinate != NULL) fprintf(file, ", correlates with %s (p %.2g)", u->coordinate, u->p);
  fprintf(file, "\n");
  for (size_t i = 0; i < u->nheat && i < 3; i++) {
    const struct um_missing_heat *h = &u->heat[i];
    char start[32], energy[80], shape[UM_MISSING_HEAT_TEXT];
    um_orbit_time_format(h->course.start, start);
    um_missing_heat_text(h, shape);
    um_diagnosis_value_text(h->energy, h->energy_sigma, "+-", energy);
    fprintf(file, "  %s %s: %s J from %s +- %.2g s%s; explains a chi-square of %.4g\n",
            i == 0 && u->found ? "missing heat of"
            : i == 0           ? "at most heat of"
                               : "or of",
            h->place, energy, start, h->start_sigma, shape, h->chi2_explained);
  }
}

void um_diagnosis_report_write_text_next(const struct um_diagnosis *diagnosis, FILE *file)
{
  print_next(file, diagnosis);
  print_unexplained(file, diagnosis->unexplained);
  print_missed(file, diagnosis);
}
