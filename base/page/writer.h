/* Writing a page in one call, and what every room that writes one needs on the way: memory that
 * lasts as long as the page is made, and the Earth's shadow behind curves over time. */
#ifndef UMBRA_PAGE_WRITER_H
#define UMBRA_PAGE_WRITER_H

#include "base/core/arena.h"
#include "base/page/page.h"

struct um_page_writer {
  struct um_context *context;
  struct um_page *page;
  struct um_core_arena memory; /* given back once the page is written */
  const char *folder;          /* in the making; NULL: there is none */
  struct um_page_axis time;    /* um_page_writer_times */
  struct um_page_shade *shade; /* [nshade] */
  size_t nshade;
};

/* Put lead, facts, sections and figures of what `of` points to on w->page. */
typedef enum um_status um_page_fill(struct um_page_writer *w, const void *of);

/* A page of that head, filled, as report.html of a folder in the making. Errors of `fill`;
 * UM_ERR_IO, UM_ERR_MEMORY, UM_ERR_LIBRARY. */
enum um_status um_page_report(struct um_context *context, const struct um_page_head *head,
                              um_page_fill *fill, const void *of, struct um_core_folder *folder);
/* The same into a stream, of whose errors the caller looks. */
enum um_status um_page_put(struct um_context *context, const struct um_page_head *head,
                           um_page_fill *fill, const void *of, FILE *file);

/* um_page_picture of that file of the folder. */
void um_page_writer_picture(struct um_page_writer *w, const char *name);

/* n zeroed things of the kind that *out points to, of the writer's memory. UM_ERR_MEMORY. */
#define UM_PAGE_ROOM(w, n, out)                                                                    \
  um_core_arena_allocate((w)->context, &(w)->memory, n, sizeof **(out), out)
/* A text, whole, of the writer's memory. UM_ERR_MEMORY. */
enum um_status um_page_words(struct um_page_writer *w, const char **out, const char *format, ...)
    UM_PRINTF(3, 4);

/* The runs of umbra and penumbra as the writer's shades. t: rising, on the axis of the curves;
 * sunlit: fraction of the Sun's disc, NULL: nothing is known; both [n]. UM_ERR_MEMORY. */
enum um_status um_page_writer_shade(struct um_page_writer *w, size_t n, const double *t,
                                    const double *sunlit);
/* The writer's axis of time, seconds since 1970, UTC, and its shades. t is the caller's. */
enum um_status um_page_writer_times(struct um_page_writer *w, size_t n, const double *t,
                                    const double *sunlit);

#endif
