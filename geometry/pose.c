/* Joints and positions. Frames are passive: part p is placed in its parent at `position`, turned by
 * `rotation` (parent to part), and a joint turns the part's contents by +angle about its axis,
 * which is the frame change um_quat_from_axis(axis, angle) after `rotation`. Children hang on the
 * turned frame. */
#include "geometry/geometry_impl.h"

#define NO_PART ((size_t)-1)

/* A Sun closer to the axis than this has no preferred angle [1]. */
#define ALONG_AXIS 1e-9
/* Sine of the angle to the normal below which a grain gives no direction in the surface [1]. */
#define UPRIGHT 1e-6

/* Where a part is: origin in body frame [m] and body-to-part rotation. */
struct frame {
  struct um_vec3 origin;
  struct um_quat q;
};

static const struct frame body_frame = {{0, 0, 0}, {1, 0, 0, 0}};

/* Frame of a part in its parent's, before its own joint turns it. */
static struct frame unturned_frame(const struct um_geometry_part *part, struct frame parent)
{
  struct um_vec3 offset = um_quat_apply(um_quat_conjugate(parent.q), part->position);
  return (struct frame){um_vec3_add(parent.origin, offset), um_quat_then(parent.q, part->rotation)};
}

static struct frame turned_frame(const struct um_geometry_part *part, struct frame frame,
                                 double angle)
{
  frame.q = um_quat_normalize(um_quat_then(frame.q, um_quat_from_axis(part->joint_axis, angle)));
  return frame;
}

/* Angle that brings n nearest to s when turned about the axis a:
 * tan(angle) = a . (n x s) / (n . s - (a . n)(a . s)). */
static double sun_angle(struct um_vec3 a, struct um_vec3 n, struct um_vec3 s)
{
  if (!(um_vec3_norm(um_vec3_cross(a, s)) > ALONG_AXIS)) return 0.0;
  double sine = um_vec3_dot(a, um_vec3_cross(n, s));
  double cosine = um_vec3_dot(n, s) - um_vec3_dot(a, n) * um_vec3_dot(a, s);
  return atan2(sine, cosine);
}

/* Frame before the part's own joint turns, found by walking up; angles of its parents are known. */
static struct frame frame_of(const struct um_geometry *geometry, size_t part, const double *angles)
{
  const struct um_geometry_part *p = &geometry->part[part];
  struct frame parent = body_frame;
  if (p->parent != NO_PART) {
    parent = frame_of(geometry, p->parent, angles);
    const struct um_geometry_part *up = &geometry->part[p->parent];
    if (up->joint != NO_PART) parent = turned_frame(up, parent, angles[up->joint]);
  }
  return unturned_frame(p, parent);
}

size_t um_geometry_joint_count(const struct um_geometry *geometry) { return geometry->njoint; }

bool um_geometry_joint_moves(const struct um_geometry *geometry)
{
  for (size_t i = 0; i < geometry->npart; i++)
    if (geometry->part[i].joint_kind == UM_JOINT_SUN ||
        geometry->part[i].joint_kind == UM_JOINT_SCHEDULE)
      return true;
  return false;
}

/* Of a jump the later row, held outside. */
static double scheduled(const struct um_geometry_schedule *s, double t)
{
  size_t low = 0, high = s->nrow; /* rows before `low` are at t or earlier, from `high` on later */
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (s->t[middle] <= t)
      low = middle + 1;
    else
      high = middle;
  }
  if (low == 0) return s->angle[0];
  if (low == s->nrow) return s->angle[s->nrow - 1];
  double w = (t - s->t[low - 1]) / (s->t[low] - s->t[low - 1]);
  return s->angle[low - 1] + w * (s->angle[low] - s->angle[low - 1]);
}

void um_geometry_joint_angles(const struct um_geometry *geometry, struct um_vec3 sun_body,
                              double t_tai, double *angles)
{
  for (size_t i = 0; i < geometry->npart; i++) {
    size_t k = geometry->order[i];
    const struct um_geometry_part *part = &geometry->part[k];
    if (part->joint == NO_PART) continue;
    double angle = part->joint_angle;
    if (part->joint_kind == UM_JOINT_SUN) {
      struct um_vec3 s = um_quat_apply(frame_of(geometry, k, angles).q, sun_body);
      angle += sun_angle(part->joint_axis, part->joint_normal, s);
    }
    if (part->joint_kind == UM_JOINT_SCHEDULE) angle += scheduled(&part->schedule, t_tai);
    angles[part->joint] = angle;
  }
}

enum um_status um_geometry_pose_create(struct um_context *context,
                                       const struct um_geometry *geometry, const double *angles,
                                       struct um_geometry_pose **out)
{
  enum um_status status;
  struct um_geometry_pose *pose = NULL;
  struct frame *frames = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, geometry->npart, sizeof *frames, (void *)&frames));
  UM_CHECK(um_core_allocate(context, 1, sizeof *pose, (void *)&pose));
  UM_CHECK(um_core_allocate(context, geometry->mesh.nvertex, sizeof *pose->vertex,
                            (void *)&pose->vertex));
  UM_CHECK(um_core_allocate(context, geometry->mesh.nfacet, sizeof *pose->facet_normal,
                            (void *)&pose->facet_normal));
  for (size_t i = 0; i < geometry->npart; i++) {
    size_t k = geometry->order[i];
    const struct um_geometry_part *part = &geometry->part[k];
    struct frame frame =
        unturned_frame(part, part->parent == NO_PART ? body_frame : frames[part->parent]);
    if (part->joint != NO_PART)
      frame = turned_frame(part, frame, angles == NULL ? part->joint_angle : angles[part->joint]);
    frames[k] = frame;
    struct um_mat3 to_body = um_mat3_transpose(um_quat_matrix(frame.q));
    for (size_t v = part->vertex_begin; v < part->vertex_end; v++)
      pose->vertex[v] = um_vec3_add(frame.origin, um_mat3_apply(to_body, geometry->vertex[v]));
    for (size_t f = part->facet_begin; f < part->facet_end; f++)
      pose->facet_normal[f] = um_mat3_apply(to_body, geometry->normal[f]);
  }
  *out = pose;
  pose = NULL;
done:
  um_core_free(context, frames);
  um_geometry_pose_destroy(context, &pose);
  return status;
}

void um_geometry_part_rotations(const struct um_geometry *geometry, const double *angles,
                                struct um_quat *rotation)
{
  for (size_t i = 0; i < geometry->npart; i++) {
    size_t k = geometry->order[i];
    const struct um_geometry_part *part = &geometry->part[k];
    struct frame frame = body_frame;
    if (part->parent != NO_PART) frame.q = rotation[part->parent];
    frame = unturned_frame(part, frame);
    if (part->joint != NO_PART)
      frame = turned_frame(part, frame, angles == NULL ? part->joint_angle : angles[part->joint]);
    rotation[k] = frame.q;
  }
}

void um_geometry_part_grain(const struct um_geometry *geometry, size_t surface,
                            struct um_vec3 *grain, struct um_vec3 *across)
{
  const struct um_geometry_surface *s = &geometry->mesh.surface[surface];
  struct um_vec3 g = geometry->part[s->part].grain;
  struct um_vec3 n = um_vec3_scale(geometry->normal[s->facet], s->back ? -1.0 : 1.0);
  if (!(um_vec3_norm(um_vec3_cross(n, g)) > UPRIGHT)) g = um_vec3(g.z, g.x, g.y);
  *grain = um_vec3_unit(um_vec3_axpy(g, -um_vec3_dot(g, n), n));
  *across = um_vec3_cross(n, *grain);
}

void um_geometry_surface_grain(const struct um_geometry *geometry, const struct um_quat *rotation,
                               size_t surface, struct um_vec3 *grain, struct um_vec3 *across)
{
  struct um_quat to_body = um_quat_conjugate(rotation[geometry->mesh.surface[surface].part]);
  um_geometry_part_grain(geometry, surface, grain, across);
  *grain = um_quat_apply(to_body, *grain);
  *across = um_quat_apply(to_body, *across);
}

void um_geometry_pose_destroy(struct um_context *context, struct um_geometry_pose **pose)
{
  if (pose == NULL || *pose == NULL) return;
  UM_FREE(context, (*pose)->vertex, (*pose)->facet_normal, *pose);
  *pose = NULL;
}

struct um_vec3 um_geometry_surface_normal(const struct um_geometry_mesh *mesh,
                                          const struct um_geometry_pose *pose, size_t surface)
{
  const struct um_geometry_surface *s = &mesh->surface[surface];
  return um_vec3_scale(pose->facet_normal[s->facet], s->back ? -1.0 : 1.0);
}
