/* The satellite in three dimensions on a page: its surfaces, where Sun, Earth and observer stand,
 * and of a run how warm and how bright it is. */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "model/products/picture.h"
#include "orbit/time.h"
#include "output/page_impl.h"
#include "output/page_scene.h"

#define INSTANTS 60      /* at most */
#define NUMBERS  1500000 /* of a quantity, at most: surfaces times instants */

struct scene {
  struct um_page_writer *w;
  const struct um_model *model;
  struct um_page_scene page;
  const struct um_environment_sample *sample; /* [ntime] */
  double *direction[5];
};
enum { OBSERVER, SUN, NADIR, VELOCITY, UP };

static void put(double *out, struct um_vec3 v)
{
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

static enum um_status directions(struct scene *s)
{
  bool orbits = true, seen = true;
  double *sunlit;
  UM_TRY(UM_PAGE_ROOM(s->w, s->page.ntime, &sunlit));
  for (int d = 0; d < 5; d++) UM_TRY(UM_PAGE_ROOM(s->w, 3 * s->page.ntime, &s->direction[d]));
  for (size_t i = 0; i < s->page.ntime; i++) {
    const struct um_environment_sample *now = &s->sample[i];
    orbits = orbits && um_vec3_norm(now->r) > 0.0 && um_vec3_norm(now->v) > 0.0;
    seen = seen && um_vec3_norm(now->to_observer) > 0.0;
    sunlit[i] = now->sunlit_fraction;
    put(s->direction[SUN] + 3 * i, um_quat_apply(now->q, now->sun));
    put(s->direction[OBSERVER] + 3 * i, um_quat_apply(now->q, now->to_observer));
    put(s->direction[UP] + 3 * i, um_quat_apply(now->q, um_vec3(0.0, 0.0, 1.0)));
    if (!orbits) continue;
    put(s->direction[NADIR] + 3 * i,
        um_quat_apply(now->q, um_vec3_scale(um_vec3_unit(now->r), -1.0)));
    put(s->direction[VELOCITY] + 3 * i, um_quat_apply(now->q, um_vec3_unit(now->v)));
  }
  s->page.sun = s->direction[SUN];
  s->page.sunlit = sunlit;
  if (seen) s->page.observer = s->direction[OBSERVER];
  if (seen) s->page.up = s->direction[UP];
  if (orbits) s->page.nadir = s->direction[NADIR];
  if (orbits) s->page.velocity = s->direction[VELOCITY];
  return UM_OK;
}

static enum um_status names(struct scene *s)
{
  const struct um_geometry *geometry = s->model->geometry;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(geometry);
  size_t npart = um_geometry_part_count(geometry), nmaterial = um_geometry_material_count(geometry);
  const char **name;
  uint32_t *index;
  UM_TRY(UM_PAGE_ROOM(s->w, npart + nmaterial, &name));
  UM_TRY(UM_PAGE_ROOM(s->w, 2 * mesh->nsurface, &index));
  for (size_t i = 0; i < npart; i++) name[i] = um_geometry_part_name(geometry, i);
  for (size_t i = 0; i < nmaterial; i++) name[npart + i] = um_geometry_material_name(geometry, i);
  for (size_t i = 0; i < mesh->nsurface; i++) {
    index[i] = mesh->surface[i].part;
    index[mesh->nsurface + i] = mesh->surface[i].material;
  }
  s->page.part_name = name;
  s->page.material_name = name + npart;
  s->page.npart = npart;
  s->page.nmaterial = nmaterial;
  s->page.part = index;
  s->page.material = index + mesh->nsurface;
  s->page.nsurface = mesh->nsurface;
  return UM_OK;
}

static enum um_status pose_at(struct scene *s, size_t i, double *angle,
                              struct um_geometry_pose **out)
{
  const struct um_geometry *geometry = s->model->geometry;
  const struct um_environment_sample *now = &s->sample[i];
  um_geometry_joint_angles(geometry, um_quat_apply(now->q, now->sun), now->t_tai, angle);
  return um_geometry_pose_create(s->w->context, geometry, angle, out);
}

/* Triangles of both sides, as they stand at the first instant; a back is wound the other way. */
static enum um_status mesh_of(struct scene *s, const struct um_geometry_pose *pose)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(s->model->geometry);
  double *vertex;
  uint32_t *corner, *of, *body;
  UM_TRY(UM_PAGE_ROOM(s->w, 3 * mesh->nvertex, &vertex));
  UM_TRY(UM_PAGE_ROOM(s->w, 5 * mesh->nsurface, &corner));
  of = corner + 3 * mesh->nsurface;
  body = of + mesh->nsurface;
  for (size_t i = 0; i < mesh->nvertex; i++) put(vertex + 3 * i, pose->vertex[i]);
  for (size_t i = 0; i < mesh->nsurface; i++) {
    const uint32_t *c = mesh->corner[mesh->surface[i].facet];
    bool back = mesh->surface[i].back;
    corner[3 * i] = c[0];
    corner[3 * i + 1] = c[back ? 2 : 1];
    corner[3 * i + 2] = c[back ? 1 : 2];
    of[i] = (uint32_t)i;
    body[i] = mesh->surface[i].part;
  }
  s->page.nvertex = mesh->nvertex;
  s->page.ntriangle = mesh->nsurface;
  s->page.vertex = vertex;
  s->page.triangle = corner;
  s->page.surface = of;
  s->page.body = body;
  return UM_OK;
}

/* A vertex of every part. */
static void first_vertices(const struct um_geometry_mesh *mesh, size_t *vertex)
{
  for (size_t f = mesh->nfacet; f-- > 0;) vertex[mesh->facet_part[f]] = mesh->corner[f][0];
}

/* How each part moves from where it stood at first: v(t) = R v(0) + c. Rotations of parts are
 * passive, body to part: R = conjugate(q(t)) q(0). */
static enum um_status motions(struct scene *s)
{
  enum um_status status;
  const struct um_geometry *geometry = s->model->geometry;
  size_t npart = um_geometry_part_count(geometry);
  struct um_context *context = s->w->context;
  struct um_geometry_pose *first = NULL, *now = NULL;
  struct um_page_body *bodies;
  double *angle, *pose;
  size_t *vertex;
  struct um_quat *q0, *q;
  UM_TRY(UM_PAGE_ROOM(s->w, um_geometry_joint_count(geometry), &angle));
  UM_TRY(UM_PAGE_ROOM(s->w, 7 * npart * s->page.ntime, &pose));
  UM_TRY(UM_PAGE_ROOM(s->w, npart, &vertex));
  UM_TRY(UM_PAGE_ROOM(s->w, 2 * npart, &q0));
  UM_TRY(UM_PAGE_ROOM(s->w, npart, &bodies));
  q = q0 + npart;
  first_vertices(um_geometry_mesh(geometry), vertex);
  UM_CHECK(pose_at(s, 0, angle, &first));
  um_geometry_part_rotations(geometry, angle, q0);
  UM_CHECK(mesh_of(s, first));
  if (!um_geometry_joint_moves(geometry)) {
    s->page.body = NULL;
    goto done;
  }
  for (size_t i = 0; i < s->page.ntime; i++) {
    um_geometry_pose_destroy(context, &now);
    UM_CHECK(pose_at(s, i, angle, &now));
    um_geometry_part_rotations(geometry, angle, q);
    for (size_t b = 0; b < npart; b++) {
      double *out = pose + 7 * (b * s->page.ntime + i);
      struct um_quat turn = um_quat_then(q[b], um_quat_conjugate(q0[b])); /* active: see below */
      struct um_vec3 from = first->vertex[vertex[b]], to = now->vertex[vertex[b]];
      struct um_vec3 turned = um_quat_apply(um_quat_conjugate(q[b]), um_quat_apply(q0[b], from));
      out[0] = turn.w;
      out[1] = turn.x;
      out[2] = turn.y;
      out[3] = turn.z;
      put(out + 4, um_vec3_axpy(to, -1.0, turned));
      bodies[b] =
          (struct um_page_body){um_geometry_part_name(geometry, b), pose + 7 * b * s->page.ntime};
    }
  }
  s->page.bodies = bodies;
  s->page.nbody = npart;
  status = UM_OK;
done:
  um_geometry_pose_destroy(context, &first);
  um_geometry_pose_destroy(context, &now);
  return status;
}

enum um_status um_output_page_put_scene(struct um_page_writer *w, const struct um_model *model,
                                        const struct um_output_scene *scene,
                                        const struct um_page_figure *figure)
{
  struct scene s = {.w = w, .model = model};
  s.page.ntime = scene->ntime;
  s.page.time = scene->time;
  s.sample = scene->sample;
  s.page.quantity = scene->quantity;
  s.page.nquantity = scene->nquantity;
  UM_TRY(names(&s));
  UM_TRY(directions(&s));
  UM_TRY(motions(&s));
  um_page_scene(w->page, figure, &s.page);
  return UM_OK;
}

/* ---- of a run ---- */

/* Even instants from the first to the last: observation[ntime]. */
static enum um_status choose(struct um_output_page *p, struct um_output_scene *scene,
                             size_t **observation)
{
  const struct um_model_result *r = p->run->result;
  const struct um_model_tables *tables = p->run->tables;
  size_t n = r->nobs < INSTANTS ? r->nobs : INSTANTS;
  double *time;
  struct um_environment_sample *sample;
  if (n > 1 && n * r->nsurface > NUMBERS) n = NUMBERS / r->nsurface > 1 ? NUMBERS / r->nsurface : 1;
  UM_TRY(UM_PAGE_ROOM(p->w, n, observation));
  UM_TRY(UM_PAGE_ROOM(p->w, n, &time));
  UM_TRY(UM_PAGE_ROOM(p->w, n, &sample));
  for (size_t i = 0; i < n; i++) {
    size_t k = n > 1 ? i * (r->nobs - 1) / (n - 1) : 0;
    (*observation)[i] = k;
    time[i] = um_orbit_time_unix(tables->t_obs[k]);
    sample[i] = tables->sample[k * tables->nsub + tables->nsub / 2];
  }
  *scene = (struct um_output_scene){.ntime = n, .time = time, .sample = sample};
  return UM_OK;
}

static enum um_status quantities(struct um_output_page *p, const size_t *observation,
                                 struct um_output_scene *scene)
{
  struct um_context *context = p->w->context;
  const struct um_output_run *run = p->run;
  const struct um_model_result *r = run->result;
  size_t n = r->nsurface, ntime = scene->ntime, nband = run->model->has_observer ? r->nband : 0;
  struct um_page_quantity *quantity;
  double *temperature, *radiance, *row;
  UM_TRY(UM_PAGE_ROOM(p->w, 1 + nband, &quantity));
  UM_TRY(UM_PAGE_ROOM(p->w, ntime * n, &temperature));
  UM_TRY(UM_PAGE_ROOM(p->w, nband * ntime * n, &radiance));
  UM_TRY(UM_PAGE_ROOM(p->w, nband * n, &row));
  um_core_progress_begin(context, "how bright surfaces are", ntime);
  enum um_status status = UM_OK;
  for (size_t i = 0; status == UM_OK && i < ntime; i++) {
    size_t k = observation[i];
    memcpy(temperature + i * n, r->surface_temperature + k * n, n * sizeof *temperature);
    if (nband > 0) status = um_model_surface_radiance(context, run->model, run->tables, r, k, row);
    for (size_t b = 0; b < nband; b++)
      memcpy(radiance + (b * ntime + i) * n, row + b * n, n * sizeof *row);
    if (status == UM_OK) status = um_core_progress_step(context, 1);
  }
  um_core_progress_end(context);
  quantity[0] = (struct um_page_quantity){
      .id = "temperature", .name = "temperature", .unit = "K", .value = temperature};
  for (size_t b = 0; b < nband; b++) {
    const struct um_optics_band *band = &run->model->band[b];
    quantity[1 + b] = (struct um_page_quantity){
        .id = band->name,
        .name = band->name,
        .unit = "W/m^2/sr",
        .scale = band->to < UM_INFRARED_FROM ? UM_PAGE_LOG : UM_PAGE_LINEAR,
        .value = radiance + b * ntime * n};
  }
  scene->quantity = quantity;
  scene->nquantity = 1 + nband;
  return status;
}

enum um_status um_output_page_scene(struct um_output_page *p)
{
  static const struct um_page_figure figure = {
      .id = "satellite",
      .title = "The satellite",
      .text = "Radiance is what a surface sends toward the observer; what the observer does not "
              "see has none."};
  struct um_output_scene scene;
  size_t *observation;
  UM_TRY(choose(p, &scene, &observation));
  UM_TRY(quantities(p, observation, &scene));
  um_page_section(p->page, "satellite", "How does it look, and how warm is each surface?",
                  UM_PAGE_PLAIN);
  um_page_writer_picture(p->w, "satellite.svg");
  return um_output_page_put_scene(p->w, p->run->model, &scene, &figure);
}
