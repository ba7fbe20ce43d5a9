/* What a person asks a diagnosis for, as text of the command line or of the scenario. */
#ifndef UMBRA_DIAGNOSIS_REQUEST_H
#define UMBRA_DIAGNOSIS_REQUEST_H

#include "evidence/diagnosis/options.h"

/* Owned: the targets and texts that its members point to. */
struct um_diagnosis_request {
  struct um_diagnosis_nuisance_effect *nuisance; /* [nnuisance] of the scenario, then of texts */
  size_t nnuisance;
  const char **exclude; /* [nexclude] of the scenario, then of texts */
  size_t nexclude;
  struct um_model_addition *wanted; /* [nwanted] */
  size_t nwanted;
  char **text; /* private */
  size_t ntext;
};

/* nuisance: [nnuisance] "effect[:target][@set][,sigma=S][,per=set|all]"; without sigma the prior
 * width of the effect's parameters, sigma=free for none; of several sets a value in each where the
 * effect may be of a set, unless it says per=all. A later one of the same effect and target takes
 * the place of an earlier. wanted: [nwanted] "effect[:target][,name=start]...", other parameters
 * NAN. exclude: [nexclude] "effect[:target]", copied behind the scenario's. UM_ERR_INPUT naming
 * file and line, or option and text: no such effect, a target that the effect cannot have or the
 * model has not, a set that the measurements have not, a clock or exposure of one set where sets
 * overlap in time, no such parameter, a number that is none or out of range. The caller releases,
 * also after a failure. */
struct um_diagnosis_request_texts {
  const char *const *nuisance, *const *exclude, *const *wanted;
  size_t nnuisance, nexclude, nwanted;
  const struct um_compare_measurements
      *measurements;  /* whose sets targets may name; NULL: of one set */
  const char *option; /* that `wanted` came by, for messages; NULL: --add */
};
enum um_status um_diagnosis_request_make(struct um_context *context, const struct um_model *model,
                                         const struct um_diagnosis_request_texts *texts,
                                         struct um_diagnosis_request *out);
void um_diagnosis_request_release(struct um_context *context, struct um_diagnosis_request *request);

#endif
