/* Directions of Sun and observer as a map has them. The three pairs are
 * those of docs/physics/reflectivity-map.md, computed there independently. */
#include "model/products/phase_vector.h"

#include "base/core/constants.h"
#include "tests/support/cmocka_all.h"

/* Printed to 1e-5 deg. */
static void published(void **state)
{
  (void)state;
  static const struct {
    struct um_vec3 sun, observer;
    double latitude, longitude;
  } at[] = {{{1, 0, 0}, {0, 1, 0}, 0.0, 45.0},
            {{1, 0, 0}, {0, 0, 1}, 45.0, 0.0},
            {{0.6, 0, 0.8}, {0, -1, 0}, 34.44990, -59.03624}};
  for (size_t i = 0; i < 3; i++) {
    struct um_model_phase_vector v = um_model_phase_vector(at[i].sun, at[i].observer);
    assert_close(v.latitude / UM_DEG, at[i].latitude, 5e-6);
    assert_close(v.longitude / UM_DEG, at[i].longitude, 5e-6);
    assert_close(v.phase_angle / UM_DEG, 90.0, 1e-12);
  }
}

/* The Sun's side, by hand: Sun and observer in the equator, the Sun to the east; in a meridian, the
 * Sun to the north; and either the other way round. */
static void plane(void **state)
{
  (void)state;
  double c = cos(0.3), s = sin(0.3);
  struct um_vec3 east = um_vec3(c, s, 0), west = um_vec3(c, -s, 0), north = um_vec3(c, 0, s),
                 south = um_vec3(c, 0, -s);
  assert_close(um_model_phase_vector(east, west).plane / UM_DEG, 90.0, 1e-12);
  assert_close(um_model_phase_vector(west, east).plane / UM_DEG, 270.0, 1e-12);
  assert_close(um_model_phase_vector(north, south).plane / UM_DEG, 0.0, 1e-12);
  assert_close(um_model_phase_vector(south, north).plane / UM_DEG, 180.0, 1e-12);
}

/* There and back, to the last digits; poles too, where the meridian says where north is. */
static void way_back(void **state)
{
  (void)state;
  for (int i = 0; i <= 6; i++)
    for (int j = 0; j < 8; j++)
      for (int k = 0; k < 12; k++) {
        struct um_model_phase_vector v = {(-90.0 + 30.0 * i) * UM_DEG, (-170.0 + 45.0 * j) * UM_DEG,
                                          (1.0 + 14.0 * k) * UM_DEG, 29.0 * k * UM_DEG};
        struct um_vec3 sun, observer, sun_again, observer_again;
        um_model_phase_directions(&v, &sun, &observer);
        assert_close(um_vec3_norm(sun), 1.0, 1e-15);
        assert_close(um_vec3_angle(sun, observer), v.phase_angle, 1e-14);
        struct um_model_phase_vector w = um_model_phase_vector(sun, observer);
        assert_close(w.latitude, v.latitude, 1e-7);
        um_model_phase_directions(&w, &sun_again, &observer_again);
        assert_close(um_vec3_norm(um_vec3_sub(sun, sun_again)), 0.0, 1e-7);
        assert_close(um_vec3_norm(um_vec3_sub(observer, observer_again)), 0.0, 1e-7);
        if (i == 0 || i == 6) continue;
        assert_close(w.longitude, v.longitude, 1e-12);
        assert_close(remainder(w.plane - v.plane, 2.0 * UM_PI), 0.0, 1e-12);
      }
}

static void no_phase_angle_and_opposite(void **state)
{
  (void)state;
  struct um_model_phase_vector v = um_model_phase_vector(um_vec3(0, 0, -1), um_vec3(0, 0, -1));
  assert_close(v.latitude / UM_DEG, -90.0, 1e-12);
  assert_true(v.phase_angle == 0.0 && v.plane == 0.0);
  v = um_model_phase_vector(um_vec3(0, 1, 0), um_vec3(0, -1, 0));
  assert_true(isnan(v.latitude) && isnan(v.longitude) && isnan(v.plane));
  assert_close(v.phase_angle, UM_PI, 1e-15);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(published), cmocka_unit_test(plane),
                                     cmocka_unit_test(way_back),
                                     cmocka_unit_test(no_phase_angle_and_opposite)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
