/* What umbra diagnose and umbra fit share: reading, writing. */
#include "app/diagnosis.h"

#include "app/terminal.h"
#include "evidence/diagnosis/report/plot.h"
#include "evidence/diagnosis/report/write.h"
#include "evidence/diagnosis/report/write_json.h"
#include "evidence/measurements/measurements.h"

enum um_status um_app_diagnosis_begin(struct um_context *context,
                                      const struct um_app_options *options,
                                      struct um_app_diagnosis *work)
{
  const struct um_diagnosis_request_texts texts = {
      .nuisance = options->nuisance,
      .nnuisance = options->nnuisance,
      .exclude = options->exclude,
      .nexclude = options->nexclude,
      .wanted = options->add,
      .nwanted = options->nadd,
  };
  um_app_terminal_progress_in_pipes(); /* it takes minutes, and its tables come at the end */
  work->changes = um_app_model_options(options);
  UM_TRY(um_compare_measurements_read(context, options->positional[1], &work->measurements));
  UM_TRY(um_sensitivity_forward_create(context, options->positional[0], &work->changes,
                                       work->measurements, UM_VARIANT_TIGHT, &work->forward));
  UM_TRY(um_diagnosis_request_make(context, work->forward->model, &texts, &work->request));
  UM_TRY(um_app_out_folder(context, options, work->forward->model->scenario->name, &work->out));
  return um_core_folder_begin(context, work->out, options->force, &work->folder);
}

enum um_status um_app_diagnosis_finish(struct um_context *context,
                                       const struct um_app_options *options,
                                       struct um_app_diagnosis *work)
{
  const struct um_diagnosis *d = work->diagnosis;
  UM_TRY(um_diagnosis_report_write(context, d, options->command, UM_APP_VERSION, work->folder));
  if (!options->no_plots)
    UM_TRY(um_diagnosis_report_plot(context, d, um_core_folder_path(work->folder)));
  UM_TRY(um_core_folder_commit(context, &work->folder));
  um_app_terminal_clear();
  if (options->json)
    return um_diagnosis_report_write_json(context, d, options->command, UM_APP_VERSION, stdout);
  return um_app_diagnosis_print(context, d, work->out);
}

void um_app_diagnosis_release(struct um_context *context, struct um_app_diagnosis *work)
{
  um_core_folder_abort(&work->folder);
  um_diagnosis_destroy(context, &work->diagnosis);
  um_sensitivity_candidates_destroy(context, &work->candidates);
  um_diagnosis_request_release(context, &work->request);
  um_sensitivity_forward_destroy(context, &work->forward);
  um_compare_measurements_destroy(context, &work->measurements);
  um_core_free(context, work->out);
}
