/* Pages beside each other: what several said, in one page. */
#ifndef UMBRA_PAGE_BESIDE_H
#define UMBRA_PAGE_BESIDE_H

#include <stdio.h>

#include "base/core/context.h"

/* A page of the documents of other pages, written by this program's viewer: path[n] their files,
 * name[n] what they are called. Curves of the same figure and panel stand beside each other; the
 * rest is that of the first. UM_ERR_IO; UM_ERR_INPUT: a file that is no page of this form (named);
 * UM_ERR_MEMORY. The caller looks for errors of the stream. */
enum um_status um_page_write_beside(struct um_context *context, size_t n, const char *const *path,
                                    const char *const *name, FILE *file);

#endif
