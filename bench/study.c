/* What a study costs: an exact point of ENVISAT's pass over a run of its own, in processor time of
 * this thread, at two places in the ranges, and how far both are apart. Goals: a tenth of a run;
 * differences within what the study asks. Some 10 minutes. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/bench.h"
#include "model/build.h"
#include "model/precompute.h"
#include "model/run.h"
#include "study/study_impl.h"

#define STUDY  UMBRA_SOURCE_DIR "/scenarios/envisat-graz-2016/study.yaml"
#define POINTS 2

/* Somewhere in the ranges, u by golden ratios. */
static void place(const struct um_study *study, size_t i, double *parameter)
{
  for (size_t j = 0; j < study->nway; j++) {
    double u = fmod(0.5 + 0.6180339887 * (double)(i + 1) + 0.3247179572 * (double)j, 1.0);
    parameter[j] = um_uncertainty_distribution_value(&study->way[j].distribution, u);
  }
}

/* The same as a run of its own: from the model on, nothing shared. [s] */
static double own_run(const struct bench *bench, const struct um_study *study,
                      const double *parameter, double *value)
{
  struct um_context *context = bench->context;
  struct um_model *model = NULL;
  struct um_model_precomputed *precomputed = NULL;
  struct um_model_result *result = NULL;
  double begin = bench_cpu();
  bench_must(bench, um_study_model(context, study, study->way, study->nway, parameter, &model));
  bench_must(bench, um_model_precompute(context, model, &precomputed));
  bench_must(bench, um_model_run(context, model, precomputed, &result));
  double seconds = bench_cpu() - begin;
  bench_must(bench, um_study_outputs_take(context, study, model, result, value));
  um_model_result_destroy(context, &result);
  um_model_precomputed_destroy(context, &precomputed);
  um_model_destroy(context, &model);
  return seconds;
}

int main(int argc, char **argv)
{
  struct bench bench;
  struct um_study *study = NULL;
  struct bench_series run = {{0}, 0}, point = {{0}, 0};
  struct um_study_run_options options = {.version = "bench"};
  double parameter[UM_STUDY_PARAMETERS_MAX], worst[64], largest[64] = {0};
  bench_begin(&bench, argc, argv, "a point of a study of ENVISAT's pass over a run of its own");
  bench_must(&bench, um_study_create(bench.context, STUDY, &options, &study));
  study->file->mode = UM_STUDY_EXACT;
  double begin = bench_cpu();
  bench_must(&bench, um_study_tolerance(bench.context, study));
  double measuring = bench_cpu() - begin;
  double *value = bench_allocate(&bench, 2 * study->nvalue, sizeof *value);
  for (size_t i = 0; i < POINTS; i++) {
    place(study, i, parameter);
    begin = bench_cpu();
    bench_must(&bench, um_study_point(bench.context, study, parameter, value));
    bench_add(&point, bench_cpu() - begin);
    bench_add(&run, own_run(&bench, study, parameter, value + study->nvalue));
    um_study_differences(study, value, value + study->nvalue, worst);
    for (size_t q = 0; q < study->noutput && q < 64; q++) largest[q] = fmax(largest[q], worst[q]);
  }
  bench_time(&bench, "an exact point", "s", &point, &run, 0.1);
  bench_number(&bench, "measuring tolerances, once a study", "s", measuring, bench_median(&run),
               NAN);
  bench_number(&bench, "factor on the tolerances", "1", study->tolerance_factor, NAN, NAN);
  for (size_t q = 0; q < study->noutput && q < 64; q++) {
    char name[80];
    snprintf(name, sizeof name, "difference from runs of their own, %.40s", study->output[q].of);
    bench_number(&bench, name, study->output[q].kind == UM_STUDY_TEMPERATURE ? "K" : "1",
                 largest[q], um_study_asked(study, q), 1.0);
  }
  um_study_destroy(bench.context, &study);
  return bench_end(&bench);
}
