/* diagnosis.json. */
#include "evidence/diagnosis/report/write_json.h"

#include "base/core/json.h"
#include "evidence/comparison/figures.h"
#include "evidence/diagnosis/doubt.h"
#include "evidence/diagnosis/report/channels.h"
#include "evidence/diagnosis/report/report_impl.h"

/* By channel; value NULL: null. */
static enum um_status json_metrics(struct um_context *context, FILE *file,
                                   const struct um_diagnosis *d, const char *indent,
                                   const double *value, double dof)
{
  const char *between = "";
  fprintf(file, ",\n%s\"metrics\": %s", indent, value == NULL ? "null" : "[");
  for (size_t c = 0; value != NULL && c < d->forward->measurements->nchannel; c++) {
    struct um_compare_metrics metrics;
    UM_TRY(um_diagnosis_report_channel_metrics(context, d, c, value, dof, &metrics));
    if (metrics.count == 0) continue;
    fprintf(file, "%s\n%s  {", between, indent);
    um_compare_json_channel(file, um_diagnosis_report_channel(d, c));
    um_compare_json_metrics(file, ", ", "all", &metrics);
    fputc('}', file);
    between = ",";
  }
  fputs(value == NULL ? "" : "]", file);
  return UM_OK;
}

static enum um_status json_level(struct um_context *context, FILE *file,
                                 const struct um_diagnosis *d, const char *key, bool after)
{
  const struct um_inference_whiteness *w = after ? &d->final_whiteness : &d->baseline_whiteness;
  double dof = after ? d->dof_after : d->dof;
  fprintf(file, ",\n  \"%s\": {\n", key);
  um_core_json_field(file, "    ", "chi2", after ? d->chi2_after : d->chi2);
  um_core_json_field(file, ", ", "dof", dof);
  um_core_json_field(file, ", ", "chi2_red", after ? d->chi2_reduced_after : d->chi2_reduced);
  um_core_json_field(file, ", ", "p_chi2", w->p_chi2);
  um_core_json_field(file, ", ", "p_white", w->p_white);
  um_core_json_field(file, ", ", "worst_channel_chi2_reduced", w->worst);
  um_core_json_field(file, ", ", "p_worst_channel", w->p_worst);
  UM_TRY(json_metrics(context, file, d, "    ", after ? d->value_after : d->value_before, dof));
  fputc('}', file);
  return UM_OK;
}

static void json_uses(FILE *file, const struct um_diagnosis *d, const char *key,
                      const struct um_model_addition *addition,
                      double (*sigma)[UM_EFFECT_PARAMETERS_MAX], size_t n)
{
  fprintf(file, ",\n  \"%s\": [", key);
  for (size_t i = 0; i < n; i++) {
    fputs(i > 0 ? ",\n    {" : "\n    {", file);
    um_diagnosis_report_json_use(file, d, addition[i].effect, addition[i].target);
    um_diagnosis_report_json_parameters(file, d, addition[i].effect, addition[i].target,
                                        addition[i].value, sigma[i]);
    fputc('}', file);
  }
  fputc(']', file);
}

/* ---- steps and ranking ---- */

static void json_score(FILE *file, const struct um_inference_score *score)
{
  um_core_json_field(file, ", ", "chi2_explained", score->statistic);
  um_core_json_field(file, ", ", "dof", score->dof);
  um_core_json_field(file, ", ", "p", score->p);
  um_core_json_field(file, ", ", "p_corrected", score->p_corrected);
  um_core_json_field(file, ", ", "kept", score->kept);
  um_core_json_bool(file, ", ", "absorbed", score->absorbed);
}

static void json_alternative(FILE *file, const struct um_diagnosis *d,
                             const struct um_diagnosis_alternative *alternative)
{
  const struct um_sensitivity_candidate *candidate =
      um_diagnosis_report_candidate_of(d, alternative);
  fputc('{', file);
  um_diagnosis_report_json_use(file, d, candidate->effect, candidate->target);
  json_score(file, &alternative->score);
  um_core_json_bool(file, ", ", "fitted", alternative->fitted);
  if (alternative->fitted) {
    um_core_json_field(file, ", ", "chi2", alternative->chi2);
    um_core_json_field(file, ", ", "bic", alternative->bic);
    um_core_json_field(file, ", ", "chi2_prior", alternative->chi2_prior);
    um_core_json_field(file, ", ", "held_out", alternative->held_out);
    um_diagnosis_report_json_parameters(file, d, candidate->effect, candidate->target,
                                        alternative->value, alternative->sigma);
  }
  um_core_json_field(file, ", ", "probability", alternative->probability);
  um_core_json_field(file, ", ", "chi2_difference", alternative->chi2_difference);
  um_core_json_bool(file, ", ", "indistinguishable", alternative->indistinguishable);
  um_core_json_bool(file, ", ", "not_tried", alternative->not_tried);
  um_core_json_bool(file, ", ", "implausible", alternative->implausible);
  um_core_json_text(file, ", ", "excluded_by",
                    alternative->excluded_by_prior   ? "prior"
                    : alternative->excluded_by_range ? "range"
                                                     : NULL);
  fputc('}', file);
}

/* The names of alternatives that are tied, or that were not tried. */
static void json_names(FILE *file, const struct um_diagnosis *d,
                       const struct um_diagnosis_step *step, const char *key, bool not_tried)
{
  const char *between = "";
  fprintf(file, ", \"%s\": [", key);
  for (size_t r = 1; r < step->nalternative; r++) {
    const struct um_diagnosis_alternative *alternative = &step->alternative[r];
    if (!(not_tried ? alternative->not_tried : alternative->indistinguishable)) continue;
    fputs(between, file);
    um_core_json_string(file, um_diagnosis_report_candidate_of(d, &step->alternative[r])->name);
    between = ", ";
  }
  fputc(']', file);
}

static enum um_status json_step(struct um_context *context, FILE *file,
                                const struct um_diagnosis *d, const struct um_diagnosis_step *step)
{
  fputs("\n    {", file);
  um_diagnosis_report_json_use(file, d, step->addition.effect, step->addition.target);
  um_diagnosis_report_json_parameters(file, d, step->addition.effect, step->addition.target,
                                      step->addition.value, step->sigma);
  um_core_json_text(file, ",\n     ", "standing", um_diagnosis_confidence_name(step->confidence));
  bool uncertain = step->confidence == UM_CONFIDENCE_UNCERTAIN;
  um_core_json_text(file, ", ", "doubt", uncertain ? um_diagnosis_doubt_of(d, step) : NULL);
  um_core_json_field(file, ",\n     ", "p_value", step->p_value);
  um_core_json_field(file, ", ", "delta_bic", step->delta_bic);
  um_core_json_field(file, ", \"held_out\": {", "before", step->held_out_before);
  um_core_json_field(file, ", ", "after", step->held_out);
  um_core_json_field(file, "}, ", "chi2", step->chi2);
  um_core_json_field(file, ", ", "dof", step->dof);
  um_core_json_field(file, ", ", "chi2_red", step->chi2_reduced);
  um_core_json_bool(file, ", ", "by_prior", step->by_prior);
  um_core_json_bool(file, ", ", "removed", step->removed);
  json_names(file, d, step, "indistinguishable_from", false);
  json_names(file, d, step, "not_tried", true);
  UM_TRY(
      json_metrics(context, file, d, "     ", um_diagnosis_report_step_values(d, step), step->dof));
  fputs(",\n     \"alternatives\": [", file);
  for (size_t r = 0; r < step->nalternative; r++) {
    fputs(r > 0 ? ",\n       " : "\n       ", file);
    json_alternative(file, d, &step->alternative[r]);
  }
  fputs("]}", file);
  return UM_OK;
}

static void json_ranking(FILE *file, const struct um_diagnosis *d)
{
  fputs(",\n  \"ranking\": [", file);
  for (size_t i = 0; i < d->nranking; i++) {
    const struct um_diagnosis_alternative *alternative = &d->ranking[i];
    const struct um_sensitivity_candidate *candidate =
        um_diagnosis_report_candidate_of(d, alternative);
    fputs(i > 0 ? ",\n    {" : "\n    {", file);
    um_diagnosis_report_json_use(file, d, candidate->effect, candidate->target);
    json_score(file, &alternative->score);
    fputs(", \"parameters\": [", file);
    for (size_t k = 0; k < candidate->ncolumn && !candidate->is_switch; k++) {
      double value, sigma;
      um_diagnosis_report_estimate(candidate, &alternative->score, k, &value, &sigma);
      fputs(k > 0 ? ", " : "", file);
      um_diagnosis_report_json_parameter(
          file, &candidate->effect->parameters[candidate->parameter[k]], value, sigma);
      fputc('}', file);
    }
    fputs("]}", file);
  }
  fputc(']', file);
}

enum um_status um_diagnosis_report_write_json(struct um_context *context,
                                              const struct um_diagnosis *diagnosis,
                                              const char *command, const char *version, FILE *file)
{
  const struct um_diagnosis *d = diagnosis;
  um_core_json_text(file, "{\n  ", "sentence", d->summary);
  um_core_json_text(file, ",\n  ", "scenario", d->forward->model->scenario->name);
  um_core_json_text(file, ",\n  ", "measurements", d->forward->measurements->path);
  um_core_json_text(file, ",\n  ", "command", command);
  um_core_json_text(file, ",\n  ", "version", version);
  um_core_json_text(file, ",\n  ", "verdict", um_diagnosis_verdict_name(d->verdict));
  um_core_json_field(file, ",\n  ", "level", d->level);
  um_core_json_field(file, ",\n  ", "model_share", d->forward->observations.model_share);
  fprintf(file, ", \"optics_samples\": %d, \"optics_samples_of_scenario\": %d", d->forward->samples,
          d->forward->samples_before);
  UM_TRY(json_level(context, file, d, "baseline", false));
  UM_TRY(json_level(context, file, d, "final", true));
  um_core_json_bool(file, ",\n  ", "not_quite_noise", d->allowance);
  um_core_json_field(file, ",\n  \"probabilities\": {", "nothing", d->probability.nothing);
  um_core_json_field(file, ", ", "one_effect", d->probability.one);
  um_core_json_field(file, ", ", "several_effects", d->probability.several);
  um_core_json_field(file, ", ", "none_of_the_catalogue", d->probability.none);
  fputc('}', file);
  um_diagnosis_report_json_sceptic(file, d);
  um_diagnosis_report_json_scatter(file, d);
  json_uses(file, d, "effects", d->addition, d->addition_sigma, d->naddition);
  json_uses(file, d, "nuisances", d->nuisance, d->nuisance_sigma, d->nnuisance);
  um_diagnosis_report_json_posterior(file, d);
  fputs(",\n  \"steps\": [", file);
  for (size_t s = 0; s < d->nstep; s++) {
    fputs(s > 0 ? "," : "", file);
    UM_TRY(json_step(context, file, d, &d->step[s]));
  }
  fputc(']', file);
  um_diagnosis_report_json_missed(file, d);
  um_diagnosis_report_json_superseded(file, d);
  um_diagnosis_report_json_residual(file, &d->residual);
  um_diagnosis_report_json_next(file, d);
  um_diagnosis_report_json_unexplained(file, d->unexplained, &d->light);
  um_diagnosis_report_json_halves(file, d);
  json_ranking(file, d);
  um_diagnosis_report_json_cost(file, d);
  fputs("\n}\n", file);
  return UM_OK;
}
