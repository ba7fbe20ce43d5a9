/* Pole and Earth by time, each instant once.
 *
 * The series of IAU 2000A have 1365 terms, those of the Earth some 2500: 15 and 10 us. A diagnosis
 * follows the orbit for a hundred variants at the same instants. The table is open to collisions
 * within REACH slots and keeps what came first: the scenario itself, before variants that move
 * time. */
#include "orbit/ephemeris.h"

#include <erfa.h>
#include <stdint.h>
#include <string.h>

#include "base/core/sampling.h"
#include "orbit/time.h"

enum { SLOTS = 1 << 15, REACH = 16 };

struct entry {
  double t_tai;
  bool has_cip, has_earth; /* neither: empty */
  struct um_orbit_cip cip;
  struct um_orbit_earth_motion earth;
};

struct um_orbit_ephemeris {
  struct entry slot[SLOTS + REACH];
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

/* The entry of a time, or the empty one that it may have; NULL: no room. */
static struct entry *entry_of(struct um_orbit_ephemeris *ephemeris, double t_tai)
{
  uint64_t bits;
  memcpy(&bits, &t_tai, sizeof bits);
  struct entry *first = &ephemeris->slot[um_core_hash(bits, 0) % SLOTS];
  for (struct entry *e = first; e < first + REACH; e++)
    if (e->t_tai == t_tai || !(e->has_cip || e->has_earth)) return e;
  return NULL;
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

/* What is kept of a time: an entry with neither where nothing is. */
static struct entry recall(struct um_orbit_ephemeris *ephemeris, double t_tai)
{
  struct entry found = {.has_cip = false};
  if (ephemeris == NULL) return found;
#pragma omp critical(um_orbit_ephemeris)
  {
    const struct entry *e = entry_of(ephemeris, t_tai);
    if (e != NULL) found = *e;
  }
  return found;
}

/* Keep one of the two, the other NULL. */
static void keep(struct um_orbit_ephemeris *ephemeris, double t_tai, const struct um_orbit_cip *cip,
                 const struct um_orbit_earth_motion *earth)
{
  if (ephemeris == NULL) return;
#pragma omp critical(um_orbit_ephemeris)
  {
    struct entry *e = entry_of(ephemeris, t_tai);
    if (e != NULL) {
      e->t_tai = t_tai;
      if (cip != NULL) e->cip = *cip;
      if (earth != NULL) e->earth = *earth;
      e->has_cip = e->has_cip || cip != NULL;
      e->has_earth = e->has_earth || earth != NULL;
    }
  }
}

void um_orbit_ephemeris_cip(struct um_orbit_ephemeris *ephemeris, double t_tai,
                            struct um_orbit_cip *out)
{
  struct entry found = recall(ephemeris, t_tai);
  if (found.has_cip) {
    *out = found.cip;
    return;
  }
  cip_series(t_tai, out);
  keep(ephemeris, t_tai, out, NULL);
}

void um_orbit_ephemeris_earth(struct um_orbit_ephemeris *ephemeris, double t_tai,
                              struct um_orbit_earth_motion *out)
{
  struct entry found = recall(ephemeris, t_tai);
  if (found.has_earth) {
    *out = found.earth;
    return;
  }
  earth_series(t_tai, out);
  keep(ephemeris, t_tai, NULL, out);
}
