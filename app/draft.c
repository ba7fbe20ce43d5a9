/* --draft-effect: what is in no catalogue, as an effect of a user's own. */
#include <string.h>
#include <sys/stat.h>

#include "app/diagnosis.h"
#include "evidence/diagnosis/report/draft.h"

enum um_status um_app_draft_check(struct um_context *context, const struct um_app_options *options)
{
  const char *path = options->draft_effect;
  struct stat there;
  size_t n = path != NULL ? strlen(path) : 0;
  if (path == NULL) return UM_OK;
  if (n < 3 || strcmp(path + n - 2, ".c") != 0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "--draft-effect %s; accepted: a name that ends in .c", path);
  if (stat(path, &there) != 0) return UM_OK;
  if (!S_ISREG(there.st_mode))
    return um_core_fail(context, UM_ERR_INPUT, "--draft-effect %s: it is no plain file", path);
  if (options->force) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "--draft-effect %s: it is there already; accepted: another name, or --force",
                      path);
}

enum um_status um_app_draft_write(struct um_context *context, const struct um_diagnosis *diagnosis,
                                  const struct um_app_options *options)
{
  enum um_diagnosis_draft draft = um_diagnosis_report_draft_choose(diagnosis);
  char text[UM_DIAGNOSIS_DRAFT_TEXT];
  UM_TRY(um_app_draft_check(context, options)); /* it may have come meanwhile */
  um_diagnosis_report_draft_text(diagnosis, draft, text);
  if (draft == UM_DRAFT_NONE) { /* what was computed is not lost */
    um_core_log(context, UM_LOG_WARNING,
                "%s is not written: neither heat nor a correction of light explains more than its "
                "numbers cost",
                options->draft_effect);
    return UM_OK;
  }
  UM_TRY(um_diagnosis_report_draft_write(context, diagnosis, options->draft_effect,
                                         options->command, UM_APP_VERSION));
  um_core_log(context, UM_LOG_INFO, "%s: %s; its first lines say how to compile and add it",
              options->draft_effect, text);
  return UM_OK;
}
