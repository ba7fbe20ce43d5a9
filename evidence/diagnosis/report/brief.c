/* A diagnosis in twelve lines. The sentence has what room the others leave; where that is too
 * little it names fewer effects, then it is cut. */
#include "evidence/diagnosis/report/brief.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/text.h"
#include "base/page/page.h"
#include "evidence/comparison/metrics.h"
#include "evidence/diagnosis/report/channels.h"
#include "evidence/diagnosis/report/next_text.h"
#include "evidence/diagnosis/report/report_impl.h"
#include "evidence/diagnosis/summary.h"

#define MISSED 1 /* that was not tried and has its reason */

enum part { FALL, NOISE, SCEPTIC, NEXT, NOT_TRIED, NPART };

struct brief {
  size_t most; /* lines of a part behind the sentence */
  char effects[UM_DIAGNOSIS_SUMMARY_MAX], part[NPART][UM_DIAGNOSIS_SUMMARY_MAX];
};

/* Bytes of the next word; "1.2 +- 0.3" and "40 %" are one. */
static size_t word_length(const char *text)
{
  size_t n = strcspn(text, " ");
  for (;;) {
    size_t glue = strncmp(text + n, " +- ", 4) == 0 ? 4 : strncmp(text + n, " %", 2) == 0 ? 1 : 0;
    if (glue == 0) return n;
    n += glue + strcspn(text + n + glue, " ");
  }
}

size_t um_diagnosis_report_wrap(FILE *file, const char *text, size_t most)
{
  size_t column = 0, line = 1;
  if (most != SIZE_MAX && um_diagnosis_report_wrap(NULL, text, SIZE_MAX) <= most) most = SIZE_MAX;
  while (*text != '\0') {
    size_t n = word_length(text), after = n + strspn(text + n, " ");
    bool last = line == most; /* " ..." stands behind it */
    if (column + (column > 0) + n + (last ? 4 : 0) > UM_DIAGNOSIS_BRIEF_WIDTH && column > 0) {
      if (line == most) {
        if (file != NULL) fputs(" ...", file);
        break;
      }
      if (file != NULL) fputc('\n', file);
      line++;
      column = 0;
    }
    if (file != NULL) fprintf(file, "%s%.*s", column > 0 ? " " : "", (int)n, text);
    column += (column > 0) + n;
    text += after;
  }
  if (file != NULL) fputc('\n', file);
  return line;
}

/* ---- how the error fell ---- */

/* The channel that the scenario fits worst; UM_COMPARE_NOWHERE: none was compared. */
static enum um_status find_worst(struct um_context *context, const struct um_diagnosis *d,
                                 size_t *out)
{
  double most = -INFINITY;
  *out = UM_COMPARE_NOWHERE;
  for (size_t c = 0; c < d->forward->measurements->nchannel; c++) {
    struct um_compare_metrics m;
    UM_TRY(um_diagnosis_report_channel_metrics(context, d, c, d->value_before, d->dof, &m));
    if (m.count == 0 || !(m.chi2_reduced > most)) continue;
    most = m.chi2_reduced;
    *out = c;
  }
  return UM_OK;
}

/* "19.31" */
static void put_figure(double value, char out[32])
{
  snprintf(out, 32, fabs(value) < 100.0 ? "%.2f" : "%.4g", value);
}

/* "Reduced chi-square 19.31 -> 1.00 over 250 rows, rms of lwir 4.11e-12 -> 6.05e-13 W/m^2." */
static enum um_status say_fall(struct um_context *context, const struct um_diagnosis *d,
                               char out[UM_DIAGNOSIS_SUMMARY_MAX])
{
  size_t worst, size = UM_DIAGNOSIS_SUMMARY_MAX;
  struct um_compare_metrics before, after;
  char from[32], to[32], chi2[120];
  UM_TRY(find_worst(context, d, &worst));
  if (worst == UM_COMPARE_NOWHERE) return UM_OK;
  const struct um_compare_channel *of = um_diagnosis_report_channel(d, worst);
  const char *unit = um_compare_residual_unit(of->quantity);
  UM_TRY(um_diagnosis_report_channel_metrics(context, d, worst, d->value_before, d->dof, &before));
  UM_TRY(
      um_diagnosis_report_channel_metrics(context, d, worst, d->value_after, d->dof_after, &after));
  put_figure(d->chi2_reduced, from);
  put_figure(d->chi2_reduced_after, to);
  bool fitted = d->naddition + d->nnuisance > 0;
  snprintf(chi2, sizeof chi2, "Reduced chi-square %s%s%s over %zu rows", from, fitted ? " -> " : "",
           fitted ? to : "", d->forward->observations.count);
  int n = fitted ? snprintf(out, size, "%s, rms of %s %.3g -> %.3g %s.", chi2, of->label,
                            before.rms, after.rms, unit)
                 : snprintf(out, size, "%s, rms of %s %.3g %s.", chi2, of->label, before.rms, unit);
  if (n > UM_DIAGNOSIS_BRIEF_WIDTH) snprintf(out, size, "%s.", chi2);
  return UM_OK;
}

/* ---- sceptic, next ---- */

/* Does the sentence name the effect that a sceptic asks of? One that abstains names what is not
 * certain in a group at most. */
static bool is_named(const struct um_diagnosis *d)
{
  if (!d->sceptic.asked) return false;
  return d->verdict != UM_VERDICT_UNEXPLAINED ||
         d->step[d->sceptic.step].confidence == UM_CONFIDENCE_CERTAIN;
}

static void say_sceptic(const struct um_diagnosis *d, char out[UM_DIAGNOSIS_SUMMARY_MAX])
{
  const struct um_diagnosis_sceptic *s = &d->sceptic;
  char frozen[80], flips[80];
  if (!is_named(d)) return;
  if (isnan(s->frozen))
    snprintf(frozen, sizeof frozen, "neither half of the time sees it");
  else
    snprintf(frozen, sizeof frozen, "half of the time foretells the rest by %.3g sigma", s->frozen);
  if (s->flips == 0)
    snprintf(flips, sizeof flips, "none of %zu changes of a row, channel, prior or noise alters",
             s->variations);
  else
    snprintf(flips, sizeof flips, "%zu of %zu changes (%s) alter%s", s->flips, s->variations,
             s->flips_by != NULL ? s->flips_by : "", s->flips == 1 ? "s" : "");
  snprintf(out, UM_DIAGNOSIS_SUMMARY_MAX,
           "Tests of %s: %s, noise does as well in %s%.2g %% of searches, %s the answer.",
           d->candidates->candidate[d->step[s->step].candidate].name, frozen,
           s->search_p * (UM_DIAGNOSIS_DRAWS + 1) < 1.5 ? "less than " : "", 100.0 * s->search_p,
           flips);
}

/* What an effect says of itself, "zero_point: standard stars", behind the names. */
static const char *behind_names(const char *told_apart_by)
{
  const char *colon = strstr(told_apart_by, ": ");
  return colon != NULL ? colon + 2 : told_apart_by;
}

/* The first that the scenario has; else what the effects say themselves. */
static void say_next(const struct um_diagnosis *d, char out[UM_DIAGNOSIS_SUMMARY_MAX])
{
  char text[UM_DIAGNOSIS_NEXT_TEXT];
  const struct um_diagnosis_next *next = NULL;
  for (size_t i = 0; i < d->nnext && (next == NULL || next->what == NULL); i++)
    if (d->next_of[i].what != NULL || d->next_of[i].npass > 0 ||
        (d->next_of[i].told_apart_by != NULL && next == NULL))
      next = &d->next_of[i];
  if (next == NULL) return;
  const struct um_diagnosis_pass *pass = um_diagnosis_report_best_pass(next);
  size_t n = (size_t)snprintf(out, UM_DIAGNOSIS_SUMMARY_MAX, "To tell %s from %s",
                              d->candidates->candidate[d->step[next->step].candidate].name,
                              d->candidates->candidate[next->candidate].name);
  if (n >= UM_DIAGNOSIS_SUMMARY_MAX) return;
  if (pass != NULL) { /* who asks for passes reads of them first */
    um_diagnosis_report_pass_text(pass, text);
    n += (size_t)snprintf(out + n, UM_DIAGNOSIS_SUMMARY_MAX - n, ", of %zu passes the best is %s",
                          next->npass, text);
  }
  if (n >= UM_DIAGNOSIS_SUMMARY_MAX) return;
  const char *words = next->told_apart_by != NULL ? behind_names(next->told_apart_by) : NULL;
  if (next->what != NULL) {
    um_diagnosis_report_next_text(next, text);
    words = text;
  }
  const char *how = next->what == NULL ? ": " : pass != NULL ? "; or measure: " : ", measure: ";
  snprintf(out + n, UM_DIAGNOSIS_SUMMARY_MAX - n, "%s%s.", words != NULL ? how : "",
           words != NULL ? words : "");
}

/* ---- all ---- */

/* Lines that the parts leave to the sentence; two more have the command and the folder. */
static size_t room(const struct brief *brief)
{
  size_t taken = 2;
  for (int i = 0; i < NPART; i++)
    if (brief->part[i][0] != '\0')
      taken += um_diagnosis_report_wrap(NULL, brief->part[i], brief->most);
  return taken < UM_DIAGNOSIS_BRIEF_LINES ? UM_DIAGNOSIS_BRIEF_LINES - taken : 0;
}

static enum um_status fill(struct um_context *context, const struct um_diagnosis *d,
                           struct brief *brief)
{
  size_t most = d->naddition > 0 ? d->naddition : 1;
  UM_TRY(say_fall(context, d, brief->part[FALL]));
  um_diagnosis_say_noise(d, brief->part[NOISE]);
  say_sceptic(d, brief->part[SCEPTIC]);
  say_next(d, brief->part[NEXT]);
  um_diagnosis_say_missed(d, MISSED, brief->part[NOT_TRIED]);
  um_diagnosis_say_effects(d, most, brief->effects);
  brief->most = 3;
  while (um_diagnosis_report_wrap(NULL, brief->effects, SIZE_MAX) > room(brief)) {
    if (brief->part[NOT_TRIED][0] != '\0')
      brief->part[NOT_TRIED][0] = '\0'; /* diagnosis.txt has it */
    else if (brief->most > 2)
      brief->most--;
    else if (most > 1)
      um_diagnosis_say_effects(d, --most, brief->effects);
    else
      break;
  }
  return UM_OK;
}

static void put(FILE *file, const struct um_diagnosis *d, const struct brief *brief,
                const char *command, const char *folder)
{
  um_diagnosis_report_wrap(file, brief->effects, room(brief));
  for (int i = 0; i < NPART; i++)
    if (brief->part[i][0] != '\0') um_diagnosis_report_wrap(file, brief->part[i], brief->most);
  um_diagnosis_report_put_command(file, d, command, folder);
  fputs("The rest is in ", file);
  um_core_text_put(file, folder);
  fputs("/diagnosis.txt; to look at: ", file);
  um_core_text_put(file, folder);
  fputs("/" UM_PAGE_FILE "\n", file);
}

enum um_status um_diagnosis_report_brief(struct um_context *context,
                                         const struct um_diagnosis *diagnosis, const char *command,
                                         const char *folder, char **out)
{
  struct brief *brief = NULL;
  char *text = NULL;
  size_t n;
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *brief, &brief));
  UM_CHECK(fill(context, diagnosis, brief));
  FILE *file = open_memstream(&text, &n);
  if (file == NULL) UM_CHECK(um_core_fail(context, UM_ERR_MEMORY, "no memory for a diagnosis"));
  put(file, diagnosis, brief, command, folder);
  if (fclose(file) != 0)
    UM_CHECK(um_core_fail(context, UM_ERR_MEMORY, "no memory for a diagnosis"));
  status = um_core_strdup(context, text, out);
done:
  free(text);
  um_core_free(context, brief);
  return status;
}
