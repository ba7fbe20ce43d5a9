/* Reflection models: Lambert and Cook-Torrance with Beckmann facets; Fresnel; roughness. */
#ifndef UMBRA_MATERIALS_BSDF_H
#define UMBRA_MATERIALS_BSDF_H

#include <complex.h>

/* Unpolarised Fresnel reflectance of an interface from vacuum to index n + i k. */
double um_materials_fresnel(double n, double k, double cos_theta);
/* Opaque sheet of thickness d [m], index n + i k, on a substrate ns + i ks, incoherent sum of
 * the passes, unpolarised (s and p summed apart). wavelength [m]. */
double um_materials_fresnel_sheet(double n, double k, double thickness, double ns, double ks,
                                  double wavelength, double cos_theta);
/* The same of a film that light is coherent through: amplitudes add, colours of thin films. */
double um_materials_fresnel_film(double n, double k, double thickness, double ns, double ks,
                                 double wavelength, double cos_theta);
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
