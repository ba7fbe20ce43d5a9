/* Merge sort (Knuth 1998, The Art of Computer Programming 3, 5.2.4): runs by qsort, merged two by
 * two. The runs are short enough for the stop to be looked at between them. */
#include "base/core/sort.h"

#include <stdlib.h>
#include <string.h>

#define RUN ((size_t)1 << 17)

/* from[begin, middle) and from[middle, end) into `to` at the same place; the left one first where
 * they are equal. */
static void merge(const char *from, char *to, size_t begin, size_t middle, size_t end, size_t size,
                  int (*compare)(const void *, const void *))
{
  size_t a = begin, b = middle;
  for (size_t i = begin; i < end; i++) {
    bool left = a < middle && (b == end || compare(from + a * size, from + b * size) <= 0);
    memcpy(to + i * size, from + (left ? a : b) * size, size);
    if (left)
      a++;
    else
      b++;
  }
}

enum um_status um_core_sort(struct um_context *context, void *base, size_t count, size_t size,
                            int (*compare)(const void *, const void *))
{
  static const char doing[] = "a long list was sorted";
  enum um_status status = UM_OK;
  char *work = NULL, *from = base, *to;
  for (size_t i = 0; i < count; i += RUN) {
    UM_TRY(um_core_stop_check(context, doing));
    qsort(from + i * size, count - i < RUN ? count - i : RUN, size, compare);
  }
  if (count <= RUN) return UM_OK;
  UM_TRY(um_core_allocate(context, count, size, &work));
  to = work;
  for (size_t width = RUN; width < count; width *= 2) {
    for (size_t i = 0; i < count; i += 2 * width) {
      size_t middle = count - i < width ? count : i + width;
      size_t end = count - i < 2 * width ? count : i + 2 * width;
      UM_CHECK(um_core_stop_check(context, doing));
      merge(from, to, i, middle, end, size, compare);
    }
    char *swap = from;
    from = to;
    to = swap;
  }
  if (from != base) memcpy(base, from, count * size);
done:
  um_core_free(context, work);
  return status;
}
