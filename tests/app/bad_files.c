/* Files that a scenario names: meshes, material records, tables of attitude and position, elements,
 * Earth orientation. The message names the line of the scenario and the line of the file. */
#include "tests/app/bad.h"

/* A cube of 1 m; every face on a line of its own. Lines 9 and 15 are the last vertex and face. */
#define CUBE                                                                                       \
  "g body\nv -0.5 -0.5 -0.5\nv 0.5 -0.5 -0.5\nv 0.5 0.5 -0.5\nv -0.5 0.5 -0.5\n"                   \
  "v -0.5 -0.5 0.5\nv 0.5 -0.5 0.5\nv 0.5 0.5 0.5\nv -0.5 0.5 0.5\n"                               \
  "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
/* The same cube once more, 0.3 m aside along every axis: it crosses the first. */
#define CUBE_ASIDE                                                                                 \
  "v -0.2 -0.2 -0.2\nv 0.8 -0.2 -0.2\nv 0.8 0.8 -0.2\nv -0.2 0.8 -0.2\n"                           \
  "v -0.2 -0.2 0.8\nv 0.8 -0.2 0.8\nv 0.8 0.8 0.8\nv -0.2 0.8 0.8\n"                               \
  "f 12 11 10 9\nf 13 14 15 16\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\n"
#define SHELL "shell: {areal_heat_capacity_J_m2_K: 3000}\n    lumped: true"
#define MESH                                                                                       \
  {                                                                                                \
    "box: {size_m: [1, 1, 1]}", "mesh: body.obj", 0                                                \
  }
#define SOLID                                                                                      \
  {                                                                                                \
    "box: {size_m: [1, 1, 1]}\n    outside: grey_white\n    " SHELL,                               \
        "mesh: body.obj\n    outside: grey_white\n    solid: aluminium_bare", 0                    \
  }

#define RECORD                                                                                     \
  "name: mine\nsummary: A test.\ncitation: None.\ngrey:\n  solar_absorptance: 0.2\n"               \
  "  emittance: 0.8\n"
#define MATERIALS                                                                                  \
  {                                                                                                \
    "bands:", "material_files: [mine.yaml]\nbands:", 0                                             \
  }

#define TURNS                                                                                      \
  "time_utc,q0,q1,q2,q3\n2016-09-06T17:00:00Z,1,0,0,0\n2016-09-06T17:30:00Z,1,0,0,0\n"             \
  "2016-09-06T18:00:00Z,1,0,0,0\n2016-09-06T18:30:00Z,1,0,0,0\n"
#define ATTITUDE                                                                                   \
  {                                                                                                \
    "- lvlh: {}", "- table: turns.csv", 0                                                          \
  }

#define PLACES                                                                                     \
  "time_utc,x_km,y_km,z_km,vx_km_s,vy_km_s,vz_km_s\n"                                              \
  "2016-09-06T18:00:00Z,7000,0,0,0,7.5,0\n2016-09-06T18:05:00Z,6637,2221,0,-2.4,7.1,0\n"           \
  "2016-09-06T18:20:00Z,2000,6700,0,-7.2,2.1,0\n"
#define ELEMENTS                                                                                   \
  "1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"                        \
  "2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n"
#define TLE(key)                                                                                   \
  {                                                                                                \
    "  tle: |\n    1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"        \
    "    2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n",                 \
        "  " key "\n", 0                                                                           \
  }
#define OBSERVER                                                                                   \
  {                                                                                                \
    "station: {name: Graz, latitude_deg: 47.067, longitude_deg: 15.493, height_m: 495}",           \
        "trajectory: {table: places.csv}", 0                                                       \
  }
#define FINALS                                                                                     \
  {                                                                                                \
    "attitude:", "  earth_orientation: {finals: finals.all}\nattitude:", 0                         \
  }

#define OBJ(label, ...)                                                                            \
  {                                                                                                \
    .name = "mesh: " label, .scenario = MESH, .file = "body.obj", .base = CUBE,                    \
    .line_of = "mesh: body.obj", __VA_ARGS__                                                       \
  }
#define TETRA(label, ...)                                                                          \
  {                                                                                                \
    .name = "solid mesh: " label, .scenario = SOLID, .file = "body.obj", .base = CUBE,             \
    .line_of = "name: bus", __VA_ARGS__                                                            \
  }
#define REC(label, ...)                                                                            \
  {                                                                                                \
    .name = "record: " label, .scenario = MATERIALS, .file = "mine.yaml", .base = RECORD,          \
    __VA_ARGS__                                                                                    \
  }
#define ATT(label, ...)                                                                            \
  {                                                                                                \
    .name = "attitude table: " label, .scenario = ATTITUDE, .file = "turns.csv", .base = TURNS,    \
    .line_of = "turns.csv", __VA_ARGS__                                                            \
  }
#define ORB(label, ...)                                                                            \
  {                                                                                                \
    .name = "trajectory table: " label, .scenario = TLE("table: places.csv"),                      \
    .file = "places.csv", .base = PLACES, .line_of = "table: places.csv", __VA_ARGS__              \
  }
#define ELE(label, ...)                                                                            \
  {                                                                                                \
    .name = "elements file: " label, .scenario = TLE("tle_file: sat.tle"), .file = "sat.tle",      \
    .base = ELEMENTS, .line_of = "tle_file:", __VA_ARGS__                                          \
  }
#define OBS(label, ...)                                                                            \
  {                                                                                                \
    .name = "observer's table: " label, .scenario = OBSERVER, .file = "places.csv",                \
    .base = PLACES, .line_of = "trajectory:", __VA_ARGS__                                          \
  }
#define IERS(label, ...)                                                                           \
  {                                                                                                \
    .name = "finals: " label, .scenario = FINALS, .file = "finals.all",                            \
    .line_of = "earth_orientation:", __VA_ARGS__                                                   \
  }

static const struct bad_case cases[] = {
    OBJ("missing", .kind = BAD_MISSING, .says = {"parts.bus.mesh: body.obj: No such file"}),
    OBJ("a folder", .kind = BAD_FOLDER, .says = {"body.obj: is not a plain file but a folder"}),
    OBJ("empty", .kind = BAD_EMPTY, .says = {"body.obj: no faces"}),
    OBJ("binary", .kind = BAD_BINARY, .says = {"body.obj:1: ", "accepted"}),
    OBJ("truncated", .edit = {NULL, NULL, 180}, .says = {"body.obj:", "truncated"}),
    OBJ("nan", .edit = {"v 0.5 0.5 0.5", "v nan 0.5 0.5", 0},
        .says = {"body.obj:8: ", "'nan' is not a finite number"}),
    OBJ("no such vertex", .edit = {"f 4 1 5 8", "f 4 1 5 9", 0},
        .says = {"body.obj:15: ", "9 is out of range", "8 vertices"}),
    OBJ("incomplete face", .edit = {"f 4 1 5 8", "f 4 1", 0},
        .says = {"body.obj:15: ", "at least 3"}),
    TETRA("open", .edit = {"f 4 1 5 8\n", "", 0},
          .says = {"parts.bus: ", "declared solid", "not closed: 4 open edges"}),
    TETRA("a face turned over", .edit = {"f 4 1 5 8\n", "f 8 5 1 4\n", 0},
          .says = {"parts.bus: ", "declared solid", "turned against each other"}),
#ifdef UMBRA_TETGEN
    {.name = "solid mesh: crosses itself",
     .scenario = SOLID,
     .file = "body.obj",
     .base = CUBE CUBE_ASIDE,
     .line_of = "name: bus",
     .says = {"parts.bus: ", "the surface crosses itself", "accepted: facets that meet"}},
#endif
    REC("missing", .kind = BAD_MISSING, .says = {"material_files: mine.yaml: No such file"}),
    REC("a folder", .kind = BAD_FOLDER, .says = {"mine.yaml: is not a plain file but a folder"}),
    REC("empty", .kind = BAD_EMPTY, .says = {"mine.yaml: empty", "accepted: "}),
    REC("binary", .kind = BAD_BINARY, .says = {"mine.yaml:1: not text", "accepted: "}),
    REC("truncated", .edit = {NULL, NULL, 30}, .says = {"mine.yaml:"}),
    REC("nan", .edit = {"0.2", ".nan", 0},
        .says = {"mine.yaml:5: grey.solar_absorptance: '.nan'", "a finite number"}),
    REC("unknown key", .edit = {"emittance", "emitance", 0},
        .says = {"mine.yaml:6: grey.emitance: ", "did you mean 'emittance'"}),
    REC("out of range", .edit = {"0.2", "1.2", 0},
        .says = {"mine.yaml:5: grey.solar_absorptance: 1.2 is out of range", "at most 1"}),
    ATT("missing", .kind = BAD_MISSING, .says = {"attitude.0.table: turns.csv: No such file"}),
    ATT("a folder", .kind = BAD_FOLDER, .says = {"turns.csv: is not a plain file but a folder"}),
    ATT("empty", .kind = BAD_EMPTY, .says = {"turns.csv: empty; accepted: CSV"}),
    ATT("binary", .kind = BAD_BINARY, .says = {"turns.csv: not a text file", "accepted: CSV"}),
    ATT("truncated", .edit = {NULL, NULL, 70}, .says = {"turns.csv:3: ", "fields", "accepted: 5"}),
    ATT("nan", .edit = {"1,0,0,0", "nan,0,0,0", 0},
        .says = {"turns.csv:2: column 'q0': 'nan' is not a finite number"}),
    ATT("not a unit quaternion", .edit = {"1,0,0,0", "1,1,0,0", 0},
        .says = {"turns.csv:2: ", "norm 1.41421", "accepted"}),
    ATT("without a column", .edit = {"q3", "q4", 0}, .says = {"column 'q3' is missing"}),
    ATT("out of order", .edit = {"T17:30", "T16:30", 0},
        .says = {"turns.csv:3: column 'time_utc'", "ascending"}),
    {.name = "attitude table: ends too early",
     .scenario = ATTITUDE,
     .file = "turns.csv",
     .base = TURNS,
     .edit = {"2016-09-06T18:30:00Z,1,0,0,0\n", "", 0},
     .line_of = "turns.csv",
     .says = {"attitude.0.table: turns.csv: ", "is wanted at 2016-09-06T18:",
              "covers 2016-09-06T17:00:00"}},
    ORB("missing", .kind = BAD_MISSING, .says = {"orbit.table: places.csv: No such file"}),
    ORB("a folder", .kind = BAD_FOLDER, .says = {"places.csv: is not a plain file but a folder"}),
    ORB("empty", .kind = BAD_EMPTY, .says = {"places.csv: empty; accepted: CSV"}),
    ORB("binary", .kind = BAD_BINARY, .says = {"places.csv: not a text file", "accepted: CSV"}),
    ORB("truncated", .edit = {NULL, NULL, 100},
        .says = {"places.csv:3: ", "fields", "accepted: 7"}),
    ORB("nan", .edit = {"6637", "nan", 0},
        .says = {"places.csv:3: column 'x_km': 'nan' is not a finite number"}),
    ORB("unknown column", .edit = {"z_km", "z_m", 0}, .says = {"'z_m'", "accepted"}),
    ORB("out of order", .edit = {"T18:05", "T17:05", 0},
        .says = {"places.csv:3: column 'time_utc'", "ascending"}),
    {.name = "trajectory table: does not cover the run",
     .scenario = TLE("table: places.csv"),
     .file = "places.csv",
     .base = PLACES,
     .edit = {"2016-09-06T18:20:00Z,2000,6700,0,-7.2,2.1,0\n", "", 0},
     .line_of = "table: places.csv",
     .says = {"orbit.table: places.csv: ", "is wanted at 2016-09-06T18:",
              "covers 2016-09-06T18:00:00"}},
    ELE("missing", .kind = BAD_MISSING, .says = {"orbit.tle_file: sat.tle: No such file"}),
    ELE("a folder", .kind = BAD_FOLDER, .says = {"sat.tle: is not a plain file but a folder"}),
    ELE("empty", .kind = BAD_EMPTY, .says = {"sat.tle: ", "line 1 is missing", "accepted"}),
    ELE("binary", .kind = BAD_BINARY, .says = {"sat.tle: ", "accepted"}),
    ELE("truncated", .edit = {NULL, NULL, 100}, .says = {"sat.tle: ", "line 2", "69"}),
    ELE("wrong checksum", .edit = {"760345", "760344", 0},
        .says = {"sat.tle: ", "line 2", "checksum is 5, the line says 4"}),
    OBS("missing", .kind = BAD_MISSING,
        .says = {"observer.trajectory.table: places.csv: No such file"}),
    OBS("nan", .edit = {"6637", "nan", 0}, .says = {"places.csv:3: column 'x_km': 'nan'"}),
    IERS("missing", .kind = BAD_MISSING,
         .says = {"orbit.earth_orientation.finals: finals.all: No such file"}),
    IERS("empty", .kind = BAD_EMPTY, .says = {"finals.all: ", "accepted"}),
    IERS("binary", .kind = BAD_BINARY, .says = {"finals.all", "accepted"}),
};

int main(void) { return bad_run("bad files", cases, sizeof cases / sizeof cases[0]); }
