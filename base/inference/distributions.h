/* Tails of distributions: the only place of diagnosis/ that knows GSL's. Nothing here fails; a tail
 * that is too thin for a double is 0. */
#ifndef UMBRA_INFERENCE_DISTRIBUTIONS_H
#define UMBRA_INFERENCE_DISTRIBUTIONS_H

/* P(X > chi2) of the chi-square distribution with dof > 0 degrees of freedom; 1 for chi2 <= 0, NaN
 * for NaN or dof <= 0. */
double um_inference_chi2_q(double chi2, double dof);

#endif
