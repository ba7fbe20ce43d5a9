/* Which points of a design are solved first where not all of them are. */
#include "base/core/sampling.h"
#include "base/core/sort.h"
#include "study/study_impl.h"

struct drawn {
  uint64_t key;
  size_t point;
};

static int compare(const void *a, const void *b)
{
  const struct drawn *x = a, *y = b;
  if (x->key != y->key) return x->key < y->key ? -1 : 1;
  return (x->point > y->point) - (x->point < y->point);
}

enum um_status um_study_order(struct um_context *context, const struct um_study *study,
                              size_t npoint, size_t *out)
{
  struct drawn *drawn = NULL;
  uint64_t seed = (uint64_t)study->file->design->seed;
  bool as_it_is = study->file->design->kind == UM_STUDY_SOBOL;
  UM_TRY(um_core_allocate(context, npoint, sizeof *drawn, &drawn));
  for (size_t i = 0; i < npoint; i++)
    drawn[i] = (struct drawn){as_it_is ? 0 : um_core_hash(seed, i), i};
  enum um_status status = um_core_sort(context, drawn, npoint, sizeof *drawn, compare);
  for (size_t i = 0; i < npoint && status == UM_OK; i++) out[i] = drawn[i].point;
  um_core_free(context, drawn);
  return status;
}
