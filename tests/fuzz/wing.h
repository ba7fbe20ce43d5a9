/* A plate in the Sun at rest in inertial space for 20 s: the smallest scenario that has a part to
 * which an input can be given. Its materials are those of tests/fuzz/data. */
#ifndef UMBRA_TESTS_FUZZ_WING_H
#define UMBRA_TESTS_FUZZ_WING_H

static const char wing[] =
    "schema: 1\n"
    "name: wing\n"
    "time: {start_utc: 2016-03-20T04:30:00Z, stop_utc: 2016-03-20T04:30:20Z, step_s: 10}\n"
    "orbit: {fixed: {position_gcrs_km: [42000, 0, 0]}}\n"
    "attitude: [{fixed: {q_gcrs: [1, 0, 0, 0]}}]\n"
    "parts:\n"
    "  - {name: wing, plate: {size_m: [2, 1]}, front: grey, back: grey, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
    "thermal: {orbits_before: 0, start: isothermal}\n";

#endif
