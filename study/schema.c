/* The schema of study.yaml: every key with its type, bounds, default and meaning, once. */
#include "base/document/schema_words.h"
#include "study/file.h"

/* --- parameters ------------------------------------------------------------------------------ */

static const char *const property_choices[] = {"emittance", "absorptance", NULL};
static const char *const spread_choices[] = {"uniform",    "normal",     "log_uniform",
                                             "log_normal", "triangular", NULL};
#define OF struct um_study_file_parameter
static const struct um_schema_field parameter_fields[] = {
    F(name, UM_SCHEMA_TEXT, .name = true,
      HELP("column in the results; default: made from what it moves")),
    F(unit, UM_SCHEMA_TEXT, HELP("printed beside the name; default: the effect's own")),
    F(key, UM_SCHEMA_TEXT, .alternative = 1,
      HELP("path of a number in scenario.yaml, as --set takes it")),
    F(material, UM_SCHEMA_TEXT, .alternative = 1, HELP("material whose property is the value")),
    F(effect, UM_SCHEMA_TEXT, .alternative = 1, HELP("effect of which one parameter is the value")),
    F(property, UM_SCHEMA_CHOICE, NO_DEFAULT, .choices = property_choices,
      HELP("of the material: emittance: hemispherical, at 300 K, its spectrum scaled; absorptance: "
           "of sunlight, its spectrum shifted")),
    F(target, UM_SCHEMA_TEXT, HELP("of the effect, as --with takes it behind the colon")),
    F(parameter, UM_SCHEMA_TEXT, HELP("of the effect; default: the only one that it has")),
    F(from, UM_SCHEMA_NUMBER, NO_DEFAULT,
      HELP("least value; cuts a normal or log-normal distribution")),
    F(to, UM_SCHEMA_NUMBER, NO_DEFAULT, HELP("largest value")),
    F(values, UM_SCHEMA_NUMBERS, .most = 100000, HELP("in place of from and to")),
    F_AS(spread, "distribution", UM_SCHEMA_CHOICE, DEFAULT(UM_STUDY_UNIFORM),
         .choices = spread_choices, HELP("of the values")),
    F(mean, UM_SCHEMA_NUMBER, NO_DEFAULT, HELP("of normal")),
    F(sigma, UM_SCHEMA_NUMBER, NO_DEFAULT,
      HELP("of normal; of the natural logarithm of log_normal")),
    F(median, UM_SCHEMA_NUMBER, NO_DEFAULT, HELP("of log_normal")),
    F(mode, UM_SCHEMA_NUMBER, NO_DEFAULT, HELP("likeliest value of triangular")),
    F(levels, UM_SCHEMA_INTEGER, NO_DEFAULT, BETWEEN(1, 100000),
      HELP("of this parameter in a grid; default: those of the design")),
};
#undef OF
static const int parameter_one[] = {1, 0};
OBJECT(parameter_object, struct um_study_file_parameter, "parameter",
       "What is moved, and between which values.", FIELDS(parameter_fields),
       .exactly_one = parameter_one);

/* --- design, error, outputs ------------------------------------------------------------------ */

static const char *const design_choices[] = {
    "grid", "list", "latin_hypercube", "sobol", "one_at_a_time", "saltelli", "morris", NULL};
#define OF struct um_study_file_design
static const struct um_schema_field design_fields[] = {
    F(kind, UM_SCHEMA_CHOICE, DEFAULT(UM_STUDY_SOBOL), .choices = design_choices,
      HELP("grid: levels of all parameters crossed; list: values of all parameters paired; "
           "one_at_a_time: levels of each while the others stay in the middle; saltelli: for "
           "Sobol indices, points times parameters + 2; morris: for elementary effects, points "
           "trajectories of parameters + 1")),
    F(points, UM_SCHEMA_INTEGER, DEFAULT(100), BETWEEN(1, 2e9),
      HELP("of latin_hypercube and sobol; rows of saltelli; trajectories of morris")),
    F(seed, UM_SCHEMA_INTEGER, DEFAULT(1), BETWEEN(0, 2e9),
      HELP("of random numbers; of sobol 0: the sequence as it is, from its corner")),
    F(levels, UM_SCHEMA_INTEGER, DEFAULT(4), BETWEEN(2, 100000),
      HELP("of every parameter of grid, one_at_a_time and morris")),
};
#undef OF
OBJECT(design_object, struct um_study_file_design, "design", "Which points are computed.",
       FIELDS(design_fields), .scalar_key = "kind");

#define OF struct um_study_file_error
static const struct um_schema_field error_fields[] = {
    F(light, UM_SCHEMA_NUMBER, DEFAULT(1e-3), BETWEEN(1e-5, 0.5),
      HELP("of irradiance, of its value or of 1 % of the curve's largest where that is more; of a "
           "magnitude 1.086 times it")),
    F(temperature_K, UM_SCHEMA_NUMBER, DEFAULT(0.1), BETWEEN(1e-3, 50),
      HELP("of every temperature")),
};
#undef OF
OBJECT(error_object, struct um_study_file_error, "error",
       "How far a point may be from a run of its own.", FIELDS(error_fields));

#define OF struct um_study_file_outputs
static const struct um_schema_field outputs_fields[] = {
    F(bands, UM_SCHEMA_TEXTS, .most = 64,
      HELP("whose irradiance is wanted; default: all, or none where places are named")),
    F(places, UM_SCHEMA_TEXTS, .most = 256,
      HELP("whose mean temperature is wanted, named as in temperatures.csv")),
    F(magnitudes, UM_SCHEMA_BOOL, DEFAULT(0), HELP("AB magnitudes of the bands as well")),
    F(measured, UM_SCHEMA_TEXT, .file = true,
      HELP("a file of measurements (that of umbra compare), from this file's folder: every point's "
           "rms and reduced chi-square against each channel are kept, and points are weighed by "
           "them; --measured takes its place")),
};
#undef OF
OBJECT(outputs_object, struct um_study_file_outputs, "outputs", "What is kept of every point.",
       FIELDS(outputs_fields));

#define OF struct um_study_file_limit
static const struct um_schema_field limit_fields[] = {
    F(of, UM_SCHEMA_TEXT, REQUIRED, HELP("band")),
    F(above, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e6), .alternative = 1,
      HELP("irradiance [W/m2]")),
    F(brighter_than, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(-40, 40), .alternative = 1,
      HELP("AB magnitude; wants outputs.magnitudes")),
};
#undef OF
OBJECT(limit_object, struct um_study_file_limit, "limit",
       "What the satellite may be brighter than.", FIELDS(limit_fields));

/* --- the study ------------------------------------------------------------------------------- */

static const char *const mode_choices[] = {"exact", "surrogate", NULL};
#define OF struct um_study_file
static const struct um_schema_field study_fields[] = {
    F(schema, UM_SCHEMA_INTEGER, REQUIRED, BETWEEN(1, 1), HELP("1")),
    F(name, UM_SCHEMA_TEXT, REQUIRED, .name = true, HELP("names the results")),
    F(summary, UM_SCHEMA_TEXT, HELP("one line")),
    F(scenario, UM_SCHEMA_TEXT, REQUIRED, .file = true,
      HELP("folder or file, from this file's folder")),
    F(parameters, UM_SCHEMA_LIST, REQUIRED, .object = &parameter_object,
      .most = UM_STUDY_PARAMETERS_MAX, HELP("what is moved")),
    F(design, UM_SCHEMA_MAP, .always = true, .object = &design_object, HELP("which points")),
    F(mode, UM_SCHEMA_CHOICE, DEFAULT(UM_STUDY_EXACT), .choices = mode_choices,
      HELP("exact: every point is solved; surrogate: a polynomial through few solved points, held "
           "against others")),
    F(error, UM_SCHEMA_MAP, .always = true, .object = &error_object,
      HELP("what is asked of the results")),
    F(limits, UM_SCHEMA_LIST, .object = &limit_object, .most = 64,
      HELP("how probable it is that a band is brighter")),
    F(outputs, UM_SCHEMA_MAP, .always = true, .object = &outputs_object, HELP("what is kept")),
    F(held_out, UM_SCHEMA_INTEGER, DEFAULT(10), BETWEEN(2, 1000),
      HELP("points that a surrogate is held against")),
    F(evaluations, UM_SCHEMA_INTEGER, DEFAULT(200), BETWEEN(10, 100000),
      HELP("points that a surrogate may solve, those held out with them")),
};
#undef OF
const struct um_schema_object um_study_schema = {
    .name = "study",
    .help = "A parameter study of a scenario.",
    .size = sizeof(struct um_study_file),
    FIELDS(study_fields),
};
