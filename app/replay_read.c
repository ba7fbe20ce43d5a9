/* Reading of replay.json: JSON is YAML, and the schema table says what may stand there. */
#include "app/replay_read.h"

#include "base/core/replay.h"

#define ARGUMENTS_MOST 4096
#define INPUTS_MOST    20000
#define BYTES_MOST     1e15

#define R struct um_app_replay_record
#define I struct um_app_replay_input

static const struct um_schema_field input_fields[] = {
    UM_FIELD(I, path, "path", UM_SCHEMA_TEXT, .required = true,
             .help = "The file, as it was opened from `folder`."),
    UM_FIELD(I, bytes, "bytes", UM_SCHEMA_NUMBER, .required = true, .maximum = BYTES_MOST,
             .help = "Its size."),
    UM_FIELD(I, digest, "fnv1a64", UM_SCHEMA_TEXT, .required = true,
             .help = "FNV-1a of 64 bits of its bytes, in hexadecimal digits."),
};

static const struct um_schema_object input_object = {.name = "input",
                                                     .help = "A file that was read.",
                                                     .size = sizeof(I),
                                                     .fields = input_fields,
                                                     .nfield = UM_FIELD_COUNT(input_fields)};

static const struct um_schema_field record_fields[] = {
    UM_FIELD(R, format, "umbra_replay", UM_SCHEMA_INTEGER, .required = true,
             .minimum = UM_CORE_REPLAY_FORMAT, .maximum = UM_CORE_REPLAY_FORMAT + 0.5,
             .help = "The version of this format."),
    UM_FIELD(R, version, "version", UM_SCHEMA_TEXT, .required = true,
             .help = "Of the program that wrote it."),
    UM_FIELD(R, arguments, "arguments", UM_SCHEMA_TEXTS, .required = true, .most = ARGUMENTS_MOST,
             .help = "The command and what stood behind it, a text each."),
    UM_FIELD(R, folder, "folder", UM_SCHEMA_TEXT, .required = true,
             .help = "The folder in which it was run."),
    UM_FIELD(R, written_utc, "written_utc", UM_SCHEMA_TEXT, .required = true,
             .help = "When it was written."),
    UM_FIELD(R, inputs, "inputs", UM_SCHEMA_LIST, .object = &input_object, .most = INPUTS_MOST,
             .help = "Files that were read, in the order of the first time."),
};

static const struct um_schema_object record_object = {.name = "replay file",
                                                      .help = "A command that was run.",
                                                      .size = sizeof(R),
                                                      .fields = record_fields,
                                                      .nfield = UM_FIELD_COUNT(record_fields)};

enum um_status um_app_replay_read(struct um_context *context, const char *path,
                                  struct um_document **document, struct um_app_replay_record **out)
{
  void *root;
  *out = NULL;
  UM_TRY(um_document_read(context, path, &record_object, NULL, 0, document, &root));
  *out = root;
  return UM_OK;
}
