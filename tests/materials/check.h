/* Shared by the tests of this folder. */
#ifndef UMBRA_TESTS_MATERIALS_CHECK_H
#define UMBRA_TESTS_MATERIALS_CHECK_H

#include <math.h>
#include <stdio.h>

#include "tests/materials/sun.h"
#include "tests/support/near.h"

/* Library of the source tree; the caller destroys both. */
#define UM_TEST_LIBRARY UMBRA_SOURCE_DIR "/materials/library"

#endif
