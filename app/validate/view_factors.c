/* View factors between plates and discs by cosine-distributed rays (Howell, A Catalog of Radiation
 * Heat Transfer Configuration Factors, C-11, C-14, C-41; a cube must close). Points are independent
 * and uniform, so that the standard error is sqrt(F (1 - F) / N); 4 of them are accepted: 6e-5
 * false alarms a row, and the points are always the same. */
#include <math.h>

#include "app/validate/cases_impl.h"
#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "geometry/visibility.h"

#define HOWELL "Howell"
enum { RAYS = 400000, BATCH = 1000 };

static double uniform(uint64_t key, uint64_t index)
{
  return um_core_hash_uniform(um_core_hash(key, index));
}

struct room {
  struct um_geometry *geometry;
  const struct um_geometry_mesh *mesh;
  struct um_geometry_pose *pose;
  struct um_geometry_visibility *visibility;
  struct um_geometry_ray rays[BATCH];
  struct um_geometry_hit hits[BATCH];
};

/* Rays first..first + BATCH from the front of part 0, facets chosen by area. */
static void rays_from(struct room *room, uint64_t first)
{
  const struct um_geometry_mesh *mesh = room->mesh;
  double total = 0.0;
  for (size_t f = 0; f < mesh->nfacet && mesh->facet_part[f] == 0; f++) total += mesh->area[f];
  for (uint64_t k = 0; k < BATCH; k++) {
    uint64_t i = first + k;
    double pick = uniform(1, i) * total, w[3];
    double point[2] = {uniform(2, i), uniform(3, i)}, turn[2] = {uniform(4, i), uniform(5, i)};
    uint32_t f = 0;
    while (mesh->facet_part[f + 1] == 0 && pick >= mesh->area[f]) pick -= mesh->area[f++];
    um_core_sample_triangle(point, w);
    struct um_vec3 p = {0.0, 0.0, 0.0};
    for (int j = 0; j < 3; j++) p = um_vec3_axpy(p, w[j], room->pose->vertex[mesh->corner[f][j]]);
    room->rays[k] = (struct um_geometry_ray){
        p, um_core_sample_cosine(turn, room->pose->facet_normal[f]), INFINITY, f};
  }
}

/* Fraction of what leaves the front of part 0 that arrives at part 1. */
static enum um_status view_factor(struct um_context *context,
                                  const struct um_geometry_part_spec part[2], double *out)
{
  struct room *room = NULL;
  size_t arrived = 0;
  enum um_status status;
  UM_CHECK(um_core_allocate(context, 1, sizeof *room, &room));
  UM_CHECK(um_geometry_create(context, part, 2, &room->geometry));
  room->mesh = um_geometry_mesh(room->geometry);
  UM_CHECK(um_geometry_pose_create(context, room->geometry, NULL, &room->pose));
  UM_CHECK(um_geometry_visibility_create(context, room->mesh, room->pose, &room->visibility));
  for (uint64_t first = 0; first < RAYS; first += BATCH) {
    rays_from(room, first);
    um_geometry_visibility_closest(room->visibility, room->rays, BATCH, room->hits);
    for (size_t k = 0; k < BATCH; k++)
      arrived += room->hits[k].facet != UM_GEOMETRY_NONE &&
                 room->mesh->facet_part[room->hits[k].facet] == 1;
  }
  *out = (double)arrived / RAYS;
done:
  if (room != NULL) {
    um_geometry_visibility_destroy(&room->visibility);
    um_geometry_pose_destroy(context, &room->pose);
    um_geometry_destroy(&room->geometry);
  }
  um_core_free(context, room);
  return status;
}

static struct um_geometry_part_spec surface(const char *name, enum um_geometry_shape shape,
                                            double x, double y, struct um_vec3 position)
{
  static const struct um_geometry_skin skin = {NULL, "front", "back"};
  return (struct um_geometry_part_spec){.name = name,
                                        .shape = shape,
                                        .size = {x, y, 0.0},
                                        .radius = x,
                                        .position = position,
                                        .rotation = {1.0, 0.0, 0.0, 0.0},
                                        .skins = &skin,
                                        .nskin = 1};
}

/* 4 standard errors, and what the facets leave of a curved outline. */
static enum um_status add(struct um_context *context, struct um_validate_report *report,
                          const char *name, const struct um_geometry_part_spec part[2],
                          double expected, double facets)
{
  double f;
  UM_TRY(view_factor(context, part, &f));
  um_validate_report_add(report, name, "1", expected, f,
                         4.0 * sqrt(expected * (1.0 - expected) / RAYS) + facets, HOWELL);
  return UM_OK;
}

enum um_status um_validate_view_factors(struct um_context *context,
                                        struct um_validate_report *report)
{
  static const struct {
    const char *name;
    double x, distance, factor;
  } aligned[] = {{"View factor, unit squares 1 apart", 1.0, 1.0, 0.199825},
                 {"View factor, unit squares 0.5 apart", 1.0, 0.5, 0.415253},
                 {"View factor, unit squares 2 apart", 1.0, 2.0, 0.068590},
                 {"View factor, 2 x 1 plates 1 apart", 2.0, 1.0, 0.285875}};
  const struct um_quat down = um_quat_from_axis(um_vec3(1.0, 0.0, 0.0), UM_PI);
  const struct um_vec3 origin = {0.0, 0.0, 0.0};
  struct um_geometry_part_spec part[2];
  for (size_t i = 0; i < sizeof aligned / sizeof aligned[0]; i++) {
    part[0] = surface("below", UM_SHAPE_PLATE, aligned[i].x, 1.0, origin);
    part[1] =
        surface("above", UM_SHAPE_PLATE, aligned[i].x, 1.0, um_vec3(0.0, 0.0, aligned[i].distance));
    part[1].rotation = down;
    UM_TRY(add(context, report, aligned[i].name, part, aligned[i].factor, 0.0));
  }
  static const struct {
    const char *name;
    double height, factor;
  } wall[] = {{"View factor, floor to wall of height 1", 1.0, 0.200044},
              {"View factor, floor to wall of height 2", 2.0, 0.232853}};
  for (size_t i = 0; i < sizeof wall / sizeof wall[0]; i++) {
    part[0] = surface("floor", UM_SHAPE_PLATE, 1.0, 1.0, origin);
    part[1] = surface("wall", UM_SHAPE_PLATE, wall[i].height, 1.0,
                      um_vec3(0.5, 0.0, 0.5 * wall[i].height));
    part[1].rotation = um_quat_from_axis(um_vec3(0.0, 1.0, 0.0), -0.5 * UM_PI);
    UM_TRY(add(context, report, wall[i].name, part, wall[i].factor, 0.0));
  }
  /* discs of equal area as polygons of 126 segments: O(n^-2) = 6e-5 */
  for (int k = 0; k < 2; k++) {
    part[k] = surface(k ? "above" : "below", UM_SHAPE_DISC, 1.0, 0.0, um_vec3(0.0, 0.0, k));
    part[k].facet_size = 0.0712;
  }
  part[1].rotation = down;
  UM_TRY(add(context, report, "View factor, unit discs 1 apart", part, 0.381966, 6e-5));
  /* a cube closes: no ray from a desk inside slips through an edge */
  part[0] = surface("desk", UM_SHAPE_PLATE, 0.5, 0.5, origin);
  static const struct um_geometry_skin closed = {NULL, "paint", NULL};
  part[1] = surface("room", UM_SHAPE_BOX, 1.0, 1.0, origin);
  part[1].size[2] = 1.0;
  part[1].skins = &closed;
  double f;
  UM_TRY(view_factor(context, part, &f));
  um_validate_report_add(report, "View factor, desk to the cube around it", "1", 1.0, f, 0.0,
                         "closure");
  return UM_OK;
}
