/* What umbra diagnose and umbra fit share: reading, writing. */
#include "app/diagnosis.h"

#include "app/batch.h"
#include "app/measured.h"
#include "app/terminal.h"
#include "base/batch/each.h"
#include "base/core/digest.h"
#include "base/core/file_snapshot.h"
#include "evidence/diagnosis/report/brief.h"
#include "evidence/diagnosis/report/text.h"
#include "evidence/diagnosis/report/write.h"
#include "evidence/diagnosis/report/write_json.h"
#include "model/build/build.h"
#include "study/identity.h"

/* What decides answers, beside files, program and changes of the scenario. */
static uint64_t digest_of(const struct um_app_options *o)
{
  const double numbers[] = {o->level,         (double)o->steps,        o->posterior ? 1.0 : 0.0,
                            (double)o->draws, o->draft_effect != NULL, (double)o->passes};
  uint64_t digest = um_core_digest_texts(UM_CORE_DIGEST_BEGIN, o->only, o->nonly);
  digest = um_core_digest_texts(digest, o->exclude, o->nexclude);
  digest = um_core_digest_texts(digest, o->nuisance, o->nnuisance);
  digest = um_core_digest_texts(digest, o->add, o->nadd); /* which umbra fit always has */
  digest = um_core_digest_texts(digest, &o->seed, o->seed != NULL);
  return um_core_digest(digest, numbers, sizeof numbers);
}

/* Before minutes of work: the folders of results and records, and whether records there are of the
 * same question. The model is made for that alone. */
static enum um_status open_folders(struct um_context *context, const struct um_app_options *options,
                                   struct um_app_diagnosis *work)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_study_identity *identity = NULL;
  struct um_batch_task task = um_batch_each_task();
  um_core_quiet_begin(context); /* what is to say of it is said when it is used */
  status = um_model_create(context, options->positional[0], &work->changes, &model);
  um_core_quiet_end(context);
  if (status != UM_OK) goto done;
  UM_CHECK(um_app_out_folder(context, options, model->scenario->name, &work->out));
  UM_CHECK(um_core_folder_begin(context, work->out, options->force, &work->folder));
  UM_CHECK(um_app_batch_records(context, work->out, &work->records));
  UM_CHECK(um_study_identity_create(context, UM_APP_VERSION, model, &work->changes, &identity));
  UM_CHECK(um_study_identity_add(context, identity, "the options", digest_of(options)));
  task.folder = work->records;
  task.resume = options->resume;
  UM_CHECK(um_study_identity_open(context, identity, &task, &work->batch));
done:
  um_study_identity_destroy(context, &identity);
  um_model_destroy(context, &model);
  return status;
}

enum um_status um_app_diagnosis_begin(struct um_context *context,
                                      const struct um_app_options *options,
                                      struct um_app_diagnosis *work)
{
  struct um_diagnosis_request_texts texts = {
      .nuisance = options->nuisance,
      .nnuisance = options->nnuisance,
      .exclude = options->exclude,
      .nexclude = options->nexclude,
      .wanted = options->add,
      .nwanted = options->nadd,
  };
  UM_TRY(um_app_draft_check(context, options));
  um_app_terminal_progress_in_pipes(); /* it takes minutes, and its tables come at the end */
  work->changes = um_app_model_options(options);
  UM_TRY(um_core_snapshot_begin(context));
  work->holds_files = true;
  UM_TRY(um_app_measured_read(context, options, &work->measurements));
  UM_TRY(open_folders(context, options, work));
  UM_TRY(um_sensitivity_forward_create(context, options->positional[0], &work->changes,
                                       work->measurements, UM_VARIANT_TIGHT, &work->forward));
  work->forward->records = work->batch;
  texts.measurements = work->measurements;
  return um_diagnosis_request_make(context, work->forward->model, &texts, &work->request);
}

enum um_status um_app_diagnosis_finish(struct um_context *context,
                                       const struct um_app_options *options,
                                       struct um_app_diagnosis *work)
{
  const struct um_diagnosis *d = work->diagnosis;
  char *brief;
  UM_TRY(um_diagnosis_report_write(context, d, options->command, UM_APP_VERSION, !options->no_plots,
                                   work->folder));
  if (options->draft_effect != NULL) UM_TRY(um_app_draft_write(context, d, options));
  UM_TRY(um_core_folder_commit(context, &work->folder));
  work->written = true;
  um_app_terminal_clear();
  if (options->json)
    return um_diagnosis_report_write_json(context, d, options->command, UM_APP_VERSION, stdout);
  if (options->details) {
    UM_TRY(um_diagnosis_report_write_text(context, d, stdout));
    um_app_tell_results(work->out);
    return UM_OK;
  }
  UM_TRY(um_diagnosis_report_brief(context, d, options->command, work->out, &brief));
  fputs(brief, stdout);
  um_diagnosis_report_write_text_posterior(d, stdout);
  um_core_free(context, brief);
  return UM_OK;
}

void um_app_diagnosis_release(struct um_context *context, struct um_app_diagnosis *work)
{
  bool keeps = work->batch != NULL && um_batch_recorded(work->batch) > 0 && !work->written;
  bool opened = work->batch != NULL;
  um_batch_close(context, &work->batch);
  if (keeps)
    um_core_message_prefix(context, "%s keeps what was computed, and --resume goes on from there",
                           work->records);
  else if (opened)
    um_study_records_remove(context, work->records);
  um_core_folder_abort(&work->folder);
  um_diagnosis_destroy(context, &work->diagnosis);
  um_sensitivity_candidates_destroy(context, &work->candidates);
  um_diagnosis_request_release(context, &work->request);
  um_sensitivity_forward_destroy(context, &work->forward);
  um_compare_measurements_destroy(context, &work->measurements);
  if (work->holds_files) um_core_snapshot_end(context);
  UM_FREE(context, work->out, work->records);
}
