/* A small satellite and studies of it, written into the working folder. */
#ifndef UMBRA_TESTS_STUDY_WORLD_H
#define UMBRA_TESTS_STUDY_WORLD_H

#include "study/study.h"

#define WORLD_SCENARIO "study_world_scenario.yaml"
#define WORLD_STUDY    "study_world_study.yaml"
#define WORLD_RECORDS  "study_world_points"

/* The scenario, and a study of these lines behind schema, name and scenario. */
void world_put(const char *study);
/* Removes both and the records. */
void world_clear(struct um_context *context);
struct um_study_run_options world_options(int workers, bool resume);
/* The study of these lines, run; fails the test where it ends with an error. The caller destroys
 * both. */
struct um_study_result *world_run(struct um_context *context, const char *text, int workers,
                                  bool resume, struct um_study **study);

#endif
