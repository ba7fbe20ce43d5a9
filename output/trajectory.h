/* Where the satellite is and how it is turned, as the tables that scenarios take. */
#ifndef UMBRA_OUTPUT_TRAJECTORY_H
#define UMBRA_OUTPUT_TRAJECTORY_H

#include "base/core/file.h"
#include "model/build/model.h"

/* Instants of the tables: from before the heat of a run begins to after its end, so close that a
 * table stands for the orbit: cubic between rows to 1 mm of a low orbit (1 cm where SGP4's
 * velocities are not the slopes of its places), turns between two of at most 0.2 rad.
 * Test: output/trajectory. */
struct um_output_instants {
  double from, step; /* t_tai [s], whole milliseconds; [s] */
  size_t count;
};
/* UM_ERR_INPUT: no orbit, or more rows than 2 million; errors of orbit and attitude. */
enum um_status um_output_instants_choose(struct um_context *context, const struct um_model *model,
                                         struct um_output_instants *out);
/* orbit.csv, time_utc,x_km,y_km,z_km,vx_km_s,vy_km_s,vz_km_s in GCRS, and attitude.csv,
 * time_utc,q0,q1,q2,q3, GCRS to body; the same as messages, orbit.oem (CCSDS 502.0-B) and
 * attitude.aem (504.0-B), and as CNES has them, orbit.cic and attitude.cic. Each serves orbit.table
 * and attitude.table; numbers read back as the same doubles, states are those of the times as
 * written. Effects on orbit and attitude are in them. UM_ERR_IO, errors of orbit and attitude. */
enum um_status um_output_write_trajectory(struct um_context *context, const struct um_model *model,
                                          const struct um_output_instants *instants,
                                          struct um_core_folder *folder);

#endif
