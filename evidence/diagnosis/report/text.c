/* diagnosis.txt: a diagnosis as tables for a person. */
#include "evidence/diagnosis/report/text.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "evidence/comparison/metrics.h"
#include "evidence/diagnosis/doubt.h"
#include "evidence/diagnosis/report/brief.h"
#include "evidence/diagnosis/report/channels.h"
#include "evidence/diagnosis/report/report_impl.h"
#include "evidence/diagnosis/value_text.h"
#include "evidence/inversion/refine.h"
#include "evidence/sensitivity/stated.h"

#define WORSE 5      /* fitted alternatives that are listed */
#define TINY  1e-300 /* smaller p are not told apart */

static void print_name(FILE *file, const struct um_model_addition *a)
{
  fprintf(file, "%s%s%s%s", a->effect->name, a->target != NULL ? ":" : "",
          a->target != NULL ? a->target : "", a->off ? " off" : "");
}

/* ---- channels ---- */

/* rms and reduced chi-square per channel with one set of model values, or before and after. */
static enum um_status print_channels(struct um_context *context, FILE *file,
                                     const struct um_diagnosis *d, const double *before,
                                     double dof_before, const double *after, double dof_after)
{
  if (after == NULL)
    fprintf(file, "  %-36s %12s %11s  %10s\n", "", "observations", "rms", "chi2/dof");
  else
    fprintf(file, "  %-36s %12s %27s  %24s\n", "", "observations", "rms", "chi2/dof");
  for (size_t c = 0; c < d->forward->measurements->nchannel; c++) {
    const struct um_compare_channel *channel = um_diagnosis_report_channel(d, c);
    struct um_compare_metrics m, n;
    UM_TRY(um_diagnosis_report_channel_metrics(context, d, c, before, dof_before, &m));
    if (m.count == 0) continue;
    char name[256];
    snprintf(name, sizeof name, "%s %s", um_compare_quantity_name(channel->quantity),
             channel->label);
    fprintf(file, "  %-36s %12zu %11.4g", name, m.count, m.rms);
    if (after != NULL) {
      UM_TRY(um_diagnosis_report_channel_metrics(context, d, c, after, dof_after, &n));
      fprintf(file, " -> %12.4g  %10.4g -> %10.4g", n.rms, m.chi2_reduced, n.chi2_reduced);
    } else {
      fprintf(file, "  %10.4g", m.chi2_reduced);
    }
    fprintf(file, "  %s\n", um_compare_residual_unit(channel->quantity));
  }
  return UM_OK;
}

/* How much of sigma is the model's own, and what was done about it. */
static void print_sampling(FILE *file, const struct um_sensitivity_forward *f)
{
  if (f->observations.model_share > UM_COMPARE_SHARE_SHOWN)
    fprintf(
        file,
        "  the model's own sampling error is %.2g %% of the variance, and stands in chi-square\n",
        100.0 * f->observations.model_share);
  if (f->samples != f->samples_before)
    fprintf(file,
            "  optics.samples %d in place of the scenario's %d, so that this error stays small\n",
            f->samples, f->samples_before);
}

/* ---- effects ---- */

static void put_whole(const struct um_diagnosis_whole *whole, char out[170])
{
  char text[160];
  um_diagnosis_whole_text(whole, text);
  snprintf(out, 170, "(%s)", text);
}

/* Beside each parameter what the scenario states as a whole. */
static void print_parameters(FILE *file, const struct um_diagnosis *d,
                             const struct um_effect *effect, const char *target,
                             const double *value, const double *sigma)
{
  if (effect->on_by_default)
    fprintf(file, "  switched %s\n", um_sensitivity_is_on(d->forward, effect) ? "off" : "on");
  for (size_t p = 0; p < effect->nparameter; p++) {
    const struct um_effect_parameter *parameter = &effect->parameters[p];
    double present[UM_EFFECT_PARAMETERS_MAX], low, high;
    um_sensitivity_forward_null(d->forward, effect, target, present);
    um_sensitivity_stated_range(d->forward, effect, target, p, present[p], &low, &high);
    bool bound = !effect->on_by_default && (value[p] <= low || value[p] >= high);
    struct um_diagnosis_whole whole;
    char text[80], of[170] = "";
    um_diagnosis_value_text(value[p], sigma[p], "+-", text);
    if (um_diagnosis_whole_find(d->forward, effect, target, p, value[p], sigma[p], &whole))
      put_whole(&whole, of);
    fprintf(file, "  %-36s %s%s%s%s%s%s\n", parameter->name, text,
            strcmp(parameter->unit, "1") == 0 ? "" : " ",
            strcmp(parameter->unit, "1") == 0 ? "" : parameter->unit, bound ? ", at its bound" : "",
            of[0] != '\0' ? " " : "", of);
  }
}

/* One that was fitted, with its values. */
static void print_alternative(FILE *file, const struct um_diagnosis *d,
                              const struct um_diagnosis_alternative *alternative)
{
  const struct um_sensitivity_candidate *c = &d->candidates->candidate[alternative->candidate];
  char text[UM_DIAGNOSIS_VALUES_MAX];
  um_diagnosis_values_text(d->forward, c->effect, c->target, alternative->value, alternative->sigma,
                           true, text);
  fprintf(file, "%s%s%s", c->name, text[0] != '\0' ? " " : "", text);
}

/* How an alternative stands to the winner; NULL: not fitted, or too far behind to be named. */
static const char *relation(const struct um_diagnosis_alternative *r, double behind)
{
  if (r->contains_winner) return "the same where it is always on, and switching explains no more:";
  if (r->indistinguishable) return "cannot be told from";
  if (r->excluded_by_prior) return "kept out by its prior alone:";
  if (r->excluded_by_range) return "kept out by the end of its range alone:";
  if (r->fitted && behind < UM_DIAGNOSIS_NEXT_BEST)
    return r->same_effect ? "as well with" : "next best";
  return NULL;
}

/* The best of those that were fitted and are too far behind to be an alternative, by BIC against
 * the winner; those far behind are left to the files. */
static void print_worse(FILE *file, const struct um_diagnosis *d,
                        const struct um_diagnosis_step *step)
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
    fprintf(file, "  fitted and worse: ");
    print_alternative(file, d, alternative);
    fprintf(file, ", BIC %s%+.1f\n", alternative->converged ? "" : "up to ", behind);
    shown++;
  }
  if (more > 0)
    fprintf(file, "  %s%zu more that %s fitted and worse: diagnosis.json has %s\n",
            shown > 0 ? "and " : "", more, more == 1 ? "was" : "were", more == 1 ? "it" : "them");
}

/* The effect's label, and what comes near the winner. */
static void print_alternatives(FILE *file, const struct um_diagnosis *d,
                               const struct um_diagnosis_step *step)
{
  static const char *const label[] = {"certain", "one of a group",
                                      "small, what it is cannot be known", "needed, not certain"};
  const struct um_diagnosis_alternative *winner = &step->alternative[0];
  const char *doubt = um_diagnosis_doubt_of(d, step);
  bool said = step->confidence == UM_CONFIDENCE_UNCERTAIN && doubt != NULL;
  if (!step->removed)
    fprintf(file, "  %s%s%s\n", label[step->confidence], said ? ": " : "", said ? doubt : "");
  for (size_t r = 1; r < step->nalternative; r++) {
    const struct um_diagnosis_alternative *alternative = &step->alternative[r];
    double behind = alternative->bic - winner->bic;
    const char *how = relation(alternative, behind);
    if (how == NULL) continue;
    fprintf(file, "  %s ", how);
    print_alternative(file, d, alternative);
    fprintf(file, ", BIC %+.1f, expected chi-square difference %.3g%s\n", behind,
            alternative->chi2_difference,
            alternative->implausible ? ", not a plausible value" : "");
  }
  if (step->by_prior) fprintf(file, "  only the priors of the effects tell them apart\n");
  size_t n = 0;
  for (size_t r = 1; r < step->nalternative; r++)
    if (step->alternative[r].not_tried)
      fprintf(file, "%s%s",
              n++ == 0 ? "  not fitted, though the linear model rates them as good: " : ", ",
              d->candidates->candidate[step->alternative[r].candidate].name);
  if (n > 0) fputc('\n', file);
}

/* What convinces a sceptic, a line each. */
static void print_sceptic(FILE *file, const struct um_diagnosis *d)
{
  const struct um_diagnosis_sceptic *s = &d->sceptic;
  const struct um_diagnosis_step *step = &d->step[s->step];
  double p = step->alternative[0].probability;
  fprintf(file, "  probability %.2g among what was fitted and nothing\n", p > 0.995 ? 1.0 : p);
  if (isnan(s->frozen))
    fprintf(file, "  frozen: neither half of the time sees it\n");
  else
    fprintf(file, "  frozen: values from one half of the time explain %.3g sigma in the other\n",
            s->frozen);
  fprintf(file, "  search: noise alone does as well in %s %.2g of searches\n",
          s->search_p * (UM_DIAGNOSIS_DRAWS + 1) < 1.5 ? "less than" : "some", s->search_p);
  fprintf(
      file,
      "  influence: %zu of %zu changes of a row, channel, prior or the noise would change what is "
      "named%s%s\n",
      s->flips, s->variations, s->flips_by != NULL ? ", first " : "",
      s->flips_by != NULL ? s->flips_by : "");
  if (s->has_else)
    fprintf(
        file,
        "  open set: were it not in the catalogue, %s would be %s, BIC %+.1f, reduced chi-square "
        "%.3g\n",
        d->candidates->candidate[s->else_candidate].name,
        s->else_reduced > UM_DIAGNOSIS_BAD_FIT ? "next and the verdict unexplained" : "named",
        s->else_behind, s->else_reduced);
  else
    fprintf(file, "  open set: were it not in the catalogue, nothing would be named\n");
}

static enum um_status print_step(struct um_context *context, FILE *file,
                                 const struct um_diagnosis *d, size_t s)
{
  const struct um_diagnosis_step *step = &d->step[s];
  const double *before = s == 0 ? d->value_before : um_diagnosis_report_step_values(d, step - 1);
  double dof_before = s == 0 ? d->dof : step[-1].dof;
  double reduced = s == 0 ? d->chi2_reduced : step[-1].chi2_reduced;
  const double *after = um_diagnosis_report_step_values(d, step);
  fprintf(file, "\nstep %zu: ", s + 1);
  print_name(file, &step->addition);
  fprintf(file, "%s\n", step->removed ? ", no longer needed at the end and taken out again" : "");
  print_parameters(file, d, step->addition.effect, step->addition.target, step->addition.value,
                   step->sigma);
  fprintf(
      file,
      "  reduced chi-square %.4g -> %.4g, p %s%.2g, delta BIC %.4g, held-out chi-square %.4g -> "
      "%.4g\n",
      reduced, step->chi2_reduced, step->p_value < TINY ? "below " : "", fmax(step->p_value, TINY),
      step->delta_bic, step->held_out_before, step->held_out);
  if (before != NULL && after != NULL)
    UM_TRY(print_channels(context, file, d, before, dof_before, after, step->dof));
  print_alternatives(file, d, step);
  if (d->sceptic.asked && d->sceptic.step == s) print_sceptic(file, d);
  print_worse(file, d, step);
  return UM_OK;
}

static void print_uses(FILE *file, const struct um_diagnosis *d, const char *title,
                       const struct um_model_addition *addition,
                       double (*sigma)[UM_EFFECT_PARAMETERS_MAX], size_t n)
{
  for (size_t i = 0; i < n; i++) {
    fprintf(file, "\n%s: ", title);
    print_name(file, &addition[i]);
    fprintf(file, "\n");
    print_parameters(file, d, addition[i].effect, addition[i].target, addition[i].value, sigma[i]);
  }
}

/* ---- what is left ---- */

/* What is far behind is left to the files. */
static void print_superseded(FILE *file, const struct um_diagnosis *d)
{
  for (size_t i = 0; i < d->nsuperseded; i++) {
    const struct um_diagnosis_superseded *s = &d->superseded[i];
    if (s->bic - d->bic_after > UM_DIAGNOSIS_FAR_BEHIND) continue;
    fprintf(file, "\nreplaced by others, BIC %+.1f%s: ", s->bic - d->bic_after,
            s->alone ? " alone" : "");
    print_name(file, &s->addition);
    fprintf(file, "\n");
    print_parameters(file, d, s->addition.effect, s->addition.target, s->addition.value, s->sigma);
  }
}

static void print_residual(FILE *file, const struct um_missing_heat_residual *r)
{
  if (r->channel == NULL) return;
  fprintf(file, "residual: worst in %s, chi-square %.3g per observation, %+.2g sigma on average",
          r->channel, r->chi2_reduced, r->mean);
  if (r->coordinate != NULL) fprintf(file, ", correlates with %s (p %.2g)", r->coordinate, r->p);
  fprintf(file, "\n");
}

enum um_status um_diagnosis_report_write_text(struct um_context *context,
                                              const struct um_diagnosis *diagnosis, FILE *file)
{
  const struct um_diagnosis *d = diagnosis;
  const struct um_sensitivity_forward *f = d->forward;
  um_diagnosis_report_wrap(file, d->summary != NULL ? d->summary : "", SIZE_MAX);
  fprintf(file, "\nverdict: %s\n", um_diagnosis_verdict_name(d->verdict));
  fprintf(file, "%s against %s: %zu observations", f->model->scenario->name, f->measurements->path,
          f->observations.count);
  if (d->candidates != NULL) fprintf(file, ", %zu candidates", d->candidates->count);
  fprintf(file, "\n\nbaseline: reduced chi-square %.4g (%.6g of %.6g degrees of freedom)\n",
          d->chi2_reduced, d->chi2, d->dof);
  UM_TRY(print_channels(context, file, d, d->value_before, d->dof, NULL, 0.0));
  print_residual(file, &d->residual);
  print_sampling(file, f);
  for (size_t s = 0; s < d->nstep; s++) UM_TRY(print_step(context, file, d, s));
  if (d->nstep == 0 && d->naddition > 0) { /* chosen, not found */
    print_uses(file, d, "fitted", d->addition, d->addition_sigma, d->naddition);
    fprintf(file, "  reduced chi-square %.4g -> %.4g\n", d->chi2_reduced, d->chi2_reduced_after);
    UM_TRY(print_channels(context, file, d, d->value_before, d->dof, d->value_after, d->dof_after));
  }
  print_uses(file, d, "fitted along", d->nuisance, d->nuisance_sigma, d->nnuisance);
  um_diagnosis_report_write_text_posterior(d, file);
  print_superseded(file, d);
  um_diagnosis_report_write_text_next(d, file);
  if (d->allowance) fprintf(file, "\nwhat is left is not quite noise\n");
  fprintf(file, "\n%zu model evaluations in the time of %.3g forward runs (%.3g s)\n",
          f->evaluations, f->seconds / f->seconds_first, f->seconds);
  fputs("the scenario as it now stands: improved/scenario.yaml\n", file);
  return UM_OK;
}
