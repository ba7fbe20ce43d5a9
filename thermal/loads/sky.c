/* The sky of every covered surface, which geometry answers by rays. Surfaces of one normal lie side
 * by side, since they look at the same cells. */
#include "thermal/loads/sky.h"

#include "geometry/cube.h"
#include "geometry/visibility.h"
#include "thermal/loads/sky_impl.h"

#define SAMPLES 4 /* rays in a cell */
#define LANES   UM_IRRADIATION_LANES
#define CELLS   UM_GEOMETRY_OPEN_CELLS

#define BLOCKS UM_IRRADIATION_BLOCKS

/* Words of every class. surface [LANES * words]: of each class, in their order, UINT32_MAX behind
 * the last one; room for it: LANES * BLOCKS - 1 a class more than there are surfaces. */
static enum um_status lay_out(struct um_context *context,
                              const struct um_geometry_visibility *visibility,
                              struct um_irradiation_sky *sky, uint32_t *surface)
{
  const struct um_irradiation_normals *normals = &sky->normals;
  size_t n = 0;
  UM_TRY(um_core_allocate(context, normals->n + 1, sizeof *sky->word, &sky->word));
  for (size_t i = 0; i < normals->n; i++) {
    size_t first = sky->word[i] = n / LANES;
    for (size_t k = normals->begin[i]; k < normals->begin[i + 1]; k++)
      if (!um_geometry_visibility_is_open(visibility, normals->order[k]))
        surface[n++] = normals->order[k];
    size_t whole = n - LANES * first > LANES ? LANES * BLOCKS : LANES;
    while ((n - LANES * first) % whole != 0) surface[n++] = UINT32_MAX;
  }
  sky->word[normals->n] = n / LANES;
  UM_TRY(um_core_allocate(context, n / LANES, CELLS * sizeof *sky->freedom, &sky->freedom));
  return n > 0 ? um_core_allocate(context, UM_IRRADIATION_CUBE_CELLS, sizeof *sky->cell, &sky->cell)
               : UM_OK;
}

/* Words of one class: [CELLS][n]. */
static void fill_class(const struct um_geometry_sky *traced, const uint32_t *surface, size_t n,
                       uint32_t *to)
{
  for (size_t i = 0; i < LANES * n; i++) {
    size_t block = i / LANES % BLOCKS, lane = i % LANES;
    size_t word = n > 1 ? i / (LANES * BLOCKS) * BLOCKS + lane : 0, byte = n > 1 ? block : lane;
    for (uint16_t cell = 0; cell < CELLS && surface[i] != UINT32_MAX; cell++)
      to[cell * n + word] |= (uint32_t)um_geometry_sky_freedom(traced, surface[i], cell)
                             << 8 * byte;
  }
}

static void fill(struct um_context *context, const struct um_geometry_sky *traced,
                 const uint32_t *surface, struct um_irradiation_sky *sky)
{
  long nclass = (long)sky->normals.n;
  for (size_t i = 0; i < UM_IRRADIATION_CUBE_CELLS; i++)
    sky->cell[i] =
        um_geometry_sky_cell(um_geometry_cube_direction(UM_IRRADIATION_CUBE_SIDE, i, 0.5, 0.5));
#pragma omp parallel for schedule(dynamic, 1) num_threads(um_core_context_threads(context))
  for (long i = 0; i < nclass; i++)
    fill_class(traced, surface + LANES * sky->word[i], sky->word[i + 1] - sky->word[i],
               sky->freedom + sky->word[i] * CELLS);
}

static enum um_status look(struct um_context *context, const struct um_geometry_mesh *mesh,
                           const struct um_geometry_pose *pose, struct um_irradiation_sky *sky)
{
  enum um_status status;
  struct um_geometry_visibility *visibility = NULL;
  struct um_geometry_sky *traced = NULL;
  uint32_t *surface = NULL;
  UM_CHECK(um_geometry_visibility_create(context, mesh, pose, &visibility));
  UM_CHECK(um_irradiation_normals_find(context, mesh, pose, &sky->normals));
  UM_CHECK(um_core_allocate(context, mesh->nsurface + (LANES * BLOCKS - 1) * sky->normals.n,
                            sizeof *surface, &surface));
  UM_CHECK(lay_out(context, visibility, sky, surface));
  if (sky->word[sky->normals.n] == 0) goto done; /* all is open */
  UM_CHECK(um_geometry_sky_create(context, visibility, SAMPLES, &traced));
  fill(context, traced, surface, sky);
done:
  um_geometry_sky_destroy(&traced);
  um_geometry_visibility_destroy(&visibility);
  um_core_free(context, surface);
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
  um_geometry_joint_angles(geometry, um_vec3(0, 0, 1), 0.0,
                           angles); /* wherever the Sun is, at any time */
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
  UM_FREE(context, (*sky)->word, (*sky)->cell, (*sky)->freedom, *sky);
  *sky = NULL;
}

size_t um_irradiation_sky_bytes(const struct um_irradiation_sky *sky)
{
  return sky == NULL ? 0 : sky->word[sky->normals.n] * CELLS * sizeof *sky->freedom;
}
