/* A scenario beside measurements, from its file to the comparison. */
#ifndef UMBRA_COMPARE_WHOLE_H
#define UMBRA_COMPARE_WHOLE_H

#include "evidence/comparison/comparison.h"
#include "evidence/inversion/refine.h"

/* What a comparison is made of; all zero before. */
struct um_compare_whole {
  struct um_model *model;
  struct um_compare_measurements measurements; /* those of the caller, its own rows: with a sigma
                                                  of the scenario's noise model where they state
                                                  none */
  struct um_compare_plan *plan;
  struct um_model_tables *tables;
  struct um_model_result *result;
  struct um_compare_comparison *comparison;
};

/* The model and the plan of it. options: NULL, or borrowed; measurements: borrowed, both while the
 * whole lives. Errors of um_model_create and um_compare_plan_create; the caller releases, also
 * after a failure. */
enum um_status um_compare_whole_begin(struct um_context *context, const char *path,
                                      const struct um_model_options *options,
                                      const struct um_compare_measurements *measurements,
                                      struct um_compare_whole *whole);
/* Run it, with as many samples as the measurements want (um_compare_refine), and compare. */
enum um_status um_compare_whole_run(struct um_context *context, struct um_compare_whole *whole);
void um_compare_whole_release(struct um_context *context, struct um_compare_whole *whole);

#endif
