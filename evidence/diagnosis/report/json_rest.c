/* The end of diagnosis.json: what others replaced, what the residual looks like, what to measure
 * next, missing heat, cost. */
#include <math.h>

#include "evidence/diagnosis/report/report_impl.h"

#include "base/core/constants.h"
#include "base/core/json.h"

/* Passes to come. */
static void json_passes(FILE *file, const struct um_diagnosis_next *next)
{
  fputs(", \"passes\": [", file);
  for (size_t i = 0; i < next->npass; i++) {
    const struct um_diagnosis_pass *p = &next->pass[i];
    um_core_json_text(file, i > 0 ? ",\n      {" : "\n      {", "station", p->station);
    um_diagnosis_report_json_time(file, ", ", "rise_utc", p->rise);
    um_diagnosis_report_json_time(file, ", ", "culmination_utc", p->culmination);
    um_diagnosis_report_json_time(file, ", ", "set_utc", p->set);
    um_core_json_field(file, ", ", "elevation_deg", p->elevation / UM_DEG);
    um_core_json_field(file, ", ", "sun_elevation_deg", p->sun_elevation / UM_DEG);
    um_core_json_text(file, ", ", "of", p->of);
    um_core_json_field(file, ", ", "sigma", p->sigmas);
    um_diagnosis_report_json_time(file, ", ", "best_from_utc", p->from);
    um_core_json_field(file, ", ", "seconds_to_5_sigma", p->seconds);
    fputc('}', file);
  }
  fputc(']', file);
}

/* The fields of an observation that tells two explanations apart. */
static void json_next_fields(FILE *file, const struct um_diagnosis_next *next)
{
  um_core_json_text(file, "", "what", next->what);
  if (next->what != NULL) {
    um_core_json_text(file, ", ", "quantity", um_compare_quantity_name(next->quantity));
    um_core_json_text(file, ", ", "of", next->of);
    um_core_json_text(file, ", ", "segment", um_compare_segment_name(next->segment));
    um_core_json_field(file, ", ", "airmass_above", next->airmass);
    um_core_json_field(file, ", ", "sigma", next->sigma);
    um_core_json_text(file, ", ", "unit", um_compare_quantity_unit(next->quantity));
    um_core_json_field(file, ", ", "chi2_difference_per_observation", next->chi2_difference);
    um_core_json_field(file, ", ", "values_to_5_sigma", um_diagnosis_next_values(next));
    um_core_json_field(file, ", ", "seconds_to_5_sigma",
                       um_diagnosis_next_values(next) * next->cadence);
    um_core_json_field(file, ", ", "phase_from_deg", next->phase_from / UM_DEG);
    um_core_json_field(file, ", ", "phase_to_deg", next->phase_to / UM_DEG);
    um_diagnosis_report_json_time(file, ", ", "from_utc", next->from);
    um_diagnosis_report_json_time(file, ", ", "to_utc", next->to);
  }
  um_core_json_text(file, ", ", "told_apart_by", next->told_apart_by);
  json_passes(file, next);
}

/* For the alternative that is hardest to tell, then for each of them. */
void um_diagnosis_report_json_next(FILE *file, const struct um_diagnosis *d)
{
  fputs(",\n  \"next_measurement\": ", file);
  if (d->next == NULL) {
    fputs("null", file);
  } else {
    fputc('{', file);
    json_next_fields(file, d->next);
    fputc('}', file);
  }
  fputs(",\n  \"next_measurements\": [", file);
  for (size_t i = 0; i < d->nnext; i++) {
    const struct um_diagnosis_next *next = &d->next_of[i];
    const char *winner = d->candidates->candidate[d->step[next->step].candidate].name;
    um_core_json_text(file, i > 0 ? ",\n    {" : "\n    {", "effect", winner);
    um_core_json_text(file, ", ", "alternative", d->candidates->candidate[next->candidate].name);
    fputs(", ", file);
    json_next_fields(file, next);
    fputc('}', file);
  }
  fputc(']', file);
}

/* What convinces a sceptic of the first effect. */
void um_diagnosis_report_json_sceptic(FILE *file, const struct um_diagnosis *d)
{
  const struct um_diagnosis_sceptic *s = &d->sceptic;
  fputs(",\n  \"sceptic\": ", file);
  if (!s->asked) {
    fputs("null", file);
    return;
  }
  um_core_json_text(file, "{", "effect", d->candidates->candidate[d->step[s->step].candidate].name);
  um_core_json_field(file, ", ", "frozen_sigma", s->frozen);
  um_core_json_field(file, ", ", "search_p", s->search_p);
  fprintf(file, ", \"variations\": %zu, \"flips\": %zu", s->variations, s->flips);
  um_core_json_text(file, ", ", "flips_by", s->flips_by);
  um_core_json_text(file, ", ", "else_named",
                    s->has_else ? d->candidates->candidate[s->else_candidate].name : NULL);
  um_core_json_field(file, ", ", "else_behind", s->has_else ? s->else_behind : (double)NAN);
  um_core_json_field(file, ", ", "else_chi2_red", s->has_else ? s->else_reduced : (double)NAN);
  fputc('}', file);
}

/* How observations scatter beside the model, and those that were set aside. */
void um_diagnosis_report_json_scatter(FILE *file, const struct um_diagnosis *d)
{
  const struct um_compare_measurements *m = d->forward->measurements;
  fputs(",\n  \"scatter\": [", file);
  for (size_t i = 0; i < d->nscatter; i++) {
    const struct um_diagnosis_scatter *s = &d->scatter[i];
    const struct um_compare_channel *c = &m->channel[s->channel];
    um_core_json_text(file, i > 0 ? ",\n    {" : "\n    {", "quantity",
                      um_compare_quantity_name(c->quantity));
    um_core_json_text(file, ", ", "of", c->of);
    um_core_json_field(file, ", ", "scale", s->scale);
    um_core_json_text(file, ", ", "discrepancy_along", s->along);
    um_core_json_field(file, ", ", "discrepancy", s->rms);
    um_core_json_text(file, ", ", "unit", um_compare_residual_unit(c->quantity));
    um_core_json_field(file, ", ", "discrepancy_in_sigma", s->sigmas);
    um_core_json_field(file, ", ", "discrepancy_share", s->share);
    fputc('}', file);
  }
  fputs("],\n  \"outliers\": [", file);
  for (size_t i = 0; i < d->noutlier; i++) {
    const struct um_compare_measurement *row = &m->row[d->outlier[i]];
    const struct um_compare_channel *c = &m->channel[row->channel];
    fprintf(file, "%s{\"line\": %d", i > 0 ? ", " : "", row->line);
    um_diagnosis_report_json_time(file, ", ", "time_utc", row->t_tai);
    um_core_json_text(file, ", ", "quantity", um_compare_quantity_name(c->quantity));
    um_core_json_text(file, ", ", "of", c->of);
    fputc('}', file);
  }
  fputc(']', file);
}

/* What the residual of the baseline looks like. */
void um_diagnosis_report_json_residual(FILE *file, const struct um_missing_heat_residual *r)
{
  fputs(",\n  \"residual\": ", file);
  if (r->channel == NULL) {
    fputs("null", file);
    return;
  }
  um_core_json_text(file, "{", "channel", r->channel);
  um_core_json_field(file, ", ", "chi2_red", r->chi2_reduced);
  um_core_json_field(file, ", ", "mean_in_sigma", r->mean);
  um_core_json_text(file, ", ", "coordinate", r->coordinate);
  um_core_json_field(file, ", ", "p", r->p);
  fputc('}', file);
}

void um_diagnosis_report_json_missed(FILE *file, const struct um_diagnosis *d)
{
  fputs(",\n  \"not_tried\": [", file);
  for (size_t i = 0; i < d->nmissed; i++) {
    um_core_json_text(file, i > 0 ? ",\n    {" : "\n    {", "candidate", d->missed[i].name);
    um_core_json_text(file, ", ", "why", d->missed[i].why);
    um_core_json_bool(file, ", ", "tested", d->missed[i].tested);
    fputc('}', file);
  }
  fputc(']', file);
}

void um_diagnosis_report_json_superseded(FILE *file, const struct um_diagnosis *d)
{
  fputs(",\n  \"superseded\": [", file);
  for (size_t i = 0; i < d->nsuperseded; i++) {
    const struct um_diagnosis_superseded *s = &d->superseded[i];
    fputs(i > 0 ? ",\n    {" : "\n    {", file);
    um_diagnosis_report_json_use(file, d, s->addition.effect, s->addition.target);
    um_diagnosis_report_json_parameters(file, d, s->addition.effect, s->addition.target,
                                        s->addition.value, s->sigma);
    um_core_json_bool(file, ", ", "alone", s->alone);
    um_core_json_field(file, ", ", "chi2", s->chi2);
    um_core_json_field(file, ", ", "bic", s->bic);
    um_core_json_field(file, ", ", "bic_behind", s->bic - d->bic_after);
    fputc('}', file);
  }
  fputc(']', file);
}

static void json_heat(FILE *file, const struct um_missing_heat *heat)
{
  um_core_json_text(file, "", "part", heat->place);
  um_core_json_text(file, ", ", "shape", um_thermal_course_name(heat->course.shape));
  um_diagnosis_report_json_time(file, ", ", "start_utc", heat->course.start);
  um_core_json_field(file, ", ", "start_sigma_s", heat->start_sigma);
  um_diagnosis_report_json_time(file, ", ", "stop_utc", heat->stop);
  um_core_json_field(file, ", ", "last_s", isfinite(heat->course.last) ? heat->course.last : NAN);
  um_core_json_field(file, ", ", "last_sigma_s", heat->last_sigma);
  um_core_json_field(file, ", ", "period_s", heat->course.period);
  um_core_json_field(file, ", ", "period_sigma_s", heat->period_sigma);
  um_core_json_field(file, ", ", "power_W", heat->power);
  um_core_json_field(file, ", ", "energy_J", heat->energy);
  um_core_json_field(file, ", ", "energy_sigma_J", heat->energy_sigma);
  um_core_json_field(file, ", ", "chi2_explained", heat->chi2_explained);
  for (int s = 0; s < UM_HEAT_SHAPES; s++)
    um_core_json_field(file, s == 0 ? ", \"bic_behind\": {" : ", ",
                       um_thermal_course_name((enum um_thermal_course_shape)s), heat->behind[s]);
  fputs("},\n      \"history\": [", file);
  for (size_t i = 0; i < heat->nbin; i++) {
    um_diagnosis_report_json_time(file, i > 0 ? ",\n        {" : "\n        {", "from_utc",
                                  heat->t[i]);
    um_diagnosis_report_json_time(file, ", ", "to_utc", heat->t[i + 1]);
    um_core_json_field(file, ", ", "heat_W", heat->heat[i]);
    um_core_json_field(file, ", ", "sigma_W", heat->sigma[i]);
    um_core_json_field(file, ", ", "low_W", heat->low[i]);
    um_core_json_field(file, ", ", "high_W", heat->high[i]);
    fputc('}', file);
  }
  fputc(']', file);
}

/* The best place stands in the object itself, the others behind it. */
void um_diagnosis_report_json_unexplained(FILE *file, const struct um_missing_heat_unexplained *u,
                                          const struct um_missing_light *light)
{
  fputs(",\n  \"unexplained\": ", file);
  if (u == NULL) {
    fputs("null", file);
    return;
  }
  um_core_json_text(file, "{", "coordinate", u->coordinate);
  um_core_json_field(file, ", ", "p", u->p);
  um_core_json_text(file, ", ", "channel", u->channel);
  um_core_json_bool(file, ", ", "found", u->found);
  um_core_json_field(file, ", ", "chi2_before", u->chi2_before);
  um_core_json_field(file, ", ", "chi2_after", u->chi2_after);
  um_diagnosis_report_json_light(file, "light", light);
  for (size_t i = 0; i < u->nheat; i++) {
    fputs(i == 0 ? ",\n      " : i == 1 ? ",\n    \"others\": [\n     {" : "},\n     {", file);
    json_heat(file, &u->heat[i]);
  }
  fputs(u->nheat > 1 ? "}]}" : "}", file);
}

void um_diagnosis_report_json_cost(FILE *file, const struct um_diagnosis *d)
{
  const struct um_sensitivity_forward *f = d->forward;
  size_t alive = 0;
  size_t count = d->candidates == NULL ? 0 : d->candidates->count;
  for (size_t i = 0; i < count; i++) alive += !d->candidates->candidate[i].insensitive;
  fprintf(file, ",\n  \"cost\": {\"candidates\": %zu, \"alive\": %zu, \"evaluations\": %zu", count,
          alive, f->evaluations);
  um_core_json_field(file, ", ", "seconds", f->seconds);
  um_core_json_field(file, ", ", "seconds_forward_run", f->seconds_first);
  um_core_json_field(file, ", ", "forward_runs", f->seconds / f->seconds_first);
  fprintf(file, ", \"heat_integrations\": %zu, \"heat_sensitivities\": %zu, \"heat_batches\": %zu",
          f->heat_runs, f->heat_sensitivities, f->heat_batches);
  um_core_json_field(file, ", ", "heat_seconds", f->heat_seconds);
  fputc('}', file);
}
