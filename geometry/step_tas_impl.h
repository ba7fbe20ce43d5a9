/* What the files that read STEP-TAS share. Private to geometry/. */
#ifndef UMBRA_GEOMETRY_STEP_TAS_IMPL_H
#define UMBRA_GEOMETRY_STEP_TAS_IMPL_H

#include "base/core/vec.h"
#include "geometry/part21_impl.h"

/* Facets of round surfaces span at most this [rad]. */
#define UM_TAS_STEP 0.17453292519943295

/* Faces of one surface in one direction. */
#define UM_TAS_FACES 10000

/* A convex solid that cuts surfaces: inside is normal . p <= offset of every plane [m]. */
struct um_geometry_tas_plane {
  struct um_vec3 normal;
  double offset;
};
struct um_geometry_tas_solid {
  struct um_geometry_tas_plane *plane; /* [n] */
  size_t n;
};

/* Convex polygons, one behind the other. */
struct um_geometry_tas_pieces {
  struct um_vec3 *corner; /* [ncorner] */
  size_t *end;            /* [n] of corners up to and with this piece */
  size_t ncorner, n, corner_capacity, capacity;
};

/* A file that is read. */
struct um_geometry_tas {
  struct um_context *context;
  const char *path;
  struct um_geometry_part21 file;
  char *text; /* [length] the OBJ that it becomes */
  size_t length, capacity;
  size_t nvertex, nfacet; /* that stand in it */
  uint8_t *seen;          /* [file.ninstance] of items: 1 inside another, 2 placed */
  char (*name)[256];      /* [nname] groups that are taken */
  size_t nname, nsurface;
  struct um_geometry_tas_solid *solid; /* [nsolid] that cut what is being read */
  size_t nsolid;
  const struct um_geometry_part21_instance *cut; /* that names its one surface; NULL: none does */
  size_t idle; /* surfaces without an active side, and the first of them: */
  const struct um_geometry_part21_instance *first_idle;
};

typedef const struct um_geometry_part21_instance *um_geometry_tas_item;
typedef const struct um_geometry_part21_value *um_geometry_tas_value;

/* p in the frame outside: turn p + move. */
struct um_geometry_tas_frame {
  struct um_mat3 turn;
  struct um_vec3 move; /* [m] */
};

/* step_tas.c. UM_ERR_INPUT: "file:line: #id NAME 'its own name': text". */
enum um_status um_geometry_tas_fail(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                    const char *format, ...) UM_PRINTF(3, 4);
/* A text of an item, as messages and OBJ take it; "" where it has none. */
void um_geometry_tas_text(const struct um_geometry_tas *t, um_geometry_tas_item of, int index,
                          char out[256]);
/* printf at the end of the OBJ. */
enum um_status um_geometry_tas_put(struct um_geometry_tas *t, const char *format, ...)
    UM_PRINTF(2, 3);

/* step_tas_fields.c: attributes by their number from 0, which messages call from 1. UM_ERR_INPUT:
 * there is none, or it is of another kind. */
/* NULL where it is $, * or missing. */
um_geometry_tas_value um_geometry_tas_attribute(const struct um_geometry_tas *t,
                                                um_geometry_tas_item of, int index);
/* `what`: in words, for a message. *out NULL where it is unset and `optional`. */
enum um_status um_geometry_tas_item_at(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                       int index, const char *what, bool optional,
                                       um_geometry_tas_item *out);
enum um_status um_geometry_tas_number(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                      int index, double *out);
/* A list of items; *next and *end run over its values: while (next < end) next = value[next].end.
 */
enum um_status um_geometry_tas_list(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                    int index, uint32_t *next, uint32_t *end);
/* The item that value `at` of a list refers to. */
enum um_status um_geometry_tas_listed(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                      uint32_t at, um_geometry_tas_item *out);
/* A quantity [m] and [rad]. */
enum um_status um_geometry_tas_length(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                      int index, double *out);
enum um_status um_geometry_tas_angle(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                     int index, double *out);
/* A point [m]. */
enum um_status um_geometry_tas_point(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                     int index, struct um_vec3 *out);
/* What attribute `index` of an item says of where it stands, put inside `outer`; unset: `outer`. */
enum um_status um_geometry_tas_place(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                     int index, const struct um_geometry_tas_frame *outer,
                                     struct um_geometry_tas_frame *out);
struct um_vec3 um_geometry_tas_move(const struct um_geometry_tas_frame *frame, struct um_vec3 p);

/* step_tas_facets.c: vertices and faces of a surface whose shape is attribute 6, seen from side 1,
 * or from side 2 where `turned`. */
enum um_status um_geometry_tas_put_shape(struct um_geometry_tas *t, um_geometry_tas_item surface,
                                         const struct um_geometry_tas_frame *frame, bool turned);
enum um_status um_geometry_tas_put_vertex(struct um_geometry_tas *t, um_geometry_tas_item surface,
                                          struct um_vec3 p);

/* step_tas_solid.c: the tool of the cut surface `of`, whose frame this is, cuts what is put from
 * here on, until solids from number `nsolid` on are given back. UM_ERR_INPUT: a tool that is not
 * read.
 */
enum um_status um_geometry_tas_cut_begin(struct um_geometry_tas *t, um_geometry_tas_item of,
                                         const struct um_geometry_tas_frame *frame);
void um_geometry_tas_cut_end(struct um_geometry_tas *t, size_t nsolid);
/* step_tas_cut.c. Adds a polygon of n corners. */
enum um_status um_geometry_tas_pieces_add(struct um_context *context,
                                          struct um_geometry_tas_pieces *pieces,
                                          const struct um_vec3 *corner, size_t n);
void um_geometry_tas_pieces_clear(struct um_context *context,
                                  struct um_geometry_tas_pieces *pieces);
/* Vertices and faces of what the solids leave of a surface's polygons; corners that lie on an edge
 * of another polygon stand in that one, too. */
enum um_status um_geometry_tas_put_cut(struct um_geometry_tas *t, um_geometry_tas_item surface,
                                       const struct um_geometry_tas_pieces *whole);

#endif
