/* Reflection models: Fresnel of interfaces and layers; Beckmann's facets; roughness. */
#ifndef UMBRA_MATERIALS_BSDF_H
#define UMBRA_MATERIALS_BSDF_H

#include <complex.h>
#include <stdbool.h>
#include <stddef.h>

/* Unpolarised Fresnel reflectance of an interface from vacuum to index n + i k. */
double um_materials_fresnel(double n, double k, double cos_theta);
/* Opaque sheet of thickness d [m], index n + i k, on a substrate ns + i ks, incoherent sum of
 * the passes, unpolarised (s and p summed apart). wavelength [m]. */
double um_materials_fresnel_sheet(double n, double k, double thickness, double ns, double ks,
                                  double wavelength, double cos_theta);
/* The same of a film that light is coherent through: amplitudes add, colours of thin films. */
double um_materials_fresnel_film(double n, double k, double thickness, double ns, double ks,
                                 double wavelength, double cos_theta);
#define UM_MATERIALS_LAYERS 16 /* on a substrate, at most */
/* A layer of index n + i k. */
struct um_materials_layer {
  double n, k;      /* [1] */
  double thickness; /* [m] */
  bool coherent;    /* so thin that light interferes in it */
};
/* The first n layers of that list, outermost first, on a substrate ns + i ks, unpolarised: what
 * returns and what reaches the substrate [1]; the rest stays in the layers. Coherent layers that
 * lie on each other interfere (characteristic matrices), passes between thick ones add as
 * intensities. Exact for coherent layers; between thick ones that absorb good to second order in
 * k/n. wavelength [m]. Test: materials/stack. */
struct um_materials_passed {
  double reflected, transmitted; /* [1] */
};
struct um_materials_passed um_materials_stack_passes(const struct um_materials_layer *layer,
                                                     size_t n, double ns, double ks,
                                                     double wavelength, double cos_theta);
/* Its reflectance; no layer: um_materials_fresnel, one: the sheet or the film above. */
double um_materials_fresnel_stack(const struct um_materials_layer *layer, size_t n, double ns,
                                  double ks, double wavelength, double cos_theta);
/* D(h) [1/sr], cosine from the normal; int D cos = 1. Beckmann & Spizzichino 1963. */
double um_materials_beckmann_distribution(double alpha, double cos_h);
/* Smith G1 for Beckmann, exact (erf) form. */
double um_materials_beckmann_masking(double alpha, double cos_theta);
/* D G / (4 cos_i cos_o) [1/sr], separable Smith, F = 1; 0 when a cosine is not positive. */
double um_materials_beckmann_lobe(double alpha, double cos_h, double cos_i, double cos_o);
/* Directional albedo of that lobe for F = 1, at cos_i, by quadrature; <= 1. */
double um_materials_beckmann_albedo(double alpha, double cos_i);
/* The same from a table to alpha 1.5, constant above; accurate to 2e-4, continuous slope in alpha.
 */
double um_materials_beckmann_albedo_tabulated(double alpha, double cos_i);
/* Table 1 of the Flying Laptop paper: alpha = sqrt(2) Rq / tau (same unit). */
double um_materials_roughness_alpha(double rq, double tau);

#endif
