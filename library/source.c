/* A scenario as a caller has it: text and changes. */
#include "library/source_impl.h"

static enum um_status copy_text(struct um_context *context, const char *text, const char **out)
{
  char *copy = NULL;
  if (text != NULL) UM_TRY(um_core_strdup(context, text, &copy));
  *out = copy;
  return UM_OK;
}

enum um_status um_library_source_add_set(struct um_context *context,
                                         struct um_library_source *source,
                                         const struct um_document_change *set)
{
  UM_TRY(um_core_reallocate(context, source->nset + 1, sizeof *source->set, &source->set));
  struct um_document_change *to = &source->set[source->nset++];
  *to = *set;
  to->key = to->text = NULL;
  enum um_status status = copy_text(context, set->key, &to->key);
  if (status == UM_OK) status = copy_text(context, set->text, &to->text);
  if (status != UM_OK) um_library_source_drop_set(context, source);
  return status;
}

void um_library_source_drop_set(struct um_context *context, struct um_library_source *source)
{
  const struct um_document_change *last = &source->set[--source->nset];
  UM_FREE(context, (void *)last->key, (void *)last->text);
}

static void change_release(struct um_context *context, struct um_model_change *change)
{
  for (size_t p = 0; change->parameter != NULL && p < change->nparameter; p++)
    um_core_free(context, (void *)change->parameter[p]);
  UM_FREE(context, (void *)change->parameter, (void *)change->value, (void *)change->effect,
          (void *)change->target);
}

/* to: all zero before; released by the caller after a failure. */
static enum um_status change_copy(struct um_context *context, const struct um_model_change *from,
                                  struct um_model_change *to)
{
  const char **name = NULL;
  double *value = NULL;
  to->off = from->off;
  UM_TRY(copy_text(context, from->effect, &to->effect));
  UM_TRY(copy_text(context, from->target, &to->target));
  UM_TRY(um_core_allocate(context, from->nparameter, sizeof *value, &value));
  to->value = value;
  UM_TRY(um_core_allocate(context, from->nparameter, sizeof *name, &name));
  to->parameter = name;
  to->nparameter = from->nparameter;
  for (size_t p = 0; p < from->nparameter; p++) {
    value[p] = from->value[p];
    UM_TRY(copy_text(context, from->parameter[p], &name[p]));
  }
  return UM_OK;
}

enum um_status um_library_source_add_change(struct um_context *context,
                                            struct um_library_source *source,
                                            const struct um_model_change *change)
{
  struct um_model_change copy = {0};
  enum um_status status;
  UM_CHECK(um_core_reallocate(context, source->nchange + 1, sizeof copy, &source->change));
  UM_CHECK(change_copy(context, change, &copy));
  source->change[source->nchange++] = copy;
done:
  if (status != UM_OK) change_release(context, &copy);
  return status;
}

void um_library_source_drop_change(struct um_context *context, struct um_library_source *source)
{
  change_release(context, &source->change[--source->nchange]);
}

enum um_status um_library_source_copy(struct um_context *context,
                                      const struct um_library_source *source,
                                      struct um_library_source *out)
{
  *out = (struct um_library_source){0};
  UM_TRY(um_core_strdup(context, source->path, &out->path));
  UM_TRY(um_core_strdup(context, source->text, &out->text));
  for (size_t i = 0; i < source->nset; i++)
    UM_TRY(um_library_source_add_set(context, out, &source->set[i]));
  for (size_t i = 0; i < source->nchange; i++)
    UM_TRY(um_library_source_add_change(context, out, &source->change[i]));
  return UM_OK;
}

void um_library_source_release(struct um_context *context, struct um_library_source *source)
{
  while (source->nset > 0) um_library_source_drop_set(context, source);
  while (source->nchange > 0) um_library_source_drop_change(context, source);
  UM_FREE(context, source->set, source->change, source->path, source->text);
  *source = (struct um_library_source){0};
}

struct um_model_options um_library_source_options(const struct um_library_source *source,
                                                  const struct umbra *umbra)
{
  return (struct um_model_options){.text = source->text,
                                   .set = source->set,
                                   .nset = source->nset,
                                   .effect_files = umbra->effect_file,
                                   .neffect_file = umbra->neffect_file,
                                   .change = source->change,
                                   .nchange = source->nchange};
}
