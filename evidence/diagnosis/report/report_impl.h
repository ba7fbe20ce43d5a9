/* Parts of a report: JSON, pictures, the improved scenario. Private to evidence/diagnosis/report/.
 */
#ifndef UMBRA_DIAGNOSIS_REPORT_REPORT_IMPL_H
#define UMBRA_DIAGNOSIS_REPORT_REPORT_IMPL_H

#include <stdio.h>

#include "base/plot/plot.h"
#include "evidence/diagnosis/diagnosis.h"

/* before, "key": value; null where the time is not finite. */
void um_diagnosis_report_json_time(FILE *file, const char *before, const char *key, double t_tai);
/* "effect": ..., "target": ... */
void um_diagnosis_report_json_use(FILE *file, const struct um_effect *effect, const char *target);
/* An object of one value that is left open. */
void um_diagnosis_report_json_parameter(FILE *file, const struct um_effect_parameter *parameter,
                                        double value, double sigma);
/* , "parameters": [...], each with the whole that the scenario states, where it states something.
 */
void um_diagnosis_report_json_parameters(FILE *file, const struct um_diagnosis *d,
                                         const struct um_effect *effect, const char *target,
                                         const double *value, const double *sigma);

/* Members of the whole object, each with its comma before. */
void um_diagnosis_report_json_missed(FILE *file, const struct um_diagnosis *d);
void um_diagnosis_report_json_superseded(FILE *file, const struct um_diagnosis *d);
void um_diagnosis_report_json_residual(FILE *file, const struct um_missing_heat_residual *r);
void um_diagnosis_report_json_next(FILE *file, const struct um_diagnosis *d);
void um_diagnosis_report_json_unexplained(FILE *file, const struct um_missing_heat_unexplained *u);
void um_diagnosis_report_json_cost(FILE *file, const struct um_diagnosis *d);

/* Pixels. */
#define UM_DIAGNOSIS_PLOT_WIDTH 1000
#define UM_DIAGNOSIS_PLOT_LEFT  100
#define UM_DIAGNOSIS_PLOT_RIGHT 980

/* The axis of time from t_tai `first` to `last`. */
struct um_plot_time um_diagnosis_report_plot_time(double first, double last);
/* The verdict, what was added and what leaves it in doubt: "not identifiable: emittance of white
 * (drawn) or albedo". */
void um_diagnosis_report_plot_verdict(const struct um_diagnosis *diagnosis, char *out, size_t size);

/* ranking.png: chi-square that the best candidates explain of the baseline, by a fit or by a
 * linear model; there is a ranking. */
enum um_status um_diagnosis_report_plot_ranking(struct um_context *context,
                                                const struct um_diagnosis *diagnosis,
                                                struct um_plot *plot);
/* heat.png: history of the missing heat at the best place; there is one. */
enum um_status um_diagnosis_report_plot_heat(struct um_context *context,
                                             const struct um_diagnosis *diagnosis,
                                             struct um_plot *plot);

/* improved/scenario.yaml into the folder at `path`. */
enum um_status um_diagnosis_report_improved_write(struct um_context *context,
                                                  const struct um_diagnosis *diagnosis,
                                                  const char *command, const char *version,
                                                  const char *path);

#endif
