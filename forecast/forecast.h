/* Passes to come: what an observer sees of the satellite from stations over days. Every pass is a
 * run of the scenario with its times and its station in place of the scenario's own, and a point of
 * a batch. */
#ifndef UMBRA_STUDY_FORECAST_H
#define UMBRA_STUDY_FORECAST_H

#include "base/batch/batch.h"
#include "environment/environment.h"
#include "model/build/model.h"
#include "orbit/observer.h"

#define UM_FORECAST_CURVE          60    /* instants of the curves that are kept of a pass */
#define UM_FORECAST_MOST           10000 /* passes */
#define UM_FORECAST_UNCERTAIN_MOST 100   /* parameters */

struct um_forecast_station {
  const char *name;                   /* borrowed */
  double latitude, longitude, height; /* [rad], [rad], [m] */
};

/* What is asked. Texts are borrowed. */
struct um_forecast_ask {
  const char *path; /* of the scenario */
  const struct um_model_options *options;
  double from; /* t_tai [s]; NaN: the scenario's start */
  double days; /* > 0; of um_forecast_times NaN, too: half a day and more to both sides of the
                * scenario's middle, so that its own pass is among them; from is NaN then */
  double minimum_elevation;                  /* [rad]; NaN: the scenario's */
  const struct um_forecast_station *station; /* [nstation] */
  size_t nstation;                           /* 0: the scenario's station */
  /* [nuncertain] as a user typed them, each with its standard deviation in its own unit:
   * "effect[:target],name=sigma[,name=sigma]..", "effect[:target]=sigma" where the effect has one
   * parameter, "key=sigma" of a number that the scenario states (um_forecast_uncertain_read) */
  const char *const *uncertain;
  size_t nuncertain;
  const char *version; /* of the program, NULL: none */
};

/* Band of a pass. Magnitudes are of the band's system, exo-atmospheric, NaN where nothing is seen.
 */
struct um_forecast_band {
  double brightest;              /* [mag] */
  double brightest_at;           /* t_tai [s]; NaN: never seen */
  double culmination;            /* [mag] at the instant nearest to culmination */
  double largest;                /* irradiance [W/m^2] after effects, the atmosphere's included */
  double largest_at;             /* t_tai [s] */
  double irradiance_culmination; /* [W/m^2] */
  double intensity;              /* largest radiant intensity toward the station [W/sr] */
  double error;                  /* of the brightest magnitude, by ray tracing [mag] */
};
/* Place of a pass [K]: mean over the pass of the mean over the place, and the extremes of that. */
struct um_forecast_place {
  double mean, lowest, highest;
};

/* A parameter that is uncertain; texts are the forecast's. */
struct um_forecast_uncertain {
  const char *name, *unit; /* "emittance:mli.factor"; "" where no unit is known */
  double value, sigma;     /* in the scenario, 1 sigma [its unit] */
};

struct um_forecast_pass {
  size_t station;
  struct um_orbit_pass pass;
  double start, stop; /* t_tai [s] of the run: whole seconds inside rise and set */
  double entry, exit; /* of the shadow: half of the Sun's disc is hidden, t_tai at the satellite
                       * [s]; NaN: not during the pass */
  bool sunlit_at_rise, sunlit_at_set;
  struct um_environment_event *event; /* [nevent] edges of the shadow during the pass */
  size_t nevent;
  double sun_elevation; /* [rad] at the station at culmination, geometric */
  double delay;         /* error of the times by the age of two-line elements, 1 sigma [s]; NaN:
                         * unknown */
  char *reason;         /* NULL: computed; else why not, and what follows is NaN */
  const struct um_forecast_band *band;   /* [nband] */
  const struct um_forecast_place *place; /* [nplace] */
  const double *curve_at;                /* [UM_FORECAST_CURVE] t_tai [s] */
  const double *curve; /* [nband][2][UM_FORECAST_CURVE] magnitude [mag], irradiance [W/m^2] */
  /* 1 sigma of these by what is uncertain, to first order; NaN where it is not known, and of times
   * and errors. NULL: nothing is uncertain */
  const struct um_forecast_band *band_sigma;
  const struct um_forecast_place *place_sigma;
  const double *curve_sigma;
  /* [nuncertain][nband + nplace] what each parameter does at 1 sigma: to a band's brightest
   * magnitude [mag], or its largest irradiance where it shines by its own heat [W/m^2], to a
   * place's mean [K]. part: to first order, signed; bend: what is beyond, absolute; NaN: not known,
   * where there is one side alone, or heat was told by a tangent, which is so in all passes but the
   * first
   */
  const double *part, *bend;
};

struct um_forecast {
  char *name;               /* the scenario's */
  double from, to;          /* t_tai [s] */
  double minimum_elevation; /* [rad] */
  size_t nstation, npass, nband, nplace;
  struct um_forecast_station *station; /* [nstation]; names owned */
  char **band, **place;                /* names */
  bool *thermal;                       /* [nband] shines by its own heat there */
  double *vega_ab; /* [nband] AB magnitude of magnitude 0 relative to Vega; NaN: the band's
                    * magnitudes are AB */
  struct um_forecast_pass *pass;           /* [npass] by rise */
  double *value;                           /* what passes point into */
  struct um_forecast_uncertain *uncertain; /* [nuncertain] */
  size_t nuncertain;
};

/* Words for the Sun's elevation: "day" above -0.833 deg (the upper limb with refraction), "civil",
 * "nautical", "astronomical" twilight down to -6, -12, -18 deg, "night". Borrowed. */
const char *um_forecast_sky(double sun_elevation);

/* System of a band's magnitudes: "Vega" or "AB". Borrowed. */
const char *um_forecast_system(const struct um_forecast *forecast, size_t band);

/* The passes that culminate in [from, from + days], without what a run gives; and a batch task for
 * the runs, whose `ncoordinate`, `nvalue`, `compute`, `accepts` and `user` are set. The forecast
 * outlives the task's batch; `ask` too, with what it points to. UM_ERR_INPUT: no station, no orbit,
 * more than UM_FORECAST_MOST passes, something uncertain that the scenario has not or cannot be
 * moved; errors of um_model_create. The caller destroys. */
enum um_status um_forecast_create(struct um_context *context, const struct um_forecast_ask *ask,
                                  struct um_batch_task *task, struct um_forecast **out);
/* The passes by their times alone: nothing is to be run, and bands and places are none. Only what
 * orbits need of the scenario is built. Errors as above; ask->uncertain is not looked at. The
 * caller destroys. */
enum um_status um_forecast_times(struct um_context *context, const struct um_forecast_ask *ask,
                                 struct um_forecast **out);
/* Open the records of the task; errors of um_study_identity_open. */
enum um_status um_forecast_open(struct um_context *context, const struct um_forecast *forecast,
                                const struct um_batch_task *task, struct um_batch **out);
/* Compute the passes; a pass that cannot be computed has its reason. Errors of um_batch_run. */
enum um_status um_forecast_run(struct um_context *context, struct um_forecast *forecast,
                               struct um_batch *batch);
/* The parameter that gives most of a band's variance over all passes that were computed, and its
 * share of it [1]; SIZE_MAX: none moves the band. */
size_t um_forecast_leader(const struct um_forecast *forecast, size_t band, double *share);
/* Accepts NULL, sets NULL. */
void um_forecast_destroy(struct um_context *context, struct um_forecast **forecast);

#endif
