/* tests/support/cmocka_all.h under the name that older tests include. */
#ifndef UMBRA_TESTS_CORE_CMOCKA_ALL_H
#define UMBRA_TESTS_CORE_CMOCKA_ALL_H

#include "tests/support/cmocka_all.h"

#endif
