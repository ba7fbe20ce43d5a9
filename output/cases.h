/* Files of cases of heat: limits.csv, and limits.png, .svg and .pdf. */
#ifndef UMBRA_OUTPUT_CASES_H
#define UMBRA_OUTPUT_CASES_H

#include <stdio.h>

#include "variant/cases.h"

/* A row for every case and place; empty where there is no bound. The caller looks for errors of the
 * stream. */
void um_output_write_cases(const struct um_variant_cases *cases, FILE *file);
/* What every case makes of the places that have limits, or of whole parts and interiors where none
 * has: a bar from the lowest to the highest temperature between the bounds. Draws nothing without
 * places. UM_ERR_IO. */
enum um_status um_output_plot_cases(struct um_context *context,
                                    const struct um_variant_cases *cases, const char *folder);
/* Is a place one of those that table and picture show? */
bool um_output_case_shows(const struct um_variant_cases *cases,
                          const struct um_variant_case_place *place);

#endif
