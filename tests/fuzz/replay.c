/* Every file of a target's corpus once, in any build: what a fuzzer found stays mended. */
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/file.h"
#include "tests/fuzz/fuzz.h"
#include "tests/support/cmocka_all.h"

static void corpus(void **state)
{
  (void)state;
  struct um_context *context;
  struct dirent **entry;
  assert_int_equal(um_core_context_create(NULL, &context), UM_OK);
  int n = scandir(UMBRA_FUZZ_CORPUS, &entry, NULL, alphasort);
  assert_true(n > 2);
  for (int i = 0; i < n; i++) {
    char *path, *bytes;
    size_t length;
    assert_int_equal(um_core_asprintf(context, &path, "%s/%s", UMBRA_FUZZ_CORPUS, entry[i]->d_name),
                     UM_OK);
    if (entry[i]->d_name[0] != '.') {
      if (um_core_file_read(context, path, 1 << 20, &bytes, &length) != UM_OK)
        fail_msg("%s", um_core_message(context));
      /* an exact copy, without the NUL behind it */
      uint8_t *copy = malloc(length > 0 ? length : 1);
      assert_non_null(copy);
      memcpy(copy, bytes, length);
      print_message("%s\n", entry[i]->d_name);
      (void)LLVMFuzzerTestOneInput(copy, length);
      free(copy);
      um_core_free(context, bytes);
    }
    um_core_free(context, path);
    free(entry[i]);
  }
  free(entry);
  um_core_context_destroy(&context);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(corpus)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
