/* What grid and refinement of spins share. Private to evidence/inversion/. */
#ifndef UMBRA_COMPARE_SPIN_IMPL_H
#define UMBRA_COMPARE_SPIN_IMPL_H

#include "evidence/inversion/spin.h"

/* One observation. */
struct um_compare_spin_row {
  double t;                     /* at the satellite, from the reference time [s] */
  struct um_quat frame;         /* GCRS to the frame of the axis */
  struct um_vec3 sun, observer; /* unit, in that frame */
  size_t band;
  double value, sigma; /* reflectivity [m^2/sr] */
};
struct um_compare_spin_data {
  struct um_compare_spin_row *row; /* [count] */
  size_t count;
  double span; /* from the first to the last [s] */
  struct um_vec3 axis_body;
  const struct um_model *model;
  const struct um_model_map *map;
  const struct um_compare_spin_search *search;
};
/* A law about the reference time. */
struct um_compare_spin_law {
  struct um_vec3 axis;
  double rate;  /* [rad/s], negative: against the axis */
  double phase; /* [rad] */
  double misfit;
};

/* Frame of the axis to body. */
static inline struct um_quat um_compare_spin_attitude(const struct um_compare_spin_data *data,
                                                      const struct um_compare_spin_law *law,
                                                      double t)
{
  return um_quat_then(um_core_quat_between(data->axis_body, law->axis),
                      um_quat_from_axis(data->axis_body, law->phase + law->rate * t));
}
/* Largest angle between two laws over the observations [rad]. */
double um_compare_spin_distance(const struct um_compare_spin_data *data,
                                const struct um_compare_spin_law *a,
                                const struct um_compare_spin_law *b);

/* The best laws of the grid, at most search->keep, apart from each other; *nlaw: how many were
 * tried. The caller frees *out. */
enum um_status um_compare_spin_grid(struct um_context *context,
                                    const struct um_compare_spin_data *data,
                                    struct um_compare_spin_law **out, size_t *count, size_t *nlaw);
/* Fit a law, on the map and then by direct simulation. */
enum um_status um_compare_spin_refine(struct um_context *context,
                                      const struct um_compare_spin_data *data,
                                      const struct um_compare_spin_law *start,
                                      struct um_compare_spin *out);

#endif
