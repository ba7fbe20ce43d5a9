/* A page to look at: one HTML file with figures, that needs no network. What it holds, and how, is
 * in format.md; the viewer in web/ draws it in a browser. Where the viewer was not built, the page
 * shows pictures and tables.
 *
 * A page is written section by section, in the order of its story; each answers one question. What
 * is handed over is copied. Errors of memory are kept, and returned by um_page_write. Texts are
 * UTF-8 and stand as they are: nothing in them becomes markup or script. */
#ifndef UMBRA_PAGE_PAGE_H
#define UMBRA_PAGE_PAGE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "base/core/file.h"

#define UM_PAGE_FILE "report.html"

struct um_page;

struct um_page_head {
  const char *command;      /* where none is on record (base/core/replay.h) */
  const char *kind, *title; /* "run"; of the page */
  const char *about;        /* what the title ends in, ": what moves it"; NULL: nothing */
  const char *token;        /* of umbra serve, which brings the page; NULL: it is a file */
};
/* The caller destroys. UM_ERR_MEMORY. */
enum um_status um_page_create(struct um_context *context, const struct um_page_head *head,
                              struct um_page **out);
/* Accepts NULL, sets NULL. */
void um_page_destroy(struct um_context *context, struct um_page **page);
/* Was the viewer built? */
bool um_page_has_viewer(void);

/* A sentence of the lead, most important first. */
void um_page_lead(struct um_page *page, const char *format, ...) UM_PRINTF(2, 3);
/* A line of the table of facts. name: a literal of the program. */
void um_page_fact(struct um_page *page, const char *name, const char *format, ...) UM_PRINTF(3, 4);

enum um_page_level { UM_PAGE_PLAIN, UM_PAGE_GOOD, UM_PAGE_WARNING, UM_PAGE_BAD };
/* The next section. id: a word of its own, letters and '-'. */
void um_page_section(struct um_page *page, const char *id, const char *question,
                     enum um_page_level level);
/* A sentence of the section, before its figures. */
void um_page_text(struct um_page *page, const char *format, ...) UM_PRINTF(2, 3);
/* For a page without viewer: an SVG file that shows what the figures of the section do. Must be
 * there when the page is written; one that is not is left out. */
void um_page_picture(struct um_page *page, const char *path);

/* ---- figures ---- */

/* What each figure has. */
struct um_page_figure {
  const char *id, *title; /* id: letters, digits and '-', one of the page */
  const char *text;       /* what to see; NULL: nothing */
  const char *file;       /* table beside the page that has the numbers; NULL: none */
};

enum um_page_scale { UM_PAGE_LINEAR, UM_PAGE_LOG, UM_PAGE_MAGNITUDE, UM_PAGE_TIME };
enum um_page_mark { UM_PAGE_LINE, UM_PAGE_POINTS, UM_PAGE_STEP, UM_PAGE_AREA };

struct um_page_series {
  const char *name;
  const char *role;   /* "model", "before", "after", "measured", "part"; NULL: none */
  const char *column; /* of the figure's file; NULL: none */
  enum um_page_mark mark;
  bool hidden;              /* off at first */
  const double *value;      /* [count] */
  const double *error;      /* [count] one standard deviation; NULL: none */
  const double *low, *high; /* [count] a band; NULL: none */
  const double *x;          /* [count] where they stand; NULL: those of the axis */
  size_t count;             /* 0: as many as the axis has */
};
struct um_page_panel {
  const char *name, *unit; /* "1": none */
  enum um_page_scale scale;
  bool stacked;                        /* areas above each other */
  bool zero;                           /* a line at 0 */
  const struct um_page_series *series; /* [nseries] */
  size_t nseries;
};
struct um_page_axis {
  const char *name, *unit; /* "UTC" of times */
  enum um_page_scale scale;
  const double *value; /* [count]; of UM_PAGE_TIME seconds since 1970, UTC */
  size_t count;
};
struct um_page_shade {
  double from, to; /* on the horizontal axis */
  const char *name;
};
/* Curves over one horizontal axis, panels below each other. */
void um_page_axes(struct um_page *page, const struct um_page_figure *figure,
                  const struct um_page_axis *x, const struct um_page_shade *shade, size_t nshade,
                  const struct um_page_panel *panel, size_t npanel);

struct um_page_column {
  const char *name, *unit;
  const char *const *text; /* [rows]; NULL: numbers */
  const double *value;     /* [rows] */
};
void um_page_table(struct um_page *page, const struct um_page_figure *figure,
                   const struct um_page_column *column, size_t ncolumn, size_t nrow);

struct um_page_bar {
  const char *name, *text; /* text: NULL: none */
  double value, error;     /* error NaN: none */
};
void um_page_bars(struct um_page *page, const struct um_page_figure *figure,
                  const struct um_page_axis *value, const struct um_page_bar *bar, size_t nbar);

/* What a thing reaches, beside what it may. Ranges of one name are those of one row's cases. */
struct um_page_range {
  const char *name, *of;   /* "battery", "hot" */
  double low, high;        /* what it reaches */
  double error;            /* how far these are uncertain to both sides; NaN: not known */
  double minimum, maximum; /* what it may; NaN: no bound */
  const char *text;        /* "kept by 3.20 K"; NULL: none */
  bool exceeded;
};
void um_page_ranges(struct um_page *page, const struct um_page_figure *figure,
                    const struct um_page_axis *value, const struct um_page_range *range,
                    size_t nrange);

/* z[y][x] */
void um_page_map(struct um_page *page, const struct um_page_figure *figure,
                 const struct um_page_axis *x, const struct um_page_axis *y, const char *name,
                 const char *unit, const double *z, bool diverging);

struct um_page_mark_at {
  double time; /* seconds since 1970, UTC */
  const char *name;
};
struct um_page_sky {
  const double *time, *azimuth_deg, *elevation_deg, *sunlit; /* [count] */
  size_t count;
  const struct um_page_mark_at *mark; /* [nmark] */
  size_t nmark;
};
void um_page_sky(struct um_page *page, const struct um_page_figure *figure,
                 const struct um_page_sky *sky);

struct um_page_slider {
  const char *name, *label, *unit;
  double null_value, minimum, maximum, reach,
      width; /* reach: INFINITY: everywhere; NaN: not known */
  bool is_switch, logarithmic;
  const char *text; /* why a line does not follow it; NULL: it does */
};
struct um_page_curve {
  const char *name, *unit, *panel; /* panel: its heading */
  const double *base;              /* [count] */
  const double *const *derivative; /* [nslider][count] */
  const double *error;             /* [nslider] of a derivative, of its largest value */
};
/* What-ifs: curve = base + sum over sliders of (value - null) derivative. */
void um_page_sliders(struct um_page *page, const struct um_page_figure *figure,
                     const struct um_page_axis *x, const struct um_page_shade *shade, size_t nshade,
                     const struct um_page_slider *slider, size_t nslider,
                     const struct um_page_curve *curve, size_t ncurve);

/* ---- the scene ---- */

struct um_page_body {
  const char *name;
  const double *pose; /* [ntime][7] quaternion, scalar first, and translation [m]: its own axes to
                         body axes */
};
struct um_page_quantity {
  const char *id, *name, *unit;
  enum um_page_scale scale;
  const double *value; /* [ntime][nsurface]; stored in 65535 steps of its range */
};
struct um_page_scene {
  size_t nvertex, ntriangle, nsurface, ntime;
  const double *vertex;     /* [nvertex][3] body axes [m] */
  const uint32_t *triangle; /* [ntriangle][3] counter-clockwise from outside */
  const uint32_t *surface;  /* [ntriangle] */
  const uint32_t *body;     /* [ntriangle] that carries it, into `bodies`; NULL: none moves */
  const uint32_t *part, *material; /* [nsurface] */
  const char *const *part_name, *const *material_name;
  size_t npart, nmaterial;
  const double *time;                                   /* [ntime] seconds since 1970, UTC */
  const double *observer, *sun, *nadir, *velocity, *up; /* [ntime][3] unit, body axes; NULL */
  const double *sunlit;                                 /* [ntime]; NULL */
  const struct um_page_body *bodies;                    /* [nbody] */
  size_t nbody;
  const struct um_page_quantity *quantity; /* [nquantity] */
  size_t nquantity;
};
/* The satellite in three dimensions, once a page, in the section at hand. */
void um_page_scene(struct um_page *page, const struct um_page_figure *figure,
                   const struct um_page_scene *scene);

/* Write the page; it may be written again. The caller looks for errors of the stream.
 * UM_ERR_MEMORY: something of it is missing; UM_ERR_LIBRARY: zlib. */
enum um_status um_page_write(struct um_context *context, struct um_page *page, FILE *file);
/* The same as report.html of a folder in the making. UM_ERR_IO, too. */
enum um_status um_page_write_report(struct um_context *context, struct um_page *page,
                                    struct um_core_folder *folder);

#endif
