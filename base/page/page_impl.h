/* A page in the making. Private to base/page/. */
#ifndef UMBRA_PAGE_PAGE_IMPL_H
#define UMBRA_PAGE_PAGE_IMPL_H

#include "base/page/page.h"

/* Text that grows. */
struct um_page_text {
  FILE *file;
  char *text;
  size_t length;
};
enum um_page_state { UM_PAGE_NO_SECTION, UM_PAGE_TEXTS, UM_PAGE_FIGURES };

struct um_page {
  char *command, *kind, *title, *token;
  struct um_page_text lead, facts, sections, scene, arrays; /* JSON */
  struct um_page_text numbers;                              /* bytes */
  struct um_page_text plain_lead, plain_facts, plain;       /* HTML, where there is no viewer */
  size_t nlead, nfact, nsection, ntext, nfigure, narray;
  enum um_page_state state;
};

/* The viewer: script, style and what the page's policy says of them. Empty where it was not built.
 */
extern const unsigned char um_page_viewer_js[], um_page_viewer_css[];
extern const size_t um_page_viewer_js_length, um_page_viewer_css_length;
extern const char um_page_viewer_js_hash[], um_page_viewer_css_hash[]; /* "sha256-..." */

/* Each puts an array behind the others and writes its number. */
void um_page_put_doubles(struct um_page *page, FILE *file, const double *value, size_t count);
void um_page_put_floats(struct um_page *page, FILE *file, const double *value, size_t count);
void um_page_put_integers(struct um_page *page, FILE *file, const uint32_t *value, size_t count);
/* In 65535 steps of their range. */
void um_page_put_steps(struct um_page *page, FILE *file, const double *value, size_t count);

/* "," before all but the first; begin of a figure: what each has. */
FILE *um_page_figure_begin(struct um_page *page, const struct um_page_figure *figure,
                           const char *kind);
void um_page_put_axis(struct um_page *page, FILE *file, const char *key,
                      const struct um_page_axis *axis); /* , "key": {...} */
void um_page_put_shade(FILE *file, const struct um_page_shade *shade, size_t nshade);
void um_page_key(FILE *file, const char *key, const char *text); /* , "key": "text" */

/* HTML of a page without viewer. */
void um_page_plain_text(FILE *file, const char *text); /* &, <, > and quotes as entities */
void um_page_plain_picture(FILE *file, const char *path);
void um_page_plain_begin(struct um_page *page, const struct um_page_figure *figure);
void um_page_plain_head(struct um_page *page, const char *name, const char *unit);
void um_page_plain_row(struct um_page *page);
void um_page_plain_cell(struct um_page *page, const char *text, double value);
void um_page_plain_end(struct um_page *page);

/* The head of a page of that title, its policy and its style; the viewer's script. served: it may
 * ask where it comes from. */
void um_page_put_head(const char *title, bool served, FILE *file);
void um_page_put_viewer(FILE *file);
/* End a text that is JSON, and put it where a script element stands; it is released. */
void um_page_text_put_json(struct um_page_text *text, FILE *file);

/* A zlib stream of the bytes as base64. UM_ERR_MEMORY, UM_ERR_LIBRARY. */
enum um_status um_page_write_packed(struct um_context *context, const char *bytes, size_t n,
                                    FILE *file);

#endif
