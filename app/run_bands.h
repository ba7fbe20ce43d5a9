/* What a run says of the light of each band. */
#ifndef UMBRA_APP_RUN_BANDS_H
#define UMBRA_APP_RUN_BANDS_H

#include "output/output.h"

/* Two lines for people: extremes, shadow, Monte-Carlo error, materials. work: shape [the larger of
 * nobs and nmaterial]. */
void um_app_run_print_band(const struct um_output_run *run, size_t band, double *work);
/* The same as a JSON object. */
void um_app_run_json_band(const struct um_output_run *run, size_t band, double *work);

#endif
