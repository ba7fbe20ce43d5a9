/* The list of lobes, and what is the same for all of them. */
#include "materials/lobe.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "materials/bsdf.h"
#include "materials/lobe_impl.h"
#include "materials/measured.h"

#define UM_LOBE(name) &um_materials_lobe_##name,
static const struct um_materials_lobe_kind *const kinds[] = {
#include "materials/lobes.def"
};
#undef UM_LOBE

size_t um_materials_lobe_kind_count(void) { return sizeof kinds / sizeof kinds[0]; }

const struct um_materials_lobe_kind *um_materials_lobe_kind_at(size_t index)
{
  return index < um_materials_lobe_kind_count() ? kinds[index] : NULL;
}

const struct um_materials_lobe_kind *um_materials_lobe_kind_find(const char *name)
{
  for (size_t k = 0; k < um_materials_lobe_kind_count(); k++)
    if (strcmp(kinds[k]->name, name) == 0) return kinds[k];
  return NULL;
}

struct um_materials_pair um_materials_pair(struct um_vec3 i, struct um_vec3 o)
{
  struct um_vec3 h = um_vec3_add(i, o);
  double length = um_vec3_norm(h);
  if (length > 0.0) h = um_vec3_scale(h, 1.0 / length);
  return (struct um_materials_pair){i.z, o.z, h.z, 0.5 * length, i.x, o.x, h.x};
}

/* With e the unit vector along i - o: i, o = cos_d h +- sin_d e, and n = cos_h h + (n.e) e + ...,
 * so that cos_i cos_o = cos_d^2 cos_h^2 - sin_d^2 (n.e)^2 and sin_d (n.e) = (cos_i - cos_o)/2;
 * mirror(i).o = 2 cos_i cos_o - i.o. */
double um_materials_pair_offset(const struct um_materials_pair *pair)
{
  double sin2 = (1.0 - pair->cos_h) * (1.0 + pair->cos_h), difference = pair->cos_i - pair->cos_o;
  return 2.0 * pair->cos_d * pair->cos_d * fmax(sin2, 0.0) + 0.5 * difference * difference;
}

/* u = s^2 (3 - 2 s) gathers points at both ends, where roughness has its peak and its tail; of a
 * mixture in each half of u, where its two lobes have theirs. */
static double quadrature(const struct um_materials_lobe *lobe, struct um_vec3 o, int nu, int nv,
                         double factor, um_materials_lobe_sink sink, void *self)
{
  const struct um_materials_lobe_kind *kind = lobe->kind;
  double toward = um_materials_lobe_toward(lobe, o), sum = 0.0;
  /* o in the plane y = 0 of an isotropic lobe: the other half is its mirror image */
  double turn = !um_materials_lobe_is_anisotropic(lobe) && o.y == 0.0 ? 0.5 : 1.0;
  int parts = kind->mixed ? 2 : 1;
  for (int j = 0; j < parts * nu; j++) {
    int part = j / nu;
    double s = (j % nu + 0.5) / nu, u = (part + s * s * (3.0 - 2.0 * s)) / parts,
           share = factor * 6.0 * s * (1.0 - s) / nu / nv / parts;
    for (int k = 0; k < nv; k++) {
      struct um_vec3 drawn = kind->draw(lobe, u, turn * (k + 0.5) / nv);
      struct um_materials_reflected r;
      kind->reflect(lobe, &drawn, 1, o, toward, &r);
      if (!(r.weight > 0.0)) continue;
      sum += share * r.weight;
      if (sink != NULL) sink(self, r.cos_d, share * r.weight);
    }
  }
  return sum;
}

double um_materials_lobe_quadrature(const struct um_materials_lobe *lobe, struct um_vec3 o, int nu,
                                    int nv, um_materials_lobe_sink sink, void *self)
{
  return quadrature(lobe, o, nu, nv, 1.0, sink, self);
}

double um_materials_lobe_mean(const struct um_materials_lobe *lobe, double cosine, int nu, int nv,
                              um_materials_lobe_sink sink, void *self)
{
  enum { AZIMUTHS = 4 };
  double s = sqrt((1.0 - cosine) * (1.0 + cosine)), sum = 0.0;
  if (um_materials_lobe_is_tabulated(lobe))
    return um_materials_beckmann_quadrature(lobe, cosine, nu, nv, sink, self);
  if (!um_materials_lobe_is_anisotropic(lobe))
    return um_materials_lobe_quadrature(lobe, um_vec3(s, 0.0, cosine), nu, nv, sink, self);
  for (int k = 0; k < AZIMUTHS; k++) { /* of a quarter; the others are its mirror images */
    double phi = 0.5 * UM_PI * (k + 0.5) / AZIMUTHS;
    struct um_vec3 o = um_vec3(s * cos(phi), s * sin(phi), cosine);
    sum += quadrature(lobe, o, nu, nv, 1.0 / AZIMUTHS, sink, self);
  }
  return sum;
}

double um_materials_lobe_albedo(const struct um_materials_lobe *lobe, double cosine)
{
  double c = fmax(1e-4, fmin(1.0, cosine));
  assert(lobe->kind != NULL);
  if (um_materials_lobe_is_whole(lobe)) return 1.0;
  if (um_materials_lobe_is_tabulated(lobe))
    return um_materials_beckmann_albedo_tabulated(lobe->alpha, cosine);
  if (lobe->measured != NULL) return um_materials_measured_albedo(lobe->measured, cosine);
  return fmin(1.0, um_materials_lobe_mean(lobe, c, 384, 24, NULL, NULL));
}
