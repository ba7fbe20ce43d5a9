/* Torque-free motion. With principal moments I_c, I_b, I_a, b the middle one and a the one whose
 * axis goes about the momentum (the greatest where L^2 > 2 E I_b, else the least), s = +1 or -1
 * where a is the greatest or the least (Landau & Lifshitz, Mechanics, section 37):
 *
 *   w_c = A_c cn u,  w_b = s A_b sn u,  w_a = A_a dn u,  u = u_0 + n (t - t_0),
 *   A_c^2 = (2 E I_a - L^2)/(I_c (I_a - I_c)),  A_b^2 = (2 E I_a - L^2)/(I_b (I_a - I_b)),
 *   A_a^2 = (L^2 - 2 E I_c)/(I_a (I_a - I_c)),  n^2 = (I_a - I_b)(L^2 - 2 E I_c)/(I_a I_b I_c),
 *   m1 = 1 - m = (I_a - I_c)(L^2 - 2 E I_b)/((I_a - I_b)(L^2 - 2 E I_c)),
 *
 * which come again after 4 K(m)/n. The momentum's direction in the body follows from I w. What is
 * left is the angle chi about it, of the body turned by chi and then tipped the shortest way:
 *
 *   chi' = (2 E/L + w_a)/(1 + cos theta),  cos theta = I_a w_a/L
 *
 * (of Euler's angles phi' + psi', by w.L = 2 E and w_a = phi' cos theta + psi'); it has dn's
 * period, 2 K, and is summed over it once. */
#include "orbit/tumble_impl.h"

#include <math.h>

#include "base/core/constants.h"
#include "orbit/elliptic_impl.h"

#define STEADY     1e-12 /* sine of the angle from rate to momentum */
#define SEPARATRIX 1e-13 /* least m1 */
#define PANEL      0.5   /* longest panel of u: the nearest pole of dn is pi/2 off */

static const struct um_vec3 along = {0.0, 0.0, 1.0};

/* Principal axes as rows of *axes, moments ascending: Jacobi's rotations. */
static void principal(const double i[6], double moment[3], struct um_vec3 axis[3])
{
  double a[3][3] = {{i[0], i[3], i[4]}, {i[3], i[1], i[5]}, {i[4], i[5], i[2]}};
  double v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int sweep = 0; sweep < 30; sweep++)
    for (int p = 0; p < 2; p++)
      for (int q = p + 1; q < 3; q++) {
        if (a[p][q] == 0.0) continue;
        double angle = 0.5 * atan2(2.0 * a[p][q], a[q][q] - a[p][p]), c = cos(angle),
               s = sin(angle);
        for (int k = 0; k < 3; k++) {
          double x = a[k][p], y = a[k][q];
          a[k][p] = c * x - s * y;
          a[k][q] = s * x + c * y;
        }
        for (int k = 0; k < 3; k++) {
          double x = a[p][k], y = a[q][k];
          a[p][k] = c * x - s * y;
          a[q][k] = s * x + c * y;
          double t = v[p][k], w = v[q][k];
          v[p][k] = c * t - s * w;
          v[q][k] = s * t + c * w;
        }
        a[p][q] = a[q][p] = 0.0;
      }
  int order[3] = {0, 1, 2};
  for (int k = 0; k < 2; k++)
    for (int j = 0; j < 2 - k; j++)
      if (a[order[j]][order[j]] > a[order[j + 1]][order[j + 1]]) {
        int other = order[j];
        order[j] = order[j + 1];
        order[j + 1] = other;
      }
  for (int k = 0; k < 3; k++) {
    moment[k] = a[order[k]][order[k]];
    axis[k] = um_vec3(v[order[k]][0], v[order[k]][1], v[order[k]][2]);
  }
}

static enum um_status moments_check(struct um_context *context, const double moment[3])
{
  if (moment[0] > 0.0 && moment[2] < INFINITY &&
      moment[2] <= (moment[0] + moment[1]) * (1.0 + 1e-9))
    return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "attitude: principal moments of inertia %g, %g, %g; accepted: above 0, none "
                      "greater than the sum of the others",
                      moment[0], moment[1], moment[2]);
}

/* Eight points of Gauss (Abramowitz & Stegun, table 25.4). */
static double chi_between(const struct um_orbit_tumble *t, double from, double to)
{
  static const double x[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                              0.9602898564975363};
  static const double w[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                              0.1012285362903763};
  double middle = 0.5 * (from + to), half = 0.5 * (to - from), sum = 0.0;
  for (int i = 0; i < 8; i++) {
    double sn, cn, dn, u = middle + (i % 2 == 0 ? half : -half) * x[i / 2];
    um_orbit_elliptic_jacobi(u, t->m1, &sn, &cn, &dn);
    double about = t->amplitude[2] * dn;
    sum += w[i / 2] * (t->energy / t->size + about) / (1.0 + t->inertia[2] * about / t->size);
  }
  return sum * half / t->n;
}

/* u within half a period of dn, and how many are taken off. */
static double reduced(const struct um_orbit_tumble *t, double u, double *periods)
{
  *periods = round(u / (2.0 * t->quarter));
  return fmin(fmax(u - *periods * 2.0 * t->quarter, -t->quarter), t->quarter);
}

static double chi_of(const struct um_orbit_tumble *t, double u)
{
  double periods, v = reduced(t, u, &periods), size = fabs(v);
  double step = t->quarter / t->panels;
  int k = (int)fmin(floor(size / step), t->panels - 1.0);
  double part = t->turned[k] + chi_between(t, k * step, size);
  return periods * 2.0 * t->turned[t->panels] + copysign(part, v);
}

static struct um_vec3 rate_of(const struct um_orbit_tumble *t, double u)
{
  double periods, v = reduced(t, u, &periods), sn, cn, dn;
  double sign = fmod(fabs(periods), 2.0) > 0.5 ? -1.0 : 1.0;
  um_orbit_elliptic_jacobi(v, t->m1, &sn, &cn, &dn);
  return um_vec3(sign * t->amplitude[0] * cn, sign * t->sense * t->amplitude[1] * sn,
                 t->amplitude[2] * dn);
}

/* From the momentum's frame to the principal axes. */
static struct um_quat tipped(const struct um_orbit_tumble *t, double u, double chi)
{
  struct um_vec3 w = rate_of(t, u);
  struct um_vec3 l =
      um_vec3_unit(um_vec3(t->inertia[0] * w.x, t->inertia[1] * w.y, t->inertia[2] * w.z));
  return um_quat_then(um_quat_from_axis(along, chi), um_core_quat_between(l, along));
}

/* Amplitudes, parameter and phase of the rate w about c, b, a. */
static enum um_status polhode(struct um_context *context, struct um_vec3 w,
                              struct um_orbit_tumble *t)
{
  const double c = t->inertia[0], b = t->inertia[1], a = t->inertia[2];
  double cc = c * w.x * w.x, bb = b * w.y * w.y, aa = a * w.z * w.z;
  double of_a = bb * (a - b) + cc * (a - c); /* 2 E I_a - L^2 */
  double of_b = aa * (a - b) + cc * (c - b); /* L^2 - 2 E I_b */
  double of_c = aa * (a - c) + bb * (b - c); /* L^2 - 2 E I_c */
  t->sense = a > b ? 1.0 : -1.0;
  t->amplitude[0] = sqrt(of_a / (c * (a - c)));
  t->amplitude[1] = sqrt(of_a / (b * (a - b)));
  t->amplitude[2] = sqrt(of_c / (a * (a - c)));
  t->n = sqrt((a - b) * of_c / (a * b * c));
  t->m1 = fmin((a - c) * of_b / ((a - b) * of_c), 1.0);
  if (!(t->m1 >= SEPARATRIX))
    return um_core_fail(
        context, UM_ERR_INPUT,
        "attitude: the rates lie on the separatrix about the middle axis of inertia; "
        "accepted: rates beside it, 1 - m of 1e-13 or more");
  t->energy = cc + bb + aa;
  t->size = sqrt(c * cc + b * bb + a * aa);
  t->quarter = um_orbit_elliptic_k(t->m1);
  t->start =
      um_orbit_elliptic_f(atan2(t->sense * w.y / t->amplitude[1], w.x / t->amplitude[0]), t->m1);
  return UM_OK;
}

static void chi_sum(struct um_orbit_tumble *t)
{
  t->panels = (int)ceil(t->quarter / PANEL);
  if (t->panels > UM_TUMBLE_PANELS) t->panels = UM_TUMBLE_PANELS;
  double step = t->quarter / t->panels;
  t->turned[0] = 0.0;
  for (int k = 0; k < t->panels; k++)
    t->turned[k + 1] = t->turned[k] + chi_between(t, k * step, (k + 1) * step);
}

enum um_status um_orbit_tumble_make(struct um_context *context, const double inertia[6],
                                    struct um_vec3 rate, struct um_quat q,
                                    struct um_orbit_tumble *out)
{
  double moment[3], w[3];
  struct um_vec3 axis[3];
  *out = (struct um_orbit_tumble){.rate = rate, .q = q};
  principal(inertia, moment, axis);
  UM_TRY(moments_check(context, moment));
  for (int k = 0; k < 3; k++) w[k] = um_vec3_dot(axis[k], rate);
  struct um_vec3 momentum = um_vec3(moment[0] * w[0], moment[1] * w[1], moment[2] * w[2]);
  struct um_vec3 turning = um_vec3(w[0], w[1], w[2]);
  if (!(um_vec3_norm(turning) > 0.0 && um_vec3_norm(turning) < INFINITY))
    return um_core_fail(context, UM_ERR_INPUT,
                        "attitude: the rates are (%g, %g, %g) rad/s; accepted: finite, not all 0",
                        rate.x, rate.y, rate.z);
  out->steady = um_vec3_norm(um_vec3_cross(turning, momentum)) <=
                STEADY * um_vec3_norm(turning) * um_vec3_norm(momentum);
  if (out->steady) return UM_OK;
  bool greatest = moment[2] * (moment[2] - moment[1]) * w[2] * w[2] >=
                  moment[0] * (moment[1] - moment[0]) * w[0] * w[0];
  int a = greatest ? 2 : 0, c = 2 - a;
  struct um_vec3 ea = um_vec3_scale(axis[a], w[a] < 0.0 ? -1.0 : 1.0), ec = axis[c];
  struct um_vec3 eb = um_vec3_cross(ea, ec);
  out->to_axes = um_core_quat_from_matrix(um_mat3_from_axes(ec, eb, ea));
  const int of[3] = {c, 1, a};
  for (int k = 0; k < 3; k++) out->inertia[k] = moment[of[k]] / moment[2];
  struct um_vec3 about =
      um_vec3(um_vec3_dot(ec, rate), um_vec3_dot(eb, rate), um_vec3_dot(ea, rate));
  UM_TRY(polhode(context, about, out));
  chi_sum(out);
  out->chi_start = chi_of(out, out->start);
  out->momentum =
      um_quat_then(um_quat_then(q, out->to_axes), um_quat_conjugate(tipped(out, out->start, 0.0)));
  return UM_OK;
}

struct um_quat um_orbit_tumble_at(const struct um_orbit_tumble *t, double since,
                                  struct um_vec3 *rate)
{
  if (t->steady) {
    double size = um_vec3_norm(t->rate), turns = since * size / (2.0 * UM_PI);
    if (rate != NULL) *rate = t->rate;
    return um_quat_then(t->q, um_quat_from_axis(um_vec3_scale(t->rate, 1.0 / size),
                                                2.0 * UM_PI * (turns - floor(turns))));
  }
  double u = t->start + t->n * since, chi = chi_of(t, u) - t->chi_start;
  struct um_quat back = um_quat_conjugate(t->to_axes);
  if (rate != NULL) *rate = um_quat_apply(back, rate_of(t, u));
  return um_quat_normalize(
      um_quat_then(um_quat_then(t->momentum, tipped(t, u, fmod(chi, 4.0 * UM_PI))), back));
}

double um_orbit_tumble_period(const struct um_orbit_tumble *t)
{
  return t->steady ? INFINITY : 4.0 * t->quarter / t->n;
}

/* w^2 is linear in sn^2. */
double um_orbit_tumble_fastest(const struct um_orbit_tumble *t)
{
  if (t->steady) return um_vec3_norm(t->rate);
  double at_c = hypot(t->amplitude[0], t->amplitude[2]);
  return fmax(at_c, hypot(t->amplitude[1], t->amplitude[2] * sqrt(t->m1)));
}
