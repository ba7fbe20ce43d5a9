/* A diagnosis in twelve lines: what a terminal shows. */
#ifndef UMBRA_DIAGNOSIS_REPORT_BRIEF_H
#define UMBRA_DIAGNOSIS_REPORT_BRIEF_H

#include <stdio.h>

#include "evidence/diagnosis/diagnosis.h"

#define UM_DIAGNOSIS_BRIEF_LINES 12 /* at most */
/* [characters] of a line, but of one with a command or path */
#define UM_DIAGNOSIS_BRIEF_WIDTH 96

/* The verdict in the words of the effects, how the error fell, what is left that is no noise, what
 * convinces a sceptic of the strongest effect, what to measure next, the command to type next,
 * where the rest is; each of them where there is something to say, in lines that end with '\n'.
 * What has no room is counted. command: that asked for the diagnosis, as it can be typed; NULL:
 * none did. folder: of the results. The caller frees *out. UM_ERR_MEMORY. */
enum um_status um_diagnosis_report_brief(struct um_context *context,
                                         const struct um_diagnosis *diagnosis, const char *command,
                                         const char *folder, char **out);

/* Words in lines of that width, at most so many of them: "..." ends one that is cut. file NULL:
 * they are counted alone. Returns how many lines there are. */
size_t um_diagnosis_report_wrap(FILE *file, const char *text, size_t most);

#endif
