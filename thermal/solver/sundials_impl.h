/* Where SUNDIALS 6 and 7 differ: names of 7, and what they say when they fail. Private to thermal/.
 */
#ifndef UMBRA_THERMAL_SUNDIALS_IMPL_H
#define UMBRA_THERMAL_SUNDIALS_IMPL_H

#include <sundials/sundials_linearsolver.h>

#if SUNDIALS_VERSION_MAJOR < 7
#define SUN_COMM_NULL    NULL
#define SUN_ERR_EXT_FAIL SUNLS_PACKAGE_FAIL_UNREC
#endif

struct um_thermal_words {
  char text[256];
};

/* What CVODES or KINSOL (memory) says is kept, the last of it, and not printed. Returns their code,
 * below 0 on failure. */
int um_thermal_words_of_cvodes(void *memory, SUNContext sun, struct um_thermal_words *words);
int um_thermal_words_of_kinsol(void *memory, SUNContext sun, struct um_thermal_words *words);

#endif
