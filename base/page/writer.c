/* A page from its head to its file. */
#include "base/page/writer.h"

#include <stdarg.h>
#include <string.h>

#include "base/core/replay.h"
#include "base/plot/plot.h"

/* Into the folder, or where there is none into the file. */
static enum um_status make(struct um_context *context, const struct um_page_head *head,
                           um_page_fill *fill, const void *of, struct um_core_folder *folder,
                           FILE *file)
{
  enum um_status status;
  struct um_page_writer w = {.context = context,
                             .folder = folder != NULL ? um_core_folder_path(folder) : NULL};
  struct um_page_head typed = *head;
  if (um_core_replay_command(context) != NULL) typed.command = um_core_replay_command(context);
  UM_CHECK(um_page_create(context, &typed, &w.page));
  UM_CHECK(fill(&w, of));
  status = folder != NULL ? um_page_write_report(context, w.page, folder)
                          : um_page_write(context, w.page, file);
done:
  um_page_destroy(context, &w.page);
  um_core_arena_release(context, &w.memory);
  return status;
}

enum um_status um_page_report(struct um_context *context, const struct um_page_head *head,
                              um_page_fill *fill, const void *of, struct um_core_folder *folder)
{
  return make(context, head, fill, of, folder, NULL);
}

enum um_status um_page_put(struct um_context *context, const struct um_page_head *head,
                           um_page_fill *fill, const void *of, FILE *file)
{
  return make(context, head, fill, of, NULL, file);
}

void um_page_writer_picture(struct um_page_writer *w, const char *name)
{
  char path[4096];
  int n = w->folder != NULL ? snprintf(path, sizeof path, "%s/%s", w->folder, name) : 0;
  if (n > 0 && (size_t)n < sizeof path) um_page_picture(w->page, path);
}

enum um_status um_page_words(struct um_page_writer *w, const char **out, const char *format, ...)
{
  va_list values;
  char *text = NULL;
  va_start(values, format);
  int n = vsnprintf(NULL, 0, format, values);
  va_end(values);
  *out = NULL;
  if (n < 0) return um_core_fail(w->context, UM_ERR_MEMORY, "a page: out of memory");
  UM_TRY(UM_PAGE_ROOM(w, (size_t)n + 1, &text));
  va_start(values, format);
  (void)vsnprintf(text, (size_t)n + 1, format, values);
  va_end(values);
  *out = text;
  return UM_OK;
}

enum um_status um_page_writer_shade(struct um_page_writer *w, size_t n, const double *t,
                                    const double *sunlit)
{
  struct um_plot_shadow shadow;
  w->nshade = 0;
  UM_TRY(UM_PAGE_ROOM(w, n, &w->shade));
  for (size_t k = 0; sunlit != NULL && um_plot_shadow_next(n, t, sunlit, &k, &shadow);)
    w->shade[w->nshade++] =
        (struct um_page_shade){shadow.from, shadow.to, shadow.umbra ? "umbra" : "penumbra"};
  return UM_OK;
}

enum um_status um_page_writer_times(struct um_page_writer *w, size_t n, const double *t,
                                    const double *sunlit)
{
  w->time = (struct um_page_axis){"time", "UTC", UM_PAGE_TIME, t, n};
  return um_page_writer_shade(w, n, t, sunlit);
}
