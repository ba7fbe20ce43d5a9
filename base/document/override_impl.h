/* Private to base/document/: what --set and a change do. */
#ifndef UMBRA_DOCUMENT_OVERRIDE_IMPL_H
#define UMBRA_DOCUMENT_OVERRIDE_IMPL_H

#include "base/document/document_impl.h"

/* Apply one "key.path=yaml value" to the tree. */
enum um_status um_document_set(struct um_document *document, const char *override);
/* Apply one change to the tree: a number arrives with all its bits. */
enum um_status um_document_set_change(struct um_document *document,
                                      const struct um_document_change *change);

#endif
