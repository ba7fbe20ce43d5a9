/* Light of the Earth in the radiance of a surface: its sunlit ground and its own radiation, in the
 * lobe and beside it (docs/physics/earthlight.md; radiance.c has the whole sum). */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "optics/radiance/radiance_group.h"

#define ALL_OF_IT (1.0 - 1e-9) /* view factor of a surface that sees nothing but the Earth */

struct um_vec3 um_optics_nadir(const struct um_environment_sample *sample)
{
  double r = um_vec3_norm(sample->r);
  if (!(r > 0.0)) return um_vec3(0.0, 0.0, 0.0);
  return um_quat_apply(sample->q, um_vec3_scale(sample->r, -1.0 / r));
}

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

/* Sum over the nodes of a lobe's shares and F, per bin. Most shares are 0, a lobe being narrow, and
 * many records have none in some of the bands. */
static void weigh(const struct um_optics_spectra *spectra, size_t skin, const double *share,
                  double *row)
{
  size_t n = spectra->nbin;
  const double *fresnel = spectra->fresnel + skin * UM_OPTICS_FRESNEL_NODES * n;
  memset(row, 0, n * sizeof *row);
  for (size_t band = 0; band < spectra->nband; band++) {
    if (!spectra->has_lobe[skin * spectra->nband + band]) continue;
    size_t first = spectra->first[band], end = spectra->first[band + 1];
    for (size_t k = 0; k < UM_OPTICS_FRESNEL_NODES; k++) {
      if (share[k] == 0.0) continue;
      for (size_t b = first; b < end; b++) row[b] += share[k] * fresnel[k * n + b];
    }
  }
}

/* A direction of the body frame in that of the surface, x along its grain. */
static struct um_vec3 toward(const struct um_optics_sight *sight, struct um_vec3 direction,
                             double cosine)
{
  return um_vec3(um_vec3_dot(sight->grain, direction), um_vec3_dot(sight->across, direction),
                 cosine);
}

static bool mirrors_earth(const struct um_optics_spectra *spectra,
                          const struct um_optics_instant *instant, size_t skin)
{
  return instant->earth_lobe && spectra->lobe[skin].kind != NULL;
}

bool um_optics_reflects_evenly(const struct um_optics_spectra *spectra,
                               const struct um_optics_instant *instant, size_t skin)
{
  return spectra->diffuse_emitter[skin] && !mirrors_earth(spectra, instant, skin);
}

void um_optics_earth_shares(const struct um_optics_spectra *spectra,
                            const struct um_optics_instant *instant, size_t skin,
                            const struct um_optics_sight *sight,
                            struct um_optics_earth_shares *shares)
{
  shares->whole = 0.0;
  if (instant->sunlight_only || !mirrors_earth(spectra, instant, skin)) return;
  bool turned = um_materials_lobe_is_anisotropic(&spectra->lobe[skin]);
  struct um_optics_frame grain;
  if (turned)
    grain = (struct um_optics_frame){toward(sight, instant->observer_body, sight->cos_observer),
                                     toward(sight, instant->nadir_body, sight->cos_nadir),
                                     toward(sight, instant->sun_body, sight->cos_sun)};
  const struct um_optics_earth_before before = {
      sight->cos_observer,   sight->cos_nadir,   sight->cos_sun,   instant->observer_nadir,
      instant->observer_sun, instant->nadir_sun, instant->h_ratio, turned ? &grain : NULL};
  shares->whole = um_environment_plate_view_factor(instant->h_ratio,
                                                   acos(fmin(fmax(sight->cos_nadir, -1.0), 1.0)));
  um_optics_earth_lobe(&before, &spectra->facets[skin], &shares->lobe);
}

void um_optics_earth_seen_add(const struct um_optics_spectra *spectra,
                              const struct um_optics_instant *instant,
                              const struct um_optics_earth_shares *shares,
                              const struct um_optics_sight *sight, double area,
                              struct um_optics_work *work, struct um_optics_earth_seen *earth)
{
  double clear = shares->whole > 0.0 ? area * fmin(1.0, sight->view_factor / shares->whole) : 0.0;
  earth->view_factor += area * sight->view_factor;
  earth->clear += clear;
  if (sight->albedo > 0.0) earth->clear_lit += clear;
  if (!instant->earth_varies) return;
  um_optics_planck_sum_add(spectra, sight->brightness, area * sight->view_factor, &work->far);
  if (clear > 0.0) um_optics_planck_sum_add(spectra, sight->brightness, clear, &work->clear);
}

/* What a surface reflects of the Earth's radiation, per bin: the diffuse parts by view factor and
 * the lobe as far as the Earth fills it. */
static void add_planet(const struct um_optics_spectra *spectra,
                       const struct um_optics_instant *instant, size_t skin,
                       const struct um_optics_sight *sight,
                       const struct um_optics_earth_shares *shares,
                       const struct um_optics_earth_seen *earth, const double *emissivity,
                       struct um_optics_work *work, double *planet)
{
  size_t n = spectra->nbin;
  bool varies = instant->earth_varies;
  if (!mirrors_earth(spectra, instant, skin)) {
    for (size_t b = 0; b < n; b++)
      planet[b] += (varies ? work->earth[b] : earth->view_factor) * (1.0 - emissivity[b]);
    return;
  }
  const double *diffuse = spectra->diffuse + skin * n;
  const double *mean = spectra->masked_mean + skin * n;
  const double *all = work->lobe_all, *part = work->lobe_earth, *masked = work->masked_observer;
  bool masks = spectra->masks[skin];
  if (masks) um_optics_spectra_masked(spectra, skin, sight->cos_observer, work->masked_observer);
  weigh(spectra, skin, shares->lobe.all, work->lobe_all);
  /* before the whole of what the surface sees the edge of the Earth is its own horizon */
  weigh(spectra, skin, shares->whole < ALL_OF_IT ? shares->lobe.earth : shares->lobe.all,
        work->lobe_earth);
  for (size_t b = 0; b < n; b++) {
    double flat = diffuse[b] - mean[b];
    if (masks) flat += masked[b];
    flat = fmin(flat, 1.0 - emissivity[b]);
    double filled = all[b] > 0.0 ? part[b] / all[b] : 0.0;
    planet[b] +=
        (varies ? work->earth[b] : earth->view_factor) * flat +
        (varies ? work->earth_clear[b] : earth->clear) * filled * (1.0 - emissivity[b] - flat);
  }
}

void um_optics_add_earth(const struct um_optics_spectra *spectra,
                         const struct um_optics_instant *instant, size_t skin,
                         const struct um_optics_sight *sight,
                         const struct um_optics_earth_shares *shares,
                         const struct um_optics_earth_seen *earth, const double *emissivity,
                         struct um_optics_work *work, struct um_optics_sum *sum)
{
  size_t n = spectra->nbin;
  if (instant->earth_varies) {
    um_optics_planck_sum_end(spectra, &work->far, work->earth);
    um_optics_planck_sum_end(spectra, &work->clear, work->earth_clear);
  }
  if (mirrors_earth(spectra, instant, skin) && instant->earthshine > 0.0 &&
      earth->clear_lit > 0.0) {
    weigh(spectra, skin, shares->lobe.lit, work->lobe_earth);
    for (size_t b = 0; b < n; b++) sum->earthlit[b] += earth->clear_lit * work->lobe_earth[b];
  }
  if (um_optics_reflects_evenly(spectra, instant, skin) && !instant->earth_varies)
    sum->view_factor += earth->view_factor;
  else
    add_planet(spectra, instant, skin, sight, shares, earth, emissivity, work, sum->planet);
}
