/* Picture of one instant, factored: what each pixel sees, and the spectra of what is seen. */
#ifndef UMBRA_OPTICS_IMAGE_H
#define UMBRA_OPTICS_IMAGE_H

#include "optics/radiance/optics.h"

#define UM_OPTICS_IMAGE_WIDTH   16384
#define UM_OPTICS_IMAGE_SAMPLES 4096
#define UM_OPTICS_IMAGE_BYTES   4294967296.0 /* of one picture, 4 GiB */

/* Samples of a pixel that met one surface, and those of them that the Sun lights. */
struct um_optics_image_share {
  uint32_t spectrum; /* of the picture */
  uint16_t seen, lit;
};
/* The pixels of a line from the first to the last that sees something. */
struct um_optics_image_row {
  uint32_t from, count;
  uint32_t *first; /* [count + 1] shares of pixel from + i: first[i] up to first[i + 1] */
  struct um_optics_image_share *share; /* [first[count]] */
};
/* Orthographic toward the observer; row 0 on top. Radiance of a pixel in a bin:
 *   L = sum over its shares of (seen dark + lit sun) / samples
 * Rays do not depend on wavelength: all bands share them, and 2000 bins cost spectra of surfaces,
 * not pixels. */
struct um_optics_image {
  int width, height, samples;
  double pixel_size; /* [m] on the satellite */
  size_t nbin, nband;
  size_t *first;                  /* [nband + 1] first bin of each band */
  double *wavelength, *bin_width; /* [nbin] [m] */
  double *transmission;           /* [nbin] of the band's filter, not in the radiance [1] */
  size_t nspectrum;
  uint32_t *surface; /* [nspectrum] of the geometry, ascending */
  float *dark;       /* [nspectrum][nbin] radiance without direct sunlight [W/m^2/sr/m] */
  float *sun;        /* [nspectrum][nbin] what direct sunlight adds [W/m^2/sr/m] */
  struct um_optics_image_row *row; /* [height] */
};
struct um_optics_image_options {
  int width; /* pixels; height follows; square pixels */
  int samples_per_pixel;
  struct um_vec3 up_gcrs; /* direction that points up in the picture [1] */
};
/* One specular lobe, shadows by rays to points of the Sun's disc, inter-reflection as facet means
 * when the scene asks for it; the same radiance as the light curve, so that the sum over pixels
 * times pixel area is its intensity, within the sampling error of the outline.
 * time: index of the sample in the scene; the view is not used and may be NULL. UM_ERR_INPUT: width
 * outside 1..16384, samples outside 1..4096, `up` along the line of sight, more than
 * UM_OPTICS_IMAGE_BYTES. Same bytes for any number of threads. The caller destroys. */
enum um_status um_optics_image_render(struct um_context *context,
                                      const struct um_optics_scene *scene, size_t time,
                                      const struct um_optics_band *bands, size_t nband,
                                      const struct um_optics_image_options *options,
                                      struct um_optics_image **out);
void um_optics_image_destroy(struct um_context *context, struct um_optics_image **image);

/* What a picture will cost, told from a few of its lines. */
struct um_optics_image_cost {
  int width, height;
  double pixel_size; /* [m] */
  double covered;    /* share of the pixels that see something [1] */
  double bytes;      /* of the picture and of the rendering, at most [bytes] */
  double seconds;    /* of tracing, on this machine as it is now [s] */
};
/* Needs geometry and samples of the scene alone, so it comes before heat and light. Errors as of
 * um_optics_image_render; too many bytes are no error here. */
enum um_status um_optics_image_estimate(struct um_context *context,
                                        const struct um_optics_scene *scene, size_t time,
                                        const struct um_optics_band *bands, size_t nband,
                                        const struct um_optics_image_options *options,
                                        struct um_optics_image_cost *out);

/* Radiances of pixels [from, from + count) of a line in bins [bin, bin + nbin): out[i * stride + b]
 * [W/m^2/sr/m]. */
struct um_optics_image_span {
  int y, from, count;
  size_t bin, nbin, stride;
};
void um_optics_image_expand(const struct um_optics_image *image,
                            const struct um_optics_image_span *span, float *out);
/* Sums over bins with weights [nbin], taken once per spectrum: out[nspectrum][2], dark and what
 * sunlight adds, in units of weight times [W/m^2/sr/m]. */
void um_optics_image_weigh(const struct um_optics_image *image, const double *weight,
                           double (*out)[2]);
/* Such a sum at a pixel. */
double um_optics_image_pixel(const struct um_optics_image *image, const double (*weighed)[2], int x,
                             int y);
/* Shares of a pixel; *count 0: it sees nothing. */
const struct um_optics_image_share *um_optics_image_shares(const struct um_optics_image *image,
                                                           int x, int y, size_t *count);
/* Half of the pixel or more sees a surface. */
bool um_optics_image_covered(const struct um_optics_image *image, int x, int y);
/* What a share q of the samples that see a surface does not exceed, of a weighed sum: 0.99 leaves
 * the brightest hundredth above it. 0 where nothing is seen. UM_ERR_MEMORY. */
enum um_status um_optics_image_quantile(struct um_context *context,
                                        const struct um_optics_image *image,
                                        const double (*weighed)[2], double q, double *out);

#endif
