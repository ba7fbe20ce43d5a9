/* Private to thermal/network/: contacts between parts. */
#ifndef UMBRA_THERMAL_CONTACT_IMPL_H
#define UMBRA_THERMAL_CONTACT_IMPL_H

#include "thermal/network/builder_impl.h"

/* Conduction between two places. */
enum um_status um_thermal_contact_assemble(struct um_thermal_builder *b,
                                           const struct um_thermal_contact *contact);

#endif
