/* A parameter of a study or of a forecast: its name, its distribution, and what a value does to the
 * scenario. */
#ifndef UMBRA_STUDY_PARAMETER_H
#define UMBRA_STUDY_PARAMETER_H

#include "base/uncertainty/distribution.h"
#include "model/build/model.h"
#include "study/file.h"

/* What a value becomes: that of a key, or of an effect's parameter. */
struct um_study_binding {
  const struct um_study_file_parameter *file;
  struct um_uncertainty_distribution distribution;
  char name[UM_STUDY_NAME];
  const char *unit;               /* "" where none is known */
  const struct um_effect *effect; /* NULL: of file->key */
  const char *target;             /* of the effect; NULL: none */
  size_t which;                   /* its parameter */
  double of_record;               /* of a material: the property that its record has; else NaN */
  double nominal;                 /* value that the scenario has; NaN: unknown */
};
/* Against the scenario as it stands; a parameter that was not read from a file has a mark of line
 * 0, whose `file` says where it came from. UM_ERR_INPUT with file and line of the study: no such
 * material, effect, parameter or target. */
enum um_status um_study_binding_find(struct um_context *context, const struct um_model *model,
                                     const struct um_study_file_parameter *parameter,
                                     struct um_study_binding *out);
/* UM_ERR_INPUT likewise: the ends of its distribution lie where the effect, or a property, has no
 * values. */
enum um_status um_study_binding_check_ends(struct um_context *context,
                                           const struct um_study_binding *binding);
/* Have two models the same value of the effect's parameter? True of a key. */
bool um_study_binding_same(const struct um_study_binding *binding, const struct um_model *a,
                           const struct um_model *b);

/* --- twice.c --- */
/* UM_ERR_INPUT with both names and lines: two bindings to one place of the scenario, or to one
 * parameter of an effect; a key that contains another. */
enum um_status um_study_bindings_check(struct um_context *context, const struct um_model *model,
                                       const struct um_study_binding *binding, size_t nbinding);
/* The same of what only shows in `moved`, the model with binding `at` alone away from the scenario:
 * it moves what another binding states. */
enum um_status um_study_bindings_check_moved(struct um_context *context,
                                             const struct um_model *model,
                                             const struct um_model *moved,
                                             const struct um_study_binding *binding,
                                             size_t nbinding, size_t at);

/* Changes of the scenario at parameter values. */
struct um_study_changes {
  struct um_document_change *key;     /* owned */
  struct um_model_addition *addition; /* owned */
  struct um_model_changes all;
};
/* binding, value: [nbinding], borrowed while the changes are used. UM_ERR_MEMORY. Cleared by the
 * caller, after a failure too. */
enum um_status um_study_changes_make(struct um_context *context, const struct um_model *nominal,
                                     const struct um_study_binding *binding, size_t nbinding,
                                     const double *value, struct um_study_changes *out);
void um_study_changes_clear(struct um_context *context, struct um_study_changes *changes);

#endif
