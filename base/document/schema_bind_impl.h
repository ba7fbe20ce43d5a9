/* Private to base/document/: from the tree to the structs of a schema. */
#ifndef UMBRA_DOCUMENT_SCHEMA_BIND_IMPL_H
#define UMBRA_DOCUMENT_SCHEMA_BIND_IMPL_H

#include "base/document/document_impl.h"

/* Check the tree against the schema and bind it. */
enum um_status um_document_bind(struct um_document *document, const struct um_schema_object *schema,
                                void **root);

#endif
