/* What a run gives. */
#ifndef UMBRA_MODEL_RESULT_H
#define UMBRA_MODEL_RESULT_H

#include "base/core/context.h"
#include "optics/instrument/grey_body.h"
#include "thermal/solver/solve.h"

/* Temperatures of one named place (part, side, group, interior, or "material:NAME") [K]. */
struct um_model_place_history {
  char *name;
  double *mean, *minimum, *maximum; /* [nobs] area-weighted (capacity-weighted inside) */
  double drift; /* change of the mean over the last orbit before the window [K] */
};

/* What an infrared observer concludes from the thermal bands of an observation
 * (model/run/grey_body.h).
 */
struct um_model_grey_body {
  struct um_instrument_grey_body one, two; /* n 0: none */
  double temperature_error;                /* of `one`, by the standard errors of the bands [K] */
  double area_error;                       /* [m^2] */
};

/* What finer facets would change of a run, estimated (model/run/mesh_error.h). Signs: of what is,
 * less what finer facets have [K]; of light, what they have over what is, less 1 [1]. */
struct um_model_mesh_error {
  double *surface;    /* [nsurface] rms over the instants [K] */
  double *side;       /* [2 groups] of the mean of a group's front, of its back, the largest of the
                         instants [K] */
  double temperature; /* the largest of these [K] */
  double temperature_mean;    /* of its size, over surfaces by area and over instants [K] */
  size_t group;               /* of the geometry, where it is largest */
  bool back;                  /* its side */
  size_t nband;               /* 0: no light */
  double *light, *light_mean; /* [nband] of the observation where it is largest, and the mean [1] */
};

struct um_model_result {
  size_t nobs, nband, nsensor, nmaterial, nsurface, nnode, nplace;
  double *irradiance; /* [nobs][nband] at the aperture, what the filter lets through, after effects
                         [W/m^2]; NaN where hidden */
  double *magnitude_ab; /* [nobs][nband] after effects other than the atmosphere's; INFINITY where
                           the irradiance is 0, NaN where it is negative and where hidden */
  double
      *measured_intensity; /* [nobs][nband] what is concluded from a measurement, E R^2 without an
                              atmosphere, after effects other than its [W/sr]; where hidden, too */
  double *intensity;       /* [nobs][nband][nmaterial][UM_MECHANISM_COUNT] [W/sr] */
  double *standard_error;  /* [nobs][nband] of the total [W/sr] */
  /* [nobs][nband] that error through range, exposure and effects: of irradiance [W/m^2], and of the
   * flux 10^(-0.4 magnitude_ab) [1]; both NaN where nothing arrives */
  double *irradiance_error, *magnitude_error;
  double *vega_ab;          /* [nband] magnitude_vega is magnitude_ab less this */
  double *count_rate;       /* [nobs][nsensor] after effects [1/s]; NaN where hidden */
  double *count_rate_error; /* [nobs][nsensor] standard error of it by ray tracing [1/s] */
  struct um_model_grey_body *grey_body; /* [nobs]; NULL: fewer than three thermal bands */
  double *spectral; /* [nobs][nbin][UM_MECHANISM_COUNT] before any filter [W/sr/m] */
  size_t nbin;
  double *wavelength, *bin_width;       /* [nbin] [m] */
  double *transmission;                 /* [nbin] of the band's filter [1] */
  uint32_t *bin_band;                   /* [nbin] */
  double *surface_temperature;          /* [nobs][nsurface] [K] */
  double *node_temperature;             /* [nobs][nnode] [K] */
  struct um_model_place_history *place; /* [nplace] */
  struct um_thermal_heat *heat; /* [nobs][nplace] [W]; of thermal places, zero for materials; NULL:
                                   not asked for (um_model_run_observed) */
  struct um_thermal_heat audit; /* [J] over the whole thermal run */
  double audit_error;           /* [1] */
  double audit_limit;           /* of it (um_thermal_history_audit_limit) */
  double periodic_distance;     /* what the periodic start left [K]; NaN when isothermal */
  size_t steps, rhs_evaluations, jacobians;
  struct um_model_mesh_error mesh; /* surface NULL: not asked for */
};

/* Radiant intensity of one observation and band, all materials together [W/sr]; mechanism < 0: all.
 */
double um_model_result_intensity(const struct um_model_result *result, size_t k, size_t band,
                                 int mechanism);

void um_model_result_destroy(struct um_context *context, struct um_model_result **result);

#endif
