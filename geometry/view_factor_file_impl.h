/* Private to geometry/: the hashes of what view factors are made of, as a file states them. */
#ifndef UMBRA_GEOMETRY_VIEW_FACTOR_FILE_IMPL_H
#define UMBRA_GEOMETRY_VIEW_FACTOR_FILE_IMPL_H

#include "geometry/view_factors.h"

extern const char *const um_geometry_view_factor_key_name[4]; /* records, in their order */
void um_geometry_view_factor_key_values(const struct um_geometry_view_factor_key *key,
                                        uint64_t out[4]);

#endif
