/* One quantity of a reference beside ours, row by row: kept, compared and printed as a table row.
 */
#ifndef UMBRA_TESTS_MODEL_CHANNEL_H
#define UMBRA_TESTS_MODEL_CHANNEL_H

#include <stdbool.h>

#include "tests/support/cmocka_all.h"

/* Accepted: with `relative` 0 the difference `absolute`; otherwise `relative` of the value but not
 * of less than `least`, and of values that are zero `absolute` times the peak. */
struct accept {
  double absolute, relative, least;
};

struct channel {
  double *expected, *value; /* [n] */
  size_t n, room;
};

struct channel channel_new(size_t rows);
void channel_add(struct channel *c, double expected, double value);
/* Print peak, greatest and rms difference (relative ones where they are accepted so) and free the
 * channel. True when every row is accepted; rows that are not are printed. Fewer than 20 rows fail
 * the test. */
bool channel_close(struct channel *c, const char *what, const char *unit, struct accept accept);

#endif
