/* Frames of a detector: a source in cells, its trail, the point spread function, pixels, noise. */
#include "optics/instrument/frame.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"

#define CELLS    3         /* of a pixel, an axis: its middle one is the pixel's */
#define ENCLOSED 0.9999999 /* of a point's light within the kernel, where 512 cells hold it */
#define DIRECT   30.0      /* mean up to which Poisson's numbers are drawn one by one */

struct grid {
  int width, height; /* cells */
  double cell;       /* [arcsec] */
  double *value;
};

/* Put light at a place [cells from the middle of cell 0], split between four cells so that its
 * centre of mass stays. */
static void put(const struct grid *g, double x, double y, double light)
{
  int i = (int)floor(x), j = (int)floor(y);
  double u = x - i, v = y - j;
  if (i < 0 || j < 0 || i + 1 >= g->width || j + 1 >= g->height) return;
  double *to = g->value + (size_t)j * (size_t)g->width + (size_t)i;
  to[0] += light * (1.0 - u) * (1.0 - v);
  to[1] += light * u * (1.0 - v);
  to[g->width] += light * (1.0 - u) * v;
  to[g->width + 1] += light * u * v;
}

/* One pixel of the source, along its trail: steps of half a cell at most. */
static void put_trail(const struct grid *g, const struct um_instrument_frame_options *o, double x,
                      double y, double light)
{
  double length = o->trail / g->cell;
  int n = 1 + (int)ceil(2.0 * length);
  for (int k = 0; k < n; k++) {
    double along = length * ((k + 0.5) / n - 0.5);
    put(g, x + along * cos(o->trail_angle), y - along * sin(o->trail_angle), light / n);
  }
}

static void gather(const struct um_instrument_source *s,
                   const struct um_instrument_frame_options *o, const struct grid *g)
{
  int parts = 1 + (int)(s->pixel / g->cell); /* large pixels in several */
  double scale = s->pixel / g->cell;
  for (int j = 0; j < s->height * parts; j++)
    for (int i = 0; i < s->width * parts; i++) {
      double rate = s->rate[(size_t)(j / parts) * (size_t)s->width + (size_t)(i / parts)];
      if (!(rate > 0.0)) continue;
      double x = ((i + 0.5) / parts - 0.5 * s->width) * scale + 0.5 * g->width - 0.5;
      double y = ((j + 0.5) / parts - 0.5 * s->height) * scale + 0.5 * g->height - 0.5;
      put_trail(g, o, x, y, rate * o->exposure / (parts * parts));
    }
}

/* Stars, and their electrons. */
static double gather_stars(const struct um_instrument_frame_options *o, const struct grid *g)
{
  double sum = 0.0;
  for (size_t i = 0; i < o->nstar; i++) {
    double light = o->star[i].rate * o->exposure;
    put(g, 0.5 * g->width - 0.5 + o->star[i].x / g->cell,
        0.5 * g->height - 0.5 - o->star[i].y / g->cell, light);
    sum += light;
  }
  return sum;
}

/* Every cell spreads its light; lines of the result are worked on apart from each other. */
static void spread(const struct um_context *context, const struct grid *from,
                   const struct um_instrument_kernel *kernel, const struct grid *to)
{
  int side = 2 * kernel->half + 1, width = from->width;
#pragma omp parallel for schedule(dynamic, 4) num_threads(um_core_context_threads(context))
  for (int y = 0; y < to->height; y++) {
    double *line = to->value + (size_t)y * (size_t)width;
    for (int j = y - kernel->half; j <= y + kernel->half && !um_core_stopped(context); j++) {
      if (j < 0 || j >= from->height) continue;
      const double *share = kernel->share + (size_t)(y - j + kernel->half) * (size_t)side;
      for (int i = 0; i < width; i++) {
        double light = from->value[(size_t)j * (size_t)width + (size_t)i];
        if (!(light > 0.0)) continue;
        int a = i - kernel->half < 0 ? 0 : i - kernel->half;
        int b = i + kernel->half >= width ? width - 1 : i + kernel->half;
        for (int x = a; x <= b; x++) line[x] += light * share[x - i + kernel->half];
      }
    }
  }
}

static enum um_status size_frame(struct um_context *context, const struct um_instrument_source *s,
                                 const struct um_instrument_frame_options *o, double reach,
                                 struct um_instrument_frame *out)
{
  double trail[2] = {o->trail * fabs(cos(o->trail_angle)), o->trail * fabs(sin(o->trail_angle))};
  double across = s->width * s->pixel + trail[0], up = s->height * s->pixel + trail[1];
  for (size_t i = 0; i < o->nstar; i++) {
    across = fmax(across, 2.0 * fabs(o->star[i].x));
    up = fmax(up, 2.0 * fabs(o->star[i].y));
  }
  double width = ceil((across + 2.0 * reach) / o->pixel) + 2.0 * o->border;
  double height = ceil((up + 2.0 * reach) / o->pixel) + 2.0 * o->border;
  if (!(width <= UM_INSTRUMENT_FRAME_SIDE && height <= UM_INSTRUMENT_FRAME_SIDE))
    return um_core_fail(context, UM_ERR_INPUT,
                        "frame of %g x %g pixels of %g arcsec; accepted: up to %d a side, by "
                        "larger pixels, a shorter trail or a narrower point spread function",
                        width, height, o->pixel, UM_INSTRUMENT_FRAME_SIDE);
  out->width = (int)width;
  out->height = (int)height;
  out->pixel = o->pixel;
  return um_core_allocate(context, (size_t)out->width * (size_t)out->height, sizeof(double),
                          &out->electrons);
}

static void sum_pixels(const struct grid *g, struct um_instrument_frame *frame)
{
  double held = 0.0;
  for (int y = 0; y < g->height; y++)
    for (int x = 0; x < g->width; x++) {
      double value = g->value[(size_t)y * (size_t)g->width + (size_t)x];
      frame->electrons[(size_t)(y / CELLS) * (size_t)frame->width + (size_t)(x / CELLS)] += value;
      held += value;
    }
  frame->outside = frame->source + frame->stars - held;
}

enum um_status um_instrument_frame_create(struct um_context *context,
                                          const struct um_instrument_source *source,
                                          const struct um_instrument_psf *psf,
                                          const struct um_instrument_frame_options *options,
                                          struct um_instrument_frame *out)
{
  struct um_instrument_kernel kernel = {0};
  struct grid from = {.cell = options->pixel / CELLS}, to;
  enum um_status status;
  *out = (struct um_instrument_frame){0};
  to = from;
  UM_CHECK(um_instrument_kernel_create(context, psf, from.cell, ENCLOSED, &kernel));
  UM_CHECK(size_frame(context, source, options, (kernel.half + 1) * from.cell, out));
  from.width = to.width = CELLS * out->width;
  from.height = to.height = CELLS * out->height;
  size_t n = (size_t)from.width * (size_t)from.height;
  UM_CHECK(um_core_allocate(context, n, sizeof(double), &from.value));
  UM_CHECK(um_core_allocate(context, n, sizeof(double), &to.value));
  for (size_t i = 0; i < (size_t)source->width * (size_t)source->height; i++)
    out->source += source->rate[i] * options->exposure;
  gather(source, options, &from);
  out->stars = gather_stars(options, &from);
  spread(context, &from, &kernel, &to);
  UM_CHECK(um_core_stop_check(context, "a frame was computed"));
  sum_pixels(&to, out);
done:
  um_instrument_kernel_clear(context, &kernel);
  UM_FREE(context, from.value, to.value);
  if (status != UM_OK) um_instrument_frame_clear(context, out);
  return status;
}

void um_instrument_frame_clear(struct um_context *context, struct um_instrument_frame *frame)
{
  um_core_free(context, frame->electrons);
  frame->electrons = NULL;
}

/* Numbers of one pixel: each call draws the next. */
struct stream {
  uint64_t key, count;
};

static double uniform(struct stream *s)
{
  return um_core_hash_uniform(um_core_hash(s->key, s->count++));
}

/* Box and Muller 1958. */
static double normal(struct stream *s)
{
  double u = 1.0 - uniform(s), v = uniform(s);
  return sqrt(-2.0 * log(u)) * cos(2.0 * UM_PI * v);
}

/* By multiplication (Knuth) up to DIRECT; beyond, m + sqrt(m - 5/36) z + (z^2 - 1)/6 rounded, which
 * has Poisson's mean, variance (1/18 of it by the square, 1/12 by rounding) and, to first order,
 * skewness (Cornish & Fisher 1938). */
static double poisson(struct stream *s, double mean)
{
  if (!(mean > 0.0)) return 0.0;
  if (mean <= DIRECT) {
    double limit = exp(-mean), product = uniform(s);
    int n = 0;
    while (product > limit) {
      product *= uniform(s);
      n++;
    }
    return n;
  }
  double z = normal(s);
  return fmax(0.0, floor(mean + sqrt(mean - 5.0 / 36.0) * z + (z * z - 1.0) / 6.0 + 0.5));
}

size_t um_instrument_frame_read(const struct um_instrument_frame *frame,
                                const struct um_instrument_readout *readout, float *counts)
{
  size_t saturated = 0, n = (size_t)frame->width * (size_t)frame->height;
  for (size_t i = 0; i < n; i++) {
    struct stream s = {um_core_hash(readout->seed, i), 0};
    double electrons = fmax(frame->electrons[i], 0.0) + readout->background;
    if (!readout->noiseless) electrons = poisson(&s, electrons);
    if (electrons > readout->saturation) {
      electrons = readout->saturation;
      saturated++;
    }
    if (!readout->noiseless) electrons += readout->read_noise * normal(&s);
    double value = electrons / readout->gain;
    counts[i] = (float)(readout->noiseless ? value : floor(value + 0.5));
  }
  return saturated;
}
