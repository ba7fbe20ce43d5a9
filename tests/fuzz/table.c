/* A table of any header as measurements: of magnitudes, and as it is guessed; and the line that
 * remembers its columns. */
#include <string.h>

#include "evidence/measurements/import.h"
#include "tests/fuzz/rows.h"

static void import(struct um_context *context, const char *path,
                   const struct um_compare_columns *columns)
{
  struct um_compare_measurements *rows = NULL;
  struct um_compare_imported found;
  char *map = NULL, *note = NULL, *text = NULL;
  struct um_compare_columns back;
  if (um_fuzz_good(context, um_compare_import(context, path, columns, &found, &rows))) {
    rows_try(context, rows);
    if (um_fuzz_good(context, um_compare_columns_text(context, &found.columns, &map)) &&
        um_fuzz_good(context, um_core_asprintf(context, &note, UM_COMPARE_IMPORT_MARK "%s", map)) &&
        um_fuzz_good(context,
                     um_compare_measurements_write_noted(context, rows, note, um_fuzz_out())) &&
        um_compare_columns_read(context, um_fuzz_out(), &back, &text) != UM_OK &&
        !um_fuzz_memory_is_short())
      um_fuzz_finding("the columns do not read back: %s", um_core_message(context));
  } else if (rows != NULL) {
    um_fuzz_finding("rows in spite of the failure");
  }
  um_compare_measurements_destroy(context, &rows);
  um_core_free(context, map);
  um_core_free(context, note);
  um_core_free(context, text);
}

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  static const struct um_compare_columns magnitudes = {
      .time = "UTC", .magnitude = "V", .sigma = "Verr"};
  struct um_compare_columns columns;
  const char *path = um_fuzz_file(0, data, size);
  char *text = NULL;
  import(context, path, &magnitudes);
  if (um_fuzz_good(context, um_compare_import_suggest(context, path, &text)))
    if (strncmp(text, "umbra import ", 13) != 0) um_fuzz_finding("no command: %s", text);
  um_core_free(context, text);
  text = NULL;
  if (um_fuzz_good(context, um_compare_columns_read(context, path, &columns, &text)))
    import(context, path, &columns);
  um_core_free(context, text);
}
