/* Angular moments of the Earth (angular_moments.h), by rings about the plate's own normal, since
 * the polynomials in u = sqrt(cos(theta)) are constant on each:
 *
 *   int P_k 2 u^3 A du,   A = int L dpsi over |psi| < Psi(theta)
 *   cos(Psi) = (cos(rho) - cos(theta) c) / (sin(theta) s)
 *
 * with rho the angular radius of the Earth, c and s cosine and sine of the tilt t of the plate from
 * nadir. A ring nearer to the normal than rho - t lies on the Earth all round. What the Earth emits
 * is the same all over: A = 2 Psi. What it reflects is max(cos SZA, 0) of the ground that stands in
 * a direction d, p = d tau - h nadir, tau = h d.nadir - sqrt(1 - h^2 (1 - (d.nadir)^2)).
 *
 * Psi begins and ends like a square root, as does the ground at the limb: nodes are laid by 3 x^2 -
 * 2 x^3 in u, Gauss-Legendre's, and by (3 x - x^3)/2 in psi, which are flat at both ends. */
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

/* One number of each of four azimuths. */
typedef double four __attribute__((vector_size(4 * sizeof(double))));

/* Cosine and sine of 0 to pi to 2 ulp of 1, by Taylor's series about pi/2. */
static inline __attribute__((always_inline)) void turn(const four *psi, four *cosine, four *sine)
{
  static const double odd[10] = {-1.0 / 51090942171709440000.0,
                                 1.0 / 121645100408832000.0,
                                 -1.0 / 355687428096000.0,
                                 1.0 / 1307674368000.0,
                                 -1.0 / 6227020800.0,
                                 1.0 / 39916800.0,
                                 -1.0 / 362880.0,
                                 1.0 / 5040.0,
                                 -1.0 / 120.0,
                                 1.0 / 6.0};
  static const double even[11] = {-1.0 / 1124000727777607680000.0,
                                  1.0 / 2432902008176640000.0,
                                  -1.0 / 6402373705728000.0,
                                  1.0 / 20922789888000.0,
                                  -1.0 / 87178291200.0,
                                  1.0 / 479001600.0,
                                  -1.0 / 3628800.0,
                                  1.0 / 40320.0,
                                  -1.0 / 720.0,
                                  1.0 / 24.0,
                                  -1.0 / 2.0};
  four x = *psi - 0.5 * UM_PI, x2 = x * x, c = {0.0}, s = {0.0};
  for (int i = 0; i < 10; i++) c = c * x2 + odd[i];
  for (int i = 0; i < 11; i++) s = s * x2 + even[i];
  *cosine = c * x2 * x - x;
  *sine = s * x2 + 1.0;
}

/* cos SZA of the ground in directions d of the plate's frame at azimuths psi and -psi, tau being
 * the same for both. */
static inline __attribute__((always_inline)) void day_at(const struct plate *plate, double cosine,
                                                         double sine, const four *psi, four *at,
                                                         four *opposite)
{
  double h = plate->h, beneath = h * (plate->s * plate->sun.x + plate->c * plate->sun.z);
  four x, y;
  turn(psi, &x, &y);
  x *= sine;
  y *= sine;
  four down = plate->s * x + plate->c * cosine, far = 1.0 - h * h * (1.0 - down * down);
  for (int l = 0; l < 4; l++) far[l] = far[l] > 0.0 ? sqrt(far[l]) : 0.0;
  four tau = h * down - far, side = tau * y * plate->sun.y;
  four middle = tau * (x * plate->sun.x + cosine * plate->sun.z) - beneath;
  *at = middle + side;
  *opposite = middle - side;
}

#define PARTS 8 /* of x, at most */

/* Azimuths psi > 0 and weights of Gauss-Legendre's rule on n equal parts of x = -1..1, over the arc
 * of the ring; psi = (3 x - x^3)/2 where the ring ends, and evenly where it is whole. */
struct nodes {
  int n; /* of four azimuths: the other half of the parts is -psi */
  four psi[PARTS], weight[PARTS];
};

static void nodes_make(bool whole, int n, struct nodes *out)
{
  out->n = n;
  for (int k = 0; k < 4 * n; k++) {
    int j = 4 * n + k, at = k / 4, l = k % 4;
    const struct um_environment_gauss *gauss = &um_environment_gauss_8[j % 8];
    double x = whole ? (2.0 * j + 1.0) / (8 * n) - 1.0 : 2.0 * (j / 8 + gauss->x) / n - 1.0;
    out->psi[at][l] = whole ? x : 0.5 * x * (3.0 - x * x);
    out->weight[at][l] = whole ? 0.25 / n : 3.0 * (1.0 - x * x) * gauss->w / n;
  }
}

/* Integral of max(cos SZA, 0) over |psi| < arc. lit: in how many of the 8 n directions it is day.
 */
UM_WIDE_VECTORS static double lit_ring_by(const struct plate *plate, double cosine, double sine,
                                          double arc, const struct nodes *nodes, int *lit)
{
  four sum = {0.0};
  *lit = 0;
  for (int k = 0; k < nodes->n; k++) {
    four at, opposite, psi = nodes->psi[k] * arc;
    day_at(plate, cosine, sine, &psi, &at, &opposite);
    for (int l = 0; l < 4; l++) {
      *lit += (at[l] > 0.0) + (opposite[l] > 0.0);
      at[l] = (at[l] > 0.0 ? at[l] : 0.0) + (opposite[l] > 0.0 ? opposite[l] : 0.0);
    }
    sum += nodes->weight[k] * at;
  }
  return arc * (sum[0] + sum[1] + (sum[2] + sum[3]));
}

/* A ring that is whole needs twice as many, one that the terminator crosses, a kink, eight times.
 */
static double lit_ring(const struct plate *plate, double cosine, double sine, double arc,
                       const struct nodes nodes[2])
{
  int lit;
  double sum = lit_ring_by(plate, cosine, sine, arc, &nodes[0], &lit);
  return lit == 0 || lit == 8 * nodes[0].n ? sum
                                           : lit_ring_by(plate, cosine, sine, arc, &nodes[1], &lit);
}

/* Sums over rings from u = from to to. [0]: of 1, then of the polynomials. */
struct sums {
  double emitted[UM_ANGULAR_MOMENTS + 1], lit[UM_ANGULAR_MOMENTS + 1];
};

static void add_rings(const struct plate *plate, const struct um_environment_gauss *rule, int n,
                      double from, double to, bool whole, bool lit, struct sums *sums)
{
  struct nodes nodes[2];
  nodes_make(whole, whole ? 2 : 1, &nodes[0]);
  nodes_make(whole, PARTS, &nodes[1]);
  for (int i = 0; i < n; i++) {
    double x = rule[i].x, map = whole ? x : x * x * (3.0 - 2.0 * x);
    double u = from + (to - from) * map, cosine = u * u, sine = sqrt(1.0 - cosine * cosine);
    double weight =
        (to - from) * rule[i].w * (whole ? 1.0 : 6.0 * x * (1.0 - x)) * 2.0 * u * cosine;
    double edge = (plate->cos_rho - cosine * plate->c) / (sine * plate->s);
    double arc = whole ? UM_PI : acos(fmax(-1.0, fmin(1.0, edge)));
    double p[UM_ANGULAR_MOMENTS + 1] = {1.0};
    um_environment_angular_polynomials(cosine, p + 1);
    double bright = lit ? lit_ring(plate, cosine, sine, arc, nodes) : 0.0;
    for (int k = 0; k <= UM_ANGULAR_MOMENTS; k++) {
      sums->emitted[k] += weight * 2.0 * arc * p[k];
      sums->lit[k] += weight * bright * p[k];
    }
  }
}

void um_environment_earth_moments(const struct um_environment_earth_view *view,
                                  struct um_vec3 normal, bool lit,
                                  struct um_environment_earth_moments *out)
{
  struct plate plate = plate_of(view, normal);
  double tilt = atan2(plate.s, plate.c), rho = atan2(1.0 / view->h, plate.cos_rho);
  double near = sqrt(fmax(0.0, cos(tilt - rho))), far = sqrt(fmax(0.0, cos(tilt + rho)));
  struct sums sums = {{0.0}, {0.0}};
  if (tilt < rho) add_rings(&plate, um_environment_gauss_8, 8, near, 1.0, true, lit, &sums);
  if (far < near && plate.s > 1e-8)
    add_rings(&plate, um_environment_gauss_16, 16, far, near, false, lit, &sums);
  for (int k = 0; k < UM_ANGULAR_MOMENTS; k++) {
    out->planet[k] = sums.emitted[0] > 0.0 ? sums.emitted[k + 1] / sums.emitted[0] : 0.0;
    out->albedo[k] = sums.lit[0] > 0.0 ? sums.lit[k + 1] / sums.lit[0] : 0.0;
  }
}
