/* Distributions of a parameter, by GSL. */
#include "base/uncertainty/distribution.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

typedef const struct um_uncertainty_distribution law;

static bool logarithmic(law *l)
{
  return l->kind == UM_UNCERTAINTY_LOG_UNIFORM || l->kind == UM_UNCERTAINTY_LOG_NORMAL;
}
static bool normal(law *l)
{
  return l->kind == UM_UNCERTAINTY_NORMAL || l->kind == UM_UNCERTAINTY_LOG_NORMAL;
}

static enum um_status check_list(struct um_context *context, const char *name, law *l)
{
  bool differ = false;
  if (l->nvalue == 0) return um_core_fail(context, UM_ERR_INPUT, "%s: a list without values", name);
  for (size_t i = 0; i < l->nvalue; i++) {
    if (!isfinite(l->value[i]))
      return um_core_fail(context, UM_ERR_INPUT, "%s: value %zu of the list is not finite", name,
                          i);
    differ = differ || l->value[i] != l->value[0];
  }
  if (differ) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "%s: all values of the list are %g, nothing varies",
                      name, l->value[0]);
}

static enum um_status check_normal(struct um_context *context, const char *name, law *l)
{
  bool log_normal = l->kind == UM_UNCERTAINTY_LOG_NORMAL;
  if (!(l->sigma > 0.0 && isfinite(l->sigma)))
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: a %s distribution with sigma %g, which must be above 0", name,
                        log_normal ? "log-normal" : "normal", l->sigma);
  if (log_normal && !(l->median > 0.0 && isfinite(l->median)))
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: a log-normal distribution with median %g, which must be above 0", name,
                        l->median);
  if (!log_normal && !isfinite(l->mean))
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: the mean of a normal distribution is not finite", name);
  if (isnan(l->from) || isnan(l->to) || (log_normal && isfinite(l->from) && l->from <= 0.0))
    return um_core_fail(context, UM_ERR_INPUT, "%s: cut from %g to %g, which %s", name, l->from,
                        l->to, log_normal ? "must be above 0" : "are no numbers");
  return UM_OK;
}

enum um_status um_uncertainty_distribution_check(struct um_context *context, const char *name,
                                                 law *l)
{
  double least, largest;
  if (l->kind == UM_UNCERTAINTY_LIST) return check_list(context, name, l);
  if (normal(l)) {
    UM_TRY(check_normal(context, name, l));
  } else if (!isfinite(l->from) || !isfinite(l->to)) {
    return um_core_fail(context, UM_ERR_INPUT, "%s: a range from %g to %g is not finite", name,
                        l->from, l->to);
  }
  um_uncertainty_distribution_ends(l, &least, &largest);
  if (!(least < largest))
    return um_core_fail(context, UM_ERR_INPUT, "%s: the range from %g to %g is empty", name, least,
                        largest);
  if (l->kind == UM_UNCERTAINTY_LOG_UNIFORM && !(l->from > 0.0))
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: a log-uniform distribution from %g, which must be above 0", name,
                        l->from);
  if (l->kind == UM_UNCERTAINTY_TRIANGULAR && !(l->mode >= l->from && l->mode <= l->to))
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: a triangular distribution with mode %g outside its range %g to %g",
                        name, l->mode, l->from, l->to);
  return UM_OK;
}

/* The variable in which the distribution is normal, or its place linear. */
static double transformed(law *l, double value) { return logarithmic(l) ? log(value) : value; }

void um_uncertainty_distribution_ends(law *l, double *least, double *largest)
{
  *least = l->from;
  *largest = l->to;
  if (l->kind == UM_UNCERTAINTY_LIST) {
    *least = *largest = l->value[0];
    for (size_t i = 1; i < l->nvalue; i++) {
      *least = fmin(*least, l->value[i]);
      *largest = fmax(*largest, l->value[i]);
    }
  } else if (l->kind == UM_UNCERTAINTY_NORMAL) {
    if (!isfinite(l->from)) *least = l->mean - UM_UNCERTAINTY_CUT * l->sigma;
    if (!isfinite(l->to)) *largest = l->mean + UM_UNCERTAINTY_CUT * l->sigma;
  } else if (l->kind == UM_UNCERTAINTY_LOG_NORMAL) {
    if (!isfinite(l->from)) *least = l->median * exp(-UM_UNCERTAINTY_CUT * l->sigma);
    if (!isfinite(l->to)) *largest = l->median * exp(UM_UNCERTAINTY_CUT * l->sigma);
  }
}

/* Ends of a normal one in standard deviations from its mean. */
static double standard(law *l, double value)
{
  double mean = l->kind == UM_UNCERTAINTY_LOG_NORMAL ? log(l->median) : l->mean;
  return (transformed(l, value) - mean) / l->sigma;
}

/* Phi(b) - Phi(a), from the tail in which both are small. */
static double between(double a, double b)
{
  return a > 0.0 ? gsl_cdf_ugaussian_Q(a) - gsl_cdf_ugaussian_Q(b)
                 : gsl_cdf_ugaussian_P(b) - gsl_cdf_ugaussian_P(a);
}

/* Of a cut normal distribution: Phi(z) = Phi(a) + u (Phi(b) - Phi(a)). */
static double normal_value(law *l, double u, double least, double largest)
{
  double a = standard(l, least), b = standard(l, largest);
  double z = a > 0.0 ? gsl_cdf_ugaussian_Qinv(gsl_cdf_ugaussian_Q(a) - u * between(a, b))
                     : gsl_cdf_ugaussian_Pinv(gsl_cdf_ugaussian_P(a) + u * between(a, b));
  return l->kind == UM_UNCERTAINTY_LOG_NORMAL ? l->median * exp(l->sigma * z)
                                              : l->mean + l->sigma * z;
}

/* Share of a triangle's area left of its mode. */
static double left(law *l) { return (l->mode - l->from) / (l->to - l->from); }

double um_uncertainty_distribution_value(law *l, double u)
{
  double least, largest, x = NAN;
  um_uncertainty_distribution_ends(l, &least, &largest);
  if (l->kind == UM_UNCERTAINTY_LIST) {
    size_t i = u <= 0.0 ? 0 : (size_t)(fmin(u, 1.0) * (double)l->nvalue);
    return isnan(u) ? NAN : l->value[i < l->nvalue ? i : l->nvalue - 1];
  }
  if (u <= 0.0) return least;
  if (u >= 1.0) return largest;
  switch (l->kind) {
  case UM_UNCERTAINTY_UNIFORM:
    x = least + u * (largest - least);
    break;
  case UM_UNCERTAINTY_LOG_UNIFORM:
    x = least * exp(u * log(largest / least));
    break;
  case UM_UNCERTAINTY_TRIANGULAR: /* F = (x - a)^2 / ((b - a) (c - a)) left of the mode c */
    x = u < left(l) ? least + sqrt(u * (largest - least) * (l->mode - least))
                    : largest - sqrt((1.0 - u) * (largest - least) * (largest - l->mode));
    break;
  case UM_UNCERTAINTY_NORMAL:
  case UM_UNCERTAINTY_LOG_NORMAL:
    x = normal_value(l, u, least, largest);
    break;
  case UM_UNCERTAINTY_LIST:
    break;
  }
  return x < least ? least : x > largest ? largest : x;
}

double um_uncertainty_distribution_place(law *l, double value)
{
  double least, largest;
  um_uncertainty_distribution_ends(l, &least, &largest);
  double a = transformed(l, least), b = transformed(l, largest);
  return (transformed(l, value) - a) / (b - a);
}

double um_uncertainty_distribution_at_place(law *l, double place)
{
  double least, largest;
  um_uncertainty_distribution_ends(l, &least, &largest);
  if (place == 0.0) return least;
  if (place == 1.0) return largest;
  return logarithmic(l) ? least * pow(largest / least, place) : least + place * (largest - least);
}
