/* A scenario as a caller has it: text and changes. */
#include "library/source_impl.h"

enum um_status um_library_source_add_override(struct um_context *context,
                                              struct um_library_source *source, const char *text)
{
  UM_TRY(um_core_reallocate(context, source->noverride + 1, sizeof *source->override,
                            &source->override));
  UM_TRY(um_core_strdup(context, text, &source->override[source->noverride]));
  source->noverride++;
  return UM_OK;
}

void um_library_source_drop_override(struct um_context *context, struct um_library_source *source)
{
  um_core_free(context, source->override[--source->noverride]);
}

static void change_release(struct um_context *context, struct um_model_change *change)
{
  for (size_t p = 0; change->parameter != NULL && p < change->nparameter; p++)
    um_core_free(context, (void *)change->parameter[p]);
  UM_FREE(context, (void *)change->parameter, (void *)change->value, (void *)change->effect,
          (void *)change->target);
}

static enum um_status copy_text(struct um_context *context, const char *text, const char **out)
{
  char *copy = NULL;
  if (text != NULL) UM_TRY(um_core_strdup(context, text, &copy));
  *out = copy;
  return UM_OK;
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

enum um_status um_library_source_copy(struct um_context *context,
                                      const struct um_library_source *source,
                                      struct um_library_source *out)
{
  *out = (struct um_library_source){0};
  UM_TRY(um_core_strdup(context, source->path, &out->path));
  UM_TRY(um_core_strdup(context, source->text, &out->text));
  for (size_t i = 0; i < source->noverride; i++)
    UM_TRY(um_library_source_add_override(context, out, source->override[i]));
  for (size_t i = 0; i < source->nchange; i++)
    UM_TRY(um_library_source_add_change(context, out, &source->change[i]));
  return UM_OK;
}

void um_library_source_release(struct um_context *context, struct um_library_source *source)
{
  while (source->noverride > 0) um_library_source_drop_override(context, source);
  for (size_t i = 0; i < source->nchange; i++) change_release(context, &source->change[i]);
  UM_FREE(context, source->override, source->change, source->path, source->text);
  *source = (struct um_library_source){0};
}

struct um_model_options um_library_source_options(const struct um_library_source *source)
{
  return (struct um_model_options){.text = source->text,
                                   .overrides = (const char *const *)source->override,
                                   .noverride = source->noverride,
                                   .change = source->change,
                                   .nchange = source->nchange};
}
