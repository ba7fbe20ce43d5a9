/* A closed grey box that radiates inside against a radiosity network of its own, to 0.1 K over two
 * orbits. The network has six walls, or twelve where each has an inner layer; view factors of the
 * box from Howell's C-11 and C-14, radiosities J = e s T^4 + (1 - e) F J from six equations by
 * elimination, Runge-Kutta of the fourth order in steps of 1 s (0.5 s differ by less than 1e-6 K).
 * It takes the loads of the scenario, linear between their times, and nothing else. What is left is
 * the view factors by rays: 5e-4 of up to 200 W/m2 over 10 W/m2/K. */
#include <string.h>

#include "model/build/build.h"
#include "model/run/run.h"
#include "tests/scenarios/support.h"
#include "tests/support/view_factor_forms.h"
#include "thermal/network/body.h"
#include "thermal/network/network.h"

#define SCENARIO UMBRA_SOURCE_DIR "/tests/scenarios/data/box_inside.yaml"
#define WALLS    6

static const char *const wall[WALLS] = {"+x", "-x", "+y", "-y", "+z", "-z"};
static const double box[3] = {2, 1, 1};
static const double inside[WALLS] = {0.5, 0.5, 0.5, 0.1, 0.85, 0.5};

struct network {
  const struct support_run *run;
  size_t row;
  double area[WALLS], factor[WALLS][WALLS];
  double capacity[2 * WALLS];  /* outer layers, then inner ones [J/K] */
  double through;              /* [W/m2/K]; INFINITY: one layer */
  double joined[WALLS][WALLS]; /* [W/K] */
};

static void describe(struct network *n, const struct support_run *run, double through)
{
  *n = (struct network){.run = run, .through = through};
  for (int i = 0; i < WALLS; i++) {
    n->area[i] = box[(i / 2 + 1) % 3] * box[(i / 2 + 2) % 3];
    bool two = isfinite(through);
    n->capacity[i] = 1000.0 * n->area[i] * (two ? 0.3 : 1.0);
    n->capacity[WALLS + i] = 1000.0 * n->area[i] * 0.7;
    for (int j = 0; j < WALLS; j++) n->factor[i][j] = forms_box(box, i, j);
  }
  n->joined[0][2] = n->joined[2][0] = 1.0;
  n->joined[5][2] = n->joined[2][5] = 2.0;
}

/* Absorbed by the black walls at t [W]. */
static void absorbed(struct network *n, double t, double q[WALLS])
{
  const struct um_irradiation_loads *l = n->run->tables->loads;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(n->run->model->geometry);
  while (n->row > 0 && l->t[n->row] > t) n->row--;
  while (n->row + 2 < l->ntime && l->t[n->row + 1] <= t) n->row++;
  size_t k = n->row;
  double u = (t - l->t[k]) / (l->t[k + 1] - l->t[k]);
  u = fmin(fmax(u, 0.0), 1.0);
  double sun = ((1 - u) * l->irradiance[k] + u * l->irradiance[k + 1]) *
               ((1 - u) * l->sunlit[k] + u * l->sunlit[k + 1]);
  for (int i = 0; i < WALLS; i++) q[i] = 0.0;
  for (size_t s = 0; s < mesh->nsurface; s++) {
    const char *name = um_geometry_group(n->run->model->geometry, mesh->surface[s].group)->name;
    int i = 0;
    while (strcmp(name, wall[i]) != 0) i++;
    for (int side = 0; side < 2; side++) {
      size_t at = (k + (size_t)side) * l->nsurface + s;
      double weight = mesh->area[mesh->surface[s].facet] * (side ? u : 1 - u);
      q[i] += weight * (sun * (double)l->sun[at] + (double)l->albedo[at] + (double)l->planet[at]);
    }
  }
}

/* What every wall gains inside [W]: x of (1 - (1 - e) F) J = e s T^4. */
static void gains(const struct network *n, const double *t, double gain[WALLS])
{
  double m[WALLS][WALLS + 1];
  for (int i = 0; i < WALLS; i++) {
    for (int j = 0; j < WALLS; j++)
      m[i][j] = (i == j ? 1.0 : 0.0) - (1 - inside[i]) * n->factor[i][j];
    m[i][WALLS] = inside[i] * UM_STEFAN_BOLTZMANN * pow(t[i], 4);
  }
  for (int p = 0; p < WALLS; p++) /* diagonally dominant */
    for (int i = 0; i < WALLS; i++) {
      if (i == p) continue;
      double share = m[i][p] / m[p][p];
      for (int j = p; j <= WALLS; j++) m[i][j] -= share * m[p][j];
    }
  for (int i = 0; i < WALLS; i++) {
    double arrives = 0.0;
    for (int j = 0; j < WALLS; j++) arrives += n->factor[i][j] * m[j][WALLS] / m[j][j];
    gain[i] = n->area[i] * inside[i] * (arrives - UM_STEFAN_BOLTZMANN * pow(t[i], 4));
  }
}

static void rate(struct network *n, double time, const double *t, double *out)
{
  double q[WALLS], gain[WALLS];
  bool two = isfinite(n->through);
  const double *inner = two ? t + WALLS : t;
  absorbed(n, time, q);
  gains(n, inner, gain);
  for (int i = 0; i < WALLS; i++) {
    double heat = q[i] - n->area[i] * UM_STEFAN_BOLTZMANN * pow(t[i], 4), in = gain[i];
    if (two) {
      double flow = n->through * n->area[i] * (t[i] - t[WALLS + i]);
      heat -= flow;
      in += flow;
    }
    /* contacts of groups meet outer layers */
    for (int j = 0; j < WALLS; j++) heat += n->joined[i][j] * (t[j] - t[i]);
    out[i] = (two ? heat : heat + in) / n->capacity[i];
    if (two) out[WALLS + i] = in / n->capacity[WALLS + i];
  }
}

static void step(struct network *n, double time, double h, double *t)
{
  double k[4][2 * WALLS] = {{0}}, y[2 * WALLS];
  static const double at[4] = {0.0, 0.5, 0.5, 1.0};
  for (int s = 0; s < 4; s++) {
    for (int i = 0; i < 2 * WALLS; i++) y[i] = t[i] + (s > 0 ? at[s] * h * k[s - 1][i] : 0.0);
    rate(n, time + at[s] * h, y, k[s]);
  }
  for (int i = 0; i < 2 * WALLS; i++)
    t[i] += h / 6.0 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
}

/* Largest difference of a wall, and how far the same box without an inside would be [K]. */
static void follow(const char *const *set, size_t nset, double through)
{
  struct support_run run, dark;
  static const char *const off[] = {"parts.box.inside_emittance=0",
                                    "parts.box.groups.+z.inside_emittance=0",
                                    "parts.box.groups.-y.inside_emittance=0"};
  struct network n;
  double t[2 * WALLS], worst = 0.0, without = 0.0, now;
  support_compute(SCENARIO, set, nset, &run);
  support_compute(SCENARIO, off, 3, &dark);
  describe(&n, &run, through);
  for (int i = 0; i < 2 * WALLS; i++) t[i] = 293.15;
  now = run.tables->loads->t[0];
  for (size_t k = 0; k < run.result->nobs; k++) {
    double until = run.tables->sample[k].t_tai;
    while (now < until - 1e-6) {
      double h = fmin(1.0, until - now);
      step(&n, now, h, t);
      now += h;
    }
    for (int i = 0; i < WALLS; i++) {
      char place[32];
      snprintf(place, sizeof place, "box.%s", wall[i]);
      double ours = support_temperature(&run, place)[k];
      support_close(place, ours, t[i], 0.1);
      worst = fmax(worst, fabs(ours - t[i]));
      without = fmax(without, fabs(support_temperature(&dark, place)[k] - t[i]));
      if (!isfinite(through)) continue;
      snprintf(place, sizeof place, "box.%s.inside", wall[i]);
      support_close(place, support_temperature(&run, place)[k], t[WALLS + i], 0.1);
    }
  }
  print_message("walls within %.4f K of the network over two orbits; without an inside %.1f K off, "
                "audit %.1e\n",
                worst, without, run.result->audit_error);
  assert_true(without > 20.0);
  assert_true(run.result->audit_error < 1e-6);
  support_release(&run);
  support_release(&dark);
}

static void one_layer(void **state)
{
  (void)state;
  follow(NULL, 0, INFINITY);
}

static void two_layers(void **state)
{
  (void)state;
  static const char *const set[] = {"parts.box.shell.through_conductance_W_m2_K=12"};
  follow(set, 1, 12.0);
}

/* What was traced while mutual radiation is off serves a model that has it on, as a diagnosis asks.
 */
static void switched_on(void **state)
{
  (void)state;
  static const char *const without[] = {"effects.+={effect: mutual_radiation, off: true}"};
  struct support_run off, on;
  struct um_model *model = NULL;
  struct um_model_result *result = NULL;
  support_compute(SCENARIO, without, 1, &off);
  support_compute(SCENARIO, NULL, 0, &on);
  if (um_model_create(off.context, SCENARIO, NULL, &model) != UM_OK ||
      um_model_run(off.context, model, off.tables, &result) != UM_OK)
    fail_msg("%s", um_core_message(off.context));
  um_model_result_destroy(off.context, &off.result);
  off.result = result;
  for (int i = 0; i < WALLS; i++)
    for (size_t k = 0; k < on.result->nobs; k++) {
      char place[32];
      snprintf(place, sizeof place, "box.%s", wall[i]);
      support_close(place, support_temperature(&off, place)[k], support_temperature(&on, place)[k],
                    0.0);
    }
  um_model_destroy(off.context, &model);
  support_release(&off);
  support_release(&on);
}

/* Whoever withholds mutual radiation withholds the inside. */
static void withheld(void **state)
{
  (void)state;
  static const char *const without[] = {"effects.+={effect: mutual_radiation, off: true}"};
  static const char *const off[] = {"parts.box.inside_emittance=0",
                                    "parts.box.groups.+z.inside_emittance=0",
                                    "parts.box.groups.-y.inside_emittance=0"};
  struct support_run a, b;
  support_compute(SCENARIO, without, 1, &a);
  support_compute(SCENARIO, off, 3, &b);
  for (int i = 0; i < WALLS; i++)
    for (size_t k = 0; k < a.result->nobs; k++) {
      char place[32];
      snprintf(place, sizeof place, "box.%s", wall[i]);
      support_close(place, support_temperature(&a, place)[k], support_temperature(&b, place)[k],
                    0.0);
    }
  support_release(&a);
  support_release(&b);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(one_layer), cmocka_unit_test(two_layers),
                                     cmocka_unit_test(withheld), cmocka_unit_test(switched_on)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
