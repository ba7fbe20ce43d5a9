/* Temperature and infrared cross-section of what was measured in several thermal bands, time by
 * time (optics/instrument/grey_body.h). */
#ifndef UMBRA_COMPARE_RETRIEVE_H
#define UMBRA_COMPARE_RETRIEVE_H

#include <stdio.h>

#include "evidence/comparison/predict.h"
#include "optics/instrument/grey_body.h"

/* Light of one time, and what glows so. */
struct um_compare_retrieved_row {
  double t_tai;
  size_t nband;                            /* thermal bands measured */
  struct um_instrument_grey_body one, two; /* n 0: too few bands, or no grey body fits */
};
struct um_compare_retrieved {
  struct um_compare_retrieved_row *row; /* [count] times with light in some thermal band */
  size_t count;
};

/* Of rows of band_irradiance and radiant_intensity with flag 0 in bands between
 * UM_INSTRUMENT_THERMAL_FROM and _TO: one grey body where there are three bands or more, two where
 * there are five. Bands and range are the scenario's; nothing is put back of what the air takes,
 * and sunlight in the band counts as heat. UM_ERR_INPUT with file and line: as
 * um_compare_plan_create, a row without sigma; no time with three bands. UM_ERR_MEMORY,
 * UM_ERR_CANCELLED. The caller destroys.
 */
enum um_status um_compare_retrieve(struct um_context *context, const struct um_model *model,
                                   const struct um_compare_measurements *measurements,
                                   struct um_compare_retrieved **out);
void um_compare_retrieved_destroy(struct um_context *context,
                                  struct um_compare_retrieved **retrieved);

/* Is the light of a row better explained by two grey bodies, each parameter paid for (BIC)? */
bool um_compare_retrieved_prefers_two(const struct um_compare_retrieved_row *row);

/* retrieved.csv: a row per time. Errors are the stream's. */
void um_compare_retrieved_write(const struct um_compare_retrieved *retrieved, FILE *file);

#endif
