/* Radiance of surfaces toward the observer (D.1, D.3, D.5 of the physics notes):
 *
 *   sun      E_sun(lambda) nu(lambda) (au/d)^2 f_r(i, o) cos_i, f_r of materials.h, nu what shadow
 *            and air leave of the Sun (environment/shadow_light.h)
 *   earth    rho_d(lambda)/pi E_albedo E_sun(lambda)/E_sun + (1 - eps(cos_o)) F_earth B(T_b), of
 *            which the lobe's part is what the lobe sees of the Earth (earth_lobe.c)
 *   emitted  eps(lambda, cos_o) B_lambda(T)
 *
 * T_b is the brightness temperature of the Earth; where the Earth varies, of what of it lies before
 * the surface.
 *
 * F is Fresnel's reflectance at the facet that mirrors the Sun to the observer: its angle of
 * incidence is half the phase angle, the same for every surface, so that geometry and spectra
 * factor: one lobe weight per material carries all wavelengths. It is the mean of the lobe over the
 * Sun's disc (`sunlit` of materials/lobe.h). */
#include "optics/radiance_impl.h"

#include <math.h>
#include <string.h>

#include "core/constants.h"

struct um_optics_instant um_optics_instant(const struct um_optics_scene *scene, size_t time)
{
  const struct um_environment_sample *sample = &scene->samples[time];
  struct um_optics_instant now = {.time = time};
  now.observer_body = um_quat_apply(sample->q, sample->to_observer);
  now.sun_body = um_quat_apply(sample->q, sample->sun);
  struct um_vec3 both = um_vec3_add(now.observer_body, now.sun_body);
  double length = um_vec3_norm(both);
  if (length > 1e-9) now.half_body = um_vec3_scale(both, 1.0 / length);
  now.cos_half_phase = fmin(1.0, 0.5 * length);
  now.sun_radius = asin(UM_SOLAR_RADIUS / sample->sun_distance);
  double relative = UM_AU / sample->sun_distance;
  now.sun = sample->sunlit_fraction * relative * relative;
  const struct um_environment *environment = scene->environment;
  now.earthshine = environment->earthshine_on ? environment->earthshine_factor : 0.0;
  now.earth_reflection =
      environment->earth_reflection_on ? environment->earth_reflection_factor : 0.0;
  now.earth_varies = scene->brightness != NULL;
  now.sunlight_only = scene->sunlight_only;
  um_optics_instant_earth(environment, sample, &now);
  return now;
}

static enum um_status work_fill(struct um_context *context, const struct um_optics_spectra *spectra,
                                size_t nray, struct um_optics_work *work)
{
  size_t nbin = spectra->nbin, nskin = spectra->nskin, nband = spectra->nband;
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->planck));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->emissivity));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->masked_sun));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->masked_observer));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->earth));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->sunlight));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->lobe_all));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->lobe_earth));
  UM_TRY(um_core_allocate(context, nbin * UM_MECHANISM_COUNT, sizeof(double), &work->spectral));
  UM_TRY(um_core_allocate(context, nskin * nbin, sizeof(double), &work->specular));
  UM_TRY(um_core_allocate(context, nskin, sizeof(bool), &work->specular_known));
  UM_TRY(um_core_allocate(context, (4 * nskin + 4) * nbin, sizeof(double), &work->bins));
  UM_TRY(um_core_allocate(context, nskin, sizeof *work->sum, &work->sum));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->incoming));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->reflected));
  UM_TRY(um_core_allocate(context, nband, sizeof(double), &work->band));
  UM_TRY(um_core_allocate(context, nband, sizeof(double), &work->band_variance));
  UM_TRY(um_core_allocate(context, nray, sizeof *work->ray, &work->ray));
  UM_TRY(um_core_allocate(context, nray, 1, &work->occluded));
  UM_TRY(um_core_allocate(context, nray, 1, &work->hidden));
  UM_TRY(um_core_allocate(context, spectra->njoint, sizeof *work->angle, &work->angle));
  UM_TRY(um_core_allocate(context, spectra->npart, sizeof *work->rotation, &work->rotation));
  for (size_t m = 0; m <= nskin; m++) {
    struct um_optics_sum *sum = m < nskin ? &work->sum[m] : &work->single;
    sum->emitted = work->bins + 4 * m * nbin;
    sum->planet = sum->emitted + nbin;
    sum->masked = sum->planet + nbin;
    sum->earthlit = sum->masked + nbin;
  }
  return UM_OK;
}

enum um_status um_optics_work_create(struct um_context *context,
                                     const struct um_optics_spectra *spectra, size_t nray,
                                     size_t nwork, struct um_optics_work **out)
{
  enum um_status status = um_core_allocate(context, nwork, sizeof **out, out);
  for (size_t i = 0; status == UM_OK && i < nwork; i++)
    status = work_fill(context, spectra, nray, &(*out)[i]);
  if (status != UM_OK) um_optics_work_destroy(context, nwork, out);
  return status;
}

void um_optics_work_destroy(struct um_context *context, size_t nwork, struct um_optics_work **work)
{
  if (work == NULL || *work == NULL) return;
  for (size_t i = 0; i < nwork; i++) {
    struct um_optics_work *w = &(*work)[i];
    void *const blocks[] = {
        w->planck,   w->emissivity, w->spectral,  w->specular,   w->specular_known,  w->bins,
        w->sum,      w->incoming,   w->reflected, w->band,       w->band_variance,   w->ray,
        w->occluded, w->hidden,     w->earth,     w->masked_sun, w->masked_observer, w->sunlight,
        w->lobe_all, w->lobe_earth, w->angle,     w->rotation};
    for (size_t k = 0; k < sizeof blocks / sizeof blocks[0]; k++) um_core_free(context, blocks[k]);
  }
  um_core_free(context, *work);
  *work = NULL;
}

void um_optics_sunlight_at(const struct um_environment *environment,
                           const struct um_environment_sample *sample,
                           struct um_optics_sunlight *out)
{
  double relative = UM_AU / sample->sun_distance;
  out->sunlit = sample->sunlit_fraction;
  out->share = sample->sunlit_fraction * relative * relative;
  out->air.count = 0;
  if (environment->limb != NULL && out->share > 0.0)
    um_environment_shadow_light(environment, sample->r, sample->sun, sample->sun_distance,
                                sample->pole, &out->air);
}

double um_optics_sunlight(const struct um_optics_sunlight *light, double solar, double wavelength)
{
  double out = light->share * solar;
  if (light->air.count > 0)
    out *= um_environment_shadow_light_at(&light->air, wavelength) / light->sunlit;
  return out;
}

void um_optics_light(const struct um_optics_spectra *spectra, const struct um_optics_scene *scene,
                     const struct um_optics_instant *instant, struct um_optics_work *work)
{
  struct um_optics_sunlight light;
  um_optics_sunlight_at(scene->environment, &scene->samples[instant->time], &light);
  for (size_t b = 0; b < spectra->nbin; b++)
    work->sunlight[b] = um_optics_sunlight(&light, spectra->sun[b], spectra->wavelength[b]);
}

void um_optics_turn(const struct um_optics_spectra *spectra, const struct um_optics_scene *scene,
                    const struct um_optics_instant *instant, struct um_optics_work *work)
{
  if (!spectra->grain) return;
  um_geometry_joint_angles(scene->geometry, instant->sun_body, work->angle);
  um_geometry_part_rotations(scene->geometry, spectra->njoint > 0 ? work->angle : NULL,
                             work->rotation);
}

void um_optics_sight_turn(const struct um_optics_spectra *spectra,
                          const struct um_optics_scene *scene, size_t surface,
                          const struct um_optics_work *work, struct um_optics_sight *sight)
{
  if (!spectra->grain) return;
  size_t skin = um_optics_skin(spectra, um_geometry_mesh(scene->geometry), surface);
  if (spectra->creases != NULL) {
    const struct um_geometry_creases *c = spectra->creases->patches;
    size_t first = c->first[surface];
    sight->patches = (struct um_materials_patches){c->along + first, c->across + first,
                                                   c->share + first, c->first[surface + 1] - first};
  }
  if (sight->patches.n > 0 || um_materials_lobe_is_anisotropic(&spectra->lobe[skin]))
    um_geometry_surface_grain(scene->geometry, work->rotation, surface, &sight->grain,
                              &sight->across);
}

void um_optics_sum_clear(const struct um_optics_spectra *spectra, struct um_optics_sum *sum)
{
  sum->lambert = sum->lobe = sum->albedo = sum->view_factor = 0.0;
  memset(sum->emitted, 0, spectra->nbin * sizeof *sum->emitted);
  memset(sum->planet, 0, spectra->nbin * sizeof *sum->planet);
  memset(sum->masked, 0, spectra->nbin * sizeof *sum->masked);
  memset(sum->earthlit, 0, spectra->nbin * sizeof *sum->earthlit);
}

/* M(i) M(o) of a sunlit surface. */
static void add_masked(const struct um_optics_spectra *spectra, size_t skin,
                       const struct um_optics_sight *sight, double projected,
                       struct um_optics_work *work, struct um_optics_sum *sum)
{
  const double *toward = work->masked_observer, *from = work->masked_sun;
  um_optics_spectra_masked(spectra, skin, sight->cos_sun, work->masked_sun);
  um_optics_spectra_masked(spectra, skin, sight->cos_observer, work->masked_observer);
  for (size_t b = 0; b < spectra->nbin; b++) sum->masked[b] += projected * from[b] * toward[b];
}

static struct um_materials_pair pair_of(const struct um_optics_instant *instant,
                                        const struct um_materials_lobe *lobe,
                                        const struct um_optics_sight *sight)
{
  struct um_materials_pair pair = {
      sight->cos_sun, sight->cos_observer, sight->cos_half, instant->cos_half_phase, 0.0, 0.0, 0.0};
  if (!um_materials_lobe_is_anisotropic(lobe) && sight->patches.n == 0) return pair;
  pair.along_i = um_vec3_dot(sight->grain, instant->sun_body);
  pair.along_o = um_vec3_dot(sight->grain, instant->observer_body);
  pair.along_h = um_vec3_dot(sight->grain, instant->half_body);
  return pair;
}

void um_optics_sum_add(const struct um_optics_spectra *spectra,
                       const struct um_optics_instant *instant, size_t skin,
                       const struct um_optics_sight *sight, struct um_optics_work *work,
                       struct um_optics_sum *sum)
{
  double cos_o = sight->cos_observer, cos_i = sight->cos_sun;
  if (!(cos_o > 0.0)) return;
  if (instant->sun > 0.0 && sight->area_lit > 0.0 && cos_i > 0.0) {
    double projected = sight->area_lit * cos_o * cos_i;
    sum->lambert += projected;
    if (spectra->masks[skin]) add_masked(spectra, skin, sight, projected, work, sum);
    const struct um_materials_lobe *lobe = &spectra->lobe[skin];
    if (lobe->kind != NULL) {
      struct um_materials_pair pair = pair_of(instant, lobe, sight);
      sum->lobe += projected *
                   (sight->patches.n > 0
                        ? um_materials_lobe_patches(&spectra->flat[skin], lobe, &pair,
                                                    um_vec3_dot(sight->across, instant->half_body),
                                                    instant->sun_radius, &sight->patches)
                        : lobe->kind->sunlit(lobe, &pair, instant->sun_radius));
    }
  }
  double seen = sight->area_seen * cos_o;
  if (!(seen > 0.0) || instant->sunlight_only) return;
  sum->albedo += seen * sight->albedo;
  um_optics_spectra_planck(spectra, sight->temperature, work->planck);
  size_t n = spectra->nbin;
  const double *planck = work->planck;
  double *emitted = sum->emitted, *planet = sum->planet;
  if (instant->earth_varies) um_optics_spectra_planck(spectra, sight->brightness, work->earth);
  if (instant->earth_lobe && spectra->lobe[skin].kind != NULL)
    um_optics_add_earth_lobe(spectra, instant, skin, sight, seen, work, sum);
  if (spectra->diffuse_emitter[skin]) {
    const double *row = spectra->emissivity + skin * UM_OPTICS_ANGLE_NODES * n;
    for (size_t b = 0; b < n && instant->earth_varies; b++)
      planet[b] += seen * sight->view_factor * (1.0 - row[b]) * work->earth[b];
    sum->view_factor += seen * sight->view_factor;
    for (size_t b = 0; b < n; b++) emitted[b] += seen * planck[b];
    return;
  }
  const double *emissivity = um_optics_spectra_emissivity(spectra, skin, cos_o, work->emissivity);
  for (size_t b = 0; b < n; b++) emitted[b] += seen * emissivity[b] * planck[b];
  um_optics_add_planet(spectra, instant, skin, sight, seen, emissivity, work, sum);
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
    row[b] = um_materials_specular_reflectance(scene->material[material], adjustment,
                                               spectra->wavelength[b], instant->cos_half_phase);
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
  if (instant->sun > 0.0 && sum->lambert > 0.0) {
    const double *mean = spectra->masked_mean + skin * n;
    for (size_t b = 0; b < n; b++) {
      double scattered = (diffuse[b] - mean[b]) * sum->lambert;
      if (mean[b] > 0.0) scattered += sum->masked[b] / mean[b];
      spectral[b * UM_MECHANISM_COUNT + UM_MECHANISM_SUN] = work->sunlight[b] * scattered / UM_PI;
    }
    if (sum->lobe > 0.0) {
      const double *specular = um_optics_specular(spectra, scene, instant, skin, work);
      for (size_t b = 0; b < n; b++)
        spectral[b * UM_MECHANISM_COUNT + UM_MECHANISM_SUN] +=
            work->sunlight[b] * specular[b] * sum->lobe;
    }
  }
  double albedo = instant->earthshine * sum->albedo / UM_PI;
  double lobe = instant->earthshine * instant->earth_radiance;
  for (size_t b = 0; b < n; b++) {
    double planet = diffuse_emitter && !instant->earth_varies
                        ? (1.0 - emissivity[b]) * sum->view_factor
                        : sum->planet[b];
    planet *= instant->earth_reflection;
    double earth = instant->earth_varies ? 1.0 : spectra->earth[b];
    double *to = spectral + b * UM_MECHANISM_COUNT;
    to[UM_MECHANISM_EARTH] =
        spectra->share[b] * (diffuse[b] * albedo + lobe * sum->earthlit[b]) + planet * earth;
    to[UM_MECHANISM_EMITTED] = (diffuse_emitter ? emissivity[b] : 1.0) * sum->emitted[b];
  }
}
