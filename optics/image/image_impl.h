/* Private to the renderer of pictures: tracing of lines, spectra of what they saw. */
#ifndef UMBRA_OPTICS_IMAGE_IMPL_H
#define UMBRA_OPTICS_IMAGE_IMPL_H

#include "optics/image/camera_impl.h"
#include "optics/image/image.h"
#include "optics/radiance/posed_scene_group.h"
#include "optics/radiance/radiance_group.h"

/* What the lines of a picture are traced in. */
struct um_optics_exposure {
  const struct um_geometry_mesh *mesh;
  const struct um_optics_posed_scene *posed;
  struct um_optics_instant now;
  struct um_optics_camera camera;
  int samples; /* per pixel */
};
struct um_optics_tracer;

/* Room for the rays of `nrow` lines at a time, in as many threads as the context has. */
enum um_status um_optics_tracer_create(struct um_context *context,
                                       const struct um_optics_exposure *frame,
                                       struct um_optics_tracer **out);
void um_optics_tracer_destroy(struct um_context *context, struct um_optics_tracer **tracer);
double um_optics_tracer_bytes(const struct um_context *context,
                              const struct um_optics_exposure *frame);
/* Lines y[0..n) into row[n], shares by surface in place of spectrum; empty rows are what they were
 * before. UM_ERR_MEMORY, UM_ERR_CANCELLED; UM_ERR_INPUT beyond UM_OPTICS_IMAGE_BYTES in all. */
enum um_status um_optics_tracer_run(struct um_context *context, struct um_optics_tracer *tracer,
                                    const int *y, size_t n, struct um_optics_image_row *row);
/* Bytes of the rows that it made so far, and pixels of them that see something. */
double um_optics_tracer_row_bytes(const struct um_optics_tracer *tracer);
size_t um_optics_tracer_covered(const struct um_optics_tracer *tracer);

#define UM_OPTICS_SEEN_WHOLE 0.98 /* of a surface, seen: all of it */
#define UM_OPTICS_SEEN_LEAST 0.02 /* the smallest share that is told apart */

/* dark and sun of an image whose surfaces are named; scene and bands as in um_optics_image_render.
 * seen: [nspectrum] share of each surface that is seen, from UM_OPTICS_SEEN_LEAST to 1. */
enum um_status um_optics_image_spectra(struct um_context *context,
                                       const struct um_optics_scene *scene, size_t time,
                                       const struct um_optics_band *bands, size_t nband,
                                       const struct um_optics_exposure *frame, const double *seen,
                                       struct um_optics_image *image);

#endif
