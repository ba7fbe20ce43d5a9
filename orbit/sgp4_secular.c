/* SGP4, secular part: Brouwer mean motion from the Kozai one, rates by J2, J2^2 and J4, and the
 * drag polynomials of a power-law atmosphere (Lane & Cranford).
 *
 * References: STR3 section 6; V06; Hoots, Schumacher & Glover 2004, J. Guidance 27:174, whose
 * letters (xi, eta, psi, C1..C5, D2..D4) are kept. */
#include "orbit/sgp4_impl.h"

/* Quantities of the epoch that several steps need. */
struct epoch {
  double theta, theta2, theta4; /* cos i and powers */
  double beta2, beta;           /* 1 - e^2 and its root */
  double p;                     /* semi-latus rectum [er] */
  double con41, con42;          /* 3 theta^2 - 1, 1 - 5 theta^2 */
};

/* Kozai -> Brouwer, STR3 section 6, first block:
 *   delta_1 = 3/4 J2 (3 theta^2 - 1) / (a_1^2 beta^3),
 *   a_0 = a_1 (1 - delta_1/3 - delta_1^2 - 134/81 delta_1^3),  n_0 = n / (1 + delta_0) */
static void mean_motion_recover(const struct um_sgp4_elements *tle, struct epoch *c,
                                struct um_sgp4_secular *s)
{
  c->theta = cos(tle->i);
  c->theta2 = c->theta * c->theta;
  c->theta4 = c->theta2 * c->theta2;
  c->beta2 = 1.0 - tle->e * tle->e;
  c->beta = sqrt(c->beta2);
  c->con41 = 3.0 * c->theta2 - 1.0;
  c->con42 = 1.0 - 5.0 * c->theta2;

  double a1 = pow(um_sgp4_ke() / tle->n, 2.0 / 3.0);
  double j2_term = 0.75 * SGP4_J2 * c->con41 / (c->beta * c->beta2);
  double delta1 = j2_term / (a1 * a1);
  double a_trial =
      a1 * (1.0 - delta1 * delta1 - delta1 * (1.0 / 3.0 + 134.0 * delta1 * delta1 / 81.0));
  s->n0 = tle->n / (1.0 + j2_term / (a_trial * a_trial));
  s->a0 = pow(um_sgp4_ke() / s->n0, 2.0 / 3.0);
  c->p = s->a0 * c->beta2;
}

/* Secular rates by gravity (STR3, M-dot, omega-dot, Omega-dot). */
static void gravity_prepare(const struct epoch *c, struct um_sgp4_secular *s, double *raan_dot_j2)
{
  double inverse_p2 = 1.0 / (c->p * c->p);
  double k1 = 1.5 * SGP4_J2 * inverse_p2 * s->n0;                   /* first order in J2 */
  double k2 = 0.5 * k1 * SGP4_J2 * inverse_p2;                      /* J2^2 */
  double k4 = -0.46875 * SGP4_J4 * inverse_p2 * inverse_p2 * s->n0; /* J4 */

  s->m_dot = s->n0 + 0.5 * k1 * c->beta * c->con41 +
             0.0625 * k2 * c->beta * (13.0 - 78.0 * c->theta2 + 137.0 * c->theta4);
  s->argp_dot = -0.5 * k1 * c->con42 + 0.0625 * k2 * (7.0 - 114.0 * c->theta2 + 395.0 * c->theta4) +
                k4 * (3.0 - 36.0 * c->theta2 + 49.0 * c->theta4);
  *raan_dot_j2 = -k1 * c->theta;
  s->raan_dot =
      *raan_dot_j2 +
      (0.5 * k2 * (4.0 - 19.0 * c->theta2) + 2.0 * k4 * (3.0 - 7.0 * c->theta2)) * c->theta;
}

/* The atmosphere's parameters s [er] and (q0 - s)^4 [er^4] by the height of perigee [km]:
 * s = 78 km above 156 km, perigee - 78 km below, 20 km below 98 km. */
static void atmosphere(double perigee_height, double *s, double *q0_s4)
{
  double s_height = 78.0;
  if (perigee_height < 156.0) s_height = perigee_height < 98.0 ? 20.0 : perigee_height - 78.0;
  double ratio = (120.0 - s_height) / SGP4_RADIUS;
  *q0_s4 = ratio * ratio * ratio * ratio;
  *s = s_height / SGP4_RADIUS + 1.0;
}

/* Terms above t^2 (D2..D4 and the time polynomials of the mean longitude). */
static void drag_high_order(double s_star, double xi, struct um_sgp4_secular *s)
{
  double c1_2 = s->c1 * s->c1;
  s->d2 = 4.0 * s->a0 * xi * c1_2;
  double k = s->d2 * xi * s->c1 / 3.0;
  s->d3 = (17.0 * s->a0 + s_star) * k;
  s->d4 = 0.5 * k * s->a0 * xi * (221.0 * s->a0 + 31.0 * s_star) * s->c1;
  s->t3 = s->d2 + 2.0 * c1_2;
  s->t4 = 0.25 * (3.0 * s->d3 + s->c1 * (12.0 * s->d2 + 10.0 * c1_2));
  s->t5 = 0.2 * (3.0 * s->d4 + 12.0 * s->c1 * s->d3 + 6.0 * s->d2 * s->d2 +
                 15.0 * c1_2 * (2.0 * s->d2 + c1_2));
}

static void drag_prepare(const struct um_sgp4_elements *tle, const struct epoch *c,
                         double raan_dot_j2, struct um_sgp4_secular *s)
{
  double s_star, q0_s4;
  double perigee = s->a0 * (1.0 - tle->e); /* [er] */
  atmosphere((perigee - 1.0) * SGP4_RADIUS, &s_star, &q0_s4);
  s->truncated = perigee < 220.0 / SGP4_RADIUS + 1.0;

  double xi = 1.0 / (s->a0 - s_star);
  double eta = s->a0 * tle->e * xi, eta2 = eta * eta, e_eta = tle->e * eta;
  double psi2 = fabs(1.0 - eta2);
  double k = q0_s4 * xi * xi * xi * xi; /* (q0 - s)^4 xi^4 */
  double k_psi = k / pow(psi2, 3.5);
  double sin_i = sin(tle->i), x1mth2 = 1.0 - c->theta2;

  double c2 = k_psi * s->n0 *
              (s->a0 * (1.0 + 1.5 * eta2 + e_eta * (4.0 + eta2)) +
               0.375 * SGP4_J2 * xi / psi2 * c->con41 * (8.0 + 3.0 * eta2 * (8.0 + eta2)));
  double c3 = 0.0;
  if (tle->e > 1.0e-4) c3 = -2.0 * k * xi * (SGP4_J3 / SGP4_J2) * s->n0 * sin_i / tle->e;
  s->c1 = s->bstar * c2;
  s->c4 = 2.0 * s->n0 * k_psi * s->a0 * c->beta2 *
          (eta * (2.0 + 0.5 * eta2) + tle->e * (0.5 + 2.0 * eta2) -
           SGP4_J2 * xi / (s->a0 * psi2) *
               (-3.0 * c->con41 * (1.0 - 2.0 * e_eta + eta2 * (1.5 - 0.5 * e_eta)) +
                0.75 * x1mth2 * (2.0 * eta2 - e_eta * (1.0 + eta2)) * cos(2.0 * tle->argp)));
  s->c5 = 2.0 * k_psi * s->a0 * c->beta2 * (1.0 + 2.75 * (eta2 + e_eta) + e_eta * eta2);

  s->raan_drag = 3.5 * c->beta2 * raan_dot_j2 * s->c1;
  s->argp_drag = s->bstar * c3 * cos(tle->argp);
  s->m_drag = tle->e > 1.0e-4 ? -2.0 / 3.0 * k * s->bstar / e_eta : 0.0;
  s->t2 = 1.5 * s->c1;
  s->eta = eta;
  double one_plus = 1.0 + eta * cos(tle->m);
  s->cube0 = one_plus * one_plus * one_plus;
  s->sin_m0 = sin(tle->m);
  drag_high_order(s_star, xi, s);
}

void um_orbit_sgp4_secular_prepare(const struct um_sgp4_elements *tle, double bstar,
                                   struct um_sgp4_secular *secular)
{
  struct epoch c;
  double raan_dot_j2;
  *secular = (struct um_sgp4_secular){.bstar = bstar};
  mean_motion_recover(tle, &c, secular);
  gravity_prepare(&c, secular, &raan_dot_j2);
  drag_prepare(tle, &c, raan_dot_j2, secular);
}

/* STR3 section 6, "secular effects of atmospheric drag and gravitation". */
void um_orbit_sgp4_secular_at(const struct um_sgp4_elements *epoch,
                              const struct um_sgp4_secular *secular, double t,
                              struct um_sgp4_elements *mean, struct um_sgp4_drag *drag)
{
  const struct um_sgp4_elements *at0 = epoch;
  const struct um_sgp4_secular *s = secular;
  double t2 = t * t;
  double m_gravity = at0->m + s->m_dot * t, argp_gravity = at0->argp + s->argp_dot * t;
  *mean = *at0;
  mean->m = m_gravity;
  mean->argp = argp_gravity;
  mean->raan = at0->raan + s->raan_dot * t + s->raan_drag * t2;
  drag->axis = 1.0 - s->c1 * t;
  drag->e = s->bstar * s->c4 * t;
  drag->longitude = s->t2 * t2;
  if (s->truncated) return;

  double t3 = t2 * t, t4 = t3 * t;
  double one_plus = 1.0 + s->eta * cos(m_gravity);
  double shift = s->argp_drag * t + s->m_drag * (one_plus * one_plus * one_plus - s->cube0);
  mean->m = m_gravity + shift;
  mean->argp = argp_gravity - shift;
  drag->axis -= s->d2 * t2 + s->d3 * t3 + s->d4 * t4;
  drag->e += s->bstar * s->c5 * (sin(mean->m) - s->sin_m0);
  drag->longitude += s->t3 * t3 + t4 * (s->t4 + t * s->t5);
}
