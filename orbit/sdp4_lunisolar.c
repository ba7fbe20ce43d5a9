/* SDP4, Sun and Moon: secular rates and long-period periodics by the first-order third-body theory
 * of Hujsak 1979 (Project Space Track report), as written in STR3 section 7 and V06.
 *
 * The perturbing body moves on a fixed ellipse. With A and B its orbit's node-ward axes seen in the
 * satellite's orbital plane (components a1 along the node, a2 across, a5 along the normal; b
 * alike), and their projections X on the satellite's apsides, the averaged disturbing function is a
 * quadratic form in A, B, X: the numbers Z and S below. */
#include "orbit/sgp4_impl.h"

#define ZNS             1.19459e-5   /* mean motion of the Sun [rad/min] */
#define ZES             0.01675      /* eccentricity of the Sun's orbit */
#define ZNL             1.5835218e-4 /* of the Moon [rad/min] */
#define ZEL             0.05490      /* of the Moon */
#define C1_SUN          2.9864797e-6 /* perturbation coefficients [rad/min] */
#define C1_MOON         4.7968065e-7 /* [rad/min] */
#define LOW_INCLINATION 5.2359877e-2 /* 3 deg: node terms are dropped [rad] */
#define LYDDANE_LIMIT   0.2          /* [rad] */

/* Orientation of the perturbing body's orbit relative to the satellite's node. */
struct body_frame {
  double cos_g, sin_g; /* argument of perigee */
  double cos_i, sin_i; /* inclination to the equator */
  double cos_h, sin_h; /* satellite node less the body's node */
};

/* The satellite's ellipse. */
struct ellipse {
  double n, e, e2, beta2; /* [rad/min], [1] */
  double cos_i, sin_i, cos_argp, sin_argp;
};

/* Coefficients of the quadratic forms, letters of STR3 section 7. */
struct third_body {
  double s1, s2, s3, s4, s5, s6, s7;
  double z1, z2, z3, z11, z12, z13, z21, z22, z23, z31, z32, z33;
};

/* A unit vector of the body's orbit in the satellite's plane: node, across, normal; and its
 * projections on the apsides: along perigee, ahead of it, and the normal part split by omega. */
struct projected {
  double node, across, normal;
  double perigee, ahead, normal_sin, normal_cos;
};

static struct projected project(double node, double across_equator, double pole,
                                const struct ellipse *o)
{
  struct projected p;
  p.node = node;
  p.across = o->cos_i * across_equator + o->sin_i * pole;
  p.normal = -o->sin_i * across_equator + o->cos_i * pole;
  p.perigee = p.node * o->cos_argp + p.across * o->sin_argp;
  p.ahead = -p.node * o->sin_argp + p.across * o->cos_argp;
  p.normal_sin = p.normal * o->sin_argp;
  p.normal_cos = p.normal * o->cos_argp;
  return p;
}

static struct third_body third_body(const struct body_frame *f, double c, const struct ellipse *o)
{
  /* STR3: a1, a7, a8 and a3, a9, a10 (rotation by g, i, h), then a2, a5 and a4, a6 */
  struct projected a =
      project(f->cos_g * f->cos_h + f->sin_g * f->cos_i * f->sin_h,
              -f->cos_g * f->sin_h + f->sin_g * f->cos_i * f->cos_h, f->sin_g * f->sin_i, o);
  struct projected b =
      project(-f->sin_g * f->cos_h + f->cos_g * f->cos_i * f->sin_h,
              f->sin_g * f->sin_h + f->cos_g * f->cos_i * f->cos_h, f->cos_g * f->sin_i, o);
  struct third_body t;
  /* Z3j: pure apsidal forms */
  t.z31 = 12.0 * a.perigee * a.perigee - 3.0 * a.ahead * a.ahead;
  t.z32 = 24.0 * a.perigee * b.perigee - 6.0 * a.ahead * b.ahead;
  t.z33 = 12.0 * b.perigee * b.perigee - 3.0 * b.ahead * b.ahead;
  /* Zj: in-plane forms; + (1 - e^2) Z3j doubled as in STR3 */
  double z1 = 3.0 * (a.node * a.node + a.across * a.across) + t.z31 * o->e2;
  double z2 = 6.0 * (a.node * b.node + a.across * b.across) + t.z32 * o->e2;
  double z3 = 3.0 * (b.node * b.node + b.across * b.across) + t.z33 * o->e2;
  t.z1 = z1 + z1 + o->beta2 * t.z31;
  t.z2 = z2 + z2 + o->beta2 * t.z32;
  t.z3 = z3 + z3 + o->beta2 * t.z33;
  /* Z1j: derivative by inclination */
  t.z11 = -6.0 * a.node * a.normal +
          o->e2 * (-24.0 * a.perigee * a.normal_cos - 6.0 * a.ahead * a.normal_sin);
  t.z12 = -6.0 * (a.node * b.normal + b.node * a.normal) +
          o->e2 * (-24.0 * (b.perigee * a.normal_cos + a.perigee * b.normal_cos) -
                   6.0 * (a.ahead * b.normal_sin + b.ahead * a.normal_sin));
  t.z13 = -6.0 * b.node * b.normal +
          o->e2 * (-24.0 * b.perigee * b.normal_cos - 6.0 * b.ahead * b.normal_sin);
  /* Z2j: derivative by node */
  t.z21 = 6.0 * a.across * a.normal +
          o->e2 * (24.0 * a.perigee * a.normal_sin - 6.0 * a.ahead * a.normal_cos);
  t.z22 = 6.0 * (b.across * a.normal + a.across * b.normal) +
          o->e2 * (24.0 * (b.perigee * a.normal_sin + a.perigee * b.normal_sin) -
                   6.0 * (b.ahead * a.normal_cos + a.ahead * b.normal_cos));
  t.z23 = 6.0 * b.across * b.normal +
          o->e2 * (24.0 * b.perigee * b.normal_sin - 6.0 * b.ahead * b.normal_cos);

  double beta = sqrt(o->beta2);
  t.s3 = c / o->n;
  t.s2 = -0.5 * t.s3 / beta;
  t.s4 = t.s3 * beta;
  t.s1 = -15.0 * o->e * t.s4;
  t.s5 = a.perigee * a.ahead + b.perigee * b.ahead;
  t.s6 = b.perigee * a.ahead + a.perigee * b.ahead;
  t.s7 = b.perigee * b.ahead - a.perigee * a.ahead;
  return t;
}

/* Amplitudes of sin, cos combinations of the body's true anomaly (STR3: Se2 .. Sh3). */
static struct um_sdp4_body periodics_of(const struct third_body *t, double e2, double m0, double n,
                                        double e)
{
  return (struct um_sdp4_body){.m0 = m0,
                               .n = n,
                               .e = e,
                               .e2 = 2.0 * t->s1 * t->s6,
                               .e3 = 2.0 * t->s1 * t->s7,
                               .i2 = 2.0 * t->s2 * t->z12,
                               .i3 = 2.0 * t->s2 * (t->z13 - t->z11),
                               .l2 = -2.0 * t->s3 * t->z2,
                               .l3 = -2.0 * t->s3 * (t->z3 - t->z1),
                               .l4 = -2.0 * t->s3 * (-21.0 - 9.0 * e2) * e,
                               .gh2 = 2.0 * t->s4 * t->z32,
                               .gh3 = 2.0 * t->s4 * (t->z33 - t->z31),
                               .gh4 = -18.0 * t->s4 * e,
                               .h2 = -2.0 * t->s2 * t->z22,
                               .h3 = -2.0 * t->s2 * (t->z23 - t->z21)};
}

/* Secular rates of one body, added. */
static void secular_add(const struct third_body *t, double n, const struct ellipse *o, double i,
                        struct um_sdp4_deep *deep)
{
  deep->e_dot += t->s1 * n * t->s5;
  deep->i_dot += t->s2 * n * (t->z11 + t->z13);
  deep->m_dot += -n * t->s3 * (t->z1 + t->z3 - 14.0 - 6.0 * o->e2);
  double gh = t->s4 * n * (t->z31 + t->z33 - 6.0);
  double h = -n * t->s2 * (t->z21 + t->z23);
  if (i < LOW_INCLINATION || i > UM_PI - LOW_INCLINATION) h = 0.0;
  if (o->sin_i != 0.0) h /= o->sin_i;
  deep->argp_dot += gh - o->cos_i * h;
  deep->raan_dot += h;
}

static double wrap(double angle) { return fmod(angle, 2.0 * UM_PI); }

void um_orbit_sdp4_lunisolar_prepare(const struct um_sgp4_elements *epoch, double days_1950,
                                     struct um_sdp4_deep *deep)
{
  /* Obliquity and the Sun's perigee, fixed for all dates (STR3) */
  static const double cos_obliquity = 0.91744867, sin_obliquity = 0.39785416;
  struct body_frame sun = {.cos_g = 0.1945905,
                           .sin_g = -0.98088458,
                           .cos_i = cos_obliquity,
                           .sin_i = sin_obliquity,
                           .cos_h = cos(epoch->raan),
                           .sin_h = sin(epoch->raan)};
  double day = days_1950 + 18261.5; /* since 1899-12-31 12h UTC */

  /* The Moon's orbit on the equator by spherical trigonometry from its node on the ecliptic */
  double node = wrap(4.5236020 - 9.2422029e-4 * day);
  double perigee = 5.8351514 + 0.0019443680 * day;
  double cos_i = 0.91375164 - 0.03568096 * cos(node), sin_i = sqrt(1.0 - cos_i * cos_i);
  double sin_h = 0.089683511 * sin(node) / sin_i, cos_h = sqrt(1.0 - sin_h * sin_h);
  double arc = atan2(sin_obliquity * sin(node) / sin_i,
                     cos_h * cos(node) + cos_obliquity * sin_h * sin(node));
  double g = perigee + arc - node;
  struct body_frame moon = {.cos_g = cos(g),
                            .sin_g = sin(g),
                            .cos_i = cos_i,
                            .sin_i = sin_i,
                            .cos_h = cos_h * sun.cos_h + sin_h * sun.sin_h,
                            .sin_h = sun.sin_h * cos_h - sun.cos_h * sin_h};

  double e2 = epoch->e * epoch->e;
  struct ellipse o = {.n = epoch->n,
                      .e = epoch->e,
                      .e2 = e2,
                      .beta2 = 1.0 - e2,
                      .cos_i = cos(epoch->i),
                      .sin_i = sin(epoch->i),
                      .cos_argp = cos(epoch->argp),
                      .sin_argp = sin(epoch->argp)};
  struct third_body by_sun = third_body(&sun, C1_SUN, &o);
  struct third_body by_moon = third_body(&moon, C1_MOON, &o);
  deep->sun = periodics_of(&by_sun, e2, wrap(6.2565837 + 0.017201977 * day), ZNS, ZES);
  deep->moon = periodics_of(&by_moon, e2, wrap(4.7199672 + 0.22997150 * day - perigee), ZNL, ZEL);
  secular_add(&by_sun, ZNS, &o, epoch->i, deep);
  secular_add(&by_moon, ZNL, &o, epoch->i, deep);
}

/* Long-period shifts of e, i, mean anomaly, argument of perigee plus cos i node, and node. */
struct shift {
  double e, i, l, gh, h;
};

static void periodics_add(const struct um_sdp4_body *b, double t, struct shift *s)
{
  double m = b->m0 + b->n * t;
  double f = m + 2.0 * b->e * sin(m); /* true anomaly to first order */
  double sin_f = sin(f);
  double f2 = 0.5 * sin_f * sin_f - 0.25, f3 = -0.5 * sin_f * cos(f);
  s->e += b->e2 * f2 + b->e3 * f3;
  s->i += b->i2 * f2 + b->i3 * f3;
  s->l += b->l2 * f2 + b->l3 * f3 + b->l4 * sin_f;
  s->gh += b->gh2 * f2 + b->gh3 * f3 + b->gh4 * sin_f;
  s->h += b->h2 * f2 + b->h3 * f3;
}

/* Lyddane 1963: for small inclinations the node is shifted through its Cartesian components
 * sin i sin Omega, sin i cos Omega; the mean longitude takes what the node cannot. */
static void lyddane_apply(const struct shift *s, struct um_sgp4_elements *mean)
{
  double sin_i = sin(mean->i), cos_i = cos(mean->i);
  double sin_node = sin(mean->raan), cos_node = cos(mean->raan);
  double alpha = sin_i * sin_node + s->h * cos_node + s->i * cos_i * sin_node;
  double beta = sin_i * cos_node - s->h * sin_node + s->i * cos_i * cos_node;
  double before = wrap(mean->raan);
  double longitude = mean->m + mean->argp + cos_i * before + s->l + s->gh - s->i * before * sin_i;
  double node = atan2(alpha, beta);
  if (fabs(before - node) > UM_PI) node += node < before ? 2.0 * UM_PI : -2.0 * UM_PI;
  mean->raan = node;
  mean->m += s->l;
  mean->argp = longitude - mean->m - cos_i * node;
}

void um_orbit_sdp4_lunisolar_periodics(const struct um_sdp4_deep *deep, double t,
                                       struct um_sgp4_elements *mean)
{
  struct shift s = {0};
  periodics_add(&deep->sun, t, &s);
  periodics_add(&deep->moon, t, &s);
  mean->i += s.i;
  mean->e += s.e;
  if (mean->i >= LYDDANE_LIMIT) {
    double h = s.h / sin(mean->i);
    mean->argp += s.gh - cos(mean->i) * h;
    mean->raan += h;
    mean->m += s.l;
  } else {
    lyddane_apply(&s, mean);
  }
}
