/* What the verbs that write pictures share: parts of them, and what they cost. */
#ifndef UMBRA_APP_PICTURE_H
#define UMBRA_APP_PICTURE_H

#include "app/app.h"
#include "model/geometry/tables.h"
#include "output/cube.h"
#include "output/exr.h"

/* An instant as an option says it, t_tai [s]. UM_ERR_INPUT names the option. */
enum um_status um_app_instant(struct um_context *context, const char *option, const char *text,
                              double *t);
/* Refuse an instant that the scenario does not reach: outside time.start_utc to time.stop_utc.
 * more: what else is accepted, "" for nothing. UM_ERR_INPUT names option and span. */
enum um_status um_app_instant_within(struct um_context *context, const char *option,
                                     const char *text, double t, const struct um_model *model,
                                     const char *more);
/* From the scenario's start to an instant in it, so that heat has the history that a run gives it;
 * the instant is the last observation. The caller destroys. Errors of um_model_precompute_at. */
enum um_status um_app_instant_precompute(struct um_context *context, const struct um_model *model,
                                         double t, struct um_model_tables **out);
/* --wavelengths FROM-TO [um] and --tile X,Y,WIDTH,HEIGHT as typed, all without them. UM_ERR_INPUT.
 */
enum um_status um_app_picture_part(struct um_context *context, const struct um_app_options *options,
                                   struct um_output_cube_part *out);
/* The same of a picture that is there. UM_ERR_INPUT: outside it. */
enum um_status um_app_cut(struct um_context *context, const struct um_app_options *options,
                          const struct um_optics_image *image, struct um_output_cut *cut);
/* Print what a picture will cost; UM_ERR_INPUT: too much memory, too large a file or too little
 * room for it, with the option that helps. */
enum um_status um_app_picture_cost(struct um_context *context, const struct um_app_options *options,
                                   const struct um_optics_image_cost *cost,
                                   const struct um_optics_band *band);
/* The same for a part of a picture that is there. */
enum um_status um_app_cut_cost(struct um_context *context, const struct um_app_options *options,
                               const struct um_optics_image *image,
                               const struct um_output_cut *cut);
/* What was written; mean: of the band's radiance [W/m2/sr], NAN where it is not known. */
void um_app_picture_print(const struct um_app_options *options, int width, int height,
                          double pixel_m, size_t nbin, double mean);

#endif
