/* report.html of cases of heat: are the limits kept, and by how much? */
#include <math.h>

#include "base/page/writer.h"
#include "output/cases.h"

struct totals {
  size_t limits, exceeded;
  const struct um_variant_case *least_of; /* of the least margin; NULL: there are no limits */
  const struct um_variant_case_place *least;
};

static struct totals count(const struct um_variant_cases *cases)
{
  struct totals t = {0};
  for (size_t i = 0; i < cases->count; i++)
    for (size_t p = 0; p < cases->item[i].nplace; p++) {
      const struct um_variant_case_place *place = &cases->item[i].place[p];
      double margin = um_variant_case_margin(place);
      if (isnan(margin)) continue;
      t.limits++;
      t.exceeded += um_variant_case_exceeded(place);
      if (t.least != NULL && !(margin < um_variant_case_margin(t.least))) continue;
      t.least = place;
      t.least_of = &cases->item[i];
    }
  return t;
}

/* Places in the order of the first case, all cases of each below each other. */
static enum um_status ranges(struct um_page_writer *w, const struct um_variant_cases *cases)
{
  static const struct um_page_figure figure = {
      .id = "limits",
      .title = "Temperatures and their limits",
      .text = "Bars reach from the lowest to the highest temperature of a case. Pale: the "
              "uncertainty of what is computed. Strokes: the limits.",
      .file = "limits.csv"};
  const struct um_page_axis value = {.name = "temperature", .unit = "K"};
  struct um_page_range *range;
  size_t n = 0;
  UM_TRY(UM_PAGE_ROOM(w, cases->item[0].nplace * cases->count, &range));
  for (size_t p = 0; p < cases->item[0].nplace; p++) {
    const char *name = cases->item[0].place[p].name;
    if (!um_output_case_shows(cases, &cases->item[0].place[p])) continue;
    for (size_t i = 0; i < cases->count; i++) {
      const struct um_variant_case_place *place = um_output_case_place(&cases->item[i], name);
      if (place == NULL) continue;
      double margin = um_variant_case_margin(place);
      bool exceeded = um_variant_case_exceeded(place);
      const char *text = NULL;
      if (!isnan(margin))
        UM_TRY(
            um_page_words(w, &text, "%s by %.2f K", exceeded ? "exceeded" : "kept", fabs(margin)));
      range[n++] = (struct um_page_range){.name = name,
                                          .of = cases->item[i].name,
                                          .low = place->lowest,
                                          .high = place->highest,
                                          .error = isnan(margin) ? NAN : place->uncertainty,
                                          .minimum = place->minimum,
                                          .maximum = place->maximum,
                                          .text = text,
                                          .exceeded = exceeded};
    }
  }
  um_page_ranges(w->page, &figure, &value, range, n);
  return UM_OK;
}

static enum um_status table(struct um_page_writer *w, const struct um_variant_cases *cases)
{
  static const struct um_page_figure figure = {
      .id = "temperatures",
      .title = "Every place of every case",
      .text = "A margin counts the uncertainty against what is computed; below 0 it is exceeded.",
      .file = "limits.csv"};
  enum { MEAN, LOWEST, HIGHEST, MINIMUM, MAXIMUM, UNCERTAINTY, MARGIN, NUMBERS };
  const char **name, **of, **how;
  double *value[NUMBERS];
  size_t most = 0, n = 0;
  for (size_t i = 0; i < cases->count; i++) most += cases->item[i].nplace;
  UM_TRY(UM_PAGE_ROOM(w, most, &name));
  UM_TRY(UM_PAGE_ROOM(w, most, &of));
  UM_TRY(UM_PAGE_ROOM(w, most, &how));
  for (int k = 0; k < NUMBERS; k++) UM_TRY(UM_PAGE_ROOM(w, most, &value[k]));
  for (size_t i = 0; i < cases->count; i++)
    for (size_t p = 0; p < cases->item[i].nplace; p++, n++) {
      const struct um_variant_case_place *place = &cases->item[i].place[p];
      of[n] = cases->item[i].name;
      how[n] = um_variant_analysis_name(cases->item[i].analysis);
      name[n] = place->name;
      value[MEAN][n] = place->mean;
      value[LOWEST][n] = place->lowest;
      value[HIGHEST][n] = place->highest;
      value[MINIMUM][n] = place->minimum;
      value[MAXIMUM][n] = place->maximum;
      value[UNCERTAINTY][n] = place->uncertainty;
      value[MARGIN][n] = um_variant_case_margin(place);
    }
  const struct um_page_column column[] = {
      {.name = "case", .text = of},
      {.name = "analysis", .text = how},
      {.name = "place", .text = name},
      {.name = "mean", .unit = "K", .value = value[MEAN]},
      {.name = "lowest", .unit = "K", .value = value[LOWEST]},
      {.name = "highest", .unit = "K", .value = value[HIGHEST]},
      {.name = "minimum", .unit = "K", .value = value[MINIMUM]},
      {.name = "maximum", .unit = "K", .value = value[MAXIMUM]},
      {.name = "uncertainty", .unit = "K", .value = value[UNCERTAINTY]},
      {.name = "margin", .unit = "K", .value = value[MARGIN]}};
  um_page_section(w->page, "temperatures", "How warm is every place?", UM_PAGE_PLAIN);
  um_page_table(w->page, &figure, column, sizeof column / sizeof column[0], n);
  return UM_OK;
}

static enum um_status fill(struct um_page_writer *w, const void *of)
{
  const struct um_variant_cases *cases = of;
  struct totals t = count(cases);
  if (t.limits == 0)
    um_page_lead(w->page, "The scenario states no limits of temperature.");
  else if (t.exceeded > 0)
    um_page_lead(w->page, "%zu of %zu limits are exceeded, most by %.2f K: %s in the case %s.",
                 t.exceeded, t.limits, -um_variant_case_margin(t.least), t.least->name,
                 t.least_of->name);
  else
    um_page_lead(w->page, "All %zu limits are kept; the least margin is %.2f K: %s in the case %s.",
                 t.limits, um_variant_case_margin(t.least), t.least->name, t.least_of->name);
  for (size_t i = 0; i < cases->count; i++)
    um_page_fact(w->page, cases->item[i].name, "%s analysis, %zu places",
                 um_variant_analysis_name(cases->item[i].analysis), cases->item[i].nplace);
  um_page_section(w->page, "limits", "Are the limits kept?",
                  t.limits == 0     ? UM_PAGE_PLAIN
                  : t.exceeded == 0 ? UM_PAGE_GOOD
                                    : UM_PAGE_BAD);
  if (t.limits == 0) um_page_text(w->page, "Shown are whole parts and their interiors.");
  um_page_writer_picture(w, "limits.svg");
  UM_TRY(ranges(w, cases));
  return table(w, cases);
}

enum um_status um_output_page_cases(struct um_context *context,
                                    const struct um_variant_cases *cases,
                                    struct um_core_folder *folder)
{
  const struct um_page_head head = {.command = "umbra cases",
                                    .kind = "cases",
                                    .title = cases->scenario,
                                    .about = ": temperatures and limits"};
  return um_page_report(context, &head, fill, cases, folder);
}
