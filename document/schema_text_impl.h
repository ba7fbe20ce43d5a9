/* Private to document/: the words of a schema. */
#ifndef UMBRA_DOCUMENT_SCHEMA_TEXT_IMPL_H
#define UMBRA_DOCUMENT_SCHEMA_TEXT_IMPL_H

#include "document/schema.h"

/* What a field accepts, in words: "a number, more than 0, at most 1". Does not fail. */
void um_document_schema_accepted(const struct um_schema_field *field, char *buffer, size_t size);

#endif
