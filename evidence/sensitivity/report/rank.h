/* Which parameters move what most. */
#ifndef UMBRA_SENSITIVITY_REPORT_RANK_H
#define UMBRA_SENSITIVITY_REPORT_RANK_H

#include "evidence/sensitivity/matrix.h"

/* Curves that are ranked together: one of light, or all temperatures. */
struct um_sensitivity_report_group {
  const char *name;   /* "lwir", "temperature"; borrowed */
  size_t first, last; /* curves */
};
/* The groups of a matrix: every curve of light, then the temperatures where there are some. */
size_t um_sensitivity_report_groups(const struct um_sensitivity_matrix *matrix);
struct um_sensitivity_report_group
um_sensitivity_report_group(const struct um_sensitivity_matrix *matrix, size_t index);

/* What one width of a parameter's prior does to a group. */
struct um_sensitivity_report_leader {
  size_t row, curve; /* of the matrix; the curve that it moves most */
  double share;      /* largest change of it, of its size [1] */
};
/* What a row does to the group at instants [from, to). */
struct um_sensitivity_report_leader
um_sensitivity_report_strongest(const struct um_sensitivity_matrix *matrix, size_t row,
                                const struct um_sensitivity_report_group *group, size_t from,
                                size_t to);
/* The share that a hundredth of what the parameter changes makes of it [1]; NaN where nothing is
 * stated that is one number. */
double um_sensitivity_report_by_percent(const struct um_sensitivity_matrix *matrix,
                                        const struct um_sensitivity_report_leader *leader);
/* The strongest rows of a group at instants [from, to), the strongest first, at most `most`, of a
 * millionth of a curve's size or more; behind: of those that act on light behind the satellite
 * (calibration, air), or of all others. How many there are. Switches, of which there is one step
 * only, count with it. Does not fail. */
size_t um_sensitivity_report_leaders(const struct um_sensitivity_matrix *matrix,
                                     const struct um_sensitivity_report_group *group, size_t from,
                                     size_t to, bool behind, size_t most,
                                     struct um_sensitivity_report_leader *out);

/* The end of the piece of at most `seconds` that begins at instant `from`. */
size_t um_sensitivity_report_piece(const struct um_sensitivity_matrix *matrix, size_t from,
                                   double seconds);

#endif
