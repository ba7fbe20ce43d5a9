/* Tolerances of the points' heat, measured at the upper ends of all ranges (variant/accuracy.h). */
#include <math.h>

#include "study/study_impl.h"

/* Of the asked error that tolerances may use up at the place where they are measured. A surrogate
 * takes what is left of them from point to point for structure, and wants more points for it than
 * tighter tolerances cost; it then states the rest at most. */
#define SHARE 0.5

/* Upper ends of all that leaves the geometry as it is. *n 0: there is none. */
static enum um_status corner_open(struct um_context *context, const struct um_study *study,
                                  struct um_variant *out)
{
  enum um_status status;
  struct um_study_binding *binding = NULL;
  double *value = NULL, least;
  size_t n = 0;
  UM_CHECK(um_core_allocate(context, study->nbinding, sizeof *binding, &binding));
  UM_CHECK(um_core_allocate(context, study->nbinding, sizeof *value, &value));
  for (size_t i = 0; i < study->nbinding; i++) {
    if (study->moves_geometry[i]) continue;
    binding[n] = study->binding[i];
    um_uncertainty_distribution_ends(&binding[n].distribution, &least, &value[n]);
    n++;
  }
  UM_CHECK(um_study_open(context, study, binding, n, value, out));
done:
  um_core_free(context, binding);
  um_core_free(context, value);
  return status;
}

/* Does anything need heat of its own? */
static bool any_heat(const struct um_study *study)
{
  for (size_t i = 0; i < study->nbinding; i++)
    if (study->moves_heat[i]) return true;
  return false;
}

enum um_status um_study_tolerance(struct um_context *context, struct um_study *study)
{
  enum um_status status = UM_OK;
  const struct um_variant_error any = {INFINITY, INFINITY, INFINITY};
  double share = study->file->mode == UM_STUDY_SURROGATE ? UM_STUDY_SHARE_SURROGATE : SHARE;
  struct um_variant corner = {0};
  study->accuracy.tolerance = um_variant_tolerance_asked(&any, NULL);
  if (!any_heat(study)) return UM_OK;
  UM_CHECK(corner_open(context, study, &corner));
  /* what two parameters do together may need another geometry though neither does alone */
  if (corner.tables != study->base.tables)
    study->accuracy.tolerance = UM_VARIANT_TIGHT;
  else
    UM_CHECK(
        um_variant_accuracy_measure(context, &study->curves, share, &corner, &study->accuracy));
done:
  um_variant_close(context, &corner);
  return status;
}
