/* Measurements: observations of channels, in tracks, as a file has them, or several files, a set
 * each (join.h). */
#ifndef UMBRA_COMPARE_SET_H
#define UMBRA_COMPARE_SET_H

#include <stddef.h>

#include "base/core/context.h"
#include "evidence/measurements/quantity.h"

/* An index that stands for nothing. */
#define UM_COMPARE_NOWHERE ((size_t)-1)

/* One row. */
struct um_compare_measurement {
  double t_tai;                                /* mid-exposure at the observer [s] */
  size_t channel;                              /* index into the set's channels */
  double value;                                /* in the quantity's unit */
  double sigma;                                /* > 0; NaN when the file gives none */
  double exposure;                             /* [s]; NaN when the file gives none */
  size_t track;                                /* index into the set's tracks */
  int flag;                                    /* 0: use */
  double satellite_height, azimuth, elevation; /* independent observation [m], [rad], [rad]; NaN */
  int line;                                    /* in the file */
  size_t station;                              /* index into the set's stations; SIZE_MAX: none */
  size_t set;                                  /* index into the files; 0 where there is one */
};

/* A file, in a telescope's night, by one instrument: what is off in it may be right in another. */
struct um_compare_file {
  char *path;
  char *name;              /* of the file without folder and ending; no two are the same */
  char *station;           /* that its rows are of where they name none; NULL: the observer */
  const char *time_column; /* what the file calls its times; static */
};

/* Rows of one quantity of one thing in one set. */
struct um_compare_channel {
  enum um_compare_quantity quantity;
  char *of;    /* band, part, side, node, filter or sensor, as in the file */
  char *label; /* what outputs call it: `of`, of several sets "vis@night1" */
  size_t set;
  size_t count;
};

struct um_compare_measurements {
  char *path;                   /* of several files all, parted by ", " */
  struct um_compare_file *file; /* [nfile] */
  size_t nfile;
  struct um_compare_measurement *row; /* [count], in file order */
  size_t count;
  struct um_compare_channel *channel; /* [nchannel], in order of first appearance */
  size_t nchannel;
  char **track; /* [ntrack] names; one track "" when the file has no column */
  size_t ntrack;
  bool independent; /* rows carry satellite height, azimuth and elevation */
  char **station;   /* [nstation] names */
  size_t nstation;
};

/* The file that a row stands in, and what that calls its times; borrowed. Do not fail. */
const char *um_compare_row_path(const struct um_compare_measurements *m, size_t row);
const char *um_compare_row_time_column(const struct um_compare_measurements *m, size_t row);

/* The set of that name; UM_COMPARE_NOWHERE: there is none. Does not fail. */
size_t um_compare_set_find(const struct um_compare_measurements *m, const char *name);

/* Accepts NULL, sets NULL. */
void um_compare_measurements_destroy(struct um_context *context,
                                     struct um_compare_measurements **measurements);

#endif
