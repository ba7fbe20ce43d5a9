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
  double r = um_vec3_norm(sample->r);
  now->earth_varies = now->earth_varies && r >= environment->earth_radius;
  if (now->earth_varies) {
    struct um_environment_globe globe = {sample->t_tai, sample->pole, sample->greenwich};
    struct um_environment_earth_axes *axes = &now->earth.axes;
    um_environment_earth_seen(environment, &globe, sample->r, sample->sun, sample->sun_distance,
                              &now->earth);
    axes->nadir = um_quat_apply(sample->q, axes->nadir);
    axes->sunward = um_quat_apply(sample->q, axes->sunward);
    axes->side = um_quat_apply(sample->q, axes->side);
    now->mirror_cloud = environment->mirror_cloud;
  }
  now->earth_lobe = environment->earthlight_lobe_on && r >= environment->earth_radius;
  if (!now->earth_lobe) return;
  now->nadir_body = um_optics_nadir(sample);
  now->h_ratio = r / environment->earth_radius;
  now->observer_nadir = um_vec3_dot(now->observer_body, now->nadir_body);
  now->observer_sun = um_vec3_dot(now->observer_body, now->sun_body);
  now->nadir_sun = um_vec3_dot(now->nadir_body, now->sun_body);
  now->earth_radiance = (now->earth_varies ? 1.0 : environment->albedo) *
                        um_environment_solar_irradiance(environment, sample->sun_distance) / UM_PI;
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

/* A vector with x toward a, which has no z here, and y to the side that `mirror` says. */
static struct um_vec3 turned_to(struct um_vec3 v, struct um_vec3 a, double mirror)
{
  return um_vec3(a.x * v.x + a.y * v.y, mirror * (a.x * v.y - a.y * v.x), v.z);
}

/* Of a lobe without a grain: x toward the observer and the nadir on the side of positive y, as
 * where the Earth does not vary, so that the same facets are taken. */
static void turn_to_observer(struct um_optics_frame *f, struct um_environment_earth_axes *axes)
{
  struct um_vec3 level = um_vec3(f->observer.x, f->observer.y, 0.0);
  double length = um_vec3_norm(level);
  if (!(length > 1e-9)) { /* the azimuth counts from the nadir */
    level = um_vec3(f->nadir.x, f->nadir.y, 0.0);
    length = um_vec3_norm(level);
  }
  if (!(length > 1e-9)) return;
  level = um_vec3_scale(level, 1.0 / length);
  double side = turned_to(f->nadir, level, 1.0).y;
  if (!(fabs(side) > 1e-9)) side = turned_to(f->sun, level, 1.0).y;
  double mirror = side < 0.0 ? -1.0 : 1.0;
  struct um_vec3 *const all[] = {&f->observer, &f->nadir,      &f->sun,
                                 &axes->nadir, &axes->sunward, &axes->side};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++)
    *all[k] = turned_to(*all[k], level, mirror);
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
  if (turned || instant->earth_varies)
    grain = (struct um_optics_frame){toward(sight, instant->observer_body, sight->cos_observer),
                                     toward(sight, instant->nadir_body, sight->cos_nadir),
                                     toward(sight, instant->sun_body, sight->cos_sun)};
  struct um_environment_earth_axes axes = {.h = instant->h_ratio};
  if (instant->earth_varies) {
    const struct um_environment_earth_axes *body = &instant->earth.axes;
    struct um_vec3 normal = um_vec3_cross(sight->grain, sight->across);
    axes.nadir = toward(sight, body->nadir, um_vec3_dot(normal, body->nadir));
    axes.sunward = toward(sight, body->sunward, um_vec3_dot(normal, body->sunward));
    axes.side = toward(sight, body->side, um_vec3_dot(normal, body->side));
    if (!turned) turn_to_observer(&grain, &axes);
  }
  const struct um_optics_earth_before before = {sight->cos_observer,
                                                sight->cos_nadir,
                                                sight->cos_sun,
                                                instant->observer_nadir,
                                                instant->observer_sun,
                                                instant->nadir_sun,
                                                instant->h_ratio,
                                                turned || instant->earth_varies ? &grain : NULL,
                                                instant->earth_varies ? &instant->earth : NULL,
                                                axes};
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
  if (varies && earth->clear > 0.0)
    um_optics_earth_mirrored(spectra, shares->lobe.where, work, work->earth_clear);
  weigh(spectra, skin, shares->lobe.all, work->lobe_all);
  /* before the whole of what the surface sees the edge of the Earth is its own horizon */
  weigh(spectra, skin, shares->whole < ALL_OF_IT ? shares->lobe.earth : shares->lobe.all,
        work->lobe_earth);
  for (size_t b = 0; b < n; b++) {
    double flat = diffuse[b] - mean[b];
    if (masks) flat += masked[b];
    flat = fmin(flat, 1.0 - emissivity[b]);
    double filled = all[b] > 0.0 ? part[b] / all[b] : 0.0;
    planet[b] += (varies ? work->earth[b] : earth->view_factor) * flat +
                 earth->clear * (varies ? work->earth_clear[b] : 1.0) * filled *
                     (1.0 - emissivity[b] - flat);
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
    for (size_t b = 0; b < n; b++) work->earth[b] *= work->earth_ratio[b];
    memset(work->earth_clear, 0, n * sizeof *work->earth_clear);
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
