/* The few vector functions that are too long to be inline. */
#include "base/core/vec.h"

#include "base/core/constants.h"

/* Shepperd 1978, J. Guidance and Control 1:223: divide by the largest of the four components, so
 * that no square root of a cancelled sum is taken. */
struct um_quat um_core_quat_from_matrix(struct um_mat3 m)
{
  double trace = m.m[0][0] + m.m[1][1] + m.m[2][2];
  struct um_quat q;
  if (trace > m.m[0][0] && trace > m.m[1][1] && trace > m.m[2][2]) {
    double w = 0.5 * sqrt(1.0 + trace), s = 0.25 / w;
    q = (struct um_quat){w, s * (m.m[1][2] - m.m[2][1]), s * (m.m[2][0] - m.m[0][2]),
                         s * (m.m[0][1] - m.m[1][0])};
  } else if (m.m[0][0] >= m.m[1][1] && m.m[0][0] >= m.m[2][2]) {
    double x = 0.5 * sqrt(1.0 + m.m[0][0] - m.m[1][1] - m.m[2][2]), s = 0.25 / x;
    q = (struct um_quat){s * (m.m[1][2] - m.m[2][1]), x, s * (m.m[0][1] + m.m[1][0]),
                         s * (m.m[0][2] + m.m[2][0])};
  } else if (m.m[1][1] >= m.m[2][2]) {
    double y = 0.5 * sqrt(1.0 - m.m[0][0] + m.m[1][1] - m.m[2][2]), s = 0.25 / y;
    q = (struct um_quat){s * (m.m[2][0] - m.m[0][2]), s * (m.m[0][1] + m.m[1][0]), y,
                         s * (m.m[1][2] + m.m[2][1])};
  } else {
    double z = 0.5 * sqrt(1.0 - m.m[0][0] - m.m[1][1] + m.m[2][2]), s = 0.25 / z;
    q = (struct um_quat){s * (m.m[0][1] - m.m[1][0]), s * (m.m[0][2] + m.m[2][0]),
                         s * (m.m[1][2] + m.m[2][1]), z};
  }
  return um_quat_normalize(q);
}

/* Shoemake 1985, with the linear limit where the sines vanish. */
struct um_quat um_core_quat_slerp(struct um_quat a, struct um_quat b, double u)
{
  double dot = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
  double sign = dot < 0.0 ? -1.0 : 1.0;
  double c = fmin(sign * dot, 1.0);
  double angle = acos(c), s = sin(angle);
  double wa = 1.0 - u, wb = u;
  if (s > 1e-9) {
    wa = sin((1.0 - u) * angle) / s;
    wb = sin(u * angle) / s;
  }
  wb *= sign;
  return um_quat_normalize((struct um_quat){wa * a.w + wb * b.w, wa * a.x + wb * b.x,
                                            wa * a.y + wb * b.y, wa * a.z + wb * b.z});
}

/* Duff et al. 2017, JCGT 6:1: branch-free orthonormal basis, stable for every n. */
void um_core_vec3_frame(struct um_vec3 n, struct um_vec3 *t, struct um_vec3 *b)
{
  double sign = copysign(1.0, n.z);
  double a = -1.0 / (sign + n.z);
  double c = n.x * n.y * a;
  *t = um_vec3(1.0 + sign * n.x * n.x * a, sign * c, -sign * n.x);
  *b = um_vec3(c, sign + n.y * n.y * a, -n.y);
}

struct um_quat um_core_quat_between(struct um_vec3 a, struct um_vec3 b)
{
  struct um_vec3 cross = um_vec3_cross(a, b), t, u;
  double sine = um_vec3_norm(cross);
  if (sine > 1e-12) return um_quat_from_axis(um_vec3_scale(cross, 1.0 / sine), um_vec3_angle(a, b));
  if (um_vec3_dot(a, b) > 0.0) return (struct um_quat){1.0, 0.0, 0.0, 0.0};
  um_core_vec3_frame(a, &t, &u);
  return um_quat_from_axis(t, UM_PI);
}
