/* A run of a scenario on its own, from the model on: what benchmarks of changed runs are held
 * against. */
#ifndef UMBRA_BENCH_OWN_RUN_H
#define UMBRA_BENCH_OWN_RUN_H

#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/bench/bench.h"

/* Processor time of its geometry, heat and light [s]. */
static inline double bench_own_run(const struct bench *bench, const struct um_model *model)
{
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  double begin = bench_cpu();
  bench_must(bench, um_model_precompute(bench->context, model, &tables));
  bench_must(bench, um_model_run(bench->context, model, tables, &result));
  double seconds = bench_cpu() - begin;
  um_model_result_destroy(bench->context, &result);
  um_model_tables_destroy(bench->context, &tables);
  return seconds;
}

#endif
