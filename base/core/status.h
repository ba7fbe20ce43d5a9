/* What every fallible function of Umbra returns, and the one list of codes and texts. */
#ifndef UMBRA_CORE_STATUS_H
#define UMBRA_CORE_STATUS_H

/* code, text. The message that names value, unit, bound and the user's own word is in the context.
 */
#define UM_STATUS_LIST(X)                                                                          \
  X(UM_OK, "success")                                                                              \
  X(UM_ERR_INPUT, "the user's data is wrong")                                                      \
  X(UM_ERR_IO, "a file could not be read or written")                                              \
  X(UM_ERR_MEMORY, "out of memory")                                                                \
  X(UM_ERR_NUMERIC, "a computation did not converge or left its domain")                           \
  X(UM_ERR_LIBRARY, "a foreign library failed")                                                    \
  X(UM_ERR_CANCELLED, "cancelled by the caller")                                                   \
  X(UM_ERR_REFUSED, "a model refuses the values it is asked for")

#define UM_STATUS_ENUM(code, text) code,
enum um_status { UM_STATUS_LIST(UM_STATUS_ENUM) UM_STATUS_COUNT };
#undef UM_STATUS_ENUM

/* Text of a code; borrowed; does not fail ("unknown status" outside the list). */
const char *um_core_status_text(enum um_status status);

/* Return at once when a call fails; for functions that own nothing. */
#define UM_TRY(call)                                                                               \
  do {                                                                                             \
    enum um_status um_try_status_ = (call);                                                        \
    if (um_try_status_ != UM_OK) return um_try_status_;                                            \
  } while (0)

/* Jump to `done:` when a call fails, with the code in the local `status`; for functions that own.
 */
#define UM_CHECK(call)                                                                             \
  do {                                                                                             \
    status = (call);                                                                               \
    if (status != UM_OK) goto done;                                                                \
  } while (0)

#endif
