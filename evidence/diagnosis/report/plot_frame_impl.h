/* What the pictures of a diagnosis share: size, axis of time, verdict. Private to
 * evidence/diagnosis/report/.
 */
#ifndef UMBRA_DIAGNOSIS_REPORT_PLOT_FRAME_IMPL_H
#define UMBRA_DIAGNOSIS_REPORT_PLOT_FRAME_IMPL_H

#include "base/plot/plot.h"
#include "evidence/diagnosis/diagnosis.h"

/* Pixels. */
#define UM_DIAGNOSIS_PLOT_WIDTH 1000
#define UM_DIAGNOSIS_PLOT_LEFT  100
#define UM_DIAGNOSIS_PLOT_RIGHT 980

/* The axis of time from t_tai `first` to `last`. */
struct um_plot_time um_diagnosis_report_plot_time(double first, double last);
/* The verdict, what was added and what leaves it in doubt: "not identifiable: emittance of white
 * (drawn) or albedo". */
void um_diagnosis_report_plot_verdict(const struct um_diagnosis *diagnosis, char *out, size_t size);

#endif
