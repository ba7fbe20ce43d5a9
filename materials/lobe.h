/* The geometric half of a BSDF: a lobe of which every facet or ray reflects F = 1.
 *
 *   f_r(i, o, lambda) = diffuse parts + F(cos_d, lambda) f(i, o)
 *
 * f [1/sr] does not depend on wavelength, F [1] of the record not on the surface: at one instant
 * cos_d is the same for all surfaces, so light curves sum f and multiply by spectra afterwards
 * (docs/decisions/0011-lobes.md). Directions are unit vectors in the frame of the surface: z its
 * normal, x along the grain, and point away from it. A kind is one file, materials/lobe_NAME.c, and
 * one line of materials/lobes.def; tests/materials/conformance.c holds all of them to the same
 * laws. */
#ifndef UMBRA_MATERIALS_LOBE_H
#define UMBRA_MATERIALS_LOBE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/core/vec.h"

struct um_materials_lobe_kind;

struct um_materials_mixture;
struct um_materials_measured;

struct um_materials_lobe {
  const struct um_materials_lobe_kind *kind; /* NULL: the surface has no lobe */
  double alpha, alpha_across; /* roughness along x and along y [1]; equal where it is isotropic */
  bool correlated;            /* masking of both directions by the height of the facet */
  const struct um_materials_mixture *mixture; /* of kind mixture, borrowed; NULL of others */
  double tilted; /* of kind mixture: mean square slope that creases add to both, twice that per axis
                    [1] */
  const struct um_materials_measured *measured; /* of kind measured, borrowed; NULL of others */
  bool compensated; /* facets pass light on to each other, nothing of it is lost; else f is single
                       scattering. Kinds without Smith's masking are as they are (compensation.c) */
};

/* Two lobes at once, f = share f_1 + (1 - share) f_2, each alike all round. */
struct um_materials_mixture {
  double share; /* of the first [1] */
  struct {
    const struct um_materials_lobe_kind *kind; /* neither a mirror nor a mixture */
    double ratio; /* of its alpha to that of the mixture, which is the wider one [1] */
    bool correlated;
  } of[2];
};

/* A pair of directions as a lobe takes it. */
struct um_materials_pair {
  double cos_i, cos_o, cos_h;       /* with the normal; h: half vector [1] */
  double cos_d;                     /* between half vector and either direction [1] */
  double along_i, along_o, along_h; /* with x; read by anisotropic lobes alone [1] */
};
struct um_materials_pair um_materials_pair(struct um_vec3 i, struct um_vec3 o);
/* 1 - cosine of the angle between the observer and the mirror image of the source, without
 * cancellation: 2 cos_d^2 sin_h^2 + (cos_i - cos_o)^2/2. */
double um_materials_pair_offset(const struct um_materials_pair *pair);

/* A direction from which light is reflected to o. */
struct um_materials_reflected {
  struct um_vec3 i; /* [1] */
  double cos_d;     /* [1] */
  double weight; /* f cos_i over the density of i, of a mixture so in the mean over what comes from
                    i; 0 where i is below the surface [1] */
};

struct um_materials_lobe_kind {
  const char *name; /* of materials/lobes.def and `lobe: {kind: NAME}` */
  const char *summary, *reference;
  bool rough;       /* has a roughness */
  bool masked;      /* has Smith's masking in two forms */
  bool anisotropic; /* alpha_across may differ from alpha */
  double exponent;  /* alpha^2 times the exponent that may stand for it [1]; 0: none does */
  bool delta;       /* a mirror: f is no number, sunlit is */
  bool mixed;       /* made of others: needs a mixture */
  bool absorbs; /* what its albedo lacks of 1 is absorbed, not kept back by masking: f is a whole
                   BRDF, F a factor of it */
  /* f [1/sr]; 0 where a cosine is not positive. Reciprocal. */
  double (*evaluate)(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair);
  /* Mean of f over a disc of angular radius [rad] about the source: what a point Sun of that
   * irradiance would be replaced by [1/sr]. */
  double (*sunlit)(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair,
                   double sun_radius);
  /* A direction i for o is sampled in two steps, of which the first does not know o: two numbers of
   * [0, 1) become a vector (a facet's normal, or a turn from the mirror direction), smoothly. */
  struct um_vec3 (*draw)(const struct um_materials_lobe *lobe, double u, double v);
  /* What depends on o alone, handed to reflect; NULL: nothing. */
  double (*toward)(const struct um_materials_lobe *lobe, struct um_vec3 o);
  void (*reflect)(const struct um_materials_lobe *lobe, const struct um_vec3 *drawn, size_t n,
                  struct um_vec3 o, double toward, struct um_materials_reflected *out /* [n] */);
  /* Density of the facets' slopes, by r^2 = x^2/alpha^2 + y^2/alpha_across^2, int dx dy over the
   * alphas 1; NULL where f is no D G/(4 cos_i cos_o). */
  double (*slopes)(double r2);
  /* Density of sampled directions [1/sr]. */
  double (*density)(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair);
};

/* A lobe of which the facets are tilted further, by slopes of a mean square per axis: alpha^2 + 2
 * s^2 (docs/physics/creases.md), exact for Beckmann's, whose facets have normal slopes: those of
 * two heights that are added add. A mirror becomes Beckmann's of that alpha; kinds without
 * roughness stay, and all with 0. */
struct um_materials_lobe um_materials_lobe_tilted(const struct um_materials_lobe *lobe,
                                                  double slope_variance);

/* Flat patches of a surface that each carry the lobe, tilted (geometry/creases.h). */
struct um_materials_patches {
  const float *along, *across; /* [n] their slopes along x and along y [1] */
  const float *share;          /* [n] of the surface; sum 1 [1] */
  size_t n;
};
/* Sunlit f of a surface of patches, the mean over them:
 *
 *   f = D(h) G(i, o)/(4 cos_i cos_o),  D(h) = sum_k share_k P(h - slopes_k)/cos_h^4
 *
 * P the distribution of the slopes of a patch's own lobe, widened by the Sun's disc, G the masking
 * of `tilted`, um_materials_lobe_tilted of it, whose f is the mean over all patches that could be.
 * Reciprocal, int D cos = 1. Kinds that have no
 * distribution of slopes give the f of `tilted`. across_h: component of the half vector across the
 * grain; along_h of the pair is read for all kinds. Test: materials/creases. */
double um_materials_lobe_patches(const struct um_materials_lobe *lobe,
                                 const struct um_materials_lobe *tilted,
                                 const struct um_materials_pair *pair, double across_h,
                                 double sun_radius, const struct um_materials_patches *patches);

/* All kinds, in the order of the list; NULL beyond. */
size_t um_materials_lobe_kind_count(void);
const struct um_materials_lobe_kind *um_materials_lobe_kind_at(size_t index);
const struct um_materials_lobe_kind *um_materials_lobe_kind_find(const char *name);

static inline bool um_materials_lobe_is_anisotropic(const struct um_materials_lobe *lobe)
{
  return lobe->alpha != lobe->alpha_across;
}

/* Is int f cos_i dw_i 1 toward every o, within 5e-3, by facets that pass light on? */
bool um_materials_lobe_is_whole(const struct um_materials_lobe *lobe);

/* What the samples for o have in common. */
static inline double um_materials_lobe_toward(const struct um_materials_lobe *lobe,
                                              struct um_vec3 o)
{
  return lobe->kind->toward != NULL ? lobe->kind->toward(lobe, o) : 0.0;
}

/* Takes the samples of a quadrature: cos_d and its share of the directional albedo. */
typedef void (*um_materials_lobe_sink)(void *self, double cos_d, double weight);
/* Directional albedo int f cos_i dw_i toward o by nu x nv samples; sink may be NULL. */
double um_materials_lobe_quadrature(const struct um_materials_lobe *lobe, struct um_vec3 o, int nu,
                                    int nv, um_materials_lobe_sink sink, void *self);
/* The same toward a cosine above 0, the mean over azimuths; 384 x 24 are good to 2e-4
 * (test: materials/conformance). */
double um_materials_lobe_mean(const struct um_materials_lobe *lobe, double cosine, int nu, int nv,
                              um_materials_lobe_sink sink, void *self);
/* Directional albedo toward a cosine, the mean over azimuths; of the Beckmann lobe with separable
 * masking from its table (2e-4, roughness to 1.5, constant above); 1 of a whole one. Never above 1,
 * but of a measured table that is. */
double um_materials_lobe_albedo(const struct um_materials_lobe *lobe, double cosine);

#endif
