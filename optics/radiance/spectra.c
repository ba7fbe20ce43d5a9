/* Wavelength bins and the tables of sources and materials on them; black bodies: planck.c.
 * Emissivities are interpolated in u = sqrt(cos), which is dense where metals peak. */
#include "optics/radiance/spectra_impl.h"

#include <math.h>

#include "optics/radiance/lagrange_impl.h"

const char *um_optics_mechanism_name(enum um_optics_mechanism mechanism)
{
  static const char *const name[UM_MECHANISM_COUNT] = {"sun", "earth", "emitted", "interreflected",
                                                       "other"};
  return name[mechanism];
}

#define BINS_MAX 100000

/* Table [UM_OPTICS_ANGLE_NODES][n] at a cosine. */
static void at_cosine(const double *table, size_t n, double cosine, double *row)
{
  double place = sqrt(fmin(fmax(cosine, 0.0), 1.0)) * (UM_OPTICS_ANGLE_NODES - 1);
  size_t node = (size_t)place;
  if (node < 1) node = 1;
  if (node > UM_OPTICS_ANGLE_NODES - 3) node = UM_OPTICS_ANGLE_NODES - 3;
  double w[4];
  um_optics_lagrange_weights(place - (double)node, w);
  um_optics_lagrange_rows(w, table + (node - 1) * n, n, n, row);
}

void um_optics_spectra_masked(const struct um_optics_spectra *spectra, size_t skin, double cosine,
                              double *row)
{
  size_t n = spectra->nbin;
  at_cosine(spectra->masked + skin * UM_OPTICS_ANGLE_NODES * n, n, cosine, row);
}

const double *um_optics_spectra_untilted(const struct um_optics_spectra *spectra, size_t skin,
                                         double cosine, double *row)
{
  size_t n = spectra->nbin;
  const double *table = spectra->emissivity + skin * UM_OPTICS_ANGLE_NODES * n;
  if (spectra->diffuse_emitter[skin]) return table;
  at_cosine(table, n, cosine, row);
  return row;
}

const double *um_optics_spectra_emissivity(const struct um_optics_spectra *spectra, size_t skin,
                                           double cosine, double *row)
{
  const double *upright = um_optics_spectra_untilted(spectra, skin, cosine, row);
  const double *tilt = spectra->tilt + skin * spectra->nbin;
  if (!spectra->tilts[skin]) return upright;
  for (size_t b = 0; b < spectra->nbin; b++)
    row[b] = um_materials_emissivity_tilted(upright[b], tilt[b], cosine);
  return row;
}

static enum um_status check_bands(struct um_context *context, const struct um_optics_band *bands,
                                  size_t nband)
{
  if (nband == 0)
    return um_core_fail(context, UM_ERR_INPUT, "bands: none given; accepted: 1 or more");
  for (size_t k = 0; k < nband; k++) {
    const struct um_optics_band *b = &bands[k];
    if (!(b->from > 0.0 && b->to > b->from && isfinite(b->to)))
      return um_core_fail(context, UM_ERR_INPUT,
                          "band '%s': %g to %g um; accepted: 0 < from < to, finite", b->name,
                          1e6 * b->from, 1e6 * b->to);
    if (b->bins < 1 || b->bins > BINS_MAX)
      return um_core_fail(context, UM_ERR_INPUT, "band '%s': %d bins; accepted: 1 to %d", b->name,
                          b->bins, BINS_MAX);
  }
  return UM_OK;
}

#define GROUND_COLDEST 190.0 /* of what an Earth that is spectral shows [K] */
#define GROUND_WARMEST 325.0

/* Lowest and highest temperature [K] of the samples asked for. */
static enum um_status temperature_range(struct um_context *context,
                                        const struct um_optics_scene *scene, size_t first,
                                        size_t count, double *low, double *high)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(scene->geometry);
  *low = INFINITY;
  *high = 0.0;
  for (size_t t = first; t < first + count; t++)
    for (size_t s = 0; s < mesh->nsurface; s++) {
      double value = scene->temperature[t * mesh->nsurface + s];
      if (!(value > 0.0 && isfinite(value)))
        return um_core_fail(context, UM_ERR_NUMERIC,
                            "part '%s', facet %u, sample %zu: temperature %g K; accepted: above 0",
                            um_geometry_part_name(scene->geometry, mesh->surface[s].part),
                            (unsigned)mesh->surface[s].facet, t, value);
      if (value < *low) *low = value;
      if (value > *high) *high = value;
      if (scene->brightness == NULL) continue;
      double earth = (double)scene->brightness[t * mesh->nsurface + s];
      if (earth > 100.0 && earth < *low) *low = earth; /* colder is evaluated directly */
      if (earth > *high) *high = earth;
    }
  if (scene->brightness != NULL && um_environment_earth_is_spectral(scene->environment)) {
    *low = fmin(*low, GROUND_COLDEST);
    *high = fmax(*high, GROUND_WARMEST);
  }
  return UM_OK;
}

static enum um_status bins_create(struct um_context *context, const struct um_optics_band *bands,
                                  struct um_optics_spectra *s)
{
  UM_TRY(um_core_allocate(context, s->nband + 1, sizeof *s->first, &s->first));
  for (size_t k = 0; k < s->nband; k++) s->first[k + 1] = s->first[k] + (size_t)bands[k].bins;
  s->nbin = s->first[s->nband];
  UM_TRY(um_core_allocate(context, s->nbin, sizeof *s->wavelength, &s->wavelength));
  UM_TRY(um_core_allocate(context, s->nbin, sizeof *s->width, &s->width));
  UM_TRY(um_core_allocate(context, s->nbin, sizeof *s->from, &s->from));
  UM_TRY(um_core_allocate(context, s->nbin, sizeof *s->to, &s->to));
  UM_TRY(um_core_allocate(context, s->nbin, sizeof *s->transmission, &s->transmission));
  UM_TRY(um_core_allocate(context, s->nbin, sizeof *s->band, &s->band));
  for (size_t k = 0; k < s->nband; k++)
    for (size_t b = s->first[k]; b < s->first[k + 1]; b++) {
      int i = (int)(b - s->first[k]);
      s->from[b] = um_optics_band_edge(&bands[k], i);
      s->to[b] = um_optics_band_edge(&bands[k], i + 1);
      s->width[b] = s->to[b] - s->from[b];
      s->wavelength[b] = 0.5 * (s->from[b] + s->to[b]);
      s->transmission[b] =
          bands[k].transmission != NULL ? bands[k].transmission[b - s->first[k]] : 1.0;
      s->band[b] = (uint32_t)k;
    }
  return UM_OK;
}

static enum um_status sources_create(struct um_context *context,
                                     const struct um_environment *environment,
                                     struct um_optics_spectra *s)
{
  UM_TRY(um_core_allocate(context, s->nbin, sizeof *s->sun, &s->sun));
  UM_TRY(um_core_allocate(context, s->nbin, sizeof *s->share, &s->share));
  UM_TRY(um_core_allocate(context, s->nbin, sizeof *s->earth, &s->earth));
  for (size_t b = 0; b < s->nbin; b++) {
    s->sun[b] = um_environment_solar_band(environment, s->from[b], s->to[b]) / s->width[b];
    s->share[b] =
        environment->solar_irradiance > 0.0 ? s->sun[b] / environment->solar_irradiance : 0.0;
    s->earth[b] = um_optics_planck_mean(s, b, environment->brightness_temperature);
  }
  return UM_OK;
}

static enum um_status materials_allocate(struct um_context *context, struct um_optics_spectra *s)
{
  size_t n = s->nskin;
  UM_TRY(um_core_allocate(context, n * s->nbin, sizeof *s->diffuse, &s->diffuse));
  UM_TRY(um_core_allocate(context, n * UM_OPTICS_ANGLE_NODES * s->nbin, sizeof *s->emissivity,
                          &s->emissivity));
  UM_TRY(um_core_allocate(context, n, sizeof *s->diffuse_emitter, &s->diffuse_emitter));
  UM_TRY(um_core_allocate(context, n * s->nbin, sizeof *s->tilt, &s->tilt));
  UM_TRY(um_core_allocate(context, n, sizeof *s->tilts, &s->tilts));
  UM_TRY(um_core_allocate(context, n * UM_OPTICS_ANGLE_NODES * s->nbin, sizeof *s->masked,
                          &s->masked));
  UM_TRY(um_core_allocate(context, n * s->nbin, sizeof *s->masked_mean, &s->masked_mean));
  UM_TRY(um_core_allocate(context, n, sizeof *s->masks, &s->masks));
  UM_TRY(um_core_allocate(context, n, sizeof *s->lobe_share, &s->lobe_share));
  UM_TRY(um_core_allocate(context, n, sizeof *s->lobe, &s->lobe));
  UM_TRY(um_core_allocate(context, n, sizeof *s->flat, &s->flat));
  UM_TRY(um_core_allocate(context, n, sizeof *s->facets, &s->facets));
  UM_TRY(um_core_allocate(context, n * UM_OPTICS_LOBE_RINGS * UM_OPTICS_LOBE_CELLS, sizeof *s->half,
                          &s->half));
  UM_TRY(um_core_allocate(context, n * s->nband, sizeof *s->has_lobe, &s->has_lobe));
  return um_core_allocate(context, n * UM_OPTICS_FRESNEL_NODES * s->nbin, sizeof *s->fresnel,
                          &s->fresnel);
}

/* The lobe of a material: its facets, and F at the nodes of their cosines. */
static void lobe_fill(const struct um_context *context, const struct um_materials_record *record,
                      const struct um_materials_adjustment *adjustment, bool compensated, size_t m,
                      struct um_optics_spectra *s)
{
  s->lobe[m] = um_materials_lobe(record, adjustment);
  if (s->lobe[m].kind == NULL) return;
  s->lobe[m].compensated = s->lobe[m].compensated && compensated;
  s->facets[m] =
      (struct um_optics_lobe_facets){s->lobe[m], UM_OPTICS_LOBE_RINGS, UM_OPTICS_LOBE_CELLS,
                                     s->half + m * UM_OPTICS_LOBE_RINGS * UM_OPTICS_LOBE_CELLS};
  um_optics_lobe_facets_fill(&s->facets[m]);
  double *fresnel = s->fresnel + m * UM_OPTICS_FRESNEL_NODES * s->nbin;
#pragma omp parallel for schedule(static) num_threads(um_core_context_threads(context))
  for (size_t b = 0; b < s->nbin; b++)
    for (int k = 0; k < UM_OPTICS_FRESNEL_NODES; k++)
      fresnel[(size_t)k * s->nbin + b] = um_materials_specular_reflectance(
          record, adjustment, s->wavelength[b], um_optics_fresnel_node(k));
  for (size_t band = 0; band < s->nband; band++) {
    bool *has = &s->has_lobe[m * s->nband + band];
    *has = false;
    for (size_t k = 0; k < UM_OPTICS_FRESNEL_NODES && !*has; k++)
      for (size_t b = s->first[band]; b < s->first[band + 1] && !*has; b++)
        *has = fresnel[k * s->nbin + b] != 0.0;
  }
}

/* How often a path goes on by the lobe rather than by the flat parts: by what both reflect at
 * normal incidence, the mean of the bands. Three steps, so that a parameter that is moved a little
 * leaves the paths where they are. */
static double lobe_share(const struct um_optics_spectra *s, size_t m)
{
  double mean = 0.0;
  if (s->lobe[m].kind == NULL) return 0.0;
  const double *f =
      s->fresnel + (m * UM_OPTICS_FRESNEL_NODES + UM_OPTICS_FRESNEL_NODES - 1) * s->nbin;
  for (size_t k = 0; k < s->nband; k++) {
    double lobe = 0.0, flat = 0.0;
    for (size_t b = s->first[k]; b < s->first[k + 1]; b++) {
      lobe += f[b] * s->width[b];
      flat += s->diffuse[m * s->nbin + b] * s->width[b];
    }
    if (lobe > 0.0) mean += lobe / (lobe + flat) / (double)s->nband;
  }
  return mean < 0.25 ? 0.2 : mean < 0.75 ? 0.5 : 0.85;
}

static enum um_status materials_check(struct um_context *context,
                                      const struct um_optics_scene *scene)
{
  for (size_t m = 0; m < um_geometry_material_count(scene->geometry); m++)
    if (scene->material[m] == NULL)
      return um_core_fail(context, UM_ERR_INPUT, "material '%s' has no record",
                          um_geometry_material_name(scene->geometry, m));
  return UM_OK;
}

void um_optics_spectra_materials(const struct um_context *context,
                                 const struct um_optics_scene *scene, size_t time,
                                 struct um_optics_spectra *s)
{
  const struct um_optics_creases *creases = s->creases;
  bool compensated = scene->environment->multiple_scattering_on; /* from facet to facet */
  s->grain =
      s->varies || (creases != NULL && creases->patches->first[creases->patches->nsurface] > 0);
  for (size_t m = 0; m < s->nskin; m++) {
    size_t material = um_optics_material(s, m);
    const struct um_materials_record *record = scene->material[material];
    const struct um_materials_adjustment *adjustment = um_optics_adjustment(scene, time, material);
    struct um_materials_adjustment creased, upright = um_materials_no_adjustment;
    s->flat[m] = um_materials_lobe(record, adjustment);
    s->flat[m].compensated = s->flat[m].compensated && compensated;
    if (creases != NULL && creases->slope_variance[m] > 0.0) {
      creased = adjustment != NULL ? *adjustment : um_materials_no_adjustment;
      creased.lobe.slope_variance = creases->slope_variance[m];
      adjustment = &creased;
    }
    s->diffuse_emitter[m] = um_materials_emissivity_is_diffuse(record, adjustment);
    s->tilts[m] = adjustment != NULL && adjustment->emissivity_tilt != 0.0;
    if (adjustment != NULL) upright = *adjustment;
    upright.emissivity_tilt = 0.0;
    lobe_fill(context, record, adjustment, compensated, m, s);
    s->grain = s->grain || um_materials_lobe_is_anisotropic(&s->lobe[m]);
    size_t nodes = s->diffuse_emitter[m] ? 1 : UM_OPTICS_ANGLE_NODES;
    s->masks[m] = compensated && s->lobe[m].kind != NULL && !um_materials_is_grey(record) &&
                  !um_materials_lobe_is_whole(&s->lobe[m]);
    double *emissivity = s->emissivity + m * UM_OPTICS_ANGLE_NODES * s->nbin;
    double *masked = s->masked + m * UM_OPTICS_ANGLE_NODES * s->nbin;
#pragma omp parallel for schedule(dynamic, 1) num_threads(um_core_context_threads(context))
    for (size_t b = 0; b < s->nbin; b++) {
      double wavelength = s->wavelength[b];
      s->diffuse[m * s->nbin + b] =
          um_materials_diffuse_reflectance(record, adjustment, wavelength);
      for (size_t i = 0; i < nodes; i++) {
        double u = nodes == 1 ? 1.0 : (double)i / (UM_OPTICS_ANGLE_NODES - 1);
        emissivity[i * s->nbin + b] = um_materials_emissivity(record, &upright, wavelength, u * u);
      }
      s->tilt[m * s->nbin + b] = um_materials_emissivity_tilt(record, adjustment, wavelength);
      double masked_mean = um_materials_masked_mean(record, adjustment, wavelength);
      s->masked_mean[m * s->nbin + b] = compensated ? masked_mean : 0.0;
      if (!compensated) s->diffuse[m * s->nbin + b] -= masked_mean;
      for (size_t i = 0; i < UM_OPTICS_ANGLE_NODES && s->masks[m]; i++) {
        double u = (double)i / (UM_OPTICS_ANGLE_NODES - 1);
        masked[i * s->nbin + b] =
            um_materials_masked_reflectance(record, adjustment, wavelength, u * u);
      }
    }
    s->lobe_share[m] = lobe_share(s, m);
  }
}

enum um_status um_optics_spectra_share(struct um_context *context,
                                       const struct um_optics_spectra *from,
                                       struct um_optics_spectra *to)
{
  *to = *from;
  to->diffuse = to->emissivity = to->masked = to->masked_mean = NULL;
  to->diffuse_emitter = to->masks = to->tilts = NULL;
  to->tilt = NULL;
  to->lobe_share = NULL;
  to->has_lobe = NULL;
  to->lobe = to->flat = NULL;
  to->facets = NULL;
  to->half = NULL;
  to->fresnel = NULL;
  return materials_allocate(context, to);
}

void um_optics_spectra_share_clear(struct um_context *context, struct um_optics_spectra *shared)
{
  void *const blocks[] = {shared->diffuse, shared->emissivity, shared->diffuse_emitter,
                          shared->lobe,    shared->masked,     shared->masked_mean,
                          shared->masks,   shared->facets,     shared->half,
                          shared->fresnel, shared->flat,       shared->lobe_share,
                          shared->tilt,    shared->tilts,      shared->has_lobe};
  for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) um_core_free(context, blocks[i]);
}

enum um_status um_optics_spectra_create(struct um_context *context,
                                        const struct um_optics_scene *scene, size_t first,
                                        size_t count, const struct um_optics_band *bands,
                                        size_t nband, struct um_optics_spectra **out)
{
  enum um_status status = UM_OK;
  struct um_optics_spectra *s = NULL;
  double low, high;
  *out = NULL;
  UM_CHECK(check_bands(context, bands, nband));
  UM_CHECK(temperature_range(context, scene, first, count, &low, &high));
  UM_CHECK(um_core_allocate(context, 1, sizeof *s, &s));
  s->nband = nband;
  s->nmaterial = um_geometry_material_count(scene->geometry);
  s->creases = scene->creases;
  s->varies = scene->brightness != NULL;
  s->nskin = s->creases != NULL ? s->creases->nskin : s->nmaterial;
  s->npart = um_geometry_part_count(scene->geometry);
  s->njoint = um_geometry_joint_count(scene->geometry);
  UM_CHECK(bins_create(context, bands, s));
  UM_CHECK(sources_create(context, scene->environment, s));
  if (scene->brightness != NULL && um_environment_earth_is_spectral(scene->environment))
    UM_CHECK(um_optics_earth_ratios_create(context, s));
  UM_CHECK(materials_check(context, scene));
  UM_CHECK(materials_allocate(context, s));
  um_optics_spectra_materials(context, scene, first, s);
  UM_CHECK(um_optics_planck_create(context, low, high, s));
  *out = s;
  s = NULL;
done:
  um_optics_spectra_destroy(context, &s);
  return status;
}

void um_optics_spectra_destroy(struct um_context *context, struct um_optics_spectra **spectra)
{
  if (spectra == NULL || *spectra == NULL) return;
  struct um_optics_spectra *s = *spectra;
  if (s->planck != NULL)
    for (size_t k = 0; k < s->nband; k++) um_core_free(context, s->planck[k].radiance);
  void *const blocks[] = {
      s->wavelength, s->width,    s->from,         s->to,      s->band,       s->first,
      s->sun,        s->share,    s->earth,        s->diffuse, s->emissivity, s->diffuse_emitter,
      s->lobe,       s->masked,   s->masked_mean,  s->masks,   s->planck,     s->facets,
      s->half,       s->fresnel,  s->transmission, s->flat,    s->lobe_share, s->tilt,
      s->tilts,      s->has_lobe, s->clear,        s->cloud};
  for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) um_core_free(context, blocks[i]);
  um_core_free(context, s);
  *spectra = NULL;
}
