/* What every verb of the command knows, those that are clients of library/umbra.h alone, too:
 * exits, options, the table of verbs. */
#ifndef UMBRA_APP_CLIENT_H
#define UMBRA_APP_CLIENT_H

#include <stdbool.h>
#include <stdio.h>

#include "library/umbra.h"

struct um_context;
struct um_app_option;

/* Defaults of options. UM_APP_VERSION, as "1.2.3", is the project's, defined by the build. */
#define UM_APP_RENDER_WIDTH      512 /* pixels */
#define UM_APP_RENDER_SAMPLES    16  /* per pixel */
#define UM_APP_FRAME_WIDTH       256 /* pixels of the picture that is put on a detector */
#define UM_APP_FRAME_SAMPLES     8
#define UM_APP_MAP_STEP          2   /* [deg] */
#define UM_APP_MAP_PHASE_ANGLES  "0" /* [deg] */
#define UM_APP_MAP_PLANES        4
#define UM_APP_MAP_TOLERANCE     0.1 /* [1] */
#define UM_APP_AXIS_STEP         5   /* [deg] */
#define UM_APP_SOLUTIONS         24
#define UM_APP_DRAWS             1000
#define UM_APP_FLOOR             0.001 /* of the peak */
#define UM_APP_TEMPERATURE_SIGMA 0.5   /* [K] */

/* Exit codes of every command, and what help and man page say of them: CODE(name, number, text). */
#define UM_APP_EXITS(CODE)                                                                         \
  CODE(UM_APP_DONE, 0, "done")                                                                     \
  CODE(UM_APP_FAILED, 1, "failed: one line on standard error says why")                            \
  CODE(UM_APP_MISUSE, 2, "misuse of the command line")                                             \
  CODE(UM_APP_LOST, 3,                                                                             \
       "study, forecast: points are missing, since their processes died: --resume computes them")  \
  CODE(UM_APP_EXCEEDED, 4, "done, but a limit is exceeded or a case misses its tolerance")
#define UM_APP_EXIT_NAME(name, number, text) name = number,
enum um_app_exit {
  UM_APP_EXITS(UM_APP_EXIT_NAME) UM_APP_SIGNAL = 128 /* + n: ended by signal n */
};

/* Options that verbs have in common, as parsed; texts borrowed from argv. */
struct um_app_options {
  const char *positional[4];
  int npositional;
  int literal;      /* where "--" stands among the arguments; 0: nowhere */
  const char *out;  /* --out, -o */
  const char **set; /* --set KEY=VALUE */
  size_t nset;
  const char **with, **without;
  size_t nwith, nwithout;
  const char **effect_file; /* --effect-file */
  size_t neffect_file;
  const char *time_utc, *band;       /* --time, --band */
  int width, samples;                /* --width, --samples */
  const char *wavelengths, *tile;    /* --wavelengths, --tile */
  const char *sensor, *psf, *motion; /* of frame: --sensor, --psf, --motion */
  const char **star;                 /* of frame and photometry: --star */
  size_t nstar;
  int border;                      /* of frame, 0: not said */
  const char *aperture, *at, *sky; /* of photometry */
  const char *extinction;          /* of calibrate */
  const char **more;               /* arguments behind positional, where the last may be many */
  size_t nmore;
  const char **picture; /* --picture */
  size_t npicture;
  /* of synth: --noise, --seed, --temperatures, --temperature-sigma */
  const char *noise, *seed, *temperatures, *temperature_sigma;
  /* of diagnose and fit: --only, --exclude, --nuisance, --add, --level, --steps */
  const char **only, **exclude, **nuisance, **add;
  size_t nonly, nexclude, nnuisance, nadd;
  const char **what_if; /* of sensitivity: --what-if, --data, --elasticity */
  size_t nwhat_if;
  bool elasticity;
  const char *data;
  double level;                                      /* 0: not said */
  int steps;                                         /* 0: not said */
  int passes;                                        /* of diagnose: --passes N; 0: none */
  const char *draft_effect;                          /* of diagnose: --draft-effect FILE */
  const char *from_brdf, *half_angle, *from_profile; /* of materials */
  const char *from_reflectance, *reference, *angle;
  /* of map and attitude: --step, --phase-angles, --planes, --tolerance */
  const char *step, *phase_angles, *map_tolerance;
  int planes;
  const char *period, *axis_step; /* of attitude: --period, --axis-step */
  int solutions;                  /* --solutions */
  bool study_check;               /* of study: --check */
  const char *measured;           /* of study: --measured FILE */
  bool view;                      /* of check: --view */
  int port;                       /* of serve: --port; 0: any that is free */
  bool times;                     /* of forecast: --times */
  bool force, json, thermal, optics, no_plots, details, allow_effects;
  bool grey_body; /* of synth: --grey-body */
  /* of study and forecast: --workers (0: not said), --share; of diagnose and fit, too: --resume */
  int workers;
  const char *share;
  bool resume;
  bool posterior; /* of fit: --posterior, --draws (0: not said), --seed */
  int draws;
  const char *days, *minimum_elevation; /* of forecast: --days, --minimum-elevation, --station */
  const char **station, **uncertain;    /* and --uncertain */
  size_t nstation, nuncertain;
  /* of import: --time and so on, columns of a table and words about them */
  const char *column_time, *column_magnitude, *column_flux, *column_counts, *column_temperature;
  const char *column_sigma, *column_flag, *column_exposure, *column_track;
  const char *column_band, *column_of, *column_system, *column_unit;
  const char *like, *format;                 /* of import */
  const char *as;                            /* of export: --as */
  const char *from_mesh, *tle, *one_station; /* of new: --from, --tle, --station */
  char *command;                             /* the command as typed */
  const char *replay;                        /* --replay FILE */
  const struct um_app_option **token; /* [argc] what each argument is of; NULL: of no option */
};

/* What an option takes and where it goes. */
enum um_app_takes {
  UM_APP_FLAG,    /* nothing; bool */
  UM_APP_TEXT,    /* const char * */
  UM_APP_LIST,    /* const char **, may come again; the count stands at `count` */
  UM_APP_NUMBER,  /* whole number from 1 to `most`; int */
  UM_APP_SHARE,   /* number between 0 and 1; double */
  UM_APP_THREADS, /* goes to the context */
  UM_APP_HELP
};
/* What a shell offers for an argument. */
enum um_app_offers {
  UM_APP_NOTHING,
  UM_APP_FILES,
  UM_APP_FOLDERS,
  UM_APP_RESULTS, /* folders of results */
  UM_APP_REPLAYS, /* the same, or *.json */
  UM_APP_SCENARIOS,
  UM_APP_STUDIES,
  UM_APP_VIEWS,  /* a scenario, or a factored picture */
  UM_APP_TABLES, /* *.csv */
  UM_APP_EFFECTS,
  UM_APP_MATERIALS,
  UM_APP_SENSORS,
  UM_APP_SECTIONS, /* of the scenario reference */
  UM_APP_SHELLS,
  UM_APP_FILTERS,
  UM_APP_SHIPPED, /* scenarios that come with the program */
  UM_APP_THINGS,  /* what umbra list lists */
  UM_APP_ONE,     /* the name of one of these */
  UM_APP_EXPORTS, /* kinds of export */
  UM_APP_VERBS
};

/* One option; help, man page, completion and parsing follow from it. */
struct um_app_option {
  const char *id; /* what verbs call it */
  const char *name, *argument;
  char letter; /* 0: none */
  enum um_app_takes takes;
  size_t at, count; /* offsets in um_app_options */
  int most;
  enum um_app_offers offers;
  const char *default_value; /* what holds without it; NULL: nothing to say */
  const char *example;       /* NULL: of itself clear */
  const char *help;
};
/* By id; NULL when there is none. */
const struct um_app_option *um_app_option_find(const char *id);
/* In order of the table; NULL behind the last. */
const struct um_app_option *um_app_option_at(size_t index);
/* The next of a list of ids, parted by blanks, NULL at its end; *list moves. */
const struct um_app_option *um_app_option_next(const char **list);

/* Returns the exit status. UM_APP_MISUSE: said what is wrong; the usage line is printed behind it.
 */
typedef int um_app_command(struct um_context *context, const struct um_app_options *options);

/* What a user does with a verb: the help lists verbs by it, in this order. */
enum um_app_group {
  UM_APP_SIMULATE,
  UM_APP_OBSERVE,
  UM_APP_COMPARE,
  UM_APP_EXPLORE,
  UM_APP_LOOK_UP,
  UM_APP_GROUPS /* how many there are */
};

struct um_app_verb {
  const char *name;
  const char *arguments; /* "SCENARIO MEASURED"; "[NAME]" may be left out, "NAME..." be many */
  const char *summary;
  const char *needs,
      *accepts;             /* ids of the options it must have and may have, beside common ones */
  const char *about;        /* what help adds; NULL: nothing */
  const char *examples;     /* a line each */
  const char *listed;       /* heading of a list behind the options; NULL: there is none */
  void (*list)(FILE *file); /* prints it */
  um_app_command *run;
  enum um_app_group group;
  bool unrecorded; /* it has no results that could be made again */
};
/* Ids of the options that it has in common with others. */
const char *um_app_verb_common(const struct um_app_verb *verb);
/* May its last argument come again? */
bool um_app_verb_takes_more(const struct um_app_verb *verb);
size_t um_app_verb_count(void);
const struct um_app_verb *um_app_verb_at(size_t index);
/* NULL when there is none. */
const struct um_app_verb *um_app_verb_find(const char *name);
/* A verb as it was called before: umbra NAME ... is umbra VERB FIRST ... now. */
struct um_app_old_name {
  const char *name;
  char verb[16];
  char first[16];    /* argument that the verb takes first; "": none */
  const char *where; /* only with an argument that begins so; NULL: always */
};
/* The old name `name` before arguments [n]; NULL: it is none. */
struct um_app_old_name *um_app_old_name_find(const char *name, int n, char *const *arguments);
/* The command line with the verb of now, [*argc] with NULL behind; a line on stderr says the new
 * name. The caller frees; NULL: no memory. Texts stay those of argv. */
char **um_app_old_name_translate(struct um_app_old_name *old, int *argc, char **argv);

/* What umbra list lists. */
struct um_app_thing {
  const char *word; /* "materials" */
  const char *holds;
  enum um_app_offers offers; /* names of it, for a shell */
  um_app_command *run;       /* positional[0]: the name of one, or none */
};
/* In order of the table; NULL behind the last. */
const struct um_app_thing *um_app_thing_at(size_t index);
/* Names of filters or scenarios that come with the program, parted by blanks, for a shell. Does not
 * fail: none where their folder is not there. */
void um_app_filters_put(struct um_context *context, FILE *file);
void um_app_scenarios_put(struct um_context *context, FILE *file);

/* A word of an argument list as "SCENARIO" without brackets, false at its end; *list moves. */
bool um_app_argument_next(const char **list, char name[32], bool *optional);
enum um_app_offers um_app_argument_offers(const char *name);

/* "umbra run SCENARIO [--out DIR] ..." on one line, without a line end. */
void um_app_usage(FILE *file, const struct um_app_verb *verb);
/* The commands; one command with its options. */
void um_app_help(FILE *file);
void um_app_help_verb(FILE *file, const struct um_app_verb *verb);
/* "unknown command 'nur'" with the nearest one. */
#define UM_APP_UNKNOWN 192
void um_app_verb_unknown(const char *name, char out[UM_APP_UNKNOWN]);

/* A session whose log goes to the terminal. UM_APP_DONE; UM_APP_FAILED: said why. The caller closes
 * it. */
int um_app_session_open(struct umbra **out);
/* Print the session's message as "umbra: message" on stderr; returns UM_APP_FAILED. */
int um_app_session_fail(const struct umbra *umbra);

/* The manual's page of an effect, as Markdown, and the whole manual of those that come with the
 * program, docs/effects.md. Errors of writing are the stream's. */
void um_app_effect_page(FILE *file, const struct umbra_effect *effect);
void um_app_effect_manual(FILE *file, const struct umbra *umbra);

/* Kinds of umbra export: the name of one, NULL behind the last; a line on each. */
const char *um_app_export_name(size_t index);
void um_app_export_list(FILE *file);

/* The commands. */
um_app_command um_app_new, um_app_export, um_app_run, um_app_list, um_app_scenarios,
    um_app_material, um_app_study, um_app_cases, um_app_check, um_app_forecast, um_app_filters,
    um_app_retrieve, um_app_photometry, um_app_calibrate, um_app_sensors, um_app_materials_profile,
    um_app_materials_reflectance, um_app_materials_fit, um_app_materials, um_app_effects,
    um_app_render, um_app_render_picture, um_app_frame, um_app_expand, um_app_attitude, um_app_map,
    um_app_compare, um_app_period, um_app_import, um_app_diagnose, um_app_fit, um_app_sensitivity,
    um_app_synth, um_app_report, um_app_serve, um_app_replay, um_app_validate, um_app_schema,
    um_app_completion, um_app_help_command;

#endif
