/* What geometry tables hold. */
#ifndef UMBRA_MODEL_TABLES_H
#define UMBRA_MODEL_TABLES_H

#include <stdbool.h>
#include <stddef.h>

#include "environment/timeline.h"
#include "geometry/view_factor_table.h"
#include "optics/radiance/optics.h"
#include "orbit/observer.h"
#include "thermal/loads/mirrored.h"

/* How finely a body is looked at; 0: as the scenario of the model at hand has it. */
struct um_model_sampling {
  int samples; /* points per facet, optics.samples */
  int paths;   /* between surfaces, optics.interreflection_samples */
};

struct um_model_body_tables;

/* Everything geometric about one timeline, traced once; physics runs on it many times. */
struct um_model_tables {
  size_t nobs;                /* observations */
  size_t nsub;                /* instants per observation (exposure) */
  double *t_obs;              /* [nobs] t_tai, mid-exposure, at the observer */
  size_t *station;            /* [nobs] of um_model_instants; NULL: the observer */
  const char **set;           /* [nobs] of um_model_instants; NULL: none; texts borrowed */
  struct um_orbit_look *look; /* [nobs * nsub] */
  struct um_environment_sample *sample; /* [nobs * nsub], at the satellite's time */
  double *sunlit;                       /* [nobs] mean over the exposure */
  bool *hidden;   /* [nobs] below the station's horizon, or behind the Earth, during the exposure */
  double period;  /* of the orbit [s]; NaN for a fixed point */
  double t_first; /* middle of the first observation, at the satellite [s] */
  double t_start; /* thermal start, t_tai [s] */
  double t_periodic_end;              /* end of the orbit that is made periodic; t_start if none */
  struct um_irradiation_loads *loads; /* over [t_start, last observation], for heat */
  struct um_irradiation_loads *seen;  /* at the observed instants: the same as `loads`, or, where
                                         those are means over a turn, a table of its own */
  struct um_environment_sample *load_sample; /* [loads->ntime] what the rows were traced at */
  size_t *load_row;                          /* [nobs * nsub] row of `seen` at each instant */
  bool sparse; /* observed instants are no rows of `loads`; `seen` has them, linear between rows */
  double spin_period;                          /* over which `loads` are means [s]; 0: over none */
  struct um_irradiation_loads *spin_variation; /* rows of `seen`: struct um_irradiation_spin; NULL
                                          where `loads` are no means */
  struct um_model_body_tables *body;           /* shared with others: body_tables.h */
  struct um_geometry_view_factor_table *view_factors; /* of `body`: at the times of the loads, or 1
                                                         where nothing moves; NULL: no heat to
                                                         follow */
  struct um_irradiation_mirrored *mirrored; /* at the times of the loads; NULL: no mirror */
  struct um_optics_view *view;              /* [nobs * nsub]; NULL without an observer */
  struct um_model_sampling sampling;        /* samples: of `view`; paths: of the runs on it */
  struct um_optics_photon_maps *photons; /* on that view: um_model_precompute_photons; else NULL */
  struct um_environment_event *event;    /* [nevent], eclipse edges from t_start to the end */
  size_t nevent;
  bool points; /* observations stand alone: one instant and one row of loads each, in their order;
                  the rows are numbered, their t is t_start plus the number [s]; no events; heat is
                  not followed */
};

/* Of the model's stations that which looked at observation k. */
size_t um_model_tables_station(const struct um_model_tables *tables, size_t k);

#endif
