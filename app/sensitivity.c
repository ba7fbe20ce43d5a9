/* umbra sensitivity: how light and temperatures move with every parameter. */
#include "app/sensitivity.h"

#include "app/terminal.h"
#include "evidence/measurements/measurements.h"
#include "evidence/sensitivity/own.h"
#include "model/build/build.h"

/* The measurements of --data, or the scenario's own instants. */
static enum um_status find_set(struct um_context *context, const struct um_app_options *options,
                               struct um_app_sensitivity_work *work)
{
  struct um_model *model = NULL;
  if (options->data != NULL)
    return um_compare_measurements_read(context, options->data, &work->set);
  UM_TRY(um_model_create(context, options->positional[0], &work->changes, &model));
  enum um_status status = um_sensitivity_own_create(context, model, &work->set);
  um_model_destroy(context, &model);
  return status;
}

static enum um_status read_what_ifs(struct um_context *context,
                                    const struct um_app_options *options,
                                    struct um_app_sensitivity_work *work)
{
  work->nwhat_if = options->nwhat_if;
  UM_TRY(um_core_allocate(context, work->nwhat_if, sizeof *work->request, &work->request));
  UM_TRY(um_core_allocate(context, work->nwhat_if, sizeof *work->what_if, &work->what_if));
  for (size_t i = 0; i < work->nwhat_if; i++) {
    const struct um_diagnosis_request_texts texts = {
        .wanted = &options->what_if[i], .nwanted = 1, .option = "--what-if"};
    UM_TRY(um_diagnosis_request_make(context, work->forward->model, &texts, &work->request[i]));
  }
  return UM_OK;
}

enum um_status um_app_sensitivity_begin(struct um_context *context,
                                        const struct um_app_options *options,
                                        struct um_app_sensitivity_work *work)
{
  um_app_terminal_progress_in_pipes(); /* it may take minutes, and its tables come at the end */
  work->changes = um_app_model_options(options);
  UM_TRY(find_set(context, options, work));
  UM_TRY(um_sensitivity_forward_create(context, options->positional[0], &work->changes, work->set,
                                       UM_SENSITIVITY_MATRIX_TOLERANCE, &work->forward));
  return read_what_ifs(context, options, work);
}

static enum um_status begin_folder(struct um_context *context, const struct um_app_options *options,
                                   struct um_app_sensitivity_work *work)
{
  UM_TRY(um_app_out_folder(context, options, work->forward->model->scenario->name, &work->out));
  return um_core_folder_begin(context, work->out, options->force, &work->folder);
}

enum um_status um_app_sensitivity_compute(struct um_context *context,
                                          const struct um_app_options *options,
                                          struct um_app_sensitivity_work *work)
{
  const struct um_sensitivity_candidates_options which = {.only = options->only,
                                                          .nonly = options->nonly,
                                                          .exclude = options->exclude,
                                                          .nexclude = options->nexclude};
  UM_TRY(um_sensitivity_matrix_create(context, work->forward, options->data == NULL, &which,
                                      &work->matrix));
  for (size_t i = 0; i < work->nwhat_if; i++) {
    enum um_status status = um_sensitivity_what_if_create(
        context, work->matrix, &work->request[i].wanted[0], &work->what_if[i]);
    if (status != UM_OK) um_core_message_prefix(context, "--what-if %s", options->what_if[i]);
    UM_TRY(status);
  }
  return UM_OK;
}

static enum um_status finish(struct um_context *context, const struct um_app_options *options,
                             struct um_app_sensitivity_work *work)
{
  const struct um_sensitivity_report report = {.matrix = work->matrix,
                                               .elasticity = options->elasticity,
                                               .what_if = work->what_if,
                                               .nwhat_if = work->nwhat_if,
                                               .command = options->command,
                                               .version = UM_APP_VERSION};
  UM_TRY(um_sensitivity_report_write(context, &report, !options->no_plots, work->folder));
  UM_TRY(um_core_folder_commit(context, &work->folder));
  um_app_terminal_clear();
  if (options->json)
    um_sensitivity_report_write_json(&report, stdout);
  else
    um_app_sensitivity_print(&report, work->out);
  return UM_OK;
}

void um_app_sensitivity_release(struct um_context *context, struct um_app_sensitivity_work *work)
{
  um_core_folder_abort(&work->folder);
  for (size_t i = 0; i < work->nwhat_if; i++) {
    if (work->what_if != NULL) um_sensitivity_what_if_release(context, &work->what_if[i]);
    if (work->request != NULL) um_diagnosis_request_release(context, &work->request[i]);
  }
  um_sensitivity_matrix_destroy(context, &work->matrix);
  um_sensitivity_forward_destroy(context, &work->forward);
  um_compare_measurements_destroy(context, &work->set);
  UM_FREE(context, work->what_if, work->request, work->out);
}

int um_app_sensitivity(struct um_context *context, const struct um_app_options *options)
{
  struct um_app_sensitivity_work work = {.out = NULL};
  enum um_status status = um_app_sensitivity_begin(context, options, &work);
  if (status == UM_OK) status = begin_folder(context, options, &work);
  if (status == UM_OK) status = um_app_sensitivity_compute(context, options, &work);
  if (status == UM_OK) status = finish(context, options, &work);
  um_app_sensitivity_release(context, &work);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
