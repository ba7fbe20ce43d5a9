/* Private to orbit/: mean-elements messages, whatever they are written in. */
#ifndef UMBRA_ORBIT_OMM_IMPL_H
#define UMBRA_ORBIT_OMM_IMPL_H

#include "orbit/tle.h"

#define UM_ORBIT_OMM_KEYWORDS 16

/* What stands behind the keywords that are read; NULL: nothing. Borrowed. */
struct um_orbit_omm {
  const char *text[UM_ORBIT_OMM_KEYWORDS];
  int line[UM_ORBIT_OMM_KEYWORDS]; /* of each */
  int begin;                       /* line where the message begins */
};

/* The keyword's place in these, or UM_ORBIT_OMM_KEYWORDS. */
size_t um_orbit_omm_find(const char *keyword);
const char *um_orbit_omm_keyword(size_t which);
/* What stands behind a keyword. UM_ERR_INPUT: something stands there already. */
enum um_status um_orbit_omm_put(struct um_context *context, const char *name,
                                struct um_orbit_omm *omm, size_t which, const char *text, int line);
/* The set of a message. UM_ERR_INPUT naming `name`, line, keyword and what is accepted. */
enum um_status um_orbit_omm_make(struct um_context *context, const char *name,
                                 const struct um_orbit_omm *omm, struct um_orbit_tle *out);

/* A set behind those that are there. UM_ERR_MEMORY. */
enum um_status um_orbit_elements_add(struct um_context *context, struct um_orbit_elements *elements,
                                     const struct um_orbit_tle *set);

/* That of a message. Errors of um_orbit_omm_make. */
enum um_status um_orbit_omm_add(struct um_context *context, const char *name,
                                const struct um_orbit_omm *omm, struct um_orbit_elements *elements);

/* Messages of a text, added: key = value (written into), JSON, CSV, XML. */
enum um_status um_orbit_omm_kvn(struct um_context *context, const char *name, char *text,
                                struct um_orbit_elements *out);
enum um_status um_orbit_omm_json(struct um_context *context, const char *name, const char *text,
                                 struct um_orbit_elements *out);
enum um_status um_orbit_omm_csv(struct um_context *context, const char *name, const char *text,
                                size_t length, struct um_orbit_elements *out);
enum um_status um_orbit_omm_xml(struct um_context *context, const char *name, const char *bytes,
                                size_t length, struct um_orbit_elements *out);

#endif
