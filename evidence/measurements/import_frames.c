/* Rows of a table of several sensors that are no readings.
 *
 * A receiver without a frame writes zeros, or the last frame again. Sensors that stand still do so,
 * too, as far as they are told apart: with p_c the share of rows in which sensor c repeats itself,
 * chance alone has all of them repeat themselves in a row with prod p_c. Rows are held where the
 * whole table would have less than one half of such a row. */
#include <string.h>

#include "base/core/number.h"
#include "evidence/measurements/import_impl.h"

#define BY_CHANCE 0.5 /* rows */

static bool is_zero(const struct um_core_csv *csv, size_t row, size_t column)
{
  double value;
  return um_core_number_parse(um_core_csv_text(csv, row, column), &value) && value == 0.0;
}

static bool repeats(const struct um_core_csv *csv, size_t row, size_t column)
{
  return row > 0 &&
         strcmp(um_core_csv_text(csv, row, column), um_core_csv_text(csv, row - 1, column)) == 0;
}

enum um_status um_compare_import_frames(struct um_context *context, const struct um_core_csv *csv,
                                        const size_t *column, size_t n,
                                        enum um_compare_import_frame **out)
{
  size_t rows = um_core_csv_rows(csv);
  double expected = (double)rows; /* rows that repeat the one before by chance */
  UM_TRY(um_core_allocate(context, rows + 1, sizeof **out, out));
  for (size_t row = 0; row < rows; row++) {
    size_t zeros = 0, held = 0;
    for (size_t c = 0; c < n; c++) {
      zeros += is_zero(csv, row, column[c]);
      held += repeats(csv, row, column[c]);
    }
    if (held == n) (*out)[row] = UM_IMPORT_FRAME_HELD;
    if (zeros == n) (*out)[row] = UM_IMPORT_FRAME_ZEROS;
  }
  for (size_t c = 0; c < n; c++) {
    size_t alone = 0, counted = 0; /* where the row as a whole is none that is asked about */
    for (size_t row = 1; row < rows; row++) {
      if ((*out)[row] != UM_IMPORT_FRAME_GOOD) continue;
      counted++;
      alone += repeats(csv, row, column[c]);
    }
    expected *= ((double)alone + 1.0) / ((double)counted + 2.0);
  }
  for (size_t row = 0; row < rows && expected >= BY_CHANCE; row++)
    if ((*out)[row] == UM_IMPORT_FRAME_HELD) (*out)[row] = UM_IMPORT_FRAME_GOOD;
  return UM_OK;
}
