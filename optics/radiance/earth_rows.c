/* Spectra of an Earth that varies, direction by direction. A node of the visible cap sends
 *
 *   L = (1 - c) r_g(T_s, w) B(T_s) + c r_c(T_c, w) B(T_c),
 *
 * ground of temperature T_s and cloud of T_c over the cover c, r what the air makes of a black body
 * (environment/earth_infrared.h); of an Earth that is not spectral B(T_b). What surfaces reflect by
 * their view factor comes of the mean over the cap, of which they have the brightness temperature:
 * earth_ratio is that mean over the black body of it. */
#include <math.h>
#include <string.h>

#include "base/core/planck.h"
#include "optics/radiance/lagrange_impl.h"
#include "optics/radiance/radiance_group.h"

enum um_status um_optics_earth_ratios_create(struct um_context *context,
                                             struct um_optics_spectra *s)
{
  size_t n = s->nbin;
  double cosine[UM_EARTH_SEEN_RINGS];
  for (int ring = 0; ring < UM_EARTH_SEEN_RINGS; ring++)
    cosine[ring] = um_environment_earth_seen_cosine(ring);
  UM_TRY(um_core_allocate(context, (size_t)UM_EARTH_TEMPERATURES * UM_EARTH_SEEN_RINGS * n,
                          sizeof *s->clear, &s->clear));
  UM_TRY(um_core_allocate(context, (size_t)UM_EARTH_TEMPERATURES * UM_EARTH_SEEN_RINGS * n,
                          sizeof *s->cloud, &s->cloud));
#pragma omp parallel for schedule(dynamic) num_threads(um_core_context_threads(context))
  for (size_t b = 0; b < n; b++)
    for (int step = 0; step < UM_EARTH_TEMPERATURES; step++) {
      double clear[UM_EARTH_SEEN_RINGS], cloud[UM_EARTH_SEEN_RINGS];
      um_environment_earth_ratios(s->from[b], s->to[b], UM_EARTH_COLDEST + UM_EARTH_STEP * step,
                                  cosine, UM_EARTH_SEEN_RINGS, clear, cloud);
      for (int ring = 0; ring < UM_EARTH_SEEN_RINGS; ring++) {
        size_t at = (size_t)(step * UM_EARTH_SEEN_RINGS + ring) * n + b;
        s->clear[at] = clear[ring];
        s->cloud[at] = cloud[ring];
      }
    }
  return UM_OK;
}

/* row += share r(T, w) B(T), r cubic between its temperatures; ratio NULL: 1. scratch[nbin] */
static void add_part(const struct um_optics_spectra *s, const double *ratio, int ring,
                     double temperature, double share, double *scratch, double *row)
{
  if (!(share > 0.0)) return;
  double place = (temperature - UM_EARTH_COLDEST) / UM_EARTH_STEP, weight[4];
  place = fmin(fmax(place, 0.0), UM_EARTH_TEMPERATURES - 1.0);
  int k = (int)fmin(fmax(place, 1.0), UM_EARTH_TEMPERATURES - 3.0);
  um_optics_spectra_planck(s, temperature, scratch);
  if (ratio == NULL) {
    for (size_t b = 0; b < s->nbin; b++) row[b] += share * scratch[b];
    return;
  }
  um_optics_lagrange_weights(place - k, weight);
  size_t n = s->nbin, stride = UM_EARTH_SEEN_RINGS * n;
  const double *at = ratio + (size_t)(k - 1) * stride + (size_t)ring * n;
  for (size_t b = 0; b < n; b++)
    row[b] += share * scratch[b] *
              (weight[0] * at[b] + weight[1] * at[stride + b] + weight[2] * at[2 * stride + b] +
               weight[3] * at[3 * stride + b]);
}

void um_optics_earth_rows(const struct um_optics_spectra *spectra,
                          const struct um_optics_instant *instant, struct um_optics_work *work)
{
  if (!instant->earth_varies) return;
  const struct um_environment_earth_seen *seen = &instant->earth;
  size_t n = spectra->nbin;
  double window = 0.0, *mean = work->earth_ratio, *scratch = work->planck;
  memset(mean, 0, n * sizeof *mean);
  for (int k = 0; k < UM_EARTH_SEEN_NODES; k++) {
    int ring = k / UM_EARTH_SEEN_AROUND;
    struct um_environment_ground_parts part = seen->parts[k];
    double *row = work->earth_row + (size_t)k * n;
    double share = seen->share[ring] / UM_EARTH_SEEN_AROUND;
    double limb = um_environment_earth_limb(um_environment_earth_seen_cosine(ring));
    window += share * (seen->spectral ? limb : 1.0) *
              um_core_planck_radiance(UM_EARTH_WINDOW, seen->ground[k].brightness);
    for (int pass = 0; pass < 2; pass++) { /* as it is; as lobes have it */
      double cover = part.cover + (pass == 1 ? instant->mirror_cloud : 0.0);
      if (pass == 1 && instant->mirror_cloud == 0.0) break;
      cover = fmin(fmax(cover, 0.0), 1.0);
      memset(row, 0, n * sizeof *row);
      if (seen->spectral) {
        add_part(spectra, spectra->clear, ring, part.surface, 1.0 - cover, scratch, row);
        add_part(spectra, spectra->cloud, ring, part.top, cover, scratch, row);
      } else {
        add_part(spectra, NULL, ring, seen->ground[k].brightness, 1.0, scratch, row);
      }
      for (size_t b = 0; b < n && pass == 0; b++) mean[b] += share * row[b];
    }
  }
  um_optics_spectra_planck(spectra, um_core_planck_temperature(UM_EARTH_WINDOW, window), scratch);
  for (size_t b = 0; b < n; b++) mean[b] = scratch[b] > 0.0 ? mean[b] / scratch[b] : 1.0;
}

void um_optics_earth_mirrored(const struct um_optics_spectra *spectra, const double *where,
                              const struct um_optics_work *work, double *row)
{
  size_t n = spectra->nbin;
  double all = 0.0;
  memset(row, 0, n * sizeof *row);
  for (int k = 0; k < UM_EARTH_SEEN_NODES; k++) {
    if (where[k] == 0.0) continue;
    const double *from = work->earth_row + (size_t)k * n;
    all += where[k];
    for (size_t b = 0; b < n; b++) row[b] += where[k] * from[b];
  }
  for (size_t b = 0; b < n && all > 0.0; b++) row[b] /= all;
}

void um_optics_earth_toward(const struct um_optics_spectra *spectra,
                            const struct um_optics_instant *instant, struct um_vec3 direction,
                            const struct um_optics_work *work, double *row, double *albedo)
{
  unsigned short node[4];
  double weight[4];
  size_t n = spectra->nbin;
  um_environment_earth_seen_at(&instant->earth.axes, direction, node, weight);
  memset(row, 0, n * sizeof *row);
  *albedo = 0.0;
  for (int k = 0; k < 4; k++) {
    const double *from = work->earth_row + (size_t)node[k] * n;
    *albedo += weight[k] * instant->earth.ground[node[k]].albedo;
    for (size_t b = 0; b < n; b++) row[b] += weight[k] * from[b];
  }
}
