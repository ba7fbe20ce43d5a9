/* Private to base/document/: the keys of a mapping against its schema. */
#ifndef UMBRA_DOCUMENT_SCHEMA_CHECK_IMPL_H
#define UMBRA_DOCUMENT_SCHEMA_CHECK_IMPL_H

#include "base/document/document_impl.h"

/* The field that a key names, NULL when there is none; the rest field has no name. */
const struct um_schema_field *um_document_schema_find(const struct um_schema_object *object,
                                                      const char *key);

/* UM_ERR_INPUT for an unknown key (the nearest known one is named), for two keys of one group, and
 * for none of a group of which one is required. */
enum um_status um_document_schema_check_keys(struct um_context *context,
                                             const struct um_schema_object *object,
                                             const struct um_node *node);

#endif
