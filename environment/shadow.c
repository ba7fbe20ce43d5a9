/* The Earth in front of the solar disc.
 *
 * A ray from r along d meets the ellipsoid |S x| = R, S = stretch by 1/(1 - f) along the pole, when
 *
 *   Q(d) = (Sr . Sd)^2 - |Sd|^2 (|Sr|^2 - R^2) > 0
 *
 * Q = 0 is the cone of the limb. In the plane that touches the sky at the centre of the Sun the
 * disc is a circle of radius t = tan a and the limb a conic v(u), so the visible flux is a line
 * integral around the visible part of the disc, by Green's theorem,
 *
 *   F = 1/(2 pi k(1) t^2) * contour integral of k(x) (u dv - v du),   x = (u^2 + v^2)/t^2,
 *   k(x) = (1/x) * integral from 0 to x of w/2 dx',   w = 1 - c (1 - sqrt(1 - x)) limb darkening
 *
 * an arc of the circle, elementary, and a piece of the limb, by Gauss-Legendre. It is what slicing
 * the disc into infinitely thin strips of rays gives (Adhya et al. 2004, J. Spacecraft Rockets
 * 41:168), without the strips. Montenbruck & Gill 2000, 3.4.2, take both discs as plane circles;
 * this differs from it by up to 2.2e-4. Their formula is used where the Earth looks smaller than
 * three solar radii, beyond 450 000 km.
 *
 * CYLINDER is the sphere and a point Sun in the direction given. */
#include <math.h>
#include <stdbool.h>

#include "base/core/constants.h"
#include "environment/environment.h"
#include "environment/quadrature_impl.h"
#include "environment/shadow_impl.h"

/* Earth and Sun as seen from one point; lengths in units of the shadow radius. */
struct limb {
  double stretch;    /* a/b of the ellipsoid [1] */
  struct um_vec3 sr; /* S r / R */
  double d;          /* |S r|^2 / R^2 - 1 */
  double sun, edge;  /* angles of the Sun and of the limb below it from the geocentre [rad] */
  double angle;      /* centre of the Sun above the limb, at right angles to the limb [rad] */
  struct um_vec3 up; /* unit, at the Sun, at right angles to the limb, away from the Earth */
};

static struct um_vec3 stretched(struct um_vec3 x, struct um_vec3 pole, double stretch)
{
  return um_vec3_axpy(x, (stretch - 1.0) * um_vec3_dot(x, pole), pole);
}

static struct limb limb_find(const struct um_environment *environment, struct um_vec3 r,
                             struct um_vec3 sun, struct um_vec3 pole)
{
  struct limb limb = {.stretch = 1.0};
  if (environment->shadow == UM_SHADOW_OBLATE) limb.stretch = 1.0 / (1.0 - UM_EARTH_FLATTENING);
  limb.sr = stretched(um_vec3_scale(r, 1.0 / environment->shadow_radius), pole, limb.stretch);
  limb.d = um_vec3_dot(limb.sr, limb.sr) - 1.0;
  if (limb.d <= 0.0) { /* inside the Earth it is dark */
    limb.angle = -0.5 * UM_PI;
    return limb;
  }

  /* directions n cos(theta) + e sin(theta) in the plane of geocentre and Sun */
  struct um_vec3 n = um_vec3_unit(um_vec3_scale(r, -1.0)), e, unused;
  struct um_vec3 across = um_vec3_axpy(sun, -um_vec3_dot(sun, n), n);
  double sine = um_vec3_norm(across);
  if (sine > 1e-8) /* below, rounding would turn e */
    e = um_vec3_scale(across, 1.0 / sine);
  else
    um_core_vec3_frame(n, &e, &unused);
  limb.sun = atan2(sine, um_vec3_dot(sun, n));

  /* Q = 0: A sin^2 + 2 B sin cos + C cos^2 = 0, the root on the side of the Sun */
  struct um_vec3 sn = stretched(n, pole, limb.stretch), se = stretched(e, pole, limb.stretch);
  double rn = um_vec3_dot(limb.sr, sn), re = um_vec3_dot(limb.sr, se);
  double a = re * re - limb.d * um_vec3_dot(se, se);
  double b = rn * re - limb.d * um_vec3_dot(sn, se);
  double c = rn * rn - limb.d * um_vec3_dot(sn, sn);
  limb.edge = atan2(b + sqrt(fmax(b * b - a * c, 0.0)), -a);

  /* the normal of the cone there, -grad Q; it leans from the plane by the tilt of an oblate limb */
  double ce = cos(limb.edge), si = sin(limb.edge);
  struct um_vec3 l = um_vec3_axpy(um_vec3_scale(n, ce), si, e);
  struct um_vec3 sl = stretched(l, pole, limb.stretch);
  struct um_vec3 gradient =
      um_vec3_axpy(um_vec3_scale(sl, limb.d), -um_vec3_dot(limb.sr, sl), limb.sr);
  struct um_vec3 normal = um_vec3_unit(stretched(gradient, pole, limb.stretch));
  struct um_vec3 rise = um_vec3_axpy(um_vec3_scale(n, -si), ce, e);
  limb.angle = (limb.sun - limb.edge) * um_vec3_dot(normal, rise);
  limb.up = um_vec3_unit(um_vec3_axpy(normal, -um_vec3_dot(normal, sun), sun));
  return limb;
}

/* The limb as a conic q(u, v) = 0 in the plane of the disc, d = sun + u e1 + v up. */
struct conic {
  double q[3][3];
};

static struct conic conic_of(const struct limb *limb, struct um_vec3 sun, struct um_vec3 pole)
{
  struct um_vec3 axis[3] = {sun, um_vec3_cross(limb->up, sun), limb->up};
  struct conic conic;
  for (int i = 0; i < 3; i++) axis[i] = stretched(axis[i], pole, limb->stretch);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      conic.q[i][j] = um_vec3_dot(limb->sr, axis[i]) * um_vec3_dot(limb->sr, axis[j]) -
                      limb->d * um_vec3_dot(axis[i], axis[j]);
  return conic;
}

/* Height v of the limb at u, and its slope dv/du. */
static double conic_height(const struct conic *conic, double u, double *slope)
{
  const double(*q)[3] = conic->q;
  double b = q[0][2] + q[1][2] * u;
  double c = q[0][0] + u * (2.0 * q[0][1] + u * q[1][1]);
  double v = c / (sqrt(fmax(b * b - q[2][2] * c, 0.0)) - b);
  *slope = -(q[0][1] + q[1][1] * u + q[1][2] * v) / (b + q[2][2] * v);
  return v;
}

/* Angle phi in [-pi/2, pi/2] at which the limb crosses the circle of radius t on the side
 * u = side t cos(phi), v = t sin(phi): sin(phi) = v(u)/t contracts by the curvature of the limb
 * times t, at most 1/3 here and about 0.002 from a low orbit. */
static double crossing(const struct conic *conic, double t, double side)
{
  double phi = 0.0, slope;
  for (int i = 0; i < 40; i++) {
    double before = phi;
    double s = conic_height(conic, side * t * cos(phi), &slope) / t;
    phi = asin(fmin(fmax(s, -1.0), 1.0));
    if (fabs(phi - before) < 1e-15) break;
  }
  return phi;
}

/* k(x) for limb darkening c; (1 - (1 - x)^(3/2))/x written without cancellation. */
static double contour_weight(double x, double c)
{
  double m = sqrt(fmax(1.0 - x, 0.0));
  return 0.5 * (1.0 - c) + c / 3.0 * (1.0 + m + m * m) / (1.0 + m);
}

static double fraction_cut(const struct limb *limb, struct um_vec3 sun, struct um_vec3 pole,
                           double angular_radius, double darkening)
{
  struct conic conic = conic_of(limb, sun, pole);
  double t = tan(angular_radius);
  double right = crossing(&conic, t, 1.0), left = crossing(&conic, t, -1.0);
  /* the arc above the limb, counter-clockwise from the right */
  double rim = contour_weight(1.0, darkening);
  double sum = rim * t * t * (UM_PI - left - right);
  /* the limb from left to right, u = middle + half sin(tau): k(x) ends like (1 - x)^(3/2) */
  double middle = 0.5 * t * (cos(right) - cos(left)), half = 0.5 * t * (cos(right) + cos(left));
  for (int i = 0; i < 16; i++) {
    double tau = UM_PI * (um_environment_gauss_16[i].x - 0.5), slope;
    double u = middle + half * sin(tau), v = conic_height(&conic, u, &slope);
    double weight = UM_PI * um_environment_gauss_16[i].w * half * cos(tau);
    sum += weight * contour_weight((u * u + v * v) / (t * t), darkening) * (u * slope - v);
  }
  return fmin(fmax(sum / (2.0 * UM_PI * rim * t * t), 0.0), 1.0);
}

/* Plane circles, Montenbruck & Gill 2000 eq. 3.87-3.94: a Sun, b Earth, c separation [rad]. */
static double fraction_plane(double a, double b, double c)
{
  if (c <= fabs(a - b)) return a > b ? 1.0 - b * b / (a * a) : 0.0;
  double x = 0.5 * (c * c + a * a - b * b) / c, y = sqrt(fmax(a * a - x * x, 0.0));
  double area = a * a * acos(x / a) + b * b * acos((c - x) / b) - c * y;
  return fmin(fmax(1.0 - area / (UM_PI * a * a), 0.0), 1.0);
}

static double sun_angular_radius(double distance)
{
  return asin(fmin(UM_SOLAR_RADIUS / distance, 1.0));
}

struct um_environment_limb_sight um_environment_limb_sight(const struct um_environment *environment,
                                                           struct um_vec3 r, struct um_vec3 sun,
                                                           double distance, struct um_vec3 pole)
{
  struct limb limb = {.angle = UM_PI};
  if (environment->shadow != UM_SHADOW_NONE) limb = limb_find(environment, r, sun, pole);
  return (struct um_environment_limb_sight){limb.angle, limb.edge, um_vec3_norm(r),
                                            sun_angular_radius(distance)};
}

double um_environment_airless_fraction(const struct um_environment *environment, struct um_vec3 r,
                                       struct um_vec3 sun, double distance, struct um_vec3 pole)
{
  if (environment->shadow == UM_SHADOW_NONE) return 1.0;
  struct limb limb = limb_find(environment, r, sun, pole);
  if (isnan(limb.angle)) return NAN;
  if (environment->shadow == UM_SHADOW_CYLINDER || environment->disc == UM_DISC_POINT)
    return limb.angle > 0.0 ? 1.0 : 0.0;
  double a = sun_angular_radius(distance);
  if (limb.angle >= a) return 1.0;
  if (limb.angle <= -a) return 0.0;
  if (limb.edge < 3.0 * a) return fraction_plane(a, limb.edge, limb.sun);
  bool darkened = environment->disc == UM_DISC_LIMB_DARKENED;
  return fraction_cut(&limb, sun, pole, a, darkened ? environment->limb_darkening : 0.0);
}

double um_environment_limb_angle(const struct um_environment *environment, struct um_vec3 r,
                                 struct um_vec3 sun, double distance, struct um_vec3 pole)
{
  (void)distance;
  if (environment->shadow == UM_SHADOW_NONE) return UM_PI;
  return limb_find(environment, r, sun, pole).angle;
}
