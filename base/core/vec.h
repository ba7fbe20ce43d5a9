/* Three-vectors, quaternions and rotation matrices, all by value and inline.
 * Quaternions are scalar first, frame A to frame B, passive: v_b = um_quat_apply(q, v_a). */
#ifndef UMBRA_CORE_VEC_H
#define UMBRA_CORE_VEC_H

#include <math.h>

struct um_vec3 {
  double x, y, z;
};
struct um_quat {
  double w, x, y, z;
};
/* Row major: v_b = M v_a, rows are the axes of B in A. */
struct um_mat3 {
  double m[3][3];
};

static inline struct um_vec3 um_vec3(double x, double y, double z)
{
  return (struct um_vec3){x, y, z};
}
static inline struct um_vec3 um_vec3_add(struct um_vec3 a, struct um_vec3 b)
{
  return um_vec3(a.x + b.x, a.y + b.y, a.z + b.z);
}
static inline struct um_vec3 um_vec3_sub(struct um_vec3 a, struct um_vec3 b)
{
  return um_vec3(a.x - b.x, a.y - b.y, a.z - b.z);
}
static inline struct um_vec3 um_vec3_scale(struct um_vec3 a, double s)
{
  return um_vec3(s * a.x, s * a.y, s * a.z);
}
/* a + s b */
static inline struct um_vec3 um_vec3_axpy(struct um_vec3 a, double s, struct um_vec3 b)
{
  return um_vec3(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z);
}
static inline double um_vec3_dot(struct um_vec3 a, struct um_vec3 b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
static inline struct um_vec3 um_vec3_cross(struct um_vec3 a, struct um_vec3 b)
{
  return um_vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
static inline double um_vec3_norm(struct um_vec3 a) { return sqrt(um_vec3_dot(a, a)); }
/* Unit vector; the zero vector gives NaN. */
static inline struct um_vec3 um_vec3_unit(struct um_vec3 a)
{
  return um_vec3_scale(a, 1.0 / um_vec3_norm(a));
}
/* Angle between a and b [rad], accurate near 0 and pi. */
static inline double um_vec3_angle(struct um_vec3 a, struct um_vec3 b)
{
  return atan2(um_vec3_norm(um_vec3_cross(a, b)), um_vec3_dot(a, b));
}

static inline struct um_vec3 um_mat3_apply(struct um_mat3 m, struct um_vec3 v)
{
  return um_vec3(m.m[0][0] * v.x + m.m[0][1] * v.y + m.m[0][2] * v.z,
                 m.m[1][0] * v.x + m.m[1][1] * v.y + m.m[1][2] * v.z,
                 m.m[2][0] * v.x + m.m[2][1] * v.y + m.m[2][2] * v.z);
}
static inline struct um_mat3 um_mat3_transpose(struct um_mat3 a)
{
  struct um_mat3 t;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) t.m[i][j] = a.m[j][i];
  return t;
}
/* a b: first b, then a. */
static inline struct um_mat3 um_mat3_multiply(struct um_mat3 a, struct um_mat3 b)
{
  struct um_mat3 c;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      c.m[i][j] = a.m[i][0] * b.m[0][j] + a.m[i][1] * b.m[1][j] + a.m[i][2] * b.m[2][j];
  return c;
}
/* Matrix whose rows are the given axes of B expressed in A. */
static inline struct um_mat3 um_mat3_from_axes(struct um_vec3 x, struct um_vec3 y, struct um_vec3 z)
{
  return (struct um_mat3){{{x.x, x.y, x.z}, {y.x, y.y, y.z}, {z.x, z.y, z.z}}};
}

static inline struct um_quat um_quat_conjugate(struct um_quat q)
{
  return (struct um_quat){q.w, -q.x, -q.y, -q.z};
}
static inline struct um_quat um_quat_normalize(struct um_quat q)
{
  double s = 1.0 / sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return (struct um_quat){s * q.w, s * q.x, s * q.y, s * q.z};
}
/* The passive matrix of q: um_mat3_apply(um_quat_matrix(q), v) == um_quat_apply(q, v). */
static inline struct um_mat3 um_quat_matrix(struct um_quat q)
{
  double w = q.w, x = q.x, y = q.y, z = q.z;
  return (struct um_mat3){
      {{w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)},
       {2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)},
       {2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z}}};
}
static inline struct um_vec3 um_quat_apply(struct um_quat q, struct um_vec3 v)
{
  return um_mat3_apply(um_quat_matrix(q), v);
}
/* Passive composition: q_ac = um_quat_then(q_ab, q_bc). (Hamilton product q_ab q_bc.) */
static inline struct um_quat um_quat_then(struct um_quat p, struct um_quat q)
{
  return (struct um_quat){
      p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z, p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
      p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x, p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
}
/* Frame B is frame A turned by +angle [rad] about the unit axis (the axis reads the same in both).
 */
static inline struct um_quat um_quat_from_axis(struct um_vec3 axis, double angle)
{
  double s = sin(0.5 * angle);
  return (struct um_quat){cos(0.5 * angle), s * axis.x, s * axis.y, s * axis.z};
}

/* Quaternion of a passive rotation matrix (Shepperd's method); exported, see vec.c. */
struct um_quat um_core_quat_from_matrix(struct um_mat3 m);
/* The smallest rotation of a frame after which the unit vector a, read in the turned frame, is the
 * unit vector b of the first frame: about a x b by the angle between them; any perpendicular serves
 * for opposite directions. */
struct um_quat um_core_quat_between(struct um_vec3 a, struct um_vec3 b);
/* Spherical linear interpolation along the shorter arc, u in [0, 1]. */
struct um_quat um_core_quat_slerp(struct um_quat a, struct um_quat b, double u);
/* Two unit vectors that complete the unit vector n to a right-handed frame (t, b, n). */
void um_core_vec3_frame(struct um_vec3 n, struct um_vec3 *t, struct um_vec3 *b);

#endif
