/* What a page shows where there is no viewer: texts and tables as HTML. */
#include <math.h>

#include "base/page/page_impl.h"

void um_page_plain_text(FILE *file, const char *text)
{
  for (; *text != '\0'; text++) switch (*text) {
    case '&':
      fputs("&amp;", file);
      break;
    case '<':
      fputs("&lt;", file);
      break;
    case '>':
      fputs("&gt;", file);
      break;
    case '"':
      fputs("&quot;", file);
      break;
    default:
      fputc(*text, file);
    }
}

void um_page_plain_begin(struct um_page *page, const struct um_page_figure *figure)
{
  FILE *file = page->plain.file;
  fputs("<details><summary>", file);
  um_page_plain_text(file, figure->title);
  fputs("</summary>\n", file);
  if (figure->text != NULL) {
    fputs("<p>", file);
    um_page_plain_text(file, figure->text);
    fputs("</p>\n", file);
  }
  fputs("<div class=\"t\"><table><tr>", file);
}

void um_page_plain_head(struct um_page *page, const char *name, const char *unit)
{
  FILE *file = page->plain.file;
  fputs("<th>", file);
  um_page_plain_text(file, name);
  if (unit != NULL && !(unit[0] == '1' && unit[1] == '\0')) {
    fputs(" [", file);
    um_page_plain_text(file, unit);
    fputc(']', file);
  }
  fputs("</th>", file);
}

void um_page_plain_row(struct um_page *page) { fputs("</tr>\n<tr>", page->plain.file); }

void um_page_plain_cell(struct um_page *page, const char *text, double value)
{
  FILE *file = page->plain.file;
  fputs("<td>", file);
  if (text != NULL)
    um_page_plain_text(file, text);
  else if (isfinite(value))
    fprintf(file, "%.9g", value);
  fputs("</td>", file);
}

void um_page_plain_end(struct um_page *page)
{
  fputs("</tr></table></div></details>\n", page->plain.file);
}
