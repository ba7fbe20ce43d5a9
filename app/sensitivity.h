/* What umbra sensitivity works with, and prints. */
#ifndef UMBRA_APP_SENSITIVITY_H
#define UMBRA_APP_SENSITIVITY_H

#include "app/app.h"
#include "evidence/diagnosis/request.h"
#include "evidence/sensitivity/report/write.h"

/* What the command has at hand; all zero before it begins. */
struct um_app_sensitivity_work {
  struct um_model_options changes; /* of the scenario; the forward borrows it */
  struct um_compare_measurements *set;
  struct um_sensitivity_forward *forward;
  struct um_diagnosis_request *request; /* [nwhat_if] of each --what-if */
  struct um_sensitivity_matrix *matrix;
  struct um_sensitivity_what_if *what_if; /* [nwhat_if] */
  size_t nwhat_if;
  struct um_core_folder *folder;
  char *out;
};
/* Read the scenario and what is differentiated, then the what-ifs; the matrix. Release after an
 * error, too. */
enum um_status um_app_sensitivity_begin(struct um_context *context,
                                        const struct um_app_options *options,
                                        struct um_app_sensitivity_work *work);
enum um_status um_app_sensitivity_compute(struct um_context *context,
                                          const struct um_app_options *options,
                                          struct um_app_sensitivity_work *work);
void um_app_sensitivity_release(struct um_context *context, struct um_app_sensitivity_work *work);

/* The tables for a person (sensitivity_print.c). */
void um_app_sensitivity_print(const struct um_sensitivity_report *report, const char *folder);

#endif
