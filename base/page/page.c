/* A page in the making: its texts and sections. */
#include "base/page/page.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/json.h"
#include "base/page/page_impl.h"

#define TEXTS(page)                                                                                \
  {                                                                                                \
    &(page)->lead, &(page)->facts, &(page)->sections, &(page)->scene, &(page)->arrays,             \
        &(page)->numbers, &(page)->plain_lead, &(page)->plain_facts, &(page)->plain                \
  }

bool um_page_has_viewer(void) { return um_page_viewer_js_length > 0; }

static bool texts_open(struct um_page *page)
{
  struct um_page_text *const texts[] = TEXTS(page);
  for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
    texts[i]->file = open_memstream(&texts[i]->text, &texts[i]->length);
    if (texts[i]->file == NULL) return false;
  }
  return true;
}

enum um_status um_page_create(struct um_context *context, const struct um_page_head *head,
                              struct um_page **out)
{
  enum um_status status;
  struct um_page *page = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *page, &page));
  UM_CHECK(um_core_strdup(context, head->command, &page->command));
  UM_CHECK(um_core_strdup(context, head->kind, &page->kind));
  UM_CHECK(um_core_asprintf(context, &page->title, "%s%s", head->title,
                            head->about != NULL ? head->about : ""));
  if (head->token != NULL) UM_CHECK(um_core_strdup(context, head->token, &page->token));
  if (!texts_open(page)) UM_CHECK(um_core_fail(context, UM_ERR_MEMORY, "a page: out of memory"));
  *out = page;
  page = NULL;
done:
  um_page_destroy(context, &page);
  return status;
}

void um_page_destroy(struct um_context *context, struct um_page **page)
{
  if (page == NULL || *page == NULL) return;
  struct um_page *p = *page;
  struct um_page_text *const texts[] = TEXTS(p);
  for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
    if (texts[i]->file != NULL) (void)fclose(texts[i]->file);
    free(texts[i]->text);
  }
  UM_FREE(context, p->command, p->kind, p->title, p->token, p);
  *page = NULL;
}

void um_page_key(FILE *file, const char *key, const char *text)
{
  if (text != NULL) um_core_json_text(file, ", ", key, text);
}

/* A sentence as JSON, and as HTML between the two pieces of markup; whole, however long it is. */
static void put_sentence(FILE *json, FILE *html, const char *before, const char *behind,
                         const char *format, va_list values)
{
  char *text = NULL;
  size_t length = 0;
  FILE *memory = open_memstream(&text, &length);
  if (memory == NULL) return;
  (void)vfprintf(memory, format, values);
  if (fclose(memory) == 0) {
    um_core_json_string(json, text);
    fputs(before, html);
    um_page_plain_text(html, text);
    fputs(behind, html);
  }
  free(text);
}

void um_page_lead(struct um_page *page, const char *format, ...)
{
  va_list values;
  if (page->nlead++ > 0) fputs(", ", page->lead.file);
  va_start(values, format);
  put_sentence(page->lead.file, page->plain_lead.file, "<p>", "</p>\n", format, values);
  va_end(values);
}

void um_page_fact(struct um_page *page, const char *name, const char *format, ...)
{
  va_list values;
  um_core_json_text(page->facts.file, page->nfact++ > 0 ? ",\n{" : "{", "name", name);
  fputs(", \"value\": ", page->facts.file);
  fputs("<tr><th>", page->plain_facts.file);
  um_page_plain_text(page->plain_facts.file, name);
  va_start(values, format);
  put_sentence(page->facts.file, page->plain_facts.file, "</th><td>", "</td></tr>\n", format,
               values);
  va_end(values);
  fputc('}', page->facts.file);
}

/* Close the section at hand. */
static void section_end(struct um_page *page)
{
  static const char *const end[] = {
      [UM_PAGE_NO_SECTION] = "", [UM_PAGE_TEXTS] = "], \"figures\": []}", [UM_PAGE_FIGURES] = "]}"};
  fputs(end[page->state], page->sections.file);
  if (page->state != UM_PAGE_NO_SECTION) fputs("</section>\n", page->plain.file);
  page->state = UM_PAGE_NO_SECTION;
}

void um_page_section(struct um_page *page, const char *id, const char *question,
                     enum um_page_level level)
{
  static const char *const names[] = {
      [UM_PAGE_GOOD] = "good", [UM_PAGE_WARNING] = "warning", [UM_PAGE_BAD] = "bad"};
  FILE *file = page->sections.file;
  section_end(page);
  um_core_json_text(file, page->nsection++ > 0 ? ",\n{" : "{", "id", id);
  um_core_json_text(file, ", ", "question", question);
  if (level != UM_PAGE_PLAIN) um_page_key(file, "level", names[level]);
  fputs(", \"text\": [", file);
  fputs("<section><h2>", page->plain.file);
  um_page_plain_text(page->plain.file, question);
  fputs("</h2>\n", page->plain.file);
  page->state = UM_PAGE_TEXTS;
  page->ntext = page->nfigure = 0;
}

void um_page_text(struct um_page *page, const char *format, ...)
{
  va_list values;
  if (page->state != UM_PAGE_TEXTS) return;
  if (page->ntext++ > 0) fputs(", ", page->sections.file);
  va_start(values, format);
  put_sentence(page->sections.file, page->plain.file, "<p>", "</p>\n", format, values);
  va_end(values);
}

void um_page_picture(struct um_page *page, const char *path)
{
  if (!um_page_has_viewer()) um_page_plain_picture(page->plain.file, path);
}

FILE *um_page_figure_begin(struct um_page *page, const struct um_page_figure *figure,
                           const char *kind)
{
  FILE *file = page->sections.file;
  if (page->state == UM_PAGE_TEXTS) fputs("], \"figures\": [", file);
  page->state = UM_PAGE_FIGURES;
  um_core_json_text(file, page->nfigure++ > 0 ? ",\n{" : "\n{", "kind", kind);
  um_page_key(file, "id", figure->id);
  um_page_key(file, "title", figure->title);
  um_page_key(file, "text", figure->text);
  um_page_key(file, "file", figure->file);
  return file;
}

/* Bytes of a text that no longer grows; false: memory was short. */
static bool text_end(struct um_page_text *text)
{
  return fflush(text->file) == 0 && ferror(text->file) == 0;
}

/* JSON inside a script element: '<' stands in strings alone, where it may be escaped, so that no
 * text ends the element. */
static void put_json(const struct um_page_text *json, FILE *file)
{
  for (size_t i = 0; i < json->length; i++)
    if (json->text[i] == '<')
      fputs("\\u003c", file);
    else
      fputc(json->text[i], file);
}

void um_page_text_put_json(struct um_page_text *text, FILE *file)
{
  (void)fclose(text->file);
  text->file = NULL;
  put_json(text, file);
  free(text->text);
}

static void put_document(const struct um_page *page, FILE *file)
{
  struct um_page_text head = {0};
  fputs("<script type=\"application/json\" id=\"umbra-document\">\n", file);
  head.file = open_memstream(&head.text, &head.length);
  if (head.file != NULL) {
    fputs("{\"format\": \"umbra page\", \"version\": 1", head.file);
    um_page_key(head.file, "program", UM_PAGE_PROGRAM);
    um_page_key(head.file, "command", page->command);
    um_page_key(head.file, "kind", page->kind);
    um_page_key(head.file, "title", page->title);
    if (page->token != NULL) {
      um_core_json_text(head.file, ", \"serve\": {", "token", page->token);
      fputc('}', head.file);
    }
    um_page_text_put_json(&head, file);
  }
  fputs(",\n\"lead\": [", file);
  put_json(&page->lead, file);
  fputs("],\n\"facts\": [", file);
  put_json(&page->facts, file);
  fputs("],\n\"sections\": [\n", file);
  put_json(&page->sections, file);
  fputs("]", file);
  if (page->scene.length > 0) {
    fputs(",\n\"scene\": ", file);
    put_json(&page->scene, file);
  }
  fputs(",\n\"arrays\": [", file);
  put_json(&page->arrays, file);
  fputs("]}\n</script>\n", file);
}

#define PLAIN_STYLE                                                                                \
  "body{font:16px/1.5 system-ui,sans-serif;max-width:70rem;margin:2rem auto;padding:0 1rem}"       \
  "table{border-collapse:collapse;font-variant-numeric:tabular-nums}td,th{padding:.1rem .6rem;"    \
  "text-align:left}img{max-width:100%}details{margin:.5rem 0}.t{max-height:24rem;overflow:auto}"

/* The policy lets nothing in from elsewhere, and runs no script but the viewer. */
void um_page_put_head(const char *title, bool served, FILE *file)
{
  fputs("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
        "img-src data: blob:; base-uri 'none'; form-action 'none'",
        file);
  if (served) fputs("; connect-src 'self'", file);
  if (um_page_has_viewer())
    fprintf(file, "; script-src '%s'; style-src '%s'", um_page_viewer_js_hash,
            um_page_viewer_css_hash);
  else
    fputs("; style-src 'unsafe-inline'", file);
  fputs("\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<link rel=\"icon\" href=\"data:,\">\n<title>",
        file);
  um_page_plain_text(file, title);
  fputs("</title>\n<style>", file);
  if (um_page_has_viewer())
    fwrite(um_page_viewer_css, 1, um_page_viewer_css_length, file);
  else
    fputs(PLAIN_STYLE, file);
  fputs("</style>\n</head>\n", file);
}

/* What a page shows without script. */
static void put_plain(const struct um_page *page, FILE *file)
{
  fputs("<main id=\"umbra-static\">\n<h1>", file);
  um_page_plain_text(file, page->title);
  fputs("</h1>\n", file);
  fwrite(page->plain_lead.text, 1, page->plain_lead.length, file);
  if (um_page_has_viewer()) {
    fputs("<p>The figures of this page need scripts, which this browser does not run.</p>\n", file);
  } else {
    fputs("<table>\n", file);
    fwrite(page->plain_facts.text, 1, page->plain_facts.length, file);
    fputs("</table>\n", file);
    fwrite(page->plain.text, 1, page->plain.length, file);
    fputs("<p>", file);
    um_page_plain_text(file, UM_PAGE_PROGRAM);
    fputs(": ", file);
    um_page_plain_text(file, page->command);
    fputs("</p>\n", file);
  }
  fputs("</main>\n", file);
}

void um_page_put_viewer(FILE *file)
{
  if (!um_page_has_viewer()) return;
  fputs("<script>", file);
  fwrite(um_page_viewer_js, 1, um_page_viewer_js_length, file);
  fputs("</script>\n", file);
}

enum um_status um_page_write(struct um_context *context, struct um_page *page, FILE *file)
{
  struct um_page_text *const texts[] = TEXTS(page);
  section_end(page);
  for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++)
    if (!text_end(texts[i])) return um_core_fail(context, UM_ERR_MEMORY, "a page: out of memory");
  um_page_put_head(page->title, page->token != NULL, file);
  fputs("<body>\n", file);
  put_plain(page, file);
  put_document(page, file);
  fputs("<script type=\"text/plain\" id=\"umbra-numbers\">", file);
  UM_TRY(um_page_write_packed(context, page->numbers.text, page->numbers.length, file));
  fputs("</script>\n", file);
  um_page_put_viewer(file);
  fputs("</body>\n</html>\n", file);
  return UM_OK;
}

enum um_status um_page_write_report(struct um_context *context, struct um_page *page,
                                    struct um_core_folder *folder)
{
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, folder, UM_PAGE_FILE, &file));
  enum um_status status = um_page_write(context, page, file);
  enum um_status closed = um_core_file_close(context, UM_PAGE_FILE, &file);
  return status != UM_OK ? status : closed;
}
