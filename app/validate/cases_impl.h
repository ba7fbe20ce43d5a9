/* Groups of cases, one per file. Private to app/validate/. */
#ifndef UMBRA_VALIDATE_CASES_IMPL_H
#define UMBRA_VALIDATE_CASES_IMPL_H

#include "app/validate/validate.h"

/* The thermal half. */
um_validate_cases um_validate_conduction, um_validate_radiation, um_validate_networks,
    um_validate_inside, um_validate_orbiting, um_validate_view_factors;

/* The optical half. */
um_validate_cases um_validate_radiometry, um_validate_surfaces, um_validate_bodies;

#endif
