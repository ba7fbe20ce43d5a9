/* The unit that the name of a key ends in. Private to library/. */
#ifndef UMBRA_LIBRARY_KEY_UNIT_IMPL_H
#define UMBRA_LIBRARY_KEY_UNIT_IMPL_H

#define UM_LIBRARY_UNIT 48

/* "areal_heat_capacity_J_m2_K" -> "J/(m^2 K)"; "" where it ends in none. Does not fail. */
void um_library_key_unit(const char *key, char out[UM_LIBRARY_UNIT]);

#endif
