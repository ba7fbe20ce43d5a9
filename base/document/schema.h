/* One table describes a YAML file: it checks, binds into C structs, and emits the reference page
 * and the JSON Schema. Every bound struct that stands for a YAML mapping begins with a
 * `struct um_mark at`, so that a later check can still name file, line and key. */
#ifndef UMBRA_DOCUMENT_SCHEMA_H
#define UMBRA_DOCUMENT_SCHEMA_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/core/context.h"

struct um_node;

/* Where a value came from: "file:line: path". An override has line 0 and file "--set". */
struct um_mark {
  const char *file; /* borrowed from the document */
  int line;         /* 1-based; 0 = no line */
  const char *path; /* e.g. "parts.bus.interior.power_W", borrowed */
  /* what stands there, borrowed, for um_document_mark_key; NULL: a mapping that is not written */
  const struct um_node *node;
};

enum um_schema_type {
  UM_SCHEMA_NUMBER,  /* double; finite */
  UM_SCHEMA_INTEGER, /* int */
  UM_SCHEMA_BOOL,    /* bool; true/false only */
  UM_SCHEMA_TEXT,    /* const char *; NULL when absent */
  UM_SCHEMA_CHOICE,  /* int: index into `choices` */
  UM_SCHEMA_VECTOR,  /* double[length]; a sequence of exactly `length` numbers */
  UM_SCHEMA_NUMBERS, /* struct um_schema_list of double */
  UM_SCHEMA_TEXTS,   /* struct um_schema_list of const char * */
  UM_SCHEMA_MAP,     /* struct T *; NULL when absent; described by `object` */
  UM_SCHEMA_LIST,    /* struct um_schema_list of T: a sequence of mappings */
  UM_SCHEMA_DICT,    /* struct um_schema_list of T: a mapping name -> mapping; T is
                        { struct um_mark at; const char *name; ... } */
  UM_SCHEMA_PARSED,  /* anything scalar through `parse`, e.g. a UTC into a double */
  UM_SCHEMA_REST     /* struct um_schema_list of struct um_schema_number: every key of this mapping
                        that no other field names; `key` is what the reference calls them */
};

/* One key of a UM_SCHEMA_REST field. */
struct um_schema_number {
  struct um_mark at;
  const char *name;
  double value; /* finite */
};

struct um_schema_list {
  void *items; /* [count] objects of object->size (or double, or const char *) */
  size_t count;
};

struct um_schema_object;

struct um_schema_field {
  const char *key;
  enum um_schema_type type;
  size_t offset;
  bool required;
  double minimum,
      maximum;       /* of numbers and vector elements, inclusive unless `open`; equal = no bound */
  bool open_minimum; /* minimum itself is refused */
  double default_value; /* default of NUMBER, INTEGER, BOOL, CHOICE, of each VECTOR element, and of
                      a PARSED whose target is a double; NaN: no default, which leaves NaN, an
                      INTEGER INT_MIN, a CHOICE -1, a BOOL false */
  size_t length;        /* of VECTOR; of the inline target of PARSED [bytes] */
  bool file;            /* TEXT or TEXTS: names files, relative ones from the document's folder */
  bool name;            /* TEXT or TEXTS: names that reach other files and programs; they pass
                           um_core_name_is_safe, as do the keys of every DICT */
  bool behind; /* DICT: its keys are written behind a part's name: um_core_name_is_safe_behind */
  size_t most; /* elements of a NUMBERS, TEXTS, LIST or DICT; 0: no bound */
  bool always; /* MAP: an absent mapping is read as an empty one, so that its defaults hold */
  const char *const *choices;            /* NULL-terminated, for CHOICE */
  const struct um_schema_object *object; /* for MAP, LIST, DICT */
  /* For PARSED: text -> target; on failure writes what is accepted into `why`. */
  bool (*parse)(const char *text, void *target, char *why, size_t why_size);
  int alternative;  /* fields of one object with the same nonzero number exclude each other */
  const char *help; /* one sentence for the reference; units stand in the key */
};

struct um_schema_object {
  const char *name; /* "scenario", "tle orbit" ... in messages */
  const char *help;
  size_t size; /* sizeof the bound struct; begins with struct um_mark */
  const struct um_schema_field *fields;
  size_t nfield;
  /* alternative group numbers of which exactly one member must be present; 0-terminated; or NULL */
  const int *exactly_one;
  /* A MAP field, or an element of a LIST or DICT, whose value may also be a plain scalar (e.g.
   * `atmosphere: none`): key of the field in this object that receives the scalar, all others
   * taking their defaults; NULL: a mapping is required. */
  const char *scalar_key;
  bool others; /* keys that no field names are left alone: a file of another program */
};

/* Initialisers: UM_FIELD(struct T, member, "key_unit", TYPE) with more members of the field behind
 * the type where needed: UM_FIELD(struct T, member, "key_unit", TYPE, .required = true). */
#define UM_FIELD(structure, member, key_, ...)                                                     \
  {                                                                                                \
    .key = (key_), .offset = offsetof(structure, member), .type = __VA_ARGS__                      \
  }
#define UM_FIELD_COUNT(fields) (sizeof(fields) / sizeof((fields)[0]))

/* A parsed, checked document; owns every string and struct bound from it. */
struct um_document;

/* Parse `path` (aliases, anchors, duplicate keys, tags are refused; UTF-8; at most 2 MiB), apply
 * `noverride` texts "key.path=yaml value" in order (names address lists of mappings that have a
 * `name`, or an `effect` with optional ":target"; integers address by position; the value is YAML;
 * missing mappings on the way are made; a path that ends in "+" adds an element to a list), check
 * against `schema` and bind. root: the bound struct, owned by the document. Errors: one line
 * "file:line: key: problem; accepted: ...", unknown keys with the nearest known one. UM_ERR_IO,
 * UM_ERR_INPUT, UM_ERR_MEMORY.
 */
enum um_status um_document_read(struct um_context *context, const char *path,
                                const struct um_schema_object *schema, const char *const *overrides,
                                size_t noverride, struct um_document **out, void **root);
/* The same from memory; relative names inside resolve against `path` as if it were the file. */
enum um_status um_document_parse(struct um_context *context, const char *path, const char *text,
                                 const struct um_schema_object *schema,
                                 const char *const *overrides, size_t noverride,
                                 struct um_document **out, void **root);
/* One key with another value. Borrowed while it is applied. */
struct um_document_change {
  const char *key; /* path of an override */
  double number;   /* in the unit of the field; of a parsed one in that of what it is parsed into (a
                      UTC: t_tai [s]); NaN: `text` is YAML */
  const char *text; /* how the number is written in um_document_text; NULL: as few digits as give it
                       back, the sign of -0 too */
  bool as_written;  /* a parsed field reads the number from its text, as it does in a file */
};
/* A document with changes, from the tree of `origin`: nothing is read or parsed but YAML texts of
 * the changes. `origin` outlives it. Checks, binding and errors of um_document_read; a field of
 * text takes a number as it is written. */
enum um_status um_document_change(struct um_context *context, const struct um_document *origin,
                                  const struct um_schema_object *schema,
                                  const struct um_document_change *change, size_t nchange,
                                  struct um_document **out, void **root);
/* A changed document becomes the owner of its origin: destroying it destroys both. *origin is set
 * to NULL. */
void um_document_keep_origin(struct um_document *document, struct um_document **origin);
void um_document_destroy(struct um_document **document);
/* The document as YAML text after its overrides, comments kept where libfyaml keeps them; the
 * caller frees. Used for the copy in results and for improved scenarios. */
enum um_status um_document_text(struct um_context *context, const struct um_document *document,
                                char **out);
/* Relative names of files (fields with `file`) are written anew so that they lead to the same files
 * from a document in `folder`, which exists: relative, or absolute where the two folders have only
 * the root in common; one whose folder does not exist leads to the same place, too. For
 * um_document_text: what is bound stays. UM_ERR_IO "name: reason" where the document's own folder
 * does not exist any more. */
enum um_status um_document_move(struct um_context *context, struct um_document *document,
                                const struct um_schema_object *schema, const char *folder);
/* The number at a key path (that of an override), after overrides; NaN where the document has none
 * there. */
double um_document_number(struct um_document *document, const char *key);
/* What stands at a key path, after overrides. Texts are the document's. */
enum um_document_value_kind {
  UM_DOCUMENT_NOTHING,
  UM_DOCUMENT_NUMBER,
  UM_DOCUMENT_TEXT, /* words without quotes, too: true, 2016-09-06T18:07:00Z */
  UM_DOCUMENT_LIST, /* elements by position, key.0 */
  UM_DOCUMENT_GROUP /* elements by name */
};
struct um_document_value {
  enum um_document_value_kind kind;
  bool quoted;             /* of a text */
  double number;           /* of a number; else NaN */
  const char *text;        /* of a number or text, as it is written; else NULL */
  size_t count;            /* of elements */
  const char *const *name; /* [count] of a group; else NULL */
};
/* UM_ERR_INPUT: a path that can lead nowhere, as into an element that a list has not;
 * UM_ERR_MEMORY. */
enum um_status um_document_value(struct um_document *document, const char *key,
                                 struct um_document_value *out);
/* Do both documents say the same at a path of keys alone ("environment.earth"), number for number?
 * Absent in both counts as the same. */
bool um_document_same(const struct um_document *a, const struct um_document *b, const char *path);
/* Where a key path (that of an override) leads, in one spelling: an element of a list by its
 * position, ".parts.0.shell". out: [size], cut where it is full. */
void um_document_place(struct um_document *document, const char *key, char *out, size_t size);
/* Memory owned by the document, zeroed; for things derived while binding. */
enum um_status um_document_allocate(struct um_context *context, struct um_document *document,
                                    size_t count, size_t size, void *out);

/* Mark of a key of the mapping that stands at `parent`; `parent` itself when the mapping has no
 * such key, is no mapping, or key is NULL. Borrowed from the document, or `parent`. Does not fail.
 */
const struct um_mark *um_document_mark_key(const struct um_mark *parent, const char *key);

/* Record "file:line: path: message" and return UM_ERR_INPUT. */
enum um_status um_document_mark_fail(struct um_context *context, const struct um_mark *at,
                                     const char *format, ...) UM_PRINTF(3, 4);

/* Reference page (Markdown) and JSON Schema (draft 2020-12) of a schema. */
enum um_status um_document_schema_write_markdown(FILE *file, const struct um_schema_object *schema);
enum um_status um_document_schema_write_json(FILE *file, const struct um_schema_object *schema);

/* The field that a path of keys names, and the mapping it stands in. Behind a list or a dictionary
 * the name of an element may stand ("parts.bus.shell") or not ("parts.shell", "parts[].shell").
 * UM_ERR_INPUT names the key that there is not, the nearest one and what is accepted. */
enum um_status um_document_schema_find_path(struct um_context *context,
                                            const struct um_schema_object *schema, const char *path,
                                            const struct um_schema_object **object,
                                            const struct um_schema_field **field);
/* The part of the reference page, or of the JSON Schema, that is about one field. */
enum um_status um_document_schema_write_field(FILE *file, const struct um_schema_object *object,
                                              const struct um_schema_field *field,
                                              const char *path);
enum um_status um_document_schema_write_json_field(FILE *file, const struct um_schema_field *field);
/* What a field accepts, in words; cut where the buffer is full. Does not fail. */
void um_document_schema_accepted(const struct um_schema_field *field, char *buffer, size_t size);
/* Every path of keys and its field, as um_document_schema_find_path takes them, without those of
 * mappings that hold themselves; what a visit returns but UM_OK ends it and is returned. */
typedef enum um_status (*um_document_schema_visitor)(void *self, const char *path,
                                                     const struct um_schema_field *field);
enum um_status um_document_schema_walk(const struct um_schema_object *schema,
                                       um_document_schema_visitor visit, void *self);
/* Every path of keys, one a line, as um_document_schema_find_path takes them; without those of
 * mappings that hold themselves. */
void um_document_schema_write_paths(FILE *file, const struct um_schema_object *schema);

#endif
