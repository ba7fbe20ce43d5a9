/* A scenario computed from beginning to end. */
#include "tests/scenarios/support.h"

#include <string.h>

#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"

static void need(struct um_context *context, enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

void support_compute(const char *path, const char *const *overrides, size_t noverride,
                     struct support_run *run)
{
  const struct um_model_options options = {.overrides = overrides, .noverride = noverride};
  *run = (struct support_run){0};
  need(NULL, um_core_context_create(NULL, &run->context));
  need(run->context, um_model_create(run->context, path, &options, &run->model));
  need(run->context, um_model_precompute(run->context, run->model, &run->tables));
  need(run->context, um_model_run(run->context, run->model, run->tables, &run->result));
}

void support_release(struct support_run *run)
{
  um_model_result_destroy(run->context, &run->result);
  um_model_tables_destroy(run->context, &run->tables);
  um_model_destroy(run->context, &run->model);
  um_core_context_destroy(&run->context);
}

const double *support_temperature(const struct support_run *run, const char *place)
{
  for (size_t p = 0; p < run->result->nplace; p++)
    if (strcmp(run->result->place[p].name, place) == 0) return run->result->place[p].mean;
  fail_msg("no place is called '%s'", place);
  return NULL;
}

double support_time(const struct support_run *run, size_t k)
{
  return run->tables->t_obs[k] - run->tables->t_obs[0];
}

void support_close(const char *what, double value, double expected, double tolerance)
{
  double error = fabs(value - expected);
  if (!(error <= tolerance))
    fail_msg("%s: %.9g, expected %.9g, off by %.3g, allowed %.3g", what, value, expected, error,
             tolerance);
}
