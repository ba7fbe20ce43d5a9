/* Names that would be commands, quotes or lines of their own where they are written again, and
 * sizes that no scenario has: each is refused where it is read, with its key. */
#include <stdio.h>

#include "tests/app/bad.h"

#define ACCEPTED "accepted: a name of at most 255 bytes without control characters"
#define FIRST    "its first character none of = + - @"
#define BAND     "  vis: {from_um: 0.38, to_um: 0.78, bins: 4}"
#define BUS      "  - name: bus"
#define STATION  "station: {name: Graz"
#define THERMAL  "thermal: {start: isothermal, orbits_before: 0.05, step_s: 30}"
#define TIME     "time: {start_utc: 2016-09-06T18:07:00Z, stop_utc: 2016-09-06T18:11:00Z, step_s: 60}"
#define PRISM    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng a\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
#define SHAPE    "box: {size_m: [1, 1, 1]}"

/* A change of the scenario, the text whose line is named, and what is said. */
#define NAMED(what, from, to, line, ...)                                                           \
  {                                                                                                \
    .name = what, .scenario = {from, to, 0}, .line_of = line, .says = { __VA_ARGS__ }              \
  }
#define SET(what, option_, ...)                                                                    \
  {                                                                                                \
    .name = what, .option = {"--set", option_}, .says = { __VA_ARGS__ }                            \
  }

static const struct bad_case cases[] = {
    NAMED("backtick in the scenario's name", "name: box", "name: \"a `touch x`\"", "name: \"a",
          "name: 'a `touch x`'", ACCEPTED),
    NAMED("dollar in the scenario's name", "name: box", "name: a$(touch x)", "name: a$", ACCEPTED),
    NAMED("backslash in a part's name", BUS, "  - name: b\\x", "  - name: b", "name: 'b\\x'",
          ACCEPTED),
    NAMED("quote in a part's name", BUS, "  - name: b\"x", "  - name: b", ACCEPTED),
    NAMED("line end in a part's name", BUS, "  - name: \"b\\nx\"", "  - name: \"b", ACCEPTED),
    NAMED("NEL in a part's name", BUS, "  - name: \"b\\x85x\"", "  - name: \"b", ACCEPTED),
    NAMED("backtick in a band's name", BAND, "  \"v`id`\": {from_um: 0.38, to_um: 0.78, bins: 4}",
          "  \"v`id`\"", "'v`id`'", ACCEPTED),
    NAMED("dollar in a material", "outside: grey_white", "outside: $HOME", "    outside: $HOME",
          "parts.bus.outside", ACCEPTED),
    NAMED("backtick in a station", STATION, "station: {name: \"`id`\"",
          "  station:", "observer.station.name", ACCEPTED),
    NAMED("quote in a parent", "    outside: grey_white",
          "    parent: 'a\"b'\n    outside: grey_white", "    parent", "parts.bus.parent",
          ACCEPTED),
    NAMED("dollar in a material group", "    outside: grey_white",
          "    materials: {$x: grey_white}", "    materials", "'$x'", ACCEPTED),
    NAMED("backtick in a thermal group", "    outside: grey_white",
          "    outside: grey_white\n    groups: {\"`\": {power_W: 1}}", "    groups", ACCEPTED),
    NAMED("dollar in a contact", THERMAL,
          "contacts: [{a: bus, b: $x, conductance_W_K: 1}]\n" THERMAL, "contacts", "contacts.0.b",
          ACCEPTED),
    NAMED("backtick in an effect's target", THERMAL,
          "effects: [{effect: area, target: \"`id`\"}]\n" THERMAL, "effects", "target", ACCEPTED),
    NAMED("quote in what noise is of", THERMAL,
          "measurements: {noise: [{quantity: temperature, of: 'x\"y'}]}\n" THERMAL, "measurements",
          "measurements.noise.0.of", ACCEPTED),
    NAMED("dollar in what is excluded", THERMAL, "measurements: {exclude: [$x]}\n" THERMAL,
          "measurements", "measurements.exclude.0", ACCEPTED),
    NAMED("a formula in the scenario's name", "name: box", "name: \"=1+1\"", "name: \"=1",
          "name: '=1+1'", FIRST),
    NAMED("a formula in a part's name", BUS, "  - name: \"@SUM(1)\"", "  - name: \"@",
          "name: '@SUM(1)'", FIRST),
    NAMED("a sign before a part's name", BUS, "  - name: +bus", "  - name: +", "name: '+bus'",
          FIRST),
    NAMED("a formula in a band's name", BAND, "  \"=vis\": {from_um: 0.38, to_um: 0.78, bins: 4}",
          "  \"=vis\"", "'=vis'", FIRST),
    NAMED("a sign before a case's name", THERMAL, "cases: {-hot: {}}\n" THERMAL, "cases", "'-hot'",
          FIRST),
    NAMED("a formula in a station", STATION, "station: {name: \"=1\"",
          "  station:", "observer.station.name", FIRST),
    NAMED("a formula in a material", "outside: grey_white", "outside: \"@white\"",
          "    outside: \"@", "parts.bus.outside", FIRST),
    NAMED("a mark of direction in a part's name", BUS, "  - name: \"b\\u202ex\"", "  - name: \"b",
          ACCEPTED),
    NAMED("an escape sequence in a summary", "name: box", "name: box\nsummary: \"\\e[2J\"",
          "summary:", "summary: ' [2J' holds a control character"),
    SET("a formula by --set", "name==1", "--set: name", FIRST),
    NAMED("a formula in a sensor's name", THERMAL, "sensors: {=eye: {band: vis}}\n" THERMAL,
          "sensors", "'=eye'", FIRST),
    SET("line end by --set", "name=a\n\nb", "--set: name", ACCEPTED),
    SET("two carriage returns by --set", "parts.bus.outside=white\r\rx", "--set: parts.bus.outside",
        ACCEPTED),
    {.name = "backtick in a group of a mesh",
     .scenario = {SHAPE, "mesh: m.obj", 0},
     .file = "m.obj",
     .base = PRISM,
     .edit = {"g a", "g `id`", 0},
     .says = {"m.obj:5: '`id`' is not accepted", ACCEPTED}},
    {.name = "dollar in a material of a mesh",
     .scenario = {SHAPE, "mesh: m.obj", 0},
     .file = "m.obj",
     .base = PRISM,
     .edit = {"g a", "usemtl $(id)", 0},
     .says = {"m.obj:5: '$(id)' is not accepted", ACCEPTED}},
    {.name = "quote in a material record's name",
     .scenario = {THERMAL, "material_files: [x.mat.yaml]\n" THERMAL, 0},
     .file = "x.mat.yaml",
     .base = "name: a\"b\nsummary: x\ncitation: x\n"
             "grey: {solar_absorptance: 0.5, emittance: 0.9, vis_reflectance_diffuse: 0.5}\n",
     .says = {"x.mat.yaml:1: name: 'a\"b'", ACCEPTED}},

    NAMED("load step of a nanosecond", "step_s: 30}", "step_s: 1e-9}", "thermal:",
          "thermal.step_s: ", "instants of the heat loads", "accepted: up to 5e+06 of them"),
    NAMED("more orbits than are followed", THERMAL,
          "thermal: {start: isothermal, orbits_before: 10000}",
          "thermal:", "thermal.orbits_before: ", "accepted: up to 5e+06 of them"),
    NAMED("a span of 83 years",
          TIME "\norbit:\n  tle: |\n"
               "    1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
               "    2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n",
          "time: {start_utc: 2016-03-20T04:30:00Z, stop_utc: 2099-03-20T04:31:00Z, step_s: 1e7}\n"
          "orbit: {circular: {altitude_km: 765, beta_deg: 0}}\n",
          NULL, "accepted: up to 5e+06 of them"),
    NAMED("exposures of too many instants", "step_s: 60}",
          "step_s: 0.001, exposure_s: 0.0005, exposure_samples: 1000}",
          "time:", "time.exposure_samples: ", "observed instants"),
    NAMED("an altitude of a metre",
          "  tle: |\n"
          "    1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
          "    2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n",
          "  circular: {altitude_km: 0.001}\n", "  circular:", "orbit.circular.altitude_km",
          "at least 1"),
};

int main(void) { return bad_run("bad_names", cases, sizeof cases / sizeof cases[0]); }
