/* TetGen in a child process: it crashes, aborts or runs on where a surface displeases it, so it
 * works in a fork with limits on memory and time, and sends its result through a pipe. */
#include "thermal/tetgen.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "thermal/tetgen_impl.h"

#if defined(__SANITIZE_ADDRESS__)
#define ADDRESS_LIMIT 0 /* the sanitizer's shadow memory would break it */
#else
#define ADDRESS_LIMIT 1
#endif

/* First on the pipe; then points, tetrahedra, flagged facets. */
struct header {
  int32_t code;     /* of um_thermal_tetgen_call */
  int32_t crossing; /* the list of flagged facets follows, nothing else */
  int32_t npoint, ntetrahedron, nflagged;
};
struct bytes {
  char *data;
  size_t count;
};

static double now(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Address space of this process [bytes]; the child inherits it. */
static size_t address_space(void)
{
  size_t pages = 0;
  FILE *file = fopen("/proc/self/statm", "r");
  if (file == NULL) return 0;
  if (fscanf(file, "%zu", &pages) != 1) pages = 0;
  fclose(file);
  return pages * (size_t)sysconf(_SC_PAGESIZE);
}

static void send_all(int pipe_end, const void *data, size_t bytes)
{
  const char *at = data;
  while (bytes > 0) {
    ssize_t n = write(pipe_end, at, bytes);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) _exit(1);
    at += n;
    bytes -= (size_t)n;
  }
}

static void child_limits(const struct um_thermal_tetgen_limits *limits, size_t inherited)
{
  struct rlimit core = {0, 0};
  rlim_t seconds = (rlim_t)ceil(limits->seconds);
  struct rlimit time_limit = {seconds, seconds + 1};
  setrlimit(RLIMIT_CORE, &core);
  setrlimit(RLIMIT_CPU, &time_limit);
  if (ADDRESS_LIMIT && inherited > 0) {
    rlim_t bytes = (rlim_t)(inherited + limits->megabyte * 1048576);
    setrlimit(RLIMIT_AS, &(struct rlimit){bytes, bytes});
  }
  int null = open("/dev/null", O_WRONLY);
  if (null >= 0) {
    dup2(null, STDOUT_FILENO);
    dup2(null, STDERR_FILENO);
  }
  signal(SIGPIPE, SIG_DFL);
}

/* The child's life: look for crossing facets, fill, send, exit. */
static void child_run(const struct um_thermal_tetgen_surface *s, const char *switches,
                      const double *point, int pipe_end)
{
  struct um_thermal_tetgen_result r = {0};
  const int *facet = (const int *)s->facet;
  int npoint = (int)s->nvertex, nfacet = (int)s->nfacet;
  struct header h = {.crossing = 1};
  h.code = um_thermal_tetgen_call("pdQ", point, npoint, facet, nfacet, NULL, 0, &r);
  h.nflagged = r.nface;
  if (h.code == UM_TETGEN_OK && r.nface == 0) {
    h.crossing = 0;
    h.code =
        um_thermal_tetgen_call(switches, point, npoint, facet, nfacet, s->hole, (int)s->nhole, &r);
    h.nflagged = 0;
    h.npoint = r.npoint;
    h.ntetrahedron = r.ntetrahedron;
  }
  send_all(pipe_end, &h, sizeof h);
  send_all(pipe_end, r.point, 3 * sizeof(double) * (size_t)h.npoint);
  send_all(pipe_end, r.tetrahedron, 4 * sizeof(int) * (size_t)h.ntetrahedron);
  send_all(pipe_end, r.face_marker, sizeof(int) * (size_t)h.nflagged);
  _exit(0);
}

/* Everything until the pipe closes; UM_ERR_NUMERIC stands for "out of time". */
static enum um_status receive(struct um_context *context, int pipe_end, double deadline,
                              struct bytes *in)
{
  size_t room = 0;
  for (;;) {
    double left = deadline - now();
    if (!(left > 0.0)) return UM_ERR_NUMERIC;
    struct pollfd wait = {.fd = pipe_end, .events = POLLIN};
    int ready = poll(&wait, 1, (int)fmin(1000.0 * left + 1.0, 3600e3));
    if (ready <= 0) continue; /* time is looked at above; a signal is no reason to stop */
    if (in->count == room) {
      room = 2 * room + 65536;
      UM_TRY(um_core_reallocate(context, room, 1, &in->data));
    }
    ssize_t n = read(pipe_end, in->data + in->count, room - in->count);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return UM_ERR_LIBRARY;
    if (n == 0) return UM_OK;
    in->count += (size_t)n;
  }
}

/* Start the child, collect what it says, bury it. */
static enum um_status run_child(struct um_context *context,
                                const struct um_thermal_tetgen_surface *s, const char *switches,
                                const double *point, const struct um_thermal_tetgen_limits *limits,
                                struct bytes *in)
{
  int ends[2], state = 0;
  size_t inherited = address_space();
  if (pipe(ends) != 0)
    return um_core_fail(context, UM_ERR_LIBRARY, "part %s: no pipe to TetGen: %s", s->name,
                        strerror(errno));
  pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    child_limits(limits, inherited);
    child_run(s, switches, point, ends[1]);
  }
  int fork_error = errno;
  close(ends[1]);
  if (child < 0) {
    close(ends[0]);
    return um_core_fail(context, UM_ERR_LIBRARY, "part %s: no process for TetGen: %s", s->name,
                        strerror(fork_error));
  }
  enum um_status status = receive(context, ends[0], now() + limits->seconds, in);
  if (status != UM_OK) kill(child, SIGKILL);
  close(ends[0]);
  while (waitpid(child, &state, 0) < 0 && errno == EINTR) continue;
  if (status == UM_ERR_NUMERIC || (WIFSIGNALED(state) && WTERMSIG(state) == SIGXCPU))
    return um_core_fail(
        context, UM_ERR_LIBRARY,
        "part %s: TetGen did not finish within %g s; accepted: fewer facets, larger "
        "tetrahedra, or a shell",
        s->name, limits->seconds);
  if (status == UM_ERR_MEMORY) return status;
  if (status != UM_OK || !WIFEXITED(state) || WEXITSTATUS(state) != 0)
    return um_core_fail(
        context, UM_ERR_LIBRARY,
        "part %s: TetGen crashed (%s %d) with %zu facets; check the surface, or make "
        "the part a shell",
        s->name, WIFSIGNALED(state) ? "signal" : "exit",
        WIFSIGNALED(state) ? WTERMSIG(state) : WEXITSTATUS(state), s->nfacet);
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
                                const struct um_thermal_tetgen_surface *s, const struct bytes *in,
                                struct um_thermal_tetrahedra *t)
{
  struct header h = {.code = UM_TETGEN_UNKNOWN};
  size_t want = sizeof h;
  if (in->count >= sizeof h) memcpy(&h, in->data, sizeof h);
  if (h.npoint >= 0 && h.ntetrahedron >= 0 && h.nflagged >= 0)
    want += 3 * sizeof(double) * (size_t)h.npoint + 4 * sizeof(int) * (size_t)h.ntetrahedron +
            sizeof(int) * (size_t)h.nflagged;
  if (in->count != want)
    return um_core_fail(context, UM_ERR_LIBRARY, "part %s: TetGen's answer was cut short", s->name);
  if (h.code == UM_TETGEN_CROSSING || h.nflagged > 0)
    return fail_crossing(context, s, (int *)(void *)(in->data + sizeof h), (size_t)h.nflagged);
  if (h.code != UM_TETGEN_OK)
    return um_core_fail(context, UM_ERR_LIBRARY, "part %s: TetGen stopped with code %d%s", s->name,
                        (int)h.code, h.code == UM_TETGEN_MEMORY ? " (out of memory)" : "");
  if (h.ntetrahedron == 0 || h.npoint < (int)s->nvertex)
    return um_core_fail(context, UM_ERR_INPUT,
                        "part %s: TetGen found no volume inside the surface; accepted: a closed "
                        "surface with space inside",
                        s->name);
  return unpack(context, s, &h, in->data + sizeof h, t);
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
  struct bytes in = {0};
  char switches[64] = "pYq1.4Q";
  enum um_status status;
  UM_CHECK(um_thermal_tetgen_check(context, &s));
  if (!um_thermal_tetgen_present()) {
    status = um_core_fail(context, UM_ERR_LIBRARY,
                          "part %s: solid parts need TetGen, which this build leaves out "
                          "(UMBRA_TETGEN=OFF); accepted: a shell or a lumped part",
                          name);
    goto done;
  }
  /* a regular tetrahedron of edge L has the volume L^3 / (6 sqrt(2)) */
  if (edge > 0.0)
    snprintf(switches, sizeof switches, "pYq1.4a%.18fQ", edge * edge * edge / (6.0 * sqrt(2.0)));
  UM_CHECK(run_child(context, &s, switches, &vertex[0].x, limits, &in));
  UM_CHECK(um_core_allocate(context, 1, sizeof *t, &t));
  UM_CHECK(interpret(context, &s, &in, t));
  *out = t;
  t = NULL;
done:
  um_thermal_tetrahedra_destroy(context, &t);
  um_core_free(context, in.data);
  um_core_free(context, s.hole);
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

void um_thermal_tetrahedra_destroy(struct um_context *context,
                                   struct um_thermal_tetrahedra **tetrahedra)
{
  if (tetrahedra == NULL || *tetrahedra == NULL) return;
  um_core_free(context, (*tetrahedra)->vertex);
  um_core_free(context, (*tetrahedra)->corner);
  um_core_free(context, *tetrahedra);
  *tetrahedra = NULL;
}
