/* A diagnosis or fit as a result. Private to library/. */
#ifndef UMBRA_LIBRARY_DIAGNOSIS_IMPL_H
#define UMBRA_LIBRARY_DIAGNOSIS_IMPL_H

#include "base/core/arena.h"
#include "evidence/diagnosis/diagnosis.h"
#include "evidence/diagnosis/request.h"
#include "library/measurements_impl.h"
#include "library/result_impl.h"
#include "library/source_impl.h"

struct um_library_diagnosis {
  struct um_library_source source, wanted; /* wanted: its changes are what a fit is asked for */
  struct um_model_options options;
  struct umbra_measurements *measurements; /* shared */
  struct um_sensitivity_forward *forward;
  struct um_diagnosis_request request;
  struct um_sensitivity_candidates *candidates;
  struct um_diagnosis *diagnosis;
  struct um_core_arena memory; /* of the verdict */
  struct umbra_verdict verdict;
};

/* Say the diagnosis in the words of the public header. UM_ERR_MEMORY. */
enum um_status um_library_verdict(struct um_context *context, struct um_library_diagnosis *work);

#endif
