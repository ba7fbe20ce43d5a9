/* Words of a command line. */
#include "base/core/text.h"

#include <stdio.h>
#include <string.h>

#include "tests/support/cmocka_all.h"

/* A shell reads back what was meant. */
static void test_words_of_a_shell(void **state)
{
  (void)state;
  static const char *const words[] = {
      "plain-1.5_x/y@n,a=b:c+%", "two words", "it's", "", "a$HOME`b`", "{a: [1]}", "*", "~",
      "\xc3\xa9t\xc3\xa9"};
  for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
    char line[256] = "", got[256];
    FILE *file = fmemopen(line, sizeof line, "w");
    assert_non_null(file);
    fputs("printf %s ", file);
    um_core_text_put_word(file, words[i]);
    fputs("x", file); /* joined to the word: it has no loose end */
    assert_int_equal(fclose(file), 0);
    FILE *shell = popen(line, "r"); /* NOLINT(cert-env33-c): that is what is tested */
    assert_non_null(shell);
    size_t n = fread(got, 1, sizeof got - 1, shell);
    got[n] = '\0';
    assert_int_equal(pclose(shell), 0);
    assert_int_equal(n, strlen(words[i]) + 1);
    assert_int_equal(strncmp(got, words[i], n - 1), 0);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_words_of_a_shell)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
