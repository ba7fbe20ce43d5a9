/* What an observer sees, as a tracking data message (TDM, CCSDS 503.0-B). */
#ifndef UMBRA_OUTPUT_TDM_H
#define UMBRA_OUTPUT_TDM_H

#include "output/output.h"

/* A segment a band that has magnitudes: MAG, of Vega's system, and in the first azimuth and
 * elevation (ANGLE_1, ANGLE_2 [deg], from a station), RANGE [km]. Hidden observations are left out.
 * `umbra import` reads the magnitudes as the same doubles. Errors of writing are the stream's.
 * Test: cli_app_export. */
enum um_status um_output_write_tdm(const struct um_output_run *run, FILE *file);

#endif
