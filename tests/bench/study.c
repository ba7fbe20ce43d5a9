/* What a study of ENVISAT's pass costs, in processor time of this thread: its 1000 points by a
 * surrogate over 1000 runs of their own, an exact point over such a run; and how far both are from
 * runs of their own, at points of the study's design that are spread over the ranges and had no
 * say. Goals: a fiftieth, a tenth, and what the study states of itself, at 99 of 100 values. Some
 * 25 minutes. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "study/identity.h"
#include "study/result.h"
#include "study/study_impl.h"
#include "tests/bench/bench.h"

#define STUDY      UMBRA_SOURCE_DIR "/scenarios/envisat-graz-2016/study.yaml"
#define POINTS     20 /* that are held against runs of their own, and solved exactly, too */
#define QUANTITIES 64

/* Largest differences from runs of their own, by quantity; share of the surrogate's values that are
 * off by more than is stated. */
struct differences {
  double surrogate[QUANTITIES], exact[QUANTITIES], beyond[QUANTITIES];
};

/* The same as a run of its own: from the model on, nothing shared. [s] */
static double own_run(const struct bench *bench, const struct um_study *study,
                      const double *parameter, double *value)
{
  struct um_context *context = bench->context;
  struct um_study_changes changes;
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  bench_must(bench, um_study_changes_make(context, study->model, study->binding, study->nbinding,
                                          parameter, &changes));
  double begin = bench_cpu();
  bench_must(bench, um_model_variant_create(context, study->model, &changes.all, &model));
  bench_must(bench, um_model_precompute(context, model, &tables));
  bench_must(bench, um_model_run(context, model, tables, &result));
  double seconds = bench_cpu() - begin;
  bench_must(bench, um_study_outputs_take(context, study, model, result, value));
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
  um_study_changes_clear(context, &changes);
  return seconds;
}

static void note_worst(const struct um_study *study, const double *value, const double *own,
                       double *largest)
{
  double worst[QUANTITIES];
  um_variant_differences(&study->curves, value, own, worst);
  for (size_t q = 0; q < study->noutput; q++) largest[q] = fmax(largest[q], worst[q]);
}

static void note_beyond(const struct um_study *study, const struct um_study_result *r,
                        const double *value, const double *own, double *share)
{
  for (size_t q = 0, at = 0; q < study->noutput; q++)
    for (size_t k = 0; k < study->ntime; k++, at++) {
      const struct um_variant_curve *of = &study->curve[q];
      double unit = of->relative ? fmax(fabs(own[at]), of->floor) : 1.0;
      share[q] += fabs(value[at] - own[at]) > r->error[q] * unit
                      ? 1.0 / (double)(POINTS * study->ntime)
                      : 0.0;
    }
}

static void compare(struct bench *bench, struct um_study *study, const struct um_study_result *r,
                    struct bench_series *run, struct bench_series *point, struct differences *d)
{
  double *value = bench_allocate(bench, 2 * study->nvalue, sizeof *value);
  double *own = value + study->nvalue;
  for (size_t i = 0; i < POINTS; i++) {
    size_t at = (2 * i + 1) * r->npoint / (2 * POINTS);
    const double *parameter = r->parameter + at * r->nparameter;
    bench_add(run, own_run(bench, study, parameter, own));
    note_worst(study, r->value + at * r->nvalue, own, d->surrogate);
    note_beyond(study, r, r->value + at * r->nvalue, own, d->beyond);
    double begin = bench_cpu();
    bench_must(bench, um_study_point(bench->context, study, parameter, value));
    bench_add(point, bench_cpu() - begin);
    note_worst(study, value, own, d->exact);
  }
  free(value);
}

static void report(struct bench *bench, const struct um_study *study,
                   const struct um_study_result *r, const struct differences *d)
{
  char name[80];
  for (size_t q = 0; q < study->noutput; q++) {
    const char *unit = study->output[q].kind == UM_STUDY_TEMPERATURE ? "K" : "1";
    double asked = study->curve[q].asked;
    snprintf(name, sizeof name, "stated of %.40s over asked", study->output[q].of);
    bench_number(bench, name, unit, r->error[q], asked, 1.0);
    snprintf(name, sizeof name, "surrogate from runs, %.40s, over stated", study->output[q].of);
    bench_number(bench, name, unit, d->surrogate[q], fmax(r->error[q], 1e-6), NAN);
    snprintf(name, sizeof name, "share of its values beyond that, %.40s", study->output[q].of);
    bench_number(bench, name, "1", d->beyond[q], 1.0, 0.01);
    snprintf(name, sizeof name, "exact points from runs, %.40s, over asked", study->output[q].of);
    bench_number(bench, name, unit, d->exact[q], asked, 1.0);
  }
}

int main(int argc, char **argv)
{
  struct bench bench;
  struct um_study *study = NULL;
  struct um_study_result *result = NULL;
  struct bench_series run = {{0}, 0}, point = {{0}, 0};
  struct differences d = {{0}, {0}, {0}};
  char folder[BENCH_FOLDER], records[BENCH_FOLDER + 16];
  bench_begin(&bench, argc, argv, "a study of ENVISAT's pass over runs of their own");
  bench_folder(folder);
  snprintf(records, sizeof records, "%s/points", folder);
  struct um_study_run_options options = {.version = "bench", .batch = {.folder = records}};
  double begin = bench_cpu();
  bench_must(&bench, um_study_create(bench.context, STUDY, &options, &study));
  if (study->noutput > QUANTITIES) return 1;
  double preparing = bench_cpu() - begin;
  bench_must(&bench, um_study_run(bench.context, study, &result));
  double all = bench_cpu() - begin, surrogate_factor = study->accuracy.tolerance.factor;
  study->file->mode = UM_STUDY_EXACT;
  bench_must(&bench, um_study_tolerance(bench.context, study));
  um_study_records_remove(bench.context, records);
  remove(folder);
  compare(&bench, study, result, &run, &point, &d);
  double own = bench_median(&run), of_all = (double)result->npoint * own;
  bench_number(&bench, "all points by a surrogate over runs of their own", "s", all, of_all, 0.02);
  bench_number(&bench, "of it the scenario as it stands", "s", preparing, own, NAN);
  bench_number(&bench, "points solved for it", "1", (double)result->exact, NAN, NAN);
  bench_number(&bench, "factor on their tolerances", "1", surrogate_factor, NAN, NAN);
  bench_number(&bench, "and of an exact study", "1", study->accuracy.tolerance.factor, NAN, NAN);
  bench_time(&bench, "an exact point", "s", &point, &run, 0.1);
  report(&bench, study, result, &d);
  um_study_result_destroy(bench.context, &result);
  um_study_destroy(bench.context, &study);
  return bench_end(&bench);
}
