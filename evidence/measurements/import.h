/* Measurements out of a table with any header: which column is what. */
#ifndef UMBRA_COMPARE_IMPORT_H
#define UMBRA_COMPARE_IMPORT_H

#include "evidence/measurements/set.h"
#include "orbit/time_form.h"

/* What is said of a table, all optional here: names of columns, and words about one of them. Texts
 * are borrowed. */
struct um_compare_columns {
  const char *time; /* a column, or two with a '+' between: date+time */
  /* the one that holds the value; of temperatures also "COLUMN=PLACE,COLUMN=PLACE,..." */
  const char *magnitude, *flux, *counts, *temperature;
  const char *sigma, *flag, *exposure, *track;
  const char *band;   /* of magnitudes and fluxes: a band of the scenario */
  const char *of;     /* of temperatures a place, of counts a sensor */
  const char *system; /* of magnitudes: "ab" or "vega" */
  const char *unit;   /* of fluxes and temperatures: "W/m2", "C" */
};
/* Number of its members and the word for each, which is the option's name, too: "time"; *member,
 * where it is not NULL, takes the place in the struct. NULL behind the last. Do not fail. */
const char *um_compare_columns_word(size_t index);
const char **um_compare_columns_member(struct um_compare_columns *columns, size_t index);

/* The same as one line, "time=UTC magnitude=V": what holds a blank or a quote stands in quotes, a
 * quote twice. The caller frees *out. */
enum um_status um_compare_columns_text(struct um_context *context,
                                       const struct um_compare_columns *columns, char **out);
/* The columns that a file of measurements was imported by, from its line of comment
 * "# umbra import: time=UTC magnitude=V". *text holds the texts, the caller frees it. UM_ERR_INPUT
 * where there is no such line. */
enum um_status um_compare_columns_read(struct um_context *context, const char *path,
                                       struct um_compare_columns *out, char **text);
#define UM_COMPARE_IMPORT_MARK "umbra import: "

/* What an import found. */
struct um_compare_imported {
  struct um_compare_columns columns; /* as asked, with what was taken by the columns' names: band,
                                        system, unit */
  enum um_orbit_time_form form;      /* how times are written */
  size_t empty;                      /* values that are not there, left out */
  size_t zeros, held;                /* rows of a table of several sensors that are flagged: all
                                        zeros, or beyond chance all as in the row before */
  size_t doubled;                    /* rows of such a table that are left out, as an earlier one
                                        has their time */
  bool sorted;                       /* rows were not in the order of time, and are now */
  char name[64];                     /* text of columns.band */
};

/* Read the table. Band, system and unit that are not said are taken from the names of columns where
 * these say them: "Vmag" is band V of Vega's system. A time is UTC as text, a Julian date, a
 * modified one, or POSIX seconds, all rows alike. Refused, one line with file, line, column and
 * what is accepted: an unknown column, with the nearest and all that there are; no value or more
 * than one kind of it; what is not known of it; fields that are no numbers; and what
 * um_compare_measurements_read refuses of values and between rows. A value that is empty, nan, -,
 * --, null or indef is left out. Of a table with a column a sensor, rows that are no readings are
 * flagged, or left out where they are zeros in kelvins. UM_ERR_IO, UM_ERR_INPUT, UM_ERR_MEMORY;
 * *out is NULL then. The caller destroys. */
enum um_status um_compare_import(struct um_context *context, const char *path,
                                 const struct um_compare_columns *columns,
                                 struct um_compare_imported *found,
                                 struct um_compare_measurements **out);

/* The command that imports this table, guessed from the names of its columns and its first row:
 * "umbra import lc.csv --time UTC --magnitude V --sigma Verr -o lc-measured.csv". The caller frees
 * *out. Errors of um_compare_foreign_table_read; UM_ERR_INPUT where no column looks like a time or
 * like a value. */
enum um_status um_compare_import_suggest(struct um_context *context, const char *path, char **out);

/* Of a magnitude's band or column: "vega", "ab", or NULL where the name says neither. Does not
 * fail. */
const char *um_compare_import_system(const char *name);
/* "V" of "Vmag", "mag_V", "m_V"; false where nothing is left. */
bool um_compare_import_band(const char *column, char *out, size_t size);

#endif
