/* What the verbs that write pictures share: parts of them, and what they cost. */
#ifndef UMBRA_APP_PICTURE_H
#define UMBRA_APP_PICTURE_H

#include "app/app.h"
#include "output/cube.h"
#include "output/exr.h"

/* A scenario at the one instant that --time says: its overrides and two more. UM_ERR_INPUT names
 * --time; destroy after a failure too. */
struct um_app_instant {
  struct um_model_options changes;
  const char **overrides;
  char *at[2];
};
enum um_status um_app_instant_create(struct um_context *context,
                                     const struct um_app_options *options,
                                     struct um_app_instant *out);
void um_app_instant_destroy(struct um_context *context, struct um_app_instant *instant);
/* A name in .nc asks for a factored picture. */
bool um_app_is_cube(const char *path);
/* Said before the computing begins: what cannot be written, or is not ours to replace. The picture
 * is renamed into place, which must not hit a device. */
enum um_status um_app_check_picture(struct um_context *context,
                                    const struct um_app_options *options);
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

#endif
