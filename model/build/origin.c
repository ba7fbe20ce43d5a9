/* What a variant has from its origin: each builder names the keys that it reads. */
#include "model/build/steps_impl.h"

bool um_model_origin_says(const struct um_model *model, const char *const *paths)
{
  if (model->origin == NULL) return false;
  for (; *paths != NULL; paths++)
    if (!um_document_same(model->document, model->origin->document, *paths)) return false;
  return true;
}
