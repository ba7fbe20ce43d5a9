/* A small scenario-like schema with every type of field. */
#include "tests/base/document/sample_schema.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const char sample_text[] = "name: demo # the name\n"
                           "altitude_km: 800\n"
                           "time: {start: T0+5, step_s: 2}   # flow\n"
                           "parts:\n"
                           "  # the bus\n"
                           "  - {name: bus, size_m: [1, 2, 3]}\n"
                           "  - name: solar.array\n"
                           "    shell:\n"
                           "      thickness_m: 0.01  # thin\n"
                           "  - name: solar\n"
                           "materials:\n"
                           "  mli: {emittance: 0.5}\n"
                           "effects:\n"
                           "  - {effect: panel, target: bus, efficiency: 0.1}\n"
                           "  - {effect: albedo, off: true}\n"
                           "  - {effect: glint, target: bus}\n"
                           "  - {effect: glint, target: solar}\n"
                           "levels: [1, 2.5, -3e-1]\n"
                           "tags: [a, \"b, c\", 'd']\n"
                           "atmosphere: clear_sky\n"
                           "verbose: false\n";

/* "T0+seconds" into a double. */
static bool parse_start(const char *text, void *target, char *why, size_t why_size)
{
  double value;
  char tail;
  if (strncmp(text, "T0+", 3) != 0 || sscanf(text + 3, "%lf%c", &value, &tail) != 1) {
    snprintf(why, why_size, "T0+seconds");
    return false;
  }
  memcpy(target, &value, sizeof value);
  return true;
}

static const char *const models[] = {"none", "clear_sky", NULL};
static const int one_orbit[] = {1, 0};

static const struct um_schema_field time_fields[] = {
    UM_FIELD(struct sample_time, start, "start", UM_SCHEMA_PARSED, .required = true,
             .length = sizeof(double), .parse = parse_start, .help = "First instant."),
    UM_FIELD(struct sample_time, step, "step_s", UM_SCHEMA_NUMBER, .minimum = 0.0,
             .maximum = INFINITY, .open_minimum = true, .default_value = 1.0, .help = "Step."),
};
static const struct um_schema_object time_object = {.name = "time",
                                                    .size = sizeof(struct sample_time),
                                                    .fields = time_fields,
                                                    .nfield = UM_FIELD_COUNT(time_fields)};

static const struct um_schema_field shell_fields[] = {
    UM_FIELD(struct sample_shell, thickness, "thickness_m", UM_SCHEMA_NUMBER, .required = true,
             .help = "Thickness."),
};
static const struct um_schema_object shell_object = {.name = "shell",
                                                     .size = sizeof(struct sample_shell),
                                                     .fields = shell_fields,
                                                     .nfield = UM_FIELD_COUNT(shell_fields)};

static const struct um_schema_field part_fields[] = {
    UM_FIELD(struct sample_part, name, "name", UM_SCHEMA_TEXT, .required = true, .help = "Name."),
    UM_FIELD(struct sample_part, shell, "shell", UM_SCHEMA_MAP, .object = &shell_object),
    UM_FIELD(struct sample_part, size, "size_m", UM_SCHEMA_VECTOR, .length = 3, .minimum = 0.0,
             .maximum = 100.0, .default_value = NAN),
    UM_FIELD(struct sample_part, lumped, "lumped", UM_SCHEMA_BOOL),
};
static const struct um_schema_object part_object = {.name = "part",
                                                    .size = sizeof(struct sample_part),
                                                    .fields = part_fields,
                                                    .nfield = UM_FIELD_COUNT(part_fields)};

static const struct um_schema_field material_fields[] = {
    UM_FIELD(struct sample_material, emittance, "emittance", UM_SCHEMA_NUMBER, .minimum = 0.0,
             .maximum = 1.0, .default_value = NAN, .help = "Emittance | hemispherical."),
};
static const struct um_schema_object material_object = {.name = "material",
                                                        .size = sizeof(struct sample_material),
                                                        .fields = material_fields,
                                                        .nfield = UM_FIELD_COUNT(material_fields)};

static const struct um_schema_field effect_fields[] = {
    UM_FIELD(struct sample_effect, effect, "effect", UM_SCHEMA_TEXT, .required = true),
    UM_FIELD(struct sample_effect, target, "target", UM_SCHEMA_TEXT),
    UM_FIELD(struct sample_effect, off, "off", UM_SCHEMA_BOOL),
    UM_FIELD(struct sample_effect, efficiency, "efficiency", UM_SCHEMA_NUMBER,
             .default_value = 0.2),
};
static const struct um_schema_object effect_object = {.name = "effect",
                                                      .size = sizeof(struct sample_effect),
                                                      .fields = effect_fields,
                                                      .nfield = UM_FIELD_COUNT(effect_fields)};

static const struct um_schema_field atmosphere_fields[] = {
    UM_FIELD(struct sample_atmosphere, model, "model", UM_SCHEMA_CHOICE, .required = true,
             .choices = models),
    UM_FIELD(struct sample_atmosphere, visibility, "visibility_km", UM_SCHEMA_NUMBER,
             .default_value = 23.0),
};
static const struct um_schema_object atmosphere_object = {.name = "atmosphere",
                                                          .size = sizeof(struct sample_atmosphere),
                                                          .fields = atmosphere_fields,
                                                          .nfield =
                                                              UM_FIELD_COUNT(atmosphere_fields),
                                                          .scalar_key = "model"};

static const struct um_schema_field fields[] = {
    UM_FIELD(struct sample, name, "name", UM_SCHEMA_TEXT, .required = true,
             .help = "Name of the \"scenario\"."),
    UM_FIELD(struct sample, tle, "tle", UM_SCHEMA_TEXT, .alternative = 1),
    UM_FIELD(struct sample, altitude, "altitude_km", UM_SCHEMA_NUMBER, .alternative = 1,
             .default_value = NAN),
    UM_FIELD(struct sample, time, "time", UM_SCHEMA_MAP, .required = true, .object = &time_object),
    UM_FIELD(struct sample, parts, "parts", UM_SCHEMA_LIST, .object = &part_object),
    UM_FIELD(struct sample, materials, "materials", UM_SCHEMA_DICT, .object = &material_object),
    UM_FIELD(struct sample, effects, "effects", UM_SCHEMA_LIST, .object = &effect_object),
    UM_FIELD(struct sample, levels, "levels", UM_SCHEMA_NUMBERS),
    UM_FIELD(struct sample, tags, "tags", UM_SCHEMA_TEXTS, .file = true),
    UM_FIELD(struct sample, atmosphere, "atmosphere", UM_SCHEMA_MAP, .object = &atmosphere_object),
    UM_FIELD(struct sample, orbits, "orbits", UM_SCHEMA_INTEGER, .minimum = 1.0, .maximum = 99.0,
             .default_value = 4.0),
    UM_FIELD(struct sample, verbose, "verbose", UM_SCHEMA_BOOL),
};
const struct um_schema_object sample_schema = {.name = "scenario",
                                               .help = "A sample.",
                                               .size = sizeof(struct sample),
                                               .fields = fields,
                                               .nfield = UM_FIELD_COUNT(fields),
                                               .exactly_one = one_orbit};
