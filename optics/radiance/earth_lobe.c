/* L_r/L_E of a lobe (docs/physics/earthlight.md): directions i are sampled as its kind says
 * (materials/lobe.h), facets h of Beckmann's so that
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
#include "optics/radiance/earth_lobe_impl.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "base/core/vec.h"

#define UPRIGHT 1e-9 /* sine of an angle of which the azimuth does not matter */

double um_optics_fresnel_node(int node)
{
  double x = node / (UM_OPTICS_FRESNEL_NODES - 1.0);
  return x * x;
}

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

/* With x toward the observer. */
static struct um_optics_frame frame_of(const struct um_optics_earth_before *b)
{
  struct um_optics_frame f;
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

double um_optics_earth_lit(struct um_vec3 nadir, struct um_vec3 sun, double h, struct um_vec3 i,
                           double cos_eta)
{
  double root = 1.0 - h * h * (1.0 - cos_eta * cos_eta);
  double t = h * cos_eta - sqrt(fmax(root, 0.0));
  return fmax(0.0, um_vec3_dot(um_vec3_axpy(um_vec3_scale(nadir, -h), t, i), sun));
}

/* What a half vector brings. */
struct facet {
  struct um_vec3 i;
  double weight; /* of the lobe */
  double cosine; /* o.h */
  double inside; /* i.nadir - cos(rho) */
};

/* How the Earth lies about the surface. */
struct view {
  const struct um_optics_earth_before *before;
  struct um_optics_frame f;
  double h, cos_rho; /* r/R, cosine of the Earth's half width */
};

/* A ring of them. */
static void ring_at(const struct view *view, const struct um_optics_lobe_facets *facets,
                    double toward, int ring, struct facet *out)
{
  const struct um_optics_frame *f = &view->f;
  struct um_materials_reflected r[UM_OPTICS_LOBE_CELLS_MAX];
  const struct um_materials_lobe *lobe = &facets->lobe;
  size_t n = (size_t)facets->cells;
  lobe->kind->reflect(lobe, facets->half + (size_t)ring * n, n, f->observer, toward, r);
  for (size_t k = 0; k < n; k++) {
    out[k] = (struct facet){.i = r[k].i,
                            .weight = r[k].weight,
                            .cosine = r[k].cos_d,
                            .inside = um_vec3_dot(r[k].i, f->nadir) - view->cos_rho};
  }
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

int um_optics_fresnel_weights(double cosine, double weight[4])
{
  double at = sqrt(fmin(fmax(cosine, 0.0), 1.0)) * (UM_OPTICS_FRESNEL_NODES - 1);
  int k = (int)at;
  if (k < 1) k = 1;
  if (k > UM_OPTICS_FRESNEL_NODES - 3) k = UM_OPTICS_FRESNEL_NODES - 3;
  double f = at - k;
  weight[0] = -f * (f - 1.0) * (f - 2.0) / 6.0;
  weight[1] = (f + 1.0) * (f - 1.0) * (f - 2.0) / 2.0;
  weight[2] = -(f + 1.0) * f * (f - 2.0) / 2.0;
  weight[3] = (f + 1.0) * f * (f - 1.0) / 6.0;
  return k - 1;
}

static void spread(const double weight[4], double w, double *node)
{
  for (int p = 0; p < 4; p++) node[p] += w * weight[p];
}

void um_optics_lobe_facets_fill(struct um_optics_lobe_facets *facets)
{
  const struct um_materials_lobe *lobe = &facets->lobe;
  for (int k = 0; k < facets->rings; k++)
    for (int j = 0; j < facets->cells; j++)
      facets->half[k * facets->cells + j] =
          lobe->kind->draw(lobe, (k + 0.5) / facets->rings, (0.25 + j) / facets->cells);
}

/* What the Earth sends from where a facet looks, w of the lobe. */
static void add_earth(const struct view *view, const struct facet *facet, int first,
                      const double weight[4], double w, struct um_optics_earth_lobe *out)
{
  const struct um_environment_earth_seen *seen = view->before->seen;
  double lit = um_optics_earth_lit(view->f.nadir, view->f.sun, view->h, facet->i,
                                   facet->inside + view->cos_rho);
  spread(weight, w, out->earth + first);
  if (seen != NULL) {
    unsigned short node[4];
    double share[4], albedo = 0.0;
    um_environment_earth_seen_at(&view->before->axes, facet->i, node, share);
    for (int k = 0; k < 4; k++) {
      albedo += share[k] * seen->ground[node[k]].albedo;
      out->where[node[k]] += w * share[k];
    }
    lit *= albedo;
  }
  if (lit > 0.0) spread(weight, w * lit, out->lit + first);
}

/* What a ring of facets brings; low and high: the rings below and above it, or itself. */
static void add_ring(const struct view *view, const struct facet *low, const struct facet *ring,
                     const struct facet *high, int cells, double share,
                     struct um_optics_earth_lobe *out)
{
  for (int j = 0; j < cells; j++) {
    const struct facet *now = &ring[j];
    if (!(now->weight > 0.0)) continue;
    const struct facet *last = &ring[j > 0 ? j - 1 : cells - 1];
    const struct facet *next = &ring[j + 1 < cells ? j + 1 : 0];
    double along = 0.5 * (next->inside - last->inside), across = high[j].inside - low[j].inside;
    if (low != ring && high != ring) across *= 0.5;
    double w = share * now->weight, inside = share_inside(now->inside, along, across);
    double weight[4];
    int node = um_optics_fresnel_weights(now->cosine, weight);
    spread(weight, w, out->all + node);
    if (inside > 0.0) add_earth(view, now, node, weight, w * inside, out);
  }
}

void um_optics_earth_lobe(const struct um_optics_earth_before *before,
                          const struct um_optics_lobe_facets *facets,
                          struct um_optics_earth_lobe *out)
{
  struct facet row[3][UM_OPTICS_LOBE_CELLS_MAX];
  struct view view = {.before = before, .h = fmax(before->h_ratio, 1.0)};
  memset(out, 0, before->seen != NULL ? sizeof *out : offsetof(struct um_optics_earth_lobe, where));
  if (!(before->normal_observer > 0.0)) return;
  view.f = before->grain != NULL ? *before->grain : frame_of(before);
  view.cos_rho = sqrt(fmax(0.0, 1.0 - 1.0 / (view.h * view.h)));
  double toward = um_materials_lobe_toward(&facets->lobe, view.f.observer);
  int cells = facets->cells;
  for (int k = -1; k < facets->rings; k++) {
    if (k + 1 < facets->rings) ring_at(&view, facets, toward, k + 1, row[(k + 1) % 3]);
    if (k < 0) continue;
    const struct facet *low = row[(k > 0 ? k - 1 : k) % 3];
    const struct facet *ring = row[k % 3];
    const struct facet *high = row[(k + 1 < facets->rings ? k + 1 : k) % 3];
    add_ring(&view, low, ring, high, cells, 1.0 / (facets->rings * cells), out);
  }
}
