/* Effects on geometry: a part of another area, a joint at another angle. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "tests/effects/case.h"
#include "tests/support/cmocka_all.h"

/* One plate alone: everything that it sends scales with its area, and its temperature, which is a
 * matter of fluxes and capacity per area, stays. Lengths are scaled by sqrt(1.21), so that the
 * areas are those of the scenario to rounding; temperatures agree to the integrator's tolerance (a
 * rounding can change its steps; 1e-9 relative is asked for), the light with them. */
static void area_scales_everything(void **state)
{
  (void)state;
  static const char *const with[] = {"area:plate,factor=1.21", NULL},
                           *const set[] = {"thermal.relative_tolerance=1e-9",
                                           "thermal.absolute_tolerance_K=1e-7", NULL};
  struct case_run a = case_compute(case_plate, NULL, NULL, set);
  struct case_run b = case_compute(case_plate, with, NULL, set);
  const struct um_geometry_mesh *x = um_geometry_mesh(a.model->geometry);
  const struct um_geometry_mesh *y = um_geometry_mesh(b.model->geometry);
  assert_int_equal(x->nfacet, y->nfacet);
  for (size_t f = 0; f < x->nfacet; f++) case_near("facet", y->area[f], 1.21 * x->area[f], 1e-12);
  for (size_t i = 0; i < a.result->nobs * a.result->nsurface; i++)
    case_near("temperature", b.result->surface_temperature[i], a.result->surface_temperature[i],
              1e-7);
  for (size_t i = 0; i < a.result->nobs * a.result->nband; i++)
    case_near("irradiance", b.result->irradiance[i], 1.21 * a.result->irradiance[i], 1e-6);
  case_release(&a);
  case_release(&b);
}

/* All shapes and a mesh: every area of the part grows by the factor, mesh topology stays, other
 * parts stay. */
static void area_acts_on_every_shape(void **state)
{
  (void)state;
  static const char *const shapes[] = {
      "box: {size_m: [1, 2, 3]}, outside: grey_white",
      "plate: {size_m: [1, 2]}, front: grey_white, back: grey_white",
      "disc: {radius_m: 0.7}, front: grey_white, back: grey_white",
      "cylinder: {radius_m: 0.7, height_m: 2}, outside: grey_white",
      "cone: {radius_m: 0.7, radius_top_m: 0.3, height_m: 2}, outside: grey_white",
      "sphere: {radius_m: 0.7}, outside: grey_white",
      "paraboloid: {radius_m: 0.7, focal_length_m: 0.5}, front: grey_white, back: grey_white"};
  for (size_t s = 0; s < sizeof shapes / sizeof shapes[0]; s++) {
    char scenario[2048];
    snprintf(scenario, sizeof scenario,
             "schema: 1\nname: shapes\n"
             "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:00:00Z, step_s: 60}\n"
             "orbit: {fixed: {position_gcrs_km: [3000, 6500, 1000]}}\n"
             "attitude: [{fixed: {q_gcrs: [1, 0, 0, 0]}}]\n"
             "parts:\n"
             "  - {name: one, %s, lumped: true, facet_size_m: 0.4,\n"
             "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
             "  - {name: two, box: {size_m: [1, 1, 1]}, pose: {position_m: [9, 0, 0]},\n"
             "     outside: grey_white, lumped: true, shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
             "thermal: {start: isothermal, orbits_before: 0}\n",
             shapes[s]);
    struct case_run a = case_with(scenario, NULL), b = case_with(scenario, "area:one,factor=0.8");
    const struct um_geometry_mesh *x = um_geometry_mesh(a.model->geometry);
    const struct um_geometry_mesh *y = um_geometry_mesh(b.model->geometry);
    assert_int_equal(x->nfacet, y->nfacet);
    for (size_t f = 0; f < x->nfacet; f++)
      case_near(shapes[s], y->area[f], (x->facet_part[f] == 0 ? 0.8 : 1.0) * x->area[f], 1e-12);
    case_release(&a);
    case_release(&b);
  }
}

/* The offset is the joint's own angle: the same scene as with that angle in the scenario. */
static void array_angle_turns_a_fixed_joint(void **state)
{
  (void)state;
  static const char *const set[] = {"parts.plate.joint.angle_deg=12", NULL};
  struct case_run a = case_compute(case_plate, NULL, NULL, set);
  struct case_run b = case_with(case_plate, "array_angle:plate,angle_deg=12");
  struct case_run plain = case_with(case_plate, NULL);
  assert_true(case_same(&a, &b));
  assert_false(case_same(&plain, &b));
  case_release(&a);
  case_release(&b);
  case_release(&plain);
}

/* A wing that tracks the Sun about y reaches the cosine sqrt(1 - s_y^2); 10 deg beside it, cos 10
 * deg of that. The loads are kept as float. */
static void array_angle_offsets_tracking(void **state)
{
  (void)state;
  struct case_run a = case_with(case_satellite, "array_angle:wing,angle_deg=10");
  const struct um_geometry_mesh *mesh = um_geometry_mesh(a.model->geometry);
  size_t seen = 0;
  for (size_t k = 0; k < a.tables->nobs; k++) {
    struct um_vec3 sun = um_quat_apply(a.tables->sample[k].q, a.tables->sample[k].sun);
    double expected = sqrt(1.0 - sun.y * sun.y) * cos(10.0 * UM_DEG);
    struct um_geometry_pose *pose = NULL;
    double angle;
    um_geometry_joint_angles(a.model->geometry, sun, 0.0, &angle);
    assert_int_equal(um_geometry_pose_create(case_context(), a.model->geometry, &angle, &pose),
                     UM_OK);
    for (size_t s = 0; s < mesh->nsurface; s++)
      if (mesh->surface[s].part == 1 && !mesh->surface[s].back) {
        case_near("cosine", um_vec3_dot(um_geometry_surface_normal(mesh, pose, s), sun), expected,
                  1e-12);
        seen++;
      }
    um_geometry_pose_destroy(case_context(), &pose);
  }
  assert_true(seen > 0);
  case_release(&a);
}

static void array_angle_wants_a_joint(void **state)
{
  (void)state;
  case_refused(case_satellite, "array_angle:box,angle_deg=5", "part 'box' has no joint");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(area_scales_everything),
      cmocka_unit_test(area_acts_on_every_shape),
      cmocka_unit_test(array_angle_turns_a_fixed_joint),
      cmocka_unit_test(array_angle_offsets_tracking),
      cmocka_unit_test(array_angle_wants_a_joint),
  };
  return cmocka_run_group_tests(tests, case_begin, case_end);
}
