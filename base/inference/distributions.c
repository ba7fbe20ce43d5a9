/* Tails of distributions, by GSL. Its handler would end the program where a tail underflows; off,
 * it returns 0 there, which is what we want. */
#include "base/inference/distributions.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <math.h>

double um_inference_chi2_q(double chi2, double dof)
{
  if (!(dof > 0.0) || isnan(chi2)) return NAN;
  if (chi2 <= 0.0) return 1.0;
  if (isinf(chi2)) return 0.0;
  gsl_set_error_handler_off();
  double q = gsl_cdf_chisq_Q(chi2, dof);
  return q >= 0.0 ? fmin(q, 1.0) : 0.0;
}
