/* L_r/L_E of a lobe, in half vectors (PHYSICS D.5): facets h are spread so that
 *
 *   tan^2(theta_h) = -alpha^2 ln(1 - u),  u and phi uniform,
 *
 * each mirrors what comes from i = 2 (o.h) h - o, and the lobe is the mean of
 *
 *   F(o.h) G(i, o) (o.h)/(cos_o cos_h)   where cos_i > 0.
 *
 * The Earth is the cap i.nadir > cos(rho), sin(rho) = R/r. The Sun's zenith angle is that at the
 * place p = -nadir r/R + t i that the ray meets, t = (r cos(eta) - sqrt(R^2 - r^2 sin^2(eta)))/R.
 */
#include "optics/earth_lobe_impl.h"

#include <math.h>
#include <string.h>

#include "core/constants.h"
#include "core/vec.h"
#include "materials/bsdf.h"

#define UNMASKED 4.0  /* cotangent over alpha beyond which masking is below 1e-9 */
#define NEAR     -0.2 /* cosine outside the Earth beyond which no part of a cell is inside */
#define UPRIGHT  1e-9 /* sine of an angle of which the azimuth does not matter */

double um_optics_fresnel_node(int node)
{
  double x = node / (UM_OPTICS_FRESNEL_NODES - 1.0);
  return x * x;
}

/* The frame of the surface: z its normal, x toward the observer. */
struct frame {
  struct um_vec3 observer, nadir, sun;
};

/* Unit vector of given cosines with z, with a known vector a (of z and x alone) and, for the sign
 * and size of y, with b. */
static struct um_vec3 place(double with_z, double with_a, struct um_vec3 a)
{
  double x = fabs(a.x) > UPRIGHT ? (with_a - a.z * with_z) / a.x : 0.0;
  double rest = fmax(0.0, 1.0 - with_z * with_z);
  x = fmin(fmax(x, -sqrt(rest)), sqrt(rest));
  if (!(fabs(a.x) > UPRIGHT)) x = sqrt(rest);
  return um_vec3(x, sqrt(fmax(0.0, rest - x * x)), with_z);
}

static struct frame frame_of(const struct um_optics_earth_before *b)
{
  struct frame f;
  double sine = sqrt(fmax(0.0, 1.0 - b->normal_observer * b->normal_observer));
  f.observer = um_vec3(sine, 0.0, b->normal_observer);
  f.nadir = place(b->normal_nadir, b->observer_nadir, f.observer);
  if (sine > UPRIGHT) {
    f.sun = place(b->normal_sun, b->observer_sun, f.observer);
  } else { /* the azimuth counts from the nadir */
    f.sun = place(b->normal_sun, b->nadir_sun, f.nadir);
  }
  double same = um_vec3_dot(f.nadir, f.sun), other = same - 2.0 * f.nadir.y * f.sun.y;
  if (fabs(other - b->nadir_sun) < fabs(same - b->nadir_sun)) f.sun.y = -f.sun.y;
  return f;
}

static double masking(double alpha, double cosine)
{
  if (!(cosine > 0.0)) return 0.0;
  double sine2 = 1.0 - cosine * cosine;
  if (cosine * cosine > UNMASKED * UNMASKED * alpha * alpha * sine2) return 1.0;
  return um_materials_beckmann_masking(alpha, cosine);
}

/* Cosine of the Sun's zenith angle where the direction meets the Earth; 0 in the dark. */
static double lit_at(const struct frame *f, double h, struct um_vec3 i, double cos_eta)
{
  double root = 1.0 - h * h * (1.0 - cos_eta * cos_eta);
  double t = h * cos_eta - sqrt(fmax(root, 0.0));
  return fmax(0.0, um_vec3_dot(um_vec3_axpy(um_vec3_scale(f->nadir, -h), t, i), f->sun));
}

/* What a half vector brings. */
struct facet {
  double weight; /* of the lobe */
  double cosine; /* o.h */
  double inside; /* i.nadir - cos(rho) */
  double lit;
};

static struct facet facet_at(const struct frame *f, double alpha, double g_o, double h_ratio,
                             double cos_rho, struct um_vec3 h)
{
  struct facet facet = {.cosine = um_vec3_dot(f->observer, h)};
  struct um_vec3 i = um_vec3_axpy(um_vec3_scale(f->observer, -1.0), 2.0 * facet.cosine, h);
  double cos_eta = um_vec3_dot(i, f->nadir);
  facet.inside = cos_eta - cos_rho;
  if (!(facet.cosine > 0.0) || !(i.z > 0.0)) return facet;
  facet.weight = g_o * masking(alpha, i.z) * facet.cosine / (f->observer.z * h.z);
  facet.lit = facet.inside > NEAR ? lit_at(f, h_ratio, i, cos_eta) : 0.0;
  return facet;
}

/* Share of a cell in which a function is positive that is g at the middle and differs by a and b
 * from side to side: the distribution of the sum of two uniform variables. */
static double share_inside(double g, double a, double b)
{
  double wide = fmax(fabs(a), fabs(b)), narrow = fmin(fabs(a), fabs(b));
  double t = g + 0.5 * (wide + narrow);
  if (!(t > 0.0)) return 0.0;
  if (t >= wide + narrow) return 1.0;
  if (t < narrow) return t * t / (2.0 * wide * narrow);
  if (t <= wide) return (t - 0.5 * narrow) / wide;
  t = wide + narrow - t;
  return 1.0 - t * t / (2.0 * wide * narrow);
}

/* Adds w to the nodes around a cosine, by Lagrange's weights in its square root. */
static void spread(double cosine, double w, double *node)
{
  double at = sqrt(fmin(fmax(cosine, 0.0), 1.0)) * (UM_OPTICS_FRESNEL_NODES - 1);
  int k = (int)at;
  if (k < 1) k = 1;
  if (k > UM_OPTICS_FRESNEL_NODES - 3) k = UM_OPTICS_FRESNEL_NODES - 3;
  double f = at - k;
  node[k - 1] -= w * f * (f - 1.0) * (f - 2.0) / 6.0;
  node[k] += w * (f + 1.0) * (f - 1.0) * (f - 2.0) / 2.0;
  node[k + 1] -= w * (f + 1.0) * f * (f - 2.0) / 2.0;
  node[k + 2] += w * (f + 1.0) * f * (f - 1.0) / 6.0;
}

void um_optics_lobe_facets_fill(struct um_optics_lobe_facets *facets)
{
  for (int k = 0; k < facets->rings; k++) {
    double tangent = facets->alpha * sqrt(-log1p(-(k + 0.5) / facets->rings));
    double cosine = 1.0 / sqrt(1.0 + tangent * tangent), sine = tangent * cosine;
    for (int j = 0; j < facets->cells; j++) {
      double phi = 2.0 * UM_PI * (0.25 + j) / facets->cells;
      facets->half[k * facets->cells + j] = um_vec3(sine * cos(phi), sine * sin(phi), cosine);
    }
  }
}

/* What a ring of facets brings; low and high: the rings below and above it, or itself. */
static void add_ring(const struct facet *low, const struct facet *ring, const struct facet *high,
                     int cells, double share, struct um_optics_earth_lobe *out)
{
  for (int j = 0; j < cells; j++) {
    const struct facet *now = &ring[j];
    if (!(now->weight > 0.0)) continue;
    const struct facet *last = &ring[j > 0 ? j - 1 : cells - 1];
    const struct facet *next = &ring[j + 1 < cells ? j + 1 : 0];
    double along = 0.5 * (next->inside - last->inside), across = high[j].inside - low[j].inside;
    if (low != ring && high != ring) across *= 0.5;
    double w = share * now->weight, inside = share_inside(now->inside, along, across);
    spread(now->cosine, w, out->all);
    if (inside > 0.0) spread(now->cosine, w * inside, out->earth);
    if (inside * now->lit > 0.0) spread(now->cosine, w * inside * now->lit, out->lit);
  }
}

void um_optics_earth_lobe(const struct um_optics_earth_before *before,
                          const struct um_optics_lobe_facets *facets,
                          struct um_optics_earth_lobe *out)
{
  struct facet row[3][UM_OPTICS_LOBE_CELLS_MAX];
  memset(out, 0, sizeof *out);
  if (!(before->normal_observer > 0.0)) return;
  struct frame f = frame_of(before);
  double h = fmax(before->h_ratio, 1.0), cos_rho = sqrt(fmax(0.0, 1.0 - 1.0 / (h * h)));
  double alpha = facets->alpha, g_o = masking(alpha, f.observer.z);
  int cells = facets->cells;
  for (int k = -1; k < facets->rings; k++) {
    if (k + 1 < facets->rings)
      for (int j = 0; j < cells; j++)
        row[(k + 1) % 3][j] =
            facet_at(&f, alpha, g_o, h, cos_rho, facets->half[(k + 1) * cells + j]);
    if (k < 0) continue;
    const struct facet *low = row[(k > 0 ? k - 1 : k) % 3];
    const struct facet *ring = row[k % 3];
    const struct facet *high = row[(k + 1 < facets->rings ? k + 1 : k) % 3];
    add_ring(low, ring, high, cells, 1.0 / (facets->rings * cells), out);
  }
}
