/* An effect of a user's own, drafted from what a diagnosis found and no catalogue has: one C file.
 */
#ifndef UMBRA_DIAGNOSIS_REPORT_DRAFT_H
#define UMBRA_DIAGNOSIS_REPORT_DRAFT_H

#include <stdio.h>

#include "evidence/diagnosis/diagnosis.h"

enum um_diagnosis_draft { UM_DRAFT_NONE, UM_DRAFT_HEAT, UM_DRAFT_LIGHT };

/* What a draft would be made of: heat_asked or light_asked of a diagnosis that was asked for one,
 * whichever has the least BIC; NONE where neither is worth its numbers. Does not fail. */
enum um_diagnosis_draft um_diagnosis_report_draft_choose(const struct um_diagnosis *d);
/* "heat in bus.interior", "light of panel in vis ..": one line. Does not fail. */
#define UM_DIAGNOSIS_DRAFT_TEXT 512
void um_diagnosis_report_draft_text(const struct um_diagnosis *d, enum um_diagnosis_draft draft,
                                    char out[UM_DIAGNOSIS_DRAFT_TEXT]);
/* Name of the effect in a file: its stem in letters, digits and _, with "draft_" before one that
 * begins with no letter or that the program has. */
#define UM_DIAGNOSIS_DRAFT_NAME 61
void um_diagnosis_report_draft_name(const struct um_diagnosis *d, const char *path,
                                    char out[UM_DIAGNOSIS_DRAFT_NAME]);
/* The file; draft is not NONE. The caller looks for errors of the stream. */
void um_diagnosis_report_draft_put(const struct um_diagnosis *d, enum um_diagnosis_draft draft,
                                   const char *name, const char *command, const char *version,
                                   FILE *file);
/* A file that appears whole. UM_ERR_INPUT: nothing was found that a draft could be made of.
 * UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_diagnosis_report_draft_write(struct um_context *context,
                                               const struct um_diagnosis *d, const char *path,
                                               const char *command, const char *version);

#endif
