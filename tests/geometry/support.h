/* What the tests of geometry share: a context, satellites from specs, their scene. */
#ifndef UMBRA_TESTS_GEOMETRY_SUPPORT_H
#define UMBRA_TESTS_GEOMETRY_SUPPORT_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/context.h"
#include "base/core/sampling.h"
#include "geometry/geometry.h"
#include "geometry/visibility.h"
#include "tests/support/cmocka_all.h"

/* One skin for every group; closed bodies have no back. */
static const struct um_geometry_skin support_closed = {NULL, "paint", NULL};
static const struct um_geometry_skin support_open = {NULL, "cell", "cfrp"};

struct support {
  struct um_context *context;
  struct um_geometry *geometry;
  const struct um_geometry_mesh *mesh;
  struct um_geometry_pose *pose;
  struct um_geometry_visibility *visibility;
};

static inline struct um_geometry_part_spec support_box(const char *name, double x, double y,
                                                       double z)
{
  return (struct um_geometry_part_spec){.name = name,
                                        .shape = UM_SHAPE_BOX,
                                        .size = {x, y, z},
                                        .rotation = {1, 0, 0, 0},
                                        .skins = &support_closed,
                                        .nskin = 1};
}

static inline struct um_geometry_part_spec support_plate(const char *name, double x, double y,
                                                         struct um_vec3 position)
{
  return (struct um_geometry_part_spec){.name = name,
                                        .shape = UM_SHAPE_PLATE,
                                        .size = {x, y, 0},
                                        .position = position,
                                        .rotation = {1, 0, 0, 0},
                                        .skins = &support_open,
                                        .nskin = 1};
}

/* Geometry, pose at rest angles and scene; fails the test with the message. */
static inline struct support support_create(const struct um_geometry_part_spec *parts, size_t npart)
{
  struct support s = {NULL, NULL, NULL, NULL, NULL};
  assert_int_equal(um_core_context_create(NULL, &s.context), UM_OK);
  if (um_geometry_create(s.context, parts, npart, &s.geometry) != UM_OK)
    fail_msg("%s", um_core_message(s.context));
  s.mesh = um_geometry_mesh(s.geometry);
  if (um_geometry_pose_create(s.context, s.geometry, NULL, &s.pose) != UM_OK)
    fail_msg("%s", um_core_message(s.context));
  if (um_geometry_visibility_create(s.context, s.mesh, s.pose, &s.visibility) != UM_OK)
    fail_msg("%s", um_core_message(s.context));
  return s;
}

static inline void support_destroy(struct support *s)
{
  um_geometry_visibility_destroy(&s->visibility);
  um_geometry_pose_destroy(s->context, &s->pose);
  um_geometry_destroy(&s->geometry);
  um_core_context_destroy(&s->context);
}

/* Sum over surfaces of area x cos x free fraction: the area that shows toward d [m^2]. */
static inline double support_projected_area(const struct support *s, struct um_vec3 d, int nsample)
{
  double *fraction = calloc(s->mesh->nsurface, sizeof *fraction), sum = 0.0;
  assert_non_null(fraction);
  um_geometry_visibility_toward(s->visibility, d, nsample, fraction);
  for (size_t i = 0; i < s->mesh->nsurface; i++) {
    double cosine = um_vec3_dot(um_geometry_surface_normal(s->mesh, s->pose, i), d);
    sum += s->mesh->area[s->mesh->surface[i].facet] * fmax(0.0, cosine) * fraction[i];
  }
  free(fraction);
  return sum;
}

/* Create must fail with UM_ERR_INPUT and a message that holds `expected`. */
static inline void support_refused(const struct um_geometry_part_spec *parts, size_t npart,
                                   const char *expected)
{
  struct um_context *context;
  struct um_geometry *geometry;
  assert_int_equal(um_core_context_create(NULL, &context), UM_OK);
  enum um_status status = um_geometry_create(context, parts, npart, &geometry);
  if (status != UM_ERR_INPUT || strstr(um_core_message(context), expected) == NULL)
    fail_msg("status %d, message '%s', expected one with '%s'", (int)status,
             um_core_message(context), expected);
  assert_null(geometry);
  um_core_context_destroy(&context);
}

#endif
