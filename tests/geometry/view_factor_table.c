/* View factors over the angles of joints: at a pose of the lattice those of the pose, between two
 * of them close to those traced there, closed and reciprocal everywhere. */
#include "geometry/view_factor_table.h"

#include "tests/geometry/support.h"

/* A box with wings beside two of its walls that turn about y after the Sun. */
static size_t satellite(struct um_geometry_part_spec part[3], size_t wings)
{
  part[0] = support_box("bus", 1, 1, 1);
  for (size_t k = 0; k < wings; k++) {
    part[1 + k] = support_plate(k ? "left" : "right", 1.2, 1, um_vec3(0, k ? -1.1 : 1.1, 0));
    part[1 + k].joint = UM_JOINT_SUN;
    part[1 + k].joint_axis = um_vec3(0, 1, 0);
    part[1 + k].joint_normal = um_vec3(0, 0, 1);
    part[1 + k].facet_size = 0.6;
  }
  part[0].facet_size = 0.6;
  return 1 + wings;
}

static struct um_geometry_view_factor_table *table_of(struct um_context *context,
                                                      const struct um_geometry *geometry,
                                                      const double *angles, size_t ntime,
                                                      size_t rays)
{
  struct um_geometry_view_factor_options options;
  struct um_geometry_view_factor_table *table = NULL;
  um_geometry_view_factor_defaults(&options);
  options.rays = rays;
  if (um_geometry_view_factor_table_create(context, geometry, angles, ntime, 64, &options,
                                           &table) != UM_OK)
    fail_msg("%s", um_core_message(context));
  return table;
}

/* Share of what the whole of the wings sends that arrives at the bus, at a time of the table. */
static double to_bus(const struct um_geometry *geometry,
                     const struct um_geometry_view_factor_table *t, size_t time)
{
  const struct um_geometry_surface *surface = um_geometry_mesh(geometry)->surface;
  double sum = 0.0, area = 0.0;
  for (size_t p = 0; p < t->patches->npatch; p++) {
    if (surface[t->patches->surface[t->patches->begin[p]]].part == 0) continue;
    area += t->patches->area[p];
    for (size_t q = 0; q < t->patches->npatch; q++) {
      if (surface[t->patches->surface[t->patches->begin[q]]].part != 0) continue;
      for (size_t c = 0; c < t->ncorner; c++)
        sum += t->weight[time * t->ncorner + c] *
               um_geometry_view_factors_area(t->pose[t->corner[time * t->ncorner + c]], p, q);
    }
  }
  return sum / area;
}

static void one_wing(void **state)
{
  (void)state;
  struct um_geometry_part_spec part[3];
  struct support s = support_create(part, satellite(part, 1));
  /* at a pose, between two, across the turn */
  const double angle[4] = {30 * UM_DEG, 37.5 * UM_DEG, 44 * UM_DEG, -7.5 * UM_DEG};
  struct um_geometry_view_factor_table *t = table_of(s.context, s.geometry, angle, 4, 16384);
  assert_close(t->step, 15 * UM_DEG, 1e-12);
  assert_int_equal(t->npose, 4); /* 30, 45, 345, 0 */
  for (size_t k = 0; k < 4; k++) {
    struct um_geometry_view_factor_table *own =
        table_of(s.context, s.geometry, angle + k, 1, 16384);
    double sum = 0.0;
    for (size_t c = 0; c < t->ncorner; c++) sum += t->weight[k * t->ncorner + c];
    assert_close(sum, 1.0, 1e-12);
    print_message("%5.1f deg: wing to bus %.5f, traced there %.5f\n", angle[k] / UM_DEG,
                  to_bus(s.geometry, t, k), to_bus(s.geometry, own, 0));
    assert_close(to_bus(s.geometry, t, k), to_bus(s.geometry, own, 0), k == 0 ? 1e-12 : 1e-3);
    um_geometry_view_factor_table_destroy(s.context, &own);
  }
  um_geometry_view_factor_table_destroy(s.context, &t);
  /* a whole turn: the error between poses is judged */
  double turn[72];
  for (int k = 0; k < 72; k++) turn[k] = (5.0 * k - 180.0) * UM_DEG;
  t = table_of(s.context, s.geometry, turn, 72, 4096);
  print_message("%zu poses, error of a view factor between them %.4f\n", t->npose,
                t->interpolation);
  assert_int_equal(t->npose, 24);
  assert_true(t->interpolation > 1e-4 && t->interpolation < 0.02);
  um_geometry_view_factor_table_destroy(s.context, &t);
  support_destroy(&s);
}

/* Two wings that turn together ask for the poses of one; that turn apart, for at most 64. */
static void two_wings(void **state)
{
  (void)state;
  struct um_geometry_part_spec part[3];
  struct support s = support_create(part, satellite(part, 2));
  double together[2 * 30], apart[2 * 200];
  for (int k = 0; k < 30; k++) together[2 * k] = together[2 * k + 1] = 4.0 * k * UM_DEG;
  struct um_geometry_view_factor_table *t = table_of(s.context, s.geometry, together, 30, 256);
  assert_int_equal(t->npose, 9); /* 0 to 120 */
  assert_int_equal(t->ncorner, 3);
  um_geometry_view_factor_table_destroy(s.context, &t);
  for (int k = 0; k < 200; k++) {
    apart[2 * k] = 1.8 * k * UM_DEG;
    apart[2 * k + 1] = 31.0 * k * UM_DEG;
  }
  t = table_of(s.context, s.geometry, apart, 200, 64);
  print_message("%zu poses %.1f deg apart\n", t->npose, t->step / UM_DEG);
  assert_true(t->npose <= 64 && t->step > 15.1 * UM_DEG);
  for (size_t k = 0; k < 200; k++) {
    double sum = 0.0;
    for (size_t c = 0; c < 3; c++) {
      assert_true(t->weight[3 * k + c] >= 0.0 && t->corner[3 * k + c] < t->npose);
      sum += t->weight[3 * k + c];
    }
    assert_close(sum, 1.0, 1e-8);
  }
  um_geometry_view_factor_table_destroy(s.context, &t);
  support_destroy(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(one_wing), cmocka_unit_test(two_wings)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
