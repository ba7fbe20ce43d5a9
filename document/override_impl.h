/* Private to document/: what --set does. */
#ifndef UMBRA_DOCUMENT_OVERRIDE_IMPL_H
#define UMBRA_DOCUMENT_OVERRIDE_IMPL_H

#include "document/document_impl.h"

/* Apply one "key.path=yaml value" to the tree. */
enum um_status um_document_set(struct um_document *document, const char *override);

#endif
