/* Evaluation of a record, with and without adjustments.
 *
 *   f_r = rho_d/pi + M(i) M(o)/(pi Mbar) + F f
 * f is the lobe (lobe.h), rho_d the Lambert part as described, M what the lobe's masking keeps back
 * (spectrum.c). Without an adjustment, or with null values, the tabulated numbers come back bit for
 * bit.
 *
 * Adjustments keep the books where they say that they change absorption or emission:
 *   absorptance_shift a, below 2.5 um:  rho_d - a; what rho_d cannot give is taken from F.
 *   emittance scales s, from 2.5 um up: emissivity s (1 - R). With phi = rho_d/(rho_d + mean F)
 *       rho_d' = phi (1 - s) + s rho_d,  F' = (1 - phi)(1 - s) + s F,  so 1 - R' = s (1 - R).
 * A measured BRDF, whose F has no angle and whose lobe reflects F E(o), is scaled with phi = 1;
 * what rho_d cannot give is taken from F over the mean of E, so that hemispherical emissivity and
 * absorptance are what was asked and reflected and emitted make 1 in every direction.
 * A tilt d of the emissivity adds d eps_h (1 - 21 (1 - cos)^5) / 20, whose hemispherical mean is 0:
 * (1 - cos)^5 is Schlick's (1994) approach of Fresnel's law to grazing, of mean 1/21.
 * diffuse_scale, specular_scale, roughness_scale and slope_variance change what is reflected only.
 * A reflectance is never negative and the described rho_d plus F never above 1. */
#include <math.h>

#include "base/core/constants.h"
#include "materials/measured.h"
#include "materials/record_impl.h"

const struct um_materials_adjustment um_materials_no_adjustment = {
    .absorptance_shift = 0.0,
    .emittance_scale = 1.0,
    .band_emissivity_scale = 1.0,
    .roughness_scale = 1.0,
    .specular_scale = 1.0,
    .diffuse_scale = 1.0,
    .emissivity_tilt = 0.0,
    .lobe = {0.0, 0.0},
    .thickness_scale = 1.0,
};

/* A scale of 0 leaves a lobe this narrow, not none. */
static const double smallest_alpha = 1e-4;

static double unit_clamp(double x) { return x < 0.0 ? 0.0 : (x > 1.0 ? 1.0 : x); }

/* Nothing is changed but, perhaps, the tilt of the emissivity, which is added last. */
static bool is_null(const struct um_materials_adjustment *a)
{
  return a == NULL || (a->absorptance_shift == 0.0 && a->emittance_scale == 1.0 &&
                       a->band_emissivity_scale == 1.0 && a->roughness_scale == 1.0 &&
                       a->specular_scale == 1.0 && a->diffuse_scale == 1.0 &&
                       a->lobe.slope_variance == 0.0 && a->lobe.log_across == 0.0);
}

static double linear(const double *table, size_t i, double t)
{
  return table[i] + t * (table[i + 1] - table[i]);
}

/* Scale of the emissivity at a wavelength; 1 below the split. */
static double emissivity_scale(const struct um_materials_adjustment *a, double wavelength)
{
  return wavelength < UM_INFRARED_FROM ? 1.0 : a->emittance_scale * a->band_emissivity_scale;
}

/* --- grey records ---------------------------------------------------------------------------- */

static double grey_emissivity(const struct um_materials_record *record,
                              const struct um_materials_adjustment *a, double wavelength)
{
  const struct um_materials_grey *g = &record->explicit_values;
  double value = g->emittance;
  for (size_t i = 0; i < g->nband; i++)
    if (wavelength >= g->bands[i].from && wavelength <= g->bands[i].to) {
      value = g->bands[i].emissivity;
      break;
    }
  return a == NULL ? value : unit_clamp(value * emissivity_scale(a, wavelength));
}

/* Explicit below the split; above it everything that is not emitted is scattered. */
static double grey_diffuse(const struct um_materials_record *record,
                           const struct um_materials_adjustment *a, double wavelength)
{
  const struct um_materials_grey *g = &record->explicit_values;
  if (wavelength >= UM_INFRARED_FROM) return 1.0 - grey_emissivity(record, a, wavelength);
  if (a == NULL) return g->diffuse;
  double shifted = fmax(0.0, g->diffuse - a->absorptance_shift);
  return fmax(0.0, fmin(shifted * a->diffuse_scale, 1.0 - g->specular));
}

static double grey_specular(const struct um_materials_record *record,
                            const struct um_materials_adjustment *a, double wavelength)
{
  const struct um_materials_grey *g = &record->explicit_values;
  if (wavelength >= UM_INFRARED_FROM) return 0.0;
  if (a == NULL) return g->specular;
  double rest = fmax(0.0, a->absorptance_shift - g->diffuse);
  double f = fmax(0.0, g->specular - rest) * a->specular_scale;
  return fmax(0.0, fmin(f, 1.0 - grey_diffuse(record, a, wavelength)));
}

/* --- spectral records ------------------------------------------------------------------------ */

/* An adjustment at one wavelength: rho_d = described, F' = scale F + offset. */
struct changed {
  double diffuse, scale, offset;
  double most; /* F that leaves nothing to absorb beside no Lambert part */
};

/* A Lambert part of a measured record, which no angle may bring above 1; what is below 0 is F's. */
static void change_whole(const struct um_materials_measured *m, double diffuse, struct changed *c)
{
  double most = fmin(1.0, fmax(um_materials_measured_albedo_most(m), 1e-9));
  double mean = fmax(um_materials_measured_albedo_mean(m), 1e-9);
  c->diffuse = unit_clamp(diffuse);
  c->offset = fmin(0.0, diffuse) / mean;
  c->most = 1.0 / most;
}

static struct changed change(const struct um_materials_record *record,
                             const struct um_materials_adjustment *a, double wavelength, size_t i,
                             double t)
{
  const struct um_materials_spectrum *s = &record->spectrum;
  double diffuse = linear(s->diffuse, i, t);
  struct changed c = {diffuse, 1.0, 0.0, 1.0};
  if (wavelength < UM_INFRARED_FROM) {
    c.diffuse = fmax(0.0, diffuse - a->absorptance_shift);
    c.offset = -fmax(0.0, a->absorptance_shift - diffuse);
    if (record->measured) change_whole(record->measured, diffuse - a->absorptance_shift, &c);
    return c;
  }
  double scale = emissivity_scale(a, wavelength);
  if (record->measured) {
    c.scale = scale;
    change_whole(record->measured, 1.0 - scale + scale * diffuse, &c);
    return c;
  }
  double reflectance = diffuse + linear(s->lobe_mean, i, t);
  double phi = reflectance > 0.0 ? diffuse / reflectance : 1.0;
  c.diffuse = unit_clamp(phi * (1.0 - scale) + scale * diffuse);
  c.scale = scale;
  c.offset = (1.0 - phi) * (1.0 - scale);
  return c;
}

static double apply(const struct changed *c, double f)
{
  return fmax(0.0, fmin(c->scale * f + c->offset, (1.0 - c->diffuse) * c->most));
}

/* What the lobe reflects toward a cosine; f: F averaged over the facets that it uses there. */
static double reflected(const struct um_materials_record *record, const struct changed *c, size_t i,
                        double t, double f, double cosine)
{
  const struct um_materials_measured *m = record->measured;
  if (m == NULL) return apply(c, f);
  const struct um_materials_spectrum *s = &record->spectrum;
  return apply(c, um_materials_spectrum_angular(s, s->facet, i, t, 1.0)) *
         um_materials_measured_albedo(m, cosine);
}

/* Lambert part of an adjusted record. */
static double adjusted_lambert(const struct um_materials_spectrum *s, const struct changed *c,
                               const struct um_materials_adjustment *a, double wavelength, size_t i,
                               double t)
{
  double scale = wavelength < UM_INFRARED_FROM ? a->diffuse_scale : 1.0;
  double normal = apply(c, um_materials_spectrum_angular(s, s->facet, i, t, 1.0)) / c->most;
  return fmax(0.0, fmin(c->diffuse * scale, 1.0 - normal));
}

/* F of a facet, or its mean, with the optics-only scale: what stands beside the Lambert part. */
static double adjusted_facet(const struct um_materials_record *record, double f,
                             const struct um_materials_adjustment *a, double wavelength, size_t i,
                             double t)
{
  struct changed c = change(record, a, wavelength, i, t);
  double room = (1.0 - adjusted_lambert(&record->spectrum, &c, a, wavelength, i, t)) * c.most;
  return fmax(0.0, fmin(fmin(apply(&c, f), room) * a->specular_scale, room));
}

static double spectral_specular(const struct um_materials_record *record,
                                const struct um_materials_adjustment *a, double wavelength,
                                double cos_h)
{
  const struct um_materials_spectrum *s = &record->spectrum;
  double t;
  size_t i = um_materials_spectrum_locate(s, wavelength, &t);
  double f = um_materials_spectrum_angular(s, s->facet, i, t, cos_h);
  return a == NULL ? f : adjusted_facet(record, f, a, wavelength, i, t);
}

/* M(o) = Fbar(o) (1 - E(o)). */
static double spectral_masked(const struct um_materials_record *record,
                              const struct um_materials_adjustment *a, double wavelength,
                              double cos_o)
{
  const struct um_materials_spectrum *s = &record->spectrum;
  struct um_materials_lobe shape = um_materials_lobe(record, a);
  if (record->measured) return 0.0;
  double t;
  size_t i = um_materials_spectrum_locate(s, wavelength, &t);
  double f = um_materials_spectrum_angular(s, s->lobe, i, t, cos_o);
  if (a != NULL) f = adjusted_facet(record, f, a, wavelength, i, t);
  return f * (1.0 - um_materials_albedo(record, &shape, cos_o));
}

static double spectral_masked_mean(const struct um_materials_record *record,
                                   const struct um_materials_adjustment *a, double wavelength)
{
  double t, value[UM_MATERIALS_COSINES];
  size_t i = um_materials_spectrum_locate(&record->spectrum, wavelength, &t);
  if (a == NULL) return linear(record->spectrum.masked_mean, i, t);
  if (!um_materials_has_lobe(record)) return 0.0;
  for (size_t j = 0; j < UM_MATERIALS_COSINES; j++)
    value[j] = spectral_masked(record, a, wavelength, um_materials_node_cosine(j));
  return um_materials_hemispherical_mean(value, UM_MATERIALS_COSINES);
}

static double spectral_diffuse(const struct um_materials_record *record,
                               const struct um_materials_adjustment *a, double wavelength)
{
  const struct um_materials_spectrum *s = &record->spectrum;
  double t;
  size_t i = um_materials_spectrum_locate(s, wavelength, &t);
  if (a == NULL) return linear(s->diffuse, i, t) + linear(s->masked_mean, i, t);
  struct changed c = change(record, a, wavelength, i, t);
  return adjusted_lambert(s, &c, a, wavelength, i, t) + spectral_masked_mean(record, a, wavelength);
}

/* 1 - rho_d - Fbar(cos_o), of the described surface, not of the optics-only scales. */
static double spectral_emissivity(const struct um_materials_record *record,
                                  const struct um_materials_adjustment *a, double wavelength,
                                  double cos_o)
{
  const struct um_materials_spectrum *s = &record->spectrum;
  double t;
  size_t i = um_materials_spectrum_locate(s, wavelength, &t);
  double f = um_materials_spectrum_angular(s, s->lobe, i, t, cos_o);
  if (a == NULL) return unit_clamp(1.0 - linear(s->diffuse, i, t) - f);
  struct changed c = change(record, a, wavelength, i, t);
  return unit_clamp(1.0 - c.diffuse - reflected(record, &c, i, t, f, cos_o));
}

static double spectral_hemispherical(const struct um_materials_record *record,
                                     const struct um_materials_adjustment *a, double wavelength)
{
  const struct um_materials_spectrum *s = &record->spectrum;
  double t;
  size_t i = um_materials_spectrum_locate(s, wavelength, &t);
  double f = linear(s->lobe_mean, i, t);
  if (a == NULL) return linear(s->diffuse, i, t) + f;
  struct changed c = change(record, a, wavelength, i, t);
  if (record->measured)
    return c.diffuse + apply(&c, um_materials_spectrum_angular(s, s->facet, i, t, 1.0)) *
                           um_materials_measured_albedo_mean(record->measured);
  return c.diffuse + apply(&c, f);
}

/* --- public ---------------------------------------------------------------------------------- */

double um_materials_diffuse_reflectance(const struct um_materials_record *record,
                                        const struct um_materials_adjustment *adjustment,
                                        double wavelength)
{
  const struct um_materials_adjustment *a = is_null(adjustment) ? NULL : adjustment;
  return record->grey ? grey_diffuse(record, a, wavelength)
                      : spectral_diffuse(record, a, wavelength);
}

double um_materials_specular_reflectance(const struct um_materials_record *record,
                                         const struct um_materials_adjustment *adjustment,
                                         double wavelength, double cos_h)
{
  if (!um_materials_has_lobe(record)) return 0.0;
  const struct um_materials_adjustment *a = is_null(adjustment) ? NULL : adjustment;
  return record->grey ? grey_specular(record, a, wavelength)
                      : spectral_specular(record, a, wavelength, cos_h);
}

double um_materials_masked_reflectance(const struct um_materials_record *record,
                                       const struct um_materials_adjustment *adjustment,
                                       double wavelength, double cosine)
{
  if (record->grey || !um_materials_has_lobe(record)) return 0.0;
  return spectral_masked(record, is_null(adjustment) ? NULL : adjustment, wavelength, cosine);
}

double um_materials_masked_mean(const struct um_materials_record *record,
                                const struct um_materials_adjustment *adjustment, double wavelength)
{
  if (record->grey || !um_materials_has_lobe(record)) return 0.0;
  return spectral_masked_mean(record, is_null(adjustment) ? NULL : adjustment, wavelength);
}

bool um_materials_has_lobe(const struct um_materials_record *record)
{
  return record->lobe.kind != NULL;
}

struct um_materials_lobe um_materials_lobe(const struct um_materials_record *record,
                                           const struct um_materials_adjustment *adjustment)
{
  struct um_materials_lobe lobe = record->lobe;
  if (adjustment == NULL || lobe.kind == NULL) return lobe;
  if (lobe.kind->rough && adjustment->roughness_scale != 1.0) {
    lobe.alpha = fmax(lobe.alpha * adjustment->roughness_scale, smallest_alpha);
    lobe.alpha_across = fmax(lobe.alpha_across * adjustment->roughness_scale, smallest_alpha);
  }
  if (lobe.kind->anisotropic && adjustment->lobe.log_across != 0.0)
    lobe.alpha_across = fmax(lobe.alpha_across * exp(adjustment->lobe.log_across), smallest_alpha);
  return um_materials_lobe_tilted(&lobe, adjustment->lobe.slope_variance);
}

double um_materials_roughness(const struct um_materials_record *record,
                              const struct um_materials_adjustment *adjustment)
{
  return um_materials_lobe(record, adjustment).alpha;
}

double um_materials_emissivity(const struct um_materials_record *record,
                               const struct um_materials_adjustment *adjustment, double wavelength,
                               double cos_o)
{
  const struct um_materials_adjustment *a = is_null(adjustment) ? NULL : adjustment;
  double value = record->grey ? grey_emissivity(record, a, wavelength)
                              : spectral_emissivity(record, a, wavelength, cos_o);
  double tilt = um_materials_emissivity_tilt(record, adjustment, wavelength);
  return tilt == 0.0 ? value : um_materials_emissivity_tilted(value, tilt, cos_o);
}

double um_materials_emissivity_tilt(const struct um_materials_record *record,
                                    const struct um_materials_adjustment *adjustment,
                                    double wavelength)
{
  if (adjustment == NULL || adjustment->emissivity_tilt == 0.0 || wavelength < UM_INFRARED_FROM)
    return 0.0;
  return adjustment->emissivity_tilt *
         (1.0 - um_materials_hemispherical_reflectance(record, adjustment, wavelength));
}

/* eps' = eps + d eps_h (1 - 21 (1 - cos)^5) / 20 */
double um_materials_emissivity_tilted(double emissivity, double tilt, double cos_o)
{
  double left = 1.0 - unit_clamp(cos_o), square = left * left;
  return unit_clamp(emissivity + tilt * ((1.0 - 21.0 * square * square * left) / 20.0));
}

bool um_materials_emissivity_is_diffuse(const struct um_materials_record *record,
                                        const struct um_materials_adjustment *adjustment)
{
  if (adjustment != NULL && adjustment->emissivity_tilt != 0.0) return false;
  return record->grey || record->spectrum.ncos == 1;
}

double um_materials_hemispherical_reflectance(const struct um_materials_record *record,
                                              const struct um_materials_adjustment *adjustment,
                                              double wavelength)
{
  const struct um_materials_adjustment *a = is_null(adjustment) ? NULL : adjustment;
  if (record->grey)
    return grey_diffuse(record, a, wavelength) + grey_specular(record, a, wavelength);
  return spectral_hemispherical(record, a, wavelength);
}

const char *um_materials_name(const struct um_materials_record *record) { return record->name; }
const char *um_materials_summary(const struct um_materials_record *record)
{
  return record->summary;
}
const char *um_materials_citation(const struct um_materials_record *record)
{
  return record->citation;
}
bool um_materials_is_grey(const struct um_materials_record *record) { return record->grey; }
struct um_materials_catalogue um_materials_catalogue(const struct um_materials_record *record)
{
  return record->catalogue;
}
