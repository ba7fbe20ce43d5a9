/* Missing heat: how observations answer to heat of a place, the best pulse, the history. Private to
 * missing_heat/. */
#ifndef UMBRA_MISSING_HEAT_HEAT_IMPL_H
#define UMBRA_MISSING_HEAT_HEAT_IMPL_H

#include "inference/projection.h"
#include "missing_heat/unexplained.h"

/* --- heat_rows.c: from heat to observations */

/* A scenario with its additions, run, and the answer of its light to temperatures. */
struct um_missing_heat_base {
  struct um_sensitivity_forward *forward;   /* borrowed */
  const struct um_model_addition *addition; /* [naddition] borrowed */
  size_t naddition;
  struct um_model *own_model; /* owned; NULL: the forward's own parts serve */
  struct um_model_precomputed *own_trace;
  struct um_model_thermal_solution *own_heat;
  const struct um_model *model;
  const struct um_model_precomputed *precomputed;
  const struct um_model_thermal_solution *heat;
  struct um_model_result *result;
  size_t *first, *row; /* observations of observation k: observation[first[k]] ..
                          observation[first[k + 1] - 1] */
  /* Regions: surfaces whose light is taken to answer to the mean of their temperatures, weighted by
   * what the observer sees of them; groups and sides, materials where the optics take their means
   */
  size_t nregion;
  uint32_t *region; /* [nsurface] */
  double *slope; /* [nregion][nobservation] d(observation / sigma)/dT [1/K]; 0 for temperatures */
};
/* Errors of the runs. The caller releases what was begun, after an error too. */
enum um_status um_missing_heat_base_create(struct um_context *context,
                                           struct um_sensitivity_forward *forward,
                                           const struct um_model_addition *addition,
                                           size_t naddition, struct um_missing_heat_base *out);
void um_missing_heat_base_release(struct um_context *context, struct um_missing_heat_base *base);

/* Values over sigma of the observations in use of a run on the base's geometry precomputation. */
enum um_status um_missing_heat_predict(struct um_context *context,
                                       const struct um_missing_heat_base *base,
                                       const struct um_model_result *result, double *out);

/* Where heat may be: nodes with shares of sum 1. */
struct um_missing_heat_place {
  char *name;
  uint32_t *node;
  double *weight;
  size_t nnode;
};
/* The wall of every group ("part.group", "part" where it has one group) and every interior. */
enum um_status um_missing_heat_places_create(struct um_context *context,
                                             const struct um_model *model,
                                             struct um_missing_heat_place **out, size_t *nplace);
void um_missing_heat_places_destroy(struct um_context *context,
                                    struct um_missing_heat_place **place, size_t nplace);

/* Change of the observations per watt in each bin: column [nbin][nobservation] [sigma/W]; edge:
 * [nbin + 1] t_tai.
 */
enum um_status um_missing_heat_columns(struct um_context *context,
                                       const struct um_missing_heat_base *base,
                                       const struct um_missing_heat_place *place, size_t nbin,
                                       const double *edge, double *column);

/* --- heat_pulse.c: what fits */

/* Observations after the nuisances against bins of heat. */
struct um_missing_heat_bins {
  size_t nbin, nleft;
  double *edge;   /* [nbin + 1] t_tai [s] */
  double *column; /* [nbin][nleft] */
  /* sums over the bins before: of the products of projected columns, of whole ones, and with the
   * residual; [nbin + 1][nbin + 1], the same, [nbin + 1] */
  double *product, *whole, *with;
};
/* column: [nbin][nobservation], taken as it is; residual: [nleft] projected. */
enum um_status um_missing_heat_bins_create(struct um_context *context,
                                           struct um_inference_projection *projection,
                                           const double *residual, size_t nbin, const double *edge,
                                           const double *column, struct um_missing_heat_bins *out);
void um_missing_heat_bins_release(struct um_context *context, struct um_missing_heat_bins *bins);

struct um_missing_heat_pulse {
  size_t from, to; /* edges */
  double chi2;     /* explained */
  double power;    /* [W] */
  double start_sigma, energy_sigma;
};
/* The best of all pulses between two edges. Sigmas about it, with all pulses weighed by their
 * likelihood. */
void um_missing_heat_pulse_find(const struct um_missing_heat_bins *bins,
                                struct um_missing_heat_pulse *out);

/* --- heat_change.c */
/* Power of a pulse by the model itself, and the chi-square that it explains, from a power that the
 * linear response gave. residual: [nleft]. Errors of the runs. */
enum um_status um_missing_heat_change(struct um_context *context,
                                      const struct um_missing_heat_base *base,
                                      struct um_inference_projection *projection,
                                      const double *residual,
                                      const struct um_missing_heat_place *place, double from,
                                      double to, double *power, double *chi2);

/* --- heat_history.c */
/* Heat of every bin and its sigma, both [nbin]. */
enum um_status um_missing_heat_history(struct um_context *context,
                                       const struct um_missing_heat_bins *bins,
                                       const double *residual, double *heat, double *sigma);

#endif
