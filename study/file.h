/* study.yaml as the user wrote it: one C struct per mapping, bound by the schema table in
 * schema.c. */
#ifndef UMBRA_STUDY_FILE_H
#define UMBRA_STUDY_FILE_H

#include "base/document/schema.h"
#include "base/uncertainty/distribution.h"
#include "study/result.h"

#define UM_STUDY_NAME           192
#define UM_STUDY_PARAMETERS_MAX 10
#define UM_STUDY_POINTS_MAX     1000000
#define UM_STUDY_VALUES_MAX     100000 /* of a point */

enum um_study_mode { UM_STUDY_EXACT, UM_STUDY_SURROGATE };
enum um_study_property { UM_STUDY_EMITTANCE, UM_STUDY_ABSORPTANCE };
/* In the order of UM_UNCERTAINTY_UNIFORM and on. */
enum um_study_spread {
  UM_STUDY_UNIFORM,
  UM_STUDY_NORMAL,
  UM_STUDY_LOG_UNIFORM,
  UM_STUDY_LOG_NORMAL,
  UM_STUDY_TRIANGULAR
};

struct um_study_file_parameter {
  struct um_mark at;
  const char *name, *unit;          /* NULL: made from what it is */
  const char *key;                  /* a path of scenario.yaml, or .. */
  const char *material;             /* .. a material, with a property, or .. */
  const char *effect;               /* .. an effect, with target and parameter */
  const char *target, *parameter;   /* NULL: none, its only one */
  int property;                     /* um_study_property, -1: none */
  double from, to;                  /* NaN: not said */
  struct um_schema_list values;     /* of double */
  int spread;                       /* um_study_spread */
  double mean, sigma, median, mode; /* NaN: not said */
  int levels;                       /* of a grid; INT_MIN: not said */
};
struct um_study_file_design {
  struct um_mark at;
  int kind; /* um_study_design */
  int points, seed, levels;
};
struct um_study_file_error {
  struct um_mark at;
  double light, temperature_K;
};
struct um_study_file_limit {
  struct um_mark at;
  const char *of;              /* a band of the outputs */
  double above, brighter_than; /* NaN: not said; one of them is */
};
struct um_study_file_outputs {
  struct um_mark at;
  struct um_schema_list bands, places; /* of const char * */
  bool magnitudes;
  const char *measured; /* NULL: none */
};
struct um_study_file {
  struct um_mark at;
  int schema;
  const char *name, *summary, *scenario;
  struct um_schema_list limits;     /* of struct um_study_file_limit */
  struct um_schema_list parameters; /* of struct um_study_file_parameter */
  struct um_study_file_design *design;
  int mode;
  struct um_study_file_error *error;
  struct um_study_file_outputs *outputs;
  int held_out, evaluations; /* of a surrogate */
};

/* The name of a parameter's column. */
void um_study_parameter_name(const struct um_study_file_parameter *parameter,
                             char out[UM_STUDY_NAME]);
/* Its distribution; values stay those of the file. */
struct um_uncertainty_distribution
um_study_distribution(const struct um_study_file_parameter *parameter);

/* The table behind it, for the reference page. */
extern const struct um_schema_object um_study_schema;

/* Read and check all that can be without the scenario: ranges have a width, every parameter says
 * one thing that it moves, the number of points is at most UM_STUDY_POINTS_MAX. UM_ERR_IO,
 * UM_ERR_INPUT with file, line and key, UM_ERR_MEMORY. The document owns everything; the caller
 * destroys it. */
enum um_status um_study_file_read(struct um_context *context, const char *path,
                                  struct um_document **document, struct um_study_file **out);
enum um_status um_study_file_parse(struct um_context *context, const char *path, const char *text,
                                   struct um_document **document, struct um_study_file **out);

/* Number of points of the design; beyond 1e18 that. */
double um_study_file_points(const struct um_study_file *file);

#endif
