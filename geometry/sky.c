/* The sky of each surface in body frame: free fraction per directional cell.
 *
 * Cells are the squares of a 32 x 32 grid on the equal-area octahedral map of the sphere (Clarberg
 * 2008, "Fast equal-area mapping of the (hemi)sphere using SIMD", J. Graphics Tools 13:53): every
 * cell has solid angle 4 pi / 1024. Each cell is sampled with nsample rays from points of the facet
 * in directions spread over the cell, both keyed by the facet; fractions are kept in steps of
 * 1/255. A direction of a cell that lies below the surface's horizon is mirrored at its plane. Open
 * surfaces have no cells. */
#include <assert.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "geometry/visibility.h"
#include "geometry/visibility_data_impl.h"

#define SIDE       32
#define NCELL      UM_GEOMETRY_OPEN_CELLS
#define NDIRECTION 64
#define KEY_SKY    UINT64_C(0x736b79)
#define BATCH      256

_Static_assert(NCELL == SIDE * SIDE, "cells of the square");

struct um_geometry_sky {
  struct um_context *context;
  size_t *row;      /* [nsurface] first cell in `freedom`; SIZE_MAX where open */
  uint8_t *freedom; /* [nrow][NCELL] free fraction times 255 */
};

/* Map square [-1,1]^2 to the sphere (Clarberg 2008): with d = 1 - |u| - |v| and r = 1 - |d|,
 * phi = pi/4 ((|v| - |u|) / r + 1), |z| = 1 - r^2, rho = r sqrt(2 - r^2). */
static struct um_vec3 sphere_of(double u, double v)
{
  double d = 1.0 - fabs(u) - fabs(v), r = 1.0 - fabs(d);
  double phi = r > 0.0 ? 0.25 * UM_PI * ((fabs(v) - fabs(u)) / r + 1.0) : 0.0;
  double rho = r * sqrt(2.0 - r * r);
  return um_vec3(copysign(rho * cos(phi), u), copysign(rho * sin(phi), v),
                 copysign(1.0 - r * r, d));
}

/* The inverse: cell of a unit direction. */
static size_t cell_of(struct um_vec3 w)
{
  double r = sqrt(fmax(0.0, 1.0 - fabs(w.z)));
  double phi = atan2(fabs(w.y), fabs(w.x)); /* [0, pi/2] */
  double v = r * phi * 2.0 / UM_PI, u = r - v;
  if (w.z < 0.0) { /* the lower half is folded outward */
    double swap = u;
    u = 1.0 - v;
    v = 1.0 - swap;
  }
  u = copysign(u, w.x);
  v = copysign(v, w.y);
  double i = floor(0.5 * (u + 1.0) * SIDE), j = floor(0.5 * (v + 1.0) * SIDE);
  i = fmin(fmax(i, 0.0), SIDE - 1.0);
  j = fmin(fmax(j, 0.0), SIDE - 1.0);
  return (size_t)j * SIDE + (size_t)i;
}

/* Direction at (x, y) in [0,1)^2 of a cell. */
static struct um_vec3 direction_of(size_t cell, double x, double y)
{
  size_t row = cell / SIDE;
  double i = (double)(cell % SIDE), j = (double)row;
  return sphere_of(2.0 * (i + x) / SIDE - 1.0, 2.0 * (j + y) / SIDE - 1.0);
}

/* What all surfaces share. */
struct cells {
  struct um_vec3 centre[NCELL];
  double reach[NCELL]; /* sine of the angle from the centre to the farthest point of the cell */
  struct um_vec3 direction[NCELL][NDIRECTION];
};

static void fill_cells(struct cells *cells)
{
  for (size_t cell = 0; cell < NCELL; cell++) {
    struct um_vec3 centre = direction_of(cell, 0.5, 0.5);
    double farthest = 0.0;
    for (int y = 0; y <= 2; y++)
      for (int x = 0; x <= 2; x++)
        farthest = fmax(farthest, um_vec3_angle(centre, direction_of(cell, 0.5 * x, 0.5 * y)));
    cells->centre[cell] = centre;
    /* a tenth more: the farthest point need not be a corner */
    cells->reach[cell] = sin(1.1 * farthest);
    for (uint64_t k = 0; k < NDIRECTION; k++) {
      double u[2];
      um_geometry_points_second((uint64_t)cell * NDIRECTION + k, u);
      cells->direction[cell][k] = direction_of(cell, u[0], u[1]);
    }
  }
}

struct sky_batch {
  struct um_geometry_ray ray[BATCH];
  size_t cell[BATCH];
  size_t n;
};

static void trace(const struct um_geometry_visibility *v, struct sky_batch *batch, double *count)
{
  uint8_t occluded[BATCH];
  um_geometry_visibility_occluded(v, batch->ray, batch->n, occluded);
  for (size_t i = 0; i < batch->n; i++) count[batch->cell[i]] += occluded[i] ? 0.0 : 1.0;
  batch->n = 0;
}

static void fill_surface(const struct um_geometry_visibility *v, const struct cells *cells,
                         size_t surface, int nsample, uint8_t freedom[NCELL])
{
  struct um_vec3 n = um_geometry_surface_normal(v->mesh, v->pose, surface);
  uint32_t facet = v->mesh->surface[surface].facet;
  uint64_t key = um_core_hash(KEY_SKY, facet);
  double count[NCELL] = {0.0};
  struct sky_batch batch;
  batch.n = 0;
  for (size_t cell = 0; cell < NCELL; cell++) {
    if (um_vec3_dot(n, cells->centre[cell]) < -cells->reach[cell]) continue; /* below the horizon */
    uint64_t first = um_core_hash(key, cell);
    for (int k = 0; k < nsample; k++) {
      struct um_vec3 d = cells->direction[cell][(first + (uint64_t)k) % NDIRECTION];
      double height = um_vec3_dot(n, d);
      if (height <= 0.0) d = um_vec3_axpy(d, -2.0 * height, n);
      /* points go on from cell to cell and so cover the facet evenly over all cells */
      struct um_vec3 origin =
          um_geometry_points_facet(v, 0, facet, (uint64_t)cell * (uint64_t)nsample + (uint64_t)k);
      if (batch.n == BATCH) trace(v, &batch, count);
      batch.ray[batch.n] = (struct um_geometry_ray){origin, d, INFINITY, facet};
      batch.cell[batch.n++] = cell;
    }
  }
  trace(v, &batch, count);
  for (size_t cell = 0; cell < NCELL; cell++)
    freedom[cell] = (uint8_t)lround(255.0 * count[cell] / nsample);
}

enum um_status um_geometry_sky_create(struct um_context *context,
                                      const struct um_geometry_visibility *visibility, int nsample,
                                      struct um_geometry_sky **out)
{
  enum um_status status;
  struct um_geometry_sky *sky = NULL;
  struct cells *cells = NULL;
  size_t nsurface = visibility->mesh->nsurface, nrow = 0;
  assert(nsample >= 1);
  if (nsample < 1) nsample = 1;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *sky, (void *)&sky));
  sky->context = context;
  UM_CHECK(um_core_allocate(context, nsurface, sizeof *sky->row, (void *)&sky->row));
  for (size_t s = 0; s < nsurface; s++)
    sky->row[s] = visibility->open[s] ? SIZE_MAX : NCELL * nrow++;
  UM_CHECK(um_core_allocate(context, nrow, NCELL, (void *)&sky->freedom));
  UM_CHECK(um_core_allocate(context, 1, sizeof *cells, (void *)&cells));
  fill_cells(cells);
#pragma omp parallel for schedule(dynamic, 16) num_threads(um_core_context_threads(context))
  for (size_t s = 0; s < nsurface; s++)
    if (sky->row[s] != SIZE_MAX && !um_core_stopped(context))
      fill_surface(visibility, cells, s, nsample, sky->freedom + sky->row[s]);
  UM_CHECK(um_core_stop_check(context, "the sky of the surfaces was traced"));
  *out = sky;
  sky = NULL;
done:
  um_core_free(context, cells);
  um_geometry_sky_destroy(&sky);
  return status;
}

void um_geometry_sky_destroy(struct um_geometry_sky **sky)
{
  if (sky == NULL || *sky == NULL) return;
  UM_FREE((*sky)->context, (*sky)->row, (*sky)->freedom, *sky);
  *sky = NULL;
}

uint16_t um_geometry_sky_cell(struct um_vec3 d) { return (uint16_t)cell_of(d); }

uint8_t um_geometry_sky_freedom(const struct um_geometry_sky *sky, size_t surface, uint16_t cell)
{
  return sky->row[surface] == SIZE_MAX ? UINT8_MAX : sky->freedom[sky->row[surface] + cell];
}

double um_geometry_sky_free(const struct um_geometry_sky *sky, size_t surface, struct um_vec3 d)
{
  return um_geometry_sky_freedom(sky, surface, um_geometry_sky_cell(d)) / 255.0;
}
