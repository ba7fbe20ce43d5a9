/* umbra report: pages of results beside each other, in one page. */
#include <string.h>

#include "app/app.h"
#include "app/target.h"
#include "base/core/file.h"
#include "base/page/beside.h"
#include "base/page/page.h"

#define PAGES 8 /* at most */

/* "out/a/report.html" of a folder; a file is itself. */
static enum um_status page_path(struct um_context *context, const char *name, char **out)
{
  size_t n = strlen(name);
  bool file = n > 5 && strcmp(name + n - 5, ".html") == 0;
  return file ? um_core_strdup(context, name, out)
              : um_core_asprintf(context, out, "%s/" UM_PAGE_FILE, name);
}

int um_app_report(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_core_whole_file whole;
  const char *name[PAGES];
  char *path[PAGES] = {NULL};
  size_t n = 1 + options->nmore;
  if (n > PAGES) {
    fprintf(stderr, "umbra: report: %zu folders; accepted: up to %d\n", n, PAGES);
    return UM_APP_MISUSE;
  }
  for (size_t i = 0; i < n; i++) {
    name[i] = i == 0 ? options->positional[0] : options->more[i - 1];
    UM_CHECK(page_path(context, name[i], &path[i]));
  }
  UM_CHECK(um_app_check_picture(context, options, ".html"));
  UM_CHECK(um_core_whole_begin(context, options->out, &whole));
  status = um_page_write_beside(context, n, (const char *const *)path, name, whole.file);
  UM_CHECK(um_core_whole_end(context, &whole, status));
  if (options->json) {
    um_core_json_text(stdout, "{", "file", options->out);
    um_core_json_count(stdout, ", ", "pages", n);
    printf("}\n");
  } else {
    printf("to look at: %s\n", options->out);
  }
done:
  for (size_t i = 0; i < PAGES; i++) um_core_free(context, path[i]);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
