/* The smallest scenario that gives a light curve, without its parts: two instants of a satellite at
 * rest, seen from a direction in one band. */
#ifndef UMBRA_TESTS_APP_SMALL_H
#define UMBRA_TESTS_APP_SMALL_H

#define SMALL_HEAD                                                                                 \
  "schema: 1\nname: h\n"                                                                           \
  "time: {start_utc: 2016-03-20T04:30:00Z, stop_utc: 2016-03-20T04:31:00Z, step_s: 30}\n"          \
  "orbit: {circular: {altitude_km: 765, beta_deg: 0}}\n"                                           \
  "attitude:\n  - fixed: {q_gcrs: [1, 0, 0, 0]}\n"                                                 \
  "observer: {direction: {unit_gcrs: [0.5, 0.8660254, 0], range_km: 1000}}\n"                      \
  "bands: {vis: {from_um: 0.38, to_um: 0.78, bins: 4}}\n"

#endif
