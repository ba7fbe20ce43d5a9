/* A point of a study, exactly: geometry and heat are shared where they are the same number for
 * number. Heat starts from the periodic state of the scenario as it stands, never from another
 * point, so that a point has the same bits in any order and process.
 */
#include "study/study_impl.h"

enum um_status um_study_open(struct um_context *context, const struct um_study *study,
                             const struct um_study_binding *binding, size_t nbinding,
                             const double *value, struct um_variant *out)
{
  struct um_study_changes changes = {0};
  *out = (struct um_variant){0};
  enum um_status status =
      um_study_changes_make(context, study->model, binding, nbinding, value, &changes);
  if (status == UM_OK) status = um_variant_open(context, study->evaluator, &changes.all, NULL, out);
  um_study_changes_clear(context, &changes);
  return status;
}

enum um_status um_study_point(struct um_context *context, void *user, const double *parameter,
                              double *value)
{
  struct um_study *study = user;
  struct um_variant v;
  enum um_status status =
      um_study_open(context, study, study->binding, study->nbinding, parameter, &v);
  if (status == UM_OK)
    status = um_variant_values(context, &study->curves, &study->accuracy, &v, value);
  um_variant_close(context, &v);
  return status;
}
