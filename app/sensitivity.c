/* umbra sensitivity: how light and temperatures move with every parameter. */
#include "app/sensitivity.h"

#include "app/terminal.h"
#include "evidence/measurements/measurements.h"
#include "evidence/sensitivity/own.h"
#include "model/build/build.h"

struct work {
  struct um_model_options changes; /* of the scenario; the forward borrows it */
  struct um_compare_measurements *set;
  struct um_sensitivity_forward *forward;
  struct um_sensitivity_matrix *matrix;
  struct um_core_folder *folder;
  char *out;
};

/* The measurements of --data, or the scenario's own instants. */
static enum um_status find_set(struct um_context *context, const struct um_app_options *options,
                               struct work *work)
{
  struct um_model *model = NULL;
  if (options->data != NULL)
    return um_compare_measurements_read(context, options->data, &work->set);
  UM_TRY(um_model_create(context, options->positional[0], &work->changes, &model));
  enum um_status status = um_sensitivity_own_create(context, model, &work->set);
  um_model_destroy(context, &model);
  return status;
}

static enum um_status sensitivity(struct um_context *context, const struct um_app_options *options,
                                  struct work *work)
{
  const struct um_sensitivity_candidates_options which = {.only = options->only,
                                                          .nonly = options->nonly,
                                                          .exclude = options->exclude,
                                                          .nexclude = options->nexclude};
  work->changes = um_app_model_options(options);
  UM_TRY(find_set(context, options, work));
  UM_TRY(um_sensitivity_forward_create(context, options->positional[0], &work->changes, work->set,
                                       1.0, &work->forward));
  UM_TRY(um_app_out_folder(context, options, work->forward->model->scenario->name, &work->out));
  UM_TRY(um_core_folder_begin(context, work->out, options->force, &work->folder));
  UM_TRY(um_sensitivity_matrix_create(context, work->forward, options->data == NULL, &which,
                                      &work->matrix));
  UM_TRY(um_core_folder_commit(context, &work->folder));
  um_app_terminal_clear();
  um_app_sensitivity_print(work->matrix, work->out);
  return UM_OK;
}

int um_app_sensitivity(struct um_context *context, const struct um_app_options *options)
{
  struct work work = {.out = NULL};
  enum um_status status = sensitivity(context, options, &work);
  um_core_folder_abort(&work.folder);
  um_sensitivity_matrix_destroy(context, &work.matrix);
  um_sensitivity_forward_destroy(context, &work.forward);
  um_compare_measurements_destroy(context, &work.set);
  um_core_free(context, work.out);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
