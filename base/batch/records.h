/* Records of batches, as a caller sees them. */
#ifndef UMBRA_BATCH_RECORDS_H
#define UMBRA_BATCH_RECORDS_H

#include "base/core/context.h"

/* Remove the records of any task in `folder`, and the folder where nothing else lies in it. For
 * callers whose results are written. Does not fail. */
void um_batch_records_remove(struct um_context *context, const char *folder);

#endif
