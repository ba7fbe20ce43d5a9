/* The inside of closed parts: boxes against Howell's C-11 and C-14, the sphere, whose inside sees
 * every piece of itself alike, and what surrounds or fills the room not at all. */
#include "geometry/inside.h"

#include "tests/geometry/support.h"
#include "tests/support/allocator.h"
#include "tests/support/view_factor_forms.h"

static struct um_geometry_view_factor_table *table_of(const struct support *s, size_t outside)
{
  struct um_geometry_view_factor_options options;
  struct um_geometry_view_factor_table *table = NULL;
  um_geometry_view_factor_defaults(&options);
  if (um_geometry_view_factor_table_create(s->context, s->geometry, NULL, 1, outside, &options,
                                           &table) != UM_OK)
    fail_msg("%s", um_core_message(s->context));
  return table;
}

static const struct um_geometry_room *add(const struct support *s, uint32_t part, size_t limit,
                                          struct um_geometry_view_factor_table *table)
{
  struct um_geometry_view_factor_options options;
  um_geometry_view_factor_defaults(&options);
  if (um_geometry_inside_add(s->context, s->geometry, part, limit, &options, table) != UM_OK)
    fail_msg("%s", um_core_message(s->context));
  return &table->room[table->nroom - 1];
}

/* Rows sum to their areas with nothing to space, the same number stands for both ways. */
static void assert_closed(const struct um_geometry_view_factor_table *t,
                          const struct um_geometry_room *room)
{
  const struct um_geometry_view_factors *f = room->factors;
  for (size_t p = 0; p < f->npatch; p++) {
    double sum = 0.0, area = t->patches->area[room->first + p];
    for (size_t e = f->begin[p]; e < f->begin[p + 1]; e++) {
      sum += f->area[e];
      assert_close(um_geometry_view_factors_area(f, f->other[e], p), f->area[e], 0.0);
    }
    assert_close(f->space[p], 0.0, 0.0);
    assert_close(sum, area, 1e-12 * area);
  }
}

static void boxes(void **state)
{
  (void)state;
  static const double size[2][3] = {{1, 1, 1}, {2, 1, 0.4}};
  assert_close(forms_box(size[0], 0, 1), 0.199825, 1e-6);
  assert_close(forms_box(size[0], 0, 2), 0.200044, 1e-6);
  for (int k = 0; k < 2; k++) {
    const double *l = size[k];
    struct um_geometry_part_spec part = support_box("bus", l[0], l[1], l[2]);
    part.facet_size = 0.5;
    part.position = um_vec3(30, -4, 2);
    part.rotation = um_quat_from_axis(um_vec3(0.6, 0, 0.8), 1.0);
    struct support s = support_create(&part, 1);
    struct um_geometry_view_factor_table *t = table_of(&s, 64);
    assert_int_equal(t->noutside, 0); /* convex: nothing outside */
    const struct um_geometry_room *room = add(&s, 0, 0, t);
    assert_int_equal(room->factors->npatch, 6);
    assert_int_equal(t->patches->nsurface, s.mesh->nsurface + s.mesh->nfacet);
    assert_closed(t, room);
    double worst = 0.0;
    for (int i = 0; i < 6; i++) {
      double sum = 0.0;
      for (int j = 0; j < 6; j++) {
        double f = um_geometry_view_factors_area(room->factors, (size_t)i, (size_t)j) /
                   t->patches->area[i];
        worst = fmax(worst, fabs(f - forms_box(l, i, j)));
        sum += forms_box(l, i, j);
      }
      assert_close(sum, 1.0, 1e-12);
    }
    print_message("box %g x %g x %g: view factors within %.1e, row sums as sampled %.1e\n", l[0],
                  l[1], l[2], worst, room->factors->unclosed);
    assert_true(worst < 5e-4); /* half of what closure is to bring (1e-3) */
    um_geometry_view_factor_table_destroy(s.context, &t);
    support_destroy(&s);
  }
}

/* Inside a sphere F_pq = A_q / A (Howell C-138), A_p F_pp of a patch itself included. */
static void sphere(void **state)
{
  (void)state;
  struct um_geometry_part_spec part = {.name = "ball",
                                       .shape = UM_SHAPE_SPHERE,
                                       .radius = 0.7,
                                       .rotation = {1, 0, 0, 0},
                                       .skins = &support_closed,
                                       .nskin = 1,
                                       .facet_size = 0.15};
  struct support s = support_create(&part, 1);
  struct um_geometry_view_factor_table *t = table_of(&s, 64);
  const struct um_geometry_room *room = add(&s, 0, 8, t);
  double all = 0.0, worst = 0.0;
  assert_int_equal(room->factors->npatch, 8);
  assert_closed(t, room);
  for (size_t p = 0; p < 8; p++) all += t->patches->area[p];
  for (size_t p = 0; p < 8; p++)
    for (size_t q = 0; q < 8; q++)
      worst = fmax(worst,
                   fabs(um_geometry_view_factors_area(room->factors, p, q) / t->patches->area[p] -
                        t->patches->area[q] / all));
  print_message("sphere of %zu facets: view factors within %.1e\n", s.mesh->nfacet, worst);
  assert_true(worst < 2e-3); /* facets are not the sphere: O(h^2) = (0.15 / 0.7)^2 / 24 of 1/8 */
  um_geometry_view_factor_table_destroy(s.context, &t);
  support_destroy(&s);
}

/* A tank in a bus, a wing beside: the bus does not see the tank, the outside is as it was, and
 * patches of two rooms stand behind it. */
static void rooms_apart(void **state)
{
  (void)state;
  struct um_geometry_part_spec part[3] = {support_box("bus", 1, 1, 1),
                                          support_box("tank", 0.4, 0.4, 0.4),
                                          support_plate("wing", 1, 1, um_vec3(1.1, 0, 0))};
  struct support s = support_create(part, 3);
  struct um_geometry_view_factor_table *alone = table_of(&s, 64), *t = table_of(&s, 64);
  size_t outside = t->noutside;
  assert_true(outside > 0);
  const struct um_geometry_room *room = add(&s, 0, 0, t);
  assert_int_equal(room->first, outside);
  double f = um_geometry_view_factors_area(room->factors, 0, 1);
  assert_close(f, forms_box(part[0].size, 0, 1), 5e-4);
  room = add(&s, 1, 0, t);
  assert_int_equal(room->part, 1);
  assert_int_equal(room->first, outside + 6);
  assert_int_equal(t->patches->npatch, outside + 12);
  assert_close(t->patches->area[outside + 6], 0.16, 1e-12);
  for (size_t i = 0; i < t->patches->begin[outside + 12]; i++) {
    uint32_t surface = t->patches->surface[i];
    size_t p = t->patches->patch[surface];
    assert_true(i >= t->patches->begin[p] && i < t->patches->begin[p + 1]);
    if (p < outside) continue;
    size_t facet = surface - s.mesh->nsurface;
    assert_int_equal(s.mesh->facet_part[facet], p < outside + 6 ? 0 : 1);
  }
  assert_int_equal(alone->pose[0]->begin[outside], t->pose[0]->begin[outside]);
  for (size_t e = 0; e < alone->pose[0]->begin[outside]; e++)
    assert_close(alone->pose[0]->area[e], t->pose[0]->area[e], 0.0);
  um_geometry_view_factor_table_destroy(s.context, &alone);
  um_geometry_view_factor_table_destroy(s.context, &t);
  support_destroy(&s);
}

static void open_part(void **state)
{
  (void)state;
  struct um_geometry_part_spec part = support_plate("wing", 1, 1, um_vec3(0, 0, 0));
  struct support s = support_create(&part, 1);
  struct um_geometry_view_factor_options options;
  struct um_geometry_view_factor_table *t = table_of(&s, 64);
  um_geometry_view_factor_defaults(&options);
  assert_int_equal(um_geometry_inside_add(s.context, s.geometry, 0, 0, &options, t), UM_ERR_INPUT);
  assert_string_equal(um_core_message(s.context), "part wing has no inside: it is not closed");
  um_geometry_view_factor_table_destroy(s.context, &t);
  support_destroy(&s);
}

static void out_of_memory(void **state)
{
  (void)state;
  struct um_geometry_part_spec part = support_box("bus", 1, 1, 1);
  struct support s = support_create(&part, 1);
  struct um_test_memory memory = {0};
  struct um_core_allocator allocator = um_test_memory_allocator(&memory);
  struct um_context *small = NULL;
  struct um_geometry_view_factor_options options;
  um_geometry_view_factor_defaults(&options);
  assert_int_equal(um_core_context_create(&allocator, &small), UM_OK);
  um_core_context_set_threads(small, 1);
  long live = memory.alive, tries = 0;
  enum um_status status = UM_ERR_MEMORY;
  while (status != UM_OK) {
    struct um_geometry_view_factor_table *t = NULL;
    memory.fail_call = 0;
    assert_int_equal(
        um_geometry_view_factor_table_create(small, s.geometry, NULL, 1, 64, &options, &t), UM_OK);
    memory.calls = 0;
    memory.fail_call = ++tries;
    um_core_message_clear(small);
    status = um_geometry_inside_add(small, s.geometry, 0, 0, &options, t);
    if (status != UM_OK) assert_int_equal(status, UM_ERR_MEMORY);
    um_geometry_view_factor_table_destroy(small, &t);
    assert_int_equal(memory.alive, live);
  }
  assert_true(tries > 20);
  um_core_context_destroy(&small);
  support_destroy(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(boxes),     cmocka_unit_test(sphere),        cmocka_unit_test(rooms_apart),
      cmocka_unit_test(open_part), cmocka_unit_test(out_of_memory),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
