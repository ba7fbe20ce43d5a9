/* A comparison with measurements as a result. */
#include "evidence/comparison/report.h"
#include "evidence/inversion/whole.h"
#include "library/measurements_impl.h"
#include "library/result_impl.h"
#include "library/scenario_impl.h"

struct comparison {
  struct um_library_source source;
  struct um_model_options options;
  struct umbra_measurements *measurements; /* shared */
  struct um_compare_whole whole;
  struct umbra_comparison said;
  struct umbra_channel *channel; /* [nchannel of the comparison] */
  double *column;                /* [3][observations] residual, sigma, sigma of the model */
};

static void comparison_release(struct um_context *context, void *work)
{
  struct comparison *c = work;
  um_compare_whole_release(context, &c->whole);
  um_library_measurements_drop(&c->measurements);
  um_library_source_release(context, &c->source);
  UM_FREE(context, c->channel, c->column, c);
}

static enum um_status comparison_write(struct um_context *context,
                                       const struct umbra_result *result,
                                       const struct umbra_write *write,
                                       struct um_core_folder *folder)
{
  const struct comparison *c = result->work;
  return um_compare_write(context, c->whole.comparison, write->command, UM_LIBRARY_VERSION,
                          write->pictures != 0, folder);
}

static const struct um_model *comparison_model(const void *work)
{
  return ((const struct comparison *)work)->whole.model;
}

static const struct um_library_kind kind = {comparison_write, comparison_release, comparison_model};

static struct umbra_channel channel_of(const struct um_compare_comparison *c, size_t i)
{
  const struct um_compare_channel_comparison *from = &c->channel[i];
  const struct um_compare_channel *of = &c->run.plan->measurements->channel[from->channel];
  const struct um_compare_metrics *m = &from->all;
  return (struct umbra_channel){.quantity = um_compare_quantity_name(of->quantity),
                                .of = of->label,
                                .unit = um_compare_residual_unit(of->quantity),
                                .count = from->count,
                                .left_out = from->left_out,
                                .bias = m->bias,
                                .rms = m->rms,
                                .bias_mag = m->bias_mag,
                                .rms_mag = m->rms_mag,
                                .scale = m->scale,
                                .chi2 = m->chi2,
                                .dof = m->dof,
                                .chi2_reduced = m->chi2_reduced,
                                .durbin_watson = m->durbin_watson,
                                .white_p = m->white_p,
                                .model_share = m->model_share};
}

static enum um_status say(struct um_context *context, struct comparison *work,
                          struct umbra_result *result)
{
  const struct um_compare_comparison *c = work->whole.comparison;
  size_t n = work->whole.measurements.count;
  UM_TRY(um_core_allocate(context, 3 * n, sizeof *work->column, &work->column));
  for (size_t i = 0; i < n; i++) {
    const struct um_compare_residual *r = &c->residual[i];
    work->column[i] = r->measured - r->model;
    work->column[n + i] = r->sigma;
    work->column[2 * n + i] = r->model_sigma;
  }
  const struct {
    const char *name, *unit;
    const double *data;
  } arrays[] = {{"model", "of the quantity", c->model},
                {"residual", "of residuals", work->column},
                {"sigma", "of residuals", work->column + n},
                {"model_sigma", "of residuals", work->column + 2 * n}};
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
    const struct umbra_array a = {.name = arrays[i].name,
                                  .unit = arrays[i].unit,
                                  .shape = {n},
                                  .axis = {"observation"},
                                  .data = arrays[i].data};
    UM_TRY(um_library_result_show(context, result, &a));
  }
  UM_TRY(um_core_allocate(context, c->nchannel, sizeof *work->channel, &work->channel));
  for (size_t i = 0; i < c->nchannel; i++) work->channel[i] = channel_of(c, i);
  work->said =
      (struct umbra_comparison){c->chi2, c->dof, c->chi2_reduced, work->channel, c->nchannel};
  return UM_OK;
}

enum umbra_status umbra_compare(struct umbra *umbra, const struct umbra_scenario *scenario,
                                struct umbra_measurements *measurements, struct umbra_result **out)
{
  struct um_context *context = um_library_begin(umbra);
  struct umbra_result *result = NULL;
  struct comparison *work = NULL;
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *work, &work));
  work->measurements = um_library_measurements_share(measurements);
  UM_CHECK(um_library_source_copy(context, &scenario->source, &work->source));
  work->options = um_library_source_options(&work->source, umbra);
  UM_CHECK(um_compare_whole_begin(context, work->source.path, &work->options, measurements->set,
                                  &work->whole));
  UM_CHECK(um_compare_whole_run(context, &work->whole));
  UM_CHECK(um_library_result_create(context, umbra, &kind, work, &result));
  work = NULL;
  UM_CHECK(say(context, result->work, result));
  *out = result;
done:
  if (work != NULL) comparison_release(context, work);
  if (status != UM_OK) umbra_result_close(&result);
  return um_library_status(status);
}

const struct umbra_comparison *umbra_result_comparison(const struct umbra_result *result)
{
  return result->kind == &kind ? &((const struct comparison *)result->work)->said : NULL;
}
