/* Forecasts as a table, as a calendar, as a picture and as a page. */
#ifndef UMBRA_STUDY_FORECAST_WRITE_H
#define UMBRA_STUDY_FORECAST_WRITE_H

#include <stdio.h>

#include "base/core/file.h"
#include "forecast/forecast.h"

/* One row a pass; columns: docs/files.md. Errors of writing are the stream's. */
void um_forecast_csv(const struct um_forecast *forecast, FILE *file);
/* Curves of every pass: pass, time, magnitudes, irradiances. Errors of writing are the stream's. */
void um_forecast_curves(const struct um_forecast *forecast, FILE *file);
/* What each uncertain parameter does to each pass at 1 sigma; columns: docs/files.md. Errors of
 * writing are the stream's. */
void um_forecast_contributions(const struct um_forecast *forecast, FILE *file);
/* iCalendar (RFC 5545): an event a pass that was computed. Errors of writing are the stream's. */
void um_forecast_ics(const struct um_forecast *forecast, FILE *file);
/* Magnitudes and signals against the time of night, drawn in `folder`. Errors
 * of um_plot_draw. */
enum um_status um_forecast_plot(struct um_context *context, const struct um_forecast *forecast,
                                const char *folder);

/* report.html of a forecast whose passes were computed, behind the picture that it may show.
 * Errors of um_model_sample_seen; UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_forecast_page(struct um_context *context, const struct um_forecast *forecast,
                                struct um_core_folder *folder);

/* All of these into a folder that is being written: passes.csv, curves.csv, passes.ics, where
 * something is uncertain contributions.csv, report.html. UM_ERR_IO; errors of um_forecast_plot and
 * um_forecast_page. */
enum um_status um_forecast_write(struct um_context *context, const struct um_forecast *forecast,
                                 bool pictures, struct um_core_folder *folder);

/* A text value of iCalendar: backslash, semicolon, comma and line end escaped, other control
 * characters left out (RFC 5545, 3.3.11). out: [size], cut at whole characters where it is full. */
void um_forecast_ics_escape(const char *text, char *out, size_t size);
/* A content line, folded at 75 bytes without breaking a character of UTF-8, with CRLF (3.1). */
void um_forecast_ics_line(FILE *file, const char *line);

#endif
