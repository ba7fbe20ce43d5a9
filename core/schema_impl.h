/* Parts of the schema shared by binding and emitting. */
#ifndef UMBRA_CORE_SCHEMA_IMPL_H
#define UMBRA_CORE_SCHEMA_IMPL_H

#include "core/document_impl.h"

/* What a field accepts, in words: "a number, more than 0, at most 1". Does not fail. */
/* The field that a key names, NULL when there is none; the rest field has no name. */
const struct um_schema_field *um_core_schema_find(const struct um_schema_object *object,
                                                  const char *key);
void um_core_schema_accepted(const struct um_schema_field *field, char *buffer, size_t size);

/* UM_ERR_INPUT for an unknown key (the nearest known one is named), for two keys of one group, and
 * for none of a group of which one is required. */
enum um_status um_core_schema_check_keys(struct um_context *context,
                                         const struct um_schema_object *object,
                                         const struct um_node *node);

#endif
