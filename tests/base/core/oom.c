/* Memory that runs out: every allocation of the context fails once, at each place in turn. Each
 * time the call must return UM_ERR_MEMORY, leave nothing behind, and work when tried again.
 * (Allocations inside libfyaml do not pass through the context and do not fail here.) */
#include <string.h>

#include "base/core/csv.h"
#include "base/core/file.h"
#include "base/core/replay.h"
#include "tests/base/document/sample_schema.h"
#include "tests/support/allocator.h"
#include "tests/support/cmocka_all.h"

static enum um_status use_csv(struct um_context *context)
{
  char text[4096] = "a,b\n";
  for (int i = 0; i < 300; i++) strcat(text, "1,\"2\"\n"); /* makes the tables grow */
  struct um_core_csv *csv;
  enum um_status status = um_core_csv_parse(context, "t.csv", text, strlen(text), &csv);
  um_core_csv_destroy(&csv);
  return status;
}

static enum um_status use_document(struct um_context *context)
{
  static const char *const sets[] = {"parts.bus.shell.thickness_m=1", "altitude_km=3",
                                     "effects.panel:bus.off=true"};
  struct um_document *document;
  void *root;
  char *text = NULL;
  UM_TRY(
      um_document_parse(context, "s.yaml", sample_text, &sample_schema, sets, 3, &document, &root));
  enum um_status status = um_document_text(context, document, &text);
  um_core_free(context, text);
  um_document_destroy(&document);
  return status;
}

/* The text is written anew. */
static enum um_status use_rewriting(struct um_context *context)
{
  static const char *const set = "parts.bus={name: x}";
  struct um_document *document;
  void *root;
  char *text = NULL;
  UM_TRY(
      um_document_parse(context, "s.yaml", sample_text, &sample_schema, &set, 1, &document, &root));
  enum um_status status = um_document_text(context, document, &text);
  um_core_free(context, text);
  um_document_destroy(&document);
  return status;
}

/* A document larger than the first block of memory. */
static enum um_status use_large_document(struct um_context *context)
{
  static char text[60000];
  strcpy(text, "name: a\ntle: b\ntime: {start: T0+1}\nlevels: [1");
  char *p = text + strlen(text);
  for (int i = 0; i < 700; i++, p += 3) memcpy(p, ", 2", 4);
  strcpy(p, "]\n");
  struct um_document *document;
  void *root;
  UM_TRY(um_document_parse(context, "s.yaml", text, &sample_schema, NULL, 0, &document, &root));
  um_document_destroy(&document);
  return UM_OK;
}

static enum um_status use_refusal(struct um_context *context)
{
  static const char *const set = "parts.bux.x=1";
  struct um_document *document;
  void *root;
  enum um_status status =
      um_document_parse(context, "s.yaml", sample_text, &sample_schema, &set, 1, &document, &root);
  return status == UM_ERR_INPUT ? UM_OK : status;
}

static enum um_status use_folder(struct um_context *context)
{
  struct um_core_folder *folder;
  FILE *file;
  enum um_status status;
  UM_TRY(um_core_folder_begin(context, "oom-out/deep", false, &folder));
  UM_CHECK(um_core_folder_open(context, folder, "a.csv", &file));
  UM_CHECK(um_core_file_close(context, "a.csv", &file));
  UM_CHECK(um_core_folder_commit(context, &folder));
  UM_CHECK(um_core_folder_begin(context, "oom-out/deep", false, &folder));
  UM_CHECK(um_core_folder_commit(context, &folder));
done:
  um_core_folder_abort(&folder);
  remove("oom-out/deep/.umbra");
  remove("oom-out/deep/a.csv");
  remove("oom-out/deep");
  if (remove("oom-out") != 0 && status == UM_OK) status = UM_ERR_IO;
  return status;
}

/* What a command read, and the folder that tells of it. */
static enum um_status use_record(struct um_context *context)
{
  static char *const command[] = {(char *)"run", (char *)"oom-a"};
  enum um_status status;
  struct um_core_folder *folder = NULL;
  FILE *file = fopen("oom-a", "wb");
  assert_non_null(file);
  assert_int_equal(fclose(file), 0);
  UM_CHECK(um_core_replay_begin(context, "1", "umbra run", command, 2));
  UM_CHECK(um_core_replay_leave_out(context, "/usr"));
  UM_CHECK(um_core_file_check(context, "oom-a"));
  UM_CHECK(um_core_folder_begin(context, "oom-out", false, &folder));
  UM_CHECK(um_core_folder_commit(context, &folder));
done:
  um_core_replay_end(context);
  um_core_folder_abort(&folder);
  remove("oom-a");
  remove("oom-out/.umbra");
  /* with its record, where it is there at all */
  bool whole = remove("oom-out/replay.json") == 0;
  if ((remove("oom-out") == 0) != whole && status == UM_OK) status = UM_ERR_IO;
  return status;
}

static enum um_status use_log(struct um_context *context)
{
  /* a log line that finds no memory is lost; the run goes on */
  um_core_log(context, UM_LOG_INFO, "line");
  return UM_OK;
}

/* Returns the number of allocations of a use that succeeds. */
static long run(enum um_status (*use)(struct um_context *), bool survives)
{
  for (long k = 1;; k++) {
    struct um_test_memory memory = {.fail_call = k};
    struct um_core_allocator allocator = um_test_memory_allocator(&memory);
    struct um_context *context;
    enum um_status status = um_core_context_create(&allocator, &context);
    if (status == UM_OK) {
      long before = memory.alive;
      status = use(context);
      if (!survives) assert_int_equal(memory.alive, before);
      if (status != UM_OK) {
        assert_true(strlen(um_core_message(context)) > 0);
        memory.fail_call = 0;
        um_core_message_clear(context);
        assert_int_equal(use(context), UM_OK);
      }
    }
    um_core_context_destroy(&context);
    assert_int_equal(memory.alive, 0);
    if (memory.calls < k) {
      assert_int_equal(status, UM_OK);
      return memory.calls;
    }
    if (!survives || k == 1) assert_int_equal(status, UM_ERR_MEMORY);
  }
}

static void test_every_allocation_fails(void **state)
{
  (void)state;
  static const struct {
    const char *name;
    enum um_status (*use)(struct um_context *);
    bool survives;
  } uses[] = {{"csv", use_csv, false},
              {"document", use_document, false},
              {"rewriting", use_rewriting, false},
              {"large document", use_large_document, false},
              {"refusal", use_refusal, false},
              {"folder", use_folder, false},
              {"record", use_record, false},
              {"log", use_log, true}};
  for (size_t i = 0; i < sizeof uses / sizeof uses[0]; i++)
    print_message("%s: each of %ld allocations failed once\n", uses[i].name,
                  run(uses[i].use, uses[i].survives));
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_every_allocation_fails)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
