/* What every fuzz target shares. A target defines um_fuzz_one; fuzz.c calls it twice per input,
 * the second time with one allocation that fails, and demands of both that every failure has a
 * status of the list and a one-line message, and that nothing is left allocated. */
#ifndef UMBRA_TESTS_FUZZ_FUZZ_H
#define UMBRA_TESTS_FUZZ_FUZZ_H

#include <stddef.h>
#include <stdint.h>

#include "base/core/context.h"

/* The target: read this input and let go of everything again. */
void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size);

/* Call after each fallible call, with what it returned; clears the message. Returns true when it
 * went well; ends the program when the failure is not a proper one. FUZZ_TALK in the environment
 * prints it. */
bool um_fuzz_good(struct um_context *context, enum um_status status);
/* Ends the program with this text: a finding. */
_Noreturn void um_fuzz_finding(const char *format, ...) UM_PRINTF(1, 2);
/* A finding unless the value is finite. */
void um_fuzz_finite(double value, const char *what);
/* True in the second call, in which an allocation fails: what was written need not read back. */
bool um_fuzz_memory_is_short(void);

/* Path of a file that holds these bytes until the next call; `which` 0 or 1, for targets that read
 * two. */
const char *um_fuzz_file(int which, const void *data, size_t size);
/* Path of a file that a target may write, in a folder that goes when the program ends. */
const char *um_fuzz_out(void);
/* The bytes in that file, for libraries that do not open a file in memory. */
const char *um_fuzz_out_file(const void *data, size_t size);
/* The bytes as a string of its own, so that a read behind its end is seen; the caller frees with
 * free(). NUL bytes end it early. */
char *um_fuzz_text(const uint8_t *data, size_t size);

/* For readers that work in a child process (base/core/child.h): call before an input, and after it.
 * What a sanitizer said of our code in a child is a finding. A crash inside a foreign library is
 * none: the child is there for it, and the reader has to refuse the file. */
void um_fuzz_children_watch(void);
void um_fuzz_children_judge(void);

/* What libFuzzer calls, and the test that replays a corpus. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#endif
