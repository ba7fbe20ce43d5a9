/* The sky of every covered surface, in cells of a cube, from the finer question that geometry
 * answers by rays. Surfaces of one normal lie side by side, since they look at the same cells. */
#include "thermal/loads/sky.h"

#include "geometry/cube.h"
#include "geometry/visibility.h"
#include "thermal/loads/sky_impl.h"

#define SAMPLES 4 /* rays in a cell of the finer sky */
#define LANES   UM_IRRADIATION_LANES
#define CELLS   UM_IRRADIATION_CUBE_CELLS

/* Groups of every class. lane [LANES * groups]: the surface of each, UINT32_MAX behind the last one
 * of a class; room for it: LANES - 1 a class more than there are surfaces. */
static enum um_status group(struct um_context *context,
                            const struct um_geometry_visibility *visibility,
                            struct um_irradiation_sky *sky, uint32_t *lane)
{
  const struct um_irradiation_normals *normals = &sky->normals;
  size_t n = 0;
  UM_TRY(um_core_allocate(context, normals->n + 1, sizeof *sky->group, &sky->group));
  for (size_t i = 0; i < normals->n; i++) {
    sky->group[i] = n / LANES;
    for (size_t k = normals->begin[i]; k < normals->begin[i + 1]; k++)
      if (!um_geometry_visibility_is_open(visibility, normals->order[k]))
        lane[n++] = normals->order[k];
    while (n % LANES != 0) lane[n++] = UINT32_MAX;
  }
  sky->group[normals->n] = n / LANES;
  /* who looks at a group fetches the next one: there is one behind the last */
  return um_core_allocate(context, n / LANES + 1, CELLS * sizeof *sky->freedom, &sky->freedom);
}

/* Freedom of every cell from that of the finer sky in its middle. */
static enum um_status fill(struct um_context *context, const struct um_geometry_sky *fine,
                           const uint32_t *lane, struct um_irradiation_sky *sky)
{
  uint16_t *middle = NULL; /* [CELLS] cell of the finer sky */
  UM_TRY(um_core_allocate(context, CELLS, sizeof *middle, &middle));
  for (size_t cell = 0; cell < CELLS; cell++)
    middle[cell] =
        um_geometry_sky_cell(um_geometry_cube_direction(UM_IRRADIATION_CUBE_SIDE, cell, 0.5, 0.5));
  long ngroup = (long)sky->group[sky->normals.n];
#pragma omp parallel for schedule(static) num_threads(um_core_context_threads(context))
  for (long g = 0; g < ngroup; g++)
    for (size_t l = 0; l < LANES; l++) {
      uint32_t *to = sky->freedom + (size_t)g * CELLS, s = lane[(size_t)g * LANES + l];
      for (size_t cell = 0; cell < CELLS && s != UINT32_MAX; cell++)
        to[cell] |= (uint32_t)um_geometry_sky_freedom(fine, s, middle[cell]) << 8 * l;
    }
  um_core_free(context, middle);
  return UM_OK;
}

static enum um_status look(struct um_context *context, const struct um_geometry_mesh *mesh,
                           const struct um_geometry_pose *pose, struct um_irradiation_sky *sky)
{
  enum um_status status;
  struct um_geometry_visibility *visibility = NULL;
  struct um_geometry_sky *fine = NULL;
  uint32_t *lane = NULL;
  UM_CHECK(um_geometry_visibility_create(context, mesh, pose, &visibility));
  UM_CHECK(um_irradiation_normals_find(context, mesh, pose, &sky->normals));
  UM_CHECK(um_core_allocate(context, mesh->nsurface + (LANES - 1) * sky->normals.n, sizeof *lane,
                            &lane));
  UM_CHECK(group(context, visibility, sky, lane));
  if (sky->group[sky->normals.n] == 0) goto done; /* all is open */
  UM_CHECK(um_geometry_sky_create(context, visibility, SAMPLES, &fine));
  UM_CHECK(fill(context, fine, lane, sky));
done:
  um_geometry_sky_destroy(&fine);
  um_geometry_visibility_destroy(&visibility);
  um_core_free(context, lane);
  return status;
}

enum um_status um_irradiation_sky_create(struct um_context *context,
                                         const struct um_geometry *geometry,
                                         struct um_irradiation_sky **out)
{
  enum um_status status;
  struct um_irradiation_sky *sky = NULL;
  struct um_geometry_pose *pose = NULL;
  size_t njoint = um_geometry_joint_count(geometry);
  double *angles = NULL;
  *out = NULL;
  if (um_geometry_joint_moves(geometry))
    return um_core_fail(context, UM_ERR_INPUT,
                        "one sky of a body whose joints move; accepted: joints that stand still");
  UM_CHECK(um_core_allocate(context, 1, sizeof *sky, &sky));
  UM_CHECK(um_core_allocate(context, njoint, sizeof *angles, &angles));
  um_geometry_joint_angles(geometry, um_vec3(0, 0, 1), angles); /* wherever the Sun is */
  UM_CHECK(um_geometry_pose_create(context, geometry, njoint == 0 ? NULL : angles, &pose));
  UM_CHECK(look(context, um_geometry_mesh(geometry), pose, sky));
  *out = sky;
  sky = NULL;
done:
  um_geometry_pose_destroy(context, &pose);
  um_core_free(context, angles);
  um_irradiation_sky_destroy(context, &sky);
  return status;
}

void um_irradiation_sky_destroy(struct um_context *context, struct um_irradiation_sky **sky)
{
  if (sky == NULL || *sky == NULL) return;
  um_irradiation_normals_clear(context, &(*sky)->normals);
  UM_FREE(context, (*sky)->group, (*sky)->freedom, *sky);
  *sky = NULL;
}

size_t um_irradiation_sky_bytes(const struct um_irradiation_sky *sky)
{
  return sky == NULL ? 0 : sky->group[sky->normals.n] * CELLS * sizeof *sky->freedom;
}
