/* One observation beside the model, in the linear unit of its quantity: where magnitudes become
 * flux, and where the model's own sampling error joins that of the measurement. */
#ifndef UMBRA_COMPARE_RESIDUAL_H
#define UMBRA_COMPARE_RESIDUAL_H

#include "evidence/measurements/measurements.h"

struct um_compare_residual {
  double measured, model; /* linear unit; the residual is measured - model */
  double sigma;           /* of the measurement, linear unit; NaN: none */
  double model_sigma;     /* standard error of the model's sampling, linear unit */
};

/* Row of a set against the model's value for it. model: in the quantity's unit, NaN: left out;
 * model_sigma: linear unit. */
struct um_compare_residual um_compare_residual_make(const struct um_compare_measurements *m,
                                                    size_t row, double model, double model_sigma);
/* measured - model over both errors in quadrature; measured - model where there is no sigma. */
double um_compare_residual_normalised(const struct um_compare_residual *r);
/* Both errors in quadrature, and the share of the model's in their variance [1]. */
double um_compare_residual_sigma(double sigma, double model_sigma);
double um_compare_residual_share(double sigma, double model_sigma);

/* What is measured in a row, in the linear unit, with a sigma in the quantity's own; NaN: none. */
struct um_compare_linear um_compare_measured(const struct um_compare_measurements *m, size_t row,
                                             double sigma);
/* Model values of rows row[n] of a set, in the linear unit. value: [rows of the set] in their
 * quantities' units; row NULL: the first n rows; out [n] may then be value itself. */
void um_compare_modelled(const struct um_compare_measurements *m, size_t n, const size_t *row,
                         const double *value, double *out);

#endif
