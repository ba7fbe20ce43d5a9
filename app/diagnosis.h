/* What umbra diagnose and umbra fit share. */
#ifndef UMBRA_APP_DIAGNOSIS_H
#define UMBRA_APP_DIAGNOSIS_H

#include "app/app.h"
#include "base/batch/batch.h"
#include "base/core/file.h"
#include "evidence/diagnosis/diagnosis.h"
#include "evidence/diagnosis/request.h"

struct um_app_diagnosis {
  struct um_model_options changes; /* of the scenario; the forward borrows it */
  struct um_compare_measurements *measurements;
  struct um_sensitivity_forward *forward;
  struct um_diagnosis_request request;
  struct um_sensitivity_candidates *candidates;
  struct um_diagnosis *diagnosis;
  struct um_core_folder *folder;
  char *out;              /* the folder's place */
  bool holds_files;       /* they stay as they were when they were read first */
  char *records;          /* folder of what is computed, until results are written */
  struct um_batch *batch; /* of that */
  bool written;
};

/* Measurements, forward, request and folder; all zero before. */
enum um_status um_app_diagnosis_begin(struct um_context *context,
                                      const struct um_app_options *options,
                                      struct um_app_diagnosis *work);
/* Write, draw, put in place, print. */
enum um_status um_app_diagnosis_finish(struct um_context *context,
                                       const struct um_app_options *options,
                                       struct um_app_diagnosis *work);
/* What was computed stays on record where results were not written, and the message says so. */
void um_app_diagnosis_release(struct um_context *context, struct um_app_diagnosis *work);

/* Whether --draft-effect names a C file that may be written. UM_ERR_INPUT: it does not end in .c,
 * it is there and --force is not given, it is no file. */
enum um_status um_app_draft_check(struct um_context *context, const struct um_app_options *options);
/* The draft of a finished diagnosis, and a line about it to stderr. */
enum um_status um_app_draft_write(struct um_context *context, const struct um_diagnosis *diagnosis,
                                  const struct um_app_options *options);

#endif
