/* Several files of measurements as one, each a set of its own. */
#ifndef UMBRA_COMPARE_JOIN_H
#define UMBRA_COMPARE_JOIN_H

#include "evidence/measurements/set.h"

/* Rows of parts [n >= 1] behind each other, each made of one file; channels, tracks and what a
 * nuisance is free in are those of a part. name: [n] what sets are called, NULL or "" for those of
 * their files; names of files that are the same get "-2" and so on. UM_ERR_INPUT: a name that is
 * there twice, parts with and without independent geometry; UM_ERR_MEMORY. *out is NULL then. The
 * caller destroys. */
enum um_status um_compare_measurements_join(struct um_context *context,
                                            struct um_compare_measurements *const *part,
                                            const char *const *name, size_t n,
                                            struct um_compare_measurements **out);
/* The same of files; one file is what um_compare_measurements_read makes of it. Errors of both. */
enum um_status um_compare_measurements_read_all(struct um_context *context, const char *const *path,
                                                size_t n, struct um_compare_measurements **out);

#endif
