/* report.html of a diagnosis, its story in order: how far off, what was tried, what wins and by how
 * much, why to believe it, what remains, what to measure next. */
#include <math.h>
#include <string.h>

#include "evidence/comparison/channel_page.h"
#include "evidence/comparison/shade.h"
#include "evidence/diagnosis/report/channels.h"
#include "evidence/diagnosis/report/next_text.h"
#include "evidence/diagnosis/report/report_impl.h"
#include "evidence/diagnosis/value_text.h"
#include "orbit/time.h"

#define FAR 100.0 /* alternatives further behind in BIC are left to diagnosis.json */

struct work {
  struct um_page_writer *p;
  struct um_page *page; /* the writer's */
  const struct um_diagnosis *d;
};

/* "emittance of mli", as a text of the page. */
static enum um_status name_of(struct work *w, const struct um_effect *effect, const char *target,
                              const char **out)
{
  return um_page_words(w->p, out, "%s%s%s", effect->name, target != NULL ? " of " : "",
                       target != NULL ? target : "");
}

static enum um_status values_of(struct work *w, const struct um_effect *effect, const char *target,
                                const double *value, const double *sigma, const char **out)
{
  char *text;
  UM_TRY(UM_PAGE_ROOM(w->p, UM_DIAGNOSIS_VALUES_MAX, &text));
  um_diagnosis_values_text(w->d->forward, effect, target, value, sigma, true, text);
  bool off = um_sensitivity_is_on(w->d->forward, effect);
  *out = off ? "switched off" : text[0] != '\0' ? text : "switched on";
  return UM_OK;
}

/* ---- channels ---- */

static enum um_status channel(struct work *w, size_t c)
{
  const struct um_diagnosis *d = w->d;
  const struct um_sensitivity_observations *o = &d->forward->observations;
  const struct um_compare_channel *of = um_diagnosis_report_channel(d, c);
  const double *values[UM_COMPARE_PAGE_MODELS] = {d->value_before, d->value_after};
  bool fitted = d->naddition + d->nnuisance > 0;
  const char *const names[UM_COMPARE_PAGE_MODELS] = {fitted ? "before" : "model", "after"};
  struct um_compare_page_channel page = {
      .channel = of, .weighted = true, .nmodel = fitted ? UM_COMPARE_PAGE_MODELS : 1};
  size_t *row, n;
  double *time, *measured, *sigma;
  enum um_status status;
  UM_TRY(um_diagnosis_report_channel_rows(w->p->context, d, c, &row, &n));
  UM_CHECK(UM_PAGE_ROOM(w->p, n, &time));
  UM_CHECK(UM_PAGE_ROOM(w->p, n, &measured));
  UM_CHECK(UM_PAGE_ROOM(w->p, n, &sigma));
  for (size_t i = 0; i < n; i++) {
    bool magnitude = um_compare_is_magnitude(of->quantity);
    double flux = o->measured[row[i]], error = o->stated_sigma[row[i]];
    time[i] = um_orbit_time_unix(o->t[row[i]]);
    measured[i] = um_diagnosis_report_in_unit(of->quantity, flux);
    sigma[i] = magnitude ? error / flux * 2.5 / M_LN10 : error;
  }
  for (size_t m = 0; m < page.nmodel; m++) {
    double *value, *residual;
    UM_CHECK(UM_PAGE_ROOM(w->p, n, &value));
    UM_CHECK(UM_PAGE_ROOM(w->p, n, &residual));
    for (size_t i = 0; i < n; i++) {
      value[i] = um_diagnosis_report_in_unit(of->quantity, values[m][row[i]]);
      residual[i] = (o->measured[row[i]] - values[m][row[i]]) / o->sigma[row[i]];
    }
    page.model[m] = (struct um_compare_page_model){names[m], names[m], value, residual};
  }
  page.count = n;
  page.time = time;
  page.value = measured;
  page.sigma = sigma;
  if (n > 0) status = um_compare_page_put_channel(w->p, &page, c);
done:
  um_core_free(w->p->context, row);
  return status;
}

static enum um_status how_far(struct work *w)
{
  const struct um_diagnosis *d = w->d;
  um_page_section(w->page, "far", "How far off was the model, and where?", UM_PAGE_PLAIN);
  um_compare_page_put_chi2(w->page, "Before", d->chi2, d->dof);
  if (d->naddition + d->nnuisance > 0)
    um_compare_page_put_chi2(w->page, "After", d->chi2_after, d->dof_after);
  if (d->residual.channel != NULL)
    um_page_text(w->page, "Worst in %s: %+.2g sigma on average%s%s.", d->residual.channel,
                 d->residual.mean,
                 d->residual.coordinate != NULL ? "; the residual goes with " : "",
                 d->residual.coordinate != NULL ? d->residual.coordinate : "");
  for (size_t c = 0; c < d->forward->measurements->nchannel; c++) UM_TRY(channel(w, c));
  return UM_OK;
}

/* ---- what was tried ---- */

static enum um_status tried(struct work *w)
{
  static const struct um_page_figure figure = {
      .id = "tried",
      .title = "What each effect alone explains",
      .text = "Chi-square that an effect takes off the model before. Effects that were not fitted "
              "are shown by their linear model."};
  static const char *const roles[UM_DIAGNOSIS_BAR_ROLES] = {
      [UM_DIAGNOSIS_BAR_LINEAR] = "not fitted",
      [UM_DIAGNOSIS_BAR_FITTED] = "fitted, and worse",
      [UM_DIAGNOSIS_BAR_TIED] = "cannot be told from the winner",
      [UM_DIAGNOSIS_BAR_WINNER] = "wins"};
  const struct um_diagnosis *d = w->d;
  struct um_diagnosis_report_bar *bars = NULL;
  struct um_page_bar *bar;
  size_t shown, tested;
  enum um_status status;
  if (d->nranking == 0) return UM_OK;
  UM_CHECK(um_diagnosis_report_bars(w->p->context, d, &bars, &shown, &tested));
  UM_CHECK(UM_PAGE_ROOM(w->p, shown, &bar));
  for (size_t i = 0; i < shown; i++) {
    const char *text;
    char estimate[160];
    um_diagnosis_report_bar_text(d, &bars[i], estimate);
    UM_CHECK(um_page_words(w->p, &text, "%s%s%s", roles[bars[i].role],
                           estimate[0] != '\0' ? ": " : "", estimate));
    bar[i] = (struct um_page_bar){um_diagnosis_report_candidate_of(d, bars[i].score)->name, text,
                                  um_diagnosis_report_explained(d, &bars[i]), NAN};
  }
  const struct um_page_axis value = {.name = "chi-square explained", .unit = "1"};
  um_page_section(w->page, "tried", "What was tried?", UM_PAGE_PLAIN);
  um_page_text(w->page, "%zu effects were tested; the best %zu are shown.", tested, shown);
  um_page_bars(w->page, &figure, &value, bar, shown);
done:
  um_core_free(w->p->context, bars);
  return status;
}

/* ---- what wins ---- */

static enum um_status found(struct work *w)
{
  static const struct um_page_figure figure = {.id = "found", .title = "Effects, fitted together"};
  const struct um_diagnosis *d = w->d;
  size_t n = d->naddition + d->nnuisance;
  const char **name, **value, **why, **kind;
  UM_TRY(UM_PAGE_ROOM(w->p, n, &name));
  UM_TRY(UM_PAGE_ROOM(w->p, n, &value));
  UM_TRY(UM_PAGE_ROOM(w->p, n, &why));
  UM_TRY(UM_PAGE_ROOM(w->p, n, &kind));
  for (size_t i = 0; i < n; i++) {
    bool nuisance = i >= d->naddition;
    size_t at = nuisance ? i - d->naddition : i;
    const struct um_model_addition *a = nuisance ? &d->nuisance[at] : &d->addition[at];
    const double *sigma = nuisance ? d->nuisance_sigma[at] : d->addition_sigma[at];
    const struct um_diagnosis_step *step = nuisance ? NULL : um_diagnosis_step_of(d, a);
    UM_TRY(name_of(w, a->effect, a->target, &name[i]));
    UM_TRY(values_of(w, a->effect, a->target, a->value, sigma, &value[i]));
    why[i] = a->effect->summary;
    kind[i] = nuisance       ? "uncertain anyway"
              : step == NULL ? "chosen"
                             : um_diagnosis_confidence_name(step->confidence);
  }
  const struct um_page_column column[] = {{.name = "effect", .text = name},
                                          {.name = "value", .text = value},
                                          {.name = "how sure", .text = kind},
                                          {.name = "what it says", .text = why}};
  um_page_table(w->page, &figure, column, 4, n);
  return UM_OK;
}

/* Is an alternative worth a line? */
static bool is_near(const struct um_diagnosis_step *step, size_t i)
{
  const struct um_diagnosis_alternative *a = &step->alternative[i];
  return (a->fitted && a->bic - step->alternative[0].bic < FAR) || a->not_tried;
}

static enum um_status alternatives(struct work *w)
{
  static const struct um_page_figure figure = {
      .id = "alternatives",
      .title = "Alternatives, and how far behind they are",
      .text = "A difference in BIC of 10 or more is strong evidence for the winner."};
  const struct um_diagnosis *d = w->d;
  size_t most = 0, n = 0;
  const char **name, **of, **value, **how;
  double *behind, *apart;
  for (size_t s = 0; s < d->nstep; s++) most += d->step[s].nalternative;
  UM_TRY(UM_PAGE_ROOM(w->p, most, &name));
  UM_TRY(UM_PAGE_ROOM(w->p, most, &of));
  UM_TRY(UM_PAGE_ROOM(w->p, most, &value));
  UM_TRY(UM_PAGE_ROOM(w->p, most, &how));
  UM_TRY(UM_PAGE_ROOM(w->p, most, &behind));
  UM_TRY(UM_PAGE_ROOM(w->p, most, &apart));
  for (size_t s = 0; s < d->nstep; s++)
    for (size_t i = 1; i < d->step[s].nalternative; i++) {
      const struct um_diagnosis_step *step = &d->step[s];
      const struct um_diagnosis_alternative *a = &step->alternative[i];
      const struct um_sensitivity_candidate *c = um_diagnosis_report_candidate_of(d, a);
      if (!is_near(step, i)) continue;
      name[n] = c->name;
      UM_TRY(name_of(w, step->addition.effect, step->addition.target, &of[n]));
      value[n] = "";
      if (a->fitted) UM_TRY(values_of(w, c->effect, c->target, a->value, a->sigma, &value[n]));
      behind[n] = a->fitted ? a->bic - step->alternative[0].bic : (double)NAN;
      apart[n] = a->chi2_difference;
      how[n++] = a->not_tried           ? "not fitted"
                 : a->indistinguishable ? "cannot be told from it"
                 : a->excluded_by_prior ? "kept out by its prior alone"
                 : a->excluded_by_range ? "kept out by the end of its range alone"
                 : a->implausible       ? "further than 3 prior widths from the usual"
                                        : "worse";
    }
  const struct um_page_column column[] = {
      {.name = "instead of", .text = of}, {.name = "alternative", .text = name},
      {.name = "value", .text = value},   {.name = "BIC behind", .value = behind},
      {.name = "stands", .text = how},    {.name = "chi-square between them", .value = apart}};
  if (n > 0) um_page_table(w->page, &figure, column, 6, n);
  return UM_OK;
}

static enum um_status wins(struct work *w)
{
  const struct um_diagnosis *d = w->d;
  if (d->naddition + d->nnuisance == 0) return UM_OK;
  um_page_section(w->page, "wins", "What wins, and by how much?", UM_PAGE_PLAIN);
  UM_TRY(found(w));
  return alternatives(w);
}

static enum um_status believe(struct work *w)
{
  static const struct um_page_figure figure = {
      .id = "steps",
      .title = "Step by step",
      .text = "Held out: chi-square of parts of the data that a fit to the rest did not see."};
  const struct um_diagnosis *d = w->d;
  enum { P, BIC, BEFORE, AFTER, REDUCED, COLUMNS };
  const char **name;
  double *value[COLUMNS];
  if (d->nstep == 0) return UM_OK;
  UM_TRY(UM_PAGE_ROOM(w->p, d->nstep, &name));
  for (int i = 0; i < COLUMNS; i++) UM_TRY(UM_PAGE_ROOM(w->p, d->nstep, &value[i]));
  for (size_t s = 0; s < d->nstep; s++) {
    const struct um_diagnosis_step *step = &d->step[s];
    UM_TRY(name_of(w, step->addition.effect, step->addition.target, &name[s]));
    value[P][s] = step->p_value;
    value[BIC][s] = step->delta_bic;
    value[BEFORE][s] = step->held_out_before;
    value[AFTER][s] = step->held_out;
    value[REDUCED][s] = step->chi2_reduced;
  }
  const struct um_page_column column[] = {
      {.name = "added", .text = name},
      {.name = "p, corrected for all that were tested", .value = value[P]},
      {.name = "change in BIC", .value = value[BIC]},
      {.name = "held out before", .value = value[BEFORE]},
      {.name = "held out after", .value = value[AFTER]},
      {.name = "chi-square per degree of freedom", .value = value[REDUCED]}};
  um_page_section(w->page, "believe", "Why believe it?", UM_PAGE_PLAIN);
  um_page_table(w->page, &figure, column, 6, d->nstep);
  return UM_OK;
}

static void remains(struct work *w)
{
  const struct um_diagnosis *d = w->d;
  char light[UM_MISSING_LIGHT_TEXT];
  bool white = d->verdict != UM_VERDICT_UNEXPLAINED && !d->allowance;
  um_page_section(w->page, "remains", "What remains?", white ? UM_PAGE_GOOD : UM_PAGE_WARNING);
  um_compare_page_put_chi2(w->page, "After", d->chi2_after, d->dof_after);
  if (d->allowance) um_page_text(w->page, "What is left is not quite noise.");
  if (d->unexplained != NULL && d->unexplained->channel != NULL)
    um_page_text(w->page, "Worst in %s%s%s.", d->unexplained->channel,
                 d->unexplained->coordinate != NULL ? ", where it goes with " : "",
                 d->unexplained->coordinate != NULL ? d->unexplained->coordinate : "");
  if (!d->light.found) return;
  um_missing_light_text(&d->light, light);
  um_page_text(w->page, "A correction of light explains it: %s.", light);
}

static enum um_status next(struct work *w)
{
  static const struct um_page_figure figure = {.id = "next", .title = "What would tell them apart"};
  static const char pass_of[] = "pass of ";
  const struct um_diagnosis *d = w->d;
  const char **winner, **from, **what;
  size_t n = 0, most = d->nnext;
  if (d->nnext == 0) return UM_OK;
  for (size_t i = 0; i < d->nnext; i++) most += d->next_of[i].npass;
  UM_TRY(UM_PAGE_ROOM(w->p, most, &winner));
  UM_TRY(UM_PAGE_ROOM(w->p, most, &from));
  UM_TRY(UM_PAGE_ROOM(w->p, most, &what));
  for (size_t i = 0; i < d->nnext; i++) {
    const struct um_diagnosis_next *one = &d->next_of[i];
    for (size_t k = 0; k <= one->npass; k++) {
      char *text;
      UM_TRY(UM_PAGE_ROOM(w->p, UM_DIAGNOSIS_NEXT_TEXT + sizeof pass_of, &text));
      size_t prefix = k == 0 ? 0 : strlen(pass_of);
      memcpy(text, pass_of, prefix);
      if (k == 0)
        um_diagnosis_report_next_text(one, text);
      else
        um_diagnosis_report_pass_text(&one->pass[k - 1], text + prefix);
      winner[n] = d->candidates->candidate[d->step[one->step].candidate].name;
      from[n] = d->candidates->candidate[one->candidate].name;
      what[n++] = text;
    }
  }
  const struct um_page_column column[] = {{.name = "to tell", .text = winner},
                                          {.name = "from", .text = from},
                                          {.name = "measure", .text = what}};
  um_page_section(w->page, "next", "What should be measured next?", UM_PAGE_PLAIN);
  um_page_table(w->page, &figure, column, 3, n);
  return UM_OK;
}

static enum um_status fill(struct um_page_writer *p, const void *of)
{
  const struct um_diagnosis *d = of;
  struct work whole = {.p = p, .page = p->page, .d = d}, *w = &whole;
  const struct um_sensitivity_observations *o = &d->forward->observations;
  double first = INFINITY, last = -INFINITY;
  for (size_t i = 0; i < o->count; i++) {
    first = fmin(first, o->t[i]);
    last = fmax(last, o->t[i]);
  }
  UM_TRY(um_compare_page_shade(p, d->forward->model, first, last));
  if (d->summary != NULL) um_page_lead(w->page, "%s", d->summary);
  um_page_fact(w->page, "verdict", "%s", um_diagnosis_verdict_name(d->verdict));
  um_page_fact(w->page, "scenario", "%s", d->forward->model->scenario->name);
  um_page_fact(w->page, "measurements", "%s, %zu observations", d->forward->measurements->path,
               o->count);
  UM_TRY(how_far(w));
  UM_TRY(tried(w));
  UM_TRY(wins(w));
  UM_TRY(believe(w));
  remains(w);
  return next(w);
}

enum um_status um_diagnosis_report_write_page(struct um_context *context,
                                              const struct um_diagnosis *diagnosis,
                                              const char *command, struct um_core_folder *folder)
{
  const struct um_page_head head = {.command = command,
                                    .kind = "diagnosis",
                                    .title = diagnosis->forward->model->scenario->name,
                                    .about = ": what the model lacks"};
  return um_page_report(context, &head, fill, diagnosis, folder);
}
