/* Attitude ephemeris messages (AEM, CCSDS 504.0-B, and CNES's) as rows of a table of quaternions. A
 * message turns frame A into B (A2B) or B into A; one of them is the body's, the other one of
 * orbit/frames.h, from GCRS to which each row is turned at its own instant.
 *
 *   v_B = M(q) v_A,   q = (cos(phi/2), e sin(phi/2)),   as everywhere here (base/core/vec.h)
 *
 * Version 2 of the standard has neither direction nor order: A to B, the scalar last. In XML the
 * components have names, and become a row with the scalar last. */
#include <math.h>
#include <string.h>

#include "orbit/attitude_table_impl.h"
#include "orbit/message_impl.h"

#define ROWS 256 /* room at first */

struct reader {
  struct um_orbit_attitude_table *table;
  size_t room;
  /* of the segment; 0: not said */
  char outer, body; /* 'A', 'B': which frame the body turns in, which is its own */
  char from;        /* 'A', 'B': which one is turned into the other */
  char scalar;      /* 'F' first, 'L' last */
  bool is_quaternion;
  enum um_orbit_frame frame; /* the one that the body turns in */
};

static void begin(void *self)
{
  struct reader *r = self;
  *r = (struct reader){.table = r->table, .room = r->room};
}

static bool is_body(const char *frame)
{
  static const char *const names[] = {"SC_BODY", "SATELLITE", "BODY"};
  for (size_t k = 0; k < sizeof names / sizeof names[0]; k++)
    if (strncmp(frame, names[k], strlen(names[k])) == 0) return true;
  return false;
}

static enum um_status take_frame(const struct um_orbit_message *m, struct reader *r,
                                 const char *key, const char *value)
{
  char which = key[strlen("REF_FRAME_")];
  if (um_orbit_frame_find(value, &r->frame)) {
    r->outer = which;
    return UM_OK;
  }
  if (!is_body(value))
    return um_orbit_message_refuse(m, key, value, UM_ORBIT_FRAMES ", SC_BODY_1, SATELLITE_FRAME");
  r->body = which;
  return UM_OK;
}

static enum um_status take_key(const struct um_orbit_message *m, void *self, const char *key,
                               const char *value)
{
  struct reader *r = self;
  if (strcmp(key, "REF_FRAME_A") == 0 || strcmp(key, "REF_FRAME_B") == 0)
    return take_frame(m, r, key, value);
  if (strcmp(key, "ATTITUDE_DIR") == 0) {
    r->from = value[0];
    if (strcmp(value, "A2B") != 0 && strcmp(value, "B2A") != 0)
      return um_orbit_message_refuse(m, key, value, "A2B, B2A");
  }
  if (strcmp(key, "ATTITUDE_TYPE") == 0) {
    r->is_quaternion = strcmp(value, "QUATERNION") == 0;
    if (!r->is_quaternion) return um_orbit_message_refuse(m, key, value, "QUATERNION");
  }
  if (strcmp(key, "QUATERNION_TYPE") == 0) {
    r->scalar = value[0];
    if (strcmp(value, "FIRST") != 0 && strcmp(value, "LAST") != 0)
      return um_orbit_message_refuse(m, key, value, "FIRST, LAST");
  }
  return UM_OK;
}

static enum um_status missing(const struct um_orbit_message *m, const char *what)
{
  return um_core_fail(m->context, UM_ERR_INPUT, "%s:%d: the segment has no %s", m->name, m->line,
                      what);
}

static enum um_status ready(const struct um_orbit_message *m, void *self)
{
  struct reader *r = self;
  if (m->version >= '2' && r->from == 0) r->from = 'A';
  if (m->version >= '2' && r->scalar == 0) r->scalar = 'L';
  if (r->outer == 0) return missing(m, "frame beside the body's; accepted: REF_FRAME_A or B");
  if (r->body == 0) return missing(m, "frame of the body; accepted: REF_FRAME_A or B");
  if (r->from == 0) return missing(m, "ATTITUDE_DIR");
  if (!r->is_quaternion) return missing(m, "ATTITUDE_TYPE");
  return r->scalar != 0 ? UM_OK : missing(m, "QUATERNION_TYPE");
}

static enum um_status reserve(struct um_context *context, struct reader *r)
{
  struct um_orbit_attitude_table *table = r->table;
  if (table->n < r->room) return UM_OK;
  r->room = r->room == 0 ? ROWS : 2 * r->room;
  UM_TRY(um_core_reallocate(context, r->room, sizeof *table->t, (void **)&table->t));
  return um_core_reallocate(context, r->room, sizeof *table->q, (void **)&table->q);
}

static enum um_status take_row(const struct um_orbit_message *m, void *self, double t_tai,
                               const double *number, size_t count)
{
  struct reader *r = self;
  const double *x = number;
  struct um_mat3 turn;
  (void)count;
  struct um_quat q = r->scalar == 'F' ? (struct um_quat){x[0], x[1], x[2], x[3]}
                                      : (struct um_quat){x[3], x[0], x[1], x[2]};
  double norm = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]);
  if (!(fabs(norm - 1.0) <= UM_ORBIT_ATTITUDE_NORM))
    return um_core_fail(m->context, UM_ERR_INPUT,
                        "%s:%d: the quaternion has norm %.6g, 1 within %g is accepted", m->name,
                        m->line, norm, UM_ORBIT_ATTITUDE_NORM);
  if (r->from != r->outer) q = um_quat_conjugate(q);
  UM_TRY(um_orbit_message_blame(
      m, um_orbit_frame_from_gcrs(m->context, m->orientation, r->frame, t_tai, &turn)));
  q = um_quat_then(um_core_quat_from_matrix(turn), q);
  UM_TRY(reserve(m->context, r));
  r->table->t[r->table->n] = t_tai;
  r->table->q[r->table->n++] = um_quat_normalize(q);
  return UM_OK;
}

static const struct um_orbit_message_calls calls = {
    .kind = "AEM",
    .stk = UM_ORBIT_STK_ATTITUDE,
    .form = {.message = "aem",
             .row = "attitudeState",
             .fields = {{"Q1", NULL}, {"Q2", NULL}, {"Q3", NULL}, {"QC", NULL}},
             .end_of_meta = "QUATERNION_TYPE = LAST"},
    .begin = begin,
    .key = take_key,
    .ready = ready,
    .row = take_row,
    .least = 4,
    .most = 4,
    .row_is = "a time, 4 of a quaternion"};

enum um_status um_orbit_aem_read(struct um_context *context, const char *name,
                                 const struct um_orbit_earth_orientation *orientation, char *text,
                                 size_t length, bool *is, struct um_orbit_attitude_table *table)
{
  struct reader r = {.table = table};
  struct um_orbit_message m = {
      .context = context, .name = name, .calls = &calls, .self = &r, .orientation = orientation};
  return um_orbit_message_read(&m, text, length, is);
}
