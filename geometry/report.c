/* What a user wants to know of a part: area, volume (divergence theorem,
 * V = sum v0 . (v1 x v2) / 6), open and overused edges, sharpest angle. */
#include "geometry/report_impl.h"

#include "base/core/constants.h"
#include "geometry/geometry_impl.h"

static double angle_at(struct um_vec3 at, struct um_vec3 b, struct um_vec3 c)
{
  return um_vec3_angle(um_vec3_sub(b, at), um_vec3_sub(c, at));
}

static void add_facet(struct um_geometry_report *report, struct um_vec3 middle, struct um_vec3 a,
                      struct um_vec3 b, struct um_vec3 c, double *volume)
{
  struct um_vec3 cross = um_vec3_cross(um_vec3_sub(b, a), um_vec3_sub(c, a));
  double twice_area = um_vec3_norm(cross);
  struct um_vec3 ab = um_vec3_sub(b, a), bc = um_vec3_sub(c, b), ca = um_vec3_sub(a, c);
  double longest2 = fmax(um_vec3_dot(ab, ab), fmax(um_vec3_dot(bc, bc), um_vec3_dot(ca, ca)));
  if (!(twice_area > UM_GEOMETRY_DEGENERATE * longest2)) report->ndegenerate++;
  report->area += 0.5 * twice_area;
  *volume += um_vec3_dot(um_vec3_sub(a, middle), cross) / 6.0;
  double sharpest = fmin(angle_at(a, b, c), fmin(angle_at(b, c, a), angle_at(c, a, b)));
  report->sharpest_angle = fmin(report->sharpest_angle, sharpest);
}

struct um_geometry_report um_geometry_report_compute(const struct um_geometry_patch *patch,
                                                     const struct um_geometry_edges *edges)
{
  struct um_geometry_report report = {
      .nvertex = patch->nvertex, .nfacet = patch->nfacet, .sharpest_angle = UM_PI};
  /* volumes are taken about the mean vertex, which keeps cancellation small far from the origin */
  struct um_vec3 middle = um_vec3(0, 0, 0);
  for (size_t i = 0; i < patch->nvertex; i++) middle = um_vec3_add(middle, patch->vertex[i]);
  middle = um_vec3_scale(middle, 1.0 / (double)patch->nvertex);
  double volume = 0.0;
  for (size_t f = 0; f < patch->nfacet; f++) {
    const uint32_t *c = patch->corner[f];
    add_facet(&report, middle, patch->vertex[c[0]], patch->vertex[c[1]], patch->vertex[c[2]],
              &volume);
  }
  bool oriented = true;
  for (size_t e = 0; e < edges->nedge; e++) {
    if (edges->edge[e].uses == 1) report.nboundary_edge++;
    if (edges->edge[e].uses > 2) report.nonmanifold_edge++;
    if (edges->edge[e].uses == 2 && edges->edge[e].forward != 1) oriented = false;
  }
  report.closed = report.nboundary_edge == 0 && report.nonmanifold_edge == 0 && oriented;
  report.volume = report.closed ? volume : NAN;
  return report;
}

struct um_geometry_report um_geometry_report(const struct um_geometry *geometry, size_t part)
{
  return geometry->part[part].report;
}

double um_geometry_material_area(const struct um_geometry *geometry, size_t material)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(geometry);
  double area = 0.0;
  for (size_t s = 0; s < mesh->nsurface; s++)
    if (mesh->surface[s].material == material) area += mesh->area[mesh->surface[s].facet];
  return area;
}
