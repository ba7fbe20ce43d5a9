/* Spins that agree with measured light: a search over axis, sense, rate and phase by looking up on
 * a reflectivity map and on one of the Earth's light, the best refined with the whole model, all
 * that cannot be told apart listed. */
#ifndef UMBRA_COMPARE_SPIN_H
#define UMBRA_COMPARE_SPIN_H

#include "evidence/inversion/on_map.h"

struct um_compare_spin_search {
  double axis_step;                 /* between neighbouring axes [rad] */
  double turn_step;                 /* of the body's turn, and of phases, a part of a turn [rad] */
  double period_least, period_most; /* of one turn, either sense [s] */
  size_t keep;                      /* local minima of the grid that are refined, at most */
};

/* A law of steady spin; the turn is that of attitude.spin (orbit/attitude.h). */
struct um_compare_spin {
  struct um_vec3 axis; /* unit, in the frame of the scenario's law */
  double period;       /* [s]; negative: against the axis */
  double phase;        /* turn at the set's reference time, 0 to 2 pi [rad] */
  double misfit;       /* of the grid, per observation [1] */
  double chi2;         /* of the whole model */
  double axis_sigma, period_sigma, phase_sigma; /* [rad], [s], [rad]; NaN: not determined */
  double apart; /* from the best, sqrt(chi2 - chi2 of the best), over the best's reduced chi2 where
                   that is above 1 [sigma] */
};
struct um_compare_spins {
  struct um_compare_spin *spin; /* [count] the best first */
  size_t count;
  size_t nobservation;
  size_t nlaw;   /* laws that the grid held */
  double at_tai; /* reference time, middle of the observations, at the satellite [s] */
  bool lvlh;     /* the axes are in the orbital frame, else in GCRS */
  struct um_vec3 axis_body;
};

/* The scenario has one attitude law, a spin about axis_body without nutation, whose other keys are
 * what is sought; its attitude effects are not applied. Every row of on_map wants a sigma; rows of
 * bands that reach beyond 2.5 um are left out. What is fitted and ranked is the whole model of a
 * row: sunlight, the Earth's light, light between surfaces, air, exposure, effects on observations.
 * Heat alone is not followed, which does not show in such bands. The grid looks up sunlight on the
 * map and the Earth's light on a coarse grid of its own. It takes the map's own error as 0.3 of
 * each value, so that a glint beside its place weighs no more than a few faint rows; its local
 * minima in phase at every axis and sense are gathered into solutions apart by more than steps of
 * the grid, and the best of these are fitted;
 * with light between surfaces those that without it are within 100 times the best's chi-square.
 * UM_ERR_INPUT: another law, no sigma, a search that is none, more than 1e9 laws, fewer than five
 * rows. Others as um_model_reflectivity. The caller destroys. */
enum um_status um_compare_spins_find(struct um_context *context, const struct um_model *model,
                                     const struct um_compare_on_map *on_map,
                                     const struct um_model_map *map,
                                     const struct um_compare_spin_search *search,
                                     struct um_compare_spins **out);
/* What find refuses of scenario, rows and search but the number of laws, before a map is made. */
enum um_status um_compare_spins_check(struct um_context *context, const struct um_model *model,
                                      const struct um_compare_on_map *on_map,
                                      const struct um_compare_spin_search *search);
void um_compare_spins_destroy(struct um_context *context, struct um_compare_spins **spins);

/* attitude.csv: the solutions. */
void um_compare_spins_write(const struct um_compare_spins *spins, FILE *file);

#endif
