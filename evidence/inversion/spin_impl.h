/* What grid and refinement of spins share. Private to evidence/inversion/. */
#ifndef UMBRA_COMPARE_SPIN_IMPL_H
#define UMBRA_COMPARE_SPIN_IMPL_H

#include "evidence/inversion/spin.h"

/* One observation. */
struct um_compare_spin_row {
  double t;                     /* at the satellite, from the reference time [s] */
  struct um_vec3 sun, observer; /* unit, in the frame of the axis */
  size_t band;
  double value, sigma; /* reflectivity [m^2/sr] */
  size_t on_map;       /* row of on_map */
  double node;         /* between the nodes of `earth` */
  double earth_scale;  /* reflectivity there, of what `earth` holds [1] */
};
struct um_compare_spin_light;
struct um_compare_spin_data {
  struct um_compare_spin_row *row; /* [count] */
  size_t count;
  double span;   /* from the first to the last [s] */
  double at_tai; /* the reference time [s] */
  bool lvlh;     /* the frame of the axis is the orbital one, else GCRS */
  struct um_vec3 axis_body;
  const struct um_model *model;
  const struct um_compare_on_map *on_map;
  const struct um_model_map *map;
  struct um_model_map *earth;          /* NULL: the Earth sends no light that is reflected */
  struct um_compare_spin_light *light; /* the whole model */
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

/* The frame of the axis at samples [n], GCRS to it, by the laws of orbit/; out [n]. */
enum um_status um_compare_spin_frames(struct um_context *context, bool lvlh,
                                      const struct um_environment_sample *sample, size_t n,
                                      struct um_quat *out);

/* Light of the Earth by the attitude of the body in the frame of the axis, on a coarse grid at
 * nodes along the observations, between which the sky turns by some 25 deg; fills node and
 * earth_scale of the rows. Nodes: sunlight at 1 au as unit, light between surfaces left out. The
 * caller destroys data->earth. Errors of um_model_precompute_posed. */
enum um_status um_compare_spin_earth(struct um_context *context, struct um_compare_spin_data *data);
/* What the grid looks up for a row of the body at q, frame of the axis to body: sunlight on the
 * map, and the Earth's light [m^2/sr]; scratch [nband]. NaN where Sun and observer are opposite. */
double um_compare_spin_look_up(const struct um_compare_spin_data *data,
                               const struct um_compare_spin_row *row, struct um_quat q,
                               double *scratch);

/* The whole model for laws: exposures, sunlight, the Earth's light, air, effects on observations.
 * The caller destroys. Errors of um_model_precompute_unposed; UM_ERR_INPUT for a row of light from
 * below the horizon. */
enum um_status um_compare_spin_light_create(struct um_context *context,
                                            const struct um_compare_spin_data *data,
                                            struct um_compare_spin_light **out);
/* Model of every row [count of the data], in its reflectivity [m^2/sr]; between: with light between
 * surfaces, where the model has it. */
enum um_status um_compare_spin_light_of(struct um_context *context,
                                        const struct um_compare_spin_data *data,
                                        const struct um_compare_spin_law *law, bool between,
                                        double *value);
void um_compare_spin_light_destroy(struct um_context *context,
                                   struct um_compare_spin_light **light);
/* Has the model light between surfaces that can see each other? */
bool um_compare_spin_has_between(const struct um_model *model);

/* The best laws of the grid, at most search->keep, apart from each other; *nlaw: how many were
 * tried. The caller frees *out. */
enum um_status um_compare_spin_grid(struct um_context *context,
                                    const struct um_compare_spin_data *data,
                                    struct um_compare_spin_law **out, size_t *count, size_t *nlaw);
/* Fit a law: on the map and then with the whole model but light between surfaces; between: with all
 * of it at once. */
enum um_status um_compare_spin_refine(struct um_context *context,
                                      const struct um_compare_spin_data *data,
                                      const struct um_compare_spin_law *start, bool between,
                                      struct um_compare_spin *out);

#endif
