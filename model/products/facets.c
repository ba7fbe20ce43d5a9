#include "model/products/facets.h"

#include <math.h>
#include <stdlib.h>

#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/mesh_error.h"

#define FACETS_MAX 40000
#define SHARE      0.6 /* of a group's error that is cut in a round [1] */
#define TOLERANCE  4.0 /* of integration in time, over that of a run [1] */

/* Error of a facet on one side, by area. */
struct piece {
  uint32_t facet;
  double error; /* [K m^2] */
};

static int larger_first(const void *a, const void *b)
{
  const struct piece *x = a, *y = b;
  if (x->error != y->error) return x->error > y->error ? -1 : 1;
  return x->facet < y->facet ? -1 : x->facet > y->facet;
}

/* Mark what holds most of the error of a group's side. */
static void mark(const struct um_geometry_mesh *mesh, const double *error, uint32_t group,
                 bool back, struct piece *piece, bool *marked)
{
  double sum = 0.0, taken = 0.0;
  size_t n = 0;
  for (size_t s = 0; s < mesh->nsurface; s++) {
    const struct um_geometry_surface *at = &mesh->surface[s];
    if (at->group != group || (at->back != 0) != back) continue;
    piece[n] = (struct piece){at->facet, error[s] * mesh->area[at->facet]};
    sum += piece[n++].error;
  }
  qsort(piece, n, sizeof *piece, larger_first);
  for (size_t i = 0; i < n && taken < SHARE * sum; i++) {
    taken += piece[i].error;
    marked[piece[i].facet] = true;
  }
}

/* One more round of every part that has facets marked. */
static enum um_status halve(struct um_context *context, const struct um_geometry_mesh *mesh,
                            const bool *marked, struct um_model_facets *out)
{
  for (size_t f = 0, end; f < mesh->nfacet; f = end) {
    uint32_t part = mesh->facet_part[f], *number = NULL;
    size_t n = 0;
    for (end = f; end < mesh->nfacet && mesh->facet_part[end] == part; end++)
      if (marked[end]) n++;
    if (n == 0) continue;
    struct um_geometry_halvings *to = &out->part[part];
    struct um_geometry_halving *round =
        (struct um_geometry_halving *)(uintptr_t)to->round; /* made here */
    UM_TRY(um_core_reallocate(context, to->nround + 1, sizeof *round, &round));
    to->round = round;
    UM_TRY(um_core_allocate(context, n, sizeof *number, &number));
    round[to->nround++] = (struct um_geometry_halving){end - f, number, n};
    for (size_t i = f; i < end; i++)
      if (marked[i]) *number++ = (uint32_t)(i - f);
  }
  return UM_OK;
}

/* One satellite: its heat, its errors, what is halved next. */
static enum um_status round_run(struct um_context *context, const struct um_model *model,
                                struct um_model_facets *out)
{
  enum um_status status;
  struct um_model *finer = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_thermal_solution *heat = NULL;
  struct um_model_result dark = {0};
  bool *marked = NULL;
  struct piece *piece = NULL;
  const struct um_model_changes changes = {.halvings = out->part};
  double limit = model->scenario->thermal->facet_error_K;
  struct um_model_facets_round *round = &out->round[out->nround++];
  UM_CHECK(um_model_variant_create(context, model, &changes, &finer));
  const struct um_geometry_mesh *mesh = um_geometry_mesh(finer->geometry);
  UM_CHECK(um_model_precompute(context, finer, &tables));
  UM_CHECK(um_model_thermal_solution_create(context, finer, tables, NULL, TOLERANCE, &heat));
  UM_CHECK(um_model_mesh_error(context, finer, tables, heat, &dark, &dark.mesh));
  UM_CHECK(um_core_allocate(context, mesh->nfacet, sizeof *marked, &marked));
  UM_CHECK(um_core_allocate(context, mesh->nfacet, sizeof *piece, &piece));
  *round = (struct um_model_facets_round){.nfacet = mesh->nfacet};
  for (uint32_t g = 0; g < 2 * um_geometry_group_count(finer->geometry); g++) {
    double off = fabs(dark.mesh.side[g]);
    if (off > limit) mark(mesh, dark.mesh.surface, g / 2, g % 2 != 0, piece, marked);
    if (off <= round->error) continue;
    round->error = off;
    round->group = g / 2;
    round->back = g % 2 != 0;
  }
  out->reached = round->error <= limit;
  if (!out->reached && out->nround <= UM_MODEL_FACETS_ROUNDS && mesh->nfacet <= FACETS_MAX)
    UM_CHECK(halve(context, mesh, marked, out));
done:
  UM_FREE(context, marked, piece, dark.mesh.surface, dark.mesh.side, dark.mesh.light,
          dark.mesh.light_mean);
  um_model_thermal_solution_destroy(context, &heat);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &finer);
  return status;
}

enum um_status um_model_facets_adapt(struct um_context *context, const struct um_model *model,
                                     struct um_model_facets **out)
{
  enum um_status status;
  struct um_model_facets *facets = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *facets, &facets));
  facets->npart = model->scenario->parts.count;
  UM_CHECK(um_core_allocate(context, facets->npart, sizeof *facets->part, &facets->part));
  do {
    UM_CHECK(um_core_stop_check(context, "facets were fitted to temperatures"));
    UM_CHECK(round_run(context, model, facets));
  } while (!facets->reached && facets->nround <= UM_MODEL_FACETS_ROUNDS &&
           facets->round[facets->nround - 1].nfacet <= FACETS_MAX);
done:
  if (status != UM_OK) um_model_facets_destroy(context, &facets);
  *out = facets;
  return status;
}

void um_model_facets_destroy(struct um_context *context, struct um_model_facets **facets)
{
  struct um_model_facets *f = *facets;
  if (f == NULL) return;
  for (size_t p = 0; f->part != NULL && p < f->npart; p++) {
    const struct um_geometry_halvings *part = &f->part[p];
    for (size_t i = 0; i < part->nround; i++)
      um_core_free(context, (void *)(uintptr_t)part->round[i].facet);
    um_core_free(context, (void *)(uintptr_t)part->round);
  }
  UM_FREE(context, f->part, f);
  *facets = NULL;
}
