/* The axis of time of a diagnosis, and its verdict as a title. */
#include "evidence/diagnosis/report/report_impl.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "evidence/diagnosis/report/channels.h"
#include "orbit/time.h"

#define NAMES 3 /* of a group that are said */

struct um_plot_time um_diagnosis_report_plot_time(double first, double last)
{
  char start[32];
  um_orbit_time_format(first, start);
  return um_plot_time(first, last, start);
}

struct text {
  char *at;
  size_t used, size;
};

static void add(struct text *text, const char *format, ...) UM_PRINTF(2, 3);
static void add(struct text *text, const char *format, ...)
{
  va_list list;
  va_start(list, format);
  int n = vsnprintf(text->at + text->used, text->size - text->used, format, list);
  va_end(list);
  if (n > 0) text->used += (size_t)n;
  if (text->used >= text->size) text->used = text->size - 1;
}

/* Why an effect is not certain: " (drawn) or emittance:white or 2 more, 1 not tried" of what cannot
 * be told from it, " (not certain)". */
static void add_doubt(struct text *text, const struct um_diagnosis *d,
                      const struct um_diagnosis_step *step)
{
  size_t n = 0, not_tried = 0;
  if (step->confidence == UM_CONFIDENCE_CERTAIN) return;
  if (step->confidence == UM_CONFIDENCE_UNCERTAIN) {
    add(text, " (not certain)");
    return;
  }
  for (size_t i = 1; i < step->nalternative; i++) {
    not_tried += step->alternative[i].not_tried;
    if (!step->alternative[i].indistinguishable) continue;
    if (n == 0) add(text, " (drawn)");
    if (n++ < NAMES)
      add(text, " or %s", um_diagnosis_report_candidate_of(d, &step->alternative[i])->name);
  }
  if (n > NAMES) add(text, " or %zu more", n - NAMES);
  if (not_tried > 0) add(text, ", %zu not tried", not_tried);
}

static void add_effects(struct text *text, const struct um_diagnosis *d, bool doubts)
{
  for (size_t i = 0; i < d->naddition; i++) {
    const struct um_model_addition *a = &d->addition[i];
    add(text, "%s%s%s%s%s", i == 0 ? "" : ", ", a->effect->name, a->target == NULL ? "" : " of ",
        a->target == NULL ? "" : a->target, a->off ? " off" : "");
    const struct um_diagnosis_step *step = um_diagnosis_step_of(d, a);
    if (doubts && step != NULL) add_doubt(text, d, step);
  }
}

void um_diagnosis_report_plot_verdict(const struct um_diagnosis *d, char *out, size_t size)
{
  struct text text = {out, 0, size};
  bool chosen = d->candidates == NULL, none = d->naddition == 0;
  out[0] = '\0';
  switch (d->verdict) {
  case UM_VERDICT_COMPLETE:
    add(&text, "complete, nothing added");
    return;
  case UM_VERDICT_FOUND:
    add(&text, chosen ? "fitted: " : "found: ");
    break;
  case UM_VERDICT_NOT_IDENTIFIABLE:
    add(&text,
        none ? "not identifiable, nothing added: a nuisance took it up" : "not identifiable: ");
    break;
  case UM_VERDICT_UNEXPLAINED:
    add(&text, none     ? "unexplained, nothing added"
               : chosen ? "fitted, and not explained by: "
                        : "unexplained, even with ");
    break;
  }
  add_effects(&text, d, d->verdict == UM_VERDICT_NOT_IDENTIFIABLE);
}
