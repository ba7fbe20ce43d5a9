/* Files of cases of heat: limits.csv, limits.png, .svg and .pdf, report.html. */
#ifndef UMBRA_OUTPUT_CASES_H
#define UMBRA_OUTPUT_CASES_H

#include <stdio.h>

#include "base/core/file.h"
#include "variant/cases.h"

/* A row for every case and place; empty where there is no bound. The caller looks for errors of the
 * stream. */
void um_output_write_cases(const struct um_variant_cases *cases, FILE *file);
/* What every case makes of the places that have limits, or of whole parts and interiors where none
 * has: a bar from the lowest to the highest temperature between the bounds. Draws nothing without
 * places. UM_ERR_IO. */
enum um_status um_output_plot_cases(struct um_context *context,
                                    const struct um_variant_cases *cases, const char *folder);
/* report.html, behind the picture that it may show: every place between its limits in every case.
 * UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_output_page_cases(struct um_context *context,
                                    const struct um_variant_cases *cases,
                                    struct um_core_folder *folder);
/* The place of that name in a case; NULL: the case's parts have none. */
const struct um_variant_case_place *um_output_case_place(const struct um_variant_case *of,
                                                         const char *name);
/* Is a place one of those that table and picture show? */
bool um_output_case_shows(const struct um_variant_cases *cases,
                          const struct um_variant_case_place *place);

#endif
