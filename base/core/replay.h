/* What a command was and which files it read, written beside its results as replay.json, so that it
 * can be run again. A context without a record, as the library's, notes and writes nothing. */
#ifndef UMBRA_CORE_REPLAY_H
#define UMBRA_CORE_REPLAY_H

#include <stdint.h>
#include <stdio.h>

#include "base/core/context.h"

#define UM_CORE_REPLAY_FILE   "replay.json"
#define UM_CORE_REPLAY_FORMAT 1  /* of the file: its key umbra_replay */
#define UM_CORE_REPLAY_DIGEST 17 /* room for a digest as text [bytes] */

/* A command begins, run in the working folder of now; what was noted of one before is forgotten.
 * version: of the program. command: as typed. argument: [nargument] the verb and what stood behind
 * it. Texts are borrowed until the end. UM_ERR_MEMORY. */
enum um_status um_core_replay_begin(struct um_context *context, const char *version,
                                    const char *command, char *const *argument, size_t nargument);
/* Forget it. Does not fail. */
void um_core_replay_end(struct um_context *context);
/* The command on record, as typed; NULL: none is. Borrowed. */
const char *um_core_replay_command(struct um_context *context);
/* A plain file was opened for reading, at its begin: it is an input, as it is now, on record the
 * first time. The place in the file stays. For the thread of the context alone. UM_ERR_MEMORY,
 * UM_ERR_IO, UM_ERR_CANCELLED. */
enum um_status um_core_replay_note(struct um_context *context, const char *path, int descriptor);
/* It was no input of the user's. Does not fail. */
void um_core_replay_forget(struct um_context *context, const char *path);
/* Files below this folder come with the program of that version, and are no inputs from here on.
 * UM_ERR_MEMORY. */
enum um_status um_core_replay_leave_out(struct um_context *context, const char *folder);
/* The record as JSON (docs/files.md); errors of writing are left in the stream. */
void um_core_replay_write(struct um_context *context, FILE *file);
/* A digest (base/core/digest.h) as it stands in the file. */
void um_core_replay_digest_text(uint64_t digest, char out[UM_CORE_REPLAY_DIGEST]);
/* Digest of the bytes of an open file; the place in it stays. UM_ERR_IO, UM_ERR_CANCELLED. */
enum um_status um_core_descriptor_digest(struct um_context *context, const char *path,
                                         int descriptor, uint64_t *out);

#endif
