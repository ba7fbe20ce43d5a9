/* Orbit ephemeris messages (OEM, CCSDS 502.0-B-3, section 5, and CNES's) as rows of a table. Each
 * row is turned to GCRS at its own instant. */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "orbit/message_impl.h"
#include "orbit/trajectory_impl.h"

#define ROWS 256 /* room at first */

struct reader {
  struct um_orbit_table *table;
  size_t room;
  bool framed; /* the segment's frame was said */
  enum um_orbit_frame frame;
};

static void begin(void *self)
{
  struct reader *r = self;
  r->framed = false;
}

static enum um_status take_key(const struct um_orbit_message *m, void *self, const char *key,
                               const char *value)
{
  struct reader *r = self;
  if (strcmp(key, "CENTER_NAME") == 0 && strcmp(value, "EARTH") != 0)
    return um_orbit_message_refuse(m, key, value, "EARTH");
  if (strcmp(key, "REF_FRAME") != 0) return UM_OK;
  r->framed = um_orbit_frame_find(value, &r->frame);
  return r->framed ? UM_OK : um_orbit_message_refuse(m, key, value, UM_ORBIT_FRAMES);
}

static enum um_status ready(const struct um_orbit_message *m, void *self)
{
  const struct reader *r = self;
  if (r->framed) return UM_OK;
  return um_core_fail(m->context, UM_ERR_INPUT, "%s:%d: the segment has no REF_FRAME", m->name,
                      m->line);
}

static struct um_vec3 metres(const double km[3])
{
  return um_vec3(1e3 * km[0], 1e3 * km[1], 1e3 * km[2]);
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
  struct um_vec3 at = metres(number), v = metres(number + 3);
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
  UM_TRY(um_orbit_message_blame(
      m, um_orbit_frame_to_gcrs(m->context, m->orientation, r->frame, t_tai, &at, &v)));
  UM_TRY(reserve(m->context, r));
  table->t[table->n] = t_tai;
  table->r[table->n] = at;
  table->v[table->n++] = v;
  return UM_OK;
}

static const struct um_orbit_message_calls calls = {
    .kind = "OEM",
    .stk = UM_ORBIT_STK_EPHEMERIS,
    .form = {.message = "oem",
             .row = "stateVector",
             .fields = {{"X", "km"},
                        {"Y", "km"},
                        {"Z", "km"},
                        {"X_DOT", "km/s"},
                        {"Y_DOT", "km/s"},
                        {"Z_DOT", "km/s"}}},
    .begin = begin,
    .key = take_key,
    .ready = ready,
    .row = take_row,
    .least = 6,
    .most = 9,
    .row_is = "a time, 3 of the place, 3 of the velocity"};

enum um_status um_orbit_oem_read(struct um_context *context, const char *name,
                                 const struct um_orbit_earth_orientation *orientation, char *text,
                                 size_t length, bool *is, struct um_orbit_table *table)
{
  struct reader r = {.table = table};
  struct um_orbit_message m = {
      .context = context, .name = name, .calls = &calls, .self = &r, .orientation = orientation};
  return um_orbit_message_read(&m, text, length, is);
}
