/* Tables of FITS: the first with rows. */
#include "evidence/measurements/foreign_kind.h"
#include "output/fits_library.h"

static enum um_status convert(struct um_context *context, const char *path, const char *bytes,
                              size_t length, FILE *csv)
{
  char *text = NULL;
  size_t n = 0;
  UM_TRY(um_output_fits_table(context, path, bytes, length, &text, &n));
  fwrite(text, 1, n, csv);
  um_core_free(context, text);
  return UM_OK;
}

const struct um_compare_foreign_kind um_compare_foreign_fits = {um_output_fits_is, convert};
