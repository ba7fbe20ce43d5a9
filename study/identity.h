/* What points on record were computed from: the program's own bytes, those of every file that the
 * model is made of, and what was asked. Points of anything else are not added to them. Beside the
 * records lies a list of it, "made-of.txt", by which a refusal says what has changed. */
#ifndef UMBRA_STUDY_IDENTITY_H
#define UMBRA_STUDY_IDENTITY_H

#include <stdint.h>

#include "base/batch/batch.h"
#include "model/build/model.h"

struct um_study_identity;

/* The program and its version, the files that were read since um_core_snapshot_begin and those that
 * the model will read later, the changes of the options. Names of files do not count, so that
 * another machine may have them elsewhere. UM_ERR_IO: a file cannot be read. The caller destroys.
 */
enum um_status um_study_identity_create(struct um_context *context, const char *version,
                                        const struct um_model *model,
                                        const struct um_model_options *options,
                                        struct um_study_identity **out);
/* Something that is asked besides; name: in the plural ("the stations"), borrowed for the call. */
enum um_status um_study_identity_add(struct um_context *context, struct um_study_identity *identity,
                                     const char *name, uint64_t digest);
/* Before hours of work: may points be added to those in the folder, as far as the identity is known
 * yet? UM_ERR_IO says which file or what else is not as it was. */
enum um_status um_study_identity_check(struct um_context *context,
                                       const struct um_study_identity *identity,
                                       const char *folder);
/* As um_batch_open, with this identity for that of the task; errors of um_study_identity_check
 * where the task resumes or is a share. */
enum um_status um_study_identity_open(struct um_context *context,
                                      const struct um_study_identity *identity,
                                      const struct um_batch_task *task, struct um_batch **out);
/* Remove records and the list beside them. For callers whose results are written. Does not fail. */
void um_study_records_remove(struct um_context *context, const char *folder);
/* Accepts NULL, sets NULL. */
void um_study_identity_destroy(struct um_context *context, struct um_study_identity **identity);

#endif
