/* Pole and Earth by time, between nodes.
 *
 * The series of IAU 2000A have 1365 terms, those of the Earth some 2500: 15 and 10 us. Both hold
 * nothing faster than days, so that a cubic through four nodes,
 *
 *   f(t) = sum over k = -1..2 of f(t_(i+k)) L_k(u),   u = (t - t_i)/STEP in [0, 1),
 *
 * is off by 3/128 (omega STEP)^4 of a term: 2 mm of the Earth's way (by the month, 4700 km, and by
 * the year), 1e-9 arcsec of the pole (by half a month, 0.1 arcsec). A diagnosis follows the orbit
 * for a hundred variants, some of which move time. */
#include "orbit/ephemeris.h"

#include <erfa.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "orbit/time.h"

#define STEP  3600.0 /* [s] */
#define SLOTS 4096   /* 170 days, before one takes the place of another */
#define REACH 1e12   /* nodes are within; beyond, and of no time at all, the series answer [s] */

struct node {
  int64_t number; /* of STEP since t_tai = 0 */
  bool known;
  struct um_orbit_cip cip;
  struct um_orbit_earth_motion earth;
};

struct um_orbit_ephemeris {
  struct node slot[SLOTS];
};

enum um_status um_orbit_ephemeris_create(struct um_context *context,
                                         struct um_orbit_ephemeris **out)
{
  return um_core_allocate(context, 1, sizeof **out, out);
}

void um_orbit_ephemeris_destroy(struct um_context *context, struct um_orbit_ephemeris **ephemeris)
{
  if (ephemeris == NULL) return;
  um_core_free(context, *ephemeris);
  *ephemeris = NULL;
}

static void cip_series(double t_tai, struct um_orbit_cip *out)
{
  double tt[2];
  um_orbit_time_tt(t_tai, tt);
  eraXys06a(tt[0], tt[1], &out->x, &out->y, &out->s);
}

static void earth_series(double t_tai, struct um_orbit_earth_motion *out)
{
  double tt[2], heliocentric[2][3], barycentric[2][3];
  um_orbit_time_tt(t_tai, tt);
  eraEpv00(tt[0], tt[1], heliocentric, barycentric);
  memcpy(out->r, heliocentric[0], sizeof out->r);
  memcpy(out->v, heliocentric[1], sizeof out->v);
  memcpy(out->v_b, barycentric[1], sizeof out->v_b);
}

static const struct node *node_of(struct um_orbit_ephemeris *ephemeris, int64_t number)
{
  struct node *n = &ephemeris->slot[(uint64_t)number % SLOTS];
  if (n->known && n->number == number) return n;
  cip_series((double)number * STEP, &n->cip);
  earth_series((double)number * STEP, &n->earth);
  n->number = number;
  n->known = true;
  return n;
}

/* The four nodes about a time, and what each counts. */
static void nodes_about(struct um_orbit_ephemeris *ephemeris, double t_tai, struct node node[4],
                        double weight[4])
{
  double first = floor(t_tai / STEP), u = t_tai / STEP - first;
  weight[0] = -u * (u - 1.0) * (u - 2.0) / 6.0;
  weight[1] = (u + 1.0) * (u - 1.0) * (u - 2.0) / 2.0;
  weight[2] = -(u + 1.0) * u * (u - 2.0) / 2.0;
  weight[3] = (u + 1.0) * u * (u - 1.0) / 6.0;
#pragma omp critical(um_orbit_ephemeris)
  for (int k = 0; k < 4; k++) node[k] = *node_of(ephemeris, (int64_t)first + k - 1);
}

void um_orbit_ephemeris_cip(struct um_orbit_ephemeris *ephemeris, double t_tai,
                            struct um_orbit_cip *out)
{
  struct node node[4];
  double weight[4];
  if (ephemeris == NULL || !(fabs(t_tai) < REACH)) {
    cip_series(t_tai, out);
    return;
  }
  nodes_about(ephemeris, t_tai, node, weight);
  *out = (struct um_orbit_cip){.x = 0.0};
  for (int k = 0; k < 4; k++) {
    out->x += weight[k] * node[k].cip.x;
    out->y += weight[k] * node[k].cip.y;
    out->s += weight[k] * node[k].cip.s;
  }
}

void um_orbit_ephemeris_earth(struct um_orbit_ephemeris *ephemeris, double t_tai,
                              struct um_orbit_earth_motion *out)
{
  struct node node[4];
  double weight[4];
  if (ephemeris == NULL || !(fabs(t_tai) < REACH)) {
    earth_series(t_tai, out);
    return;
  }
  nodes_about(ephemeris, t_tai, node, weight);
  *out = (struct um_orbit_earth_motion){.r = {0.0}};
  for (int k = 0; k < 4; k++)
    for (int i = 0; i < 3; i++) {
      out->r[i] += weight[k] * node[k].earth.r[i];
      out->v[i] += weight[k] * node[k].earth.v[i];
      out->v_b[i] += weight[k] * node[k].earth.v_b[i];
    }
}
