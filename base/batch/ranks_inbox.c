/* Messages of other ranks, received by MPI without waiting, one at a time of each sender. */
#include "base/batch/ranks_inbox_impl.h"

#include <mpi.h>

struct sender {
  char *buffer;     /* [longest] of the message that is received from it */
  bool receiving;   /* not whole yet, by `request` */
  MPI_Status about; /* of it */
  MPI_Request request;
};

struct um_batch_inbox {
  int first, end;
  size_t longest;
  struct sender *sender; /* [end], from `first` on */
};

enum um_status um_batch_inbox_create(struct um_context *context, int first, int end, size_t longest,
                                     struct um_batch_inbox **out)
{
  enum um_status status;
  struct um_batch_inbox *inbox;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *inbox, &inbox));
  *inbox = (struct um_batch_inbox){.first = first, .end = end, .longest = longest};
  UM_CHECK(um_core_allocate(context, (size_t)end, sizeof *inbox->sender, &inbox->sender));
  for (int r = first; r < end; r++)
    UM_CHECK(um_core_allocate(context, longest, 1, &inbox->sender[r].buffer));
  *out = inbox;
  inbox = NULL;
done:
  um_batch_inbox_destroy(context, &inbox);
  return status;
}

bool um_batch_inbox_take(struct um_batch_inbox *inbox, struct um_batch_message *out)
{
  for (int r = inbox->first; r < inbox->end; r++) {
    struct sender *s = &inbox->sender[r];
    MPI_Message message;
    int there = 0, whole = 0, bytes;
    if (!s->receiving) {
      MPI_Improbe(r, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &message, &s->about);
      if (!there) continue;
      MPI_Imrecv(s->buffer, (int)inbox->longest - 1, MPI_BYTE, &message, &s->request);
      s->receiving = true;
    }
    MPI_Test(&s->request, &whole, MPI_STATUS_IGNORE);
    if (!whole) continue;
    s->receiving = false;
    MPI_Get_count(&s->about, MPI_BYTE, &bytes);
    s->buffer[bytes] = '\0';
    *out = (struct um_batch_message){r, s->about.MPI_TAG, (size_t)bytes, s->buffer};
    return true;
  }
  return false;
}

void um_batch_inbox_destroy(struct um_context *context, struct um_batch_inbox **inbox)
{
  if (inbox == NULL || *inbox == NULL) return;
  struct um_batch_inbox *i = *inbox;
  for (int r = i->first; i->sender != NULL && r < i->end; r++)
    /* MPI may still write into the buffer of what has not arrived whole */
    if (!i->sender[r].receiving) um_core_free(context, i->sender[r].buffer);
  um_core_free(context, i->sender);
  um_core_free(context, i);
  *inbox = NULL;
}
