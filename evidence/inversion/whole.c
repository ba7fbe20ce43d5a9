/* A scenario beside measurements, from its file to the comparison. */
#include "evidence/inversion/whole.h"

#include <string.h>

#include "evidence/comparison/compare.h"
#include "evidence/measurements/noise.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"

enum um_status um_compare_whole_begin(struct um_context *context, const char *path,
                                      const struct um_model_options *options,
                                      const struct um_compare_measurements *measurements,
                                      struct um_compare_whole *whole)
{
  struct um_compare_measurements *own = &whole->measurements;
  *own = *measurements;
  own->row = NULL;
  UM_TRY(um_core_allocate(context, own->count, sizeof *own->row, &own->row));
  memcpy(own->row, measurements->row, own->count * sizeof *own->row);
  UM_TRY(um_model_create(context, path, options, &whole->model));
  return um_compare_plan_create(context, whole->model, own, &whole->plan);
}

/* Observations without a sigma take the one that the scenario's noise model gives the model's
 * value. */
static enum um_status fill_sigma(struct um_context *context, struct um_compare_whole *whole)
{
  enum um_status status;
  struct um_compare_measurements *m = &whole->measurements;
  double *value = NULL, *sigma = NULL;
  UM_CHECK(um_core_allocate(context, m->count, sizeof *value, &value));
  UM_CHECK(um_core_allocate(context, m->count, sizeof *sigma, &sigma));
  UM_CHECK(um_compare_predict(context, whole->plan, whole->tables, whole->result, value));
  UM_CHECK(um_compare_noise_sigmas(context, whole->model->scenario, m, value, sigma));
  for (size_t i = 0; i < m->count; i++) m->row[i].sigma = sigma[i];
done:
  UM_FREE(context, value, sigma);
  return status;
}

enum um_status um_compare_whole_run(struct um_context *context, struct um_compare_whole *whole)
{
  struct um_compare_share_user shared = {whole->model, whole->plan};
  UM_TRY(um_compare_plan_trace(context, whole->model, whole->plan, &whole->tables));
  UM_TRY(um_compare_refine(context, whole->model, whole->tables, UM_COMPARE_MODEL_SHARE,
                           um_compare_share_of_plan, &shared, &whole->result, NULL));
  UM_TRY(fill_sigma(context, whole));
  const struct um_compare_run run = {whole->model, whole->plan, whole->tables, whole->result};
  return um_compare_create(context, &run, 0.0, &whole->comparison);
}

void um_compare_whole_release(struct um_context *context, struct um_compare_whole *whole)
{
  um_compare_destroy(context, &whole->comparison);
  um_model_result_destroy(context, &whole->result);
  um_model_tables_destroy(context, &whole->tables);
  um_compare_plan_destroy(context, &whole->plan);
  um_model_destroy(context, &whole->model);
  um_core_free(context, whole->measurements.row);
  whole->measurements.row = NULL;
}
