/* The record of a command that was run: reading of replay.json. */
#ifndef UMBRA_APP_REPLAY_READ_H
#define UMBRA_APP_REPLAY_READ_H

#include "base/document/schema.h"

struct um_app_replay_input {
  struct um_mark at;
  const char *path;   /* as opened */
  double bytes;       /* size */
  const char *digest; /* as um_core_replay_digest_text writes it */
};

struct um_app_replay_record {
  struct um_mark at;
  int format;
  const char *version, *folder, *written_utc;
  struct um_schema_list arguments; /* of const char *: the verb and what stands behind it */
  struct um_schema_list inputs;    /* of struct um_app_replay_input */
};

/* Somebody's file, held to its schema: keys, types, sizes. *out belongs to *document, which the
 * caller destroys. UM_ERR_IO, UM_ERR_INPUT "file:line: key: problem; accepted: ...", UM_ERR_MEMORY.
 */
enum um_status um_app_replay_read(struct um_context *context, const char *path,
                                  struct um_document **document, struct um_app_replay_record **out);

#endif
