/* From the descriptions of parts to one mesh: build each part in its own frame, join, number the
 * surfaces (by part, facet, side). */
#include <string.h>

#include "geometry/geometry_impl.h"
#include "geometry/patch_impl.h"
#include "geometry/report_impl.h"
#include "geometry/skin_impl.h"

#define NO_PART ((size_t)-1)

static enum um_status check_positive(struct um_context *context,
                                     const struct um_geometry_part_spec *spec, const char *what,
                                     double value)
{
  if (value > 0.0 && value <= UM_GEOMETRY_MAX_LENGTH) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "part '%s': %s is %g m; a value above 0 and up to %g is accepted", spec->name,
                      what, value, UM_GEOMETRY_MAX_LENGTH);
}

static enum um_status check_sizes(struct um_context *context,
                                  const struct um_geometry_part_spec *spec)
{
  static const char *const size_name[] = {"size x", "size y", "size z"};
  int nsize = spec->shape == UM_SHAPE_BOX ? 3 : spec->shape == UM_SHAPE_PLATE ? 2 : 0;
  for (int k = 0; k < nsize; k++)
    UM_TRY(check_positive(context, spec, size_name[k], spec->size[k]));
  if (nsize == 0 && spec->shape != UM_SHAPE_MESH)
    UM_TRY(check_positive(context, spec, "radius", spec->radius));
  if (spec->shape == UM_SHAPE_CYLINDER || spec->shape == UM_SHAPE_CONE)
    UM_TRY(check_positive(context, spec, "height", spec->height));
  if (spec->shape == UM_SHAPE_CONE &&
      !(spec->radius_top >= 0.0 && spec->radius_top <= UM_GEOMETRY_MAX_LENGTH))
    return um_core_fail(context, UM_ERR_INPUT,
                        "part '%s': top radius is %g m; a value from 0 to %g is accepted",
                        spec->name, spec->radius_top, UM_GEOMETRY_MAX_LENGTH);
  if (spec->shape == UM_SHAPE_PARABOLOID)
    UM_TRY(check_positive(context, spec, "focal length", spec->focal_length));
  if (spec->shape == UM_SHAPE_MESH && spec->mesh_path == NULL)
    return um_core_fail(context, UM_ERR_INPUT, "part '%s': a mesh needs a file", spec->name);
  if (spec->shape == UM_SHAPE_MESH && spec->mesh_scale != 0.0)
    UM_TRY(check_positive(context, spec, "mesh scale (m per file unit)", spec->mesh_scale));
  if (!(isfinite(spec->facet_size) && spec->facet_size >= 0.0))
    return um_core_fail(context, UM_ERR_INPUT,
                        "part '%s': facet size is %g m; a finite value of at least 0 is accepted",
                        spec->name, spec->facet_size);
  return UM_OK;
}

/* False also for NaN. */
static bool within_reach(struct um_vec3 v)
{
  return fabs(v.x) <= UM_GEOMETRY_MAX_LENGTH && fabs(v.y) <= UM_GEOMETRY_MAX_LENGTH &&
         fabs(v.z) <= UM_GEOMETRY_MAX_LENGTH;
}

static enum um_status copy_schedule(struct um_context *context,
                                    const struct um_geometry_part_spec *spec,
                                    struct um_geometry_part *part)
{
  const struct um_geometry_schedule *from = &spec->schedule;
  size_t n = from->nrow;
  double *t, *angle;
  if (n == 0)
    return um_core_fail(context, UM_ERR_INPUT, "part '%s': the schedule of its joint is empty",
                        spec->name);
  UM_TRY(um_core_allocate(context, n, sizeof *t, &t));
  part->schedule.t = t;
  UM_TRY(um_core_allocate(context, n, sizeof *angle, &angle));
  part->schedule.angle = angle;
  part->schedule.nrow = n;
  for (size_t i = 0; i < n; i++) {
    t[i] = from->t[i];
    angle[i] = from->angle[i];
    if (!(isfinite(t[i]) && isfinite(angle[i]) && t[i] >= t[i > 0 ? i - 1 : 0]))
      return um_core_fail(context, UM_ERR_INPUT,
                          "part '%s': row %zu of the schedule of its joint, %g s and %g rad; "
                          "accepted: finite, ascending times",
                          spec->name, i + 1, t[i], angle[i]);
  }
  return UM_OK;
}

/* Pose and joint of a spec into the part, unit vectors made unit. */
static enum um_status copy_pose(struct um_context *context,
                                const struct um_geometry_part_spec *spec,
                                struct um_geometry_part *part)
{
  struct um_quat q = spec->rotation;
  double norm = sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (!within_reach(spec->position))
    return um_core_fail(context, UM_ERR_INPUT,
                        "part '%s': its position (%g, %g, %g) m is not finite or beyond %g m",
                        spec->name, spec->position.x, spec->position.y, spec->position.z,
                        UM_GEOMETRY_MAX_LENGTH);
  if (norm == 0.0)
    q = (struct um_quat){1, 0, 0, 0}; /* not given */
  else if (!(fabs(norm - 1.0) <= 1e-6))
    return um_core_fail(
        context, UM_ERR_INPUT,
        "part '%s': the norm of its rotation is %.9g; a unit quaternion is accepted", spec->name,
        norm);
  part->position = spec->position;
  part->rotation = um_quat_normalize(q);
  double grain = um_vec3_norm(spec->grain);
  if (!isfinite(grain))
    return um_core_fail(context, UM_ERR_INPUT, "part '%s': its grain is not finite", spec->name);
  part->grain = grain > 0.0 ? um_vec3_scale(spec->grain, 1.0 / grain) : um_vec3(1.0, 0.0, 0.0);
  part->joint_kind = spec->joint;
  part->joint = NO_PART;
  if (spec->joint == UM_JOINT_NONE) return UM_OK;
  double axis = um_vec3_norm(spec->joint_axis), normal = um_vec3_norm(spec->joint_normal);
  if (!(fabs(axis - 1.0) <= 1e-6))
    return um_core_fail(context, UM_ERR_INPUT,
                        "part '%s': the length of its joint axis is %g; a unit vector is accepted",
                        spec->name, axis);
  if (!isfinite(spec->joint_angle))
    return um_core_fail(context, UM_ERR_INPUT, "part '%s': its joint angle is not finite",
                        spec->name);
  part->joint_axis = um_vec3_unit(spec->joint_axis);
  part->joint_angle = spec->joint_angle;
  if (spec->joint == UM_JOINT_SCHEDULE) UM_TRY(copy_schedule(context, spec, part));
  if (spec->joint != UM_JOINT_SUN) return UM_OK;
  if (!(fabs(normal - 1.0) <= 1e-6))
    return um_core_fail(
        context, UM_ERR_INPUT,
        "part '%s': the length of its Sun-tracking normal is %g; a unit vector is accepted",
        spec->name, normal);
  part->joint_normal = um_vec3_unit(spec->joint_normal);
  if (!(um_vec3_norm(um_vec3_cross(part->joint_normal, part->joint_axis)) > 1e-6))
    return um_core_fail(context, UM_ERR_INPUT,
                        "part '%s': its Sun-tracking normal lies along the joint axis, so turning "
                        "cannot point it at the Sun",
                        spec->name);
  return UM_OK;
}

static enum um_status check_names(struct um_context *context,
                                  const struct um_geometry_part_spec *specs, size_t npart)
{
  if (npart == 0) return um_core_fail(context, UM_ERR_INPUT, "the satellite has no parts");
  for (size_t i = 0; i < npart; i++) {
    if (specs[i].name == NULL || specs[i].name[0] == '\0')
      return um_core_fail(context, UM_ERR_INPUT, "part %zu has no name", i + 1);
    for (size_t j = 0; j < i; j++)
      if (strcmp(specs[i].name, specs[j].name) == 0)
        return um_core_fail(context, UM_ERR_INPUT, "two parts are called '%s'", specs[i].name);
  }
  return UM_OK;
}

/* depth[i]: how many parts carry part i, one after the other. Each chain is walked up to the first
 * part whose depth is known. depth comes in as NO_PART. */
static enum um_status find_depths(const struct um_geometry *geometry,
                                  const struct um_geometry_part_spec *specs, size_t *depth)
{
  size_t n = geometry->npart;
  for (size_t i = 0; i < n; i++) {
    size_t steps = 0, at = i;
    for (; at != NO_PART && depth[at] == NO_PART && steps <= n; steps++)
      at = geometry->part[at].parent;
    if (steps > n)
      return um_core_fail(geometry->context, UM_ERR_INPUT, "part '%s': its parents form a circle",
                          specs[i].name);
    size_t base = at == NO_PART ? 0 : depth[at] + 1;
    for (at = i; steps > 0; at = geometry->part[at].parent) depth[at] = base + --steps;
  }
  return UM_OK;
}

/* Parents by name and an order in which parents come first: depth by depth. */
static enum um_status find_parents(struct um_geometry *geometry,
                                   const struct um_geometry_part_spec *specs)
{
  enum um_status status;
  size_t n = geometry->npart, placed = 0, *depth = NULL;
  for (size_t i = 0; i < n; i++) {
    size_t parent = NO_PART;
    if (specs[i].parent != NULL) {
      parent = um_geometry_part_find(geometry, specs[i].parent);
      if (parent == NO_PART)
        return um_core_fail(geometry->context, UM_ERR_INPUT,
                            "part '%s': its parent '%s' is not a part", specs[i].name,
                            specs[i].parent);
    }
    geometry->part[i].parent = parent;
  }
  UM_CHECK(um_core_allocate(geometry->context, n, sizeof *depth, (void *)&depth));
  for (size_t i = 0; i < n; i++) depth[i] = NO_PART;
  UM_CHECK(find_depths(geometry, specs, depth));
  for (size_t level = 0; placed < n; level++)
    for (size_t i = 0; i < n; i++)
      if (depth[i] == level) geometry->order[placed++] = i;
done:
  um_core_free(geometry->context, depth);
  return status;
}

/* Mesh of one part in its own frame: built, welded, checked, refined. */
static enum um_status build_patch(const struct um_geometry_part_spec *spec,
                                  struct um_geometry_patch *patch)
{
  if (spec->shape == UM_SHAPE_MESH) {
    patch->source = spec->mesh_path;
    const struct um_geometry_obj_wish wish = {.scale =
                                                  spec->mesh_scale == 0.0 ? 1.0 : spec->mesh_scale,
                                              .groups = spec->mesh_groups,
                                              .ngroup = spec->nmesh_group};
    UM_TRY(um_geometry_obj_read(patch, spec->mesh_path, &wish));
  } else {
    UM_TRY(um_geometry_primitive_build(spec, patch));
  }
  UM_TRY(um_geometry_patch_weld(patch));
  UM_TRY(um_geometry_patch_check(patch));
  UM_TRY(um_geometry_refine(patch, spec->name, spec->facet_size));
  for (size_t i = 0; i < spec->halvings.nround; i++)
    UM_TRY(um_geometry_halve(patch, spec->name, &spec->halvings.round[i]));
  return UM_OK;
}

static enum um_status check_solid(struct um_context *context,
                                  const struct um_geometry_part_spec *spec,
                                  const struct um_geometry_report *report)
{
  if (spec->solid && !report->closed)
    return um_core_fail(context, UM_ERR_INPUT,
                        "part '%s' is declared solid but its mesh is not closed: %zu open edges, "
                        "%zu edges of more than two facets%s",
                        spec->name, report->nboundary_edge, report->nonmanifold_edge,
                        report->nboundary_edge + report->nonmanifold_edge == 0
                            ? ", but facets turned against each other"
                            : "");
  if (!report->closed || report->volume > 0.0) return UM_OK;
  if (spec->solid)
    return um_core_fail(context, UM_ERR_INPUT,
                        "part '%s' is declared solid but encloses %g m3: its facets must be "
                        "counter-clockwise seen from outside",
                        spec->name, report->volume);
  um_core_log(context, UM_LOG_WARNING,
              "part '%s': a closed mesh of volume %g m3: its fronts look inward", spec->name,
              report->volume);
  return UM_OK;
}

/* Append the facets of a patch to the mesh. */
static enum um_status append(struct um_geometry *geometry, uint32_t part,
                             const struct um_geometry_patch *patch)
{
  struct um_context *context = geometry->context;
  struct um_geometry_mesh *mesh = &geometry->mesh;
  struct um_geometry_part *p = &geometry->part[part];
  size_t nv = mesh->nvertex + patch->nvertex, nf = mesh->nfacet + patch->nfacet;
  if (nf > UM_GEOMETRY_MAX_FACETS)
    return um_core_fail(
        context, UM_ERR_INPUT,
        "part '%s': %zu facets, with those of the parts before it %zu; accepted: at "
        "most %zu of the whole satellite",
        p->name, patch->nfacet, nf, UM_GEOMETRY_MAX_FACETS);
  UM_TRY(um_core_reallocate(context, nv, sizeof *geometry->vertex, (void *)&geometry->vertex));
  UM_TRY(um_core_reallocate(context, nf, sizeof *geometry->normal, (void *)&geometry->normal));
  UM_TRY(um_core_reallocate(context, nf, sizeof *mesh->corner, (void *)&mesh->corner));
  UM_TRY(um_core_reallocate(context, nf, sizeof *mesh->facet_part, (void *)&mesh->facet_part));
  UM_TRY(um_core_reallocate(context, nf, sizeof *mesh->facet_group, (void *)&mesh->facet_group));
  UM_TRY(um_core_reallocate(context, nf, sizeof *mesh->area, (void *)&mesh->area));
  memcpy(geometry->vertex + mesh->nvertex, patch->vertex, patch->nvertex * sizeof *patch->vertex);
  uint32_t first_group = (uint32_t)(geometry->ngroup - patch->ngroup);
  for (size_t i = 0; i < patch->nfacet; i++) {
    size_t f = mesh->nfacet + i;
    struct um_vec3 cross = um_geometry_cross_of(patch->vertex, patch->corner[i]);
    double norm = um_vec3_norm(cross);
    for (int k = 0; k < 3; k++) mesh->corner[f][k] = patch->corner[i][k] + (uint32_t)mesh->nvertex;
    mesh->facet_part[f] = part;
    mesh->facet_group[f] = first_group + patch->group[i];
    mesh->area[f] = 0.5 * norm;
    geometry->normal[f] = um_vec3_scale(cross, 1.0 / norm);
  }
  p->vertex_begin = mesh->nvertex;
  p->facet_begin = mesh->nfacet;
  p->vertex_end = mesh->nvertex = nv;
  p->facet_end = mesh->nfacet = nf;
  return UM_OK;
}

static enum um_status add_part(struct um_geometry *geometry,
                               const struct um_geometry_part_spec *spec, uint32_t part)
{
  enum um_status status;
  struct um_context *context = geometry->context;
  struct um_geometry_part *p = &geometry->part[part];
  struct um_geometry_patch patch;
  struct um_geometry_edges edges = {NULL, 0, NULL};
  uint8_t *closed = NULL;
  um_geometry_patch_begin(&patch, context, spec->name);
  UM_CHECK(check_sizes(context, spec));
  UM_CHECK(copy_pose(context, spec, p));
  if (p->joint_kind != UM_JOINT_NONE) p->joint = geometry->njoint++;
  UM_CHECK(build_patch(spec, &patch));
  const uint32_t(*corner)[3] = (const uint32_t(*)[3])patch.corner;
  UM_CHECK(um_geometry_edges_create(context, corner, patch.nfacet, &edges));
  p->report = um_geometry_report_compute(&patch, &edges);
  p->report.part = p->name;
  UM_CHECK(check_solid(context, spec, &p->report));
  UM_CHECK(um_core_allocate(context, patch.nfacet, 1, (void *)&closed));
  UM_CHECK(um_geometry_edges_closed(context, corner, patch.nfacet, patch.nvertex, &edges, closed));
  UM_CHECK(um_geometry_skin_apply(geometry, spec, part, &patch, closed));
  UM_CHECK(append(geometry, part, &patch));
done:
  um_core_free(context, closed);
  um_geometry_edges_destroy(context, &edges);
  um_geometry_patch_end(&patch);
  return status;
}

static enum um_status number_surfaces(struct um_geometry *geometry)
{
  struct um_context *context = geometry->context;
  struct um_geometry_mesh *mesh = &geometry->mesh;
  size_t n = mesh->nfacet;
  UM_TRY(um_core_allocate(context, n, sizeof(uint32_t), (void *)&mesh->surface_of_front));
  UM_TRY(um_core_allocate(context, n, sizeof(uint32_t), (void *)&mesh->surface_of_back));
  UM_TRY(um_core_allocate(context, 2 * n, sizeof *mesh->surface, (void *)&mesh->surface));
  for (uint32_t f = 0; f < n; f++) {
    const struct um_geometry_group *group = &geometry->group[mesh->facet_group[f]];
    const uint32_t material[2] = {group->front_material, group->back_material};
    uint32_t *of[2] = {&mesh->surface_of_front[f], &mesh->surface_of_back[f]};
    for (uint8_t side = 0; side < 2; side++) {
      *of[side] = UM_GEOMETRY_NONE;
      if (material[side] == UM_GEOMETRY_NONE) continue;
      *of[side] = (uint32_t)mesh->nsurface;
      mesh->surface[mesh->nsurface++] = (struct um_geometry_surface){
          f, mesh->facet_part[f], mesh->facet_group[f], material[side], side};
    }
  }
  return UM_OK;
}

enum um_status um_geometry_create(struct um_context *context,
                                  const struct um_geometry_part_spec *parts, size_t npart,
                                  struct um_geometry **out)
{
  enum um_status status;
  struct um_geometry *geometry = NULL;
  *out = NULL;
  UM_CHECK(check_names(context, parts, npart));
  UM_CHECK(um_core_allocate(context, 1, sizeof *geometry, (void *)&geometry));
  geometry->context = context;
  UM_CHECK(um_core_allocate(context, npart, sizeof *geometry->part, (void *)&geometry->part));
  UM_CHECK(um_core_allocate(context, npart, sizeof *geometry->order, (void *)&geometry->order));
  geometry->npart = npart;
  for (size_t i = 0; i < npart; i++)
    UM_CHECK(um_core_strdup(context, parts[i].name, &geometry->part[i].name));
  UM_CHECK(find_parents(geometry, parts));
  for (uint32_t i = 0; i < npart; i++) {
    UM_CHECK(um_core_stop_check(context, "parts were built"));
    UM_CHECK(add_part(geometry, &parts[i], i));
  }
  UM_CHECK(number_surfaces(geometry));
  *out = geometry;
  geometry = NULL;
done:
  um_geometry_destroy(&geometry);
  return status;
}
