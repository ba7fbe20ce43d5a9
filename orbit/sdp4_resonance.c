/* SDP4, resonance of the geopotential with orbits of about one day and half a day.
 *
 * The mean motion n and the resonance angle lambda follow
 *   dn/dt = sum A sin(k_w omega + k_l lambda - phase),   dlambda/dt = n + lambda_dot,
 * integrated from the epoch by Taylor steps of 720 min (Hujsak 1979; STR3 section 7; V06). Every
 * call starts at the epoch, so that a state does not depend on the calls before it. */
#include "orbit/sgp4_impl.h"

#define EARTH_RATE 4.37526908801129966e-3 /* sidereal rotation [rad/min] */
#define STEP       720.0                  /* [min] */

/* Polynomial c0 + c1 e + c2 e^2 + c3 e^3 of an eccentricity function G_lpq. */
struct cubic {
  double c0, c1, c2, c3;
};

static double cubic_at(struct cubic c, double e)
{
  double e2 = e * e;
  return c.c0 + c.c1 * e + c.c2 * e2 + c.c3 * (e * e2);
}

/* G_lpq(e) of Molniya-like orbits, fitted in pieces (STR3). */
struct eccentricity_functions {
  double g201, g211, g310, g322, g410, g422, g520, g521, g532, g533;
};

static struct eccentricity_functions eccentricity_functions(double e)
{
  struct eccentricity_functions g;
  g.g201 = -0.306 - (e - 0.64) * 0.440;
  if (e <= 0.65) {
    g.g211 = cubic_at((struct cubic){3.616, -13.2470, 16.2900, 0.0}, e);
    g.g310 = cubic_at((struct cubic){-19.302, 117.3900, -228.4190, 156.5910}, e);
    g.g322 = cubic_at((struct cubic){-18.9068, 109.7927, -214.6334, 146.5816}, e);
    g.g410 = cubic_at((struct cubic){-41.122, 242.6940, -471.0940, 313.9530}, e);
    g.g422 = cubic_at((struct cubic){-146.407, 841.8800, -1629.014, 1083.4350}, e);
    g.g520 = cubic_at((struct cubic){-532.114, 3017.977, -5740.032, 3708.2760}, e);
  } else {
    g.g211 = cubic_at((struct cubic){-72.099, 331.819, -508.738, 266.724}, e);
    g.g310 = cubic_at((struct cubic){-346.844, 1582.851, -2415.925, 1246.113}, e);
    g.g322 = cubic_at((struct cubic){-342.585, 1554.908, -2366.899, 1215.972}, e);
    g.g410 = cubic_at((struct cubic){-1052.797, 4758.686, -7193.992, 3651.957}, e);
    g.g422 = cubic_at((struct cubic){-3581.690, 16178.110, -24462.770, 12422.520}, e);
    g.g520 = e > 0.715 ? cubic_at((struct cubic){-5149.66, 29936.92, -54087.36, 31324.56}, e)
                       : cubic_at((struct cubic){1464.74, -4664.75, 3763.64, 0.0}, e);
  }
  if (e < 0.7) {
    g.g533 = cubic_at((struct cubic){-919.22770, 4988.6100, -9064.7700, 5542.21}, e);
    g.g521 = cubic_at((struct cubic){-822.71072, 4568.6173, -8491.4146, 5337.524}, e);
    g.g532 = cubic_at((struct cubic){-853.66600, 4690.2500, -8624.7700, 5341.4}, e);
  } else {
    g.g533 = cubic_at((struct cubic){-37995.780, 161616.52, -229838.20, 109377.94}, e);
    g.g521 = cubic_at((struct cubic){-51752.104, 218913.95, -309468.16, 146349.42}, e);
    g.g532 = cubic_at((struct cubic){-40023.880, 170470.89, -242699.48, 115605.82}, e);
  }
  return g;
}

/* F_lmp(i) (Kaula) of the ten half-day terms. */
struct inclination_functions {
  double f220, f221, f321, f322, f441, f442, f522, f523, f542, f543;
};

static struct inclination_functions inclination_functions(double i)
{
  double c = cos(i), s = sin(i), c2 = c * c, s2 = s * s;
  struct inclination_functions f;
  f.f220 = 0.75 * (1.0 + 2.0 * c + c2);
  f.f221 = 1.5 * s2;
  f.f321 = 1.875 * s * (1.0 - 2.0 * c - 3.0 * c2);
  f.f322 = -1.875 * s * (1.0 + 2.0 * c - 3.0 * c2);
  f.f441 = 35.0 * s2 * f.f220;
  f.f442 = 39.3750 * s2 * s2;
  f.f522 =
      9.84375 * s * (s2 * (1.0 - 2.0 * c - 5.0 * c2) + 0.33333333 * (-2.0 + 4.0 * c + 6.0 * c2));
  f.f523 = s * (4.92187512 * s2 * (-2.0 - 4.0 * c + 10.0 * c2) +
                6.56250012 * (1.0 + 2.0 * c - 3.0 * c2));
  f.f542 = 29.53125 * s * (2.0 - 8.0 * c + c2 * (-12.0 + 8.0 * c + 10.0 * c2));
  f.f543 = 29.53125 * s * (-2.0 - 8.0 * c + c2 * (12.0 + 8.0 * c - 10.0 * c2));
  return f;
}

static void half_day_prepare(const struct um_sgp4_elements *o, struct um_sdp4_deep *deep)
{
  /* sqrt(C^2 + S^2) and phase of the geopotential terms (l, m) */
  static const double root22 = 1.7891679e-6, root32 = 3.7393792e-7, root44 = 7.3636953e-9,
                      root52 = 1.1428639e-7, root54 = 2.1765803e-9;
  static const double g22 = 5.7686396, g32 = 0.95240898, g44 = 1.8014998, g52 = 1.0508330,
                      g54 = 4.4108898; /* [rad] */
  struct eccentricity_functions g = eccentricity_functions(o->e);
  struct inclination_functions f = inclination_functions(o->i);
  double inverse_a = pow(o->n / um_sgp4_ke(), 2.0 / 3.0); /* [1/er] */

  /* A_lmpq = k n^2 a^-l root F G, k = 3 (6 for m = 4) */
  double a2 = 3.0 * o->n * o->n * inverse_a * inverse_a;
  double a3 = a2 * inverse_a, a4 = a3 * inverse_a, a5 = a4 * inverse_a;
  const struct um_sdp4_harmonic term[10] = {{a2 * root22 * f.f220 * g.g201, 2, 1, g22},
                                            {a2 * root22 * f.f221 * g.g211, 0, 1, g22},
                                            {a3 * root32 * f.f321 * g.g310, 1, 1, g32},
                                            {a3 * root32 * f.f322 * g.g322, -1, 1, g32},
                                            {2.0 * a4 * root44 * f.f441 * g.g410, 2, 2, g44},
                                            {2.0 * a4 * root44 * f.f442 * g.g422, 0, 2, g44},
                                            {a5 * root52 * f.f522 * g.g520, 1, 1, g52},
                                            {a5 * root52 * f.f523 * g.g532, -1, 1, g52},
                                            {2.0 * a5 * root54 * f.f542 * g.g521, 1, 2, g54},
                                            {2.0 * a5 * root54 * f.f543 * g.g533, -1, 2, g54}};
  for (int k = 0; k < 10; k++) deep->harmonic[k] = term[k];
  deep->harmonics = 10;
}

static void one_day_prepare(const struct um_sgp4_elements *o, struct um_sdp4_deep *deep)
{
  static const double q22 = 1.7891679e-6, q31 = 2.1460748e-6, q33 = 2.2123015e-7;
  static const double phase31 = 0.13130908, phase22 = 2.8843198, phase33 = 0.37448087; /* [rad] */
  double e2 = o->e * o->e, c = cos(o->i), s = sin(o->i), one_plus = 1.0 + c;
  double g200 = 1.0 + e2 * (-2.5 + 0.8125 * e2);
  double g310 = 1.0 + 2.0 * e2;
  double g300 = 1.0 + e2 * (-6.0 + 6.60937 * e2);
  double f220 = 0.75 * one_plus * one_plus;
  double f311 = 0.9375 * s * s * (1.0 + 3.0 * c) - 0.75 * one_plus;
  double f330 = 1.875 * one_plus * one_plus * one_plus;
  double inverse_a = pow(o->n / um_sgp4_ke(), 2.0 / 3.0); /* [1/er] */
  double a2 = 3.0 * o->n * o->n * inverse_a * inverse_a;
  deep->harmonic[0] = (struct um_sdp4_harmonic){a2 * inverse_a * f311 * g310 * q31, 0, 1, phase31};
  deep->harmonic[1] = (struct um_sdp4_harmonic){2.0 * a2 * f220 * g200 * q22, 0, 2, 2.0 * phase22};
  deep->harmonic[2] =
      (struct um_sdp4_harmonic){3.0 * a2 * inverse_a * f330 * g300 * q33, 0, 3, 3.0 * phase33};
  deep->harmonics = 3;
}

void um_orbit_sdp4_resonance_prepare(const struct um_sgp4_elements *epoch,
                                     const struct um_sgp4_secular *secular,
                                     struct um_sdp4_deep *deep)
{
  double n = epoch->n;
  deep->resonance = UM_RESONANCE_NONE;
  if (n > 0.0034906585 && n < 0.0052359877) {
    deep->resonance = UM_RESONANCE_ONE_DAY;
    one_day_prepare(epoch, deep);
    /* lambda = M + omega + Omega - theta */
    deep->lambda0 = fmod(epoch->m + epoch->raan + epoch->argp - deep->gmst0, 2.0 * UM_PI);
    deep->lambda_dot = secular->m_dot + (secular->argp_dot + secular->raan_dot) - EARTH_RATE +
                       deep->m_dot + deep->argp_dot + deep->raan_dot - n;
  } else if (n >= 8.26e-3 && n <= 9.24e-3 && epoch->e >= 0.5) {
    deep->resonance = UM_RESONANCE_HALF_DAY;
    half_day_prepare(epoch, deep);
    /* lambda = M + 2 Omega - 2 theta */
    deep->lambda0 =
        fmod(epoch->m + epoch->raan + epoch->raan - deep->gmst0 - deep->gmst0, 2.0 * UM_PI);
    deep->lambda_dot =
        secular->m_dot + deep->m_dot + 2.0 * (secular->raan_dot + deep->raan_dot - EARTH_RATE) - n;
  }
}

/* Resonance state and its derivatives by time. */
struct resonance {
  double lambda, n;                    /* [rad], [rad/min] */
  double lambda_dot, n_dot, n_dot_dot; /* [rad/min], [rad/min^2], [rad/min^3] */
};

static void derivatives(const struct um_sdp4_deep *deep, double argp, struct resonance *r)
{
  r->lambda_dot = r->n + deep->lambda_dot;
  r->n_dot = 0.0;
  r->n_dot_dot = 0.0;
  for (int k = 0; k < deep->harmonics; k++) {
    const struct um_sdp4_harmonic *h = &deep->harmonic[k];
    double angle = h->k_argp * argp + h->k_lambda * r->lambda - h->phase;
    r->n_dot += h->amplitude * sin(angle);
    r->n_dot_dot += h->k_lambda * h->amplitude * cos(angle);
  }
  r->n_dot_dot *= r->lambda_dot;
}

/* Second-order Taylor step of both. */
static void advance(struct resonance *r, double dt)
{
  r->lambda += r->lambda_dot * dt + r->n_dot * dt * dt * 0.5;
  r->n += r->n_dot * dt + r->n_dot_dot * dt * dt * 0.5;
}

void um_orbit_sdp4_resonance_at(const struct um_sdp4_deep *deep,
                                const struct um_sgp4_elements *epoch, double argp_dot, double t,
                                struct um_sgp4_elements *mean)
{
  if (deep->resonance == UM_RESONANCE_NONE) return;
  double theta = fmod(deep->gmst0 + t * EARTH_RATE, 2.0 * UM_PI);
  double step = t > 0.0 ? STEP : -STEP, at = 0.0;
  struct resonance r = {.lambda = deep->lambda0, .n = epoch->n};
  derivatives(deep, epoch->argp, &r);
  while (fabs(t - at) >= STEP) {
    advance(&r, step);
    at += step;
    derivatives(deep, epoch->argp + argp_dot * at, &r);
  }
  advance(&r, t - at);
  mean->n = r.n;
  /* back from the resonance angle to the mean anomaly */
  mean->m = deep->resonance == UM_RESONANCE_ONE_DAY ? r.lambda - mean->raan - mean->argp + theta
                                                    : r.lambda - 2.0 * mean->raan + 2.0 * theta;
}
