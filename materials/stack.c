/* Reflectance of layers on an opaque substrate, some thick, some so thin that light interferes.
 *
 * Coherent layers that lie on each other are one matrix for s and one for p, which takes tangential
 * E and H from the back of a layer to its front (Born & Wolf 1999, 1.6.2; Macleod 2010, ch. 2):
 *   M = [cos delta, -i sin delta/Y; -i Y sin delta, cos delta],  delta = 2 pi q d/lambda
 *   Y = q (s), eta^2/q (p),  q = sqrt(eta^2 - sin^2 theta)
 *   (B, C) = M_1 ... M_n (1, Y_b),  r = (Y_a B - C)/(Y_a B + C)
 *   T = 4 Re Y_a Re Y_b/|Y_a B + C|^2
 * with a before and b behind. M exp(i delta) has no growing terms, whatever is absorbed:
 *   [1 + e, (1 - e)/Y; Y (1 - e), 1 + e]/2,  e = exp(2 i delta)
 * and the same numbers with M_11 and M_22 exchanged are the stack from behind.
 * Between thick layers intensities add (Byrnes, arXiv 1603.02720, sec. 4), from the substrate up:
 *   R = R_f + T^2 t^2 R_below/(1 - R_b t^2 R_below),  t = exp(-4 pi Im(q) d/lambda)
 * An interface between two thick layers passes on 1 - R, as a sheet's does (fresnel.c): T by its
 * own formula has a mixed term where both absorb, of second order in k/n. One layer alone is Airy's
 * formula or the sheet of fresnel.c. */
#include <assert.h>
#include <math.h>

#include "base/core/constants.h"
#include "materials/bsdf.h"

/* What a layer or half-space is at one wavelength and angle. */
struct medium {
  double complex eta2, q;
  double complex e; /* exp(2 i delta) of a coherent layer */
  double pass;      /* t of a thick one */
  bool coherent;
};

/* From the front and from behind; both pass on the same. */
struct packet {
  double front, back, through;
};

static const double nearly_grazing = 1e-8;

static double norm(double complex z) { return creal(z) * creal(z) + cimag(z) * cimag(z); }

static struct medium medium_of(double n, double k, double cos_theta)
{
  double complex eta = n + k * I;
  struct medium m = {.eta2 = eta * eta};
  m.q = csqrt(m.eta2 - (1.0 - cos_theta) * (1.0 + cos_theta));
  if (cimag(m.q) < 0.0) m.q = -m.q;
  if (norm(m.q) < nearly_grazing * nearly_grazing) m.q = nearly_grazing;
  return m;
}

static struct medium layer_of(const struct um_materials_layer *layer, double wavelength,
                              double cos_theta)
{
  struct medium m = medium_of(layer->n, layer->k, cos_theta);
  double waves = 4.0 * UM_PI * layer->thickness / wavelength;
  m.coherent = layer->coherent;
  if (m.coherent)
    m.e = cexp(I * m.q * waves);
  else
    m.pass = exp(-cimag(m.q) * waves);
  return m;
}

/* Y */
static double complex admittance(const struct medium *m, bool p)
{
  return p ? m->eta2 / m->q : m->q;
}

/* The n coherent layers behind m[0], up to m[n + 1]. */
static struct packet coherent(const struct medium *m, size_t n, bool p)
{
  double complex ya = admittance(&m[0], p), yb = admittance(&m[n + 1], p);
  double complex m11 = 1.0, m12 = 0.0, m21 = 0.0, m22 = 1.0;
  double kept = 1.0;
  for (size_t i = 1; i <= n; i++) {
    double complex y = admittance(&m[i], p), c = 0.5 * (1.0 + m[i].e), s = 0.5 * (1.0 - m[i].e);
    double complex a11 = m11 * c + m12 * y * s, a12 = m11 * s / y + m12 * c;
    double complex a21 = m21 * c + m22 * y * s, a22 = m21 * s / y + m22 * c;
    m11 = a11, m12 = a12, m21 = a21, m22 = a22;
    kept *= cabs(m[i].e);
  }
  double complex front = ya * (m11 + m12 * yb), front_c = m21 + m22 * yb;
  double complex back = yb * (m22 + m12 * ya), back_c = m21 + m11 * ya;
  struct packet out = {norm(front - front_c) / norm(front + front_c),
                       norm(back - back_c) / norm(back + back_c), 0.0};
  out.through =
      n == 0 ? 1.0 - out.front : 4.0 * creal(ya) * creal(yb) * kept / norm(front + front_c);
  out.through = fmax(0.0, fmin(out.through, 1.0 - fmax(out.front, out.back)));
  return out;
}

/* From the substrate m[n + 1] up to the vacuum m[0]. */
static struct um_materials_passed stack_of(const struct medium *m, size_t n, bool p)
{
  struct um_materials_passed below = {0.0, 1.0};
  double pass = 1.0; /* through the thick layer that was met last */
  size_t behind = n + 1;
  for (;;) {
    size_t before = behind - 1;
    while (before > 0 && m[before].coherent) before--;
    struct packet here = coherent(m + before, behind - before - 1, p);
    if (behind == n + 1) {
      below = (struct um_materials_passed){here.front, here.through};
    } else {
      double returned = below.reflected * pass * pass, again = 1.0 - here.back * returned;
      below.transmitted *= here.through * pass / again;
      below.reflected = here.front + here.through * here.through * returned / again;
    }
    if (before == 0) return below;
    pass = m[before].pass;
    behind = before;
  }
}

struct um_materials_passed um_materials_stack_passes(const struct um_materials_layer *layer,
                                                     size_t n, double ns, double ks,
                                                     double wavelength, double cos_theta)
{
  struct medium m[UM_MATERIALS_LAYERS + 2];
  double c = fmin(cos_theta, 1.0);
  assert(wavelength > 0.0 && n <= UM_MATERIALS_LAYERS);
  if (!(cos_theta > nearly_grazing)) return (struct um_materials_passed){1.0, 0.0};
  m[0] = medium_of(1.0, 0.0, c);
  for (size_t i = 0; i < n; i++) m[i + 1] = layer_of(&layer[i], wavelength, c);
  m[n + 1] = medium_of(ns, ks, c);
  struct um_materials_passed s = stack_of(m, n, false), p = stack_of(m, n, true);
  return (struct um_materials_passed){0.5 * (s.reflected + p.reflected),
                                      0.5 * (s.transmitted + p.transmitted)};
}

double um_materials_fresnel_stack(const struct um_materials_layer *layer, size_t n, double ns,
                                  double ks, double wavelength, double cos_theta)
{
  if (n == 0) return um_materials_fresnel(ns, ks, cos_theta);
  if (n == 1)
    return (layer->coherent ? um_materials_fresnel_film : um_materials_fresnel_sheet)(
        layer->n, layer->k, layer->thickness, ns, ks, wavelength, cos_theta);
  return um_materials_stack_passes(layer, n, ns, ks, wavelength, cos_theta).reflected;
}
