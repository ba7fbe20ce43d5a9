/* Exchange files of ISO 10303-21 ("STEP files"): instances and their attributes. Private to
 * geometry/. */
#ifndef UMBRA_GEOMETRY_PART21_IMPL_H
#define UMBRA_GEOMETRY_PART21_IMPL_H

#include <stdint.h>

#include "base/core/context.h"

/* What the file is held to; beyond it, UM_ERR_INPUT. */
#define UM_PART21_DEEPEST   32                /* lists within lists */
#define UM_PART21_VALUES    ((size_t)1 << 24) /* that are kept */
#define UM_PART21_INSTANCES ((size_t)1 << 22) /* that are kept */

enum um_geometry_part21_kind {
  UM_PART21_UNSET,     /* $ */
  UM_PART21_DERIVED,   /* * */
  UM_PART21_NUMBER,    /* .number */
  UM_PART21_STRING,    /* .text between the quotes, as it stands */
  UM_PART21_BINARY,    /* the same */
  UM_PART21_ENUM,      /* .text between the points */
  UM_PART21_REFERENCE, /* .id */
  UM_PART21_LIST,      /* what is in it follows */
  UM_PART21_TYPED,     /* NAME(...): .text is the name, what is in it follows */
};

/* A piece of the file's text, without an end of its own. */
struct um_geometry_part21_text {
  const char *at;
  size_t length;
};

/* Values stand in the order of the file: what is in a list follows it. */
struct um_geometry_part21_value {
  enum um_geometry_part21_kind kind;
  uint32_t end; /* number of the value behind this one and all that is in it */
  union {
    double number;
    uint64_t id;
    struct um_geometry_part21_text text;
  };
};

/* #id=NAME(...); */
struct um_geometry_part21_instance {
  uint64_t id;
  struct um_geometry_part21_text name;
  uint32_t list; /* number of the value that is the list of its attributes */
  int line;
};

struct um_geometry_part21 {
  struct um_geometry_part21_value *value; /* [nvalue] */
  size_t nvalue, value_capacity;
  struct um_geometry_part21_instance *instance; /* [ninstance], ids ascend */
  size_t ninstance, instance_capacity;
};

/* Is an instance of this name kept? What is not is read, checked and forgotten. */
typedef bool (*um_geometry_part21_wanted)(struct um_geometry_part21_text name);

/* Read the bytes of a file; they are borrowed as long as *out is used. Header and sections of data,
 * edition 1 and 2; scopes and complex instances (#1=(A()B());) are refused. UM_ERR_INPUT with file,
 * line and what is expected; UM_ERR_MEMORY, UM_ERR_CANCELLED. The caller clears, after a failure,
 * too. */
enum um_status um_geometry_part21_read(struct um_context *context, const char *path,
                                       const char *bytes, size_t length,
                                       um_geometry_part21_wanted wanted,
                                       struct um_geometry_part21 *out);
void um_geometry_part21_clear(struct um_context *context, struct um_geometry_part21 *file);

/* The instance of that id, NULL: none is kept. */
const struct um_geometry_part21_instance *
um_geometry_part21_find(const struct um_geometry_part21 *file, uint64_t id);
/* Attribute `index` of an instance, from 0; NULL: it has fewer. */
const struct um_geometry_part21_value *
um_geometry_part21_attribute(const struct um_geometry_part21 *file,
                             const struct um_geometry_part21_instance *instance, int index);
/* Do the texts agree? */
bool um_geometry_part21_is(struct um_geometry_part21_text text, const char *word);

#endif
