/* A small scenario-like schema with every type of field, shared by the tests of core. */
#ifndef UMBRA_TESTS_DOCUMENT_SAMPLE_SCHEMA_H
#define UMBRA_TESTS_DOCUMENT_SAMPLE_SCHEMA_H

#include "base/document/schema.h"

enum sample_model { SAMPLE_MODEL_NONE, SAMPLE_MODEL_CLEAR_SKY };

struct sample_shell {
  struct um_mark at;
  double thickness; /* [m] */
};

struct sample_part {
  struct um_mark at;
  const char *name;
  struct sample_shell *shell;
  double size[3]; /* [m] */
  bool lumped;
};

struct sample_material {
  struct um_mark at;
  const char *name;
  double emittance;
};

struct sample_effect {
  struct um_mark at;
  const char *effect, *target;
  double efficiency;
  bool off;
};

struct sample_atmosphere {
  struct um_mark at;
  int model;         /* enum sample_model */
  double visibility; /* [km] */
};

struct sample_time {
  struct um_mark at;
  double start, step; /* [s] */
};

struct sample {
  struct um_mark at;
  const char *name, *tle;
  double altitude; /* [km] */
  struct sample_time *time;
  struct um_schema_list parts, materials, effects; /* of the structs above */
  struct um_schema_list levels, tags;              /* of double, of const char * */
  struct sample_atmosphere *atmosphere;
  int orbits;
  bool verbose;
};

extern const struct um_schema_object sample_schema;
/* A document that is valid for it. */
extern const char sample_text[];

#endif
