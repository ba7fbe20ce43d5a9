/* What the Earth sends to plates: a Lambert sphere of uniform albedo and outgoing longwave; what
 * differs from place to place comes on top (earth_varied.c).
 *
 * Emitted: OLR times the plate-Earth view factor, in closed form (Howell, catalogue of radiation
 * configuration factors, plate to sphere; Juul 1979, Lett. Heat Mass Transfer 6:513).
 *
 * Reflected: E(n) = (a S / pi) * integral over the visible cap of max(cos SZA, 0) max(n.d, 0)
 * dOmega. The cap ends at the Earth-central angle acos(R/r). On a ring of directions d around the
 * nadir both factors are of the form a + b cos(phi), each positive on one arc of azimuth, so that
 * the integral over phi is elementary, kinks included. Across the rings it is Gauss-Legendre in
 * w = cos(e), e the angle at the ground between zenith and satellite, in which all is analytic
 * from the nadir, w = 1, to the limb, w = 0:
 *
 *   sin(theta) = sin(e)/h,  psi = e - theta,  dOmega = w / (h^2 cos(theta)) dw dphi
 *
 * The range is split where the terminator first touches a ring and begins where the plate's horizon
 * does; from there the integrand grows like (w_t - w)^(3/2), so nodes are laid in sqrt(w_t - w).
 * Only plates turned away from the nadir are integrated: with the vector flux V, the integral of
 * max(cos SZA, 0) d dOmega, the others follow from E(n) = E(-n) + (a S / pi) n.V. */
#include "environment/environment.h"

#include <math.h>
#include <stdbool.h>

#include "base/core/constants.h"
#include "environment/earth_moments_impl.h"
#include "environment/earth_varied_impl.h"
#include "environment/quadrature_impl.h"

/* The w of the ring that the terminator touches, psi = |pi/2 - sigma|; -1 if beyond the limb. */
static double terminator_find(const struct um_environment_earth_view *view)
{
  double c = view->sin_zenith, s = fabs(view->cos_zenith); /* of psi */
  if (c * view->h <= 1.0) return -1.0;
  /* at the ground, the satellite stands at cos(e) = (h cos(psi) - 1)/distance */
  return (view->h * c - 1.0) / hypot(view->h * s, view->h * c - 1.0);
}

/* Nodes in w from `from` down to `to`; crowded at `from` when the integrand starts there like a
 * power 3/2. */
struct span {
  double from, to;
  bool root;
};

static double span_node(struct span span, struct um_environment_gauss gauss, double *weight)
{
  double x = gauss.x, width = span.from - span.to;
  *weight = gauss.w * width * (span.root ? 2.0 * x : 1.0);
  return span.from - width * (span.root ? x * x : x);
}

/* The lit part of the rings from w = `start` to the limb, in one span or two. */
static int spans_find(const struct um_environment_earth_view *view, double terminator, double start,
                      bool root, struct span spans[2])
{
  bool day = view->cos_zenith > 0.0; /* the rings inside the terminator are lit all round */
  if (terminator < 0.0) {
    spans[0] = (struct span){start, 0.0, root};
    return day ? 1 : 0;
  }
  if (terminator >= start) {
    spans[0] = (struct span){start, 0.0, true};
    return 1;
  }
  int count = 0;
  if (day) spans[count++] = (struct span){start, terminator, root};
  spans[count++] = (struct span){terminator, 0.0, true};
  return count;
}

/* A plate's normal in the frame of the rings. */
struct plate {
  double c, s;                /* cosine and sine of its tilt from nadir [1] */
  double delta, cos_d, sin_d; /* its azimuth from the Sun's, 0..pi [rad] */
};

static struct plate plate_of(const struct um_environment_earth_view *view, struct um_vec3 normal)
{
  struct plate plate = {.c = um_vec3_dot(normal, view->nadir), .cos_d = 1.0};
  double x = um_vec3_dot(normal, view->sunward), y = um_vec3_dot(normal, view->side);
  plate.s = sqrt(x * x + y * y);
  if (plate.s > 0.0) {
    plate.cos_d = x / plate.s;
    plate.sin_d = fabs(y) / plate.s;
    plate.delta = acos(fmin(fmax(plate.cos_d, -1.0), 1.0));
  }
  return plate;
}

/* The plate's back. */
static struct plate plate_opposite(struct plate plate)
{
  return (struct plate){-plate.c, plate.s, UM_PI - plate.delta, -plate.cos_d, plate.sin_d};
}

/* Integral over phi of (p + q cos(phi)) (a + b cos(phi - delta)), at an end given by the angle, its
 * cosine and its sine:
 *   a p phi + b p sin(phi - delta) + a q sin(phi)
 *   + b q (phi cos(delta) / 2 + sin(2 phi - delta) / 4) */
static double primitive(const struct um_environment_earth_ring *ring, double p, double q,
                        const struct plate *plate, double phi, double c, double s)
{
  double sd = s * plate->cos_d - c * plate->sin_d; /* sin(phi - delta) */
  double cd = c * plate->cos_d + s * plate->sin_d;
  double s2d = s * cd + c * sd; /* sin(2 phi - delta) */
  return ring->a * (p * phi + q * s) +
         ring->b * (p * sd + q * (0.5 * phi * plate->cos_d + 0.25 * s2d));
}

/* Integral over phi of max(cos SZA, 0) max(n.d, 0) on one ring; phi from the plate's azimuth. The
 * plate's arc |phi| < alpha and the lit arc |phi - delta| < gamma meet in one piece or two. */
static double ring_flux(const struct um_environment_earth_ring *ring, const struct plate *plate)
{
  double p = plate->c * ring->z, q = plate->s * ring->x;
  if (p <= -q) return 0.0;
  double alpha, ca, sa;
  um_environment_earth_arc(p, q, &alpha, &ca, &sa);
  double first = plate->delta - ring->gamma, last = plate->delta + ring->gamma, sum = 0.0;
  double at_minus_alpha = primitive(ring, p, q, plate, -alpha, ca, -sa);
  double at_alpha = primitive(ring, p, q, plate, alpha, ca, sa);
  if (ring->cos_gamma <= -1.0) return at_alpha - at_minus_alpha; /* lit all round */
  /* cosine and sine of delta -+ gamma */
  double cf = plate->cos_d * ring->cos_gamma + plate->sin_d * ring->sin_gamma;
  double sf = plate->sin_d * ring->cos_gamma - plate->cos_d * ring->sin_gamma;
  double cl = plate->cos_d * ring->cos_gamma - plate->sin_d * ring->sin_gamma;
  double sl = plate->sin_d * ring->cos_gamma + plate->cos_d * ring->sin_gamma;
  if (first < alpha) {
    double low = first > -alpha ? primitive(ring, p, q, plate, first, cf, sf) : at_minus_alpha;
    double high = last < alpha ? primitive(ring, p, q, plate, last, cl, sl) : at_alpha;
    sum += high - low; /* last >= 0 > -alpha */
  }
  /* the lit arc comes round the back: one turn lower */
  double turned = last - 2.0 * UM_PI;
  if (turned > -alpha) {
    double high = turned < alpha ? primitive(ring, p, q, plate, turned, cl, sl) : at_alpha;
    sum += high - at_minus_alpha;
  }
  return sum;
}

/* Vector flux V of the lit cap, toward nadir and sunward. */
static void vector_flux(const struct um_environment_earth_view *view, double terminator,
                        double *nadir, double *sunward)
{
  struct span spans[2];
  int count = spans_find(view, terminator, 1.0, false, spans);
  *nadir = *sunward = 0.0;
  for (int k = 0; k < count; k++)
    for (int i = 0; i < 16; i++) {
      double weight, w = span_node(spans[k], um_environment_gauss_16[i], &weight);
      struct um_environment_earth_ring ring = um_environment_earth_ring(view, w);
      double g = ring.gamma, s = ring.sin_gamma, c = ring.cos_gamma;
      weight *= ring.solid_angle;
      *nadir += weight * ring.z * 2.0 * (ring.a * g + ring.b * s);
      *sunward += weight * ring.x * (2.0 * ring.a * s + ring.b * (g + s * c));
    }
}

/* Integral of max(cos SZA, 0) max(n.d, 0) dOmega for a plate turned away from the nadir, c <= 0,
 * whose horizon crosses the cap: it sees the rings of theta beyond pi/2 from its normal. */
static double away_flux(const struct um_environment_earth_view *view, double terminator,
                        const struct plate *plate)
{
  double sine = fmin(-view->h * plate->c, 1.0); /* sin(theta) = |c| = sin(e)/h */
  struct span spans[2];
  int count = spans_find(view, terminator, sqrt((1.0 - sine) * (1.0 + sine)), true, spans);
  double sum = 0.0;
  for (int k = 0; k < count; k++)
    for (int i = 0; i < 8; i++) {
      double weight, w = span_node(spans[k], um_environment_gauss_8[i], &weight);
      struct um_environment_earth_ring ring = um_environment_earth_ring(view, w);
      if (ring.gamma > 0.0) sum += weight * ring.solid_angle * ring_flux(&ring, plate);
    }
  return sum;
}

/* Howell; Juul 1979. h = r/R, c = cosine of the tilt from nadir. */
static double plate_view_factor(double h, double c)
{
  double h2 = h * h, root = sqrt(fmax(h2 - 1.0, 0.0));
  double s = sqrt(fmax((1.0 - c) * (1.0 + c), 0.0));
  if (isnan(c)) return NAN;
  /* the whole Earth is before the plate, tilt <= acos(1/h), or behind it */
  if (h * s <= root) return c > 0.0 ? c / h2 : 0.0;
  double kept = c * acos(fmin(fmax(-root * c / s, -1.0), 1.0));
  double lost = root * sqrt(fmax(1.0 - h2 * c * c, 0.0));
  return 0.5 - asin(fmin(root / (h * s), 1.0)) / UM_PI + (kept - lost) / (UM_PI * h2);
}

double um_environment_plate_view_factor(double h_ratio, double tilt)
{
  return plate_view_factor(fmax(h_ratio, 1.0), cos(tilt));
}

double um_environment_sphere_view_factor(double h_ratio)
{
  double h = fmax(h_ratio, 1.0), x = 1.0 / (h * h);
  return 0.5 * x / (1.0 + sqrt(1.0 - x)); /* (1 - sqrt(1 - 1/h^2)) / 2 */
}

/* Reflected sunlight that a plate gets from the lit cap per albedo and per S/pi [sr]. */
struct lit_cap {
  struct um_environment_earth_view view;
  double terminator, limb; /* w; sine of the tilt that touches the Earth */
  double nadir, sunward;   /* of the vector flux V [sr] */
};

static struct lit_cap lit_cap(const struct um_environment *environment, struct um_vec3 r,
                              struct um_vec3 sun)
{
  struct lit_cap cap = {.view = um_environment_earth_view(environment, r, sun)};
  cap.terminator = terminator_find(&cap.view);
  vector_flux(&cap.view, cap.terminator, &cap.nadir, &cap.sunward);
  cap.limb = sqrt(fmax(1.0 - 1.0 / (cap.view.h * cap.view.h), 0.0));
  return cap;
}

static double lit_flux(const struct lit_cap *cap, struct um_vec3 normal)
{
  struct plate plate = plate_of(&cap->view, normal);
  double sum = isnan(plate.c + cap->view.cos_zenith) ? NAN : 0.0;
  if (plate.c > 0.0) { /* E(n) = E(-n) + n.V */
    sum = plate.c * cap->nadir + plate.s * plate.cos_d * cap->sunward;
    plate = plate_opposite(plate);
  }
  if (plate.s > cap->limb) sum += away_flux(&cap->view, cap->terminator, &plate);
  return sum < 0.0 ? 0.0 : sum;
}

static void scale(double *x, double factor)
{
  for (int k = 0; k < UM_ANGULAR_MOMENTS; k++) x[k] *= factor;
}

/* Moments of the uniform Earth whose fluxes a plate gets. */
static void uniform_moments(const struct lit_cap *cap,
                            const struct um_environment_earth_azimuths *azimuths,
                            struct um_vec3 normal, double albedo, double planet,
                            struct um_environment_earth_moments *out)
{
  um_environment_earth_moments(&cap->view, azimuths, normal, albedo > 0.0, out);
  scale(out->albedo, albedo);
  scale(out->planet, planet);
}

/* The uniform Earth of the cap's means, and cell by cell what differs from it. */
static void varied_flux(const struct um_environment_ground_view *ground, const struct lit_cap *cap,
                        double irradiance, const struct um_vec3 *normals, size_t n,
                        struct um_environment_earth_flux *out,
                        struct um_environment_earth_moments *moments)
{
  struct um_environment_varied varied;
  struct um_environment_earth_azimuths azimuths = {0};
  um_environment_varied_make(&cap->view, ground, &varied);
  if (moments != NULL) azimuths = um_environment_earth_azimuths(&cap->view);
  for (size_t i = 0; i < n; i++) {
    double albedo, planet;
    um_environment_varied_plate(&varied, normals[i], &albedo, &planet, &out[i].brightness);
    double uniform = varied.albedo * lit_flux(cap, normals[i]);
    albedo += uniform;
    out[i].albedo = irradiance / UM_PI * (albedo < 0.0 ? 0.0 : albedo);
    out[i].view_factor = plate_view_factor(cap->view.h, um_vec3_dot(normals[i], cap->view.nadir));
    planet += varied.longwave * out[i].view_factor;
    out[i].planet = planet < 0.0 || out[i].view_factor == 0.0 ? 0.0 : planet;
    if (moments == NULL) continue;
    uniform_moments(cap, &azimuths, normals[i], uniform, varied.longwave * out[i].view_factor,
                    &moments[i]);
    um_environment_varied_moments(&varied, normals[i], &moments[i]);
    scale(moments[i].albedo, out[i].albedo > 0.0 ? irradiance / UM_PI : 0.0);
    scale(moments[i].planet, out[i].planet > 0.0 ? 1.0 : 0.0);
  }
}

void um_environment_earth_flux_by_angle(const struct um_environment *environment,
                                        const struct um_environment_globe *globe, struct um_vec3 r,
                                        struct um_vec3 sun, double distance,
                                        const struct um_vec3 *normals, size_t n,
                                        struct um_environment_earth_flux *out,
                                        struct um_environment_earth_moments *moments)
{
  struct lit_cap cap = lit_cap(environment, r, sun);
  double irradiance = um_environment_solar_irradiance(environment, distance);
  if (globe != NULL && um_environment_earth_varies(environment)) {
    struct um_environment_ground_view ground =
        um_environment_ground_view(environment, globe, distance);
    varied_flux(&ground, &cap, irradiance, normals, n, out, moments);
    return;
  }
  struct um_environment_earth_azimuths azimuths = {0};
  if (moments != NULL) azimuths = um_environment_earth_azimuths(&cap.view);
  double of_albedo = environment->albedo * irradiance / UM_PI;
  for (size_t i = 0; i < n; i++) {
    out[i].albedo = of_albedo * lit_flux(&cap, normals[i]);
    out[i].view_factor = plate_view_factor(cap.view.h, um_vec3_dot(normals[i], cap.view.nadir));
    out[i].planet = environment->outgoing_longwave * out[i].view_factor;
    out[i].brightness = environment->brightness_temperature;
    if (moments != NULL)
      uniform_moments(&cap, &azimuths, normals[i], out[i].albedo, out[i].planet, &moments[i]);
  }
}

void um_environment_earth_flux(const struct um_environment *environment,
                               const struct um_environment_globe *globe, struct um_vec3 r,
                               struct um_vec3 sun, double distance, const struct um_vec3 *normals,
                               size_t n, struct um_environment_earth_flux *out)
{
  um_environment_earth_flux_by_angle(environment, globe, r, sun, distance, normals, n, out, NULL);
}
