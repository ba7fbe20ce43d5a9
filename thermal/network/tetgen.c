/* TetGen in a child process: it crashes, aborts or runs on where a surface displeases it, so it
 * works in a fork with limits on memory and time, and sends its result through a pipe. */
#include "thermal/network/tetgen.h"

#include <stdio.h>
#include <string.h>

#include "base/core/child.h"
#include "thermal/network/tetgen_check_impl.h"
#include "thermal/network/tetgen_impl.h"

/* First on the pipe; then points, tetrahedra, flagged facets. */
struct header {
  int32_t code;     /* of um_thermal_tetgen_call */
  int32_t crossing; /* the list of flagged facets follows, nothing else */
  int32_t npoint, ntetrahedron, nflagged;
};
/* What the child is given. */
struct work {
  const struct um_thermal_tetgen_surface *surface;
  const char *switches;
};

/* The child's life: look for crossing facets, fill, send. */
static int child_work(void *self, int pipe_end)
{
  const struct work *w = self;
  const struct um_thermal_tetgen_surface *s = w->surface;
  struct um_thermal_tetgen_result r = {0};
  struct header h = {.crossing = 1};
  const int *facet = (const int *)s->facet;
  const double *point = &s->vertex[0].x;
  int npoint = (int)s->nvertex, nfacet = (int)s->nfacet;
  h.code = um_thermal_tetgen_call("pdQ", point, npoint, facet, nfacet, NULL, 0, &r);
  h.nflagged = r.nface;
  if (h.code == UM_TETGEN_OK && r.nface == 0) {
    h.crossing = 0;
    h.code = um_thermal_tetgen_call(w->switches, point, npoint, facet, nfacet, s->hole,
                                    (int)s->nhole, &r);
    h.nflagged = 0;
    h.npoint = r.npoint;
    h.ntetrahedron = r.ntetrahedron;
  }
  bool sent =
      um_core_child_write(pipe_end, &h, sizeof h) &&
      um_core_child_write(pipe_end, r.point, 3 * sizeof(double) * (size_t)h.npoint) &&
      um_core_child_write(pipe_end, r.tetrahedron, 4 * sizeof(int) * (size_t)h.ntetrahedron) &&
      um_core_child_write(pipe_end, r.face_marker, sizeof(int) * (size_t)h.nflagged);
  return sent ? 0 : 1;
}

/* What TetGen answers, in a child of its own. */
static enum um_status run_child(struct um_context *context,
                                const struct um_thermal_tetgen_surface *s, const char *switches,
                                const struct um_thermal_tetgen_limits *limits,
                                struct um_core_child_result *in)
{
  struct work work = {s, switches};
  struct um_core_child_limits bounds = {limits->seconds, limits->megabyte};
  enum um_status status = um_core_child_run(context, "TetGen", child_work, &work, &bounds, in);
  if (status == UM_ERR_LIBRARY) um_core_message_prefix(context, "part %s", s->name);
  UM_TRY(status);
  if (in->end == UM_CHILD_TIMED_OUT)
    return um_core_fail(
        context, UM_ERR_LIBRARY,
        "part %s: TetGen did not finish within %g s; accepted: fewer facets, larger "
        "tetrahedra, or a shell",
        s->name, limits->seconds);
  if (in->end == UM_CHILD_SIGNALLED || in->code != 0)
    return um_core_fail(
        context, UM_ERR_LIBRARY,
        "part %s: TetGen crashed (%s %d) with %zu facets; check the surface, or make "
        "the part a shell",
        s->name, in->end == UM_CHILD_SIGNALLED ? "signal" : "exit", in->code, s->nfacet);
  return UM_OK;
}

static enum um_status fail_crossing(struct um_context *context,
                                    const struct um_thermal_tetgen_surface *s, int *flagged,
                                    size_t n)
{
  uint32_t pair[2];
  struct um_vec3 centre[2] = {{0, 0, 0}, {0, 0, 0}};
  for (size_t i = 0; i < n; i++)
    if (--flagged[i] < 0 || (size_t)flagged[i] >= s->nfacet) n = 0;
  if (n < 2)
    return um_core_fail(context, UM_ERR_INPUT,
                        "part %s: the surface crosses itself; accepted: facets that meet at edges "
                        "only",
                        s->name);
  um_thermal_tetgen_crossing(s, flagged, n, pair);
  for (int i = 0; i < 2; i++)
    for (int c = 0; c < 3; c++)
      centre[i] = um_vec3_axpy(centre[i], 1.0 / 3.0, s->vertex[s->facet[pair[i]][c]]);
  return um_core_fail(context, UM_ERR_INPUT,
                      "part %s: the surface crosses itself: facet %u near (%g, %g, %g) m and facet "
                      "%u near (%g, %g, %g) m; accepted: facets that meet at edges only",
                      s->name, (unsigned)pair[0], centre[0].x, centre[0].y, centre[0].z,
                      (unsigned)pair[1], centre[1].x, centre[1].y, centre[1].z);
}

/* Tetrahedra out of the received bytes; each turned to positive volume. */
static enum um_status unpack(struct um_context *context, const struct um_thermal_tetgen_surface *s,
                             const struct header *h, const char *data,
                             struct um_thermal_tetrahedra *t)
{
  t->nvertex = (size_t)h->npoint;
  t->ntetrahedron = (size_t)h->ntetrahedron;
  UM_TRY(um_core_allocate(context, t->nvertex, sizeof *t->vertex, &t->vertex));
  UM_TRY(um_core_allocate(context, t->ntetrahedron, sizeof *t->corner, &t->corner));
  memcpy(t->vertex, data, t->nvertex * sizeof *t->vertex);
  memcpy(t->corner, data + t->nvertex * sizeof *t->vertex, t->ntetrahedron * sizeof *t->corner);
  double volume = 0.0;
  bool same = memcmp(t->vertex, s->vertex, s->nvertex * sizeof *s->vertex) == 0;
  for (size_t e = 0; e < t->ntetrahedron && same; e++) {
    uint32_t *c = t->corner[e];
    for (int i = 0; i < 4; i++) same = same && c[i] < t->nvertex;
    if (!same) break;
    struct um_vec3 p = t->vertex[c[0]];
    struct um_vec3 a = um_vec3_sub(t->vertex[c[1]], p), b = um_vec3_sub(t->vertex[c[2]], p);
    double v = um_vec3_dot(um_vec3_cross(a, b), um_vec3_sub(t->vertex[c[3]], p)) / 6.0;
    if (v < 0.0) {
      uint32_t swap = c[0];
      c[0] = c[1];
      c[1] = swap;
    }
    volume += fabs(v);
    same = v != 0.0;
  }
  if (!same || !(fabs(volume - s->volume) <= 1e-6 * s->volume))
    return um_core_fail(context, UM_ERR_LIBRARY,
                        "part %s: TetGen filled %g m3 of the %g m3 that the surface encloses",
                        s->name, volume, s->volume);
  return UM_OK;
}

static enum um_status interpret(struct um_context *context,
                                const struct um_thermal_tetgen_surface *s,
                                const struct um_core_child_result *in,
                                struct um_thermal_tetrahedra *t)
{
  struct header h = {.code = UM_TETGEN_UNKNOWN};
  size_t want = sizeof h;
  if (in->count >= sizeof h) memcpy(&h, in->answer, sizeof h);
  if (h.npoint >= 0 && h.ntetrahedron >= 0 && h.nflagged >= 0)
    want += 3 * sizeof(double) * (size_t)h.npoint + 4 * sizeof(int) * (size_t)h.ntetrahedron +
            sizeof(int) * (size_t)h.nflagged;
  if (in->count != want)
    return um_core_fail(context, UM_ERR_LIBRARY, "part %s: TetGen's answer was cut short", s->name);
  if (h.code == UM_TETGEN_CROSSING || h.nflagged > 0)
    return fail_crossing(context, s, (int *)(void *)(in->answer + sizeof h), (size_t)h.nflagged);
  if (h.code != UM_TETGEN_OK)
    return um_core_fail(context, UM_ERR_LIBRARY, "part %s: TetGen stopped with code %d%s", s->name,
                        (int)h.code, h.code == UM_TETGEN_MEMORY ? " (out of memory)" : "");
  if (h.ntetrahedron == 0 || h.npoint < (int)s->nvertex)
    return um_core_fail(context, UM_ERR_INPUT,
                        "part %s: TetGen found no volume inside the surface; accepted: a closed "
                        "surface with space inside",
                        s->name);
  return unpack(context, s, &h, in->answer + sizeof h, t);
}

enum um_status um_thermal_tetgen_fill_limited(struct um_context *context, const char *name,
                                              const struct um_vec3 *vertex, size_t nvertex,
                                              const uint32_t (*facet)[3], size_t nfacet,
                                              double edge,
                                              const struct um_thermal_tetgen_limits *limits,
                                              struct um_thermal_tetrahedra **out)
{
  *out = NULL;
  struct um_thermal_tetgen_surface s = {
      .name = name, .vertex = vertex, .nvertex = nvertex, .facet = facet, .nfacet = nfacet};
  struct um_thermal_tetrahedra *t = NULL;
  struct um_core_child_result in = {0};
  char switches[64] = "pYq1.4Q";
  enum um_status status;
  UM_CHECK(um_thermal_tetgen_check(context, &s));
  if (!um_thermal_tetgen_present()) {
    status = um_core_fail(context, UM_ERR_LIBRARY,
                          "part %s: solid parts need TetGen, which this build leaves out "
                          "(UMBRA_TETGEN=OFF); accepted: a shell, a lumped part, or an interior "
                          "with conductivity_W_m_K 0",
                          name);
    goto done;
  }
  /* a regular tetrahedron of edge L has the volume L^3 / (6 sqrt(2)) */
  if (edge > 0.0)
    snprintf(switches, sizeof switches, "pYq1.4a%.18fQ", edge * edge * edge / (6.0 * sqrt(2.0)));
  UM_CHECK(run_child(context, &s, switches, limits, &in));
  UM_CHECK(um_core_allocate(context, 1, sizeof *t, &t));
  UM_CHECK(interpret(context, &s, &in, t));
  UM_CHECK(um_core_allocate(context, nfacet, sizeof *t->facet, &t->facet));
  memcpy(t->facet, facet, nfacet * sizeof *t->facet);
  t->nsurface = nvertex;
  t->nfacet = nfacet;
  t->edge = edge;
  *out = t;
  t = NULL;
done:
  um_thermal_tetrahedra_destroy(context, &t);
  UM_FREE(context, in.answer, s.hole);
  return status;
}

enum um_status um_thermal_tetgen_fill(struct um_context *context, const char *name,
                                      const struct um_vec3 *vertex, size_t nvertex,
                                      const uint32_t (*facet)[3], size_t nfacet, double edge,
                                      struct um_thermal_tetrahedra **out)
{
  struct um_thermal_tetgen_limits limits = {.seconds = 300.0, .megabyte = 8192};
  return um_thermal_tetgen_fill_limited(context, name, vertex, nvertex, facet, nfacet, edge,
                                        &limits, out);
}

bool um_thermal_tetrahedra_fill(const struct um_thermal_tetrahedra *tetrahedra,
                                const struct um_vec3 *vertex, size_t nvertex,
                                const uint32_t (*facet)[3], size_t nfacet, double edge)
{
  const struct um_thermal_tetrahedra *t = tetrahedra;
  bool same = t->nsurface == nvertex && t->nfacet == nfacet && t->edge == edge &&
              memcmp(t->facet, facet, nfacet * sizeof *facet) == 0;
  for (size_t v = 0; v < nvertex && same; v++)
    same = t->vertex[v].x == vertex[v].x && t->vertex[v].y == vertex[v].y &&
           t->vertex[v].z == vertex[v].z;
  return same;
}

enum um_status um_thermal_tetrahedra_copy(struct um_context *context,
                                          const struct um_thermal_tetrahedra *tetrahedra,
                                          struct um_thermal_tetrahedra **out)
{
  enum um_status status;
  const struct um_thermal_tetrahedra *from = tetrahedra;
  struct um_thermal_tetrahedra *t = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *t, &t));
  UM_CHECK(um_core_allocate(context, from->nvertex, sizeof *t->vertex, &t->vertex));
  UM_CHECK(um_core_allocate(context, from->ntetrahedron, sizeof *t->corner, &t->corner));
  UM_CHECK(um_core_allocate(context, from->nfacet, sizeof *t->facet, &t->facet));
  memcpy(t->vertex, from->vertex, from->nvertex * sizeof *t->vertex);
  memcpy(t->corner, from->corner, from->ntetrahedron * sizeof *t->corner);
  memcpy(t->facet, from->facet, from->nfacet * sizeof *t->facet);
  t->nvertex = from->nvertex;
  t->ntetrahedron = from->ntetrahedron;
  t->nsurface = from->nsurface;
  t->nfacet = from->nfacet;
  t->edge = from->edge;
  *out = t;
  t = NULL;
done:
  um_thermal_tetrahedra_destroy(context, &t);
  return status;
}

void um_thermal_tetrahedra_destroy(struct um_context *context,
                                   struct um_thermal_tetrahedra **tetrahedra)
{
  if (tetrahedra == NULL || *tetrahedra == NULL) return;
  UM_FREE(context, (*tetrahedra)->vertex, (*tetrahedra)->corner, (*tetrahedra)->facet, *tetrahedra);
  *tetrahedra = NULL;
}
