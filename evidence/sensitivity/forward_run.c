/* Everything of one variant of a forward, kept; what evaluations took. */
#include "evidence/sensitivity/forward.h"
#include "model/run/run.h"

/* Observations want many paths, of which evaluations with the scenario's geometry have few. */
static enum um_status run_with_all_paths(struct um_context *context,
                                         const struct um_sensitivity_forward *forward, bool window,
                                         struct um_sensitivity_forward_run *out)
{
  const struct um_variant *v = &out->variant;
  bool more = !window && v->tables->sampling.paths != forward->paths;
  if (more) UM_TRY(um_variant_paths(context, forward->evaluator, forward->paths, forward->paths));
  UM_TRY(um_model_run_with(context, v->model, v->tables, v->heat, &out->result));
  if (!more) return UM_OK;
  return um_variant_paths(context, forward->evaluator, forward->paths_before,
                          forward->instants.sampling.paths);
}

enum um_status um_sensitivity_forward_run(struct um_context *context,
                                          const struct um_sensitivity_forward *forward,
                                          const struct um_model_addition *addition,
                                          size_t naddition, const struct um_model_instants *over,
                                          struct um_sensitivity_forward_run *out)
{
  enum um_status status;
  const struct um_model_changes changes = {.addition = addition, .naddition = naddition};
  const struct um_variant_heat heat = um_sensitivity_forward_heat(forward);
  bool other = over != NULL && !forward->model->points; /* points have no window of their own */
  struct um_model_instants instants = {.count = 0};
  struct um_variant *v = &out->variant;
  *out = (struct um_sensitivity_forward_run){.result = NULL};
  um_core_quiet_begin(context);
  if (other) {
    instants = *over;
    instants.sampling.samples = forward->instants.sampling.samples;
    instants.sampling.paths = forward->paths_before;
    UM_CHECK(um_variant_open_over(context, forward->evaluator, &instants, &changes, &heat, v));
  } else {
    UM_CHECK(um_variant_open(context, forward->evaluator, &changes, &heat, v));
  }
  UM_CHECK(run_with_all_paths(context, forward, other, out));
done:
  um_core_quiet_end(context);
  if (status != UM_OK) um_sensitivity_forward_run_release(context, out);
  return status == UM_ERR_INPUT && naddition > 0 ? UM_ERR_REFUSED : status;
}

void um_sensitivity_forward_run_release(struct um_context *context,
                                        struct um_sensitivity_forward_run *run)
{
  um_model_result_destroy(context, &run->result);
  um_variant_close(context, &run->variant);
}
