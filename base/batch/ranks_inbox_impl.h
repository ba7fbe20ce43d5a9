/* Private to base/batch/: messages that arrive from other ranks, each handed on once it is whole.
 */
#ifndef UMBRA_BATCH_RANKS_INBOX_IMPL_H
#define UMBRA_BATCH_RANKS_INBOX_IMPL_H

#include <stdbool.h>
#include <stddef.h>

#include "base/core/context.h"

struct um_batch_inbox;

struct um_batch_message {
  int from, tag;
  size_t bytes;
  const char *data; /* [bytes], with a NUL behind; borrowed until the next one of its sender */
};

/* Messages of the ranks first to end - 1, each shorter than `longest` [byte]. UM_ERR_MEMORY. */
enum um_status um_batch_inbox_create(struct um_context *context, int first, int end, size_t longest,
                                     struct um_batch_inbox **out);
/* The next message that has arrived whole; false: none. A long one comes in pieces, and its sender
 * may be stopped in the midst of it: others are heard meanwhile. */
bool um_batch_inbox_take(struct um_batch_inbox *inbox, struct um_batch_message *out);
/* Accepts NULL, sets NULL. */
void um_batch_inbox_destroy(struct um_context *context, struct um_batch_inbox **inbox);

#endif
