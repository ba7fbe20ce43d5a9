/* Where a frame lies on the sky. */
#ifndef UMBRA_MODEL_FRAME_SKY_H
#define UMBRA_MODEL_FRAME_SKY_H

#include "model/geometry/tables.h"

/* A gnomonic projection (TAN of FITS, Calabretta & Greisen 2002) about the middle of the frame. */
struct um_model_frame_sky {
  double ra, dec;  /* of the satellite as the observer sees it, in GCRS, corrected for light time,
                      not for aberration and refraction [deg] */
  double cd[2][2]; /* of east and north, by pixels to the right and up [deg] */
};

/* Of observation k, up being away from the Earth, pixels of `pixel` [arcsec]. Does not fail. Test:
 * cli_app_formats. */
struct um_model_frame_sky um_model_frame_sky(const struct um_model_tables *tables, size_t k,
                                             double pixel);

#endif
