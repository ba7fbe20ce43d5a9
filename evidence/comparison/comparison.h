/* What a comparison of model and measurements holds. */
#ifndef UMBRA_COMPARE_COMPARISON_H
#define UMBRA_COMPARE_COMPARISON_H

#include "evidence/comparison/coordinates.h"
#include "evidence/comparison/metrics.h"
#include "evidence/comparison/predict.h"
#include "evidence/comparison/residual.h"
#include "evidence/comparison/segments.h"
#include "model/geometry/tables.h"
#include "model/run/result.h"

#define UM_COMPARE_WORST 3 /* intervals per channel */

/* A model and a run of it on geometry tables of the plan, with the heat of places
 * (um_model_run_with); everything borrowed. */
struct um_compare_run {
  const struct um_model *model;
  const struct um_compare_plan *plan;
  const struct um_model_tables *tables;
  const struct um_model_result *result;
};

/* A share of a model value: radiant intensity [W/sr] by mechanism or material, or heat [W]. */
struct um_compare_share {
  const char *name; /* borrowed from the model */
  double value;
};

/* A run of neighbouring observations of one channel. */
struct um_compare_interval {
  size_t first, count; /* of the channel's observations in order of time */
  double from, to;     /* t_tai of the first and last [s] */
  double chi2; /* sum (r / s)^2, s of both errors; sum r^2 over the mean r^2 where an observation
                  has no sigma */
  double bias; /* mean residual, linear unit */
  double mean_measured; /* linear unit */
  double sunlit;        /* mean sunlit fraction */
  /* Light: mean over the observations, first by mechanism, then by material [W/sr]. Temperatures of
   * a place of the heat network: mean heat flows into it [W]. */
  struct um_compare_share *mechanism, *material; /* [nmechanism], [nmaterial] */
  size_t nmechanism, nmaterial;
};

/* Of the normalised residual r / s (r where an observation has no sigma) with a coordinate:
 * Spearman's rank correlation, with a circular coordinate the circular-linear one. p takes
 * observations as independent, which residuals of a wrong model are not: read it as an order, not
 * as a level. */
struct um_compare_correlation {
  const char *name; /* borrowed from the comparison */
  size_t count;     /* observations where the coordinate has a meaning */
  double value, p;  /* NaN where it does not vary */
};

struct um_compare_channel_comparison {
  size_t channel;  /* of the measurements */
  size_t left_out; /* observations with a flag */
  size_t count;    /* observations in use */
  size_t *row;     /* [count] in order of time */
  struct um_compare_metrics all, segment[UM_SEGMENT_COUNT];
  struct um_compare_interval worst[UM_COMPARE_WORST]; /* by chi2, falling; they do not overlap */
  size_t nworst;
  struct um_compare_correlation *correlation; /* [ncorrelation] by p, rising */
  size_t ncorrelation;
};

struct um_compare_comparison {
  struct um_compare_run run;
  double *model; /* [observations] in the quantity's unit; NaN for observations left out */
  struct um_compare_residual *residual; /* [observations] model NaN: left out */
  enum um_compare_segment *light;       /* [nobs] */
  enum um_compare_segment *motion;
  struct um_compare_coordinates *coordinates;
  struct um_compare_channel_comparison *channel; /* [nchannel] of channels in use */
  size_t nchannel;
  double chi2, dof, chi2_reduced; /* of all observations with a sigma; NaN without */
  double model_share; /* of all observations with a sigma: see um_compare_metrics; NaN without */
  int samples, samples_before; /* optics.samples that was used, and that of the scenario as it was
                                  read: the caller's to set where it refined; the model's own */
};

/* Accepts NULL, sets NULL. */
void um_compare_destroy(struct um_context *context, struct um_compare_comparison **comparison);

#endif
