/* A diagnosis as tables for a person. */
#include <math.h>
#include <string.h>

#include "app/diagnosis.h"
#include "evidence/comparison/metrics.h"
#include "evidence/diagnosis/report/channels.h"
#include "evidence/diagnosis/value_text.h"
#include "evidence/inversion/refine.h"
#include "evidence/sensitivity/stated.h"

#define WIDTH 96     /* of the summary [characters] */
#define WORSE 5      /* fitted alternatives that are listed */
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
    printf("  %-36s %12s %11s  %10s\n", "", "observations", "rms", "chi2/dof");
  else
    printf("  %-36s %12s %27s  %24s\n", "", "observations", "rms", "chi2/dof");
  for (size_t c = 0; c < d->forward->measurements->nchannel; c++) {
    const struct um_compare_channel *channel = um_diagnosis_report_channel(d, c);
    struct um_compare_metrics m, n;
    UM_TRY(um_diagnosis_report_channel_metrics(context, d, c, before, dof_before, &m));
    if (m.count == 0) continue;
    char name[256];
    snprintf(name, sizeof name, "%s %s", um_compare_quantity_name(channel->quantity),
             channel->label);
    printf("  %-36s %12zu %11.4g", name, m.count, m.rms);
    if (after != NULL) {
      UM_TRY(um_diagnosis_report_channel_metrics(context, d, c, after, dof_after, &n));
      printf(" -> %12.4g  %10.4g -> %10.4g", n.rms, m.chi2_reduced, n.chi2_reduced);
    } else {
      printf("  %10.4g", m.chi2_reduced);
    }
    printf("  %s\n", um_compare_residual_unit(channel->quantity));
  }
  return UM_OK;
}

/* How much of sigma is the model's own, and what was done about it. */
static void print_sampling(const struct um_sensitivity_forward *f)
{
  if (f->observations.model_share > UM_COMPARE_SHARE_SHOWN)
    printf(
        "  the model's own sampling error is %.2g %% of the variance, and stands in chi-square\n",
        100.0 * f->observations.model_share);
  if (f->samples != f->samples_before)
    printf("  optics.samples %d in place of the scenario's %d, so that this error stays small\n",
           f->samples, f->samples_before);
}

/* ---- effects ---- */

/* Beside each parameter what the scenario states as a whole. */
static void print_parameters(const struct um_diagnosis *d, const struct um_effect *effect,
                             const char *target, const double *value, const double *sigma)
{
  if (effect->on_by_default) printf("  switched on\n");
  for (size_t p = 0; p < effect->nparameter; p++) {
    const struct um_effect_parameter *parameter = &effect->parameters[p];
    double present[UM_EFFECT_PARAMETERS_MAX], low, high;
    um_sensitivity_forward_null(d->forward, effect, target, present);
    um_sensitivity_stated_range(d->forward, effect, target, p, present[p], &low, &high);
    bool bound = !effect->on_by_default && (value[p] <= low || value[p] >= high);
    struct um_diagnosis_whole whole;
    char text[80], of[160] = "";
    um_diagnosis_report_value_text(value[p], sigma[p], "+-", text);
    if (um_diagnosis_whole_find(d->forward, effect, target, p, value[p], sigma[p], &whole))
      um_diagnosis_whole_text(&whole, of);
    printf("  %-36s %s%s%s%s%s%s\n", parameter->name, text,
           strcmp(parameter->unit, "1") == 0 ? "" : " ",
           strcmp(parameter->unit, "1") == 0 ? "" : parameter->unit, bound ? ", at its bound" : "",
           of[0] != '\0' ? " " : "", of);
  }
}

/* One that was fitted, with its values. */
static void print_alternative(const struct um_diagnosis *d,
                              const struct um_diagnosis_alternative *alternative)
{
  const struct um_sensitivity_candidate *c = &d->candidates->candidate[alternative->candidate];
  char text[UM_DIAGNOSIS_VALUES_MAX];
  um_diagnosis_values_text(d->forward, c->effect, c->target, alternative->value, alternative->sigma,
                           text);
  printf("%s%s%s", c->name, text[0] != '\0' ? " " : "", text);
}

/* How an alternative stands to the winner; NULL: not fitted, or too far behind to be named. */
static const char *relation(const struct um_diagnosis_alternative *r, double behind)
{
  if (r->indistinguishable) return "cannot be told from";
  if (r->excluded_by_prior) return "kept out by its prior alone:";
  if (r->excluded_by_range) return "kept out by the end of its range alone:";
  if (r->fitted && behind < UM_DIAGNOSIS_NEXT_BEST)
    return r->same_effect ? "as well with" : "next best";
  return NULL;
}

/* The best of those that were fitted and are too far behind to be an alternative, by BIC against
 * the winner; those far behind are left to the files. */
static void print_worse(const struct um_diagnosis *d, const struct um_diagnosis_step *step)
{
  size_t shown = 0, more = 0;
  for (size_t r = 1; r < step->nalternative; r++) {
    const struct um_diagnosis_alternative *alternative = &step->alternative[r];
    double behind = alternative->bic - step->alternative[0].bic;
    if (!alternative->fitted || relation(alternative, behind) != NULL) continue;
    if (shown == WORSE || behind > UM_DIAGNOSIS_FAR_BEHIND) {
      more++;
      continue;
    }
    printf("  fitted and worse: ");
    print_alternative(d, alternative);
    printf(", BIC %s%+.1f\n", alternative->converged ? "" : "up to ", behind);
    shown++;
  }
  if (more > 0)
    printf("  %s%zu more that %s fitted and worse: diagnosis.json has %s\n",
           shown > 0 ? "and " : "", more, more == 1 ? "was" : "were", more == 1 ? "it" : "them");
}

/* The effect's label, and what comes near the winner. */
static void print_alternatives(const struct um_diagnosis *d, const struct um_diagnosis_step *step)
{
  static const char *const label[] = {"certain", "one of a group",
                                      "small, what it is cannot be known",
                                      "needed, but within two sigmas of no effect"};
  const struct um_diagnosis_alternative *winner = &step->alternative[0];
  if (!step->removed) printf("  %s\n", label[step->confidence]);
  for (size_t r = 1; r < step->nalternative; r++) {
    const struct um_diagnosis_alternative *alternative = &step->alternative[r];
    double behind = alternative->bic - winner->bic;
    const char *how = relation(alternative, behind);
    if (how == NULL) continue;
    printf("  %s ", how);
    print_alternative(d, alternative);
    printf(", BIC %+.1f, expected chi-square difference %.3g%s\n", behind,
           alternative->chi2_difference, alternative->implausible ? ", not a plausible value" : "");
  }
  if (step->by_prior) printf("  only the priors of the effects tell them apart\n");
  size_t n = 0;
  for (size_t r = 1; r < step->nalternative; r++)
    if (step->alternative[r].not_tried)
      printf("%s%s", n++ == 0 ? "  not fitted, though the linear model rates them as good: " : ", ",
             d->candidates->candidate[step->alternative[r].candidate].name);
  if (n > 0) putchar('\n');
}

/* What convinces a sceptic, a line each. */
static void print_sceptic(const struct um_diagnosis *d)
{
  const struct um_diagnosis_sceptic *s = &d->sceptic;
  const struct um_diagnosis_step *step = &d->step[s->step];
  double p = step->alternative[0].probability;
  printf("  probability %.2g among what was fitted and nothing\n", p > 0.995 ? 1.0 : p);
  if (isnan(s->frozen))
    printf("  frozen: neither half of the time sees it\n");
  else
    printf("  frozen: values from one half of the time explain %.3g sigma in the other\n",
           s->frozen);
  printf("  search: noise alone does as well in %s %.2g of searches\n",
         s->search_p * (UM_DIAGNOSIS_DRAWS + 1) < 1.5 ? "less than" : "some", s->search_p);
  printf("  influence: %zu of %zu changes of one row, channel or prior would change what is "
         "named%s%s\n",
         s->flips, s->variations, s->flips_by != NULL ? ", first " : "",
         s->flips_by != NULL ? s->flips_by : "");
  if (s->has_else)
    printf(
        "  open set: were it not in the catalogue, %s would be %s, BIC %+.1f, reduced chi-square "
        "%.3g\n",
        d->candidates->candidate[s->else_candidate].name,
        s->else_reduced > UM_DIAGNOSIS_BAD_FIT ? "next and the verdict unexplained" : "named",
        s->else_behind, s->else_reduced);
  else
    printf("  open set: were it not in the catalogue, nothing would be named\n");
}

static enum um_status print_step(struct um_context *context, const struct um_diagnosis *d, size_t s)
{
  const struct um_diagnosis_step *step = &d->step[s];
  const double *before = s == 0 ? d->value_before : um_diagnosis_report_step_values(d, step - 1);
  double dof_before = s == 0 ? d->dof : step[-1].dof;
  double reduced = s == 0 ? d->chi2_reduced : step[-1].chi2_reduced;
  const double *after = um_diagnosis_report_step_values(d, step);
  printf("\nstep %zu: ", s + 1);
  print_name(step->addition.effect, step->addition.target);
  printf("%s\n", step->removed ? ", no longer needed at the end and taken out again" : "");
  print_parameters(d, step->addition.effect, step->addition.target, step->addition.value,
                   step->sigma);
  printf("  reduced chi-square %.4g -> %.4g, p %s%.2g, delta BIC %.4g, held-out chi-square %.4g -> "
         "%.4g\n",
         reduced, step->chi2_reduced, step->p_value < TINY ? "below " : "",
         fmax(step->p_value, TINY), step->delta_bic, step->held_out_before, step->held_out);
  if (before != NULL && after != NULL)
    UM_TRY(print_channels(context, d, before, dof_before, after, step->dof));
  print_alternatives(d, step);
  if (d->sceptic.asked && d->sceptic.step == s) print_sceptic(d);
  print_worse(d, step);
  return UM_OK;
}

static void print_uses(const struct um_diagnosis *d, const char *title,
                       const struct um_model_addition *addition,
                       double (*sigma)[UM_EFFECT_PARAMETERS_MAX], size_t n)
{
  for (size_t i = 0; i < n; i++) {
    printf("\n%s: ", title);
    print_name(addition[i].effect, addition[i].target);
    printf("\n");
    print_parameters(d, addition[i].effect, addition[i].target, addition[i].value, sigma[i]);
  }
}

/* ---- what is left ---- */

/* What is far behind is left to the files. */
static void print_superseded(const struct um_diagnosis *d)
{
  for (size_t i = 0; i < d->nsuperseded; i++) {
    const struct um_diagnosis_superseded *s = &d->superseded[i];
    if (s->bic - d->bic_after > UM_DIAGNOSIS_FAR_BEHIND) continue;
    printf("\nreplaced by others, BIC %+.1f%s: ", s->bic - d->bic_after, s->alone ? " alone" : "");
    print_name(s->addition.effect, s->addition.target);
    printf("\n");
    print_parameters(d, s->addition.effect, s->addition.target, s->addition.value, s->sigma);
  }
}

static void print_residual(const struct um_missing_heat_residual *r)
{
  if (r->channel == NULL) return;
  printf("residual: worst in %s, chi-square %.3g per observation, %+.2g sigma on average",
         r->channel, r->chi2_reduced, r->mean);
  if (r->coordinate != NULL) printf(", correlates with %s (p %.2g)", r->coordinate, r->p);
  printf("\n");
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
  const struct um_sensitivity_forward *f = d->forward;
  print_wrapped(d->summary != NULL ? d->summary : "");
  printf("\nverdict: %s\n", um_diagnosis_verdict_name(d->verdict));
  printf("%s against %s: %zu observations", f->model->scenario->name, f->measurements->path,
         f->observations.count);
  if (d->candidates != NULL) printf(", %zu candidates", d->candidates->count);
  printf("\n\nbaseline: reduced chi-square %.4g (%.6g of %.6g degrees of freedom)\n",
         d->chi2_reduced, d->chi2, d->dof);
  UM_TRY(print_channels(context, d, d->value_before, d->dof, NULL, 0.0));
  print_residual(&d->residual);
  print_sampling(f);
  for (size_t s = 0; s < d->nstep; s++) UM_TRY(print_step(context, d, s));
  if (d->nstep == 0 && d->naddition > 0) { /* chosen, not found */
    print_uses(d, "fitted", d->addition, d->addition_sigma, d->naddition);
    printf("  reduced chi-square %.4g -> %.4g\n", d->chi2_reduced, d->chi2_reduced_after);
    UM_TRY(print_channels(context, d, d->value_before, d->dof, d->value_after, d->dof_after));
  }
  print_uses(d, "fitted along", d->nuisance, d->nuisance_sigma, d->nnuisance);
  um_app_posterior_print(d);
  print_superseded(d);
  um_app_diagnosis_print_next(d);
  if (d->allowance) printf("\nwhat is left is not quite noise\n");
  printf("\n%zu model evaluations in the time of %.3g forward runs (%.3g s)\n", f->evaluations,
         f->seconds / f->seconds_first, f->seconds);
  printf("the scenario as it now stands in %s/improved\n", folder);
  um_app_tell_results(folder);
  return UM_OK;
}
