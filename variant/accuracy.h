/* The bias that tolerances give the curves of a scenario, measured, and its correction in variants.
 * Errors of an integration have one sign: what loose tolerances do to a variant they do to the
 * scenario as it stands, nearly. So
 *
 *   y = y_loose + (y_0 - y_0,loose) of temperatures and magnitudes, y_loose y_0/y_0,loose of light.
 */
#ifndef UMBRA_VARIANT_ACCURACY_H
#define UMBRA_VARIANT_ACCURACY_H

#include "variant/evaluator.h"

struct um_variant_curve {
  size_t count;  /* values */
  bool relative; /* errors and corrections are of the value, else absolute */
  double floor;  /* of a value that errors are relative to */
  double asked;  /* error [1 or the curve's unit] */
};
/* What is looked at; all borrowed. */
struct um_variant_curves {
  struct um_variant_evaluator *evaluator;
  const struct um_variant *base;        /* the scenario as it stands, open with heat */
  const struct um_variant_curve *curve; /* [ncurve] */
  size_t ncurve, nvalue;
  const double *nominal; /* [nvalue] of the scenario as it stands; NaN: nothing is seen */
  /* Values [nvalue] of a run. */
  enum um_status (*take)(struct um_context *context, const void *user, const struct um_model *model,
                         const struct um_model_result *result, double *value);
  const void *user;
};

/* Starts zeroed but for its tolerance. */
struct um_variant_accuracy {
  struct um_variant_tolerance tolerance;
  double *bias; /* [ncurve] of the scenario as it stands, by the tolerance */
  double
      *correction; /* [nvalue] factor of relative curves, addend of others; NULL: none is known */
  double *error;   /* [ncurve] that is left of a variant; NULL: not measured */
};
void um_variant_accuracy_release(struct um_context *context, struct um_variant_accuracy *accuracy);

/* Largest differences [ncurve] of two variants' values, relative to b's where a curve is. */
void um_variant_differences(const struct um_variant_curves *curves, const double *a,
                            const double *b, double *largest);
/* Values of an open variant with the tolerance; the bias is corrected where the geometry is the
 * scenario's. accuracy NULL: with the scenario's own, solved though some heat is at hand. Errors of
 * um_variant_find_heat, um_variant_observe and take. */
enum um_status um_variant_values(struct um_context *context, const struct um_variant_curves *curves,
                                 const struct um_variant_accuracy *accuracy,
                                 struct um_variant *variant, double *value);
/* Bias and correction of accuracy->tolerance: the scenario as it stands is solved with it. */
enum um_status um_variant_accuracy_bias(struct um_context *context,
                                        const struct um_variant_curves *curves,
                                        struct um_variant_accuracy *accuracy);
/* The loosest tolerance that leaves `share` of what is asked of every curve, measured at a variant
 * of the scenario's geometry, far from it; the tightest where none does. */
enum um_status um_variant_accuracy_measure(struct um_context *context,
                                           const struct um_variant_curves *curves, double share,
                                           struct um_variant *variant,
                                           struct um_variant_accuracy *accuracy);

#endif
