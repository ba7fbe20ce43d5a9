/* Light of the Earth in the radiance of a surface: its sunlit ground and its own radiation, in the
 * lobe and beside it (D.5 of the physics notes; radiance.c has the whole sum). */
#include <math.h>
#include <string.h>

#include "core/constants.h"
#include "optics/radiance_impl.h"
#include "optics/stage_impl.h"

#define ALL_OF_IT (1.0 - 1e-9) /* view factor of a surface that sees nothing but the Earth */

void um_optics_instant_earth(const struct um_environment *environment,
                             const struct um_environment_sample *sample,
                             struct um_optics_instant *now)
{
  double r = um_vec3_norm(sample->r), albedo = environment->albedo;
  now->earth_lobe = environment->earthlight_lobe_on && r >= environment->earth_radius;
  if (!now->earth_lobe) return;
  now->nadir_body = um_optics_nadir(sample);
  now->h_ratio = r / environment->earth_radius;
  now->observer_nadir = um_vec3_dot(now->observer_body, now->nadir_body);
  now->observer_sun = um_vec3_dot(now->observer_body, now->sun_body);
  now->nadir_sun = um_vec3_dot(now->nadir_body, now->sun_body);
  if (now->earth_varies && now->earthshine > 0.0) {
    struct um_environment uniform = *environment;
    struct um_environment_globe globe = {sample->t_tai, sample->pole, sample->greenwich};
    struct um_environment_earth_flux varied, white;
    struct um_vec3 nadir = um_vec3_scale(sample->r, -1.0 / r);
    uniform.albedo = 1.0;
    um_environment_earth_flux(environment, &globe, sample->r, sample->sun, sample->sun_distance,
                              &nadir, 1, &varied);
    um_environment_earth_flux(&uniform, NULL, sample->r, sample->sun, sample->sun_distance, &nadir,
                              1, &white);
    if (white.albedo > 0.0) albedo = varied.albedo / white.albedo;
  }
  now->earth_radiance =
      albedo * um_environment_solar_irradiance(environment, sample->sun_distance) / UM_PI;
}

/* Sum over the nodes of a lobe's shares and F, per bin. */
static void weigh(const struct um_optics_spectra *spectra, size_t skin, const double *share,
                  double *row)
{
  size_t n = spectra->nbin;
  const double *fresnel = spectra->fresnel + skin * UM_OPTICS_FRESNEL_NODES * n;
  memset(row, 0, n * sizeof *row);
  for (size_t k = 0; k < UM_OPTICS_FRESNEL_NODES; k++)
    for (size_t b = 0; b < n; b++) row[b] += share[k] * fresnel[k * n + b];
}

/* A direction of the body frame in that of the surface, x along its grain. */
static struct um_vec3 toward(const struct um_optics_sight *sight, struct um_vec3 direction,
                             double cosine)
{
  return um_vec3(um_vec3_dot(sight->grain, direction), um_vec3_dot(sight->across, direction),
                 cosine);
}

void um_optics_add_earth_lobe(const struct um_optics_spectra *spectra,
                              const struct um_optics_instant *instant, size_t skin,
                              const struct um_optics_sight *sight, double seen,
                              struct um_optics_work *work, struct um_optics_sum *sum)
{
  bool turned = um_materials_lobe_is_anisotropic(&spectra->lobe[skin]);
  struct um_optics_frame grain;
  if (turned)
    grain = (struct um_optics_frame){toward(sight, instant->observer_body, sight->cos_observer),
                                     toward(sight, instant->nadir_body, sight->cos_nadir),
                                     toward(sight, instant->sun_body, sight->cos_sun)};
  const struct um_optics_earth_before before = {
      sight->cos_observer,   sight->cos_nadir,   sight->cos_sun,   instant->observer_nadir,
      instant->observer_sun, instant->nadir_sun, instant->h_ratio, turned ? &grain : NULL};
  struct um_optics_earth_lobe lobe;
  size_t n = spectra->nbin;
  double whole = um_environment_plate_view_factor(instant->h_ratio,
                                                  acos(fmin(fmax(sight->cos_nadir, -1.0), 1.0)));
  double clear = whole > 0.0 ? fmin(1.0, sight->view_factor / whole) : 0.0;
  um_optics_earth_lobe(&before, &spectra->facets[skin], &lobe);
  if (instant->earthshine > 0.0 && sight->albedo > 0.0) {
    weigh(spectra, skin, lobe.lit, work->lobe_earth);
    for (size_t b = 0; b < n; b++) sum->earthlit[b] += seen * clear * work->lobe_earth[b];
  }
  if (spectra->diffuse_emitter[skin]) return;
  weigh(spectra, skin, lobe.all, work->lobe_all);
  /* before the whole of what the surface sees the edge of the Earth is its own horizon */
  weigh(spectra, skin, whole < ALL_OF_IT ? lobe.earth : lobe.all, work->lobe_earth);
  for (size_t b = 0; b < n; b++)
    work->lobe_earth[b] =
        work->lobe_all[b] > 0.0 ? clear * work->lobe_earth[b] / work->lobe_all[b] : 0.0;
}

void um_optics_add_planet(const struct um_optics_spectra *spectra,
                          const struct um_optics_instant *instant, size_t skin,
                          const struct um_optics_sight *sight, double seen,
                          const double *emissivity, struct um_optics_work *work,
                          struct um_optics_sum *sum)
{
  size_t n = spectra->nbin;
  const double *diffuse = spectra->diffuse + skin * n;
  const double *mean = spectra->masked_mean + skin * n;
  bool lobe = instant->earth_lobe && spectra->lobe[skin].kind != NULL;
  if (lobe && spectra->masks[skin])
    um_optics_spectra_masked(spectra, skin, sight->cos_observer, work->masked_observer);
  for (size_t b = 0; b < n; b++) {
    double back = sight->view_factor * (1.0 - emissivity[b]);
    if (lobe) {
      double flat = diffuse[b] - mean[b];
      if (spectra->masks[skin]) flat += work->masked_observer[b];
      flat = fmin(flat, 1.0 - emissivity[b]);
      back = sight->view_factor * flat + work->lobe_earth[b] * (1.0 - emissivity[b] - flat);
    }
    sum->planet[b] += seen * back * (instant->earth_varies ? work->earth[b] : 1.0);
  }
}
