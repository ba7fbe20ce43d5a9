/* Pages beside each other. A page carries its document and its numbers in two elements of script
 * that no text can end; they are taken over as they stand. */
#include "base/page/beside.h"

#include <string.h>

#include "base/core/file.h"
#include "base/core/json.h"
#include "base/page/page_impl.h"

#define LIMIT    268435456 /* [bytes] of a page */
#define DOCUMENT "<script type=\"application/json\" id=\"umbra-document\">"
#define NUMBERS  "<script type=\"text/plain\" id=\"umbra-numbers\">"
#define END      "</script>"

struct piece {
  const char *text;
  size_t length;
};

/* What an element holds; false: there is none. */
static bool find(const char *text, const char *from, struct piece *out)
{
  const char *at = strstr(text, from);
  if (at == NULL) return false;
  out->text = at + strlen(from);
  const char *end = strstr(out->text, END);
  out->length = end == NULL ? 0 : (size_t)(end - out->text);
  return end != NULL;
}

/* Neither may hold what would end its element in the page to come. */
static bool is_sound(const struct piece *document, const struct piece *numbers)
{
  static const char base64[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=";
  return memchr(document->text, '<', document->length) == NULL &&
         strspn(numbers->text, base64) == numbers->length &&
         strstr(document->text, "\"format\": \"umbra page\", \"version\": 1") != NULL;
}

static void put_piece(const struct piece *piece, const char *type, const char *id, size_t i,
                      FILE *file)
{
  fprintf(file, "<script type=\"%s\" id=\"%s", type, id);
  if (i > 0) fprintf(file, "-%zu", i);
  fputs("\">", file);
  fwrite(piece->text, 1, piece->length, file);
  fputs(END "\n", file);
}

static enum um_status put_document(struct um_context *context, const char *path, size_t i,
                                   FILE *file)
{
  char *text = NULL;
  size_t length;
  struct piece document = {0}, numbers = {0};
  UM_TRY(um_core_file_read(context, path, LIMIT, &text, &length));
  enum um_status status = UM_OK;
  if (!find(text, DOCUMENT, &document) || !find(text, NUMBERS, &numbers) ||
      !is_sound(&document, &numbers))
    status =
        um_core_fail(context, UM_ERR_INPUT,
                     "%s: no page of Umbra; accepted: report.html of a folder of results", path);
  if (status == UM_OK) {
    put_piece(&document, "application/json", "umbra-document", i, file);
    put_piece(&numbers, "text/plain", "umbra-numbers", i, file);
  }
  um_core_free(context, text);
  return status;
}

enum um_status um_page_write_beside(struct um_context *context, size_t n, const char *const *path,
                                    const char *const *name, FILE *file)
{
  um_page_put_head(n > 1 ? "Results beside each other" : name[0], false, file);
  fputs("<body>\n<main id=\"umbra-static\">\n<h1>Results beside each other</h1>\n<ul>\n", file);
  for (size_t i = 0; i < n; i++) {
    fputs("<li>", file);
    um_page_plain_text(file, name[i]);
    fputs("</li>\n", file);
  }
  fputs("</ul>\n<p>The figures of this page need the viewer, and scripts.</p>\n</main>\n", file);
  for (size_t i = 0; i < n; i++) UM_TRY(put_document(context, path[i], i, file));
  fputs("<script type=\"application/json\" id=\"umbra-sets\">[", file);
  for (size_t i = 0; i < n; i++) {
    struct um_page_text one = {0};
    one.file = open_memstream(&one.text, &one.length);
    if (one.file == NULL) return um_core_fail(context, UM_ERR_MEMORY, "a page: out of memory");
    if (i > 0) fputs(", ", file);
    um_core_json_string(one.file, name[i]);
    um_page_text_put_json(&one, file);
  }
  fputs("]" END "\n", file);
  um_page_put_viewer(file);
  fputs("</body>\n</html>\n", file);
  return UM_OK;
}
