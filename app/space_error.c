/* Error in space of a run, by one refinement: the same scenario with facets and tetrahedra of half
 * the size, and how far its temperatures and its thermal light lie off. At order 2 what the run
 * itself is off by is 4/3 of that, what the refined one is off by a third. */
#include "app/space_error.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/core/constants.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"

#define SETS_PER_PART 3

/* Longest edge of a part's facets [m]. */
static double longest_edge(const struct um_geometry_mesh *mesh, const struct um_vec3 *vertex,
                           size_t part)
{
  double longest = 0.0;
  for (size_t f = 0; f < mesh->nfacet; f++)
    for (int c = 0; c < 3 && mesh->facet_part[f] == part; c++)
      longest = fmax(longest, um_vec3_norm(um_vec3_sub(vertex[mesh->corner[f][(c + 1) % 3]],
                                                       vertex[mesh->corner[f][c]])));
  return longest;
}

static enum um_status halve_one(struct um_context *context, const char *part, const char *size,
                                double half, struct um_document_change *set, size_t *nset)
{
  char *key = NULL;
  UM_TRY(um_core_asprintf(context, &key, "parts.%s.%s", part, size));
  set[(*nset)++] = (struct um_document_change){.key = key, .number = half};
  return UM_OK;
}

/* Keys that halve the sizes of every part; of facets only where none is cut beyond its size.
 * set[SETS_PER_PART * npart]; the caller frees the keys.
 */
static enum um_status halve(struct um_context *context, const struct um_model *model,
                            struct um_document_change *set, size_t *nset)
{
  enum um_status status = UM_OK;
  struct um_geometry_pose *pose = NULL;
  const struct um_scenario_part *part = model->scenario->parts.items;
  double *angles = NULL;
  size_t njoint = um_geometry_joint_count(model->geometry);
  UM_CHECK(um_core_allocate(context, njoint, sizeof *angles, &angles));
  UM_CHECK(um_geometry_pose_create(context, model->geometry, angles, &pose));
  for (size_t p = 0; p < model->scenario->parts.count; p++) {
    double edge = longest_edge(um_geometry_mesh(model->geometry), pose->vertex, p);
    if (model->halvings == NULL)
      UM_CHECK(halve_one(context, part[p].name, "facet_size_m", 0.5 * edge * (1.0 + 1e-9), set,
                         nset)); /* a half is not cut once more */
    if (part[p].solid != NULL && part[p].solid->tetrahedron_size_m > 0.0)
      UM_CHECK(halve_one(context, part[p].name, "solid.tetrahedron_size_m",
                         0.5 * part[p].solid->tetrahedron_size_m, set, nset));
    if (part[p].interior != NULL && part[p].interior->tetrahedron_size_m > 0.0)
      UM_CHECK(halve_one(context, part[p].name, "interior.tetrahedron_size_m",
                         0.5 * part[p].interior->tetrahedron_size_m, set, nset));
  }
done:
  um_core_free(context, angles);
  um_geometry_pose_destroy(context, &pose);
  return status;
}

/* The scenario's halvings, and one more round of all facets. out: [parts], freed by rounds_free,
 * after a failure too. */
static enum um_status one_more(struct um_context *context, const struct um_model *model,
                               struct um_geometry_halvings *out)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  for (size_t p = 0; p < model->scenario->parts.count; p++) {
    const struct um_geometry_halvings *from = &model->halvings[p];
    struct um_geometry_halving *round = NULL;
    uint32_t *facet = NULL;
    size_t n = 0;
    for (size_t f = 0; f < mesh->nfacet; f++) n += mesh->facet_part[f] == p ? 1 : 0;
    UM_TRY(um_core_allocate(context, from->nround + 1, sizeof *round, &round));
    out[p] = (struct um_geometry_halvings){round, from->nround};
    for (size_t i = 0; i < from->nround; i++) round[i] = from->round[i];
    UM_TRY(um_core_allocate(context, n, sizeof *facet, &facet));
    for (uint32_t f = 0; f < n; f++) facet[f] = f;
    round[out[p].nround++] = (struct um_geometry_halving){n, facet, n};
  }
  return UM_OK;
}

static void rounds_free(struct um_context *context, const struct um_model *model,
                        struct um_geometry_halvings *rounds)
{
  for (size_t p = 0; rounds != NULL && p < model->scenario->parts.count; p++) {
    size_t own = model->halvings[p].nround;
    if (rounds[p].nround > own)
      um_core_free(context, (void *)(uintptr_t)rounds[p].round[own].facet);
    um_core_free(context, (void *)(uintptr_t)rounds[p].round);
  }
  um_core_free(context, rounds);
}

/* Largest and mean change over the run of the mean temperature of places that both have [K]. */
static void of_temperatures(const struct um_model_result *a, const struct um_model_result *b,
                            struct um_app_space_error *out)
{
  double sum = 0.0, n = 0.0;
  for (size_t p = 0; p < a->nplace && p < b->nplace; p++) {
    if (strcmp(a->place[p].name, b->place[p].name) != 0) continue;
    for (size_t k = 0; k < a->nobs && k < b->nobs; k++) {
      double change = fabs(b->place[p].mean[k] - a->place[p].mean[k]);
      sum += change;
      n += 1.0;
      if (change <= out->temperature) continue;
      out->temperature = change;
      out->place = a->place[p].name;
    }
  }
  out->temperature_mean = n > 0.0 ? sum / n : 0.0;
}

/* The same of the intensity in the warmest band, of itself [1]. */
static void of_light(const struct um_model *model, const struct um_model_result *a,
                     const struct um_model_result *b, struct um_app_space_error *out)
{
  size_t band = a->nband;
  for (size_t i = 0; i < a->nband; i++)
    if (model->band[i].from >= UM_INFRARED_FROM) band = i;
  if (a->nmaterial == 0 || band == a->nband) return;
  out->band = model->band[band].name;
  for (size_t k = 0; k < a->nobs && k < b->nobs; k++) {
    double was = um_model_result_intensity(a, k, band, -1);
    double change = was > 0.0 ? fabs(um_model_result_intensity(b, k, band, -1) / was - 1.0) : 0.0;
    out->light_mean += change / (double)a->nobs;
    out->light = fmax(out->light, change);
  }
}

enum um_status um_app_space_error(struct um_context *context, const struct um_model *model,
                                  const struct um_model_result *result,
                                  struct um_app_space_error *out)
{
  enum um_status status;
  size_t room = SETS_PER_PART * model->scenario->parts.count, nset = 0;
  struct um_document_change *set = NULL;
  struct um_model *finer = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_result *other = NULL;
  struct um_geometry_halvings *rounds = NULL;
  *out = (struct um_app_space_error){.place = "none"};
  UM_CHECK(um_core_allocate(context, room, sizeof *set, &set));
  UM_CHECK(halve(context, model, set, &nset));
  if (model->halvings != NULL) {
    UM_CHECK(um_core_allocate(context, model->scenario->parts.count, sizeof *rounds, &rounds));
    UM_CHECK(one_more(context, model, rounds));
  }
  const struct um_model_changes changes = {.key = set, .nkey = nset, .halvings = rounds};
  UM_CHECK(um_model_variant_create(context, model, &changes, &finer));
  UM_CHECK(um_model_precompute(context, finer, &tables));
  UM_CHECK(um_model_run(context, finer, tables, &other));
  out->nsurface = other->nsurface;
  of_temperatures(result, other, out);
  of_light(model, result, other, out);
done:
  rounds_free(context, model, rounds);
  um_model_result_destroy(context, &other);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &finer);
  for (size_t i = 0; i < nset; i++) um_core_free(context, (void *)(uintptr_t)set[i].key);
  um_core_free(context, set);
  return status;
}
