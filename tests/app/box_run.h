/* A run in a fresh folder, and a band's numbers in its tables. */
#ifndef UMBRA_TESTS_APP_BOX_RUN_H
#define UMBRA_TESTS_APP_BOX_RUN_H

#include "tests/app/command.h"
#include "tests/app/table.h"

/* CSV numbers have nine digits, so that a sum of five rounds to 5 x 5e-10 of the largest at most.
 */
#define PRINTED 1e-8

/* Of box.yaml and two_parts.yaml. */
static const char *const bands[] = {"vis", "lwir"};
static const char *const mechanisms[] = {"sun", "earth", "emitted", "interreflected", "other"};

/* CMocka setups: that scenario, run without pictures into the folder out. */
int enter_box(void **state);
int enter_two_parts(void **state);

/* The field BAND_WHAT of a row, and its number. */
const char *band_text(const struct table *t, size_t row, const char *band, const char *what);
double band_number(const struct table *t, size_t row, const char *band, const char *what);

#endif
