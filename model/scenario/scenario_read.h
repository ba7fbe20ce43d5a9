/* A scenario from its file. */
#ifndef UMBRA_MODEL_SCENARIO_READ_H
#define UMBRA_MODEL_SCENARIO_READ_H

#include "model/scenario/scenario.h"

/* Read a scenario folder or file with overrides and changes [nchange] behind them, without which it
 * has to be good, too; checks what one mapping cannot know of another (stop after start, names).
 * text: its YAML, in place of the file at `path`; NULL: read. The document owns everything. */
enum um_status um_model_scenario_read(struct um_context *context, const char *path,
                                      const char *text, const char *const *overrides,
                                      size_t noverride, const struct um_document_change *change,
                                      size_t nchange, struct um_document **document,
                                      const struct um_scenario **out);

/* The scenario of a document with changes, which outlives the new one (um_document_change); the
 * same checks. */
enum um_status um_model_scenario_change(struct um_context *context,
                                        const struct um_document *origin,
                                        const struct um_document_change *change, size_t nchange,
                                        struct um_document **document,
                                        const struct um_scenario **out);

#endif
