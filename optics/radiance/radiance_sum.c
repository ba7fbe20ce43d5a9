/* Sums over surfaces that face the same way, and the spectrum of a sum (radiance.c has the
 * equations). All that depends on directions is worked out once for such surfaces; what each brings
 * of its own, areas, temperature, sky and Earth before it, enters linearly. */
#include <string.h>

#include "base/core/constants.h"
#include "optics/radiance/radiance_group.h"

void um_optics_sum_clear(const struct um_optics_spectra *spectra, struct um_optics_sum *sum)
{
  sum->lambert = sum->lobe = sum->albedo = sum->view_factor = 0.0;
  memset(sum->emitted, 0, spectra->nbin * sizeof *sum->emitted);
  memset(sum->planet, 0, spectra->nbin * sizeof *sum->planet);
  memset(sum->masked, 0, spectra->nbin * sizeof *sum->masked);
  memset(sum->earthlit, 0, spectra->nbin * sizeof *sum->earthlit);
}

/* M(i) M(o) of lit surfaces. */
static void add_masked(const struct um_optics_spectra *spectra, size_t skin,
                       const struct um_optics_sight *sight, double projected,
                       struct um_optics_work *work, struct um_optics_sum *sum)
{
  const double *toward = work->masked_observer, *from = work->masked_sun;
  um_optics_spectra_masked(spectra, skin, sight->cos_lamp, work->masked_sun);
  um_optics_spectra_masked(spectra, skin, sight->cos_observer, work->masked_observer);
  for (size_t b = 0; b < spectra->nbin; b++) sum->masked[b] += projected * from[b] * toward[b];
}

static struct um_materials_pair pair_of(const struct um_optics_instant *instant,
                                        const struct um_materials_lobe *lobe,
                                        const struct um_optics_sight *sight)
{
  struct um_materials_pair pair = {sight->cos_lamp,
                                   sight->cos_observer,
                                   sight->cos_half,
                                   instant->lamp.cos_half_phase,
                                   0.0,
                                   0.0,
                                   0.0};
  if (!um_materials_lobe_is_anisotropic(lobe) && sight->patches.n == 0) return pair;
  pair.along_i = um_vec3_dot(sight->grain, instant->lamp.body);
  pair.along_o = um_vec3_dot(sight->grain, instant->observer_body);
  pair.along_h = um_vec3_dot(sight->grain, instant->lamp.half);
  return pair;
}

static void add_lamp(const struct um_optics_spectra *spectra,
                     const struct um_optics_instant *instant, size_t skin,
                     const struct um_optics_sight *sight, double lit, struct um_optics_work *work,
                     struct um_optics_sum *sum)
{
  double projected = lit * sight->cos_observer * sight->cos_lamp;
  const struct um_materials_lobe *lobe = &spectra->lobe[skin];
  sum->lambert += projected;
  if (spectra->masks[skin]) add_masked(spectra, skin, sight, projected, work, sum);
  if (lobe->kind == NULL) return;
  struct um_materials_pair pair = pair_of(instant, lobe, sight);
  sum->lobe +=
      projected * (sight->patches.n > 0
                       ? um_materials_lobe_patches(&spectra->flat[skin], lobe, &pair,
                                                   um_vec3_dot(sight->across, instant->lamp.half),
                                                   instant->lamp.radius, &sight->patches)
                       : lobe->kind->sunlit(lobe, &pair, instant->lamp.radius));
}

void um_optics_sum_add(const struct um_optics_spectra *spectra,
                       const struct um_optics_instant *instant, size_t skin,
                       const struct um_optics_sight *sight, size_t count,
                       const struct um_optics_earth_shares *shares, struct um_optics_work *work,
                       struct um_optics_sum *sum)
{
  double cos_o = sight->cos_observer, lit = 0.0, seen = 0.0;
  struct um_optics_earth_seen earth = {0};
  if (!(cos_o > 0.0)) return;
  for (size_t i = 0; i < count; i++) {
    lit += sight[i].area_lit;
    seen += sight[i].area_seen * cos_o;
  }
  if (instant->lamp.shines && lit > 0.0 && sight->cos_lamp > 0.0)
    add_lamp(spectra, instant, skin, sight, lit, work, sum);
  if (!(seen > 0.0) || instant->sunlight_only) return;
  for (size_t i = 0; i < count; i++) {
    double area = sight[i].area_seen * cos_o;
    if (!(area > 0.0)) continue;
    um_optics_planck_sum_add(spectra, sight[i].temperature, area, &work->bodies);
    sum->albedo += area * sight[i].albedo;
    um_optics_earth_seen_add(spectra, instant, shares, &sight[i], area, work, &earth);
  }
  um_optics_planck_sum_end(spectra, &work->bodies, work->planck);
  size_t n = spectra->nbin;
  const double *planck = work->planck;
  double *emitted = sum->emitted;
  const double *emissivity = um_optics_spectra_emissivity(spectra, skin, cos_o, work->emissivity);
  if (spectra->diffuse_emitter[skin])
    for (size_t b = 0; b < n; b++) emitted[b] += planck[b];
  else
    for (size_t b = 0; b < n; b++) emitted[b] += emissivity[b] * planck[b];
  um_optics_add_earth(spectra, instant, skin, sight, shares, &earth, emissivity, work, sum);
}

const double *um_optics_specular(const struct um_optics_spectra *spectra,
                                 const struct um_optics_scene *scene,
                                 const struct um_optics_instant *instant, size_t skin,
                                 struct um_optics_work *work)
{
  double *row = work->specular + skin * spectra->nbin;
  if (work->specular_known[skin]) return row;
  size_t material = um_optics_material(spectra, skin);
  const struct um_materials_adjustment *adjustment =
      um_optics_adjustment(scene, instant->time, material);
  for (size_t b = 0; b < spectra->nbin; b++)
    row[b] =
        um_materials_specular_reflectance(scene->material[material], adjustment,
                                          spectra->wavelength[b], instant->lamp.cos_half_phase);
  work->specular_known[skin] = true;
  return row;
}

void um_optics_sum_spectrum(const struct um_optics_spectra *spectra,
                            const struct um_optics_scene *scene,
                            const struct um_optics_instant *instant, size_t skin,
                            const struct um_optics_sum *sum, struct um_optics_work *work,
                            double *spectral)
{
  size_t n = spectra->nbin;
  memset(spectral, 0, n * UM_MECHANISM_COUNT * sizeof *spectral);
  const double *diffuse = spectra->diffuse + skin * n;
  const double *emissivity = spectra->emissivity + skin * UM_OPTICS_ANGLE_NODES * n;
  bool diffuse_emitter = spectra->diffuse_emitter[skin];
  size_t by = instant->lamp.name == UM_LAMP_MOON ? UM_MECHANISM_OTHER : UM_MECHANISM_SUN;
  if (instant->lamp.shines && sum->lambert > 0.0) {
    const double *mean = spectra->masked_mean + skin * n;
    for (size_t b = 0; b < n; b++) {
      double scattered = (diffuse[b] - mean[b]) * sum->lambert;
      if (mean[b] > 0.0) scattered += sum->masked[b] / mean[b];
      spectral[b * UM_MECHANISM_COUNT + by] = work->sunlight[b] * scattered / UM_PI;
    }
    if (sum->lobe > 0.0) {
      const double *specular = um_optics_specular(spectra, scene, instant, skin, work);
      for (size_t b = 0; b < n; b++)
        spectral[b * UM_MECHANISM_COUNT + by] += work->sunlight[b] * specular[b] * sum->lobe;
    }
  }
  double albedo = instant->earthshine * sum->albedo / UM_PI;
  double lobe = instant->earthshine * instant->earth_radiance;
  bool evenly = um_optics_reflects_evenly(spectra, instant, skin) && !instant->earth_varies;
  for (size_t b = 0; b < n; b++) {
    double planet = evenly ? (1.0 - emissivity[b]) * sum->view_factor : sum->planet[b];
    planet *= instant->earth_reflection;
    double earth = instant->earth_varies ? 1.0 : spectra->earth[b];
    double *to = spectral + b * UM_MECHANISM_COUNT;
    to[UM_MECHANISM_EARTH] =
        spectra->share[b] * (diffuse[b] * albedo + lobe * sum->earthlit[b]) + planet * earth;
    to[UM_MECHANISM_EMITTED] = (diffuse_emitter ? emissivity[b] : 1.0) * sum->emitted[b];
  }
}
