/* A diagnosis as tables for a person. */
#include <math.h>
#include <string.h>

#include "app/diagnosis.h"
#include "compare/figures.h"
#include "diagnosis/channels.h"
#include "orbit/time.h"

#define WIDTH 96     /* of the sentence [characters] */
#define TINY  1e-300 /* smaller p are not told apart */

static void print_name(const struct um_effect *effect, const char *target)
{
  printf("%s%s%s", effect->name, target != NULL ? ":" : "", target != NULL ? target : "");
}

/* ---- channels ---- */

/* rms and reduced chi-square per channel with one set of model values, or before and after. */
static enum um_status print_channels(struct um_context *context, const struct um_diagnosis *d,
                                     const double *before, double dof_before, const double *after,
                                     double dof_after)
{
  if (after == NULL)
    printf("  %-36s %6s %11s  %10s\n", "", "rows", "rms", "chi2/dof");
  else
    printf("  %-36s %6s %27s  %24s\n", "", "rows", "rms", "chi2/dof");
  for (size_t c = 0; c < d->forward->measurements->nchannel; c++) {
    const struct um_compare_channel *channel = um_diagnosis_channel(d, c);
    struct um_compare_metrics m, n;
    UM_TRY(um_diagnosis_channel_metrics(context, d, c, before, dof_before, &m));
    if (m.count == 0) continue;
    char name[256];
    snprintf(name, sizeof name, "%s %s", um_compare_quantity_name(channel->quantity), channel->of);
    printf("  %-36s %6zu %11.4g", name, m.count, m.rms);
    if (after != NULL) {
      UM_TRY(um_diagnosis_channel_metrics(context, d, c, after, dof_after, &n));
      printf(" -> %12.4g  %10.4g -> %10.4g", n.rms, m.chi2_reduced, n.chi2_reduced);
    } else {
      printf("  %10.4g", m.chi2_reduced);
    }
    printf("  %s\n", um_compare_residual_unit(channel->quantity));
  }
  return UM_OK;
}

/* ---- effects ---- */

static void print_parameters(const struct um_effect *effect, const double *value,
                             const double *sigma)
{
  for (size_t p = 0; p < effect->nparameter; p++) {
    const struct um_effect_parameter *parameter = &effect->parameters[p];
    bool bound = value[p] == parameter->minimum || value[p] == parameter->maximum;
    char text[80];
    um_diagnosis_value_text(value[p], sigma[p], "+-", text);
    printf("  %-36s %s%s%s%s\n", parameter->name, text,
           strcmp(parameter->unit, "1") == 0 ? "" : " ",
           strcmp(parameter->unit, "1") == 0 ? "" : parameter->unit, bound ? ", at its bound" : "");
  }
  if (effect->nparameter == 0) printf("  switched on\n");
}

/* What cannot be told from the winner. */
static void print_rivals(const struct um_diagnosis *d, const struct um_diagnosis_step *step)
{
  const struct um_diagnosis_rival *winner = NULL;
  for (size_t r = 0; r < step->nrival; r++)
    if (step->rival[r].candidate == step->candidate) winner = &step->rival[r];
  for (size_t r = 0; r < step->nrival; r++) {
    const struct um_diagnosis_rival *rival = &step->rival[r];
    const struct um_diagnosis_candidate *candidate = &d->candidates->candidate[rival->candidate];
    if (rival == winner || !rival->indistinguishable) continue;
    printf("  cannot be told from %s", candidate->name);
    for (size_t p = 0; rival->fitted && p < candidate->ncolumn && !candidate->is_switch; p++) {
      size_t k = candidate->parameter[p];
      const struct um_effect_parameter *parameter = &candidate->effect->parameters[k];
      char text[80];
      um_diagnosis_value_text(rival->value[k], rival->sigma[k], "+-", text);
      printf(", %s %s%s%s", parameter->name, text, strcmp(parameter->unit, "1") == 0 ? "" : " ",
             strcmp(parameter->unit, "1") == 0 ? "" : parameter->unit);
    }
    if (rival->fitted && winner != NULL && isfinite(rival->bic))
      printf(", BIC %+.1f", rival->bic - winner->bic);
    printf(", separation %.3g%s\n", rival->separation,
           rival->incredible ? ", not a credible value" : "");
  }
  if (step->by_prior) printf("  only the priors of the effects tell them apart\n");
}

static enum um_status print_step(struct um_context *context, const struct um_diagnosis *d, size_t s)
{
  const struct um_diagnosis_step *step = &d->step[s];
  const double *before = s == 0 ? d->value_before : um_diagnosis_step_values(d, step - 1);
  double dof_before = s == 0 ? d->dof : step[-1].dof;
  double reduced = s == 0 ? d->chi2_reduced : step[-1].chi2_reduced;
  const double *after = um_diagnosis_step_values(d, step);
  printf("\nstep %zu: ", s + 1);
  print_name(step->addition.effect, step->addition.target);
  printf("%s\n", step->removed ? ", no longer needed at the end and taken out again" : "");
  print_parameters(step->addition.effect, step->addition.value, step->sigma);
  printf("  reduced chi-square %.4g -> %.4g, p %s%.2g, delta BIC %.4g, held-out chi-square %.4g -> "
         "%.4g\n",
         reduced, step->chi2_reduced, step->p_value < TINY ? "below " : "",
         fmax(step->p_value, TINY), step->delta_bic, step->held_out_before, step->held_out);
  if (before != NULL && after != NULL)
    UM_TRY(print_channels(context, d, before, dof_before, after, step->dof));
  print_rivals(d, step);
  return UM_OK;
}

static void print_uses(const char *title, const struct um_diagnosis_addition *addition,
                       double (*sigma)[UM_EFFECT_PARAMETERS_MAX], size_t n)
{
  for (size_t i = 0; i < n; i++) {
    printf("\n%s: ", title);
    print_name(addition[i].effect, addition[i].target);
    printf("\n");
    print_parameters(addition[i].effect, addition[i].value, sigma[i]);
  }
}

/* ---- what is left ---- */

static void print_next(const struct um_diagnosis_next *next)
{
  char from[40], to[40];
  if (next == NULL) return;
  if (next->what == NULL) {
    printf("\nnext measurement: nothing that this scenario observes would tell them apart\n");
    return;
  }
  um_compare_time_text(next->from, from);
  um_compare_time_text(next->to, to);
  printf("\nnext measurement: %s, %s to %s\n  a row of sigma %.3g %s there tells them apart by a "
         "chi-square of %.3g\n",
         next->what, from, to, next->sigma, um_compare_quantity_unit(next->quantity),
         next->separation);
}

static void print_unexplained(const struct um_diagnosis_unexplained *u)
{
  if (u == NULL) return;
  printf("\nunexplained:");
  if (u->channel != NULL) printf(" worst in %s", u->channel);
  if (u->coordinate != NULL) printf(", goes with %s (p %.2g)", u->coordinate, u->p);
  printf("\n");
  for (size_t i = 0; i < u->nheat && i < 3; i++) {
    const struct um_diagnosis_heat *h = &u->heat[i];
    char start[32], energy[80];
    um_orbit_time_format(h->start, start);
    um_diagnosis_value_text(h->energy, h->energy_sigma, "+-", energy);
    printf("  %s %s: %s J from %s +- %.2g s for %.4g s, explains a chi-square of %.4g\n",
           i == 0 && u->found ? "missing heat of"
           : i == 0           ? "at most heat of"
                              : "or of",
           h->place, energy, start, h->start_sigma, h->stop - h->start, h->chi2_explained);
  }
}

/* Words in lines of WIDTH. */
static void print_wrapped(const char *text)
{
  size_t column = 0;
  while (*text != '\0') {
    size_t n = strcspn(text, " ");
    if (column > 0 && column + 1 + n > WIDTH) {
      putchar('\n');
      column = 0;
    }
    column += (size_t)printf("%s%.*s", column > 0 ? " " : "", (int)n, text);
    text += n + (text[n] == ' ');
  }
  putchar('\n');
}

enum um_status um_app_diagnosis_print(struct um_context *context,
                                      const struct um_diagnosis *diagnosis, const char *folder)
{
  const struct um_diagnosis *d = diagnosis;
  const struct um_diagnosis_forward *f = d->forward;
  printf("%s against %s: %zu rows", f->model->scenario->name, f->measurements->path, f->nrow);
  if (d->candidates != NULL) printf(", %zu candidates", d->candidates->count);
  printf("\n\nbaseline: reduced chi-square %.4g (%.6g of %.6g degrees of freedom)\n",
         d->chi2_reduced, d->chi2, d->dof);
  UM_TRY(print_channels(context, d, d->value_before, d->dof, NULL, 0.0));
  for (size_t s = 0; s < d->nstep; s++) UM_TRY(print_step(context, d, s));
  if (d->nstep == 0 && d->naddition > 0) { /* chosen, not found */
    print_uses("fitted", d->addition, d->addition_sigma, d->naddition);
    printf("  reduced chi-square %.4g -> %.4g\n", d->chi2_reduced, d->chi2_reduced_after);
    UM_TRY(print_channels(context, d, d->value_before, d->dof, d->value_after, d->dof_after));
  }
  print_uses("fitted along", d->nuisance, d->nuisance_sigma, d->nnuisance);
  print_next(d->next);
  print_unexplained(d->unexplained);
  printf("\nverdict: %s\n", um_diagnosis_verdict_name(d->verdict));
  print_wrapped(d->sentence != NULL ? d->sentence : "");
  printf("\n%zu model evaluations in the time of %.3g forward runs (%.3g s)\n", f->evaluations,
         f->seconds / f->seconds_first, f->seconds);
  printf("results in %s, the scenario as it now stands in %s/improved\n", folder, folder);
  return UM_OK;
}
