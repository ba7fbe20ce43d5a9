/* Orbit ephemeris messages (OEM, CCSDS 502.0-B-3, section 5, and CNES's) as rows of a table.
 * EME2000 differs from GCRS by the bias of its frame,
 *
 *   r_GCRS = B^T r_EME2000   (IERS Conventions 2010, 5.6; 0.023 arcsec, 0.8 m of a low orbit). */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "orbit/message_impl.h"
#include "orbit/trajectory_impl.h"

#define ROWS 256 /* room at first */

struct reader {
  struct um_orbit_table *table;
  size_t room;
  bool framed, biased; /* of the segment: its frame was said, is EME2000 */
};

static void begin(void *self)
{
  struct reader *r = self;
  r->framed = r->biased = false;
}

static enum um_status take_key(const struct um_orbit_message *m, void *self, const char *key,
                               const char *value)
{
  struct reader *r = self;
  if (strcmp(key, "CENTER_NAME") == 0 && strcmp(value, "EARTH") != 0)
    return um_orbit_message_refuse(m, key, value, "EARTH");
  if (strcmp(key, "REF_FRAME") != 0) return UM_OK;
  r->framed = um_orbit_message_is_inertial(value, &r->biased);
  return r->framed ? UM_OK : um_orbit_message_refuse(m, key, value, "GCRF, ICRF, EME2000");
}

static enum um_status ready(const struct um_orbit_message *m, void *self)
{
  const struct reader *r = self;
  if (r->framed) return UM_OK;
  return um_core_fail(m->context, UM_ERR_INPUT, "%s:%d: the segment has no REF_FRAME", m->name,
                      m->line);
}

static struct um_vec3 in_gcrs(const struct um_orbit_message *m, bool biased, const double x[3])
{
  double out[3] = {x[0], x[1], x[2]};
  for (int k = 0; k < 3 && biased; k++)
    out[k] = m->bias[0][k] * x[0] + m->bias[1][k] * x[1] + m->bias[2][k] * x[2];
  return um_vec3(1e3 * out[0], 1e3 * out[1], 1e3 * out[2]);
}

static enum um_status reserve(struct um_context *context, struct reader *r)
{
  struct um_orbit_table *table = r->table;
  if (table->n < r->room) return UM_OK;
  r->room = r->room == 0 ? ROWS : 2 * r->room;
  UM_TRY(um_core_reallocate(context, r->room, sizeof *table->t, (void **)&table->t));
  UM_TRY(um_core_reallocate(context, r->room, sizeof *table->r, (void **)&table->r));
  return um_core_reallocate(context, r->room, sizeof *table->v, (void **)&table->v);
}

/* Place [km], velocity [km/s]; accelerations behind them are not needed. */
static enum um_status take_row(const struct um_orbit_message *m, void *self, double t_tai,
                               const double *number, size_t count)
{
  struct reader *r = self;
  struct um_orbit_table *table = r->table;
  (void)count;
  struct um_vec3 at = in_gcrs(m, r->biased, number), v = in_gcrs(m, r->biased, number + 3);
  double distance = um_vec3_norm(at);
  if (!(distance >= UM_ORBIT_NEAREST && distance <= UM_ORBIT_FARTHEST))
    return um_core_fail(m->context, UM_ERR_INPUT,
                        "%s:%d: the position is %g km from the geocentre; accepted: %g to %g km",
                        m->name, m->line, 1e-3 * distance, 1e-3 * UM_ORBIT_NEAREST,
                        1e-3 * UM_ORBIT_FARTHEST);
  if (!(um_vec3_norm(v) < UM_LIGHT_SPEED))
    return um_core_fail(m->context, UM_ERR_INPUT,
                        "%s:%d: the speed is %g km/s; accepted: less than light's", m->name,
                        m->line, 1e-3 * um_vec3_norm(v));
  UM_TRY(reserve(m->context, r));
  table->t[table->n] = t_tai;
  table->r[table->n] = at;
  table->v[table->n++] = v;
  return UM_OK;
}

static const struct um_orbit_message_calls calls = {
    .begin = begin,
    .key = take_key,
    .ready = ready,
    .row = take_row,
    .least = 6,
    .most = 9,
    .row_is = "a time, 3 of the place, 3 of the velocity"};

enum um_status um_orbit_oem_read(struct um_context *context, const char *name, char *text,
                                 int before, struct um_orbit_table *table)
{
  struct reader r = {.table = table};
  struct um_orbit_message m = {
      .context = context, .name = name, .calls = &calls, .self = &r, .line = -before};
  return um_orbit_message_read(&m, text);
}
