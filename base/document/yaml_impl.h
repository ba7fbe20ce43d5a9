/* Private to base/document/: text to tree. */
#ifndef UMBRA_DOCUMENT_YAML_IMPL_H
#define UMBRA_DOCUMENT_YAML_IMPL_H

#include "base/document/document_impl.h"

/* yaml.c is the only file that knows libfyaml. Text to tree; memory is the document's. `name` is
 * what messages call it; from_file: marks carry the name and lines, otherwise "--set" and no line.
 * UM_ERR_INPUT: not YAML, empty, more than one document, alias, anchor, tag, duplicate key, key
 * that is no scalar. */
enum um_status um_document_yaml_load(struct um_document *document, const char *name, bool from_file,
                                     const char *text, size_t length, struct um_node **out);

#endif
