/* Pages whose documents are taken over into another: what is between the marks ends no element. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/page/beside.h"
#include "base/page/page.h"
#include "tests/fuzz/fuzz.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  const char *path[2] = {um_fuzz_file(0, data, size), NULL}, *name[2] = {"<a>", "b"};
  char *text = NULL;
  size_t length = 0, scripts = 0;
  path[1] = path[0];
  FILE *file = open_memstream(&text, &length);
  if (file == NULL) return;
  bool good = um_fuzz_good(context, um_page_write_beside(context, 2, path, name, file));
  if (fclose(file) == 0 && good) {
    /* of each page two, their names, the viewer where there is one */
    size_t ours = um_page_has_viewer() ? 6 : 5;
    for (const char *at = text; (at = strstr(at, "</script>")) != NULL; at++) scripts++;
    if (scripts != ours) um_fuzz_finding("a document ends its element");
  }
  free(text);
}
