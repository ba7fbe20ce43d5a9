/* Black bodies in the bins of a light curve: tables over temperature, and sums of many bodies. */
#ifndef UMBRA_OPTICS_PLANCK_IMPL_H
#define UMBRA_OPTICS_PLANCK_IMPL_H

#include "optics/spectra_impl.h"

/* Tables for temperatures from low to high [K]. UM_ERR_MEMORY. */
enum um_status um_optics_planck_create(struct um_context *context, double low, double high,
                                       struct um_optics_spectra *spectra);
/* Bin mean of B_lambda, evaluated [W/m^2/sr/m]. */
double um_optics_planck_mean(const struct um_optics_spectra *spectra, size_t bin,
                             double temperature);

/* sum_i w_i B(T_i): interpolation is linear in the rows of the tables, so that bodies add weights
 * of nodes and the rows are run through once for all of them. Empty when created and after _end. */
struct um_optics_planck_sum {
  double *weight;    /* of the nodes of all bands, one band after the other */
  size_t *low, *end; /* [nband] nodes with a weight, low to end - 1 */
  double *rest;      /* [nbin] of bodies that the tables do not hold */
  bool *has_rest;    /* [nband] */
};
enum um_status um_optics_planck_sum_create(struct um_context *context,
                                           const struct um_optics_spectra *spectra,
                                           struct um_optics_planck_sum *sum);
void um_optics_planck_sum_clear(struct um_context *context, struct um_optics_planck_sum *sum);
void um_optics_planck_sum_add(const struct um_optics_spectra *spectra, double temperature,
                              double weight, struct um_optics_planck_sum *sum);
/* The sum per bin, row[nbin] overwritten; relative error below 5e-9 where the weights have one
 * sign. */
void um_optics_planck_sum_end(const struct um_optics_spectra *spectra,
                              struct um_optics_planck_sum *sum, double *row);

#endif
