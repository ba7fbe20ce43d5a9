/* The axis of time of a diagnosis, and its verdict as a title. */
#include "diagnosis/report/plot_frame_impl.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "diagnosis/report/channels.h"
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

/* The step that added an effect; NULL: it was chosen, not found. */
static const struct um_diagnosis_step *step_of(const struct um_diagnosis *d,
                                               const struct um_model_addition *a)
{
  for (size_t s = 0; s < d->nstep; s++)
    if (!d->step[s].removed && d->step[s].addition.effect == a->effect &&
        d->step[s].addition.target == a->target)
      return &d->step[s];
  return NULL;
}

/* " (drawn) or emittance:white or 2 more": what cannot be told from an effect. */
static void add_group(struct text *text, const struct um_diagnosis *d,
                      const struct um_diagnosis_step *step)
{
  size_t n = 0;
  if (step == NULL || step->standing == UM_STANDING_CERTAIN) return;
  for (size_t i = 1; i < step->nalternative; i++) {
    if (!step->alternative[i].indistinguishable) continue;
    if (n == 0) add(text, " (drawn)");
    if (n++ < NAMES)
      add(text, " or %s", um_diagnosis_report_candidate_of(d, &step->alternative[i])->name);
  }
  if (n > NAMES) add(text, " or %zu more", n - NAMES);
}

static void add_effects(struct text *text, const struct um_diagnosis *d, bool groups)
{
  for (size_t i = 0; i < d->naddition; i++) {
    const struct um_model_addition *a = &d->addition[i];
    add(text, "%s%s%s%s", i == 0 ? "" : ", ", a->effect->name, a->target == NULL ? "" : " of ",
        a->target == NULL ? "" : a->target);
    if (groups) add_group(text, d, step_of(d, a));
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
