/* Radiance of surfaces toward the observer (docs/physics/light-curves.md,
 * docs/physics/roughness-and-lobes.md and docs/physics/earthlight.md):
 *
 *   lamp     E_sun(lambda) nu(lambda) (au/d)^2 f_r(i, o) cos_i, f_r of materials.h, nu what shadow
 *            and air leave of the Sun (environment/shadow_light.h), and what air scatters into the
 *            shadow (environment/umbra_scatter.h)
 *   earth    rho_d(lambda)/pi E_albedo E_sun(lambda)/E_sun + (1 - eps(cos_o)) F_earth B(T_b), of
 *            which the lobe's part, wherever F is above 0, is what the lobe sees of the Earth
 *            (earth_lobe.c)
 *   emitted  eps(lambda, cos_o) B_lambda(T)
 *
 * T_b is the brightness temperature of the Earth; where the Earth varies, of what of it lies before
 * the surface.
 *
 * F is Fresnel's reflectance at the facet that mirrors the Sun to the observer: its angle of
 * incidence is half the phase angle, the same for every surface, so that geometry and spectra
 * factor: one lobe weight per material carries all wavelengths. It is the mean of the lobe over the
 * Sun's disc (`sunlit` of materials/lobe.h). */
#include "optics/radiance/radiance_group.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"

static struct um_optics_lamp lamp_of(enum um_optics_lamp_name name, struct um_vec3 observer,
                                     struct um_vec3 body, double radius, bool shines)
{
  struct um_optics_lamp lamp = {.name = name, .body = body, .radius = radius, .shines = shines};
  struct um_vec3 both = um_vec3_add(observer, body);
  double length = um_vec3_norm(both);
  if (length > 1e-9) lamp.half = um_vec3_scale(both, 1.0 / length);
  lamp.cos_half_phase = fmin(1.0, 0.5 * length);
  return lamp;
}

void um_optics_instant_moon(const struct um_optics_scene *scene, struct um_optics_instant *now)
{
  const struct um_environment_sample *sample = &scene->samples[now->time];
  bool there = sample->moon_distance > 0.0;
  now->lamp = lamp_of(UM_LAMP_MOON, now->observer_body, um_quat_apply(sample->q, sample->moon),
                      there ? um_environment_moon_radius(sample->moon_distance) : 0.0, there);
}

struct um_optics_instant um_optics_instant(const struct um_optics_scene *scene, size_t time)
{
  const struct um_environment_sample *sample = &scene->samples[time];
  struct um_optics_instant now = {.time = time};
  now.observer_body = um_quat_apply(sample->q, sample->to_observer);
  now.sun_body = um_quat_apply(sample->q, sample->sun);
  now.sun_radius = asin(UM_SOLAR_RADIUS / sample->sun_distance);
  double relative = UM_AU / sample->sun_distance;
  now.sun = sample->sunlit_fraction * relative * relative;
  now.lamp = lamp_of(UM_LAMP_SUN, now.observer_body, now.sun_body, now.sun_radius,
                     now.sun > 0.0 || sample->scattered > 0.0);
  const struct um_environment *environment = scene->environment;
  now.earthshine = environment->earthshine_on ? environment->earthshine_factor : 0.0;
  now.earth_reflection =
      environment->earth_reflection_on ? environment->earth_reflection_factor : 0.0;
  now.earth_varies = scene->brightness != NULL;
  now.sunlight_only = scene->sunlight_only;
  um_optics_instant_earth(environment, sample, &now);
  return now;
}

bool um_optics_moon_is_brighter(const struct um_optics_scene *scene,
                                const struct um_optics_instant *now)
{
  const struct um_environment_sample *sample = &scene->samples[now->time];
  struct um_environment_moonlight moon;
  if (!now->lamp.shines) return true;
  if (now->sun > 0.0 || !(sample->moon_distance > 0.0)) return false;
  um_environment_moonlight(scene->environment, sample, &moon);
  return um_environment_moonlight_at(&moon, UM_UMBRA_SCATTER_ASKED) > sample->scattered;
}

static enum um_status work_fill(struct um_context *context, const struct um_optics_spectra *spectra,
                                size_t nray, struct um_optics_work *work)
{
  size_t nbin = spectra->nbin, nskin = spectra->nskin, nband = spectra->nband;
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->planck));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->emissivity));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->upright));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->masked_sun));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->masked_observer));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->earth));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->earth_clear));
  UM_TRY(um_optics_planck_sum_create(context, spectra, &work->bodies));
  UM_TRY(um_optics_planck_sum_create(context, spectra, &work->far));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->earth_ratio));
  if (spectra->varies)
    UM_TRY(um_core_allocate(context, UM_EARTH_SEEN_NODES * nbin, sizeof(double), &work->earth_row));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->sunlight));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->lobe_all));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->lobe_earth));
  UM_TRY(um_core_allocate(context, nbin * UM_MECHANISM_COUNT, sizeof(double), &work->spectral));
  UM_TRY(um_core_allocate(context, nskin * nbin, sizeof(double), &work->specular));
  UM_TRY(um_core_allocate(context, nskin, sizeof(bool), &work->specular_known));
  UM_TRY(um_core_allocate(context, (4 * nskin + 4) * nbin, sizeof(double), &work->bins));
  UM_TRY(um_core_allocate(context, nskin, sizeof *work->sum, &work->sum));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->incoming));
  UM_TRY(um_core_allocate(context, nbin, sizeof(double), &work->row));
  UM_TRY(um_core_allocate(context, nray * nbin, sizeof(double), &work->throughput));
  UM_TRY(um_core_allocate(context, nray * nbin, sizeof(double), &work->mirrored));
  UM_TRY(um_core_allocate(context, nray * nbin, sizeof(double), &work->gathered));
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
    void *const blocks[] = {w->planck,          w->emissivity, w->spectral,      w->specular,
                            w->specular_known,  w->bins,       w->sum,           w->incoming,
                            w->reflected,       w->band,       w->band_variance, w->ray,
                            w->occluded,        w->hidden,     w->earth,         w->masked_sun,
                            w->masked_observer, w->sunlight,   w->lobe_all,      w->lobe_earth,
                            w->angle,           w->rotation,   w->earth_clear,   w->row,
                            w->throughput,      w->mirrored,   w->gathered,      w->upright,
                            w->earth_row,       w->earth_ratio};
    for (size_t k = 0; k < sizeof blocks / sizeof blocks[0]; k++) um_core_free(context, blocks[k]);
    um_optics_planck_sum_clear(context, &w->bodies);
    um_optics_planck_sum_clear(context, &w->far);
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
  out->near = relative * relative;
  out->air.count = 0;
  out->scattered.any = false;
  if (sample->scattered > 0.0)
    um_environment_umbra_scattered(environment, sample->r, sample->sun, sample->sun_distance,
                                   sample->pole, sample->sunlit_fraction, &out->scattered);
  if (environment->limb != NULL && out->share > 0.0)
    um_environment_shadow_light(environment, sample->r, sample->sun, sample->sun_distance,
                                sample->pole, &out->air);
}

double um_optics_sunlight(const struct um_optics_sunlight *light, double solar, double wavelength)
{
  double out = light->share * solar;
  if (light->air.count > 0)
    out *= um_environment_shadow_light_at(&light->air, wavelength) / light->sunlit;
  if (light->scattered.any)
    out += light->near * solar * um_environment_scattered_at(&light->scattered, wavelength);
  return out;
}

void um_optics_light(const struct um_optics_spectra *spectra, const struct um_optics_scene *scene,
                     const struct um_optics_instant *instant, struct um_optics_work *work)
{
  const struct um_environment_sample *sample = &scene->samples[instant->time];
  memset(work->specular_known, 0, spectra->nskin * sizeof *work->specular_known);
  if (instant->lamp.name == UM_LAMP_MOON) {
    struct um_environment_moonlight moon;
    um_environment_moonlight(scene->environment, sample, &moon);
    for (size_t b = 0; b < spectra->nbin; b++)
      work->sunlight[b] =
          spectra->sun[b] * um_environment_moonlight_at(&moon, spectra->wavelength[b]);
    return;
  }
  um_optics_earth_rows(spectra, instant, work);
  struct um_optics_sunlight light;
  um_optics_sunlight_at(scene->environment, sample, &light);
  for (size_t b = 0; b < spectra->nbin; b++)
    work->sunlight[b] = um_optics_sunlight(&light, spectra->sun[b], spectra->wavelength[b]);
}

void um_optics_turn(const struct um_optics_spectra *spectra, const struct um_optics_scene *scene,
                    const struct um_optics_instant *instant, struct um_optics_work *work)
{
  if (!spectra->grain) return;
  um_geometry_joint_angles(scene->geometry, instant->sun_body, scene->samples[instant->time].t_tai,
                           work->angle);
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
  if (sight->patches.n > 0 || spectra->varies ||
      um_materials_lobe_is_anisotropic(&spectra->lobe[skin]))
    um_geometry_surface_grain(scene->geometry, work->rotation, surface, &sight->grain,
                              &sight->across);
}
