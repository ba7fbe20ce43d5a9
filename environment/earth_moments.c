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

/* max(cos SZA, 0) of the ground in directions d of the plate's frame at azimuths of cosines c and
 * sines s [n], on the ring whose cosine and sine are given. */
UM_WIDE_VECTORS static void lit_at(const struct plate *plate, double cosine, double sine,
                                   const double *c, const double *s, int n, double *out)
{
  double h = plate->h, beneath = h * (plate->s * plate->sun.x + plate->c * plate->sun.z);
  for (int j = 0; j < n; j++) {
    double x = sine * c[j], y = sine * s[j], down = plate->s * x + plate->c * cosine;
    double far = 1.0 - h * h * (1.0 - down * down);
    double tau = h * down - sqrt(far > 0.0 ? far : 0.0);
    double sza = tau * (x * plate->sun.x + y * plate->sun.y + cosine * plate->sun.z) - beneath;
    out[j] = sza > 0.0 ? sza : 0.0;
  }
}

#define DIRECTIONS 64 /* on a ring, at most */

/* Azimuths of Gauss-Legendre's rule on n equal parts of x = -1..1. */
struct azimuths {
  int n;
  bool whole;                          /* the ring is, and they stand evenly */
  double x[DIRECTIONS], w[DIRECTIONS]; /* [8 n] */
  double arc;                          /* of which `c` and `s` are; -1: of none */
  double c[DIRECTIONS], s[DIRECTIONS];
};

static void azimuths_make(bool whole, int n, struct azimuths *out)
{
  out->n = n;
  out->whole = whole;
  out->arc = -1.0;
  for (int j = 0; j < 8 * n; j++) {
    const struct um_environment_gauss *gauss = &um_environment_gauss_8[j % 8];
    int part = j / 8;
    out->x[j] = whole ? (2.0 * j + 1.0) / (8 * n) - 1.0 : 2.0 * (part + gauss->x) / n - 1.0;
    out->w[j] = gauss->w;
  }
}

/* Their cosines and sines on a ring; psi = arc (3 x - x^3)/2 where it ends. Most stand opposite to
 * another. */
static void azimuths_place(struct azimuths *a, double arc)
{
  int n = 8 * a->n;
  double psi[DIRECTIONS];
  if (a->arc == arc) return;
  a->arc = arc;
  for (int j = 0; j < n; j++)
    psi[j] = a->whole ? arc * a->x[j] : 0.5 * arc * a->x[j] * (3.0 - a->x[j] * a->x[j]);
  for (int j = 0; j < n; j++) {
    int opposite = n - 1 - j;
    bool known = opposite < j && psi[opposite] == -psi[j];
    a->c[j] = known ? a->c[opposite] : cos(psi[j]);
    a->s[j] = known ? -a->s[opposite] : sin(psi[j]);
  }
}

/* Integral of max(cos SZA, 0) over |psi| < arc. lit: in how many directions it is day. */
static double lit_ring_by(const struct plate *plate, double cosine, double sine, double arc,
                          struct azimuths *a, int *lit)
{
  int n = a->n;
  double at[DIRECTIONS], sum = 0.0;
  azimuths_place(a, arc);
  lit_at(plate, cosine, sine, a->c, a->s, 8 * n, at);
  *lit = 0;
  for (int j = 0; j < 8 * n; j++) {
    double weight = 0.25 * arc / n;
    if (!a->whole) weight = 3.0 * arc * (1.0 - a->x[j] * a->x[j]) * a->w[j] / n;
    *lit += at[j] > 0.0;
    sum += at[j] * weight;
  }
  return sum;
}

/* A ring that is whole needs twice as many as one that ends, one that the terminator crosses, a
 * kink, eight times. few, many: such rules. */
static double lit_ring(const struct plate *plate, double cosine, double sine, double arc,
                       struct azimuths *few, struct azimuths *many)
{
  int lit;
  double sum = lit_ring_by(plate, cosine, sine, arc, few, &lit);
  return lit == 0 || lit == 8 * few->n ? sum : lit_ring_by(plate, cosine, sine, arc, many, &lit);
}

/* Sums over rings from u = from to to. [0]: of 1, then of the polynomials. */
struct sums {
  double emitted[UM_ANGULAR_MOMENTS + 1], lit[UM_ANGULAR_MOMENTS + 1];
};

static void add_rings(const struct plate *plate, const struct um_environment_gauss *rule, int n,
                      double from, double to, bool whole, bool lit, struct sums *sums)
{
  struct azimuths few, many;
  azimuths_make(whole, whole ? 2 : 1, &few);
  azimuths_make(whole, DIRECTIONS / 8, &many);
  for (int i = 0; i < n; i++) {
    double x = rule[i].x, map = whole ? x : x * x * (3.0 - 2.0 * x);
    double u = from + (to - from) * map, cosine = u * u, sine = sqrt(1.0 - cosine * cosine);
    double weight =
        (to - from) * rule[i].w * (whole ? 1.0 : 6.0 * x * (1.0 - x)) * 2.0 * u * cosine;
    double edge = (plate->cos_rho - cosine * plate->c) / (sine * plate->s);
    double arc = whole ? UM_PI : acos(fmax(-1.0, fmin(1.0, edge)));
    double p[UM_ANGULAR_MOMENTS + 1] = {1.0};
    um_environment_angular_polynomials(cosine, p + 1);
    double bright = lit ? lit_ring(plate, cosine, sine, arc, &few, &many) : 0.0;
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
