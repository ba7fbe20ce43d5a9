/* What an analyst makes once for a world: the candidates and their signatures. */
#include <math.h>

#include "evidence/sensitivity/candidates.h"
#include "tests/lab/lab.h"

enum um_status lab_desk_create(struct um_context *context, const struct lab_world *world,
                               const char *folder, struct lab_desk *out)
{
  enum um_status status;
  struct lab_truth plain = {0};
  struct lab_case own = {.part = "analyst", .world = world};
  *out = (struct lab_desk){.world = world};
  lab_world_path(world, out->path);
  lab_world_analyst(world, &out->analyst);
  out->analyst.options.overrides = out->analyst.override;
  out->analyst.options.without = out->analyst.without;
  UM_CHECK(lab_truth_create(context, &own, true, folder, &plain));
  UM_CHECK(lab_truth_measure(context, &plain, &own, &out->measurements));
  UM_CHECK(um_sensitivity_forward_create(context, out->path, &out->analyst.options,
                                         out->measurements, UM_VARIANT_TIGHT, &out->forward));
  UM_CHECK(um_sensitivity_candidates_create(context, out->forward, NULL, 0,
                                            &(struct um_sensitivity_candidates_options){0},
                                            &out->candidates));
done:
  lab_truth_release(context, &plain);
  if (status != UM_OK) lab_desk_release(context, out);
  return status;
}

void lab_desk_release(struct um_context *context, struct lab_desk *desk)
{
  um_sensitivity_candidates_destroy(context, &desk->candidates);
  um_sensitivity_forward_destroy(context, &desk->forward);
  um_compare_measurements_destroy(context, &desk->measurements);
}
