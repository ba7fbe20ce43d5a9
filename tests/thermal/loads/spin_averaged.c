/* Loads over a turn against closed forms: a ball far from the Earth that spins across the Sun,
 * every facet of it a plate whose normal n goes round the axis a,
 *
 *   n . s = c cos(phase),  c = |n - (n . a) a|         Sun s across the axis
 *
 *   mean of max(n . s, 0)            c / pi
 *   the same of (n . s) max(n . s, 0)    c^2 / 4
 *   heat beyond the mean since its middle, at phase x in [-pi, pi] of the facet
 *       P / (2 pi) (S(x) - x c / pi),  S(x) = c sin x, held at +-c behind the edges
 *
 * and before an Earth of small angle the same of its direction. */
#include "tests/thermal/body_help.h"
#include "thermal/loads/loads.h"

#define ROWS   50
#define NODES  64
#define PERIOD 5.0
#define WORST  (1.1 / (NODES * NODES)) /* of a mean, as the header says */

static struct um_environment environment;

static int setup(void **state)
{
  um_environment_defaults(&environment);
  return help_setup(state);
}

/* Phase 0 at the sample's own time; the turn goes about -z. */
static enum um_status turned(void *self, size_t row, double before, struct um_quat *q)
{
  (void)self, (void)row;
  double half = UM_PI * before / PERIOD; /* a body that was ahead by so much turns about -z */
  *q = (struct um_quat){cos(half), 0.0, 0.0, sin(half)};
  return UM_OK;
}

static struct um_irradiation_loads *trace(const struct help_satellite *s, bool variation)
{
  struct um_environment_sample sample[ROWS];
  struct um_irradiation_loads *loads = NULL;
  struct um_irradiation_spin spin = {
      .n = NODES, .period = PERIOD, .variation = variation, .attitude = turned};
  for (size_t k = 0; k < ROWS; k++)
    sample[k] = (struct um_environment_sample){.t_tai = 10.0 * (double)k,
                                               .r = {-1e9, 0.0, 0.0},
                                               .sun = {0.0, 1.0, 0.0},
                                               .sun_distance = UM_AU,
                                               .pole = {0.0, 0.0, 1.0},
                                               .sunlit_fraction = 1.0,
                                               .q = {1.0, 0.0, 0.0, 0.0}};
  const struct um_irradiation_loads_options options = {.nsample = 1, .spin = &spin};
  OK(um_irradiation_loads_make(help_context, s->geometry, &environment, sample, ROWS, NULL, 0,
                               &options, &loads));
  return loads;
}

static void ball(struct help_satellite *s)
{
  size_t p = help_part(s, "ball", UM_SHAPE_SPHERE, NULL);
  s->shape[p].radius = 1.0;
  s->shape[p].facet_size = 0.8;
  help_geometry(s);
}

/* sum of by_cosine times (cosine of its node)^power; a cubic in the root is exact, so up to 1.5. */
static double moment(const struct um_irradiation_loads *loads, size_t at, double power)
{
  double sum = 0.0;
  for (size_t b = 0; b < UM_IRRADIATION_COSINES; b++)
    sum += (double)loads->by_cosine[at * UM_IRRADIATION_COSINES + b] *
           pow((double)b / (UM_IRRADIATION_COSINES - 1), 2.0 * power);
  return sum;
}

static void test_mean(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  ball(&s);
  const struct um_geometry_mesh *mesh = um_geometry_mesh(s.geometry);
  struct um_geometry_pose *pose = NULL;
  OK(um_geometry_pose_create(help_context, s.geometry, NULL, &pose));
  struct um_irradiation_loads *loads = trace(&s, false);
  double earth = environment.earth_radius / 1e9;
  for (size_t i = 0; i < mesh->nsurface; i++) {
    struct um_vec3 n = um_geometry_surface_normal(mesh, pose, i);
    double c = hypot(n.x, n.y), rows = 0.0, planet = 0.0;
    for (size_t k = 0; k < ROWS; k++) {
      size_t at = k * mesh->nsurface + i;
      NEAR("mean of a row", (double)loads->sun[at], c / UM_PI, WORST);
      NEAR("all cosines", moment(loads, at, 0.0), (double)loads->sun[at], 1e-6);
      NEAR("mean square", moment(loads, at, 1.0), 0.25 * c * c, WORST);
      rows += (double)loads->sun[at] / ROWS;
      planet += (double)loads->planet[at] / ROWS;
    }
    /* shifts of the golden section: their mean error is below 1 / rows of the worst */
    NEAR("mean over rows", rows, c / UM_PI, WORST * 3.0 / ROWS);
    /* (R / r)^2 max(cos); seen edge-on an Earth of angle R / r shows a strip of that share more */
    NEAR("planet", planet / (environment.outgoing_longwave * earth * earth), c / UM_PI,
         WORST + earth);
  }
  um_irradiation_loads_destroy(help_context, &loads);
  um_geometry_pose_destroy(help_context, &pose);
  help_end(&s);
}

static void test_variation(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  ball(&s);
  const struct um_geometry_mesh *mesh = um_geometry_mesh(s.geometry);
  struct um_geometry_pose *pose = NULL;
  OK(um_geometry_pose_create(help_context, s.geometry, NULL, &pose));
  struct um_irradiation_loads *loads = trace(&s, true);
  double largest = 0.0;
  for (size_t i = 0; i < mesh->nsurface; i++) {
    struct um_vec3 n = um_geometry_surface_normal(mesh, pose, i);
    double c = hypot(n.x, n.y), x = atan2(n.x, n.y); /* from -x over +y, the Sun, to +x */
    double sine = fabs(x) < 0.5 * UM_PI ? sin(x) : x > 0.0 ? 1.0 : -1.0;
    double expected = PERIOD / (2.0 * UM_PI) * c * (sine - x / UM_PI);
    for (size_t k = 0; k < ROWS; k++)
      NEAR("variation", (double)loads->sun[k * mesh->nsurface + i], expected, PERIOD * WORST);
    largest = fmax(largest, fabs(expected) * 2.0 * UM_PI / PERIOD);
  }
  /* half the range of what the bound of thermal/solver/spin_variation.h takes as 0.55 */
  NEAR("range", largest, 0.55, 0.01);
  um_irradiation_loads_destroy(help_context, &loads);
  um_geometry_pose_destroy(help_context, &pose);
  help_end(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_mean), cmocka_unit_test(test_variation)};
  return cmocka_run_group_tests_name("irradiation_spin_averaged", tests, setup, help_teardown);
}
