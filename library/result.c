/* Results: arrays by name, files, the end. */
#include "library/result_impl.h"

#include <string.h>

enum um_status um_library_result_create(struct um_context *context, struct umbra *session,
                                        const struct um_library_kind *kind, void *work,
                                        struct umbra_result **out)
{
  UM_TRY(um_core_allocate(context, 1, sizeof **out, out));
  (*out)->session = um_library_session_share(session);
  (*out)->kind = kind;
  (*out)->work = work;
  return UM_OK;
}

enum um_status um_library_result_show(struct um_context *context, struct umbra_result *result,
                                      const struct umbra_array *array)
{
  if (array->data == NULL) return UM_OK;
  UM_TRY(um_core_reallocate(context, result->narray + 1, sizeof *array, &result->array));
  struct umbra_array *to = &result->array[result->narray++];
  *to = *array;
  while (to->dimensions < 4 && to->axis[to->dimensions] != NULL) to->dimensions++;
  return UM_OK;
}

enum um_status um_library_result_make(struct um_context *context, struct umbra_result *result,
                                      struct umbra_array array, const char *name, const char *unit,
                                      double **data)
{
  size_t n = 1;
  for (size_t i = 0; i < 4 && array.axis[i] != NULL; i++) n *= array.shape[i];
  UM_TRY(um_core_reallocate(context, result->nowned + 1, sizeof *data, &result->owned));
  UM_TRY(um_core_allocate(context, n, sizeof **data, data));
  result->owned[result->nowned++] = *data;
  array.name = name;
  array.unit = unit;
  array.data = *data;
  return um_library_result_show(context, result, &array);
}

const struct umbra_array *umbra_result_array(const struct umbra_result *result, const char *name)
{
  for (size_t i = 0; i < result->narray; i++)
    if (strcmp(result->array[i].name, name) == 0) return &result->array[i];
  return NULL;
}

const struct umbra_array *umbra_result_array_at(const struct umbra_result *result, size_t index)
{
  return index < result->narray ? &result->array[index] : NULL;
}

enum umbra_status umbra_result_write(struct umbra *umbra, const struct umbra_result *result,
                                     const char *folder, const struct umbra_write *write)
{
  struct um_context *context = um_library_begin(umbra);
  struct um_core_folder *made = NULL;
  struct umbra_write how = UMBRA_WRITE;
  enum um_status status;
  if (write != NULL) {
    UM_CHECK(um_library_check_size(context, "struct umbra_write", write->size, sizeof *write));
    how = *write;
  }
  if (how.command == NULL) how.command = "libumbra";
  UM_CHECK(um_core_folder_begin(context, folder, how.force != 0, &made));
  UM_CHECK(result->kind->write(context, result, &how, made));
  UM_CHECK(um_core_folder_commit(context, &made));
done:
  um_core_folder_abort(&made);
  return um_library_status(status);
}

void umbra_result_close(struct umbra_result **result)
{
  if (result == NULL || *result == NULL) return;
  struct umbra_result *r = *result;
  struct umbra *session = r->session;
  struct um_context *context = session->context;
  if (r->work != NULL) r->kind->release(context, r->work);
  for (size_t i = 0; i < r->nowned; i++) um_core_free(context, r->owned[i]);
  UM_FREE(context, r->owned, (void *)r->citation.sentence, (void *)r->citation.bibtex, r->array, r);
  *result = NULL;
  um_library_session_drop(&session);
}
