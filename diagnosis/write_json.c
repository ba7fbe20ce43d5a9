/* diagnosis.json. */
#include <math.h>

#include "compare/figures.h"
#include "core/json.h"
#include "diagnosis/report_impl.h"

/* ---- pieces ---- */

static void json_text(FILE *file, const char *before, const char *key, const char *text)
{
  fprintf(file, "%s\"%s\": ", before, key);
  if (text == NULL)
    fputs("null", file);
  else
    um_core_json_string(file, text);
}

static void json_time(FILE *file, const char *before, const char *key, double t_tai)
{
  char text[40];
  if (isfinite(t_tai)) um_compare_time_text(t_tai, text);
  json_text(file, before, key, isfinite(t_tai) ? text : NULL);
}

static void json_bool(FILE *file, const char *before, const char *key, bool value)
{
  fprintf(file, "%s\"%s\": %s", before, key, value ? "true" : "false");
}

static void json_use(FILE *file, const struct um_effect *effect, const char *target)
{
  json_text(file, "", "effect", effect->name);
  json_text(file, ", ", "target", target);
}

static void json_parameter(FILE *file, const struct um_effect_parameter *parameter, double value,
                           double sigma)
{
  json_text(file, "{", "name", parameter->name);
  um_core_json_field(file, ", ", "value", value);
  um_core_json_field(file, ", ", "sigma", sigma);
  json_text(file, ", ", "unit", parameter->unit);
  fputc('}', file);
}

static void json_parameters(FILE *file, const struct um_effect *effect, const double *value,
                            const double *sigma)
{
  fputs(", \"parameters\": [", file);
  for (size_t p = 0; p < effect->nparameter; p++) {
    fputs(p > 0 ? ", " : "", file);
    json_parameter(file, &effect->parameters[p], value[p], sigma[p]);
  }
  fputc(']', file);
}

/* By channel; value NULL: null. */
static enum um_status json_metrics(struct um_context *context, FILE *file,
                                   const struct um_diagnosis *d, const char *indent,
                                   const double *value, double dof)
{
  const char *between = "";
  fprintf(file, ",\n%s\"metrics\": %s", indent, value == NULL ? "null" : "[");
  for (size_t c = 0; value != NULL && c < d->forward->measurements->nchannel; c++) {
    struct um_compare_metrics metrics;
    UM_TRY(um_diagnosis_channel_metrics(context, d, c, value, dof, &metrics));
    if (metrics.count == 0) continue;
    fprintf(file, "%s\n%s  {", between, indent);
    um_compare_json_channel(file, um_diagnosis_channel(d, c));
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
  const struct um_diagnosis_whiteness *w = after ? &d->final_whiteness : &d->baseline_whiteness;
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

static void json_uses(FILE *file, const char *key, const struct um_diagnosis_addition *addition,
                      double (*sigma)[UM_EFFECT_PARAMETERS_MAX], size_t n)
{
  fprintf(file, ",\n  \"%s\": [", key);
  for (size_t i = 0; i < n; i++) {
    fputs(i > 0 ? ",\n    {" : "\n    {", file);
    json_use(file, addition[i].effect, addition[i].target);
    json_parameters(file, addition[i].effect, addition[i].value, sigma[i]);
    fputc('}', file);
  }
  fputc(']', file);
}

/* ---- steps and ranking ---- */

static void json_score(FILE *file, const struct um_diagnosis_score *score)
{
  um_core_json_field(file, ", ", "chi2_explained", score->statistic);
  um_core_json_field(file, ", ", "dof", score->dof);
  um_core_json_field(file, ", ", "p", score->p);
  um_core_json_field(file, ", ", "p_corrected", score->p_corrected);
  um_core_json_field(file, ", ", "kept", score->kept);
  json_bool(file, ", ", "absorbed", score->absorbed);
}

static void json_rival(FILE *file, const struct um_diagnosis *d,
                       const struct um_diagnosis_rival *rival)
{
  const struct um_diagnosis_candidate *candidate = um_diagnosis_candidate_of(d, rival);
  fputc('{', file);
  json_use(file, candidate->effect, candidate->target);
  json_score(file, &rival->score);
  json_bool(file, ", ", "fitted", rival->fitted);
  if (rival->fitted) {
    um_core_json_field(file, ", ", "chi2", rival->chi2);
    um_core_json_field(file, ", ", "bic", rival->bic);
    um_core_json_field(file, ", ", "held_out", rival->held_out);
    json_parameters(file, candidate->effect, rival->value, rival->sigma);
  }
  um_core_json_field(file, ", ", "separation", rival->separation);
  json_bool(file, ", ", "indistinguishable", rival->indistinguishable);
  json_bool(file, ", ", "incredible", rival->incredible);
  fputc('}', file);
}

static void json_indistinguishable(FILE *file, const struct um_diagnosis *d,
                                   const struct um_diagnosis_step *step)
{
  const char *between = "";
  fputs(", \"indistinguishable_from\": [", file);
  for (size_t r = 0; r < step->nrival; r++) {
    if (!step->rival[r].indistinguishable || step->rival[r].candidate == step->candidate) continue;
    fputs(between, file);
    um_core_json_string(file, um_diagnosis_candidate_of(d, &step->rival[r])->name);
    between = ", ";
  }
  fputc(']', file);
}

static enum um_status json_step(struct um_context *context, FILE *file,
                                const struct um_diagnosis *d, const struct um_diagnosis_step *step)
{
  fputs("\n    {", file);
  json_use(file, step->addition.effect, step->addition.target);
  json_parameters(file, step->addition.effect, step->addition.value, step->sigma);
  um_core_json_field(file, ",\n     ", "p_value", step->p_value);
  um_core_json_field(file, ", ", "delta_bic", step->delta_bic);
  um_core_json_field(file, ", \"held_out\": {", "before", step->held_out_before);
  um_core_json_field(file, ", ", "after", step->held_out);
  um_core_json_field(file, "}, ", "chi2", step->chi2);
  um_core_json_field(file, ", ", "dof", step->dof);
  um_core_json_field(file, ", ", "chi2_red", step->chi2_reduced);
  json_bool(file, ", ", "by_prior", step->by_prior);
  json_bool(file, ", ", "removed", step->removed);
  json_indistinguishable(file, d, step);
  UM_TRY(json_metrics(context, file, d, "     ", um_diagnosis_step_values(d, step), step->dof));
  fputs(",\n     \"rivals\": [", file);
  for (size_t r = 0; r < step->nrival; r++) {
    fputs(r > 0 ? ",\n       " : "\n       ", file);
    json_rival(file, d, &step->rival[r]);
  }
  fputs("]}", file);
  return UM_OK;
}

static void json_ranking(FILE *file, const struct um_diagnosis *d)
{
  fputs(",\n  \"ranking\": [", file);
  for (size_t i = 0; i < d->nranking; i++) {
    const struct um_diagnosis_rival *rival = &d->ranking[i];
    const struct um_diagnosis_candidate *candidate = um_diagnosis_candidate_of(d, rival);
    fputs(i > 0 ? ",\n    {" : "\n    {", file);
    json_use(file, candidate->effect, candidate->target);
    json_score(file, &rival->score);
    fputs(", \"parameters\": [", file);
    for (size_t k = 0; k < candidate->ncolumn && !candidate->is_switch; k++) {
      double value, sigma;
      um_diagnosis_estimate(candidate, &rival->score, k, &value, &sigma);
      fputs(k > 0 ? ", " : "", file);
      json_parameter(file, &candidate->effect->parameters[candidate->parameter[k]], value, sigma);
    }
    fputs("]}", file);
  }
  fputc(']', file);
}

/* ---- what is left ---- */

static void json_next(FILE *file, const struct um_diagnosis_next *next)
{
  fputs(",\n  \"next_measurement\": ", file);
  if (next == NULL) {
    fputs("null", file);
    return;
  }
  json_text(file, "{", "what", next->what);
  if (next->what != NULL) {
    json_text(file, ", ", "quantity", um_compare_quantity_name(next->quantity));
    json_text(file, ", ", "of", next->of);
    json_text(file, ", ", "segment", um_compare_segment_name(next->segment));
    um_core_json_field(file, ", ", "sigma", next->sigma);
    json_text(file, ", ", "unit", um_compare_quantity_unit(next->quantity));
    um_core_json_field(file, ", ", "separation_per_row", next->separation);
    json_time(file, ", ", "from_utc", next->from);
    json_time(file, ", ", "to_utc", next->to);
  }
  fputc('}', file);
}

static void json_heat(FILE *file, const struct um_diagnosis_heat *heat)
{
  json_text(file, "", "part", heat->place);
  json_time(file, ", ", "start_utc", heat->start);
  um_core_json_field(file, ", ", "start_sigma_s", heat->start_sigma);
  json_time(file, ", ", "stop_utc", heat->stop);
  um_core_json_field(file, ", ", "power_W", heat->power);
  um_core_json_field(file, ", ", "energy_J", heat->energy);
  um_core_json_field(file, ", ", "energy_sigma_J", heat->energy_sigma);
  um_core_json_field(file, ", ", "chi2_explained", heat->chi2_explained);
  fputs(",\n      \"history\": [", file);
  for (size_t i = 0; i < heat->nbin; i++) {
    json_time(file, i > 0 ? ",\n        {" : "\n        {", "from_utc", heat->t[i]);
    json_time(file, ", ", "to_utc", heat->t[i + 1]);
    um_core_json_field(file, ", ", "heat_W", heat->heat[i]);
    um_core_json_field(file, ", ", "sigma_W", heat->sigma[i]);
    fputc('}', file);
  }
  fputc(']', file);
}

/* The best place stands in the object itself, the others behind it. */
static void json_unexplained(FILE *file, const struct um_diagnosis_unexplained *u)
{
  fputs(",\n  \"unexplained\": ", file);
  if (u == NULL) {
    fputs("null", file);
    return;
  }
  json_text(file, "{", "coordinate", u->coordinate);
  um_core_json_field(file, ", ", "p", u->p);
  json_text(file, ", ", "channel", u->channel);
  json_bool(file, ", ", "found", u->found);
  um_core_json_field(file, ", ", "chi2_before", u->chi2_before);
  um_core_json_field(file, ", ", "chi2_after", u->chi2_after);
  for (size_t i = 0; i < u->nheat; i++) {
    fputs(i == 0 ? ",\n      " : i == 1 ? ",\n    \"others\": [\n     {" : "},\n     {", file);
    json_heat(file, &u->heat[i]);
  }
  fputs(u->nheat > 1 ? "}]}" : "}", file);
}

static void json_cost(FILE *file, const struct um_diagnosis *d)
{
  const struct um_diagnosis_forward *f = d->forward;
  size_t alive = 0;
  size_t count = d->candidates == NULL ? 0 : d->candidates->count;
  for (size_t i = 0; i < count; i++) alive += !d->candidates->candidate[i].dead;
  fprintf(file, ",\n  \"cost\": {\"candidates\": %zu, \"alive\": %zu, \"evaluations\": %zu", count,
          alive, f->evaluations);
  um_core_json_field(file, ", ", "seconds", f->seconds);
  um_core_json_field(file, ", ", "seconds_forward_run", f->seconds_first);
  um_core_json_field(file, ", ", "forward_runs", f->seconds / f->seconds_first);
  fputc('}', file);
}

enum um_status um_diagnosis_write_json(struct um_context *context,
                                       const struct um_diagnosis *diagnosis, const char *command,
                                       const char *version, FILE *file)
{
  const struct um_diagnosis *d = diagnosis;
  json_text(file, "{\n  ", "scenario", d->forward->model->scenario->name);
  json_text(file, ",\n  ", "measurements", d->forward->measurements->path);
  json_text(file, ",\n  ", "command", command);
  json_text(file, ",\n  ", "version", version);
  json_text(file, ",\n  ", "verdict", um_diagnosis_verdict_name(d->verdict));
  json_text(file, ",\n  ", "sentence", d->sentence);
  um_core_json_field(file, ",\n  ", "level", d->level);
  UM_TRY(json_level(context, file, d, "baseline", false));
  UM_TRY(json_level(context, file, d, "final", true));
  json_uses(file, "effects", d->addition, d->addition_sigma, d->naddition);
  json_uses(file, "nuisances", d->nuisance, d->nuisance_sigma, d->nnuisance);
  fputs(",\n  \"steps\": [", file);
  for (size_t s = 0; s < d->nstep; s++) {
    fputs(s > 0 ? "," : "", file);
    UM_TRY(json_step(context, file, d, &d->step[s]));
  }
  fputc(']', file);
  json_next(file, d->next);
  json_unexplained(file, d->unexplained);
  json_ranking(file, d);
  json_cost(file, d);
  fputs("\n}\n", file);
  return UM_OK;
}
