/* Files of element sets for SGP4: two-line elements, and orbit mean-elements messages (OMM, CCSDS
 * 502.0-B-3) as key = value, XML, JSON or CSV, which have room for catalogue numbers of nine
 * digits. */
#ifndef UMBRA_ORBIT_ELEMENTS_H
#define UMBRA_ORBIT_ELEMENTS_H

#include "orbit/tle.h"

/* All sets of one object that a file has, by their epochs, rising; of equal epochs the one that
 * stands last. What it is written in is found out. object: its catalogue number; 0: the only one.
 * Frame and scale of an OMM are TEME and UTC, its theory is SGP4. UM_ERR_IO; UM_ERR_INPUT
 * "file:line: ...": what um_orbit_tle_parse refuses, a keyword that is missing, out of range or of
 * another frame, time scale or theory, sets of several objects where none is named, none of the one
 * that is. The caller releases. */
enum um_status um_orbit_elements_read(struct um_context *context, const char *path, int object,
                                      struct um_orbit_elements *out);
/* The same from memory; `name` is what messages call it. */
enum um_status um_orbit_elements_parse(struct um_context *context, const char *name,
                                       const char *text, size_t length, int object,
                                       struct um_orbit_elements *out);
void um_orbit_elements_release(struct um_context *context, struct um_orbit_elements *elements);

/* The set whose epoch is nearest. */
size_t um_orbit_elements_nearest(const struct um_orbit_elements *elements, double t_tai);

#endif
