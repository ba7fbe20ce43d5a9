/* Tolerances are measured, not guessed: a variant far from the scenario is computed both ways. */
#include "variant/accuracy.h"

#include <math.h>

#include "variant/tolerance_impl.h"

/* Of the bias that is corrected in a variant, left elsewhere than where it is measured. */
#define SHARE_LEFT 0.2

void um_variant_accuracy_release(struct um_context *context, struct um_variant_accuracy *accuracy)
{
  um_core_free(context, accuracy->bias);
  um_core_free(context, accuracy->correction);
  um_core_free(context, accuracy->error);
}

/* Largest difference of one curve's values. */
static double curve_difference(const struct um_variant_curve *curve, const double *a,
                               const double *b)
{
  double largest = 0.0;
  for (size_t k = 0; k < curve->count; k++) {
    double unit = curve->relative ? fmax(fabs(b[k]), curve->floor) : 1.0;
    if (isnan(a[k]) && isnan(b[k])) continue;
    double difference = fabs(a[k] - b[k]);
    if (difference == 0.0) continue; /* where nothing shines, unit may be 0 */
    largest = isnan(difference) ? (double)INFINITY : fmax(largest, difference / unit);
  }
  return largest;
}

void um_variant_differences(const struct um_variant_curves *curves, const double *a,
                            const double *b, double *largest)
{
  for (size_t q = 0, at = 0; q < curves->ncurve; at += curves->curve[q++].count)
    largest[q] = curve_difference(&curves->curve[q], a + at, b + at);
}

/* Light and temperatures of a variant with heat, into value. */
static enum um_status observe(struct um_context *context, const struct um_variant_curves *curves,
                              const struct um_variant *v, double *value)
{
  struct um_model_result *result = NULL;
  UM_TRY(um_variant_observe(context, curves->evaluator, v, &result));
  enum um_status status = curves->take(context, curves->user, v->model, result, value);
  um_model_result_destroy(context, &result);
  return status;
}

static struct um_variant_heat heat_of(struct um_variant_tolerance tolerance)
{
  return (struct um_variant_heat){.start = UM_VARIANT_WARM, .tolerance = tolerance};
}

static void correct(const struct um_variant_curves *curves, const double *correction, double *value)
{
  for (size_t q = 0, at = 0; q < curves->ncurve; q++)
    for (size_t k = 0; k < curves->curve[q].count; k++, at++)
      if (curves->curve[q].relative)
        value[at] *= correction[at];
      else
        value[at] += correction[at];
}

enum um_status um_variant_values(struct um_context *context, const struct um_variant_curves *curves,
                                 const struct um_variant_accuracy *accuracy,
                                 struct um_variant *variant, double *value)
{
  bool tight = accuracy == NULL;
  const struct um_variant_heat how = heat_of(tight ? UM_VARIANT_TIGHT : accuracy->tolerance);
  if (tight)
    UM_TRY(um_variant_heat_again(context, curves->evaluator, &how, variant));
  else
    UM_TRY(um_variant_find_heat(context, curves->evaluator, &how, variant));
  UM_TRY(observe(context, curves, variant, value));
  if (!tight && accuracy->correction != NULL && variant->fresh_heat &&
      variant->tables == curves->base->tables)
    correct(curves, accuracy->correction, value);
  return UM_OK;
}

enum um_status um_variant_accuracy_bias(struct um_context *context,
                                        const struct um_variant_curves *curves,
                                        struct um_variant_accuracy *accuracy)
{
  enum um_status status;
  const struct um_variant_heat how = heat_of(accuracy->tolerance);
  struct um_variant v = *curves->base;
  double *loose = NULL;
  if (accuracy->correction == NULL) {
    UM_TRY(um_core_allocate(context, curves->ncurve, sizeof(double), &accuracy->bias));
    UM_TRY(um_core_allocate(context, curves->nvalue, sizeof(double), &accuracy->correction));
  }
  UM_TRY(um_core_allocate(context, curves->nvalue, sizeof *loose, &loose));
  UM_CHECK(um_variant_heat_again(context, curves->evaluator, &how, &v));
  UM_CHECK(observe(context, curves, &v, loose));
  for (size_t q = 0, at = 0; q < curves->ncurve; q++)
    for (size_t k = 0; k < curves->curve[q].count; k++, at++) {
      double exact = curves->nominal[at], difference = exact - loose[at];
      if (curves->curve[q].relative)
        accuracy->correction[at] = exact > 0.0 && loose[at] > 0.0 ? exact / loose[at] : 1.0;
      else
        accuracy->correction[at] = isfinite(difference) ? difference : 0.0;
    }
  um_variant_differences(curves, loose, curves->nominal, accuracy->bias);
done:
  um_variant_close(context, &v);
  um_core_free(context, loose);
  return status;
}

/* What the tolerance leaves of a variant whose values with the scenario's own are own[nvalue];
 * value [nvalue] is scratch. */
static enum um_status leaves(struct um_context *context, const struct um_variant_curves *curves,
                             struct um_variant *variant, const double *own, double *value,
                             struct um_variant_accuracy *accuracy)
{
  UM_TRY(um_variant_accuracy_bias(context, curves, accuracy));
  UM_TRY(um_variant_values(context, curves, accuracy, variant, value));
  um_variant_differences(curves, value, own, accuracy->error);
  for (size_t q = 0; q < curves->ncurve; q++) accuracy->error[q] += SHARE_LEFT * accuracy->bias[q];
  return UM_OK;
}

static bool good_enough(const struct um_variant_curves *curves, double share, const double *error)
{
  for (size_t q = 0; q < curves->ncurve; q++)
    if (!(error[q] <= share * curves->curve[q].asked)) return false;
  return true;
}

enum um_status um_variant_accuracy_measure(struct um_context *context,
                                           const struct um_variant_curves *curves, double share,
                                           struct um_variant *variant,
                                           struct um_variant_accuracy *accuracy)
{
  enum um_status status;
  double *value = NULL;
  UM_TRY(um_core_allocate(context, 2 * curves->nvalue, sizeof *value, &value));
  if (accuracy->error == NULL)
    UM_CHECK(um_core_allocate(context, curves->ncurve, sizeof(double), &accuracy->error));
  double *own = value + curves->nvalue;
  UM_CHECK(um_variant_values(context, curves, NULL, variant, own));
  for (size_t i = 0; i < UM_VARIANT_CHOICES; i++) {
    accuracy->tolerance = um_variant_tolerance_choices[i].tolerance;
    status = leaves(context, curves, variant, own, value, accuracy);
    if (status == UM_ERR_NUMERIC && i + 1 < UM_VARIANT_CHOICES) {
      um_core_message_clear(context); /* too loose to find a state that repeats */
      continue;
    }
    UM_CHECK(status);
    if (good_enough(curves, share, accuracy->error)) break;
  }
done:
  um_core_free(context, value);
  return status;
}
