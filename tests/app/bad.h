/* Bad input: what is wrong, and what the one line on standard error must say. */
#ifndef UMBRA_TESTS_APP_BAD_H
#define UMBRA_TESTS_APP_BAD_H

#include <stddef.h>

/* A change of a text: the first `find` becomes `replace`, then only `keep` bytes stay (0: all). */
struct bad_edit {
  const char *find, *replace;
  size_t keep;
};

enum bad_kind { BAD_TEXT, BAD_MISSING, BAD_FOLDER, BAD_EMPTY, BAD_BINARY };

struct bad_case {
  const char *name;
  struct bad_edit scenario; /* of data/box.yaml */
  enum bad_kind kind;       /* of `file`, or of the scenario itself without `file` */
  const char *file;         /* a second file that the scenario names, NULL: none */
  const char *base;         /* its text before `edit` */
  struct bad_edit edit;
  const char *line_of; /* text of the scenario whose line is named, NULL: none is */
  const char *says[5];
  const char *option[3];
};

/* Every case as a CMocka test of its own; returns the number of failures. */
int bad_run(const char *group, const struct bad_case *cases, size_t n);

#endif
