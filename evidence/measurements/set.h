/* A set of measurements: observations of channels, in tracks, as a file has them. */
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
};

/* Rows of one quantity of one thing. */
struct um_compare_channel {
  enum um_compare_quantity quantity;
  char *of; /* band, part, side, node, filter or sensor, as in the file */
  size_t count;
};

struct um_compare_measurements {
  char *path;
  const char *time_column;            /* what the file calls its times; static */
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

/* Accepts NULL, sets NULL. */
void um_compare_measurements_destroy(struct um_context *context,
                                     struct um_compare_measurements **measurements);

#endif
