/* Exchange areas against closed forms (Howell, A Catalog of Radiation Heat Transfer Configuration
 * Factors, C-11, C-14, C-41): within 4 standard errors as sampled, within 1e-3 after closure;
 * closure and reciprocity; the elbow of an independent simulator (tests/reference/exchange.csv). */
#include "geometry/view_factors.h"

#include "tests/geometry/support.h"
#include "tests/support/allocator.h"

struct factors {
  struct support s;
  struct um_geometry_patches *patches;
  struct um_geometry_view_factors *f;
};

static enum um_status factors_make(struct factors *v, size_t limit, size_t rays, bool open)
{
  struct um_geometry_view_factor_options options;
  um_geometry_view_factor_defaults(&options);
  options.rays = rays;
  options.open = open;
  double *seen = calloc(v->s.mesh->nsurface, sizeof *seen);
  assert_non_null(seen);
  for (size_t i = 0; i < v->s.mesh->nsurface; i++)
    seen[i] = um_geometry_visibility_is_open(v->s.visibility, i) ? -1.0 : 1.0;
  enum um_status status =
      um_geometry_patches_create(v->s.context, v->s.mesh, v->s.pose, seen, limit, &v->patches);
  free(seen);
  if (status != UM_OK) return status;
  return um_geometry_view_factors_create(v->s.context, v->s.mesh, v->s.pose, v->s.visibility,
                                         v->patches, &options, &v->f);
}

static struct factors factors_of(const struct um_geometry_part_spec *parts, size_t npart,
                                 size_t limit, size_t rays, bool open)
{
  struct factors v = {.s = support_create(parts, npart)};
  if (factors_make(&v, limit, rays, open) != UM_OK) fail_msg("%s", um_core_message(v.s.context));
  return v;
}

static void factors_destroy(struct factors *v)
{
  um_geometry_view_factors_destroy(v->s.context, &v->f);
  um_geometry_patches_destroy(v->s.context, &v->patches);
  support_destroy(&v->s);
}

/* Share of what leaves one side of part a that reaches one side of part b; rays, how many left. */
static double between(const struct factors *v, uint32_t a, int back_a, uint32_t b, int back_b,
                      double *rays)
{
  double area = 0.0, all = 0.0, sum = 0.0;
  const struct um_geometry_surface *surface = v->s.mesh->surface;
  for (size_t p = 0; p < v->patches->npatch; p++) {
    const struct um_geometry_surface *from = &surface[v->patches->surface[v->patches->begin[p]]];
    all += v->patches->area[p];
    if (from->part != a || from->back != back_a) continue;
    area += v->patches->area[p];
    for (size_t e = v->f->begin[p]; e < v->f->begin[p + 1]; e++) {
      size_t q = v->f->other[e];
      const struct um_geometry_surface *to = &surface[v->patches->surface[v->patches->begin[q]]];
      if (to->part == b && to->back == back_b) sum += v->f->area[e];
    }
  }
  if (rays != NULL) *rays = (double)v->f->rays * area / all;
  return sum / area;
}

/* Front of part 0 to front of part 1: as sampled, closed, and closed between few patches. */
static void check(const struct um_geometry_part_spec parts[2], double expected, double facets)
{
  for (int k = 0; k < 3; k++) {
    double rays;
    struct factors v = factors_of(parts, 2, k == 2 ? 3 : SIZE_MAX, k == 2 ? 65536 : 4096, k == 0);
    double f = between(&v, 0, 0, 1, 0, &rays);
    double sigma = sqrt(expected * (1.0 - expected) / rays);
    print_message("view factor %.6f, expected %.6f: %+.2f standard errors, %zu patches, row sums "
                  "to %.1e\n",
                  f, expected, (f - expected) / sigma, v.patches->npatch,
                  k == 0 ? NAN : v.f->unclosed);
    assert_close(f, expected, (k == 0 ? 4.0 * sigma : 1e-3) + facets);
    factors_destroy(&v);
  }
}

static struct um_geometry_part_spec facing(const char *name, double x, double y, double distance)
{
  struct um_geometry_part_spec part = support_plate(name, x, y, um_vec3(0, 0, distance));
  if (distance > 0.0) part.rotation = um_quat_from_axis(um_vec3(1, 0, 0), UM_PI);
  part.facet_size = 0.4;
  return part;
}

static void parallel_plates(void **state)
{
  (void)state;
  static const struct {
    double x, distance, factor;
  } row[] = {{1, 1, 0.199825}, {1, 0.5, 0.415253}, {1, 2, 0.068590}, {2, 1, 0.285875}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    struct um_geometry_part_spec parts[2] = {facing("below", row[i].x, 1, 0),
                                             facing("above", row[i].x, 1, row[i].distance)};
    check(parts, row[i].factor, 0.0);
  }
}

/* Howell C-14: rectangles of one common edge l at 90 deg, floor of depth w, wall of height h. */
static double common_edge(double l, double w, double h)
{
  double H = h / l, W = w / l, H2 = H * H, W2 = W * W, d = sqrt(H2 + W2);
  double product = (1 + W2) * (1 + H2) / (1 + W2 + H2) *
                   pow(W2 * (1 + W2 + H2) / ((1 + W2) * (W2 + H2)), W2) *
                   pow(H2 * (1 + H2 + W2) / ((1 + H2) * (H2 + W2)), H2);
  return (W * atan(1 / W) + H * atan(1 / H) - d * atan(1 / d) + 0.25 * log(product)) / (UM_PI * W);
}

/* Floor in z = 0 up to x = 0, wall above x = 0 that faces it. */
static void stand(struct um_geometry_part_spec parts[2], double l, double w, double h)
{
  parts[0] = support_plate("floor", w, l, um_vec3(-0.5 * w, 0, 0));
  parts[1] = support_plate("wall", h, l, um_vec3(0, 0, 0.5 * h));
  parts[1].rotation = um_quat_from_axis(um_vec3(0, 1, 0), -0.5 * UM_PI);
  parts[0].facet_size = parts[1].facet_size = 0.4;
}

static void perpendicular_plates(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[2];
  assert_close(common_edge(1, 1, 1), 0.200044, 1e-6);
  assert_close(common_edge(1, 1, 2), 0.232853, 1e-6);
  stand(parts, 1, 1, 1);
  check(parts, 0.200044, 0.0);
  stand(parts, 1, 1, 2);
  check(parts, 0.232853, 0.0);
}

/* A groove of 90 deg: 0.292893 where it is endless, here 20 long. */
static void v_groove(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[2];
  assert_close(common_edge(1e4, 1, 1), 0.292893, 5e-5);
  stand(parts, 20, 1, 1);
  parts[0].facet_size = parts[1].facet_size = 1.5;
  check(parts, common_edge(20, 1, 1), 0.0);
}

/* Discs as polygons of 63 corners of the circle's area: 3e-4. */
static void discs(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[2] = {facing("below", 1, 1, 0), facing("above", 1, 1, 1)};
  for (int k = 0; k < 2; k++) {
    parts[k].shape = UM_SHAPE_DISC;
    parts[k].radius = 1.0;
    parts[k].facet_size = 0.14;
  }
  check(parts, 0.381966, 3e-4);
}

/* Six plates that look inward at a unit cube. */
static void room(struct um_geometry_part_spec part[6], double facet_size)
{
  static const char *const name[6] = {"x0", "x1", "y0", "y1", "z0", "z1"};
  for (int k = 0; k < 6; k++) {
    double side = k % 2 == 0 ? -0.5 : 0.5;
    int axis = k / 2;
    part[k] = support_plate(
        name[k], 1, 1, um_vec3(axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0));
    /* turn of the plate's +z to the inward normal; passive, so the other way round */
    double turn = side < 0.0 ? 0.5 : -0.5;
    if (axis == 0) part[k].rotation = um_quat_from_axis(um_vec3(0, 1, 0), turn * UM_PI);
    if (axis == 1) part[k].rotation = um_quat_from_axis(um_vec3(1, 0, 0), -turn * UM_PI);
    if (axis == 2 && side > 0.0) part[k].rotation = um_quat_from_axis(um_vec3(1, 0, 0), UM_PI);
    part[k].facet_size = facet_size;
  }
}

static void cube_inside(void **state)
{
  (void)state;
  struct um_geometry_part_spec part[6];
  room(part, 0.4);
  struct factors v = factors_of(part, 6, SIZE_MAX, 4096, false);
  double leak = 0.0;
  for (size_t p = 0; p < v.patches->npatch; p++) leak += v.f->space[p];
  print_message("cube: opposite %.6f, beside %.6f, %.1e of 6 m2 leak\n",
                between(&v, 0, 0, 1, 0, NULL), between(&v, 0, 0, 2, 0, NULL), leak);
  assert_close(between(&v, 0, 0, 1, 0, NULL), 0.199825, 1e-3);
  for (uint32_t b = 2; b < 6; b++) assert_close(between(&v, 0, 0, b, 0, NULL), 0.200044, 1e-3);
  assert_true(leak == 0.0); /* no ray slips through an edge */
  factors_destroy(&v);
}

/* A faceted sphere in a room: all of it arrives, hence F21 = A1 / A2, exactly after closure. */
static void sphere_in_a_room(void **state)
{
  (void)state;
  struct um_geometry_part_spec part[7];
  room(part, 0.4);
  part[6] = (struct um_geometry_part_spec){.name = "ball",
                                           .shape = UM_SHAPE_SPHERE,
                                           .radius = 0.3,
                                           .rotation = {1, 0, 0, 0},
                                           .skins = &support_closed,
                                           .nskin = 1,
                                           .facet_size = 0.1};
  struct factors v = factors_of(part, 7, 200, 4096, false);
  double out = 0.0, itself = between(&v, 6, 0, 6, 0, NULL), area = 0.0, back = 0.0;
  for (size_t p = 0; p < v.patches->npatch; p++)
    if (v.s.mesh->surface[v.patches->surface[v.patches->begin[p]]].part == 6)
      area += v.patches->area[p];
  for (uint32_t b = 0; b < 6; b++) {
    out += between(&v, 6, 0, b, 0, NULL);
    back += between(&v, b, 0, 6, 0, NULL);
  }
  assert_close(itself, 0.0, 0.0); /* convex */
  assert_close(out, 1.0, 1e-12);
  assert_close(back, area / 1.0, 1e-12);
  for (uint32_t b = 0; b < 6; b++) assert_close(between(&v, b, 0, 6, 0, NULL), area / 6.0, 1e-3);
  assert_true(v.f->residual < 1e-12);
  factors_destroy(&v);
}

/* Wall of a box and a plate beside it; the figures are those of exact polygons. */
static void elbow(void **state)
{
  (void)state;
  struct um_geometry_part_spec part[2] = {support_box("bus", 1.2, 1.2, 1.2),
                                          support_plate("array", 1.2, 1.5, um_vec3(0, 1.6, 0))};
  part[0].facet_size = part[1].facet_size = 0.4243;
  struct factors v = factors_of(part, 2, SIZE_MAX, 4096, false);
  for (int back = 0; back < 2; back++) {
    double to = between(&v, 0, 0, 1, back, NULL), from = between(&v, 1, back, 0, 0, NULL);
    print_message("elbow: wall to panel %.6f, panel to wall %.6f, cut %.1e\n", to, from, v.f->cut);
    assert_close(to, 0.07985, 2e-4);
    assert_close(from, 0.06388, 2e-4);
  }
  factors_destroy(&v);
}

/* Exactly reciprocal, closed, without negative areas, and the same bytes for one and four threads.
 */
static void laws(void **state)
{
  (void)state;
  struct um_geometry_part_spec part[3] = {support_box("bus", 1.2, 1.2, 1.2),
                                          support_plate("array", 1.2, 1.5, um_vec3(0, 1.6, 0)),
                                          support_plate("wing", 3, 1, um_vec3(0.2, 0.3, 0.5))};
  for (int k = 0; k < 3; k++) part[k].facet_size = 0.3;
  struct factors v = factors_of(part, 3, 40, 500, false), w = {.s = support_create(part, 3)};
  um_core_context_set_threads(v.s.context, 1);
  um_core_context_set_threads(w.s.context, 4);
  assert_int_equal(factors_make(&w, 40, 500, false), UM_OK);
  assert_true(v.patches->npatch == 40);
  size_t n = v.f->begin[40];
  assert_true(n == w.f->begin[40]);
  assert_memory_equal(v.f->area, w.f->area, n * sizeof *v.f->area);
  assert_memory_equal(v.f->space, w.f->space, 40 * sizeof *v.f->space);
  for (size_t p = 0; p < 40; p++) {
    double sum = v.f->space[p];
    assert_true(v.f->space[p] >= 0.0);
    for (size_t e = v.f->begin[p]; e < v.f->begin[p + 1]; e++) {
      assert_true(v.f->area[e] >= 0.0);
      assert_true(v.f->area[e] == um_geometry_view_factors_area(v.f, v.f->other[e], p));
      sum += v.f->area[e];
    }
    assert_close(sum / v.patches->area[p], 1.0, 1e-12);
  }
  /* the wing stands through the wall of the box: what is inside sees itself */
  double itself = 0.0;
  for (size_t p = 0; p < 40; p++) itself += um_geometry_view_factors_area(v.f, p, p);
  assert_true(itself > 0.1);
  factors_destroy(&v);
  factors_destroy(&w);
}

static void convex_has_none(void **state)
{
  (void)state;
  struct um_geometry_part_spec part = support_box("bus", 1, 2, 3);
  struct factors v = factors_of(&part, 1, 10, 100, false);
  assert_true(v.patches->npatch == 0 && v.f->begin[0] == 0 && v.f->rays == 0);
  factors_destroy(&v);
  v = (struct factors){.s = support_create(&part, 1)};
  assert_int_equal(factors_make(&v, 10, 0, false), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(v.s.context), "view factors by 0 rays"));
  factors_destroy(&v);
}

/* Every allocation fails once: "out of memory", nothing is left behind. */
static void out_of_memory(void **state)
{
  (void)state;
  struct um_geometry_part_spec part[2] = {support_box("bus", 1.2, 1.2, 1.2),
                                          support_plate("array", 1.2, 1.5, um_vec3(0, 1.6, 0))};
  struct um_test_memory memory = {0};
  struct um_core_allocator allocator = um_test_memory_allocator(&memory);
  struct factors v = {.s = support_create(part, 2)}, w = v;
  struct um_context *context = NULL;
  assert_int_equal(um_core_context_create(&allocator, &context), UM_OK);
  um_core_context_set_threads(context, 1);
  w.s.context = context;
  long live = memory.alive, tries = 0;
  enum um_status status = UM_ERR_MEMORY;
  while (status != UM_OK) {
    memory.calls = 0;
    memory.fail_call = ++tries;
    um_core_message_clear(context);
    status = factors_make(&w, 5, 64, false);
    if (status == UM_OK) break;
    assert_int_equal(status, UM_ERR_MEMORY);
    assert_null(w.f);
    um_geometry_patches_destroy(context, &w.patches);
    assert_int_equal(memory.alive, live);
  }
  print_message("view factors: %ld allocations failed one by one\n", tries - 1);
  assert_true(tries > 15);
  um_geometry_view_factors_destroy(context, &w.f);
  um_geometry_patches_destroy(context, &w.patches);
  assert_int_equal(memory.alive, live);
  um_core_context_destroy(&context);
  support_destroy(&v.s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(parallel_plates), cmocka_unit_test(perpendicular_plates),
      cmocka_unit_test(v_groove),        cmocka_unit_test(discs),
      cmocka_unit_test(cube_inside),     cmocka_unit_test(sphere_in_a_room),
      cmocka_unit_test(elbow),           cmocka_unit_test(laws),
      cmocka_unit_test(convex_has_none), cmocka_unit_test(out_of_memory),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
