/* The folder of a study's results. */
#ifndef UMBRA_STUDY_FOLDER_H
#define UMBRA_STUDY_FOLDER_H

#include <stdio.h>

#include "study/result.h"

/* Before hours of work: UM_ERR_IO where the folder may not be written. */
enum um_status um_study_folder_try(struct um_context *context, const char *path, bool force);

struct um_study_folder {
  const char *measured; /* path of measurements that points are held against; NULL: none */
  bool force;           /* a folder that the program did not write is replaced, too */
  bool pictures;
  FILE *words; /* where the summary for a person goes; NULL: nowhere */
};
/* Write all files of a result (docs/files.md); the folder appears whole or not at all. What falls
 * short of what was asked is logged as warnings. Statistics want two points that succeeded.
 * UM_ERR_IO, UM_ERR_MEMORY; errors of um_study_measured_create. */
enum um_status um_study_folder_write(struct um_context *context, struct um_study_result *result,
                                     const struct um_study_folder *how, const char *path);

#endif
