/* Private to orbit/: messages of CCSDS and CNES, in segments of keywords and rows, whatever they
 * are written in. */
#ifndef UMBRA_ORBIT_MESSAGE_IMPL_H
#define UMBRA_ORBIT_MESSAGE_IMPL_H

#include "base/core/context.h"
#include "base/core/vec.h"
#include "orbit/frames.h"
#include "orbit/ndm.h"
#include "orbit/stk_impl.h"

#define UM_ORBIT_MESSAGE_WORDS 12 /* of a row, at most */

/* Where in a message a line stands. */
enum um_orbit_message_place { UM_ORBIT_HEADER, UM_ORBIT_META, UM_ORBIT_ROWS, UM_ORBIT_COVARIANCE };

/* A message while it is read. Who reads fills in the first five. */
struct um_orbit_message {
  struct um_context *context;
  const char *name; /* of the file */
  const struct um_orbit_message_calls *calls;
  void *self;                                           /* of the calls */
  const struct um_orbit_earth_orientation *orientation; /* of frames that turn; NULL: zero */
  int line;
  enum um_orbit_message_place place;
  char version;  /* first digit, '1' */
  bool has_days; /* of CNES: a time is two numbers */
  char scale[8]; /* of the segment */
  bool begins;   /* no row of the segment was read */
  size_t rows;   /* read so far */
  double last;   /* time of the row before [s]; -INFINITY */
};
struct um_orbit_message_calls {
  const char *kind;              /* "OEM" */
  enum um_orbit_stk_kind stk;    /* what a file of STK has to hold */
  struct um_orbit_ndm_form form; /* in XML */
  void (*begin)(void *self);     /* META_START; NULL: nothing to do */
  /* what stands between META_START and META_STOP, but for TIME_SYSTEM */
  enum um_status (*key)(const struct um_orbit_message *m, void *self, const char *key,
                        const char *value);
  enum um_status (*ready)(const struct um_orbit_message *m,
                          void *self); /* META_STOP; NULL: no checks */
  /* values: number [count], behind the time */
  enum um_status (*row)(const struct um_orbit_message *m, void *self, double t_tai,
                        const double *number, size_t count);
  size_t least, most; /* numbers of a row: one or the other */
  const char *row_is; /* "a time, 3 of the place, 3 of the velocity" */
};

/* "KEYWORD = value" without the blanks around both; the line is written into. false: no '='. */
bool um_orbit_message_pair(char *line, char **key, char **value);
/* All of a text of `length` bytes, which is written into: key = value of CCSDS or CNES, XML of
 * CCSDS, or a file of STK. *is false: it is none of these, and nothing was read. At least two rows.
 * Times ascend; a segment may begin with the last row of the one before, which is passed over.
 * UM_ERR_INPUT naming file, line and what is accepted. */
enum um_status um_orbit_message_read(struct um_orbit_message *m, char *text, size_t length,
                                     bool *is);
/* UM_ERR_INPUT "file:line: key: 'value'; accepted: ...". */
enum um_status um_orbit_message_refuse(const struct um_orbit_message *m, const char *key,
                                       const char *value, const char *accepted);
/* A failure of a row's own, with file and line before its message; UM_OK: nothing. */
enum um_status um_orbit_message_blame(const struct um_orbit_message *m, enum um_status status);

#endif
