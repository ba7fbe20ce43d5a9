/* Navigation messages of CCSDS in XML (NDM/XML, 505.0-B) as lines of their other form,
 * KEYWORD = value, so that one reader serves both. */
#ifndef UMBRA_ORBIT_NDM_H
#define UMBRA_ORBIT_NDM_H

#include <stdbool.h>
#include <stddef.h>

#include "base/core/context.h"

/* A value of a row; unit: what an attribute `units` of it has to say, NULL: it is not looked at. */
struct um_orbit_ndm_field {
  const char *keyword, *unit;
};

#define UM_ORBIT_NDM_FIELDS 6 /* of a row, at most */

/* What is taken of a file: every element `message` of it. */
struct um_orbit_ndm_form {
  const char *message; /* "oem" */
  /* Element of a row, "stateVector": EPOCH and fields in whatever order are the line
   * "EPOCH field field ...". NULL: the message has no rows, and all its values are pairs. */
  const char *row;
  struct um_orbit_ndm_field fields[UM_ORBIT_NDM_FIELDS]; /* up to a keyword NULL. None: whatever
                              stands in a row behind EPOCH is a line "KEYWORD = EPOCH value" */
  const char *end_of_meta; /* a line of one's own before META_STOP; NULL: none */
};

/* Takes a line, which may be written into; `line`: where in the file it stands. */
typedef enum um_status um_orbit_ndm_take(void *self, int line, char *text);

/* Is a text XML whose outermost element is `message` or `ndm`? It ends in '\0'. */
bool um_orbit_ndm_is(const char *text, const char *message);
/* The lines of a file's messages: "CCSDS_OEM_VERS = 2.0" for an element, META_START, META_STOP,
 * DATA_START and DATA_STOP for `metadata` and `data`, "KEYWORD = value" for what stands in the
 * former, and rows. Comments are left out. In constant memory, but for what expat holds of one
 * element. UM_ERR_INPUT, with file and line: no XML, a document type (so that no entity can be
 * declared), more than 256 MiB (some 700,000 rows), 32 elements in one another or 127 bytes of a
 * value, rows that are not whole, no such message; failures of `take` as they are. */
enum um_status um_orbit_ndm_read(struct um_context *context, const char *name, const char *bytes,
                                 size_t length, const struct um_orbit_ndm_form *form,
                                 um_orbit_ndm_take *take, void *self);

#endif
