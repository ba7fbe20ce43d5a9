/* Words of which schema tables are written: for the sources that hold tables, not for headers. */
#ifndef UMBRA_DOCUMENT_SCHEMA_WORDS_H
#define UMBRA_DOCUMENT_SCHEMA_WORDS_H

#include <math.h>

#include "base/document/schema.h"

#define REQUIRED           .required = true
#define POSITIVE(top)      .minimum = 0.0, .maximum = (top), .open_minimum = true
#define BETWEEN(low, high) .minimum = (low), .maximum = (high)
#define NO_DEFAULT         .default_value = NAN
#define DEFAULT(v)         .default_value = (v)
#define HELP(text)         .help = (text)
#define NAMES_FILE         .file = true
#define NAME               .name = true
#define MOST(n)            .most = (n)
#define FIELDS(array)      .fields = (array), .nfield = UM_FIELD_COUNT(array)
/* A field of struct OF, whose key is the member's name, or another. */
#define F_AS(member, key, type, ...) UM_FIELD(OF, member, key, type, __VA_ARGS__)
#define F(member, ...)               F_AS(member, #member, __VA_ARGS__)
#define OBJECT(identifier, structure, name_, help_, ...)                                           \
  static const struct um_schema_object identifier = {                                              \
      .name = (name_), .help = (help_), .size = sizeof(structure), __VA_ARGS__}
#define SHARED_OBJECT(identifier, structure, name_, help_, ...)                                    \
  const struct um_schema_object identifier = {                                                     \
      .name = (name_), .help = (help_), .size = sizeof(structure), __VA_ARGS__}

#endif
