/* Paths of one surface that are traced together. Private to optics/paths/. */
#ifndef UMBRA_OPTICS_BUNDLE_IMPL_H
#define UMBRA_OPTICS_BUNDLE_IMPL_H

#include "base/core/sampling.h"
#include "optics/paths/photons_group.h"

/* Keys that keep the point sequences of different uses apart. */
enum { UM_OPTICS_KEY_RAY = 0x726179, UM_OPTICS_KEY_WAY = 0x776179 };

struct um_optics_bundle {
  struct um_optics_paths paths;
  struct um_optics_photons *photons;
  double worth; /* what a path's radiance adds to the intensity [m^2] */
  uint64_t key; /* of seed, surface and instant: um_optics_path_key */
  bool known;   /* all of them are seen, and meet something where they first turn */
  int n, alive;
  int of[UM_OPTICS_PATHS];          /* [alive] */
  uint32_t sample[UM_OPTICS_PATHS]; /* [n], like what follows */
  bool mirrors[UM_OPTICS_PATHS];    /* nothing else so far */
  struct um_optics_vertex vertex[UM_OPTICS_PATHS];
  struct um_optics_turn turn[UM_OPTICS_PATHS];
  struct um_geometry_hit hit[UM_OPTICS_PATHS];
};

static inline double *um_optics_bundle_throughput(const struct um_optics_bundle *p, int i)
{
  return p->paths.work->throughput + (size_t)i * p->paths.spectra->nbin;
}
static inline double *um_optics_bundle_gathered(const struct um_optics_bundle *p, int i)
{
  return p->paths.work->gathered + (size_t)i * p->paths.spectra->nbin;
}

/* Of throughput, what mirrors alone have passed on. */
static inline double *um_optics_bundle_mirrored(const struct um_optics_bundle *p, int i)
{
  return p->paths.work->mirrored + (size_t)i * p->paths.spectra->nbin;
}

static inline double um_optics_bundle_number(const struct um_optics_bundle *p, int i, int vertex,
                                             uint64_t use)
{
  uint64_t key = um_core_hash(um_core_hash(p->key, p->sample[i]), (uint64_t)vertex);
  return um_core_hash_uniform(um_core_hash(key, use));
}

/* Weighted mean over a band [W/m^2/sr], or its unit times that of the row. */
static inline double um_optics_band_sum(const struct um_optics_spectra *s, size_t k,
                                        const double *row)
{
  double sum = 0.0;
  for (size_t b = s->first[k]; b < s->first[k + 1]; b++)
    sum += row[b] * s->transmission[b] * s->width[b];
  return sum;
}

/* first_turns.c: numbers of a surface's paths at an instant. */
uint64_t um_optics_path_key(const struct um_optics_paths *paths, size_t surface);
/* Where a path first turns: u, and what chooses between lobe and cosine [1]. */
double um_optics_bundle_first(const struct um_optics_bundle *bundle, uint32_t sample, double u[2]);
/* The next paths of a surface from *next on, of nsample in all, without those that are known to
 * bring nothing; false: none is left. */
bool um_optics_bundle_fill(struct um_optics_bundle *bundle, size_t surface, uint32_t *next,
                           uint32_t nsample);
/* Points of the surface that the observer sees. */
void um_optics_bundle_begin(struct um_optics_bundle *bundle, size_t surface, double seen);
/* path_sun.c: sunlight at the vertices that paths have come to, straight from the Sun and by way of
 * mirrors; vertex: how many there were before. */
void um_optics_bundle_add_sun(struct um_optics_bundle *bundle, int vertex);
void um_optics_bundle_add_photons(struct um_optics_bundle *bundle, int vertex);
/* What the surface where paths begin scatters of its photons, into work->reflected. */
void um_optics_bundle_add_seen_photons(struct um_optics_bundle *bundle, size_t surface,
                                       double seen);

#endif
