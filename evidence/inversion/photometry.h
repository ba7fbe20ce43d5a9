/* What a telescope's frames say: photometry of FITS files as count rates, stars of known magnitude,
 * and the calibration that they give a series of counts. */
#ifndef UMBRA_COMPARE_PHOTOMETRY_H
#define UMBRA_COMPARE_PHOTOMETRY_H

#include "evidence/measurements/set.h"
#include "model/build/model.h"
#include "optics/instrument/aperture.h"
#include "optics/instrument/calibration.h"

/* One object in one frame. */
struct um_compare_photometry {
  double t_tai;    /* mid-exposure [s] */
  double exposure; /* [s] */
  double airmass;  /* NAN: the header says none */
  char sensor[72]; /* INSTRUME of the header */
  struct um_instrument_aperture_sum sum;
  double rate, sigma; /* of the net counts [1/s] */
};

/* Measure frame `path`. aperture->x, y as FITS counts pixels (1,1 is the middle of the first); NAN:
 * the middle of the frame. Of the header EXPTIME (or EXPOSURE), GAIN (or EGAIN) and RDNOISE,
 * SATURATE where it is there, AIRMASS likewise; the time is DATE-AVG, else half an exposure after
 * DATE-OBS. UM_ERR_INPUT, UM_ERR_IO with the file's name; UM_ERR_MEMORY. */
enum um_status um_compare_photometry_measure(struct um_context *context, const char *path,
                                             const struct um_instrument_aperture *aperture,
                                             struct um_compare_photometry *out);
/* Rows of count_rate of the frames' sensors, in order of time, flag 1 where a pixel of the circle
 * is saturated. path: what the set is called. The caller destroys. */
enum um_status um_compare_photometry_set(struct um_context *context,
                                         const struct um_compare_photometry *frame, size_t n,
                                         const char *path, struct um_compare_measurements **out);

/* Calibration from a table of stars: CSV with magnitude_ab, airmass, count_rate, sigma and, where
 * it is there, flag (0 or empty: used). Predicted is what the scenario's sensor s counts of such a
 * star (um_model_star_rate), so that air and effects of the scenario are in it and what is fitted
 * is what they leave. UM_ERR_INPUT with file and line. */
enum um_status um_compare_calibration_read(struct um_context *context, const struct um_model *model,
                                           size_t s, const char *path, double extinction,
                                           struct um_instrument_calibration *out);
/* Rows of count_rate of sensor s over the factor at their airmass, their sigma with that of the
 * factor, which all rows share; their number in *rows. Others stay. UM_ERR_INPUT with file and
 * line: a row whose satellite is below the horizon, no such row. */
enum um_status um_compare_calibrate(struct um_context *context, const struct um_model *model,
                                    size_t s, const struct um_instrument_calibration *calibration,
                                    struct um_compare_measurements *measurements, size_t *rows);

#endif
