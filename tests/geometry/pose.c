/* Poses, nested parents, joints. */
#include "tests/geometry/support.h"

static struct um_vec3 centre_of(const struct support *s, const struct um_geometry_pose *pose,
                                uint32_t part)
{
  struct um_vec3 sum = um_vec3(0, 0, 0);
  double area = 0.0;
  for (size_t f = 0; f < s->mesh->nfacet; f++) {
    if (s->mesh->facet_part[f] != part) continue;
    for (int k = 0; k < 3; k++)
      sum = um_vec3_axpy(sum, s->mesh->area[f] / 3.0, pose->vertex[s->mesh->corner[f][k]]);
    area += s->mesh->area[f];
  }
  return um_vec3_scale(sum, 1.0 / area);
}

static struct um_vec3 normal_of(const struct support *s, const struct um_geometry_pose *pose,
                                uint32_t part)
{
  for (size_t f = 0; f < s->mesh->nfacet; f++)
    if (s->mesh->facet_part[f] == part) return pose->facet_normal[f];
  return um_vec3(0, 0, 0);
}

static void assert_vector(struct um_vec3 v, double x, double y, double z)
{
  assert_close(v.x, x, 1e-14);
  assert_close(v.y, y, 1e-14);
  assert_close(v.z, z, 1e-14);
}

/* A passive turn of +90 degrees about z takes the part's x axis to the body's y axis. */
static void passive_rotation(void **state)
{
  (void)state;
  struct um_geometry_part_spec plate = support_plate("p", 2, 1, um_vec3(1, 2, 3));
  plate.rotation = um_quat_from_axis(um_vec3(0, 1, 0), 0.5 * UM_PI);
  struct support s = support_create(&plate, 1);
  /* the part's z axis, its normal, lies along the body's x axis */
  assert_vector(normal_of(&s, s.pose, 0), 1, 0, 0);
  assert_vector(centre_of(&s, s.pose, 0), 1, 2, 3);
  support_destroy(&s);
}

/* The child is listed before its parent; its place is parent + R^T offset. */
static void nested_parents(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[] = {support_plate("wing", 2, 1, um_vec3(0, 4, 0)),
                                          support_box("boom", 0.1, 3, 0.1),
                                          support_box("bus", 1, 1, 1)};
  parts[0].parent = "boom";
  parts[1].parent = "bus";
  parts[1].position = um_vec3(2, 0, 0);
  parts[1].rotation = um_quat_from_axis(um_vec3(0, 0, 1), 0.5 * UM_PI);
  parts[2].position = um_vec3(0, 0, 5);
  struct support s = support_create(parts, 3);
  /* boom's y axis is the body's -x: 2 - 4 */
  assert_vector(centre_of(&s, s.pose, 0), -2, 0, 5);
  assert_vector(centre_of(&s, s.pose, 1), 2, 0, 5);
  support_destroy(&s);
}

/* Joint turned by a fixed angle carries its child along. */
static void fixed_joint(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[] = {support_box("yoke", 0.1, 0.1, 0.1),
                                          support_plate("wing", 2, 1, um_vec3(3, 0, 0))};
  parts[0].joint = UM_JOINT_FIXED;
  parts[0].joint_axis = um_vec3(0, 1, 0);
  parts[0].joint_angle = 0.5 * UM_PI;
  parts[1].parent = "yoke";
  struct support s = support_create(parts, 2);
  assert_int_equal(um_geometry_joint_count(s.geometry), 1);
  assert_false(um_geometry_joint_moves(s.geometry));
  double angle = 7.0;
  um_geometry_joint_angles(s.geometry, um_vec3(0, 0, 1), 0.0, &angle);
  assert_close(angle, 0.5 * UM_PI, 0.0);
  /* +90 degrees about y turns x to -z and z to x */
  assert_vector(centre_of(&s, s.pose, 1), 0, 0, -3);
  assert_vector(normal_of(&s, s.pose, 1), 1, 0, 0);
  support_destroy(&s);
}

static struct um_geometry_part_spec sun_wing(void)
{
  struct um_geometry_part_spec wing = support_plate("wing", 2, 1, um_vec3(0, 3, 0));
  wing.joint = UM_JOINT_SUN;
  wing.joint_axis = um_vec3(0, 1, 0);
  wing.joint_normal = um_vec3(0, 0, 1);
  return wing;
}

/* The tracked normal makes the largest cosine with the Sun that one axis allows:
 * sqrt(1 - (a . s)^2) for a normal at right angles to the axis. */
static void sun_joint_tracks(void **state)
{
  (void)state;
  struct um_geometry_part_spec wing = sun_wing();
  wing.rotation = um_quat_from_axis(um_vec3_unit(um_vec3(1, -2, 0.5)), 1.234);
  struct support s = support_create(&wing, 1);
  assert_true(um_geometry_joint_moves(s.geometry));
  struct um_vec3 axis = um_quat_apply(um_quat_conjugate(wing.rotation), wing.joint_axis);
  for (uint64_t i = 0; i < 100; i++) {
    double u[2], angle;
    um_core_sample_2d(3, i, u);
    struct um_vec3 sun = um_core_sample_cosine(u, um_vec3(0, 0, i % 2 == 0 ? 1 : -1));
    um_geometry_joint_angles(s.geometry, sun, 0.0, &angle);
    struct um_geometry_pose *pose;
    assert_int_equal(um_geometry_pose_create(s.context, s.geometry, &angle, &pose), UM_OK);
    double along = um_vec3_dot(axis, sun);
    assert_close(um_vec3_dot(normal_of(&s, pose, 0), sun), sqrt(1.0 - along * along), 1e-13);
    assert_vector(centre_of(&s, pose, 0), 0, 3, 0);
    um_geometry_pose_destroy(s.context, &pose);
  }
  double angle;
  um_geometry_joint_angles(s.geometry, axis, 0.0, &angle);
  assert_close(angle, 0.0, 0.0); /* the Sun along the axis */
  support_destroy(&s);
}

/* Two axes, one on the other (outer about y, inner about x), point the wing straight at the Sun:
 * the outer removes the x component, the inner does the rest. The inner one is listed first. */
static void nested_sun_joints(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[] = {sun_wing(), support_box("yoke", 0.1, 0.1, 0.1)};
  parts[0].parent = "yoke";
  parts[0].joint_axis = um_vec3(1, 0, 0);
  parts[1].joint = UM_JOINT_SUN;
  parts[1].joint_axis = um_vec3(0, 1, 0);
  parts[1].joint_normal = um_vec3(0, 0, 1);
  struct support s = support_create(parts, 2);
  for (uint64_t i = 0; i < 100; i++) {
    double u[2], angles[2];
    um_core_sample_2d(4, i, u);
    struct um_vec3 sun = um_core_sample_cosine(u, um_vec3(0, 0, i % 2 == 0 ? 1 : -1));
    um_geometry_joint_angles(s.geometry, sun, 0.0, angles);
    struct um_geometry_pose *pose;
    assert_int_equal(um_geometry_pose_create(s.context, s.geometry, angles, &pose), UM_OK);
    assert_close(um_vec3_dot(normal_of(&s, pose, 0), sun), 1.0, 1e-13);
    um_geometry_pose_destroy(s.context, &pose);
  }
  support_destroy(&s);
}

/* An offset of the joint turns the wing away by that angle. */
static void sun_joint_offset(void **state)
{
  (void)state;
  struct um_geometry_part_spec wing = sun_wing();
  wing.joint_angle = 0.3;
  struct support s = support_create(&wing, 1);
  double angle;
  um_geometry_joint_angles(s.geometry, um_vec3(1, 0, 0), 0.0, &angle);
  assert_close(angle, 0.5 * UM_PI + 0.3, 1e-15);
  support_destroy(&s);
}

/* By time: linear, the later row of a jump, the ends held; the joint's own angle is added. */
static void scheduled_joint(void **state)
{
  (void)state;
  const double t[] = {10, 20, 20, 30}, turn[] = {0, 1, 2, 4};
  static const struct {
    double t, angle;
  } at[] = {{-INFINITY, 0.0}, {10, 0.0}, {15, 0.5}, {20, 2.0}, {25, 3.0}, {30, 4.0}, {99, 4.0}};
  struct um_geometry_part_spec wing = support_plate("wing", 2, 1, um_vec3(0, 3, 0));
  wing.joint = UM_JOINT_SCHEDULE;
  wing.joint_axis = um_vec3(0, 1, 0);
  wing.joint_angle = 0.25;
  wing.schedule = (struct um_geometry_schedule){4, t, turn};
  struct support s = support_create(&wing, 1);
  assert_true(um_geometry_joint_moves(s.geometry));
  for (size_t i = 0; i < sizeof at / sizeof at[0]; i++) {
    double angle;
    um_geometry_joint_angles(s.geometry, um_vec3(0, 0, 1), at[i].t, &angle);
    assert_close(angle, at[i].angle + 0.25, 1e-15);
  }
  const double later[] = {0, 1, 2, 5};
  wing.schedule.angle = later;
  struct support other = support_create(&wing, 1);
  assert_true(um_geometry_equal(s.geometry, s.geometry));
  assert_false(um_geometry_equal(s.geometry, other.geometry));
  support_destroy(&other);
  support_destroy(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(scheduled_joint),  cmocka_unit_test(passive_rotation),
      cmocka_unit_test(nested_parents),   cmocka_unit_test(fixed_joint),
      cmocka_unit_test(sun_joint_tracks), cmocka_unit_test(nested_sun_joints),
      cmocka_unit_test(sun_joint_offset)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
