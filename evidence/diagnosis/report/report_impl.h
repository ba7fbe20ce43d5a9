/* Parts of a report: JSON, pictures, the improved scenario. Private to evidence/diagnosis/report/.
 */
#ifndef UMBRA_DIAGNOSIS_REPORT_REPORT_IMPL_H
#define UMBRA_DIAGNOSIS_REPORT_REPORT_IMPL_H

#include <stdio.h>

#include "base/core/file.h"
#include "base/plot/plot.h"
#include "evidence/diagnosis/diagnosis.h"

/* before, "key": value; null where the time is not finite. */
void um_diagnosis_report_json_time(FILE *file, const char *before, const char *key, double t_tai);
/* "effect": ..., "target": ... */
void um_diagnosis_report_json_use(FILE *file, const struct um_diagnosis *d,
                                  const struct um_effect *effect, const char *target);
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
void um_diagnosis_report_json_sceptic(FILE *file, const struct um_diagnosis *d);
void um_diagnosis_report_json_scatter(FILE *file, const struct um_diagnosis *d);
void um_diagnosis_report_json_residual(FILE *file, const struct um_missing_heat_residual *r);
void um_diagnosis_report_json_next(FILE *file, const struct um_diagnosis *d);
void um_diagnosis_report_json_unexplained(FILE *file, const struct um_missing_heat_unexplained *u,
                                          const struct um_missing_light *light);
/* , "key": a correction of light, null where there is none. */
void um_diagnosis_report_json_light(FILE *file, const char *key,
                                    const struct um_missing_light *light);
void um_diagnosis_report_json_halves(FILE *file, const struct um_diagnosis *d);
/* What is known of fitted parameters together. */
void um_diagnosis_report_json_posterior(FILE *file, const struct um_diagnosis *d);
void um_diagnosis_report_json_cost(FILE *file, const struct um_diagnosis *d);

/* The end of diagnosis.txt (text_next.c): what is left open. */
void um_diagnosis_report_write_text_next(const struct um_diagnosis *diagnosis, FILE *file);

/* The command to type next as a line of the brief (brief_command.c): found: to see that it is gone;
 * a group: the same question without its first; what leaves things open: where it is off, or the
 * whole catalogue; complete: what could have been seen. It can be typed where the diagnosis was,
 * and leaves its folder as it is. command, folder: as of um_diagnosis_report_brief. */
void um_diagnosis_report_put_command(FILE *file, const struct um_diagnosis *diagnosis,
                                     const char *command, const char *folder);
/* posterior.csv and posterior_curves.csv; nothing without draws. UM_ERR_IO. */
enum um_status um_diagnosis_report_posterior_write(struct um_context *context,
                                                   const struct um_diagnosis *d,
                                                   struct um_core_folder *folder);
/* The picture "posterior" of the draws, which has tables of its own. UM_ERR_MEMORY. */
enum um_status um_diagnosis_report_plot_posterior(struct um_context *context,
                                                  const struct um_diagnosis *d,
                                                  struct um_plot *plot);

/* Pixels. */
#define UM_DIAGNOSIS_PLOT_WIDTH 1000
#define UM_DIAGNOSIS_PLOT_LEFT  100
#define UM_DIAGNOSIS_PLOT_RIGHT 980

/* The axis of time from t_tai `first` to `last`. */
struct um_plot_time um_diagnosis_report_plot_time(double first, double last);
/* The verdict, what was added and what leaves it in doubt: "not identifiable: emittance of white
 * (drawn) or albedo". */
void um_diagnosis_report_plot_verdict(const struct um_diagnosis *diagnosis, char *out, size_t size);

/* A candidate by what it explains alone of the baseline's chi-square. */
enum um_diagnosis_report_role {
  UM_DIAGNOSIS_BAR_LINEAR, /* not fitted: by the linear model */
  UM_DIAGNOSIS_BAR_FITTED, /* and worse than the winner */
  UM_DIAGNOSIS_BAR_TIED,   /* cannot be told from the winner */
  UM_DIAGNOSIS_BAR_WINNER, /* of the first step */
  UM_DIAGNOSIS_BAR_ROLES
};
struct um_diagnosis_report_bar {
  const struct um_diagnosis_alternative *score; /* on the baseline */
  const struct um_diagnosis_alternative *fit;   /* of the first step; NULL: not fitted */
  enum um_diagnosis_report_role role;
};
/* The candidates, best first; *out: [*tested], of which *shown are worth a look; the caller frees.
 */
enum um_status um_diagnosis_report_bars(struct um_context *context, const struct um_diagnosis *d,
                                        struct um_diagnosis_report_bar **out, size_t *shown,
                                        size_t *tested);
double um_diagnosis_report_explained(const struct um_diagnosis *d,
                                     const struct um_diagnosis_report_bar *bar);
/* "power_W 4.2 ± 0.3" of the first parameter, "" of a switch. */
void um_diagnosis_report_bar_text(const struct um_diagnosis *d,
                                  const struct um_diagnosis_report_bar *bar, char out[160]);

/* ranking.png: chi-square that the best candidates explain of the baseline, by a fit or by a
 * linear model; there is a ranking. */
enum um_status um_diagnosis_report_plot_ranking(struct um_context *context,
                                                const struct um_diagnosis *diagnosis,
                                                struct um_plot *plot);
/* heat.png: history of the missing heat at the best place; there is one. */
enum um_status um_diagnosis_report_plot_heat(struct um_context *context,
                                             const struct um_diagnosis *diagnosis,
                                             struct um_plot *plot);

/* report.html into a folder in the making. UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_diagnosis_report_write_page(struct um_context *context,
                                              const struct um_diagnosis *diagnosis,
                                              const char *command, struct um_core_folder *folder);

/* improved/scenario.yaml into the folder at `path`. */
enum um_status um_diagnosis_report_improved_write(struct um_context *context,
                                                  const struct um_diagnosis *diagnosis,
                                                  const char *command, const char *version,
                                                  const char *path);

#endif
