/* Which stages of a run depend on which parameter: each is tried at both ends of its range, and
 * what is built from it is compared, number for number. */
#include <string.h>

#include "study/study_impl.h"

/* The scenario with one parameter at one end, and what of its own holds there. */
struct end {
  struct um_variant variant;
  bool geometry, heat; /* compatible; heat: where the geometry is */
};

static enum um_status try_end(struct um_context *context, const struct um_study *study, size_t i,
                              double value, struct end *end)
{
  const struct um_mark *at = &study->binding[i].file->at;
  struct um_variant *v = &end->variant;
  enum um_status status = um_study_open(context, study, &study->binding[i], 1, &value, v);
  if (status == UM_ERR_INPUT || status == UM_ERR_REFUSED) {
    um_core_message_prefix(context, "%s:%d: %s: '%s' at %.10g", at->file, at->line, at->path,
                           study->binding[i].name, value);
    return UM_ERR_INPUT;
  }
  UM_TRY(status);
  UM_TRY(um_study_bindings_check_moved(context, study->model, v->model, study->binding,
                                       study->nbinding, i));
  end->geometry = v->tables == study->base.tables;
  if (!end->geometry) return UM_OK;
  return um_model_thermal_solution_is_compatible(context, study->base.heat, v->model, v->tables,
                                                 &end->heat);
}

/* Same geometry and same heat: does the light differ? */
static enum um_status check_light(struct um_context *context, const struct um_study *study,
                                  size_t i, struct end *end)
{
  enum um_status status;
  double *value = NULL;
  const struct um_mark *at = &study->binding[i].file->at;
  UM_TRY(um_core_allocate(context, 2 * study->nvalue, sizeof *value, &value));
  for (int e = 0; e < 2; e++)
    UM_CHECK(um_variant_values(context, &study->curves, &study->accuracy, &end[e].variant,
                               value + (size_t)e * study->nvalue));
  if (memcmp(value, value + study->nvalue, study->nvalue * sizeof *value) == 0)
    status = um_document_mark_fail(
        context, at,
        "'%s' changes nothing of what is asked; accepted: a parameter that does, or other outputs",
        study->binding[i].name);
done:
  um_core_free(context, value);
  return status;
}

enum um_status um_study_dependencies_find(struct um_context *context, struct um_study *study)
{
  UM_TRY(um_core_allocate(context, study->nbinding, sizeof *study->moves_geometry,
                          &study->moves_geometry));
  UM_TRY(um_core_allocate(context, study->nbinding, sizeof *study->moves_heat, &study->moves_heat));
  for (size_t i = 0; i < study->nbinding; i++) {
    struct end end[2] = {{.geometry = false}, {.geometry = false}};
    double value[2];
    enum um_status status = UM_OK;
    um_uncertainty_distribution_ends(&study->binding[i].distribution, &value[0], &value[1]);
    for (int e = 0; e < 2 && status == UM_OK; e++)
      status = try_end(context, study, i, value[e], &end[e]);
    study->moves_geometry[i] = !(end[0].geometry && end[1].geometry);
    study->moves_heat[i] = !(end[0].heat && end[1].heat);
    if (status == UM_OK && !study->moves_geometry[i] && !study->moves_heat[i])
      status = check_light(context, study, i, end);
    um_variant_close(context, &end[0].variant);
    um_variant_close(context, &end[1].variant);
    UM_TRY(status);
  }
  return UM_OK;
}
