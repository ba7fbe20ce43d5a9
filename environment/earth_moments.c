/* Angular moments of the Earth (angular_moments.h), by rings about the plate's own normal, since
 * the polynomials in u = sqrt(cos(theta)) are constant on each:
 *
 *   int P_k 2 u^3 A du,   A = int L dpsi over |psi| < Psi(theta)
 *   cos(Psi) = (cos(rho) - cos(theta) c) / (sin(theta) s)
 *
 * with rho the angular radius of the Earth, c and s cosine and sine of the tilt t of the plate from
 * nadir. A ring nearer to the normal than rho - t lies on the Earth all round. What the Earth emits
 * is the same all over: A = 2 Psi. What it reflects is max(cos SZA, 0) of the ground that stands in
 * a direction d, p = d tau - h nadir, tau = h d.nadir - sqrt(1 - h^2 (1 - (d.nadir)^2)); directions
 * at psi and -psi differ by the sign of one summand.
 *
 * Psi begins and ends like a square root, as does the ground at the limb: nodes are laid by 3 x^2 -
 * 2 x^3 in u, Gauss-Legendre's, and by (3 x - x^3)/2 in psi, which are flat at both ends. Rings
 * stand side by side in wide registers, so that sines and cosines are polynomials of theirs. */
#include "environment/earth_moments_impl.h"

#include "base/core/constants.h"
#include "base/core/wide.h"
#include "environment/quadrature_impl.h"

void um_environment_angular_project(const double *value, size_t n, double a[UM_ANGULAR_MOMENTS])
{
  static const double boole[4] = {14.0, 32.0, 12.0, 32.0};
  double h = 1.0 / (double)(n - 1);
  for (size_t k = 0; k < UM_ANGULAR_MOMENTS; k++) a[k] = 0.0;
  for (size_t i = 0; i < n; i++) {
    double u = (double)i * h, p[UM_ANGULAR_MOMENTS];
    double weight = (i == 0 || i == n - 1 ? 7.0 : boole[i % 4]) * 2.0 * h / 45.0;
    um_environment_angular_polynomials(u * u, p);
    for (size_t k = 0; k < UM_ANGULAR_MOMENTS; k++)
      a[k] += 2.0 * ((double)k + 3.0) * weight * value[i] * p[k] * u * u * u;
  }
}

/* Whole rings, then those that end. */
#define WHOLE 8
#define RINGS 24

static void azimuth_set(struct um_environment_earth_azimuths *a, int j, double x, double weight)
{
  a->part[j] = 0.5 * x * (3.0 - x * x);
  a->weight[j] = 1.5 * (1.0 - x * x) * weight;
  a->cosine[j] = cos(UM_PI * (j + 0.5) / a->n);
  a->sine[j] = sin(UM_PI * (j + 0.5) / a->n);
}

/* Where all rings are lit all round, Gauss-Legendre's eight on -1..1; across the terminator, a
 * kink, as many on each quarter. */
struct um_environment_earth_azimuths
um_environment_earth_azimuths(const struct um_environment_earth_view *view)
{
  struct um_environment_earth_azimuths a = {.crossed = view->sin_zenith * view->h > 1.0};
  a.n = a.crossed ? 16 : 4;
  for (int j = 0; j < a.n; j++) {
    const struct um_environment_gauss *gauss = &um_environment_gauss_8[a.crossed ? j % 8 : 4 + j];
    int quarter = j / 8;
    if (a.crossed)
      azimuth_set(&a, j, 0.5 * (quarter + gauss->x), 0.5 * gauss->w);
    else
      azimuth_set(&a, j, 2.0 * gauss->x - 1.0, 2.0 * gauss->w);
  }
  return a;
}

/* A plate before the Earth; the frame has the normal for its z, nadir in x and z. */
struct plate {
  double h, cos_rho, c, s;
  struct um_vec3 sun;
};

static struct plate plate_of(const struct um_environment_earth_view *view, struct um_vec3 normal)
{
  struct um_vec3 sun =
      um_vec3_axpy(um_vec3_scale(view->nadir, -view->cos_zenith), view->sin_zenith, view->sunward);
  struct plate plate = {.h = view->h, .c = fmax(-1.0, fmin(1.0, um_vec3_dot(normal, view->nadir)))};
  struct um_vec3 across = um_vec3_axpy(view->nadir, -plate.c, normal), along;
  plate.cos_rho = sqrt(fmax(0.0, (1.0 - 1.0 / view->h) * (1.0 + 1.0 / view->h)));
  plate.s = um_vec3_norm(across);
  if (plate.s > 1e-8)
    along = um_vec3_cross(normal, across = um_vec3_scale(across, 1.0 / plate.s));
  else
    um_core_vec3_frame(normal, &across, &along);
  plate.sun = um_vec3(um_vec3_dot(sun, across), um_vec3_dot(sun, along), um_vec3_dot(sun, normal));
  return plate;
}

/* Rings from the first one that there is to the end. */
struct rings {
  int first, end;
  double u[RINGS], cosine[RINGS], sine[RINGS], weight[RINGS];
  double arc[RINGS];    /* Psi */
  double bright[RINGS]; /* integral of max(cos SZA, 0) over |psi| < Psi */
};

static void rings_lay(const struct plate *plate, struct rings *r)
{
  double mid = plate->c * plate->cos_rho, wide = plate->s / plate->h; /* of cos(t -+ rho) */
  double near = sqrt(fmax(0.0, fmin(mid + wide, 1.0))), far = sqrt(fmax(0.0, mid - wide));
  r->first = plate->c > plate->cos_rho ? 0 : WHOLE;
  r->end = far < near && plate->s > 1e-8 ? RINGS : WHOLE;
  for (int i = 0; i < WHOLE; i++) {
    r->u[i] = near + (1.0 - near) * um_environment_gauss_8[i].x;
    r->weight[i] = (1.0 - near) * um_environment_gauss_8[i].w;
  }
  for (int i = WHOLE; i < RINGS; i++) {
    const struct um_environment_gauss *gauss = &um_environment_gauss_16[i - WHOLE];
    double x = gauss->x;
    r->u[i] = far + (near - far) * x * x * (3.0 - 2.0 * x);
    r->weight[i] = (near - far) * gauss->w * 6.0 * x * (1.0 - x);
  }
}

/* max(x, 0) */
static inline double above(double x) { return 0.5 * (x + fabs(x)); }

/* Arc cosine of what is held to -1..1, to 2e-8 (Abramowitz & Stegun 1964, 4.4.46). */
static inline double arc_of(double cosine)
{
  static const double a[8] = {1.5707963050, -0.2145988016, 0.0889789874, -0.0501743046,
                              0.0308918810, -0.0170881256, 0.0066700901, -0.0012624911};
  double less = above(1.0 - fabs(cosine)), x = 1.0 - less, sum = a[7];
  for (int k = 6; k >= 0; k--) sum = sum * x + a[k];
  return 0.5 * UM_PI - copysign(0.5 * UM_PI - sqrt(less) * sum, cosine);
}

UM_WIDE_VECTORS static void rings_bound(const struct plate *plate, struct rings *r)
{
  for (int i = 0; i < RINGS; i++) {
    double u = r->u[i], cosine = u * u;
    r->cosine[i] = cosine;
    r->sine[i] = sqrt(1.0 - cosine * cosine + 1e-30); /* never 0 */
    r->weight[i] *= 2.0 * u * cosine;
    r->arc[i] = arc_of((plate->cos_rho - cosine * plate->c) / (r->sine[i] * plate->s));
  }
  for (int i = 0; i < WHOLE; i++) r->arc[i] = UM_PI;
}

/* Sine and cosine of 0..pi/2 to 3e-9 (4.3.97, 4.3.99 there). */
static inline double sine_of(double x)
{
  static const double a[5] = {-0.1666666664, 0.0083333315, -0.0001984090, 0.0000027526,
                              -0.0000000239};
  double q = x * x;
  return x * (1.0 + q * (a[0] + q * (a[1] + q * (a[2] + q * (a[3] + q * a[4])))));
}

static inline double cosine_of(double x)
{
  static const double a[5] = {-0.4999999963, 0.0416666418, -0.0013888397, 0.0000247609,
                              -0.0000002605};
  double q = x * x;
  return 1.0 + q * (a[0] + q * (a[1] + q * (a[2] + q * (a[3] + q * a[4]))));
}

/* Azimuth j of all rings. */
struct turned {
  double cosine[RINGS], sine[RINGS], weight[RINGS];
};

UM_WIDE_VECTORS static void turn(const struct um_environment_earth_azimuths *a, int j,
                                 const struct rings *r, struct turned *out)
{
  double part = 0.5 * a->part[j], weight = a->weight[j];
  for (int i = 0; i < WHOLE; i++) {
    out->cosine[i] = a->cosine[j];
    out->sine[i] = a->sine[j];
    out->weight[i] = 1.0 / a->n;
  }
  for (int i = WHOLE; i < RINGS; i++) {
    double s = sine_of(part * r->arc[i]), c = cosine_of(part * r->arc[i]);
    out->cosine[i] = 1.0 - 2.0 * s * s;
    out->sine[i] = 2.0 * s * c;
    out->weight[i] = weight;
  }
}

UM_WIDE_VECTORS static void rings_light(const struct plate *plate,
                                        const struct um_environment_earth_azimuths *a,
                                        struct rings *r)
{
  double h = plate->h, beneath = h * (plate->s * plate->sun.x + plate->c * plate->sun.z);
  struct um_vec3 sun = plate->sun;
  struct turned t;
  for (int i = 0; i < RINGS; i++) r->bright[i] = 0.0;
  for (int j = 0; j < a->n; j++) {
    turn(a, j, r, &t);
    for (int i = r->first; i < r->end; i++) {
      double x = r->sine[i] * t.cosine[i], y = r->sine[i] * t.sine[i], z = r->cosine[i];
      double down = h * (plate->s * x + plate->c * z);
      double tau = down - sqrt(above(1.0 - h * h + down * down));
      double sza = tau * (x * sun.x + z * sun.z) - beneath, side = tau * y * sun.y;
      r->bright[i] += t.weight[i] * (above(sza + side) + above(sza - side));
    }
  }
  for (int i = r->first; i < r->end; i++) r->bright[i] *= r->arc[i];
}

/* Sums over rings. [0]: of 1, then of the polynomials. */
struct sums {
  double emitted[UM_ANGULAR_MOMENTS + 1], lit[UM_ANGULAR_MOMENTS + 1];
};

static void add_up(const struct rings *r, struct sums *sums)
{
  *sums = (struct sums){{0.0}, {0.0}};
  for (int i = r->first; i < r->end; i++) {
    double p[UM_ANGULAR_MOMENTS + 1] = {1.0};
    um_environment_angular_polynomials(r->cosine[i], p + 1);
    for (int k = 0; k <= UM_ANGULAR_MOMENTS; k++) {
      sums->emitted[k] += r->weight[i] * 2.0 * r->arc[i] * p[k];
      sums->lit[k] += r->weight[i] * r->bright[i] * p[k];
    }
  }
}

void um_environment_earth_moments(const struct um_environment_earth_view *view,
                                  const struct um_environment_earth_azimuths *azimuths,
                                  struct um_vec3 normal, bool lit,
                                  struct um_environment_earth_moments *out)
{
  struct plate plate = plate_of(view, normal);
  struct rings rings = {.first = 0};
  struct sums sums;
  rings_lay(&plate, &rings);
  if (rings.first < rings.end) rings_bound(&plate, &rings);
  if (rings.first < rings.end && lit) rings_light(&plate, azimuths, &rings);
  add_up(&rings, &sums);
  for (int k = 0; k < UM_ANGULAR_MOMENTS; k++) {
    out->planet[k] = sums.emitted[0] > 0.0 ? sums.emitted[k + 1] / sums.emitted[0] : 0.0;
    out->albedo[k] = sums.lit[0] > 0.0 ? sums.lit[k + 1] / sums.lit[0] : 0.0;
  }
}
