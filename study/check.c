/* What is known of a study before it runs. */
#include <math.h>
#include <omp.h>

#include "base/core/json.h"
#include "base/uncertainty/surrogate.h"
#include "study/study_impl.h"

#define TERMS_TYPICAL 8 /* points that a surrogate solves for each parameter, about */

static const char *needs(const struct um_study *study, size_t i)
{
  if (study->moves_geometry[i]) return "geometry, heat and light";
  return study->moves_heat[i] ? "heat and light" : "light";
}

/* Wall time of a point in the middle of all ranges [s]. */
static enum um_status time_of_point(struct um_context *context, struct um_study *study,
                                    double *seconds)
{
  double parameter[UM_STUDY_PARAMETERS_MAX], *value = NULL;
  for (size_t i = 0; i < study->nbinding; i++)
    parameter[i] = um_uncertainty_distribution_value(&study->binding[i].distribution, 0.5);
  UM_TRY(um_core_allocate(context, study->nvalue, sizeof *value, &value));
  double begin = omp_get_wtime();
  um_core_quiet_begin(context);
  enum um_status status = um_study_point(context, study, parameter, value);
  um_core_quiet_end(context);
  *seconds = omp_get_wtime() - begin;
  um_core_free(context, value);
  return status;
}

static void print_time(FILE *file, double seconds)
{
  if (seconds < 90.0)
    fprintf(file, "%.0f s", seconds);
  else if (seconds < 5400.0)
    fprintf(file, "%.0f min", seconds / 60.0);
  else
    fprintf(file, "%.1f h", seconds / 3600.0);
}

/* What is known before it runs. */
struct known {
  double points, solved;  /* solved: expected */
  double point, run, all; /* wall times [s] of a point, a run of its own, the study */
  double bytes;           /* of study.nc, at most */
  int workers;
};

static enum um_status learn(struct um_context *context, struct um_study *study, struct known *k)
{
  const struct um_study_file *f = study->file;
  UM_TRY(time_of_point(context, study, &k->point));
  k->workers = study->options.batch.work.workers > 1 ? study->options.batch.work.workers : 1;
  k->points = k->solved = um_study_file_points(f);
  k->run = study->seconds_run;
  if (f->mode == UM_STUDY_SURROGATE) {
    k->solved = (1 + UM_UNCERTAINTY_STATING) * f->held_out + 1;
    k->solved = fmin(k->solved + TERMS_TYPICAL * (double)study->nbinding, f->evaluations);
  }
  k->all = k->solved * k->point / k->workers + um_variant_base_seconds_heat(study->evaluator);
  k->bytes = k->points * (double)study->nvalue * sizeof(double);
  return UM_OK;
}

static void print_known(const struct um_study *study, const struct known *k, FILE *file)
{
  const struct um_study_file *f = study->file;
  double least, largest;
  fprintf(file, "%s: %.0f points of %s, %zu curves of %zu observations\n", f->name, k->points,
          study->model->scenario->name, study->noutput, study->ntime);
  fprintf(file, "%-40s %12s %12s %12s  %s\n", "parameter", "from", "to", "scenario",
          "computed anew");
  for (size_t i = 0; i < study->nbinding; i++) {
    um_uncertainty_distribution_ends(&study->binding[i].distribution, &least, &largest);
    fprintf(file, "%-40s %12.6g %12.6g ", study->binding[i].name, least, largest);
    if (isnan(study->binding[i].nominal))
      fprintf(file, "%12s", "-");
    else
      fprintf(file, "%12.6g", study->binding[i].nominal);
    fprintf(file, "  %s\n", needs(study, i));
  }
  fprintf(file, "a run of its own takes ");
  print_time(file, k->run);
  fprintf(file, ", a point in the middle %.2g s\n", k->point);
  if (f->mode == UM_STUDY_SURROGATE)
    fprintf(file, "surrogate: about %.0f points to solve, at most %d\n", k->solved, f->evaluations);
  fprintf(file, "about ");
  print_time(file, k->all);
  fprintf(file, " with %d process%s; study.nc at most %.3g MB\n", k->workers,
          k->workers == 1 ? "" : "es", 1e-6 * k->bytes);
}

static void json_known(const struct um_study *study, const struct known *k, FILE *file)
{
  double least, largest;
  um_core_json_text(file, "{", "name", study->file->name);
  um_core_json_text(file, ", ", "scenario", study->model->scenario->name);
  um_core_json_field(file, ", ", "points", k->points);
  um_core_json_field(file, ", ", "points_to_solve", k->solved);
  um_core_json_count(file, ", ", "curves", study->noutput);
  um_core_json_count(file, ", ", "observations", study->ntime);
  fputs(",\n  \"parameters\": [", file);
  for (size_t i = 0; i < study->nbinding; i++) {
    um_uncertainty_distribution_ends(&study->binding[i].distribution, &least, &largest);
    um_core_json_text(file, i > 0 ? ",\n    {" : "\n    {", "name", study->binding[i].name);
    um_core_json_field(file, ", ", "from", least);
    um_core_json_field(file, ", ", "to", largest);
    um_core_json_field(file, ", ", "scenario", study->binding[i].nominal);
    um_core_json_text(file, ", ", "computed_anew", needs(study, i));
    fputc('}', file);
  }
  um_core_json_field(file, "],\n  ", "run_s", k->run);
  um_core_json_field(file, ", ", "point_s", k->point);
  um_core_json_field(file, ", ", "study_s", k->all);
  um_core_json_count(file, ", ", "processes", (size_t)k->workers);
  um_core_json_field(file, ", ", "study_nc_bytes", k->bytes);
  fputs("}\n", file);
}

enum um_status um_study_print_check(struct um_context *context, struct um_study *study, bool json,
                                    FILE *file)
{
  struct known known;
  UM_TRY(learn(context, study, &known));
  if (json)
    json_known(study, &known, file);
  else
    print_known(study, &known, file);
  return UM_OK;
}
