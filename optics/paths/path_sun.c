/* Sunlight at the vertices of paths. Straight from the Sun by a shadow ray to a point of its disc
 * (next-event estimation; f_r the disc's mean); by way of mirrors as photons (photons_group.h):
 *
 *   f_r = flat parts + lobe:  all but a narrow lobe  <- the Sun, photons
 *                             a narrow lobe          <- the Sun, if the path met nothing else,
 *
 * so that each sequence of parts is counted once: a narrow lobe that the path comes to by way of
 * anything else is the mirror of a photon there. */
#include <math.h>
#include <string.h>

#include "optics/paths/bundle_impl.h"

enum { KEY_DISC = 0x64697363, KEY_PICK = 0x7069636b };

struct um_vec3 um_optics_disc_direction(const struct um_optics_instant *now, const double u[2])
{
  double xy[2];
  struct um_vec3 t, b;
  um_core_sample_disc(u, xy);
  um_core_vec3_frame(now->sun_body, &t, &b);
  double size = tan(now->sun_radius);
  struct um_vec3 d = um_vec3_axpy(now->sun_body, size * xy[0], t);
  return um_vec3_unit(um_vec3_axpy(d, size * xy[1], b));
}

static void add_sunlight(const struct um_optics_bundle *p, int i, const double *left,
                         const struct um_optics_turn *turn, enum um_optics_parts parts)
{
  struct um_optics_work *work = p->paths.work;
  double *sum = um_optics_bundle_gathered(p, i);
  um_optics_vertex_row(&p->paths, &p->vertex[i], turn, parts, work->incoming);
  for (size_t b = 0; b < p->paths.spectra->nbin; b++)
    sum[b] += left[b] * work->incoming[b] * work->sunlight[b];
}

/* Sunlight at the vertices that paths have come to; what mirrors throw elsewhere than to the
 * observer comes as photons. */
void um_optics_bundle_add_sun(struct um_optics_bundle *p, int vertex)
{
  const struct um_optics_posed_scene *posed = p->paths.posed;
  struct um_optics_work *work = p->paths.work;
  struct um_optics_turn turn[UM_OPTICS_PATHS];
  int of[UM_OPTICS_PATHS], n = 0;
  if (!(p->paths.instant->sun > 0.0)) return;
  for (int a = 0; a < p->alive; a++) {
    int i = p->of[a];
    double u[2] = {um_optics_bundle_number(p, i, vertex, KEY_DISC),
                   um_optics_bundle_number(p, i, vertex, KEY_DISC + 1)};
    if (!um_optics_vertex_sun(&p->paths, &p->vertex[i], &turn[n])) continue;
    work->ray[n] = (struct um_geometry_ray){
        p->vertex[i].point, um_optics_disc_direction(p->paths.instant, u), INFINITY,
        posed->exchange->mesh->surface[p->vertex[i].surface].facet};
    of[n++] = i;
  }
  um_geometry_visibility_occluded(posed->visibility, work->ray, (size_t)n, work->occluded);
  for (int k = 0; k < n; k++) {
    if (work->occluded[k]) continue;
    const struct um_optics_vertex *v = &p->vertex[of[k]];
    add_sunlight(p, of[k], um_optics_bundle_throughput(p, of[k]), &turn[k],
                 v->mirror ? UM_OPTICS_FLAT : UM_OPTICS_WHOLE);
    if (v->mirror && p->mirrors[of[k]])
      add_sunlight(p, of[k], um_optics_bundle_mirrored(p, of[k]), &turn[k], UM_OPTICS_LOBE);
  }
}

static void note_brought(const struct um_optics_bundle *p, const struct um_optics_photon *photon,
                         double worth, const double *row)
{
  size_t nband = p->photons->nband;
  for (size_t k = 0; k < nband; k++)
    p->photons->brought[photon->root * nband + k] +=
        worth * um_optics_band_sum(p->paths.spectra, k, row);
}

/* What vertices scatter of one photon each, for all that fell on their surface: of a surface the
 * place of its photons is not told apart. */
void um_optics_bundle_add_photons(struct um_optics_bundle *p, int vertex)
{
  const struct um_optics_photons *photons = p->photons;
  const struct um_geometry_mesh *mesh = p->paths.posed->exchange->mesh;
  struct um_optics_work *work = p->paths.work;
  int most = p->paths.scene->interreflection_most;
  for (int a = 0; a < p->alive; a++) {
    int i = p->of[a];
    struct um_optics_turn turn;
    const struct um_optics_vertex *v = &p->vertex[i];
    size_t n = um_optics_photons_on(photons, v->surface);
    if (n == 0) continue;
    size_t pick = (size_t)(um_optics_bundle_number(p, i, vertex, KEY_PICK) * (double)n);
    const struct um_optics_photon *photon =
        &photons->photon[photons->order[photons->first[v->surface] + pick]];
    if (most > 0 && vertex + photon->mirrors > most) continue;
    if (!um_optics_vertex_lit(&p->paths, v, photon->from, &turn)) continue;
    double *sum = um_optics_bundle_gathered(p, i), *left = um_optics_bundle_throughput(p, i);
    double flux = (double)photon->area * (double)n / mesh->area[mesh->surface[v->surface].facet];
    um_optics_vertex_row(&p->paths, v, &turn, UM_OPTICS_WHOLE, work->incoming);
    um_optics_photon_row(&p->paths, photons, photon, work->row);
    for (size_t b = 0; b < p->paths.spectra->nbin; b++) {
      work->row[b] *= flux * left[b] * work->incoming[b];
      sum[b] += work->row[b];
    }
    note_brought(p, photon, p->worth, work->row);
  }
}

static void add_seen_photon(struct um_optics_bundle *p, size_t surface,
                            const struct um_optics_photon *photon)
{
  const struct um_geometry_mesh *mesh = p->paths.posed->exchange->mesh;
  struct um_optics_work *work = p->paths.work;
  struct um_optics_vertex *v = &p->vertex[0];
  struct um_optics_turn turn;
  double area = mesh->area[mesh->surface[surface].facet];
  int most = p->paths.scene->interreflection_most;
  if (most > 0 && photon->mirrors > most) return;
  um_optics_vertex_place(&p->paths, surface, photon->point, p->paths.instant->observer_body, v);
  if (!um_optics_vertex_lit(&p->paths, v, photon->from, &turn)) return;
  um_optics_vertex_row(&p->paths, v, &turn, UM_OPTICS_WHOLE, work->incoming);
  um_optics_photon_row(&p->paths, p->photons, photon, work->row);
  for (size_t b = 0; b < p->paths.spectra->nbin; b++) {
    work->row[b] *= (double)photon->area / area * work->incoming[b];
    work->reflected[b] += work->row[b];
  }
  note_brought(p, photon, area * v->o.z, work->row);
}

/* What of the photons on the surface itself goes to the observer, each from where it fell. */
void um_optics_bundle_add_seen_photons(struct um_optics_bundle *p, size_t surface, double seen)
{
  const struct um_optics_posed_scene *posed = p->paths.posed;
  const struct um_optics_photons *photons = p->photons;
  const struct um_geometry_mesh *mesh = posed->exchange->mesh;
  struct um_optics_work *work = p->paths.work;
  uint32_t facet = mesh->surface[surface].facet;
  for (size_t first = photons->first[surface], n; first < photons->first[surface + 1]; first += n) {
    n = photons->first[surface + 1] - first;
    if (n > UM_OPTICS_PATHS) n = UM_OPTICS_PATHS;
    memset(work->hidden, 0, n);
    for (size_t i = 0; i < n; i++)
      work->ray[i] = (struct um_geometry_ray){photons->photon[photons->order[first + i]].point,
                                              p->paths.instant->observer_body, INFINITY, facet};
    if (seen < 1.0) um_geometry_visibility_occluded(posed->visibility, work->ray, n, work->hidden);
    for (size_t i = 0; i < n; i++)
      if (!work->hidden[i])
        add_seen_photon(p, surface, &photons->photon[photons->order[first + i]]);
  }
}
