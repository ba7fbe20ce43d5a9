/* Private to orbit/: ephemeris and attitude files of STK (.e, .a) as messages of CNES. */
#ifndef UMBRA_ORBIT_STK_IMPL_H
#define UMBRA_ORBIT_STK_IMPL_H

#include <stdbool.h>

#include "base/core/context.h"

/* What such a file holds, by its keyword. */
enum um_orbit_stk_kind { UM_ORBIT_STK_EPHEMERIS, UM_ORBIT_STK_ATTITUDE };

/* Does a text begin as a file of STK does? */
bool um_orbit_stk_is(const char *text);
/* The same as an OEM or AEM of CNES, in TAI: *before lines of its own, then one for each of the
 * file, so that messages name its lines. Places and velocities in km; quaternions, the scalar last,
 * from J2000 or ICRF to the body. The caller frees *out. UM_ERR_INPUT naming file, line and what is
 * accepted. */
enum um_status um_orbit_stk_message(struct um_context *context, const char *name, const char *text,
                                    enum um_orbit_stk_kind kind, char **out, int *before);

#endif
