/* A scenario that was read is written and read again. */
#ifndef UMBRA_TESTS_FUZZ_DOCUMENTS_H
#define UMBRA_TESTS_FUZZ_DOCUMENTS_H

#include "model/scenario/scenario_schema.h"
#include "tests/fuzz/fuzz.h"

static inline void documents_try(struct um_context *context, const char *text,
                                 const char *const *set, size_t nset)
{
  struct um_document *document = NULL;
  void *root;
  char *written = NULL;
  if (!um_fuzz_good(context,
                    um_document_parse(context, "fuzz.yaml", text, &um_model_scenario_schema, set,
                                      nset, &document, &root))) {
    if (document != NULL) um_fuzz_finding("a document in spite of the failure");
    return;
  }
  if (um_fuzz_good(context, um_document_text(context, document, &written))) {
    struct um_document *again = NULL;
    enum um_status status = um_document_parse(context, "written.yaml", written,
                                              &um_model_scenario_schema, NULL, 0, &again, &root);
    if (status != UM_OK && !um_fuzz_memory_is_short())
      um_fuzz_finding("what was written does not read back: %s\n%s", um_core_message(context),
                      written);
    (void)um_fuzz_good(context, status);
    um_document_destroy(&again);
  }
  um_core_free(context, written);
  um_document_destroy(&document);
}

#endif
