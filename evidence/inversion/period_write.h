/* Periods in files and pictures. */
#ifndef UMBRA_COMPARE_PERIOD_WRITE_H
#define UMBRA_COMPARE_PERIOD_WRITE_H

#include "base/core/file.h"
#include "evidence/inversion/period_report.h"

/* periodogram.csv, folded.csv and, with plots, period_CHANNEL.png into a folder. UM_ERR_IO. */
enum um_status um_compare_period_write(struct um_context *context,
                                       const struct um_compare_period_report *report, bool plots,
                                       struct um_core_folder *folder);

#endif
