/* Pictures by gnuplot. Every picture of every command goes through here, so that what a user names
 * a thing can be drawn and never be run.
 *
 * A script in the making holds words of ours, numbers, and texts: um_plot_add writes each %s as a
 * string constant of gnuplot, and there is no other way to put a text into a script. Tables lie in
 * files beside it, from which the script reads numbers by place of row and column, never by name.
 * The script stays beside the pictures; `gnuplot -e "kind='pdf'" SCRIPT` draws it again.
 *
 * Lengths on a picture are pixels of its PNG at 96 to the inch, from its upper left corner. */
#ifndef UMBRA_PLOT_PLOT_H
#define UMBRA_PLOT_PLOT_H

#include <stdbool.h>

#include "base/core/context.h"

struct um_plot;

/* A script of that plain file name in a folder. The caller draws or destroys. UM_ERR_IO. */
enum um_status um_plot_create(struct um_context *context, const char *folder, const char *script,
                              struct um_plot **out);
/* Close the script and have gnuplot draw every picture as PNG, SVG and PDF; sets *plot to NULL.
 * UM_ERR_IO where the script could not be written. What goes wrong in gnuplot, or that there is
 * none, is a logged warning: pictures are not results. */
enum um_status um_plot_draw(struct um_context *context, struct um_plot **plot);
/* Accepts NULL, sets NULL. A script that was not drawn remains. */
void um_plot_destroy(struct um_context *context, struct um_plot **plot);

/* printf into the script with %d %u %zu %e %f %g %s %%, where %s writes a string constant, its
 * quotes included: control characters and marks of writing direction become blanks, bytes that are
 * no UTF-8 a question mark, single quotes apostrophes, and 160 characters are enough. A number that
 * is not finite becomes NaN. The format is a literal of ours. Errors of writing are met by
 * um_plot_draw. */
void um_plot_add(struct um_plot *plot, const char *format, ...) UM_PRINTF(2, 3);

/* ---- pictures ---- */

/* Begin a picture of that size: NAME.png and so on. Everything is as gnuplot has it at its start,
 * but the style that all pictures share. Of the name letters, digits, '.', '-', '+' and what is
 * not ASCII are kept, others become '_'; it does not begin with a '.' or '-'. */
void um_plot_picture(struct um_plot *plot, const char *name, int width, int height);
/* Title in bold at the upper left, and what stands below it ("": nothing). */
void um_plot_title(struct um_plot *plot, const char *title, const char *below);
/* Place of the next panel. */
void um_plot_panel(struct um_plot *plot, int left, int top, int right, int bottom);
/* What the vertical axis of the next panels shows: a name as it is, and under it our own words, in
 * which "^2" is raised. Either may be "". */
void um_plot_ylabel(struct um_plot *plot, const char *name, const char *words);
/* Whether the numbers of the horizontal axis are shown. */
void um_plot_xnumbers(struct um_plot *plot, bool shown);

/* Step between four or so numbers of an axis of that length: 1, 2 or 5 times a power of ten. */
double um_plot_spacing(double length);
/* "W/m^2" as "W/m²", for texts. */
void um_plot_unit(const char *unit, char out[80]);
/* Power of ten in whose units numbers up to `largest` are drawn, 1 where they read well as they
 * are; unit: "W/m^2" becomes "10^{-11} W/m^2". */
double um_plot_power(double largest, const char *unit, char out[80]);

/* ---- time ---- */

/* Minutes, hours or days since the first instant, by how long it is. */
struct um_plot_time {
  double first, last; /* t_tai [s] */
  double unit;        /* [s] */
  const char *word;   /* "minutes" */
  char start[32];     /* the first instant, ISO 8601 */
};
/* start: the first instant in words of gnuplot's "%Y-%m-%dT%H:%M:%S". */
struct um_plot_time um_plot_time(double first, double last, const char *start);
/* Place of a time on the axis. */
double um_plot_time_at(const struct um_plot_time *time, double t_tai);
/* The axis is that of the panels to come; x(i) is the place of the time in column i. */
void um_plot_time_axis(struct um_plot *plot, const struct um_plot_time *time);
/* "minutes after 2016-09-21 20:31:02 UTC", below, and what the shades say where there are some. */
void um_plot_time_label(struct um_plot *plot, const struct um_plot_time *time);
/* A run of umbra or penumbra, halfway to its neighbours. */
struct um_plot_shadow {
  double from, to;
  bool umbra;
};
/* The next one from instant *k on, which moves behind it; false: there is none. t rising and sunlit
 * fraction, both [count]. */
bool um_plot_shadow_next(size_t count, const double *t, const double *sunlit, size_t *k,
                         struct um_plot_shadow *out);
/* Runs of umbra as dark, of penumbra as light boxes behind the curves of the panels to come,
 * halfway to the neighbours. t_tai rising and sunlit fraction, both [count]. */
void um_plot_shade(struct um_plot *plot, const struct um_plot_time *time, size_t count,
                   const double *t_tai, const double *sunlit);

/* ---- axes that outliers do not set, curves with gaps ---- */

/* How far few values may stretch an axis at either end [its length]: a third is left for the rest;
 * of light in linear units, where peaks are what one looks for, a nineteenth. */
#define UM_PLOT_STRETCH       1.0
#define UM_PLOT_STRETCH_LIGHT 9.0

/* What an axis holds of a set: all but the last twentieth at either end (3 of fewer than 60, at
 * most a fifth), as of measurements; the middle half, as of a model; nothing for its own sake. */
enum um_plot_shown { UM_PLOT_MOST, UM_PLOT_MIDDLE, UM_PLOT_NEAR };
struct um_plot_values {
  const double *value; /* [n]; what is not finite is left out */
  size_t n;
  enum um_plot_shown shown;
};
/* An axis that holds what it must, and all else within `stretch` times that length. */
struct um_plot_range {
  double low, high;       /* of the axis, with a margin */
  bool cut;               /* a value lies beyond it */
  size_t below, above;    /* of the sets of UM_PLOT_MOST, beyond it */
  double lowest, highest; /* of the same; NaN: none is finite */
};
/* anchor: a value that the axis always holds, NaN for none. 0 to 1 without values. UM_ERR_MEMORY.
 */
enum um_status um_plot_range(struct um_context *context, const struct um_plot_values *set,
                             size_t nset, double anchor, double stretch, struct um_plot_range *out);
/* The vertical axis of the next panels, in units of `unit`, with a line that says how many of
 * UM_PLOT_MOST lie beyond it and how far. edge(v) is then the end of the axis beyond which v lies,
 * NaN for a v on the axis: where the caller marks what is cut. */
void um_plot_ordinate(struct um_plot *plot, const struct um_plot_range *range, double unit,
                      bool reverse);

/* Step of times [n], ascending, beyond which a curve has a gap: eight median ones [s]; INFINITY for
 * fewer than three. UM_ERR_MEMORY. */
enum um_status um_plot_gap(struct um_context *context, size_t n, const double *t, double *out);
/* The table $curveNUMBER, place on the axis of time and value, with an empty line, at which a curve
 * stops, wherever times are further apart than `gap` [s] or a value is not finite. */
void um_plot_curve(struct um_plot *plot, const struct um_plot_time *time, size_t number, size_t n,
                   const double *t, const double *value, double gap);

#endif
