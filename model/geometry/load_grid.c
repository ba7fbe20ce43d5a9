/* Times of the rows of the loads: fine enough for the turn of the body and for the penumbra; every
 * observed instant is one, so that optics and heat use the same fluxes. The loads are linear
 * between grid times: a shadow without penumbra, which is a jump, has one on either side of its
 * edge.
 *
 * Rows that are long past when the observations begin stand SPARSE times further apart, unless
 * thermal.step_s says how far: of a body that turns they still have the right mean over its turns,
 * where trapezoids of what is periodic have no error but that of its harmonics beyond their number,
 * and what the surfaces missed within a turn they forget. Observed instants that stand closer than
 * rows need to are the only rows there. docs/physics/heat-in-time.md has what both leave.
 *
 * Of sparse loads observed instants are no rows. */
#include "model/geometry/load_grid_impl.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/core/sort.h"
#include "model/geometry/precompute_loads_impl.h"

#define TURN_PER_STEP    0.08 /* rotation between load rows [rad]; linear error < 1e-3 of a cosine */
#define PENUMBRA_POINTS  8    /* rows between two events of one eclipse edge */
#define AIR_LIT          8    /* rows half such a gap apart before the Sun sinks into the air */
#define AIR_DARK         10   /* and behind the umbra's edge, as far as light is bent: 66 km */
#define PENUMBRA_LONGEST 120  /* events further apart than this are not one edge [s] */
#define SAME_TIME        1e-3 /* grid times nearer than this are one [s] */
#define JUMP_SIDE        1e-4 /* from a shadow's edge without penumbra to its sides [s] */
#define SPARSE           3.0
#define RECENT           300.0 /* before the first observation, where rows stand as ever [s] */

struct grid_time {
  double t;
  bool wanted; /* observed instant, or a side of a jump: never displaced */
  bool laid;   /* stands there for the turn of the body alone */
};

static int compare_times(const void *a, const void *b)
{
  double x = ((const struct grid_time *)a)->t, y = ((const struct grid_time *)b)->t;
  return (x > y) - (x < y);
}

bool um_model_load_rows_vary(const struct um_model *model, const struct um_model_tables *tables)
{
  return isnan(model->scenario->thermal->step_s) && !(tables->spin_period > 0.0);
}

double um_model_load_step(const struct um_model *model, const struct um_model_tables *tables)
{
  double step = model->scenario->thermal->step_s;
  if (!isnan(step)) return step;
  if (tables->spin_period > 0.0) return UM_MODEL_LOADS_LONGEST_STEP;
  double orbital = isnan(tables->period) ? 0.0 : 2.0 * UM_PI / tables->period;
  double rate = um_orbit_attitude_rate(model->attitude, orbital);
  return rate > 0.0 ? fmin(UM_MODEL_LOADS_LONGEST_STEP, TURN_PER_STEP / rate)
                    : UM_MODEL_LOADS_LONGEST_STEP;
}

/* Where an event stands in the grid. Behind a cylinder, or before a Sun without a disc, the three
 * events of an edge coincide: penumbra and umbra are then set on its two sides. */
static struct grid_time event_time(const struct um_model *model,
                                   const struct um_environment_event *event)
{
  double side = 0.0;
  if (model->environment.shadow == UM_SHADOW_CYLINDER || model->environment.disc == UM_DISC_POINT) {
    if (event->kind == UM_EVENT_PENUMBRA_ENTRY || event->kind == UM_EVENT_UMBRA_EXIT)
      side = -JUMP_SIDE;
    else if (event->kind == UM_EVENT_UMBRA_ENTRY || event->kind == UM_EVENT_PENUMBRA_EXIT)
      side = JUMP_SIDE;
  }
  return (struct grid_time){.t = event->t_tai + side, .wanted = side != 0.0};
}

/* Without rows laid between two wanted ones that are `step` apart or less. */
static size_t drop_needless(double step, struct grid_time *grid, size_t n)
{
  size_t kept = 0;
  double before = -INFINITY; /* last wanted time */
  for (size_t i = 0, next = 0; i < n; i++) {
    while (next < n && (next < i || !grid[next].wanted)) next++;
    double after = next < n ? grid[next].t : INFINITY;
    bool needed = !grid[i].laid || after - before > step;
    if (grid[i].wanted) before = grid[i].t;
    if (needed) grid[kept++] = grid[i];
  }
  return kept;
}

/* Times strictly ascending; a wanted one displaces a neighbour that is not. */
static size_t merge_times(struct grid_time *grid, size_t n)
{
  size_t kept = 0;
  for (size_t i = 0; i < n; i++) {
    struct grid_time *last = kept > 0 ? &grid[kept - 1] : NULL;
    if (last == NULL || grid[i].t - last->t >= SAME_TIME ||
        (grid[i].wanted && last->wanted && grid[i].t > last->t))
      grid[kept++] = grid[i];
    else if (grid[i].wanted && !last->wanted)
      *last = grid[i];
  }
  return kept;
}

/* Rows before and behind an edge, on which the Earth's air bends and dims the Sun: a gap between
 * two events of an edge is 15 km of height at the limb, the air reaches from 60 km to where a ray
 * along the ground ends, 66 km below. */
static size_t air_rows(const struct um_environment_event *event, double gap, double end,
                       struct grid_time *grid, size_t n)
{
  int rows = 0;
  double way = 0.0;
  switch (event->kind) {
  case UM_EVENT_PENUMBRA_ENTRY:
    way = -0.5, rows = AIR_LIT;
    break;
  case UM_EVENT_UMBRA_ENTRY:
    way = 0.5, rows = AIR_DARK;
    break;
  case UM_EVENT_UMBRA_EXIT:
    way = -0.5, rows = AIR_DARK;
    break;
  case UM_EVENT_PENUMBRA_EXIT:
    way = 0.5, rows = AIR_LIT;
    break;
  default:
    break;
  }
  for (int k = 1; k <= rows; k++) {
    double t = event->t_tai + k * way * gap;
    if (t > grid[0].t && t < end) grid[n++].t = t;
  }
  return n;
}

/* Rows `step` apart or less over [from, to], those behind the end left out. */
static size_t lay(double from, double to, double end, double step, struct grid_time *grid, size_t n)
{
  size_t nstep = (size_t)ceil((to - from) / step);
  for (size_t i = 0; i <= nstep; i++) {
    double t = nstep == 0 ? end : from + (to - from) * (double)i / (double)nstep;
    if (t < end + SAME_TIME) grid[n++] = (struct grid_time){.t = t, .laid = true};
  }
  return n;
}

enum um_status um_model_load_grid(struct um_context *context, const struct um_model *model,
                                  const struct um_model_tables *tables, double step, double **out,
                                  size_t *count)
{
  size_t ninstant = tables->nobs * tables->nsub, n = 0;
  double last = tables->sample[ninstant - 1].t_tai;
  double end = fmax(last, tables->t_periodic_end);
  /* laid out over an orbit at least, so that what moves the last observation by a little does not
   * move the rows before it; rows behind the end are left out */
  double laid = isnan(tables->period) ? end : fmax(end, tables->t_start + tables->period);
  size_t room = (size_t)ceil((laid - tables->t_start) / step) + 5 + ninstant +
                tables->nevent * (PENUMBRA_POINTS + 1 + AIR_DARK);
  struct grid_time *grid = NULL;
  UM_TRY(um_core_allocate(context, room, sizeof *grid, &grid));
  double recent = tables->t_start;
  if (um_model_load_rows_vary(model, tables) && tables->t_first - RECENT > recent) {
    recent = tables->t_first - RECENT;
    n = lay(tables->t_start, recent, end, fmin(SPARSE * step, UM_MODEL_LOADS_LONGEST_STEP), grid,
            n);
  }
  n = lay(recent, laid, end, step, grid, n);
  /* observed instants then have a table of theirs */
  bool apart = tables->spin_period > 0.0 || tables->sparse;
  if (apart) grid[n++] = (struct grid_time){.t = end, .wanted = true};
  for (size_t i = 0; i < ninstant && !apart; i++)
    grid[n++] = (struct grid_time){.t = tables->sample[i].t_tai, .wanted = true};
  for (size_t i = 0; i < tables->nevent; i++) {
    grid[n++] = event_time(model, &tables->event[i]);
    if (i + 1 == tables->nevent) break;
    double gap = tables->event[i + 1].t_tai - tables->event[i].t_tai;
    if (!(gap > SAME_TIME && gap < PENUMBRA_LONGEST)) continue;
    for (int k = 1; k < PENUMBRA_POINTS; k++)
      grid[n++].t = tables->event[i].t_tai + gap * k / PENUMBRA_POINTS;
    n = air_rows(&tables->event[i], gap, end, grid, n);
    n = air_rows(&tables->event[i + 1], gap, end, grid, n);
  }
  enum um_status status = um_core_sort(context, grid, n, sizeof *grid, compare_times);
  n = merge_times(grid, drop_needless(step, grid, n));
  if (status == UM_OK) status = um_core_allocate(context, n, sizeof **out, out);
  for (size_t i = 0; status == UM_OK && i < n; i++) (*out)[i] = grid[i].t;
  um_core_free(context, grid);
  *count = n;
  return status;
}

enum um_status um_model_load_edges(struct um_context *context, const struct um_model *model,
                                   const struct um_model_tables *tables, double **out)
{
  UM_TRY(um_core_allocate(context, tables->nevent, sizeof **out, out));
  for (size_t i = 0; i < tables->nevent; i++) (*out)[i] = event_time(model, &tables->event[i]).t;
  return UM_OK;
}
