/* Memory that runs out at every single allocation in turn: UM_ERR_MEMORY, nothing leaks (the blocks
 * handed out are counted), nothing crashes. */
#include "orbit_test.h"

#include "orbit/attitude.h"
#include "orbit/observer.h"
#include "tests/support/allocator.h"

struct paths {
  char orbit[256], attitude[256], finals[256];
};

/* Everything that allocates, once. */
static enum um_status everything(struct um_context *context, const struct paths *paths)
{
  enum um_status status;
  struct um_orbit_trajectory *tle = NULL, *table = NULL;
  struct um_orbit_attitude *attitude = NULL;
  struct um_orbit_pass *passes = NULL;
  struct um_orbit_earth_orientation eop = {0};
  struct um_orbit_ephemeris *ephemeris = NULL;
  struct um_orbit_tle elements;
  struct um_orbit_attitude_law law = {.kind = UM_ATTITUDE_TABLE, .table_path = paths->attitude};
  struct um_orbit_observer station = {.latitude = 0.8};
  size_t count;
  UM_CHECK(um_orbit_ephemeris_create(context, &ephemeris));
  UM_CHECK(um_orbit_finals_read(context, paths->finals, &eop.finals));
  UM_CHECK(
      um_orbit_tle_parse(context,
                         "1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
                         "2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n",
                         1, &elements));
  UM_CHECK(um_orbit_trajectory_create_tle(context, &elements, &eop, &tle));
  UM_CHECK(um_orbit_trajectory_create_table(context, paths->orbit, NULL, &table));
  UM_CHECK(um_orbit_attitude_create(context, &law, 1, &attitude));
  UM_CHECK(um_orbit_passes_find(context, &station, tle, elements.epoch_tai,
                                elements.epoch_tai + 3000.0, -1.0, &passes, &count));
done:
  um_core_free(context, passes);
  um_orbit_attitude_destroy(&attitude);
  um_orbit_trajectory_destroy(&table);
  um_orbit_trajectory_destroy(&tle);
  um_orbit_finals_destroy(&eop.finals);
  um_orbit_ephemeris_destroy(context, &ephemeris);
  return status;
}

static void runs_out(void **state)
{
  (void)state;
  struct paths paths;
  scratch_write("memory_orbit.csv",
                "time_utc,x_km,y_km,z_km\n2016-09-06T00:00:00Z,7000,0,0\n"
                "2016-09-06T00:01:00Z,7000,400,0\n2016-09-06T00:02:00Z,7000,800,0\n"
                "2016-09-06T00:03:00Z,7000,1200,0\n2016-09-06T00:04:00Z,7000,1600,0\n",
                paths.orbit);
  scratch_write(
      "memory_attitude.csv",
      "time_utc,q0,q1,q2,q3\n2016-09-06T00:00:00Z,1,0,0,0\n2016-09-06T00:01:00Z,0,1,0,0\n",
      paths.attitude);
  /* columns of readme.finals2000A: MJD 8-15, xp 19-27, yp 38-46, UT1-UTC 59-68 */
  scratch_write("memory_finals.txt",
                "16 9 6 57637.00 I  0.236620 0.000030  0.351290 0.000020  I-0.2677940 0.0000090\n"
                "16 9 8 57639.00 I  0.236620 0.000030  0.351290 0.000020  I-0.2677940 0.0000090\n",
                paths.finals);
  enum um_status status = UM_ERR_MEMORY;
  long room = 0;
  for (; status == UM_ERR_MEMORY && room < 1000; room++) {
    struct um_test_memory memory = {.stays_out = true};
    struct um_core_allocator allocator = um_test_memory_allocator(&memory);
    struct um_context *context = NULL;
    assert_int_equal(um_core_context_create(&allocator, &context), UM_OK);
    memory.calls = 0;
    memory.fail_call = room + 1;
    long alive = memory.alive;
    status = everything(context, &paths);
    if (status != UM_OK && status != UM_ERR_MEMORY)
      fail_msg("room for %ld: %s", room, um_core_message(context));
    assert_int_equal(memory.alive, alive);
    um_core_context_destroy(&context);
    assert_int_equal(memory.alive, 0);
  }
  assert_int_equal(status, UM_OK);
  assert_true(room > 15); /* it did run out many times before */
  remove(paths.orbit);
  remove(paths.attitude);
  remove(paths.finals);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(runs_out)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
