/* Private to thermal/network/: ESATAN's thermal network language, as files .d have it. */
#ifndef UMBRA_THERMAL_ESATAN_IMPL_H
#define UMBRA_THERMAL_ESATAN_IMPL_H

#include "thermal/network/network.h"

/* Blocks that are read, and those whose statements are Mortran and are run over time. */
enum um_thermal_esatan_block {
  UM_ESATAN_NONE, /* texts, arrays, events: nothing of the network */
  UM_ESATAN_VALUES,
  UM_ESATAN_NODES,
  UM_ESATAN_CONDUCTORS,
  UM_ESATAN_ONCE,     /* $INITIAL, $EXECUTION: assignments before the solution */
  UM_ESATAN_OVER_TIME /* $SUBROUTINES, $VARIABLES1, $VARIABLES2 */
};

struct um_thermal_esatan_statement {
  const char *text; /* without comments, one line */
  int line;
  enum um_thermal_esatan_block block;
};

/* Splits `text` in place. statement: [*n], in the order of the file; the caller frees the array.
 * UM_ERR_INPUT with file and line: no such block, a statement without its end, several models. */
enum um_status um_thermal_esatan_split(struct um_context *context, const char *path, char *text,
                                       struct um_thermal_esatan_statement **statement, size_t *n);

/* Entities of a node that expressions may name. */
enum um_thermal_esatan_entity {
  UM_ESATAN_T,
  UM_ESATAN_C,
  UM_ESATAN_A,
  UM_ESATAN_ALP,
  UM_ESATAN_EPS,
  UM_ESATAN_QI,
  UM_ESATAN_QA,
  UM_ESATAN_QE,
  UM_ESATAN_QR,
  UM_ESATAN_QS,
  UM_ESATAN_ENTITIES
};

struct um_thermal_esatan_node {
  long number;
  char kind; /* 'D', 'A', 'B', 'X' inactive */
  char label[64];
  double value[UM_ESATAN_ENTITIES]; /* T in the file's degrees */
  int line;
  uint32_t index; /* in the network */
};

struct um_thermal_esatan_value {
  const char *name, *text; /* its expression; name ends at the first character that is none */
  int line;
  bool known, busy;
  double value;
};

/* What a file says. */
struct um_thermal_esatan {
  struct um_context *context;
  const char *path;
  struct um_thermal_esatan_value *values; /* [nvalue] */
  struct um_thermal_esatan_node *node;    /* [nnode] in the order of the file */
  uint32_t *order;                        /* [nnode] by number; NULL while nodes are read */
  size_t nvalue, value_room, nnode, node_room;
  double stefan, offset; /* [W/m^2/K^4]; [K] of 0 in the file's degrees */
};

/* Length of the name at `text`; 0: none. */
size_t um_thermal_esatan_word(const char *text);
/* Do `length` characters of `text` spell `word`, in capitals or not? */
bool um_thermal_esatan_same(const char *text, size_t length, const char *word);
/* The constant of this name, or NULL. */
struct um_thermal_esatan_value *um_thermal_esatan_find(const struct um_thermal_esatan *e,
                                                       const char *name, size_t length);
/* Node of this number, or NULL. */
struct um_thermal_esatan_node *um_thermal_esatan_node(const struct um_thermal_esatan *e,
                                                      long number);
/* "T10", "T:10", "EPS10": which of what node, NULL: no such word or no such node. */
double *um_thermal_esatan_entity(const struct um_thermal_esatan *e, const char *word,
                                 size_t length);
/* A whole expression: numbers, constants, entities, + - * / ** ( ). UM_ERR_INPUT with file and
 * line. */
enum um_status um_thermal_esatan_evaluate(struct um_thermal_esatan *e, const char *text, int line,
                                          double *out);

/* esatan.c: do these bytes begin as such a file? */
bool um_thermal_esatan_is(const char *text);
enum um_status um_thermal_esatan_read(struct um_context *context, const char *path, char *text,
                                      struct um_thermal_network **out);

#endif
